//! The number of drops needed for an uncertainty, and the limit for a drift.

use super::mean::Mean;
use super::quantile::student;

/// Upper limit of the number of drops.
pub const MAX_DROPS: usize = 100_000;

/// How many drops of this kind, those made included, give the mean a 95 % interval of plus or minus
/// `half_width`.
///
/// The scatter is taken as this group shows it, with Student's t for so many drops (Cochran,
/// *Sampling Techniques*, 1977, chapter 4, with t for z). `None` if a single drop cannot tell the
/// scatter, if the half width is not above zero, or if it takes more than [`MAX_DROPS`].
///
/// ```
/// use bouncelab::inference::Measured;
/// use bouncelab::groups::{Mean, drops_needed};
///
/// let drops = [1.0, 3.0, 2.0, 4.0, 0.0].map(|value| Measured { value, sd: 0.0 });
/// let mean = Mean::of(&drops)?;
/// // Standard deviation 1.58: for plus or minus 1 that is t 1.58 / sqrt(n), so n = 13.
/// assert_eq!(drops_needed(&mean, 1.0), Some(13));
/// # Ok::<(), bouncelab::Error>(())
/// ```
pub fn drops_needed(mean: &Mean, half_width: f64) -> Option<usize> {
    mean.between?;
    if half_width.is_nan() || half_width <= 0.0 {
        return None;
    }
    let one = mean.of_one_drop();
    let enough = |drops: usize| {
        let drops = drops as f64;
        student(0.975, drops - 1.0) * one / drops.sqrt() <= half_width
    };
    if !enough(MAX_DROPS) {
        return None;
    }
    let (mut few, mut many) = (1, MAX_DROPS);
    while many - few > 1 {
        let middle = usize::midpoint(few, many);
        if enough(middle) {
            many = middle;
        } else {
            few = middle;
        }
    }
    Some(many)
}

/// How far single values lie from their mean as long as nothing changes: three standard deviations,
/// from the differences of successive values, so that a drift does not widen it (chart of
/// individuals: Montgomery, *Introduction to Statistical Quality Control*, 2012, section 6.4).
/// `None` for fewer than two values.
///
/// ```
/// // Successive values differ by 1, 2 and 3.
/// let limit = bouncelab::groups::run_limit(&[1.0, 2.0, 0.0, 3.0]).unwrap();
/// assert!((limit - 3.0 * 2.0 / 1.128).abs() < 1e-12);
/// ```
pub fn run_limit(values: &[f64]) -> Option<f64> {
    /// Mean range of two normal values over their standard deviation, 2/sqrt(pi).
    const RANGE_OF_TWO: f64 = 1.128;
    if values.len() < 2 {
        return None;
    }
    let ranges = values.windows(2).map(|pair| (pair[1] - pair[0]).abs());
    let mean = ranges.sum::<f64>() / (values.len() - 1) as f64;
    Some(3.0 * mean / RANGE_OF_TWO)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::inference::Measured;

    #[test]
    fn a_smaller_uncertainty_takes_more_drops_and_some_take_too_many() {
        let drops = [0.92, 0.925, 0.915].map(|value| Measured { value, sd: 0.001 });
        let mean = Mean::of(&drops).unwrap();
        let needed = |half_width: f64| drops_needed(&mean, half_width);
        assert!(needed(0.001).unwrap() > needed(0.002).unwrap());
        assert_eq!(needed(1.0), Some(2));
        assert_eq!(needed(1e-9), None);
        assert_eq!(needed(0.0), None);
        assert_eq!(drops_needed(&Mean::of(&drops[..1]).unwrap(), 0.001), None);
    }
}
