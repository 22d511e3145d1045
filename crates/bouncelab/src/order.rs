//! Order statistics: what sorted values say, which a few wild ones hardly move.

/// The values from the least to the greatest.
pub(crate) fn sorted(values: impl IntoIterator<Item = f64>) -> Vec<f64> {
    let mut sorted: Vec<f64> = values.into_iter().collect();
    sorted.sort_unstable_by(f64::total_cmp);
    sorted
}

/// The value below which a share of sorted values lies, between neighbours in proportion: the i-th of
/// n stands for the share (i - 1/2)/n. `None` without values.
pub(crate) fn quantile(sorted: &[f64], share: f64) -> Option<f64> {
    let last = sorted.len().checked_sub(1)?;
    let place = (share * sorted.len() as f64 - 0.5).clamp(0.0, last as f64);
    let low = place as usize;
    let high = (low + 1).min(last);
    Some(sorted[low] + (place - low as f64) * (sorted[high] - sorted[low]))
}

/// The middle value, or the mean of the two in the middle. `None` without values.
pub(crate) fn median(values: impl IntoIterator<Item = f64>) -> Option<f64> {
    quantile(&sorted(values), 0.5)
}

/// The standard deviation of a normal distribution with this median absolute deviation from its
/// middle. `None` without values.
pub(crate) fn robust_sd(off: impl IntoIterator<Item = f64>) -> Option<f64> {
    /// The median absolute deviation of the standard normal distribution.
    const MEDIAN_DEVIATION: f64 = 0.674_489_75;
    Some(median(off.into_iter().map(f64::abs))? / MEDIAN_DEVIATION)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_median_of_an_even_count_lies_between_two() {
        assert_eq!(median([3.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(median([4.0, 1.0, 2.0, 3.0]), Some(2.5));
        assert_eq!(median([7.0]), Some(7.0));
        assert_eq!(median([]), None);
    }

    #[test]
    fn quantiles_of_evenly_spread_values_are_their_shares() {
        let values: Vec<f64> = (0..1000).map(|i| (f64::from(i) + 0.5) / 1000.0).collect();
        for share in [0.001, 0.025, 0.5, 0.84, 0.999] {
            assert!((quantile(&values, share).unwrap() - share).abs() < 1e-12);
        }
        assert_eq!(quantile(&values, 0.0), Some(values[0]));
        assert_eq!(quantile(&values, 1.0), Some(values[999]));
    }

    /// Half of a standard normal distribution lies within 0.6745 of its middle, and one wild value
    /// among many moves that little.
    #[test]
    fn a_wild_value_hardly_moves_the_robust_deviation() {
        use statrs::distribution::{ContinuousCDF, Normal};
        let normal = Normal::new(0.0, 2.0).unwrap();
        let mut values: Vec<f64> = (0..999)
            .map(|i| normal.inverse_cdf((f64::from(i) + 0.5) / 999.0))
            .collect();
        assert!((robust_sd(values.iter().copied()).unwrap() - 2.0).abs() < 0.005);
        values.push(1e9);
        assert!((robust_sd(values).unwrap() - 2.0).abs() < 0.01);
    }
}
