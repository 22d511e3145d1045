//! Many recordings with their metadata, and their results as tables.
//!
//! | module | what it does |
//! |---|---|
//! | [`Error`] | the errors |
//! | [`name`](name()) | file names as text |
//! | [`Pattern`] | metadata in file names |
//! | `notes` | metadata in a TOML file or a CSV |
//! | `archive` | recordings in a ZIP archive |
//! | [`Session`] | the recordings and their metadata |
//! | [`Metadata`] | metadata as quantities |
//! | [`hash`] | hashes of contents and settings |
//! | [`Record`] | the result of one recording |
//! | [`journal`] | the results so far |
//! | [`complete`] | analyses one recording if needed |
//! | [`batch`] | rows of recordings on a cluster |
//! | [`Outcome`] | statistics of the drops, which [`bouncelab_report::groups`] shows |
//! | [`figures()`] | figures of the statistics |
//! | [`report()`] | the report as a page |
//! | [`SessionDocument`] | the statistics as JSON |
//! | [`table`] | tables as Parquet, CSV and JSON lines |
//! | [`write_tables`], [`tables`] | the tables of a session |

#![warn(missing_docs)]

mod archive;
pub mod batch;
mod columns;
mod document;
mod error;
mod figures;
pub mod hash;
pub mod journal;
mod metadata;
mod name;
mod notes;
mod pattern;
mod record;
mod recordings;
mod report;
mod results;
mod study;
pub mod table;
mod work;

pub use archive::ArchiveEntry;
pub use columns::{tables, write_tables};
pub use document::{DOCUMENT_MARK, SCHEMA, SessionDocument};
pub use error::{Error, Result};
pub use figures::figures;
pub use metadata::{Advice, BUILD, KnownRecording, Metadata, MetadataOptions};
pub use name::name;
pub use notes::{Note, Notes};
pub use pattern::Pattern;
pub use record::{RECORD, Record};
pub use recordings::{RecordingFile, SESSION_FILE, Session, Sources, UnmatchedNames};
pub use report::report;
pub use results::{Results, Store};
pub use study::{Outcome, SessionDrop, StudyOptions, compared_drops};
pub use work::{Done, complete, record_of};
