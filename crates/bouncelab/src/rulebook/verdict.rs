//! Conforms, does not conform, or cannot decide.

use std::fmt;

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

use super::budget::{MeanRebound, Spread};
use super::inconclusive::{self, InconclusiveReason, Remark};
use super::precision::Precision;
use super::procedure::{self, Check, Conditions, Kept};
use super::rebound::Rebound;
use super::rule::{Averaging, Evenness, Limits, Rule};
use crate::analysis::{Drop, Options};
use crate::ball::{self, Ball};
use crate::error::{Quantity, Result, positive_up_to};
use crate::estimate::Estimate;
use crate::stats;

/// The drops that were detected in one place: those of one recording, or of several.
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
    /// The limits are met, and the procedure of the rule is shown to be kept.
    Conforms,
    /// The limits are met, but parts of the procedure are not shown.
    ConformsAsFarAsShown,
    /// The limits are not met.
    DoesNotConform,
    /// These drops do not tell, or the procedure was not kept.
    CannotDecide,
}

impl Outcome {
    /// Its name in data.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Conforms => "conforms",
            Self::ConformsAsFarAsShown => "conforms-as-far-as-shown",
            Self::DoesNotConform => "does-not-conform",
            Self::CannotDecide => "cannot-decide",
        }
    }
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// What drops say of a rule. Heights are those of the point at which the rule measures.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Verdict {
    /// The decision.
    pub outcome: Outcome,
    /// Probability that everything is within the limits, if there are limits and every drop has a height.
    pub within: Option<f64>,
    /// The rebound by the procedure of the rule, mean over the drops.
    pub rebound: Option<MeanRebound>,
    /// The rebound on the reference.
    pub reference: Option<MeanRebound>,
    /// The one over the other.
    pub share: Option<Estimate>,
    /// How unlike the places are, in the way of the rule.
    pub unevenness: Option<Estimate>,
    /// What the model answers in its place, from all impacts: a height, m, or a share of the reference.
    pub model: Option<Estimate>,
    /// The values (m, or shares for a rule that compares) that would conform at this uncertainty: the
    /// limits less a guard band. `None` without limits, or if no value would.
    pub accepted: Option<Limits>,
    /// The parts of the procedure, and whether they were kept.
    pub procedure: Vec<Check>,
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
    /// Probability that it is wrong to say that it conforms: that something is outside the limits all the same.
    pub fn wrong_accept(&self) -> Option<f64> {
        self.within.map(|within| 1.0 - within)
    }

    /// The value that is held against the limits: a height, m, or a share.
    pub fn value(&self) -> Option<Estimate> {
        self.share.or_else(|| Some(self.rebound.as_ref()?.height_m))
    }

    /// How drops repeat within a place and over places; `None` without two places, one of which has two drops.
    pub fn precision(&self) -> Option<Precision> {
        let places = self
            .drops
            .iter()
            .map(|drop| drop.place + 1)
            .max()
            .unwrap_or(0);
        let mut levels = vec![Vec::new(); places];
        for drop in &self.drops {
            levels[drop.place].push(drop.height_m?);
        }
        Precision::of(&levels)
    }

    /// Mean over the drops of the plain g T²/8 of their first flights, m; `None` unless all have one.
    pub fn drag_free_m(&self) -> Option<f64> {
        let heights_m = self.drops.iter().map(|drop| drop.drag_free_m);
        let heights_m = heights_m.collect::<Option<Vec<f64>>>()?;
        (!heights_m.is_empty()).then(|| stats::mean(&heights_m))
    }
}

/// Judges drops by a rule. The [module](super) has an example.
///
/// `surface` and `reference` are the drops on the surface and, for a rule that compares, on the
/// reference, by place; they were analysed with the same `settings`. Without an inference the model has no answer.
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
    let rebounds = |places: &[Place]| -> Vec<Vec<Rebound>> {
        let of = |place: &Place| {
            let drops = place.iter();
            drops
                .map(|drop| Rebound::new(drop, rule, settings))
                .collect()
        };
        places.iter().map(of).collect()
    };
    let (surface, reference) = (rebounds(surface), rebounds(reference));
    judge_rebounds(rule, settings, conditions, surface, reference, decision)
}

