//! Restitution laws: restitution against impact speed.

use std::ops::Bound::{Excluded, Unbounded};

use crate::error::{Quantity, Result, positive, positive_up_to, within};
use crate::simd::{LANES, Lanes, dispatch};

/// The coefficient of restitution e as a function of the impact speed.
///
/// | law | e(v) | source |
/// |---|---|---|
/// | [constant](Self::constant) | e | the paper |
/// | [linear](Self::linear) | e0 - k v | first order of any smooth law |
/// | [power](Self::power) | e* (v/v*)^-p | p = 1/4: plastic contact (K. L. Johnson, Contact Mechanics, 1985, section 11.5) |
/// | [viscoelastic](Self::viscoelastic) | 1 - 1.153 a v^1/5 + ... | P. Müller, T. Pöschel, Phys. Rev. E 84, 021302 (2011) |
/// | [knee](Self::knee) | e0 at low speed, falling above a knee | a hollow ball buckles (R. Cross, Am. J. Phys. 82, 2014) |
/// | [smooth](Self::smooth) | a power law whose exponent changes with speed | no law: what a real surface may do |
///
/// Where a law leaves the range from 0 to 1, e stays at its end.
///
/// ```
/// use bouncelab::impact::Restitution;
///
/// let stiff = Restitution::constant(0.95)?;
/// assert_eq!(stiff.at(3.0), 0.95);
///
/// let softening = Restitution::linear(0.96, 0.01)?;
/// assert_eq!(format!("{:.2}", softening.at(3.0)), "0.93");
/// # Ok::<(), bouncelab::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Restitution {
    family: Family,
    /// The numbers of the law, as its family says; the rest is zero.
    numbers: [f64; NUMBERS],
}

/// The form of a law, with the meaning of its numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Family {
    /// e.
    Constant,
    /// e at rest, and the loss for each m/s.
    Linear,
    /// e at the reference speed, that speed, and the exponent.
    Power,
    /// The dissipation.
    Viscoelastic,
    /// e below the knee, the speed of the knee, and the loss for each m/s above it.
    Knee,
    /// ln e at the reference speed, the logarithm of that speed, and the two [`Half`]s, towards slower
    /// impacts first.
    Smooth,
}

/// As many numbers as the largest family has.
const NUMBERS: usize = 8;

/// A smooth law on one side of its reference speed, in the distance u from there in ln v.
#[derive(Clone, Copy)]
struct Half<const L: usize> {
    /// d ln e / d ln v at the reference speed, and at the end.
    from: Lanes<L>,
    to: Lanes<L>,
    /// Distance of the end, beyond which the slope stays.
    end: Lanes<L>,
}

impl<const L: usize> Half<L> {
    /// ln e over that at the reference speed, and its slope, at a distance.
    #[inline(always)]
    fn rise(&self, distance: Lanes<L>) -> (Lanes<L>, Lanes<L>) {
        let beyond = (distance - self.end).max(0.0);
        let within = distance - beyond;
        let slope = self.from + (self.to - self.from) * (within / self.end);
        let rise = (self.from + slope) * within * 0.5 + self.to * beyond;
        (rise, slope)
    }
}

/// Numerator and denominator of the Padé form of Müller and Pöschel in x = (a v^1/5)^1/2. Expanded
/// it is 1 - 1.15345 x² + 0.79826 x⁴: the series 1 - C1 a v^1/5 + C2 a² v^2/5 with C2 = 3/5 C1²,
/// but it stays between 0 and 1 where the series runs away.
mod pade {
    use crate::simd::Lanes;

    const C1: f64 = 0.501_086;
    const B: [f64; 4] = [0.501_086, 1.153_45, 0.577_977, 0.532_178];

