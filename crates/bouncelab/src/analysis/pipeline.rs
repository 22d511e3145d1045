//! The steps from samples, or times, to the result.

use super::result::{Recording, Source, StrongestBand};
use super::{
    Drop, Edits, ListOrigin, Options, analyze_impacts, edit, gap, impacts_of_times, listed,
};
use crate::Result;
use crate::detection::{Detection, Detector, Envelope};
use crate::diagnostic::{Code, Diagnostic};
use crate::impact::Impact;
use crate::onset;
use crate::stats::sort_by_number;
use crate::train::{MIN_IMPACTS, Train};

/// Analyses a recording of one channel: full scale is 1.
///
/// ```
/// use bouncelab::{Options, analyze, demo};
///
/// let recording = demo::sound(&demo::history()?, 1)?;
/// let result = analyze(&recording.samples, recording.sample_rate_hz, &Options::default())?;
/// for drop in &result.drops {
///     let restitution = drop.posterior.clone()?.restitution;
///     println!("e = {:.4} ± {:.4}", restitution.value, restitution.sd);
/// }
/// assert_eq!(result.drops.len(), 1);
/// # Ok::<(), bouncelab::Error>(())
/// ```
///
/// # Errors
///
/// [`Error::NoBand`](crate::Error::NoBand) and [`Error::NoChannel`](crate::Error::NoChannel) if the
/// options name a band or a channel that does not exist. A recording without a drop is no error:
/// [`Recording::no_drop`] is the reason.
pub fn analyze(samples: &[f32], sample_rate_hz: u32, options: &Options) -> Result<Recording> {
    analyze_channels(&[samples], sample_rate_hz, options)
}

/// Analyses a recording of several channels of equal length; the one with the most evidence for its
/// drops is used.
///
/// # Errors
///
/// Those of [`analyze`].
///
/// ```
/// use bouncelab::analysis::Source;
/// use bouncelab::{Options, analyze_channels, demo};
///
/// // Nothing on the left, a drop on the right.
/// let sound = demo::sound(&demo::history()?, 1)?;
/// let silence = vec![0.0; sound.samples.len()];
/// let options = Options::default().without_inference();
/// let result = analyze_channels(&[&silence, &sound.samples], sound.sample_rate_hz, &options)?;
/// assert!(matches!(result.source, Source::Sound { channel: 2, .. }));
/// # Ok::<(), bouncelab::Error>(())
/// ```
pub fn analyze_channels(
    channels: &[&[f32]],
    sample_rate_hz: u32,
    options: &Options,
) -> Result<Recording> {
    let mut detector = Detector::with_options(sample_rate_hz, channels.len(), &options.detection)?;
    detector.push(channels);
    Ok(Plan::of_detection(detector.finish(), options).run())
}

/// Analyses a list of impact times in seconds, in increasing order, which are those of one drop.
///
/// ```
/// use bouncelab::{Options, analyze_times};
///
/// let times_s = [0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045];
/// let result = analyze_times(&times_s, &Options::default());
/// let fit = result.drops[0].log_linear_fit.clone()?;
/// assert_eq!(format!("{:.3}", fit.restitution.value), "0.932");
/// # Ok::<(), bouncelab::Error>(())
/// ```
pub fn analyze_times(times_s: &[f64], options: &Options) -> Recording {
    Plan::of_times(times_s, options).run()
}

/// Maximum number of drops of a recording that are analysed; each takes a tenth of a second and less than a megabyte.
const MAX_DROPS: usize = 1_000;

/// A recording whose drops are yet to be analysed, each independently: in parallel if the caller has threads, else one
/// after the other.
///
/// ```
/// use bouncelab::Options;
/// use bouncelab::analysis::{DropTask, Plan};
///
/// let plan = Plan::of_times(&[0.0, 0.4605, 0.8877, 1.2854], &Options::default());
/// let drops = plan.tasks().iter().map(DropTask::run).collect();
/// assert_eq!(plan.finish(drops).drops.len(), 1);
/// ```
#[derive(Clone, Debug)]
pub struct Plan {
    recording: Recording,
    options: Options,
    tasks: Vec<DropTask>,
}

/// One drop to be analysed; equal tasks have equal results.
#[derive(Clone, Debug, PartialEq)]
pub struct DropTask {
    candidate: DropCandidate,
    options: Options,
}

/// A drop before it is analysed.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct DropCandidate {
    /// Its impacts, in order of time.
    pub impacts: Vec<Impact>,
    /// Probability that it is a drop; 1 if it was marked by hand.
    pub probability: f64,
}