/// Judges drops of which the rebounds by this rule and these settings are known, by place.
///
/// # Errors
/// As [`judge`].
pub fn judge_rebounds(
    rule: &Rule,
    settings: &Options,
    conditions: &Conditions,
    surface: Vec<Vec<Rebound>>,
    reference: Vec<Vec<Rebound>>,
    decision: Decision,
) -> Result<Verdict> {
    rule.check()?;
    decision.check()?;
    let fall_m = rule.fall_of(settings);
    let counts = [&surface, &reference].map(|places| places.iter().map(Vec::len).collect());
    let procedure = procedure::checks(rule, settings.ball.diameter_m(), conditions, &counts);
    let (drops, reference_drops) = (placed(surface), placed(reference));
    let mut doubts = doubts(rule, fall_m, &procedure);
    doubts.extend(of_drops(&drops));
    doubts.extend(of_drops(&reference_drops));
    let found = Found::new(rule, settings, fall_m, &drops, &reference_drops);
    let within = found.within(rule, &drops);
    let outcome = outcome(within, &doubts, &procedure, decision);
    let mut remarks = inconclusive::of_rule(rule);
    remarks.extend(other_ball(rule, &settings.ball));
    if outcome == Outcome::CannotDecide && doubts.is_empty() {
        doubts.push(InconclusiveReason::TooUncertain);
        remarks.push(found.deciding_drops(rule, drops.len(), decision));
    }
    if (1..3).contains(&drops.len()) {
        remarks.push(Remark::FewDrops(drops.len()));
    }
    let model = model(rule, &drops, &reference_drops).map(|spread| spread.estimate());
    let share = found.share.map(|share| share.estimate());
    let mut verdict = Verdict {
        outcome,
        within,
        share,
        unevenness: Estimate::of_draws(found.unevenness.iter().copied()),
        accepted: found.accepted(rule, decision),
        rebound: found.rebound,
        reference: found.reference,
        model,
        procedure,
        drops,
        reference_drops,
        doubts,
        remarks,
    };
    verdict.remarks.extend(verdict.model_differs());
    Ok(verdict)
}

fn outcome(
    within: Option<f64>,
    doubts: &[InconclusiveReason],
    procedure: &[Check],
    decision: Decision,
) -> Outcome {
    let shown = procedure.iter().all(|check| check.kept == Kept::Yes);
    match within {
        _ if !doubts.is_empty() => Outcome::CannotDecide,
        Some(within) if 1.0 - within <= decision.risk() && shown => Outcome::Conforms,
        Some(within) if 1.0 - within <= decision.risk() => Outcome::ConformsAsFarAsShown,
        Some(within) if within <= decision.risk() => Outcome::DoesNotConform,
        _ => Outcome::CannotDecide,
    }
}

/// The drops of all places, each with the number of its place.
fn placed(places: Vec<Vec<Rebound>>) -> Vec<Rebound> {
    let placed = places.into_iter().enumerate();
    let drops = placed
        .flat_map(|(place, drops)| drops.into_iter().map(move |drop| Rebound { place, ..drop }));
    drops.collect()
}

/// The values that a rule holds against its limits.
struct Found {
    rebound: Option<MeanRebound>,
    reference: Option<MeanRebound>,
    share: Option<Spread>,
    /// Draws of how unlike the places are; empty if the rule does not ask.
    unevenness: Vec<f64>,
}

impl Found {
    fn new(
        rule: &Rule,
        settings: &Options,
        fall_m: Option<f64>,
        drops: &[Rebound],
        reference: &[Rebound],
    ) -> Self {
        let mean = |drops: &[Rebound]| MeanRebound::new(drops, fall_m, rule, settings);
        let (rebound, reference) = (mean(drops), mean(reference));
        let share = rebound
            .as_ref()
            .zip(reference.as_ref())
            .map(|(rebound, reference)| rebound.over(reference));
        let unevenness = match (rule.evenness, &rebound) {
            (Some(even), Some(_)) => unevenness(even, drops, reference.as_ref(), settings),
            _ => Vec::new(),
        };
        Self {
            rebound,
            reference,
            share,
            unevenness,
        }
    }

