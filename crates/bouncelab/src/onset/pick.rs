//! The time at which a sound begins, to a fraction of a sample.
//!
//! The signal is whitened by a prediction learnt before it, which removes hum, rumble and the ringing of
//! the impact before. An impact is the moment at which the prediction error grows: for a change of variance at sample k of N the negative
//! logarithm of the likelihood is k/2 ln var(before) + (N - k)/2 ln var(after), the AIC function of
//! seismology (Maeda 1985; with autoregression, Leonard & Kennett 1999). Its exponential is the
//! posterior of k: its mean is the time, below a sample, and its width the standard error.

use super::parameters::{
    LEARN_S, MAX_NATS, MIN_PRECURSOR_RATIO, MIN_PRECURSOR_S, MIN_VARIANCE_SAMPLES, PICK_AFTER_S,
    PICK_BEFORE_S,
};
use crate::whiten::{Autoregression, ORDER};

/// A time in samples, and its standard error.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pick {
    /// A sample of the buffer, counted from its start.
    pub(super) sample: usize,
    /// Samples after it, kept separate so that the number of the sample in a long stream does not round it.
    pub(super) after: f64,
    /// Standard error in samples.
    pub(super) sigma: f64,
}

/// Picks onsets; holds the sizes for one sample rate and scratch space.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Picker {
    learn: usize,
    before: usize,
    after: usize,
    precursor: usize,
    error_energy: Vec<f64>,
    score: Vec<f32>,
}

impl Picker {
    pub(super) fn new(sample_rate_hz: f64) -> Self {
        let samples = |time_s: f64, min: usize| ((time_s * sample_rate_hz) as usize).max(min);
        let shortest = 2 * MIN_VARIANCE_SAMPLES;
        Self {
            learn: samples(LEARN_S, 4 * ORDER),
            before: samples(PICK_BEFORE_S, shortest),
            after: samples(PICK_AFTER_S, shortest),
            precursor: samples(MIN_PRECURSOR_S, shortest),
            error_energy: Vec::new(),
            score: Vec::new(),
        }
    }

    /// Number of samples before the rough time that the picker needs.
    pub(super) fn history(&self) -> usize {
        self.learn + self.before
    }

    /// Number of samples from the rough time on that the picker needs.
    pub(super) fn look_ahead(&self) -> usize {
        self.after
    }

    /// The onset near sample `rough`; `noise_power` is the minimum power of noise.
    pub(super) fn pick(&mut self, samples: &[f32], rough: usize, noise_power: f64) -> Pick {
        let end = (rough + self.after).min(samples.len());
        let start = rough.saturating_sub(self.before).max(ORDER);
        if end < start + 4 * MIN_VARIANCE_SAMPLES {
            // At the very edge of a recording only the rough time is known.
            return Pick {
                sample: rough,
                after: 0.0,
                sigma: self.after as f64 / 2.0,
            };
        }
        let model = Autoregression::learn(
            &samples[start.saturating_sub(self.learn)..start],
            noise_power,
        );
        self.error_energy.clear();
        self.error_energy.push(0.0);
        let mut sum = 0.0;
        for error in model.errors(&samples[start - ORDER..end]) {
            sum += f64::from(error).powi(2) + noise_power;
            self.error_energy.push(sum);
        }
        let pick = self.change_point(start, 0);
        if end - pick.sample < 2 * self.precursor {
            return pick;
        }
        let later = self.change_point(start, pick.sample + pick.after as usize - start);
        if self.is_precursor(start, &pick, &later) {
            later
        } else {
            pick
        }
    }

    /// Whether the sound from one change to a later one is a precursor of the much louder sound after that.
    fn is_precursor(&self, start: usize, change: &Pick, later: &Pick) -> bool {
        let end = self.error_energy.len() - 1;
        let index = |pick: &Pick| (pick.sample + pick.after as usize - start).min(end);
        let power = |from: usize, to: usize| {
            (self.error_energy[to] - self.error_energy[from]) / (to - from).max(1) as f64
        };
        let (from, to) = (index(change), index(later));
        to >= from + self.precursor && power(to, end) > MIN_PRECURSOR_RATIO * power(from, to)
    }

