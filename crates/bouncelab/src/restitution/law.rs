//! What every restitution law has, and how it is evaluated.

use std::str::FromStr;

use super::LawKind;
use crate::error::{Error, Quantity, Result, positive_up_to, within};
use crate::simd::{LANES, Lanes, dispatch};

/// The coefficient of restitution e as a function of the impact speed: a law of one of the [kinds](LawKind) with its
/// numbers. Where a law leaves the range from 0 to 1, e stays at its end.
///
/// As text it is the name of the law with its numbers, or one number, which is a constant restitution:
///
/// ```
/// use bouncelab::restitution::Restitution;
///
/// let stiff = Restitution::constant(0.95)?;
/// assert_eq!(stiff.at(3.0), 0.95);
/// assert_eq!("0.95".parse(), Ok(stiff));
///
/// let softening: Restitution = "linear:0.96,0.01".parse()?;
/// assert_eq!(format!("{:.2}", softening.at(3.0)), "0.93");
/// # Ok::<(), bouncelab::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Restitution {
    kind: LawKind,
    /// The numbers of the law, with meanings that its file states; the rest is zero.
    numbers: [f64; NUMBERS],
}

/// As many numbers as the largest law has.
pub(super) const NUMBERS: usize = 9;

/// As many numbers besides e* as the inference can find for a law.
pub(crate) const MAX_SHAPES: usize = 5;

/// A law as data: what the simulation, the inference and the front ends ask of it. The two functions that are evaluated
/// millions of times, `curve` and `log_curve`, are functions of its module.
#[derive(Debug)]
pub(super) struct Law {
    /// Its name, as in arguments, tables and messages.
    pub(super) name: &'static str,
    /// A law of this kind as text.
    pub(super) example: &'static str,
    /// The same as a formula.
    pub(super) meaning: &'static str,
    /// The law with the numbers of its text; `None` if their count is wrong.
    pub(super) of_numbers: fn(&[f64]) -> Option<Result<Restitution>>,
    /// Number of the stream of random numbers of the inference. It belongs to the name: it never changes, and no other law
    /// ever gets it, so that another law in the list leaves the digits of all others as they are.
    pub(super) random_stream: u64,
    /// How many restitutions, at different speeds, distinguish it from a constant.
    pub(super) restitutions_needed: usize,
    /// How many numbers it has besides e*, at most [`MAX_SHAPES`].
    pub(super) shapes: usize,
    /// The prior: the law with this e* at the reference speed whose other numbers are these standard normals.
    pub(super) of_normals: fn(f64, [f64; MAX_SHAPES], &SpeedRange) -> Result<Restitution>,
    /// The normals from which a search for the best fit starts.
    pub(super) start: [f64; MAX_SHAPES],
    /// The first normal of the law whose slope d ln e/d ln v at the reference speed is this, if one number determines it:
    /// the search starts there if another law was fitted before.
    pub(super) normal_of_slope: Option<fn(f64, &SpeedRange) -> f64>,
    /// Whether that start helps if there are few flights too.
    pub(super) slope_from_few_flights: bool,
}

/// The impact speeds of a drop, m/s.
#[expect(clippy::struct_field_names, reason = "units stand in names")]
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SpeedRange {
    /// v*, in the middle of them: every law of the inference is given by its restitution there.
    pub(crate) reference_m_s: f64,
    pub(crate) slowest_m_s: f64,
    pub(crate) fastest_m_s: f64,
}

impl LawKind {
    /// Its name, as in arguments and tables.
    pub const fn name(self) -> &'static str {
        self.law().name
    }

    /// A law of this kind as text, which [`Restitution`] reads.
    ///
    /// ```
    /// use bouncelab::restitution::LawKind;
    ///
    /// assert_eq!(LawKind::Linear.example(), "linear:0.96,0.01");
    /// assert_eq!(LawKind::Linear.meaning(), "0.96 - 0.01 v");
    /// ```
    pub const fn example(self) -> &'static str {
        self.law().example
    }

    /// The restitution of the [example](Self::example) at v m/s.
    pub const fn meaning(self) -> &'static str {
        self.law().meaning
    }

    /// How many restitutions, at different speeds, distinguish it from a constant.
    pub const fn restitutions_needed(self) -> usize {
        self.law().restitutions_needed
    }

    /// How many numbers it has besides e*.
    pub(crate) const fn shapes(self) -> usize {
        self.law().shapes
    }

    /// Number of its stream of random numbers.
    pub(crate) const fn random_stream(self) -> u64 {
        self.law().random_stream
    }

    /// The law with this restitution at the reference speed, and with these standard normals as its other numbers.
    pub(crate) fn of_normals(
        self,
        restitution: f64,
        normals: [f64; MAX_SHAPES],
        speeds: &SpeedRange,
    ) -> Result<Restitution> {
        (self.law().of_normals)(restitution, normals, speeds)
    }

    /// The standard normal of one of its numbers from which a search for the best fit starts.
    pub(crate) fn start(self, shape: usize) -> f64 {
        self.law().start[shape]
    }

    /// The first standard normal of the law that has this slope d ln e/d ln v at the reference speed; `None` where one
    /// number does not determine it, or few flights determine it badly.
    pub(crate) fn normal_of_slope(
        self,
        log_slope: f64,
        speeds: &SpeedRange,
        many_flights: bool,
    ) -> Option<f64> {
        let law = self.law();
        let normal = law.normal_of_slope?;
        (many_flights || law.slope_from_few_flights).then(|| normal(log_slope, speeds))
    }

    /// Whether the first of its numbers besides e* is a slope.
    pub(crate) fn has_slope(self) -> bool {
        self.law().normal_of_slope.is_some()
    }
}