    /// e and d ln e / d ln x at x.
    #[inline(always)]
    pub(super) fn restitution<const L: usize>(x: Lanes<L>) -> (Lanes<L>, Lanes<L>) {
        let numerator = x * C1 + 1.0;
        let denominator = x * (x * (x * (x * B[3] + B[2]) + B[1]) + B[0]) + 1.0;
        let slope = x * (x * (x * (4.0 * B[3]) + 3.0 * B[2]) + 2.0 * B[1]) + B[0];
        (
            numerator / denominator,
            x * (Lanes::all(C1) / numerator - slope / denominator),
        )
    }
}

/// The knee is rounded over this share of its speed: a real ball has no corner, and neither should
/// a likelihood.
const KNEE_WIDTH: f64 = 0.1;

impl Restitution {
    /// The same e at every speed, as in the paper.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) unless it is from 0 to 1.
    ///
    /// ```
    /// use bouncelab::impact::Restitution;
    ///
    /// assert_eq!(Restitution::constant(0.9)?.at(5.0), 0.9);
    /// assert!(Restitution::constant(1.1).is_err());
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn constant(restitution: f64) -> Result<Self> {
        let restitution = fraction(restitution)?;
        Ok(Self::new(
            Family::Constant,
            &[restitution, restitution.ln()],
        ))
    }

