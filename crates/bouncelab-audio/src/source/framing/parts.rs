//! The parts of an MP4 file that is written as a stream (ISO 14496-12 section 8.8).
//!
//! A part lists the lengths and durations of its samples. What it states must agree with the parts before it and with the bytes
//! behind it: the demuxer steps over what it does not know, and does not read the time at which a part begins.

use std::io::{self, Read, Seek};
use std::ops::Range;

use super::Window;
use super::nested::{Header, atom, kind};

/// What the parts so far state.
#[derive(Default)]
pub(super) struct Parts {
    tracks: Vec<Track>,
    sequence: u32,
    /// Position of the last part; `None` before the first one.
    at: Option<u64>,
    /// Number of bytes that it lists, and that follow it.
    listed: u64,
    held: u64,
}

/// A track that the film announces.
#[derive(Clone, Copy)]
struct Track {
    id: u32,
    /// Duration in ticks and length in bytes of a sample for which a part states none.
    sample: Sample,
    /// Time at which its next part should begin, in ticks, and how far it may be off; `None` before the first part.
    due: Option<(u64, u64)>,
}

/// A sample: its duration in ticks and its length in bytes.
#[derive(Clone, Copy)]
struct Sample {
    duration: u32,
    bytes: u32,
}

impl Parts {
    /// Takes the description of the film; returns whether it announces parts.
    pub(super) fn take_movie<S: Read + Seek>(
        &mut self,
        window: &mut Window<S>,
        movie: &Header,
    ) -> io::Result<bool> {
        let film = children(window, movie.content..movie.end.unwrap_or(window.len))?;
        let Some(announced) = film.iter().find(|it| it.kind == kind(*b"mvex")) else {
            return Ok(false);
        };
        for track in children(window, announced.range.clone())? {
            if track.kind == kind(*b"trex") {
                let fields = Fields::of(window, &track)?;
                // Version and flags, track, description, duration, bytes.
                let [_, id, _, duration, bytes] = [0, 4, 8, 12, 16].map(|at| fields.u32(at));
                if let (Some(id), Some(duration), Some(bytes)) = (id, duration, bytes) {
                    self.tracks.push(Track {
                        id,
                        sample: Sample { duration, bytes },
                        due: None,
                    });
                }
            }
        }
        Ok(true)
    }

    /// Takes a part at this position. The error is the position from which on nothing can be used.
    pub(super) fn take_part<S: Read + Seek>(
        &mut self,
        window: &mut Window<S>,
        at: u64,
        part: &Header,
    ) -> io::Result<Result<(), u64>> {
        if let Err(at) = self.finish() {
            return Ok(Err(at));
        }
        (self.at, self.listed, self.held) = (Some(at), 0, 0);
        let end = part.end.unwrap_or(window.len);
        let is_read = self.read_part(window, part.content..end)?;
        Ok(is_read.ok_or(at))
    }

    /// Takes the bytes of samples.
    pub(super) fn take_sound(&mut self, sound: Range<u64>) {
        self.held += sound.end - sound.start;
    }

    /// Compares the last part with the bytes behind it. The error is its position.
    pub(super) fn finish(&self) -> Result<(), u64> {
        match self.at {
            Some(at) if self.listed != self.held => Err(at),
            _ => Ok(()),
        }
    }

    /// `None` if the part contradicts itself or the parts before it.
    fn read_part<S: Read + Seek>(
        &mut self,
        window: &mut Window<S>,
        content: Range<u64>,
    ) -> io::Result<Option<()>> {
        const KNOWN: [[u8; 4]; 4] = [*b"mfhd", *b"traf", *b"pssh", *b"uuid"];
        let Some(boxes) = whole(window, content, &KNOWN)? else {
            return Ok(None);
        };
        for inner in boxes {
            let is_right = if inner.kind == kind(*b"mfhd") {
                let sequence = Fields::of(window, &inner)?.u32(4);
                let is_next = sequence.is_some_and(|it| self.sequence == 0 || it > self.sequence);
                self.sequence = sequence.unwrap_or(0);
                is_next
            } else if inner.kind == kind(*b"traf") {
                self.read_track(window, inner.range)?.is_some()
            } else {
                true
            };
            if !is_right {
                return Ok(None);
            }
        }
        Ok(Some(()))
    }

    /// Reads the samples of one track in a part.
    fn read_track<S: Read + Seek>(
        &mut self,
        window: &mut Window<S>,
        content: Range<u64>,
    ) -> io::Result<Option<()>> {
        const KNOWN: [[u8; 4]; 11] = [
            *b"tfhd", *b"tfdt", *b"trun", *b"sbgp", *b"sgpd", *b"subs", *b"saiz", *b"saio",
            *b"senc", *b"meta", *b"uuid",
        ];
        let Some(boxes) = whole(window, content, &KNOWN)? else {
            return Ok(None);
        };
        let named = |name| boxes.iter().filter(move |it| it.kind == kind(name));
        let Some(header) = named(*b"tfhd").next() else {
            return Ok(None);
        };
        let header = Fields::of(window, header)?;
        let id = header.u32(4);
        let Some(track) = self.tracks.iter_mut().find(|track| Some(track.id) == id) else {
            return Ok(None);
        };
        let Some(usual) = header.usual_sample(track.sample) else {
            return Ok(None);
        };
        let mut time = track.due;
        if let Some(begin) = named(*b"tfdt").next() {
            let Some(stated) = Fields::of(window, begin)?.time() else {
                return Ok(None);
            };
            let is_due = track
                .due
                .is_none_or(|(due, reach)| due.abs_diff(stated) <= reach);
            if !is_due {
                return Ok(None);
            }
            time = Some((stated, 0));
        }
        let mut at = time.map_or(0, |(time, _)| time);
        let mut reach = 0;
        for run in named(*b"trun") {
            let Some(run) = Run::of(window, run, usual)? else {
                return Ok(None);
            };
            at = at.saturating_add(run.duration);
            reach = u64::from(run.last / 2);
            self.listed = self.listed.saturating_add(run.bytes);
        }
        track.due = Some((at, reach));
        Ok(Some(()))
    }
}

