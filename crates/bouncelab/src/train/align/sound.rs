//! The whitened sound around one impact, and the time in it at which the impact begins.

use super::template::{Noise, SmoothedNoise, Template, Uncertainty};
use super::wave::{cross_correlation, norm, resample, running_energy};
use crate::onset::Onset;
use crate::simd::{LANES, Lanes, dispatch, sum_of_exp};
use crate::stats::sort_by_number;
use crate::train::parameters::{
    KERNEL_REACH, MAX_RINGING_S, MAX_SHIFT_S, MAX_SHIFT_SIGMA, MAX_WAVE_AFTER_S, MIN_AGREEMENT,
    MIN_CORRELATION, MIN_SHIFT_ODDS, MIN_SHIFT_S, MIN_WAVE_AFTER_S, NOISE_S,
    SAMPLES_PER_INDEPENDENT, WAVE_BEFORE_S, WRONG_PICK_SHARE,
};
use crate::whiten::{self, Autoregression};
use std::f64::consts::TAU;

/// Lengths in samples at one rate.
pub(super) struct Span {
    /// Index of the picked time in the samples of a sound.
    pub(super) origin: usize,
    /// Compared part: its samples before the picked time, and all of them.
    pub(super) before: usize,
    pub(super) length: usize,
    /// Minimum and maximum length after the picked time.
    pub(super) min: usize,
    pub(super) max: usize,
    /// Minimum and maximum of the largest shift that is tried.
    pub(super) min_shift: f64,
    pub(super) max_shift: f64,
    /// The noise before, and the longest ringing.
    pub(super) noise: usize,
    pub(super) ringing: usize,
}

impl Span {
    pub(super) fn new(rate_hz: f64) -> Self {
        let samples = |time_s: f64| (time_s * rate_hz).ceil() as usize;
        let before = samples(WAVE_BEFORE_S);
        let max_shift = samples(MAX_SHIFT_S).max(2);
        Self {
            origin: before + max_shift + KERNEL_REACH,
            before,
            length: before + samples(MAX_WAVE_AFTER_S),
            min: samples(MIN_WAVE_AFTER_S),
            max: samples(MAX_WAVE_AFTER_S),
            min_shift: samples(MIN_SHIFT_S).max(2) as f64,
            max_shift: max_shift as f64,
            noise: samples(NOISE_S).max(4 * whiten::ORDER),
            ringing: samples(MAX_RINGING_S),
        }
    }

    /// Samples of a sound that lie before the impact at any shift.
    pub(super) fn quiet(&self) -> usize {
        self.origin - self.before - self.min_shift as usize
    }

    /// Samples of a sound after its origin.
    fn after(&self) -> usize {
        self.max + self.max_shift as usize + KERNEL_REACH + 1
    }
}

/// The whitened sound around one impact.
pub(super) struct Sound {
    pub(super) impact: usize,
    /// Samples on a grid that has the picked time at its origin.
    pub(super) samples: Vec<f32>,
    /// Energy of the samples before each sample.
    pub(super) energy: Vec<f64>,
    /// Power of the noise before the impact, and its power before smoothing, which is its density in the
    /// remaining band.
    pub(super) noise: f64,
    pub(super) density: f64,
    /// Maximum distance of the impact from its pick, in samples.
    pub(super) reach: usize,
    /// Standard error of the pick in samples.
    pub(super) pick_sigma: f64,
    /// Time of the impact, in samples after its pick.
    pub(super) shift: f64,
    /// Variance of the shift because other shifts fit as well, in samples squared.
    pub(super) ambiguity: f64,
    /// Log odds that it sounds like the others.
    pub(super) ln_odds: f64,
    /// Whether it fits the others.
    pub(super) fits: bool,
    /// The sources of the error of the shift, once it is settled.
    pub(super) uncertainty: Option<Uncertainty>,
}

/// The samples around one impact, and before them the noise from which the whitening is learnt.
pub(super) struct Cut {
    impact: usize,
    /// Its time, and the first of the samples, in samples of the recording.
    pub(super) at: f64,
    pub(super) first: usize,
    pub(super) samples: Vec<f32>,
    /// Whether it fitted the others in the pass before.
    pub(super) fits: bool,
}

/// Cuts out the impacts at these positions, in order of time, except those too near the ends of
/// the samples.
pub(super) fn cut_out(positions: &[f64], fits: &[bool], samples: &[f32], span: &Span) -> Vec<Cut> {
    let cut = |(impact, &at): (usize, &f64)| {
        let first = (at as usize).checked_sub(span.origin + span.noise)?;
        let end = at as usize + span.after() + KERNEL_REACH;
        Some(Cut {
            impact,
            at,
            first,
            samples: samples.get(first..end)?.to_vec(),
            fits: fits[impact],
        })
    };
    let mut cuts: Vec<Cut> = positions.iter().enumerate().filter_map(cut).collect();
    sort_by_number(&mut cuts, |cut| cut.at);
    cuts
}

