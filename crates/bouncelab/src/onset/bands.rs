//! Energy in several bands.
//!
//! The upper bands are octaves of half-band filters (`octaves`). The remaining low frequencies, at about an eighth
//! of the sample rate, are split into the lower bands by causal filters: a fourth-order
//! high-pass and a second-order low-pass, Butterworth sections. Their poles lie near 1, but at that
//! rate single precision suffices: rounding stays 100 dB below the sound.

use super::octaves::{self, Octaves};
use super::parameters::{
    DENORMAL_GUARD, FRAME_HOPS, HOP_S, LOW_EDGES_HZ, MAX_HALVINGS, MAX_HOP, MAX_LOW_EDGE,
    MAX_LOW_RATE_HZ, MIN_EDGE_RATIO, MIN_SHARE_IN_RANGE, STEADINESS,
};
use std::f64::consts::{PI, SQRT_2};
use std::ops::Range;

/// Number of frequency bands of the detector.
pub const BANDS: usize = 5;

/// Number of lower bands.
const LOW: usize = LOW_EDGES_HZ.len();

/// The energies of one frame.
pub(super) type FrameEnergies = [[f32; FRAME_HOPS]; BANDS];

/// The filters of all bands, and how they respond to noise.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct FilterBank {
    /// How many bands lie below the Nyquist frequency; the rest have no energy.
    pub(super) bands: usize,
    /// Lower and upper edge of each band, Hz.
    pub(super) edges_hz: [(f64, f64); BANDS],
    /// Whether a rise in each band counts.
    pub(super) watched: [bool; BANDS],
    /// Effective noise bandwidth of each band, Hz.
    pub(super) width_hz: [f64; BANDS],
    /// Share of the power of white noise that lies in each band.
    pub(super) share: [f64; BANDS],
    /// Samples of a hop.
    pub(super) hop: usize,
    octaves: Octaves,
    /// The levels of the tree and the band each belongs to.
    levels: Vec<(usize, usize)>,
    low: LowBands,
    has_begun: bool,
}

impl FilterBank {
    pub(super) fn new(sample_rate_hz: f64) -> Self {
        let octaves_above = (sample_rate_hz / MAX_LOW_RATE_HZ).log2().floor() + 1.0;
        let halvings = octaves_above.clamp(0.0, MAX_HALVINGS) as usize;
        let low_rate_hz = sample_rate_hz / f64::from(1 << halvings);
        let low_samples = ((low_rate_hz * HOP_S).round() as usize).clamp(1, MAX_HOP >> halvings);
        let hop = low_samples << halvings;
        let mut bank = Self {
            bands: 0,
            edges_hz: [(0.0, 0.0); BANDS],
            watched: [true; BANDS],
            width_hz: [1.0; BANDS],
            share: [0.0; BANDS],
            hop,
            octaves: Octaves::new(halvings, hop * FRAME_HOPS),
            levels: Vec::new(),
            low: LowBands::new(),
            has_begun: false,
        };
        bank.set_low_bands(low_rate_hz);
        if bank.bands == LOW {
            bank.set_octaves(halvings, sample_rate_hz);
        }
        bank
    }

    fn set_low_bands(&mut self, rate_hz: f64) {
        for (band, &(low_hz, edge_hz)) in LOW_EDGES_HZ.iter().enumerate() {
            let high_hz = edge_hz.min(MAX_LOW_EDGE * rate_hz);
            if high_hz < MIN_EDGE_RATIO * low_hz {
                break;
            }
            self.bands = band + 1;
            self.edges_hz[band] = (low_hz, high_hz);
            self.width_hz[band] = high_hz - low_hz;
            self.share[band] = (high_hz - low_hz) / (rate_hz / 2.0);
            self.low.set(band, low_hz / rate_hz, high_hz / rate_hz);
        }
    }

    fn set_octaves(&mut self, halvings: usize, sample_rate_hz: f64) {
        for level in (0..=halvings).rev() {
            // The last two levels make the third band.
            let band = LOW + (halvings - level).saturating_sub(1);
            if band >= BANDS {
                break;
            }
            // Level n works at the sample rate over 2^n and splits off the upper half of its frequencies.
            let octave_hz = sample_rate_hz / f64::from(4 << level);
            if level == halvings || band > LOW {
                self.edges_hz[band] = (octave_hz, 2.0 * octave_hz);
                self.width_hz[band] = STEADINESS * octave_hz;
            } else {
                self.edges_hz[band].1 = 2.0 * octave_hz;
                self.width_hz[band] += STEADINESS * octave_hz;
            }
            self.share[band] += octaves::WHITE_SHARE / f64::from(1 << level);
            self.levels.push((level, band));
            self.bands = band + 1;
        }
    }

