//! The detector: samples in, drops out.
//!
//! It takes a recording of any length in blocks of any size, channel by channel, and remembers no
//! more of it than the longest drop lasts, and never more than 128 MB of samples. All channels are
//! analysed; the one whose drops have the most evidence against chance is believed, and the result says
//! which that is.
//!
//! ```
//! use bouncelab::impact::ImpactEvent;
//! use bouncelab::detection::Detector;
//! use bouncelab::synth::{self, Scene};
//!
//! let mut time_s = 0.0;
//! let strikes: Vec<ImpactEvent> = (0..20)
//!     .map(|n| {
//!         let speed_m_s = 2.4 * 0.9_f64.powi(n);
//!         let strike = ImpactEvent { time_s, speed_m_s };
//!         time_s += 2.0 * 0.9 * speed_m_s / 9.81;
//!         strike
//!     })
//!     .collect();
//! let recording = synth::render(&strikes, &Scene::default(), 7)?;
//!
//! let mut detector = Detector::new(recording.sample_rate_hz, 1);
//! for block in recording.samples.chunks(1024) {
//!     detector.push(&[block]);
//! }
//! let detection = detector.finish();
//! assert_eq!(detection.found.trains.len(), 1);
//! assert_eq!(detection.found.trains[0].impacts().len(), 20);
//! # Ok::<(), bouncelab::Error>(())
//! ```

mod watch;

use crate::diagnostic::{Code, Diagnostic};
use crate::error::{Error, Result};
use crate::onset::{self, Onset, OnsetDetector};
use crate::simd::dispatch;
use crate::stats::median;
use crate::train::{self, Excerpt, Span, Train, TrainSearch};
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

pub use watch::DropWatch;

/// So many seconds are remembered at most; when they are full, the past is judged.
const REMEMBERED_S: f64 = 180.0;
/// No drop lasts longer than this share of them: what is older is forgotten then.
const DROP_SHARE: f64 = 2.0 / 3.0;
/// So many samples of all channels together are remembered at most (128 MB): nearly three minutes of two
/// channels at 96 kHz, and less of more channels.
const MOST_SAMPLES: f64 = 32e6;
/// If less than this many seconds could be remembered, channels are refused: a drop may last two thirds of it,
/// and balls of sports hardly last 20 s.
const LEAST_REMEMBERED_S: f64 = 40.0;
/// So many sounds are remembered at most, and the past is judged when there are as many: ten times
/// the impacts of the longest drop (e = 0.99, from a metre to a tenth of a millimetre).
const MOST_ONSETS: usize = 4000;
/// Sounds farther apart than this, in seconds, have nothing to do with each other: no flight is
/// as long, and no sound is compared with others as far away.
const GAP_S: f64 = 3.2;
/// No onset comes later than this after its time, in seconds.
const DELAY_S: f64 = 0.3;
/// Seconds before and after a train in which more of its impacts may be found.
const AROUND_S: f64 = 2.5;
/// A train continues if its last impact was detected less than this many seconds ago.
const OPEN_S: f64 = 10.0;

/// Where in a recording to look for impacts.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct DetectionOptions {
    /// The only channel to use, the first being 1; if `None`, the one with the most evidence.
    pub channel: Option<usize>,
    /// The only frequencies to use, in Hz; if `None`, all bands, each against its own background.
    pub band_hz: Option<Range<f64>>,
}

/// Detects the drops in a stream of samples, of one or more channels.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Detector {
    /// Channels that were equal to the first so far are `None`: they share its detector.
    channels: Vec<Option<ChannelDetector>>,
    /// The only channel that is used, counted from 0, of so many.
    only: Option<usize>,
    of_channels: usize,
}

/// The detections in a recording.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Detection {
    /// Samples a second.
    pub sample_rate_hz: u32,
    /// How many channels there are.
    pub channels: usize,
    /// The channel with the most evidence, counted from 0.
    pub channel: usize,
    /// How many channels there were that differ from each other.
    pub distinct_channels: usize,
    /// The drops in it.
    pub found: TrainSearch,
    /// How many sounds stand out of its background.
    pub onsets: usize,
    /// Its loudness over time, for a picture.
    pub envelope: Envelope,
    /// Length of the recording in seconds.
    pub duration_s: f64,
    /// How many of its samples lie at full scale or at its own limit, in runs: clipping.
    pub clipped_samples: u64,
}