/// The cuts less what a linear prediction, learnt from the noise before all of them, predicts.
pub(super) fn whitened(cuts: &[Cut], onsets: &[Onset], rate_hz: f64, span: &Span) -> Vec<Sound> {
    let noises = cuts.iter().map(|cut| &cut.samples[..span.noise]);
    let model = Autoregression::learn_from_many(noises);
    cuts.iter()
        .map(|cut| {
            let errors = dispatch(
                #[inline(always)]
                || model.errors(&cut.samples[span.noise - whiten::ORDER..]),
            );
            let pick_sigma = onsets[cut.impact].sigma_s * rate_hz;
            let samples = resample(&errors, cut.at.fract(), span.origin + span.after());
            let energy = running_energy(&samples);
            let noise = noise_power(&energy, span);
            Sound {
                impact: cut.impact,
                noise,
                density: noise,
                energy,
                samples,
                reach: (MAX_SHIFT_SIGMA * pick_sigma)
                    .clamp(span.min_shift, span.max_shift)
                    .ceil() as usize,
                pick_sigma,
                shift: 0.0,
                ambiguity: 0.0,
                ln_odds: f64::NEG_INFINITY,
                fits: cut.fits,
                uncertainty: None,
            }
        })
        .collect()
}

impl Sound {
    /// The waveform that begins this many samples after the pick.
    pub(super) fn wave(&self, span: &Span, shift: f64) -> Vec<f32> {
        let first = (span.origin - span.before) as f64 + shift;
        resample(&self.samples, first, span.length)
    }

    /// Whether a sound begins here: the ringing of the impact before may look similar, but decays.
    pub(super) fn begins(&self, span: &Span) -> bool {
        let length = span.origin - span.before;
        // The mean of the others may have shifted it to beyond the cut.
        let last = self.energy.len() - 1 - length;
        let start = ((length as f64 + self.shift).max(0.0) as usize).min(last);
        let energy = |first: usize| self.energy[first + length] - self.energy[first];
        energy(start) > energy(start.saturating_sub(length))
    }

    /// Finds the most probable shift at which the sound fits the stack of the others, and its ambiguity.
    pub(super) fn find(&mut self, others: &[f32], span: &Span) {
        let correlations = self.correlations(others, span);
        let ln_odds = self.ln_odds(&correlations, span);
        self.ln_odds = sum_of_exp(&ln_odds).ln();
        let best = best_peak(&correlations, &ln_odds).filter(|&best| {
            self.ln_odds > MIN_SHIFT_ODDS.ln() && correlations[best] > MIN_CORRELATION
        });
        self.take(best, &correlations);
        self.ambiguity = best.map_or(0.0, |best| ambiguity(best, &correlations, &ln_odds));
    }

    /// Finds the shift at which the sound is most similar to the stack of the others, all shifts being equally probable.
    pub(super) fn find_most_similar(&mut self, others: &[f32], span: &Span) {
        let correlations = self.correlations(others, span);
        let peak = best_peak(&correlations, &correlations);
        let agreeing = peak.filter(|&peak| correlations[peak] > MIN_AGREEMENT);
        self.take(agreeing, &correlations);
    }

    /// Takes the shift of one of these correlations, if any, interpolated by a parabola.
    fn take(&mut self, best: Option<usize>, correlations: &[f64]) {
        self.fits = best.is_some();
        self.shift = best.map_or(0.0, |best| {
            best as f64 - self.reach as f64 + vertex(&correlations[best - 1..=best + 1])
        });
    }

    /// Refines the shift and measures its uncertainty, by the wave at the shift so far.
    pub(super) fn settle(
        &mut self,
        template: &Template,
        wave: &[f32],
        smoothed: &SmoothedNoise,
        span: &Span,
    ) {
        let noise = Noise {
            power: self.noise,
            samples: span.quiet() as f64,
            correlated: self.density / self.noise.max(f64::MIN_POSITIVE),
            density: self.density * smoothed.where_steep,
            slope: self.density * smoothed.slope,
        };
        let fit = template.fit(wave);
        self.shift += template.step(&fit);
        self.uncertainty = Some(template.uncertainty(&fit, &noise));
    }

