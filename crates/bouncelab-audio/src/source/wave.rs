//! Headers of WAV files that the demuxer cannot read: those of long recordings, whose sizes have 64
//! bits, and those of recorders that were stopped before they wrote the sizes.
//!
//! RF64 is EBU Tech 3306, BW64 its successor ITU-R BS.2088; W64 is the format of Sonic Foundry, with names
//! of 16 bytes that begin with the four letters of WAV.

use std::io::{self, Read, Seek};
use std::ops::Range;

use super::chunks::{Chunks, Header, MAX_CHUNKS, Mended, RateDoubt, Samples, Variant};
use super::codec;
use crate::lost_chunk;

/// Maximum length in bytes of the description of the sound (chunk `fmt `).
const MAX_FORMAT_LEN: u64 = 1 << 10;
/// Maximum length in bytes of the list of losses (chunk `lost`).
const MAX_LOST_LEN: u64 = 1 << 20;

/// The size of a chunk whose size stands elsewhere or was not known.
const UNKNOWN: u32 = u32::MAX;

/// The name with which a W64 file begins.
const W64_FILE: &[u8; 16] = b"riff\x2e\x91\xcf\x11\xa5\xd6\x28\xdb\x04\xc1\x00\x00";

/// Whether the first bytes are those of a WAV, RF64, BW64 or W64.
pub(crate) fn is_wave(head: &[u8]) -> bool {
    let is_long = head.starts_with(W64_FILE) && head.get(24..28) == Some(b"wave");
    let has_marker = [b"RIFF", b"RF64", b"BW64"]
        .iter()
        .any(|it| head.starts_with(*it));
    is_long || (has_marker && head.get(8..12) == Some(b"WAVE"))
}

/// Reads the header of a file that begins at the present position.
pub(super) fn header<S: Read + Seek>(source: &mut S) -> io::Result<Header> {
    let mut chunks = Chunks::new(source)?;
    let mut header = Header::default();
    let (mut format, mut sizes, mut has_sound) = (Format::default(), None, false);
    for _ in 0..MAX_CHUNKS {
        let Some((name, content)) = chunks.next()? else {
            break;
        };
        let len = content.end - content.start;
        match &name {
            b"fmt " if !has_sound && len <= MAX_FORMAT_LEN => {
                format = Format::new(chunks.read(&content)?);
            }
            b"ds64" if !has_sound => {
                sizes = chunks
                    .read(&(content.start..content.start + 16))?
                    .last_chunk()
                    .copied();
            }
            b"data" if !has_sound => {
                has_sound = true;
                let sizes = sizes.map(u64::from_le_bytes);
                let (end, is_known) = sound_end(&mut chunks, &content, sizes)?;
                // Some programs leave the padding of an odd length out.
                if end != content.end || !chunks.is_at_chunk()? {
                    chunks.continue_at(end);
                }
                header.is_unfinished = !is_known || chunks.has_rest()?;
                // The demuxer reads from the header itself what that states right.
                let is_mended = chunks.variant != Variant::Riff
                    || end != content.end
                    || content.end > chunks.stated_end
                    || format.is_mended;
                if is_mended && !format.bytes.is_empty() {
                    header.mended = Some(mended(&format.bytes, content.start..end));
                }
            }
            // Two recordings were joined.
            b"data" => header.is_unfinished = true,
            name if *name == lost_chunk::NAME && header.lost.is_empty() && len <= MAX_LOST_LEN => {
                header.lost = chunks.read(&content)?;
            }
            _ => {}
        }
    }
    header.rate_doubt = format.other_rate_hz.map(RateDoubt::Contradicted);
    header.contradiction = format.contradiction;
    header.foreign_codec = format.foreign_codec;
    Ok(header)
}

/// Where the sound ends, and whether the file states it.
fn sound_end<S: Read + Seek>(
    chunks: &mut Chunks<S>,
    content: &Range<u64>,
    long: Option<u64>,
) -> io::Result<(u64, bool)> {
    let stated = match chunks.variant {
        Variant::Rf64 if content.end - content.start == u64::from(UNKNOWN) => {
            content.start.saturating_add(long.unwrap_or(0))
        }
        _ => content.end,
    };
    let (stated_end, file_len) = (chunks.stated_end, chunks.file_len);
    if stated > content.start {
        return Ok((stated, true));
    }
    if chunks.variant != Variant::Riff {
        return Ok((file_len, false));
    }
    if content.start >= file_len || chunks.is_at_chunk()? {
        return Ok((stated, true));
    }
    // The recorder wrote no size of the sound, although sound follows: that of the file may count it.
    let is_counted = (content.start + 1..=file_len).contains(&stated_end);
    let end = if is_counted { stated_end } else { file_len };
    Ok((end, is_counted))
}

/// The description of the sound, and what in it contradicts itself.
#[derive(Debug, Default, PartialEq)]
struct Format {
    /// As the demuxer can read it.
    bytes: Vec<u8>,
    is_mended: bool,
    /// The rate in Hz that follows from the bytes a second, where it differs from the stated rate.
    other_rate_hz: Option<f64>,
    contradiction: Option<String>,
    /// The codec, if the demuxer does not know it.
    foreign_codec: Option<String>,
}

