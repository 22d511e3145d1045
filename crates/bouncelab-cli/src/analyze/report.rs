//! The report of a recording.

use std::path::Path;

use bouncelab_report::report::{self, Page, Provenance, Recording};
use bouncelab_session::hash::hash_of_file;

use super::read::Analysed;
use crate::failure::Failure;
use crate::language::translator;
use crate::physics::Physics;
use crate::report::provenance;

/// The page of the result of a file.
pub(super) fn page(path: &Path, analysed: &Analysed, physics: &Physics) -> Result<Page, Failure> {
    let recording = Recording {
        name: &analysed.name,
        setup: physics,
        result: &analysed.result,
    };
    let provenance = Provenance {
        files: vec![(analysed.name.clone(), hash_of_file(path)?.to_string())],
        ..provenance()
    };
    Ok(report::of_recording(&recording, &provenance, translator()))
}
