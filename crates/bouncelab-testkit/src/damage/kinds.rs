//! The ways in which files of recordings are damaged.

use std::ops::Range;

/// What happens to a file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Damage {
    /// One bit of one byte is another.
    Bit,
    /// 300 bytes are zero.
    Zeros,
    /// 2,000 bytes are missing.
    Removed,
    /// All that follows is missing.
    Truncated,
    /// One bit of one byte of the header is another.
    Header,
    /// Sixty-four bits behind the header are others.
    Bits,
    /// 1,500 bytes are there twice.
    Inserted,
    /// One or two frames are missing.
    Dropped,
    /// A frame is there twice.
    Repeated,
    /// The file, and the beginning of the same file behind it.
    Joined,
    /// The header states another number of channels.
    Channels,
}

impl Damage {
    /// Every way.
    pub const ALL: [Self; 11] = [
        Self::Bit,
        Self::Zeros,
        Self::Removed,
        Self::Truncated,
        Self::Header,
        Self::Bits,
        Self::Inserted,
        Self::Dropped,
        Self::Repeated,
        Self::Joined,
        Self::Channels,
    ];

    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Bit => "one bit changed",
            Self::Zeros => "300 bytes set to zero",
            Self::Removed => "2,000 bytes missing",
            Self::Truncated => "cut off",
            Self::Header => "one bit of the header changed",
            Self::Bits => "64 bits changed",
            Self::Inserted => "1,500 bytes repeated",
            Self::Dropped => "one or two frames missing",
            Self::Repeated => "a frame repeated",
            Self::Joined => "joined with its beginning",
            Self::Channels => "another number of channels",
        }
    }

    /// Number of places of a file: its percents, or the bytes of its header.
    pub fn places(self, file: &[u8]) -> usize {
        match self {
            Self::Header => header(file).len(),
            _ => 100,
        }
    }

    /// The file after it, at one of its places; the same file if it has no such part.
    pub fn at(self, place: usize, file: &[u8]) -> Vec<u8> {
        let mut damaged = file.to_vec();
        let at = file.len() * place.min(99) / 100;
        match self {
            Self::Bit => flip(&mut damaged, at, place),
            Self::Zeros => damaged[at..]
                .iter_mut()
                .take(300)
                .for_each(|byte| *byte = 0),
            Self::Removed => drop(damaged.drain(at..file.len().min(at + 2_000))),
            Self::Truncated => damaged.truncate(at),
            Self::Header => flip(&mut damaged, header(file).start + place, place),
            Self::Bits => {
                let header = header(file);
                // A movie may have its description behind the sound.
                let sound = match header.start {
                    0 => header.end..file.len(),
                    start if start > file.len() / 2 => 0..start,
                    _ => header.end..file.len(),
                };
                // The multiplier of Knuth's generator spreads them over the file.
                let mut number = place as u64 + 1;
                for _ in 0..64 {
                    number = number
                        .wrapping_mul(6_364_136_223_846_793_005)
                        .wrapping_add(1);
                    let offset = (number >> 33) as usize % sound.len().max(1);
                    flip(&mut damaged, sound.start + offset, place);
                }
            }
            Self::Inserted => {
                let piece = file[at.saturating_sub(1_500)..at].to_vec();
                drop(damaged.splice(at..at, piece));
            }
            Self::Dropped | Self::Repeated => {
                let frames = frames(file);
                // The first may be the tag of an encoder.
                let number = 1 + frames.len() * place / 100;
                if let Some(frame) = frames.get(number) {
                    let next = frames.get(number + place % 2).unwrap_or(frame);
                    if self == Self::Dropped {
                        drop(damaged.drain(frame.start..next.end));
                    } else {
                        drop(damaged.splice(frame.end..frame.end, file[frame.clone()].to_vec()));
                    }
                }
            }
            Self::Joined => damaged.extend_from_slice(&file[..at]),
            Self::Channels => {
                if let Some(byte) = channels(file).and_then(|at| damaged.get_mut(at)) {
                    *byte = place as u8;
                }
            }
        }
        damaged
    }
}

fn flip(file: &mut [u8], at: usize, number: usize) {
    if let Some(byte) = file.get_mut(at) {
        *byte ^= 1 << (number % 8);
    }
}

fn find(file: &[u8], words: &[u8]) -> Option<usize> {
    file.windows(words.len()).position(|it| it == words)
}

