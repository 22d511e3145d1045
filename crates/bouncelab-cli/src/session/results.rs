//! The results of all recordings, read from the journal one at a time.

use std::collections::BTreeMap;

use bouncelab_session::hash::Hash;
use bouncelab_session::journal::{Journal, Key};

use super::notes::Setup;
use super::record::Record;
use super::work::Done;
use crate::failure::Failure;

/// Where the results of a session are.
#[derive(Clone, Copy)]
pub(super) struct Results<'a> {
    pub(super) recordings: &'a [Setup],
    pub(super) done: &'a Done,
    pub(super) journal: &'a Journal,
}

impl Results<'_> {
    /// The result of a recording, and what it is of.
    pub(super) fn read(&self, place: usize) -> Result<(Key, Record), Failure> {
        let setup = &self.recordings[place];
        let name = &setup.recording.name;
        let content = self.done.contents[place].as_ref();
        let key = setup.key(*content.map_err(|reason| Failure::Input(reason.clone()))?);
        let record = self.journal.read(name, &key)?;
        let lost = || Failure::Input(format!("{name}: its result is lost; run again"));
        Ok((key, record.ok_or_else(lost)?))
    }

    /// For each recording the first with the same content, if it is another.
    pub(super) fn duplicates(&self) -> Vec<Option<usize>> {
        let mut first: BTreeMap<Hash, usize> = BTreeMap::new();
        let contents = self.done.contents.iter().enumerate();
        contents
            .map(|(place, content)| {
                let known = *first.entry(*content.as_ref().ok()?).or_insert(place);
                (known != place).then_some(known)
            })
            .collect()
    }
}
