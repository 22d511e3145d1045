//! Candidates to trains: which onsets are the impacts of one drop, and which are missing.
//!
//! The flight times of a drop shrink by a ratio that changes slowly, and the impacts of one ball
//! on one spot sound alike. Clicks, voices, claps, clocks and rallies do neither for long.
//! So two explanations of the same onsets are compared: *a drop*, whose
//! next impact is predicted by the ones before, or *other sounds*, at independent times. The
//! logarithm of their probability ratio is the evidence, in nats. It adds up over the impacts
//! (the module `evidence`), so that dynamic programming finds the best train of all (`chain`).
//! This train is then compared with a third explanation: a person or a machine that keeps time,
//! and may speed up (`rhythm`). `search` does this for all trains of a recording, `align` measures their times, and
//! `missing` says where undetected impacts should be. All numbers are in `parameters`.
//! There is no threshold on loudness anywhere.
//!
//! ```
//! use bouncelab::onset::Onset;
//! use bouncelab::train;
//!
//! // Ten impacts whose flights shrink by 0.9, as candidates of equal sound.
//! let mut time_s = 0.1;
//! let onsets: Vec<Onset> = (0..10)
//!     .map(|n| {
//!         time_s += 0.4 * 0.9_f64.powi(n);
//!         Onset { time_s, ..Onset::click(0.0) }
//!     })
//!     .collect();
//! let search = train::find(&onsets);
//! assert_eq!(search.trains.len(), 1);
//! assert_eq!(search.trains[0].impacts().len(), 10);
//! ```

mod align;
mod chain;
mod evidence;
mod missing;
mod parameters;
mod rhythm;
mod search;

use crate::diagnostic::{Code, Diagnostic};
use crate::onset::Onset;
use crate::stats::{logistic, median, sort_by_number};
pub(crate) use chain::work;
pub(crate) use evidence::Span;
use missing::{expected, ratio_near};
pub(crate) use parameters::{ALIGNED_REACH_S, LN_MISSED, MIN_UNUSED};
use parameters::{
    COMPARED_WITH_FIRST, GRAVITY_M_S2, MAX_CANDIDATES, MAX_ECHO_S, MAX_INTERVAL_S,
    MAX_JOINED_LN_RATIO, MAX_LAST_FLIGHTS, MAX_NOTICE_S, MAX_RATTLE_FLIGHT_S, MAX_RATTLE_GAP_S,
    MAX_SHARED_S, MIN_CONCURRENT_IMPACTS, MIN_DISTANT_DB, MIN_EVIDENCE, MIN_SEARCHED_FLIGHT_S,
};
use search::Read;
pub(crate) use search::{Excerpt, search};

/// Minimum number of impacts of a train: three determine the ratio of the flights, two more confirm it against chance.
pub const MIN_IMPACTS: usize = 5;

/// A detected impact.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct TrainImpact {
    /// Its time, level and spectrum.
    pub onset: Onset,
    /// Number in the train, counted from 0 at the first detected impact; a missed impact takes a
    /// number too, so that numbers may have gaps.
    pub number: u32,
    /// Probability that this onset is an impact of the drop, given that the rest of the train is.
    pub probability: f64,
}

/// The impacts of one drop, in order of time.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Train {
    impacts: Vec<TrainImpact>,
    evidence: f64,
    log_bayes_factor: f64,
    /// Sounds near it that are nearly as loud as its loudest impact, and belong to no train.
    pub(crate) unused: usize,
    /// Time in seconds of a sound before it that may be an earlier impact.
    pub(crate) earlier_s: Option<f64>,
}

impl Train {
    /// A train of which nothing is noted of the sounds around it.
    fn new(impacts: Vec<TrainImpact>, evidence: f64, log_bayes_factor: f64) -> Self {
        Self {
            impacts,
            evidence,
            log_bayes_factor,
            unused: 0,
            earlier_s: None,
        }
    }

    /// The detected impacts in order of time: at least [`MIN_IMPACTS`], of a candidate at least three.
    pub fn impacts(&self) -> &[TrainImpact] {
        &self.impacts
    }

    /// Evidence that this is a drop, over both chance and a rhythm, in nats.
    pub fn evidence(&self) -> f64 {
        self.evidence
    }