    /// e(v) = e0 - k v: falling with the impact speed if k is above zero.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) unless e0 is from 0 to 2 and k (in
    /// s/m) is finite. An e0 above 1 is a line that meets 1 at a speed above zero.
    ///
    /// ```
    /// let law = bouncelab::impact::Restitution::linear(0.96, 0.01)?;
    /// assert!((law.at(2.0) - 0.94).abs() < 1e-12);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn linear(at_rest: f64, loss_per_speed_s_m: f64) -> Result<Self> {
        within(Quantity::Restitution, at_rest, 0.0..=2.0)?;
        let loss = within(Quantity::RestitutionLoss, loss_per_speed_s_m, ..)?;
        Ok(Self::new(Family::Linear, &[at_rest, loss]))
    }

    /// e(v) = e* (v/v*)^-p; p = 1/4 for a contact that deforms for good.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) unless e* is from 0 to 1, v* (m/s) above
    /// zero and p finite.
    ///
    /// ```
    /// let law = bouncelab::impact::Restitution::power(0.9, 2.0, 0.25)?;
    /// assert!((law.at(4.0) - 0.9 * 0.5_f64.powf(0.25)).abs() < 1e-12);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn power(reference: f64, reference_speed_m_s: f64, exponent: f64) -> Result<Self> {
        fraction(reference)?;
        positive(Quantity::ReferenceSpeed, reference_speed_m_s)?;
        let exponent = within(Quantity::RestitutionExponent, exponent, ..)?;
        Ok(Self::new(
            Family::Power,
            &[
                reference,
                reference_speed_m_s,
                exponent,
                reference.ln(),
                reference_speed_m_s.ln(),
            ],
        ))
    }

    /// A viscoelastic sphere: 1 - 1.15344 a v^1/5 + 0.79826 a² v^2/5 - ..., in the Padé form that
    /// stays valid where the series does not.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) unless a, in (m/s)^-1/5, is finite and not
    /// below zero.
    ///
    /// ```
    /// let law = bouncelab::impact::Restitution::viscoelastic(0.05)?;
    /// assert!(law.at(0.1) > law.at(1.0) && law.at(1.0) > law.at(10.0));
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn viscoelastic(dissipation: f64) -> Result<Self> {
        let dissipation = within(Quantity::Dissipation, dissipation, 0.0..)?;
        Ok(Self::new(Family::Viscoelastic, &[dissipation]))
    }

    /// The viscoelastic sphere that has a given restitution at a given speed.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) unless the restitution is above 0, not above
    /// 1, and the speed above zero.
    ///
    /// ```
    /// let law = bouncelab::impact::Restitution::viscoelastic_through(0.9, 2.0)?;
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

    /// e0 well below a knee speed, falling by k per m/s above it; the corner is rounded over a
    /// tenth of the knee speed.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) unless e0 is from 0 to 1, the knee (m/s)
    /// above zero and k (s/m) finite.
    ///
    /// ```
    /// let law = bouncelab::impact::Restitution::knee(0.95, 1.5, 0.02)?;
    /// assert!((law.at(0.5) - 0.95).abs() < 1e-4); // flat below the knee
    /// assert!((law.at(3.0) - 0.92).abs() < 1e-4); // 0.02 for each m/s above it
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn knee(below: f64, knee_speed_m_s: f64, loss_per_speed_s_m: f64) -> Result<Self> {
        fraction(below)?;
        positive(Quantity::ReferenceSpeed, knee_speed_m_s)?;
        let loss = within(Quantity::RestitutionLoss, loss_per_speed_s_m, ..)?;
        Ok(Self::new(Family::Knee, &[below, knee_speed_m_s, loss]))
    }

    /// e* at the middle of three speeds in m/s, each with its slope d ln e / d ln v. Between them the
    /// slope goes straight in ln v, beyond them it stays: a quadratic spline of ln e, flexible enough for
    /// any law that changes slowly.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) unless e* is above 0 and not above 1, the speeds
    /// increase from above zero, and the slopes are finite.
    ///
    /// ```
    /// let law = bouncelab::impact::Restitution::smooth(0.9, [0.5, 1.0, 2.0], [0.0, -0.02, -0.1])?;
    /// assert!((law.at(1.0) - 0.9).abs() < 1e-12);
    /// assert!((law.log_slope(4.0) + 0.1).abs() < 1e-12); // a power law beyond the last speed
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn smooth(restitution: f64, speeds_m_s: [f64; 3], slopes: [f64; 3]) -> Result<Self> {
        lively(restitution)?;
        let [slow, middle, fast] = speeds_m_s;
        for (speed_m_s, above) in [(slow, 0.0), (middle, slow), (fast, middle)] {
            within(
                Quantity::ReferenceSpeed,
                speed_m_s,
                (Excluded(above), Unbounded),
            )?;
        }
        for slope in slopes {
            within(Quantity::RestitutionExponent, slope, ..)?;
        }
        let (reference, slowest, fastest) = (middle.ln(), slow.ln(), fast.ln());
        Ok(Self::new(
            Family::Smooth,
            &[
                restitution.ln(),
                reference,
                // Towards slower impacts the distance grows the other way.
                -slopes[1],
                -slopes[0],
                reference - slowest,
                slopes[1],
                slopes[2],
                fastest - reference,
            ],
        ))
    }

    /// The coefficient of restitution of an impact at a speed, from 0 to 1.
    #[inline]
    pub fn at(&self, impact_speed_m_s: f64) -> f64 {
        self.at_with_log_slope(impact_speed_m_s).0
    }

    /// The coefficients of restitution at several speeds, several at once.
    pub(crate) fn at_each(&self, impact_speeds_m_s: &[f64]) -> Vec<f64> {
        let laws = Restitutions::of(&[*self; LANES]);
        let mut found = Vec::with_capacity(impact_speeds_m_s.len());
        for speeds in impact_speeds_m_s.chunks(LANES) {
            let lanes = Lanes::of(|lane| speeds[lane.min(speeds.len() - 1)]);
            let (e, _) = dispatch(
                #[inline(always)]
                || laws.at_with_log_slope(lanes),
            );
            found.extend_from_slice(&e.0[..speeds.len()]);
        }
        found
    }

    /// d ln e / d ln v at an impact speed: how many per cent e changes when the speed changes by
    /// one. Zero where e is held at 0 or 1.
    ///
    /// ```
    /// let law = bouncelab::impact::Restitution::power(0.9, 2.0, 0.25)?;
    /// assert_eq!(law.log_slope(3.0), -0.25);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn log_slope(&self, impact_speed_m_s: f64) -> f64 {
        self.at_with_log_slope(impact_speed_m_s).1
    }

    /// Both [`Self::at`] and [`Self::log_slope`]; once in the program, since it is long.
    #[inline(never)]
    pub(crate) fn at_with_log_slope(&self, impact_speed_m_s: f64) -> (f64, f64) {
        let (e, log_slope) =
            Restitutions::of(&[*self]).at_with_log_slope(Lanes([impact_speed_m_s]));
        (e.0[0], log_slope.0[0])
    }

    fn new(family: Family, own: &[f64]) -> Self {
        let mut numbers = [0.0; NUMBERS];
        numbers[..own.len()].copy_from_slice(own);
        Self { family, numbers }
    }
}

