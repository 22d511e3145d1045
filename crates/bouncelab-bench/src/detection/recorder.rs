//! Sound as a recorder takes it: without what its samples cannot carry.

use bouncelab::impact::ImpactEvent;
use bouncelab::synth::{self, Rendered, Scene};
use std::f64::consts::PI;

/// Oversampling: this multiple of the sample rate is close enough to continuous time.
const OVERSAMPLED: usize = 4;
/// Half the length of the filter, in samples of the recording.
const REACH: usize = 32;
/// The filter passes what lies below this share of the sample rate.
const PASSED: f64 = 0.476;

/// A recording, and the same without its noise.
pub(crate) struct Recorded {
    /// The truth, and the samples with the noise.
    pub(crate) noisy: Rendered,
    pub(crate) clean: Vec<f32>,
    pub(crate) noise_rms: f64,
}

/// Records these impacts. The synthesiser samples its sounds as they are: what lies above half the
/// sample rate comes back below it, different in each impact, by where its samples happen to lie.
/// A recorder filters that out first.
pub(crate) fn record(events: &[ImpactEvent], scene: &Scene, seed: u64) -> Recorded {
    let render = |scene: &Scene| {
        synth::render(events, scene, seed).unwrap_or_else(|error| panic!("{error}"))
    };
    let quiet = Scene {
        noise: None,
        ..scene.clone()
    };
    let mut noisy = render(scene);
    let unfiltered = render(&quiet).samples;
    let fine = render(&Scene {
        sample_rate_hz: scene.sample_rate_hz * OVERSAMPLED as u32,
        ..quiet
    });
    let clean = filter(&fine.samples, unfiltered.len());
    let mut energy = 0.0;
    for ((noisy, unfiltered), clean) in noisy.samples.iter_mut().zip(&unfiltered).zip(&clean) {
        let noise = *noisy - unfiltered;
        energy += f64::from(noise).powi(2);
        *noisy = clean + noise;
    }
    Recorded {
        noise_rms: (energy / clean.len() as f64).sqrt(),
        noisy,
        clean,
    }
}

/// Length of the windowed sinc in output samples, of `OVERSAMPLED` input samples each.
fn filter(fine: &[f32], length: usize) -> Vec<f32> {
    let reach = REACH * OVERSAMPLED;
    let kernel: Vec<f32> = (0..=2 * reach)
        .map(|n| {
            let x = (n as f64 - reach as f64) / OVERSAMPLED as f64;
            let window = 0.5 + 0.5 * (PI * x / REACH as f64).cos();
            let phase = 2.0 * PI * PASSED * x;
            let sinc = if n == reach { 1.0 } else { phase.sin() / phase };
            (window * sinc * 2.0 * PASSED / OVERSAMPLED as f64) as f32
        })
        .collect();
    let mut padded = vec![0.0; length * OVERSAMPLED + 2 * reach];
    let copied = fine.len().min(length * OVERSAMPLED);
    padded[reach..][..copied].copy_from_slice(&fine[..copied]);
    (0..length)
        .map(|n| {
            let around = &padded[n * OVERSAMPLED..][..kernel.len()];
            kernel.iter().zip(around).map(|(k, x)| k * x).sum()
        })
        .collect()
}