    /// The bands below the Nyquist frequency, low to high, in Hz.
    pub(super) fn bands_hz(&self) -> Vec<Range<f64>> {
        let edges_hz = self.edges_hz[..self.bands].iter();
        edges_hz.map(|&(low_hz, high_hz)| low_hz..high_hz).collect()
    }

    /// Restricts the detection to the bands of which at least half lies between these frequencies in Hz; returns whether
    /// there are any.
    pub(super) fn watch(&mut self, low_hz: f64, high_hz: f64) -> bool {
        for (watched, edges_hz) in self.watched.iter_mut().zip(self.edges_hz) {
            let inside_hz = edges_hz.1.min(high_hz) - edges_hz.0.max(low_hz);
            *watched =
                low_hz < high_hz && inside_hz >= MIN_SHARE_IN_RANGE * (edges_hz.1 - edges_hz.0);
        }
        self.watched[..self.bands].contains(&true)
    }

    /// Samples of a frame.
    pub(super) fn frame(&self) -> usize {
        self.hop * FRAME_HOPS
    }

    /// Delay of the energies, in samples.
    pub(super) fn delay(&self) -> usize {
        self.octaves.delay()
    }

    /// Mean square of each band in each hop of the next frame of samples.
    pub(super) fn energies(&mut self, frame: &[f32]) -> FrameEnergies {
        if !self.has_begun {
            self.has_begun = true;
            self.octaves.begin(frame[0]);
            self.low.offset = frame[0];
        }
        let mut energies = [[0.0; FRAME_HOPS]; BANDS];
        let low = self.octaves.push(frame);
        self.low.energies(low, &mut energies);
        for &(level, band) in &self.levels {
            self.octaves.add_energies(level, &mut energies[band]);
        }
        energies
    }
}

/// Sections of the filter of a lower band.
const SECTIONS: usize = 3;
/// All sections of all bands, and two unused ones, so that they fill wide registers.
const LANES: usize = 8;

/// The filters of the lower bands, in direct form I. At each step section n of a band takes the output of section n - 1 of
/// the step before, so that all sections run side by side; the lanes are the first sections of both bands, the second,
/// the third, and two unused.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
struct LowBands {
    /// The first sample, which is subtracted.
    offset: f32,
    /// Power gain of each band.
    gain: [f32; LOW],
    /// Coefficients of each section: of the sample before in the numerator, and of the denominator.
    middle: [f32; LANES],
    a1: [f32; LANES],
    a2: [f32; LANES],
    /// The latest two inputs of each section.
    x1: [f32; LANES],
    x2: [f32; LANES],
    /// The latest two outputs of each section.
    y1: [f32; LANES],
    y2: [f32; LANES],
}

impl LowBands {
    fn new() -> Self {
        let zero = [0.0; LANES];
        Self {
            offset: 0.0,
            gain: [0.0; LOW],
            middle: zero,
            a1: zero,
            a2: zero,
            x1: zero,
            x2: zero,
            y1: zero,
            y2: zero,
        }
    }

    /// Sets the edges of a band in units of the sample rate.
    fn set(&mut self, band: usize, low: f64, high: f64) {
        let high_pass = Section::high_pass(low);
        let sections = [high_pass, high_pass, Section::low_pass(high)];
        // The sections leave out their gains; the energy is multiplied by the product of their squares.
        let gain: f64 = sections.iter().map(|s| s.gain * s.gain).product();
        self.gain[band] = gain as f32;
        for (index, section) in sections.iter().enumerate() {
            let lane = index * LOW + band;
            self.middle[lane] = section.middle as f32;
            self.a1[lane] = section.a1 as f32;
            self.a2[lane] = section.a2 as f32;
        }
    }

