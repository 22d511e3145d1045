//! A copy of a recording with its impacts as markers.

use std::path::Path;

use bouncelab_audio::{Cue, Input, SampleFormat, encode_wav_with_cues};
use bouncelab_report::document::labels::{Label, labels};
use bouncelab_report::file::Outputs;

use super::read::Analysed;
use crate::failure::Failure;
use crate::language::text_with;
use crate::report::{NO_MARK, write};

/// Writes the sound of a recording as a WAV file of 32-bit floats, in which every sample is as it was, with a marker
/// at each impact.
pub(super) fn write_cues(
    recording: &Path,
    analysed: &Analysed,
    target: &Path,
    outputs: &Outputs,
) -> Result<(), Failure> {
    let Input::Sound(mut source) = Input::open(recording)? else {
        let name = [("name", analysed.name.as_str().into())];
        return Err(Failure::Usage(text_with("analyze-cues-need-sound", &name)));
    };
    let mut channels = vec![Vec::new(); source.channels()];
    while let Some(block) = source.next_block()? {
        for (number, channel) in channels.iter_mut().enumerate() {
            channel.extend_from_slice(block.channel(number));
        }
    }
    let cue = |Label { time_s, text }| Cue { time_s, text };
    let cues: Vec<Cue> = labels(&analysed.result).into_iter().map(cue).collect();
    let channels: Vec<&[f32]> = channels.iter().map(Vec::as_slice).collect();
    let rate_hz = source.sample_rate_hz();
    let wav = encode_wav_with_cues(rate_hz, SampleFormat::Float32, &channels, &cues)?;
    write(outputs, target, NO_MARK, &wav)
}
