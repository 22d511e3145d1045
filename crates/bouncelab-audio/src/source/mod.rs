//! A recording as a stream of blocks of samples.

mod alac;
mod blank;
mod codec;
mod content;
mod edits;
mod framing;
mod input;
mod lost;
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
use self::codec::{Layout, MAX_CHANNELS};
use self::content::Content;
use self::input::Input;
use self::lost::Lost;
use self::presentation::Presentation;
use self::track::{Next, Step, Track};
use crate::error::{Error, Result};
use crate::formats::SoundFormat;
use crate::lost_chunk;
use crate::problem::{LayoutProblem, MissingContent, Stage};
use crate::warning::Warning;

/// The lowest sample rate that is read, in hertz. Below it there is nothing left of a click, and
/// its onset is no better known than a quarter of a millisecond.
pub const MIN_SAMPLE_RATE_HZ: u32 = 4_000;

/// The highest sample rate that is read, in hertz: above that of any recorder, and below what a
/// damaged header may claim.
pub const MAX_SAMPLE_RATE_HZ: u32 = 10_000_000;

/// The most frames in one [`Block`].
pub const MAX_BLOCK_FRAMES: usize = 4_096;

/// No recording is read for longer: a small file may claim any length.
const MOST_S: u64 = 24 * 3600;
/// Nor are more samples of all channels read: as many as two channels at 192 kHz have in that time.
const MOST_SAMPLES: u64 = MOST_S * 2 * 192_000;

/// A recording being read, block by block, in memory that does not grow with its length.
///
/// The first frame is time zero and the frame `i` is at `i / sample_rate_hz` seconds. What an
/// encoder put in front of the sound (21 ms in most AAC, 7 ms in Opus) is taken out wherever the
/// file says how much it is, so that times agree with those of other players:
///
/// | format | what says how much is not sound |
/// |---|---|
/// | MP4, M4A, MOV | the track's edit list, else the iTunes tag, else the pre-skip of Opus |
/// | Opus in Ogg and Matroska (`.webm`, `.mkv`) | the pre-skip in the Opus header |
/// | MP3 | the LAME or Info tag |
/// | Vorbis | the stream itself |
///
/// A file that does not say (an MP3 without tag, AAC in a bare stream or in Matroska) starts
/// late by a constant 20 to 50 ms, in other players as here. Differences between times, all that
/// the physics needs, do not suffer.
///
/// Integer samples are scaled to `-1.0..1.0`; float samples are taken as they are, except that
/// NaN and infinity become zero and are reported ([`Warning::NonFinite`]): one bad sample of an
/// exporting program must not cost the recording, nor spread into everything computed from it.
///
/// ```
/// use bouncelab_audio::Source;
///
/// # let wav = include_bytes!("../../tests/fixtures/pcm16.wav").to_vec();
/// let mut source = Source::from_bytes(wav, "clicks.wav")?;
/// let mut loudest: f32 = 0.0;
/// while let Some(block) = source.next_block()? {
///     loudest = block.channel(0).iter().fold(loudest, |peak, sample| peak.max(sample.abs()));
/// }
/// assert!(loudest > 0.4);
/// assert!(source.warnings().is_empty());
/// # Ok::<(), bouncelab_audio::Error>(())
/// ```
pub struct Source {
    name: String,
    description: Option<&'static str>,
    track: Track,
    layout: Layout,
    presentation: Presentation,
    /// Decoded frames, all channels; the first is frame `planes_start` of the decoded stream.
    planes: Vec<Vec<f32>>,
    planes_start: u64,
    /// The frames in `planes` that were not yet looked at.
    pending: Range<u64>,
    /// What comes before: frames that were lost, for which silence is handed out.
    hole: Range<u64>,
    silence: Vec<Vec<f32>>,
    gaps: Vec<Gap>,
    blanks: Blanks,
    /// How many frames were handed out.
    presented: u64,
    ended: bool,
    warnings: Vec<Warning>,
}

/// A stretch of consecutive samples of all channels.
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
    /// If there is no such channel: see [`Source::channels`].
    pub fn channel(&self, channel: usize) -> &[f32] {
        &self.planes[channel][self.within.clone()]
    }

    /// How many channels there are: always [`Source::channels`].
    pub fn channels(&self) -> usize {
        self.planes.len()
    }

    /// How many samples each channel has: 1 to [`MAX_BLOCK_FRAMES`].
    pub fn frames(&self) -> usize {
        self.within.len()
    }

    /// The place of the first sample in the recording, in frames.
    pub fn start_frame(&self) -> u64 {
        self.start_frame
    }
}

