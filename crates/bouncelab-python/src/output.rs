//! Files that people ask for: the gate of the command line, with the words of Python.

use std::io;
use std::path::{Path, PathBuf};

use bouncelab::Plain;
use bouncelab_report::file::Outputs;
use bouncelab_report::mark::{self, Mark};
use bouncelab_session::table::Form;
use pyo3::prelude::*;

use crate::failure::{Failure, Result};

/// Writes a file whole. It replaces another file only if that is no input, and bouncelab wrote it or `force` is given.
/// The form determines the mark by which a file of bouncelab is recognised.
#[pyfunction]
pub(crate) fn write_file(
    py: Python<'_>,
    path: PathBuf,
    form: &str,
    content: &[u8],
    inputs: Vec<PathBuf>,
    force: bool,
) -> Result<()> {
    py.detach(|| write(&path, mark_of(form), content, &inputs, force))
}

pub(crate) fn write(
    path: &Path,
    mark: Mark,
    content: &[u8],
    inputs: &[PathBuf],
    force: bool,
) -> Result<()> {
    let written = outputs(inputs, force).write(path, mark, content);
    written.map_err(|reason| unwritable(path, &reason))
}

fn mark_of(form: &str) -> Mark {
    let tables = Form::ALL.map(|form| (form.ending(), form.mark()));
    let mut marks = mark::FIGURES.into_iter().chain(tables);
    let found = marks.find(|(ending, _)| *ending == form);
    found.map_or(Mark::NONE, |(_, mark)| mark)
}

/// The gate of a function that reads these files.
pub(crate) fn outputs(inputs: &[PathBuf], force: bool) -> Outputs {
    Outputs::new(inputs, force).asked_with("force=True")
}

pub(crate) fn unwritable(path: &Path, reason: &io::Error) -> Failure {
    Failure::Output(format!(
        "{}: {reason}; choose another place",
        Plain::path(path)
    ))
}
