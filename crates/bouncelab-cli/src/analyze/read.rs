//! Reads and analyses a file.

use std::io::{self, Read};
use std::iter;
use std::path::Path;
use std::time::Duration;

use bouncelab::analysis::{DropTask, Plan};
use bouncelab::diagnostic::{Code, Diagnostic};
use bouncelab::{Options, Plain, Recording};
use bouncelab_audio::Input;
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;

use crate::failure::Failure;
use crate::language::{text, text_with, translator};

/// A file and its result.
pub(crate) struct Analysed {
    /// The name of the file as given.
    pub(crate) name: String,
    /// Its result, with the sentences of all diagnostics.
    pub(crate) result: Recording,
}

/// Reads a file and analyses every drop in it; `quiet` shows no progress, which the caller does.
pub(crate) fn read(file: &Path, options: &Options, quiet: bool) -> Result<Analysed, Failure> {
    let name = String::from(Plain::path(file));
    let input = if is_standard_input(file) {
        standard_input()?
    } else {
        Input::open(file)?
    };
    let progress = progress(input.duration_s().filter(|_| !quiet));
    let plan = input.plan(options, |seconds| {
        progress.set_position(seconds as u64);
        Ok(())
    });
    progress.finish_and_clear();
    let plan = plan.map_err(|failure| match failure {
        Failure::Usage(reason) => Failure::Usage(format!("{name}: {reason}")),
        other => other,
    })?;
    Ok(Analysed::new(name, run(plan, options)))
}

/// Whether a file stands for standard input.
pub(crate) fn is_standard_input(file: &Path) -> bool {
    file == Path::new("-")
}

/// Standard input to its end: a list of times if it begins as text, else sound.
fn standard_input() -> Result<Input, Failure> {
    /// Maximum length, which is held in memory: an hour and a half of stereo at 48 kHz and 16 bits.
    const MAX_BYTES: u64 = 1 << 30;
    /// How much of it shows whether it is text, unless it begins as UTF-16 does.
    const BEGINNING: usize = 1024;
    let mut bytes = Vec::new();
    io::stdin()
        .lock()
        .take(MAX_BYTES + 1)
        .read_to_end(&mut bytes)
        .map_err(|reason| Failure::Input(format!("cannot read standard input: {reason}")))?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(Failure::Input(text("analyze-input-too-long")));
    }
    let is_control = |byte: &u8| byte.is_ascii_control() && !byte.is_ascii_whitespace();
    let is_wide = bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]);
    let is_text = is_wide || !bytes.iter().take(BEGINNING).any(is_control);
    let name = if is_text { "stdin.txt" } else { "stdin" };
    Ok(Input::from_bytes(bytes, name)?)
}

impl Analysed {
    /// The result with the sentences of all diagnostics.
    pub(crate) fn new(name: String, mut result: Recording) -> Self {
        translator().complete(&mut result);
        Self { name, result }
    }

    /// Why there is no drop, and what may be one, a line each; `None` if there is one.
    pub(crate) fn no_drop(&self) -> Option<String> {
        let reason = translator().diagnostic(self.result.no_drop.as_ref()?);
        let why = [
            ("name", self.name.as_str().into()),
            ("reason", reason.into()),
        ];
        let offers = |it: &&Diagnostic| matches!(it.code, Code::PossibleDrop | Code::NoCandidate);
        let offers = self.result.diagnostics.iter().filter(offers);
        let lines = iter::once(text_with("analyze-no-drop", &why))
            .chain(offers.map(|offer| format!("  {}", translator().diagnostic(offer))));
        Some(lines.collect::<Vec<_>>().join("\n"))
    }
}

/// Analyses drops, in parallel unless the caller already reads recordings in parallel.
fn run(plan: Plan, options: &Options) -> Recording {
    if rayon::current_thread_index().is_some() {
        return plan.run();
    }
    let waiting = inferring(&plan, options);
    let drops = plan.tasks().par_iter().map(DropTask::run).collect();
    waiting.finish_and_clear();
    plan.finish(drops)
}

/// A bar for recordings long enough to wait for; it hides itself when stderr is no terminal.
fn progress(duration_s: Option<f64>) -> ProgressBar {
    const LONG_S: f64 = 300.0;
    let Some(duration_s) = duration_s.filter(|&duration_s| duration_s > LONG_S) else {
        return ProgressBar::hidden();
    };
    let bar = ProgressBar::new(duration_s as u64);
    let places = [
        ("bar", "{wide_bar}".into()),
        ("done", "{pos}/{len}".into()),
        ("left", "{eta}".into()),
    ];
    if let Ok(style) = ProgressStyle::with_template(&text_with("analyze-detecting", &places)) {
        bar.set_style(style);
    }
    bar.enable_steady_tick(TICK);
    bar
}

/// A spinner during an inference from many impacts, which takes seconds; it hides itself as the bar does.
fn inferring(plan: &Plan, options: &Options) -> ProgressBar {
    /// About two milliseconds each.
    const MANY: usize = 1000;
    let impacts: usize = plan.tasks().iter().map(|task| task.impacts().len()).sum();
    if options.inference.is_none() || impacts < MANY {
        return ProgressBar::hidden();
    }
    let spinner = ProgressBar::new_spinner();
    let impacts = [("impacts", impacts.into())];
    spinner.set_message(text_with("analyze-inferring", &impacts));
    spinner.enable_steady_tick(TICK);
    spinner
}

/// Interval of updates of the progress.
const TICK: Duration = Duration::from_millis(200);
