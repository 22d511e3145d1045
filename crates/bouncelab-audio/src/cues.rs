//! WAV files with cue markers, which editors and players show at their times.
//!
//! A marker is an entry of the chunk `cue ` and its text a chunk `labl` in a list of the type `adtl`; both follow the
//! samples (Microsoft and IBM, "Multimedia Programming Interface and Data Specifications 1.0", 1991).

use std::io::{BufWriter, Seek, Write};

use crate::error::{Error, Result};
use crate::lost_chunk;
use crate::source::SoundReader;
use crate::wav::{MAX_DATA_LEN, SampleFormat, TOO_LONG, WavLayout, chunk};

/// A marker in a sound.
#[derive(Debug, Clone, PartialEq)]
pub struct Cue {
    /// Its time in seconds, from the beginning of the sound.
    pub time_s: f64,
    /// Its text.
    pub text: String,
}

/// Copies a recording into a WAV file of 32-bit floats, which represent every sample exactly, with markers. Blocks are
/// copied as they are read.
///
/// ```
/// use std::io::Cursor;
/// use bouncelab_audio::{Cue, SoundReader, copy_with_cues};
///
/// # let wav = include_bytes!("../tests/fixtures/pcm16.wav").to_vec();
/// let mut source = SoundReader::from_bytes(wav, "clicks.wav")?;
/// let mut copy = Cursor::new(Vec::new());
/// let cue = Cue { time_s: 0.1, text: "1".to_owned() };
/// copy_with_cues(&mut source, &mut copy, &[cue])?;
/// assert!(SoundReader::from_bytes(copy.into_inner(), "marked.wav")?.duration_s() > Some(0.1));
/// # Ok::<(), bouncelab_audio::Error>(())
/// ```
///
/// # Errors
///
/// Those of [`SoundReader::next_block`], [`Error::Unwritable`] if the copy would exceed 4 GB or a marker lies outside the
/// sound, [`Error::Io`] if it cannot be written.
pub fn copy_with_cues(
    source: &mut SoundReader,
    copy: impl Write + Seek,
    cues: &[Cue],
) -> Result<()> {
    let name = format!("copy of {}", source.name());
    let failed = |reason| Error::io(&name, reason);
    let refused = |problem: &str| Error::unwritable(&name, problem);
    let format = SampleFormat::Float32;
    let (rate_hz, channels) = (source.sample_rate_hz(), source.channels());
    let layout = WavLayout::new(&name, rate_hz, channels, format)?;
    let mut copy = BufWriter::new(copy);
    copy.write_all(&layout.header(0, 0)).map_err(failed)?;
    let mut frames = 0;
    while let Some(block) = source.next_block()? {
        frames += block.frames() as u64;
        let mut bytes = Vec::new();
        for frame in 0..block.frames() {
            for channel in 0..channels {
                format.encode(block.channel(channel)[frame], &mut bytes);
            }
        }
        copy.write_all(&bytes).map_err(failed)?;
        if frames * u64::from(layout.frame_len()) > u64::from(MAX_DATA_LEN) {
            return Err(refused(TOO_LONG));
        }
    }
    let data_len = frames as u32 * u32::from(layout.frame_len());
    let markers = markers(cues, rate_hz, frames).map_err(|problem| refused(&problem))?;
    let lost = lost_chunk::encode(source.gaps(), rate_hz);
    let chunks = [markers, lost].concat();
    let behind = u32::try_from(chunks.len()).unwrap_or(u32::MAX);
    if behind > MAX_DATA_LEN - data_len {
        return Err(refused(TOO_LONG));
    }
    copy.write_all(&chunks).map_err(failed)?;
    copy.rewind().map_err(failed)?;
    let header = layout.header(data_len, behind);
    copy.write_all(&header).map_err(failed)?;
    copy.flush().map_err(failed)
}

/// The chunks of markers in a sound of `frames` frames.
fn markers(cues: &[Cue], sample_rate_hz: u32, frames: u64) -> std::result::Result<Vec<u8>, String> {
    let (mut points, mut texts) = (Vec::new(), b"adtl".to_vec());
    points.extend_from_slice(&(cues.len() as u32).to_le_bytes());
    for (cue, number) in cues.iter().zip(1_u32..) {
        let frame = (cue.time_s * f64::from(sample_rate_hz)).round();
        if !(0.0..frames as f64).contains(&frame) {
            return Err(format!("a marker at {} s is outside of it", cue.time_s));
        }
        points.extend(point(number, frame as u32));
        let text = [&number.to_le_bytes(), cue.text.as_bytes(), b"\0"].concat();
        texts.extend(chunk(*b"labl", &text));
    }
    Ok([chunk(*b"cue ", &points), chunk(*b"LIST", &texts)].concat())
}

/// An entry of the chunk `cue `: its number, its position in the order of playing, the chunk that it is in, where that
/// and its block begin, and the frame in it.
fn point(number: u32, frame: u32) -> impl Iterator<Item = u8> {
    let data = u32::from_le_bytes(*b"data");
    let fields = [number, frame, data, 0, 0, frame];
    fields.into_iter().flat_map(u32::to_le_bytes)
}
