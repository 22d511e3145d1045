//! The verdict as text.

use std::fmt::Write;

use bouncelab::rulebook::{Decision, Rule, Verdict};
use bouncelab_report::Table;
use bouncelab_report::document::verdict::Evaluation;
use bouncelab_report::report::verdict::{
    because, budget, by_rule, drop_table, outcome, precision, procedure, ways,
};
use bouncelab_report::rules::words;

use crate::analyze::{assumed, note};
use crate::language::{text, text_with, translator};

/// The verdict, the rebound by several definitions and why they differ, and remarks.
pub(crate) fn report(evaluation: &Evaluation) -> String {
    let Evaluation {
        rule,
        verdict,
        decision,
        files,
        reference_files,
        setup,
    } = evaluation;
    let mut page = String::new();
    for line in of_rule(rule) {
        add(&mut page, &line);
    }
    add(&mut page, "");
    for line in decided(verdict, *decision) {
        add(&mut page, &line);
    }
    for because in because(verdict, translator()) {
        add(&mut page, &format!("  {because}"));
    }
    add(&mut page, "");
    add(
        &mut page,
        &indented(&procedure(rule, &verdict.procedure, translator())),
    );
    add(&mut page, "");
    add(&mut page, &indented(&ways(verdict, translator())));
    if let Some(mean) = &verdict.rebound {
        add(&mut page, "");
        let title = translator().with_colon(&text("verdict-budget"));
        add(&mut page, &format!("  {title}"));
        add(&mut page, &indented(&budget(mean, translator())));
    }
    if let Some(found) = verdict.precision() {
        add(&mut page, "");
        let title = translator().with_colon(&text("verdict-precision"));
        add(&mut page, &format!("  {title}"));
        let table = precision(&[("place", &found)], translator());
        add(&mut page, &indented(&table));
    }
    add(&mut page, "");
    add(
        &mut page,
        &indented(&drop_table(&verdict.drops, files, translator())),
    );
    if !verdict.reference_drops.is_empty() {
        let drops = drop_table(&verdict.reference_drops, reference_files, translator());
        add(&mut page, "");
        add(&mut page, &format!("  {}", text("verdict-on-reference")));
        add(&mut page, &indented(&drops));
    }
    add(&mut page, "");
    let remarks = verdict.remarks.iter();
    let remarks = remarks.map(|remark| translator().diagnostic(&remark.diagnostic()));
    for remark in remarks.chain(words::note(rule, translator())) {
        add(&mut page, &note(remark));
    }
    if !setup.assumptions.is_empty() {
        add(&mut page, &assumed(&setup.assumptions));
    }
    page
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
    let source = rule.source.citation();
    let surface = rule.surface.as_deref();
    let surface = surface.map(|name| words::surface(name, translator()));
    let wants = [
        ("drop", words::drop(rule, translator()).into()),
        ("surface", surface.map_or("none".into(), Into::into)),
        ("wanted", words::wanted(rule, translator()).into()),
        ("point", words::point(rule.point(), translator()).into()),
    ];
    let status = words::read(rule.source.read, translator());
    vec![
        format!(
            "{} {} ({})",
            translator().with_colon(&rule.name),
            words::title(rule, translator()),
            translator().in_one_line([source, status])
        ),
        format!("  {}", text_with("verdict-rule-line", &wants)),
    ]
}

fn decided(verdict: &Verdict, decision: Decision) -> Vec<String> {
    let mut lines = vec![outcome(verdict, translator())];
    let decision_rule = by_rule(verdict, decision, translator()).into_iter();
    lines.extend(decision_rule.map(|sentence| format!("  {sentence}")));
    lines
}
