//! Times below a sample, from what the impacts of one drop have in common.
//!
//! The impacts of a drop sound alike. Their waveforms, whitened, are laid over each other by the
//! picked times and stacked; each is then shifted to where it fits the stack of the others best.
//! This uses the whole of each sound where a pick uses its first fraction of a millisecond, and
//! does not depend on loudness. It is done twice: the first time tells how the impacts ring, which is
//! taken out for the second. What a shift leaves unexplained gives its standard error, as the
//! Cramer-Rao bound for the arrival time of a known waveform in noise:
//! var(t) = var(noise) / sum (a s'(t))^2. In much noise a shift by a whole period of the sound may fit
//! as well: the error also holds how far off those shifts are that are nearly as probable.

mod ringing;
mod sound;
mod template;
mod wave;

use super::evidence::ln_level;
use super::{TrainImpact, UNHEARD};
use crate::onset::Onset;
use crate::stats::{median, sort_by_number};
use sound::{Sound, Span, cut_out, noise_power, whitened};
use template::{Doubt, Left, Template, middle_size, stack, usual_difference, weight};
use wave::{convolve, running_energy, smoothing};

/// What sounds after that holds less than this share of the energy.
const LEAST_SHARE: f64 = 0.03;
/// Each pass knows from the one before where the impacts are, and so how they ring. Times settle to
/// well below their errors in so many rounds.
const ROUNDS: [usize; 2] = [1, 3];
/// The first round finds where the impacts agree, the second how many do.
const AGREEMENT_ROUNDS: usize = 2;
/// High frequencies are smoothed away while this share of the energy of the impacts is kept: what
/// little they hold is steep.
const LEAST_KEPT: f64 = 0.97;
/// So many of the loudest impacts are asked.
const TRIED: usize = 6;

/// Moves the times of these impacts to where their waveforms agree, and says which of them agree
/// and begin there. Only the first `picked` were picked; the others, which have the level of the one before,
/// get their own, and agree only if it may be theirs.
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
    for rounds in ROUNDS {
        span = Span::new(rate_hz);
        let mut cuts = cut_out(&positions, &fits, samples, &span);
        // With fewer there is no stack of others to speak of.
        if cuts.len() < 3 {
            return fits;
        }
        ringing::remove(&mut cuts, samples, &span);
        sounds = whitened(&cuts, &onsets, rate_hz, &span);
        lay_over(&mut sounds, &mut span, rounds);
        for sound in &sounds {
            fits[sound.impact] = sound.fits;
            positions[sound.impact] += sound.shift;
        }
    }
    let settled = || sounds.iter().filter(|sound| sound.fits);
    let doubts: Vec<&Doubt> = settled().filter_map(|sound| sound.doubt.as_ref()).collect();
    let difference = usual_difference(&doubts);
    for sound in settled() {
        let onset = &mut impacts[sound.impact].onset;
        onset.time_s = start_s + positions[sound.impact] / rate_hz;
        if let Some(doubt) = &sound.doubt {
            let error = doubt.shift_error(difference);
            onset.sigma_s = error.hypot(sound.ambiguity.sqrt()) / rate_hz;
        }
        fits[sound.impact] = sound.begins(&span);
    }
    for (sound, level_db) in levels_db(impacts, picked, &sounds) {
        let onset = &mut impacts[sound.impact].onset;
        let ln_odds = sound.ln_odds + ln_level(level_db - onset.level_db);
        fits[sound.impact] &= ln_odds > (UNHEARD / (1.0 - UNHEARD)).ln();
        onset.level_db = level_db;
    }
    fits
}

/// The levels of the impacts that were not picked, from how much louder those are that were.
fn levels_db<'a>(
    impacts: &[TrainImpact],
    picked: usize,
    sounds: &'a [Sound],
) -> Vec<(&'a Sound, f64)> {
    let fitting = sounds.iter().filter(|sound| sound.fits);
    let relative = fitting.filter_map(|sound| {
        let energy = sound.doubt.as_ref()?.energy;
        Some((sound, 10.0 * energy.log10()))
    });
    let (known, unknown): (Vec<_>, Vec<_>) = relative.partition(|(sound, _)| sound.impact < picked);
    let known = known.iter();
    let full_scale = median(known.map(|(sound, db)| impacts[sound.impact].onset.level_db - db));
    let Some(full_scale_db) = full_scale else {
        return Vec::new();
    };
    let unknown = unknown.into_iter();
    unknown
        .map(|(sound, db)| (sound, full_scale_db + db))
        .collect()
}