impl Plan {
    /// The plan for what was detected in sound.
    pub fn of_detection(detection: Detection, options: &Options) -> Self {
        let source = Source::Sound {
            format: None,
            sample_rate_hz: detection.sample_rate_hz,
            channels: detection.channels,
            channel: detection.channel + 1,
            duration_s: detection.duration_s,
            onsets: detection.onsets,
        };
        let trains = &detection.found.trains;
        let mut recording = Recording {
            strongest_band: strongest_band(&detection),
            no_drop: detection.no_drop(),
            diagnostics: detection.diagnostics(),
            ..Recording::of(source)
        };
        if trains.len() > MAX_DROPS {
            let left_out = Diagnostic::new(Code::TooManyDrops)
                .with("drops", trains.len())
                .with("most", MAX_DROPS)
                .with("end_s", trains[MAX_DROPS - 1].end_s());
            recording.diagnostics.push(left_out);
        }
        let trains = trains.iter().take(MAX_DROPS);
        let mut candidates: Vec<DropCandidate> = trains
            .map(|train| DropCandidate::detected(train, &detection.envelope))
            .collect();
        candidates.retain(|candidate| {
            let veto = listed::veto(&candidate.impacts);
            let is_drop = veto.is_none();
            recording.no_drop = veto.or(recording.no_drop.take());
            is_drop
        });
        let offered = detection.found.candidates.iter();
        recording.candidates = offered
            .map(|train| DropCandidate::detected(train, &detection.envelope))
            .collect();
        let mut plan = Self::new(recording, candidates, options);
        plan.recording.envelope = Some(detection.envelope);
        plan
    }

    /// The plan for a list of impact times in seconds, in increasing order.
    pub fn of_times(times_s: &[f64], options: &Options) -> Self {
        Self::of_list(times_s, ListOrigin::default(), options)
    }

    /// The same for a list of known origin.
    pub fn of_list(times_s: &[f64], origin: ListOrigin, options: &Options) -> Self {
        let no_drop = listed::refusal(times_s);
        let is_drop = no_drop.is_none();
        let candidates = is_drop.then(|| DropCandidate::of_times(times_s));
        let recording = Recording {
            no_drop,
            diagnostics: origin.diagnostics().collect(),
            ..Recording::of(Source::Times(origin))
        };
        Self::new(recording, candidates.into_iter().collect(), options)
    }

    /// The same for the sound of a file: with the name of its format, and with the diagnostics of the file before those of
    /// the sound.
    ///
    /// ```
    /// use bouncelab::analysis::{Plan, Source};
    /// use bouncelab::{Detector, Options};
    ///
    /// let silence = Detector::new(48_000, 1).finish();
    /// let plan = Plan::of_detection(silence, &Options::default()).of_file("WAV", []);
    /// let Source::Sound { format, .. } = plan.run().source else { panic!("a list of times") };
    /// assert_eq!(format.as_deref(), Some("WAV"));
    /// ```
    #[must_use]
    pub fn of_file(
        mut self,
        format: &str,
        diagnostics: impl IntoIterator<Item = Diagnostic>,
    ) -> Self {
        self.recording.source = self.recording.source.with_format(format);
        self.recording.diagnostics.splice(0..0, diagnostics);
        self
    }

    /// The plan for drops that were detected before, or edited by hand.
    pub fn of_candidates(
        source: Source,
        candidates: Vec<DropCandidate>,
        options: &Options,
    ) -> Self {
        Self::new(Recording::of(source), candidates, options)
    }

    fn new(
        mut recording: Recording,
        mut candidates: Vec<DropCandidate>,
        options: &Options,
    ) -> Self {
        for &number in &options.edits.accept {
            match recording.candidates.get(number.wrapping_sub(1)) {
                Some(accepted) => candidates.push(accepted.clone()),
                None => recording.diagnostics.push(
                    Diagnostic::new(Code::NoCandidate)
                        .with("number", number)
                        .with("count", recording.candidates.len()),
                ),
            }
        }
        sort_by_number(&mut candidates, DropCandidate::start_s);
        recording
            .diagnostics
            .extend(apply(&options.edits, &mut candidates));
        for candidate in &mut candidates {
            let lost = gap::cut(&mut candidate.impacts, &options.edits.gaps);
            recording.diagnostics.extend(lost);
        }
        candidates.retain(|candidate| candidate.impacts.len() >= 2);
        recording.no_drop = candidates.is_empty().then(|| {
            let known = recording.no_drop.take();
            known.unwrap_or_else(|| Diagnostic::new(Code::NothingLeft))
        });
        let offered = (1..).zip(&recording.candidates);
        let offered = offered.filter(|(number, _)| !options.edits.accept.contains(number));
        recording
            .diagnostics
            .extend(offered.map(|(number, candidate)| {
                Diagnostic::new(Code::PossibleDrop)
                    .with("number", number)
                    .with("start_s", candidate.start_s())
                    .with("impacts", candidate.impacts.len())
                    .with("probability", candidate.probability)
            }));
        let starts_s: Vec<f64> = candidates.iter().map(DropCandidate::start_s).collect();
        let tasks = candidates.into_iter().map(|candidate| DropTask {
            options: options.for_drop(candidate.start_s(), &starts_s),
            candidate,
        });
        Self {
            tasks: tasks.collect(),
            options: options.clone(),
            recording,
        }
    }

