//! Headers of WAV files that the demuxer cannot read: those of long recordings, whose sizes have 64
//! bits, and those of recorders that were stopped before they wrote the sizes.
//!
//! RF64 is EBU Tech 3306, BW64 its successor ITU-R BS.2088; W64 is the format of Sonic Foundry, with names
//! of 16 bytes that begin with the four letters of WAV.

use std::io::{self, Read, Seek, SeekFrom};
use std::ops::Range;

use crate::lost_chunk;

/// Maximum number of chunks that are read: recorders write fewer in front of the sound.
const MAX_CHUNKS: usize = 64;
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

/// A header that the demuxer can read, and the range of bytes of the sound behind it.
#[derive(Debug, PartialEq)]
pub(super) struct Mended {
    pub(super) header: Vec<u8>,
    pub(super) sound: Range<u64>,
}

/// What a file states in front of its sound and behind it.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Header {
    /// A replacement, if the demuxer cannot read the header.
    pub(super) mended: Option<Mended>,
    /// Whether a recorder was stopped before it wrote the size of the sound, or more sound follows than the size states.
    pub(super) is_unfinished: bool,
    /// The content of the chunk with the losses of the recorder; empty without one.
    pub(super) lost: Vec<u8>,
    /// The rate in Hz that follows from the stated bytes per second, where it differs from the stated rate.
    pub(super) other_rate_hz: Option<f64>,
}

/// Reads the header of a file that begins at the present position.
pub(super) fn header<S: Read + Seek>(source: &mut S) -> io::Result<Header> {
    let start = source.stream_position()?;
    let file_len = source.seek(SeekFrom::End(0))?;
    let mut chunks = Chunks::new(source, start)?;
    let mut header = Header::default();
    let (mut format, mut sizes, mut has_sound) = (Vec::new(), None, false);
    for _ in 0..MAX_CHUNKS {
        let Some((name, content)) = chunks.next(file_len)? else {
            break;
        };
        let len = content.end - content.start;
        if has_sound && is_uncounted(name, file_len.saturating_sub(content.start), &format) {
            header.is_unfinished = true;
            break;
        }
        match &name {
            b"fmt " if !has_sound && len <= MAX_FORMAT_LEN => format = chunks.read(&content)?,
            b"ds64" if !has_sound => {
                sizes = chunks
                    .read(&(content.start..content.start + 16))?
                    .last_chunk()
                    .copied();
            }
            b"data" if !has_sound => {
                has_sound = true;
                let size = chunks.sound_size(&content, sizes.map(u64::from_le_bytes));
                let usable_size = size.filter(|_| !format.is_empty());
                header.is_unfinished = usable_size == Some(0);
                header.mended = usable_size.map(|size| {
                    let end = match size {
                        0 => file_len,
                        len => content.start.saturating_add(len),
                    };
                    Mended::new(&format, content.start..end)
                });
            }
            name if *name == lost_chunk::NAME && header.lost.is_empty() && len <= MAX_LOST_LEN => {
                header.lost = chunks.read(&content)?;
            }
            _ => {}
        }
    }
    header.other_rate_hz = other_rate_hz(&format);
    Ok(header)
}

/// Whether the bytes behind the sound are sound too: a second piece, or more than a second of bytes that are no chunk.
fn is_uncounted(name: [u8; 4], behind: u64, format: &[u8]) -> bool {
    let bytes_per_s = number(format, 8).unwrap_or(0);
    let is_name = name.iter().all(|letter| (b' '..=b'~').contains(letter));
    name == *b"data" || (!is_name && bytes_per_s > 0 && behind > bytes_per_s.into())
}

/// The rate that follows from the bytes per second, if the description contradicts itself. Only for codecs whose frames
/// have equal lengths.
fn other_rate_hz(format: &[u8]) -> Option<f64> {
    /// Their codes: PCM, floating point, and that of an extensible header.
    const EQUAL_FRAMES: [u16; 3] = [1, 3, 0xfffe];
    let word = |at: usize| Some(u16::from_le_bytes(*format.get(at..)?.first_chunk()?));
    let (rate_hz, bytes_per_s, frame_bytes) = (number(format, 4)?, number(format, 8)?, word(12)?);
    // Some recorders write zero for what they do not know.
    let states = EQUAL_FRAMES.contains(&word(0)?) && bytes_per_s > 0 && frame_bytes > 0;
    let implied_hz = f64::from(bytes_per_s) / f64::from(frame_bytes);
    (states && (implied_hz - f64::from(rate_hz)).abs() >= 1.0).then_some(implied_hz)
}

/// The number of 32 bits at an offset in a description of sound.
fn number(format: &[u8], at: usize) -> Option<u32> {
    Some(u32::from_le_bytes(*format.get(at..)?.first_chunk()?))
}

impl Mended {
    fn new(format: &[u8], sound: Range<u64>) -> Self {
        let len = u32::try_from(sound.end - sound.start);
        let format_len = (format.len() as u32).to_le_bytes();
        let mut header = b"RIFF\xff\xff\xff\xffWAVEfmt ".to_vec();
        header.extend_from_slice(&format_len);
        header.extend_from_slice(format);
        header.extend_from_slice(&[0][..format.len() % 2]);
        header.extend_from_slice(b"data");
        header.extend_from_slice(&len.unwrap_or(UNKNOWN).to_le_bytes());
        Self { header, sound }
    }
}

