//! Frames of MPEG layer 3 and of AAC in ADTS: each begins with a header that states its length, and the next frame
//! follows it.
//!
//! Four equal bits of a header may also occur within a frame. So a frame counts as one only as part of a chain: where its
//! header states that the next frame begins, there is another header of the same stream.

use std::io::{self, Read, Seek};
use std::ops::Range;

use symphonia::core::checksum::Crc16AnsiLe;
use symphonia::core::io::Monitor;

use super::{Break, Framing, MAX_BREAKS, Missing, Window, keep};

/// The content of a header.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Frame {
    /// Length in bytes, header included.
    len: u64,
    /// The fields that are equal in all frames of a stream: codec, rate, channels.
    kind: u32,
    /// Code of the bit rate, where the length follows from it.
    bit_rate: Option<u32>,
}

/// Parses a header; `None` if these bytes are not one.
type Parse = fn(&[u8]) -> Option<Frame>;

/// Number of bytes that contain the header of a frame.
const HEADER: u64 = 8;

/// Number of bytes of the first frame that contain the tag of an encoder, behind header and side information.
const TAG: u64 = 200;

/// Number of headers, each where the one before announces it, that do not occur by chance.
const CHAIN: usize = 3;

/// Parses a header of MPEG layer 3 (ISO 11172-3 section 2.4.2.3; for half rates ISO 13818-3).
pub(super) fn mp3_frame(bytes: &[u8]) -> Option<Frame> {
    const KBIT_S: [u64; 16] = [
        0, 32, 40, 48, 56, 64, 80, 96, 112, 128, 160, 192, 224, 256, 320, 0,
    ];
    const KBIT_S_HALF: [u64; 16] = [
        0, 8, 16, 24, 32, 40, 48, 56, 64, 80, 96, 112, 128, 144, 160, 0,
    ];
    // Sync (11 bits), version (2), layer (2), protection (1), bit rate (4), rate (2), padding (1), private (1), mode (2).
    let word = u32::from_be_bytes(*bytes.first_chunk()?);
    let (version, layer) = (word >> 19 & 3, word >> 17 & 3);
    let (bit_rate, rate) = (word >> 12 & 15, word >> 10 & 3);
    if word >> 21 != 0x7ff || version == 1 || layer != 1 || rate == 3 {
        return None;
    }
    let rate_hz = [44_100, 48_000, 32_000][rate as usize];
    // A frame has 1152 samples, in the versions of half and quarter rates 576: bytes = samples / 8 * bit rate / rate.
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

/// Parses a header of ADTS (ISO 14496-3 table 1.A.5).
pub(super) fn adts_frame(bytes: &[u8]) -> Option<Frame> {
    // Bits from the highest: sync (12), version (1), layer (2), protection (1), profile (2), rate (4), private (1),
    // channels (3), four flags, length (13), fullness (11), blocks (2), and the first byte of the sound.
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

/// What a frame of layer 3 states of the one before it (ISO 11172-3 section 2.4.1.7; for half rates ISO 13818-3).
struct Layer3 {
    /// Number of bytes of its sound that stand in front of its own bytes, and of its own bytes for any sound.
    reservoir: u32,
    room: u32,
    /// Length of its sound in bytes.
    sound: u32,
    /// The windows of its first and last granule, for each channel.
    windows: [[u32; 2]; 2],
    bytes: Vec<u8>,
}

impl Layer3 {
    /// Reads the side information; `None` for another layer.
    fn parse(bytes: &[u8]) -> Option<Self> {
        mp3_frame(bytes)?;
        let word = u32::from_be_bytes(*bytes.first_chunk()?);
        let (is_whole_rate, is_mono) = (word >> 19 & 3 == 3, word >> 6 & 3 == 3);
        let channels = if is_mono { 1 } else { 2 };
        // Bits of the reservoir, in front of the granules, of one of them, and of its fields between length and window.
        let (reservoir, private, granules, granule, fields) = match (is_whole_rate, is_mono) {
            (true, true) => (9, 5 + 4, 2, 59, 17 + 4),
            (true, false) => (9, 3 + 8, 2, 59, 17 + 4),
            (false, true) => (8, 1, 1, 63, 17 + 9),
            (false, false) => (8, 2, 1, 63, 17 + 9),
        };
        let has_checksum = word >> 16 & 1 == 0;
        let side_at = if has_checksum { 6 } else { 4 };
        let head = reservoir + private;
        let side_len = (head + granules * channels * granule) / 8;
        let side = bytes.get(side_at..side_at + side_len)?;
        let bits = |at: usize, count: usize| {
            let bit = |at: usize| u32::from(side[at / 8] >> (7 - at % 8) & 1);
            (at..at + count).fold(0, |value, at| value << 1 | bit(at))
        };
        let of = |number: usize, channel: usize| head + (number * channels + channel) * granule;
        let window = |number, channel| {
            // Without the flag the window is the long one.
            let at = of(number, channel) + 12 + fields;
            bits(at, 1) * bits(at + 1, 2)
        };
        let ends = |channel| [window(0, channel), window(granules - 1, channel)];
        let sound: u32 = (0..granules * channels)
            .map(|it| bits(head + it * granule, 12))
            .sum();
        Some(Self {
            reservoir: bits(0, reservoir),
            room: (bytes.len() - side_at - side_len) as u32,
            sound: sound.div_ceil(8),
            windows: [ends(0), ends(channels - 1)],
            bytes: bytes.to_vec(),
        })
    }

    /// Whether this frame may follow another: its sound begins where that of the other has ended, or later; its windows fit
    /// together (long, start, short, stop), and it is no copy.
    fn follows(&self, before: &Self) -> bool {
        // Positions relative to the own bytes of the frame before.
        let begins = i64::from(before.room) - i64::from(self.reservoir);
        let ends = i64::from(before.sound) - i64::from(before.reservoir);
        let fits = |channel: usize| {
            let (last, next) = (before.windows[channel][1], self.windows[channel][0]);
            // The window behind a long or stop one begins long, behind a start one is short, behind a short one stays short or stops.
            matches!((last, next), (0 | 3, 0 | 1) | (1, 2) | (2, 2 | 3))
        };
        let is_copy = self.sound > 0 && self.bytes == before.bytes;
        begins >= ends && fits(0) && fits(1) && !is_copy
    }
}

/// Follows the chain of frames, and notes where it breaks.
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
    let mut frames = Frames {
        tag: walk.tag(first)?,
        ..Frames::default()
    };
    let mut at = first;
    let mut before = None;
    while at < walk.window.len && frames.holes.len() < MAX_BREAKS {
        match walk.frame(at)? {
            Some(frame) if at + frame.len > walk.window.len => {
                frames.is_cut = true;
                break;
            }
            Some(frame) => {
                let own = if at == first && frames.tag.is_some() {
                    None
                } else {
                    Layer3::parse(walk.window.at(at, frame.len)?)
                };
                let is_next = Option::zip(before.as_ref(), own.as_ref())
                    .is_none_or(|(before, own): (&Layer3, &Layer3)| own.follows(before));
                frames.push(at, frame, is_next);
                before = own;
                at += frame.len;
            }
            // The damage may be in the last frame, whose header then states a wrong length: search from there.
            None => match walk.find(frames.last.start + 1)? {
                Some(resumed) => {
                    frames.lose_last_up_to(resumed);
                    before = None;
                    at = resumed;
                }
                None => break,
            },
        }
    }
    let is_altered = walk.is_altered(&frames, first)?;
    Ok(frames.framing(start..first, walk.window.len, is_altered))
}

/// Goes from frame to frame.
struct Walk<'a, 'b, S> {
    window: &'a mut Window<'b, S>,
    parse: Parse,
    /// That of the stream; `None` before its first frame is known.
    kind: Option<u32>,
}

impl<S: Read + Seek> Walk<'_, '_, S> {
    /// The frame that begins at a position, if it is one of this stream.
    fn frame(&mut self, at: u64) -> io::Result<Option<Frame>> {
        let frame = (self.parse)(self.window.at(at, HEADER)?);
        Ok(frame.filter(|frame| self.kind.is_none_or(|kind| kind == frame.kind)))
    }

    /// The first position from here on where a chain of frames begins.
    fn find(&mut self, from: u64) -> io::Result<Option<u64>> {
        for at in from..self.window.len {
            if self.window.at(at, 1)? == [0xff] && self.is_chain(at)? {
                return Ok(Some(at));
            }
        }
        Ok(None)
    }

    /// Whether `CHAIN` frames follow each other from this position on. The kind of the stream is then theirs.
    fn is_chain(&mut self, at: u64) -> io::Result<bool> {
        let known = self.kind;
        let mut next = at;
        for _ in 0..CHAIN {
            // The last frames of a stream are a shorter chain.
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

    /// The tag of an encoder, if the first frame holds one in place of sound.
    fn tag(&mut self, first: u64) -> io::Result<Option<Tag>> {
        let bytes = self.window.at(first, TAG)?;
        // It lies behind header and side information, whose length depends on version and channels.
        let tag = [13, 21, 36].into_iter().find_map(|offset| {
            let tag = bytes.get(offset..)?;
            (tag.starts_with(b"Xing") || tag.starts_with(b"Info")).then_some(tag)
        });
        let number = |offset: usize| {
            let bytes = *tag?.get(offset..)?.first_chunk()?;
            Some(u64::from(u32::from_be_bytes(bytes)))
        };
        let flags = number(4).unwrap_or(0);
        let is_tag = tag.is_some() || bytes.get(36..40) == Some(b"VBRI");
        let has_frames = flags & 1 == 1;
        let bytes_at = if has_frames { 12 } else { 8 };
        Ok(is_tag.then(|| Tag {
            frames: number(8).filter(|_| has_frames),
            bytes: number(bytes_at).filter(|_| flags & 2 == 2),
            music: tag.and_then(|tag| Music::of(tag, flags)),
        }))
    }

    /// Whether the frames are not those of the tag, by their number or by its checksum, without a place that shows it.
    fn is_altered(&mut self, frames: &Frames, first: u64) -> io::Result<bool> {
        /// Number of bytes that are added to the checksum at once.
        const PIECE: u64 = 1 << 16;
        let Some(stated) = frames.tag.as_ref().filter(|_| frames.holes.is_empty()) else {
            return Ok(false);
        };
        let Some(tag) = self.frame(first)? else {
            return Ok(false);
        };
        if !frames.is_cut && stated.is_miscounted(frames, frames.last.end - first) {
            return Ok(true);
        }
        let Some(music) = &stated.music else {
            return Ok(false);
        };
        // The checksum counts for these bytes only.
        if frames.last.end - first != music.len {
            return Ok(false);
        }
        let mut checksum = Crc16AnsiLe::new(0);
        let mut at = first + tag.len;
        while at < frames.last.end {
            let bytes = self.window.at(at, PIECE.min(frames.last.end - at))?;
            if bytes.is_empty() {
                break;
            }
            checksum.process_buf_bytes(bytes);
            at += bytes.len() as u64;
        }
        Ok(checksum.crc() != music.checksum)
    }
}

/// What the encoder states of the stream in its first frame.
struct Tag {
    /// Number of frames behind the tag.
    frames: Option<u64>,
    /// Length of the stream in bytes, the tag included.
    bytes: Option<u64>,
    music: Option<Music>,
}

impl Tag {
    /// Whether neither the number of frames nor the length is that of the file, `len` bytes with the tag. Some encoders
    /// count one of them in another way; frames that are missing or repeated change both.
    fn is_miscounted(&self, frames: &Frames, len: u64) -> bool {
        // The last frame, which is not counted, stands for the tag, which is.
        let is_other_number = self.frames.is_some_and(|number| number != frames.count);
        is_other_number && self.bytes != Some(len)
    }
}

/// Length and checksum of the frames, as LAME and encoders with its tag state them.
struct Music {
    /// Length of all frames in bytes, that of the tag included.
    len: u64,
    /// CRC-16 of the frames behind the tag.
    checksum: u16,
}

impl Music {
    /// Parses the fields behind the optional ones, which the flags announce, and behind 28 bytes that are not needed here.
    fn of(tag: &[u8], flags: u64) -> Option<Self> {
        /// Flag and length in bytes of each optional field: frames, bytes, table of contents, quality.
        const FIELDS: [(u64, usize); 4] = [(1, 4), (2, 4), (4, 100), (8, 4)];
        let fields = FIELDS.iter().filter(|(flag, _)| flags & flag != 0);
        let offset = 8 + fields.map(|(_, len)| len).sum::<usize>() + 28;
        let len = u32::from_be_bytes(*tag.get(offset..)?.first_chunk()?);
        let checksum = u16::from_be_bytes(*tag.get(offset + 4..)?.first_chunk()?);
        // Encoders that do not count write zero.
        (len > 0 && checksum > 0).then_some(Self {
            len: len.into(),
            checksum,
        })
    }
}

/// The frames of the file.
#[derive(Default)]
struct Frames {
    tag: Option<Tag>,
    /// The ranges of the frames before the last one.
    kept: Vec<Range<u64>>,
    /// Number of those frames.
    count: u64,
    /// Length of those frames in bytes.
    bytes: u64,
    /// The last frame. Where no frame follows it, it may be damaged and is not kept.
    last: Range<u64>,
    /// Code of the bit rate of the last frame.
    bit_rate: Option<u32>,
    /// Whether the bit rate varies.
    is_variable: bool,
    holes: Vec<Hole>,
    /// Whether the file ends within a frame.
    is_cut: bool,
}

/// A range of bytes without frames; an empty one, where frames follow each other that cannot have done so.
struct Hole {
    /// Number of frames before it.
    frame: u64,
    /// Its length.
    bytes: u64,
}

impl Frames {
    /// Adds a frame; `is_next` unless it cannot have followed the one before.
    fn push(&mut self, at: u64, frame: Frame, is_next: bool) {
        self.keep_last();
        if !is_next {
            self.holes.push(Hole {
                frame: self.count,
                bytes: 0,
            });
        }
        self.last = at..at + frame.len;
        // The bit rate of a tag may differ from that of the sound.
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

    /// The result of the survey. The demuxer reads the bytes before the first frame and after the last one, too: they
    /// are mostly tags.
    fn framing(mut self, lead: Range<u64>, end: u64, is_altered: bool) -> Framing {
        self.keep_last();
        let tail = self.last.end..end;
        let mut breaks: Vec<Break> = self.holes.iter().map(|hole| self.missing(hole)).collect();
        // If there is one hole, all announced frames that are not there were in it.
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

    /// Number of frames according to the tag, itself included.
    fn announced(&self) -> Option<u64> {
        Some(self.tag.as_ref()?.frames? + 1)
    }

    /// What is missing in a hole. At a constant bit rate its length gives the number of frames: certainly so if that is
    /// a whole number of frames, since then the bytes are all there and only headers are damaged.
    fn missing(&self, hole: &Hole) -> Break {
        let frame_bytes = self.bytes as f64 / self.count.max(1) as f64;
        let frames = hole.bytes as f64 / frame_bytes;
        let count = frames.round().max(1.0);
        // Lengths of frames are whole bytes, so that the sum may differ by one.
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
