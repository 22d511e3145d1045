//! The report of a verdict, as a page.

use bouncelab::Estimate;
use bouncelab::rulebook::{Limits, Rebound, Requirement, Status};
use bouncelab_report::Chart;
use bouncelab_report::figure::{self, Judged};
use bouncelab_report::messages::{Translator, capital};
use bouncelab_report::report::{
    Block, Language, Page, Provenance, Section, ended, method, repeat, shared_conditions,
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
            decision(),
            method(translator()),
            repeat(&provenance, translator()),
        ],
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
    lead.push(Block::figure("verdict", chart(told, translator())));
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

/// What the decision is about, and every drop that led to it, against the limits.
fn chart(told: &Told<'_>, translator: &Translator) -> Chart {
    /// Metres to centimetres, shares to percent.
    const SHOWN: f64 = 100.0;
    let verdict = told.verdict;
    let (limits, decides, (quantity, unit)) = match &told.rule.requirement {
        Requirement::Height(limits) => (*limits, verdict.rebound, ("axis-rebound", "cm")),
        Requirement::About(_) => (Limits::default(), verdict.rebound, ("axis-rebound", "cm")),
        Requirement::Share { limits, .. } => {
            (*limits, verdict.share, ("axis-share-of-reference", "%"))
        }
    };
    let scaled = |limits: Limits| [limits.least, limits.greatest].map(|end| Some(end? * SHOWN));
    let judged = |name: String, found: &Estimate, decides: bool| Judged {
        name,
        value: found.value * SHOWN,
        interval95: Some(found.interval95.map(|end| end * SHOWN)),
        decides,
    };
    let mut rows: Vec<Judged> = decides
        .iter()
        .map(|found| judged(message("verdict-all-drops"), found, true))
        .collect();
    if verdict.share.is_none() {
        let name = |drop: &Rebound| told.files.get(drop.place).cloned().unwrap_or_default();
        let drops = verdict.drops.iter();
        rows.extend(
            drops.filter_map(|drop| Some(judged(name(drop), drop.predicted_m.as_ref()?, false))),
        );
    }
    let accepted = verdict.accepted.map_or([None; 2], scaled);
    figure::limits(
        &rows,
        scaled(limits),
        accepted,
        (translator.text(quantity), unit),
        translator,
    )
}
