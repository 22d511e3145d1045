//! A verdict as data: the schema `bouncelab.verdict/4`.

use bouncelab::rulebook::{
    self, Decision, Formula, InconclusiveReason, Limits, MeanRebound, Point, Precision, Remark,
    Requirement, Rule, Source,
};
use bouncelab::settings::Setup;
use bouncelab::{Diagnostic, Estimate};
use serde::Serialize;

use super::SettingsUsed;
use crate::messages::Translator;

/// Name and version of the schema.
pub const SCHEMA: &str = "bouncelab.verdict/4";

/// The conformity of drops with a rule.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct VerdictDocument {
    schema: &'static str,
    /// Version of the program that made it.
    bouncelab: &'static str,
    rule: RuleUsed,
    settings: SettingsUsed,
    decision: DecisionUsed,
    outcome: &'static str,
    /// That everything is within the limits.
    probability_within: Option<f64>,
    /// That a pass is wrong.
    probability_wrong_accept: Option<f64>,
    rebound_m: Option<Estimate>,
    reference_rebound_m: Option<Estimate>,
    share_of_reference: Option<Estimate>,
    unevenness: Option<Estimate>,
    /// How drops repeat, within a place and over places.
    precision: Option<Precision>,
    /// What the model answers, m or a share.
    model: Option<Estimate>,
    accepted: Option<Limits>,
    /// Mean over the drops of g T²/8.
    drag_free_m: Option<f64>,
    /// The sources of the uncertainty of `rebound_m` and of `reference_rebound_m`.
    budget: Vec<Component>,
    reference_budget: Vec<Component>,
    procedure: Vec<Check>,
    drops: Vec<Drop>,
    reference_drops: Vec<Drop>,
    reasons: Vec<Diagnostic>,
    remarks: Vec<Diagnostic>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
struct RuleUsed {
    name: String,
    title: String,
    source: Source,
    surface: Option<String>,
    reference: Option<String>,
    drop_height_m: Option<f64>,
    measured_at: Option<Point>,
    rebound_m: Option<Limits>,
    about_m: Option<f64>,
    share_of_reference: Option<Limits>,
    fewest_drops: usize,
    fewest_places: usize,
    conditioning: Option<String>,
    formula: Option<Formula>,
    rounding: Option<f64>,
}

/// A source of uncertainty; `degrees_of_freedom` is `null` where there is no end of them.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
struct Component {
    cause: &'static str,
    correction_m: f64,
    sd_m: f64,
    degrees_of_freedom: Option<f64>,
}

/// A part of the procedure; `found` is in SI units.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
struct Check {
    item: &'static str,
    state: &'static str,
    found: Option<f64>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
struct DecisionUsed {
    rule: &'static str,
    risk: f64,
}

/// One drop; heights are of the point at which the rule measures.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct Drop {
    recording: String,
    first_flight_s: Option<f64>,
    height_m: Option<f64>,
    times_sd_m: f64,
    drag_free_m: Option<f64>,
    predicted_m: Option<Estimate>,
}

/// Rebounds on the same surface, by place.
#[derive(Clone, Debug, Default)]
pub struct Surface {
    names: Vec<String>,
    places: Vec<Vec<rulebook::Rebound>>,
}

impl Surface {
    /// Adds a place.
    pub fn push(&mut self, name: String, rebounds: Vec<rulebook::Rebound>) {
        self.names.push(name);
        self.places.push(rebounds);
    }
}

/// A verdict and all that it rests on.
#[derive(Clone, Debug)]
pub struct Evaluation {
    /// The rule that was applied.
    pub rule: Rule,
    /// The settings, given or assumed.
    pub setup: Setup,
    /// How it was decided.
    pub decision: Decision,
    /// The result.
    pub verdict: rulebook::Verdict,
    /// Names of the places, in order.
    pub files: Vec<String>,
    /// Names of the places on the reference surface, in order.
    pub reference_files: Vec<String>,
}

impl Evaluation {
    /// Judges the rebounds on a surface and, for a rule that compares, on the reference.
    ///
    /// # Errors
    /// As [`rulebook::judge_rebounds`].
    pub fn new(
        rule: &Rule,
        setup: &Setup,
        surface: Surface,
        reference: Surface,
        decision: Decision,
    ) -> bouncelab::Result<Self> {
        let verdict = rulebook::judge_rebounds(
            rule,
            &setup.options,
            &setup.conditions,
            surface.places,
            reference.places,
            decision,
        )?;
        Ok(Self {
            rule: rule.clone(),
            setup: setup.clone(),
            decision,
            verdict,
            files: surface.names,
            reference_files: reference.names,
        })
    }
}