impl Detection {
    /// Why there is no drop; `None` if there is one.
    ///
    /// ```
    /// use bouncelab::Detector;
    ///
    /// let mut detector = Detector::new(48_000, 1);
    /// detector.push(&[&[0.0; 48_000]]);
    /// let reason = detector.finish().no_drop().unwrap();
    /// assert_eq!(reason.code.name(), "recording-silent");
    /// ```
    pub fn no_drop(&self) -> Option<Diagnostic> {
        if !self.found.trains.is_empty() {
            return None;
        }
        Some(if self.envelope.is_constant() {
            Diagnostic::new(Code::RecordingSilent)
        } else {
            self.found.no_drop(self.onsets)
        })
    }

    /// The band in which the impacts of all drops stand out most, by its number in
    /// [`onset::bands_hz`], and by how many dB they do so in the middle; `None` without a drop.
    pub fn strongest_band(&self) -> Option<(usize, f64)> {
        let impacts = || self.found.trains.iter().flat_map(Train::impacts);
        (0..onset::BANDS)
            .filter_map(|band| {
                let above_db =
                    impacts().map(|i| i.onset.band_levels_db[band] - i.onset.band_noise_db[band]);
                Some((band, median(above_db.map(f64::from))?))
            })
            .max_by(|a, b| a.1.total_cmp(&b.1))
    }

    /// What is odd about the recording as a whole.
    pub fn diagnostics(&self) -> Vec<Diagnostic> {
        let distant = self.found.distant.iter().map(|train| {
            Diagnostic::new(Code::DistantBall)
                .with("start_s", train.start_s())
                .with("end_s", train.end_s())
                .with("impacts", train.impacts().len())
        });
        let mut diagnostics: Vec<Diagnostic> = distant.collect();
        diagnostics.extend(self.found.overlaps().map(|(start_s, end_s)| {
            let at_once = Diagnostic::new(Code::DropsAtOnce);
            at_once.with("start_s", start_s).with("end_s", end_s)
        }));
        if self.clipped_samples > 0 && !self.found.trains.is_empty() {
            let clipped = Diagnostic::new(Code::Clipped);
            diagnostics.push(clipped.with("samples", self.clipped_samples));
        }
        diagnostics
    }
}

impl Detector {
    /// A detector for this many channels (at least one) at this rate.
    pub fn new(sample_rate_hz: u32, channels: usize) -> Self {
        Self::with(OnsetDetector::new(sample_rate_hz), sample_rate_hz, channels)
    }

    /// A detector that looks where the options say: in one channel, or in the bands
    /// ([`onset::bands_hz`]) of which at least half lies in a range of frequencies.
    ///
    /// # Errors
    ///
    /// [`Error::NoChannel`] and [`Error::NoBand`] if there is none; [`Error::TooManyChannels`] if there
    /// are so many that too little of each could be remembered, and none of them is chosen.
    ///
    /// ```
    /// use bouncelab::Detector;
    /// use bouncelab::detection::DetectionOptions;
    ///
    /// let second = DetectionOptions { channel: Some(2), ..DetectionOptions::default() };
    /// assert!(Detector::with_options(48_000, 2, &second).is_ok());
    /// assert!(Detector::with_options(48_000, 1, &second).is_err());
    /// ```
    pub fn with_options(
        sample_rate_hz: u32,
        channels: usize,
        options: &DetectionOptions,
    ) -> Result<Self> {
        let only = check_channel(options.channel, channels)?;
        let onsets = match &options.band_hz {
            None => OnsetDetector::new(sample_rate_hz),
            Some(band_hz) => OnsetDetector::within(sample_rate_hz, band_hz)?,
        };
        let used = if only.is_some() { 1 } else { channels };
        let most = (MOST_SAMPLES / (onsets.rate_hz() * LEAST_REMEMBERED_S)) as usize;
        if used > most {
            return Err(Error::TooManyChannels { channels, most });
        }
        Ok(Self {
            only,
            of_channels: channels,
            ..Self::with(onsets, sample_rate_hz, used)
        })
    }

