//! Samples to onset candidates, each with a time, its standard error and a strength.
//!
//! The detector is adaptive: it has no threshold in volts or decibels. A candidate is a moment at
//! which the energy of the next few milliseconds exceeds the energy of the last few by much, in
//! units of the chance fluctuation of noise of that bandwidth. Several bands are watched at
//! once, because a table-tennis ball is loudest above 6 kHz, a basketball below 400 Hz. All
//! filters are causal, so they smear nothing to before the onset.
//!
//! The time of a candidate is its *onset*, not its peak: it is picked from the waveform as
//! seismologists pick the arrival of a wave (`pick`).
//!
//! The minimum strength is low on purpose: [`crate::train`] decides which candidates are impacts. All numbers are in
//! `parameters`.
//!
//! ```
//! use bouncelab::onset::OnsetDetector;
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
//! let mut detector = OnsetDetector::new(44_100);
//! detector.push(&samples, &mut onsets);
//! detector.finish(&mut onsets);
//! let loudest = onsets.iter().max_by(|a, b| a.level_db.total_cmp(&b.level_db)).unwrap();
//! assert!((loudest.time_s - 0.25).abs() < 5e-5);
//! ```

mod bands;
mod decimate;
mod floor;
mod history;
mod novelty;
mod octaves;
mod parameters;
mod pick;

pub use bands::BANDS;
pub(crate) use history::History;

use crate::error::{Error, Result};
use crate::simd::dispatch;
use bands::FilterBank;
use decimate::Decimator;
use floor::QuantisationStep;
use novelty::{HopEnergies, Novelty};
use parameters::{
    CLICK_BAND_LEVEL_DB, CLICK_BAND_NOISE_DB, CLICK_LEVEL_DB, CLICK_SIGMA_S, CLICK_STRENGTH,
    END_HOPS, FRAME_HOPS, MAX_PRECURSOR_S, MIN_DECIBEL_POWER, MIN_DISTINCT_STRENGTH, MIN_STRENGTH,
    SPACING_S, STEP_DIVISOR,
};
use pick::Picker;
use std::borrow::Cow;
use std::ops::Range;

/// A candidate for an impact.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Onset {
    /// Time of the onset in seconds from the first sample.
    pub time_s: f64,
    /// Standard error of the time in seconds.
    pub sigma_s: f64,
    /// How much louder the onset is than what came before: the root of the sum of squares over the
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
    /// A candidate of which only the time is given: a click of equal level in all bands, without noise.
    ///
    /// ```
    /// use bouncelab::onset::Onset;
    /// use bouncelab::train;
    ///
    /// // Times read off an oscilloscope: e = 0.9 without air.
    /// let times_s = [0.0, 0.4, 0.76, 1.084, 1.3756, 1.63804, 1.874236];
    /// let search = train::find(&times_s.map(Onset::click));
    /// assert_eq!(search.trains[0].impacts().len(), 7);
    /// ```
    pub fn click(time_s: f64) -> Self {
        Self {
            time_s,
            sigma_s: CLICK_SIGMA_S,
            strength: CLICK_STRENGTH,
            level_db: CLICK_LEVEL_DB,
            band_levels_db: [CLICK_BAND_LEVEL_DB; BANDS],
            band_noise_db: [CLICK_BAND_NOISE_DB; BANDS],
        }
    }

    /// Whether noise alone hardly makes such a candidate. Fainter candidates are informative where they are rare.
    pub(crate) fn stands_out(&self) -> bool {
        self.strength >= MIN_DISTINCT_STRENGTH
    }
}

/// The bands that are watched at this sample rate, low to high, in Hz.
///
/// ```
/// let bands_hz = bouncelab::onset::bands_hz(48_000);
/// assert_eq!(bands_hz[0], 80.0..400.0);
/// assert_eq!(bands_hz[4], 12_000.0..24_000.0);
/// ```
pub fn bands_hz(sample_rate_hz: u32) -> Vec<Range<f64>> {
    FilterBank::new(Decimator::of_rate(sample_rate_hz).1).bands_hz()
}

