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
    /// What came of the work on each, in their order.
    pub done: &'a [Done],
    /// Where their results are.
    pub store: Store<'a>,
}

/// Where results are kept.
#[derive(Debug, Clone, Copy)]
pub enum Store<'a> {
    /// In the journal of this machine.
    Journal(&'a Journal),
    /// In the rows of a cluster.
    Batch(&'a Batch),
}

impl Results<'_> {
    /// Hands on the results of some recordings, with their places: those of a journal in this order, those of
    /// a cluster in the order of its rows.
    ///
    /// # Errors
    /// [`Error::NoResult`] if there is none, [`Error::Read`] and [`Error::Rows`] if it cannot be read, and
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
        for place in (0..self.recordings.len()).filter(|&place| is_wanted(place)) {
            let (key, record) = self.read(journal, place)?;
            take(place, &key, record)?;
        }
        Ok(())
    }

    fn read(&self, journal: &Journal, place: usize) -> Result<(Key, Record)> {
        let recording = &self.recordings[place];
        let none = || Error::NoResult {
            name: recording.name().to_owned(),
        };
        let content = self.done[place].content.as_ref().map_err(|_| none())?;
        let key = recording.key(*content);
        let record = journal.read(recording.name(), &key)?;
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
