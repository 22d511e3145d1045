//! The ringing of the impacts before, which is subtracted from the sound of the next one.
//!
//! The impacts of a drop sound alike, and those that a silence follows show how they ring. This
//! ringing is subtracted at the level that it has before a later impact: it
//! would pull the time of the impact towards its own phase, and it is no noise.

use super::sound::{Cut, Span};
use super::wave::{dot, resample};
use crate::stats::sort_by_number;
use crate::train::parameters::{
    KERNEL_REACH, MAX_DECAYED_RATIO, MIN_RINGING_SILENCES, RINGING_BLOCKS, RINGING_SILENCES,
};

/// Subtracts the ringing of the impacts before from each cut, if enough of them fit to measure how they
/// ring.
pub(super) fn remove(cuts: &mut [Cut], recording: &[f32], span: &Span) {
    let Some(sound) = whole_sound(cuts, recording, span) else {
        return;
    };
    let quiet = ..span.noise + span.quiet();
    let mut earlier: Vec<(f64, f32)> = Vec::new();
    for cut in cuts {
        let first = cut.first as f64;
        earlier.retain(|(at, _)| first - at < sound.len() as f64);
        let ringing = sum(&sound, &earlier, first, cut.samples.len());
        // As much of it as is in the noise before the impact.
        let share = level(&cut.samples[quiet], &ringing[quiet]).clamp(0.0, 1.0);
        for (sample, ringing) in cut.samples.iter_mut().zip(&ringing) {
            *sample -= share * ringing;
        }
        if cut.fits {
            let own = resample(&cut.samples, cut.at - first, span.max);
            earlier.push((cut.at, level(&own, &sound[..span.max])));
        }
    }
}

/// The sound of an impact from its time until it has decayed; `None` if too few impacts show it.
fn whole_sound(cuts: &[Cut], recording: &[f32], span: &Span) -> Option<Vec<f32>> {
    // The length and the start of the time after each impact until the next one, the longest first.
    let mut silences: Vec<(usize, f64)> = cuts
        .windows(2)
        .filter(|pair| pair[0].fits)
        .map(|pair| ((pair[1].at - pair[0].at) as usize, pair[0].at))
        .collect();
    sort_by_number(&mut silences, |(length, _)| -(*length as f64));
    let shortest = silences.get(MIN_RINGING_SILENCES - 1)?.0;
    let length = shortest.checked_sub(span.before)?.min(span.ringing);
    let block = span.ringing / RINGING_BLOCKS;
    if length < span.max + block {
        return None;
    }
    let sounds = silences
        .iter()
        .take(RINGING_SILENCES)
        .take_while(|silence| silence.0 >= length + span.before)
        .map(|&(_, at)| sound_at(recording, at, length));
    let mut sound = mean(sounds, span.max);
    fade(&mut sound, block, span.max);
    Some(sound)
}

/// The samples of the recording from this time on.
fn sound_at(recording: &[f32], at: f64, length: usize) -> Vec<f32> {
    // The interpolation needs its reach before and after, and a sample of rounding.
    let first = at as usize - KERNEL_REACH;
    let end = (first + length + 3 * KERNEL_REACH).min(recording.len());
    resample(&recording[first..end], at - first as f64, length)
}

/// The mean of sounds that differ in level only, at the level of the first (least squares); the level of each is that of
/// its first `compared` samples.
fn mean(mut sounds: impl Iterator<Item = Vec<f32>>, compared: usize) -> Vec<f32> {
    let Some(first) = sounds.next() else {
        return Vec::new();
    };
    let mut sum = first.clone();
    let mut squares = 1.0;
    for sound in sounds {
        let level = level(&sound[..compared], &first[..compared]);
        squares += level * level;
        for (sum, value) in sum.iter_mut().zip(&sound) {
            *sum += level * value;
        }
    }
    sum.iter().map(|sum| sum / squares).collect()
}

/// Subtracts from a sound its mean at the end, and fades it out over the block
/// after which it is no louder than there; its first `unchanged` samples keep their level.
fn fade(sound: &mut Vec<f32>, block: usize, unchanged: usize) {
    let end = &sound[sound.len() - block..];
    let offset = end.iter().sum::<f32>() / block as f32;
    for value in sound.iter_mut() {
        *value -= offset;
    }
    let power = |block: &[f32]| dot(block, block);
    let decayed = MAX_DECAYED_RATIO * power(&sound[sound.len() - block..]);
    let last_loud = sound.chunks_exact(block).rposition(|b| power(b) > decayed);
    let length = last_loud
        .map_or(0, |last| (last + 1) * block)
        .max(unchanged + block);
    sound.truncate(length);
    let first = sound.len().saturating_sub(block).max(unchanged);
    for (n, value) in sound[first..].iter_mut().enumerate() {
        *value *= 1.0 - n as f32 / block as f32;
    }
}

/// `length` samples from the position `first` on of the sum of a sound at these times with these levels.
fn sum(sound: &[f32], impacts: &[(f64, f32)], first: f64, length: usize) -> Vec<f32> {
    let mut sum = vec![0.0; length];
    for &(at, level) in impacts {
        for (sum, value) in sum.iter_mut().zip(resample(sound, first - at, length)) {
            *sum += level * value;
        }
    }
    sum
}

/// The factor by which a sound is contained in samples, whatever their mean (least squares).
fn level(samples: &[f32], sound: &[f32]) -> f32 {
    let mean = sound.iter().sum::<f32>() / sound.len() as f32;
    let centred: Vec<f32> = sound.iter().map(|value| value - mean).collect();
    dot(samples, &centred) / dot(&centred, &centred).max(f32::MIN_POSITIVE)
}
