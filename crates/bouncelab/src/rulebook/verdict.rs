//! Pass, fail, or cannot decide.

use std::fmt;

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use super::inconclusive::{self, InconclusiveReason, Remark};
use super::pool;
use super::rebound::Rebound;
use super::rule::{Averaging, Conditions, Evenness, Limits, Requirement, Rule};
use crate::analysis::{Drop, Options};
use crate::ball::{self, Ball};
use crate::diagnostic::{Code, Diagnostic};
use crate::error::{Quantity, Result, positive_up_to};
use crate::estimate::Estimate;
use crate::stats;
use crate::stats::{quantile, sorted};

/// The drops that were heard in one place: those of one recording.
pub type Place<'a> = Vec<&'a Drop>;

/// How a decision follows from a probability (JCGM 106:2012, clause 8).
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Decision {
    /// Guarded acceptance: pass only if the probability of being outside the limits is at most the
    /// risk, fail only if that of being within is, and otherwise cannot decide.
    Guarded {
        /// The greatest probability of a wrong decision, above 0 and below one half.
        risk: f64,
    },
    /// Simple acceptance: whatever is more probable.
    Simple,
}

impl Default for Decision {
    /// Guarded, with at most 5 % wrong.
    fn default() -> Self {
        Self::Guarded { risk: 0.05 }
    }
}

impl Decision {
    /// The greatest probability of a wrong decision.
    ///
    /// ```
    /// use bouncelab::rulebook::Decision;
    ///
    /// assert_eq!(Decision::default().risk(), 0.05);
    /// ```
    pub const fn risk(self) -> f64 {
        match self {
            Self::Guarded { risk } => risk,
            Self::Simple => 0.5,
        }
    }

    fn check(self) -> Result<()> {
        positive_up_to(Quantity::Risk, self.risk(), 0.5).map(drop)
    }
}

/// What a verdict says.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Outcome {
    /// The rule is obeyed.
    Pass,
    /// It is not.
    Fail,
    /// These drops do not tell.
    CannotDecide,
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Pass => "pass",
            Self::Fail => "fail",
            Self::CannotDecide => "cannot decide",
        })
    }
}

/// What drops say of a rule. Heights are those of the point at which the rule measures.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Verdict {
    /// The decision.
    pub outcome: Outcome,
    /// Probability that everything is within the limits, if there are limits and enough drops.
    pub within: Option<f64>,
    /// The rebound, mean over the drops, m.
    pub rebound: Option<Estimate>,
    /// The rebound on the reference, m.
    pub reference: Option<Estimate>,
    /// The one over the other.
    pub share: Option<Estimate>,
    /// How unlike the places are, in the way of the rule.
    pub unevenness: Option<Estimate>,
    /// The values (m, or shares for a rule that compares) that would pass at this uncertainty: the
    /// limits less a guard band. `None` without limits, or if no value would.
    pub accepted: Option<Limits>,
    /// Every drop on the surface.
    pub drops: Vec<Rebound>,
    /// Every drop on the reference.
    pub reference_drops: Vec<Rebound>,
    /// Why nothing can be decided.
    pub doubts: Vec<InconclusiveReason>,
    /// What to know.
    pub remarks: Vec<Remark>,
}

impl Verdict {
    /// Probability that a pass is wrong: that something is outside the limits all the same.
    pub fn wrong_accept(&self) -> Option<f64> {
        self.within.map(|within| 1.0 - within)
    }

    /// Mean over the drops of the plain g T²/8 of their first flights, m; `None` unless all have one.
    pub fn drag_free_m(&self) -> Option<f64> {
        mean_of(&self.drops, |drop| drop.drag_free_m)
    }

    /// Mean over the drops of the rule's own formula, m.
    pub fn formula_m(&self) -> Option<f64> {
        mean_of(&self.drops, |drop| drop.formula_m)
    }
}

fn mean_of(drops: &[Rebound], value: impl Fn(&Rebound) -> Option<f64>) -> Option<f64> {
    let values = drops.iter().map(value).collect::<Option<Vec<f64>>>()?;
    (!values.is_empty()).then(|| stats::mean(&values))
}

/// The seed of what little chance there is: the order in which draws meet.
const SEED: u64 = 1;

