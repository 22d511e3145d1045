//! How many flights lie between two impacts that were detected?
//!
//! Where impacts are missing, the numbers of the others are a guess, and the uncertainty does not contain a
//! wrong one: after a long flight an impact may have been missed or the surface may be dull. So every
//! numbering that may explain the intervals is a model of its own, weighed like the others.

use super::observed::Observed;
use super::parameters::{
    FLIGHT_RATIO_SD, MAX_EXCESS_COST, MAX_FIRST_FLIGHTS, MAX_MISSED, MAX_OTHER_NUMBERINGS,
    MAX_RATIO, MAX_RATIO_SDS, MIN_START_RATIO, OUTLIER_COST, RATIO_MEMORY, START_RATIOS,
};
use crate::stats::sort_by_number;
use crate::train::LN_MISSED;

/// Numbers of flights in the intervals, and their cost: minus the logarithm of prior times likelihood.
#[derive(Debug, Clone, PartialEq)]
struct Numbering {
    flights: Vec<usize>,
    cost: f64,
}

/// The numberings that may explain the intervals, the given one first.
pub(super) fn plausible(observed: &Observed) -> Vec<Observed> {
    let durations_s: Vec<f64> = observed.intervals.iter().map(|i| i.duration_s).collect();
    let stated: Vec<usize> = observed.intervals.iter().map(|i| i.flights).collect();
    let mut hypotheses: Vec<Numbering> = Vec::new();
    for first in 1..=MAX_FIRST_FLIGHTS {
        for step in 0..START_RATIOS {
            // From a dead ball, 0.4, to a perfect one, evenly in the logarithm.
            let ratio = MIN_START_RATIO.powf((step as f64 + 0.5) / START_RATIOS as f64);
            hypotheses.push(follow(&durations_s, first, ratio));
        }
    }
    sort_by_number(&mut hypotheses, |hypothesis| hypothesis.cost);
    let least = hypotheses[0].cost;
    hypotheses.retain(|hypothesis| hypothesis.cost < least + MAX_EXCESS_COST);
    let nearby = neighbours(&hypotheses[0]);
    let mut kept = vec![stated];
    for hypothesis in hypotheses
        .into_iter()
        .map(|hypothesis| hypothesis.flights)
        .chain(nearby)
    {
        if kept.len() <= MAX_OTHER_NUMBERINGS && !kept.contains(&hypothesis) {
            kept.push(hypothesis);
        }
    }
    kept.into_iter()
        .map(|flights| observed.renumbered(&flights))
        .collect()
}

/// Numbers the intervals one after the other, each by the number of flights that fits best to the flights before.
fn follow(durations_s: &[f64], first: usize, ratio: f64) -> Numbering {
    let (mut flights, mut ratio) = (vec![first], ratio);
    let mut cost = missed_cost(first);
    // An interval of n flights, the last of which lasts t, lasts t (1 + 1/r + 1/r² + ...).
    let last_of =
        |duration_s: f64, flights: usize, ratio: f64| duration_s / series(flights, ratio.recip());
    let mut last_s = last_of(durations_s[0], first, ratio);
    for &duration_s in &durations_s[1..] {
        let priced = |count: usize| {
            let off = (duration_s / (last_s * ratio * series(count, ratio))).ln();
            let sds = off / FLIGHT_RATIO_SD;
            let price = (0.5 * sds * sds).min(OUTLIER_COST) + missed_cost(count);
            (count, off, price)
        };
        let mut best = priced(1);
        for count in 2..=MAX_MISSED + 1 {
            // The prior of more missed impacts is lower still.
            if missed_cost(count) >= best.2 {
                break;
            }
            let other = priced(count);
            if other.2 < best.2 {
                best = other;
            }
        }
        let (count, off, price) = best;
        cost += price;
        if off.abs() < MAX_RATIO_SDS * FLIGHT_RATIO_SD {
            ratio = (ratio * (off / (RATIO_MEMORY * count as f64)).exp()).min(MAX_RATIO);
        }
        last_s = last_of(duration_s, count, ratio);
        flights.push(count);
    }
    Numbering { flights, cost }
}

/// Numberings with one impact more or less in one of the intervals of several flights.
fn neighbours(numbering: &Numbering) -> Vec<Vec<usize>> {
    let mut neighbours = Vec::new();
    for (interval, &count) in numbering.flights.iter().enumerate() {
        for other in [count - 1, count + 1] {
            if count > 1 && other <= MAX_MISSED + 1 {
                let mut flights = numbering.flights.clone();
                flights[interval] = other;
                neighbours.push(flights);
            }
        }
    }
    neighbours
}

/// Minus the logarithm of the prior probability of the missed impacts in this number of flights.
fn missed_cost(flights: usize) -> f64 {
    -LN_MISSED * (flights - 1) as f64
}

/// 1 + r + r² + ..., this number of terms.
fn series(terms: usize, ratio: f64) -> f64 {
    (0..terms).fold(0.0, |sum, _| sum * ratio + 1.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::impact::Impact;

    /// Impacts of a ball that keeps a share of its flight, of which some were missed.
    fn numberings(ratio: f64, detected: &[i32]) -> Vec<Vec<usize>> {
        let impacts: Vec<Impact> = (1..)
            .zip(detected)
            .map(|(number, &place)| {
                Impact::new(number, 0.5 * (1.0 - ratio.powi(place)) / (1.0 - ratio))
            })
            .collect();
        let found = plausible(&Observed::new(&impacts).unwrap());
        let flights = |observed: &Observed| observed.intervals.iter().map(|i| i.flights).collect();
        found.iter().map(flights).collect()
    }

    #[test]
    fn several_successive_impacts_may_be_missing() {
        let found = numberings(0.9, &[0, 1, 2, 6, 7, 8, 10, 11]);
        assert!(found.contains(&vec![1, 1, 4, 1, 1, 2, 1]), "{found:?}");
        assert_eq!(found[0], [1; 7], "as stated");
    }

    #[test]
    fn the_second_impact_may_be_missing() {
        let found = numberings(0.6, &[0, 2, 3, 4, 5]);
        assert!(found.contains(&vec![2, 1, 1, 1]), "{found:?}");
    }

    #[test]
    fn where_none_is_missing_there_is_one_numbering() {
        let detected: Vec<i32> = (0..20).collect();
        assert_eq!(numberings(0.9, &detected), [[1; 19]]);
    }
}
