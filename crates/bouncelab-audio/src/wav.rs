//! Encodes WAV files.

use bouncelab::analysis::Gap;

use crate::error::{Error, Result};
use crate::lost_chunk;

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
    /// Number of bits of a sample.
    pub fn bits(self) -> u16 {
        match self {
            Self::Int8 => 8,
            Self::Int16 => 16,
            Self::Int24 => 24,
            Self::Int32 | Self::Float32 => 32,
        }
    }

    pub(crate) fn encode(self, sample: f32, target: &mut Vec<u8>) {
        let full_scale = f64::from(self.bits() - 1).exp2();
        let scaled = (f64::from(sample) * full_scale).round();
        let level = scaled.clamp(-full_scale, full_scale - 1.0) as i32;
        match self {
            // In WAV files samples of 8 bits, and only these, have no sign.
            Self::Int8 => target.push((level + 128) as u8),
            Self::Int16 | Self::Int24 | Self::Int32 => {
                target.extend_from_slice(&level.to_le_bytes()[..usize::from(self.bits() / 8)]);
            }
            Self::Float32 => target.extend_from_slice(&sample.to_le_bytes()),
        }
    }
}

/// A WAV file: one slice of samples for each channel, all of the same length.
///
/// Samples are in `-1.0..1.0`; the integer formats clip samples outside this range, as a sound
/// card does.
///
/// ```
/// use bouncelab_audio::{SampleFormat, encode_wav};
///
/// let click: Vec<f32> = (0..441).map(|i| (-i as f32 / 50.0).exp()).collect();
/// let wav = encode_wav(44_100, SampleFormat::Int16, &[&click])?;
/// assert!(wav.starts_with(b"RIFF"));
/// # Ok::<(), bouncelab_audio::Error>(())
/// ```
///
/// # Errors
///
/// [`Error::Unwritable`] if there is no channel, the channels differ in length, a sample is not
/// a finite number, the rate is zero or the file would exceed 4 GB.
pub fn encode_wav(
    sample_rate_hz: u32,
    format: SampleFormat,
    channels: &[&[f32]],
) -> Result<Vec<u8>> {
    Ok(Sound::new("WAV in memory", sample_rate_hz, format, channels)?.encode())
}

/// Notes where sound was lost and silence stands in its place, in a WAV file that [`encode_wav`] made.
pub fn note_gaps(wav: &mut Vec<u8>, sample_rate_hz: u32, gaps: &[Gap]) {
    /// What the size of the whole does not count: its name and itself.
    const HEAD_LEN: usize = 8;
    wav.extend(lost_chunk::encode(gaps, sample_rate_hz));
    let size = (wav.len() - HEAD_LEN) as u32;
    wav[4..HEAD_LEN].copy_from_slice(&size.to_le_bytes());
}

/// A sound that fits into a WAV file.
struct Sound<'a> {
    layout: WavLayout,
    channels: &'a [&'a [f32]],
    /// The size of all samples.
    data_len: u32,
}

impl<'a> Sound<'a> {
    fn new(
        name: &str,
        sample_rate_hz: u32,
        format: SampleFormat,
        channels: &'a [&'a [f32]],
    ) -> Result<Self> {
        let layout = WavLayout::new(name, sample_rate_hz, channels.len(), format)?;
        let frames = channels[0].len();
        if let Some(other) = channels.iter().find(|channel| channel.len() != frames) {
            let problem = format!("channels of {frames} and {} samples", other.len());
            return Err(Error::unwritable(name, problem));
        }
        for (number, channel) in channels.iter().enumerate() {
            if let Some(index) = channel.iter().position(|sample| !sample.is_finite()) {
                let problem = format!("sample {index} of channel {number} is not a number");
                return Err(Error::unwritable(name, problem));
            }
        }
        let data_len = u32::try_from(frames as u64 * u64::from(layout.frame_len()));
        match data_len {
            Ok(data_len @ ..=MAX_DATA_LEN) => Ok(Self {
                layout,
                channels,
                data_len,
            }),
            _ => Err(Error::unwritable(name, TOO_LONG)),
        }
    }

    /// The whole file.
    fn encode(&self) -> Vec<u8> {
        let size = HEADER_LEN as usize + self.data_len as usize + 1;
        let mut bytes = Vec::with_capacity(size);
        bytes.extend_from_slice(&self.layout.header(self.data_len, 0));
        for frame in 0..self.channels[0].len() {
            for channel in self.channels {
                self.layout.format.encode(channel[frame], &mut bytes);
            }
        }
        bytes.extend_from_slice(&[0][..(self.data_len % 2) as usize]);
        bytes
    }
}