    fn with(onsets: OnsetDetector, sample_rate_hz: u32, channels: usize) -> Self {
        let remembered_s = MOST_SAMPLES / (onsets.rate_hz() * channels.max(1) as f64);
        let first = ChannelDetector::new(onsets, sample_rate_hz, remembered_s);
        let mut detectors = vec![Some(first)];
        detectors.resize_with(channels.max(1), || None);
        Self {
            channels: detectors,
            only: None,
            of_channels: channels.max(1),
        }
    }

    /// The same detector, new, for samples that stay at hand elsewhere, as in an array: it remembers hardly
    /// any of them (but for rates above 96 kHz, which it lowers), and reads older ones again when it needs
    /// them. `read` gives the samples of a channel, counted from 0, whose numbers lie in a range; all of them
    /// were pushed before. The result is the same.
    ///
    /// ```
    /// use bouncelab::{Detector, demo};
    ///
    /// let sound = demo::sound(&demo::history()?, 1)?;
    /// let kept = sound.samples.clone();
    /// let mut detector = Detector::new(sound.sample_rate_hz, 1)
    ///     .rereading(move |_, range| kept[range.start as usize..range.end as usize].to_vec());
    /// detector.push(&[&sound.samples]);
    /// assert_eq!(detector.finish().found.trains.len(), 1);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    #[must_use]
    pub fn rereading(
        mut self,
        read: impl Fn(usize, Range<u64>) -> Vec<f32> + Send + Sync + 'static,
    ) -> Self {
        let read: Arc<ReadKept> = Arc::new(read);
        let channels = self.channels.iter_mut().flatten();
        for channel in channels.filter(|channel| channel.detector.is_plain()) {
            channel.detector.set_remembering(false);
            channel.kept = Some(Kept {
                channel: self.only.unwrap_or(0),
                read: Arc::clone(&read),
            });
        }
        self
    }

    /// Takes the next samples of every channel.
    ///
    /// # Panics
    ///
    /// If there are not as many slices as channels, or they differ in length.
    pub fn push(&mut self, channels: &[&[f32]]) {
        assert_eq!(
            channels.len(),
            self.of_channels,
            "one slice for each channel"
        );
        assert!(
            channels.iter().all(|c| c.len() == channels[0].len()),
            "channels of equal length"
        );
        let channels = match self.only {
            Some(only) => &channels[only..=only],
            None => channels,
        };
        for (index, samples) in channels.iter().enumerate().skip(1) {
            if self.channels[index].is_none() && *samples != channels[0] {
                let mut channel = self.channels[0].clone();
                if let Some(kept) = channel.as_mut().and_then(|it| it.kept.as_mut()) {
                    kept.channel = index;
                }
                self.channels[index] = channel;
            }
        }
        for (channel, samples) in self.channels.iter_mut().zip(channels) {
            if let Some(channel) = channel {
                channel.push(samples);
            }
        }
    }

    /// How many sounds have stood out from the background so far, in all channels that differ.
    pub fn onsets(&self) -> usize {
        let channels = self.channels.iter().flatten();
        channels
            .map(|channel| channel.onsets_judged + standing_out(&channel.onsets))
            .sum()
    }

    /// How much the judgement of the sounds that are not yet judged does.
    fn work(&self) -> u64 {
        let channels = self.channels.iter().flatten();
        channels.map(|channel| train::work(&channel.onsets)).sum()
    }

    /// The detections so far, as if the recording ended here. It takes as long as the judgement of
    /// the sounds that are not yet judged: some milliseconds.
    ///
    /// ```
    /// use bouncelab::{Detector, demo};
    ///
    /// let sound = demo::sound(&demo::history()?, 1)?;
    /// let mut detector = Detector::new(sound.sample_rate_hz, 1);
    /// let (first, second) = sound.samples.split_at(3 * sound.sample_rate_hz as usize);
    /// detector.push(&[first]);
    /// let early = detector.so_far().found.trains[0].impacts().len();
    /// detector.push(&[second]);
    /// assert!(detector.finish().found.trains[0].impacts().len() > early);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn so_far(&self) -> Detection {
        self.clone().finish()
    }

    /// Ends the recording and believes the channel with the most evidence against chance.
    pub fn finish(self) -> Detection {
        let distinct_channels = self.channels.iter().flatten().count();
        let heard = self
            .channels
            .into_iter()
            .enumerate()
            .filter_map(|(number, channel)| Some((number, channel?)))
            .map(|(number, channel)| channel.finish(number, distinct_channels))
            .map(|detection| Detection {
                channels: self.of_channels,
                channel: self.only.unwrap_or(detection.channel),
                ..detection
            });
        // Of equals, the first.
        heard
            .reduce(|best, other| {
                if other.found.log_bayes_factor() > best.found.log_bayes_factor() {
                    other
                } else {
                    best
                }
            })
            .unwrap_or_else(|| unreachable!("the first channel always has an channel"))
    }
}

