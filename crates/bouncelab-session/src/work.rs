//! Work on many recordings.

use crate::error::Error;
use crate::hash::{Hash, hash_of_file};
use crate::journal::{Journal, Key};
use crate::metadata::KnownRecording;
use crate::record::Record;

/// What came of the work on one recording.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Done {
    /// Its content, or why it cannot be read or analysed.
    pub content: std::result::Result<Hash, String>,
    /// Whether its result was in the journal already.
    pub kept: bool,
    /// Whether it could not be read, or was analysed now and holds no drop.
    pub without_drop: bool,
}

/// Makes sure that the journal has the result of a recording: the one that is there already, if
/// content and settings are the same, else a new one, which `analyze` makes of the recording with the
/// content of this key ([`KnownRecording::record`], here or in another process).
///
/// Each result depends on the content of its recording and the settings alone, never on the order of
/// work, so any number of threads may do this side by side, and a run that was interrupted goes on
/// where it was.
///
/// # Errors
/// [`Error::Output`] if the journal cannot be written, and those of `analyze`.
pub fn complete<E: From<Error>>(
    recording: &KnownRecording,
    journal: &Journal,
    analyze: impl FnOnce(Key) -> std::result::Result<Record, E>,
) -> std::result::Result<Done, E> {
    let content = match hash_of_file(&recording.recording.path) {
        Ok(content) => content,
        Err(reason) => return Ok(Done::failed(reason.to_string())),
    };
    let (name, key) = (recording.name(), recording.key(content));
    let kept = journal.has(name, &key);
    let mut without_drop = false;
    if !kept {
        let record = analyze(key)?;
        without_drop = record.drops.is_empty();
        journal.append(name, &key, &record)?;
    }
    Ok(Done {
        content: Ok(content),
        kept,
        without_drop,
    })
}

impl Done {
    /// Nothing came of it, for this reason.
    pub fn failed(reason: String) -> Self {
        Self {
            content: Err(reason),
            kept: false,
            without_drop: true,
        }
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;
    use std::fs;
    use std::sync::Arc;

    use bouncelab::setup::Settings;

    use super::*;
    use crate::hash::{hash, hash_of};
    use crate::metadata::{BUILD, Metadata};
    use crate::record::RECORD;
    use crate::recordings::Recording;

    #[test]
    fn no_result_of_another_build_is_used() {
        const TIMES: &[u8] = b"0\n0.4605\n0.8877\n1.2854\n";
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("drop.txt");
        fs::write(&path, TIMES).unwrap();
        let recording = KnownRecording {
            recording: Recording {
                path,
                name: "drop.txt".to_owned(),
            },
            metadata: Arc::new(Metadata {
                setup: Settings::default().resolve(false).unwrap(),
                factors: BTreeMap::new(),
                height_m: None,
                temperature_k: None,
            }),
        };
        let journal = Journal::open(&folder.path().join("results")).unwrap();
        for part in 0..BUILD.len() {
            let mut build = BUILD;
            build[part] = "another";
            let key = Key {
                content: hash(TIMES),
                settings: hash_of(&(RECORD, build, recording.options())),
            };
            let other = Record::failed("of another build".to_owned());
            journal.append("drop.txt", &key, &other).unwrap();
        }
        let done = || {
            complete(&recording, &journal, |key| {
                Ok::<_, Error>(recording.record(key.content))
            })
        };
        assert!(!done().unwrap().kept);
        assert!(done().unwrap().kept, "its own result is");
        let own = journal.read::<Record>("drop.txt", &recording.key(hash(TIMES)));
        assert_eq!(own.unwrap().unwrap().drops.len(), 1);
    }
}
