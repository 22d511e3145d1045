//! The analysis of many recordings, in parallel, once each.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

use bouncelab_session::journal::Journal;
use bouncelab_session::{Done, KnownRecording, complete};
use indicatif::{ProgressBar, ProgressStyle};
use rayon::ThreadPoolBuilder;
use rayon::prelude::*;

use crate::failure::Failure;

/// Analyses every recording whose result is not in the journal yet.
pub(super) fn analyze_all(
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
        let done = complete(recording, journal)?;
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
        "analysing {wide_bar} {pos}/{len} recordings, {per_sec}, {eta} left{msg}",
    ) {
        bar.set_style(style);
    }
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}
