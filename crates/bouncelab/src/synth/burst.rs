//! One short sound, sampled from an onset that lies anywhere between two samples.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::voice::Mode;

/// Modes stop where they have fallen this far (120 dB) below the loudest mode at level 1.
const FLOOR: f64 = 1e-6;

/// The time over which the loudness of an impact is defined.
pub(super) const LOUDNESS_WINDOW_S: f64 = 5e-3;

/// A short sound on the sample grid of the recording.
#[derive(Default)]
pub(super) struct Burst {
    /// Index in the recording of the first sample at or after the onset.
    first: usize,
    samples: Vec<f64>,
    window: usize,
}

impl Burst {
    /// Replaces the sound by modes (each with its phase at the onset) excited at `time_s` with
    /// `level`, rising over `rise_s`, and evaluated at the exact sample times.
    pub(super) fn excite(
        &mut self,
        time_s: f64,
        modes: impl Iterator<Item = (Mode, f64)>,
        level: f64,
        rise_s: f64,
        sample_rate_hz: f64,
    ) {
        let onset = time_s * sample_rate_hz;
        let first = onset.ceil();
        let offset_s = (first - onset) / sample_rate_hz;
        self.first = first as usize;
        self.window = (LOUDNESS_WINDOW_S * sample_rate_hz).round() as usize;
        self.samples.clear();
        for (mode, phase_rad) in modes {
            self.add_mode(mode, phase_rad, level, offset_s, sample_rate_hz);
        }
        for (n, sample) in self.samples.iter_mut().enumerate() {
            let t = offset_s + n as f64 / sample_rate_hz;
            if t >= rise_s {
                break;
            }
            *sample *= (FRAC_PI_2 * t / rise_s).sin().powi(2);
        }
    }

    fn add_mode(
        &mut self,
        mode: Mode,
        phase_rad: f64,
        level: f64,
        offset_s: f64,
        sample_rate_hz: f64,
    ) {
        let amplitude = level * mode.level;
        let audible_s = mode.decay_s * (amplitude / FLOOR).ln().max(0.0);
        let length = (audible_s * sample_rate_hz).ceil() as usize;
        if self.samples.len() < length {
            self.samples.resize(length, 0.0);
        }
        // A rotating, shrinking phasor: one complex product for each sample.
        let shrink = (-1.0 / (mode.decay_s * sample_rate_hz)).exp();
        let (sin, cos) = (TAU * mode.frequency_hz / sample_rate_hz).sin_cos();
        let (step_re, step_im) = (shrink * cos, shrink * sin);
        let start = amplitude * (-offset_s / mode.decay_s).exp();
        let (sin, cos) = (TAU * mode.frequency_hz * offset_s + phase_rad).sin_cos();
        let (mut re, mut im) = (start * cos, start * sin);
        for sample in &mut self.samples[..length] {
            *sample += im;
            (re, im) = (re * step_re - im * step_im, re * step_im + im * step_re);
        }
    }

    /// Root mean square over the first 5 ms.
    pub(super) fn rms(&self) -> f64 {
        let energy: f64 = self.samples.iter().take(self.window).map(|x| x * x).sum();
        (energy / self.window as f64).sqrt()
    }

    /// Largest absolute sample.
    pub(super) fn peak(&self) -> f64 {
        self.samples.iter().fold(0.0, |peak, x| x.abs().max(peak))
    }

    /// Adds `gain` times the sound to a recording, as far as the recording reaches.
    pub(super) fn add_to(&self, recording: &mut [f32], gain: f64) {
        let rest = recording.get_mut(self.first..).unwrap_or_default();
        for (out, x) in rest.iter_mut().zip(&self.samples) {
            *out += (gain * x) as f32;
        }
    }
}
