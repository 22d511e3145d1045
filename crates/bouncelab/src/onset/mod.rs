//! Samples to onset candidates, each with a time, its standard error and a strength.
//!
//! The detector is adaptive: it has no threshold in volts or decibels. A candidate is a moment at
//! which the energy of the next few milliseconds stands out of the energy of the last few, in
//! units of how much noise of that bandwidth fluctuates by chance. Several bands are watched at
//! once, because a table-tennis ball shows best above 6 kHz, a basketball below 400 Hz. All
//! filters are causal, so nothing is smeared to before the onset.
//!
//! The time of a candidate is its *onset*, not its peak: it is picked from the waveform as
//! seismologists pick the arrival of a wave (`pick`).
//!
//! The bar is low on purpose: which candidates are impacts is for [`crate::train`] to judge.
//!
//! ```
//! use bouncelab::onset::Detector;
//!
//! // A decaying 3 kHz click at 0.25 s in faint noise.
//! let mut noise = 1u32;
//! let samples: Vec<f32> = (0..22_050)
//!     .map(|n| {
//!         noise = noise.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
//!         let t = n as f32 / 44_100.0 - 0.25;
//!         let click = if t < 0.0 { 0.0 } else { (-t / 0.005).exp() * (18_850.0 * t).sin() };
//!         0.5 * click + 1e-3 * ((noise >> 8) as f32 / 1.7e7 - 0.5)
//!     })
//!     .collect();
//! let mut onsets = Vec::new();
//! let mut detector = Detector::new(44_100);
//! detector.push(&samples, &mut onsets);
//! detector.finish(&mut onsets);
//! let loudest = onsets.iter().max_by(|a, b| a.level_db.total_cmp(&b.level_db)).unwrap();
//! assert!((loudest.time_s - 0.25).abs() < 5e-5);
//! ```

mod bands;
mod novelty;
mod pick;

pub use bands::BANDS;

use bands::FilterBank;
use novelty::{HopEnergies, Novelty, QuantisationStep};
use pick::Picker;
use std::collections::VecDeque;

/// A candidate for an impact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Onset {
    /// Time of the onset in seconds from the first sample.
    pub time_s: f64,
    /// Standard error of the time in seconds.
    pub sigma_s: f64,
    /// How far the onset stands out of what came before: the root of the sum of squares over the
    /// bands of the rise in energy, each in standard deviations of the rises that noise makes.
    pub strength: f64,
    /// Level of the sound that began here, in dB relative to full scale.
    pub level_db: f64,
    /// The same for each band, low to high.
    pub band_levels_db: [f32; BANDS],
    /// Level in each band before the onset, in dB: a sound below it cannot be measured.
    pub band_noise_db: [f32; BANDS],
}

impl Onset {
    /// A candidate known by its time alone: a click of equal level in all bands, without noise.
    pub fn click(time_s: f64) -> Self {
        Self {
            time_s,
            sigma_s: 1e-4,
            strength: 30.0,
            level_db: -20.0,
            band_levels_db: [-27.0; BANDS],
            band_noise_db: [-90.0; BANDS],
        }
    }
}

/// Seconds for each value of band energy.
const HOP_S: f64 = 0.0005;
/// A candidate is the strongest moment this far to both sides.
const SPACING_S: f64 = 0.006;
/// The bar for a candidate. White noise hardly reaches it, other backgrounds a few times a second.
const BAR: f64 = 2.0;
/// Samples that are no longer needed are dropped when there are this many of them.
const SPARE: usize = 1 << 14;

/// Finds onset candidates in a stream of samples, in constant memory.
#[derive(Clone)]
pub struct Detector {
    sample_rate_hz: f64,
    hop: usize,
    spacing: usize,
    bank: FilterBank,
    energies: HopEnergies,
    step: QuantisationStep,
    picker: Picker,
    /// The latest moments, `2 * spacing` of them at most, with the candidate in the middle.
    moments: VecDeque<Novelty>,
    /// The latest samples, and the number of the first of them in the stream.
    samples: Vec<f32>,
    first_sample: u64,
    /// How many of `samples` have been through the filters.
    filtered: usize,
    last_onset_s: f64,
}

