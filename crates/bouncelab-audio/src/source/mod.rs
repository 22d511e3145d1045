//! A recording as a stream of blocks of samples.

mod alac;
mod apple;
mod blank;
mod chunks;
mod codec;
mod content;
mod flips;
mod framing;
mod input;
mod lost;
mod movie;
mod opus;
mod presentation;
mod track;
pub(crate) mod wave;

use std::fmt;
use std::fs::{self, File};
use std::io::{Cursor, Read, Seek, SeekFrom};
use std::ops::Range;
use std::path::Path;
use std::sync::Arc;

use bouncelab::Plain;
use bouncelab::analysis::Gap;

use self::blank::Blanks;
use self::chunks::{Header, RateDoubt};
use self::codec::{Layout, MAX_CHANNELS};
use self::content::Content;
use self::flips::Flips;
use self::input::MediaInput;
pub use self::input::position_after;
use self::lost::Lost;
use self::presentation::Presentation;
use self::track::{Next, Step, Track};
use crate::error::{Error, Result};
use crate::formats::SoundFormat;
use crate::lost_chunk;
use crate::problem::{LayoutProblem, MissingContent, Stage};
use crate::warning::Warning;

/// The lowest sample rate that is read, in hertz. At lower rates little of a click is left, and
/// its onset is uncertain by more than a quarter of a millisecond.
pub const MIN_SAMPLE_RATE_HZ: u32 = 4_000;

/// The highest sample rate that is read, in hertz: above that of any recorder, and below many rates in
/// damaged headers.
pub const MAX_SAMPLE_RATE_HZ: u32 = 10_000_000;

/// Maximum number of frames in a [`Block`].
pub const MAX_BLOCK_FRAMES: usize = 4_096;

/// Maximum duration that is read, in seconds: a small file may claim any length.
const MAX_DURATION_S: u64 = 24 * 3600;
/// Maximum number of samples of all channels that are read: those of two channels at 192 kHz in that time.
const MAX_SAMPLES: u64 = MAX_DURATION_S * 2 * 192_000;
/// Maximum number of gaps: a file with more is read up to there.
const MAX_GAPS: usize = 1_000;
/// Minimum level of a sample that is damaged, in units of full scale: no sound reaches it.
const MIN_DAMAGED: f32 = 1e7;

/// A recording being read, block by block, in memory that does not grow with its length.
///
/// The first frame is time zero and the frame `i` is at `i / sample_rate_hz` seconds. The priming that an
/// encoder writes in front of the sound (21 ms in most AAC, 7 ms in Opus) is left out wherever the
/// file states its length, so that times agree with those of other players:
///
/// | format | what states the length of the priming |
/// |---|---|
/// | MP4, M4A, MOV | the track's edit list, else the iTunes tag, else the pre-skip of Opus |
/// | Opus in Ogg and Matroska (`.webm`, `.mkv`) | the pre-skip in the Opus header |
/// | MP3 | the LAME or Info tag |
/// | Vorbis | the stream itself |
///
/// Sound from a file that does not state it (an MP3 without tag, AAC in a bare stream or in Matroska) is
/// late by a constant 20 to 50 ms, in other players as here. Differences between times, which are all that
/// the physics needs, are not affected.
///
/// Integer samples are scaled to `-1.0..1.0`; float samples are taken as they are, except that
/// NaN and infinity become zero and are reported ([`Warning::NonFinite`]): one bad sample of an
/// exporting program should neither make the recording useless nor spread into everything computed from it.
///
/// ```
/// use bouncelab_audio::SoundReader;
///
/// # let wav = include_bytes!("../../tests/fixtures/pcm16.wav").to_vec();
/// let mut source = SoundReader::from_bytes(wav, "clicks.wav")?;
/// let mut loudest: f32 = 0.0;
/// while let Some(block) = source.next_block()? {
///     loudest = block.channel(0).iter().fold(loudest, |peak, sample| peak.max(sample.abs()));
/// }
/// assert!(loudest > 0.4);
/// assert!(source.warnings().is_empty());
/// # Ok::<(), bouncelab_audio::Error>(())
/// ```
pub struct SoundReader {
    name: String,
    description: Option<&'static str>,
    track: Track,
    layout: Layout,
    presentation: Presentation,
    /// Decoded frames of all channels; the first is frame `planes_start` of the decoded stream.
    planes: Vec<Vec<f32>>,
    planes_start: u64,
    /// The frames in `planes` that were not yet returned.
    pending: Range<u64>,
    /// Lost frames before those, for which silence is returned.
    hole: Range<u64>,
    silence: Vec<Vec<f32>>,
    gaps: Vec<Gap>,
    blanks: Blanks,
    flips: Flips,
    /// Number of frames that were returned.
    presented: u64,
    ended: bool,
    warnings: Vec<Warning>,
}

