//! The envelope of a recording.

use super::parameters::{MAX_STEPS, MIN_STEP_SAMPLES, PEAK_S, QUIET_SHARE, SOON_S};

/// Minimum and maximum sample in equal steps of time: a picture of a recording of any length, in
/// constant memory.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Envelope {
    sample_rate_hz: f64,
    samples_per_step: usize,
    min: Vec<f32>,
    max: Vec<f32>,
    /// Samples in the last step.
    in_step: usize,
}

impl Envelope {
    pub(super) fn new(sample_rate_hz: u32) -> Self {
        Self {
            sample_rate_hz: f64::from(sample_rate_hz),
            samples_per_step: MIN_STEP_SAMPLES,
            min: Vec::new(),
            max: Vec::new(),
            in_step: MIN_STEP_SAMPLES,
        }
    }

    /// An envelope from the minimum and maximum sample of each step; if one list is longer, its excess is
    /// dropped.
    pub fn of_steps(step_s: f64, mut min: Vec<f32>, mut max: Vec<f32>) -> Self {
        let steps = min.len().min(max.len());
        min.truncate(steps);
        max.truncate(steps);
        Self {
            sample_rate_hz: 1.0 / step_s,
            samples_per_step: 1,
            min,
            max,
            in_step: 1,
        }
    }

    /// Duration of a step, s.
    pub fn step_s(&self) -> f64 {
        self.samples_per_step as f64 / self.sample_rate_hz
    }

    /// The minimum sample of each step.
    pub fn min(&self) -> &[f32] {
        &self.min
    }

    /// The maximum sample of each step.
    pub fn max(&self) -> &[f32] {
        &self.max
    }

    /// Whether all samples have the same value: silence, or a dead microphone.
    pub fn is_constant(&self) -> bool {
        let min = self.min.iter().copied().fold(f32::INFINITY, f32::min);
        let max = self.max.iter().copied().fold(f32::NEG_INFINITY, f32::max);
        max <= min
    }

    /// For how long before an impact at this time nothing was nearly as loud, s; at most since the recording began.
    pub(crate) fn quiet_before_s(&self, time_s: f64) -> f64 {
        let step_s = self.step_s();
        let step_of = |time_s: f64| ((time_s / step_s).max(0.0) as usize).min(self.min.len());
        // A recorder may add a constant.
        let middles = self
            .min
            .iter()
            .zip(&self.max)
            .map(|(min, max)| 0.5 * f64::from(min + max));
        let centre = (middles.sum::<f64>() / self.min.len() as f64) as f32;
        let amplitude = |step: usize| greater(self.max[step] - centre, centre - self.min[step]);
        let impact = step_of(time_s)..self.min.len().min(step_of(time_s + PEAK_S) + 1);
        let loudest = impact.map(amplitude).fold(0.0, greater);
        let is_loud = |step: &usize| amplitude(*step) >= QUIET_SHARE * loudest;
        let loud = (0..step_of(time_s - SOON_S)).rfind(is_loud);
        time_s - loud.map_or(0.0, |step| (step + 1) as f64 * step_s)
    }

    /// Takes the next samples; returns their extremes.
    pub(super) fn push(&mut self, samples: &[f32]) -> Extremes {
        // The first samples complete the last step.
        let missing = self.samples_per_step - self.in_step;
        let (completing, mut rest) = samples.split_at(missing.min(samples.len()));
        let mut all = Extremes::of(completing);
        if let (Some(min), Some(max)) = (self.min.last_mut(), self.max.last_mut()) {
            *min = lesser(all.min, *min);
            *max = greater(all.max, *max);
        }
        self.in_step += completing.len();
        while !rest.is_empty() {
            if self.min.len() == MAX_STEPS {
                self.halve();
            }
            let (step, later) = rest.split_at(self.samples_per_step.min(rest.len()));
            let extremes = Extremes::of(step);
            all = all.with(extremes);
            self.min.push(extremes.min);
            self.max.push(extremes.max);
            self.in_step = step.len();
            rest = later;
        }
        all
    }

    fn halve(&mut self) {
        keep_of_pairs(&mut self.min, lesser);
        keep_of_pairs(&mut self.max, greater);
        self.samples_per_step *= 2;
    }
}

/// Minimum and maximum of some samples.
#[derive(Clone, Copy)]
pub(super) struct Extremes {
    min: f32,
    max: f32,
}

impl Extremes {
    /// Of these samples.
    fn of(samples: &[f32]) -> Self {
        Self {
            min: extreme(samples, lesser),
            max: extreme(samples, greater),
        }
    }

    fn with(self, other: Self) -> Self {
        Self {
            min: lesser(other.min, self.min),
            max: greater(other.max, self.max),
        }
    }

    /// The maximum distance from 0.
    pub(super) fn size(self) -> f32 {
        self.max.max(-self.min)
    }
}

/// The most extreme of these samples, in lanes that fill wide registers; infinite without samples.
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

/// Keeps one of each pair of these values, whose number is even.
fn keep_of_pairs(values: &mut Vec<f32>, pick: impl Fn(f32, f32) -> f32) {
    for pair in 0..values.len() / 2 {
        values[pair] = pick(values[2 * pair], values[2 * pair + 1]);
    }
    values.truncate(values.len() / 2);
}

/// Faster than `f32::min`, which takes care of NaN: one instruction.
fn lesser(a: f32, b: f32) -> f32 {
    if a < b { a } else { b }
}

/// Faster than `f32::max`, as [`lesser`].
fn greater(a: f32, b: f32) -> f32 {
    if a > b { a } else { b }
}
