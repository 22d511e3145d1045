//! The row of one recording.

use std::collections::{BTreeMap, HashMap};
use std::path::PathBuf;
use std::sync::Arc;

use bouncelab::Plain;
use bouncelab::setup::Settings;
use serde::{Deserialize, Serialize};

use crate::columns::{empty_tables_of_one, tables_of_one};
use crate::hash::Hash;
use crate::journal::Key;
use crate::metadata::{KnownRecording, Metadata};
use crate::record::Record;
use crate::recordings::Recording;
use crate::table::Table;

/// What one recording says, or why it says nothing. It depends on its content, its name, what was noted of it
/// and the settings, and on nothing else.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// What the recording is called.
    pub recording: String,
    /// Hash of its content, if it can be read.
    pub content: Option<Hash>,
    /// Hash of settings and version: that of the tables of a session.
    pub settings: Option<Hash>,
    /// Why there is no record.
    pub failure: Option<Failure>,
    /// What is known of it.
    pub known: Known,
    /// What it says, if nothing failed.
    pub record: Option<Record>,
}

/// Why a recording says nothing.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Failure {
    /// The kind of reason.
    pub code: FailureCode,
    /// The reason, in English.
    pub message: String,
}

/// Kinds of reasons why a recording says nothing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum FailureCode {
    /// What was noted of it makes no sense.
    Metadata,
    /// It cannot be opened.
    Unreadable,
    /// Its content cannot be decoded or analysed.
    NotAnalysed,
    /// It ended the process that analysed it.
    ProcessDied,
    /// It took longer than it may.
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

/// What is known of a recording, from which its [`Metadata`] follow.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Known {
    /// What was stated, of all recordings and of this one.
    pub settings: Settings,
    /// Whether there is to be an inference.
    pub inference: bool,
    /// What its drops are compared by.
    pub factors: BTreeMap<String, String>,
    /// The drop height as noted, m.
    pub height_m: Option<f64>,
    /// The temperature as noted, K.
    pub temperature_k: Option<f64>,
}

impl Known {
    fn metadata(&self) -> bouncelab::Result<Metadata> {
        Ok(Metadata {
            setup: self.settings.resolve(self.inference)?,
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

/// Metadata by what they follow from, each made once.
#[derive(Debug, Default)]
pub(super) struct KnownMetadata(HashMap<String, Arc<Metadata>>);

impl KnownMetadata {
    /// The metadata that follow from a [`Known`], given as JSON.
    pub(super) fn of(&mut self, known: &str) -> Result<Arc<Metadata>, String> {
        if let Some(made) = self.0.get(known) {
            return Ok(Arc::clone(made));
        }
        let parsed: Known = serde_json::from_str(known).map_err(|fault| fault.to_string())?;
        let made = parsed.metadata().map_err(|refusal| refusal.to_string())?;
        let made = Arc::new(made);
        self.0.insert(known.to_owned(), Arc::clone(&made));
        Ok(made)
    }
}

/// The tables of drops and impacts of single recordings: the columns of the tables of a session, but for the
/// name of the recording and what was noted. What takes other recordings is empty.
#[derive(Debug, Default)]
pub struct RowTables(KnownMetadata);

impl RowTables {
    /// The tables without rows.
    pub fn empty() -> [Table; 2] {
        empty_tables_of_one()
    }

    /// The tables of a row.
    ///
    /// # Errors
    /// The reason, if its settings make no sense; those of a [`Kernel`](super::Kernel) do.
    pub fn of(&mut self, row: &Row) -> Result<[Table; 2], String> {
        let (Some(record), Some(content), Some(settings)) =
            (&row.record, row.content, row.settings)
        else {
            return Ok(Self::empty());
        };
        let known = serde_json::to_string(&row.known).map_err(|fault| fault.to_string())?;
        let recording = KnownRecording {
            recording: Recording {
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
