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

/// What is compared of each impact, in seconds before and after its time: as long as it sounds,
/// but no longer than this, lest the next one is heard in it.
const BEFORE_S: f64 = 0.0005;
const AFTER_S: f64 = 0.0025;
const MOST_AFTER_S: f64 = 0.008;
/// What sounds after that holds less than this share of the energy.
const LEAST_SHARE: f64 = 0.03;
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
/// High frequencies are smoothed away while this share of the energy of the impacts is kept.
const LEAST_KEPT: f64 = 0.9;
/// So many of the loudest impacts are asked.
const TRIED: usize = 6;
/// Impacts of one drop differ a little, and not as noise does: what they leave unexplained is like
/// so many numbers drawn at random, one or two for each mode that rings.
const FREE_DIFFERENCES: f64 = 2.0;
/// No shift is surer than this, in samples.
const LEAST_SIGMA: f64 = 0.0005;
/// After the first round an impact is sought so many samples around where it was found.
const NEAR: usize = 6;
/// Half the length of the interpolation kernel in samples.
const KERNEL: usize = 8;

/// Moves the times of these impacts to where their waveforms agree, and says which of them agree
/// and begin there.
/// `samples` begin at `start_s` of the recording; impacts too near their ends keep their times.
pub(super) fn align(
    impacts: &mut [HeardImpact],
    samples: &[f32],
    start_s: f64,
    rate_hz: f64,
) -> Vec<bool> {
    let mut agrees = vec![false; impacts.len()];
    let mut span = Span::new(rate_hz);
    let mut sounds = whitened_sounds(impacts, samples, start_s, rate_hz, &span);
    // With fewer there is no stack of others to speak of.
    if sounds.len() < 3 {
        return agrees;
    }
    let smoothed = smooth(&mut sounds, &span);
    span.length = span.before + sounding(&sounds, &span);
    for round in 0..ROUNDS {
        let waves: Vec<Vec<f32>> = sounds.iter().map(|s| s.wave(&span, s.shift)).collect();
        let middle = middle_size(&waves);
        // How much noise of one wave is in the stack.
        let noise: f32 = waves.iter().map(|w| weight(w, middle).powi(2)).sum();
        let stack = stack(&waves, middle);
        let smoothness = smoothness(&stack, &smoothed);
        for (sound, wave) in sounds.iter_mut().zip(&waves) {
            let own = weight(wave, middle);
            let others: Vec<f32> = stack.iter().zip(wave).map(|(s, w)| s - w * own).collect();
            let template = Template::new(&others, noise - own * own);
            sound.fit(&template, &span, round == 0);
            if round + 1 == ROUNDS {
                sound.settle(&template, smoothness, &span);
            }
        }
        keep_mean(&mut sounds);
    }
    for sound in sounds.iter().filter(|sound| sound.fits) {
        let onset = &mut impacts[sound.impact].onset;
        onset.time_s += sound.shift / rate_hz;
        onset.sigma_s = sound.sigma / rate_hz;
        agrees[sound.impact] = sound.begins(&span);
    }
    agrees
}

/// Lengths in samples at one rate.
struct Span {
    /// The picked time lies so far inside the samples of a sound.
    origin: usize,
    before: usize,
    length: usize,
    /// The least and the greatest length after the picked time.
    least: usize,
    most: usize,
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
            length: before + samples(MOST_AFTER_S),
            least: samples(AFTER_S),
            most: samples(MOST_AFTER_S),
            nearest: samples(NEAREST_S).max(2) as f64,
            farthest: farthest as f64,
            noise: samples(NOISE_S).max(4 * whiten::ORDER),
        }
    }

    /// Samples of a sound that lie before the impact, wherever it begins.
    fn quiet(&self) -> usize {
        self.origin - self.before - self.nearest as usize
    }

    /// Samples of a sound after its origin.
    fn after(&self) -> usize {
        self.most + self.farthest as usize + KERNEL + 1
    }
}

