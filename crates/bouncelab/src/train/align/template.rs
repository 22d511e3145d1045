//! What impacts have in common, and how far one of them is from it.

use super::wave::{convolve, derivative, dot, norm};

/// Impacts of one drop differ a little, and not as noise does: what they leave unexplained is like
/// so many numbers drawn at random, one or two for each mode that rings.
const FREE_DIFFERENCES: f64 = 2.0;
/// No shift is surer than this, in samples.
const LEAST_SIGMA: f64 = 0.0005;

pub(super) fn middle_size(waves: &[Vec<f32>]) -> f32 {
    let mut sizes: Vec<f32> = waves.iter().map(|wave| norm(wave)).collect();
    sizes.sort_by(f32::total_cmp);
    sizes[sizes.len() / 2]
}

/// The weight of a wave in a stack of waves of this middle size.
pub(super) fn weight(wave: &[f32], middle: f32) -> f32 {
    1.0 / norm(wave).max(middle).max(f32::MIN_POSITIVE)
}

/// The sum of the waves: each at unit energy, but those below the middle as quiet as they are,
/// because they hold more noise.
pub(super) fn stack(waves: &[Vec<f32>], middle: f32) -> Vec<f32> {
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
pub(super) struct Template<'a> {
    pub(super) wave: &'a [f32],
    derivative: Vec<f32>,
    energy: f32,
    slope: f32,
    /// Power of its noise over that of one impact.
    noise: f32,
}

impl<'a> Template<'a> {
    pub(super) fn new(wave: &'a [f32], noise: f32) -> Self {
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
    pub(super) fn misfit(&self, wave: &[f32]) -> f64 {
        let (residual, level) = self.residual(wave);
        let late = -dot(&self.derivative, &residual) / (level * self.slope);
        if late.is_finite() {
            f64::from(late)
        } else {
            0.0
        }
    }

    /// Standard error of the shift of a wave in this noise, in samples.
    pub(super) fn shift_error(&self, wave: &[f32], noise: &Noise) -> f64 {
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
pub(super) struct Noise {
    /// Its power, and from how many samples that is known.
    pub(super) power: f64,
    pub(super) heard: f64,
    /// How many samples in a row are alike, because it was smoothed.
    pub(super) alike: f64,
    /// Its density where the template is steep.
    pub(super) density: f64,
}

/// The share of the noise in the slope of this stack that smoothing leaves: the shift smooths once
/// what is left of a wave and once the template.
pub(super) fn smoothness(stack: &[f32], smoothed: &[f32]) -> f64 {
    let slope = derivative(stack);
    let twice = convolve(&slope, smoothed);
    f64::from(dot(&twice, &twice) / dot(&slope, &slope).max(f32::MIN_POSITIVE))
}