/// Laws of one family, one in each lane.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Restitutions<const L: usize> {
    family: Family,
    numbers: [Lanes<L>; NUMBERS],
}

impl<const L: usize> Restitutions<L> {
    /// These laws, all of the family of the first.
    #[inline(always)]
    pub(crate) fn of(laws: &[Restitution; L]) -> Self {
        let family = laws[0].family;
        debug_assert!(laws.iter().all(|law| law.family == family));
        let number = |place: usize| Lanes::of(|lane| laws[lane].numbers[place]);
        Self {
            family,
            numbers: std::array::from_fn(number),
        }
    }

    /// e and d ln e/d ln v at an impact speed in each lane.
    #[inline(always)]
    pub(crate) fn at_with_log_slope(&self, speed: Lanes<L>) -> (Lanes<L>, Lanes<L>) {
        let (e, log_slope) = self.unbounded(speed);
        let bounded = Lanes::of(|lane| {
            let e = e.0[lane];
            let e = if e < 0.0 { 0.0 } else { e };
            if e > 1.0 { 1.0 } else { e }
        });
        // Held at 0 or 1 it does not change.
        let free = Lanes::of(|lane| bounded.0[lane] * (1.0 - bounded.0[lane]));
        (bounded, free.if_positive(log_slope, Lanes::all(0.0)))
    }

    /// ln e and d ln e/d ln v, by the logarithm of the impact speed in each lane; not a number where e would be
    /// below zero. Some laws are straight lines there, so that neither powers nor logarithms are left.
    #[inline(always)]
    pub(crate) fn ln_at_with_log_slope(&self, ln_speed: Lanes<L>) -> (Lanes<L>, Lanes<L>) {
        let [_, b, c, d, e, ..] = self.numbers;
        let (ln_e, log_slope) = match self.family {
            Family::Constant => (b, Lanes::all(0.0)),
            Family::Power => (d - c * (ln_speed - e), -c),
            Family::Smooth => self.smooth(ln_speed),
            Family::Linear | Family::Viscoelastic | Family::Knee => {
                let (e, log_slope) = self.unbounded(ln_speed.exp());
                (e.ln(), log_slope)
            }
        };
        // Held at 1 it does not change.
        let zero = Lanes::all(0.0);
        let free = (-ln_e).if_positive(log_slope, zero);
        (ln_e.if_positive(zero, ln_e), free)
    }

    /// The same, if e had no bounds.
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    fn unbounded(&self, v: Lanes<L>) -> (Lanes<L>, Lanes<L>) {
        let [a, b, c, ..] = self.numbers;
        match self.family {
            Family::Constant => (a, Lanes::all(0.0)),
            Family::Linear => {
                let e = a - b * v;
                (e, -(b * v) / e)
            }
            Family::Power => (a * ((v / b).ln() * -c).exp(), -c),
            Family::Viscoelastic => {
                // x = (a v^1/5)^1/2.
                let x = a.sqrt() * (v.ln() * 0.1).exp();
                let (e, log_slope) = pade::restitution(x);
                (e, log_slope * 0.1)
            }
            Family::Knee => {
                let width = b * KNEE_WIDTH;
                let past = (v - b) / width;
                // ln(1 + exp past) and 1/(1 + exp -past), without overflow.
                let small = (-past.abs()).exp();
                let softplus = past.max(0.0) + (small + 1.0).ln();
                let logistic = past.if_positive(Lanes::all(1.0), small) / (small + 1.0);
                let e = a - c * width * softplus;
                (e, -(c * logistic * v) / e)
            }
            Family::Smooth => {
                let (ln_e, log_slope) = self.smooth(v.ln());
                (ln_e.exp(), log_slope)
            }
        }
    }

