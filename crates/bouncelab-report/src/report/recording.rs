//! The page of one recording.

use bouncelab::Estimate;
use bouncelab::analysis::Drop;

use super::conditions::{conditions, priors};
use super::drop::{drop, drop_details, in_words};
use super::input::{Provenance, ReportInput};
use super::method::{method, method_in_short};
use super::page::{Block, Language, Page, Section, ended, sentence};
use crate::figure::{self, Mark};
use crate::messages::Translator;
use crate::quantity::{Quantity, Unit};
use crate::table::{Align, Table};

/// Drops with sections of their own: a page of a thousand would take 600 MB.
pub const MAX_DROPS_SHOWN: usize = 100;

/// The page of a recording: each drop in sentences, numbers and figures, the assumptions, the method, and
/// how to repeat it; all else in its details, which are folded.
pub fn of_recording(input: &ReportInput, provenance: &Provenance, translator: &Translator) -> Page {
    let drops = &input.result.drops;
    let settings = &input.setup.options;
    let (mut sections, mut details) = (Vec::new(), Vec::new());
    if let [only] = drops.as_slice() {
        // The page begins with the sentences already.
        sections.push(drop(
            &translator.text("report-drop"),
            only,
            input.setup,
            false,
            translator,
        ));
        details.extend(drop_details(only, settings, translator));
    } else {
        for (one, number) in drops.iter().take(MAX_DROPS_SHOWN).zip(1_usize..) {
            let of = [("number", number.into()), ("count", drops.len().into())];
            let heading = translator.text_with("report-drop-of", &of);
            sections.push(drop(&heading, one, input.setup, true, translator));
            details.push(Section {
                heading,
                blocks: Vec::new(),
                parts: drop_details(one, settings, translator),
            });
        }
    }
    sections.extend([
        conditions(input, translator),
        method_in_short(translator),
        repeat(provenance, translator),
    ]);
    details.extend([
        priors(settings, translator),
        air(input, translator),
        method(translator),
    ]);
    details.retain(|section| !section.is_empty());
    Page {
        title: file_name(input.name),
        subtitle: made_by(provenance, translator),
        lead: lead(input, translator),
        sections,
        details,
        unfolded: false,
        foot: String::new(),
        compact: false,
        logo: None,
        language: Language::new(translator),
    }
}

/// The name without its folder, which does not describe the recording.
fn file_name(name: &str) -> String {
    let own = name.rsplit(['/', '\\']).find(|part| !part.is_empty());
    own.unwrap_or(name).to_owned()
}

/// Which program made a page, and when.
pub fn made_by(provenance: &Provenance, translator: &Translator) -> String {
    let version = ("version", env!("CARGO_PKG_VERSION").into());
    match &provenance.made {
        Some(made) => {
            translator.text_with("report-made-on", &[version, ("date", made.as_str().into())])
        }
        None => translator.text_with("report-made-by", &[version]),
    }
}

fn lead(input: &ReportInput, translator: &Translator) -> Vec<Block> {
    let mut lead = Vec::new();
    match input.result.drops.as_slice() {
        [] => {
            let reason = input.result.no_drop.as_ref().map_or_else(
                || translator.text("report-no-reason"),
                |known| ended(translator.diagnostic(known)),
            );
            let reason = [("reason", reason.into())];
            lead.push(Block::Lead(translator.text_with("report-no-drop", &reason)));
        }
        [only] => lead.extend(in_words(only, input.setup, translator)),
        several => {
            let impacts: usize = several.iter().map(|drop| drop.impacts.len()).sum();
            let counts = [("drops", several.len().into()), ("impacts", impacts.into())];
            lead.push(Block::Lead(
                translator.text_with("report-drops-found", &counts),
            ));
            lead.push(Block::table(
                translator.text("report-drops"),
                overview(several, translator),
            ));
            if several.len() > MAX_DROPS_SHOWN {
                let shown = [("count", MAX_DROPS_SHOWN.into())];
                lead.push(Block::Note(
                    translator.text_with("report-first-drops", &shown),
                ));
            }
        }
    }
    let notes = input.result.diagnostics.iter();
    lead.extend(notes.map(|known| Block::Note(sentence(&translator.diagnostic(known)))));
    if let Some(sound) = &input.result.envelope {
        let marks = Mark::of_drops(&input.result.drops);
        lead.push(Block::figure(
            "waveform",
            figure::waveform(sound, &marks, translator),
        ));
    }
    lead
}

/// One line for each drop.
fn overview(drops: &[Drop], translator: &Translator) -> Table {
    let mut table = Table::with_headings(
        translator,
        [
            ("column-drop", Align::Right),
            ("column-start", Align::Right),
            ("column-impacts", Align::Right),
            ("quantity-restitution", Align::Right),
            ("quantity-drop-height", Align::Right),
        ],
    );
    for (drop, number) in drops.iter().zip(1..) {
        let posterior = drop.posterior.as_ref().ok();
        let shown = |summary: Option<&Estimate>, unit| match summary {
            Some(summary) => Quantity::of(summary, unit).text(translator),
            None => translator.text("unit-cannot-tell"),
        };
        let start = drop.impacts.first();
        table.row([
            number.to_string(),
            start.map_or_else(String::new, |first| translator.fixed(first.time_s, 2)),
            drop.impacts.len().to_string(),
            shown(posterior.map(|it| &it.restitution), Unit::Number),
            shown(posterior.map(|it| &it.drop_height_m), Unit::Length),
        ]);
    }
    table
}

fn air(input: &ReportInput, translator: &Translator) -> Section {
    let figures = figure::of_air(&input.result.drops, &input.setup.options, translator);
    let blocks = figures
        .into_iter()
        .map(|(name, chart)| Block::figure(name, chart))
        .collect();
    Section::new(translator.text("report-air"), blocks)
}

/// How to get the same page again: version, command, and the hash of each file.
pub fn repeat(provenance: &Provenance, translator: &Translator) -> Section {
    let version = [("version", env!("CARGO_PKG_VERSION").into())];
    let mut blocks = vec![Block::text(
        translator.text_with("report-repeat-version", &version),
    )];
    if let Some(command) = &provenance.command {
        blocks.push(Block::Code(command.clone()));
    }
    if !provenance.files.is_empty() {
        blocks.push(Block::text(translator.text("report-repeat-files")));
        let lines: Vec<String> = provenance
            .files
            .iter()
            .map(|(name, hash)| format!("{hash}  {name}"))
            .collect();
        blocks.push(Block::Code(lines.join("\n")));
    }
    Section::new(translator.text("report-repeat"), blocks)
}
