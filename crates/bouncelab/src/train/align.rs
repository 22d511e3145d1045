//! Times below a sample, from what the impacts of one drop have in common.
//!
//! The impacts of a drop sound alike. Their waveforms, whitened, are laid over each other by the
//! picked times and stacked; each is then shifted to where it fits the stack of the others best.
//! This uses the whole of each sound where a pick uses its first fraction of a millisecond, and
//! does not depend on loudness. What a shift leaves unexplained gives its standard error, as the
//! Cramer-Rao bound for the arrival time of a known waveform in noise:
//! var(t) = var(noise) / sum (a s'(t))^2.

use super::HeardImpact;
use crate::whiten::{self, Autoregression};
use std::f64::consts::PI;

/// What is compared of each impact, in seconds before and after its time.
const BEFORE_S: f64 = 0.0005;
const AFTER_S: f64 = 0.0025;
/// The noise before an impact from which the whitening is learnt, in seconds.
const NOISE_S: f64 = 0.010;
/// The farthest an impact is shifted, in seconds, and in standard errors of its pick.
const FARTHEST_S: f64 = 0.006;
/// A pick may be surer of itself than it should be, in the ringing of the impact before: every
/// impact is sought at least so far around its pick, in seconds.
const NEAREST_S: f64 = 0.003;
const FARTHEST_SIGMA: f64 = 6.0;
/// An impact that shares less than this with the others keeps its pick.
const LEAST_CORRELATION: f64 = 0.6;
/// Times settle to well below their errors in so many rounds.
const ROUNDS: usize = 3;
/// Impacts of one drop differ a little, which no residual shows: a standard error in samples that
/// is added to that of the fit. Measured on synthetic impacts whose modes scatter by 0.1 radian.
const LEAST_SIGMA: f64 = 0.05;
/// Half the length of the interpolation kernel in samples.
const KERNEL: usize = 8;

/// Moves the times of these impacts to where their waveforms agree, and says which of them agree.
/// `samples` begin at `start_s` of the recording; impacts too near their ends keep their times.
pub(super) fn align(
    impacts: &mut [HeardImpact],
    samples: &[f32],
    start_s: f64,
    rate_hz: f64,
) -> Vec<bool> {
    let mut agrees = vec![false; impacts.len()];
    let span = Span::new(rate_hz);
    let mut sounds = whitened_sounds(impacts, samples, start_s, rate_hz, &span);
    // With fewer there is no stack of others to speak of.
    if sounds.len() < 3 {
        return agrees;
    }
    for _ in 0..ROUNDS {
        let waves: Vec<Vec<f64>> = sounds.iter().map(|s| s.wave(&span, s.shift)).collect();
        let stack = stack(&waves);
        for (sound, wave) in sounds.iter_mut().zip(&waves) {
            sound.fit(wave, &stack, &span);
        }
        keep_mean(&mut sounds);
    }
    for sound in &sounds {
        if let Some(sigma) = sound.sigma {
            let onset = &mut impacts[sound.impact].onset;
            onset.time_s += sound.shift / rate_hz;
            onset.sigma_s = sigma / rate_hz;
            agrees[sound.impact] = true;
        }
    }
    agrees
}

/// Lengths in samples at one rate.
struct Span {
    /// The picked time lies so far inside the samples of a sound.
    origin: usize,
    before: usize,
    length: usize,
    nearest: f64,
    farthest: f64,
    noise: usize,
}

impl Span {
    fn new(rate_hz: f64) -> Self {
        let samples = |time_s: f64| (time_s * rate_hz).ceil() as usize;
        let before = samples(BEFORE_S);
        let farthest = samples(FARTHEST_S).max(2);
        Self {
            origin: before + farthest + KERNEL,
            before,
            length: before + samples(AFTER_S),
            nearest: samples(NEAREST_S).max(2) as f64,
            farthest: farthest as f64,
            noise: samples(NOISE_S).max(4 * whiten::ORDER),
        }
    }

    /// Samples of a sound after its origin.
    fn after(&self) -> usize {
        self.length - self.before + self.farthest as usize + KERNEL + 1
    }
}

/// The whitened surroundings of one impact.
struct Sound {
    impact: usize,
    /// Samples on a grid that has the picked time at its origin.
    samples: Vec<f64>,
    /// How far the impact may be from its pick, in samples.
    reach: usize,
    /// Standard error of the pick in samples.
    pick_sigma: f64,
    /// Where the impact begins, in samples after its pick.
    shift: f64,
    /// Standard error of the shift in samples; `None` while it does not fit the others.
    sigma: Option<f64>,
}

fn whitened_sounds(
    impacts: &[HeardImpact],
    samples: &[f32],
    start_s: f64,
    rate_hz: f64,
    span: &Span,
) -> Vec<Sound> {
    let cuts: Vec<(usize, f64)> = impacts
        .iter()
        .enumerate()
        .map(|(impact, heard)| (impact, (heard.onset.time_s - start_s) * rate_hz))
        .filter(|&(_, at)| {
            at >= (span.origin + span.noise) as f64
                && at as usize + span.after() + KERNEL < samples.len()
        })
        .collect();
    let begin = |at: f64| at as usize - span.origin;
    let noises = cuts
        .iter()
        .map(|&(_, at)| &samples[begin(at) - span.noise..begin(at)]);
    let model = Autoregression::learn_from_many(noises);
    cuts.iter()
        .map(|&(impact, at)| {
            let first = begin(at) - whiten::ORDER;
            let end = at as usize + span.after() + KERNEL;
            let errors: Vec<f64> = model.errors(&samples[first..end]).collect();
            let fraction = at - at.floor();
            let pick_sigma = impacts[impact].onset.sigma_s * rate_hz;
            Sound {
                impact,
                samples: resample(&errors, fraction, span.origin + span.after()),
                reach: (FARTHEST_SIGMA * pick_sigma)
                    .clamp(span.nearest, span.farthest)
                    .ceil() as usize,
                pick_sigma,
                shift: 0.0,
                sigma: None,
            }
        })
        .collect()
}

