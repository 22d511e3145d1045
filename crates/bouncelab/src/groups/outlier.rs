//! Outliers: drops that are unlike the others of their group.

use std::collections::BTreeMap;

use crate::inference::Measured;
use crate::stats::{median, robust_sd, sort_by_number};

/// A modified z-score beyond this names an outlier (Iglewicz and Hoaglin, *How to Detect and Handle
/// Outliers*, 1993).
pub const OUTLIER_THRESHOLD: f64 = 3.5;

/// In a group of two both are equally odd.
const MIN_DROPS: usize = 3;

/// A drop that lies far from its group.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Outlier {
    /// Its place in the list.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub drop: usize,
    /// How far its value lies from the median of its group.
    pub off: f64,
    /// The same in robust standard deviations.
    pub score: f64,
}

/// Drops farther than [`OUTLIER_THRESHOLD`] robust standard deviations from the median of their group, the
/// farthest first.
///
/// The scatter is the median absolute deviation of all drops from the medians of their groups; a
/// drop that is known less well than most may lie farther away by its own error. Medians and
/// deviations stand up to a good share of outliers, which means and standard deviations do not: an
/// outlier hides itself in those. Groups of fewer than three drops say nothing.
///
/// ```
/// use bouncelab::groups::outliers;
/// use bouncelab::inference::Measured;
///
/// let drops = [0.931, 0.934, 0.929, 0.933, 0.80].map(|value| Measured { value, sd: 0.001 });
/// let named = outliers(&drops, &[0; 5]);
/// assert_eq!((named.len(), named[0].drop), (1, 4));
/// ```
pub fn outliers(drops: &[Measured], group: &[usize]) -> Vec<Outlier> {
    let mut members: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for (drop, &group) in group.iter().enumerate().take(drops.len()) {
        members.entry(group).or_default().push(drop);
    }
    members.retain(|_, drops| drops.len() >= MIN_DROPS);
    let mut off = vec![None; drops.len()];
    let mut deviations = Vec::new();
    for of_group in members.values() {
        let Some(middle) = median(of_group.iter().map(|&drop| drops[drop].value)) else {
            continue;
        };
        // The median follows few values closely, so that they seem to scatter less.
        let few = of_group.len() as f64;
        let wider = (few / (few - 1.0)).sqrt();
        for &drop in of_group {
            let from_median = drops[drop].value - middle;
            off[drop] = Some(from_median);
            deviations.push(from_median * wider);
        }
    }
    let (Some(typical), Some(scatter)) = (
        median(drops.iter().map(|drop| drop.sd)),
        robust_sd(deviations),
    ) else {
        return Vec::new();
    };
    let scatter = scatter.max(typical);
    let mut found: Vec<Outlier> = (0..drops.len())
        .filter_map(|drop| {
            let off = off[drop]?;
            let worse = (drops[drop].sd.powi(2) - typical * typical).max(0.0);
            let score = off / (scatter * scatter + worse).sqrt();
            (score.abs() > OUTLIER_THRESHOLD).then_some(Outlier { drop, off, score })
        })
        .collect();
    sort_by_number(&mut found, |outlier| -outlier.score.abs());
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drops(values: &[f64]) -> Vec<Measured> {
        values
            .iter()
            .map(|&value| Measured { value, sd: 0.01 })
            .collect()
    }

    /// The example of Iglewicz and Hoaglin's section 3.3: with these ten values the z-score names
    /// none, the modified one the two largest.
    #[test]
    fn two_outliers_do_not_hide_each_other() {
        let values = [2.1, 2.6, 2.4, 2.5, 2.3, 2.1, 2.3, 2.6, 8.2, 8.3];
        let found = outliers(&drops(&values), &[0; 10]);
        let named: Vec<usize> = found.iter().map(|outlier| outlier.drop).collect();
        assert_eq!(named, [9, 8]);
        assert!((found[0].off - 5.85).abs() < 1e-9);
    }

    #[test]
    fn a_drop_is_judged_by_its_own_group() {
        let values = [0.80, 0.81, 0.79, 0.80, 0.94, 0.95, 0.93, 0.94, 0.80];
        let found = outliers(&drops(&values), &[0, 0, 0, 0, 1, 1, 1, 1, 1]);
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].drop, 8);
        assert!(found[0].score < 0.0);
    }

    #[test]
    fn what_is_known_badly_may_lie_far_off_and_pairs_say_nothing() {
        let mut values = drops(&[1.0, 1.01, 0.99, 1.0, 1.5]);
        assert_eq!(outliers(&values, &[0; 5]).len(), 1);
        values[4].sd = 0.4;
        assert_eq!(outliers(&values, &[0; 5]), []);
        assert_eq!(outliers(&values, &[0, 0, 1, 1, 2]), []);
        assert_eq!(outliers(&[], &[]), []);
    }
}