/// Consecutive samples of all channels.
#[derive(Debug, Clone)]
pub struct Block<'a> {
    planes: &'a [Vec<f32>],
    within: Range<usize>,
    start_frame: u64,
}

impl Block<'_> {
    /// The samples of one channel, counted from 0.
    ///
    /// # Panics
    ///
    /// If there is no such channel: see [`SoundReader::channels`].
    pub fn channel(&self, channel: usize) -> &[f32] {
        &self.planes[channel][self.within.clone()]
    }

    /// Number of channels: always [`SoundReader::channels`].
    pub fn channels(&self) -> usize {
        self.planes.len()
    }

    /// Number of samples of each channel: 1 to [`MAX_BLOCK_FRAMES`].
    pub fn frames(&self) -> usize {
        self.within.len()
    }

    /// Index of the first frame in the recording.
    pub fn start_frame(&self) -> u64 {
        self.start_frame
    }
}

impl fmt::Debug for SoundReader {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("SoundReader")
            .field("name", &self.name)
            .field("format", &self.format())
            .field("layout", &self.layout)
            .field("presented", &self.presented)
            .field("warnings", &self.warnings)
            .finish_non_exhaustive()
    }
}

impl SoundReader {
    /// Opens a file and decodes its first packet.
    ///
    /// # Errors
    ///
    /// Any variant of [`Error`] but [`Error::Times`] and [`Error::Unwritable`]: the file is not
    /// there, not sound, damaged before the first sample, or of a kind that is not supported.
    pub fn open(path: impl AsRef<Path>) -> Result<Self> {
        let path = path.as_ref();
        let name = String::from(Plain::path(path));
        let failed = |reason| Error::io(&name, reason);
        let about = fs::metadata(path).map_err(failed)?;
        // Opening a folder succeeds on some systems and fails with unrelated errors on others; opening a pipe waits
        // until another program writes into it.
        if about.is_dir() {
            return Err(Error::Directory { name });
        }
        if !about.is_file() {
            return Err(Error::Pipe { name });
        }
        let file = File::open(path).map_err(failed)?;
        Self::from_reader(file, &name)
    }

    /// Reads a recording from memory; the name is for messages only.
    ///
    /// # Errors
    ///
    /// As for [`SoundReader::open`].
    pub fn from_bytes(bytes: impl Into<Arc<[u8]>>, name: &str) -> Result<Self> {
        Self::from_reader(Cursor::new(bytes.into()), name)
    }