    /// Mean square of each band in each hop.
    fn energies(&mut self, samples: &[f32], energies: &mut FrameEnergies) {
        let length = samples.len() / FRAME_HOPS;
        let offset = self.offset - DENORMAL_GUARD;
        let Self { middle, a1, a2, .. } = *self;
        let (mut x1, mut x2, mut y1, mut y2) = (self.x1, self.x2, self.y1, self.y2);
        for (hop, samples) in samples.chunks_exact(length).enumerate() {
            let mut sums = [0.0; LOW];
            for &sample in samples {
                let input = sample - offset;
                let x = [input, input, y1[0], y1[1], y1[2], y1[3], 0.0, 0.0];
                let y: [f32; LANES] = std::array::from_fn(|n| {
                    // y1, of which the next sample must wait, enters last.
                    (x[n] + (middle[n] * x1[n] + x2[n] - a2[n] * y2[n])) - a1[n] * y1[n]
                });
                (x2, x1, y2, y1) = (x1, x, y1, y);
                for band in 0..LOW {
                    let last = y[(SECTIONS - 1) * LOW + band];
                    sums[band] += last * last;
                }
            }
            for band in 0..LOW {
                energies[band][hop] = sums[band] * self.gain[band] / length as f32;
            }
        }
        (self.x1, self.x2, self.y1, self.y2) = (x1, x2, y1, y2);
    }
}

/// A Butterworth section of second order: numerator `gain` (1, `middle`, 1).
#[derive(Clone, Copy, Debug)]
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

#[cfg(test)]
mod tests {
    use super::*;

    /// Energy of a sine of mean square 1 in each band, after the filters have settled.
    fn response(frequency_hz: f64, rate_hz: f64) -> [f32; BANDS] {
        let mut bank = FilterBank::new(rate_hz);
        let sine: Vec<f32> = (0..rate_hz as usize)
            .map(|n| ((2.0 * PI * frequency_hz * n as f64 / rate_hz).sin() * SQRT_2) as f32)
            .collect();
        let mut last = [0.0; BANDS];
        for frame in sine.chunks_exact(bank.frame()) {
            last = bank
                .energies(frame)
                .map(|hops| hops.iter().sum::<f32>() / FRAME_HOPS as f32);
        }
        last
    }

    #[test]
    fn a_tone_in_a_band_keeps_its_power_there_and_loses_it_elsewhere() {
        for rate in [44_100.0, 48_000.0, 192_000.0] {
            for (band, tone_hz) in [180.0, 800.0, 3600.0, 8000.0, 16_000.0]
                .into_iter()
                .enumerate()
            {
                let energies = response(tone_hz, rate);
                assert!(
                    (0.5..1.1).contains(&energies[band]),
                    "{rate} band {band}: {energies:?}"
                );
            }
            // Two octaves below a band less than -46 dB is left.
            assert!(response(1100.0, rate)[3] < 10f32.powf(-4.6));
        }
    }

    #[test]
    fn a_tone_is_in_the_band_whose_edges_lie_around_it() {
        for rate in [8000.0, 22_050.0, 44_100.0, 48_000.0] {
            let bank = FilterBank::new(rate);
            for band in 0..bank.bands {
                let (low_hz, high_hz) = bank.edges_hz[band];
                let energies = response((low_hz * high_hz).sqrt(), rate);
                // Half of it where two octaves make the band.
                assert!(energies[band] > 0.45, "{rate} band {band}: {energies:?}");
            }
        }
    }

    #[test]
    fn bands_that_lie_mostly_in_a_range_are_watched() {
        let mut bank = FilterBank::new(44_100.0);
        assert!(bank.watch(300.0, 9000.0));
        assert_eq!(bank.watched, [false, true, true, true, false]);
        assert!(!bank.watch(300.0, 310.0));
        assert!(!bank.watch(f64::NAN, f64::NAN));
    }

    #[test]
    fn bands_above_the_nyquist_frequency_are_dropped() {
        assert_eq!(FilterBank::new(44_100.0).bands, 5);
        assert_eq!(FilterBank::new(32_000.0).bands, 5);
        assert_eq!(FilterBank::new(16_000.0).bands, 4);
        assert_eq!(FilterBank::new(8000.0).bands, 3);
        assert_eq!(FilterBank::new(4000.0).bands, 3);
        assert_eq!(FilterBank::new(1000.0).bands, 1);
        assert_eq!(FilterBank::new(1.0).bands, 0);
        assert!(response(300.0, 4000.0)[0] > 0.5);
    }
}
