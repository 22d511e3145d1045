//! The report of a recording.

use std::path::Path;

use bouncelab_report::report::{self, Page, Provenance, Recording};
use bouncelab_session::hash::hash_of_file;

use super::hear::Hearing;
use crate::failure::Failure;
use crate::language::translator;
use crate::physics::Physics;
use crate::report::provenance;

/// The page of what was heard in a file.
pub(super) fn page(heard: &Path, hearing: &Hearing, physics: &Physics) -> Result<Page, Failure> {
    let recording = Recording {
        name: &hearing.name,
        origin: &hearing.origin,
        settings: &physics.settings,
        ball_label: &physics.ball_label,
        assumptions: &physics.assumptions,
        drops: &hearing.drops,
        no_drop: hearing.no_drop.as_deref(),
        warnings: &hearing.warnings,
        sound: hearing.envelope.as_ref(),
    };
    let provenance = Provenance {
        files: vec![(hearing.name.clone(), hash_of_file(heard)?.to_string())],
        ..provenance()
    };
    Ok(report::of_recording(&recording, &provenance, translator()))
}