impl fmt::Debug for Source {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Source")
            .field("name", &self.name)
            .field("format", &self.format())
            .field("layout", &self.layout)
            .field("presented", &self.presented)
            .field("warnings", &self.warnings)
            .finish_non_exhaustive()
    }
}

impl Source {
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
        // Opening a folder succeeds on some systems and fails with the strangest errors on others; opening a pipe
        // waits for somebody who writes.
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
    /// As for [`Source::open`].
    pub fn from_bytes(bytes: impl Into<Arc<[u8]>>, name: &str) -> Result<Self> {
        Self::from_reader(Cursor::new(bytes.into()), name)
    }

    /// Reads a recording from anything that can be read and searched; the name is for messages
    /// only.
    ///
    /// # Errors
    ///
    /// As for [`Source::open`].
    pub fn from_reader<R>(reader: R, name: &str) -> Result<Self>
    where
        R: Read + Seek + Send + Sync + 'static,
    {
        let fail = |reason| Error::io(name, reason);
        let mut reader = Input::new(reader).map_err(fail)?;
        let container = match content::identify(&mut reader).map_err(fail)? {
            Content::Sound(container) => container,
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
        let mut header = wave::Header::default();
        if container == SoundFormat::Wav {
            let start = reader.stream_position().map_err(fail)?;
            header = wave::header(&mut reader).map_err(fail)?;
            match header.mended.take() {
                Some(wave) => reader.read_behind(wave.header, wave.sound),
                None => reader.seek(SeekFrom::Start(start)).map(drop),
            }
            .map_err(fail)?;
        }
        let surveyed = framing::survey(container, &mut reader).map_err(fail)?;
        let mut framing = surveyed.ok_or_else(|| Error::Malformed {
            name: name.to_owned(),
            format: container.name(),
            stage: Stage::Sound,
            detail: "it is damaged in too many places".to_owned(),
        })?;
        framing.is_cut |= header.is_unfinished;
        if let Some(sound) = framing.sound.take() {
            reader.read_only(sound).map_err(fail)?;
        }
        let track = Track::open(container, Box::new(reader), framing, name)?;
        let mut source = Self::start(track, name)?;
        for gap in lost_chunk::decode(&header.lost, source.sample_rate_hz()) {
            source.note_gap(gap);
        }
        if let Some(implied_hz) = header.other_rate_hz {
            source.warnings.push(Warning::RateInDoubt {
                stated_hz: source.sample_rate_hz(),
                implied_hz,
            });
        }
        Ok(source)
    }

    /// Decodes up to the first sound. A source that exists can be read, and its layout is that of
    /// the sound, not of a header that may differ.
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

    /// Samples in a second of each channel.
    pub fn sample_rate_hz(&self) -> u32 {
        self.layout.sample_rate_hz
    }

    /// How many channels there are: 1 to 64.
    pub fn channels(&self) -> usize {
        self.layout.channels
    }

    /// What the recording is, for people: for example "AAC in MOV" or "16-bit WAV".
    pub fn format(&self) -> String {
        let format = self.description.map(str::to_owned);
        format.unwrap_or_else(|| self.track.format())
    }

    /// What it was before it was made a recording.
    pub(crate) fn described_as(mut self, description: &'static str) -> Self {
        self.description = Some(description);
        self
    }

    /// The file, as the caller named it.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// How long the sound is according to the file, in seconds; `None` if it does not say, as
    /// recordings from a browser do not. For progress, not for physics: the header may be wrong,
    /// and without a header it is an estimate.
    pub fn duration_s(&self) -> Option<f64> {
        let announced = self.track.announced(self.layout, &self.presentation)?;
        Some(self.seconds(announced.frames))
    }

    /// What was wrong with the recording, as far as it was read.
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    /// Where sound was lost, as far as it was read: silence stands in its place. What a
    /// [`Recorder`](crate::Recorder) noted of its own file is known at once.
    pub fn gaps(&self) -> &[Gap] {
        &self.gaps
    }

    /// The next samples, or `None` at the end.
    ///
    /// # Errors
    ///
    /// [`Error::Io`] if the system fails to read, [`Error::TooLong`] after 24 hours, or less of many
    /// channels at a high rate. Damage in the file is no
    /// error here: what can be decoded is, and the rest is in [`Source::warnings`].
    pub fn next_block(&mut self) -> Result<Option<Block<'_>>> {
        let most = self.most_frames();
        if self.presented.max(self.pending.end) > most {
            return Err(Error::TooLong {
                name: self.name.clone(),
                most_h: (self.seconds(most) / 36.0).floor() / 100.0,
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
                let place = |frame| (frame - self.planes_start) as usize;
                let within = place(part.start)..place(end);
                return Ok(Some(self.block(within, false)));
            }
            if self.ended {
                return Ok(None);
            }
            self.decode_more()?;
        }
    }

    /// How many frames are read at most.
    fn most_frames(&self) -> u64 {
        let in_time = MOST_S * u64::from(self.layout.sample_rate_hz);
        in_time.min(MOST_SAMPLES / self.layout.channels as u64)
    }

    /// The next block: these frames of the planes, or as many of silence.
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

    /// Puts the next packet into `planes`, or finds the end.
    fn decode_more(&mut self) -> Result<()> {
        let at = self.pending.end;
        if at >= self.presentation.end() {
            self.stop(at);
            return Ok(());
        }
        let Step { lost, next } = self.track.step(&self.name, &mut self.planes)?;
        let at = self.lose(at, lost);
        match next {
            _ if lost.is_some() && self.gaps.len() > MOST_GAPS => self.end(at, true),
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

    /// Notes that sound was lost from this decoded frame on; where it sets in again.
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
        }
    }

    fn stop(&mut self, at: u64) {
        self.ended = true;
        self.pending = at..at;
        if self.track.is_altered() {
            self.note_altered(at);
        }
    }

    /// Notes that the sound up to this decoded frame is not what was encoded, wherever that is.
    fn note_altered(&mut self, at: u64) {
        let read_s = self.presented_s(at);
        self.warnings.push(Warning::Altered { read_s });
    }

    /// Stops, and warns if that is too early: because the file is broken there, or is shorter than
    /// it says.
    fn end(&mut self, at: u64, broken: bool) {
        self.stop(at);
        // A recorder that says where it lost sound has put zeros there.
        let noted = self.gaps.len() as u64;
        let blanks = self.blanks.odd().filter(|(places, ..)| *places > noted);
        if let Some((places, first, frames)) = blanks {
            self.warnings.push(Warning::Blank {
                places,
                first_s: self.presented_s(first),
                blank_s: self.seconds(frames),
            });
        }
        let read_s = self.presented_s(at);
        let announced = self.track.announced(self.layout, &self.presentation);
        let counted = announced.and_then(|it| Some((self.seconds(it.frames), it.tolerance_s?)));
        let is_short = |(expected_s, tolerance_s)| expected_s - read_s > tolerance_s;
        if broken || counted.is_some_and(is_short) {
            let expected_s = counted.filter(|it| is_short(*it)).map(|it| it.0);
            self.warnings
                .push(Warning::Truncated { read_s, expected_s });
        }
    }

    /// Replaces what is not a number.
    fn scrub(&mut self) {
        // A damaged number may be anything; no other sound is ten million times full scale.
        let is_odd = |sample: &f32| sample.is_nan() || sample.abs() >= 1e7;
        // Nearly always there is none, which is soon seen of many at once.
        let any_odd = |plane: &Vec<f32>| plane.iter().fold(false, |any, it| any | is_odd(it));
        if !self.planes.iter().any(any_odd) {
            return;
        }
        let mut count = 0;
        let mut first = usize::MAX;
        for plane in &mut self.planes {
            for (place, sample) in plane.iter_mut().enumerate() {
                if is_odd(sample) {
                    *sample = 0.0;
                    count += 1;
                    first = first.min(place);
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

/// More gaps than this are no recording: it is read up to there.
const MOST_GAPS: usize = 1_000;

/// Whether sound of so many samples a second and channels is of use; samples that come from no file are
/// held to the same limits.
///
/// # Errors
///
/// [`Error::UnsupportedLayout`] with this name, if it is not.
///
/// ```
/// assert!(bouncelab_audio::check_layout(44_100, 2, "microphone").is_ok());
/// assert!(bouncelab_audio::check_layout(1_000, 2, "microphone").is_err());
/// ```
pub fn check_layout(sample_rate_hz: u32, channels: usize, name: &str) -> Result<()> {
    let problem = if sample_rate_hz < MIN_SAMPLE_RATE_HZ {
        LayoutProblem::TooSlow {
            sample_rate_hz,
            least_hz: MIN_SAMPLE_RATE_HZ,
        }
    } else if sample_rate_hz > MAX_SAMPLE_RATE_HZ {
        LayoutProblem::TooFast {
            sample_rate_hz,
            most_hz: MAX_SAMPLE_RATE_HZ,
        }
    } else if channels > MAX_CHANNELS {
        LayoutProblem::TooManyChannels {
            channels,
            most: MAX_CHANNELS,
        }
    } else {
        return Ok(());
    };
    Err(Error::UnsupportedLayout {
        name: name.to_owned(),
        problem,
    })
}
