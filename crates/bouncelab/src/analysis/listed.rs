//! Lists of impact times: where they come from, and whether they can be those of one drop.

use std::collections::BTreeMap;

use crate::diagnostic::{Code, Diagnostic};
use crate::impact::Impact;
use crate::stats::median;
use crate::train;

/// Upper limit of a flight time, in seconds: 1.1 km high, or eight missed flights of 14 m.
const MAX_FLIGHT_S: f64 = 30.0;

/// Maximum number of impacts of a drop: the longest drops of steel balls have about a hundred, and an inference from more
/// takes seconds.
const MAX_IMPACTS: usize = 500;

/// Maximum ratio of the duration of a flight to that of the one before, on average over a list. Without air the ratio is
/// the restitution, and no ball is known with more than 0.99.
const MAX_RATIO: f64 = 0.99;

/// Where a list of impact times comes from.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct ListOrigin {
    /// The program that exported it, and its kind of export, if they are known.
    pub program: Option<String>,
    /// Whether each time is that at which the sound exceeded a threshold, which marks a faint impact later than a loud one.
    pub by_threshold: bool,
    /// Whether the list has the times from impact to impact, of which the impact times are the sums.
    pub of_intervals: bool,
    /// What the file states of the measurement, by field, such as `device`.
    pub notes: BTreeMap<String, String>,
}

impl ListOrigin {
    /// The program and the notes in one line, if there are any: "phyphox acoustic stopwatch, Pixel 7".
    pub fn description(&self) -> Option<String> {
        let parts = self.program.iter().chain(self.notes.values());
        let parts: Vec<&str> = parts.map(String::as_str).collect();
        (!parts.is_empty()).then(|| parts.join(", "))
    }

    /// What is to be said of times of this origin.
    pub(super) fn diagnostics(&self) -> impl Iterator<Item = Diagnostic> {
        let threshold = self.by_threshold.then_some(Code::TimesByThreshold);
        let intervals = self.of_intervals.then_some(Code::TimesOfIntervals);
        threshold.into_iter().chain(intervals).map(Diagnostic::new)
    }
}

/// Why these times, which increase, are not the impacts of one drop.
pub(super) fn refusal(times_s: &[f64]) -> Option<Diagnostic> {
    let is_far = |pair: &[f64]| pair[1] - pair[0] > MAX_FLIGHT_S;
    if times_s.len() < 2 {
        Some(Diagnostic::new(Code::TooFewTimes))
    } else if times_s.windows(2).any(is_far) {
        Some(Diagnostic::new(Code::TimesInMilliseconds))
    } else if times_s.len() > MAX_IMPACTS {
        let too_many = Diagnostic::new(Code::TooManyTimes).with("count", times_s.len());
        Some(too_many.with("most", MAX_IMPACTS))
    } else {
        let numbers = train::number_impacts(times_s);
        let (count, first_s, last_s) = rising(times_s, &numbers)?;
        Some(
            Diagnostic::new(Code::FlightsDoNotFall)
                .with("count", count)
                .with("first_s", first_s)
                .with("last_s", last_s),
        )
    }
}

/// Why the detected impacts of a train are not those of a drop, whatever their sounds are: as of music whose beat wanders.
pub(super) fn veto(impacts: &[Impact]) -> Option<Diagnostic> {
    let times_s: Vec<f64> = impacts.iter().map(|impact| impact.time_s).collect();
    let numbers: Vec<u32> = impacts.iter().map(|impact| impact.number as u32).collect();
    let (flights, first_s, _) = rising(&times_s, &numbers)?;
    let periodic = Diagnostic::new(Code::PeriodicSounds).with("count", flights + 1);
    Some(periodic.with("interval_s", first_s))
}

