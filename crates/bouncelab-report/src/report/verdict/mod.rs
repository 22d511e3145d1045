//! The page of a verdict.

mod tables;
mod words;

use bouncelab::rulebook::Status;

use super::conditions::{priors, shared_conditions};
use super::method::method;
use super::page::{Block, Language, Page, Section, ended};
use super::recording::{made_by, repeat};
use super::subject::Provenance;
use crate::document::verdict::Judgement;
use crate::figure;
use crate::messages::{Translator, capital};
use crate::rules;

pub use tables::{differences, drops as drop_table, ways};
pub use words::{because, by_rule, outcome, outcome_name};

/// The page of a verdict: what was decided, the rule, the rebound in several ways, each drop, what was
/// assumed, the method, and how to repeat it.
pub fn of_verdict(judgement: &Judgement<'_>, provenance: &Provenance, words: &Translator) -> Page {
    let title = words.with_colon(&rules::words::title(judgement.rule, words));
    let outcome = words::outcome_name(judgement.verdict.outcome, words);
    Page {
        title: format!("{title} {outcome}"),
        subtitle: made_by(provenance, words),
        lead: lead(judgement, words),
        sections: vec![
            the_rule(judgement, words),
            rebound(judgement, words),
            drops(judgement, words),
            shared_conditions(judgement.setup, words),
            priors(&judgement.setup.options, words),
            decision(words),
            method(words),
            repeat(provenance, words),
        ],
        details: Vec::new(),
        unfolded: false,
        language: Language::new(words),
    }
}

fn lead(judgement: &Judgement<'_>, words: &Translator) -> Vec<Block> {
    let verdict = judgement.verdict;
    let mut lead = vec![Block::Lead(words::outcome(verdict, words))];
    lead.push(Block::text(
        words::by_rule(verdict, judgement.decision, words).join(" "),
    ));
    lead.extend(words::because(verdict, words).map(Block::Note));
    if judgement.rule.status == Status::Unverified {
        lead.push(Block::Note(words.text("rule-nobody-read")));
    }
    let chart = figure::verdict(judgement.rule, verdict, judgement.files, words);
    lead.push(Block::figure("verdict", chart));
    lead
}

fn the_rule(judgement: &Judgement<'_>, words: &Translator) -> Section {
    let name = (words.text("rule-name"), judgement.rule.name.clone());
    let facts = std::iter::once(name).chain(rules::words::facts(judgement.rule, words));
    let facts = facts.map(|(name, value)| (capital(&name), value));
    Section::new(
        words.text("verdict-the-rule"),
        vec![Block::Facts(facts.collect())],
    )
}

fn rebound(judgement: &Judgement<'_>, words: &Translator) -> Section {
    let ways = tables::ways(judgement.verdict, words);
    let mut blocks = vec![Block::table(words.text("verdict-ways"), ways)];
    if let Some(steps) = tables::differences(judgement.verdict, words) {
        blocks.push(Block::table(words.text("verdict-steps"), steps));
        blocks.push(Block::text(words.text("verdict-steps-why")));
    }
    let remarks = judgement.verdict.remarks.iter();
    let remarks = remarks.map(|remark| words.diagnostic(&remark.diagnostic()));
    let notes = remarks.chain(rules::words::note(judgement.rule, words));
    blocks.extend(notes.map(|note| Block::Note(ended(note))));
    Section::new(words.text("verdict-the-rebound"), blocks)
}

fn drops(judgement: &Judgement<'_>, words: &Translator) -> Section {
    let verdict = judgement.verdict;
    let drops = tables::drops(&verdict.drops, judgement.files, words);
    let mut blocks = vec![Block::table(words.text("verdict-every-drop"), drops)];
    if !verdict.reference_drops.is_empty() {
        let drops = tables::drops(&verdict.reference_drops, judgement.reference_files, words);
        blocks.push(Block::table(
            words.text("verdict-every-reference-drop"),
            drops,
        ));
    }
    Section::new(words.text("verdict-drops"), blocks)
}

fn decision(words: &Translator) -> Section {
    let ids = ["verdict-method-predicted", "verdict-method-decided"];
    let blocks = ids.map(|id| Block::text(words.text(id)));
    Section::new(words.text("verdict-method"), blocks.into())
}