    /// Reads a recording from anything that can be read and searched; the name is for messages
    /// only.
    ///
    /// # Errors
    ///
    /// As for [`SoundReader::open`].
    pub fn from_reader<R>(reader: R, name: &str) -> Result<Self>
    where
        R: Read + Seek + Send + Sync + 'static,
    {
        let fail = |reason| Error::io(name, reason);
        let unsupported = |format, codec| Error::UnsupportedCodec {
            name: name.to_owned(),
            format,
            codec,
        };
        let mut reader = MediaInput::new(reader).map_err(fail)?;
        let container = match content::identify(&mut reader).map_err(fail)? {
            Content::Sound(container) => container,
            Content::Foreign(format, codec) => return Err(unsupported(format, codec)),
            Content::Other(looks_like) => {
                return Err(Error::NotSound {
                    name: name.to_owned(),
                    looks_like,
                });
            }
            Content::Nothing => {
                return Err(Error::Empty {
                    name: name.to_owned(),
                    what: MissingContent::Content,
                });
            }
        };
        reader.set_stream(container.is_stream());
        let start = reader.stream_position().map_err(fail)?;
        let mut header = match container {
            SoundFormat::Wav => wave::header(&mut reader).map_err(fail)?,
            SoundFormat::Aiff | SoundFormat::Caf => apple::header(&mut reader).map_err(fail)?,
            _ => Header::default(),
        };
        let malformed = |stage, detail| Error::Malformed {
            name: name.to_owned(),
            format: container.name(),
            stage,
            detail,
        };
        if let Some(codec) = header.foreign_codec.take() {
            return Err(unsupported(container.name(), codec));
        }
        if let Some(contradiction) = header.contradiction.take() {
            return Err(malformed(Stage::Header, contradiction));
        }
        match header.mended.take() {
            Some(wave) => reader.read_behind(wave.header, wave.sound),
            None => reader.seek(SeekFrom::Start(start)).map(drop),
        }
        .map_err(fail)?;
        let surveyed = framing::survey(container, &mut reader).map_err(fail)?;
        let damaged = || "it is damaged in too many places".to_owned();
        let mut framing = surveyed.ok_or_else(|| malformed(Stage::Sound, damaged()))?;
        framing.is_cut |= header.is_unfinished;
        if let Some(sound) = framing.sound.take() {
            reader.read_only(sound).map_err(fail)?;
        }
        let track = Track::open(container, Box::new(reader), framing, name)?;
        let mut source = Self::start(track, name)?;
        for gap in lost_chunk::decode(&header.lost, source.sample_rate_hz()) {
            source.note_gap(gap);
        }
        if let Some(doubt) = header.rate_doubt {
            source.warnings.push(Warning::RateInDoubt {
                stated_hz: source.sample_rate_hz(),
                implied_hz: match doubt {
                    RateDoubt::Contradicted(implied_hz) => Some(implied_hz),
                    RateDoubt::Unusual => None,
                },
            });
        }
        Ok(source)
    }

    /// Decodes the first sound. A source that exists can be read, and its layout is that of
    /// the sound, from which that of the header may differ.
    fn start(mut track: Track, name: &str) -> Result<Self> {
        let mut planes = Vec::new();
        let Step { lost, next } = track.step(name, &mut planes)?;
        let Next::Sound(layout) = next else {
            return Err(track.undecodable(name));
        };
        check_layout(layout.sample_rate_hz, layout.channels, name)?;
        let edited = track.presentation(layout);
        let mut source = Self {
            name: name.to_owned(),
            description: None,
            layout,
            pending: 0..0,
            hole: 0..0,
            silence: vec![vec![0.0; MAX_BLOCK_FRAMES]; layout.channels],
            gaps: Vec::new(),
            blanks: Blanks::default(),
            flips: Flips::default(),
            planes,
            planes_start: 0,
            presented: 0,
            ended: false,
            warnings: Vec::new(),
            presentation: edited.clone().unwrap_or_else(|| track.unedited()),
            track,
        };
        if edited.is_none() {
            source.warnings.push(Warning::EditsIgnored);
        }
        let begins = source.lose(0, lost);
        source.take_planes(begins);
        source.scrub();
        Ok(source)
    }

    /// Samples of each channel per second, in Hz.
    pub fn sample_rate_hz(&self) -> u32 {
        self.layout.sample_rate_hz
    }

    /// Number of channels: 1 to 64.
    pub fn channels(&self) -> usize {
        self.layout.channels
    }

    /// The format for people, such as "AAC in MOV" or "16-bit WAV".
    pub fn format(&self) -> String {
        let format = self.description.map(str::to_owned);
        format.unwrap_or_else(|| self.track.format())
    }

    /// This source with another description of its format.
    pub(crate) fn described_as(mut self, description: &'static str) -> Self {
        self.description = Some(description);
        self
    }

    /// The file, as the caller named it.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Duration of the sound in seconds according to the file; `None` if the file does not state it, as
    /// recordings of browsers do not. It is meant for a display of progress: the header may be wrong,
    /// and without a header the duration is an estimate.
    pub fn duration_s(&self) -> Option<f64> {
        let announced = self.track.announced(self.layout, &self.presentation)?;
        Some(self.seconds(announced.frames))
    }

    /// The damage of the recording, as far as it was read.
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    /// The places where sound was lost, as far as the recording was read; silence stands in them. Those that a
    /// [`Recorder`](crate::Recorder) noted in its file are known at once.
    pub fn gaps(&self) -> &[Gap] {
        &self.gaps
    }

