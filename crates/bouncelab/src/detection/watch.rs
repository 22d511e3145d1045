//! Which drops are over, while sound still comes?

use super::{Detection, DetectionOptions, Detector};
use crate::Result;
use crate::train::{Train, TrainSearch, latest_next_s};

/// How often is looked whether something is to be told, in seconds of sound.
const LOOK_S: f64 = 0.1;
/// All sounds are judged anew this often at most, in seconds of sound, while no drop is known.
const JUDGE_S: f64 = 1.0;
/// Among dense sounds they are judged less often, so that each second of sound brings no more work than this, as
/// [`Detector::work`] counts it: a tenth of a second or less on an ordinary computer. Steady clicks, 30 a second,
/// are still judged each second; 100 a second, every ten seconds.
const WORK_PER_S: f64 = 16e6;
/// Sounds this much later than a drop, in seconds, no longer change how it is judged: no sound is
/// compared with others farther away than 3 s, and none is noticed more than half a second late.
const SETTLED_S: f64 = 3.6;

/// Watches sound that still comes, and tells of each drop once, when it is over.
///
/// What it tells depends on the sound alone, never on the blocks in which it comes, and is what the
/// whole recording says of the drop.
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
    /// How many frames were heard, and how many will have been at the next look.
    frames: u64,
    next_look: u64,
    /// What was heard when all was last judged, how many sounds there were, and before when that is not done again.
    heard: Option<Detection>,
    judged_onsets: usize,
    next_judge_s: f64,
    told: Vec<Train>,
    /// What had been heard when a drop was last told of.
    last: Reported,
}

