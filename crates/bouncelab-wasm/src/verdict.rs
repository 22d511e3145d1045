//! Verdicts by the rules that are built in, as `bouncelab verdict` gives them.

use bouncelab::analysis::Plan;
use bouncelab::rulebook::{Decision, Item, Rebound, Rule};
use bouncelab::settings::{Settings, Setup};
use bouncelab_report::document::verdict::{Evaluation, Surface};
use bouncelab_report::messages::{Translator, capital};
use bouncelab_report::report::verdict::of_verdict;
use bouncelab_report::report::{Page, Provenance};
use bouncelab_report::rules::{self, words};

use crate::analyst::Analyst;
use crate::refusal::{Refusal, Result};
use crate::wire::{
    DropMarks, Judged, JudgedPlace, ReboundRequest, RuleChoice, StatedPart, VerdictRequest,
};

/// The rules by title.
///
/// # Errors
///
/// None: the tests read the built-in rules.
pub fn choices(translator: &Translator) -> Result<Vec<RuleChoice>> {
    let rules = rules::built_in()?;
    let choice = |rule: &Rule| RuleChoice {
        rule: rule.clone(),
        name: rule.name.clone(),
        title: words::title(rule, translator),
        has_ball: rule.ball.is_some(),
        needs_reference: rule.needs_reference(),
    };
    let mut choices: Vec<RuleChoice> = rules.iter().map(choice).collect();
    choices.sort_by(|a, b| a.title.cmp(&b.title));
    Ok(choices)
}

/// Judges drops by a rule.
///
/// # Errors
///
/// If neither the rule nor the settings have a ball, or a setting is out of range.
pub fn judge(
    analyst: &mut Analyst,
    request: &VerdictRequest,
    translator: &Translator,
) -> Result<Judged> {
    let evaluation = evaluation(analyst, request)?;
    Ok(judged(&evaluation, translator))
}

/// The report of a verdict as one HTML file.
///
/// # Errors
///
/// As those of [`judge`].
pub fn report(
    analyst: &mut Analyst,
    request: &VerdictRequest,
    translator: &Translator,
) -> Result<String> {
    let evaluation = evaluation(analyst, request)?;
    let provenance = Provenance {
        made: request.made.clone(),
        ..Provenance::default()
    };
    Ok(of_verdict(&evaluation, &provenance, None, translator).html())
}

/// The rebounds of the drops of a recording.
///
/// # Errors
///
/// As those of [`judge`].
pub fn rebounds(analyst: &mut Analyst, request: &ReboundRequest) -> Result<Vec<Rebound>> {
    let setup = setup(&request.rule, &request.settings)?;
    Ok(in_place(analyst, &request.place, &request.rule, &setup))
}

/// The settings of drops that a rule judges, with what it says of them.
///
/// # Errors
///
/// As those of [`judge`].
pub fn setup(rule: &Rule, settings: &Settings) -> Result<Setup> {
    let no_ball = || Refusal::fault(format!("the rule {} names no known ball", rule.name));
    let (settings, is_its_ball) = settings.with_ball_of(rule).ok_or_else(no_ball)?;
    let mut setup = settings.resolve()?;
    setup.assume(rule, is_its_ball);
    Ok(setup)
}

/// A verdict as the page shows it.
pub(crate) fn judged(evaluation: &Evaluation, translator: &Translator) -> Judged {
    let provenance = Provenance::default();
    let Page { lead, sections, .. } = of_verdict(evaluation, &provenance, None, translator);
    Judged {
        lead,
        sections,
        stated: stated(evaluation, translator),
    }
}

fn in_place(
    analyst: &mut Analyst,
    place: &JudgedPlace,
    rule: &Rule,
    setup: &Setup,
) -> Vec<Rebound> {
    let candidates = place.drops.iter().map(DropMarks::candidate).collect();
    let plan = Plan::of_candidates(place.source.clone(), candidates, &setup.options);
    let drops = plan.tasks().iter().map(|task| analyst.drop(task));
    drops
        .map(|drop| Rebound::new(&drop, rule, &setup.options))
        .collect()
}

fn evaluation(analyst: &mut Analyst, request: &VerdictRequest) -> Result<Evaluation> {
    let rule = &request.rule;
    let mut setup = setup(rule, &request.settings)?;
    let kept = request.kept.iter().map(|name| Item::stated(name));
    setup.conditions.kept = kept.collect::<bouncelab::Result<_>>()?;
    let mut surface = |places: &[JudgedPlace]| {
        let mut surface = Surface::default();
        for place in places {
            surface.push(place.name.clone(), in_place(analyst, place, rule, &setup));
        }
        surface
    };
    let (here, there) = (surface(&request.surface), surface(&request.reference));
    let decision = Decision::default();
    Ok(Evaluation::new(rule, &setup, here, there, decision)?)
}

/// The parts of the procedure that only a person can state.
fn stated(evaluation: &Evaluation, translator: &Translator) -> Vec<StatedPart> {
    let checks = evaluation.verdict.procedure.iter();
    checks
        .filter(|check| Item::STATED.contains(&check.item))
        .map(|check| StatedPart {
            name: check.item.name(),
            label: format!(
                "{} {}",
                translator.with_colon(&capital(
                    &translator.text(&format!("verdict-item-{}", check.item.name()))
                )),
                words::asked(&evaluation.rule, check.item, translator)
            ),
        })
        .collect()
}
