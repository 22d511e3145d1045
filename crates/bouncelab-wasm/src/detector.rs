//! Detects the drops of a recording.

use bouncelab::analysis::{DetectionOptions, DropTask, Gap, Plan, rests_at_s};
use bouncelab::onset::OnsetDetector;
use bouncelab::train::Train;
use bouncelab::{Detector, Diagnostic, Impact, Options, Recording};

use crate::pyramid::{Level, Pyramid};
use crate::refusal::Result;
use crate::wire::{ReadList, SoFar};

/// Detects drops in a recording as it comes, and keeps its loudness at any zoom.
///
/// Drops are analysed without the inference, as those of an ordinary ball in ordinary air: what a page
/// shows until its settings are applied.
#[derive(Debug)]
pub struct RecordingDetector {
    detector: Detector,
    /// One for each channel of the recording.
    pyramids: Vec<Pyramid>,
    options: Options,
    sample_rate_hz: u32,
    frames: u64,
    /// The number of onsets at the last search for drops, and its result.
    searched_onsets: usize,
    so_far: SoFar,
    /// The last drop of that search.
    last: Option<Train>,
}

impl RecordingDetector {
    /// A detector for a number of channels, which uses one of them (counted from 1) or all.
    ///
    /// # Errors
    ///
    /// If there is no channel of this number.
    pub fn new(sample_rate_hz: u32, channels: usize, channel: Option<usize>) -> Result<Self> {
        let detection = DetectionOptions {
            channel,
            ..DetectionOptions::default()
        };
        Ok(Self {
            detector: Detector::with_options(sample_rate_hz, channels, &detection)?,
            pyramids: vec![Pyramid::default(); channels],
            options: Options::default().without_inference(),
            sample_rate_hz,
            frames: 0,
            searched_onsets: 0,
            so_far: SoFar::default(),
            last: None,
        })
    }

    /// Takes the next samples of each channel.
    pub fn push(&mut self, channels: &[&[f32]]) {
        for (pyramid, samples) in self.pyramids.iter_mut().zip(channels) {
            pyramid.push(samples);
        }
        self.detector.push(channels);
        self.frames += channels.first().map_or(0, |samples| samples.len()) as u64;
    }

    /// Notes where sound was lost: silence is pushed instead, and no flight across it counts.
    pub fn lose(&mut self, gaps: Vec<Gap>) {
        self.options.edits.gaps.extend(gaps);
    }

    /// What was detected so far. Drops are searched again only if there are new onsets.
    pub fn so_far(&mut self) -> &SoFar {
        if self.detector.onsets() != self.searched_onsets {
            self.searched_onsets = self.detector.onsets();
            let detection = self.detector.so_far();
            self.last = detection.found.trains.last().cloned();
            let plan = Plan::of_detection(detection, &self.options);
            self.so_far.drops = plan.tasks().len();
            self.so_far.drop = plan.tasks().last().map(DropTask::run);
        }
        let now_s = self.frames as f64 / f64::from(self.sample_rate_hz);
        self.so_far.duration_s = now_s;
        let last = self.last.as_ref();
        self.so_far.at_rest =
            last.is_some_and(|train| now_s > rests_at_s(train.impacts(), &self.options.edits.gaps));
        &self.so_far
    }

    /// Ends the recording: what was detected, and the loudness of the channel with the drops. Format and
    /// warnings are those of the file.
    pub fn finish(mut self, format: &str, warnings: Vec<Diagnostic>) -> (Recording, Vec<Level>) {
        let detection = self.detector.finish();
        let levels = self.pyramids.swap_remove(detection.channel).levels();
        let plan = Plan::of_detection(detection, &self.options);
        (plan.of_file(format, warnings).run(), levels)
    }
}

/// A list of times as a recording.
pub fn of_list(list: &ReadList) -> Recording {
    let options = Options::default().without_inference();
    Plan::of_list(&list.times_s, list.origin.clone(), &options).run()
}

/// The onset nearest to a time in samples that begin at `start_s`, as an impact.
pub fn onset_near(
    samples: &[f32],
    sample_rate_hz: u32,
    start_s: f64,
    time_s: f64,
) -> Option<Impact> {
    let mut onsets = Vec::new();
    let mut detector = OnsetDetector::new(sample_rate_hz);
    detector.push(samples, &mut onsets);
    detector.finish(&mut onsets);
    let impacts = onsets.iter().map(|onset| {
        let impact = Impact::new(1, start_s + onset.time_s).with_time_sd_s(onset.sigma_s);
        impact.with_level_db(onset.level_db)
    });
    let distance = |impact: &Impact| (impact.time_s - time_s).abs();
    impacts.min_by(|a, b| distance(a).total_cmp(&distance(b)))
}

#[cfg(test)]
mod tests {
    use bouncelab::demo;

    use super::*;

    /// After how many seconds a ball seems to rest that was heard for 3 s, before silence.
    fn rests_after_s(gaps: Vec<Gap>) -> Option<f64> {
        let sound = demo::sound(&demo::history().unwrap(), 1).unwrap();
        let rate_hz = sound.sample_rate_hz as usize;
        let mut detector = RecordingDetector::new(sound.sample_rate_hz, 1, None).unwrap();
        detector.push(&[&sound.samples[..3 * rate_hz]]);
        assert!(!detector.so_far().at_rest);
        detector.lose(gaps);
        (0..100).find_map(|_| {
            detector.push(&[&vec![0.0; rate_hz / 10]]);
            let so_far = detector.so_far();
            so_far.at_rest.then_some(so_far.duration_s)
        })
    }

    #[test]
    fn a_ball_rests_only_when_no_impact_is_heard() {
        let gap = |start_s, duration_s| Gap {
            start_s,
            duration_s,
            certain: true,
        };
        let silent_s = rests_after_s(vec![]).unwrap();
        assert!(silent_s < 5.5);
        assert_eq!(rests_after_s(vec![gap(1.0, 0.2)]), Some(silent_s));
        let lost_s = rests_after_s(vec![gap(3.0, 4.0)]).unwrap();
        assert!(lost_s > silent_s + 3.0, "{silent_s} s, {lost_s} s");
    }
}
