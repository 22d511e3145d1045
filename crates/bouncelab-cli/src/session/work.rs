//! Hearing many recordings, side by side, once each.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

use bouncelab_session::hash::{self, Hash};
use bouncelab_session::journal::{Journal, Key};
use indicatif::{ProgressBar, ProgressStyle};
use rayon::ThreadPoolBuilder;
use rayon::prelude::*;

use super::notes::Setup;
use super::record::{RECORD, Record};
use crate::analyze::{Heeded, hear};
use crate::failure::Failure;

/// So many results are at most lost when the power fails.
const SYNC_EVERY: usize = 50;

/// What came of a run.
pub(super) struct Done {
    /// The content of each recording that could be read, in their order; else why not.
    pub(super) contents: Vec<Result<Hash, String>>,
    /// How many results were there already.
    pub(super) kept: usize,
}

/// Hears every recording whose result is not in the journal yet.
///
/// Each result depends on the content of its recording and the settings alone, never on the order of
/// work, so it does not matter which thread comes when, or how often a run was interrupted.
pub(super) fn hear_all(
    recordings: &[Setup],
    journal: &Journal,
    jobs: Option<usize>,
) -> Result<Done, Failure> {
    let pool = ThreadPoolBuilder::new()
        .num_threads(jobs.map_or(0, |jobs| jobs.min(recordings.len())))
        .build()
        .map_err(|fault| Failure::Input(format!("cannot start the work: {fault}")))?;
    let bar = progress(recordings.len());
    let (kept, failed) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let appended = AtomicUsize::new(0);
    let one = |setup: &Setup| -> Result<Result<Hash, String>, Failure> {
        let content = match hash::hash_of_file(&setup.recording.path) {
            Ok(content) => content,
            Err(reason) => {
                failed.fetch_add(1, Ordering::Relaxed);
                bar.inc(1);
                return Ok(Err(reason.to_string()));
            }
        };
        let key = setup.key(content);
        let name = &setup.recording.name;
        if journal.has(name, &key) {
            kept.fetch_add(1, Ordering::Relaxed);
        } else {
            let record = record(setup, &key);
            if record.failure.is_some() || record.no_drop.is_some() {
                failed.fetch_add(1, Ordering::Relaxed);
            }
            journal.append(name, &key, &record)?;
            if appended.fetch_add(1, Ordering::Relaxed) % SYNC_EVERY == SYNC_EVERY - 1 {
                journal.sync()?;
            }
        }
        bar.set_message(match failed.load(Ordering::Relaxed) {
            0 => String::new(),
            count => format!(", {count} without a drop"),
        });
        bar.inc(1);
        Ok(Ok(content))
    };
    let contents = pool.install(|| {
        recordings
            .par_iter()
            .map(one)
            .collect::<Result<Vec<_>, _>>()
    });
    bar.finish_and_clear();
    let contents = contents?;
    journal.sync()?;
    Ok(Done {
        contents,
        kept: kept.into_inner(),
    })
}

/// A bar that hides itself when stderr is no terminal.
fn progress(recordings: usize) -> ProgressBar {
    let bar = ProgressBar::new(recordings as u64);
    if let Ok(style) = ProgressStyle::with_template(
        "hearing {wide_bar} {pos}/{len} recordings, {per_sec}, {eta} left{msg}",
    ) {
        bar.set_style(style);
    }
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}

impl Setup {
    /// What its result depends on: the sound, and the settings of this version.
    pub(super) fn key(&self, content: Hash) -> Key {
        let settings = &self.set_up.physics.settings;
        let text = format!("{RECORD} {} {settings:?}", env!("CARGO_PKG_VERSION"));
        Key {
            content,
            settings: hash::hash(text.as_bytes()),
        }
    }
}

fn record(setup: &Setup, key: &Key) -> Record {
    let heeded = Heeded {
        quiet: true,
        ..Heeded::default()
    };
    let mut settings = setup.set_up.physics.settings.clone();
    if let Some(inference) = &mut settings.inference {
        // Equal seeds would give the errors of sampling of all drops the same sign.
        inference.sampler.seed ^= key.content.number();
    }
    let path = &setup.recording.path;
    // Whatever goes wrong with one recording, the others go on.
    let heard = catch_unwind(AssertUnwindSafe(|| hear(path, &heeded, &settings)));
    match heard {
        Ok(Ok(hearing)) => Record::of(&hearing),
        Ok(Err(failure)) => Record::failed(failure.to_string()),
        Err(_) => Record::failed(format!(
            "{}: the program stumbled over it, which is a fault of the program; please report it",
            setup.recording.name
        )),
    }
}
