//! What the demuxer in use does not take from MP4, M4A and MOV files: edit lists, which state the parts of a track that
//! are presented, and descriptions of sound that it does not know.
//!
//! Encoders write 1024 (ffmpeg), 2112 (Apple) or another number of AAC frames in front of the sound
//! and make players skip them by an edit list (ISO/IEC 14496-12, boxes `edts` and `elst`). The
//! demuxer ignores these boxes, so they are read here.

use std::io::{self, Read, Seek, SeekFrom};

use super::alac::alac_setup;

/// A track.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct MovieTrack {
    pub(super) track_id: u32,
    /// In seconds; empty without an edit list.
    pub(super) edits: Vec<Edit>,
    /// How its sound is encoded; `None` if it has pictures.
    pub(super) sound: Option<SoundEntry>,
}

/// The description of sound (box `stsd`).
#[derive(Debug, Clone, PartialEq)]
pub(super) struct SoundEntry {
    /// Name of the codec in four letters.
    pub(super) codec: [u8; 4],
    /// The set-up of ALAC; `QuickTime` has it in a box within a box.
    pub(super) alac: Option<Vec<u8>>,
    /// Whether samples have the high byte first, unless the name of the codec tells: so `QuickTime` writes them where no
    /// box `enda` states the opposite.
    pub(super) is_high_first: bool,
}

/// A part of the track that is presented.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Edit {
    /// Start of the part, in seconds from the first sample of the track.
    pub(super) start_s: f64,
    /// Its length in seconds; `None` if it reaches to the end.
    pub(super) duration_s: Option<f64>,
    /// Whether it is played at another speed than that of the recording.
    pub(super) warped: bool,
}

/// Maximum number of boxes within a box: far more than a file has, so that a damaged file causes limited work.
const MAX_BOXES: usize = 10_000;
/// Maximum number of edits of a track, for the same reason.
const MAX_EDITS: usize = 1_000;

/// Maximum length of a description in bytes, for the same reason.
const MAX_ENTRY: u64 = 1 << 12;

/// The box that states that samples have the low byte first.
const LOW_FIRST: &[u8] = b"enda\0\x01";

/// Reads all tracks. Damaged boxes give none: the demuxer, which reads the same boxes later, reports the damage.
pub(super) fn read<S: Read + Seek + ?Sized>(source: &mut S) -> Vec<MovieTrack> {
    read_movie(source).unwrap_or_default()
}

fn read_movie<S: Read + Seek + ?Sized>(source: &mut S) -> io::Result<Vec<MovieTrack>> {
    let end = source.seek(SeekFrom::End(0))?;
    let mut tracks = Vec::new();
    for movie in boxes(source, 0..end)?
        .iter()
        .filter(|inner| &inner.kind == b"moov")
    {
        let parts = boxes(source, movie.start..movie.end)?;
        let Some(header) = first(&parts, *b"mvhd") else {
            continue;
        };
        let movie_scale = timescale(source, header)?;
        for track in parts.iter().filter(|inner| &inner.kind == b"trak") {
            tracks.extend(read_track(source, track, movie_scale)?);
        }
    }
    Ok(tracks)
}

fn read_track<S: Read + Seek + ?Sized>(
    source: &mut S,
    track: &BoxSpan,
    movie_scale: f64,
) -> io::Result<Option<MovieTrack>> {
    let parts = boxes(source, track.start..track.end)?;
    let (Some(header), Some(media)) = (first(&parts, *b"tkhd"), first(&parts, *b"mdia")) else {
        return Ok(None);
    };
    let media = boxes(source, media.start..media.end)?;
    let mut edits = Vec::new();
    if let (Some(list), Some(media_header)) = (
        descend(source, &parts, &[*b"edts", *b"elst"])?,
        first(&media, *b"mdhd"),
    ) {
        let media_scale = timescale(source, media_header)?;
        edits = edit_list(source, &list, movie_scale, media_scale)?;
    }
    Ok(Some(MovieTrack {
        track_id: track_id(source, header)?,
        edits,
        sound: sound_entry(source, &media)?,
    }))
}

