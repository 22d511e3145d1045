//! Reverberation: a decaying tail of noise after every sound.

use rand::{Rng, RngExt};
use rand_distr::StandardNormal;
use rustfft::algorithm::Radix4;
use rustfft::algorithm::butterflies::Butterfly8;
use rustfft::num_complex::Complex;
use rustfft::{Fft, FftDirection, Length};
use std::sync::Arc;

use super::scene::Reverb;

/// Adds to a recording its own reverberation.
pub(super) fn add_reverb(
    recording: &mut [f32],
    reverb: &Reverb,
    sample_rate_hz: f64,
    rng: &mut impl Rng,
) {
    let tail = impulse_response(reverb, sample_rate_hz, recording.len(), rng);
    add_convolved(recording, &tail);
}

/// The tail alone, without the direct sound, no longer than the recording.
fn impulse_response(
    reverb: &Reverb,
    sample_rate_hz: f64,
    max_length: usize,
    rng: &mut impl Rng,
) -> Vec<f32> {
    let samples = reverb.rt60_s * sample_rate_hz;
    let decay = -1000_f64.ln() / samples;
    let length = samples.ceil() as usize;
    let mut tail: Vec<f64> = (0..length)
        .map(|n| rng.sample::<f64, _>(StandardNormal) * (decay * n as f64).exp())
        .collect();
    // The first sample is that of the direct sound.
    tail[0] = 0.0;
    let energy: f64 = tail.iter().map(|x| x * x).sum();
    let gain = (10_f64.powf(-reverb.direct_to_reverberant_db / 10.0) / energy).sqrt();
    tail.truncate(max_length);
    tail.iter().map(|x| (gain * x) as f32).collect()
}

/// Adds `recording` convolved with `kernel` to itself, block by block (overlap-add).
fn add_convolved(recording: &mut [f32], kernel: &[f32]) {
    let forward = transform(2 * kernel.len(), FftDirection::Forward);
    let inverse = transform(2 * kernel.len(), FftDirection::Inverse);
    let size = forward.len();
    let zero = Complex::new(0.0, 0.0);
    let mut response = vec![zero; size];
    let mut sound = vec![zero; size];
    fill(&mut response, kernel);
    forward.process(&mut response);
    // The inverse transform is not normalised.
    let scale = 1.0 / size as f32;

    let dry = recording.to_vec();
    let block = size - kernel.len() + 1;
    for (index, input) in dry.chunks(block).enumerate() {
        fill(&mut sound, input);
        forward.process(&mut sound);
        for (x, h) in sound.iter_mut().zip(&response) {
            *x = *x * h * scale;
        }
        inverse.process(&mut sound);
        for (out, wet) in recording[index * block..].iter_mut().zip(&sound) {
            *out += wet.re;
        }
    }
}

/// A transform of at least this length. It has the same base as that of the spectrogram of the page: code for
/// other bases would make the page larger.
fn transform(at_least: usize, direction: FftDirection) -> Radix4<f32> {
    const BASE: usize = 8;
    let steps = at_least
        .div_ceil(BASE)
        .next_power_of_two()
        .ilog2()
        .div_ceil(2);
    Radix4::new_with_base(steps, Arc::new(Butterfly8::new(direction)))
}

/// Fills `target` with these samples and zeros after them.
fn fill(target: &mut [Complex<f32>], samples: &[f32]) {
    let silence = std::iter::repeat(&0.0);
    for (value, &sample) in target.iter_mut().zip(samples.iter().chain(silence)) {
        *value = Complex::new(sample, 0.0);
    }
}
