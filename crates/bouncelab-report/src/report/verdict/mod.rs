//! The page of a verdict.

mod notes;
mod tables;
mod words;

use bouncelab::rulebook::Precision;

use super::conditions::{priors, shared_conditions};
use super::input::Provenance;
use super::method::method;
use super::page::{Block, Language, Page, Section, sentence};
use super::recording::{made_by, repeat};
use crate::document::verdict::Evaluation;
use crate::figure;
use crate::messages::{Translator, capital};
use crate::rules;

pub use notes::{MethodCheck, NoteField, TestNotes};
pub use tables::{budget, drops as drop_table, precision, procedure, ways};
pub use words::{because, by_rule, outcome, outcome_name, so_far};

/// The page of a verdict: what was decided, the rule, the rebound in several ways, each drop, what was
/// assumed, the method, and how to repeat it; with the notes of a laboratory the report of a test.
pub fn of_verdict(
    evaluation: &Evaluation,
    provenance: &Provenance,
    notes: Option<&TestNotes>,
    translator: &Translator,
) -> Page {
    let title = translator.with_colon(&rules::words::title(&evaluation.rule, translator));
    let outcome = words::outcome_name(evaluation.verdict.outcome, translator);
    let made = provenance.made.as_deref();
    let cited = evaluation.rule.source.citation();
    let head = notes.map(|notes| notes.section(&cited, made, translator));
    let one_page = notes.is_some_and(|notes| notes.one_page);
    let sections = if one_page {
        Vec::new()
    } else {
        let of_operators = notes.and_then(|notes| notes.of_operators);
        vec![
            rebound(evaluation, of_operators.as_ref(), translator),
            the_rule(evaluation, translator),
            drops(evaluation, translator),
            shared_conditions(&evaluation.setup, translator),
            decision(translator),
            repeat(provenance, translator),
        ]
    };
    // The model stands beside the result: what it assumes is no part of a test report.
    let details = match notes {
        Some(_) => Vec::new(),
        None => vec![
            priors(&evaluation.setup.options, translator),
            method(translator),
        ],
    };
    let closing = notes.map(|notes| notes.closing(translator));
    let foot = notes.map_or_else(String::new, |notes| notes.title(translator));
    let result = format!("{title} {outcome}");
    Page {
        title: notes::joined([foot.clone(), result]),
        subtitle: made_by(provenance, translator),
        lead: lead(evaluation, one_page, translator),
        sections: head.into_iter().chain(sections).chain(closing).collect(),
        details,
        unfolded: false,
        foot,
        compact: one_page,
        logo: notes.and_then(|notes| notes.logo.clone()),
        language: Language::new(translator),
    }
}

fn lead(evaluation: &Evaluation, with_result: bool, translator: &Translator) -> Vec<Block> {
    let verdict = &evaluation.verdict;
    let mut lead = vec![Block::Lead(words::outcome(verdict, translator))];
    lead.push(Block::text(
        words::by_rule(verdict, evaluation.decision, translator).join(" "),
    ));
    lead.extend(words::because(verdict, translator).map(Block::Note));
    let chart = figure::verdict(&evaluation.rule, verdict, &evaluation.files, translator);
    lead.push(Block::figure("verdict", chart));
    if with_result {
        let ways = tables::ways(verdict, translator);
        lead.push(Block::table(translator.text("verdict-ways"), ways));
    }
    lead
}

fn the_rule(evaluation: &Evaluation, translator: &Translator) -> Section {
    let name = (translator.text("rule-name"), evaluation.rule.name.clone());
    let facts = std::iter::once(name).chain(rules::words::facts(&evaluation.rule, translator));
    let facts = facts.map(|(name, value)| (capital(&name), value));
    let checks = tables::procedure(&evaluation.rule, &evaluation.verdict.procedure, translator);
    Section::new(
        translator.text("verdict-the-rule"),
        vec![
            Block::Facts(facts.collect()),
            Block::table(translator.text("verdict-procedure"), checks),
        ],
    )
}

fn rebound(
    evaluation: &Evaluation,
    of_operators: Option<&Precision>,
    translator: &Translator,
) -> Section {
    let ways = tables::ways(&evaluation.verdict, translator);
    let mut blocks = vec![Block::table(translator.text("verdict-ways"), ways)];
    let budgets = [
        ("verdict-budget", &evaluation.verdict.rebound),
        ("verdict-budget-reference", &evaluation.verdict.reference),
    ];
    for (id, mean) in budgets {
        if let Some(mean) = mean {
            blocks.push(Block::table(
                translator.text(id),
                tables::budget(mean, translator),
            ));
        }
    }
    blocks.push(Block::text(translator.text("verdict-budget-why")));
    let of_places = evaluation.verdict.precision();
    let factors = [("place", of_places.as_ref()), ("operator", of_operators)];
    let known: Vec<(&str, &Precision)> = factors
        .into_iter()
        .filter_map(|(factor, precision)| Some((factor, precision?)))
        .collect();
    if !known.is_empty() {
        blocks.push(Block::table(
            translator.text("verdict-precision"),
            tables::precision(&known, translator),
        ));
        blocks.push(Block::text(translator.text("verdict-precision-why")));
    }
    let remarks = evaluation.verdict.remarks.iter();
    let remarks = remarks.map(|remark| translator.diagnostic(&remark.diagnostic()));
    let notes = remarks.chain(rules::words::note(&evaluation.rule, translator));
    blocks.extend(notes.map(|note| Block::Note(sentence(&note))));
    Section::new(translator.text("verdict-the-rebound"), blocks)
}

fn drops(evaluation: &Evaluation, translator: &Translator) -> Section {
    let verdict = &evaluation.verdict;
    let drops = tables::drops(&verdict.drops, &evaluation.files, translator);
    let mut blocks = vec![Block::table(translator.text("verdict-every-drop"), drops)];
    if !verdict.reference_drops.is_empty() {
        let drops = tables::drops(
            &verdict.reference_drops,
            &evaluation.reference_files,
            translator,
        );
        blocks.push(Block::table(
            translator.text("verdict-every-reference-drop"),
            drops,
        ));
    }
    Section::new(translator.text("verdict-drops"), blocks)
}

fn decision(translator: &Translator) -> Section {
    let ids = ["verdict-method-predicted", "verdict-method-decided"];
    let blocks = ids.map(|id| Block::text(translator.text(id)));
    Section::new(translator.text("verdict-method"), blocks.into())
}
