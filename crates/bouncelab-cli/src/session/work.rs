//! Hearing many recordings, side by side, once each.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

use bouncelab_report::document::Origin;
use bouncelab_session::hash::Hash;
use bouncelab_session::journal::Journal;
use bouncelab_session::record::{DropRecord, Record};
use bouncelab_session::{Done, KnownRecording, complete};
use indicatif::{ProgressBar, ProgressStyle};
use rayon::ThreadPoolBuilder;
use rayon::prelude::*;

use crate::analyze::{Heeded, hear};
use crate::failure::Failure;

/// Hears every recording whose result is not in the journal yet.
pub(super) fn hear_all(
    recordings: &[KnownRecording],
    journal: &Journal,
    jobs: Option<usize>,
) -> Result<Vec<Done>, Failure> {
    let pool = ThreadPoolBuilder::new()
        .num_threads(jobs.map_or(0, |jobs| jobs.min(recordings.len())))
        .build()
        .map_err(|fault| Failure::Input(format!("cannot start the work: {fault}")))?;
    let bar = progress(recordings.len());
    let without_drop = AtomicUsize::new(0);
    let one = |recording: &KnownRecording| {
        let done = complete(recording, journal, |content| record(recording, content))?;
        let without = usize::from(done.without_drop);
        let without = without_drop.fetch_add(without, Ordering::Relaxed) + without;
        if without > 0 {
            bar.set_message(format!(", {without} without a drop"));
        }
        bar.inc(1);
        Ok::<Done, Failure>(done)
    };
    let done = pool.install(|| recordings.par_iter().map(one).collect());
    bar.finish_and_clear();
    journal.sync()?;
    done
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

fn record(recording: &KnownRecording, content: Hash) -> Record {
    let heeded = Heeded {
        quiet: true,
        ..Heeded::default()
    };
    let mut settings = recording.metadata.setup.settings.clone();
    if let Some(inference) = &mut settings.inference {
        // Equal seeds would give the errors of sampling of all drops the same sign.
        inference.sampler.seed ^= content.number();
    }
    let path = &recording.recording.path;
    // Whatever goes wrong with one recording, the others go on.
    let heard = catch_unwind(AssertUnwindSafe(|| hear(path, &heeded, &settings)));
    match heard {
        Ok(Ok(hearing)) => Record {
            duration_s: match hearing.origin {
                Origin::Sound { duration_s, .. } => Some(duration_s),
                Origin::Times => None,
            },
            drops: std::iter::zip(&hearing.drops, &hearing.probabilities)
                .map(|(drop, &probability)| DropRecord::of(drop, probability))
                .collect(),
            no_drop: hearing.no_drop,
            failure: None,
            warnings: hearing.warnings,
        },
        Ok(Err(failure)) => Record::failed(failure.to_string()),
        Err(_) => Record::failed(format!(
            "{}: the program stumbled over it, which is a fault of the program; please report it",
            recording.name()
        )),
    }
}