/// The whitened surroundings of one impact.
struct Sound {
    impact: usize,
    /// Samples on a grid that has the picked time at its origin.
    samples: Vec<f32>,
    /// Energy of the samples before each.
    energy: Vec<f64>,
    /// Power of the noise before the impact, and what it was before smoothing: its density in the
    /// band that is left.
    noise: f64,
    density: f64,
    /// How far the impact may be from its pick, in samples.
    reach: usize,
    /// Standard error of the pick in samples.
    pick_sigma: f64,
    /// Where the impact begins, in samples after its pick.
    shift: f64,
    /// Whether it fits the others.
    fits: bool,
    /// Standard error of the shift in samples, once it is settled.
    sigma: f64,
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
            let errors = model.errors(&samples[first..end]);
            let fraction = at - at.floor();
            let pick_sigma = impacts[impact].onset.sigma_s * rate_hz;
            let samples = resample(&errors, fraction, span.origin + span.after());
            let energy = running_energy(&samples);
            let noise = noise_power(&energy, span);
            Sound {
                impact,
                noise,
                density: noise,
                energy,
                samples,
                reach: (FARTHEST_SIGMA * pick_sigma)
                    .clamp(span.nearest, span.farthest)
                    .ceil() as usize,
                pick_sigma,
                shift: 0.0,
                fits: false,
                sigma: f64::INFINITY,
            }
        })
        .collect()
}

impl Sound {
    /// The waveform that begins this many samples after the pick.
    fn wave(&self, span: &Span, shift: f64) -> Vec<f32> {
        let first = (span.origin - span.before) as f64 + shift;
        resample(&self.samples, first, span.length)
    }

    /// Whether something begins here: the ringing of the impact before may look alike, but fades.
    fn begins(&self, span: &Span) -> bool {
        let length = span.origin - span.before;
        // The others may have moved it to beyond what was cut out.
        let last = self.energy.len() - 1 - length;
        let at = ((length as f64 + self.shift).max(0.0) as usize).min(last);
        let energy = |first: usize| self.energy[first + length] - self.energy[first];
        energy(at) > energy(at.saturating_sub(length))
    }

    /// Finds the shift at which the sound fits the stack of the others: anywhere, or near where
    /// it was found before.
    fn fit(&mut self, template: &Template, span: &Span, anywhere: bool) {
        let others = template.wave;
        let found = if anywhere || !self.fits {
            None
        } else {
            let near = self.shift.round() as isize;
            self.best_shift(others, span, near, NEAR)
        };
        let found = found.or_else(|| self.best_shift(others, span, 0, self.reach));
        self.fits = found.is_some();
        self.shift = found.unwrap_or(0.0);
        self.step(template, span);
    }

    /// A step of Newton's from the shift of highest correlation to that of the least misfit.
    fn step(&mut self, template: &Template, span: &Span) {
        if self.fits {
            let wave = self.wave(span, self.shift);
            self.shift += template.misfit(&wave).clamp(-0.5, 0.5);
        }
    }

    /// Settles the shift and its standard error.
    fn settle(&mut self, template: &Template, smoothness: f64, span: &Span) {
        self.step(template, span);
        let wave = self.wave(span, self.shift);
        let noise = Noise {
            power: self.noise,
            heard: span.quiet() as f64,
            alike: self.density / self.noise.max(f64::MIN_POSITIVE),
            density: self.density * smoothness,
        };
        self.sigma = template.shift_error(&wave, &noise);
    }

    /// The highest correlation at whole samples around `middle`, and a parabola through it.
    fn best_shift(&self, others: &[f32], span: &Span, middle: isize, reach: usize) -> Option<f64> {
        let reach = reach.cast_signed();
        let farthest = self.reach.cast_signed();
        let lags = (middle - reach).max(-farthest)..=(middle + reach).min(farthest);
        let first_lag = *lags.start();
        let scale = f64::from(norm(others));
        let fits: Vec<f64> = lags
            .map(|lag| {
                let first = (span.origin - span.before).saturating_add_signed(lag);
                let end = first + span.length;
                let energy = self.energy[end] - self.energy[first];
                let product = f64::from(dot(&self.samples[first..end], others));
                product / (energy.max(f64::MIN_POSITIVE).sqrt() * scale)
            })
            .collect();
        let best = (1..fits.len().saturating_sub(1))
            .filter(|&i| fits[i] > LEAST_CORRELATION)
            .filter(|&i| fits[i] >= fits[i - 1] && fits[i] > fits[i + 1])
            .max_by(|&a, &b| fits[a].total_cmp(&fits[b]))?;
        let (left, right) = (fits[best - 1], fits[best + 1]);
        let vertex = 0.5 * (left - right) / (left - 2.0 * fits[best] + right);
        Some((first_lag + best.cast_signed()) as f64 + vertex)
    }
}