/// Detects the onsets of one channel.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
struct ChannelDetector {
    sample_rate_hz: u32,
    /// How many samples there have been.
    samples: u64,
    /// How many seconds may be remembered.
    remembered_s: f64,
    /// Remembers the samples from the first onset not yet judged on.
    detector: OnsetDetector,
    /// Onsets not yet judged.
    onsets: Vec<Onset>,
    onsets_judged: usize,
    /// The time up to which all is judged, in seconds, as far as it matters to what comes.
    judged_s: f64,
    found: TrainSearch,
    envelope: Envelope,
    clipping: Clipping,
    /// Where samples are that are not remembered, if they are kept.
    #[cfg_attr(feature = "serde", serde(skip))]
    kept: Option<Kept>,
}

/// The samples of a channel, which are kept elsewhere.
#[derive(Clone)]
struct Kept {
    /// The channel, counted from 0, and the function that reads it.
    channel: usize,
    read: Arc<ReadKept>,
}

type ReadKept = dyn Fn(usize, Range<u64>) -> Vec<f32> + Send + Sync;

impl fmt::Debug for Kept {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Kept")
            .field("channel", &self.channel)
            .finish_non_exhaustive()
    }
}

impl ChannelDetector {
    fn new(mut detector: OnsetDetector, sample_rate_hz: u32, most_s: f64) -> Self {
        detector.set_remembering(true);
        Self {
            sample_rate_hz,
            samples: 0,
            remembered_s: most_s.min(REMEMBERED_S),
            detector,
            onsets: Vec::new(),
            onsets_judged: 0,
            judged_s: 0.0,
            found: TrainSearch::default(),
            envelope: Envelope::new(sample_rate_hz),
            clipping: Clipping::default(),
            kept: None,
        }
    }

    fn now_s(&self) -> f64 {
        self.detector.history().end() as f64 / self.detector.rate_hz()
    }

    fn push(&mut self, samples: &[f32]) {
        let samples = &*dispatch(
            #[inline(always)]
            || {
                let samples = onset::finite(samples);
                let extremes = self.envelope.push(&samples);
                self.clipping.push(&samples, extremes.size());
                samples
            },
        );
        self.samples += samples.len() as u64;
        let heard = self.onsets.len();
        self.detector.push_finite(samples, &mut self.onsets);
        self.judge_onsets_from(heard);
        // What comes from here on is too far from the last onset to change its judgement.
        if let Some(last) = self.onsets.last()
            && self.now_s() > last.time_s + GAP_S + DELAY_S
        {
            let end_s = self.now_s();
            self.judge_all(end_s);
        }
        let first_s = self.onsets.first().map_or(self.now_s(), |o| o.time_s);
        let needed = (first_s - DELAY_S - AROUND_S) * self.detector.rate_hz();
        self.detector.history_mut().forget_before(needed as u64);
    }

    /// Judges the past as if the onsets from this one on came one by one, so that the blocks in
    /// which they come make no difference.
    fn judge_onsets_from(&mut self, first: usize) {
        let new = self.onsets.split_off(first);
        for onset in new {
            let far_s =
                |onset: Option<&Onset>, now: &Onset| onset.map_or(0.0, |o| now.time_s - o.time_s);
            if far_s(self.onsets.last(), &onset) > GAP_S {
                self.judge_all(onset.time_s);
            } else if far_s(self.onsets.first(), &onset) > self.remembered_s
                || self.onsets.len() >= MOST_ONSETS
            {
                self.judge_the_past(onset.time_s);
            }
            self.onsets.push(onset);
        }
    }

