//! Surveys a file for the places where frames are missing.
//!
//! The demuxers in use skip damaged bytes without an error, and streams of MP3 and ADTS have no clock that would show
//! it. So the file is surveyed before it is read: the demuxer gets only whole frames, and how much sound is missing
//! between them is counted as far as the file states it.

mod mpeg;
mod nested;
mod ogg;
mod parts;

use std::io::{self, Read, Seek, SeekFrom};
use std::ops::Range;

use crate::formats::SoundFormat;

/// Maximum number of places where frames are missing: a file with more is refused.
const MAX_BREAKS: usize = 1_000;

/// The result of a survey.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Framing {
    /// The ranges of bytes to read; `None` for the whole file.
    pub(super) sound: Option<Vec<Range<u64>>>,
    /// The places where frames are missing, in order.
    pub(super) breaks: Vec<Break>,
    /// Whether the file ends within a frame.
    pub(super) is_cut: bool,
    /// Whether a checksum shows that the frames differ from the encoded ones although none is missing.
    pub(super) is_altered: bool,
}

/// A place where frames are missing.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Break {
    /// The track, in a format with several.
    pub(super) track: Option<u32>,
    /// Number of packets of the track before it.
    pub(super) packet: u64,
    pub(super) missing: Missing,
}

/// How much is missing.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Missing {
    /// A number of packets.
    Packets { count: u64, certain: bool },
    /// The clock advanced by `passed` ticks between the last packet before the place and the last packet of the next
    /// page. What the `page_packets` packets that end in that page do not fill is missing.
    Ticks { passed: u64, page_packets: u64 },
}

/// Surveys a file whose container begins at the present position; `None` if it is damaged in too many places.
pub(super) fn survey<S: Read + Seek>(
    container: SoundFormat,
    source: &mut S,
) -> io::Result<Option<Framing>> {
    let start = source.stream_position()?;
    let mut window = Window::new(source)?;
    let framing = match container {
        SoundFormat::Mp3 => mpeg::survey(&mut window, start, mpeg::mp3_frame)?,
        SoundFormat::Aac => mpeg::survey(&mut window, start, mpeg::adts_frame)?,
        SoundFormat::Ogg => match ogg::survey(&mut window, start)? {
            Some(framing) => framing,
            None => return Ok(None),
        },
        SoundFormat::WebM | SoundFormat::Matroska => nested::matroska(&mut window, start)?,
        SoundFormat::Mp4 | SoundFormat::M4a | SoundFormat::Mov => nested::mp4(&mut window, start)?,
        // The demuxers of the others notice what is missing: by sizes, checksums and numbers of frames.
        _ => Framing::default(),
    };
    source.seek(SeekFrom::Start(start))?;
    Ok((framing.breaks.len() < MAX_BREAKS).then_some(framing))
}

/// A part of a file in memory.
struct Window<'a, S> {
    source: &'a mut S,
    start: u64,
    bytes: Vec<u8>,
    /// The length of the file.
    len: u64,
}

impl<'a, S: Read + Seek> Window<'a, S> {
    /// Number of bytes that are read at once: more than a page of Ogg.
    const LEN: u64 = 1 << 17;
    /// Number of those bytes that lie in front of the requested ones: a search returns to them.
    const BEFORE: u64 = Self::LEN / 4;

    fn new(source: &'a mut S) -> io::Result<Self> {
        let len = source.seek(SeekFrom::End(0))?;
        Ok(Self {
            source,
            start: 0,
            bytes: Vec::new(),
            len,
        })
    }

    /// `len` bytes from a position on; fewer only at the end of the file.
    fn at(&mut self, position: u64, len: u64) -> io::Result<&[u8]> {
        let position = position.min(self.len);
        let len = len.min(self.len - position);
        if position < self.start || position + len > self.start + self.bytes.len() as u64 {
            self.start = position.saturating_sub(Self::BEFORE);
            self.source.seek(SeekFrom::Start(self.start))?;
            self.bytes.clear();
            let mut part = self.source.by_ref().take(Self::LEN);
            part.read_to_end(&mut self.bytes)?;
        }
        let from = self.bytes.len().min((position - self.start) as usize);
        let to = self.bytes.len().min(from + len as usize);
        Ok(&self.bytes[from..to])
    }
}

/// Appends a range to ordered ranges; one that continues the last range is joined with it.
fn keep(kept: &mut Vec<Range<u64>>, range: Range<u64>) {
    match kept.last_mut() {
        Some(last) if last.end == range.start => last.end = range.end,
        _ => kept.push(range),
    }
}
