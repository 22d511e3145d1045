//! A copy of a recording with its impacts as markers.

use std::io;
use std::path::Path;

use bouncelab_audio::{Cue, Error, Input, copy_with_cues};
use bouncelab_report::document::labels::{Label, labels};
use bouncelab_report::file::Outputs;
use bouncelab_report::mark::Mark;

use super::read::Analysed;
use crate::failure::Failure;
use crate::language::text_with;
use crate::report::wrote;

/// Writes the sound of a recording as a WAV file of 32-bit floats, in which every sample is as it was, with a marker
/// at each impact. The rate is that of samples whose file does not state it.
pub(super) fn write_cues(
    recording: &Path,
    rate_hz: Option<u32>,
    analysed: &Analysed,
    target: &Path,
    outputs: &Outputs,
) -> Result<(), Failure> {
    let Ok(mut source) = Input::open(recording)?.sound(rate_hz)? else {
        let name = [("name", analysed.name.as_str().into())];
        return Err(Failure::Usage(text_with("analyze-cues-need-sound", &name)));
    };
    let cue = |Label { time_s, text }| Cue { time_s, text };
    let cues: Vec<Cue> = labels(&analysed.result).into_iter().map(cue).collect();
    let written = outputs.fill(target, Mark::NONE, |copy| {
        copy_with_cues(&mut source, copy, &cues).map_err(|fault| match fault {
            Error::Io { source, .. } => source,
            fault => io::Error::other(fault),
        })
    });
    written.map_err(|reason| Failure::unwritable(target, &reason))?;
    wrote(target);
    Ok(())
}
