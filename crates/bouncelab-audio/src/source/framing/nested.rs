//! Boxes of MP4 and elements of Matroska: each says what it is and how long, and whole files are made of
//! them. Those of a recorder that was stopped announce no length in all, so that only this shows the end
//! to be missing.

use std::io::{self, Read, Seek};

use super::{Framing, Window, keep};

/// The beginning of a box or element.
struct Header {
    kind: u64,
    /// Where its content begins and ends; `None` for "somewhere".
    content: u64,
    end: Option<u64>,
}

/// A recorder that streams writes parts of a film (ISO 14496-12 section 8.8), each of which goes on where
/// the one before ended: one that cannot be read would move all that follow.
pub(super) fn mp4<S: Read + Seek>(window: &mut Window<S>, start: u64) -> io::Result<Framing> {
    const MOVIE: [u8; 4] = *b"moov";
    const PART: [u8; 4] = *b"moof";
    const KNOWN: [[u8; 4]; 16] = [
        *b"ftyp", *b"styp", MOVIE, PART, *b"mdat", *b"free", *b"skip", *b"wide", *b"uuid",
        *b"meta", *b"sidx", *b"ssix", *b"mfra", *b"pdin", *b"prft", *b"emsg",
    ];
    let mut has_parts = false;
    let mut at = start;
    while at < window.len {
        let header = atom(window.at(at, 16)?, at);
        let known = header.filter(|header| KNOWN.iter().any(|name| kind(*name) == header.kind));
        has_parts = has_parts
            || match &known {
                Some(header) if header.kind == kind(MOVIE) => announces_parts(window, header)?,
                Some(header) => header.kind == kind(PART),
                None => false,
            };
        let end = known.map(|header| header.end.unwrap_or(window.len));
        match end.filter(|&end| end <= window.len) {
            Some(end) => at = end,
            None if has_parts => return Ok(cut(start, at)),
            None => break,
        }
    }
    Ok(Framing::default())
}

/// The number of the name of a box.
fn kind(name: [u8; 4]) -> u64 {
    u64::from(u32::from_be_bytes(name))
}

/// Whether a film says that parts follow: without this nobody would miss the first one.
fn announces_parts<S: Read + Seek>(window: &mut Window<S>, movie: &Header) -> io::Result<bool> {
    let end = movie.end.unwrap_or(window.len).min(window.len);
    let mut at = movie.content;
    while at < end {
        let Some(inner) = atom(window.at(at, 16)?, at) else {
            break;
        };
        if inner.kind == kind(*b"mvex") {
            return Ok(true);
        }
        at = inner.end.unwrap_or(end);
    }
    Ok(false)
}

fn atom(bytes: &[u8], at: u64) -> Option<Header> {
    let short = u64::from(u32::from_be_bytes(*bytes.first_chunk()?));
    let kind = u64::from(u32::from_be_bytes(*bytes.get(4..)?.first_chunk()?));
    let (len, header) = match short {
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

/// Matroska (RFC 9559): segments of clusters of blocks, and what describes them.
pub(super) fn matroska<S: Read + Seek>(window: &mut Window<S>, start: u64) -> io::Result<Framing> {
    const OPENED: [u64; 2] = [0x1853_8067, 0x1f43_b675];
    const WHOLE: [u64; 16] = [
        0x1a45_dfa3,
        0x114d_9b74,
        0x1549_a966,
        0x1654_ae6b,
        0x1c53_bb6b,
        0x1941_a469,
        0x1043_a770,
        0x1254_c367,
        0xec,
        0xbf,
        0xe7,
        0xa3,
        0xa0,
        0xab,
        0xa7,
        0x5854,
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

fn element(bytes: &[u8], at: u64) -> Option<Header> {
    let (kind_len, kind) = number(bytes, 4)?;
    let (size_len, size) = number(bytes.get(kind_len..)?, 8)?;
    let mark = 1 << (7 * size_len);
    let content = at + (kind_len + size_len) as u64;
    Some(Header {
        kind,
        content,
        // All ones: not known when it was written.
        end: (size != 2 * mark - 1).then(|| content.saturating_add(size - mark)),
    })
}

/// A number that says how many bytes it has by its leading zeros, which are part of it.
fn number(bytes: &[u8], longest: usize) -> Option<(usize, u64)> {
    let len = bytes.first()?.leading_zeros() as usize + 1;
    let bytes = bytes.get(..len).filter(|_| len <= longest)?;
    let value = bytes
        .iter()
        .fold(0, |value, &byte| value << 8 | u64::from(byte));
    Some((len, value))
}

/// A file that cannot be read from here on.
fn cut(start: u64, at: u64) -> Framing {
    let mut sound = Vec::new();
    keep(&mut sound, start..at);
    Framing {
        sound: Some(sound),
        is_cut: true,
        ..Framing::default()
    }
}