    /// Judges all onsets; what comes next comes at this time.
    fn judge_all(&mut self, end_s: f64) {
        let found = self.search(end_s);
        self.take(found);
        self.onsets_judged += standing_out(&self.onsets);
        self.onsets.clear();
    }

    /// What is found among the onsets that are not yet judged, if all is known up to this time.
    fn search(&self, end_s: f64) -> TrainSearch {
        let span = Span {
            start_s: self.judged_s,
            end_s,
        };
        let mut found = TrainSearch::default();
        train::search(
            &self.onsets,
            span,
            &|range_s| self.read(range_s),
            &mut found,
        );
        found
    }

    /// The samples of these seconds that are remembered.
    fn read(&self, range_s: Range<f64>) -> Excerpt {
        let rate_hz = self.detector.rate_hz();
        let number = |time_s: f64| (time_s * rate_hz).max(0.0) as u64;
        let range = number(range_s.start)..number(range_s.end);
        let mut samples = Vec::new();
        let mut first = self.detector.history().read(range.clone(), &mut samples);
        if let Some(Kept { channel, read }) = &self.kept
            && range.start < first.min(range.end)
        {
            let older = read(*channel, range.start..first.min(range.end));
            samples.splice(..0, onset::finite(&older).iter().copied());
            first = first.min(range.end) - older.len() as u64;
        }
        Excerpt {
            samples,
            start_s: first as f64 / rate_hz,
            rate_hz,
        }
    }

    /// Judges the onsets that no sound later than `now_s` can change, and forgets them; as many at
    /// least as keep the memory bounded.
    fn judge_the_past(&mut self, now_s: f64) {
        let mut found = self.search(now_s);
        let open_from_s = open_from_s(&found.trains, now_s);
        found.trains.retain(|train| train.end_s() < open_from_s);
        // A train that has yet to show itself may have begun at any time since the last one.
        let ends_s = found.trains.iter().map(Train::end_s);
        let last_end_s = ends_s.fold(0.0, f64::max);
        let past_s = last_end_s.max(self.forgotten_before_s(now_s, 2));
        // Nothing that goes on for longer than is remembered is a drop.
        let past_s = past_s.min((open_from_s - 1e-3).max(self.forgotten_before_s(now_s, 4)));
        found.periodic.retain(|r| r.start_s <= past_s);
        // Of a drop that is taken nothing is left to be taken for another.
        let is_judged = |onset: &Onset| {
            onset.time_s <= past_s || found.trains.iter().any(|train| train.has(onset))
        };
        let judged: Vec<Onset> = self
            .onsets
            .extract_if(.., |onset| is_judged(onset))
            .collect();
        self.onsets_judged += standing_out(&judged);
        self.take(found);
        self.judged_s = past_s;
    }

    /// The time before which nothing is remembered, if this part of the most onsets is forgotten.
    fn forgotten_before_s(&self, now_s: f64, part: usize) -> f64 {
        let crowd_s = match self.onsets.len() {
            MOST_ONSETS.. => self.onsets[MOST_ONSETS / part].time_s,
            _ => f64::NEG_INFINITY,
        };
        crowd_s.max(now_s - DROP_SHARE * self.remembered_s)
    }

    /// Sharpens the times of these trains while their samples are at hand, and keeps them.
    fn take(&mut self, mut found: TrainSearch) {
        for train in &mut found.trains {
            let heard = self.read(train.start_s() - AROUND_S..train.end_s() + AROUND_S);
            train.align(&heard.samples, heard.start_s, heard.rate_hz);
        }
        self.found.trains.append(&mut found.trains);
        self.found.periodic.append(&mut found.periodic);
    }

    fn finish(mut self, channel: usize, distinct_channels: usize) -> Detection {
        let duration_s = self.samples as f64 / f64::from(self.sample_rate_hz);
        let heard = self.onsets.len();
        self.detector.flush(&mut self.onsets);
        self.judge_onsets_from(heard);
        self.judge_all(duration_s);
        self.found.set_distant_apart();
        Detection {
            sample_rate_hz: self.sample_rate_hz,
            channels: distinct_channels,
            channel,
            distinct_channels,
            found: self.found,
            onsets: self.onsets_judged,
            envelope: self.envelope,
            duration_s,
            clipped_samples: self.clipping.count(),
        }
    }
}

