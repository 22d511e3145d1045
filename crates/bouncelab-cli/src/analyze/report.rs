//! The report of a recording.

use std::path::Path;

use bouncelab_report::report::{self, Page, Provenance, Recording};
use bouncelab_session::hash::hash_of_file;

use super::read::Analysed;
use crate::failure::Failure;
use crate::language::translator;
use crate::physics::Physics;
use crate::report::provenance;

/// The page of what was heard in a file.
pub(super) fn page(heard: &Path, analysed: &Analysed, physics: &Physics) -> Result<Page, Failure> {
    let recording = Recording {
        name: &analysed.name,
        setup: physics,
        result: &analysed.result,
    };
    let provenance = Provenance {
        files: vec![(analysed.name.clone(), hash_of_file(heard)?.to_string())],
        ..provenance()
    };
    Ok(report::of_recording(&recording, &provenance, translator()))
}