/// The bytes of the header: up to the sound where that is in one piece, else about as many as headers take.
fn header(file: &[u8]) -> Range<usize> {
    const LEN: usize = 400;
    let head = &file[..file.len().min(LEN)];
    let range = match head {
        [b'R' | b'B' | b'r' | b'F' | b'c', ..] => {
            let sound = find(head, b"data").or_else(|| find(head, b"SSND"));
            0..sound.map_or(LEN, |at| at + 16)
        }
        [_, _, _, _, b'f', b't', b'y', b'p', ..] => {
            let movie = find(file, b"moov").unwrap_or(0);
            movie..movie + 2 * LEN
        }
        _ => 0..LEN / 2,
    };
    range.start..range.end.min(file.len())
}

/// The frames of a stream, the pages of Ogg, or pieces of samples; none where a table lists them.
fn frames(file: &[u8]) -> Vec<Range<usize>> {
    /// A whole number of frames of samples of two, three or four bytes.
    const PIECE: usize = 1_200;
    let starts: Vec<usize> = match file {
        [b'R' | b'B' | b'r' | b'F' | b'c', ..] => {
            (header(file).end..file.len()).step_by(PIECE).collect()
        }
        [b'O', b'g', ..] => starts(file, 4, |it| it == b"OggS"),
        // Blocks of one fixed length, whose number is in the fifth byte.
        [b'f', b'L', ..] => starts(file, 2, |it| it == [0xff, 0xf8]),
        // Behind the tag with which programs begin.
        [b'I', b'D', b'3', ..] | [0xff, ..] => {
            let first = starts(file, 2, |it| it[0] == 0xff && it[1] >= 0xe2);
            let len = |at: usize| frame_len(file.get(at..)?);
            let chain = std::iter::successors(first.first().copied(), |&at| Some(at + len(at)?));
            chain.take_while(|&at| at < file.len()).collect()
        }
        _ => Vec::new(),
    };
    let ends = starts.iter().copied().skip(1).chain([file.len()]);
    let frames = starts.iter().zip(ends);
    frames.map(|(&start, end)| start..end).collect()
}

fn starts(file: &[u8], len: usize, begins: impl Fn(&[u8]) -> bool) -> Vec<usize> {
    let places = file.windows(len).enumerate();
    let found = places.filter(|(_, it)| begins(it));
    found.map(|(at, _)| at).collect()
}

/// Length of a frame of ADTS, or of MPEG 1 layer 3 at 48 kHz.
fn frame_len(frame: &[u8]) -> Option<usize> {
    const KBIT_S: [usize; 14] = [
        32, 40, 48, 56, 64, 80, 96, 112, 128, 160, 192, 224, 256, 320,
    ];
    let [0xff, second, third, fourth, fifth, sixth, ..] = *frame else {
        return None;
    };
    if second & 0x06 == 0 {
        let high = usize::from(fourth & 3) << 11;
        return Some(high | usize::from(fifth) << 3 | usize::from(sixth >> 5));
    }
    let kbit_s = KBIT_S.get(usize::from(third >> 4).checked_sub(1)?)?;
    Some(3 * kbit_s + usize::from(third >> 1 & 1))
}

/// Where the header states the number of channels in a byte of its own.
fn channels(file: &[u8]) -> Option<usize> {
    /// A name of the header, and how far behind it the number is.
    const PLACES: [(&[u8], usize); 9] = [
        (b"fmt \xf3", 26),
        (b"fmt ", 10),
        (b"COMM", 9),
        (b"desc", 39),
        (b"OpusHead", 9),
        (b"\x01vorbis", 11),
        (b"mp4a", 21),
        (b"alac\0\0\0\0\0\0\0\x01", 21),
        (b"sowt\0\0\0\0\0\0\0\x01", 21),
    ];
    let found = PLACES
        .iter()
        .find_map(|(name, offset)| Some(find(file, name)? + offset));
    // The element of Matroska, which the description of a track has.
    let is_matroska = file.starts_with(&[0x1a, 0x45, 0xdf, 0xa3]);
    found.or_else(|| Some(find(file, b"\x9f\x81").filter(|_| is_matroska)? + 2))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::damage::files;

    /// Every way damages most files, and frames are found in all that have no table of them.
    #[test]
    fn damage_changes_the_file() {
        for (name, file) in files() {
            let has_table = ["m4a", "mp4", "mov", "mkv", "webm"];
            let has_table = has_table.iter().any(|ending| name.ends_with(ending));
            for damage in Damage::ALL {
                let is_of_frames = matches!(damage, Damage::Dropped | Damage::Repeated);
                let has_part = match damage {
                    Damage::Channels => channels(&file).is_some(),
                    _ => !(is_of_frames && has_table),
                };
                assert_eq!(damage.at(50, &file) != file, has_part, "{name}, {damage:?}");
            }
            assert!(has_table || frames(&file).len() > 5, "{name}");
        }
    }
}
