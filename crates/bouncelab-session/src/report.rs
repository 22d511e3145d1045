//! The report of a session, as a page.

use bouncelab_report::Chart;
use bouncelab_report::groups::page;
use bouncelab_report::messages::Translator;
use bouncelab_report::report::{Block, Page, Provenance, Section, repeat};

use crate::results::Results;
use crate::study::Outcome;

/// Maximum number of recordings whose hashes are listed: a longer list is of no use on paper.
const MAX_LISTED: usize = 60;

/// The [page of the groups](page) of a session, with the charts of [`figures`](crate::figures()). If there are few
/// recordings, their hashes are part of the provenance.
pub fn report(
    outcome: &Outcome<'_>,
    results: &Results<'_>,
    charts: &[(&'static str, Chart)],
    provenance: Provenance,
    translator: &Translator,
) -> Page {
    let provenance = Provenance {
        files: files(results),
        ..provenance
    };
    let to_repeat = to_repeat(&provenance, translator);
    page(&outcome.groups, charts, &provenance, to_repeat, translator)
}

fn to_repeat(provenance: &Provenance, translator: &Translator) -> Section {
    let mut section = repeat(provenance, translator);
    if provenance.files.is_empty() {
        section
            .blocks
            .push(Block::text(translator.text("session-hashes")));
    }
    section
}

fn files(results: &Results<'_>) -> Vec<(String, String)> {
    if results.recordings.len() > MAX_LISTED {
        return Vec::new();
    }
    std::iter::zip(results.recordings, results.done)
        .filter_map(|(recording, done)| {
            let content = done.content.as_ref().ok()?;
            Some((recording.name().to_owned(), content.to_string()))
        })
        .collect()
}
