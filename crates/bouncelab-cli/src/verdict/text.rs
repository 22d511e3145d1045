//! The verdict for people.

use std::fmt::Write;

use bouncelab::rulebook::{Decision, Limits, Outcome, Rule, Verdict};
use bouncelab_report::report::ended;
use bouncelab_report::{Quantity, Table, Unit};

use super::{Told, tables};
use crate::analyze::assumed;
use crate::language::translator;
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
    let mut text = String::new();
    for line in of_rule(rule) {
        add(&mut text, &line);
    }
    add(&mut text, "");
    for line in decided(verdict, decision) {
        add(&mut text, &line);
    }
    for doubt in &verdict.doubts {
        add(
            &mut text,
            &format!(
                "  Because {}",
                ended(translator().diagnostic(&doubt.diagnostic()))
            ),
        );
    }
    add(&mut text, "");
    add(&mut text, &indented(&tables::ways(verdict)));
    if let Some(steps) = tables::differences(verdict) {
        add(&mut text, "");
        add(
            &mut text,
            "  From g T²/8 to the rebound of the rule, mean over the drops:",
        );
        add(&mut text, &indented(&steps));
    }
    add(&mut text, "");
    add(&mut text, &indented(&tables::drops(&verdict.drops, files)));
    if !verdict.reference_drops.is_empty() {
        add(&mut text, "");
        add(&mut text, "  On the reference:");
        add(
            &mut text,
            &indented(&tables::drops(&verdict.reference_drops, reference_files)),
        );
    }
    add(&mut text, "");
    let remarks = verdict.remarks.iter();
    let remarks = remarks.map(|remark| ended(translator().diagnostic(&remark.diagnostic())));
    for note in remarks.chain(rule.note.as_ref().map(ended)) {
        add(&mut text, &format!("  Note: {note}"));
    }
    if !physics.assumptions.is_empty() {
        add(&mut text, &assumed(&physics.assumptions));
    }
    text
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
    let surface = rule
        .surface
        .as_ref()
        .map_or_else(String::new, |surface| format!(" on {surface}"));
    vec![
        format!(
            "{}: {} ({}{edition}; {})",
            rule.name, rule.title, rule.source, rule.status
        ),
        format!(
            "  drop from {}{surface}; rebound wanted: {}; measured at the {} of the ball",
            rules::drop(rule),
            rules::wanted(rule),
            rule.point()
        ),
    ]
}

fn decided(verdict: &Verdict, decision: Decision) -> Vec<String> {
    let mut lines = vec![outcome(verdict)];
    let decision_rule = by_rule(verdict, decision).into_iter();
    lines.extend(decision_rule.map(|sentence| format!("  {sentence}")));
    lines
}

/// The decision, and how sure it is.
pub(super) fn outcome(verdict: &Verdict) -> String {
    let word = match verdict.outcome {
        Outcome::Pass => "PASS",
        Outcome::Fail => "FAIL",
        Outcome::CannotDecide => "CANNOT DECIDE",
    };
    match verdict.within {
        Some(within) => format!(
            "{word}. Within the limits with a probability of {}; a pass would be wrong with {}.",
            percent(within),
            percent(1.0 - within)
        ),
        None => format!("{word}."),
    }
}

/// The decision rule, and what it accepts.
pub(super) fn by_rule(verdict: &Verdict, decision: Decision) -> Vec<String> {
    let mut lines = vec![match decision {
        Decision::Guarded { risk } => format!(
            "Decision rule: guarded acceptance, wrong with at most {} either way (JCGM 106).",
            percent(risk)
        ),
        Decision::Simple => {
            "Decision rule: simple acceptance, whatever is more probable (JCGM 106).".to_owned()
        }
    }];
    if let (Some(accepted), Decision::Guarded { .. }) = (&verdict.accepted, decision) {
        let unit = if verdict.share.is_some() {
            Unit::Percent
        } else {
            Unit::Length
        };
        lines.push(format!(
            "At this uncertainty {} would pass.",
            ends(accepted, unit)
        ));
    }
    lines
}

/// A probability, without a claim to be certain.
fn percent(share: f64) -> String {
    const CERTAIN: f64 = 0.9995;
    if share > CERTAIN {
        "more than 99.9 %".to_owned()
    } else if share < 1.0 - CERTAIN {
        "less than 0.1 %".to_owned()
    } else {
        format!("{:.1} %", share * 100.0)
    }
}

fn ends(limits: &Limits, unit: Unit) -> String {
    let shown = |end: f64| Quantity::rounded(end, 4, unit).to_string();
    match (limits.least, limits.greatest) {
        (Some(least), Some(greatest)) => format!("{} to {}", shown(least), shown(greatest)),
        (Some(least), None) => format!("{} and more", shown(least)),
        (None, Some(greatest)) => format!("{} and less", shown(greatest)),
        (None, None) => "anything".to_owned(),
    }
}
