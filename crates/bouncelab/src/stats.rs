//! Order statistics, moments and the logistic function.

/// The values in increasing order.
pub(crate) fn sorted(values: impl IntoIterator<Item = f64>) -> Vec<f64> {
    let mut sorted: Vec<f64> = values.into_iter().collect();
    sorted.sort_unstable_by(f64::total_cmp);
    sorted
}

/// Sorts by a number in increasing order; items with the same number keep their order.
///
/// Only numbers are sorted, with their indices: a sort for each type of item would add 4 kB to the page.
pub(crate) fn sort_by_number<T>(items: &mut [T], number: impl Fn(&T) -> f64) {
    let mut order = in_order(items.iter().map(number).zip(0..).collect());
    for to in 0..items.len() {
        // An item whose index is below `to` has been swapped away, once or more. The swaps are recorded in `order`, so that
        // following them stays short in a long list.
        let mut from = order[to].1;
        while from < to {
            from = order[from].1;
        }
        items.swap(to, from);
        order[to].1 = from;
    }
}

#[inline(never)]
fn in_order(mut numbers: Vec<(f64, usize)>) -> Vec<(f64, usize)> {
    numbers.sort_unstable_by(|(a, earlier), (b, later)| a.total_cmp(b).then(earlier.cmp(later)));
    numbers
}

/// The value below which a share of sorted values lies, interpolated linearly between neighbours: the i-th of
/// n stands for the share (i - 1/2)/n (Hyndman and Fan 1996, type 5). `None` without values.
pub(crate) fn quantile(sorted: &[f64], share: f64) -> Option<f64> {
    let last = sorted.len().checked_sub(1)?;
    let (low, fraction) = rank(sorted.len(), share);
    let high = (low + 1).min(last);
    Some(sorted[low] + fraction * (sorted[high] - sorted[low]))
}

/// The index of the sorted value at or below the quantile of a share, and the fraction of the distance from there to the
/// next value. `count` is at least one.
fn rank(count: usize, share: f64) -> (usize, f64) {
    let rank = (share * count as f64 - 0.5).clamp(0.0, (count - 1) as f64);
    (rank as usize, rank.fract())
}

/// The quantiles of values in any order; changes their order. `None` without values. For a few quantiles this is faster
/// than sorting all values.
pub(crate) fn quantiles<const N: usize>(values: &mut [f64], shares: [f64; N]) -> Option<[f64; N]> {
    let has_values = !values.is_empty();
    has_values.then(|| {
        shares.map(|share| {
            let (low, fraction) = rank(values.len(), share);
            let (_, &mut low, above) = values.select_nth_unstable_by(low, f64::total_cmp);
            let high = above.iter().copied().min_by(f64::total_cmp);
            low + fraction * (high.unwrap_or(low) - low)
        })
    })
}

/// The middle value, or the mean of the two in the middle. `None` without values.
pub(crate) fn median(values: impl IntoIterator<Item = f64>) -> Option<f64> {
    quantile(&sorted(values), 0.5)
}

/// The standard deviation of a normal distribution whose deviations from its median have this median size. `None` without
/// values.
pub(crate) fn robust_sd(deviations: impl IntoIterator<Item = f64>) -> Option<f64> {
    /// The median absolute deviation of the standard normal distribution.
    const MEDIAN_DEVIATION: f64 = 0.674_489_75;
    Some(median(deviations.into_iter().map(f64::abs))? / MEDIAN_DEVIATION)
}

/// The mean; not a number without values.
pub(crate) fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// The standard deviation of a whole population; not a number without values.
pub(crate) fn sd(values: &[f64]) -> f64 {
    let mean = mean(values);
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    (squares / values.len() as f64).sqrt()
}

/// 1/(1 + exp -x): from 0 to 1.
pub(crate) fn logistic(x: f64) -> f64 {
    1.0 / (1.0 + (-x).exp())
}

/// ln(1 + exp x) without overflow: 0 far below zero, x far above.
pub(crate) fn softplus(x: f64) -> f64 {
    x.max(0.0) + (-x.abs()).exp().ln_1p()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Against the stable sort of the standard library.
    #[test]
    fn sorting_by_a_number_is_stable() {
        let mut number = 1_u32;
        for count in 0..40 {
            let mut items: Vec<(u32, usize)> = (0..count)
                .map(|index| {
                    number = number.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                    (number >> 28, index)
                })
                .collect();
            let mut expected = items.clone();
            expected.sort_by_key(|(number, _)| *number);
            sort_by_number(&mut items, |(number, _)| f64::from(*number));
            assert_eq!(items, expected);
        }
    }

    #[test]
    fn the_median_of_an_even_count_lies_between_two() {
        assert_eq!(median([3.0, 1.0, 2.0]), Some(2.0));
        assert_eq!(median([4.0, 1.0, 2.0, 3.0]), Some(2.5));
        assert_eq!(median([7.0]), Some(7.0));
        assert_eq!(median([]), None);
    }

    #[test]
    fn quantiles_without_sorting_are_those_of_sorted_values() {
        let values: Vec<f64> = (0..997).map(|i| f64::from(i * 571 % 997).sqrt()).collect();
        let shares = [0.0, 0.025, 0.025, 0.16, 0.5, 0.5003, 0.975, 1.0];
        for count in [1, 2, 3, 50, 997] {
            let sorted = sorted(values[..count].iter().copied());
            let expected = shares.map(|share| quantile(&sorted, share).unwrap());
            assert_eq!(
                quantiles(&mut values[..count].to_vec(), shares),
                Some(expected)
            );
        }
        assert_eq!(quantiles(&mut [], shares), None);
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

    /// Small enough to work by hand: about a mean of 5 the squares are 9, 1, 1, 1, 0, 0, 4 and 16.
    #[test]
    fn a_spread_worked_by_hand() {
        let values = [2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0];
        assert!((mean(&values) - 5.0).abs() < 1e-15);
        assert!((sd(&values) - 2.0).abs() < 1e-15);
        assert!(mean(&[]).is_nan() && sd(&[]).is_nan());
    }

    #[test]
    fn far_from_zero_they_are_what_they_soften() {
        for x in [50.0, 1e3, f64::MAX] {
            assert!((logistic(x) - 1.0).abs() < 1e-15 && logistic(-x) < 1e-15);
            assert!((softplus(x) / x - 1.0).abs() < 1e-15 && softplus(-x) < 1e-15);
        }
        assert!((softplus(0.0) - std::f64::consts::LN_2).abs() < 1e-15);
    }
}
