//! The heavy-tailed density of residuals, and draws with these tails.

use rand::{Rng, RngExt};
use rand_distr::{Distribution, StandardNormal};

use super::parameters::{MAX_FREEDOM, SCATTER_EXPONENTIALS, SCATTER_FREEDOM};
use crate::simd::Lanes;

/// Deviations of ln e in units of the scatter: one in each lane with random numbers. Student's t is a normal variable over
/// the root of a chi-squared one, here scaled to variance one.
pub(super) fn draw<const L: usize>(random: [Option<&mut impl Rng>; L]) -> Lanes<L> {
    let [mut normals, mut products] = [Lanes::all(0.0), Lanes::all(0.5)];
    for (lane, rng) in random.into_iter().enumerate() {
        if let Some(rng) = rng {
            normals.0[lane] = StandardNormal.sample(rng);
            products.0[lane] = (0..SCATTER_EXPONENTIALS)
                .map(|_| rng.random::<f64>())
                .product();
        }
    }
    let chi_squared = products.ln() * -2.0;
    normals * (Lanes::all(SCATTER_FREEDOM - 2.0) / chi_squared).sqrt()
}

/// Student's t with variance one, of an innovation that is scatter only in part.
///
/// The times have normal errors, so the tails are lighter the less of the innovation is scatter. The
/// degrees of freedom ν are those that give it the fourth moment of the sum: excess 6/(ν - 4), times
/// the square of the share.
pub(super) struct Tail<const L: usize> {
    freedom: Lanes<L>,
    per_freedom: Lanes<L>,
}

impl<const L: usize> Tail<L> {
    #[inline(always)]
    pub(super) fn of(scatter_share: Lanes<L>) -> Self {
        let per_square = Lanes::all(SCATTER_FREEDOM - 4.0) / (scatter_share * scatter_share);
        let freedom = (per_square + 4.0).min(MAX_FREEDOM);
        Self {
            freedom,
            per_freedom: Lanes::all(1.0) / freedom,
        }
    }

    /// Logarithm of the density of an innovation in units of its standard deviation, by its square, but for
    /// ln (2 π)^1/2 and half the logarithm of [`Self::width`].
    #[inline(always)]
    pub(super) fn log_density(&self, square: Lanes<L>) -> Lanes<L> {
        let (nu, per_nu) = (self.freedom, self.per_freedom);
        // ln Γ((ν + 1)/2) - ln Γ(ν/2) - ½ ln(ν/2), to 1e-5 from 6 degrees on.
        let constant = per_nu * (per_nu * per_nu * (1.0 / 24.0) - 0.25);
        constant - (nu + 1.0) * 0.5 * (square / (nu - 2.0) + 1.0).ln()
    }

    /// Square of the scale of Student's t over the variance.
    #[inline(always)]
    pub(super) fn width(&self) -> Lanes<L> {
        self.per_freedom * -2.0 + 1.0
    }

    /// Weight in the fit: the derivative of the log density over that of a normal distribution; 1 near zero.
    pub(super) fn weight(&self, square: Lanes<L>) -> Lanes<L> {
        ((self.freedom + 1.0) / (self.freedom - 2.0 + square)).min(1.0)
    }
}

#[cfg(test)]
mod tests {
    use rand::SeedableRng;

    use super::*;

    /// Student's t with variance one: it adds up to one, and so does its variance.
    #[test]
    fn the_tails_are_a_density() {
        for share in [1.0, 0.5, 0.1] {
            let tail = Tail::of(Lanes([share]));
            let (mut total, mut variance) = (0.0, 0.0);
            let step = 0.01;
            for place in -20_000..=20_000 {
                let z = f64::from(place) * step;
                let density = tail.log_density(Lanes([z * z])).0[0].exp()
                    / (2.0 * std::f64::consts::PI * tail.width().0[0]).sqrt();
                total += step * density;
                variance += step * density * z * z;
            }
            assert!((total - 1.0).abs() < 1e-4, "{share}: {total}");
            assert!((variance - 1.0).abs() < 2e-3, "{share}: {variance}");
        }
    }

    /// Tables: Student's t of 6 degrees exceeds 1.440 in 20 % and 2.447 in 5 % of all cases.
    #[test]
    fn draws_have_these_tails() {
        let mut rng = rand_chacha::ChaCha8Rng::seed_from_u64(1);
        let draws: Vec<f64> = (0..40_000).map(|_| draw([Some(&mut rng)]).0[0]).collect();
        for (quantile, share) in [(1.440, 0.2), (2.447, 0.05)] {
            let limit = quantile * ((SCATTER_FREEDOM - 2.0) / SCATTER_FREEDOM).sqrt();
            let beyond = draws.iter().filter(|draw| draw.abs() > limit).count();
            let found = beyond as f64 / draws.len() as f64;
            assert!((found - share).abs() < 0.008, "{found} {share}");
        }
    }
}