    /// Evidence that this is a drop over chance alone, in nats: it grows with every clear impact, where
    /// a few exclude a rhythm.
    pub fn log_bayes_factor(&self) -> f64 {
        self.log_bayes_factor
    }

    /// Probability that this is a drop and neither chance nor a rhythm.
    pub fn probability(&self) -> f64 {
        logistic(self.evidence)
    }

    /// Time of the first detected impact, in seconds.
    pub fn start_s(&self) -> f64 {
        self.impacts[0].onset.time_s
    }

    /// Time of the last detected impact, in seconds.
    pub fn end_s(&self) -> f64 {
        self.impacts[self.impacts.len() - 1].onset.time_s
    }

    /// Whether it is the same drop as another train of the same recording: most impacts of the shorter one are impacts of
    /// the other.
    pub fn is_same_drop(&self, other: &Self) -> bool {
        let [fewer, more] = if self.impacts.len() < other.impacts.len() {
            [self, other]
        } else {
            [other, self]
        };
        let times_s = fewer.impacts.iter().map(|impact| impact.onset.time_s);
        let shared = times_s.filter(|time_s| more.distance_s(*time_s) < MAX_SHARED_S);
        2 * shared.count() > fewer.impacts.len()
    }

    /// The distance of the nearest impact from a time, in seconds.
    fn distance_s(&self, time_s: f64) -> f64 {
        let after = self.impacts.partition_point(|i| i.onset.time_s < time_s);
        let near = self.impacts[after.saturating_sub(1)..].iter().take(2);
        near.map(|impact| (impact.onset.time_s - time_s).abs())
            .fold(f64::INFINITY, f64::min)
    }

    /// The first flight in seconds, and the ratio by which the flights after it shrink.
    fn first_flight_s(&self) -> (f64, f64) {
        (flight_s(&self.impacts[..2]), ratio_near(&self.impacts, 0))
    }

    /// The level of its loudest impact, in dB.
    fn loudest_db(&self) -> f64 {
        let levels_db = self.impacts.iter().map(|impact| impact.onset.level_db);
        levels_db.fold(f64::NEG_INFINITY, f64::max)
    }

    /// Whether an onset is one of its impacts.
    pub(crate) fn has(&self, onset: &Onset) -> bool {
        self.distance_s(onset.time_s) <= 0.0
    }

    /// Whether another is concurrent: not only its end or its beginning lies within this one.
    fn is_concurrent(&self, other: &Self) -> bool {
        let during = self.start_s()..=self.end_s();
        let impacts = other.impacts.iter();
        let concurrent = impacts.filter(|impact| during.contains(&impact.onset.time_s));
        concurrent.count() >= MIN_CONCURRENT_IMPACTS
    }

    /// Whether most impacts follow one of another train after the same delay: echoes, or a rattle.
    fn echoes(&self, other: &Self) -> bool {
        let delays_s: Vec<f64> = self
            .impacts
            .iter()
            .filter_map(|impact| {
                let after = other
                    .impacts
                    .partition_point(|i| i.onset.time_s <= impact.onset.time_s);
                let before = other.impacts.get(after.checked_sub(1)?)?;
                Some(impact.onset.time_s - before.onset.time_s)
            })
            .collect();
        let Some(usual_s) = median(delays_s.iter().copied()) else {
            return false;
        };
        let usual = delays_s
            .iter()
            .filter(|delay_s| (**delay_s - usual_s).abs() < MAX_ECHO_S);
        2 * usual.count() > self.impacts.len()
    }

    /// Natural logarithm of how much more probable level and spectrum of the first impact are for the ball of the others than
    /// for any other sound, by the one of the next impacts that is most alike.
    pub fn ln_alike(&self) -> f64 {
        let next = self.impacts.iter().skip(1).take(COMPARED_WITH_FIRST);
        let alike = next.map(|next| evidence::ln_alike(&self.impacts[0].onset, &next.onset));
        alike.fold(f64::NEG_INFINITY, f64::max)
    }

    /// Number of impacts between the first and the last that were not detected.
    pub fn missed(&self) -> usize {
        let last = self.impacts[self.impacts.len() - 1].number as usize;
        last + 1 - self.impacts.len()
    }

