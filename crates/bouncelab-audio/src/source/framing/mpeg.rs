//! Frames of MPEG layer 3 and of AAC in ADTS: each begins with a header that says how long it is, and
//! the next one follows.

use std::io::{self, Read, Seek};
use std::ops::Range;

use symphonia::core::checksum::Crc16AnsiLe;
use symphonia::core::io::Monitor;

use super::{Break, Framing, MOST_BREAKS, Missing, Window, keep};

/// What the header of a frame says.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Frame {
    /// Length in bytes, header included.
    len: u64,
    /// What is equal in all frames of a stream: codec, rate, channels.
    kind: u32,
    /// The number of its bit rate, if the length follows from that.
    bit_rate: Option<u32>,
}

/// Reads a header.
type Parse = fn(&[u8]) -> Option<Frame>;

/// Enough for the header of a frame.
const HEADER: u64 = 8;

/// Enough for the tag of an encoder behind header and side information.
const TAG: u64 = 200;

/// So many headers where each says the next is are no coincidence.
const CHAIN: usize = 3;

/// ISO 11172-3 section 2.4.2.3 and, for half rates, ISO 13818-3.
pub(super) fn mp3_frame(bytes: &[u8]) -> Option<Frame> {
    const KBIT_S: [u64; 16] = [
        0, 32, 40, 48, 56, 64, 80, 96, 112, 128, 160, 192, 224, 256, 320, 0,
    ];
    const KBIT_S_HALF: [u64; 16] = [
        0, 8, 16, 24, 32, 40, 48, 56, 64, 80, 96, 112, 128, 144, 160, 0,
    ];
    let word = u32::from_be_bytes(*bytes.first_chunk()?);
    let (version, layer) = (word >> 19 & 3, word >> 17 & 3);
    let (bit_rate, rate) = (word >> 12 & 15, word >> 10 & 3);
    if word >> 21 != 0x7ff || version == 1 || layer != 1 || rate == 3 {
        return None;
    }
    let rate_hz = [44_100, 48_000, 32_000][rate as usize];
    let (rate_hz, kbit_s, slots) = match version {
        3 => (rate_hz, KBIT_S, 144_000),
        2 => (rate_hz / 2, KBIT_S_HALF, 72_000),
        _ => (rate_hz / 4, KBIT_S_HALF, 72_000),
    };
    let kbit_s = kbit_s[bit_rate as usize];
    let is_mono = word >> 6 & 3 == 3;
    (kbit_s > 0).then(|| Frame {
        len: slots * kbit_s / rate_hz + u64::from(word >> 9 & 1),
        kind: version << 3 | rate << 1 | u32::from(is_mono),
        bit_rate: Some(bit_rate),
    })
}

/// ISO 14496-3 table 1.A.5.
pub(super) fn adts_frame(bytes: &[u8]) -> Option<Frame> {
    let word = u64::from_be_bytes(*bytes.first_chunk()?);
    let len = word >> 21 & 0x1fff;
    let blocks = word >> 8 & 3;
    let layer = (word >> 49) % 4;
    let is_frame = word >> 52 == 0xfff && layer == 0 && blocks == 0 && len > 7;
    // Version, protection, profile, rate and channels.
    let kind = (word >> 48 & 0xb) << 12 | (word >> 42 & 0x3d) << 4 | word >> 38 & 7;
    is_frame.then_some(Frame {
        len,
        kind: kind as u32,
        bit_rate: None,
    })
}

/// The frames that follow each other, and where they do not.
pub(super) fn survey<S: Read + Seek>(
    window: &mut Window<S>,
    start: u64,
    parse: Parse,
) -> io::Result<Framing> {
    let mut walk = Walk {
        window,
        parse,
        kind: None,
    };
    let Some(first) = walk.find(start)? else {
        return Ok(Framing::default());
    };
    let mut found = Found {
        tag: walk.tag(first)?,
        ..Found::default()
    };
    let mut at = first;
    while at < walk.window.len && found.holes.len() < MOST_BREAKS {
        match walk.frame(at)? {
            Some(frame) if at + frame.len > walk.window.len => {
                found.is_cut = true;
                break;
            }
            Some(frame) => {
                found.push(at, frame);
                at += frame.len;
            }
            // The header of the last frame may be what is damaged.
            None => match walk.find(found.last.start + 1)? {
                Some(resumed) => {
                    found.lose_last_up_to(resumed);
                    at = resumed;
                }
                None => break,
            },
        }
    }
    let is_altered = walk.is_altered(&found, first)?;
    Ok(found.framing(start..first, walk.window.len, is_altered))
}

