use std::path::Path;
use std::sync::Arc;

use crate::error::Result;
use crate::source::Source;
use crate::times;

/// What a file holds: a recording, or times that something else found in one.
#[derive(Debug)]
pub enum Input {
    /// A recording, opened.
    Sound(Box<Source>),
    /// Impact times in seconds, strictly increasing.
    Times(Vec<f64>),
}

impl Input {
    /// Opens a file: as a list of times if its name ends in `.txt`, `.csv` or `.json`, otherwise
    /// as sound, whose format is found from the content.
    ///
    /// # Errors
    ///
    /// Those of [`times::read`] and [`Source::open`].
    pub fn open(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        if times::is_list(&path.to_string_lossy()) {
            return times::read(path).map(Self::Times);
        }
        Source::open(path).map(|source| Self::Sound(Box::new(source)))
    }

    /// As [`Input::open`], for content in memory.
    ///
    /// # Errors
    ///
    /// Those of [`times::parse`] and [`Source::from_bytes`].
    pub fn from_bytes(bytes: impl Into<Arc<[u8]>>, name: &str) -> Result<Self> {
        let bytes = bytes.into();
        if times::is_list(name) {
            return times::parse(&bytes, name).map(Self::Times);
        }
        Source::from_bytes(bytes, name).map(|source| Self::Sound(Box::new(source)))
    }
}
