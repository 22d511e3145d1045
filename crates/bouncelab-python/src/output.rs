//! Files that people ask for: the gate of the command line, with the words of Python.

use std::io;
use std::path::{Path, PathBuf};

use bouncelab::Plain;
use bouncelab_report::file::Outputs;
use bouncelab_report::mark;
use bouncelab_session::table::Form;
use pyo3::prelude::*;

use crate::failure::{Failure, Result};

/// Recordings are never replaced unasked.
pub(crate) const NO_MARK: &str = "";

/// Writes a file whole, in the place of another only if that is none of the inputs, and bouncelab wrote it or
/// `force` asks for it. The form says by which mark the files of bouncelab are known.
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
    mark: &str,
    content: &[u8],
    inputs: &[PathBuf],
    force: bool,
) -> Result<()> {
    let written = Outputs::new(inputs, force).write(path, mark, content);
    written.map_err(|reason| Failure::Output(refusal(path, &reason)))
}

fn mark_of(form: &str) -> &'static str {
    match form {
        "svg" => mark::SVG,
        "png" => mark::PNG,
        "pdf" => mark::PDF,
        "parquet" => Form::Parquet.mark(),
        _ => NO_MARK,
    }
}

/// What the gate says names the option of the command line.
pub(crate) fn refusal(path: &Path, reason: &io::Error) -> String {
    let reason = reason.to_string().replace("--force", "force=True");
    format!("{}: {reason}; choose another place", Plain::path(path))
}
