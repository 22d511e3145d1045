//! A restitution of no named form, whose slope changes slowly with the impact speed.

use std::ops::Bound::{Excluded, Unbounded};

use super::law::{Law, NUMBERS, lively};
use super::{LawKind, Restitution};
use crate::error::{Quantity, Result, within};
use crate::simd::Lanes;

/// The slope at v* is this times sinh z with z standard normal: of solids it lies anywhere from 0.01, viscoelastic, to
/// 0.25, plastic.
const SLOPE: f64 = 0.03;

/// Standard deviation of the random walk of the slope for a factor e in speed.
const WALK: f64 = 0.05;

pub(super) const LAW: Law = Law {
    name: "smooth",
    example: "smooth:0.9,0.5,1,2,0,-0.02,-0.1",
    meaning: "0.9 at 1 m/s, with d ln e/d ln v = 0, -0.02 and -0.1 at 0.5, 1 and 2 m/s",
    of_numbers: |numbers| {
        let &[restitution, slow, middle, fast, slope_slow, slope, slope_fast] = numbers else {
            return None;
        };
        let (speeds_m_s, slopes) = ([slow, middle, fast], [slope_slow, slope, slope_fast]);
        Some(Restitution::smooth(restitution, speeds_m_s, slopes))
    },
    random_stream: 5,
    restitutions_needed: 4,
    shapes: 3,
    of_normals: |restitution, normals, speeds| {
        let speeds_m_s = [speeds.slowest_m_s, speeds.reference_m_s, speeds.fastest_m_s];
        let [slow, middle, fast] = speeds_m_s;
        let slope = SLOPE * normals[0].sinh();
        let walk = |range: f64| WALK * range.ln().sqrt();
        let slopes = [
            slope + walk(middle / slow) * normals[1],
            slope,
            slope + walk(fast / middle) * normals[2],
        ];
        Restitution::smooth(restitution, speeds_m_s, slopes)
    },
    start: [0.0; 3],
    normal_of_slope: Some(|log_slope, _| (log_slope / SLOPE).asinh()),
    // Few flights hardly determine a slope, and most of what is probable lies near zero.
    slope_from_few_flights: false,
};

impl Restitution {
    /// e* at the middle of three speeds in m/s, each with its slope d ln e / d ln v. Between them the
    /// slope is linear in ln v, beyond them it stays: a quadratic spline of ln e, flexible enough for
    /// any law that changes slowly.
    ///
    /// Prior: the speeds are the slowest impact, v* and the fastest impact; the slope at v* is 0.03 sinh z with z standard
    /// normal, and walks at random from there, by 0.05 for a factor e in speed.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) unless e* is above 0 and not above 1, the speeds
    /// increase from above zero, and the slopes are finite.
    ///
    /// ```
    /// use bouncelab::restitution::Restitution;
    ///
    /// let law = Restitution::smooth(0.9, [0.5, 1.0, 2.0], [0.0, -0.02, -0.1])?;
    /// assert!((law.at(1.0) - 0.9).abs() < 1e-12);
    /// assert!((law.log_slope(4.0) + 0.1).abs() < 1e-12); // a power law beyond the last speed
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn smooth(restitution: f64, speeds_m_s: [f64; 3], slopes: [f64; 3]) -> Result<Self> {
        lively(restitution)?;
        let [slow, middle, fast] = speeds_m_s;
        for (speed_m_s, above) in [(slow, 0.0), (middle, slow), (fast, middle)] {
            let range = (Excluded(above), Unbounded);
            within(Quantity::ReferenceSpeed, speed_m_s, range)?;
        }
        for slope in slopes {
            within(Quantity::RestitutionExponent, slope, ..)?;
        }
        let (reference, slowest, fastest) = (middle.ln(), slow.ln(), fast.ln());
        let numbers = [
            restitution.ln(),
            reference,
            // Towards slower impacts the distance grows the other way.
            -slopes[1],
            -slopes[0],
            reference - slowest,
            slopes[1],
            slopes[2],
            fastest - reference,
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
    let &[
        ln_e,
        reference,
        slow_from,
        slow_to,
        slow_end,
        fast_from,
        fast_to,
        fast_end,
    ] = numbers;
    let faster = ln_speed - reference;
    let either = |fast, slow| faster.if_positive(fast, slow);
    let half = Half {
        from: either(fast_from, slow_from),
        to: either(fast_to, slow_to),
        end: either(fast_end, slow_end),
    };
    let (rise, slope) = half.rise(faster.abs());
    (ln_e + rise, either(slope, -slope))
}

/// The law on one side of its reference speed, in the distance u from there in ln v.
#[derive(Clone, Copy)]
struct Half<const L: usize> {
    /// d ln e/du at the reference speed, and at the end.
    from: Lanes<L>,
    to: Lanes<L>,
    /// Distance of the end, beyond which the slope stays.
    end: Lanes<L>,
}

impl<const L: usize> Half<L> {
    /// ln e over that at the reference speed, and its slope, at a distance. The slope is linear up to the end, so its
    /// integral is the mean of the slopes at both ends times the distance.
    #[inline(always)]
    fn rise(&self, distance: Lanes<L>) -> (Lanes<L>, Lanes<L>) {
        let beyond = (distance - self.end).max(0.0);
        let within = distance - beyond;
        let slope = self.from + (self.to - self.from) * (within / self.end);
        let rise = (self.from + slope) * within * 0.5 + self.to * beyond;
        (rise, slope)
    }
}