/// Finds onset candidates in a stream of samples, in constant memory.
///
/// The samples are processed in frames of some 30 ms, so a candidate comes up to a tenth of a
/// second late, and does not depend on the blocks in which the samples come. Rates above 96 kHz are
/// lowered to it first.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct OnsetDetector {
    decimator: Option<Decimator>,
    /// Rate of the samples that are analysed, Hz.
    rate_hz: f64,
    /// Hops between two candidates, and at most between a precursor and its sound.
    spacing: u64,
    precursor: u64,
    bank: FilterBank,
    energies: HopEnergies,
    step: QuantisationStep,
    picker: Picker,
    /// The latest moments of at least the minimum strength.
    moments: Vec<Novelty>,
    /// Number of the first moment that may still become a candidate.
    open: u64,
    history: History,
    /// Whether the owner decides which samples are forgotten.
    remembers: bool,
    /// Number of the next frame.
    frame: u64,
    /// Samples around a moment.
    around: Vec<f32>,
    last_onset_s: f64,
}

impl OnsetDetector {
    /// A detector for samples at this rate.
    pub fn new(sample_rate_hz: u32) -> Self {
        let (decimator, rate_hz) = Decimator::of_rate(sample_rate_hz);
        Self::with(FilterBank::new(rate_hz), rate_hz, decimator)
    }

    /// A detector that uses only the bands of which at least half lies between these frequencies.
    ///
    /// # Errors
    /// [`Error::NoBand`] if less than half of every band lies between them.
    ///
    /// ```
    /// use bouncelab::onset::OnsetDetector;
    ///
    /// assert!(OnsetDetector::within(48_000, &(400.0..4000.0)).is_ok());
    /// assert!(OnsetDetector::within(48_000, &(30_000.0..40_000.0)).is_err());
    /// ```
    pub fn within(sample_rate_hz: u32, range_hz: &Range<f64>) -> Result<Self> {
        let (decimator, rate_hz) = Decimator::of_rate(sample_rate_hz);
        let mut bank = FilterBank::new(rate_hz);
        if bank.watch(range_hz.start, range_hz.end) {
            Ok(Self::with(bank, rate_hz, decimator))
        } else {
            Err(Error::no_band(range_hz, &bank.bands_hz()))
        }
    }

    fn with(bank: FilterBank, rate_hz: f64, decimator: Option<Decimator>) -> Self {
        let hop_s = bank.hop as f64 / rate_hz;
        Self {
            decimator,
            rate_hz,
            spacing: novelty::hops(SPACING_S, hop_s) as u64,
            precursor: novelty::hops(MAX_PRECURSOR_S, hop_s) as u64,
            energies: HopEnergies::new(&bank, hop_s),
            step: QuantisationStep::new(),
            picker: Picker::new(rate_hz),
            moments: Vec::new(),
            open: 0,
            history: History::new(bank.frame()),
            remembers: false,
            frame: 0,
            around: Vec::new(),
            last_onset_s: f64::NEG_INFINITY,
            bank,
        }
    }

    /// Sets whether it keeps every sample until its owner forgets it.
    pub(crate) fn set_remembering(&mut self, remembers: bool) {
        self.remembers = remembers;
    }

    /// Rate of the samples that are remembered, Hz: lower than that of the sound if that is high.
    pub(crate) fn rate_hz(&self) -> f64 {
        self.rate_hz
    }

    /// Whether the samples are remembered at the rate at which they come.
    pub(crate) fn is_plain(&self) -> bool {
        self.decimator.is_none()
    }

    /// The samples that are remembered.
    pub(crate) fn history(&self) -> &History {
        &self.history
    }

    /// The samples that are remembered.
    pub(crate) fn history_mut(&mut self) -> &mut History {
        &mut self.history
    }

