//! The verdict as text.

use std::fmt::Write;

use bouncelab::rulebook::{Decision, Limits, Outcome, Rule, Verdict};
use bouncelab_report::messages::Value;
use bouncelab_report::report::ended;
use bouncelab_report::{Quantity, Table, Unit};

use super::{Told, tables};
use crate::analyze::{assumed, note};
use crate::language::{text, text_with, translator};
use crate::rules;

/// The verdict, the rebound in several ways and why they differ, and what to know.
pub(super) fn report(told: &Told<'_>) -> String {
    let Told {
        rule,
        verdict,
        decision,
        files,
        reference_files,
        physics,
    } = *told;
    let mut page = String::new();
    for line in of_rule(rule) {
        add(&mut page, &line);
    }
    add(&mut page, "");
    for line in decided(verdict, decision) {
        add(&mut page, &line);
    }
    for because in because(verdict) {
        add(&mut page, &format!("  {because}"));
    }
    add(&mut page, "");
    add(&mut page, &indented(&tables::ways(verdict)));
    if let Some(steps) = tables::differences(verdict) {
        add(&mut page, "");
        add(&mut page, &format!("  {}:", text("verdict-steps")));
        add(&mut page, &indented(&steps));
    }
    add(&mut page, "");
    add(&mut page, &indented(&tables::drops(&verdict.drops, files)));
    if !verdict.reference_drops.is_empty() {
        let drops = tables::drops(&verdict.reference_drops, reference_files);
        add(&mut page, "");
        add(&mut page, &format!("  {}", text("verdict-on-reference")));
        add(&mut page, &indented(&drops));
    }
    add(&mut page, "");
    let remarks = verdict.remarks.iter();
    let remarks = remarks.map(|remark| translator().diagnostic(&remark.diagnostic()));
    for remark in remarks.chain(rule.note.clone()) {
        add(&mut page, &note(remark));
    }
    if !physics.assumptions.is_empty() {
        add(&mut page, &assumed(&physics.assumptions));
    }
    page
}

/// Why nothing can be decided.
pub(super) fn because(verdict: &Verdict) -> impl Iterator<Item = String> {
    verdict.doubts.iter().map(|doubt| {
        let reason = ended(translator().diagnostic(&doubt.diagnostic()));
        text_with("verdict-because", &[("reason", reason.into())])
    })
}

fn add(text: &mut String, line: &str) {
    // Writing to a String cannot fail.
    let _ = writeln!(text, "{}", line.trim_end());
}

fn indented(table: &Table) -> String {
    let rows: Vec<String> = table
        .to_string()
        .lines()
        .map(|row| format!("  {row}"))
        .collect();
    rows.join("\n")
}

fn of_rule(rule: &Rule) -> Vec<String> {
    let edition = rule
        .edition
        .as_ref()
        .map_or_else(String::new, |edition| format!(", {edition}"));
    let surface = rule.surface.as_deref().unwrap_or("none");
    let wants = [
        ("drop", rules::drop(rule).into()),
        ("surface", surface.into()),
        ("wanted", rules::wanted(rule).into()),
        ("point", rules::point(rule.point()).into()),
    ];
    let status = rules::status(rule.status);
    vec![
        format!(
            "{}: {} ({}{edition}; {status})",
            rule.name, rule.title, rule.source
        ),
        format!("  {}", text_with("verdict-rule-line", &wants)),
    ]
}

fn decided(verdict: &Verdict, decision: Decision) -> Vec<String> {
    let mut lines = vec![outcome(verdict)];
    let decision_rule = by_rule(verdict, decision).into_iter();
    lines.extend(decision_rule.map(|sentence| format!("  {sentence}")));
    lines
}

/// The decision in a few words.
pub(super) fn outcome_name(outcome: Outcome) -> String {
    text(match outcome {
        Outcome::Pass => "verdict-pass",
        Outcome::Fail => "verdict-fail",
        Outcome::CannotDecide => "verdict-cannot-decide",
    })
}

/// The decision, and how sure it is.
pub(super) fn outcome(verdict: &Verdict) -> String {
    let outcome = outcome_name(verdict.outcome).to_uppercase();
    match verdict.within {
        Some(within) => text_with(
            "verdict-sure",
            &[
                ("outcome", outcome.into()),
                ("within", percent(within).into()),
                ("outside", percent(1.0 - within).into()),
            ],
        ),
        None => format!("{outcome}."),
    }
}

/// The decision rule, and what it accepts.
pub(super) fn by_rule(verdict: &Verdict, decision: Decision) -> Vec<String> {
    let mut lines = vec![match decision {
        Decision::Guarded { risk } => {
            text_with("verdict-guarded", &[("risk", percent(risk).into())])
        }
        Decision::Simple => text("verdict-simple"),
    }];
    if let (Some(accepted), Decision::Guarded { .. }) = (&verdict.accepted, decision) {
        let unit = if verdict.share.is_some() {
            Unit::Percent
        } else {
            Unit::Length
        };
        let accepted = [("accepted", ends(accepted, unit).into())];
        lines.push(text_with("verdict-accepted", &accepted));
    }
    lines
}

/// A probability, without a claim to be certain.
fn percent(share: f64) -> String {
    const CERTAIN: f64 = 0.9995;
    let percent = |share: f64| format!("{} %", translator().fixed(share * 100.0, 1));
    if share > CERTAIN {
        text_with("verdict-more-than", &[("share", percent(0.999).into())])
    } else if share < 1.0 - CERTAIN {
        text_with("verdict-less-than", &[("share", percent(0.001).into())])
    } else {
        percent(share)
    }
}

fn ends(limits: &Limits, unit: Unit) -> String {
    let shown = |end: f64| Value::from(Quantity::rounded(end, 4, unit));
    match (limits.least, limits.greatest) {
        (Some(least), Some(greatest)) => text_with(
            "interval-ends",
            &[("low", shown(least)), ("high", shown(greatest))],
        ),
        (Some(least), None) => text_with("verdict-from", &[("least", shown(least))]),
        (None, Some(greatest)) => text_with("verdict-up-to", &[("greatest", shown(greatest))]),
        (None, None) => text("verdict-anything"),
    }
}
