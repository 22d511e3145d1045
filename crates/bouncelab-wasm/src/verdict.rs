//! Verdicts by the rules that are built in, as `bouncelab verdict` gives them.

use bouncelab::analysis::{Drop, Plan};
use bouncelab::rulebook::{self, Decision, Item, Place, Rule, Verdict};
use bouncelab::settings::Setup;
use bouncelab_report::document::verdict::Evaluation;
use bouncelab_report::messages::{Translator, capital};
use bouncelab_report::report::verdict::of_verdict;
use bouncelab_report::report::{Page, Provenance};
use bouncelab_report::rules::{self, words};

use crate::analyst::Analyst;
use crate::refusal::{Refusal, Result};
use crate::wire::{DropMarks, Judged, JudgedPlace, RuleChoice, StatedPart, VerdictRequest};

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
    let test = Test::new(analyst, request)?;
    let Page { lead, sections, .. } = test.page(request, translator);
    Ok(Judged {
        lead,
        sections,
        stated: test.stated(translator),
    })
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
    Ok(Test::new(analyst, request)?
        .page(request, translator)
        .html())
}

/// A verdict and all that it rests on.
struct Test {
    rule: Rule,
    setup: Setup,
    verdict: Verdict,
}

impl Test {
    fn new(analyst: &mut Analyst, request: &VerdictRequest) -> Result<Self> {
        let rule = request.rule.clone();
        let no_ball = || Refusal::fault(format!("the rule {} names no known ball", rule.name));
        let (settings, is_its_ball) = request.settings.with_ball_of(&rule).ok_or_else(no_ball)?;
        let mut setup = settings.resolve()?;
        setup.assume(&rule, is_its_ball);
        let kept = request.kept.iter().map(|name| Item::stated(name));
        setup.conditions.kept = kept.collect::<bouncelab::Result<_>>()?;
        let mut analysed = |places: &[JudgedPlace]| -> Vec<Vec<Drop>> {
            let places = places.iter();
            places
                .map(|place| {
                    let candidates = place.drops.iter().map(DropMarks::candidate).collect();
                    let plan =
                        Plan::of_candidates(place.source.clone(), candidates, &setup.options);
                    plan.tasks().iter().map(|task| analyst.drop(task)).collect()
                })
                .collect()
        };
        let (surface, reference) = (analysed(&request.surface), analysed(&request.reference));
        let verdict = rulebook::judge(
            &rule,
            &setup.options,
            &setup.conditions,
            &places(&surface),
            &places(&reference),
            Decision::default(),
        )?;
        Ok(Self {
            rule,
            setup,
            verdict,
        })
    }

    fn page(&self, request: &VerdictRequest, translator: &Translator) -> Page {
        let names = |places: &[JudgedPlace]| -> Vec<String> {
            places.iter().map(|place| place.name.clone()).collect()
        };
        let (files, reference_files) = (names(&request.surface), names(&request.reference));
        let evaluation = Evaluation {
            rule: &self.rule,
            setup: &self.setup,
            decision: Decision::default(),
            verdict: &self.verdict,
            files: &files,
            reference_files: &reference_files,
        };
        let provenance = Provenance {
            made: request.made.clone(),
            ..Provenance::default()
        };
        of_verdict(&evaluation, &provenance, None, translator)
    }

    /// The parts of the procedure that only a person can state.
    fn stated(&self, translator: &Translator) -> Vec<StatedPart> {
        let checks = self.verdict.procedure.iter();
        checks
            .filter(|check| Item::STATED.contains(&check.item))
            .map(|check| StatedPart {
                name: check.item.name(),
                label: format!(
                    "{} {}",
                    translator.with_colon(&capital(
                        &translator.text(&format!("verdict-item-{}", check.item.name()))
                    )),
                    words::asked(&self.rule, check.item, translator)
                ),
            })
            .collect()
    }
}

fn places(analysed: &[Vec<Drop>]) -> Vec<Place<'_>> {
    analysed
        .iter()
        .map(|drops| drops.iter().collect())
        .collect()
}