    /// The next samples, or `None` at the end.
    ///
    /// # Errors
    ///
    /// [`Error::Io`] if the system fails to read, [`Error::TooLong`] after 24 hours, or less with many
    /// channels at a high rate. Damage in the file is no
    /// error here: everything that can be decoded is returned, and [`SoundReader::warnings`] state the rest.
    pub fn next_block(&mut self) -> Result<Option<Block<'_>>> {
        let max_frames = self.max_frames();
        if self.presented.max(self.pending.end) > max_frames {
            return Err(Error::TooLong {
                name: self.name.clone(),
                // In hundredths of an hour, which are 36 s.
                max_h: (self.seconds(max_frames) / 36.0).floor() / 100.0,
            });
        }
        loop {
            if let Some(part) = self.presentation.first_within(&self.hole) {
                let end = part.end.min(part.start + MAX_BLOCK_FRAMES as u64);
                self.hole.start = end;
                let len = (end - part.start) as usize;
                return Ok(Some(self.block(0..len, true)));
            }
            self.hole = 0..0;
            if let Some(part) = self.presentation.first_within(&self.pending) {
                let end = part.end.min(part.start + MAX_BLOCK_FRAMES as u64);
                self.pending.start = end;
                let index = |frame| (frame - self.planes_start) as usize;
                let within = index(part.start)..index(end);
                return Ok(Some(self.block(within, false)));
            }
            if self.ended {
                return Ok(None);
            }
            self.decode_more()?;
        }
    }

    /// Maximum number of frames that are read.
    fn max_frames(&self) -> u64 {
        let in_time = MAX_DURATION_S * u64::from(self.layout.sample_rate_hz);
        in_time.min(MAX_SAMPLES / self.layout.channels as u64)
    }

    /// The next block: these frames of the planes, or as many frames of silence.
    fn block(&mut self, within: Range<usize>, is_silence: bool) -> Block<'_> {
        let start_frame = self.presented;
        self.presented += within.len() as u64;
        Block {
            planes: if is_silence {
                &self.silence
            } else {
                &self.planes
            },
            within,
            start_frame,
        }
    }

    /// Decodes the next packet into `planes`, or ends the recording.
    fn decode_more(&mut self) -> Result<()> {
        let decoded = self.pending.end;
        if decoded >= self.presentation.end() {
            self.stop(decoded);
            return Ok(());
        }
        let Step { lost, next } = self.track.step(&self.name, &mut self.planes)?;
        let at = self.lose(decoded, lost);
        match next {
            _ if lost.is_some() && self.gaps.len() > MAX_GAPS => self.end(at, true),
            Next::Sound(layout) if layout != self.layout => {
                self.warnings.push(Warning::FormatChange {
                    at_s: self.presented_s(at),
                });
                self.stop(at);
            }
            Next::Sound(_) => {
                self.take_planes(at);
                self.scrub();
            }
            Next::End => self.end(at, false),
            Next::Broken => self.end(at, true),
            Next::Altered => {
                let known = self.warnings.len();
                self.end(at, false);
                if self.warnings.len() == known {
                    self.note_altered(at);
                }
            }
        }
        Ok(())
    }

    /// Notes that sound was lost from the decoded frame `at` on; returns the frame with which it continues.
    fn lose(&mut self, at: u64, lost: Option<Lost>) -> u64 {
        let Some(Lost { frames, certain }) = lost else {
            return at;
        };
        let end = at + frames;
        self.hole = at..end;
        let start_s = self.presented_s(at);
        let gap = Gap {
            start_s,
            duration_s: self.presented_s(end) - start_s,
            certain,
        };
        self.note_gap(gap);
        end
    }

    fn note_gap(&mut self, gap: Gap) {
        self.gaps.push(gap);
        Warning::note_gap(&mut self.warnings, gap);
    }

    /// The planes now hold the decoded stream from this frame on.
    fn take_planes(&mut self, at: u64) {
        self.planes_start = at;
        self.pending = at..at + self.planes[0].len() as u64;
        if self.track.is_plain() {
            self.blanks.take(at, &self.planes);
            self.flips.take(at, &self.planes);
        }
    }

    /// Ends the recording at this decoded frame.
    fn stop(&mut self, at: u64) {
        self.ended = true;
        self.pending = at..at;
        if self.track.is_altered() {
            self.note_altered(at);
        }
    }

    /// Notes that the sound before this decoded frame differs somewhere from the encoded sound.
    fn note_altered(&mut self, at: u64) {
        let read_s = self.presented_s(at);
        self.warnings.push(Warning::Altered { read_s });
    }

    /// Ends the recording at this decoded frame, and warns if that is too early: if the file cannot be read behind it
    /// (`is_broken`), or is shorter than announced.
    fn end(&mut self, at: u64, is_broken: bool) {
        self.stop(at);
        // A recorder writes zeros where it notes a loss: these are no further damage.
        let noted = self.gaps.len() as u64;
        let blanks = self.blanks.suspect().filter(|(places, ..)| *places > noted);
        if let Some((places, first, frames)) = blanks {
            self.warnings.push(Warning::Blank {
                places,
                first_s: self.presented_s(first),
                blank_s: self.seconds(frames),
            });
        }
        if let Some((samples, first)) = self.flips.suspect() {
            let first_s = self.presented_s(first);
            self.warnings.push(Warning::Flipped { samples, first_s });
        }
        let read_s = self.presented_s(at);
        let announced = self.track.announced(self.layout, &self.presentation);
        let counted = announced.and_then(|it| Some((self.seconds(it.frames), it.tolerance_s?)));
        let is_short = |(expected_s, tolerance_s)| expected_s - read_s > tolerance_s;
        if is_broken || counted.is_some_and(is_short) {
            let expected_s = counted.filter(|it| is_short(*it)).map(|it| it.0);
            self.warnings
                .push(Warning::Truncated { read_s, expected_s });
        }
    }

    /// Replaces damaged samples by zero.
    fn scrub(&mut self) {
        let is_invalid = |sample: &f32| sample.is_nan() || sample.abs() >= MIN_DAMAGED;
        // Fast path: nearly all blocks have valid samples only, which a pass without branches shows.
        let has_invalid =
            |plane: &Vec<f32>| plane.iter().fold(false, |any, it| any | is_invalid(it));
        if !self.planes.iter().any(has_invalid) {
            return;
        }
        let mut count = 0;
        let mut first = usize::MAX;
        for plane in &mut self.planes {
            for (index, sample) in plane.iter_mut().enumerate() {
                if is_invalid(sample) {
                    *sample = 0.0;
                    count += 1;
                    first = first.min(index);
                }
            }
        }
        let noted = self.warnings.iter_mut().find_map(|warning| match warning {
            Warning::NonFinite { samples, .. } => Some(samples),
            _ => None,
        });
        if let Some(samples) = noted {
            *samples += count;
        } else {
            let first_s = self.presented_s(self.planes_start + first as u64);
            self.warnings.push(Warning::NonFinite {
                samples: count,
                first_s,
            });
        }
    }

    /// The presented time of a decoded frame.
    fn presented_s(&self, decoded: u64) -> f64 {
        self.seconds(self.presentation.count(decoded))
    }

    fn seconds(&self, frames: u64) -> f64 {
        frames as f64 / f64::from(self.layout.sample_rate_hz)
    }
}

