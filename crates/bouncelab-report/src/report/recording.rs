//! The page of one recording.

use bouncelab::analysis::Drop;
use bouncelab::inference::Summary;

use super::conditions::conditions;
use super::drop::{drop, in_words, measured};
use super::method::method;
use super::page::{Block, Language, Page, Section, ended, sentence};
use super::subject::{Provenance, Recording};
use crate::illustration;
use crate::quantity::{CANNOT_TELL, Unit};
use crate::table::{Align, Table};

/// The page of a recording: each drop in words and numbers, what was assumed, the method, and how to
/// repeat it.
pub fn of_recording(recording: &Recording, provenance: &Provenance) -> Page {
    let drops = recording.drops;
    let mut sections = Vec::new();
    for (index, found) in drops.iter().enumerate() {
        let heading = match drops.len() {
            1 => "The drop".to_owned(),
            count => format!("Drop {} of {count}", index + 1),
        };
        // With a single drop the page begins with the words already.
        sections.push(drop(&heading, found, recording.settings, drops.len() > 1));
    }
    sections.push(conditions(recording));
    sections.push(air(recording));
    sections.push(method());
    sections.push(repeat(provenance));
    sections.retain(|section| !section.is_empty());
    Page {
        title: file_name(recording.name),
        subtitle: subtitle(provenance),
        lead: lead(recording),
        sections,
        language: Language::default(),
    }
}

/// The name without its folder, which says nothing of the recording.
fn file_name(name: &str) -> String {
    let own = name.rsplit(['/', '\\']).find(|part| !part.is_empty());
    own.unwrap_or(name).to_owned()
}

fn subtitle(provenance: &Provenance) -> String {
    let by = format!("Report of bouncelab {}", env!("CARGO_PKG_VERSION"));
    match &provenance.made {
        Some(made) => format!("{by}, {made}"),
        None => by,
    }
}

fn lead(recording: &Recording) -> Vec<Block> {
    let mut lead = Vec::new();
    match recording.drops {
        [] => {
            let reason = recording.no_drop.unwrap_or("nothing in it bounces");
            lead.push(Block::Lead(format!("No drop was found: {}", ended(reason))));
        }
        [only] => lead.extend(in_words(only)),
        several => {
            let impacts: usize = several.iter().map(|drop| drop.impacts.len()).sum();
            lead.push(Block::Lead(format!(
                "{} drops with {impacts} impacts were heard.",
                several.len()
            )));
            lead.push(Block::table("The drops", overview(several)));
        }
    }
    lead.extend(
        recording
            .warnings
            .iter()
            .map(|warning| Block::Note(sentence(warning))),
    );
    if let Some(sound) = recording.sound
        && let Ok(drawn) = illustration::waveform(sound, recording.drops)
    {
        lead.push(Block::figure("waveform", drawn));
    }
    lead
}

/// One line for each drop.
fn overview(drops: &[Drop]) -> Table {
    let mut table = Table::new([
        ("drop", Align::Right),
        ("from s", Align::Right),
        ("impacts", Align::Right),
        ("restitution", Align::Right),
        ("drop height", Align::Right),
    ]);
    for (drop, number) in drops.iter().zip(1..) {
        let found = drop.estimate.as_ref().ok();
        let shown = |summary: Option<&Summary>, unit| {
            summary.map_or_else(|| CANNOT_TELL.to_owned(), |s| measured(s, unit).to_string())
        };
        let start = drop.impacts.first();
        table.row([
            number.to_string(),
            start.map_or_else(String::new, |first| format!("{:.2}", first.time_s)),
            drop.impacts.len().to_string(),
            shown(found.map(|f| &f.restitution), Unit::Number),
            shown(found.map(|f| &f.drop_height_m), Unit::Length),
        ]);
    }
    table
}

fn air(recording: &Recording) -> Section {
    let figures = illustration::of_air(recording.drops, recording.settings);
    let blocks = figures
        .into_iter()
        .map(|drawn| Block::figure(drawn.name, drawn.figure))
        .collect();
    Section::new("The air at these speeds", blocks)
}

/// How to get the same page again: version, command, and the hash of each file.
pub fn repeat(provenance: &Provenance) -> Section {
    let mut blocks = vec![Block::text(format!(
        "Version {} of bouncelab gives the same numbers from the same file and settings; the random \
         numbers of the inference have a seed.",
        env!("CARGO_PKG_VERSION")
    ))];
    if let Some(command) = &provenance.command {
        blocks.push(Block::Code(command.clone()));
    }
    if !provenance.files.is_empty() {
        blocks.push(Block::text(
            "The files that were read, by their SHA-256 (sha256sum shows it):",
        ));
        let lines: Vec<String> = provenance
            .files
            .iter()
            .map(|(name, hash)| format!("{hash}  {name}"))
            .collect();
        blocks.push(Block::Code(lines.join("\n")));
    }
    Section::new("To repeat this", blocks)
}