impl Sound {
    /// The waveform that begins this many samples after the pick.
    fn wave(&self, span: &Span, shift: f64) -> Vec<f64> {
        let first = (span.origin - span.before) as f64 + shift;
        resample(&self.samples, first, span.length)
    }

    /// Finds the shift at which the sound fits the stack of the others.
    fn fit(&mut self, wave: &[f64], stack: &[f64], span: &Span) {
        let own = 1.0 / norm(wave).max(f64::MIN_POSITIVE);
        let others: Vec<f64> = stack.iter().zip(wave).map(|(s, w)| s - w * own).collect();
        self.shift = 0.0;
        self.sigma = None;
        if let Some(shift) = self.best_shift(&others, span) {
            self.shift = shift;
            self.sigma = Some(shift_error(&self.wave(span, shift), &others));
        }
    }

    /// The highest correlation at whole samples, and a parabola through it.
    fn best_shift(&self, others: &[f64], span: &Span) -> Option<f64> {
        let first = span.origin - span.before - self.reach;
        let scale = norm(others);
        let fits: Vec<f64> = (0..=2 * self.reach)
            .map(|lag| {
                let wave = &self.samples[first + lag..first + lag + span.length];
                dot(wave, others) / (norm(wave) * scale)
            })
            .collect();
        let best = (1..fits.len() - 1)
            .filter(|&i| fits[i] > LEAST_CORRELATION)
            .filter(|&i| fits[i] >= fits[i - 1] && fits[i] > fits[i + 1])
            .max_by(|&a, &b| fits[a].total_cmp(&fits[b]))?;
        let (left, right) = (fits[best - 1], fits[best + 1]);
        let vertex = 0.5 * (left - right) / (left - 2.0 * fits[best] + right);
        Some(best as f64 - self.reach as f64 + vertex)
    }
}

/// Only differences of time have a meaning: the stack as a whole stays where the picks are.
fn keep_mean(sounds: &mut [Sound]) {
    let (mut weights, mut sum) = (0.0, 0.0);
    for sound in sounds.iter().filter(|s| s.sigma.is_some()) {
        let weight = sound.pick_sigma.powi(-2);
        weights += weight;
        sum += weight * sound.shift;
    }
    if weights > 0.0 {
        for sound in sounds.iter_mut().filter(|s| s.sigma.is_some()) {
            sound.shift -= sum / weights;
        }
    }
}

/// The sum of the waves, each at unit energy.
fn stack(waves: &[Vec<f64>]) -> Vec<f64> {
    let mut stack = vec![0.0; waves[0].len()];
    for wave in waves {
        let scale = 1.0 / norm(wave).max(f64::MIN_POSITIVE);
        for (sum, value) in stack.iter_mut().zip(wave) {
            *sum += value * scale;
        }
    }
    stack
}

/// Standard error of the shift of a wave against a template, in samples.
fn shift_error(wave: &[f64], template: &[f64]) -> f64 {
    let amplitude = dot(wave, template) / dot(template, template);
    let residual: f64 = wave
        .iter()
        .zip(template)
        .map(|(w, t)| (w - amplitude * t).powi(2))
        .sum();
    let slope: f64 = template
        .windows(3)
        .map(|t| (amplitude * (t[2] - t[0]) / 2.0).powi(2))
        .sum();
    let noise = residual / (wave.len() - 2) as f64;
    (noise / slope).sqrt().hypot(LEAST_SIGMA)
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(x, y)| x * y).sum()
}

fn norm(a: &[f64]) -> f64 {
    dot(a, a).sqrt()
}

/// So many values from a position between samples on, by a windowed sinc.
fn resample(samples: &[f64], position: f64, length: usize) -> Vec<f64> {
    let whole = position as usize;
    let kernel = kernel(position - whole as f64);
    // The first weight belongs to this sample; before the beginning and after the end is silence.
    let first = (whole + 1).saturating_sub(KERNEL);
    let skipped = (KERNEL - 1).saturating_sub(whole);
    (0..length)
        .map(|n| {
            let skipped = skipped.saturating_sub(n);
            let start = (whole + n + 1).saturating_sub(KERNEL).max(first);
            let taps = samples.get(start..).unwrap_or_default();
            kernel[skipped..]
                .iter()
                .zip(taps)
                .map(|(weight, sample)| weight * sample)
                .sum()
        })
        .collect()
}

/// The weights of the samples around a position this fraction after one of them.
fn kernel(fraction: f64) -> [f64; 2 * KERNEL] {
    std::array::from_fn(|tap| {
        let x = (tap + 1) as f64 - KERNEL as f64 - fraction;
        if x == 0.0 {
            return 1.0;
        }
        let window = 0.5 + 0.5 * (PI * x / KERNEL as f64).cos();
        window * (PI * x).sin() / (PI * x)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn interpolation_is_that_of_a_band_limited_signal() {
        let tone: Vec<f64> = (0..200).map(|n| (0.9 * f64::from(n)).sin()).collect();
        for position in [100.0, 100.25, 100.5, 101.9] {
            let error = resample(&tone, position, 1)[0] - (0.9 * position).sin();
            assert!(error.abs() < 2e-3, "{position}: {error}");
        }
    }
}
