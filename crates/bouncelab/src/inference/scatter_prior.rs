//! The prior of the scatter of restitution: a factor on the typical one.
//!
//! A surface may be much rougher than the usual one, but no surface lets a real ball bounce without any scatter. So ln of
//! the factor is A (e^(B z) - 1)/B with a standard normal z: nearly normal, with a longer tail above.

/// Slope of ln of the factor at the typical scatter.
const LOG_SD: f64 = 0.9;
/// How this slope grows for one standard deviation.
const SKEW: f64 = 0.25;
/// ln of the factor is above -A/B; the inverse is taken at no more than this part of it.
const LOWEST: f64 = 0.95;

/// The factor at a standard normal.
pub(super) fn factor(normal: f64) -> f64 {
    (LOG_SD / SKEW * (SKEW * normal).exp_m1()).exp()
}

/// d ln(factor)/d normal.
pub(super) fn log_slope(normal: f64) -> f64 {
    LOG_SD * (SKEW * normal).exp()
}

/// The standard normal of a factor; for one smaller than any, that of a very small one.
pub(super) fn normal(factor: f64) -> f64 {
    let share = factor.ln() * SKEW / LOG_SD;
    share.max(-LOWEST).ln_1p() / SKEW
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_inverse_undoes_the_prior() {
        for z in [-4.0, -1.0, 0.0, 0.3, 3.0] {
            assert!((normal(factor(z)) - z).abs() < 1e-12, "{z}");
            let slope = (factor(z + 1e-5) / factor(z - 1e-5)).ln() / 2e-5;
            assert!((slope / log_slope(z) - 1.0).abs() < 1e-8, "{z}");
        }
        assert!(normal(1e-9).is_finite());
    }

    #[test]
    fn it_is_as_wide_as_documented() {
        let found = [-2.0, -1.0, 1.0, 2.0].map(factor);
        for (found, documented) in found.into_iter().zip([0.24, 0.45, 2.8, 10.3]) {
            assert!((found / documented - 1.0).abs() < 0.03, "{found} {documented}");
        }
    }
}