/// Only differences of time have a meaning: the stack as a whole stays where the picks are.
fn keep_mean(sounds: &mut [Sound]) {
    let (mut weights, mut sum) = (0.0, 0.0);
    for sound in sounds.iter().filter(|s| s.fits) {
        let weight = sound.pick_sigma.powi(-2);
        weights += weight;
        sum += weight * sound.shift;
    }
    if weights > 0.0 {
        for sound in sounds.iter_mut().filter(|s| s.fits) {
            sound.shift -= sum / weights;
        }
    }
}

/// Power of the noise before an impact.
fn noise_power(energy: &[f64], span: &Span) -> f64 {
    energy[span.quiet()] / span.quiet() as f64
}

/// Takes out the high frequencies in which the impacts do not sound: they would drown the slope
/// of a dull thump. Returns the weights.
fn smooth(sounds: &mut [Sound], span: &Span) -> Vec<f32> {
    let loudness = |energy: &[f64], noise: f64| {
        let (first, end) = (span.origin, span.origin + span.most);
        (energy[end] - energy[first] - noise * span.most as f64).max(0.0)
    };
    let mut loudest: Vec<(f64, usize)> = (0..sounds.len())
        .map(|n| (loudness(&sounds[n].energy, sounds[n].noise), n))
        .filter(|&(loudness, _)| loudness > 0.0)
        .collect();
    loudest.sort_by(|a, b| b.0.total_cmp(&a.0));
    loudest.truncate(TRIED);
    let kept = |kernel: &[f32]| {
        let shares = loudest.iter().map(|&(before, n)| {
            let energy = running_energy(&convolve(&sounds[n].samples, kernel));
            loudness(&energy, noise_power(&energy, span)) / before
        });
        shares.sum::<f64>() / loudest.len() as f64
    };
    let mut kernels = [16, 8, 4, 2, 1].map(smoothing).into_iter();
    let Some(kernel) = kernels.find(|kernel| kept(kernel) > LEAST_KEPT) else {
        return vec![1.0];
    };
    for sound in sounds {
        sound.samples = convolve(&sound.samples, &kernel);
        sound.energy = running_energy(&sound.samples);
        sound.noise = noise_power(&sound.energy, span);
    }
    kernel
}

/// A bell of weights that reaches so far to both sides, its sum 1.
fn smoothing(reach: usize) -> Vec<f32> {
    let bell: Vec<f64> = (0..=2 * reach)
        .map(|n| 1.0 - (PI * (n + 1) as f64 / (reach + 1) as f64).cos())
        .collect();
    let sum: f64 = bell.iter().sum();
    bell.iter().map(|weight| (weight / sum) as f32).collect()
}

/// As many samples, each the weighted mean of those around it.
fn convolve(samples: &[f32], kernel: &[f32]) -> Vec<f32> {
    let reach = kernel.len() / 2;
    let mut padded = vec![0.0; samples.len() + 2 * reach];
    padded[reach..][..samples.len()].copy_from_slice(samples);
    let mut sums = vec![0.0; samples.len()];
    for (shift, weight) in kernel.iter().enumerate() {
        for (sum, sample) in sums.iter_mut().zip(&padded[shift..]) {
            *sum += weight * sample;
        }
    }
    sums
}

/// How long the impacts sound, in samples after their times.
fn sounding(sounds: &[Sound], span: &Span) -> usize {
    let energy_in = |sound: &Sound, first: usize, length: usize| {
        let first = span.origin + first;
        let noise = sound.noise * length as f64;
        (sound.energy[first + length] - sound.energy[first] - noise).max(0.0)
    };
    let share_after = |after: usize| {
        let shares = sounds.iter().filter_map(|sound| {
            let all = energy_in(sound, 0, span.most);
            (all > 0.0).then(|| energy_in(sound, after, span.most - after) / all)
        });
        let shares: Vec<f64> = shares.collect();
        shares.iter().sum::<f64>() / shares.len().max(1) as f64
    };
    (span.least..span.most)
        .step_by(span.least / 4 + 1)
        .find(|&after| share_after(after) < LEAST_SHARE)
        .unwrap_or(span.most)
}

