//! The results of all recordings, read from the journal one at a time.

use std::collections::BTreeMap;

use crate::error::{Error, Result};
use crate::hash::Hash;
use crate::journal::{Journal, Key};
use crate::metadata::KnownRecording;
use crate::record::Record;
use crate::work::Done;

/// Where the results of a session are.
#[derive(Debug, Clone, Copy)]
pub struct Results<'a> {
    /// The recordings.
    pub recordings: &'a [KnownRecording],
    /// What came of the work on each, in their order.
    pub done: &'a [Done],
    /// Where their results are.
    pub journal: &'a Journal,
}

impl Results<'_> {
    /// The result of a recording, by its place, and what it is of.
    ///
    /// # Errors
    /// [`Error::NoResult`] if the journal has none, [`Error::Read`] if it cannot be read.
    pub fn read(&self, place: usize) -> Result<(Key, Record)> {
        let recording = &self.recordings[place];
        let none = || Error::NoResult {
            name: recording.name().to_owned(),
        };
        let content = self.done[place].content.as_ref().map_err(|_| none())?;
        let key = recording.key(*content);
        let record = self.journal.read(recording.name(), &key)?;
        Ok((key, record.ok_or_else(none)?))
    }

    /// For each recording the first with the same content, if it is another.
    pub(crate) fn duplicates(&self) -> Vec<Option<usize>> {
        let mut first: BTreeMap<Hash, usize> = BTreeMap::new();
        let done = self.done.iter().enumerate();
        done.map(|(place, done)| {
            let known = *first.entry(*done.content.as_ref().ok()?).or_insert(place);
            (known != place).then_some(known)
        })
        .collect()
    }
}
