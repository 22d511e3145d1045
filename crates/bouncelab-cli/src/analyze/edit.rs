//! Impacts left out and added by hand.

use bouncelab::analysis::{self, Impact};
use bouncelab::train::{FEWEST_IMPACTS, Train};

/// A drop before it is analysed.
pub(crate) struct Unanalysed {
    /// Its impacts, in order of time.
    pub(crate) impacts: Vec<Impact>,
    /// How sure it is that it is a drop.
    pub(crate) probability: f64,
}

impl Unanalysed {
    /// As sure as the hand that wrote the times.
    pub(super) fn by_hand(times_s: &[f64]) -> Self {
        Self {
            impacts: analysis::impacts_of_times(times_s),
            probability: 1.0,
        }
    }

    /// Whether there is a silence to learn from.
    pub(super) fn has_a_flight(&self) -> bool {
        self.impacts.len() >= 2
    }

    fn start_s(&self) -> f64 {
        self.impacts
            .first()
            .map_or(f64::INFINITY, |impact| impact.time_s)
    }
}

impl From<&Train> for Unanalysed {
    fn from(train: &Train) -> Self {
        Self {
            impacts: train.impacts().iter().map(Impact::from).collect(),
            probability: train.probability(),
        }
    }
}

/// Leaves out and adds impacts at these times: each in the drop in which, or nearest to which, it
/// lies. Returns in words what could not be done.
pub(super) fn edit(
    drops: &mut Vec<Unanalysed>,
    exclude_s: &[f64],
    include_s: &[f64],
) -> Vec<String> {
    /// An impact farther than this from a drop, in seconds, does not belong to it.
    const REACH_S: f64 = 2.0;
    let mut include_s = include_s.to_vec();
    let mut exclude_s = exclude_s.to_vec();
    if include_s.is_empty() && exclude_s.is_empty() {
        return Vec::new();
    }
    for drop in drops.iter_mut() {
        let (Some(first), Some(last)) = (drop.impacts.first(), drop.impacts.last()) else {
            continue;
        };
        let near = first.time_s - REACH_S..=last.time_s + REACH_S;
        let (own, others) = include_s
            .iter()
            .copied()
            .partition::<Vec<f64>, _>(|t| near.contains(t));
        include_s = others;
        (drop.impacts, exclude_s) = analysis::edit(&drop.impacts, &exclude_s, &own);
    }
    let mut warnings: Vec<String> = exclude_s
        .iter()
        .map(|time_s| format!("there is no impact within 20 ms of {time_s} s to leave out"))
        .collect();
    if include_s.len() >= FEWEST_IMPACTS - 2 {
        include_s.sort_by(f64::total_cmp);
        drops.push(Unanalysed::by_hand(&include_s));
        drops.sort_by(|a, b| a.start_s().total_cmp(&b.start_s()));
    } else {
        warnings.extend(include_s.iter().map(|time_s| {
            format!("{time_s} s lies more than {REACH_S} s from any drop and was not added")
        }));
    }
    warnings
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Start and probability of each drop after this edit of one that begins at 5 s, with
    /// probability 0.8.
    fn edited(exclude_s: &[f64], include_s: &[f64]) -> Vec<(f64, f64)> {
        let mut drops = vec![Unanalysed {
            probability: 0.8,
            ..Unanalysed::by_hand(&[5.0, 5.5, 5.9])
        }];
        edit(&mut drops, exclude_s, include_s);
        drops.iter().map(|d| (d.start_s(), d.probability)).collect()
    }

    #[test]
    fn a_drop_added_by_hand_keeps_its_own_probability() {
        let (heard, added) = ((5.0, 0.8), (1.0, 1.0));
        assert_eq!(edited(&[], &[1.0, 1.5, 1.9]), [added, heard]);
        let added = (9.0, 1.0);
        assert_eq!(edited(&[], &[9.0, 9.5, 9.9]), [heard, added]);
    }

    #[test]
    fn a_drop_without_impacts_is_survived() {
        let nothing = (f64::INFINITY, 0.8);
        let all = [5.0, 5.5, 5.9];
        assert_eq!(edited(&all, &[]), [nothing]);
        assert_eq!(edited(&all, &[9.0, 9.5, 9.9]), [(9.0, 1.0), nothing]);
    }
}
