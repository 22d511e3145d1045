//! Analyses a recording as a row.

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use bouncelab::Plain;
use bouncelab::settings::Settings;
use bouncelab_report::messages::Translator;
use serde::{Deserialize, Serialize};

use super::row::{Failure, FailureCode, Known, Row};
use crate::error::{Error, Result};
use crate::hash::{Hash, hash, hash_of};
use crate::metadata::{Advice, BUILD, KnownRecording, MetadataOptions};
use crate::name::{name, without_name};
use crate::notes::Note;
use crate::pattern::Pattern;
use crate::record::{RECORD, Record};
use crate::recordings::{RecordingFile, Session};

/// How recordings are analysed, in addition to the settings for all.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct KernelOptions {
    /// The pattern for file names.
    pub pattern: Option<String>,
    /// Whether to accept notes that look like a mistake.
    pub allow_implausible: bool,
}

/// A recording as an engine gives it.
#[derive(Debug, Clone)]
pub struct Given {
    /// Its name: its path relative to the folder of all recordings.
    pub name: String,
    /// Its path.
    pub path: PathBuf,
    /// Its content, if the engine has read it.
    pub content: Option<Arc<[u8]>>,
    /// Notes about it, by field.
    pub notes: BTreeMap<String, String>,
}

/// Analyses recordings one by one, each as a session does.
#[derive(Debug, Clone)]
pub struct Kernel {
    settings: Settings,
    options: KernelOptions,
    pattern: Option<Pattern>,
    hash: Hash,
}

/// A recording before its analysis.
struct Begun {
    recording: KnownRecording,
    known: Known,
    content: std::result::Result<Hash, String>,
    kernel: Hash,
}

impl Kernel {
    /// A kernel with settings for all recordings, which the notes about a recording override.
    ///
    /// # Errors
    /// [`Error::Pattern`] if the pattern is malformed, [`Error::Metadata`] if the settings are refused.
    ///
    /// ```
    /// use std::collections::BTreeMap;
    /// use bouncelab::settings::Settings;
    /// use bouncelab_session::batch::{Given, Kernel, KernelOptions};
    ///
    /// let options = KernelOptions { pattern: Some("{surface}_{}".to_owned()), ..KernelOptions::default() };
    /// let row = Kernel::new(Settings::default(), options)?.row(Given {
    ///     name: "steel_1.txt".to_owned(),
    ///     path: "/recordings/steel_1.txt".into(),
    ///     content: Some(b"0\n0.4605\n0.8877\n1.2854\n"[..].into()),
    ///     notes: BTreeMap::new(),
    /// });
    /// assert_eq!(row.known.factors["surface"], "steel");
    /// assert_eq!(row.record.unwrap().drops[0].impacts.len(), 4);
    /// # Ok::<(), bouncelab_session::Error>(())
    /// ```
    pub fn new(settings: Settings, options: KernelOptions) -> Result<Self> {
        settings.resolve().map_err(|refusal| Error::Metadata {
            problem: refusal.to_string(),
        })?;
        Ok(Self {
            hash: hash_of(&(RECORD, BUILD, &settings, &options)),
            pattern: options.pattern.as_deref().map(Pattern::new).transpose()?,
            settings,
            options,
        })
    }

    /// Hash of the settings for all recordings, the options, and this build: rows of one output have one.
    pub fn hash(&self) -> Hash {
        self.hash
    }

    /// Analyses a recording.
    pub fn row(&self, given: Given) -> Row {
        let bytes = given.content.clone();
        let begun = match self.begin(given) {
            Ok(begun) => begun,
            Err(row) => return *row,
        };
        let name = begun.recording.name();
        let content = match &begun.content {
            Ok(content) => *content,
            Err(reason) => {
                let message = reason.clone();
                return begun.row(Err(Failure {
                    code: FailureCode::Unreadable,
                    message,
                }));
            }
        };
        let options = begun.recording.options();
        let record = match bytes {
            Some(bytes) => Some(Record::of_bytes(bytes, name, options)),
            None => begun.recording.record(content),
        };
        let Some(record) = record else {
            return begun.row(Err(Failure {
                code: FailureCode::Unreadable,
                message: Error::Changed.to_string(),
            }));
        };
        let result = match &record.failure {
            None => Ok(record),
            Some(reason) => Err(Failure {
                code: FailureCode::NotAnalysed,
                message: without_name(reason, name).to_owned(),
            }),
        };
        begun.row(result)
    }

    /// The row of a recording whose analysis failed elsewhere, such as in a process that ended.
    pub fn failed(&self, given: Given, failure: Failure) -> Row {
        match self.begin(given) {
            Ok(begun) => begun.row(Err(failure)),
            Err(row) => *row,
        }
    }

    /// Reads the notes and the content; the error is the row of a recording whose notes are refused.
    fn begin(&self, given: Given) -> std::result::Result<Begun, Box<Row>> {
        let name = name(given.name.as_ref());
        let (recording, known) =
            self.known(name.clone(), given.path, given.notes)
                .map_err(|refusal| {
                    let message = without_name(&refusal.to_string(), &name).to_owned();
                    Box::new(Row {
                        recording: name,
                        kernel: self.hash,
                        content: None,
                        settings: None,
                        failure: Some(Failure {
                            code: FailureCode::Metadata,
                            message,
                        }),
                        known: Known::default(),
                        record: None,
                    })
                })?;
        let content = match &given.content {
            Some(content) => Ok(hash(content)),
            None => recording
                .recording
                .content()
                .map_err(|reason| reason.to_string()),
        };
        Ok(Begun {
            recording,
            known,
            content,
            kernel: self.hash,
        })
    }

    /// The metadata of a recording.
    fn known(
        &self,
        name: String,
        path: PathBuf,
        notes: BTreeMap<String, String>,
    ) -> Result<(KnownRecording, Known)> {
        let notes = notes.into_iter().map(|(field, text)| {
            let said_by = "its notes".into();
            let text = Plain::of(text.trim()).into();
            (Plain::of(&field).into(), Note { text, said_by })
        });
        let recording = RecordingFile {
            path,
            entry: None,
            name,
        };
        let session = Session::of_one(recording, self.pattern.clone(), notes.collect());
        let mut read = MetadataOptions {
            settings: &self.settings,
            allow_implausible: self.options.allow_implausible,
            allow_missing: true,
            translator: &Translator::english(),
            advice: Advice {
                implausible: "Correct it, or say allow_implausible=True.",
                missing: "",
                ball: "or give the kind of all balls by ball=",
            },
        }
        .read(session)?;
        let recording = read.pop().ok_or_else(|| Error::Metadata {
            problem: "it has no metadata".to_owned(),
        })?;
        let metadata = &recording.metadata;
        let known = Known {
            settings: metadata.settings.clone(),
            factors: metadata.factors.clone(),
            height_m: metadata.height_m,
            temperature_k: metadata.temperature_k,
        };
        Ok((recording, known))
    }
}

impl Begun {
    fn row(self, result: std::result::Result<Record, Failure>) -> Row {
        let content = self.content.ok();
        let settings = self.recording.settings();
        let (record, failure) = match result {
            Ok(record) => (Some(record), None),
            Err(failure) => (None, Some(failure)),
        };
        Row {
            recording: self.recording.recording.name,
            kernel: self.kernel,
            content,
            settings: Some(settings),
            failure,
            known: self.known,
            record,
        }
    }
}
