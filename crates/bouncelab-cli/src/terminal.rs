//! Output: the only place that writes to stdout and stderr.
//!
//! `print!` and `eprintln!` panic when the reader has gone or the disk is full. Here a message that cannot be written is
//! left out, and a result that cannot be written is a failure of the command.

use std::fmt::Display;
use std::io::{self, BufWriter, Write};

use bouncelab::Plain;
use serde::Serialize;

use crate::failure::Failure;

/// Prints a message on stderr, if it can be written.
pub(crate) fn say(line: impl Display) {
    let line = Plain::lines(&line.to_string());
    let _ = writeln!(io::stderr().lock(), "{line}");
}

/// Prints a result for people on stdout, and flushes it.
pub(crate) fn print(result: impl Display) -> Result<(), Failure> {
    print_data(Plain::lines(&result.to_string()))
}

/// Prints a result for programs, as it is.
pub(crate) fn print_data(result: impl Display) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    write!(out, "{result}")?;
    Ok(out.flush()?)
}

/// Prints a result on stdout as JSON of several lines.
pub(crate) fn print_json(document: &impl Serialize) -> Result<(), Failure> {
    streamed(|out| serde_json::to_writer_pretty(out, document))
}

/// Prints a result on stdout as JSON of one line.
pub(crate) fn print_json_line(document: &impl Serialize) -> Result<(), Failure> {
    streamed(|out| serde_json::to_writer(out, document))
}

/// Prints JSON while it is made: that of a thousand drops would take 90 MB.
fn streamed(
    write: impl FnOnce(&mut BufWriter<io::StdoutLock>) -> serde_json::Result<()>,
) -> Result<(), Failure> {
    let mut out = BufWriter::new(io::stdout().lock());
    write(&mut out).map_err(io::Error::from)?;
    writeln!(out)?;
    Ok(out.flush()?)
}
