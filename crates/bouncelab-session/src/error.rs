//! Errors of a session.

use std::fmt;
use std::path::{Path, PathBuf};

use bouncelab::Plain;
use bouncelab_report::advice;
use bouncelab_report::groups::UnknownField;

use crate::name::shown;

/// Errors of reading recordings and notes, and of writing results.
///
/// Each message states the file, what is wrong with it and what to do.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// A file or folder cannot be read.
    #[error("cannot read {}: {source}", shown(path))]
    Read {
        /// The file or folder.
        path: PathBuf,
        /// The error of the operating system.
        source: std::io::Error,
    },
    /// An archive of recordings cannot be read, or holds too much.
    #[error("cannot read {}: {}", shown(path), Plain::of(problem))]
    Archive {
        /// The archive.
        path: PathBuf,
        /// What is wrong with it, and what to do.
        problem: String,
    },
    /// A file of notes is malformed.
    #[error("{}{}: {}", shown(path), AtPlace(*line, *column), Plain::of(problem))]
    Notes {
        /// The file.
        path: PathBuf,
        /// The line, counted from 1, if the problem is in one line.
        line: Option<usize>,
        /// The column, counted from 1, if it is known.
        column: Option<usize>,
        /// What is wrong, and what is expected.
        problem: String,
    },
    /// A pattern for file names is malformed.
    #[error(
        "the pattern \"{}\" {problem}; write it as in {{ball}}_{{surface}}_{{height}}_{{}}",
        Plain::of(pattern)
    )]
    Pattern {
        /// The pattern.
        pattern: String,
        /// What is wrong with it.
        problem: String,
    },
    /// Notes are missing, contradictory or implausible.
    #[error("{problem}")]
    Metadata {
        /// All problems, one on each line.
        problem: String,
    },
    /// There are no recordings.
    #[error(
        "{what}; name recordings, a folder that holds some, or a session.toml (a table with a waveform or times must be \
         named itself)"
    )]
    NoRecordings {
        /// The folders and files that were searched.
        what: String,
    },
    /// The folder for the results cannot be used.
    #[error("cannot write {}: {source}{}", shown(path), advice(source))]
    Output {
        /// The folder or file.
        path: PathBuf,
        /// The error of the operating system.
        source: std::io::Error,
    },
    /// Another run writes into the same folder.
    #[error(
        "another run writes into {}; wait for it, or name another folder",
        shown(path)
    )]
    Busy {
        /// The folder.
        path: PathBuf,
    },
    /// A recording has changed since the work began.
    #[error("the recording or its notes have changed meanwhile; run again")]
    Changed,
    /// The result of a recording is not in the journal.
    #[error("{name}: its result is lost; run again")]
    NoResult {
        /// The name of the recording.
        name: String,
    },
    /// The results of a cluster are malformed.
    #[error("{}: {}", shown(path), Plain::of(problem))]
    Rows {
        /// The file or folder.
        path: PathBuf,
        /// What is wrong, and what to do.
        problem: String,
    },
    /// A drop to be excluded does not exist.
    #[error("there is no drop \"{}\"", Plain::of(name))]
    UnknownDrop {
        /// The given name.
        name: String,
    },
    /// The field by which drops were to be grouped occurs in no notes.
    #[error("there are no metadata of \"{}\"", Plain::of(name))]
    UnknownField {
        /// The field.
        name: String,
        /// The fields that occur in notes.
        known: Vec<String>,
    },
    /// A table cannot be written.
    #[error("cannot write the table {}: {problem}", shown(path))]
    Table {
        /// The table.
        path: PathBuf,
        /// The error of the writer.
        problem: String,
    },
}

/// A result whose error is [`Error`].
pub type Result<T> = std::result::Result<T, Error>;

impl Error {
    pub(crate) fn read(path: &Path) -> impl FnOnce(std::io::Error) -> Self {
        let path = path.to_owned();
        |source| Self::Read { path, source }
    }

    pub(crate) fn rows(path: &Path, problem: impl fmt::Display) -> Self {
        Self::Rows {
            path: path.to_owned(),
            problem: problem.to_string(),
        }
    }

    pub(crate) fn output(path: &Path) -> impl FnOnce(std::io::Error) -> Self {
        let path = path.to_owned();
        |source| Self::Output { path, source }
    }

    pub(crate) fn notes(path: &Path, line: Option<usize>, problem: impl Into<String>) -> Self {
        Self::Notes {
            path: path.to_owned(),
            line,
            column: None,
            problem: problem.into(),
        }
    }
}

/// ", line 3, column 5", ", line 3" or nothing.
struct AtPlace(Option<usize>, Option<usize>);

impl fmt::Display for AtPlace {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.0, self.1) {
            (Some(line), Some(column)) => write!(f, ", line {line}, column {column}"),
            (Some(line), None) => write!(f, ", line {line}"),
            (None, _) => Ok(()),
        }
    }
}

impl From<UnknownField> for Error {
    fn from(UnknownField { name, known }: UnknownField) -> Self {
        Self::UnknownField { name, known }
    }
}
