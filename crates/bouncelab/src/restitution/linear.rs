//! A restitution that falls with the impact speed along a straight line.

use super::law::{Law, NUMBERS};
use super::{LawKind, Restitution};
use crate::error::{Quantity, Result, within};
use crate::simd::Lanes;

/// Prior standard deviation of the share of e* that is lost from rest to the fastest impact.
const LOSS_SD: f64 = 0.1;

pub(super) const LAW: Law = Law {
    name: "linear",
    example: "linear:0.96,0.01",
    meaning: "0.96 - 0.01 v",
    of_numbers: |numbers| {
        let &[at_rest, loss_per_speed_s_m] = numbers else {
            return None;
        };
        Some(Restitution::linear(at_rest, loss_per_speed_s_m))
    },
    random_stream: 1,
    restitutions_needed: 2,
    shapes: 1,
    of_normals: |restitution, [loss, ..], speeds| {
        let loss_per_speed_s_m = restitution * (LOSS_SD * loss) / speeds.fastest_m_s;
        let at_rest = restitution + loss_per_speed_s_m * speeds.reference_m_s;
        Restitution::linear(at_rest, loss_per_speed_s_m)
    },
    start: [0.0; super::law::MAX_SHAPES],
    // d ln e/d ln v = -k v/e, with k = e* LOSS_SD z/v_fastest.
    normal_of_slope: Some(|log_slope, speeds| {
        let fastest = speeds.fastest_m_s / speeds.reference_m_s;
        -log_slope * fastest / LOSS_SD
    }),
    slope_from_few_flights: true,
};

impl Restitution {
    /// e(v) = e0 - k v: falling with the impact speed if k is above zero.
    ///
    /// Prior: the share of e* that it loses from rest to the fastest impact is normal, 0 ± 0.1.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) unless e0 is from 0 to 2 and k (in
    /// s/m) is finite. An e0 above 1 is a line that meets 1 at a speed above zero.
    ///
    /// ```
    /// let law = bouncelab::restitution::Restitution::linear(0.96, 0.01)?;
    /// assert!((law.at(2.0) - 0.94).abs() < 1e-12);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn linear(at_rest: f64, loss_per_speed_s_m: f64) -> Result<Self> {
        within(Quantity::Restitution, at_rest, 0.0..=2.0)?;
        within(Quantity::RestitutionLoss, loss_per_speed_s_m, ..)?;
        let numbers = [at_rest, loss_per_speed_s_m];
        Ok(Self::new(LawKind::Linear, &numbers))
    }
}

#[inline(always)]
pub(super) fn curve<const L: usize>(
    &[at_rest, loss, ..]: &[Lanes<L>; NUMBERS],
    speed: Lanes<L>,
) -> (Lanes<L>, Lanes<L>) {
    let e = at_rest - loss * speed;
    (e, -(loss * speed) / e)
}

#[inline(always)]
pub(super) fn log_curve<const L: usize>(
    numbers: &[Lanes<L>; NUMBERS],
    ln_speed: Lanes<L>,
) -> (Lanes<L>, Lanes<L>) {
    let (e, log_slope) = curve(numbers, ln_speed.exp());
    (e.ln(), log_slope)
}