/// The chunks of a file, one after the other.
struct Chunks<'a, S> {
    source: &'a mut S,
    variant: Variant,
    /// Position at which the next one begins.
    at: u64,
    /// The size that the file states for itself, without its first eight bytes.
    stated_size: u64,
}

#[derive(Clone, Copy, PartialEq)]
enum Variant {
    /// Sizes of 32 bits.
    Riff,
    /// Sizes of 32 bits, and those that do not fit in a chunk of their own.
    Rf64,
    /// Sizes of 64 bits that count their own header.
    W64,
}

impl<'a, S: Read + Seek> Chunks<'a, S> {
    fn new(source: &'a mut S, start: u64) -> io::Result<Self> {
        source.seek(SeekFrom::Start(start))?;
        let mut head = [0; 8];
        source.read_exact(&mut head)?;
        let [a, b, c, d, size @ ..] = head;
        let (variant, header) = match &[a, b, c, d] {
            b"RIFF" => (Variant::Riff, 12),
            b"riff" => (Variant::W64, 40),
            _ => (Variant::Rf64, 12),
        };
        Ok(Self {
            source,
            variant,
            at: start + header,
            stated_size: u32::from_le_bytes(size).into(),
        })
    }

    /// Name and content of the next chunk; `None` at the end of the file.
    fn next(&mut self, file_len: u64) -> io::Result<Option<([u8; 4], Range<u64>)>> {
        let (header, align) = if self.variant == Variant::W64 {
            (24, 8)
        } else {
            (8, 2)
        };
        let start = self.at.saturating_add(header);
        if start > file_len {
            return Ok(None);
        }
        let bytes = self.read(&(self.at..start))?;
        let (Some(&name), Some(size)) = (bytes.first_chunk(), bytes.get(header as usize - 4..))
        else {
            return Ok(None);
        };
        let len = match (self.variant, bytes.last_chunk(), size.first_chunk()) {
            (Variant::W64, Some(&size), _) => u64::from_le_bytes(size).saturating_sub(header),
            (_, _, Some(&size)) => u32::from_le_bytes(size).into(),
            _ => return Ok(None),
        };
        let end = start.saturating_add(len);
        self.at = end.checked_next_multiple_of(align).unwrap_or(end);
        Ok(Some((name, start..end)))
    }

    /// The bytes of a range, fewer at the end of the file.
    fn read(&mut self, range: &Range<u64>) -> io::Result<Vec<u8>> {
        let mut bytes = Vec::new();
        self.source.seek(SeekFrom::Start(range.start))?;
        (&mut *self.source)
            .take(range.end - range.start)
            .read_to_end(&mut bytes)?;
        Ok(bytes)
    }

    /// The size of the sound in bytes, 0 if it was not known yet; `None` if the demuxer reads it from the header itself.
    fn sound_size(&self, content: &Range<u64>, size: Option<u64>) -> Option<u64> {
        let len = content.end - content.start;
        match self.variant {
            // The recorder wrote no sizes, although sound follows.
            Variant::Riff if len == 0 && content.start >= self.stated_size + 8 => Some(0),
            // The chunk is longer than the file states for itself: the size in front of the sound counts.
            Variant::Riff if content.end > self.stated_size + 8 => Some(len),
            Variant::Riff => None,
            Variant::Rf64 if len == u64::from(UNKNOWN) => Some(size.unwrap_or(0)),
            Variant::Rf64 | Variant::W64 => Some(len),
        }
    }
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::*;

    /// Format, channels, rate, bytes a second, bytes of a frame, bits: as of 16 bits.
    fn format(tag: u16, rate_hz: u32, bytes_per_s: u32) -> Vec<u8> {
        let mut format = [tag, 1].map(u16::to_le_bytes).concat();
        format.extend([rate_hz, bytes_per_s].map(u32::to_le_bytes).concat());
        format.extend([2_u16, 16].map(u16::to_le_bytes).concat());
        format
    }

    #[test]
    fn a_rate_that_contradicts_the_bytes_a_second_is_noted() {
        assert_eq!(other_rate_hz(&format(1, 44_100, 88_200)), None);
        assert_eq!(other_rate_hz(&format(1, 44_100, 96_000)), Some(48_000.0));
        assert_eq!(other_rate_hz(&format(3, 44_100, 0)), None);
        // Frames of other formats are not equal.
        assert_eq!(other_rate_hz(&format(2, 44_100, 22_311)), None);
        assert_eq!(other_rate_hz(&format(1, 44_100, 88_200)[..10]), None);
    }

    #[test]
    fn an_ordinary_header_stays_as_it_is() {
        let wav = crate::encode_wav(8_000, crate::SampleFormat::Int16, &[&[0.5; 100]]).unwrap();
        assert_eq!(header(&mut Cursor::new(wav)).unwrap(), Header::default());
    }
}