/// Judges drops by a rule. The [module](super) has an example.
///
/// `surface` and `reference` are the drops on the surface and, for a rule that compares, on the
/// reference, by place; they were analysed with the same `settings`, which must ask for the inference.
///
/// # Errors
/// [`Error::OutOfRange`](crate::Error::OutOfRange) for a rule or a risk that makes no sense. That the
/// drops do not suffice is no error but a verdict.
pub fn judge(
    rule: &Rule,
    settings: &Options,
    conditions: &Conditions,
    surface: &[Place],
    reference: &[Place],
    decision: Decision,
) -> Result<Verdict> {
    rule.check()?;
    decision.check()?;
    let dropped_m = settings.priors.drop_height_m.map(|height| height.value);
    let fall_m = rule.fall_m(settings.ball.diameter_m(), dropped_m);
    let drops = rebounds(surface, rule, fall_m, settings);
    let reference_drops = rebounds(reference, rule, fall_m, settings);
    let mut doubts = of_conditions(rule, conditions);
    if fall_m.is_none() {
        doubts.push(InconclusiveReason::NoHeight);
    }
    doubts.extend(of_numbers(rule, surface, reference));
    if fall_m.is_some() {
        doubts.extend(of_drops(surface, &drops));
        doubts.extend(of_drops(reference, &reference_drops));
    }
    let pooled = Pooled::new(rule, &drops, &reference_drops);
    let within = pooled.within(rule, &drops);
    let outcome = match within {
        _ if !doubts.is_empty() => Outcome::CannotDecide,
        Some(within) if 1.0 - within <= decision.risk() => Outcome::Pass,
        Some(within) if within <= decision.risk() => Outcome::Fail,
        _ => Outcome::CannotDecide,
    };
    if outcome == Outcome::CannotDecide && doubts.is_empty() {
        doubts.push(InconclusiveReason::TooUncertain);
    }
    let mut remarks = inconclusive::of_rule(rule);
    remarks.extend(of_circumstances(
        rule, fall_m, settings, conditions, surface,
    ));
    Ok(Verdict {
        outcome,
        within,
        rebound: pool::summary(&pooled.rebound),
        reference: pool::summary(&pooled.reference),
        share: pool::summary(&pooled.share),
        unevenness: pool::summary(&pooled.unevenness),
        accepted: pooled.accepted(rule, decision),
        drops,
        reference_drops,
        doubts,
        remarks,
    })
}

fn rebounds(
    places: &[Place],
    rule: &Rule,
    fall_m: Option<f64>,
    settings: &Options,
) -> Vec<Rebound> {
    places
        .iter()
        .enumerate()
        .flat_map(|(place, drops)| {
            drops
                .iter()
                .map(move |drop| Rebound::new(place, drop, rule, fall_m, settings))
        })
        .collect()
}

/// Draws of what the drops say together; empty where they do not tell.
#[derive(Default)]
struct Pooled {
    rebound: Vec<f64>,
    reference: Vec<f64>,
    share: Vec<f64>,
    unevenness: Vec<f64>,
}

impl Pooled {
    fn new(rule: &Rule, drops: &[Rebound], reference: &[Rebound]) -> Self {
        let mut rng = ChaCha8Rng::seed_from_u64(SEED);
        let rebound = mean(drops.iter(), &mut rng);
        let reference = mean(reference.iter(), &mut rng);
        let share = pool::ratio(&rebound, &reference);
        let last = drops.iter().map(|drop| drop.place).max().unwrap_or(0);
        let places: Vec<Vec<f64>> = (0..=last)
            .map(|place| mean(drops.iter().filter(|drop| drop.place == place), &mut rng))
            .filter(|draws| !draws.is_empty())
            .collect();
        let unevenness = match rule.evenness {
            Some(_) if places.len() < 2 => Vec::new(),
            None => Vec::new(),
            Some(Evenness::WithinOfMean(_)) => pool::across(&places, farthest_from_mean),
            Some(Evenness::Range(_)) => pool::ratio(&pool::across(&places, range), &reference),
        };
        Self {
            rebound,
            reference,
            share,
            unevenness,
        }
    }

    /// The draws and the limits that the rule sets them.
    fn required(&self, rule: &Rule) -> (&[f64], Limits) {
        match &rule.requirement {
            Requirement::Height(limits) => (&self.rebound, *limits),
            Requirement::About(_) => (&self.rebound, Limits::default()),
            Requirement::Share { limits, .. } => (&self.share, *limits),
        }
    }