    /// Measures the times again by the common waveform of the impacts (`align`), and adds
    /// missed impacts, between others and after the last, where that waveform is at the expected
    /// time.
    ///
    /// `samples` are the recording from `start_s` on. Impacts outside them, or unlike the others,
    /// keep their times.
    pub fn align(&mut self, samples: &[f32], start_s: f64, rate_hz: f64) {
        loop {
            let detected = self.impacts.len();
            let last = self.impacts[detected - 1].number;
            self.impacts.extend(expected(&self.impacts));
            let agrees = align::align(&mut self.impacts, detected, samples, start_s, rate_hz);
            let mut index = 0;
            self.impacts.retain(|_| {
                index += 1;
                index <= detected || agrees[index - 1]
            });
            sort_by_number(&mut self.impacts, |impact| f64::from(impact.number));
            if self.impacts[self.impacts.len() - 1].number == last {
                return;
            }
        }
    }

    /// The same with the samples around it.
    pub(crate) fn align_within(&mut self, read: Read) {
        let around_s = self.start_s() - ALIGNED_REACH_S..self.end_s() + ALIGNED_REACH_S;
        let excerpt = read(around_s);
        self.align(&excerpt.samples, excerpt.start_s, excerpt.rate_hz);
    }

    /// Whether it is the ball of an earlier train that rattles before it rests, such as in a groove: it follows soon, and
    /// both fly so low that nobody has dropped a ball again.
    fn is_rattling_of(&self, earlier: &Self) -> bool {
        let last = earlier.impacts.len() - 1;
        let flights_s = [
            flight_s(&earlier.impacts[last - 1..]),
            self.first_flight_s().0,
        ];
        self.start_s() - earlier.end_s() < MAX_RATTLE_GAP_S
            && flights_s
                .iter()
                .all(|&flight_s| flight_s < MAX_RATTLE_FLIGHT_S)
    }

    /// Appends a later train if that is the same ball, some of whose impacts were not detected: its first flight is the
    /// expected one if the flights in between shrink by a constant ratio.
    fn continue_with(&mut self, later: &Self) -> bool {
        let last = self.impacts.len() - 1;
        let ratio = ratio_near(&self.impacts, last);
        if ratio >= 1.0 {
            return false;
        }
        let mut next_s = ratio * flight_s(&self.impacts[last - 1..]);
        let mut time_s = self.end_s();
        let mut number = self.impacts[last].number;
        while next_s > MIN_SEARCHED_FLIGHT_S && time_s + 0.5 * next_s < later.start_s() {
            time_s += next_s;
            next_s *= ratio;
            number += 1;
        }
        let ln_ratio = (flight_s(&later.impacts[..2]) / next_s).ln();
        if next_s < MIN_SEARCHED_FLIGHT_S || ln_ratio.abs() > MAX_JOINED_LN_RATIO {
            return false;
        }
        let impacts = later.impacts.iter().map(|impact| TrainImpact {
            number: number + impact.number,
            ..*impact
        });
        self.impacts.extend(impacts);
        self.evidence = self.evidence.max(later.evidence);
        self.log_bayes_factor += later.log_bayes_factor;
        true
    }

    /// Level in dB relative to full scale of an impact at 1 m/s, if the amplitude is proportional to
    /// the speed. It depends on the distance and the hardness of the surface, not on the height of the drop.
    fn level_at_unit_speed_db(&self) -> f64 {
        let levels = self
            .impacts
            .windows(2)
            .filter(|pair| pair[1].number == pair[0].number + 1)
            .map(|pair| {
                let flight_s = pair[1].onset.time_s - pair[0].onset.time_s;
                // The flight after an impact lasts about 2 v/g.
                pair[0].onset.level_db - 20.0 * (flight_s * GRAVITY_M_S2 / 2.0).log10()
            });
        median(levels).unwrap_or(f64::NEG_INFINITY)
    }
}

/// The time between two impacts, divided by the number of flights in it, in seconds.
fn flight_s(pair: &[TrainImpact]) -> f64 {
    let flights = f64::from(pair[1].number - pair[0].number);
    (pair[1].onset.time_s - pair[0].onset.time_s) / flights
}

/// The result of a search for trains.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct TrainSearch {
    /// The trains, in the order of their first impacts; those of concurrent balls overlap.
    pub trains: Vec<Train>,
    /// Trains left out because they are much fainter than the rest: other balls, farther away.
    pub distant: Vec<Train>,
    /// Trains that are less likely drops than other sounds, the most likely first: a few at most.
    pub candidates: Vec<Train>,
    /// Sequences that look like a train but keep time: a clock, a machine, steps, applause.
    pub periodic: Vec<PeriodicSequence>,
}

