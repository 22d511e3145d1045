//! Quantiles for intervals. They come from `statrs`, which only this module uses.

use statrs::distribution::{ChiSquared, ContinuousCDF, StudentsT};

use crate::inference::Measured;

/// From this number of degrees of freedom on a t distribution equals the normal one to six digits.
const NORMAL: f64 = 1e6;

/// The value below which a share of Student's t distribution lies.
///
/// Not a number if the degrees of freedom are not above zero.
pub(super) fn student(share: f64, degrees: f64) -> f64 {
    StudentsT::new(0.0, 1.0, degrees.min(NORMAL)).map_or(f64::NAN, |t| t.inverse_cdf(share))
}

/// The 95 % confidence interval of a value whose standard error has this number of degrees of freedom.
pub(super) fn interval95(measured: Measured, degrees: f64) -> [f64; 2] {
    let half = student(0.975, degrees) * measured.sd;
    [measured.value - half, measured.value + half]
}

/// The probability of a t value at least so far from zero.
pub(super) fn student_beyond(t: f64, degrees: f64) -> f64 {
    let below = |t: StudentsT, at: f64| t.cdf(-at.abs());
    StudentsT::new(0.0, 1.0, degrees.min(NORMAL)).map_or(f64::NAN, |d| 2.0 * below(d, t))
}

/// The value below which a share of the chi-squared distribution lies.
pub(super) fn chi_squared(share: f64, degrees: f64) -> f64 {
    ChiSquared::new(degrees).map_or(f64::NAN, |d| d.inverse_cdf(share))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// From any printed table of the t and the chi-squared distribution.
    #[test]
    fn printed_quantiles() {
        let close = |value: f64, table: f64| assert!((value / table - 1.0).abs() < 5e-4, "{value}");
        close(student(0.975, 1.0), 12.706);
        close(student(0.975, 3.0), 3.182);
        close(student(0.975, 12.0), 2.179);
        close(student(0.975, f64::INFINITY), 1.960);
        close(student_beyond(2.179, 12.0), 0.05);
        close(chi_squared(0.975, 12.0), 23.337);
        close(chi_squared(0.025, 12.0), 4.404);
        assert!(student(0.975, 0.0).is_nan());
    }
}