    /// Probability that all is within the limits, on the safe side: one draw more is taken to be
    /// outside, and one to be within.
    fn within(&self, rule: &Rule, drops: &[Rebound]) -> Option<f64> {
        let (values, limits) = self.required(rule);
        let even = match rule.evenness {
            Some(_) if self.unevenness.is_empty() => return None,
            Some(Evenness::WithinOfMean(most) | Evenness::Range(most)) => Some(most),
            None => None,
        };
        if values.is_empty() || (limits.is_open() && even.is_none()) {
            return None;
        }
        let is_even = |place: usize| {
            even.is_none_or(|most| self.unevenness.get(place).is_some_and(|u| *u <= most))
        };
        if rule.averaging == Averaging::Each {
            // Whatever may go wrong cannot do more than add up.
            let uneven = even.map_or(0.0, |_| 1.0 - share_of(self.unevenness.len(), is_even));
            return Some((every_within(drops, &limits) - uneven).max(0.0));
        }
        let is_within = |place: usize| limits.contain(values[place]) && is_even(place);
        Some(share_of(values.len(), is_within))
    }

    /// The limits less the guard bands: between the value and a limit must lie what the risk leaves
    /// of the distribution.
    fn accepted(&self, rule: &Rule, decision: Decision) -> Option<Limits> {
        let (values, limits) = self.required(rule);
        if limits.is_open() {
            return None;
        }
        let sorted = sorted(values.iter().copied());
        let at = |share: f64| quantile(&sorted, share);
        let (middle, low, high) = (at(0.5)?, at(decision.risk())?, at(1.0 - decision.risk())?);
        let accepted = Limits {
            least: limits.least.map(|least| least + middle - low),
            greatest: limits.greatest.map(|greatest| greatest - (high - middle)),
        };
        let any = match (accepted.least, accepted.greatest) {
            (Some(least), Some(greatest)) => least <= greatest,
            _ => true,
        };
        any.then_some(accepted)
    }
}

/// A lower bound of the probability that every drop is within: the chances of each to be outside
/// cannot do more than add up.
fn every_within(drops: &[Rebound], limits: &Limits) -> f64 {
    let outside = |drop: &Rebound| {
        1.0 - share_of(drop.draws.len(), |place| limits.contain(drop.draws[place]))
    };
    (1.0 - drops.iter().map(outside).sum::<f64>()).max(0.0)
}

fn share_of(count: usize, holds: impl Fn(usize) -> bool) -> f64 {
    let holding = (0..count).filter(|&place| holds(place)).count();
    (holding as f64 + 1.0) / (count as f64 + 2.0)
}

/// The mean over drops, if all of them tell.
fn mean<'a>(drops: impl Iterator<Item = &'a Rebound>, rng: &mut ChaCha8Rng) -> Vec<f64> {
    let draws: Vec<&[f64]> = drops.map(|drop| drop.draws.as_slice()).collect();
    if draws.iter().any(|draws| draws.is_empty()) {
        return Vec::new();
    }
    pool::mean(&draws, rng)
}

fn farthest_from_mean(places: &[f64]) -> f64 {
    let mean = stats::mean(places);
    places
        .iter()
        .map(|place| (place / mean - 1.0).abs())
        .fold(0.0, f64::max)
}

fn range(places: &[f64]) -> f64 {
    let ends = places
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &place| {
            (low.min(place), high.max(place))
        });
    ends.1 - ends.0
}

fn of_conditions(rule: &Rule, conditions: &Conditions) -> Vec<InconclusiveReason> {
    let temperature = conditions
        .temperature_k
        .filter(|&kelvin| !rule.temperature_k.contain(kelvin))
        .map(InconclusiveReason::Temperature);
    let altitude = conditions
        .altitude_m
        .filter(|&metres| !rule.altitude_m.contain(metres))
        .map(InconclusiveReason::Altitude);
    temperature.into_iter().chain(altitude).collect()
}

