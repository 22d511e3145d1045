//! Many recordings with what was noted of each, and their results as tables.
//!
//! | module | question it answers |
//! |---|---|
//! | [`Error`] | what can go wrong? |
//! | [`name`](name()) | what is a file called, whatever bytes its name is made of? |
//! | [`Pattern`] | what does a file name say? |
//! | `notes` | what does a TOML file or a CSV say? |
//! | [`Session`] | which recordings are there, and what was said of each? |
//! | [`Metadata`] | what do the notes mean? |
//! | [`hash`] | what tells contents and settings apart? |
//! | [`Record`] | what does one recording say? |
//! | [`journal`] | which results are there already? |
//! | [`complete`] | what is left to do for one recording? |
//! | [`Outcome`] | what do the drops say together? |
//! | [`SessionDocument`] | what do they say, for other programs? |
//! | [`table`] | how is a table written as Parquet, CSV and JSON lines? |
//! | [`write_tables`], [`tables`], [`RecordingTables`] | what stands in the tables of a session, or of one recording? |

#![warn(missing_docs)]

mod columns;
mod document;
mod error;
pub mod hash;
pub mod journal;
mod metadata;
mod name;
mod notes;
mod pattern;
mod record;
mod recordings;
mod results;
mod study;
pub mod table;
mod work;

pub use columns::{RecordingTables, tables, write_tables};
pub use document::{AboutSession, Reason, SessionDocument};
pub use error::{Error, Result};
pub use metadata::{Advice, KnownRecording, Metadata, MetadataOptions, Noted};
pub use name::{name, some_of};
pub use notes::{Note, Notes};
pub use pattern::Pattern;
pub use record::{DropRecord, FitRecord, ImpactRecord, PosteriorRecord, RECORD, Record};
pub use recordings::{ENDINGS, Recording, SESSION_FILE, Session, Sources};
pub use results::Results;
pub use study::{Outcome, SessionDrop, StudyOptions};
pub use work::{Done, complete};
