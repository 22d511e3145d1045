//! Times to a fraction of a sample, from the common waveform of the impacts of one drop.
//!
//! The impacts of a drop sound alike. Their waveforms, whitened, are aligned by the
//! picked times and stacked; each is then shifted to where it fits the stack of the others best.
//! This uses the whole of each sound where a pick uses its first fraction of a millisecond, and
//! does not depend on loudness. There are two passes: the first measures how the impacts ring, and the ringing is
//! subtracted for the second. The residual of a shift gives its standard error by the
//! Cramér-Rao bound for the arrival time of a known waveform in noise:
//! var(t) = var(noise) / sum (a s'(t))^2. In much noise a shift by a whole period of the sound may fit
//! as well: the error includes the distance of those shifts that are nearly as probable.

mod ringing;
mod sound;
mod template;
mod wave;

use super::TrainImpact;
use super::evidence::ln_level;
use super::parameters::{
    AGREEMENT_ROUNDS, ALIGNMENT_ROUNDS, MIN_AGREEING, MIN_KEPT_ENERGY, MIN_LATER_SHARE,
    MIN_STACKED, REVEALED_PROBABILITY, SMOOTHING_IMPACTS, SMOOTHING_REACHES,
};
use crate::onset::Onset;
use crate::stats::{median, sort_by_number};
use sound::{Sound, Span, cut_out, noise_power, whitened};
use template::{
    SmoothedNoise, Template, Uncertainty, median_size, stack, usual_difference, weight,
};
use wave::{convolve, running_energy, smoothing};

/// Moves the times of these impacts to where their waveforms agree, and returns which of them agree
/// and begin there. Only the first `picked` were picked. The others have the level of the impact before; they
/// get their own, and agree only if it is a probable one.
/// `samples` begin at `start_s` of the recording; impacts too near their ends keep their times.
pub(super) fn align(
    impacts: &mut [TrainImpact],
    picked: usize,
    samples: &[f32],
    start_s: f64,
    rate_hz: f64,
) -> Vec<bool> {
    let mut fits = vec![false; impacts.len()];
    let mut positions: Vec<f64> = impacts
        .iter()
        .map(|impact| (impact.onset.time_s - start_s) * rate_hz)
        .collect();
    let onsets: Vec<Onset> = impacts.iter().map(|impact| impact.onset).collect();
    let mut span = Span::new(rate_hz);
    let mut sounds = Vec::new();
    for rounds in ALIGNMENT_ROUNDS {
        span = Span::new(rate_hz);
        let mut cuts = cut_out(&positions, &fits, samples, &span);
        if cuts.len() < MIN_STACKED {
            return fits;
        }
        ringing::remove(&mut cuts, samples, &span);
        sounds = whitened(&cuts, &onsets, rate_hz, &span);
        align_sounds(&mut sounds, &mut span, rounds);
        for sound in &sounds {
            fits[sound.impact] = sound.fits;
            positions[sound.impact] += sound.shift;
        }
    }
    let settled = || sounds.iter().filter(|sound| sound.fits);
    let uncertainties: Vec<&Uncertainty> = settled()
        .filter_map(|sound| sound.uncertainty.as_ref())
        .collect();
    let difference = usual_difference(&uncertainties);
    for sound in settled() {
        let onset = &mut impacts[sound.impact].onset;
        onset.time_s = start_s + positions[sound.impact] / rate_hz;
        if let Some(uncertainty) = &sound.uncertainty {
            let error = uncertainty.shift_error(difference);
            onset.sigma_s = error.hypot(sound.ambiguity.sqrt()) / rate_hz;
        }
        fits[sound.impact] = sound.begins(&span);
    }
    for (sound, level_db) in levels_db(impacts, picked, &sounds) {
        let onset = &mut impacts[sound.impact].onset;
        let ln_odds = sound.ln_odds + ln_level(level_db - onset.level_db);
        fits[sound.impact] &= ln_odds > (REVEALED_PROBABILITY / (1.0 - REVEALED_PROBABILITY)).ln();
        onset.level_db = level_db;
    }
    fits
}

/// The levels of the impacts that were not picked, relative to those that were.
fn levels_db<'a>(
    impacts: &[TrainImpact],
    picked: usize,
    sounds: &'a [Sound],
) -> Vec<(&'a Sound, f64)> {
    let fitting = sounds.iter().filter(|sound| sound.fits);
    let relative = fitting.filter_map(|sound| {
        let energy = sound.uncertainty.as_ref()?.energy;
        Some((sound, 10.0 * energy.log10()))
    });
    let (with_level, without): (Vec<_>, Vec<_>) =
        relative.partition(|(sound, _)| sound.impact < picked);
    // The level of an impact of energy 1.
    let references_db = with_level
        .iter()
        .map(|(sound, db)| impacts[sound.impact].onset.level_db - db);
    let Some(reference_db) = median(references_db) else {
        return Vec::new();
    };
    without
        .into_iter()
        .map(|(sound, db)| (sound, reference_db + db))
        .collect()
}

