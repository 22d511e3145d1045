//! A restitution that is constant below a knee and falls above it.

use super::law::{Law, NUMBERS, fraction};
use super::{LawKind, Restitution};
use crate::error::{Quantity, Result, positive, within};
use crate::simd::Lanes;
use crate::stats::logistic;

/// The knee is rounded over this share of its speed: a real ball has no corner, and neither should
/// a likelihood.
const WIDTH: f64 = 0.1;

/// The logistic function of a standard normal times this is nearly uniform from 0 to 1.
const UNIFORM: f64 = 1.6;

/// Prior median of the share of e that is lost from the knee to twice its speed.
const LOSS: f64 = 0.05;

pub(super) const LAW: Law = Law {
    name: "knee",
    example: "knee:0.95,1.5,0.02",
    meaning: "0.95 below 1.5 m/s, and 0.95 - 0.02 (v - 1.5) above",
    of_numbers: |numbers| {
        let &[below, knee_speed_m_s, loss_per_speed_s_m] = numbers else {
            return None;
        };
        Some(Restitution::knee(below, knee_speed_m_s, loss_per_speed_s_m))
    },
    random_stream: 4,
    restitutions_needed: 4,
    shapes: 2,
    of_normals: |restitution, [knee, loss, ..], speeds| {
        let range = speeds.fastest_m_s / speeds.slowest_m_s;
        let knee_speed_m_s = speeds.slowest_m_s * range.powf(logistic(UNIFORM * knee));
        let loss_per_speed_s_m = restitution * (LOSS * loss.exp()) / knee_speed_m_s;
        Restitution::knee(restitution, knee_speed_m_s, loss_per_speed_s_m)
    },
    // A knee in the fast impacts, and not steep: from there the search can go anywhere.
    start: [1.0, -1.0, 0.0, 0.0, 0.0],
    normal_of_slope: None,
    slope_from_few_flights: false,
};

impl Restitution {
    /// e0 well below a knee speed, falling by k per m/s above it, as a hollow ball that buckles (R. Cross, Am. J. Phys. 82,
    /// 2014); the corner is rounded over a tenth of the knee speed.
    ///
    /// Prior: the logarithm of the knee speed lies anywhere between those of the slowest and the fastest impact, and the
    /// share of e lost from the knee to twice its speed is log-normal, 0.05 with a factor e.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) unless e0 is from 0 to 1, the knee (m/s)
    /// above zero and k (s/m) finite.
    ///
    /// ```
    /// let law = bouncelab::restitution::Restitution::knee(0.95, 1.5, 0.02)?;
    /// assert!((law.at(0.5) - 0.95).abs() < 1e-4); // flat below the knee
    /// assert!((law.at(3.0) - 0.92).abs() < 1e-4); // 0.02 for each m/s above it
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn knee(below: f64, knee_speed_m_s: f64, loss_per_speed_s_m: f64) -> Result<Self> {
        fraction(below)?;
        positive(Quantity::ReferenceSpeed, knee_speed_m_s)?;
        within(Quantity::RestitutionLoss, loss_per_speed_s_m, ..)?;
        let numbers = [below, knee_speed_m_s, loss_per_speed_s_m];
        Ok(Self::new(LawKind::Knee, &numbers))
    }
}

/// The corner max(0, v - knee) is rounded to width ln(1 + exp((v - knee)/width)), whose derivative is a logistic
/// function.
#[inline(always)]
pub(super) fn curve<const L: usize>(
    &[below, knee_speed, loss, ..]: &[Lanes<L>; NUMBERS],
    speed: Lanes<L>,
) -> (Lanes<L>, Lanes<L>) {
    let width = knee_speed * WIDTH;
    let past = (speed - knee_speed) / width;
    // ln(1 + exp past) and 1/(1 + exp -past), without overflow.
    let small = (-past.abs()).exp();
    let softplus = past.max(0.0) + (small + 1.0).ln();
    let logistic = past.if_positive(Lanes::all(1.0), small) / (small + 1.0);
    let e = below - loss * width * softplus;
    (e, -(loss * logistic * speed) / e)
}

#[inline(always)]
pub(super) fn log_curve<const L: usize>(
    numbers: &[Lanes<L>; NUMBERS],
    ln_speed: Lanes<L>,
) -> (Lanes<L>, Lanes<L>) {
    let (e, log_slope) = curve(numbers, ln_speed.exp());
    (e.ln(), log_slope)
}