/// Steps from frame to frame.
struct Walk<'a, 'b, S> {
    window: &'a mut Window<'b, S>,
    parse: Parse,
    kind: Option<u32>,
}

impl<S: Read + Seek> Walk<'_, '_, S> {
    /// The frame that begins here, if it is one of this stream.
    fn frame(&mut self, at: u64) -> io::Result<Option<Frame>> {
        let frame = (self.parse)(self.window.at(at, HEADER)?);
        Ok(frame.filter(|frame| self.kind.is_none_or(|kind| kind == frame.kind)))
    }

    /// Where, from a place on, frames begin that follow each other.
    fn find(&mut self, from: u64) -> io::Result<Option<u64>> {
        for at in from..self.window.len {
            if self.window.at(at, 1)? == [0xff] && self.is_chain(at)? {
                return Ok(Some(at));
            }
        }
        Ok(None)
    }

    fn is_chain(&mut self, at: u64) -> io::Result<bool> {
        let known = self.kind;
        let mut next = at;
        for _ in 0..CHAIN {
            // A stream may end before it is long enough to be sure.
            if next > at && next == self.window.len {
                break;
            }
            let Some(frame) = self.frame(next)? else {
                self.kind = known;
                return Ok(false);
            };
            self.kind = Some(frame.kind);
            next += frame.len;
        }
        Ok(true)
    }

    /// Whether the first frame is none but a tag, and how many frames follow according to it.
    fn tag(&mut self, first: u64) -> io::Result<Option<Tag>> {
        let bytes = self.window.at(first, TAG)?;
        // Behind header and side information, whose length depends on version and channels.
        let tag = [13, 21, 36].into_iter().find_map(|place| {
            let tag = bytes.get(place..)?;
            (tag.starts_with(b"Xing") || tag.starts_with(b"Info")).then_some(tag)
        });
        let number = |place: usize| {
            let bytes = *tag?.get(place..)?.first_chunk()?;
            Some(u64::from(u32::from_be_bytes(bytes)))
        };
        let flags = number(4).unwrap_or(0);
        let is_tag = tag.is_some() || bytes.get(36..40) == Some(b"VBRI");
        Ok(is_tag.then(|| Tag {
            frames: number(8).filter(|_| flags & 1 == 1),
            music: tag.and_then(|tag| Music::of(tag, flags)),
        }))
    }

    /// Whether no frame is missing, and the tag has the checksum of others than these.
    fn is_altered(&mut self, found: &Found, first: u64) -> io::Result<bool> {
        const AT_ONCE: u64 = 1 << 16;
        let Some(music) = found.tag.as_ref().and_then(|tag| tag.music.as_ref()) else {
            return Ok(false);
        };
        let Some(tag) = self.frame(first)?.filter(|_| found.holes.is_empty()) else {
            return Ok(false);
        };
        // Of a file that was shortened the tag says nothing.
        if found.last.end - first != music.len {
            return Ok(false);
        }
        let mut checksum = Crc16AnsiLe::new(0);
        let mut at = first + tag.len;
        while at < found.last.end {
            let bytes = self.window.at(at, AT_ONCE.min(found.last.end - at))?;
            if bytes.is_empty() {
                break;
            }
            checksum.process_buf_bytes(bytes);
            at += bytes.len() as u64;
        }
        Ok(checksum.crc() != music.checksum)
    }
}

/// What the encoder says of the stream in the first frame.
struct Tag {
    frames: Option<u64>,
    music: Option<Music>,
}

/// What LAME, and those that write its tag, say of the frames: how long all are, and the checksum of those
/// behind the tag.
struct Music {
    len: u64,
    checksum: u16,
}

