//! The whitened surroundings of one impact, and where in them it begins.

use super::template::{Doubt, Left, Noise, Template};
use super::wave::{KERNEL, cross_correlation, norm, resample, running_energy};
use crate::onset::Onset;
use crate::simd::{LANES, Lanes, dispatch, sum_of_exp};
use crate::stats::sort_by_number;
use crate::whiten::{self, Autoregression};
use std::f64::consts::TAU;

/// What is compared of each impact, in seconds before and after its time: as long as it sounds,
/// but no longer than this, lest the next one is heard in it.
const BEFORE_S: f64 = 0.0005;
const AFTER_S: f64 = 0.0025;
const MOST_AFTER_S: f64 = 0.008;
/// The longest that an impact is heard to ring, in seconds.
const RINGING_S: f64 = 0.1;
/// The noise before an impact from which the whitening is learnt, in seconds.
const NOISE_S: f64 = 0.010;
/// The farthest an impact is shifted, in seconds, and in standard errors of its pick.
const FARTHEST_S: f64 = 0.006;
/// A pick may be surer of itself than it should be, in the ringing of the impact before: every
/// impact is sought at least so far around its pick, in seconds.
const NEAREST_S: f64 = 0.003;
const FARTHEST_SIGMA: f64 = 6.0;
/// An impact that correlates with the others by less, or of which it is not so many times likelier that it sounds like
/// them than that it does not, keeps its pick.
///
/// Of the shortest sounds that are compared some 66 samples are independent at 44.1 kHz, so that noise correlates by 0.12
/// with them, and at the best of a hundred shifts by 0.3. Of impacts 15 % sound unlike the others (`evidence`): with odds
/// of 8 before that is counted, one in fifty would be moved to where it does not belong.
const LEAST_CORRELATION: f64 = 0.35;
const LEAST_ODDS: f64 = 8.0;
/// Sounds agree if they correlate by more than this.
const LEAST_AGREEMENT: f64 = 0.6;
/// Of so many samples one counts: what impacts differ by is not white.
const SAMPLES_ALIKE: f64 = 2.0;
/// The share of picks that are wrong by anything, and not by their standard errors.
const WRONG_PICKS: f64 = 0.1;

/// Lengths in samples at one rate.
pub(super) struct Span {
    /// The picked time lies so far inside the samples of a sound.
    pub(super) origin: usize,
    pub(super) before: usize,
    pub(super) length: usize,
    /// The least and the greatest length after the picked time.
    pub(super) least: usize,
    pub(super) most: usize,
    pub(super) nearest: f64,
    pub(super) farthest: f64,
    pub(super) noise: usize,
    pub(super) ringing: usize,
}

impl Span {
    pub(super) fn new(rate_hz: f64) -> Self {
        let samples = |time_s: f64| (time_s * rate_hz).ceil() as usize;
        let before = samples(BEFORE_S);
        let farthest = samples(FARTHEST_S).max(2);
        Self {
            origin: before + farthest + KERNEL,
            before,
            length: before + samples(MOST_AFTER_S),
            least: samples(AFTER_S),
            most: samples(MOST_AFTER_S),
            nearest: samples(NEAREST_S).max(2) as f64,
            farthest: farthest as f64,
            noise: samples(NOISE_S).max(4 * whiten::ORDER),
            ringing: samples(RINGING_S),
        }
    }

    /// Samples of a sound that lie before the impact, wherever it begins.
    pub(super) fn quiet(&self) -> usize {
        self.origin - self.before - self.nearest as usize
    }

    /// Samples of a sound after its origin.
    fn after(&self) -> usize {
        self.most + self.farthest as usize + KERNEL + 1
    }
}

/// The whitened surroundings of one impact.
pub(super) struct Sound {
    pub(super) impact: usize,
    /// Samples on a grid that has the picked time at its origin.
    pub(super) samples: Vec<f32>,
    /// Energy of the samples before each.
    pub(super) energy: Vec<f64>,
    /// Power of the noise before the impact, and what it was before smoothing: its density in the
    /// band that is left.
    pub(super) noise: f64,
    pub(super) density: f64,
    /// How far the impact may be from its pick, in samples.
    pub(super) reach: usize,
    /// Standard error of the pick in samples.
    pub(super) pick_sigma: f64,
    /// Where the impact begins, in samples after its pick.
    pub(super) shift: f64,
    /// Variance of the shift because other shifts fit as well, in samples squared.
    pub(super) ambiguity: f64,
    /// Logarithm of how much likelier it is that it sounds like the others than that it does not.
    pub(super) ln_odds: f64,
    /// Whether it fits the others.
    pub(super) fits: bool,
    /// What keeps the shift from being known, once it is settled.
    pub(super) doubt: Option<Doubt>,
}

/// The samples around one impact, and before them the noise from which the whitening is learnt.
pub(super) struct Cut {
    impact: usize,
    /// Its time, and the first of the samples, in samples of the recording.
    pub(super) at: f64,
    pub(super) first: usize,
    pub(super) samples: Vec<f32>,
    /// Whether it is known to fit the others.
    pub(super) fits: bool,
}