    /// The drops to analyse, in order of time.
    pub fn tasks(&self) -> &[DropTask] {
        &self.tasks
    }

    /// The result, with the drops of [`Self::tasks`] in their order.
    pub fn finish(mut self, drops: Vec<Drop>) -> Recording {
        let starts_s: Vec<f64> = self
            .tasks
            .iter()
            .map(|task| task.candidate.start_s())
            .collect();
        let diagnostics = &mut self.recording.diagnostics;
        let height_m = self.options.priors.drop_height_m.map(|height| height.value);
        diagnostics.extend(height_m.and_then(|height_m| {
            let mut drops = drops.iter();
            drops.find_map(|drop| height_of_another_unit(height_m, drop))
        }));
        diagnostics.extend(self.options.release_without_drop(&starts_s));
        self.recording.drops = drops;
        self.recording
    }

    /// Analyses all drops, one after the other.
    pub fn run(self) -> Recording {
        let drops = self.tasks.iter().map(DropTask::run).collect();
        self.finish(drops)
    }
}

impl DropTask {
    /// The impacts that go into it.
    pub fn impacts(&self) -> &[Impact] {
        &self.candidate.impacts
    }

    /// Analyses the drop.
    pub fn run(&self) -> Drop {
        let drop = analyze_impacts(self.candidate.impacts.clone(), &self.options);
        Drop {
            probability: self.candidate.probability,
            ..drop
        }
    }
}

impl DropCandidate {
    /// A list of times is certainly a drop.
    fn of_times(times_s: &[f64]) -> Self {
        Self {
            impacts: impacts_of_times(times_s),
            probability: 1.0,
        }
    }

    fn detected(train: &Train, envelope: &Envelope) -> Self {
        let mut impacts: Vec<Impact> = train.impacts().iter().map(Impact::from).collect();
        impacts[0].quiet_before_s = Some(envelope.quiet_before_s(train.start_s()));
        impacts[0].ln_alike = Some(train.ln_alike());
        impacts[0].time_sd_s = sd_at_start_s(&impacts[0]).or(impacts[0].time_sd_s);
        Self {
            impacts,
            probability: train.probability(),
        }
    }

    fn start_s(&self) -> f64 {
        let first = self.impacts.first();
        first.map_or(f64::INFINITY, |impact| impact.time_s)
    }

    /// How far a time is from it: 0 within it.
    fn distance_s(&self, time_s: f64) -> f64 {
        match (self.impacts.first(), self.impacts.last()) {
            (Some(first), Some(last)) => (first.time_s - time_s).max(time_s - last.time_s).max(0.0),
            _ => f64::INFINITY,
        }
    }
}

/// The uncertainty of the time of an impact with which the recording begins: some of its sound is missing, so that neither its
/// beginning nor the silence before it was seen. `None` for any other impact.
fn sd_at_start_s(impact: &Impact) -> Option<f64> {
    /// Sound before an impact from which its beginning is found, s.
    const NEEDED_S: f64 = 0.01;
    /// How much of the sound before its largest part may be missing, s.
    const MISSING_S: f64 = 0.001;
    (impact.time_s < NEEDED_S).then(|| {
        let latest_s = impact.time_s.max(MISSING_S);
        impact.time_sd_s.map_or(latest_s, |sd_s| sd_s.max(latest_s))
    })
}

fn strongest_band(detection: &Detection) -> Option<StrongestBand> {
    let (band, above_background_db) = detection.strongest_band()?;
    let band_hz = onset::bands_hz(detection.sample_rate_hz).get(band)?.clone();
    Some(StrongestBand {
        low_hz: band_hz.start,
        high_hz: band_hz.end,
        above_background_db,
    })
}

