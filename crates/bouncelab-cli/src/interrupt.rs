//! Ctrl-C and the termination signals: no unfinished file remains, and a recording ends in order.

use std::process;
use std::sync::atomic::{AtomicBool, Ordering};

use bouncelab_report::file::abandon_drafts;

use crate::failure::Failure;

/// Whether the first signal only requests the end.
static ONLY_ASKS: AtomicBool = AtomicBool::new(false);
/// Whether a signal requested the end.
static REQUESTED: AtomicBool = AtomicBool::new(false);

/// From now on a signal removes unfinished files before it ends the program.
pub(crate) fn watch() -> Result<(), Failure> {
    /// The exit status that shells report for a program ended by Ctrl-C.
    const INTERRUPTED: i32 = 130;
    #[cfg(target_os = "linux")]
    hold_back()?;
    ctrlc::set_handler(|| {
        let asked_before = REQUESTED.swap(true, Ordering::Relaxed);
        if asked_before || !ONLY_ASKS.load(Ordering::Relaxed) {
            abandon_drafts();
            process::exit(INTERRUPTED);
        }
    })
    .map_err(|reason| Failure::Input(format!("cannot wait for Ctrl-C: {reason}")))
}

/// Keeps from this thread and those that it starts the signal of a file that may not grow further, of which writing then
/// reports the reason, and a hangup that is to be ignored, which would count as any other signal.
#[cfg(target_os = "linux")]
fn hold_back() -> Result<(), Failure> {
    use nix::sys::signal::{SigSet, Signal};

    let mut held = SigSet::empty();
    held.add(Signal::SIGXFSZ);
    if hangup_is_ignored() {
        held.add(Signal::SIGHUP);
    }
    held.thread_block()
        .map_err(|reason| Failure::Input(format!("cannot hold signals back: {reason}")))
}

/// Whether the program is to continue when its terminal is closed, as by `nohup`.
#[cfg(target_os = "linux")]
fn hangup_is_ignored() -> bool {
    let Ok(status) = std::fs::read_to_string("/proc/self/status") else {
        return false;
    };
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let ignored = ignored.and_then(|digits| u64::from_str_radix(digits.trim(), 16).ok());
    // A hangup is signal 1, the lowest bit.
    ignored.is_some_and(|signals| signals & 1 != 0)
}

/// Whether the program is to end.
pub(crate) struct Stop(&'static AtomicBool);

impl Stop {
    /// From now on the first signal only requests the end; the second ends the program at once.
    pub(crate) fn on_request() -> Self {
        ONLY_ASKS.store(true, Ordering::Relaxed);
        Self(&REQUESTED)
    }

    pub(crate) fn requested(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}