/// Sounds that keep time, though perhaps a little faster as they go on.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct PeriodicSequence {
    /// Time of the first sound in seconds.
    pub start_s: f64,
    /// Mean interval in seconds.
    pub interval_s: f64,
    /// Number of sounds.
    pub count: usize,
}

impl TrainSearch {
    /// Moves the trains that are much fainter than another, more certain one from `trains` to `distant`.
    pub(crate) fn set_distant_apart(&mut self) {
        let trains: Vec<(f64, f64)> = self
            .trains
            .iter()
            .map(|train| (train.level_at_unit_speed_db(), train.log_bayes_factor()))
            .collect();
        let is_distant = |&(level_db, log_bayes_factor): &(f64, f64)| {
            trains
                .iter()
                .any(|other| other.0 > level_db + MIN_DISTANT_DB && other.1 > log_bayes_factor)
        };
        let mut distant = trains.iter().map(is_distant);
        self.distant
            .extend(self.trains.extract_if(.., |_| distant.next() == Some(true)));
    }

    /// Adds candidates, and keeps the most likely of all.
    pub(crate) fn add_candidates(&mut self, candidates: impl IntoIterator<Item = Train>) {
        // More evidence than of chance has only one that has too few impacts for a drop.
        self.candidates
            .extend(candidates.into_iter().map(|train| Train {
                evidence: train.evidence.min(MIN_EVIDENCE),
                ..train
            }));
        sort_by_number(&mut self.candidates, |train| -train.evidence);
        self.candidates.truncate(MAX_CANDIDATES);
    }

    /// The times in which two trains overlap, start and end of each in seconds.
    pub(crate) fn overlaps(&self) -> impl Iterator<Item = (f64, f64)> {
        let trains = self.trains.iter().enumerate();
        let pairs = trains.flat_map(|(index, one)| {
            let later = self.trains[index + 1..].iter();
            later.map(move |other| (other.start_s(), one.end_s().min(other.end_s())))
        });
        pairs.filter(|(start_s, end_s)| start_s < end_s)
    }

    /// Evidence of all trains together over chance, in nats.
    pub fn log_bayes_factor(&self) -> f64 {
        self.trains.iter().map(Train::log_bayes_factor).sum()
    }

    /// Why there is no drop; `onsets` is the number of candidates.
    pub fn no_drop(&self, onsets: usize) -> Diagnostic {
        let of_count = |code: Code| {
            let diagnostic = Diagnostic::new(code).with("count", onsets);
            diagnostic.with("needed", MIN_IMPACTS)
        };
        match (onsets, self.periodic.first()) {
            (_, Some(periodic)) => Diagnostic::new(Code::PeriodicSounds)
                .with("count", periodic.count)
                .with("interval_s", periodic.interval_s),
            (0, None) => Diagnostic::new(Code::NoSound),
            (n, None) if n < MIN_IMPACTS => of_count(Code::TooFewSounds),
            _ => of_count(Code::NoPattern),
        }
    }
}

/// Finds the drops among onset candidates, which must be in order of time.
///
/// ```
/// use bouncelab::onset::Onset;
/// use bouncelab::train;
///
/// let clock = [0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0].map(Onset::click);
/// assert!(train::find(&clock).trains.is_empty());
/// ```
pub fn find(onsets: &[Onset]) -> TrainSearch {
    let mut result = TrainSearch::default();
    search(
        onsets,
        Span::UNBOUNDED,
        &|_| Excerpt::default(),
        &mut result,
    );
    result.set_distant_apart();
    result
}

/// The latest time at which another impact of this drop could be detected, in seconds: no flight is
/// longer than the one before it, and at most two impacts in a row are missed. After it the
/// ball rests, or was stopped.
///
/// ```
/// use bouncelab::onset::Onset;
/// use bouncelab::train;
///
/// let search = train::find(&[0.0, 0.5, 0.9, 1.2, 1.4].map(Onset::click));
/// let next_s = train::latest_next_s(search.trains[0].impacts());
/// assert!(next_s > 1.4 + 3.0 * 0.2);
/// ```
pub fn latest_next_s(impacts: &[TrainImpact]) -> f64 {
    let last_flight_s = impacts
        .windows(2)
        .map(flight_s)
        .next_back()
        .unwrap_or(MAX_INTERVAL_S);
    let last_s = impacts.last().map_or(0.0, |impact| impact.onset.time_s);
    last_s + (MAX_LAST_FLIGHTS * last_flight_s).min(MAX_INTERVAL_S) + MAX_NOTICE_S
}