/// How many impacts agree with the stack of the others, and how many of some other sounds with the stack
/// of all; of how many each.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Agreement {
    pub(super) impacts: (usize, usize),
    pub(super) others: (usize, usize),
}

/// How far these impacts, and other sounds, agree with the impacts.
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
    // With fewer there is no stack of others to speak of.
    if sounds.len() < 3 {
        return Agreement::default();
    }
    let smoothing = smooth(&mut sounds, &span);
    smooth_by(&smoothing, &mut others, &span);
    span.length = span.before + sounding(&sounds, &span);
    for _ in 0..AGREEMENT_ROUNDS {
        let stack = Stack::of(&sounds, &span);
        for (index, sound) in sounds.iter_mut().enumerate() {
            sound.find_likest(&stack.without(index), &span);
        }
    }
    let count = |sounds: &[Sound]| (sounds.iter().filter(|s| s.fits).count(), sounds.len());
    let impacts = count(&sounds);
    // Where the impacts have nothing in common there is nothing that others could share.
    if impacts.0 < 2 {
        return Agreement {
            impacts,
            others: (0, 0),
        };
    }
    let stack = Stack::of(&sounds, &span);
    for sound in &mut others {
        sound.find_likest(&stack.sum, &span);
    }
    Agreement {
        impacts,
        others: count(&others),
    }
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
        let middle = middle_size(&waves);
        Self {
            weights: waves.iter().map(|wave| weight(wave, middle)).collect(),
            sum: stack(&waves, middle),
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

/// Lays the sounds over each other and shifts each to where it fits the stack of the others.
fn lay_over(sounds: &mut [Sound], span: &mut Span, rounds: usize) {
    let smoothing = smooth(sounds, span);
    span.length = span.before + sounding(sounds, span);
    for round in 0..rounds {
        let stack = Stack::of(sounds, span);
        // How much noise of one wave is in the stack.
        let noise: f32 = stack.weights.iter().map(|weight| weight.powi(2)).sum();
        let left = Left::new(&stack.sum, &smoothing);
        for (index, sound) in sounds.iter_mut().enumerate() {
            let (wave, own) = (&stack.waves[index], stack.weights[index]);
            let others = stack.without(index);
            let template = Template::new(&others, noise - own * own, own);
            if round == 0 {
                sound.find(&others, span);
            } else if sound.fits {
                sound.settle(&template, wave, &left, span);
            }
        }
        keep_mean(sounds);
    }
}

/// Only differences of time have a meaning: the stack as a whole stays where the picks are.
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

/// Takes out the high frequencies in which the impacts do not sound: they would drown the slope
/// of a dull thump. Returns the weights.
fn smooth(sounds: &mut [Sound], span: &Span) -> Vec<f32> {
    let loudness = |energy: &[f64], noise: f64| {
        let (first, end) = (span.origin, span.origin + span.most);
        (energy[end] - energy[first] - noise * span.most as f64).max(0.0)
    };
    let mut loudest: Vec<(f64, usize)> = (0..sounds.len())
        .map(|n| (loudness(&sounds[n].energy, sounds[n].noise), n))
        .filter(|&(loudness, _)| loudness > 0.0)
        .collect();
    sort_by_number(&mut loudest, |(loudness, _)| -loudness);
    loudest.truncate(TRIED);
    let kept = |kernel: &[f32]| {
        let shares = loudest.iter().map(|&(before, n)| {
            let energy = running_energy(&convolve(&sounds[n].samples, kernel));
            loudness(&energy, noise_power(&energy, span)) / before
        });
        shares.sum::<f64>() / loudest.len() as f64
    };
    let mut kernels = [16, 8, 4, 2, 1].map(smoothing).into_iter();
    let Some(kernel) = kernels.find(|kernel| kept(kernel) > LEAST_KEPT) else {
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

/// How long the impacts sound, in samples after their times.
fn sounding(sounds: &[Sound], span: &Span) -> usize {
    let energy_in = |sound: &Sound, first: usize, length: usize| {
        let first = span.origin + first;
        let noise = sound.noise * length as f64;
        (sound.energy[first + length] - sound.energy[first] - noise).max(0.0)
    };
    let share_after = |after: usize| {
        let shares = sounds.iter().filter_map(|sound| {
            let all = energy_in(sound, 0, span.most);
            (all > 0.0).then(|| energy_in(sound, after, span.most - after) / all)
        });
        let shares: Vec<f64> = shares.collect();
        shares.iter().sum::<f64>() / shares.len().max(1) as f64
    };
    (span.least..span.most)
        .step_by(span.least / 4 + 1)
        .find(|&after| share_after(after) < LEAST_SHARE)
        .unwrap_or(span.most)
}