impl Detector {
    /// A detector for samples at this rate.
    pub fn new(sample_rate_hz: u32) -> Self {
        let sample_rate_hz = f64::from(sample_rate_hz.max(1));
        let hop = ((sample_rate_hz * HOP_S).round() as usize).max(1);
        let bank = FilterBank::new(sample_rate_hz);
        let hop_s = hop as f64 / sample_rate_hz;
        Self {
            sample_rate_hz,
            hop,
            spacing: (SPACING_S / hop_s).round().max(1.0) as usize,
            energies: HopEnergies::new(&bank, hop_s),
            bank,
            step: QuantisationStep::default(),
            picker: Picker::new(sample_rate_hz),
            moments: VecDeque::new(),
            samples: Vec::new(),
            first_sample: 0,
            filtered: 0,
            last_onset_s: f64::NEG_INFINITY,
        }
    }

    /// Takes the next samples and appends the candidates they complete to `onsets`, in order of
    /// time. A sample that is not finite counts as 0.
    pub fn push(&mut self, samples: &[f32], onsets: &mut Vec<Onset>) {
        self.samples
            .extend(samples.iter().map(|s| if s.is_finite() { *s } else { 0.0 }));
        while self.filtered + self.hop <= self.samples.len() {
            let hop = &self.samples[self.filtered..self.filtered + self.hop];
            self.step.see(hop);
            let energies = self.bank.energies(hop);
            self.filtered += self.hop;
            if let Some(moment) = self.energies.push(energies, self.step.power()) {
                self.moments.push_back(moment);
                self.consider_middle(onsets);
            }
        }
        self.forget();
    }

    /// Ends the stream and appends the last candidates.
    pub fn finish(mut self, onsets: &mut Vec<Onset>) {
        let end_s = (self.first_sample as f64 + self.samples.len() as f64) / self.sample_rate_hz;
        let before = onsets.len();
        // As if the last value went on: the last moments get their look ahead.
        let hold = self.samples.last().copied().unwrap_or(0.0);
        let look_ahead = (2 * self.spacing + self.energies.look_ahead() + 1) * self.hop;
        self.push(&vec![hold; look_ahead], onsets);
        // Where the sound breaks off is not an onset.
        let last = onsets.partition_point(|o| o.time_s < end_s - 2.0 * HOP_S);
        onsets.truncate(last.max(before));
    }

    /// Makes a candidate of the moment in the middle, if none nearby is stronger.
    fn consider_middle(&mut self, onsets: &mut Vec<Onset>) {
        if self.moments.len() <= 2 * self.spacing {
            return;
        }
        let middle = self.moments[self.spacing];
        let is_peak = middle.strength >= BAR
            && self
                .moments
                .range(..self.spacing)
                .all(|m| m.strength < middle.strength)
            && self
                .moments
                .range(self.spacing + 1..)
                .all(|m| m.strength <= middle.strength);
        self.moments.pop_front();
        if is_peak {
            let onset = self.onset(&middle);
            // Two peaks may share one onset, as of an impact with a loud echo.
            if onset.time_s > self.last_onset_s + SPACING_S / 2.0 {
                self.last_onset_s = onset.time_s;
                onsets.push(onset);
            }
        }
    }

    fn onset(&mut self, moment: &Novelty) -> Onset {
        let rough = (moment.hop * self.hop as u64 - self.first_sample) as usize;
        let pick = self.picker.pick(&self.samples, rough, self.step.power());
        Onset {
            time_s: ((self.first_sample + pick.sample as u64) as f64 + pick.after)
                / self.sample_rate_hz,
            sigma_s: pick.sigma / self.sample_rate_hz,
            strength: moment.strength,
            level_db: decibels(moment.gain.iter().sum()),
            band_levels_db: moment.gain.map(|g| decibels(g) as f32),
            band_noise_db: moment.before.map(|n| decibels(n) as f32),
        }
    }

    /// Drops the samples that no later candidate needs.
    fn forget(&mut self) {
        let oldest_hop = self.moments.front().map_or(0, |m| m.hop);
        let needed = (oldest_hop * self.hop as u64)
            .saturating_sub(self.picker.history() as u64)
            .saturating_sub(self.first_sample) as usize;
        if needed > SPARE {
            self.samples.drain(..needed);
            self.filtered -= needed;
            self.first_sample += needed as u64;
        }
    }
}

fn decibels(power: f64) -> f64 {
    10.0 * power.max(1e-14).log10()
}
