//! Means and standard deviations.

/// The mean; not a number without values.
pub(crate) fn mean(values: &[f64]) -> f64 {
    values.iter().sum::<f64>() / values.len() as f64
}

/// The standard deviation of values that are all there are; not a number without any.
pub(crate) fn sd(values: &[f64]) -> f64 {
    let mean = mean(values);
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    (squares / values.len() as f64).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Small enough to work by hand: about a mean of 5 the squares are 9, 1, 1, 1, 0, 0, 4 and 16.
    #[test]
    fn a_spread_worked_by_hand() {
        let values = [2.0, 4.0, 4.0, 4.0, 5.0, 5.0, 7.0, 9.0];
        assert!((mean(&values) - 5.0).abs() < 1e-15);
        assert!((sd(&values) - 2.0).abs() < 1e-15);
        assert!(mean(&[]).is_nan() && sd(&[]).is_nan());
    }
}
