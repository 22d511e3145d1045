//! The logistic function and its integral: a soft step and a soft corner.

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

    #[test]
    fn far_from_zero_they_are_what_they_soften() {
        for x in [50.0, 1e3, f64::MAX] {
            assert!((logistic(x) - 1.0).abs() < 1e-15 && logistic(-x) < 1e-15);
            assert!((softplus(x) / x - 1.0).abs() < 1e-15 && softplus(-x) < 1e-15);
        }
        assert!((softplus(0.0) - std::f64::consts::LN_2).abs() < 1e-15);
    }
}