/// Which sounds agree with the impacts of a drop.
pub(super) struct Agreement {
    /// The number of impacts that agree with the stack of the others, and of those compared.
    pub(super) impacts: (usize, usize),
    /// Whether each other sound agrees with the stack of all impacts; `None` if it is not compared.
    pub(super) others: Vec<Option<bool>>,
}

/// Compares impacts, and other sounds, with the impacts.
pub(super) fn agreement(
    impacts: &[Onset],
    others: &[Onset],
    samples: &[f32],
    start_s: f64,
    rate_hz: f64,
) -> Agreement {
    let onsets = [impacts, others].concat();
    let positions: Vec<f64> = onsets
        .iter()
        .map(|onset| (onset.time_s - start_s) * rate_hz)
        .collect();
    let mut span = Span::new(rate_hz);
    let cuts = cut_out(&positions, &vec![false; onsets.len()], samples, &span);
    let mut sounds = whitened(&cuts, &onsets, rate_hz, &span);
    let mut others: Vec<Sound> = sounds
        .extract_if(.., |sound| sound.impact >= impacts.len())
        .collect();
    let mut agreement = Agreement {
        impacts: (0, 0),
        others: vec![None; onsets.len() - impacts.len()],
    };
    if sounds.len() < MIN_STACKED {
        return agreement;
    }
    let smoothing = smooth(&mut sounds, &span);
    smooth_by(&smoothing, &mut others, &span);
    span.length = span.before + audible_length(&sounds, &span);
    for _ in 0..AGREEMENT_ROUNDS {
        let stack = Stack::of(&sounds, &span);
        for (index, sound) in sounds.iter_mut().enumerate() {
            sound.find_most_similar(&stack.without(index), &span);
        }
    }
    let agreeing = sounds.iter().filter(|sound| sound.fits).count();
    agreement.impacts = (agreeing, sounds.len());
    // If the impacts have no common waveform, other sounds cannot share it.
    if agreeing < MIN_AGREEING {
        return agreement;
    }
    let stack = Stack::of(&sounds, &span);
    for sound in &mut others {
        sound.find_most_similar(&stack.sum, &span);
        agreement.others[sound.impact - impacts.len()] = Some(sound.fits);
    }
    agreement
}

/// One of `factor` samples, each a mean of those around it, without the frequencies that would fold back.
pub(super) fn lowered(samples: &[f32], factor: usize) -> Vec<f32> {
    let smooth = convolve(samples, &smoothing(factor));
    smooth.into_iter().step_by(factor).collect()
}

/// The waves of some sounds, and their sum.
struct Stack {
    waves: Vec<Vec<f32>>,
    weights: Vec<f32>,
    sum: Vec<f32>,
}

impl Stack {
    fn of(sounds: &[Sound], span: &Span) -> Self {
        let waves: Vec<Vec<f32>> = sounds.iter().map(|s| s.wave(span, s.shift)).collect();
        let median_size = median_size(&waves);
        Self {
            weights: waves.iter().map(|wave| weight(wave, median_size)).collect(),
            sum: stack(&waves, median_size),
            waves,
        }
    }

    /// The sum of all waves but one.
    fn without(&self, index: usize) -> Vec<f32> {
        let (wave, own) = (&self.waves[index], self.weights[index]);
        let pairs = self.sum.iter().zip(wave);
        pairs.map(|(sum, value)| sum - value * own).collect()
    }
}

/// Shifts each sound to where it fits the stack of the others.
fn align_sounds(sounds: &mut [Sound], span: &mut Span, rounds: usize) {
    let smoothing = smooth(sounds, span);
    span.length = span.before + audible_length(sounds, span);
    for round in 0..rounds {
        let stack = Stack::of(sounds, span);
        // The power of noise in the stack over that in one wave.
        let noise: f32 = stack.weights.iter().map(|weight| weight.powi(2)).sum();
        let smoothed = SmoothedNoise::new(&stack.sum, &smoothing);
        for (index, sound) in sounds.iter_mut().enumerate() {
            let (wave, own) = (&stack.waves[index], stack.weights[index]);
            let others = stack.without(index);
            let template = Template::new(&others, noise - own * own, own);
            // The first round finds the shift to a sample among all that are possible, later ones refine it.
            if round == 0 {
                sound.find(&others, span);
            } else if sound.fits {
                sound.settle(&template, wave, &smoothed, span);
            }
        }
        keep_mean(sounds);
    }
}

