//! The report of a verdict, as a page.

use bouncelab::Estimate;
use bouncelab::rulebook::{Limits, Rebound, Requirement, Status};
use bouncelab_report::Chart;
use bouncelab_report::figure::{self, Judged};
use bouncelab_report::messages::Translator;
use bouncelab_report::report::{
    Block, Language, Page, Provenance, Section, ended, method, repeat, shared_conditions,
};

use super::{Told, tables, text};
use crate::language::translator;
use crate::report::provenance;
use crate::rules;

/// The page of a verdict; `hashes` are those of its recordings.
pub(super) fn page(told: &Told<'_>, hashes: Vec<(String, String)>) -> Page {
    let provenance = Provenance {
        files: hashes,
        ..provenance()
    };
    let made = provenance.made.as_deref().unwrap_or_default();
    let physics = told.physics;
    Page {
        title: format!("{}: {}", told.rule.title, told.verdict.outcome),
        subtitle: format!("Verdict of bouncelab {}, {made}", env!("CARGO_PKG_VERSION")),
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
    let because = verdict.doubts.iter();
    lead.extend(because.map(|doubt| {
        Block::Note(format!(
            "Because {}",
            ended(translator().diagnostic(&doubt.diagnostic()))
        ))
    }));
    if told.rule.status == Status::Unverified {
        let unverified = "This rule is unverified: nobody has read it in its source.";
        lead.push(Block::Note(unverified.to_owned()));
    }
    lead.push(Block::figure("verdict", chart(told, translator())));
    lead
}

fn the_rule(told: &Told<'_>) -> Section {
    let name = ("name", told.rule.name.clone());
    let facts = std::iter::once(name).chain(rules::facts(told.rule));
    let facts = facts.map(|(name, value)| (capitalised(name), value));
    Section::new("The rule", vec![Block::Facts(facts.collect())])
}

fn capitalised(word: &str) -> String {
    let mut letters = word.chars();
    let first = letters.next().map(|letter| letter.to_ascii_uppercase());
    first.into_iter().chain(letters).collect()
}

fn rebound(told: &Told<'_>) -> Section {
    let mut blocks = vec![Block::table(
        "The rebound by each way to work it out",
        tables::ways(told.verdict),
    )];
    if let Some(steps) = tables::differences(told.verdict) {
        blocks.push(Block::table(
            "From g T\u{b2}/8 to the rebound of the rule, mean over the drops",
            steps,
        ));
        blocks.push(Block::text(
            "The formula takes the whole time between two impacts as flight in a vacuum. The time of \
             contact is no flight; buoyancy and added mass make gravity weaker; drag shortens the \
             flight a little; and this drop fell from its own height, with an impact of its own.",
        ));
    }
    let remarks = told.verdict.remarks.iter();
    let remarks = remarks.map(|remark| translator().diagnostic(&remark.diagnostic()));
    let notes = remarks.chain(told.rule.note.clone());
    blocks.extend(notes.map(|note| Block::Note(ended(note))));
    Section::new("The rebound", blocks)
}

fn drops(told: &Told<'_>) -> Section {
    let verdict = told.verdict;
    let mut blocks = vec![Block::table(
        "Every drop",
        tables::drops(&verdict.drops, told.files),
    )];
    if !verdict.reference_drops.is_empty() {
        blocks.push(Block::table(
            "Every drop on the reference",
            tables::drops(&verdict.reference_drops, told.reference_files),
        ));
    }
    Section::new("The drops", blocks)
}

fn decision() -> Section {
    let words = [
        "What is judged is the apex after the first impact of a drop from the height of the rule, at \
         the point of the ball at which the rule measures. It is predicted from everything that the \
         drops said, at the impact speed of the rule, with the scatter of single impacts averaged out.",
        "A pass is given only if the probability of being outside the limits is at most the stated \
         risk, and a fail only if that of being within is (guarded acceptance, JCGM 106:2012, The role \
         of measurement uncertainty in conformity assessment). In between the drops cannot decide. \
         What is not known of ball, air and drag is the same for all drops and does not average out.",
    ];
    Section::new("How it was decided", words.map(Block::text).into())
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
        .map(|found| judged("all drops".to_owned(), found, true))
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
