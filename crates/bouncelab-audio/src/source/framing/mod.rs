//! Where the frames of a stream lie in its file, and where some are missing.
//!
//! The demuxers in use step over what is damaged without a word, and streams of MP3 and ADTS have no
//! clock that would show it. So the file is looked through before it is read: what is no frame is kept
//! from the demuxer, and how much sound lay there is counted as far as the file says.

mod mpeg;
mod nested;
mod ogg;

use std::io::{self, Read, Seek, SeekFrom};
use std::ops::Range;

use crate::formats::SoundFormat;

/// More damage than this is no recording.
const MOST_BREAKS: usize = 1_000;

/// What lies where in a file.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Framing {
    /// The bytes that are worth reading; `None` for all of them.
    pub(super) sound: Option<Vec<Range<u64>>>,
    /// Where frames are missing, in their order.
    pub(super) breaks: Vec<Break>,
    /// Whether the file ends within a frame.
    pub(super) is_cut: bool,
    /// Whether a checksum says that frames are not those that were encoded, though none is missing.
    pub(super) is_altered: bool,
}

/// A place where frames are missing.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Break {
    /// The track, where there are several.
    pub(super) track: Option<u32>,
    /// How many packets of the track lie before it.
    pub(super) packet: u64,
    pub(super) missing: Missing,
}

/// How much is missing.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Missing {
    /// So many packets.
    Packets { count: u64, certain: bool },
    /// As much as the clock, in its ticks, went on between the packet before and the last one of the
    /// next page, apart from the packets of that page.
    Ticks { passed: u64, page_packets: u64 },
}

/// Looks through a file of which the container begins here; `None` if it is damaged all over.
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
    Ok((framing.breaks.len() < MOST_BREAKS).then_some(framing))
}

/// A part of a file at hand.
struct Window<'a, S> {
    source: &'a mut S,
    start: u64,
    bytes: Vec<u8>,
    /// The length of the file.
    len: u64,
}

impl<'a, S: Read + Seek> Window<'a, S> {
    /// As much as is read at once: more than a page of Ogg.
    const LEN: u64 = 1 << 17;
    /// As much in front of what is asked for, which a search returns to.
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

    /// The bytes from a place on: `len` of them, fewer only at the end of the file.
    fn at(&mut self, place: u64, len: u64) -> io::Result<&[u8]> {
        let place = place.min(self.len);
        let len = len.min(self.len - place);
        if place < self.start || place + len > self.start + self.bytes.len() as u64 {
            self.start = place.saturating_sub(Self::BEFORE);
            self.source.seek(SeekFrom::Start(self.start))?;
            self.bytes.clear();
            let mut part = self.source.by_ref().take(Self::LEN);
            part.read_to_end(&mut self.bytes)?;
        }
        let from = self.bytes.len().min((place - self.start) as usize);
        let to = self.bytes.len().min(from + len as usize);
        Ok(&self.bytes[from..to])
    }
}

/// Adds a range to those in order, joined with the last one if it goes on from there.
fn keep(kept: &mut Vec<Range<u64>>, range: Range<u64>) {
    match kept.last_mut() {
        Some(last) if last.end == range.start => last.end = range.end,
        _ => kept.push(range),
    }
}