    /// ln e and its slope of a smooth law.
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    fn smooth(&self, ln_speed: Lanes<L>) -> (Lanes<L>, Lanes<L>) {
        let [
            ln_e,
            reference,
            slow_from,
            slow_to,
            slow_end,
            fast_from,
            fast_to,
            fast_end,
        ] = self.numbers;
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
}

/// The Padé argument at which e has a value: Newton on ln e over ln x, which is nearly straight.
fn pade_argument(restitution: f64) -> f64 {
    const STEPS: usize = 60;
    if restitution >= 1.0 {
        return 0.0;
    }
    let target = restitution.ln();
    // 1 - 1.15 x² for a lively ball, about x^-3 for a dead one.
    let mut x = ((1.0 - restitution) / 1.153_45).sqrt() + restitution.powf(-1.0 / 3.0) - 1.0;
    for _ in 0..STEPS {
        let (Lanes([e]), Lanes([log_slope])) = pade::restitution(Lanes([x]));
        let step = (target - e.ln()) / log_slope;
        // At most a factor of e at once: the start is rough for balls that hardly bounce.
        x *= step.clamp(-1.0, 1.0).exp();
        if step.abs() < 1e-15 {
            break;
        }
    }
    x
}

/// Of a ball that bounces at all.
fn lively(restitution: f64) -> Result<f64> {
    positive_up_to(Quantity::Restitution, restitution, 1.0)
}

fn fraction(restitution: f64) -> Result<f64> {
    within(Quantity::Restitution, restitution, 0.0..=1.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    #[expect(clippy::float_cmp, reason = "the ends of the range are exact")]
    fn restitution_stays_a_fraction() {
        let line = Restitution::linear(0.9, 0.1).unwrap();
        assert_eq!(line.at(0.0), 0.9);
        assert_eq!(line.at(100.0), 0.0);
        assert_eq!(Restitution::linear(0.9, -0.1).unwrap().at(100.0), 1.0);
        let power = Restitution::power(0.9, 1.0, 0.25).unwrap();
        assert_eq!(power.at(1e-9), 1.0);
    }

    #[test]
    fn absurd_laws_are_refused() {
        for restitution in [-0.1, 1.1, f64::NAN, f64::INFINITY] {
            assert!(Restitution::constant(restitution).is_err());
            assert!(Restitution::power(restitution, 1.0, 0.1).is_err());
            assert!(Restitution::knee(restitution, 1.0, 0.1).is_err());
            assert!(Restitution::viscoelastic_through(restitution, 1.0).is_err());
        }
        assert!(Restitution::linear(2.1, 0.0).is_err());
        assert!(Restitution::linear(0.9, f64::NAN).is_err());
        assert!(Restitution::power(0.9, 0.0, 0.1).is_err());
        assert!(Restitution::viscoelastic(-1.0).is_err());
        assert!(Restitution::smooth(0.9, [1.0, 1.0, 2.0], [0.0; 3]).is_err());
        assert!(Restitution::smooth(0.9, [0.5, 1.0, 2.0], [0.0, f64::NAN, 0.0]).is_err());
        assert!(Restitution::knee(0.9, 1.0, f64::INFINITY).is_err());
    }

    /// The logarithm of e by the logarithm of the speed, of every law, beyond its bounds too.
    #[test]
    fn logarithms_are_those_of_the_law() {
        let laws = [
            Restitution::constant(0.9).unwrap(),
            Restitution::linear(0.95, 0.03).unwrap(),
            Restitution::linear(0.9, -0.1).unwrap(),
            Restitution::power(0.9, 2.0, 0.1).unwrap(),
            Restitution::viscoelastic_through(0.9, 2.0).unwrap(),
            Restitution::knee(0.9, 1.5, 0.1).unwrap(),
            Restitution::smooth(0.9, [0.5, 1.0, 2.0], [0.0, 0.02, 0.1]).unwrap(),
        ];
        for law in laws {
            for v in [1e-4_f64, 0.1, 0.7, 1.0, 1.6, 4.0, 9.0] {
                let (e, log_slope) = law.at_with_log_slope(v);
                let of_logarithm = Restitutions::of(&[law]);
                let (Lanes([ln_e]), Lanes([slope])) =
                    of_logarithm.ln_at_with_log_slope(Lanes([v.ln()]));
                assert!((ln_e - e.ln()).abs() < 1e-14, "{law:?} {v}: {ln_e}");
                assert!((slope - log_slope).abs() < 1e-12, "{law:?} {v}: {slope}");
            }
        }
        let beyond = Restitutions::of(&[Restitution::linear(0.9, 0.1).unwrap()]);
        assert!(beyond.ln_at_with_log_slope(Lanes([3.0])).0.0[0].is_nan());
    }

    /// C1 = 1.15344 and C2 = 3/5 C1² of the viscoelastic series (T. Schwager, T. Pöschel, Phys.
    /// Rev. E 57, 650, 1998), for a dissipation so small that the next term is below 1e-6.
    #[test]
    fn the_pade_form_begins_as_the_series() {
        let (a, v) = (1e-3_f64, 2.0_f64);
        let law = Restitution::viscoelastic(a).unwrap();
        let z = a * v.powf(0.2);
        let (c1, c2) = (1.15344, 0.6 * 1.15344 * 1.15344);
        assert!((law.at(v) - (1.0 - c1 * z + c2 * z * z)).abs() < 1e-6);
    }

    #[test]
    fn a_viscoelastic_ball_goes_through_its_point() {
        for e in [0.01, 0.1, 0.5, 0.9, 0.99, 0.999_999] {
            let law = Restitution::viscoelastic_through(e, 1.7).unwrap();
            assert!((law.at(1.7) / e - 1.0).abs() < 1e-12, "{e}");
        }
        let lossless = Restitution::viscoelastic_through(1.0, 1.7).unwrap();
        assert!((lossless.at(5.0) - 1.0).abs() < 1e-15);
    }

    /// The slope of each law against a central difference.
    #[test]
    fn log_slopes_are_the_derivatives() {
        let laws = [
            Restitution::constant(0.9),
            Restitution::linear(0.95, 0.01),
            Restitution::power(0.9, 2.0, 0.05),
            Restitution::viscoelastic_through(0.9, 2.0),
            Restitution::knee(0.95, 1.5, 0.02),
            Restitution::smooth(0.9, [1.0, 1.5, 2.0], [0.03, -0.02, -0.1]),
        ];
        for law in laws.map(Result::unwrap) {
            for v in [0.5, 1.4, 1.6, 3.0_f64] {
                let h = 1e-5;
                let (above, below) = (law.at(v * (1.0 + h)).ln(), law.at(v * (1.0 - h)).ln());
                let expected = (above - below) / (2.0 * h);
                assert!((law.log_slope(v) - expected).abs() < 1e-8, "{law:?} at {v}");
            }
        }
    }

    #[test]
    fn a_knee_is_flat_below_and_straight_above() {
        let law = Restitution::knee(0.95, 1.5, 0.02).unwrap();
        assert!((law.at(0.5) - 0.95).abs() < 1e-5);
        assert!((law.at(3.0) - (0.95 - 0.02 * 1.5)).abs() < 1e-5);
    }
}