fn of_numbers(rule: &Rule, surface: &[Place], reference: &[Place]) -> Vec<InconclusiveReason> {
    let count = |places: &[Place]| places.iter().map(Vec::len).sum::<usize>();
    let too_few = |given: usize, of_reference| {
        (given < rule.fewest_drops).then_some(InconclusiveReason::TooFewDrops {
            needed: rule.fewest_drops,
            given,
            of_reference,
        })
    };
    let mut doubts: Vec<InconclusiveReason> = too_few(count(surface), false).into_iter().collect();
    let open = match &rule.requirement {
        Requirement::Height(limits) | Requirement::Share { limits, .. } => limits.is_open(),
        Requirement::About(_) => true,
    };
    if open {
        doubts.push(InconclusiveReason::NoLimits);
    }
    if rule.needs_reference() {
        match count(reference) {
            0 => doubts.push(InconclusiveReason::NoReference),
            given => doubts.extend(too_few(given, true)),
        }
    }
    if rule.evenness.is_some() && surface.len() < 2 {
        doubts.push(InconclusiveReason::OnePlace);
    }
    doubts
}

/// What keeps single drops from telling.
fn of_drops(places: &[Place], rebounds: &[Rebound]) -> Vec<InconclusiveReason> {
    let drops = places.iter().flatten();
    let mut doubts = Vec::new();
    for ((drop, rebound), number) in drops.zip(rebounds).zip(1..) {
        let unknown = |reason| InconclusiveReason::Unknown(number, reason);
        match &drop.posterior {
            Err(reason) => doubts.push(unknown(reason.diagnostic())),
            Ok(found) => {
                doubts.extend(
                    found
                        .diagnostics
                        .iter()
                        .filter_map(|known| match known.code {
                            Code::HeightContradictsTimes => {
                                Some(InconclusiveReason::Height(known.clone()))
                            }
                            _ => None,
                        }),
                );
                if rebound.draws.is_empty() {
                    doubts.push(unknown(Diagnostic::new(Code::HeightOutOfReach)));
                }
            }
        }
    }
    doubts
}

/// A remark if the ball is not of the kind that the rule is for.
fn other_ball(rule: &Rule, ball: &Ball) -> Option<Remark> {
    /// Balls of one kind differ by less, worn ones too.
    const ALIKE: f64 = 0.1;
    let preset = ball::preset(rule.ball.as_ref()?).ok()?;
    let differs = |stated: f64, of_rule: f64| (stated / of_rule - 1.0).abs() > ALIKE;
    let other = differs(ball.mass_kg(), preset.known.ball.mass_kg())
        || differs(ball.diameter_m(), preset.known.ball.diameter_m());
    other.then_some(Remark::OtherBall(preset.name))
}

fn of_circumstances(
    rule: &Rule,
    fall_m: Option<f64>,
    settings: &Options,
    conditions: &Conditions,
    surface: &[Place],
) -> Vec<Remark> {
    /// A height this much off is another height.
    const SAME: f64 = 0.02;
    /// An impact this much faster is another impact.
    const FASTER: f64 = 1.1;
    let dropped_m = settings.priors.drop_height_m.map(|height| height.value);
    let mut remarks = Vec::new();
    remarks.extend(other_ball(rule, &settings.ball));
    if conditions.temperature_k.is_none() && !rule.temperature_k.is_open() {
        remarks.push(Remark::TemperatureNotStated(rule.temperature_k));
    }
    if conditions.altitude_m.is_none() && !rule.altitude_m.is_open() {
        remarks.push(Remark::AltitudeNotStated(rule.altitude_m));
    }
    if let (Some(dropped_m), Some(rule_m)) = (dropped_m, fall_m)
        && (dropped_m / rule_m - 1.0).abs() > SAME
    {
        remarks.push(Remark::OtherHeight { dropped_m, rule_m });
    }
    let fastest = surface
        .iter()
        .flatten()
        .filter_map(|drop| drop.posterior.as_ref().ok())
        .flat_map(|found| &found.impacts)
        .map(|impact| impact.impact_speed_m_s.value)
        .fold(0.0, f64::max);
    let of_rule = settings.model().ok().zip(fall_m);
    if let Some(Ok(fall)) = of_rule.map(|(model, fall_m)| model.fall(fall_m))
        && fastest > 0.0
        && fall.impact_speed_m_s > FASTER * fastest
    {
        remarks.push(Remark::Extrapolated(fall.impact_speed_m_s / fastest));
    }
    let drops = surface.iter().map(Vec::len).sum::<usize>();
    if (1..3).contains(&drops) {
        remarks.push(Remark::FewDrops(drops));
    }
    remarks
}