/// The first description of a track of sound.
fn sound_entry<S: Read + Seek + ?Sized>(
    source: &mut S,
    media: &[BoxSpan],
) -> io::Result<Option<SoundEntry>> {
    let is_sound = descend(source, media, &[*b"minf", *b"smhd"])?.is_some();
    let list = descend(source, media, &[*b"minf", *b"stbl", *b"stsd"])?;
    let Some(list) = list.filter(|_| is_sound) else {
        return Ok(None);
    };
    let mut bytes = Vec::new();
    // Version and flags, number of descriptions, size and name of the first.
    source.seek(SeekFrom::Start(list.start + 12))?;
    let len = (list.end - list.start).min(MAX_ENTRY);
    source.take(len).read_to_end(&mut bytes)?;
    Ok(bytes.first_chunk().map(|&codec| SoundEntry {
        codec,
        alac: alac_setup(&bytes).map(<[u8]>::to_vec),
        is_high_first: !bytes.windows(LOW_FIRST.len()).any(|it| it == LOW_FIRST),
    }))
}

/// The box at the end of a path of boxes that lie within each other.
fn descend<S: Read + Seek + ?Sized>(
    source: &mut S,
    outer: &[BoxSpan],
    path: &[[u8; 4]],
) -> io::Result<Option<BoxSpan>> {
    let Some((kind, inner)) = path.split_first() else {
        return Ok(None);
    };
    match first(outer, *kind) {
        Some(found) if inner.is_empty() => Ok(Some(*found)),
        Some(found) => {
            let parts = boxes(source, found.start..found.end)?;
            descend(source, &parts, inner)
        }
        None => Ok(None),
    }
}

/// Kind of a box, and the position of its content in the file.
#[derive(Clone, Copy)]
struct BoxSpan {
    kind: [u8; 4],
    start: u64,
    end: u64,
}

fn first(boxes: &[BoxSpan], kind: [u8; 4]) -> Option<&BoxSpan> {
    boxes.iter().find(|inner| inner.kind == kind)
}

/// The boxes in a range of the file, without those within them. A box with an impossible length ends the list: a file
/// that was cut short may still have whole boxes in front.
fn boxes<S: Read + Seek + ?Sized>(
    source: &mut S,
    within: std::ops::Range<u64>,
) -> io::Result<Vec<BoxSpan>> {
    let mut spans = Vec::new();
    let mut at = within.start;
    while within.end.saturating_sub(at) >= 8 && spans.len() < MAX_BOXES {
        source.seek(SeekFrom::Start(at))?;
        let short_size = u64::from(read_u32(source)?);
        let kind = read_bytes(source)?;
        let (header, size) = match short_size {
            0 => (8, within.end - at),
            1 => (16, u64::from_be_bytes(read_bytes(source)?)),
            size => (8, size),
        };
        let Some(end) = at.checked_add(size).filter(|_| size >= header) else {
            break;
        };
        spans.push(BoxSpan {
            kind,
            start: at + header,
            end: end.min(within.end),
        });
        at = end;
    }
    Ok(spans)
}

/// Ticks in a second, from a movie or media header (`mvhd`, `mdhd`).
fn timescale<S: Read + Seek + ?Sized>(source: &mut S, header: &BoxSpan) -> io::Result<f64> {
    let wide = open_versioned(source, header)? == 1;
    source.seek(SeekFrom::Current(if wide { 16 } else { 8 }))?;
    Ok(f64::from(read_u32(source)?.max(1)))
}

fn track_id<S: Read + Seek + ?Sized>(source: &mut S, header: &BoxSpan) -> io::Result<u32> {
    let wide = open_versioned(source, header)? == 1;
    source.seek(SeekFrom::Current(if wide { 16 } else { 8 }))?;
    read_u32(source)
}

fn edit_list<S: Read + Seek + ?Sized>(
    source: &mut S,
    list: &BoxSpan,
    movie_scale: f64,
    media_scale: f64,
) -> io::Result<Vec<Edit>> {
    let wide = open_versioned(source, list)? == 1;
    let count = read_u32(source)? as usize;
    let mut edits = Vec::new();
    for _ in 0..count.min(MAX_EDITS) {
        let (duration, start) = if wide {
            (
                u64::from_be_bytes(read_bytes(source)?),
                i64::from_be_bytes(read_bytes(source)?),
            )
        } else {
            let duration = u64::from(read_u32(source)?);
            (duration, i64::from(i32::from_be_bytes(read_bytes(source)?)))
        };
        let speed = read_u32(source)?;
        // A start of -1 is a pause. In front of the sound it only makes the picture start first; here times count
        // from the start of the sound.
        if start >= 0 {
            edits.push(Edit {
                start_s: start as f64 / media_scale,
                duration_s: (duration > 0).then(|| duration as f64 / movie_scale),
                warped: speed != 0x0001_0000,
            });
        }
    }
    Ok(edits)
}