    /// Takes the next samples and appends the candidates that they complete to `onsets`, in order of
    /// time. A sample that is not finite counts as 0.
    ///
    /// ```
    /// use bouncelab::demo;
    /// use bouncelab::onset::OnsetDetector;
    ///
    /// let sound = demo::sound(&demo::history()?, 1)?;
    /// let (mut detector, mut onsets) = (OnsetDetector::new(sound.sample_rate_hz), Vec::new());
    /// for block in sound.samples.chunks(4096) {
    ///     detector.push(block, &mut onsets);
    /// }
    /// detector.finish(&mut onsets);
    /// assert!(onsets.len() >= 50);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn push(&mut self, samples: &[f32], onsets: &mut Vec<Onset>) {
        self.push_finite(&finite(samples), onsets);
    }

    /// The same for finite samples.
    pub(crate) fn push_finite(&mut self, samples: &[f32], onsets: &mut Vec<Onset>) {
        match self.decimator.take() {
            None => self.detect(samples, onsets),
            Some(mut decimator) => {
                self.detect(decimator.push(samples), onsets);
                self.decimator = Some(decimator);
            }
        }
    }

    fn detect(&mut self, samples: &[f32], onsets: &mut Vec<Onset>) {
        let mut rest = samples;
        while !rest.is_empty() {
            let taken = self.history.push(rest);
            rest = &rest[taken..];
            while self.history.end() >= (self.frame + 1) * self.bank.frame() as u64 {
                self.process_frame();
                self.settle(onsets);
                if !self.remembers {
                    self.forget();
                }
            }
        }
    }

    /// Ends the stream and appends the last candidates.
    pub fn finish(mut self, onsets: &mut Vec<Onset>) {
        self.flush(onsets);
    }

    /// Appends the last candidates; nothing can be pushed after this.
    pub(crate) fn flush(&mut self, onsets: &mut Vec<Onset>) {
        if let Some(mut decimator) = self.decimator.take() {
            self.detect(decimator.finish(), onsets);
        }
        let end = self.history.end();
        let before = onsets.len();
        // The last value is repeated, so that the last moments have the samples after them that their evaluation needs.
        let mut last_sample = Vec::new();
        self.history
            .read(end.saturating_sub(1)..end, &mut last_sample);
        let hold = last_sample.first().copied().unwrap_or(0.0);
        let look_ahead = (self.spacing + self.precursor) as usize;
        let hops = look_ahead + self.energies.look_ahead() + 1 + FRAME_HOPS;
        let length = hops * self.bank.hop + self.bank.delay();
        self.detect(&vec![hold; length], onsets);
        let end_s = (end as f64 - END_HOPS * self.bank.hop as f64) / self.rate_hz;
        let kept = onsets.partition_point(|o| o.time_s < end_s);
        onsets.truncate(kept.max(before));
    }

    /// Measures the next frame and appends the moments of at least the minimum strength.
    fn process_frame(&mut self) {
        let frame = self.history.frame(self.frame);
        self.frame += 1;
        dispatch(
            #[inline(always)]
            || {
                // A part of each frame suffices for the steps of the format.
                self.step.measure(&frame[..frame.len() / STEP_DIVISOR]);
                let energies = self.bank.energies(frame);
                self.energies.push(
                    &energies,
                    self.step.power(),
                    MIN_STRENGTH,
                    &mut self.moments,
                );
            },
        );
    }

    /// Makes candidates of the moments that are the strongest nearby.
    fn settle(&mut self, onsets: &mut Vec<Onset>) {
        let look_ahead = self.spacing + self.precursor;
        let settled = self.energies.evaluated().saturating_sub(look_ahead);
        let first = self.moments.partition_point(|m| m.hop < self.open);
        let end = self.moments.partition_point(|m| m.hop < settled);
        for index in first..end {
            if self.is_strongest(index) {
                let onset = self.onset(self.moments[index]);
                // Two peaks may share one onset, such as those of an impact and its loud echo.
                if onset.time_s > self.last_onset_s + SPACING_S / 2.0 {
                    self.last_onset_s = onset.time_s;
                    onsets.push(onset);
                }
            }
        }
        self.open = settled;
        let near = settled.saturating_sub(self.spacing);
        let past = self.moments.partition_point(|m| m.hop < near);
        self.moments.drain(..past);
    }

    /// Whether this moment is no precursor and the strongest nearby; precursors of other sounds do not count.
    fn is_strongest(&self, index: usize) -> bool {
        let (before, rest) = self.moments.split_at(index);
        let Some((moment, after)) = rest.split_first() else {
            return false;
        };
        let mut earlier = before
            .iter()
            .enumerate()
            .rev()
            .take_while(|(_, m)| m.hop + self.spacing >= moment.hop)
            .filter(|(_, m)| m.strength >= moment.strength);
        let mut later = (index + 1..)
            .zip(after)
            .take_while(|(_, m)| m.hop <= moment.hop + self.spacing)
            .filter(|(_, m)| m.strength > moment.strength);
        !self.is_precursor(index)
            && earlier.all(|(stronger, _)| self.is_precursor(stronger))
            && later.all(|(stronger, _)| self.is_precursor(stronger))
    }

    /// Whether a much louder sound begins soon after this moment.
    fn is_precursor(&self, index: usize) -> bool {
        let moment = &self.moments[index];
        let mut soon = self.moments[index + 1..]
            .iter()
            .take_while(|m| m.hop <= moment.hop + self.precursor);
        soon.any(|later| later.dwarfs(moment))
    }

    /// The candidate of a moment: its time is picked from the waveform.
    fn onset(&mut self, moment: Novelty) -> Onset {
        let delay = self.bank.delay() as u64;
        let rough = (moment.hop * self.bank.hop as u64).saturating_sub(delay);
        let from = rough.saturating_sub(self.picker.history() as u64);
        let to = rough + self.picker.look_ahead() as u64;
        let first = self.history.read(from..to, &mut self.around);
        let index = (rough - first) as usize;
        let pick = dispatch(
            #[inline(always)]
            || self.picker.pick(&self.around, index, self.step.power()),
        );
        Onset {
            time_s: ((first + pick.sample as u64) as f64 + pick.after) / self.rate_hz,
            sigma_s: pick.sigma / self.rate_hz,
            strength: moment.strength,
            level_db: decibels(moment.gain.iter().sum()),
            band_levels_db: moment.gain.map(|g| decibels(g) as f32),
            band_noise_db: moment.before.map(|n| decibels(n) as f32),
        }
    }

    /// Forgets the samples that no later candidate needs.
    fn forget(&mut self) {
        let needed = self.open * self.bank.hop as u64;
        let back = (self.picker.history() + self.bank.delay()) as u64;
        self.history.forget_before(needed.saturating_sub(back));
    }
}

