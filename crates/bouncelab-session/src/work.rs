//! Work on many recordings.

use crate::error::Error;
use crate::hash::Hash;
use crate::journal::{Journal, Key};
use crate::metadata::KnownRecording;
use crate::record::Record;

/// The outcome of the work on one recording.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Done {
    /// Hash of its content, or why it cannot be read or analysed.
    pub content: std::result::Result<Hash, String>,
    /// Whether the journal had its result already.
    pub kept: bool,
    /// Whether it could not be read, or was analysed now and has no drop.
    pub without_drop: bool,
}

/// Makes sure that the journal has the result of a recording for its present content and settings.
///
/// If the journal lacks it, `analyze` analyses the recording with this key ([`KnownRecording::record`], in this process
/// or in another). It returns `None` if the content has changed since; then no result is kept.
///
/// Each result depends on the content of its recording and the settings alone, never on the order of
/// work. So any number of threads may call this concurrently, and an interrupted run continues
/// where it ended.
///
/// # Errors
/// [`Error::Output`] if the journal cannot be written, and those of `analyze`.
pub fn complete<E: From<Error>>(
    recording: &KnownRecording,
    journal: &Journal,
    analyze: impl FnOnce(Key) -> std::result::Result<Option<Record>, E>,
) -> std::result::Result<Done, E> {
    let content = match recording.recording.content() {
        Ok(content) => content,
        Err(reason) => return Ok(Done::failed(reason.to_string())),
    };
    let (name, key) = (recording.name(), recording.key(content));
    let kept = journal.has(name, &key);
    let mut without_drop = false;
    if !kept {
        let Some(record) = analyze(key)? else {
            return Ok(Done::failed(Error::Changed.to_string()));
        };
        without_drop = record.drops.is_empty();
        journal.append(name, &key, &record)?;
    }
    Ok(Done {
        content: Ok(content),
        kept,
        without_drop,
    })
}

/// The record of the recording with this name, content and settings, among those of a session, which are in the order of
/// their names; `None` if the session has no such record, or the content has changed.
pub fn record_of(recordings: &[KnownRecording], name: &str, key: &Key) -> Option<Record> {
    let first = recordings.partition_point(|it| it.name() < name);
    let named = recordings[first..]
        .iter()
        .take_while(|it| it.name() == name);
    let mut same = named.filter(|it| it.key(key.content) == *key);
    same.next()?.record(key.content)
}

impl Done {
    /// The outcome of work that failed, with the reason.
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
    use std::path::Path;
    use std::sync::Arc;

    use bouncelab::settings::Settings;

    use super::*;
    use crate::hash::{hash, hash_of};
    use crate::metadata::{BUILD, Metadata};
    use crate::record::RECORD;
    use crate::recordings::RecordingFile;

    const TIMES: &[u8] = b"0\n0.4605\n0.8877\n1.2854\n";

    /// A list of times in a folder.
    fn recording(folder: &Path) -> KnownRecording {
        let path = folder.join("drop.txt");
        fs::write(&path, TIMES).unwrap();
        KnownRecording {
            recording: RecordingFile {
                entry: None,
                path,
                name: "drop.txt".to_owned(),
            },
            metadata: Arc::new(Metadata {
                settings: Settings::default().without_inference(),
                setup: Settings::default().without_inference().resolve().unwrap(),
                factors: BTreeMap::new(),
                height_m: None,
                temperature_k: None,
            }),
        }
    }

    /// Whether the file has other bytes or is another file.
    #[test]
    fn a_recording_that_is_replaced_meanwhile_has_no_result() {
        let folder = tempfile::tempdir().unwrap();
        let journal = Journal::open(&folder.path().join("results")).unwrap();
        let other = folder.path().join("other");
        let replace: [&dyn Fn(&Path); 3] = [
            &|path| fs::write(path, "0\n1\n1.9\n").unwrap(),
            &|path| {
                fs::write(&other, "0\n1\n1.9\n").unwrap();
                fs::rename(&other, path).unwrap();
            },
            &|path| fs::remove_file(path).unwrap(),
        ];
        for replace in replace {
            let recording = recording(folder.path());
            let done = complete(&recording, &journal, |key| {
                replace(&recording.recording.path);
                Ok::<_, Error>(recording.record(key.content))
            });
            assert_eq!(done.unwrap(), Done::failed(Error::Changed.to_string()));
            assert!(!journal.has("drop.txt", &recording.key(hash(TIMES))));
        }
    }

    #[test]
    fn no_result_of_another_build_is_used() {
        let folder = tempfile::tempdir().unwrap();
        let recording = recording(folder.path());
        let journal = Journal::open(&folder.path().join("results")).unwrap();
        for part in 0..BUILD.len() {
            let mut build = BUILD;
            build[part] = "another";
            let key = Key {
                content: hash(TIMES),
                settings: hash_of(&(build, (RECORD, recording.options()))),
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
