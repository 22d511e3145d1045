//! Stops on Ctrl-C or a termination signal.

use std::process;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::failure::Failure;

/// Whether somebody wants the program to end.
pub(super) struct Stop(Arc<AtomicBool>);

impl Stop {
    /// From now on the first Ctrl-C only asks; the second ends the program at once.
    pub(super) fn on_request() -> Result<Self, Failure> {
        /// What shells report of a program that ended by Ctrl-C.
        const INTERRUPTED: i32 = 130;
        let requested = Arc::new(AtomicBool::new(false));
        let flag = Arc::clone(&requested);
        ctrlc::set_handler(move || {
            if flag.swap(true, Ordering::Relaxed) {
                process::exit(INTERRUPTED);
            }
        })
        .map_err(|reason| Failure::Input(format!("cannot wait for Ctrl-C: {reason}")))?;
        Ok(Self(requested))
    }

    pub(super) fn requested(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}
