//! Checksums of mutated files made right, so that what lies behind them is read.

use bouncelab_session::hash::hash;

use crate::checksum::{FLAC_FRAME, FLAC_HEADER, OGG_PAGE};

/// An Ogg file with the right checksum in every page.
pub(super) fn ogg(file: &[u8]) -> Vec<u8> {
    const HEADER: usize = 27;
    let mut file = file.to_vec();
    let mut at = 0;
    while let Some(place) = find(&file, at, |bytes| bytes.starts_with(b"OggS")) {
        let segments = file.get(place + HEADER - 1).copied().map_or(0, usize::from);
        let lengths = file.get(place + HEADER..place + HEADER + segments);
        let len = lengths.map_or(0, |all| all.iter().map(|&len| usize::from(len)).sum());
        let end = place + HEADER + segments + len;
        at = place + 4;
        if let Some(page) = file.get_mut(place..end) {
            page[22..26].fill(0);
            let check = OGG_PAGE.checksum(page);
            page[22..26].copy_from_slice(&check.to_le_bytes());
            at = end;
        }
    }
    file
}

/// A FLAC file with the right checksums in every frame: it reaches from one header to the next.
pub(super) fn flac(file: &[u8]) -> Vec<u8> {
    let mut file = file.to_vec();
    let mut frame = find(&file, 0, |bytes| flac_header(bytes).is_some());
    while let Some(start) = frame {
        let len = flac_header(&file[start..]).unwrap_or_default();
        frame = find(&file, start + len + 1, |bytes| flac_header(bytes).is_some());
        let end = frame.unwrap_or(file.len());
        file[start + len] = FLAC_HEADER.checksum(&file[start..start + len]);
        if end > start + len + 2 {
            let check = FLAC_FRAME.checksum(&file[start..end - 2]);
            file[end - 2..end].copy_from_slice(&check.to_be_bytes());
        }
    }
    file
}

/// The length of the header of a frame that begins here, without its checksum, if one does.
fn flac_header(bytes: &[u8]) -> Option<usize> {
    let [0xff, 0xf8 | 0xf9, sizes, _, number, ..] = *bytes else {
        return None;
    };
    let number = match number.leading_ones() {
        0 => 1,
        len @ 2..=7 => len as usize,
        _ => return None,
    };
    let block = match sizes >> 4 {
        6 => 1,
        7 => 2,
        _ => 0,
    };
    let rate = match sizes & 15 {
        12 => 1,
        13 | 14 => 2,
        _ => 0,
    };
    let len = 4 + number + block + rate;
    (len < bytes.len()).then_some(len)
}

/// A journal with the right checksum before every line.
pub(super) fn journal(file: &[u8]) -> Vec<u8> {
    let lines = file.split_inclusive(|&byte| byte == b'\n');
    let mended = lines.map(|line| {
        let Some(place) = line.iter().position(|&byte| byte == b' ') else {
            return line.to_vec();
        };
        let text = &line[place + 1..];
        let digits = hash(text.strip_suffix(b"\n").unwrap_or(text)).to_string();
        [&digits.as_bytes()[..16], b" ", text].concat()
    });
    mended.collect::<Vec<_>>().concat()
}

/// The first place from one on at which the bytes are as wanted.
fn find(bytes: &[u8], from: usize, is_wanted: impl Fn(&[u8]) -> bool) -> Option<usize> {
    (from..bytes.len()).find(|&at| is_wanted(&bytes[at..]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{damage, hostile};

    /// Whole files have the right checksums already, and others than Ogg have no pages.
    #[test]
    fn whole_files_stay_as_they_are() {
        let sound = hostile::flac(48_000, 2, 0..3);
        assert!(flac(&sound) == sound);
        for (name, sound) in damage::files() {
            assert!(ogg(&sound) == sound, "{name}");
        }
    }
}
