//! The prior of the scatter of restitution: a factor on the typical one.
//!
//! ln of the factor is A z + B ((1 + z²)^1/2 - 1) with a standard normal z: normal below the typical scatter and above it,
//! but wider above, because a surface may be much rougher than the usual one. A spread multiplies it: 1 is the usual width,
//! and with 0 the scatter is the typical one.

use super::parameters::{MIN_SCATTER, SCATTER_LOG_SD, SCATTER_SKEW};
use crate::simd::Lanes;

/// The scatter of a surface before the data.
#[derive(Clone, Copy, Debug)]
pub(super) struct ScatterPrior {
    /// The typical scatter.
    pub(super) typical: f64,
    /// Factor on the usual width.
    pub(super) spread: f64,
}

impl ScatterPrior {
    /// The scatter at a standard normal in each lane: no less than [`MIN_SCATTER`].
    #[inline(always)]
    pub(super) fn scatters<const L: usize>(self, normal: Lanes<L>) -> Lanes<L> {
        let above_least = self.factors(normal) * self.typical;
        (above_least * above_least + MIN_SCATTER * MIN_SCATTER).sqrt()
    }

    /// The factor at a standard normal in each lane.
    #[inline(always)]
    fn factors<const L: usize>(self, normal: Lanes<L>) -> Lanes<L> {
        let root = (normal * normal + 1.0).sqrt();
        let log = normal * SCATTER_LOG_SD + (root - 1.0) * SCATTER_SKEW;
        (log * self.spread).exp()
    }

    /// d ln(factor)/d normal.
    pub(super) fn log_slope(self, normal: f64) -> f64 {
        self.spread * (SCATTER_LOG_SD + SCATTER_SKEW * normal / normal.hypot(1.0))
    }

    /// The standard normal of a scatter above zero; 0, the most probable, if all have the same.
    pub(super) fn normal(self, scatter: f64) -> f64 {
        if self.spread == 0.0 {
            return 0.0;
        }
        standard((scatter / self.typical).ln() / self.spread)
    }
}

/// The standard normal of the logarithm of a factor of the usual width: the root of the quadratic equation that
/// (B + log - A z)² = B² (1 + z²) is.
fn standard(log: f64) -> f64 {
    let log = log + SCATTER_SKEW;
    let product = SCATTER_LOG_SD * SCATTER_LOG_SD - SCATTER_SKEW * SCATTER_SKEW;
    (SCATTER_LOG_SD * log - SCATTER_SKEW * log.hypot(product.sqrt())) / product
}

#[cfg(test)]
mod tests {
    use super::*;

    const USUAL: ScatterPrior = ScatterPrior {
        typical: 0.006,
        spread: 1.0,
    };

    fn factor(prior: ScatterPrior, normal: f64) -> f64 {
        prior.factors(Lanes([normal])).0[0]
    }

    #[test]
    fn the_inverse_undoes_the_prior() {
        for spread in [0.2, 1.0, 1.7] {
            let prior = ScatterPrior { spread, ..USUAL };
            for z in [-4.0, -1.0, 0.0, 0.3, 3.0] {
                let scatter = prior.typical * factor(prior, z);
                assert!((prior.normal(scatter) - z).abs() < 1e-12, "{z}");
                let slope = (factor(prior, z + 1e-5) / factor(prior, z - 1e-5)).ln() / 2e-5;
                assert!((slope / prior.log_slope(z) - 1.0).abs() < 1e-8, "{z}");
            }
        }
    }

    #[test]
    fn without_spread_every_scatter_is_the_typical_one() {
        let exact = ScatterPrior {
            spread: 0.0,
            ..USUAL
        };
        for z in [-3.0, 0.0, 2.0] {
            assert!((factor(exact, z) - 1.0).abs() < 1e-15);
        }
        assert!(exact.normal(0.02).abs() + exact.log_slope(1.0).abs() < 1e-15);
    }

    #[test]
    fn it_is_as_wide_as_documented() {
        let found = [-2.0, -1.0, 1.0, 2.0].map(|z| factor(USUAL, z));
        for (found, documented) in found.into_iter().zip([0.22, 0.455, 2.49, 6.6]) {
            assert!(
                (found / documented - 1.0).abs() < 0.03,
                "{found} {documented}"
            );
        }
    }
}