/// Cuts out the impacts at these positions, in order of time, but for those too near the ends of
/// the samples.
pub(super) fn cut_out(positions: &[f64], fits: &[bool], samples: &[f32], span: &Span) -> Vec<Cut> {
    let cut = |(impact, &at): (usize, &f64)| {
        let first = (at as usize).checked_sub(span.origin + span.noise)?;
        let end = at as usize + span.after() + KERNEL;
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

/// The cuts without what the noise before them foretells.
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
                reach: (FARTHEST_SIGMA * pick_sigma)
                    .clamp(span.nearest, span.farthest)
                    .ceil() as usize,
                pick_sigma,
                shift: 0.0,
                ambiguity: 0.0,
                ln_odds: f64::NEG_INFINITY,
                fits: cut.fits,
                doubt: None,
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

    /// Whether something begins here: the ringing of the impact before may look alike, but fades.
    pub(super) fn begins(&self, span: &Span) -> bool {
        let length = span.origin - span.before;
        // The others may have moved it to beyond what was cut out.
        let last = self.energy.len() - 1 - length;
        let at = ((length as f64 + self.shift).max(0.0) as usize).min(last);
        let energy = |first: usize| self.energy[first + length] - self.energy[first];
        energy(at) > energy(at.saturating_sub(length))
    }

    /// Finds the most probable shift at which the sound fits the stack of the others, and how sure it is not another.
    pub(super) fn find(&mut self, others: &[f32], span: &Span) {
        let correlations = self.correlations(others, span);
        let ln_odds = self.ln_odds(&correlations, span);
        self.ln_odds = sum_of_exp(&ln_odds).ln();
        let best = best_peak(&correlations, &ln_odds).filter(|&best| {
            self.ln_odds > LEAST_ODDS.ln() && correlations[best] > LEAST_CORRELATION
        });
        self.take(best, &correlations);
        self.ambiguity = best.map_or(0.0, |best| ambiguity(best, &correlations, &ln_odds));
    }

    /// Finds the shift at which the sound is most like the stack of the others, wherever that is.
    pub(super) fn find_likest(&mut self, others: &[f32], span: &Span) {
        let correlations = self.correlations(others, span);
        let best = best_peak(&correlations, &correlations);
        let best = best.filter(|&best| correlations[best] > LEAST_AGREEMENT);
        self.take(best, &correlations);
    }

    /// Takes the shift of one of these correlations, if any.
    fn take(&mut self, best: Option<usize>, correlations: &[f64]) {
        self.fits = best.is_some();
        self.shift = best.map_or(0.0, |best| {
            best as f64 - self.reach as f64 + vertex(&correlations[best - 1..=best + 1])
        });
    }

    /// Settles the shift and what keeps it from being known, by the wave at the shift that was found.
    pub(super) fn settle(&mut self, template: &Template, wave: &[f32], left: &Left, span: &Span) {
        let noise = Noise {
            power: self.noise,
            heard: span.quiet() as f64,
            alike: self.density / self.noise.max(f64::MIN_POSITIVE),
            density: self.density * left.where_steep,
            slope: self.density * left.slope,
        };
        let fit = template.fit(wave);
        self.shift += template.step(&fit);
        self.doubt = Some(template.doubt(&fit, &noise));
    }

    /// The correlation with the others for every shift by whole samples that is tried.
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

    /// For each of these correlations, the logarithm of how much likelier it is that the sound begins there than that
    /// it does not sound like the others.
    ///
    /// With a waveform known but for its level in white noise of unknown power, `n` samples that correlate by `r` are
    /// `(1 - r^2)^(-n/2)` times as likely as without it.
    fn ln_odds(&self, correlations: &[f64], span: &Span) -> Vec<f64> {
        let alike = SAMPLES_ALIKE * (self.density / self.noise.max(f64::MIN_POSITIVE)).max(1.0);
        let count = span.length as f64 / alike;
        let sigma = self.pick_sigma.max(1.0);
        let anywhere = WRONG_PICKS / correlations.len() as f64;
        let mut ln_odds = Vec::with_capacity(correlations.len() + LANES);
        dispatch(
            #[inline(always)]
            || {
                for first in (0..correlations.len()).step_by(LANES) {
                    let index = Lanes::<LANES>::of(|lane| (first + lane) as f64);
                    let off = (index - self.reach as f64) / sigma;
                    let near = (off * off * -0.5).exp() / (TAU.sqrt() * sigma);
                    let prior = near * (1.0 - WRONG_PICKS) + anywhere;
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

/// The peak of these values that is the best by others.
fn best_peak(values: &[f64], by: &[f64]) -> Option<usize> {
    peaks(values).reduce(|best, peak| if by[peak] > by[best] { peak } else { best })
}

/// The places of the values that are greater than those before and after.
fn peaks(values: &[f64]) -> impl Iterator<Item = usize> {
    let places = values.windows(3).enumerate();
    places.filter_map(|(before, near)| match *near {
        [left, top, right] if top >= left && top > right => Some(before + 1),
        _ => None,
    })
}

/// Where the parabola through three values has its vertex, in steps from the middle one.
fn vertex(values: &[f64]) -> f64 {
    let (left, top, right) = (values[0], values[1], values[2]);
    0.5 * (left - right) / (left - 2.0 * top + right)
}

/// The mean square of how far the true shift is from the best one, if it is that of a peak.
fn ambiguity(best: usize, correlations: &[f64], ln_odds: &[f64]) -> f64 {
    let (mut weights, mut sum) = (0.0, 0.0);
    for place in peaks(correlations) {
        let weight = (ln_odds[place] - ln_odds[best]).exp();
        weights += weight;
        sum += weight * (place as f64 - best as f64).powi(2);
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
    fn an_impact_moved_out_of_its_sound_is_survived() {
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
                doubt: None,
            };
            assert!(!sound.begins(&span), "{shift}");
            assert_eq!(sound.wave(&span, shift).len(), span.length);
        }
    }
}
