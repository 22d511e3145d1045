//! Boxes of MP4 and elements of Matroska, of which a file consists: each states its kind and length.
//!
//! The file of a recorder that was stopped states no total length. Only a last box or element that ends beyond the file
//! shows that the end is missing.

use std::io::{self, Read, Seek};

use super::parts::Parts;
use super::{Framing, Window, keep};

/// The beginning of a box or element.
pub(super) struct Header {
    pub(super) kind: u64,
    /// Position at which its content begins.
    pub(super) content: u64,
    /// Position at which its content ends; `None` if the file does not state it.
    pub(super) end: Option<u64>,
}

/// Surveys a file of MP4 that is written in parts (ISO 14496-12 section 8.8), as recorders that stream do.
///
/// The times of a part continue those of the part before it. So nothing behind an unreadable part is used: its times
/// would be too early.
pub(super) fn mp4<S: Read + Seek>(window: &mut Window<S>, start: u64) -> io::Result<Framing> {
    const MOVIE: [u8; 4] = *b"moov";
    const PART: [u8; 4] = *b"moof";
    const SOUND: [u8; 4] = *b"mdat";
    const KNOWN: [[u8; 4]; 16] = [
        *b"ftyp", *b"styp", MOVIE, PART, SOUND, *b"free", *b"skip", *b"wide", *b"uuid", *b"meta",
        *b"sidx", *b"ssix", *b"mfra", *b"pdin", *b"prft", *b"emsg",
    ];
    let mut parts = Parts::default();
    let mut has_parts = false;
    let mut at = start;
    while at < window.len {
        let header = atom(window.at(at, 16)?, at);
        let known = header.filter(|header| KNOWN.iter().any(|name| kind(*name) == header.kind));
        has_parts |= known.as_ref().is_some_and(|it| it.kind == kind(PART));
        if let Some(header) = known.as_ref().filter(|it| it.kind == kind(MOVIE)) {
            has_parts |= parts.take_movie(window, header)?;
        }
        let end = known
            .as_ref()
            .map(|header| header.end.unwrap_or(window.len));
        let (Some(header), Some(end)) = (known, end.filter(|&end| end <= window.len)) else {
            return Ok(if has_parts {
                cut(start, at)
            } else {
                Framing::default()
            });
        };
        if header.kind == kind(PART)
            && let Err(wrong) = parts.take_part(window, at, &header)?
        {
            return Ok(cut(start, wrong));
        }
        if header.kind == kind(SOUND) {
            parts.take_sound(header.content..end);
        }
        at = end;
    }
    Ok(parts
        .finish()
        .map_or_else(|wrong| cut(start, wrong), |()| Framing::default()))
}

/// The name of a box as a number.
pub(super) fn kind(name: [u8; 4]) -> u64 {
    u64::from(u32::from_be_bytes(name))
}

/// The beginning of a box (ISO 14496-12 section 4.2), of which the file has these bytes at position `at`.
pub(super) fn atom(bytes: &[u8], at: u64) -> Option<Header> {
    let short = u64::from(u32::from_be_bytes(*bytes.first_chunk()?));
    let kind = u64::from(u32::from_be_bytes(*bytes.get(4..)?.first_chunk()?));
    let (len, header) = match short {
        // The last box may reach to the end of the file; a length of 64 bits stands behind the name.
        0 => (None, 8),
        1 => (
            Some(u64::from_be_bytes(*bytes.get(8..)?.first_chunk()?)),
            16,
        ),
        len => (Some(len), 8),
    };
    let is_whole = len.is_none_or(|len| len >= header);
    is_whole.then(|| Header {
        kind,
        content: at + header,
        end: len.map(|len| at.saturating_add(len)),
    })
}

/// Surveys a file of Matroska (RFC 9559): segments of clusters of blocks, and elements that describe them.
pub(super) fn matroska<S: Read + Seek>(window: &mut Window<S>, start: u64) -> io::Result<Framing> {
    /// Elements whose content is surveyed: segment and cluster.
    const OPENED: [u64; 2] = [0x1853_8067, 0x1f43_b675];
    /// Elements that are stepped over as a whole, by their numbers.
    const WHOLE: [u64; 16] = [
        0x1a45_dfa3, // EBML
        0x114d_9b74, // SeekHead
        0x1549_a966, // Info
        0x1654_ae6b, // Tracks
        0x1c53_bb6b, // Cues
        0x1941_a469, // Attachments
        0x1043_a770, // Chapters
        0x1254_c367, // Tags
        0xec,        // Void
        0xbf,        // CRC-32
        0xe7,        // Timestamp
        0xa3,        // SimpleBlock
        0xa0,        // BlockGroup
        0xab,        // PrevSize
        0xa7,        // Position
        0x5854,      // SilentTracks
    ];
    let mut at = start;
    while at < window.len {
        let header = element(window.at(at, 12)?, at);
        let next = header.and_then(|header| match header.end {
            _ if OPENED.contains(&header.kind) => Some(header.content),
            Some(end) if WHOLE.contains(&header.kind) => Some(end),
            _ => None,
        });
        match next.filter(|&next| next <= window.len) {
            Some(next) => at = next,
            None => return Ok(cut(start, at)),
        }
    }
    Ok(Framing::default())
}

/// The beginning of an element (RFC 8794), of which the file has these bytes at position `at`.
fn element(bytes: &[u8], at: u64) -> Option<Header> {
    let (kind_len, kind) = number(bytes, 4)?;
    let (size_len, size) = number(bytes.get(kind_len..)?, 8)?;
    // The bit that marks the number of bytes is no part of a size.
    let mark = 1 << (7 * size_len);
    let content = at + (kind_len + size_len) as u64;
    Some(Header {
        kind,
        content,
        // All ones stand for a size that was not known when the element was written.
        end: (size != 2 * mark - 1).then(|| content.saturating_add(size - mark)),
    })
}

/// A number of variable length (RFC 8794 section 4): its leading zeros give the number of its bytes, here with them.
fn number(bytes: &[u8], max_len: usize) -> Option<(usize, u64)> {
    let len = bytes.first()?.leading_zeros() as usize + 1;
    let bytes = bytes.get(..len).filter(|_| len <= max_len)?;
    let value = bytes
        .iter()
        .fold(0, |value, &byte| value << 8 | u64::from(byte));
    Some((len, value))
}

/// The result for a file that can be read only up to a position.
fn cut(start: u64, at: u64) -> Framing {
    let mut sound = Vec::new();
    keep(&mut sound, start..at);
    Framing {
        sound: Some(sound),
        is_cut: true,
        ..Framing::default()
    }
}
