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

    pub(super) fn start_s(&self) -> f64 {
        self.impacts
            .first()
            .map_or(f64::INFINITY, |impact| impact.time_s)
    }

    /// How far a time is from it: 0 within it.
    fn distance_s(&self, time_s: f64) -> f64 {
        match (self.impacts.first(), self.impacts.last()) {
            (Some(first), Some(last)) => (first.time_s - time_s).max(time_s - last.time_s).max(0.0),
            _ => f64::INFINITY,
        }
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
    let mut added_s = vec![Vec::new(); drops.len()];
    include_s.retain(|&time_s| {
        let near =
            nearest(drops, time_s).filter(|&place| drops[place].distance_s(time_s) <= REACH_S);
        near.map(|place| added_s[place].push(time_s)).is_none()
    });
    for (drop, added_s) in drops.iter_mut().zip(added_s) {
        (drop.impacts, exclude_s) = analysis::edit(&drop.impacts, &exclude_s, &added_s);
    }
    let mut warnings: Vec<String> = exclude_s
        .iter()
        .map(|time_s| format!("there is no impact within 20 ms of {time_s} s to leave out"))
        .collect();
    if include_s.len() >= FEWEST_IMPACTS - 2 {
        include_s.sort_unstable_by(f64::total_cmp);
        drops.push(Unanalysed::by_hand(&include_s));
        drops.sort_by(|a, b| a.start_s().total_cmp(&b.start_s()));
    } else {
        warnings.extend(include_s.iter().map(|time_s| {
            format!("{time_s} s lies more than {REACH_S} s from any drop and was not added")
        }));
    }
    warnings
}

/// The place of the drop that is nearest to a time.
fn nearest(drops: &[Unanalysed], time_s: f64) -> Option<usize> {
    let distance_s = |place: usize| drops[place].distance_s(time_s);
    (0..drops.len()).min_by(|&a, &b| distance_s(a).total_cmp(&distance_s(b)))
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
    fn an_impact_goes_to_the_nearest_of_two_drops() {
        let mut drops = [&[5.0, 5.5, 5.9], &[7.0, 7.5, 7.9]]
            .map(|t| Unanalysed::by_hand(t))
            .into();
        assert!(edit(&mut drops, &[], &[6.9, 6.0]).is_empty());
        let starts_s: Vec<f64> = drops.iter().map(Unanalysed::start_s).collect();
        assert_eq!(starts_s, [5.0, 6.9]);
    }

    #[test]
    fn a_drop_without_impacts_is_survived() {
        let nothing = (f64::INFINITY, 0.8);
        let all = [5.0, 5.5, 5.9];
        assert_eq!(edited(&all, &[]), [nothing]);
        assert_eq!(edited(&all, &[9.0, 9.5, 9.9]), [(9.0, 1.0), nothing]);
    }
}
