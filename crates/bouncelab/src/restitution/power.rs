//! A restitution that is a power of the impact speed.

use super::law::{Law, NUMBERS, fraction};
use super::{LawKind, Restitution};
use crate::error::{Quantity, Result, positive, within};
use crate::simd::Lanes;

/// Prior standard deviation of the exponent, whose mean is zero.
const EXPONENT_SD: f64 = 0.1;

pub(super) const LAW: Law = Law {
    name: "power",
    example: "power:0.9,1,0.25",
    meaning: "0.9 (v/1)^-0.25",
    of_numbers: |numbers| {
        let &[reference, reference_speed_m_s, exponent] = numbers else {
            return None;
        };
        Some(Restitution::power(reference, reference_speed_m_s, exponent))
    },
    random_stream: 2,
    restitutions_needed: 2,
    shapes: 1,
    of_normals: |restitution, [exponent, ..], speeds| {
        Restitution::power(restitution, speeds.reference_m_s, EXPONENT_SD * exponent)
    },
    start: [0.0; super::law::MAX_SHAPES],
    normal_of_slope: Some(|log_slope, _| -log_slope / EXPONENT_SD),
    slope_from_few_flights: true,
};

impl Restitution {
    /// e(v) = e* (v/v*)^-p; p = 1/4 for a contact that deforms for good (K. L. Johnson, Contact Mechanics, 1985, section
    /// 11.5).
    ///
    /// Prior: the exponent is normal, 0 ± 0.1.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) unless e* is from 0 to 1, v* (m/s) above
    /// zero and p finite.
    ///
    /// ```
    /// let law = bouncelab::restitution::Restitution::power(0.9, 2.0, 0.25)?;
    /// assert!((law.at(4.0) - 0.9 * 0.5_f64.powf(0.25)).abs() < 1e-12);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn power(reference: f64, reference_speed_m_s: f64, exponent: f64) -> Result<Self> {
        fraction(reference)?;
        positive(Quantity::ReferenceSpeed, reference_speed_m_s)?;
        within(Quantity::RestitutionExponent, exponent, ..)?;
        let numbers = [
            reference,
            reference_speed_m_s,
            exponent,
            reference.ln(),
            reference_speed_m_s.ln(),
        ];
        Ok(Self::new(LawKind::Power, &numbers))
    }
}

#[inline(always)]
pub(super) fn curve<const L: usize>(
    &[reference, reference_speed, exponent, ..]: &[Lanes<L>; NUMBERS],
    speed: Lanes<L>,
) -> (Lanes<L>, Lanes<L>) {
    let power = ((speed / reference_speed).ln() * -exponent).exp();
    (reference * power, -exponent)
}

/// A straight line: ln e = ln e* - p (ln v - ln v*).
#[inline(always)]
pub(super) fn log_curve<const L: usize>(
    &[_, _, exponent, ln_reference, ln_reference_speed, ..]: &[Lanes<L>; NUMBERS],
    ln_speed: Lanes<L>,
) -> (Lanes<L>, Lanes<L>) {
    let ln_e = ln_reference - exponent * (ln_speed - ln_reference_speed);
    (ln_e, -exponent)
}