impl std::fmt::Display for LawKind {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for LawKind {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        Self::ALL
            .into_iter()
            .find(|law| law.name() == text)
            .ok_or_else(|| Error::unknown_name("restitution law", text, &Self::ALL.map(Self::name)))
    }
}

impl FromStr for Restitution {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self> {
        let (name, numbers) = text.split_once(':').unwrap_or(("constant", text));
        let numbers: Option<Vec<f64>> = numbers
            .split(',')
            .map(|number| number.trim().parse().ok())
            .collect();
        let kind = LawKind::ALL.into_iter().find(|kind| kind.name() == name);
        kind.zip(numbers)
            .and_then(|(kind, numbers)| (kind.law().of_numbers)(&numbers))
            .unwrap_or_else(|| {
                let examples = LawKind::ALL.map(LawKind::example);
                Err(Error::unknown_name("restitution law", text, &examples))
            })
    }
}

impl Restitution {
    pub(super) fn new(kind: LawKind, own: &[f64]) -> Self {
        let mut numbers = [0.0; NUMBERS];
        numbers[..own.len()].copy_from_slice(own);
        Self { kind, numbers }
    }

    /// The coefficient of restitution of an impact at a speed, from 0 to 1.
    #[inline]
    pub fn at(&self, impact_speed_m_s: f64) -> f64 {
        self.at_with_log_slope(impact_speed_m_s).0
    }

    /// The coefficients of restitution at several speeds, several at once.
    pub(crate) fn at_each(&self, impact_speeds_m_s: &[f64]) -> Vec<f64> {
        let laws = Restitutions::of(&[*self; LANES]);
        let mut restitutions = Vec::with_capacity(impact_speeds_m_s.len());
        for speeds in impact_speeds_m_s.chunks(LANES) {
            let lanes = Lanes::of(|lane| speeds[lane.min(speeds.len() - 1)]);
            let (e, _) = dispatch(
                #[inline(always)]
                || laws.at_with_log_slope(lanes),
            );
            restitutions.extend_from_slice(&e.0[..speeds.len()]);
        }
        restitutions
    }

    /// d ln e / d ln v at an impact speed: how many per cent e changes when the speed changes by
    /// one. Zero where e is held at 0 or 1.
    ///
    /// ```
    /// let law = bouncelab::restitution::Restitution::power(0.9, 2.0, 0.25)?;
    /// assert_eq!(law.log_slope(3.0), -0.25);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn log_slope(&self, impact_speed_m_s: f64) -> f64 {
        self.at_with_log_slope(impact_speed_m_s).1
    }

    /// Both [`Self::at`] and [`Self::log_slope`]. The body is large, so the program has one copy of it.
    #[inline(never)]
    pub(crate) fn at_with_log_slope(&self, impact_speed_m_s: f64) -> (f64, f64) {
        let (e, log_slope) =
            Restitutions::of(&[*self]).at_with_log_slope(Lanes([impact_speed_m_s]));
        (e.0[0], log_slope.0[0])
    }
}

/// Laws of one kind, one in each lane.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Restitutions<const L: usize> {
    kind: LawKind,
    numbers: [Lanes<L>; NUMBERS],
}

impl<const L: usize> Restitutions<L> {
    /// These laws, all of the kind of the first.
    #[inline(always)]
    pub(crate) fn of(laws: &[Restitution; L]) -> Self {
        let kind = laws[0].kind;
        debug_assert!(laws.iter().all(|law| law.kind == kind));
        let number = |index: usize| Lanes::of(|lane| laws[lane].numbers[index]);
        Self {
            kind,
            numbers: std::array::from_fn(number),
        }
    }

    /// e and d ln e/d ln v at an impact speed in each lane.
    #[inline(always)]
    pub(crate) fn at_with_log_slope(&self, speed: Lanes<L>) -> (Lanes<L>, Lanes<L>) {
        let (e, log_slope) = self.kind.curve(&self.numbers, speed);
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
        let (ln_e, log_slope) = self.kind.log_curve(&self.numbers, ln_speed);
        // Held at 1 it does not change.
        let zero = Lanes::all(0.0);
        let free = (-ln_e).if_positive(log_slope, zero);
        (ln_e.if_positive(zero, ln_e), free)
    }
}

/// Of a ball that bounces at all.
pub(super) fn lively(restitution: f64) -> Result<f64> {
    positive_up_to(Quantity::Restitution, restitution, 1.0)
}

pub(super) fn fraction(restitution: f64) -> Result<f64> {
    within(Quantity::Restitution, restitution, 0.0..=1.0)
}
