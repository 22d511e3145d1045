//! Backgrounds beside the noise and hum of `synth`: like speech, like music.

use bouncelab::synth::Rendered;
use rand::{Rng, RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::f64::consts::TAU;

/// The other sounds.
#[derive(Clone, Copy)]
pub(crate) enum Kind {
    /// Syllables of voiced sound with three formants, between hisses and pauses.
    Speech,
    /// Notes, bass drum and hi-hat on a beat.
    Music,
}

impl Kind {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Speech => "speech-like",
            Self::Music => "music-like",
        }
    }

    /// The given number of samples of it at this rate, mean square 1.
    pub(crate) fn samples(self, count: usize, sample_rate_hz: u32, seed: u64) -> Vec<f32> {
        let rate = f64::from(sample_rate_hz);
        let mut rng = ChaCha8Rng::seed_from_u64(seed ^ 0x5eed);
        let mut samples = vec![0.0; count];
        match self {
            Self::Speech => speech(&mut samples, rate, &mut rng),
            Self::Music => music(&mut samples, rate, &mut rng),
        }
        let energy: f64 = samples.iter().map(|x| x * x).sum();
        let gain = (count as f64 / energy.max(f64::MIN_POSITIVE)).sqrt();
        samples.iter().map(|x| (gain * x) as f32).collect()
    }

    /// Adds it to a sound, at this root mean square.
    pub(crate) fn add(self, sound: &mut Rendered, rms: f64, seed: u64) {
        let samples = self.samples(sound.samples.len(), sound.sample_rate_hz, seed);
        for (sum, sample) in sound.samples.iter_mut().zip(samples) {
            *sum += (rms * f64::from(sample)) as f32;
        }
    }
}

/// A value between two others, all ratios equally likely.
fn between(low: f64, high: f64, rng: &mut impl Rng) -> f64 {
    low * (high / low).powf(rng.random())
}

fn speech(samples: &mut [f64], rate: f64, rng: &mut impl Rng) {
    let mut at = 0;
    while at < samples.len() {
        let end = (at + (rate * between(0.06, 0.3, rng)) as usize).min(samples.len());
        match rng.random_range(0..10) {
            0..=5 => voiced(&mut samples[at..end], rate, rng),
            6 | 7 => hiss(&mut samples[at..end], rng),
            _ => {}
        }
        at = end;
    }
}

/// Pulses of a voice through three formants.
fn voiced(samples: &mut [f64], rate: f64, rng: &mut impl Rng) {
    let length = samples.len() as f64;
    let pitch_hz = between(90.0, 220.0, rng);
    let glide = between(0.8, 1.25, rng);
    let formants = [(300.0, 800.0), (800.0, 2300.0), (2300.0, 3300.0)]
        .map(|(low, high)| between(low, high, rng).min(0.4 * rate));
    let mut resonators = formants.map(|hz| Resonator::new(hz, 90.0, rate));
    let mut phase = 0.0;
    for (n, sample) in samples.iter_mut().enumerate() {
        let place = n as f64 / length;
        phase += pitch_hz * glide.powf(place) / rate;
        let pulse = if phase >= 1.0 { 1.0 } else { 0.0 };
        phase = phase.fract();
        let loudness = (TAU / 2.0 * place).sin().sqrt();
        let voice: f64 = resonators.iter_mut().map(|r| r.next(pulse)).sum();
        *sample += loudness * voice;
    }
}

fn hiss(samples: &mut [f64], rng: &mut impl Rng) {
    let length = samples.len() as f64;
    let mut last = 0.0;
    for (n, sample) in samples.iter_mut().enumerate() {
        let white = rng.random::<f64>() - 0.5;
        *sample += 0.5 * (TAU / 2.0 * n as f64 / length).sin() * (white - last);
        last = white;
    }
}

/// A resonance of this frequency and bandwidth.
struct Resonator {
    a1: f64,
    a2: f64,
    y1: f64,
    y2: f64,
}

impl Resonator {
    fn new(frequency_hz: f64, width_hz: f64, rate: f64) -> Self {
        let radius = (-TAU / 2.0 * width_hz / rate).exp();
        Self {
            a1: 2.0 * radius * (TAU * frequency_hz / rate).cos(),
            a2: -radius * radius,
            y1: 0.0,
            y2: 0.0,
        }
    }

    fn next(&mut self, x: f64) -> f64 {
        let y = x + self.a1 * self.y1 + self.a2 * self.y2;
        (self.y2, self.y1) = (self.y1, y);
        y
    }
}

fn music(samples: &mut [f64], rate: f64, rng: &mut impl Rng) {
    let beat_s = between(0.35, 0.7, rng);
    let beats = (samples.len() as f64 / rate / beat_s) as usize;
    for half in 0..2 * beats {
        let start_s = beat_s * (half as f64 / 2.0) + 0.004 * rng.random::<f64>();
        let at = (start_s * rate) as usize;
        let Some(rest) = samples.get_mut(at..) else {
            return;
        };
        if half % 4 == 0 {
            decay(rest, 55.0, 0.1, 2.0, rate);
        }
        if half % 2 == 1 || rng.random_bool(0.3) {
            hat(rest, rate, rng);
        }
        if rng.random_bool(0.6) {
            let pitch_hz = 110.0 * 2f64.powf(f64::from(rng.random_range(0..36)) / 12.0);
            for partial in 1..=6_u32 {
                let hz = pitch_hz * f64::from(partial);
                if hz < 0.45 * rate {
                    decay(
                        rest,
                        hz,
                        0.4 / f64::from(partial),
                        1.0 / f64::from(partial),
                        rate,
                    );
                }
            }
        }
    }
}

/// Adds a tone that begins now and dies away: a number that turns and shrinks.
fn decay(samples: &mut [f64], frequency_hz: f64, decay_s: f64, level: f64, rate: f64) {
    let length = ((8.0 * decay_s * rate) as usize).min(samples.len());
    let (sin, cos) = (TAU * frequency_hz / rate).sin_cos();
    let shrink = (-1.0 / (decay_s * rate)).exp();
    let (mut x, mut y) = (level, 0.0);
    for sample in &mut samples[..length] {
        *sample += y;
        (x, y) = (shrink * (x * cos - y * sin), shrink * (x * sin + y * cos));
    }
}

fn hat(samples: &mut [f64], rate: f64, rng: &mut impl Rng) {
    let length = ((0.1 * rate) as usize).min(samples.len());
    let mut last = 0.0;
    for (n, sample) in samples[..length].iter_mut().enumerate() {
        let white = rng.random::<f64>() - 0.5;
        *sample += (-(n as f64) / (0.02 * rate)).exp() * (white - last);
        last = white;
    }
}
