//! The record of one recording, and the analysis that makes it.

use std::io::Seek;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::Arc;

use bouncelab::analysis::{Drop, Recording};
use bouncelab::{Diagnostic, Options, Plain};
use bouncelab_audio::Input;
use bouncelab_report::columns::DropRecord;
use serde::{Deserialize, Serialize};

use crate::hash::{self, Hash, hash, hash_of_all};

/// Name and version of the form of a [`Record`]: another whenever a record of before could not be read,
/// or would say something else.
pub const RECORD: &str = "bouncelab.record/4";

/// What one recording says.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Its drops, in order of time.
    pub drops: Vec<DropRecord>,
    /// Why no drop was found.
    pub no_drop: Option<Diagnostic>,
    /// Why it could not be read or analysed.
    pub failure: Option<String>,
    /// What is odd about it.
    pub diagnostics: Vec<Diagnostic>,
}

impl Record {
    /// What the content of a file says: nothing else matters but its name, which tells lists of times
    /// from sound, and the options.
    ///
    /// ```
    /// use bouncelab::Options;
    /// use bouncelab_session::Record;
    ///
    /// let times = b"0\n0.4605\n0.8877\n1.2854\n1.6568\n2.0045\n";
    /// let options = Options::default().without_inference();
    /// let record = Record::of_bytes(&times[..], "drop.txt", &options);
    /// assert_eq!(record.drops[0].impacts.len(), 6);
    /// ```
    pub fn of_bytes(bytes: impl Into<Arc<[u8]>>, name: &str, options: &Options) -> Self {
        let bytes = bytes.into();
        let content = hash(&bytes);
        Self::of(content, name, options, || Input::from_bytes(bytes, name))
    }

    /// What a file with this content says; `None` if it has another one, or gets it meanwhile.
    pub fn of_file(path: &Path, content: Hash, options: &Options) -> Option<Self> {
        let name = String::from(Plain::path(path));
        let file = hash::open(path).ok()?;
        let mut same = file.try_clone().ok()?;
        let record = Self::of(content, &name, options, || Input::from_reader(file, &name));
        // Of what was read, whatever has the name by now; and after it, since it may be written into.
        same.rewind().ok()?;
        (hash_of_all(same).ok()? == content).then_some(record)
    }

    pub(crate) fn of(
        content: Hash,
        name: &str,
        options: &Options,
        open: impl FnOnce() -> bouncelab_audio::Result<Input>,
    ) -> Self {
        let mut options = options.clone();
        if let Some(inference) = &mut options.inference {
            // Equal seeds would give the errors of sampling of all drops the same sign.
            inference.sampler.seed ^= content.number();
            // Drops are compared by their restitution and height.
            inference.each_impact = false;
        }
        // A fault of the program in one recording must not end the work on others.
        let analysed = catch_unwind(AssertUnwindSafe(|| analyze(open()?, &options)));
        match analysed {
            Ok(Ok(recording)) => Self::from(&recording),
            Ok(Err(failure)) => Self::failed(failure.to_string()),
            Err(_) => Self::failed(format!(
                "{name}: the analysis failed by a fault of the program; please report it"
            )),
        }
    }

    pub(crate) fn failed(reason: String) -> Self {
        Self {
            failure: Some(reason),
            ..Self::default()
        }
    }
}

/// Every drop of an opened file.
fn analyze(input: Input, options: &Options) -> Result<Recording, Box<dyn std::error::Error>> {
    let plan = input.plan::<Box<dyn std::error::Error>>(options, |_| Ok(()))?;
    Ok(plan.run())
}

impl From<&Recording> for Record {
    fn from(recording: &Recording) -> Self {
        Self {
            drops: recording.drops.iter().map(compared).collect(),
            no_drop: recording.no_drop.clone(),
            failure: None,
            diagnostics: recording.diagnostics.clone(),
        }
    }
}

/// The record of a drop, with the evidence by which drops are compared.
fn compared(drop: &Drop) -> DropRecord {
    let mut record = DropRecord::from(drop);
    if let (Some(posterior), Ok(of_drop)) = (&mut record.posterior, &drop.posterior) {
        posterior.evidence = of_drop.evidence();
    }
    record
}
