//! The room: a decaying tail of noise after every sound.

use rand::{Rng, RngExt};
use rand_distr::StandardNormal;
use realfft::RealFftPlanner;

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
    // The direct sound has its sample to itself.
    tail[0] = 0.0;
    let energy: f64 = tail.iter().map(|x| x * x).sum();
    let gain = (10_f64.powf(-reverb.direct_to_reverberant_db / 10.0) / energy).sqrt();
    tail.truncate(max_length);
    tail.iter().map(|x| (gain * x) as f32).collect()
}

/// Adds `recording` convolved with `kernel` to itself, block by block (overlap-add).
fn add_convolved(recording: &mut [f32], kernel: &[f32]) {
    let size = (2 * kernel.len()).next_power_of_two();
    let mut planner = RealFftPlanner::<f32>::new();
    let (forward, inverse) = (
        planner.plan_fft_forward(size),
        planner.plan_fft_inverse(size),
    );
    let mut time = forward.make_input_vec();
    let mut response = forward.make_output_vec();
    let mut spectrum = forward.make_output_vec();
    time[..kernel.len()].copy_from_slice(kernel);
    // The buffers come from the plans themselves, so their lengths fit.
    let fits = "buffer made by its plan";
    forward.process(&mut time, &mut response).expect(fits);
    // The inverse transform is not normalised.
    let scale = 1.0 / size as f32;

    let dry = recording.to_vec();
    let block = size - kernel.len() + 1;
    for (index, input) in dry.chunks(block).enumerate() {
        time.fill(0.0);
        time[..input.len()].copy_from_slice(input);
        forward.process(&mut time, &mut spectrum).expect(fits);
        for (x, h) in spectrum.iter_mut().zip(&response) {
            *x *= h * scale;
        }
        inverse.process(&mut spectrum, &mut time).expect(fits);
        for (out, wet) in recording[index * block..].iter_mut().zip(&time) {
            *out += wet;
        }
    }
}
