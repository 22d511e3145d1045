//! Hearing many recordings, side by side, once each.

use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

use bouncelab_session::journal::{self, Journal, Key};
use indicatif::{ProgressBar, ProgressStyle};
use rayon::ThreadPoolBuilder;
use rayon::prelude::*;

use super::notes::Understood;
use super::record::{RECORD, Record};
use crate::analyze::{Heeded, hear};
use crate::failure::Failure;

/// So many results are at most lost when the power fails.
const SYNC_EVERY: usize = 50;

/// What came of a run.
pub(super) struct Done {
    /// The key of each recording whose content could be read, in their order; else why not.
    pub(super) keys: Vec<Result<Key, String>>,
    /// How many results were there already.
    pub(super) kept: usize,
}

/// Hears every recording whose result is not in the journal yet.
///
/// Each result depends on the content of its recording and the settings alone, never on the order of
/// work, so it does not matter which thread comes when, or how often a run was interrupted.
pub(super) fn hear_all(
    recordings: &[Understood],
    journal: &Journal,
    jobs: Option<usize>,
) -> Result<Done, Failure> {
    let pool = ThreadPoolBuilder::new()
        .num_threads(jobs.unwrap_or(0))
        .build()
        .map_err(|fault| Failure::Input(format!("cannot start the work: {fault}")))?;
    let bar = progress(recordings.len());
    let (kept, failed) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let appended = AtomicUsize::new(0);
    let one = |understood: &Understood| -> Result<Result<Key, String>, Failure> {
        let key = match key(understood) {
            Ok(key) => key,
            Err(reason) => {
                failed.fetch_add(1, Ordering::Relaxed);
                bar.inc(1);
                return Ok(Err(reason));
            }
        };
        let name = &understood.recording.name;
        if journal.has(name, &key) {
            kept.fetch_add(1, Ordering::Relaxed);
        } else {
            let record = record(understood, &key);
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
        Ok(Ok(key))
    };
    let keys = pool.install(|| {
        recordings
            .par_iter()
            .map(one)
            .collect::<Result<Vec<_>, _>>()
    });
    bar.finish_and_clear();
    let keys = keys?;
    journal.sync()?;
    Ok(Done {
        keys,
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

fn key(understood: &Understood) -> Result<Key, String> {
    let content = journal::hash_of_file(&understood.recording.path);
    Ok(Key {
        content: content.map_err(|fault| fault.to_string())?,
        settings: settings(understood),
    })
}

/// Hash of everything besides the sound that a result depends on.
fn settings(understood: &Understood) -> String {
    let settings = &understood.physics.settings;
    let text = format!("{RECORD} {} {settings:?}", env!("CARGO_PKG_VERSION"));
    journal::hash(text.as_bytes())
}

fn record(understood: &Understood, key: &Key) -> Record {
    let heeded = Heeded {
        quiet: true,
        ..Heeded::default()
    };
    let mut settings = understood.physics.settings.clone();
    if let Some(question) = &mut settings.question {
        // Equal seeds would give the errors of sampling of all drops the same sign.
        question.effort.seed ^= seed(&key.content);
    }
    let path = &understood.recording.path;
    // Whatever goes wrong with one recording, the others go on.
    let heard = catch_unwind(AssertUnwindSafe(|| hear(path, &heeded, &settings)));
    match heard {
        Ok(Ok(hearing)) => Record::of(&hearing),
        Ok(Err(failure)) => Record::failed(failure.to_string()),
        Err(_) => Record::failed(format!(
            "{}: the program stumbled over it, which is a fault of the program; please report it",
            understood.recording.name
        )),
    }
}

/// The first 64 bits of a hash in hexadecimal digits.
fn seed(hash: &str) -> u64 {
    hash.get(..16)
        .and_then(|digits| u64::from_str_radix(digits, 16).ok())
        .unwrap_or(0)
}

/// For each recording the first with the same content, if it is another.
pub(super) fn duplicates(recordings: &[Understood], done: &Done) -> Vec<Option<String>> {
    let mut first: BTreeMap<&str, &str> = BTreeMap::new();
    recordings
        .iter()
        .zip(&done.keys)
        .map(|(understood, key)| {
            let key = key.as_ref().ok()?;
            let name = understood.recording.name.as_str();
            let known = *first.entry(&key.content).or_insert(name);
            (known != name).then(|| known.to_owned())
        })
        .collect()
}
