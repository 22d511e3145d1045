//! Errors of drawing, saving and reading rules.

use bouncelab::Plain;
use std::path::PathBuf;

/// What can go wrong when results are drawn, saved and evaluated.
///
/// Drawing itself never fails: a figure without usable data states so itself.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The physics refuses.
    #[error(transparent)]
    Physics(#[from] bouncelab::Error),
    /// The picture asked for is too small to read or too large to hold in memory.
    #[error(
        "a picture cannot be {width_px} pixels wide: give a width from {} to {}",
        crate::render::MIN_WIDTH_PX,
        crate::render::MAX_WIDTH_PX
    )]
    PictureWidth {
        /// The width asked for, in pixels.
        width_px: u32,
    },
    /// The drawing library could not make the picture.
    #[error("cannot turn the figure '{title}' into a PNG picture: {problem}")]
    Picture {
        /// Title of the figure.
        title: String,
        /// The message of the drawing library.
        problem: String,
    },
    /// A file of rules cannot be opened.
    #[error("cannot read the rules {file}: {source}; check the name")]
    Unreadable {
        /// The file.
        file: String,
        /// The message of the operating system.
        source: std::io::Error,
    },
    /// A file of rules is invalid.
    #[error("{file}, line {line}, column {column}: {}", Plain::of(problem))]
    Rules {
        /// The file, or what the rules are called.
        file: String,
        /// Line, counted from 1.
        line: usize,
        /// Column in letters, counted from 1.
        column: usize,
        /// What is wrong.
        problem: String,
    },
    /// The name is not a plain file name.
    #[error(
        "'{name}' cannot name a figure: use letters, digits, '-', '_' and '.', and do not start with '.'"
    )]
    Name {
        /// The name given.
        name: String,
    },
    /// The folder for the figures cannot be used.
    #[error(
        "cannot use '{}' as a folder for figures: {source}; choose another folder",
        Plain::path(folder)
    )]
    Folder {
        /// The folder.
        folder: PathBuf,
        /// The message of the operating system.
        source: std::io::Error,
    },
    /// A figure could not be written.
    #[error(
        "cannot write the figure '{}': {source}{}",
        Plain::path(path),
        advice(source)
    )]
    Write {
        /// The file that was to be written.
        path: PathBuf,
        /// The message of the operating system.
        source: std::io::Error,
    },
}

/// What to do about a file that the system does not let us write; nothing if the reason states it.
pub fn advice(reason: &std::io::Error) -> &'static str {
    use std::io::ErrorKind;
    match reason.kind() {
        ErrorKind::AlreadyExists | ErrorKind::InvalidInput | ErrorKind::IsADirectory => "",
        _ => "; does its folder exist, is it writable, and the disk not full?",
    }
}

/// A result whose error is [`Error`].
pub type Result<T> = std::result::Result<T, Error>;