/// A box within another.
struct Inner {
    kind: u64,
    range: Range<u64>,
}

/// The boxes in a range, up to one that cannot be read.
fn children<S: Read + Seek>(window: &mut Window<S>, range: Range<u64>) -> io::Result<Vec<Inner>> {
    let mut inner = Vec::new();
    let mut at = range.start;
    while at < range.end {
        let header = atom(window.at(at, 16)?, at);
        let end = header.as_ref().map(|it| it.end.unwrap_or(range.end));
        let (Some(header), Some(end)) = (header, end.filter(|&end| end <= range.end)) else {
            break;
        };
        inner.push(Inner {
            kind: header.kind,
            range: header.content..end,
        });
        at = end;
    }
    Ok(inner)
}

/// The boxes in a range, if they fill it and all have names that may be there.
fn whole<S: Read + Seek>(
    window: &mut Window<S>,
    range: Range<u64>,
    known: &[[u8; 4]],
) -> io::Result<Option<Vec<Inner>>> {
    const ANYWHERE: [[u8; 4]; 2] = [*b"free", *b"skip"];
    let end = range.end;
    let inner = children(window, range)?;
    let is_known = |it: &Inner| {
        known
            .iter()
            .chain(&ANYWHERE)
            .any(|name| kind(*name) == it.kind)
    };
    let is_whole = inner.last().is_some_and(|last| last.range.end == end);
    Ok((is_whole && inner.iter().all(is_known)).then_some(inner))
}

/// The content of a box that states numbers.
struct Fields(Vec<u8>);

impl Fields {
    fn of<S: Read + Seek>(window: &mut Window<S>, inner: &Inner) -> io::Result<Self> {
        let len = inner.range.end - inner.range.start;
        Ok(Self(window.at(inner.range.start, len)?.to_vec()))
    }

    fn u32(&self, at: usize) -> Option<u32> {
        Some(u32::from_be_bytes(*self.0.get(at..)?.first_chunk()?))
    }

    fn flags(&self) -> Option<u32> {
        Some(self.u32(0)? & 0x00ff_ffff)
    }

    /// The time at which a part begins (box `tfdt`), of 64 bits in version 1.
    fn time(&self) -> Option<u64> {
        match self.0.first()? {
            0 => self.u32(4).map(u64::from),
            _ => Some(u64::from(self.u32(4)?) << 32 | u64::from(self.u32(8)?)),
        }
    }

    /// What the header of a track in a part (box `tfhd`) states of its samples.
    fn usual_sample(&self, announced: Sample) -> Option<Sample> {
        let flags = self.flags()?;
        let mut at = 8 + if flags & 1 != 0 { 8 } else { 0 } + if flags & 2 != 0 { 4 } else { 0 };
        let mut next = |flag, otherwise| {
            if flags & flag == 0 {
                return Some(otherwise);
            }
            at += 4;
            self.u32(at - 4)
        };
        Some(Sample {
            duration: next(8, announced.duration)?,
            bytes: next(16, announced.bytes)?,
        })
    }
}

/// The sums of the samples of a run, and the duration of the last one.
struct Run {
    duration: u64,
    bytes: u64,
    last: u32,
}

impl Run {
    /// Reads a box `trun`; `None` if the number of samples does not fill it.
    fn of<S: Read + Seek>(
        window: &mut Window<S>,
        inner: &Inner,
        usual: Sample,
    ) -> io::Result<Option<Self>> {
        let head = Fields(window.at(inner.range.start, 8)?.to_vec());
        let (Some(flags), Some(count)) = (head.flags(), head.u32(4)) else {
            return Ok(None);
        };
        let fields = |of: &[u32]| 4 * of.iter().filter(|&flag| flags & flag != 0).count() as u64;
        // Position of the sound, and flags of the first sample; duration, bytes, flags and shift of each.
        let start = inner.range.start + 8 + fields(&[1, 4]);
        let each = fields(&[0x100, 0x200, 0x400, 0x800]);
        let [duration_len, bytes_len] = [0x100, 0x200].map(|flag| fields(&[flag]));
        if start + each * u64::from(count) != inner.range.end {
            return Ok(None);
        }
        let count = u64::from(count);
        let mut run = Self {
            duration: count.saturating_mul(usual.duration.into()),
            bytes: count.saturating_mul(usual.bytes.into()),
            last: usual.duration,
        };
        if duration_len > 0 {
            run.duration = 0;
        }
        if bytes_len > 0 {
            run.bytes = 0;
        }
        // Without such fields the number of samples bounds no work.
        let listed = if duration_len + bytes_len > 0 {
            count
        } else {
            0
        };
        for number in 0..listed {
            let sample = Fields(window.at(start + number * each, each)?.to_vec());
            if duration_len > 0 {
                run.last = sample.u32(0).unwrap_or(0);
                run.duration += u64::from(run.last);
            }
            if bytes_len > 0 {
                run.bytes += u64::from(sample.u32(duration_len as usize).unwrap_or(0));
            }
        }
        Ok(Some(run))
    }
}