/// Goes to the first field behind version and flags; returns the version.
fn open_versioned<S: Read + Seek + ?Sized>(source: &mut S, inner: &BoxSpan) -> io::Result<u8> {
    source.seek(SeekFrom::Start(inner.start))?;
    let [version, ..] = read_bytes::<4, S>(source)?;
    Ok(version)
}

fn read_u32<S: Read + ?Sized>(source: &mut S) -> io::Result<u32> {
    Ok(u32::from_be_bytes(read_bytes(source)?))
}

fn read_bytes<const N: usize, S: Read + ?Sized>(source: &mut S) -> io::Result<[u8; N]> {
    let mut bytes = [0; N];
    source.read_exact(&mut bytes)?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use std::io::Cursor;

    use super::*;

    fn enclose(kind: &[u8], content: &[&[u8]]) -> Vec<u8> {
        let content = content.concat();
        let size = (content.len() + 8) as u32;
        [&size.to_be_bytes(), kind, &content].concat()
    }

    fn words(words: &[u32]) -> Vec<u8> {
        words.iter().flat_map(|word| word.to_be_bytes()).collect()
    }

    /// A movie of 600 ticks a second with one track, number 7, of 44100, and this edit list.
    fn movie(list: &[u32]) -> Vec<u8> {
        let movie_header = enclose(b"mvhd", &[&words(&[0, 0, 0, 600])]);
        let track_header = enclose(b"tkhd", &[&words(&[0, 0, 0, 7])]);
        let media_header = enclose(b"mdhd", &[&words(&[0, 0, 0, 44_100])]);
        let media = enclose(b"mdia", &[&media_header]);
        let edits = enclose(b"edts", &[&enclose(b"elst", &[&words(list)])]);
        let track = enclose(b"trak", &[&track_header, &edits, &media]);
        [
            enclose(b"ftyp", &[b"qt  "]),
            enclose(b"moov", &[&movie_header, &track]),
        ]
        .concat()
    }

    fn edits(file: Vec<u8>) -> Vec<Edit> {
        let tracks = read(&mut Cursor::new(file));
        tracks
            .into_iter()
            .filter(|track| track.track_id == 7)
            .flat_map(|it| it.edits)
            .collect()
    }

    const NORMAL_SPEED: u32 = 0x0001_0000;

    #[test]
    fn starts_count_in_the_clock_of_the_media_and_lengths_in_that_of_the_movie() {
        let list = [0, 2, 300, 2_205, NORMAL_SPEED, 600, 44_100, NORMAL_SPEED];
        let edit = |start_s, duration_s| Edit {
            start_s,
            duration_s: Some(duration_s),
            warped: false,
        };
        assert_eq!(edits(movie(&list)), [edit(0.05, 0.5), edit(1.0, 1.0)]);
    }

    #[test]
    fn wide_lists_open_ends_pauses_and_other_speeds_are_read() {
        let version_1 = 1 << 24;
        let wide = [version_1, 1, 0, 300, 0, 2_205, NORMAL_SPEED];
        assert_eq!(
            edits(movie(&wide)),
            edits(movie(&[0, 1, 300, 2_205, NORMAL_SPEED]))
        );
        let pause_first = [0, 2, 90, u32::MAX, NORMAL_SPEED, 0, 0, NORMAL_SPEED];
        let whole = Edit {
            start_s: 0.0,
            duration_s: None,
            warped: false,
        };
        assert_eq!(edits(movie(&pause_first)), [whole]);
        assert!(edits(movie(&[0, 1, 300, 0, NORMAL_SPEED / 2]))[0].warped);
    }

    #[test]
    fn lists_that_break_off_are_no_lists() {
        let file = movie(&[0, 1, 300, 2_205, NORMAL_SPEED]);
        for len in 0..file.len() {
            read(&mut Cursor::new(&file[..len]));
        }
        assert_eq!(edits(movie(&[0, 1_000_000, 300])), []);
    }
}