/// The same samples; those that are not finite become 0.
pub(crate) fn finite(samples: &[f32]) -> Cow<'_, [f32]> {
    // 0 x is 0 for a finite x and NaN for any other. Without an early exit the loop runs in wide registers.
    const LANES: usize = 16;
    let mut sums = [0.0_f32; LANES];
    let (chunks, rest) = samples.as_chunks::<LANES>();
    for chunk in chunks {
        for (sum, x) in sums.iter_mut().zip(chunk) {
            *sum += 0.0 * x;
        }
    }
    if sums.iter().any(|sum| sum.is_nan()) || rest.iter().any(|x| !x.is_finite()) {
        let clean = samples.iter().map(|x| if x.is_finite() { *x } else { 0.0 });
        Cow::Owned(clean.collect())
    } else {
        Cow::Borrowed(samples)
    }
}

fn decibels(power: f64) -> f64 {
    10.0 * power.max(MIN_DECIBEL_POWER).log10()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A second at 48 kHz of noise at -100 dB, louder by this factor in this time before a click
    /// at 0.5 s: pre-echo of a codec.
    fn click_after(pre_echo_s: f64, pre_echo: f32) -> Vec<f32> {
        let mut state = 1_u32;
        (0..48_000)
            .map(|n| {
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                let noise = 1e-5 * ((state >> 8) as f32 / 8e6 - 1.0);
                let t = f64::from(n) / 48_000.0 - 0.5;
                let click = (-t / 0.004).exp() * (6e3 * std::f64::consts::TAU * t).cos();
                match t {
                    0.0.. => noise + 0.5 * click as f32,
                    _ if t > -pre_echo_s => pre_echo * noise,
                    _ => noise,
                }
            })
            .collect()
    }

    fn onsets(samples: &[f32]) -> Vec<Onset> {
        let mut onsets = Vec::new();
        let mut detector = OnsetDetector::new(48_000);
        detector.push(samples, &mut onsets);
        detector.finish(&mut onsets);
        onsets.retain(|onset| onset.time_s > 0.45);
        onsets
    }

    /// Pre-echo 40 dB above the noise and 50 dB below the click: nothing begins there.
    #[test]
    fn an_impact_begins_where_its_sound_does_not_where_pre_echo_does() {
        let clean = onsets(&click_after(0.0, 1.0));
        assert_eq!(clean.len(), 1, "{clean:?}");
        for pre_echo_s in [0.002, 0.003, 0.005, 0.008] {
            let detected = onsets(&click_after(pre_echo_s, 100.0));
            assert_eq!(detected.len(), 1, "{pre_echo_s}: {detected:?}");
            assert!(
                (detected[0].time_s - 0.5).abs() < 1e-4,
                "{pre_echo_s}: {detected:?}"
            );
            let louder_db = detected[0].level_db - clean[0].level_db;
            assert!(louder_db.abs() < 4.0, "{pre_echo_s}: {louder_db}");
        }
    }
}
