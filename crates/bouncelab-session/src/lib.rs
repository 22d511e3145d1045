//! Many recordings with what was noted of each, and their results as tables.
//!
//! This crate knows files and formats, and no physics: what a note means and what a recording says
//! is the business of those who call.
//!
//! | room | inference it answers |
//! |---|---|
//! | `error` | what can go wrong |
//! | [`name`](name()) | what is a file called, whatever bytes its name is made of? |
//! | [`pattern`](Pattern) | what does a file name say? |
//! | `notes` | what does a TOML file or a CSV say? |
//! | [`gather`](Session) | which recordings are there, and what was said of each? |
//! | [`hash`] | what tells contents and settings apart? |
//! | [`journal`] | which results are there already? |
//! | [`table`] | results as Parquet, CSV and JSON lines |

mod error;
mod gather;
pub mod hash;
pub mod journal;
mod name;
mod notes;
mod pattern;
pub mod table;

pub use error::{Error, Result};
pub use gather::{ENDINGS, Recording, SESSION_FILE, Session, Sources};
pub use name::name;
pub use notes::{Note, Notes};
pub use pattern::Pattern;
