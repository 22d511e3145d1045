//! Decides which drops are in progress and which are over.

use std::time::Instant;

use bouncelab::Result;
use bouncelab::analysis::DetectionOptions;
use bouncelab::detection::{Detection, Detector};
use bouncelab::train::{Train, TrainImpact, TrainSearch, latest_next_s};

/// How often is looked whether something is to be told, in seconds of sound.
const LOOK_S: f64 = 0.1;
/// All sounds are judged anew this often at most, in seconds of sound, while no drop is known.
const JUDGE_S: f64 = 1.0;
/// For the eyes they are judged as often as takes this share of the time.
const SHARE_FOR_EYES: f64 = 0.2;
/// Sounds this much later than a drop, in seconds, no longer change how it is judged: no sound is
/// compared with others farther away than 3 s, and none is noticed more than half a second late.
const SETTLED_S: f64 = 3.6;

/// Listens, and tells of each drop once, when it is over.
pub(super) struct Watch {
    detector: Detector,
    sample_rate_hz: f64,
    /// How many frames were read, and how many will have been at the next look.
    frames: u64,
    next_look: u64,
    /// The last evaluation of the whole recording, its time, and how many sounds there were.
    heard: Option<Detection>,
    judged_s: f64,
    judged_onsets: usize,
    glimpse: Glimpse,
    told: Vec<Train>,
    /// The detections when a drop was last reported.
    last: Reported,
}

/// What is counted from drop to drop.
#[derive(Clone, Copy, Default)]
struct Reported {
    time_s: f64,
    clipped_samples: u64,
}

/// What is shown of a drop that is going on. It changes nothing of what is told, so it may depend
/// on how fast the computer is.
#[derive(Default)]
struct Glimpse {
    trains: Vec<Train>,
    onsets: usize,
    /// Not sooner again than this.
    next: Option<Instant>,
}

/// A drop that is going on.
pub(super) struct Going<'a> {
    pub(super) impacts: &'a [TrainImpact],
    /// Whether the ball rests, or was stopped: any further impact would have been detected.
    pub(super) rests: bool,
}

impl Watch {
    pub(super) fn new(
        sample_rate_hz: u32,
        channels: usize,
        options: &DetectionOptions,
    ) -> Result<Self> {
        let mut watch = Self {
            detector: Detector::with_options(sample_rate_hz, channels, options)?,
            sample_rate_hz: f64::from(sample_rate_hz),
            frames: 0,
            next_look: 0,
            heard: None,
            judged_s: 0.0,
            judged_onsets: 0,
            glimpse: Glimpse::default(),
            told: Vec::new(),
            last: Reported::default(),
        };
        watch.set_next_look();
        Ok(watch)
    }

    pub(super) fn now_s(&self) -> f64 {
        self.frames as f64 / self.sample_rate_hz
    }

    /// How many sounds have stood out from the background.
    pub(super) fn onsets(&self) -> usize {
        self.detector.onsets()
    }

    /// How many frames there are until the next look.
    pub(super) fn frames_until_look(&self) -> usize {
        (self.next_look - self.frames) as usize
    }

    /// Takes the next samples, at most those until the next look, and returns the drops that are
    /// over since: each as a recording of its own.
    pub(super) fn push(&mut self, channels: &[&[f32]]) -> Vec<Detection> {
        self.detector.push(channels);
        self.frames += channels.first().map_or(0, |samples| samples.len()) as u64;
        if self.frames < self.next_look {
            return Vec::new();
        }
        self.set_next_look();
        self.look()
    }

    /// The drop that is going on, if there is one.
    pub(super) fn going(&mut self) -> Option<Going<'_>> {
        self.glimpse.renew(&self.detector);
        let train = self.untold(&self.glimpse.trains).last()?;
        Some(Going {
            impacts: train.impacts(),
            rests: self.now_s() > latest_next_s(train.impacts()),
        })
    }

    /// The detections in the whole recording, as if the sound ended here.
    pub(super) fn whole(&self) -> Detection {
        self.detector.so_far()
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
        let is_new = onsets != self.judged_onsets && now_s >= self.judged_s + JUDGE_S;
        let is_over = self
            .untold(self.trains())
            .any(|train| self.is_settled(train));
        if !is_new && !is_over {
            return Vec::new();
        }
        self.heard = Some(self.detector.so_far());
        (self.judged_s, self.judged_onsets) = (now_s, onsets);
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
        let is_told = |train: &Train| self.told.iter().any(|told| overlap(told, train));
        trains.iter().filter(move |train| !is_told(train))
    }

    fn is_settled(&self, train: &Train) -> bool {
        self.now_s() > latest_next_s(train.impacts()).max(train.end_s() + SETTLED_S)
    }
}

impl Glimpse {
    /// Judges all sounds if there are new ones, unless that was done a moment ago.
    fn renew(&mut self, detector: &Detector) {
        let start = Instant::now();
        if detector.onsets() == self.onsets || self.next.is_some_and(|next| start < next) {
            return;
        }
        self.onsets = detector.onsets();
        self.trains = detector.so_far().found.trains;
        self.next = Some(start + start.elapsed().div_f64(SHARE_FOR_EYES));
    }
}

/// Whether two trains share a time.
pub(super) fn overlap(a: &Train, b: &Train) -> bool {
    a.start_s() <= b.end_s() && b.start_s() <= a.end_s()
}

#[cfg(test)]
mod tests {
    use bouncelab::impact::Strike;
    use bouncelab::synth::{self, Scene};

    use super::*;

    /// Two drops of fifteen impacts each, 6 s apart.
    fn two_drops() -> Vec<f32> {
        let mut strikes = Vec::new();
        for start_s in [0.0, 9.0] {
            let mut time_s = start_s;
            for n in 0..15 {
                let speed_m_s = 2.4 * 0.88_f64.powi(n);
                strikes.push(Strike { time_s, speed_m_s });
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
        let mut watch = Watch::new(44_100, 1, &DetectionOptions::default()).unwrap();
        let mut told = Vec::new();
        for block in samples.chunks(block) {
            let mut rest = block;
            while !rest.is_empty() {
                let (piece, later) = rest.split_at(watch.frames_until_look().min(rest.len()));
                rest = later;
                for heard in watch.push(&[piece]) {
                    told.push((heard.found.trains[0].clone(), watch.now_s()));
                }
            }
        }
        told
    }

    #[test]
    fn each_drop_is_reported_once_as_in_the_whole_recording() {
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

    #[test]
    fn a_drop_that_goes_on_is_seen_and_its_end_too() {
        let samples = two_drops();
        let mut watch = Watch::new(44_100, 1, &DetectionOptions::default()).unwrap();
        let mut counts = Vec::new();
        let mut rested = false;
        for piece in samples[..7 * 44_100].chunks(4410) {
            if !watch.push(&[piece]).is_empty() {
                break;
            }
            let now_s = watch.now_s();
            // As if there had been time enough for the last look; how much there was depends on what
            // else the computer does.
            watch.glimpse.next = None;
            if let Some(going) = watch.going() {
                counts.push(going.impacts.len());
                rested |= going.rests;
                assert_eq!(
                    going.rests,
                    now_s > latest_next_s(going.impacts),
                    "{now_s} s"
                );
            }
        }
        assert!(rested);
        assert!(counts[0] < 10, "first seen with {} impacts", counts[0]);
        assert_eq!(counts.last(), Some(&15));
    }
}