/// Checks that there is a channel of this number, the first being 1; returns it counted from 0.
fn check_channel(channel: Option<usize>, channels: usize) -> Result<Option<usize>> {
    match channel {
        Some(channel) if !(1..=channels).contains(&channel) => {
            Err(Error::NoChannel { channel, channels })
        }
        channel => Ok(channel.map(|channel| channel - 1)),
    }
}

/// When the first train that may go on begins, or one that shares its time with such a train; infinity if
/// all are over.
fn open_from_s(trains: &[Train], now_s: f64) -> f64 {
    let open = trains.iter().filter(|train| train.end_s() > now_s - OPEN_S);
    let mut from_s = open.map(Train::start_s).fold(f64::INFINITY, f64::min);
    // In order of their beginnings, so that one look at each does.
    for train in trains.iter().rev() {
        if train.end_s() >= from_s {
            from_s = from_s.min(train.start_s());
        }
    }
    from_s
}

/// How many of these are sounds that stand out from the background.
fn standing_out(onsets: &[Onset]) -> usize {
    onsets.iter().filter(|onset| onset.stands_out()).count()
}

/// Least and greatest sample in equal steps of time: a picture of a recording of any length, in
/// constant memory.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Envelope {
    sample_rate_hz: f64,
    samples_per_step: usize,
    least: Vec<f32>,
    greatest: Vec<f32>,
    /// Samples in the last step.
    in_step: usize,
}

impl Envelope {
    /// The most steps that are kept; beyond, two become one.
    const MOST_STEPS: usize = 1 << 15;
    /// No step has fewer samples.
    const FEWEST_SAMPLES: usize = 16;

    fn new(sample_rate_hz: u32) -> Self {
        Self {
            sample_rate_hz: f64::from(sample_rate_hz),
            samples_per_step: Self::FEWEST_SAMPLES,
            least: Vec::new(),
            greatest: Vec::new(),
            in_step: Self::FEWEST_SAMPLES,
        }
    }

    /// An envelope that was kept elsewhere: least and greatest sample of each step, as many of
    /// each; what is over is dropped.
    pub fn of_steps(step_s: f64, mut least: Vec<f32>, mut greatest: Vec<f32>) -> Self {
        let steps = least.len().min(greatest.len());
        least.truncate(steps);
        greatest.truncate(steps);
        Self {
            sample_rate_hz: 1.0 / step_s,
            samples_per_step: 1,
            least,
            greatest,
            in_step: 1,
        }
    }

    /// Seconds for each step.
    pub fn step_s(&self) -> f64 {
        self.samples_per_step as f64 / self.sample_rate_hz
    }

    /// The least sample of each step.
    pub fn least(&self) -> &[f32] {
        &self.least
    }

    /// The greatest sample of each step.
    pub fn greatest(&self) -> &[f32] {
        &self.greatest
    }

    /// Whether all samples have the same value: silence, or a dead microphone.
    pub fn is_constant(&self) -> bool {
        let least = self.least.iter().copied().fold(f32::INFINITY, f32::min);
        let greatest = self
            .greatest
            .iter()
            .copied()
            .fold(f32::NEG_INFINITY, f32::max);
        greatest <= least
    }

    /// Takes the next samples; returns the extremes of them.
    #[inline(always)]
    fn push(&mut self, samples: &[f32]) -> Extremes {
        let begun = self.samples_per_step - self.in_step;
        let (now, mut rest) = samples.split_at(begun.min(samples.len()));
        let mut all = Extremes::of(now);
        if let (Some(least), Some(greatest)) = (self.least.last_mut(), self.greatest.last_mut()) {
            *least = lesser(all.least, *least);
            *greatest = greater(all.greatest, *greatest);
        }
        self.in_step += now.len();
        while !rest.is_empty() {
            if self.least.len() == Self::MOST_STEPS {
                self.halve();
            }
            let (step, later) = rest.split_at(self.samples_per_step.min(rest.len()));
            let extremes = Extremes::of(step);
            all = all.with(extremes);
            self.least.push(extremes.least);
            self.greatest.push(extremes.greatest);
            self.in_step = step.len();
            rest = later;
        }
        all
    }

