//! A verdict as data: the schema `bouncelab.verdict/3`.

use bouncelab::rulebook::{
    self, Decision, InconclusiveReason, Limits, Outcome, Remark, Requirement, Rule,
};
use bouncelab::settings::Setup;
use bouncelab::{Diagnostic, Estimate};
use serde::Serialize;

use super::SettingsUsed;
use crate::messages::Translator;

/// Name and version of the schema.
pub const SCHEMA: &str = "bouncelab.verdict/3";

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
    accepted: Option<Ends>,
    /// Means over the drops, by simpler formulas.
    drag_free_m: Option<f64>,
    formula_m: Option<f64>,
    drops: Vec<Drop>,
    reference_drops: Vec<Drop>,
    reasons: Vec<Diagnostic>,
    remarks: Vec<Diagnostic>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
struct RuleUsed {
    name: String,
    title: String,
    source: String,
    edition: Option<String>,
    status: String,
    surface: Option<String>,
    reference: Option<String>,
    drop_height_m: Option<f64>,
    measured_at: Option<String>,
    rebound_m: Option<Ends>,
    about_m: Option<f64>,
    share_of_reference: Option<Ends>,
    fewest_drops: usize,
}

#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
struct Ends {
    least: Option<f64>,
    greatest: Option<f64>,
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
    predicted_m: Option<Estimate>,
    first_flight_s: Option<f64>,
    drag_free_m: Option<f64>,
    formula_m: Option<f64>,
    steps: Vec<Step>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
struct Step {
    why: String,
    height_m: f64,
}

/// A verdict and all that it rests on.
#[derive(Clone, Copy, Debug)]
pub struct Evaluation<'a> {
    /// The rule that was applied.
    pub rule: &'a Rule,
    /// The settings, given or assumed.
    pub setup: &'a Setup,
    /// How it was decided.
    pub decision: Decision,
    /// The result.
    pub verdict: &'a rulebook::Verdict,
    /// Names of the places, in order.
    pub files: &'a [String],
    /// Names of the places on the reference surface, in order.
    pub reference_files: &'a [String],
}

impl VerdictDocument {
    /// The document of a verdict, with the sentences of its diagnostics.
    pub fn new(evaluation: &Evaluation<'_>, translator: &Translator) -> Self {
        let Evaluation {
            rule,
            setup,
            decision,
            verdict,
            files,
            reference_files,
        } = *evaluation;
        let mut document = Self {
            schema: SCHEMA,
            bouncelab: env!("CARGO_PKG_VERSION"),
            rule: RuleUsed::from(rule),
            settings: SettingsUsed::new(&setup.options, &setup.assumptions),
            decision: DecisionUsed {
                rule: match decision {
                    Decision::Guarded { .. } => "guarded",
                    Decision::Simple => "simple",
                },
                risk: decision.risk(),
            },
            outcome: match verdict.outcome {
                Outcome::Pass => "pass",
                Outcome::Fail => "fail",
                Outcome::CannotDecide => "cannot-decide",
            },
            probability_within: verdict.within,
            probability_wrong_accept: verdict.wrong_accept(),
            rebound_m: verdict.rebound,
            reference_rebound_m: verdict.reference,
            share_of_reference: verdict.share,
            unevenness: verdict.unevenness,
            accepted: verdict.accepted.map(Ends::from),
            drag_free_m: verdict.drag_free_m(),
            formula_m: verdict.formula_m(),
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
    rebounds
        .iter()
        .map(|rebound| Drop {
            recording: files.get(rebound.place).cloned().unwrap_or_default(),
            predicted_m: rebound.predicted_m,
            first_flight_s: rebound.first_flight_s,
            drag_free_m: rebound.drag_free_m,
            formula_m: rebound.formula_m,
            steps: rebound
                .steps
                .iter()
                .map(|step| Step {
                    why: step.why.to_string(),
                    height_m: step.height_m,
                })
                .collect(),
        })
        .collect()
}

impl From<Limits> for Ends {
    fn from(limits: Limits) -> Self {
        Self {
            least: limits.least,
            greatest: limits.greatest,
        }
    }
}

impl From<&Rule> for RuleUsed {
    fn from(rule: &Rule) -> Self {
        let (mut rebound_m, mut about_m, mut share, mut reference) = (None, None, None, None);
        match &rule.requirement {
            Requirement::Height(limits) => rebound_m = Some(Ends::from(*limits)),
            Requirement::About(height_m) => about_m = Some(*height_m),
            Requirement::Share { limits, of } => {
                share = Some(Ends::from(*limits));
                reference = Some(of.clone());
            }
        }
        Self {
            name: rule.name.clone(),
            title: rule.title.clone(),
            source: rule.source.clone(),
            edition: rule.edition.clone(),
            status: rule.status.to_string(),
            surface: rule.surface.clone(),
            reference,
            drop_height_m: rule.drop_height_m,
            measured_at: rule.measured_at.map(|point| point.to_string()),
            rebound_m,
            about_m,
            share_of_reference: share,
            fewest_drops: rule.fewest_drops,
        }
    }
}
