//! Which drops are over in a live stream.

use super::parameters::{MAX_WORK_PER_S, MIN_EVALUATION_S, POLL_S, SETTLED_S};
use super::{Detection, DetectionOptions, Detector};
use crate::Result;
use crate::train::{Train, TrainSearch, latest_next_s};

/// Watches a live stream, and reports each drop once, when it is over.
///
/// The reports depend on the sound alone, not on the blocks in which it comes, and equal the
/// result of the whole recording for the drop.
///
/// ```
/// use bouncelab::demo;
/// use bouncelab::detection::{DetectionOptions, DropWatch};
///
/// let mut sound = demo::sound(&demo::history()?, 1)?;
/// sound.samples.resize(sound.samples.len() + 6 * sound.sample_rate_hz as usize, 0.0);
/// let mut watch = DropWatch::new(sound.sample_rate_hz, 1, &DetectionOptions::default())?;
/// let over: Vec<_> = sound.samples.chunks(1024).flat_map(|block| watch.push(&[block])).collect();
/// assert_eq!(over.len(), 1);
/// # Ok::<(), bouncelab::Error>(())
/// ```
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct DropWatch {
    detector: Detector,
    sample_rate_hz: f64,
    /// Number of frames so far, and at the next poll.
    frames: u64,
    next_poll: u64,
    /// The result of the last evaluation, the number of sounds then, and the earliest time of the next one.
    detection: Option<Detection>,
    evaluated_onsets: usize,
    next_evaluation_s: f64,
    reported: Vec<Train>,
    /// The state at the last report.
    last: LastReport,
}

/// What is counted from report to report.
#[derive(Clone, Copy, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
struct LastReport {
    time_s: f64,
    clipped_samples: u64,
}

impl DropWatch {
    /// A watch for this many channels at this rate.
    ///
    /// # Errors
    ///
    /// Those of [`Detector::with_options`].
    pub fn new(sample_rate_hz: u32, channels: usize, options: &DetectionOptions) -> Result<Self> {
        let mut watch = Self {
            detector: Detector::with_options(sample_rate_hz, channels, options)?,
            sample_rate_hz: f64::from(sample_rate_hz),
            frames: 0,
            next_poll: 0,
            detection: None,
            evaluated_onsets: 0,
            next_evaluation_s: MIN_EVALUATION_S,
            reported: Vec::new(),
            last: LastReport::default(),
        };
        watch.set_next_poll();
        Ok(watch)
    }

    /// Duration of the sound so far, in seconds.
    pub fn now_s(&self) -> f64 {
        self.frames as f64 / self.sample_rate_hz
    }

    /// Number of frames until the next poll.
    pub fn frames_until_poll(&self) -> usize {
        (self.next_poll - self.frames) as usize
    }

    /// Takes the next samples of every channel, and returns the drops that are now over: each as a
    /// recording of its own.
    ///
    /// # Panics
    ///
    /// As [`Detector::push`].
    pub fn push(&mut self, channels: &[&[f32]]) -> Vec<Detection> {
        let frames = channels.first().map_or(0, |samples| samples.len());
        let mut over = Vec::new();
        let mut from = 0;
        while from < frames {
            let to = frames.min(from + self.frames_until_poll());
            let part: Vec<&[f32]> = channels.iter().map(|samples| &samples[from..to]).collect();
            self.detector.push(&part);
            self.frames += (to - from) as u64;
            if self.frames >= self.next_poll {
                self.set_next_poll();
                over.extend(self.poll());
            }
            from = to;
        }
        over
    }

    /// The detector of the stream.
    pub const fn detector(&self) -> &Detector {
        &self.detector
    }

    /// Whether a drop was reported.
    pub fn was_reported(&self, train: &Train) -> bool {
        self.reported.iter().any(|it| it.is_same_drop(train))
    }

    /// Polls are at fixed times of the sound, so that the reports do not depend on the
    /// blocks in which it comes.
    fn set_next_poll(&mut self) {
        let polls = (self.now_s() / POLL_S + 0.5).floor() + 1.0;
        let frame = (polls * POLL_S * self.sample_rate_hz).round() as u64;
        self.next_poll = frame.max(self.frames + 1);
    }

    fn poll(&mut self) -> Vec<Detection> {
        let now_s = self.now_s();
        let onsets = self.detector.onsets();
        let is_new = onsets != self.evaluated_onsets && now_s >= self.next_evaluation_s;
        let is_over = self
            .unreported(self.trains())
            .any(|train| self.is_settled(train));
        if !is_new && !is_over {
            return Vec::new();
        }
        self.detection = Some(self.detector.so_far());
        self.evaluated_onsets = onsets;
        let work_s = self.detector.work() as f64 / MAX_WORK_PER_S;
        self.next_evaluation_s = now_s + work_s.max(MIN_EVALUATION_S);
        self.report()
    }