impl Music {
    /// Behind the fields of which the flags say that they are there, and 28 bytes that are of no use here.
    fn of(tag: &[u8], flags: u64) -> Option<Self> {
        const FIELDS: [(u64, usize); 4] = [(1, 4), (2, 4), (4, 100), (8, 4)];
        let fields = FIELDS.iter().filter(|(flag, _)| flags & flag != 0);
        let place = 8 + fields.map(|(_, len)| len).sum::<usize>() + 28;
        let len = u32::from_be_bytes(*tag.get(place..)?.first_chunk()?);
        let checksum = u16::from_be_bytes(*tag.get(place + 4..)?.first_chunk()?);
        // Zero where an encoder does not count.
        (len > 0 && checksum > 0).then_some(Self {
            len: len.into(),
            checksum,
        })
    }
}

/// The frames that were found.
#[derive(Default)]
struct Found {
    tag: Option<Tag>,
    /// The bytes of frames before the last one, how many frames these are and how long.
    kept: Vec<Range<u64>>,
    count: u64,
    bytes: u64,
    /// The last frame, which the next one may yet show to be none.
    last: Range<u64>,
    bit_rate: Option<u32>,
    is_variable: bool,
    holes: Vec<Hole>,
    is_cut: bool,
}

/// A stretch without a frame.
struct Hole {
    /// How many frames lie before it.
    frame: u64,
    bytes: u64,
}

impl Found {
    fn push(&mut self, at: u64, frame: Frame) {
        self.keep_last();
        self.last = at..at + frame.len;
        // The tag need not have the rate of the sound.
        if self.count > 0 || self.tag.is_none() {
            self.is_variable |= frame.bit_rate.is_none()
                || self
                    .bit_rate
                    .is_some_and(|rate| Some(rate) != frame.bit_rate);
            self.bit_rate = frame.bit_rate;
        }
    }

    fn keep_last(&mut self) {
        if !self.last.is_empty() {
            self.count += 1;
            self.bytes += self.last.end - self.last.start;
            keep(&mut self.kept, self.last.clone());
        }
    }

    fn lose_last_up_to(&mut self, resumed: u64) {
        self.holes.push(Hole {
            frame: self.count,
            bytes: resumed - self.last.start,
        });
        self.last = resumed..resumed;
    }

    /// Puts it together. What lies before the first frame and after the last one, tags most often, is
    /// for the demuxer to judge.
    fn framing(mut self, lead: Range<u64>, end: u64, is_altered: bool) -> Framing {
        self.keep_last();
        let tail = self.last.end..end;
        let mut breaks: Vec<Break> = self.holes.iter().map(|hole| self.missing(hole)).collect();
        // What a tag announced and is not there was in the only hole.
        if let ([only], Some(announced), false) = (&mut breaks[..], self.announced(), self.is_cut)
            && announced > self.count
        {
            only.missing = Missing::Packets {
                count: announced - self.count,
                certain: true,
            };
        }
        let mut sound = vec![lead];
        for range in self.kept.into_iter().chain([tail]) {
            keep(&mut sound, range);
        }
        Framing {
            sound: (!breaks.is_empty()).then_some(sound),
            breaks,
            is_cut: self.is_cut,
            is_altered,
        }
    }

    /// How many frames there are according to the tag, itself included.
    fn announced(&self) -> Option<u64> {
        Some(self.tag.as_ref()?.frames? + 1)
    }

    /// At a constant rate a hole of whole frames is one in which nothing but their headers is damaged.
    fn missing(&self, hole: &Hole) -> Break {
        let frame_bytes = self.bytes as f64 / self.count.max(1) as f64;
        let frames = hole.bytes as f64 / frame_bytes;
        let count = frames.round().max(1.0);
        // The length of a frame is rounded to bytes.
        let is_whole = (hole.bytes as f64 - count * frame_bytes).abs() < 1.5;
        Break {
            track: None,
            packet: hole.frame - u64::from(self.tag.is_some()),
            missing: Missing::Packets {
                count: count as u64,
                certain: is_whole && !self.is_variable,
            },
        }
    }
}