    fn halve(&mut self) {
        keep_of_pairs(&mut self.least, lesser);
        keep_of_pairs(&mut self.greatest, greater);
        self.samples_per_step *= 2;
    }
}

/// The least and the greatest of some samples.
#[derive(Clone, Copy)]
struct Extremes {
    least: f32,
    greatest: f32,
}

impl Extremes {
    /// Of these samples.
    #[inline(always)]
    fn of(samples: &[f32]) -> Self {
        Self {
            least: extreme(samples, lesser),
            greatest: extreme(samples, greater),
        }
    }

    fn with(self, other: Self) -> Self {
        Self {
            least: lesser(other.least, self.least),
            greatest: greater(other.greatest, self.greatest),
        }
    }

    /// The greatest distance from 0.
    fn size(self) -> f32 {
        self.greatest.max(-self.least)
    }
}

/// The most extreme of these samples, many at a time; infinite if there are none.
#[inline(always)]
fn extreme(samples: &[f32], pick: impl Fn(f32, f32) -> f32) -> f32 {
    const LANES: usize = 8;
    let nothing = -pick(f32::INFINITY, f32::NEG_INFINITY);
    let (chunks, rest) = samples.as_chunks::<LANES>();
    let mut lanes = [nothing; LANES];
    for chunk in chunks {
        lanes = std::array::from_fn(|lane| pick(chunk[lane], lanes[lane]));
    }
    let quad: [f32; 4] = std::array::from_fn(|lane| pick(lanes[lane], lanes[lane + 4]));
    let best = pick(pick(quad[0], quad[1]), pick(quad[2], quad[3]));
    rest.iter().copied().fold(best, &pick)
}

/// Keeps one of each two of these values, of which there is an even number.
fn keep_of_pairs(values: &mut Vec<f32>, pick: impl Fn(f32, f32) -> f32) {
    for pair in 0..values.len() / 2 {
        values[pair] = pick(values[2 * pair], values[2 * pair + 1]);
    }
    values.truncate(values.len() / 2);
}