/// Excludes and includes impacts at these times, each in the drop that contains it or is nearest to it. Returns a
/// diagnostic for each time without one.
fn apply(edits: &Edits, drops: &mut Vec<DropCandidate>) -> Vec<Diagnostic> {
    /// An impact farther than this from a drop, in seconds, does not belong to it.
    const REACH_S: f64 = 2.0;
    let mut include_s = edits.include_s.clone();
    let mut exclude_s = edits.exclude_s.clone();
    if include_s.is_empty() && exclude_s.is_empty() {
        return Vec::new();
    }
    let mut added_s = vec![Vec::new(); drops.len()];
    include_s.retain(|&time_s| {
        let near =
            nearest(drops, time_s).filter(|&index| drops[index].distance_s(time_s) <= REACH_S);
        near.map(|index| added_s[index].push(time_s)).is_none()
    });
    for (drop, added_s) in drops.iter_mut().zip(added_s) {
        (drop.impacts, exclude_s) = edit(&drop.impacts, &exclude_s, &added_s);
    }
    let nothing = exclude_s
        .into_iter()
        .map(|time_s| Diagnostic::new(Code::NothingToExclude).with("time_s", time_s));
    let mut diagnostics: Vec<Diagnostic> = nothing.collect();
    if include_s.len() >= MIN_IMPACTS - 2 {
        include_s.sort_unstable_by(f64::total_cmp);
        drops.push(DropCandidate::of_times(&include_s));
        sort_by_number(drops, DropCandidate::start_s);
    } else {
        diagnostics.extend(include_s.into_iter().map(|time_s| {
            let too_far = Diagnostic::new(Code::TooFarToInclude);
            too_far.with("time_s", time_s).with("reach_s", REACH_S)
        }));
    }
    diagnostics
}

/// The index of the drop that is nearest to a time.
fn nearest(drops: &[DropCandidate], time_s: f64) -> Option<usize> {
    let distance_s = |index: usize| drops[index].distance_s(time_s);
    (0..drops.len()).min_by(|&a, &b| distance_s(a).total_cmp(&distance_s(b)))
}

/// A warning, if the stated height is far from that from which the ball was detected to fall, but
/// would fit in another unit or with its point elsewhere.
///
/// The inference would explain such a height by many missed impacts at the beginning.
fn height_of_another_unit(stated_m: f64, drop: &Drop) -> Option<Diagnostic> {
    /// Factors of a wrong unit or decimal point.
    const SLIPS: [f64; 6] = [10.0, 100.0, 1000.0, 0.1, 0.01, 0.001];
    /// Maximum ratio of a stated height to the detected one.
    const ROUGH: f64 = 1.15;
    let detected_m = detected_fall_m(drop)?;
    let off = |height_m: f64| (height_m / detected_m).ln().abs();
    let meant_m = SLIPS
        .into_iter()
        .map(|slip| stated_m / slip)
        .find(|&meant_m| off(meant_m) < ROUGH.ln())?;
    Some(
        Diagnostic::new(Code::HeightOfAnotherUnit)
            .with("stated_m", stated_m)
            .with("detected_m", detected_m)
            .with("meant_m", meant_m),
    )
}

