//! Pages of Ogg (RFC 3533): each has a number, a checksum, and the time at its end.

use std::collections::BTreeMap;
use std::io::{self, Read, Seek};

use symphonia::core::checksum::Crc32;
use symphonia::core::io::Monitor;

use super::{Break, Framing, MOST_BREAKS, Missing, Window, keep};

/// The longest page.
const PAGE: u64 = 27 + 255 + 255 * 255;

/// More tracks than this are no recording.
const MOST_TRACKS: usize = 1_000;

/// How many bytes of pages whose checksum is wrong are read, for each byte of the file and besides: damaged pages
/// are read once, but each of a row of headers may claim all that follow.
const WRONG: (u64, u64) = (4, 1 << 20);

/// What the header of a page says.
struct Page {
    len: u64,
    track: u32,
    number: u32,
    /// The time at its end; `None` if no packet ends in it.
    clock: Option<u64>,
    is_continued: bool,
    /// How many packets end in it, and whether another one begins.
    packets: u64,
    is_open: bool,
}

impl Page {
    /// The page at the beginning of these bytes, if its checksum is right. What is read of one that is wrong is
    /// taken from what may be.
    fn parse(bytes: &[u8], wrong: &mut u64) -> Option<Self> {
        let header = bytes.first_chunk::<27>()?;
        let segments = bytes.get(27..27 + usize::from(header[26]))?;
        let len = 27 + segments.len() + segments.iter().map(|&len| usize::from(len)).sum::<usize>();
        let page = bytes.get(..len).filter(|page| page.starts_with(b"OggS"))?;
        let word = |at: usize| Some(u32::from_le_bytes(*page.get(at..)?.first_chunk()?));
        let mut checksum = Crc32::new(0);
        checksum.process_buf_bytes(&page[..22]);
        checksum.process_buf_bytes(&[0; 4]);
        checksum.process_buf_bytes(&page[26..]);
        let clock = u64::from_le_bytes(*page.get(6..)?.first_chunk()?);
        if word(22)? != checksum.crc() {
            *wrong = wrong.saturating_sub(len as u64);
            return None;
        }
        Some(Self {
            len: len as u64,
            track: word(14)?,
            number: word(18)?,
            clock: (clock != u64::MAX).then_some(clock),
            is_continued: header[5] & 1 == 1,
            packets: segments.iter().filter(|&&len| len < 255).count() as u64,
            is_open: segments.last() == Some(&255),
        })
    }
}

/// The pages that are whole, and where others are missing between them; `None` if there are too many wrong ones.
pub(super) fn survey<S: Read + Seek>(
    window: &mut Window<S>,
    start: u64,
) -> io::Result<Option<Framing>> {
    let mut wrong = WRONG.0 * window.len + WRONG.1;
    let mut sound = Vec::new();
    let mut tracks: BTreeMap<u32, Track> = BTreeMap::new();
    let mut breaks = Vec::new();
    let mut at = start;
    while at < window.len && breaks.len() < MOST_BREAKS && tracks.len() < MOST_TRACKS {
        if let Some(page) = Page::parse(window.at(at, PAGE)?, &mut wrong) {
            keep(&mut sound, at..at + page.len);
            breaks.extend(tracks.entry(page.track).or_default().take(&page));
            at += page.len;
        } else if wrong == 0 {
            return Ok(None);
        } else {
            let rest = window.at(at + 1, PAGE)?;
            let next = rest.windows(4).position(|word| word == b"OggS");
            at += 1 + next.unwrap_or(rest.len().saturating_sub(3).max(1)) as u64;
        }
    }
    let is_whole = matches!(sound.as_slice(), [all] if *all == (start..window.len));
    Ok(Some(Framing {
        sound: (!is_whole).then_some(sound),
        breaks,
        ..Framing::default()
    }))
}

/// What was read of a track, as the demuxer reads it.
#[derive(Default)]
struct Track {
    number: Option<u32>,
    clock: u64,
    /// Packets of sound: those of the headers end at time 0.
    packets: u64,
    /// Whether a packet has begun that did not end.
    is_open: bool,
    /// Whether pages are missing since the last packet that ended.
    is_broken: bool,
}

impl Track {
    /// Takes the next page; the break in front of it, if there is one.
    fn take(&mut self, page: &Page) -> Option<Break> {
        let expected = self.number.map(|number| number.wrapping_add(1));
        let is_expected = expected.is_none_or(|number| number == page.number);
        self.number = Some(page.number);
        self.is_broken |= !is_expected;
        self.is_open &= is_expected && page.is_continued;
        // The end of a packet whose beginning is missing is left out.
        let is_headless = page.is_continued && !self.is_open;
        if is_headless && page.packets == 0 {
            return None;
        }
        let packets = page.packets - u64::from(is_headless);
        self.is_open = page.is_open;
        let clock = page.clock.filter(|&clock| clock > 0 && packets > 0)?;
        let passed = clock.saturating_sub(std::mem::replace(&mut self.clock, clock));
        let before = self.packets;
        self.packets += packets;
        std::mem::take(&mut self.is_broken).then_some(Break {
            track: Some(page.track),
            packet: before,
            missing: Missing::Ticks {
                passed,
                page_packets: packets,
            },
        })
    }
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::*;

    /// Each header claims to be of a page of 58 kB: all that the file holds, 2,000 times.
    #[test]
    fn headers_of_pages_that_are_none_are_given_up() {
        const LEN: usize = 27 * 400_000;
        let mut header = [0xff; 27];
        header[..4].copy_from_slice(b"OggS");
        let mut file = Cursor::new(header.repeat(LEN / header.len()));
        let mut window = Window::new(&mut file).unwrap();
        assert_eq!(survey(&mut window, 0).unwrap(), None);
        // Each takes at least 50 kB from what may be wrong.
        let headers = (WRONG.0 * LEN as u64 + WRONG.1) / 50_000;
        assert!(window.start <= headers * header.len() as u64);
    }
}