fn middle_size(waves: &[Vec<f32>]) -> f32 {
    let mut sizes: Vec<f32> = waves.iter().map(|wave| norm(wave)).collect();
    sizes.sort_by(f32::total_cmp);
    sizes[sizes.len() / 2]
}

/// The weight of a wave in a stack of waves of this middle size.
fn weight(wave: &[f32], middle: f32) -> f32 {
    1.0 / norm(wave).max(middle).max(f32::MIN_POSITIVE)
}

/// The sum of the waves: each at unit energy, but those below the middle as quiet as they are,
/// because they hold more noise.
fn stack(waves: &[Vec<f32>], middle: f32) -> Vec<f32> {
    let mut stack = vec![0.0; waves[0].len()];
    for wave in waves {
        let scale = weight(wave, middle);
        for (sum, value) in stack.iter_mut().zip(wave) {
            *sum += value * scale;
        }
    }
    stack
}

/// What other impacts say an impact sounds like.
struct Template<'a> {
    wave: &'a [f32],
    derivative: Vec<f32>,
    energy: f32,
    slope: f32,
    /// Power of its noise over that of one impact.
    noise: f32,
}

impl<'a> Template<'a> {
    fn new(wave: &'a [f32], noise: f32) -> Self {
        let derivative = derivative(wave);
        Self {
            wave,
            noise,
            energy: dot(wave, wave),
            slope: dot(&derivative, &derivative),
            derivative,
        }
    }

    /// What the template at its best level leaves of a wave, and that level.
    fn residual(&self, wave: &[f32]) -> (Vec<f32>, f32) {
        let level = dot(wave, self.wave) / self.energy;
        let pairs = wave.iter().zip(self.wave);
        (pairs.map(|(w, t)| w - level * t).collect(), level)
    }

    /// By how many samples the wave comes late.
    fn misfit(&self, wave: &[f32]) -> f64 {
        let (residual, level) = self.residual(wave);
        let late = -dot(&self.derivative, &residual) / (level * self.slope);
        if late.is_finite() {
            f64::from(late)
        } else {
            0.0
        }
    }

    /// Standard error of the shift of a wave in this noise, in samples.
    fn shift_error(&self, wave: &[f32], noise: &Noise) -> f64 {
        let (residual, level) = self.residual(wave);
        let slope = f64::from(level * level * self.slope).max(f64::MIN_POSITIVE);
        let unexplained = f64::from(dot(&residual, &residual));
        // What the noise of both leaves, give or take chance: here, and in what was heard before,
        // from which it is known. (That of the template is common to all impacts, and shifts none
        // against another.)
        let count = wave.len() as f64;
        let by_noise = count * noise.power * (1.0 + f64::from(level * level * self.noise));
        let chance = (2.0 * noise.alike * (1.0 / count + 1.0 / noise.heard)).sqrt();
        let different = if unexplained > by_noise * (1.0 + 2.0 * chance) {
            unexplained - by_noise
        } else {
            0.0
        };
        let variance = (noise.density + different / FREE_DIFFERENCES) / slope;
        variance.sqrt().hypot(LEAST_SIGMA)
    }
}

/// The noise under an impact.
struct Noise {
    /// Its power, and from how many samples that is known.
    power: f64,
    heard: f64,
    /// How many samples in a row are alike, because it was smoothed.
    alike: f64,
    /// Its density where the template is steep.
    density: f64,
}

/// The share of the noise in the slope of this stack that smoothing leaves: the shift smooths once
/// what is left of a wave and once the template.
fn smoothness(stack: &[f32], smoothed: &[f32]) -> f64 {
    let slope = derivative(stack);
    let twice = convolve(&slope, smoothed);
    f64::from(dot(&twice, &twice) / dot(&slope, &slope).max(f32::MIN_POSITIVE))
}

/// The derivative of a band-limited signal, for each sample; silence lies before and after.
fn derivative(samples: &[f32]) -> Vec<f32> {
    let length = samples.len();
    let mut padded = vec![0.0; length + 2 * KERNEL];
    padded[KERNEL..][..length].copy_from_slice(samples);
    let mut derivative = vec![0.0; length];
    for k in 1..=KERNEL {
        let window = 0.5 + 0.5 * (PI * k as f64 / (KERNEL + 1) as f64).cos();
        let sign = if k % 2 == 1 { 1.0 } else { -1.0 };
        let weight = (sign * window / k as f64) as f32;
        let (before, after) = (&padded[KERNEL - k..], &padded[KERNEL + k..]);
        for ((sum, before), after) in derivative.iter_mut().zip(before).zip(after) {
            *sum += weight * (after - before);
        }
    }
    derivative
}