    /// The drops that are over and were not reported, each as a recording of its own.
    fn report(&mut self) -> Vec<Detection> {
        let over: Vec<Train> = self
            .unreported(self.trains())
            .filter(|train| self.is_settled(train))
            .cloned()
            .collect();
        let Some(detection) = &self.detection else {
            return Vec::new();
        };
        let (before, now_s) = (self.last, self.now_s());
        let as_recording = |train: &Train| Detection {
            found: TrainSearch {
                trains: vec![train.clone()],
                distant: detection
                    .found
                    .distant
                    .iter()
                    .filter(|distant| distant.end_s() > before.time_s)
                    .cloned()
                    .collect(),
                candidates: Vec::new(),
                periodic: Vec::new(),
            },
            duration_s: now_s,
            clipped_samples: detection
                .clipped_samples
                .saturating_sub(before.clipped_samples),
            ..detection.clone()
        };
        let recordings: Vec<Detection> = over.iter().map(as_recording).collect();
        if !over.is_empty() {
            self.last = LastReport {
                time_s: now_s,
                clipped_samples: detection.clipped_samples,
            };
            self.reported.extend(over);
        }
        recordings
    }

    fn trains(&self) -> &[Train] {
        let detection = self.detection.as_ref();
        detection.map_or(&[], |detection| &detection.found.trains)
    }

    /// Those of these drops that were not reported yet.
    fn unreported<'a>(&'a self, trains: &'a [Train]) -> impl Iterator<Item = &'a Train> {
        trains.iter().filter(|train| !self.was_reported(train))
    }

    fn is_settled(&self, train: &Train) -> bool {
        self.now_s() > latest_next_s(train.impacts()).max(train.end_s() + SETTLED_S)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::impact::ImpactEvent;
    use crate::synth::{self, Scene};

    /// Two drops of fifteen impacts each, 6 s apart.
    fn two_drops() -> Vec<f32> {
        let mut events = Vec::new();
        for start_s in [0.0, 9.0] {
            let mut time_s = start_s;
            for n in 0..15 {
                let speed_m_s = 2.4 * 0.88_f64.powi(n);
                events.push(ImpactEvent { time_s, speed_m_s });
                time_s += 2.0 * 0.88 * speed_m_s / 9.81;
            }
        }
        let scene = Scene {
            tail_s: 6.0,
            ..Scene::default()
        };
        synth::render(&events, &scene, 2).unwrap().samples
    }

    /// The reported drops, and the time of each report in seconds, if the sound comes in blocks of this size.
    fn reports(samples: &[f32], block: usize) -> Vec<(Train, f64)> {
        let mut watch = DropWatch::new(44_100, 1, &DetectionOptions::default()).unwrap();
        let mut reports = Vec::new();
        for block in samples.chunks(block) {
            for detection in watch.push(&[block]) {
                reports.push((detection.found.trains[0].clone(), detection.duration_s));
            }
        }
        reports
    }

    #[test]
    fn each_drop_is_reported_once_and_as_the_whole_recording_has_it() {
        let samples = two_drops();
        let reports = reports(&samples, 1024);
        let mut detector = Detector::new(44_100, 1);
        detector.push(&[&samples]);
        let whole = detector.finish().found.trains;
        assert_eq!(whole.len(), 2);
        assert_eq!(reports.len(), 2);
        for ((train, time_s), whole) in reports.iter().zip(&whole) {
            assert_eq!(train.impacts(), whole.impacts());
            assert!(*time_s > train.end_s() && *time_s < train.end_s() + SETTLED_S + 2.0 * POLL_S);
        }
    }

    #[test]
    fn the_blocks_in_which_sound_comes_make_no_difference() {
        let samples = two_drops();
        let expected = reports(&samples, 4096);
        for block in [1, 777, 1_000_000] {
            assert_eq!(reports(&samples, block), expected, "blocks of {block}");
        }
    }

    /// Clicks of 1.5 ms at this rate per second in faint noise, for this number of seconds.
    fn clicks(per_s: usize, seconds: usize) -> Vec<f32> {
        let mut state = 1_u32;
        let mut samples: Vec<f32> = (0..seconds * 44_100)
            .map(|_| {
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                1e-3 * ((state >> 8) as f32 / 8e6 - 1.0)
            })
            .collect();
        for first in (0..seconds * per_s).map(|number| number * 44_100 / per_s) {
            for (n, sample) in samples[first..].iter_mut().take(66).enumerate() {
                let t = n as f32 / 44_100.0;
                *sample += 0.3 * (-t / 5e-4).exp() * (std::f32::consts::TAU * 3e3 * t).sin();
            }
        }
        samples
    }

    /// On a computer that needs a second for the work of a second, one of a tenth of the speed of an ordinary one,
    /// the sound that comes meanwhile fits into the ring of the microphone.
    #[test]
    fn dense_clicks_never_overrun_a_live_stream() {
        const RING_S: f64 = 30.0;
        for per_s in [100, 1_000] {
            let samples = clicks(per_s, 30);
            let mut watch = DropWatch::new(44_100, 1, &DetectionOptions::default()).unwrap();
            let mut busy_until_s: f64 = 0.0;
            let mut evaluations = 0;
            for block in samples.chunks(1024) {
                let before_s = watch.next_evaluation_s;
                assert_eq!(
                    watch.push(&[block]).len(),
                    0,
                    "{per_s}: {} s",
                    watch.now_s()
                );
                if watch.next_evaluation_s > before_s {
                    let work_s = watch.detector.work() as f64 / MAX_WORK_PER_S;
                    busy_until_s = busy_until_s.max(watch.now_s()) + work_s;
                    evaluations += 1;
                }
                let behind_s = busy_until_s - watch.now_s();
                assert!(behind_s < RING_S, "{per_s}: {behind_s} s behind");
            }
            assert_eq!(watch.frames, samples.len() as u64);
            assert!(evaluations > 0 || watch.detector.onsets() == 0, "{per_s}");
        }
    }
}
