//! What the headers of AIFF and CAF state more than once, which the demuxers do not compare.
//!
//! AIFF is Apple's Audio Interchange File Format 1.3 and AIFF-C, CAF the Core Audio Format Specification 1.0.

use std::io::{self, Read, Seek};

use super::alac::alac_setup;
use super::chunks::{Chunks, Header, MAX_CHUNKS, RateDoubt, Samples, Variant};

/// The rates in Hz at which recorders write these formats. They state the rate only once, and one wrong bit in it may
/// give another rate of recorders: half or double.
const USUAL_HZ: [f64; 2] = [44_100.0, 48_000.0];

/// Bytes of the chunk of the sound of AIFF in front of its samples: their offset and the size of a block.
const AIFF_SOUND: u64 = 8;

/// Maximum length in bytes of a description of the sound that is read.
const MAX_DESCRIPTION: u64 = 1 << 10;

/// Reads the header of a file that begins at the present position.
pub(super) fn header<S: Read + Seek>(source: &mut S) -> io::Result<Header> {
    let mut chunks = Chunks::new(source)?;
    let mut header = Header::default();
    let mut description = None;
    let mut cookie_hz = None;
    for _ in 0..MAX_CHUNKS {
        let Some((name, content)) = chunks.next()? else {
            break;
        };
        let len = content.end - content.start;
        match &name {
            b"COMM" | b"desc" if description.is_none() && len <= MAX_DESCRIPTION => {
                let bytes = chunks.read(&content)?;
                description = match chunks.variant {
                    Variant::Caf => Description::of_caf(&bytes),
                    _ => Description::of_aiff(&bytes),
                };
            }
            // The set-up of ALAC states the rate again.
            b"kuki" if len <= MAX_DESCRIPTION => {
                let bytes = chunks.read(&content)?;
                cookie_hz = alac_setup(&bytes).and_then(|it| it.last_chunk().copied());
            }
            b"SSND" | b"data" => {
                // In AIFF the samples may begin later by a stated number of bytes.
                let offset = chunks.read(&(content.start..content.start + 4))?;
                let offset = offset.first_chunk().map_or(0, |&it| u32::from_be_bytes(it));
                let sound = len.saturating_sub(AIFF_SOUND + u64::from(offset));
                let stated = description.as_ref();
                header.contradiction = stated.and_then(|it| it.contradiction(sound));
                header.is_unfinished = chunks.has_rest()?;
                break;
            }
            _ => {}
        }
    }
    // Decoders of compressed sound have another number of the rate.
    let is_doubtful = |it: &Description| it.samples.is_some() && !USUAL_HZ.contains(&it.rate_hz);
    let other_hz = description.as_ref().map(|it| it.rate_hz).filter(|rate_hz| {
        let cookie_hz = cookie_hz.map(|it| f64::from(u32::from_be_bytes(it)));
        cookie_hz.is_some_and(|cookie_hz| (cookie_hz - rate_hz).abs() >= 1.0)
    });
    header.rate_doubt = match other_hz {
        Some(other_hz) => Some(RateDoubt::Contradicted(other_hz)),
        None => description.filter(is_doubtful).map(|_| RateDoubt::Unusual),
    };
    Ok(header)
}

/// The description of the sound.
#[derive(Debug, PartialEq)]
struct Description {
    rate_hz: f64,
    /// The layout; `None` for compressed sound.
    samples: Option<Samples>,
    /// Number of frames, or in CAF of one, and the stated number of their bytes; in AIFF that of the chunk of the sound.
    frames: u64,
    bytes: Option<u64>,
}

impl Description {
    /// Parses the chunk `COMM`: channels, frames, bits, rate, and in AIFF-C the compression.
    fn of_aiff(bytes: &[u8]) -> Option<Self> {
        const SHORT: [&[u8]; 4] = [b"alaw", b"ALAW", b"ulaw", b"ULAW"];
        let stated_bits = u16::from_be_bytes(*bytes.get(6..)?.first_chunk()?);
        // A-law and mu-law may state the bits of the decoded sample.
        let is_short = bytes.get(18..22).is_some_and(|it| SHORT.contains(&it));
        Some(Self {
            rate_hz: extended(*bytes.get(8..)?.first_chunk()?),
            samples: Some(Samples {
                channels: u16::from_be_bytes(*bytes.first_chunk()?).into(),
                bits: if is_short { 8 } else { stated_bits.into() },
            }),
            frames: u32::from_be_bytes(*bytes.get(2..)?.first_chunk()?).into(),
            bytes: None,
        })
    }

    /// Parses the chunk `desc`: rate, format, flags, bytes and frames of a packet, channels, bits.
    fn of_caf(bytes: &[u8]) -> Option<Self> {
        const PLAIN: [&[u8]; 3] = [b"lpcm", b"alaw", b"ulaw"];
        let number = |at: usize| {
            let bytes = *bytes.get(at..)?.first_chunk()?;
            Some(u64::from(u32::from_be_bytes(bytes)))
        };
        let samples = Samples {
            channels: number(24)?,
            bits: number(28)?,
        };
        let is_plain = bytes.get(8..12).is_some_and(|it| PLAIN.contains(&it));
        Some(Self {
            rate_hz: f64::from_be_bytes(*bytes.first_chunk()?),
            samples: is_plain.then_some(samples),
            frames: number(20)?,
            bytes: Some(number(16)?),
        })
    }

    /// What contradicts the layout: the length of a packet in CAF, in AIFF that of the sound, in bytes. A recorder that
    /// was stopped leaves zeros, and writers pad the sound to an even length.
    fn contradiction(&self, sound: u64) -> Option<String> {
        let samples = self.samples?;
        let implied = self.frames.saturating_mul(samples.frame_bytes());
        let (what, stated, tolerance) = match self.bytes {
            Some(bytes) => ("a packet", bytes, 0),
            None => ("the sound", sound, 1),
        };
        let is_unknown = self.bytes.is_none() && (sound == 0 || self.frames == 0);
        let agrees = is_unknown || stated.abs_diff(implied) <= tolerance;
        (!agrees).then(|| samples.contradiction(what, self.frames, stated))
    }
}

/// A number of 80 bits (IEEE 754 extended): sign and exponent in 16 bits, then the significand with its integer bit.
fn extended(bytes: [u8; 10]) -> f64 {
    let [high, low, significand @ ..] = bytes;
    let exponent = i32::from(u16::from_be_bytes([high & 0x7f, low])) - 16_383 - 63;
    u64::from_be_bytes(significand) as f64 * 2_f64.powi(exponent)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The rates of most recorders, of which one bit is that of the other.
    #[test]
    fn numbers_of_80_bits_are_read() {
        for (low, rate_hz) in [(0x0e, 44_100.0), (0x0d, 22_050.0)] {
            let read_hz = extended([0x40, low, 0xac, 0x44, 0, 0, 0, 0, 0, 0]);
            assert!((read_hz - rate_hz).abs() < 1e-9, "{read_hz}");
        }
    }
}
