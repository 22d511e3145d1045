//! The page of one recording.

use bouncelab::Estimate;
use bouncelab::analysis::Drop;

use super::conditions::{conditions, priors};
use super::drop::{drop, drop_details, in_words};
use super::method::{method, method_in_short};
use super::page::{Block, Language, Page, Section, ended, sentence};
use super::subject::{Provenance, Recording};
use crate::figure::{self, Mark};
use crate::messages::Translator;
use crate::quantity::{Quantity, Unit};
use crate::table::{Align, Table};

/// So many drops have sections of their own: a page of a thousand would take 600 MB, and a reader days.
const MOST_DROPS: usize = 100;

/// The page of a recording: each drop in words, numbers and figures, what was assumed, the method, and
/// how to repeat it; all else in its details, which are folded.
pub fn of_recording(recording: &Recording, provenance: &Provenance, words: &Translator) -> Page {
    let drops = &recording.result.drops;
    let settings = &recording.setup.options;
    let (mut sections, mut details) = (Vec::new(), Vec::new());
    if let [only] = drops.as_slice() {
        // The page begins with the words already.
        sections.push(drop(
            &words.text("report-drop"),
            only,
            settings,
            false,
            words,
        ));
        details.extend(drop_details(only, settings, words));
    } else {
        for (found, number) in drops.iter().take(MOST_DROPS).zip(1_usize..) {
            let of = [("number", number.into()), ("count", drops.len().into())];
            let heading = words.text_with("report-drop-of", &of);
            sections.push(drop(&heading, found, settings, true, words));
            details.push(Section {
                heading,
                blocks: Vec::new(),
                parts: drop_details(found, settings, words),
            });
        }
    }
    sections.extend([
        conditions(recording, words),
        method_in_short(words),
        repeat(provenance, words),
    ]);
    details.extend([
        priors(settings, words),
        air(recording, words),
        method(words),
    ]);
    details.retain(|section| !section.is_empty());
    Page {
        title: file_name(recording.name),
        subtitle: made_by(provenance, words),
        lead: lead(recording, words),
        sections,
        details,
        unfolded: false,
        language: Language::new(words),
    }
}

/// The name without its folder, which says nothing of the recording.
fn file_name(name: &str) -> String {
    let own = name.rsplit(['/', '\\']).find(|part| !part.is_empty());
    own.unwrap_or(name).to_owned()
}

/// Which program made a page, and when.
pub fn made_by(provenance: &Provenance, words: &Translator) -> String {
    let version = ("version", env!("CARGO_PKG_VERSION").into());
    match &provenance.made {
        Some(made) => words.text_with("report-made-on", &[version, ("date", made.as_str().into())]),
        None => words.text_with("report-made-by", &[version]),
    }
}

fn lead(recording: &Recording, words: &Translator) -> Vec<Block> {
    let mut lead = Vec::new();
    match recording.result.drops.as_slice() {
        [] => {
            let reason = recording.result.no_drop.as_ref().map_or_else(
                || words.text("report-no-reason"),
                |known| ended(words.diagnostic(known)),
            );
            let reason = [("reason", reason.into())];
            lead.push(Block::Lead(words.text_with("report-no-drop", &reason)));
        }
        [only] => lead.extend(in_words(only, words)),
        several => {
            let impacts: usize = several.iter().map(|drop| drop.impacts.len()).sum();
            let counts = [("drops", several.len().into()), ("impacts", impacts.into())];
            lead.push(Block::Lead(words.text_with("report-drops-found", &counts)));
            lead.push(Block::table(
                words.text("report-drops"),
                overview(several, words),
            ));
            if several.len() > MOST_DROPS {
                let shown = [("count", MOST_DROPS.into())];
                lead.push(Block::Note(words.text_with("report-first-drops", &shown)));
            }
        }
    }
    let notes = recording.result.diagnostics.iter();
    lead.extend(notes.map(|known| Block::Note(sentence(&words.diagnostic(known)))));
    if let Some(sound) = &recording.result.envelope {
        let marks = Mark::of_drops(&recording.result.drops);
        lead.push(Block::figure(
            "waveform",
            figure::waveform(sound, &marks, words),
        ));
    }
    lead
}

/// One line for each drop.
fn overview(drops: &[Drop], words: &Translator) -> Table {
    let mut table = Table::with_headings(
        words,
        [
            ("column-drop", Align::Right),
            ("column-start", Align::Right),
            ("column-impacts", Align::Right),
            ("quantity-restitution", Align::Right),
            ("quantity-drop-height", Align::Right),
        ],
    );
    for (drop, number) in drops.iter().zip(1..) {
        let found = drop.posterior.as_ref().ok();
        let shown = |summary: Option<&Estimate>, unit| match summary {
            Some(summary) => Quantity::of(summary, unit).text(words),
            None => words.text("unit-cannot-tell"),
        };
        let start = drop.impacts.first();
        table.row([
            number.to_string(),
            start.map_or_else(String::new, |first| words.fixed(first.time_s, 2)),
            drop.impacts.len().to_string(),
            shown(found.map(|f| &f.restitution), Unit::Number),
            shown(found.map(|f| &f.drop_height_m), Unit::Length),
        ]);
    }
    table
}

fn air(recording: &Recording, words: &Translator) -> Section {
    let figures = figure::of_air(&recording.result.drops, &recording.setup.options, words);
    let blocks = figures
        .into_iter()
        .map(|(name, chart)| Block::figure(name, chart))
        .collect();
    Section::new(words.text("report-air"), blocks)
}

/// How to get the same page again: version, command, and the hash of each file.
pub fn repeat(provenance: &Provenance, words: &Translator) -> Section {
    let version = [("version", env!("CARGO_PKG_VERSION").into())];
    let mut blocks = vec![Block::text(
        words.text_with("report-repeat-version", &version),
    )];
    if let Some(command) = &provenance.command {
        blocks.push(Block::Code(command.clone()));
    }
    if !provenance.files.is_empty() {
        blocks.push(Block::text(words.text("report-repeat-files")));
        let lines: Vec<String> = provenance
            .files
            .iter()
            .map(|(name, hash)| format!("{hash}  {name}"))
            .collect();
        blocks.push(Block::Code(lines.join("\n")));
    }
    Section::new(words.text("report-repeat"), blocks)
}
