//! The heavy-tailed density of residuals.

/// Degrees of freedom of the scatter: nearly normal in the middle, with the fourth moment (an excess
/// of 3) of the two exponentials that were measured.
pub(super) const FREEDOM: f64 = 6.0;

/// Student's t with variance one, of an innovation that is scatter only in part.
///
/// The times have normal errors, so the tails are lighter the less of the innovation is scatter. The
/// degrees of freedom are those that give it the fourth moment of the sum: excess 6/(ν - 4), times
/// the square of the share.
pub(super) struct Tail {
    freedom: f64,
}

impl Tail {
    /// So light a tail is normal.
    const LIGHTEST: f64 = 1e6;

    pub(super) fn of(scatter_share: f64) -> Self {
        let freedom = 4.0 + (FREEDOM - 4.0) / (scatter_share * scatter_share);
        Self {
            freedom: freedom.min(Self::LIGHTEST),
        }
    }

    /// Logarithm of the density of an innovation in units of its standard deviation, by its square, but for
    /// ln (2 π)^1/2 and half the logarithm of [`Self::width`].
    pub(super) fn log_density(&self, square: f64) -> f64 {
        let nu = self.freedom;
        // ln Γ((ν + 1)/2) - ln Γ(ν/2) - ½ ln(ν/2), to 1e-5 from 6 degrees on.
        let constant = -0.25 / nu + 1.0 / (24.0 * nu.powi(3));
        constant - 0.5 * (nu + 1.0) * (square / (nu - 2.0)).ln_1p()
    }

    /// Square of the scale of Student's t over the variance.
    pub(super) fn width(&self) -> f64 {
        (self.freedom - 2.0) / self.freedom
    }

    /// Weight in the fit: what is left of the pull of the deviation, against a normal distribution;
    /// 1 in the middle.
    pub(super) fn weight(&self, square: f64) -> f64 {
        ((self.freedom + 1.0) / (self.freedom - 2.0 + square)).min(1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Student's t with variance one: it adds up to one, and so does its variance.
    #[test]
    fn the_tails_are_a_density() {
        for share in [1.0, 0.5, 0.1] {
            let tail = Tail::of(share);
            let (mut total, mut variance) = (0.0, 0.0);
            let step = 0.01;
            for place in -20_000..=20_000 {
                let z = f64::from(place) * step;
                let density = tail.log_density(z * z).exp()
                    / (2.0 * std::f64::consts::PI * tail.width()).sqrt();
                total += step * density;
                variance += step * density * z * z;
            }
            assert!((total - 1.0).abs() < 1e-4, "{share}: {total}");
            assert!((variance - 1.0).abs() < 2e-3, "{share}: {variance}");
        }
    }
}
