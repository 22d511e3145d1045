//! Work on many recordings.

use crate::error::Result;
use crate::hash::{Hash, hash_of_file};
use crate::journal::Journal;
use crate::metadata::KnownRecording;
use crate::record::Record;

/// What came of the work on one recording.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Done {
    /// Its content, or why it cannot be read.
    pub content: std::result::Result<Hash, String>,
    /// Whether its result was in the journal already.
    pub kept: bool,
    /// Whether it could not be read, or was analysed now and holds no drop.
    pub without_drop: bool,
}

/// Makes sure that the journal has the result of a recording: the one that is there already, if
/// content and settings are the same, else a new one.
///
/// Each result depends on the content of its recording and the settings alone, never on the order of
/// work, so any number of threads may do this side by side, and a run that was interrupted goes on
/// where it was.
///
/// # Errors
/// [`Error::Output`](crate::Error::Output) if the journal cannot be written.
pub fn complete(recording: &KnownRecording, journal: &Journal) -> Result<Done> {
    let path = &recording.recording.path;
    let content = match hash_of_file(path) {
        Ok(content) => content,
        Err(reason) => {
            return Ok(Done {
                content: Err(reason.to_string()),
                kept: false,
                without_drop: true,
            });
        }
    };
    let (name, key) = (recording.name(), recording.key(content));
    let kept = journal.has(name, &key);
    let mut without_drop = false;
    if !kept {
        let record = Record::of_file(path, content, recording.options());
        without_drop = record.drops.is_empty();
        journal.append(name, &key, &record)?;
    }
    Ok(Done {
        content: Ok(content),
        kept,
        without_drop,
    })
}
