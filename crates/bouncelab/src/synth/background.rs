//! Background: noise and hum.

use std::f64::consts::TAU;

use rand::{Rng, RngExt};
use rand_distr::StandardNormal;

use super::scene::{Colour, Hum};

/// Pink noise is flat below this frequency, so that its power is finite.
const PINK_FROM_HZ: f64 = 10.0;

/// Adds Gaussian noise whose root mean square over the recording is exactly `rms`.
pub(super) fn add_noise(
    recording: &mut [f32],
    colour: Colour,
    rms: f64,
    sample_rate_hz: f64,
    rng: &mut impl Rng,
) {
    let mut filter = match colour {
        Colour::White => Vec::new(),
        Colour::Pink => pink_sections(sample_rate_hz),
    };
    let mut draw = || {
        let white: f64 = rng.sample(StandardNormal);
        filter.iter_mut().fold(white, |x, section| section.next(x))
    };
    if colour == Colour::Pink {
        // Two periods of its lowest frequency, after which the filter no longer depends on its start.
        let settle = 2.0 * sample_rate_hz / PINK_FROM_HZ;
        for _ in 0..settle as usize {
            draw();
        }
    }
    let noise: Vec<f32> = recording.iter().map(|_| draw() as f32).collect();
    let energy: f64 = noise.iter().map(|&x| f64::from(x).powi(2)).sum();
    let gain = rms / (energy / noise.len() as f64).sqrt();
    for (out, x) in recording.iter_mut().zip(noise) {
        *out += (gain * f64::from(x)) as f32;
    }
}

/// A filter with one real pole and one real zero.
struct Section {
    pole: f64,
    zero: f64,
    input: f64,
    output: f64,
}

impl Section {
    fn next(&mut self, input: f64) -> f64 {
        self.output = input - self.zero * self.input + self.pole * self.output;
        self.input = input;
        self.output
    }
}

/// Poles two octaves apart with a zero midway fall by 3 dB for each octave, within 0.5 dB.
fn pink_sections(sample_rate_hz: f64) -> Vec<Section> {
    let root = |frequency_hz: f64| (-TAU * frequency_hz / sample_rate_hz).exp();
    std::iter::successors(Some(PINK_FROM_HZ), |f| Some(4.0 * f))
        .take_while(|&f| f < sample_rate_hz / 2.0)
        .map(|f| Section {
            pole: root(f),
            zero: root(2.0 * f),
            input: 0.0,
            output: 0.0,
        })
        .collect()
}

/// Adds hum of this root mean square, with random phases.
pub(super) fn add_hum(
    recording: &mut [f32],
    hum: &Hum,
    rms: f64,
    sample_rate_hz: f64,
    rng: &mut impl Rng,
) {
    let partials: Vec<f64> = (1..=hum.harmonics)
        .map(|k| k as f64)
        .take_while(|k| k * hum.frequency_hz < sample_rate_hz / 2.0)
        .collect();
    let power: f64 = partials.iter().map(|k| 0.5 / (k * k)).sum();
    let scale = rms / power.sqrt();
    for k in partials {
        let (step_im, step_re) = (TAU * k * hum.frequency_hz / sample_rate_hz).sin_cos();
        let (sin, cos) = rng.random_range(0.0..TAU).sin_cos();
        let (mut re, mut im) = (scale / k * cos, scale / k * sin);
        for out in &mut *recording {
            *out += im as f32;
            (re, im) = (re * step_re - im * step_im, re * step_im + im * step_re);
        }
    }
}