fn dot(a: &[f32], b: &[f32]) -> f32 {
    let ((a, rest_a), (b, rest_b)) = (a.as_chunks::<LANES>(), b.as_chunks::<LANES>());
    let mut lanes = [0.0_f32; LANES];
    for (a, b) in a.iter().zip(b) {
        for lane in 0..LANES {
            lanes[lane] += a[lane] * b[lane];
        }
    }
    let rest: f32 = rest_a.iter().zip(rest_b).map(|(x, y)| x * y).sum();
    lanes.iter().sum::<f32>() + rest
}

/// So many products are added side by side.
const LANES: usize = 16;

fn norm(a: &[f32]) -> f32 {
    dot(a, a).sqrt()
}

/// The energy before each of these samples, and of all.
fn running_energy(samples: &[f32]) -> Vec<f64> {
    let mut sum = 0.0;
    let sums = samples.iter().map(|&sample| {
        sum += f64::from(sample).powi(2);
        sum
    });
    std::iter::once(0.0).chain(sums).collect()
}

/// So many values from a position between samples on, by a windowed sinc; silence lies before
/// the first sample and after the last.
fn resample(samples: &[f32], position: f64, length: usize) -> Vec<f32> {
    let whole = position.floor();
    let kernel = kernel(position - whole);
    let first = whole as isize + 1 - KERNEL.cast_signed();
    let mut values = vec![0.0; length];
    for (tap, weight) in kernel.into_iter().enumerate() {
        let start = first + tap.cast_signed();
        let skipped = start.min(0).unsigned_abs().min(length);
        let taps = samples.get(start.max(0) as usize..).unwrap_or_default();
        for (value, sample) in values[skipped..].iter_mut().zip(taps) {
            *value += weight * sample;
        }
    }
    values
}

/// The weights of the samples around a position this fraction after one of them.
fn kernel(fraction: f64) -> [f32; 2 * KERNEL] {
    // From tap to tap the sine changes its sign, and the window turns by an equal angle.
    let mut sin = (PI * (fraction + KERNEL as f64 - 1.0)).sin() / PI;
    let (turn_sin, turn_cos) = (PI / KERNEL as f64).sin_cos();
    let (mut window_sin, mut window_cos) = (PI * (1.0 - fraction) / KERNEL as f64 - PI).sin_cos();
    std::array::from_fn(|tap| {
        let x = (tap + 1) as f64 - KERNEL as f64 - fraction;
        let weight = if x.abs() < 1e-9 {
            1.0
        } else {
            -(0.5 + 0.5 * window_cos) * sin / x
        };
        sin = -sin;
        (window_sin, window_cos) = (
            window_sin * turn_cos + window_cos * turn_sin,
            window_cos * turn_cos - window_sin * turn_sin,
        );
        weight as f32
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_impact_moved_out_of_its_sound_is_survived() {
        let span = Span::new(44_100.0);
        let fading = (0..span.origin + span.after()).map(|n| 0.99_f32.powf(n as f32));
        let samples: Vec<f32> = fading.collect();
        for shift in [-1e4, -400.0, 0.0, 400.0, 1e4] {
            let sound = Sound {
                impact: 0,
                energy: running_energy(&samples),
                samples: samples.clone(),
                noise: 1e-6,
                density: 1e-6,
                reach: 1,
                pick_sigma: 1.0,
                shift,
                fits: false,
                sigma: 0.0,
            };
            assert!(!sound.begins(&span), "{shift}");
            assert_eq!(sound.wave(&span, shift).len(), span.length);
        }
    }

    #[test]
    fn interpolation_is_that_of_a_band_limited_signal() {
        let tone: Vec<f32> = (0..200)
            .map(|n| (0.9 * f64::from(n)).sin() as f32)
            .collect();
        for position in [100.0, 100.25, 100.5, 101.9] {
            let error = f64::from(resample(&tone, position, 1)[0]) - (0.9 * position).sin();
            assert!(error.abs() < 2e-3, "{position}: {error}");
        }
    }
}
