//! WAV files with cue markers, which editors and players show at their places.
//!
//! A marker is an entry of the chunk `cue ` and its text a chunk `labl` in a list of the type `adtl`; both follow the
//! samples (Microsoft and IBM, "Multimedia Programming Interface and Data Specifications 1.0", 1991).

use crate::error::{Error, Result};
use crate::wav::{SampleFormat, TOO_LONG, encode_wav};

/// A marker in a sound.
#[derive(Debug, Clone, PartialEq)]
pub struct Cue {
    /// Its time in seconds, from the beginning of the sound.
    pub time_s: f64,
    /// Its text.
    pub text: String,
}

/// The bytes of a WAV file as those of [`encode_wav`], with markers.
///
/// ```
/// use bouncelab_audio::{Cue, SampleFormat, Source, encode_wav_with_cues};
///
/// let cue = Cue { time_s: 0.5, text: "1".to_owned() };
/// let wav = encode_wav_with_cues(8_000, SampleFormat::Int16, &[&[0.0; 8_000]], &[cue])?;
/// assert_eq!(Source::from_bytes(wav, "marked.wav")?.duration_s(), Some(1.0));
/// # Ok::<(), bouncelab_audio::Error>(())
/// ```
///
/// # Errors
///
/// [`Error::Unwritable`] as for [`encode_wav`], and if a marker lies outside the sound.
pub fn encode_wav_with_cues(
    sample_rate_hz: u32,
    format: SampleFormat,
    channels: &[&[f32]],
    cues: &[Cue],
) -> Result<Vec<u8>> {
    let refused = |problem: String| Error::unwritable("WAV in memory", problem);
    let mut wav = encode_wav(sample_rate_hz, format, channels)?;
    let frames = channels[0].len() as f64;
    let (mut points, mut texts) = (Vec::new(), b"adtl".to_vec());
    points.extend_from_slice(&(cues.len() as u32).to_le_bytes());
    for (cue, number) in cues.iter().zip(1_u32..) {
        let frame = (cue.time_s * f64::from(sample_rate_hz)).round();
        if !(0.0..frames).contains(&frame) {
            return Err(refused(format!(
                "a marker at {} s is outside of it",
                cue.time_s
            )));
        }
        points.extend(point(number, frame as u32));
        let text = [&number.to_le_bytes(), cue.text.as_bytes(), b"\0"].concat();
        texts.extend(chunk(*b"labl", &text));
    }
    wav.extend(chunk(*b"cue ", &points));
    wav.extend(chunk(*b"LIST", &texts));
    let len = u32::try_from(wav.len() - 8).map_err(|_| refused(TOO_LONG.to_owned()))?;
    wav[4..8].copy_from_slice(&len.to_le_bytes());
    Ok(wav)
}

/// An entry of the chunk `cue `: its number, its place in the order of playing, the chunk that it is in, where that
/// and its block begin, and the frame there.
fn point(number: u32, frame: u32) -> impl Iterator<Item = u8> {
    let data = u32::from_le_bytes(*b"data");
    let fields = [number, frame, data, 0, 0, frame];
    fields.into_iter().flat_map(u32::to_le_bytes)
}

/// A chunk, padded to an even length.
pub(crate) fn chunk(name: [u8; 4], content: &[u8]) -> Vec<u8> {
    let len = content.len() as u32;
    let padding = &[0][..content.len() % 2];
    [&name, &len.to_le_bytes(), content, padding].concat()
}