    /// The value that the rule limits.
    fn limited(&self, rule: &Rule) -> Option<Spread> {
        if rule.needs_reference() {
            self.share
        } else {
            Some(self.rebound.as_ref()?.spread)
        }
    }

    /// Probability that all is within the limits. Whatever may go wrong cannot do more than add up.
    fn within(&self, rule: &Rule, drops: &[Rebound]) -> Option<f64> {
        let limits = rule.limits();
        let value = self.limited(rule)?;
        if limits.is_open() || (rule.evenness.is_some() && self.unevenness.is_empty()) {
            return None;
        }
        let outside = if rule.averaging == Averaging::Each {
            let each = drops
                .iter()
                .filter_map(|drop| Some(value.of_drop(drop.height_m?, drop.times_sd_m)));
            each.map(|drop| 1.0 - drop.within(&limits)).sum()
        } else {
            1.0 - value.within(&limits)
        };
        let uneven = rule.evenness.map_or(0.0, |even| {
            let most = even.most();
            let beyond = self
                .unevenness
                .iter()
                .filter(|&&found| found > most)
                .count();
            (beyond as f64 + 1.0) / (self.unevenness.len() as f64 + 2.0)
        });
        Some((1.0 - outside - uneven).max(0.0))
    }

    /// The limits less the guard bands.
    fn accepted(&self, rule: &Rule, decision: Decision) -> Option<Limits> {
        let limits = rule.limits();
        let guard = self
            .limited(rule)
            .filter(|_| !limits.is_open())?
            .guard(decision.risk());
        let accepted = limits.before_rounding(-2.0 * guard);
        let some = accepted
            .least
            .zip(accepted.greatest)
            .is_none_or(|(least, greatest)| least <= greatest);
        some.then_some(accepted)
    }

    /// How many drops with this mean and scatter would decide.
    fn deciding_drops(&self, rule: &Rule, now: usize, decision: Decision) -> Remark {
        /// Nobody drops a ball more often for one verdict.
        const MOST: usize = 200;
        let limits = rule.limits();
        let decides = |count: &usize| {
            let within = self
                .limited(rule)
                .map(|value| value.with_drops(now, *count).within(&limits));
            within.is_some_and(|within| within.min(1.0 - within) <= decision.risk())
        };
        (2..=MOST)
            .find(decides)
            .map_or(Remark::NoDropsDecide, Remark::DecidingDrops)
    }
}

/// The answer of the model in place of the value that the rule limits.
fn model(rule: &Rule, drops: &[Rebound], reference: &[Rebound]) -> Option<Spread> {
    let mean = |drops: &[Rebound]| {
        let predicted: Vec<Estimate> = drops
            .iter()
            .map(|drop| drop.predicted_m)
            .collect::<Option<_>>()?;
        (!predicted.is_empty()).then(|| Spread::of_estimates(&predicted))
    };
    let surface = mean(drops)?;
    if rule.needs_reference() {
        Some(surface.over(&mean(reference)?))
    } else {
        Some(surface)
    }
}

impl Verdict {
    /// A remark if procedure and model differ by more than the uncertainties of both: an E number (`E_n`) above 1,
    /// ISO 13528.
    fn model_differs(&self) -> Option<Remark> {
        let (value, model) = (self.value()?, self.model?);
        let half = |estimate: &Estimate| (estimate.interval95[1] - estimate.interval95[0]) / 2.0;
        let by = value.value - model.value;
        (by.abs() > half(&value).hypot(half(&model))).then_some(Remark::ModelDiffers)
    }
}

