//! The prior of the scatter of restitution: a factor on the typical one.
//!
//! ln of the factor is A z + B ((1 + z²)^1/2 - 1) with a standard normal z: normal below the typical scatter and above it,
//! but wider above, because a surface may be much rougher than the usual one.

use super::parameters::{MIN_SCATTER, SCATTER_LOG_SD, SCATTER_SKEW};
use crate::simd::Lanes;

/// The scatter at a standard normal in each lane, given the typical one: no less than [`MIN_SCATTER`].
#[inline(always)]
pub(super) fn scatters<const L: usize>(typical: f64, normal: Lanes<L>) -> Lanes<L> {
    let above_least = factors(normal) * typical;
    (above_least * above_least + MIN_SCATTER * MIN_SCATTER).sqrt()
}

/// The factor at a standard normal in each lane.
#[inline(always)]
fn factors<const L: usize>(normal: Lanes<L>) -> Lanes<L> {
    let root = (normal * normal + 1.0).sqrt();
    (normal * SCATTER_LOG_SD + (root - 1.0) * SCATTER_SKEW).exp()
}

/// d ln(factor)/d normal.
pub(super) fn log_slope(normal: f64) -> f64 {
    SCATTER_LOG_SD + SCATTER_SKEW * normal / normal.hypot(1.0)
}

/// The standard normal of a factor above zero.
pub(super) fn normal(factor: f64) -> f64 {
    let log = factor.ln() + SCATTER_SKEW;
    let product = SCATTER_LOG_SD * SCATTER_LOG_SD - SCATTER_SKEW * SCATTER_SKEW;
    (SCATTER_LOG_SD * log - SCATTER_SKEW * log.hypot(product.sqrt())) / product
}

#[cfg(test)]
mod tests {
    use super::*;

    fn factor(normal: f64) -> f64 {
        factors(Lanes([normal])).0[0]
    }

    #[test]
    fn the_inverse_undoes_the_prior() {
        for z in [-4.0, -1.0, 0.0, 0.3, 3.0] {
            assert!((normal(factor(z)) - z).abs() < 1e-12, "{z}");
            let slope = (factor(z + 1e-5) / factor(z - 1e-5)).ln() / 2e-5;
            assert!((slope / log_slope(z) - 1.0).abs() < 1e-8, "{z}");
        }
    }

    #[test]
    fn it_is_as_wide_as_documented() {
        let found = [-2.0, -1.0, 1.0, 2.0].map(factor);
        for (found, documented) in found.into_iter().zip([0.22, 0.455, 2.49, 6.6]) {
            assert!(
                (found / documented - 1.0).abs() < 0.03,
                "{found} {documented}"
            );
        }
    }
}
