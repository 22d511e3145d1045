//! The verdict for people.

use std::fmt::Write;

use bouncelab::estimate::Summary;
use bouncelab::rulebook::{Decision, Limits, Outcome, Rebound, Rule, Step, Verdict};
use bouncelab_report::{Align, CANNOT_TELL, Quantity, Table, Unit};

use super::Told;
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
        add(&mut text, &format!("  Because {doubt}."));
    }
    add(&mut text, "");
    add(&mut text, &indented(&ways(verdict)));
    if let Some(steps) = differences(verdict) {
        add(&mut text, "");
        add(
            &mut text,
            "  From g T²/8 to the rebound of the rule, mean over the drops:",
        );
        add(&mut text, &indented(&steps));
    }
    add(&mut text, "");
    add(&mut text, &indented(&drops(&verdict.drops, files)));
    if !verdict.reference_drops.is_empty() {
        add(&mut text, "");
        add(&mut text, "  On the reference:");
        add(
            &mut text,
            &indented(&drops(&verdict.reference_drops, reference_files)),
        );
    }
    add(&mut text, "");
    for remark in &verdict.remarks {
        add(&mut text, &format!("  Note: {remark}."));
    }
    if let Some(note) = &rule.note {
        add(&mut text, &format!("  Note: {note}."));
    }
    if !physics.assumptions.is_empty() {
        add(
            &mut text,
            &format!("  Assumed: {}.", physics.assumptions.join("; ")),
        );
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

/// The rebound by each way to work it out.
pub(super) fn ways(verdict: &Verdict) -> Table {
    let mut table = Table::new([
        ("rebound", Align::Left),
        ("value", Align::Right),
        ("95 %", Align::Right),
    ]);
    let mut row = |name: &str, summary: &Option<Summary>, unit: Unit| {
        if let Some(summary) = summary {
            let value = Quantity::measured(summary.value, summary.sd, unit);
            table.row([
                name.to_owned(),
                value.to_string(),
                value.interval(summary.interval95),
            ]);
        }
    };
    row("predicted, with air", &verdict.rebound, Unit::Length);
    row("on the reference", &verdict.reference, Unit::Length);
    row("share of the reference", &verdict.share, Unit::Percent);
    row(
        "unevenness of the places",
        &verdict.unevenness,
        Unit::Percent,
    );
    let plain = [
        ("g T²/8 of the first flight", verdict.plain_m()),
        ("the rule's formula from T", verdict.formula_m()),
    ];
    for (name, height_m) in plain {
        if let Some(height_m) = height_m {
            table.row([name.to_owned(), length(height_m)]);
        }
    }
    if table.is_empty() {
        table.row(["", CANNOT_TELL]);
    }
    table
}

/// What lies between the plain height and the predicted one, if every drop says so.
pub(super) fn differences(verdict: &Verdict) -> Option<Table> {
    let drops = &verdict.drops;
    let first = drops.first()?;
    if drops.iter().any(|drop| drop.steps.is_empty()) {
        return None;
    }
    let mut table = Table::new([("because of", Align::Left), ("cm", Align::Right)]);
    let count = drops.len() as f64;
    for (place, step) in first.steps.iter().enumerate() {
        let of_drop = |drop: &Rebound| drop.steps.get(place).map_or(0.0, |s: &Step| s.height_m);
        let mean_m = drops.iter().map(of_drop).sum::<f64>() / count;
        table.row([step.why.to_string(), signed(mean_m * 100.0)]);
    }
    Some(table)
}

/// With its sign, but for zero.
fn signed(value: f64) -> String {
    match format!("{value:+.2}").as_str() {
        "-0.00" | "+0.00" => "0.00".to_owned(),
        number => number.replace('-', "\u{2212}"),
    }
}

pub(super) fn drops(drops: &[Rebound], files: &[String]) -> Table {
    let with_formula = drops.iter().any(|drop| drop.formula_m.is_some());
    let mut columns = vec![
        ("file", Align::Left),
        ("first flight s", Align::Right),
        ("g T²/8", Align::Right),
    ];
    if with_formula {
        columns.push(("formula", Align::Right));
    }
    columns.push(("predicted", Align::Right));
    let mut table = Table::new(columns);
    for drop in drops {
        let shown = |height: Option<f64>| height.map_or_else(String::new, length);
        let mut row = vec![
            files.get(drop.place).cloned().unwrap_or_default(),
            drop.first_flight_s
                .map_or_else(String::new, |time_s| format!("{time_s:.4}")),
            shown(drop.plain_m),
        ];
        if with_formula {
            row.push(shown(drop.formula_m));
        }
        row.push(drop.predicted_m.map_or_else(
            || CANNOT_TELL.to_owned(),
            |found| Quantity::measured(found.value, found.sd, Unit::Length).to_string(),
        ));
        table.row(row);
    }
    table
}

fn length(metres: f64) -> String {
    Quantity::rounded(metres, 4, Unit::Length).to_string()
}
