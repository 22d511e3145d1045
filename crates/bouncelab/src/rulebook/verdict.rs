//! Conforms, does not conform, or cannot decide.

use std::fmt;

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
    /// Least probability that everything is within the limits, if there are limits and every drop has a height. Where a
    /// rule limits more than one value, as each drop or the differences of places, what may go wrong adds up.
    pub within: Option<f64>,
    /// The rebound by the procedure of the rule, mean over the drops.
    pub rebound: Option<MeanRebound>,
    /// The rebound on the reference.
    pub reference: Option<MeanRebound>,
    /// The one over the other.
    pub share: Option<Estimate>,
    /// How unlike the places are, in the way of the rule: the largest difference found.
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
        let mut levels = vec![Vec::new(); places(&self.drops)];
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
    let chances = found.chances(rule, &drops, None);
    let conforms = chances.as_ref().and_then(|all| all.decided(decision));
    let outcome = outcome(conforms, &doubts, &procedure);
    let mut remarks = inconclusive::of_rule(rule);
    remarks.extend(other_ball(rule, &settings.ball));
    if outcome == Outcome::CannotDecide && doubts.is_empty() {
        doubts.push(InconclusiveReason::TooUncertain);
        remarks.push(found.deciding_drops(rule, &drops, decision));
    }
    if (1..3).contains(&drops.len()) {
        remarks.push(Remark::FewDrops(drops.len()));
    }
    let model = model(rule, &drops, &reference_drops).map(|spread| spread.estimate());
    let share = found.share.map(|share| share.estimate());
    let mut verdict = Verdict {
        outcome,
        within: chances.map(|chances| chances.all()),
        share,
        unevenness: found.unevenness(),
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

fn outcome(conforms: Option<bool>, doubts: &[InconclusiveReason], procedure: &[Check]) -> Outcome {
    let shown = procedure.iter().all(|check| check.kept == Kept::Yes);
    match conforms {
        _ if !doubts.is_empty() => Outcome::CannotDecide,
        Some(true) if shown => Outcome::Conforms,
        Some(true) => Outcome::ConformsAsFarAsShown,
        Some(false) => Outcome::DoesNotConform,
        None => Outcome::CannotDecide,
    }
}

/// The probabilities of being within, of all that a rule limits: of the mean or of each drop, and of the differences of
/// places.
struct Chances([Vec<f64>; 2]);

impl Chances {
    /// Least probability that all is within: whatever may go wrong cannot do more than add up.
    fn all(&self) -> f64 {
        let outside: f64 = self.0.iter().flatten().map(|within| 1.0 - within).sum();
        (1.0 - outside).max(0.0)
    }

    /// Whether all is within, if the decision rule allows to say so.
    fn decided(&self, decision: Decision) -> Option<bool> {
        let risk = match decision {
            Decision::Guarded { risk } => risk,
            Decision::Simple => return Some(self.0.iter().flatten().all(|&within| within >= 0.5)),
        };
        if 1.0 - self.all() <= risk {
            return Some(true);
        }
        // Of many that are within, one may seem to be outside by chance: each has its part of the risk (Bonferroni).
        let groups = self.0.iter().filter(|group| !group.is_empty());
        let count = groups.clone().count() as f64;
        let outside = |group: &Vec<f64>| {
            let least = group.iter().copied().fold(1.0, f64::min);
            least * group.len() as f64 * count <= risk
        };
        groups.clone().any(outside).then_some(false)
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
    /// The differences of places that the rule limits; empty if it does not.
    differences: Vec<Spread>,
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
        let differences = rule.evenness.map_or_else(Vec::new, |even| {
            differences(even, drops, reference.as_ref(), settings)
        });
        Self {
            rebound,
            reference,
            share,
            differences,
        }
    }

    /// The largest difference of places, which is not below 0.
    fn unevenness(&self) -> Option<Estimate> {
        let size = |spread: &Spread| spread.value.abs();
        let all = self.differences.iter();
        let largest = all.max_by(|one, other| size(one).total_cmp(&size(other)))?;
        let found = Spread {
            value: size(largest),
            ..*largest
        };
        let not_below = |interval: [f64; 2]| interval.map(|end| end.max(0.0));
        let found = found.estimate();
        Some(Estimate {
            interval68: not_below(found.interval68),
            interval95: not_below(found.interval95),
            ..found
        })
    }

    /// The value that the rule limits.
    fn limited(&self, rule: &Rule) -> Option<Spread> {
        if rule.needs_reference() {
            self.share
        } else {
            Some(self.rebound.as_ref()?.spread)
        }
    }

    /// The probabilities that all that the rule limits is within, by these drops or by so many with the same mean and
    /// scatter; `None` without a value or limits.
    fn chances(&self, rule: &Rule, drops: &[Rebound], count: Option<usize>) -> Option<Chances> {
        let limits = rule.limits();
        let value = self.limited(rule)?;
        if limits.is_open() || (rule.evenness.is_some() && self.differences.is_empty()) {
            return None;
        }
        let scaled = |spread: Spread, levels: usize| {
            count.map_or(spread, |count| {
                spread.with_drops(drops.len(), count, levels)
            })
        };
        let values = if rule.averaging == Averaging::Each {
            let each = drops.iter();
            each.filter_map(|drop| Some(value.of_drop(drop.height_m?, drop.times_sd_m)))
                .map(|drop| drop.within(&limits))
                .collect()
        } else {
            vec![scaled(value, 1).within(&limits)]
        };
        let most = rule.evenness.map_or(0.0, Evenness::most);
        let alike = Limits::between(-most, most);
        let differences = self.differences.iter();
        let differences = differences.map(|&spread| scaled(spread, places(drops)).within(&alike));
        Some(Chances([values, differences.collect()]))
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

    /// How many drops with this mean and scatter would decide, the same number in each place.
    fn deciding_drops(&self, rule: &Rule, drops: &[Rebound], decision: Decision) -> Remark {
        /// Nobody drops a ball more often for one verdict.
        const MOST: usize = 200;
        let places = if rule.compares_places() {
            places(drops)
        } else {
            1
        };
        let decides = |count: &usize| {
            let chances = self.chances(rule, drops, Some(*count));
            chances.is_some_and(|chances| chances.decided(decision).is_some())
        };
        (2 * places..=MOST)
            .step_by(places)
            .find(decides)
            .map_or(Remark::NoDropsDecide, Remark::DecidingDrops)
    }
}

/// The answer of the model in place of the value that the rule limits.
fn model(rule: &Rule, drops: &[Rebound], reference: &[Rebound]) -> Option<Spread> {
    // A drop whose inference has no answer is left out.
    let mean = |drops: &[Rebound]| {
        let predicted: Vec<Estimate> = drops.iter().filter_map(|drop| drop.predicted_m).collect();
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

/// How many places there are.
fn places(drops: &[Rebound]) -> usize {
    drops.iter().map(|drop| drop.place + 1).max().unwrap_or(0)
}

/// The differences of places that a rule limits. The mean of each place is uncertain by the scatter of drops within places, and
/// at least by the errors of their times; what all places share cancels.
fn differences(
    even: Evenness,
    drops: &[Rebound],
    reference: Option<&MeanRebound>,
    settings: &Options,
) -> Vec<Spread> {
    let mut heights_m = vec![Vec::new(); places(drops)];
    let mut times_m = vec![0.0_f64; places(drops)];
    for drop in drops {
        heights_m[drop.place].extend(drop.height_m);
        times_m[drop.place] = times_m[drop.place].max(drop.times_sd_m);
    }
    if heights_m.len() < 2 || heights_m.iter().any(Vec::is_empty) {
        return Vec::new();
    }
    let means_m: Vec<f64> = heights_m.iter().map(|place| stats::mean(place)).collect();
    let mean_m = stats::mean(&means_m);
    let of_places = heights_m.iter();
    let squares: f64 = of_places
        .map(|place| place.len() as f64 * stats::sd(place).powi(2))
        .sum();
    let freedom = drops.len() as f64 - means_m.len() as f64;
    let (scatter, degrees) = if freedom > 0.0 {
        (squares / freedom, freedom)
    } else {
        // One drop a place shows no scatter: that of the restitution is assumed.
        let assumed_m = 2.0 * settings.priors.restitution_scatter * mean_m;
        (assumed_m.powi(2), f64::INFINITY)
    };
    let of_places = heights_m.iter().zip(&times_m);
    let variances: Vec<f64> = of_places
        .map(|(place, times_m)| scatter.max(times_m.powi(2)) / place.len() as f64)
        .collect();
    let spread = |value, shared, scatter| Spread {
        value,
        shared,
        scatter,
        degrees,
    };
    let count = means_m.len() as f64;
    let every = 0..means_m.len();
    match even {
        Evenness::WithinOfMean(_) => {
            // Of m_i - m, of which m contains m_i: (1 - 1/k)² v_i and v_j/k² of the others.
            let all: f64 = variances.iter().sum();
            every
                .map(|one| {
                    let own = variances[one];
                    let scatter = (1.0 - 2.0 / count) * own + all / count.powi(2);
                    spread(means_m[one] / mean_m - 1.0, 0.0, scatter / mean_m.powi(2))
                })
                .collect()
        }
        Evenness::Range(_) => {
            let Some(reference) = reference.map(|reference| reference.height_m) else {
                return Vec::new();
            };
            let pairs = every.flat_map(|one| (0..one).map(move |other| (one, other)));
            pairs
                .map(|(one, other)| {
                    let apart = (means_m[one] - means_m[other]) / reference.value;
                    let shared = (apart * reference.sd / reference.value).powi(2);
                    let scatter = (variances[one] + variances[other]) / reference.value.powi(2);
                    spread(apart, shared, scatter)
                })
                .collect()
        }
    }
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