/// Subtracts the mean shift, weighted by the errors of the picks: only differences of time have a meaning, so the stack as
/// a whole stays at the picks.
fn keep_mean(sounds: &mut [Sound]) {
    let (mut weights, mut sum) = (0.0, 0.0);
    for sound in sounds.iter().filter(|s| s.fits) {
        let weight = sound.pick_sigma.powi(-2);
        weights += weight;
        sum += weight * sound.shift;
    }
    if weights > 0.0 {
        for sound in sounds.iter_mut().filter(|s| s.fits) {
            sound.shift -= sum / weights;
        }
    }
}

/// Removes the high frequencies in which the impacts have no energy: their noise would drown the slope
/// of a dull thump. Returns the kernel.
fn smooth(sounds: &mut [Sound], span: &Span) -> Vec<f32> {
    let loudness = |energy: &[f64], noise: f64| {
        let (first, end) = (span.origin, span.origin + span.max);
        (energy[end] - energy[first] - noise * span.max as f64).max(0.0)
    };
    let mut loudest: Vec<(f64, usize)> = (0..sounds.len())
        .map(|n| (loudness(&sounds[n].energy, sounds[n].noise), n))
        .filter(|&(loudness, _)| loudness > 0.0)
        .collect();
    sort_by_number(&mut loudest, |(loudness, _)| -loudness);
    loudest.truncate(SMOOTHING_IMPACTS);
    let kept = |kernel: &[f32]| {
        let shares = loudest.iter().map(|&(before, n)| {
            let energy = running_energy(&convolve(&sounds[n].samples, kernel));
            loudness(&energy, noise_power(&energy, span)) / before
        });
        shares.sum::<f64>() / loudest.len() as f64
    };
    let mut kernels = SMOOTHING_REACHES.map(smoothing).into_iter();
    let Some(kernel) = kernels.find(|kernel| kept(kernel) > MIN_KEPT_ENERGY) else {
        return vec![1.0];
    };
    smooth_by(&kernel, sounds, span);
    kernel
}

fn smooth_by(kernel: &[f32], sounds: &mut [Sound], span: &Span) {
    for sound in sounds {
        sound.samples = convolve(&sound.samples, kernel);
        sound.energy = running_energy(&sound.samples);
        sound.noise = noise_power(&sound.energy, span);
    }
}

/// How long the impacts are audible, in samples after their times.
fn audible_length(sounds: &[Sound], span: &Span) -> usize {
    let energy_in = |sound: &Sound, first: usize, length: usize| {
        let first = span.origin + first;
        let noise = sound.noise * length as f64;
        (sound.energy[first + length] - sound.energy[first] - noise).max(0.0)
    };
    let share_after = |after: usize| {
        let shares = sounds.iter().filter_map(|sound| {
            let all = energy_in(sound, 0, span.max);
            (all > 0.0).then(|| energy_in(sound, after, span.max - after) / all)
        });
        let (mut sum, mut count) = (0.0, 0);
        for share in shares {
            sum += share;
            count += 1;
        }
        sum / f64::from(count.max(1))
    };
    (span.min..span.max)
        .step_by(span.min / 4 + 1)
        .find(|&after| share_after(after) < MIN_LATER_SHARE)
        .unwrap_or(span.max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    /// A tone of this frequency at 44.1 kHz, its rate lowered eightfold, beside what it should be.
    fn lowered_tone(tone_hz: f64) -> Vec<(f64, f64)> {
        let value = |n: f64| (TAU * tone_hz * n / 44_100.0).sin();
        let tone: Vec<f32> = (0..4410).map(|n| value(f64::from(n)) as f32).collect();
        let kept = lowered(&tone, 8).into_iter().enumerate().map(f64_pair);
        let inside = kept.skip(2).take(540);
        inside.map(|(n, x)| (x, value(8.0 * n))).collect()
    }

    fn f64_pair((n, x): (usize, f32)) -> (f64, f64) {
        (n as f64, x.into())
    }

    /// The Hann window has its first zero at 4.9 kHz, and side lobes of 31 dB.
    #[test]
    fn a_lower_rate_keeps_low_tones_in_time_and_loses_high_ones() {
        assert!(
            lowered_tone(200.0)
                .iter()
                .all(|(x, tone)| (x - tone).abs() < 0.01)
        );
        assert!(lowered_tone(8000.0).iter().all(|(x, _)| x.abs() < 0.03));
    }
}
