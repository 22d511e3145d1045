//! A restitution of no named form, whose slope changes slowly with the impact speed.

use std::ops::Bound::{Excluded, Unbounded};

use super::law::{Law, MAX_SHAPES, NUMBERS, lively};
use super::{LawKind, Restitution};
use crate::error::{Quantity, Result, within};
use crate::simd::Lanes;

/// The slope at v* is this times sinh z with z standard normal: of solids it lies anywhere from 0.01, viscoelastic, to
/// 0.25, plastic.
const SLOPE: f64 = 0.06;

/// Standard deviation of the random walk of the slope for a factor e in speed.
pub(crate) const WALK: f64 = 0.05;

/// Number of speeds at which the slope is given: the slowest, v* and the fastest, and those halfway in ln v.
pub(super) const KNOTS: usize = 5;

pub(super) const LAW: Law = Law {
    name: "smooth",
    example: "smooth:0.9,0.5,1,2,0,0,-0.02,-0.05,-0.1",
    meaning: "0.9 at 1 m/s, with d ln e/d ln v = 0, 0, -0.02, -0.05 and -0.1 at 0.5, 0.71, 1, 1.41 and 2 m/s",
    of_numbers: |numbers| {
        let &[restitution, slow, middle, fast, ref slopes @ ..] = numbers else {
            return None;
        };
        let slopes: [f64; KNOTS] = slopes.try_into().ok()?;
        Some(Restitution::smooth(restitution, [slow, middle, fast], slopes))
    },
    random_stream: 5,
    restitutions_needed: 4,
    shapes: KNOTS,
    of_normals: |restitution, normals, speeds| {
        let speeds_m_s = [speeds.slowest_m_s, speeds.reference_m_s, speeds.fastest_m_s];
        let [slow, middle, fast] = speeds_m_s;
        let step = |range: f64| WALK * (0.5 * range.ln()).sqrt();
        let (slower, faster) = (step(middle / slow), step(fast / middle));
        let slope = SLOPE * normals[0].sinh();
        let (half_slow, half_fast) = (slope + slower * normals[1], slope + faster * normals[3]);
        let slopes = [
            half_slow + slower * normals[2],
            half_slow,
            slope,
            half_fast,
            half_fast + faster * normals[4],
        ];
        Restitution::smooth(restitution, speeds_m_s, slopes)
    },
    start: [0.0; MAX_SHAPES],
    normal_of_slope: Some(|log_slope, _| (log_slope / SLOPE).asinh()),
    // Few flights hardly determine a slope, and most of what is probable lies near zero.
    slope_from_few_flights: false,
};

impl Restitution {
    /// e* at the middle of three speeds in m/s, and the slopes d ln e / d ln v at these speeds and at the geometric means of
    /// neighbours. Between them the slope is linear in ln v, beyond them it stays: a quadratic spline of ln e, flexible
    /// enough for any law that changes slowly.
    ///
    /// Prior: the speeds are the slowest impact, v* and the fastest impact; the slope at v* is 0.06 sinh z with z standard
    /// normal, and walks at random from there, by 0.05 for a factor e in speed. A [`RestitutionPrior`](super::RestitutionPrior)
    /// takes its place.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) unless e* is above 0 and not above 1, the speeds
    /// increase from above zero, and the slopes are finite.
    ///
    /// ```
    /// use bouncelab::restitution::Restitution;
    ///
    /// let law = Restitution::smooth(0.9, [0.5, 1.0, 2.0], [0.0, 0.0, -0.02, -0.05, -0.1])?;
    /// assert!((law.at(1.0) - 0.9).abs() < 1e-12);
    /// assert!((law.log_slope(4.0) + 0.1).abs() < 1e-12); // a power law beyond the last speed
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn smooth(
        restitution: f64,
        speeds_m_s: [f64; 3],
        slopes: [f64; KNOTS],
    ) -> Result<Self> {
        lively(restitution)?;
        let [slow, middle, fast] = speeds_m_s;
        for (speed_m_s, above) in [(slow, 0.0), (middle, slow), (fast, middle)] {
            let range = (Excluded(above), Unbounded);
            within(Quantity::ReferenceSpeed, speed_m_s, range)?;
        }
        for slope in slopes {
            within(Quantity::RestitutionExponent, slope, ..)?;
        }
        let reference = middle.ln();
        let [slowest, half_slow, at_reference, half_fast, fastest] = slopes;
        let numbers = [
            restitution.ln(),
            reference,
            at_reference,
            half_slow - at_reference,
            slowest - half_slow,
            0.5 * (reference - slow.ln()),
            half_fast - at_reference,
            fastest - half_fast,
            0.5 * (fast.ln() - reference),
        ];
        Ok(Self::new(LawKind::Smooth, &numbers))
    }
}

#[cfg_attr(not(target_family = "wasm"), inline(always))]
pub(super) fn curve<const L: usize>(
    numbers: &[Lanes<L>; NUMBERS],
    speed: Lanes<L>,
) -> (Lanes<L>, Lanes<L>) {
    let (ln_e, log_slope) = log_curve(numbers, speed.ln());
    (ln_e.exp(), log_slope)
}

#[cfg_attr(not(target_family = "wasm"), inline(always))]
pub(super) fn log_curve<const L: usize>(
    numbers: &[Lanes<L>; NUMBERS],
    ln_speed: Lanes<L>,
) -> (Lanes<L>, Lanes<L>) {
    let &[ln_e, reference, slope, slow_near, slow_far, slow_width, fast_near, fast_far, fast_width] =
        numbers;
    let faster = ln_speed - reference;
    let (slow, fast) = ((-faster).max(0.0), faster.max(0.0));
    let ramps = [
        (slow_near, slow, slow_width),
        (slow_far, (slow - slow_width).max(0.0), slow_width),
        (fast_near, fast, fast_width),
        (fast_far, (fast - fast_width).max(0.0), fast_width),
    ];
    let (mut change, mut integral) = (Lanes::all(0.0), Lanes::all(0.0));
    for (index, (by, distance, width)) in ramps.into_iter().enumerate() {
        let beyond = (distance - width).max(0.0);
        let within = distance - beyond;
        let changed = by * (within / width);
        // The slope changes linearly over the width, so its mean there is half of the change, and stays beyond.
        let rise = changed * within * 0.5 + by * beyond;
        change = change + changed;
        // Towards slower impacts ln v falls.
        integral = if index < 2 { integral - rise } else { integral + rise };
    }
    (ln_e + slope * faster + integral, slope + change)
}
