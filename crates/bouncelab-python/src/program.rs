//! How is the program run in this process?

use std::ffi::OsString;

use bouncelab_cli::Invocation;
use pyo3::prelude::*;

/// Runs the program `bouncelab` to its end and returns its exit status; for a process of its own, once.
///
/// `program` is the command that starts it again, and `arguments` what it gets.
#[pyfunction]
pub(crate) fn run_program(py: Python<'_>, program: Vec<OsString>, arguments: Vec<OsString>) -> u8 {
    py.detach(|| bouncelab_cli::run(Invocation { program, arguments }))
}
