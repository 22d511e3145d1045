//! The row of one recording.

use std::collections::{BTreeMap, HashMap};
use std::path::PathBuf;
use std::sync::Arc;

use bouncelab::Plain;
use bouncelab::settings::Settings;
use bouncelab_report::data_table::DataTable;
use serde::{Deserialize, Serialize};

use crate::columns::{empty_tables_of_one, tables_of_one};
use crate::hash::Hash;
use crate::journal::Key;
use crate::metadata::{KnownRecording, Metadata};
use crate::record::Record;
use crate::recordings::RecordingFile;

/// The result of one recording, or the reason that the analysis was refused. It depends only on the content of the recording, its name, the notes
/// about it and the settings.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// Name of the recording.
    pub recording: String,
    /// Hash of what holds for all recordings: the settings and options of the kernel, and the version.
    pub kernel: Hash,
    /// Hash of its content, if it can be read.
    pub content: Option<Hash>,
    /// Hash of settings and version: that of the tables of a session.
    pub settings: Option<Hash>,
    /// Why there is no record.
    pub failure: Option<Failure>,
    /// Its metadata.
    pub known: Known,
    /// Its result, if the analysis did not fail.
    pub record: Option<Record>,
}

/// Why a recording has no result.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Failure {
    /// The kind of reason.
    pub code: FailureCode,
    /// The reason, in English.
    pub message: String,
}

/// Kinds of reasons why a recording has no result.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FailureCode {
    /// Its notes are refused.
    Metadata,
    /// It cannot be opened.
    Unreadable,
    /// Its content cannot be decoded or analysed.
    NotAnalysed,
    /// It ended the process that analysed it.
    ProcessDied,
    /// It exceeded the limit of time.
    OutOfTime,
}

impl FailureCode {
    /// Every kind.
    pub const ALL: [Self; 5] = [
        Self::Metadata,
        Self::Unreadable,
        Self::NotAnalysed,
        Self::ProcessDied,
        Self::OutOfTime,
    ];

    /// Its name in rows.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Metadata => "metadata",
            Self::Unreadable => "unreadable",
            Self::NotAnalysed => "not-analysed",
            Self::ProcessDied => "process-died",
            Self::OutOfTime => "out-of-time",
        }
    }
}

/// The stated metadata of a recording, from which its [`Metadata`] follow.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Known {
    /// The stated settings, for all recordings and for this one.
    pub settings: Settings,
    /// The factors by which its drops are compared.
    pub factors: BTreeMap<String, String>,
    /// The drop height as noted, m.
    pub height_m: Option<f64>,
    /// The temperature as noted, K.
    pub temperature_k: Option<f64>,
}

impl Known {
    fn metadata(&self) -> bouncelab::Result<Metadata> {
        Ok(Metadata {
            setup: self.settings.resolve()?,
            settings: self.settings.clone(),
            factors: self
                .factors
                .iter()
                .map(|(field, text)| (Plain::of(field).into(), Plain::of(text).into()))
                .collect(),
            height_m: self.height_m,
            temperature_k: self.temperature_k,
        })
    }
}

/// Metadata by the JSON from which they follow, each computed once.
#[derive(Debug, Default)]
pub(super) struct KnownMetadata(HashMap<String, Arc<Metadata>>);

impl KnownMetadata {
    /// Number of those.
    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    /// The metadata that follow from a [`Known`], given as JSON.
    pub(super) fn of(&mut self, known: &str) -> Result<Arc<Metadata>, String> {
        if let Some(made) = self.0.get(known) {
            return Ok(Arc::clone(made));
        }
        let parsed: Known = serde_json::from_str(known).map_err(|fault| fault.to_string())?;
        let metadata = parsed.metadata().map_err(|refusal| refusal.to_string())?;
        let made = Arc::new(metadata);
        self.0.insert(known.to_owned(), Arc::clone(&made));
        Ok(made)
    }
}

/// The tables of drops and impacts of single recordings: the columns of the tables of a session, without the
/// name of the recording and the notes. Columns that depend on other recordings are empty.
#[derive(Debug, Default)]
pub struct RowTables(KnownMetadata);

impl RowTables {
    /// The tables without rows.
    pub fn empty() -> [DataTable; 2] {
        empty_tables_of_one()
    }

    /// The tables of a row.
    ///
    /// # Errors
    /// The reason, if its settings are refused, which does not happen to rows of a [`Kernel`](super::Kernel).
    pub fn of(&mut self, row: &Row) -> Result<[DataTable; 2], String> {
        let (Some(record), Some(content), Some(settings)) =
            (&row.record, row.content, row.settings)
        else {
            return Ok(Self::empty());
        };
        let known = serde_json::to_string(&row.known).map_err(|fault| fault.to_string())?;
        let recording = KnownRecording {
            recording: RecordingFile {
                entry: None,
                path: PathBuf::from(&row.recording),
                name: row.recording.clone(),
            },
            metadata: self.0.of(&known)?,
        };
        Ok(tables_of_one(
            &recording,
            &Key { content, settings },
            record,
        ))
    }
}