/// Rough height before the first impact: the first apex divided by the share of the energy that an impact keeps.
fn detected_fall_m(drop: &Drop) -> Option<f64> {
    let first = drop.per_impact.as_ref().ok()?.flights.first()?;
    let kept = drop.per_impact_restitution()?.value.powi(2);
    Some(first.flight.apex_m / kept)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::inference::{InferenceOptions, Measured, SamplerConfig};

    fn candidates(times_s: &[&[f64]]) -> Vec<DropCandidate> {
        let candidates = times_s.iter().map(|times_s| DropCandidate {
            probability: 0.8,
            ..DropCandidate::of_times(times_s)
        });
        candidates.collect()
    }

    fn edits(exclude_s: &[f64], include_s: &[f64]) -> Edits {
        Edits {
            accept: Vec::new(),
            exclude_s: exclude_s.to_vec(),
            include_s: include_s.to_vec(),
            gaps: Vec::new(),
        }
    }

    /// Start and probability of each drop after this edit of one that begins at 5 s, with
    /// probability 0.8.
    fn edited(exclude_s: &[f64], include_s: &[f64]) -> Vec<(f64, f64)> {
        let mut drops = candidates(&[&[5.0, 5.5, 5.9]]);
        apply(&edits(exclude_s, include_s), &mut drops);
        drops.iter().map(|d| (d.start_s(), d.probability)).collect()
    }

    #[test]
    fn a_drop_added_by_hand_keeps_its_own_probability() {
        let (detected, added) = ((5.0, 0.8), (1.0, 1.0));
        assert_eq!(edited(&[], &[1.0, 1.5, 1.9]), [added, detected]);
        let added = (9.0, 1.0);
        assert_eq!(edited(&[], &[9.0, 9.5, 9.9]), [detected, added]);
    }

    #[test]
    fn an_impact_goes_to_the_nearest_of_two_drops() {
        let mut drops = candidates(&[&[5.0, 5.5, 5.9], &[7.0, 7.5, 7.9]]);
        assert!(apply(&edits(&[], &[6.9, 6.0]), &mut drops).is_empty());
        let starts_s: Vec<f64> = drops.iter().map(DropCandidate::start_s).collect();
        assert_eq!(starts_s, [5.0, 6.9]);
    }

    #[test]
    fn a_drop_without_impacts_is_left_alone() {
        let nothing = (f64::INFINITY, 0.8);
        let all = [5.0, 5.5, 5.9];
        assert_eq!(edited(&all, &[]), [nothing]);
        assert_eq!(edited(&all, &[9.0, 9.5, 9.9]), [(9.0, 1.0), nothing]);
    }

    #[test]
    fn a_list_of_more_impacts_than_a_drop_has_is_refused() {
        let of_length = |count: u32| {
            // The sums of flights that fall by a fiftieth each.
            let sum_s = |number: u32| (1.0 - 0.98_f64.powf(f64::from(number))) / 0.02;
            let times_s: Vec<f64> = (0..count).map(sum_s).collect();
            let plan = Plan::of_times(&times_s, &Options::default());
            (
                plan.tasks.len(),
                plan.recording.no_drop.map(|reason| reason.code),
            )
        };
        assert_eq!(of_length(500), (1, None));
        assert_eq!(of_length(501), (0, Some(Code::TooManyTimes)));
        assert_eq!(of_length(1_000_000), (0, Some(Code::TooManyTimes)));
    }

    /// What sounds like impacts of one ball and beats like music: 40 beats whose rate wanders, and flights that grow.
    #[test]
    fn a_train_whose_flights_do_not_fall_is_no_drop() {
        let drop: Vec<f64> = (0..40).map(|n| 0.5 * 0.9_f64.powi(n)).collect();
        let music = (0..40).map(|n| 1.22 + 0.1 * f64::from(n).sin()).collect();
        let growing = (0..8).map(|n| 0.3 * 1.08_f64.powi(n)).collect();
        for (flights_s, is_drop) in [(drop, true), (music, false), (growing, false)] {
            let mut time_s = 1.0;
            let times_s: Vec<f64> = std::iter::once(time_s)
                .chain(flights_s.iter().map(|flight_s: &f64| {
                    time_s += flight_s;
                    time_s
                }))
                .collect();
            let [candidate] = &mut candidates(&[&times_s])[..] else {
                panic!("one drop")
            };
            for (number, impact) in candidate.impacts.iter_mut().enumerate() {
                impact.number = number;
            }
            let veto = listed::veto(&candidate.impacts).map(|reason| reason.code);
            assert_eq!(veto, (!is_drop).then_some(Code::PeriodicSounds));
        }
    }

    /// Of drops that begin at 0 s and 10 s, whether each uses a release at this time (it shows
    /// whether impacts were missed before the first one), and the codes of the diagnostics.
    fn released_at(release_s: f64) -> (Vec<bool>, Vec<Code>) {
        let first = [0.0, 0.45, 0.86, 1.23, 1.57];
        let second = first.map(|time_s| 10.0 + time_s);
        let mut options = Options::default();
        options.priors.release_s = Some(Measured {
            value: release_s,
            sd: 0.005,
        });
        options.inference = Some(InferenceOptions {
            sampler: SamplerConfig {
                draws: 100,
                seed: 1,
            },
            ..InferenceOptions::default()
        });
        let recording = Plan::of_times(&[], &options).recording;
        let drops = candidates(&[&first, &second]);
        let result = Plan::new(recording, drops, &options).run();
        let uses = result.drops.iter().map(|drop| {
            let posterior = drop.posterior.as_ref().unwrap();
            posterior.missed_first_impacts.is_some()
        });
        let codes = result.diagnostics.iter().map(|known| known.code);
        (uses.collect(), codes.collect())
    }

    #[test]
    fn a_release_is_of_the_drop_that_begins_next() {
        assert_eq!(released_at(9.75), (vec![false, true], Vec::new()));
        assert_eq!(released_at(-0.25), (vec![true, false], Vec::new()));
    }

    #[test]
    fn a_release_after_every_drop_is_of_none_and_is_reported() {
        let expected = (vec![false, false], vec![Code::ReleaseWithoutDrop]);
        assert_eq!(released_at(20.0), expected);
    }
}
