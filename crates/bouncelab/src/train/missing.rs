//! Impacts that were not detected: where they should be.

use super::parameters::{
    MIN_SEARCHED_FLIGHT_S, PREDICTED_FLIGHT_SCATTER, RATIO_REACH, REVEALED_PROBABILITY,
};
use super::{Onset, TrainImpact};
use crate::stats::median;

/// Where missing impacts should be: those between others, and the next after the last.
pub(super) fn expected(impacts: &[TrainImpact]) -> Vec<TrainImpact> {
    let mut expected = Vec::new();
    for (index, pair) in impacts.windows(2).enumerate() {
        let flights = pair[1].number - pair[0].number;
        // Flights that shrink by a constant ratio divide the interval as a geometric series.
        let ratio = ratio_near(impacts, index);
        let series: f64 = (0..flights).map(|n| ratio.powf(f64::from(n))).sum();
        let mut flight_s = (pair[1].onset.time_s - pair[0].onset.time_s) / series;
        let mut time_s = pair[0].onset.time_s;
        let is_last = index + 2 == impacts.len();
        for n in 1..=flights {
            time_s += flight_s;
            flight_s *= ratio;
            if n < flights {
                expected.push(missing(&pair[0], n, time_s, flight_s));
            } else if is_last && flight_s > MIN_SEARCHED_FLIGHT_S {
                let next_s = pair[1].onset.time_s + flight_s;
                expected.push(missing(&pair[0], n + 1, next_s, flight_s));
            }
        }
    }
    expected
}

/// An impact `steps` after another, with the sound of that one and a smaller probability; `align` measures its level.
fn missing(before: &TrainImpact, steps: u32, time_s: f64, flight_s: f64) -> TrainImpact {
    TrainImpact {
        onset: Onset {
            time_s,
            sigma_s: PREDICTED_FLIGHT_SCATTER * flight_s,
            ..before.onset
        },
        number: before.number + steps,
        probability: REVEALED_PROBABILITY * before.probability,
    }
}

/// The median ratio of successive flights among the impacts around this one.
pub(super) fn ratio_near(impacts: &[TrainImpact], index: usize) -> f64 {
    let end = (index + RATIO_REACH).min(impacts.len());
    let ratios = impacts[index.saturating_sub(RATIO_REACH)..end]
        .windows(3)
        .filter(|three| three[2].number == three[0].number + 2)
        .map(|three| {
            let later_s = three[2].onset.time_s - three[1].onset.time_s;
            later_s / (three[1].onset.time_s - three[0].onset.time_s)
        });
    median(ratios).unwrap_or(1.0)
}
