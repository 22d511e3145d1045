//! Detects drops in progress, and drops that are over.

use std::time::Instant;

use bouncelab::Result;
use bouncelab::analysis::DetectionOptions;
use bouncelab::detection::{Detector, DropWatch};
use bouncelab::train::{Train, TrainImpact, latest_next_s};

/// Share of the time that the evaluation of sounds for the display may take.
const SHARE_FOR_EYES: f64 = 0.2;

/// Reports each drop that is over, and the one in progress.
pub(super) struct Watch {
    pub(super) drops: DropWatch,
    glimpse: Glimpse,
}

/// The display of a drop in progress. It has no effect on results, so it may depend on the speed of the computer.
#[derive(Default)]
struct Glimpse {
    trains: Vec<Train>,
    onsets: usize,
    /// The earliest time of the next evaluation.
    next: Option<Instant>,
}

/// A drop in progress.
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
        Ok(Self {
            drops: DropWatch::new(sample_rate_hz, channels, options)?,
            glimpse: Glimpse::default(),
        })
    }

    /// The drop in progress, if there is one.
    pub(super) fn going(&mut self) -> Option<Going<'_>> {
        self.glimpse.renew(self.drops.detector());
        let mut trains = self.glimpse.trains.iter();
        let train = trains.rfind(|train| !self.drops.was_reported(train))?;
        Some(Going {
            impacts: train.impacts(),
            rests: self.drops.now_s() > latest_next_s(train.impacts()),
        })
    }
}

impl Glimpse {
    /// Evaluates all sounds if there are new ones, unless that was done a moment ago.
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

#[cfg(test)]
mod tests {
    use bouncelab::synth::{self, Scene};
    use bouncelab_testkit::impact_events;

    use super::*;

    /// A drop of fifteen impacts, and silence.
    fn one_drop() -> Vec<f32> {
        let scene = Scene {
            tail_s: 6.0,
            ..Scene::default()
        };
        let events: Vec<_> = impact_events(2.4, 0.88).take(15).collect();
        synth::render(&events, &scene, 2).unwrap().samples
    }

    #[test]
    fn a_drop_that_goes_on_is_seen_and_its_end_too() {
        let samples = one_drop();
        let mut watch = Watch::new(44_100, 1, &DetectionOptions::default()).unwrap();
        let mut counts = Vec::new();
        let mut rested = false;
        for piece in samples[..7 * 44_100].chunks(4410) {
            if !watch.drops.push(&[piece]).is_empty() {
                break;
            }
            let now_s = watch.drops.now_s();
            // As if there had been time for the last evaluation, which depends on the load of the computer.
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
