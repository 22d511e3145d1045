//! The detector of a stream: samples in blocks of any size, in bounded memory.

use super::clipping::Clipping;
use super::envelope::Envelope;
use super::parameters::{
    CROWD_DIVISOR, MAX_DROP_SHARE, MAX_ONSET_DELAY_S, MAX_ONSETS, MAX_REMEMBERED_S, MAX_SAMPLES,
    MIN_GAP_S, MIN_REMEMBERED_S, OPEN_CROWD_DIVISOR, OPEN_MARGIN_S, OPEN_S,
};
use super::{Detection, DetectionOptions};
use crate::error::{Error, Result};
use crate::onset::{self, Onset, OnsetDetector};
use crate::simd::dispatch;
use crate::train::{self, ALIGNED_REACH_S, Excerpt, Span, Train, TrainSearch};
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// Detects the drops in a stream of samples, of one or more channels.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Detector {
    /// Channels that were equal to the first so far are `None`: they share its detector.
    channels: Vec<Option<ChannelDetector>>,
    /// The only channel that is used, counted from 0; `None` for all.
    only: Option<usize>,
    /// Number of channels of the stream.
    of_channels: usize,
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
    /// [`Error::NoChannel`] and [`Error::NoBand`] if there is no such channel or band; [`Error::TooManyChannels`] if all
    /// channels are used and there are too many to remember enough of each.
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
        let most = (MAX_SAMPLES / (onsets.rate_hz() * MIN_REMEMBERED_S)) as usize;
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
        let remembered_s = MAX_SAMPLES / (onsets.rate_hz() * channels.max(1) as f64);
        let first = ChannelDetector::new(onsets, sample_rate_hz, remembered_s);
        let mut detectors = vec![Some(first)];
        detectors.resize_with(channels.max(1), || None);
        Self {
            channels: detectors,
            only: None,
            of_channels: channels.max(1),
        }
    }

    /// The same new detector for samples that remain available elsewhere, such as in an array: it remembers few
    /// of them (except at rates above 96 kHz, which it lowers), and reads older ones again when it needs
    /// them. `read` returns the samples of a channel, counted from 0, whose numbers lie in a range; all of them
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
    /// If the number of slices differs from that of the channels, or if they differ in length.
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
        let used = match self.only {
            Some(only) => &channels[only..=only],
            None => channels,
        };
        for (index, samples) in used.iter().enumerate().skip(1) {
            // A channel that differs for the first time continues from the state of the first.
            if self.channels[index].is_none() && *samples != used[0] {
                let mut channel = self.channels[0].clone();
                if let Some(kept) = channel.as_mut().and_then(|it| it.kept.as_mut()) {
                    kept.channel = index;
                }
                self.channels[index] = channel;
            }
        }
        for (channel, samples) in self.channels.iter_mut().zip(used) {
            if let Some(channel) = channel {
                channel.push(samples);
            }
        }
    }

    /// Number of sounds so far that stand out of the background, in all channels that differ.
    pub fn onsets(&self) -> usize {
        let channels = self.channels.iter().flatten();
        channels
            .map(|channel| channel.onsets_evaluated + standing_out(&channel.onsets))
            .sum()
    }

    /// A measure of the computation that the evaluation of the remaining sounds takes.
    pub(super) fn work(&self) -> u64 {
        let channels = self.channels.iter().flatten();
        channels.map(|channel| train::work(&channel.onsets)).sum()
    }

    /// The detections so far, as if the recording ended here. It takes as long as the evaluation of
    /// the remaining sounds: some milliseconds.
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

    /// Ends the recording; the result is that of the channel with the most evidence over chance.
    pub fn finish(self) -> Detection {
        let distinct_channels = self.channels.iter().flatten().count();
        let detections = self
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
        // The first of equals.
        detections
            .reduce(|best, other| {
                if other.found.log_bayes_factor() > best.found.log_bayes_factor() {
                    other
                } else {
                    best
                }
            })
            .unwrap_or_else(|| unreachable!("the first channel always has a detector"))
    }
}