/// A chunk, padded to an even length.
pub(crate) fn chunk(name: [u8; 4], content: &[u8]) -> Vec<u8> {
    let len = content.len() as u32;
    let padding = &[0][..content.len() % 2];
    [&name, &len.to_le_bytes(), content, padding].concat()
}

/// The length of a header in bytes.
pub(crate) const HEADER_LEN: u32 = 44;

/// Maximum number of bytes of samples: sizes have 32 bits, and count most of the header.
pub(crate) const MAX_DATA_LEN: u32 = u32::MAX - 64;

/// The problem of sound beyond it.
pub(crate) const TOO_LONG: &str = "a WAV file cannot hold more than 4 GB";

/// The layout of samples in a header: the rate is above zero, and a frame has 1 to 65535 bytes.
#[derive(Debug, Clone, Copy)]
pub(crate) struct WavLayout {
    pub(crate) sample_rate_hz: u32,
    pub(crate) channels: u16,
    pub(crate) format: SampleFormat,
}

impl WavLayout {
    /// The layout of a file of this name, for messages.
    pub(crate) fn new(
        name: &str,
        sample_rate_hz: u32,
        channels: usize,
        format: SampleFormat,
    ) -> Result<Self> {
        let frame_len = channels.checked_mul(usize::from(format.bits() / 8));
        let frame_fits = frame_len.is_some_and(|len| u16::try_from(len).is_ok());
        let problem = match channels {
            0 => "there is no channel".to_owned(),
            _ if sample_rate_hz == 0 => "the sample rate is zero".to_owned(),
            _ if !frame_fits => format!("{channels} channels are too many"),
            _ => {
                return Ok(Self {
                    sample_rate_hz,
                    channels: channels as u16,
                    format,
                });
            }
        };
        Err(Error::unwritable(name, problem))
    }

    /// Number of bytes of a frame, the samples of all channels at one time.
    pub(crate) fn frame_len(self) -> u16 {
        self.channels * (self.format.bits() / 8)
    }

    /// The header of a file with `data_len` bytes of samples, and `behind` bytes of other chunks behind them.
    ///
    /// It is the plain header of 1991, not the later "extensible" one: that states the
    /// position of a loudspeaker for each channel, which is unknown here, and some programs refuse mono whose
    /// only channel is "front left".
    pub(crate) fn header(self, data_len: u32, behind: u32) -> [u8; HEADER_LEN as usize] {
        let padding = data_len % 2;
        let is_float = self.format == SampleFormat::Float32;
        let bytes_per_second = self
            .sample_rate_hz
            .saturating_mul(u32::from(self.frame_len()));
        let mut header = [0; HEADER_LEN as usize];
        let fields: [&[u8]; 13] = [
            b"RIFF",
            &(HEADER_LEN - 8 + data_len + padding + behind).to_le_bytes(),
            b"WAVE",
            b"fmt ",
            &16_u32.to_le_bytes(),
            &(if is_float { 3_u16 } else { 1 }).to_le_bytes(),
            &self.channels.to_le_bytes(),
            &self.sample_rate_hz.to_le_bytes(),
            &bytes_per_second.to_le_bytes(),
            &self.frame_len().to_le_bytes(),
            &self.format.bits().to_le_bytes(),
            b"data",
            &data_len.to_le_bytes(),
        ];
        for (target, byte) in header.iter_mut().zip(fields.into_iter().flatten()) {
            *target = *byte;
        }
        header
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Input;

    #[test]
    fn gaps_come_back_with_the_sound() {
        // An odd number of bytes is padded.
        for format in [SampleFormat::Float32, SampleFormat::Int8] {
            let samples = vec![0.5; 8_001];
            let mut wav = encode_wav(8_000, format, &[&samples]).unwrap();
            let gap = Gap {
                start_s: 0.25,
                duration_s: 0.5,
                certain: true,
            };
            note_gaps(&mut wav, 8_000, &[gap]);
            let Ok(Input::Sound(mut source)) = Input::from_bytes(wav, "lost.wav") else {
                panic!("it is a sound");
            };
            let mut frames = 0;
            while let Some(block) = source.next_block().unwrap() {
                frames += block.channel(0).len();
            }
            assert_eq!((frames, source.gaps()), (samples.len(), &[gap][..]));
            assert_eq!(source.warnings().len(), 1);
        }
    }
}