/// What is counted from drop to drop.
#[derive(Clone, Copy, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
struct Reported {
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
            next_look: 0,
            heard: None,
            judged_onsets: 0,
            next_judge_s: JUDGE_S,
            told: Vec::new(),
            last: Reported::default(),
        };
        watch.set_next_look();
        Ok(watch)
    }

    /// How much sound came, in seconds.
    pub fn now_s(&self) -> f64 {
        self.frames as f64 / self.sample_rate_hz
    }

    /// How many frames there are until the next look.
    pub fn frames_until_look(&self) -> usize {
        (self.next_look - self.frames) as usize
    }

    /// Takes the next samples of every channel, and returns the drops that are over since: each as a
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
            let to = frames.min(from + self.frames_until_look());
            let part: Vec<&[f32]> = channels.iter().map(|samples| &samples[from..to]).collect();
            self.detector.push(&part);
            self.frames += (to - from) as u64;
            if self.frames >= self.next_look {
                self.set_next_look();
                over.extend(self.look());
            }
            from = to;
        }
        over
    }

    /// What detects the sounds.
    pub const fn detector(&self) -> &Detector {
        &self.detector
    }

    /// Whether a drop was told of.
    pub fn was_told(&self, train: &Train) -> bool {
        self.told.iter().any(|told| told.is_same_drop(train))
    }

    /// Looks are at fixed times, so that the same sound gives the same answers whatever the
    /// blocks in which it comes.
    fn set_next_look(&mut self) {
        let looks = (self.now_s() / LOOK_S + 0.5).floor() + 1.0;
        let frame = (looks * LOOK_S * self.sample_rate_hz).round() as u64;
        self.next_look = frame.max(self.frames + 1);
    }

    fn look(&mut self) -> Vec<Detection> {
        let now_s = self.now_s();
        let onsets = self.detector.onsets();
        let is_new = onsets != self.judged_onsets && now_s >= self.next_judge_s;
        let is_over = self
            .untold(self.trains())
            .any(|train| self.is_settled(train));
        if !is_new && !is_over {
            return Vec::new();
        }
        self.heard = Some(self.detector.so_far());
        self.judged_onsets = onsets;
        self.next_judge_s = now_s + (self.detector.work() as f64 / WORK_PER_S).max(JUDGE_S);
        self.tell()
    }

    /// The drops that are over and were not told of, each as a recording of its own.
    fn tell(&mut self) -> Vec<Detection> {
        let over: Vec<Train> = self
            .untold(self.trains())
            .filter(|train| self.is_settled(train))
            .cloned()
            .collect();
        let Some(heard) = &self.heard else {
            return Vec::new();
        };
        let (before, now_s) = (self.last, self.now_s());
        let as_recording = |train: &Train| Detection {
            found: TrainSearch {
                trains: vec![train.clone()],
                distant: heard
                    .found
                    .distant
                    .iter()
                    .filter(|distant| distant.end_s() > before.time_s)
                    .cloned()
                    .collect(),
                periodic: Vec::new(),
            },
            duration_s: now_s,
            clipped_samples: heard.clipped_samples.saturating_sub(before.clipped_samples),
            ..heard.clone()
        };
        let recordings: Vec<Detection> = over.iter().map(as_recording).collect();
        if !over.is_empty() {
            self.last = Reported {
                time_s: now_s,
                clipped_samples: heard.clipped_samples,
            };
            self.told.extend(over);
        }
        recordings
    }

    fn trains(&self) -> &[Train] {
        self.heard.as_ref().map_or(&[], |heard| &heard.found.trains)
    }

    /// Those of these drops that were not told of yet.
    fn untold<'a>(&'a self, trains: &'a [Train]) -> impl Iterator<Item = &'a Train> {
        trains.iter().filter(|train| !self.was_told(train))
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
        let mut strikes = Vec::new();
        for start_s in [0.0, 9.0] {
            let mut time_s = start_s;
            for n in 0..15 {
                let speed_m_s = 2.4 * 0.88_f64.powi(n);
                strikes.push(ImpactEvent { time_s, speed_m_s });
                time_s += 2.0 * 0.88 * speed_m_s / 9.81;
            }
        }
        let scene = Scene {
            tail_s: 6.0,
            ..Scene::default()
        };
        synth::render(&strikes, &scene, 2).unwrap().samples
    }

    /// What is told of, and after how many seconds, if the sound comes in blocks of this size.
    fn told(samples: &[f32], block: usize) -> Vec<(Train, f64)> {
        let mut watch = DropWatch::new(44_100, 1, &DetectionOptions::default()).unwrap();
        let mut told = Vec::new();
        for block in samples.chunks(block) {
            for heard in watch.push(&[block]) {
                told.push((heard.found.trains[0].clone(), heard.duration_s));
            }
        }
        told
    }

    #[test]
    fn each_drop_is_told_of_once_and_as_the_whole_recording_has_it() {
        let samples = two_drops();
        let told = told(&samples, 1024);
        let mut detector = Detector::new(44_100, 1);
        detector.push(&[&samples]);
        let whole = detector.finish().found.trains;
        assert_eq!(whole.len(), 2);
        assert_eq!(told.len(), 2);
        for ((train, time_s), whole) in told.iter().zip(&whole) {
            assert_eq!(train.impacts(), whole.impacts());
            assert!(*time_s > train.end_s() && *time_s < train.end_s() + SETTLED_S + 2.0 * LOOK_S);
        }
    }

    #[test]
    fn the_blocks_in_which_sound_comes_make_no_difference() {
        let samples = two_drops();
        let expected = told(&samples, 4096);
        for block in [1, 777, 1_000_000] {
            assert_eq!(told(&samples, block), expected, "blocks of {block}");
        }
    }

    /// So many clicks of 1.5 ms a second in faint noise, for so many seconds.
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
            let mut judged = 0;
            for block in samples.chunks(1024) {
                let before_s = watch.next_judge_s;
                assert_eq!(
                    watch.push(&[block]).len(),
                    0,
                    "{per_s}: {} s",
                    watch.now_s()
                );
                if watch.next_judge_s > before_s {
                    let work_s = watch.detector.work() as f64 / WORK_PER_S;
                    busy_until_s = busy_until_s.max(watch.now_s()) + work_s;
                    judged += 1;
                }
                let behind_s = busy_until_s - watch.now_s();
                assert!(behind_s < RING_S, "{per_s}: {behind_s} s behind");
            }
            assert_eq!(watch.frames, samples.len() as u64);
            assert!(judged > 0 || watch.detector.onsets() == 0, "{per_s}");
        }
    }
}