impl Format {
    /// Compares channels, bits, bytes of a frame and bytes a second. Only for codecs whose frames have equal lengths.
    /// Zeros were not known to the recorder.
    fn new(bytes: Vec<u8>) -> Self {
        /// Their codes: PCM, floating point, A-law, mu-law, and that of an extensible header.
        const EQUAL_FRAMES: [u16; 5] = [1, 3, A_LAW, MU_LAW, 0xfffe];
        const A_LAW: u16 = 6;
        const MU_LAW: u16 = 7;
        /// The codes of the two kinds of ADPCM that the demuxer knows besides.
        const ADPCM: [u16; 2] = [2, 0x11];
        /// Bits of samples that some recorders write in four bytes each (`S24_LE` of ALSA).
        const SHORT_BITS: u64 = 24;
        let word = |at: usize| Some(u16::from_le_bytes(*bytes.get(at..)?.first_chunk()?));
        let double = |at: usize| Some(u32::from_le_bytes(*bytes.get(at..)?.first_chunk()?));
        let fields = (word(0), word(2), double(4), double(8), word(12), word(14));
        let is_known = |code: &u16| EQUAL_FRAMES.contains(code) || ADPCM.contains(code);
        let mut format = Self {
            foreign_codec: fields
                .0
                .filter(|it| !is_known(it))
                .map(codec::name_of_number),
            ..Self::default()
        };
        if let (Some(code), Some(channels), Some(rate), Some(per_s), Some(align), Some(bits)) =
            fields
            && EQUAL_FRAMES.contains(&code)
        {
            let samples = Samples {
                channels: channels.into(),
                // Those may state the bits of the decoded sample.
                bits: if matches!(code, A_LAW | MU_LAW) {
                    8
                } else {
                    bits.into()
                },
            };
            let frame_bytes = samples.frame_bytes();
            let (rate, per_s, align) = (u64::from(rate), u64::from(per_s), u64::from(align));
            let is_wide = samples.bits == SHORT_BITS && align == 4 * samples.channels;
            if is_wide && per_s == rate * align {
                format.is_mended = true;
            } else if align != 0 && align != frame_bytes && per_s != rate * frame_bytes {
                format.contradiction = Some(samples.contradiction("a block", 1, align));
            } else if per_s != 0 && per_s.abs_diff(rate * frame_bytes) >= frame_bytes {
                format.other_rate_hz = Some(per_s as f64 / frame_bytes as f64);
            }
        }
        format.bytes = bytes;
        if format.is_mended {
            format.bytes[14..16].copy_from_slice(&32_u16.to_le_bytes());
        }
        format
    }
}

/// A header with this description for the sound in this range.
fn mended(format: &[u8], sound: Range<u64>) -> Mended {
    let len = u32::try_from(sound.end - sound.start);
    let format_len = (format.len() as u32).to_le_bytes();
    let mut header = b"RIFF\xff\xff\xff\xffWAVEfmt ".to_vec();
    header.extend_from_slice(&format_len);
    header.extend_from_slice(format);
    header.extend_from_slice(&[0][..format.len() % 2]);
    header.extend_from_slice(b"data");
    header.extend_from_slice(&len.unwrap_or(UNKNOWN).to_le_bytes());
    Mended { header, sound }
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::*;

    /// Format, channels, rate, bytes a second, bytes of a frame, bits.
    fn format(tag: u16, channels: u16, numbers: [u32; 2], [align, bits]: [u16; 2]) -> Format {
        let mut bytes = [tag, channels].map(u16::to_le_bytes).concat();
        bytes.extend(numbers.map(u32::to_le_bytes).concat());
        bytes.extend([align, bits].map(u16::to_le_bytes).concat());
        Format::new(bytes)
    }

    #[test]
    fn a_rate_that_contradicts_the_bytes_a_second_is_noted() {
        let other_rate_hz =
            |tag, rate_hz, per_s| format(tag, 1, [rate_hz, per_s], [2, 16]).other_rate_hz;
        assert_eq!(other_rate_hz(1, 44_100, 88_200), None);
        assert_eq!(other_rate_hz(1, 44_100, 96_000), Some(48_000.0));
        assert_eq!(other_rate_hz(3, 44_100, 0), None);
        // Frames of other formats are not equal.
        assert_eq!(other_rate_hz(2, 44_100, 22_311), None);
        assert_eq!(Format::new(vec![1; 10]).other_rate_hz, None);
    }

    /// One bit in the number of channels or bits; a block that alone is wrong is harmless.
    #[test]
    fn channels_and_bits_that_contradict_block_and_bytes_a_second_are_refused() {
        let refused = |channels, block| {
            let format = format(1, channels, [44_100, 88_200], block);
            format.contradiction.is_some()
        };
        assert!(refused(3, [2, 16]) && refused(1, [2, 24]) && refused(5, [2, 16]));
        assert!(!refused(1, [2, 16]) && !refused(1, [6, 16]) && !refused(1, [0, 16]));
    }

    /// 24 bits in four bytes are 32 bits, of which the highest repeat the sign.
    #[test]
    fn samples_of_24_bits_in_four_bytes_are_read_as_32_bits() {
        let wide = format(1, 2, [48_000, 384_000], [8, 24]);
        assert!(wide.is_mended);
        assert_eq!(wide.bytes[14..16], [32, 0]);
        assert!(!format(1, 2, [48_000, 288_000], [6, 24]).is_mended);
    }

    #[test]
    fn an_ordinary_header_stays_as_it_is() {
        let wav = crate::encode_wav(8_000, crate::SampleFormat::Int16, &[&[0.5; 100]]).unwrap();
        assert_eq!(header(&mut Cursor::new(wav)).unwrap(), Header::default());
    }
}
