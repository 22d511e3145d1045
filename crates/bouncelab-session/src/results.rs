//! The results of all recordings, read one at a time from where they are kept.

use std::collections::BTreeMap;

use crate::batch::Batch;
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
    /// The outcome of the work on each, in the same order.
    pub done: &'a [Done],
    /// The store of their results.
    pub store: Store<'a>,
}

/// A store of results.
#[derive(Debug, Clone, Copy)]
pub enum Store<'a> {
    /// The journal of a run on this computer.
    Journal(&'a Journal),
    /// The rows that a cluster wrote.
    Batch(&'a Batch),
}

impl Results<'_> {
    /// Calls `take` with the results of the wanted recordings and their indices: those of a journal in the order of the
    /// recordings, those of a cluster in the order of its rows.
    ///
    /// # Errors
    /// [`Error::NoResult`] if a result is missing, [`Error::Read`] and [`Error::Rows`] if it cannot be read, and
    /// those of `take`.
    pub fn each(
        &self,
        is_wanted: impl Fn(usize) -> bool,
        mut take: impl FnMut(usize, &Key, Record) -> Result<()>,
    ) -> Result<()> {
        let journal = match self.store {
            Store::Journal(journal) => journal,
            Store::Batch(batch) => return batch.each(is_wanted, take),
        };
        for index in (0..self.recordings.len()).filter(|&index| is_wanted(index)) {
            let (key, record) = self.read(journal, index)?;
            take(index, &key, record)?;
        }
        Ok(())
    }

    fn read(&self, journal: &Journal, index: usize) -> Result<(Key, Record)> {
        let recording = &self.recordings[index];
        let none = || Error::NoResult {
            name: recording.name().to_owned(),
        };
        let content = self.done[index].content.as_ref().map_err(|_| none())?;
        let key = recording.key(*content);
        let record = journal.read(recording.name(), &key)?;
        Ok((key, record.ok_or_else(none)?))
    }

    /// For each recording the index of an earlier one with the same content, if there is one.
    pub(crate) fn duplicates(&self) -> Vec<Option<usize>> {
        let mut first: BTreeMap<Hash, usize> = BTreeMap::new();
        let done = self.done.iter().enumerate();
        done.map(|(index, done)| {
            let known = *first.entry(*done.content.as_ref().ok()?).or_insert(index);
            (known != index).then_some(known)
        })
        .collect()
    }
}
