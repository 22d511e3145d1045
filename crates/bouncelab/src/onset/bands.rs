//! Energy in several bands, by causal filters.
//!
//! Each band is a fourth-order high-pass and a second-order low-pass, Butterworth sections. The
//! bands run side by side, one lane each, so that the compiler makes vector code of them. The low
//! bands need double precision (their poles lie near 1), the high ones do not.

use std::f64::consts::{PI, SQRT_2};
use std::ops::{Add, Mul, Sub};

/// How many frequency bands the detector watches.
pub const BANDS: usize = 5;
const LOW: usize = 2;
const HIGH: usize = 4;
const SECTIONS: usize = 3;

/// Band edges in Hz; a band above the Nyquist frequency is cut or dropped.
const EDGES_HZ: [(f64, f64); BANDS] = [
    (80.0, 400.0),
    (400.0, 1500.0),
    (1500.0, 4500.0),
    (4500.0, 10_000.0),
    (10_000.0, 18_000.0),
];

/// The filters of all bands, and what they say of noise.
#[derive(Clone)]
pub(super) struct FilterBank {
    /// How many bands lie below the Nyquist frequency; the rest have no energy.
    pub(super) bands: usize,
    /// Width of each band in Hz.
    pub(super) width_hz: [f64; BANDS],
    /// Share of the power of white noise that falls in each band.
    pub(super) share: [f64; BANDS],
    gain: [f64; BANDS],
    low: Cascade<f64, LOW>,
    high: Cascade<f32, HIGH>,
}

impl FilterBank {
    pub(super) fn new(sample_rate_hz: f64) -> Self {
        let mut bank = Self {
            bands: 0,
            width_hz: [1.0; BANDS],
            share: [0.0; BANDS],
            gain: [0.0; BANDS],
            low: Cascade::new(),
            high: Cascade::new(),
        };
        for (band, &(low_hz, high_hz)) in EDGES_HZ.iter().enumerate() {
            let high_hz = high_hz.min(0.45 * sample_rate_hz);
            if high_hz < 1.3 * low_hz {
                break;
            }
            bank.bands = band + 1;
            bank.width_hz[band] = high_hz - low_hz;
            bank.share[band] = (high_hz - low_hz) / (sample_rate_hz / 2.0);
            let high_pass = Section::high_pass(low_hz / sample_rate_hz);
            let low_pass = Section::low_pass(high_hz / sample_rate_hz);
            let sections = [high_pass, high_pass, low_pass];
            // The sections leave out their gains; the energy gets them at once.
            bank.gain[band] = sections.iter().map(|s| s.gain * s.gain).product();
            for (index, section) in sections.iter().enumerate() {
                if band < LOW {
                    bank.low.set(index, band, section, |c| c);
                } else {
                    bank.high.set(index, band - LOW, section, |c| c as f32);
                }
            }
        }
        bank
    }

    /// Mean square of each band over these samples.
    pub(super) fn energies(&mut self, samples: &[f32]) -> [f64; BANDS] {
        // A whisper of an offset keeps the filters out of denormal numbers in digital silence.
        const OFFSET: f32 = 1e-15;
        let mut low = [0.0; LOW];
        let mut high = [0.0; HIGH];
        for &sample in samples {
            self.low.add_energy(f64::from(sample + OFFSET), &mut low);
            self.high.add_energy(sample + OFFSET, &mut high);
        }
        let sum = |band: usize| {
            if band < LOW {
                low[band]
            } else {
                f64::from(high[band - LOW])
            }
        };
        std::array::from_fn(|band| sum(band) * self.gain[band] / samples.len() as f64)
    }
}

/// A Butterworth section of second order: numerator `gain` (1, `middle`, 1).
#[derive(Clone, Copy)]
struct Section {
    gain: f64,
    middle: f64,
    a1: f64,
    a2: f64,
}

impl Section {
    /// `frequency` in units of the sample rate.
    fn high_pass(frequency: f64) -> Self {
        let cos = (2.0 * PI * frequency).cos();
        Self::new(frequency, 0.5 + 0.5 * cos, -2.0)
    }

