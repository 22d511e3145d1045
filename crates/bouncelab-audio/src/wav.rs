//! Samples to WAV files.

use std::fs::{self, File};
use std::io::{BufWriter, Cursor, Seek, Write};
use std::path::{Path, PathBuf};

use crate::error::{Error, Result};

/// How a sample is stored in a WAV file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum SampleFormat {
    /// 8-bit integers.
    Int8,
    /// 16-bit integers, as on a compact disc.
    Int16,
    /// 24-bit integers.
    Int24,
    /// 32-bit integers.
    Int32,
    /// 32-bit floating point.
    Float32,
}

impl SampleFormat {
    /// How many bits a sample takes.
    pub fn bits(self) -> u16 {
        match self {
            Self::Int8 => 8,
            Self::Int16 => 16,
            Self::Int24 => 24,
            Self::Int32 | Self::Float32 => 32,
        }
    }
}

/// Writes a WAV file: one slice of samples for each channel, all of the same length.
///
/// Samples are in `-1.0..1.0`; in the integer formats what lies outside is clipped, as a sound
/// card would. The file gets its name only once it is complete, so that a program that is
/// interrupted leaves nothing that looks like a whole recording.
///
/// ```no_run
/// use bouncelab_audio::{SampleFormat, write_wav};
///
/// let click: Vec<f32> = (0..441).map(|i| (-i as f32 / 50.0).exp()).collect();
/// write_wav("click.wav", 44_100, SampleFormat::Int16, &[&click])?;
/// # Ok::<(), bouncelab_audio::Error>(())
/// ```
///
/// # Errors
///
/// [`Error::Unwritable`] if there is no channel, the channels differ in length, a sample is not
/// a finite number, the rate is zero or the file would exceed 4 GB; [`Error::NotFound`] or
/// [`Error::Io`] if the system fails to write.
pub fn write_wav(
    path: impl AsRef<Path>,
    sample_rate_hz: u32,
    format: SampleFormat,
    channels: &[&[f32]],
) -> Result<()> {
    let path = path.as_ref();
    let name = path.display().to_string();
    let spec = check(&name, sample_rate_hz, format, channels)?;
    if path.is_dir() {
        return Err(Error::Directory { name });
    }
    let partial = partial_path(path);
    let written = File::create(&partial)
        .map_err(hound::Error::IoError)
        .and_then(|file| encode(BufWriter::new(file), spec, channels))
        .map_err(|fault| failed(&name, fault))
        .and_then(|()| fs::rename(&partial, path).map_err(|reason| Error::io(&name, reason)));
    if written.is_err() {
        // Nothing better can be done if even this fails; the first error is the one to tell.
        let _ = fs::remove_file(&partial);
    }
    written
}

/// The bytes that [`write_wav`] would write, for programs without a file system.
///
/// # Errors
///
/// [`Error::Unwritable`], as for [`write_wav`].
pub fn encode_wav(
    sample_rate_hz: u32,
    format: SampleFormat,
    channels: &[&[f32]],
) -> Result<Vec<u8>> {
    const NAME: &str = "WAV in memory";
    let spec = check(NAME, sample_rate_hz, format, channels)?;
    let mut bytes = Cursor::new(Vec::new());
    encode(&mut bytes, spec, channels).map_err(|fault| failed(NAME, fault))?;
    Ok(bytes.into_inner())
}

/// A name in the same folder, so that renaming is one step, and of this process alone.
fn partial_path(path: &Path) -> PathBuf {
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(format!(".{}.part", std::process::id()));
    path.with_file_name(name)
}

fn check(
    name: &str,
    sample_rate_hz: u32,
    format: SampleFormat,
    channels: &[&[f32]],
) -> Result<hound::WavSpec> {
    let refuse = |problem: String| {
        Err(Error::Unwritable {
            name: name.to_owned(),
            problem,
        })
    };
    let Some(first) = channels.first() else {
        return refuse("there is no channel".to_owned());
    };
    if sample_rate_hz == 0 {
        return refuse("the sample rate is zero".to_owned());
    }
    let Ok(count) = u16::try_from(channels.len()) else {
        return refuse(format!("{} channels are too many", channels.len()));
    };
    if let Some(other) = channels.iter().find(|channel| channel.len() != first.len()) {
        return refuse(format!(
            "channels of {} and {} samples",
            first.len(),
            other.len()
        ));
    }
    for (number, channel) in channels.iter().enumerate() {
        if let Some(place) = channel.iter().position(|sample| !sample.is_finite()) {
            return refuse(format!(
                "sample {place} of channel {number} is not a number"
            ));
        }
    }
    let bytes = first.len() as u64 * u64::from(count) * u64::from(format.bits() / 8);
    // The header's sizes have 32 bits and count the rest of the header too.
    if bytes > u64::from(u32::MAX) - 1024 {
        return refuse("a WAV file cannot hold more than 4 GB".to_owned());
    }
    Ok(hound::WavSpec {
        channels: count,
        sample_rate: sample_rate_hz,
        bits_per_sample: format.bits(),
        sample_format: match format {
            SampleFormat::Float32 => hound::SampleFormat::Float,
            _ => hound::SampleFormat::Int,
        },
    })
}

fn encode<W: Write + Seek>(
    target: W,
    spec: hound::WavSpec,
    channels: &[&[f32]],
) -> std::result::Result<(), hound::Error> {
    let mut writer = hound::WavWriter::new(target, spec)?;
    let full_scale = f64::from(spec.bits_per_sample - 1).exp2();
    for frame in 0..channels[0].len() {
        for channel in channels {
            match spec.sample_format {
                hound::SampleFormat::Float => writer.write_sample(channel[frame])?,
                hound::SampleFormat::Int => {
                    let level = (f64::from(channel[frame]) * full_scale).round();
                    writer.write_sample(level.clamp(-full_scale, full_scale - 1.0) as i32)?;
                }
            }
        }
    }
    writer.finalize()
}

fn failed(name: &str, fault: hound::Error) -> Error {
    match fault {
        hound::Error::IoError(reason) => Error::io(name, reason),
        other => Error::Unwritable {
            name: name.to_owned(),
            problem: other.to_string(),
        },
    }
}
