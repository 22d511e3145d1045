//! The report of a verdict, as a page.

use bouncelab::rulebook::Status;
use bouncelab_report::figure;
use bouncelab_report::messages::capital;
use bouncelab_report::report::{
    Block, Language, Page, Provenance, Section, ended, method, priors, repeat, shared_conditions,
};

use super::{Told, tables, text};
use crate::language::{text as message, text_with, translator};
use crate::report::provenance;
use crate::rules;

/// The page of a verdict; `hashes` are those of its recordings.
pub(super) fn page(told: &Told<'_>, hashes: Vec<(String, String)>) -> Page {
    let provenance = Provenance {
        files: hashes,
        ..provenance()
    };
    let made = provenance.made.clone().unwrap_or_default();
    let version = ("version", env!("CARGO_PKG_VERSION").into());
    let subtitle = text_with("verdict-made-on", &[version, ("date", made.into())]);
    let physics = told.physics;
    let outcome = text::outcome_name(told.verdict.outcome);
    Page {
        title: format!("{}: {outcome}", told.rule.title),
        subtitle,
        lead: lead(told),
        sections: vec![
            the_rule(told),
            rebound(told),
            drops(told),
            shared_conditions(physics, translator()),
            priors(&physics.options, translator()),
            decision(),
            method(translator()),
            repeat(&provenance, translator()),
        ],
        details: Vec::new(),
        unfolded: false,
        language: Language::new(translator()),
    }
}

fn lead(told: &Told<'_>) -> Vec<Block> {
    let verdict = told.verdict;
    let mut lead = vec![Block::Lead(text::outcome(verdict))];
    lead.push(Block::text(text::by_rule(verdict, told.decision).join(" ")));
    lead.extend(text::because(verdict).map(Block::Note));
    if told.rule.status == Status::Unverified {
        lead.push(Block::Note(message("rule-nobody-read")));
    }
    let chart = figure::verdict(told.rule, verdict, told.files, translator());
    lead.push(Block::figure("verdict", chart));
    lead
}

fn the_rule(told: &Told<'_>) -> Section {
    let name = (message("rule-name"), told.rule.name.clone());
    let facts = std::iter::once(name).chain(rules::facts(told.rule));
    let facts = facts.map(|(name, value)| (capital(&name), value));
    Section::new(
        message("verdict-the-rule"),
        vec![Block::Facts(facts.collect())],
    )
}

fn rebound(told: &Told<'_>) -> Section {
    let ways = tables::ways(told.verdict);
    let mut blocks = vec![Block::table(message("verdict-ways"), ways)];
    if let Some(steps) = tables::differences(told.verdict) {
        blocks.push(Block::table(message("verdict-steps"), steps));
        blocks.push(Block::text(message("verdict-steps-why")));
    }
    let remarks = told.verdict.remarks.iter();
    let remarks = remarks.map(|remark| translator().diagnostic(&remark.diagnostic()));
    let notes = remarks.chain(told.rule.note.clone());
    blocks.extend(notes.map(|note| Block::Note(ended(note))));
    Section::new(message("verdict-the-rebound"), blocks)
}

fn drops(told: &Told<'_>) -> Section {
    let verdict = told.verdict;
    let drops = tables::drops(&verdict.drops, told.files);
    let mut blocks = vec![Block::table(message("verdict-every-drop"), drops)];
    if !verdict.reference_drops.is_empty() {
        let drops = tables::drops(&verdict.reference_drops, told.reference_files);
        blocks.push(Block::table(message("verdict-every-reference-drop"), drops));
    }
    Section::new(message("verdict-drops"), blocks)
}

fn decision() -> Section {
    let ids = ["verdict-method-predicted", "verdict-method-decided"];
    let blocks = ids.map(|id| Block::text(message(id)));
    Section::new(message("verdict-method"), blocks.into())
}
