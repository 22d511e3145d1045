//! Work on one recording.

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
    /// Whether it was analysed now, and holds no drop.
    pub without_drop: bool,
}

/// Makes sure that the journal has the result of a recording: the one that is there already, if
/// recording and settings are the same, else what `analyze` makes of the content with this hash.
///
/// Each result depends on the content of its recording and the settings alone, never on the order of
/// work, so any number of threads may do this side by side, and a run that was interrupted goes on
/// where it was.
///
/// # Errors
/// [`Error::Output`](crate::Error::Output) if the journal cannot be written.
pub fn complete(
    recording: &KnownRecording,
    journal: &Journal,
    analyze: impl FnOnce(Hash) -> Record,
) -> Result<Done> {
    let mut done = Done {
        content: hash_of_file(&recording.recording.path).map_err(|reason| reason.to_string()),
        kept: false,
        without_drop: true,
    };
    if let Ok(content) = done.content {
        let (name, key) = (recording.name(), recording.key(content));
        done.kept = journal.has(name, &key);
        done.without_drop = false;
        if !done.kept {
            let record = analyze(content);
            done.without_drop = record.drops.is_empty();
            journal.append(name, &key, &record)?;
        }
    }
    Ok(done)
}
