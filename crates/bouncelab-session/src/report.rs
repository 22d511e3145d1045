//! The report of a session, as a page.

use bouncelab_report::Chart;
use bouncelab_report::groups::page;
use bouncelab_report::messages::Translator;
use bouncelab_report::report::{Block, Page, Provenance, Section, repeat};

use crate::results::Results;
use crate::study::Outcome;

/// With more recordings than this a list of their hashes is no use on paper.
const LISTED: usize = 60;

/// The [page of the groups](page) of a session ([`figures`](crate::figures()) makes the charts). The hashes of few
/// recordings go with the provenance.
pub fn report(
    outcome: &Outcome<'_>,
    results: &Results<'_>,
    charts: &[(&'static str, Chart)],
    provenance: Provenance,
    words: &Translator,
) -> Page {
    let provenance = Provenance {
        files: files(results),
        ..provenance
    };
    let to_repeat = to_repeat(&provenance, words);
    page(&outcome.groups, charts, &provenance, to_repeat, words)
}

fn to_repeat(provenance: &Provenance, words: &Translator) -> Section {
    let mut section = repeat(provenance, words);
    if provenance.files.is_empty() {
        section
            .blocks
            .push(Block::text(words.text("session-hashes")));
    }
    section
}

fn files(results: &Results<'_>) -> Vec<(String, String)> {
    if results.recordings.len() > LISTED {
        return Vec::new();
    }
    std::iter::zip(results.recordings, results.done)
        .filter_map(|(recording, done)| {
            let content = done.content.as_ref().ok()?;
            Some((recording.name().to_owned(), content.to_string()))
        })
        .collect()
}