    fn low_pass(frequency: f64) -> Self {
        let cos = (2.0 * PI * frequency).cos();
        Self::new(frequency, 0.5 - 0.5 * cos, 2.0)
    }

    fn new(frequency: f64, gain: f64, middle: f64) -> Self {
        let (sin, cos) = (2.0 * PI * frequency).sin_cos();
        let alpha = sin / SQRT_2;
        let a0 = 1.0 + alpha;
        Self {
            gain: gain / a0,
            middle,
            a1: -2.0 * cos / a0,
            a2: (1.0 - alpha) / a0,
        }
    }
}

/// Sections in a row, `N` lanes side by side, in transposed direct form II.
#[derive(Clone)]
struct Cascade<T, const N: usize> {
    middle: [[T; N]; SECTIONS],
    a1: [[T; N]; SECTIONS],
    a2: [[T; N]; SECTIONS],
    s1: [[T; N]; SECTIONS],
    s2: [[T; N]; SECTIONS],
}

impl<T, const N: usize> Cascade<T, N>
where
    T: Copy + Default + Add<Output = T> + Sub<Output = T> + Mul<Output = T>,
{
    fn new() -> Self {
        let zero = [[T::default(); N]; SECTIONS];
        Self {
            middle: zero,
            a1: zero,
            a2: zero,
            s1: zero,
            s2: zero,
        }
    }

    fn set(&mut self, index: usize, lane: usize, section: &Section, cast: impl Fn(f64) -> T) {
        self.middle[index][lane] = cast(section.middle);
        self.a1[index][lane] = cast(section.a1);
        self.a2[index][lane] = cast(section.a2);
    }

    #[inline]
    fn add_energy(&mut self, sample: T, energy: &mut [T; N]) {
        let mut x = [sample; N];
        for i in 0..SECTIONS {
            let y: [T; N] = std::array::from_fn(|n| x[n] + self.s1[i][n]);
            self.s1[i] = std::array::from_fn(|n| {
                self.middle[i][n] * x[n] - self.a1[i][n] * y[n] + self.s2[i][n]
            });
            self.s2[i] = std::array::from_fn(|n| x[n] - self.a2[i][n] * y[n]);
            x = y;
        }
        for n in 0..N {
            energy[n] = energy[n] + x[n] * x[n];
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Energy of a sine of amplitude 1 in each band, after the filters have settled.
    fn response(frequency_hz: f64, rate_hz: f64) -> [f64; BANDS] {
        let mut bank = FilterBank::new(rate_hz);
        let sine: Vec<f32> = (0..rate_hz as usize)
            .map(|n| (2.0 * PI * frequency_hz * n as f64 / rate_hz).sin() as f32)
            .collect();
        bank.energies(&sine[..sine.len() / 2]);
        bank.energies(&sine[sine.len() / 2..])
    }

    #[test]
    fn a_tone_in_a_band_keeps_its_power_there_and_loses_it_elsewhere() {
        for rate in [44_100.0, 48_000.0, 192_000.0] {
            for (band, &(low, high)) in EDGES_HZ.iter().enumerate() {
                let energies = response((low * high).sqrt(), rate);
                assert!(
                    (0.4..1.05).contains(&(energies[band] / 0.5)),
                    "band {band}: {energies:?}"
                );
            }
            // Two octaves below a band the fourth-order high-pass leaves less than -46 dB.
            assert!(response(1100.0, rate)[3] < 0.5 * 10f64.powf(-4.6));
        }
    }

    #[test]
    fn bands_above_the_nyquist_frequency_are_dropped() {
        assert_eq!(FilterBank::new(44_100.0).bands, 5);
        assert_eq!(FilterBank::new(8000.0).bands, 3);
        assert_eq!(FilterBank::new(4000.0).bands, 2);
        assert!(response(300.0, 4000.0)[0] > 0.3);
    }
}
