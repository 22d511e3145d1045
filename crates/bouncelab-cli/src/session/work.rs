//! The analysis of many recordings, in parallel, once each.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Duration;

use bouncelab_session::journal::Journal;
use bouncelab_session::{Done, KnownRecording, complete};
use indicatif::{ProgressBar, ProgressStyle};
use rayon::ThreadPoolBuilder;
use rayon::prelude::*;

use super::worker::{Request, Trouble, Workers};
use crate::failure::Failure;
use crate::language::text_with;

/// Analyses every recording whose result is not in the journal yet.
pub(super) fn analyze_all(
    recordings: &[KnownRecording],
    journal: &Journal,
    jobs: Option<usize>,
    time_limit_s: u64,
) -> Result<Vec<Done>, Failure> {
    let pool = ThreadPoolBuilder::new()
        .num_threads(jobs.map_or(0, |jobs| jobs.min(recordings.len())))
        .build()
        .map_err(|fault| Failure::Input(format!("cannot start the work: {fault}")))?;
    let bar = progress(recordings.len());
    let without_drop = AtomicUsize::new(0);
    let workers = Workers::default();
    // The outcome of a recording, or how its process ended.
    let analyze = |index: usize| -> Result<Result<Done, String>, Failure> {
        let name = recordings[index].name().to_owned();
        let answer = |key| workers.record(&Request { name, key });
        match complete(&recordings[index], journal, answer) {
            Ok(done) => Ok(Ok(done)),
            Err(Trouble::OutOfTime) => {
                let limit = [("seconds", time_limit_s.into())];
                Ok(Ok(Done::failed(text_with("session-out-of-time", &limit))))
            }
            Err(Trouble::Died(how)) => Ok(Err(how)),
            Err(Trouble::Session(failure)) => Err(failure),
        }
    };
    let one = |index: usize| {
        let Ok(done) = analyze(index)? else {
            return Ok(None);
        };
        let without = usize::from(done.without_drop);
        let without = without_drop.fetch_add(without, Ordering::Relaxed) + without;
        if without > 0 {
            bar.set_message(format!(", {without} without a drop"));
        }
        bar.inc(1);
        Ok(Some(done))
    };
    let places = (0..recordings.len()).into_par_iter();
    let first: Result<Vec<Option<Done>>, Failure> = pool.install(|| places.map(one).collect());
    // A recording that ended its worker is tried once more, alone: all together may have been short of memory.
    let again = |(index, done): (usize, Option<Done>)| match done {
        Some(done) => Ok(done),
        None => analyze(index).map(|done| {
            done.unwrap_or_else(|how| {
                Done::failed(text_with("session-died", &[("how", how.into())]))
            })
        }),
    };
    let done = first.and_then(|first| first.into_iter().enumerate().map(again).collect());
    bar.finish_and_clear();
    journal.sync()?;
    done
}

/// A bar that hides itself when stderr is no terminal.
fn progress(recordings: usize) -> ProgressBar {
    let bar = ProgressBar::new(recordings as u64);
    let places = [
        ("bar", "{wide_bar}".into()),
        ("done", "{pos}/{len}".into()),
        ("rate", "{per_sec}".into()),
        ("left", "{eta}".into()),
    ];
    let template = text_with("session-progress", &places) + "{msg}";
    if let Ok(style) = ProgressStyle::with_template(&template) {
        bar.set_style(style);
    }
    bar.enable_steady_tick(Duration::from_millis(200));
    bar
}