/// Draws of how unlike the places are. The mean of each is uncertain by the scatter of drops within places, and at least by
/// the errors of their times; what all places share cancels.
fn unevenness(
    even: Evenness,
    drops: &[Rebound],
    reference: Option<&MeanRebound>,
    settings: &Options,
) -> Vec<f64> {
    const DRAWS: usize = 4000;
    /// The seed of the draws.
    const SEED: u64 = 1;
    let last = drops.iter().map(|drop| drop.place).max().unwrap_or(0);
    let places: Vec<Vec<&Rebound>> = (0..=last)
        .map(|place| drops.iter().filter(|drop| drop.place == place).collect())
        .filter(|drops: &Vec<&Rebound>| !drops.is_empty())
        .collect();
    if places.len() < 2 {
        return Vec::new();
    }
    let means_m: Vec<f64> = places.iter().map(|place| mean_of(place)).collect();
    let squares: f64 = places
        .iter()
        .zip(&means_m)
        .flat_map(|(place, mean_m)| {
            place
                .iter()
                .map(move |drop| (drop.height_m.unwrap_or(*mean_m) - mean_m).powi(2))
        })
        .sum();
    let freedom = drops.len() - places.len();
    let scatter_m = if freedom == 0 {
        // One drop a place shows no scatter: that of the restitution is assumed.
        2.0 * settings.priors.restitution_scatter * stats::mean(&means_m)
    } else {
        (squares / freedom as f64).sqrt()
    };
    let sds_m: Vec<f64> = places
        .iter()
        .map(|place| {
            let times_m = place.iter().map(|drop| drop.times_sd_m).fold(0.0, f64::max);
            scatter_m.max(times_m) / (place.len() as f64).sqrt()
        })
        .collect();
    let reference_m = reference.map_or(f64::NAN, |reference| reference.height_m.value);
    let mut chance = ChaCha8Rng::seed_from_u64(SEED);
    let draws = (0..DRAWS).map(|_| {
        let drawn: Vec<f64> = means_m
            .iter()
            .zip(&sds_m)
            .map(|(mean_m, sd_m)| {
                let error: f64 = StandardNormal.sample(&mut chance);
                mean_m + sd_m * error
            })
            .collect();
        match even {
            Evenness::WithinOfMean(_) => farthest_from_mean(&drawn),
            Evenness::Range(_) => range(&drawn) / reference_m,
        }
    });
    draws.filter(|found| found.is_finite()).collect()
}

fn mean_of(drops: &[&Rebound]) -> f64 {
    let heights_m: Vec<f64> = drops.iter().filter_map(|drop| drop.height_m).collect();
    stats::mean(&heights_m)
}

fn farthest_from_mean(places: &[f64]) -> f64 {
    let mean = stats::mean(places);
    places
        .iter()
        .map(|place| (place / mean - 1.0).abs())
        .fold(0.0, f64::max)
}

fn range(places: &[f64]) -> f64 {
    let greatest = places.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    greatest - places.iter().copied().fold(f64::INFINITY, f64::min)
}

fn doubts(rule: &Rule, fall_m: Option<f64>, procedure: &[Check]) -> Vec<InconclusiveReason> {
    let broken = procedure.iter().filter(|check| check.kept == Kept::No);
    let mut doubts: Vec<_> = broken
        .map(|check| InconclusiveReason::NotKept(check.item))
        .collect();
    if rule.limits().is_open() {
        doubts.push(InconclusiveReason::NoLimits);
    }
    if fall_m.is_none() {
        doubts.push(InconclusiveReason::NoHeight);
    }
    doubts
}

/// What keeps single drops from telling.
fn of_drops(rebounds: &[Rebound]) -> Vec<InconclusiveReason> {
    let mut doubts = Vec::new();
    for (rebound, number) in rebounds.iter().zip(1..) {
        if rebound.height_m.is_none() {
            doubts.push(InconclusiveReason::NoFirstFlight(number));
        }
        let doubtful = rebound.doubts.iter().cloned();
        doubts.extend(doubtful.map(InconclusiveReason::Doubtful));
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
