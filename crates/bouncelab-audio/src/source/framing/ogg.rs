//! Pages of Ogg (RFC 3533): each has a number, a checksum, and the time of the last packet that ends in it.

use std::collections::BTreeMap;
use std::io::{self, Read, Seek};

use symphonia::core::checksum::Crc32;
use symphonia::core::io::Monitor;

use super::{Break, Framing, MAX_BREAKS, Missing, Window, keep};

/// Maximum length of a page in bytes: header, table of segments, segments.
const PAGE: u64 = 27 + 255 + 255 * 255;

/// Maximum number of tracks: a file with more is damaged.
const MAX_TRACKS: usize = 1_000;

/// Maximum number of bytes in pages whose checksum is wrong, for each byte of the file and in addition. Damaged pages
/// are read once, but each of many false headers in a row may claim a whole page behind it.
const MAX_WRONG: (u64, u64) = (4, 1 << 20);

/// The content of the header of a page.
struct Page {
    len: u64,
    track: u32,
    number: u32,
    /// Time of the last packet that ends in it, in ticks; `None` if none does.
    clock: Option<u64>,
    /// Whether it begins within a packet.
    is_continued: bool,
    /// Number of packets that end in it.
    packets: u64,
    /// Whether it ends within a packet.
    is_open: bool,
}

impl Page {
    /// The page at the beginning of these bytes, if its checksum is right. The length of one with a wrong checksum is
    /// subtracted from `wrong`.
    fn parse(bytes: &[u8], wrong: &mut u64) -> Option<Self> {
        let header = bytes.first_chunk::<27>()?;
        let segments = bytes.get(27..27 + usize::from(header[26]))?;
        let len = 27 + segments.len() + segments.iter().map(|&len| usize::from(len)).sum::<usize>();
        let page = bytes.get(..len).filter(|page| page.starts_with(b"OggS"))?;
        let word = |at: usize| Some(u32::from_le_bytes(*page.get(at..)?.first_chunk()?));
        // The checksum is that of the page with zeros in place of the checksum.
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
            // A packet ends with a segment that is not full.
            packets: segments.iter().filter(|&&len| len < 255).count() as u64,
            is_open: segments.last() == Some(&255),
        })
    }
}

/// Surveys the whole pages, and where others are missing between them; `None` if too many pages are wrong.
pub(super) fn survey<S: Read + Seek>(
    window: &mut Window<S>,
    start: u64,
) -> io::Result<Option<Framing>> {
    let mut wrong = MAX_WRONG.0 * window.len + MAX_WRONG.1;
    let mut sound = Vec::new();
    let mut tracks: BTreeMap<u32, Track> = BTreeMap::new();
    let mut breaks = Vec::new();
    let mut at = start;
    while at < window.len && breaks.len() < MAX_BREAKS && tracks.len() < MAX_TRACKS {
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

/// How far a track was surveyed, with the packets that the demuxer returns.
#[derive(Default)]
struct Track {
    /// Number of its last page.
    number: Option<u32>,
    /// Time of the last packet, in ticks.
    clock: u64,
    /// Number of packets of sound. Those of the headers, which end at time 0, do not count.
    packets: u64,
    /// Whether the last page ended within a packet.
    is_open: bool,
    /// Whether pages are missing since the last packet that ended.
    is_broken: bool,
}

impl Track {
    /// Takes the next page; returns the break in front of it, if pages are missing there.
    fn take(&mut self, page: &Page) -> Option<Break> {
        let expected = self.number.map(|number| number.wrapping_add(1));
        let is_expected = expected.is_none_or(|number| number == page.number);
        self.number = Some(page.number);
        self.is_broken |= !is_expected;
        self.is_open &= is_expected && page.is_continued;
        // The demuxer leaves out the end of a packet whose beginning is missing.
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
    fn too_many_false_headers_of_pages_are_refused() {
        const LEN: usize = 27 * 400_000;
        let mut header = [0xff; 27];
        header[..4].copy_from_slice(b"OggS");
        let mut file = Cursor::new(header.repeat(LEN / header.len()));
        let mut window = Window::new(&mut file).unwrap();
        assert_eq!(survey(&mut window, 0).unwrap(), None);
        // Each reduces the allowance by at least 50 kB.
        let headers = (MAX_WRONG.0 * LEN as u64 + MAX_WRONG.1) / 50_000;
        assert!(window.start <= headers * header.len() as u64);
    }
}