impl VerdictDocument {
    /// The document of a verdict, with the sentences of its diagnostics.
    pub fn new(evaluation: &Evaluation, translator: &Translator) -> Self {
        let Evaluation {
            rule,
            setup,
            decision,
            verdict,
            files,
            reference_files,
        } = evaluation;
        let mut document = Self {
            schema: SCHEMA,
            bouncelab: env!("CARGO_PKG_VERSION"),
            rule: RuleUsed::from(rule),
            settings: SettingsUsed::new(&setup.options, &setup.assumptions),
            decision: DecisionUsed {
                rule: match *decision {
                    Decision::Guarded { .. } => "guarded",
                    Decision::Simple => "simple",
                },
                risk: decision.risk(),
            },
            outcome: verdict.outcome.name(),
            probability_within: verdict.within,
            probability_wrong_accept: verdict.wrong_accept(),
            rebound_m: verdict.rebound.as_ref().map(|mean| mean.height_m),
            reference_rebound_m: verdict.reference.as_ref().map(|mean| mean.height_m),
            share_of_reference: verdict.share,
            unevenness: verdict.unevenness,
            precision: verdict.precision(),
            accepted: verdict.accepted,
            drag_free_m: verdict.drag_free_m(),
            model: verdict.model,
            budget: budget(verdict.rebound.as_ref()),
            reference_budget: budget(verdict.reference.as_ref()),
            procedure: verdict.procedure.iter().map(Check::from).collect(),
            drops: drops(&verdict.drops, files),
            reference_drops: drops(&verdict.reference_drops, reference_files),
            reasons: verdict
                .doubts
                .iter()
                .map(InconclusiveReason::diagnostic)
                .collect(),
            remarks: verdict.remarks.iter().map(Remark::diagnostic).collect(),
        };
        translator.complete_each(&mut document.settings.assumptions);
        translator.complete_each(&mut document.reasons);
        translator.complete_each(&mut document.remarks);
        document
    }
}

fn drops(rebounds: &[rulebook::Rebound], files: &[String]) -> Vec<Drop> {
    let drops = rebounds.iter().map(|rebound| Drop {
        recording: files.get(rebound.place).cloned().unwrap_or_default(),
        first_flight_s: rebound.first_flight_s,
        height_m: rebound.height_m,
        times_sd_m: rebound.times_sd_m,
        drag_free_m: rebound.drag_free_m,
        predicted_m: rebound.predicted_m,
    });
    drops.collect()
}

fn budget(mean: Option<&MeanRebound>) -> Vec<Component> {
    let budget = mean.into_iter().flat_map(|mean| &mean.budget);
    let components = budget.map(|part| Component {
        cause: part.cause.name(),
        correction_m: part.correction_m,
        sd_m: part.sd_m,
        degrees_of_freedom: Some(part.degrees_of_freedom).filter(|degrees| degrees.is_finite()),
    });
    components.collect()
}

impl From<&rulebook::Check> for Check {
    fn from(check: &rulebook::Check) -> Self {
        Self {
            item: check.item.name(),
            state: check.kept.name(),
            found: check.found,
        }
    }
}

impl From<&Rule> for RuleUsed {
    fn from(rule: &Rule) -> Self {
        let (mut rebound_m, mut about_m, mut share, mut reference) = (None, None, None, None);
        match &rule.requirement {
            Requirement::Height(limits) => rebound_m = Some(*limits),
            Requirement::About(height_m) => about_m = Some(*height_m),
            Requirement::Share { limits, of } => {
                share = Some(*limits);
                reference = Some(of.clone());
            }
        }
        Self {
            name: rule.name.clone(),
            title: rule.title.clone(),
            source: rule.source.clone(),
            surface: rule.surface.clone(),
            reference,
            drop_height_m: rule.drop_height_m,
            measured_at: rule.measured_at,
            rebound_m,
            about_m,
            share_of_reference: share,
            fewest_drops: rule.fewest_drops,
            fewest_places: rule.places(),
            conditioning: rule.conditioning.clone(),
            formula: rule.formula,
            rounding: rule.rounding,
        }
    }
}