    /// The correlation with the others for every shift by whole samples within reach.
    fn correlations(&self, others: &[f32], span: &Span) -> Vec<f64> {
        let scale = f64::from(norm(others));
        let first = span.origin - span.before - self.reach;
        let within = &self.samples[first..][..2 * self.reach + span.length];
        let products = cross_correlation(within, others).into_iter().zip(first..);
        let correlations = products.map(|(product, first)| {
            let energy = self.energy[first + span.length] - self.energy[first];
            f64::from(product) / (energy.max(f64::MIN_POSITIVE).sqrt() * scale)
        });
        correlations.collect()
    }

    /// For each of these correlations, the log odds that the sound begins there, over that it
    /// does not sound like the others.
    ///
    /// In white noise of unknown power, a waveform of unknown level makes `n` samples that correlate with it by `r`
    /// `(1 - r^2)^(-n/2)` times as likely (the profile likelihood ratio). The prior of the shift is normal with the standard
    /// error of the pick, and uniform for a share of the picks that are wrong.
    fn ln_odds(&self, correlations: &[f64], span: &Span) -> Vec<f64> {
        // Smoothing correlates neighbouring samples, in proportion to the power that it removes.
        let correlated =
            SAMPLES_PER_INDEPENDENT * (self.density / self.noise.max(f64::MIN_POSITIVE)).max(1.0);
        let count = span.length as f64 / correlated;
        let sigma = self.pick_sigma.max(1.0);
        let anywhere = WRONG_PICK_SHARE / correlations.len() as f64;
        let mut ln_odds = Vec::with_capacity(correlations.len() + LANES);
        dispatch(
            #[inline(always)]
            || {
                for first in (0..correlations.len()).step_by(LANES) {
                    let index = Lanes::<LANES>::of(|lane| (first + lane) as f64);
                    let off = (index - self.reach as f64) / sigma;
                    let near = (off * off * -0.5).exp() / (TAU.sqrt() * sigma);
                    let prior = near * (1.0 - WRONG_PICK_SHARE) + anywhere;
                    let explained = Lanes::of(|lane| {
                        let correlation = correlations.get(first + lane);
                        correlation.map_or(0.0, |correlation| correlation.max(0.0).powi(2))
                    });
                    let unexplained = (-explained + 1.0).max(f64::EPSILON);
                    ln_odds.extend((prior.ln() - unexplained.ln() * (0.5 * count)).0);
                }
            },
        );
        ln_odds.truncate(correlations.len());
        ln_odds
    }
}

/// The peak of these values at which `score` is largest.
fn best_peak(values: &[f64], score: &[f64]) -> Option<usize> {
    peaks(values).reduce(|best, peak| {
        if score[peak] > score[best] {
            peak
        } else {
            best
        }
    })
}

/// The indices of the values that are greater than those before and after.
fn peaks(values: &[f64]) -> impl Iterator<Item = usize> {
    let threes = values.windows(3).enumerate();
    threes.filter_map(|(before, near)| match *near {
        [left, top, right] if top >= left && top > right => Some(before + 1),
        _ => None,
    })
}

/// The vertex of the parabola through three values, in steps from the middle one.
fn vertex(values: &[f64]) -> f64 {
    let (left, top, right) = (values[0], values[1], values[2]);
    0.5 * (left - right) / (left - 2.0 * top + right)
}

/// The mean square distance of the true shift from the best one, if it is that of some peak.
fn ambiguity(best: usize, correlations: &[f64], ln_odds: &[f64]) -> f64 {
    let (mut weights, mut sum) = (0.0, 0.0);
    for peak in peaks(correlations) {
        let weight = (ln_odds[peak] - ln_odds[best]).exp();
        weights += weight;
        sum += weight * (peak as f64 - best as f64).powi(2);
    }
    sum / weights
}

/// Power of the noise before an impact.
pub(super) fn noise_power(energy: &[f64], span: &Span) -> f64 {
    energy[span.quiet()] / span.quiet() as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_impact_shifted_out_of_its_sound_does_not_begin() {
        let span = Span::new(44_100.0);
        let fading = (0..span.origin + span.after()).map(|n| 0.99_f32.powf(n as f32));
        let samples: Vec<f32> = fading.collect();
        for shift in [-1e4, -400.0, 0.0, 400.0, 1e4] {
            let sound = Sound {
                impact: 0,
                energy: running_energy(&samples),
                samples: samples.clone(),
                noise: 1e-6,
                density: 1e-6,
                reach: 1,
                pick_sigma: 1.0,
                shift,
                ambiguity: 0.0,
                ln_odds: 0.0,
                fits: false,
                uncertainty: None,
            };
            assert!(!sound.begins(&span), "{shift}");
            assert_eq!(sound.wave(&span, shift).len(), span.length);
        }
    }
}