/// Checks the sample rate and the number of channels of sound, which may also come from a microphone.
///
/// # Errors
///
/// [`Error::UnsupportedLayout`] with this name, if the rate is below [`MIN_SAMPLE_RATE_HZ`] or above
/// [`MAX_SAMPLE_RATE_HZ`], or there are more than 64 channels.
///
/// ```
/// assert!(bouncelab_audio::check_layout(44_100, 2, "microphone").is_ok());
/// assert!(bouncelab_audio::check_layout(1_000, 2, "microphone").is_err());
/// ```
pub fn check_layout(sample_rate_hz: u32, channels: usize, name: &str) -> Result<()> {
    let problem = if sample_rate_hz < MIN_SAMPLE_RATE_HZ {
        LayoutProblem::TooSlow {
            sample_rate_hz,
            min_hz: MIN_SAMPLE_RATE_HZ,
        }
    } else if sample_rate_hz > MAX_SAMPLE_RATE_HZ {
        LayoutProblem::TooFast {
            sample_rate_hz,
            max_hz: MAX_SAMPLE_RATE_HZ,
        }
    } else if channels > MAX_CHANNELS {
        LayoutProblem::TooManyChannels {
            channels,
            max: MAX_CHANNELS,
        }
    } else {
        return Ok(());
    };
    Err(Error::UnsupportedLayout {
        name: name.to_owned(),
        problem,
    })
}
