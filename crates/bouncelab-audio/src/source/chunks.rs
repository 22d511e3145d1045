//! The chunks of WAV, AIFF and CAF, and what must agree in the headers of samples of equal length.

use std::io::{self, Read, Seek, SeekFrom};
use std::ops::Range;

/// Maximum number of chunks that are read: recorders write fewer.
pub(super) const MAX_CHUNKS: usize = 64;

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
    /// Whether a recorder was stopped before it wrote the size of the sound, or the file is longer than its sizes state.
    pub(super) is_unfinished: bool,
    /// The content of the chunk with the losses of the recorder; empty without one.
    pub(super) lost: Vec<u8>,
    /// A reason to doubt the stated rate.
    pub(super) rate_doubt: Option<RateDoubt>,
    /// Numbers of the header that contradict each other, for the refusal.
    pub(super) contradiction: Option<String>,
    /// The codec, if the demuxer does not know it.
    pub(super) foreign_codec: Option<String>,
}

/// Why a stated rate may be wrong.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum RateDoubt {
    /// The bytes a second are those of this rate, in Hz.
    Contradicted(f64),
    /// No other number confirms it, and recorders seldom use it.
    Unusual,
}

/// The layout that a header states for samples of equal length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Samples {
    pub(super) channels: u64,
    /// Bits of a sample.
    pub(super) bits: u64,
}

impl Samples {
    /// Bytes of a frame: a sample takes whole bytes.
    pub(super) fn frame_bytes(self) -> u64 {
        self.channels * self.bits.div_ceil(8)
    }

    /// The refusal of a header that states another number of bytes for `what`, which holds `frames` frames.
    pub(super) fn contradiction(self, what: &str, frames: u64, stated: u64) -> String {
        let Self { channels, bits } = self;
        let implied = frames.saturating_mul(self.frame_bytes());
        format!(
            "it contradicts itself: {frames} frames of {channels} channels of {bits} bits take {implied} bytes, but \
             {what} has {stated}"
        )
    }
}

/// The chunks of a file, one after the other.
pub(super) struct Chunks<'a, S> {
    source: &'a mut S,
    pub(super) variant: Variant,
    /// Position at which the next one begins.
    at: u64,
    /// Where the file ends according to itself, in the variants whose sizes have 32 bits.
    pub(super) stated_end: u64,
    pub(super) file_len: u64,
}

/// How sizes are written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Variant {
    /// 32 bits.
    Riff,
    /// 32 bits, and those that do not fit in a chunk of their own.
    Rf64,
    /// 64 bits that count their own header.
    W64,
    /// 32 bits, the high byte first.
    Aiff,
    /// 64 bits, the high byte first, without padding.
    Caf,
}

impl<'a, S: Read + Seek> Chunks<'a, S> {
    /// Those of a file that begins at the present position.
    pub(super) fn new(source: &'a mut S) -> io::Result<Self> {
        let start = source.stream_position()?;
        let file_len = source.seek(SeekFrom::End(0))?;
        source.seek(SeekFrom::Start(start))?;
        let mut head = [0; 8];
        source.read_exact(&mut head)?;
        let [a, b, c, d, size @ ..] = head;
        let (variant, header, size) = match &[a, b, c, d] {
            b"RIFF" => (Variant::Riff, 12, u32::from_le_bytes(size)),
            b"FORM" => (Variant::Aiff, 12, u32::from_be_bytes(size)),
            b"riff" => (Variant::W64, 40, u32::MAX),
            b"caff" => (Variant::Caf, 8, u32::MAX),
            _ => (Variant::Rf64, 12, u32::MAX),
        };
        Ok(Self {
            source,
            variant,
            at: start + header,
            stated_end: start + 8 + u64::from(size),
            file_len,
        })
    }

    /// Name and content of the next chunk; `None` at the end of the file.
    pub(super) fn next(&mut self) -> io::Result<Option<([u8; 4], Range<u64>)>> {
        let (header, align) = match self.variant {
            Variant::W64 => (24, 8),
            Variant::Caf => (12, 1),
            Variant::Riff | Variant::Rf64 | Variant::Aiff => (8, 2),
        };
        let start = self.at.saturating_add(header);
        if start > self.file_len {
            return Ok(None);
        }
        let bytes = self.read(&(self.at..start))?;
        let long = || bytes.last_chunk().copied();
        let short = || bytes.last_chunk().copied();
        let len = match self.variant {
            Variant::W64 => long().map(|size| u64::from_le_bytes(size).saturating_sub(header)),
            Variant::Caf => long().map(u64::from_be_bytes),
            Variant::Aiff => short().map(|size| u32::from_be_bytes(size).into()),
            Variant::Riff | Variant::Rf64 => short().map(|size| u32::from_le_bytes(size).into()),
        };
        let (Some(&name), Some(len)) = (bytes.first_chunk(), len) else {
            return Ok(None);
        };
        let end = start.saturating_add(len);
        self.at = end.checked_next_multiple_of(align).unwrap_or(end);
        Ok(Some((name, start..end)))
    }

    /// Continues at the end of the sound, where that differs from the end of its chunk.
    pub(super) fn continue_at(&mut self, position: u64) {
        self.at = position;
    }

    /// Whether a chunk begins here, and no second file. It may be cut off, but not behind the end that the file states for itself.
    pub(super) fn is_at_chunk(&mut self) -> io::Result<bool> {
        const FILES: [&[u8]; 5] = [b"RIFF", b"RF64", b"BW64", b"riff", b"FORM"];
        let at = self.at;
        let name = self.read(&(at..at.saturating_add(4)))?;
        let end = self.next()?.map_or(at, |(_, content)| content.end);
        self.at = at;
        let is_name =
            name.iter().all(|letter| (b' '..=b'~').contains(letter)) && !FILES.contains(&&name[..]);
        Ok(is_name && (end <= self.file_len || self.file_len <= self.stated_end))
    }

    /// Whether bytes that no chunk counts follow here, as where bytes were inserted into the sound, a second piece follows
    /// it, or its size is too small. Part of a frame, padding with zeros and tags of music are not meant.
    pub(super) fn has_rest(&mut self) -> io::Result<bool> {
        /// Number of bytes that are looked at.
        const HEAD: u64 = 1 << 12;
        /// Files are padded to whole sectors, of this length in bytes.
        const SECTOR: u64 = 512;
        /// Minimum number of bytes.
        const MIN_REST: usize = 8;
        const TAGS: [&[u8]; 3] = [b"TAG", b"ID3", b"APETAGEX"];
        let rest = self.read(&(self.at..self.at.saturating_add(HEAD)))?;
        let is_tag = TAGS.iter().any(|tag| rest.starts_with(tag));
        let is_padding = self.file_len.is_multiple_of(SECTOR) && rest.iter().all(|&byte| byte == 0);
        Ok(rest.len() >= MIN_REST && !is_tag && !is_padding && !self.is_at_chunk()?)
    }

    /// The bytes of a range, fewer at the end of the file.
    pub(super) fn read(&mut self, range: &Range<u64>) -> io::Result<Vec<u8>> {
        let mut bytes = Vec::new();
        if range.start >= self.file_len {
            return Ok(bytes);
        }
        self.source.seek(SeekFrom::Start(range.start))?;
        (&mut *self.source)
            .take(range.end - range.start)
            .read_to_end(&mut bytes)?;
        Ok(bytes)
    }
}
