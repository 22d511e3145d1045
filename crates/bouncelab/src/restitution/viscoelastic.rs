//! A sphere that is viscoelastic.

use super::law::{Law, NUMBERS, lively};
use super::{LawKind, Restitution};
use crate::error::{Quantity, Result, positive, within};
use crate::simd::Lanes;

pub(super) const LAW: Law = Law {
    name: "viscoelastic",
    example: "viscoelastic:0.9,1",
    meaning: "0.9 at 1 m/s, and 1 - C v^(1/5) + ... elsewhere",
    of_numbers: |numbers| {
        let &[restitution, speed_m_s] = numbers else {
            return None;
        };
        Some(Restitution::viscoelastic_through(restitution, speed_m_s))
    },
    random_stream: 3,
    restitutions_needed: 2,
    shapes: 0,
    of_normals: |restitution, _, speeds| {
        Restitution::viscoelastic_through(restitution, speeds.reference_m_s)
    },
    start: [0.0; super::law::MAX_SHAPES],
    normal_of_slope: None,
    slope_from_few_flights: false,
};

impl Restitution {
    /// A viscoelastic sphere: 1 - 1.15344 a v^1/5 + 0.79826 a² v^2/5 - ..., in the Padé form that
    /// stays valid where the series does not (P. Müller, T. Pöschel, Phys. Rev. E 84, 021302, 2011).
    ///
    /// Prior: none but that of e*, which determines a.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) unless a, in (m/s)^-1/5, is finite and not
    /// below zero.
    ///
    /// ```
    /// let law = bouncelab::restitution::Restitution::viscoelastic(0.05)?;
    /// assert!(law.at(0.1) > law.at(1.0) && law.at(1.0) > law.at(10.0));
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn viscoelastic(dissipation: f64) -> Result<Self> {
        within(Quantity::Dissipation, dissipation, 0.0..)?;
        Ok(Self::new(LawKind::Viscoelastic, &[dissipation]))
    }

    /// The viscoelastic sphere that has a given restitution at a given speed.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) unless the restitution is above 0, not above
    /// 1, and the speed above zero.
    ///
    /// ```
    /// let law = bouncelab::restitution::Restitution::viscoelastic_through(0.9, 2.0)?;
    /// assert!((law.at(2.0) - 0.9).abs() < 1e-12);
    /// assert!(law.at(1.0) > 0.9);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn viscoelastic_through(restitution: f64, speed_m_s: f64) -> Result<Self> {
        lively(restitution)?;
        positive(Quantity::ReferenceSpeed, speed_m_s)?;
        let x = pade_argument(restitution);
        Self::viscoelastic(x * x / speed_m_s.powf(0.2))
    }
}

#[inline(always)]
pub(super) fn curve<const L: usize>(
    &[dissipation, ..]: &[Lanes<L>; NUMBERS],
    speed: Lanes<L>,
) -> (Lanes<L>, Lanes<L>) {
    // x = (a v^1/5)^1/2, so d ln x/d ln v = 1/10.
    let x = dissipation.sqrt() * (speed.ln() * 0.1).exp();
    let (e, log_slope) = pade(x);
    (e, log_slope * 0.1)
}

#[inline(always)]
pub(super) fn log_curve<const L: usize>(
    numbers: &[Lanes<L>; NUMBERS],
    ln_speed: Lanes<L>,
) -> (Lanes<L>, Lanes<L>) {
    let (e, log_slope) = curve(numbers, ln_speed.exp());
    (e.ln(), log_slope)
}

/// Coefficient of the numerator of the Padé form, and those of the denominator from x on.
const C1: f64 = 0.501_086;
const B: [f64; 4] = [0.501_086, 1.153_45, 0.577_977, 0.532_178];

/// e and d ln e / d ln x by the Padé form of Müller and Pöschel in x = (a v^1/5)^1/2. Expanded it is
/// 1 - 1.15345 x² + 0.79826 x⁴: the series 1 - C1 a v^1/5 + C2 a² v^2/5 with C2 = 3/5 C1², but it
/// stays between 0 and 1 where the series diverges.
#[inline(always)]
fn pade<const L: usize>(x: Lanes<L>) -> (Lanes<L>, Lanes<L>) {
    let numerator = x * C1 + 1.0;
    let denominator = x * (x * (x * (x * B[3] + B[2]) + B[1]) + B[0]) + 1.0;
    let slope = x * (x * (x * (4.0 * B[3]) + 3.0 * B[2]) + 2.0 * B[1]) + B[0];
    (
        numerator / denominator,
        x * (Lanes::all(C1) / numerator - slope / denominator),
    )
}

/// The argument of the Padé form at which e has a value: Newton's method on ln e over ln x, which is nearly straight.
fn pade_argument(restitution: f64) -> f64 {
    const MAX_STEPS: usize = 60;
    if restitution >= 1.0 {
        return 0.0;
    }
    let target = restitution.ln();
    // 1 - 1.15 x² for a lively ball, about x^-3 for a dead one.
    let mut x = ((1.0 - restitution) / B[1]).sqrt() + restitution.powf(-1.0 / 3.0) - 1.0;
    for _ in 0..MAX_STEPS {
        let (Lanes([e]), Lanes([log_slope])) = pade(Lanes([x]));
        let step = (target - e.ln()) / log_slope;
        // At most a factor of e at once: the start is rough for balls that hardly bounce.
        x *= step.clamp(-1.0, 1.0).exp();
        if step.abs() < 1e-15 {
            break;
        }
    }
    x
}