/// Detects the onsets of one channel.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
struct ChannelDetector {
    sample_rate_hz: u32,
    /// Number of samples so far.
    samples: u64,
    /// Maximum time that is remembered, s.
    remembered_s: f64,
    /// Remembers the samples from the first onset that is not yet evaluated.
    detector: OnsetDetector,
    /// Onsets that are not yet evaluated.
    onsets: Vec<Onset>,
    onsets_evaluated: usize,
    /// The time up to which all onsets are evaluated, in seconds.
    evaluated_s: f64,
    found: TrainSearch,
    envelope: Envelope,
    clipping: Clipping,
    /// Samples that are kept elsewhere in place of being remembered.
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
    fn new(mut detector: OnsetDetector, sample_rate_hz: u32, max_s: f64) -> Self {
        detector.set_remembering(true);
        Self {
            sample_rate_hz,
            samples: 0,
            remembered_s: max_s.min(MAX_REMEMBERED_S),
            detector,
            onsets: Vec::new(),
            onsets_evaluated: 0,
            evaluated_s: 0.0,
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
        let finite = dispatch(
            #[inline(always)]
            || {
                let finite = onset::finite(samples);
                let extremes = self.envelope.push(&finite);
                self.clipping.push(&finite, extremes.size());
                finite
            },
        );
        self.samples += finite.len() as u64;
        let before = self.onsets.len();
        self.detector.push_finite(&finite, &mut self.onsets);
        self.evaluate_onsets_from(before);
        // Later sounds are too far from the last onset to change its evaluation.
        if let Some(last) = self.onsets.last()
            && self.now_s() > last.time_s + MIN_GAP_S + MAX_ONSET_DELAY_S
        {
            let end_s = self.now_s();
            self.evaluate_all(end_s);
        }
        let first_s = self.onsets.first().map_or(self.now_s(), |o| o.time_s);
        let needed = (first_s - MAX_ONSET_DELAY_S - ALIGNED_REACH_S) * self.detector.rate_hz();
        self.detector.history_mut().forget_before(needed as u64);
    }

    /// Evaluates the past as if the onsets from this one on came one by one, so that the result does not depend on the
    /// blocks in which they come.
    fn evaluate_onsets_from(&mut self, first: usize) {
        let new = self.onsets.split_off(first);
        for onset in new {
            let since_s =
                |earlier: Option<&Onset>| earlier.map_or(0.0, |o| onset.time_s - o.time_s);
            if since_s(self.onsets.last()) > MIN_GAP_S {
                self.evaluate_all(onset.time_s);
            } else if since_s(self.onsets.first()) > self.remembered_s
                || self.onsets.len() >= MAX_ONSETS
            {
                self.evaluate_the_past(onset.time_s);
            }
            self.onsets.push(onset);
        }
    }

    /// Evaluates all onsets; the next sound comes at `end_s`.
    fn evaluate_all(&mut self, end_s: f64) {
        let result = self.search(end_s);
        self.take(result);
        self.onsets_evaluated += standing_out(&self.onsets);
        self.onsets.clear();
    }

    /// The trains among the onsets that are not yet evaluated, which are all onsets up to this time.
    fn search(&self, end_s: f64) -> TrainSearch {
        let span = Span {
            start_s: self.evaluated_s,
            end_s,
        };
        let mut result = TrainSearch::default();
        train::search(
            &self.onsets,
            span,
            &|range_s| self.read(range_s),
            &mut result,
        );
        result
    }

    /// The samples of this time, in seconds, as far as they are remembered or kept.
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

    /// Evaluates the onsets whose evaluation no sound later than `now_s` can change, and forgets them; at
    /// least as many as keep the memory bounded.
    fn evaluate_the_past(&mut self, now_s: f64) {
        let mut result = self.search(now_s);
        let open_from_s = open_from_s(&result.trains, now_s);
        result.trains.retain(|train| train.end_s() < open_from_s);
        // A train that is not yet recognised may have begun at any time since the last one.
        let ends_s = result.trains.iter().map(Train::end_s);
        let last_end_s = ends_s.fold(0.0, f64::max);
        let closed_s = last_end_s.max(self.forgotten_before_s(now_s, CROWD_DIVISOR));
        // An open train is kept, but a sequence longer than the memory cannot be a drop.
        let kept_from_s =
            (open_from_s - OPEN_MARGIN_S).max(self.forgotten_before_s(now_s, OPEN_CROWD_DIVISOR));
        let past_s = closed_s.min(kept_from_s);
        result.periodic.retain(|r| r.start_s <= past_s);
        result.candidates.retain(|train| train.end_s() <= past_s);
        // The impacts of an accepted drop are removed from the candidates.
        let is_evaluated = |onset: &Onset| {
            onset.time_s <= past_s || result.trains.iter().any(|train| train.has(onset))
        };
        let evaluated: Vec<Onset> = self
            .onsets
            .extract_if(.., |onset| is_evaluated(onset))
            .collect();
        self.onsets_evaluated += standing_out(&evaluated);
        self.take(result);
        self.evaluated_s = past_s;
    }

    /// The time before which all sounds are forgotten: those older than the longest drop, and if the onsets are full, the
    /// oldest `1/divisor` of them.
    fn forgotten_before_s(&self, now_s: f64, divisor: usize) -> f64 {
        let crowd_s = match self.onsets.len() {
            MAX_ONSETS.. => self.onsets[MAX_ONSETS / divisor].time_s,
            _ => f64::NEG_INFINITY,
        };
        crowd_s.max(now_s - MAX_DROP_SHARE * self.remembered_s)
    }

    /// Aligns these trains while their samples are available, and adds them to the result.
    fn take(&mut self, mut result: TrainSearch) {
        for train in result.trains.iter_mut().chain(&mut result.candidates) {
            train.align_within(&|range_s| self.read(range_s));
        }
        self.found.trains.append(&mut result.trains);
        self.found.periodic.append(&mut result.periodic);
        self.found.add_candidates(result.candidates);
    }

    fn finish(mut self, channel: usize, distinct_channels: usize) -> Detection {
        let duration_s = self.samples as f64 / f64::from(self.sample_rate_hz);
        let before = self.onsets.len();
        self.detector.flush(&mut self.onsets);
        self.evaluate_onsets_from(before);
        self.evaluate_all(duration_s);
        self.found.set_distant_apart();
        Detection {
            sample_rate_hz: self.sample_rate_hz,
            channels: distinct_channels,
            channel,
            distinct_channels,
            found: self.found,
            onsets: self.onsets_evaluated,
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

/// The start of the first open train, or of one that overlaps with an open train; infinity if
/// all are over.
fn open_from_s(trains: &[Train], now_s: f64) -> f64 {
    let open = trains.iter().filter(|train| train.end_s() > now_s - OPEN_S);
    let mut from_s = open.map(Train::start_s).fold(f64::INFINITY, f64::min);
    // In the order of their starts, so that one pass suffices.
    for train in trains.iter().rev() {
        if train.end_s() >= from_s {
            from_s = from_s.min(train.start_s());
        }
    }
    from_s
}

/// The number of these sounds that stand out of the background.
fn standing_out(onsets: &[Onset]) -> usize {
    onsets.iter().filter(|onset| onset.stands_out()).count()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Clicks at this rate for this time, whose levels differ by up to 6 dB, with a drop of fifteen loud impacts
    /// from `drop_s` on.
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

    /// The result for these onsets as they come one by one, of which never more than the maximum are remembered.
    fn evaluated(onsets: &[Onset]) -> TrainSearch {
        let mut channel =
            ChannelDetector::new(OnsetDetector::new(44_100), 44_100, MAX_REMEMBERED_S);
        for onset in onsets {
            channel.onsets.push(*onset);
            channel.evaluate_onsets_from(channel.onsets.len() - 1);
            assert!(channel.onsets.len() <= MAX_ONSETS);
        }
        channel.evaluate_all(onsets[onsets.len() - 1].time_s);
        channel.found
    }

    #[test]
    fn steady_clicks_are_no_drop_however_long_they_continue() {
        for rate_hz in [20.0, 40.0, 70.0, 100.0] {
            let clicks = &clicks_and_drop(rate_hz, 400.0, 500.0)[..(400.0 * rate_hz) as usize];
            assert_eq!(evaluated(clicks).trains, [], "{rate_hz}");
        }
    }

    /// The past is evaluated whenever four thousand sounds are remembered.
    #[test]
    fn a_drop_is_found_wherever_the_past_is_cut() {
        for rate_hz in [20.0, 40.0, 70.0, 100.0] {
            let cut_s = MAX_ONSETS as f64 / rate_hz;
            for drop_s in [-5.0, -2.0, -1.0, 0.5].map(|it| cut_s + it) {
                let result = evaluated(&clicks_and_drop(rate_hz, cut_s + 10.0, drop_s));
                let starts_s: Vec<f64> = result.trains.iter().map(Train::start_s).collect();
                assert_eq!(starts_s, [drop_s + 0.4], "{rate_hz}");
                let impacts = result.trains[0].impacts().len();
                // One of the densest clicks may be taken for another impact.
                let max = if rate_hz < 100.0 { 15 } else { 16 };
                assert!(
                    (15..=max).contains(&impacts),
                    "{rate_hz}: {drop_s}: {impacts}"
                );
            }
        }
    }

    /// They once continued the train for three hundred impacts, or the drop was lost, or found twice.
    #[test]
    fn steady_clicks_after_a_drop_are_no_part_of_it() {
        for (rate_hz, drop_s) in [45.0, 60.0]
            .into_iter()
            .flat_map(|rate_hz| [5.0, 40.0, 60.0, 78.0, 90.0].map(|drop_s| (rate_hz, drop_s)))
        {
            let result = evaluated(&clicks_and_long_drop(rate_hz, drop_s));
            let starts_s: Vec<f64> = result.trains.iter().map(Train::start_s).collect();
            assert_eq!(starts_s, [drop_s], "{rate_hz}");
            // A few clicks are taken for impacts, until the rhythm is more likely than further impacts.
            let impacts = result.trains[0].impacts().len();
            assert!(
                (38..=60).contains(&impacts),
                "{rate_hz}: {drop_s}: {impacts}"
            );
        }
    }
}