/// Numbers the impacts of one drop, the first 0, so that the flights shrink most evenly: an
/// interval that is too long counts as several flights.
///
/// `times_s` must increase. If they do not look like a drop at all, every interval counts as
/// one flight.
///
/// ```
/// use bouncelab::train::number_impacts;
///
/// assert_eq!(number_impacts(&[0.0, 0.5, 0.95, 1.355]), [0, 1, 2, 3]);
/// // An impact was missed after 1.7 s.
/// let times_s = [0.0, 0.5, 0.95, 1.355, 1.7195, 2.3428, 2.6085, 2.8477];
/// assert_eq!(number_impacts(&times_s), [0, 1, 2, 3, 4, 6, 7, 8]);
/// ```
pub fn number_impacts(times_s: &[f64]) -> Vec<u32> {
    let onsets: Vec<Onset> = times_s.iter().map(|&time_s| Onset::click(time_s)).collect();
    chain::numbers(&onsets).unwrap_or_else(|| (0..times_s.len() as u32).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::ops::Range;

    /// Impacts of a drop whose flights shrink by 0.92, those of some numbers left out.
    fn drop_without(missed: Range<u32>) -> Vec<Onset> {
        let times_s = (0..30).scan(1.0, |time_s, n| {
            let now_s = *time_s;
            *time_s += 0.5 * 0.92_f64.powi(n);
            Some((n as u32, now_s))
        });
        let detected = times_s.filter(|(number, _)| !missed.contains(number));
        detected.map(|(_, time_s)| Onset::click(time_s)).collect()
    }

    #[test]
    fn a_drop_with_a_long_gap_is_one_drop() {
        let result = find(&drop_without(10..17));
        assert_eq!(result.trains.len(), 1);
        let numbers: Vec<u32> = result.trains[0]
            .impacts()
            .iter()
            .map(|i| i.number)
            .collect();
        assert_eq!(numbers, (0..10).chain(17..30).collect::<Vec<_>>());
    }

    /// Its first flight is longer than the one to expect if the first drop continued.
    #[test]
    fn a_second_drop_after_the_first_is_another() {
        let mut onsets = drop_without(12..30);
        let start_s = onsets[11].time_s + 0.6;
        onsets.extend(drop_without(30..30).into_iter().map(|onset| Onset {
            time_s: start_s + onset.time_s,
            ..onset
        }));
        assert_eq!(find(&onsets).trains.len(), 2);
    }

    /// Sounds two milliseconds before some impacts and after others are no other drop. Each of the two trains once replaced
    /// the other in an endless loop.
    #[test]
    fn sounds_next_to_each_impact_are_no_drop_of_their_own() {
        let drop = drop_without(30..30);
        let twins = drop.iter().enumerate().map(|(index, onset)| Onset {
            time_s: onset.time_s + [-0.0025, 0.0025][index / 8 % 2],
            ..*onset
        });
        let mut onsets: Vec<Onset> = drop.iter().copied().chain(twins).collect();
        onsets.sort_by(|a, b| a.time_s.total_cmp(&b.time_s));
        assert_eq!(find(&onsets).trains.len(), 1);
    }

    /// The last bits of a recording make sounds of their own.
    #[test]
    fn a_drop_far_below_full_scale_takes_more_evidence() {
        let impacts_s: Vec<f64> = (0..6)
            .scan(1.0, |time_s, n| {
                let now_s = *time_s;
                *time_s += 0.4 * 0.85_f64.powi(n);
                Some(now_s)
            })
            .collect();
        let at_level = |level_db: f64| {
            let clicks = impacts_s.iter().map(|&time_s| Onset {
                level_db,
                ..Onset::click(time_s)
            });
            find(&clicks.collect::<Vec<_>>()).trains[0].log_bayes_factor()
        };
        assert!((at_level(-20.0) - at_level(-50.0)).abs() < 1e-9);
        let lost = at_level(-20.0) - at_level(-80.0);
        assert!((lost - 10.0_f64.ln()).abs() < 1e-9, "{lost}");
    }
}
