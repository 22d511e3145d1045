//! Shall the work go on?

use std::panic::resume_unwind;
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

use pyo3::prelude::*;

use crate::failure::Result;

/// Looks from time to time whether somebody wants the work to end, and says how far it is.
pub(crate) struct Watch {
    report: Option<Py<PyAny>>,
    last: Instant,
}

/// Far below what a person waits for, and far above what a look takes.
const PERIOD: Duration = Duration::from_millis(50);

impl Watch {
    /// `report` is called with the name of the work, how much of it is done, and of how much.
    pub(crate) fn new(report: Option<Py<PyAny>>) -> Self {
        Self {
            report,
            last: Instant::now(),
        }
    }

    /// Goes on, unless an interruption or an exception of `report` ends the work.
    pub(crate) fn look(&mut self, work: &str, done: f64, whole: Option<f64>) -> Result<()> {
        if self.last.elapsed() < PERIOD {
            return Ok(());
        }
        self.last = Instant::now();
        Python::attach(|py| {
            py.check_signals()?;
            if let Some(report) = &self.report {
                report.call1(py, (work, done, whole))?;
            }
            Ok(())
        })
    }
}

/// Does work that has no steps between which to look, without the lock of the interpreter. An interruption does not wait
/// for it: the thread that does it touches nothing of Python, and ends by itself.
pub(crate) fn interruptible<T: Send + 'static>(
    work: impl FnOnce() -> T + Send + 'static,
) -> Result<T> {
    let (sender, result) = mpsc::channel();
    let thread = thread::spawn(move || {
        // Nobody takes the result of work that was interrupted.
        sender.send(work()).ok();
    });
    loop {
        match result.recv_timeout(PERIOD) {
            Ok(done) => return Ok(done),
            Err(RecvTimeoutError::Timeout) => {
                Python::attach(|py| {
                    py.check_signals()?;
                    PyResult::Ok(())
                })?;
            }
            Err(RecvTimeoutError::Disconnected) => match thread.join() {
                Err(panic) => resume_unwind(panic),
                Ok(()) => unreachable!("a thread that ends sends its result or panics"),
            },
        }
    }
}