    /// Where the variance changes among the errors from `first` on, the first of which is that of
    /// sample `start`.
    fn change_point(&mut self, start: usize, first: usize) -> Pick {
        let energy = &self.error_energy[first..];
        let n = energy.len() - 1;
        let base = energy[0];
        let total = energy[n] - base;
        let start = start + first;
        // Of the mean variance, so that single precision suffices for the logarithms; their common constant cancels.
        let mean_energy = total / n as f64;
        let variance = |energy: f64, count: f32| (energy / mean_energy) as f32 / count;
        self.score.clear();
        // The AIC function for a change after k of n samples.
        let candidates = MIN_VARIANCE_SAMPLES..=n - MIN_VARIANCE_SAMPLES;
        self.score.extend(candidates.map(|k| {
            let before = energy[k] - base;
            let (a, b) = (k as f32, (n - k) as f32);
            0.5 * (a * ln(variance(before, a)) + b * ln(variance(total - before, b)))
        }));
        // Mean and variance of the posterior of k, which is the exponential of the negative score.
        let best = self.score.iter().copied().fold(f32::INFINITY, f32::min);
        let (mut weight, mut mean, mut square) = (0.0, 0.0, 0.0);
        for (k, score) in self.score.iter().enumerate() {
            let nats = best - score;
            if nats > -MAX_NATS {
                let w = f64::from(nats.exp());
                weight += w;
                mean += w * k as f64;
                square += w * (k * k) as f64;
            }
        }
        mean /= weight;
        // No pick is better than rounding to whole samples, whose variance is 1/12.
        let variance = (square / weight - mean * mean).max(1.0 / 12.0);
        Pick {
            sample: start + MIN_VARIANCE_SAMPLES,
            after: mean,
            sigma: variance.sqrt(),
        }
    }
}

/// The natural logarithm of a positive number to six digits, in plain arithmetic, which the compiler runs in wide
/// registers. With x = 2^k m, ln x = k ln 2 + 2 artanh((m - 1)/(m + 1)), by its series.
fn ln(x: f32) -> f32 {
    /// The mantissa lies between the square roots of 1/2 and 2.
    const MIN_MANTISSA: u32 = std::f32::consts::FRAC_1_SQRT_2.to_bits();
    let exponent = x.to_bits().wrapping_sub(MIN_MANTISSA).cast_signed() >> 23;
    let mantissa = f32::from_bits(x.to_bits().wrapping_sub((exponent << 23).cast_unsigned()));
    let t = (mantissa - 1.0) / (mantissa + 1.0);
    let t2 = t * t;
    let series = 1.0 + t2 * (1.0 / 3.0 + t2 * (1.0 / 5.0 + t2 * (1.0 / 7.0)));
    exponent as f32 * std::f32::consts::LN_2 + 2.0 * t * series
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_logarithm_is_that_of_the_library() {
        let mut x = 1e-30_f32;
        while x < 1e30 {
            assert!((ln(x) - x.ln()).abs() < 1e-6 * (1.0 + x.ln().abs()), "{x}");
            x *= 1.013;
        }
    }

    #[test]
    fn a_step_in_variance_is_found_to_the_sample() {
        // Alternating signs of a fixed pseudo-random sequence, 40 dB louder from sample 1500.
        let mut state = 1u32;
        let samples: Vec<f32> = (0..3000)
            .map(|n| {
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                let noise = f64::from(state >> 8) / f64::from(1 << 24) - 0.5;
                (noise * if n >= 1500 { 0.1 } else { 0.001 }) as f32
            })
            .collect();
        let mut picker = Picker::new(44_100.0);
        for rough in [1380, 1490, 1500, 1560] {
            let pick = picker.pick(&samples, rough, 0.0);
            assert!(
                (pick.sample as f64 + pick.after - 1500.0).abs() < 1.0,
                "{rough}: {pick:?}"
            );
            assert!(pick.sigma < 2.0);
        }
    }
}