/// Number of flights, and typical durations of the first and last in seconds, if they do not fall on the whole, or most
/// last longer than the one before, so that most impacts gain energy: samples, a clock, another order, or several drops.
fn rising(times_s: &[f64], numbers: &[u32]) -> Option<(usize, f64, f64)> {
    let flights: Vec<Flight> = std::iter::zip(times_s.windows(2), numbers.windows(2))
        .map(|(times_s, numbers)| {
            let count = f64::from(numbers[1] - numbers[0]);
            Flight {
                number: f64::from(numbers[0]) + 0.5 * count,
                duration_s: (times_s[1] - times_s[0]) / count,
            }
        })
        .collect();
    if flights.len() < 2 {
        return None;
    }
    let rises = flights
        .windows(2)
        .filter(|pair| pair[1].duration_s > pair[0].duration_s);
    let mostly_rises = 2 * rises.count() > flights.len() - 1;
    let third = flights.len().div_ceil(3);
    let early = typical(&flights[..third])?;
    let late = typical(&flights[flights.len() - third..])?;
    // By ln(late / early) = distance ln(ratio).
    let ln_ratio = (late.duration_s / early.duration_s).ln() / (late.number - early.number);
    let is_rising = mostly_rises || ln_ratio > MAX_RATIO.ln();
    is_rising.then_some((flights.len(), early.duration_s, late.duration_s))
}

/// A flight, or several whose impacts are not in the list.
struct Flight {
    /// Number in the drop; of several, the mean.
    number: f64,
    /// Its duration; of several, the mean, in seconds.
    duration_s: f64,
}

/// Median number and duration of flights.
fn typical(flights: &[Flight]) -> Option<Flight> {
    Some(Flight {
        number: median(flights.iter().map(|flight| flight.number))?,
        duration_s: median(flights.iter().map(|flight| flight.duration_s))?,
    })
}

#[cfg(test)]
mod tests {
    use super::refusal;
    use crate::diagnostic::Code;

    /// Times with these intervals between them.
    fn times(intervals_s: impl IntoIterator<Item = f64>) -> Vec<f64> {
        let sums = intervals_s.into_iter().scan(0.0, |time_s, interval_s| {
            *time_s += interval_s;
            Some(*time_s)
        });
        std::iter::once(0.0).chain(sums).collect()
    }

    fn code(times_s: &[f64]) -> Option<Code> {
        refusal(times_s).map(|diagnostic| diagnostic.code)
    }

    #[test]
    fn flights_that_do_not_fall_are_no_drop() {
        let repeated =
            |each: &[f64], count| each.iter().copied().cycle().take(count).collect::<Vec<_>>();
        let rising = (0..12).map(|n| 0.3 * 1.05_f64.powi(n));
        // 25 points along each flight, as a table of motion has.
        let motion = (0..7).flat_map(|n| [0.46 * 0.93_f64.powi(n) / 25.0; 25]);
        for times_s in [
            times(repeated(&[0.5], 2)),
            times(repeated(&[0.5], 100)),
            times(repeated(&[0.022, 0.022, 0.019], 300)),
            times([0.3, 0.5, 0.7]),
            times(rising),
            times(motion),
        ] {
            assert_eq!(code(&times_s), Some(Code::FlightsDoNotFall), "{times_s:?}");
        }
    }

    #[test]
    fn drops_with_missed_and_false_impacts_remain() {
        let drop = |ratio: f64, count: i32| times((0..count).map(|n| 0.5 * ratio.powi(n)));
        let without = |mut times_s: Vec<f64>, missed: &[usize]| {
            for &index in missed.iter().rev() {
                times_s.remove(index);
            }
            times_s
        };
        // To the frames of a video.
        let coarse = drop(0.85, 12)
            .iter()
            .map(|time_s| (time_s * 30.0).round() / 30.0)
            .collect();
        let mut other = drop(0.9, 12);
        other.insert(5, 1.9);
        for times_s in [
            drop(0.98, 2),
            drop(0.98, 100),
            drop(0.3, 5),
            without(drop(0.9, 12), &[4]),
            without(drop(0.9, 20), &[3, 7, 8]),
            coarse,
            other,
        ] {
            assert_eq!(code(&times_s), None, "{times_s:?}");
        }
    }
}