/// Without the care for NaN that `f32::min` takes: one instruction.
#[inline(always)]
fn lesser(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// Without the care for NaN that `f32::max` takes.
#[inline(always)]
fn greater(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}

/// Counts samples cut off at the limit of the recorder: runs of the same extreme value.
#[derive(Clone, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
struct Clipping {
    extreme: f32,
    last: f32,
    run: u64,
    count: u64,
}

impl Clipping {
    /// So many equal samples in a row at the extreme are no coincidence.
    const RUN: u64 = 3;
    /// Below this share of full scale a flat top is not the recorder's limit.
    const LOUD: f32 = 0.3;

    fn push(&mut self, samples: &[f32], loudest: f32) {
        if loudest < self.extreme.max(Self::LOUD) {
            // Most blocks are nowhere near the limit.
            self.run = 0;
            self.last = 0.0;
            return;
        }
        for &sample in samples {
            let size = sample.abs();
            if size > self.extreme {
                self.extreme = size;
                self.count = 0;
            }
            self.run = if size >= self.extreme && sample.to_bits() == self.last.to_bits() {
                self.run + 1
            } else {
                1
            };
            if size >= self.extreme && size > Self::LOUD {
                match self.run {
                    Self::RUN => self.count += Self::RUN,
                    n if n > Self::RUN => self.count += 1,
                    _ => {}
                }
            }
            self.last = sample;
        }
    }

    fn count(&self) -> u64 {
        self.count
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Clicks at this rate for so many seconds, whose levels differ by up to 6 dB, with a drop of fifteen loud impacts
    /// from this time on.
    fn clicks_and_drop(rate_hz: f64, duration_s: f64, drop_s: f64) -> Vec<Onset> {
        let clicks = (0..(rate_hz * duration_s) as u32).map(|n| Onset {
            strength: 5.0,
            // Without order from one click to the next.
            level_db: -40.0 + 3.0 * f64::from(n).powi(2).sin(),
            ..Onset::click(f64::from(n) / rate_hz)
        });
        let mut time_s = drop_s;
        let impacts = (0..15).map(|n| {
            time_s += 0.4 * 0.9_f64.powi(n);
            let level_db = -10.0 + 20.0 * f64::from(n) * 0.9_f64.log10();
            Onset {
                strength: 60.0,
                level_db,
                ..Onset::click(time_s)
            }
        });
        let mut onsets: Vec<Onset> = clicks.chain(impacts).collect();
        onsets.sort_by(|a, b| a.time_s.total_cmp(&b.time_s));
        onsets
    }

    /// Steady clicks for twenty seconds longer than this, when a drop begins whose forty flights shrink to twice their
    /// interval.
    fn clicks_and_long_drop(rate_hz: f64, drop_s: f64) -> Vec<Onset> {
        let mut onsets = clicks_and_drop(rate_hz, drop_s + 20.0, drop_s + 30.0);
        onsets.truncate(((drop_s + 20.0) * rate_hz) as usize);
        let flights_s = (0..40).map(|n| 0.6 * 0.935_f64.powi(n));
        let impacts = flights_s.scan(drop_s, |time_s, flight_s| {
            let onset = Onset {
                strength: 60.0,
                level_db: -10.0 + 20.0 * (flight_s / 0.6).log10(),
                ..Onset::click(*time_s)
            };
            *time_s += flight_s;
            Some(onset)
        });
        onsets.extend(impacts);
        onsets.sort_by(|a, b| a.time_s.total_cmp(&b.time_s));
        onsets
    }

    /// What is found among these onsets as they come one by one; never are many remembered.
    fn judged(onsets: &[Onset]) -> TrainSearch {
        let mut channel = ChannelDetector::new(OnsetDetector::new(44_100), 44_100, REMEMBERED_S);
        for onset in onsets {
            channel.onsets.push(*onset);
            channel.judge_onsets_from(channel.onsets.len() - 1);
            assert!(channel.onsets.len() <= MOST_ONSETS);
        }
        channel.judge_all(onsets[onsets.len() - 1].time_s);
        channel.found
    }

    #[test]
    fn steady_clicks_are_no_drop_however_long_they_go_on() {
        for rate_hz in [20.0, 40.0, 70.0, 100.0] {
            let found =
                judged(&clicks_and_drop(rate_hz, 400.0, 500.0)[..(400.0 * rate_hz) as usize]);
            assert_eq!(found.trains, [], "{rate_hz}");
        }
    }

    /// The past is judged whenever four thousand sounds are remembered.
    #[test]
    fn a_drop_is_found_wherever_the_past_is_cut() {
        for rate_hz in [20.0, 40.0, 70.0, 100.0] {
            let cut_s = MOST_ONSETS as f64 / rate_hz;
            for drop_s in [-5.0, -2.0, -1.0, 0.5].map(|it| cut_s + it) {
                let found = judged(&clicks_and_drop(rate_hz, cut_s + 10.0, drop_s));
                let starts_s: Vec<f64> = found.trains.iter().map(Train::start_s).collect();
                assert_eq!(starts_s, [drop_s + 0.4], "{rate_hz}");
                let impacts = found.trains[0].impacts().len();
                // Of the densest clicks one may pass for another impact.
                let most = if rate_hz < 100.0 { 15 } else { 16 };
                assert!(
                    (15..=most).contains(&impacts),
                    "{rate_hz}: {drop_s}: {impacts}"
                );
            }
        }
    }

    /// They once went on as three hundred impacts, or took the drop with them, or it was found twice.
    #[test]
    fn steady_clicks_after_a_drop_are_no_part_of_it() {
        for (rate_hz, drop_s) in [45.0, 60.0]
            .into_iter()
            .flat_map(|rate_hz| [5.0, 40.0, 60.0, 78.0, 90.0].map(|drop_s| (rate_hz, drop_s)))
        {
            let found = judged(&clicks_and_long_drop(rate_hz, drop_s));
            let starts_s: Vec<f64> = found.trains.iter().map(Train::start_s).collect();
            assert_eq!(starts_s, [drop_s], "{rate_hz}");
            // As long as the drop may be the beginning of what keeps time, a few clicks are taken for impacts.
            let impacts = found.trains[0].impacts().len();
            assert!(
                (38..=60).contains(&impacts),
                "{rate_hz}: {drop_s}: {impacts}"
            );
        }
    }
}
