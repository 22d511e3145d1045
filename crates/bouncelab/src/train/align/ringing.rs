//! What is still heard of the impacts before when the next one comes.
//!
//! The impacts of a drop sound alike, and those that a silence follows show how they ring. That
//! ringing, as far as it is heard before a later impact, is taken out of its surroundings: it
//! would draw the impact towards its own phase, and it is no noise.

use super::sound::{Cut, Span};
use super::wave::{KERNEL, dot, resample};
use crate::stats::sort_by_number;

/// So many silences show it.
const SHOWN: usize = 6;
/// Its power is looked at in so many blocks of the longest that is looked for.
const BLOCKS: usize = 10;
/// It has died down where its power is no more than this times that at the end.
const LEAST_POWER: f32 = 2.0;

/// Takes the ringing of those before out of each cut, if they fit well enough to tell how they
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
        let share = level(&cut.samples[quiet], &ringing[quiet]).clamp(0.0, 1.0);
        for (sample, ringing) in cut.samples.iter_mut().zip(&ringing) {
            *sample -= share * ringing;
        }
        if cut.fits {
            let own = resample(&cut.samples, cut.at - first, span.most);
            earlier.push((cut.at, level(&own, &sound[..span.most])));
        }
    }
}

/// The sound of an impact until it has died down, from its time on; nothing if too few show it.
fn whole_sound(cuts: &[Cut], recording: &[f32], span: &Span) -> Option<Vec<f32>> {
    /// Fewer could be odd ones.
    const FEWEST: usize = 3;
    let silences = cuts.windows(2).filter(|pair| pair[0].fits);
    let mut silences: Vec<(usize, f64)> = silences
        .map(|pair| ((pair[1].at - pair[0].at) as usize, pair[0].at))
        .collect();
    sort_by_number(&mut silences, |(length, _)| -(*length as f64));
    let length = silences.get(FEWEST - 1)?.0.checked_sub(span.before)?;
    let length = length.min(span.ringing);
    if length < span.most + span.ringing / BLOCKS {
        return None;
    }
    let shown = silences.iter().take(SHOWN);
    let shown = shown.take_while(|silence| silence.0 >= length + span.before);
    let sounds = shown.map(|&(_, at)| sound_at(recording, at, length));
    let mut sound = mean(sounds, span.most);
    fade(&mut sound, span.ringing / BLOCKS, span.most);
    Some(sound)
}

/// What is heard from this time on.
fn sound_at(recording: &[f32], at: f64, length: usize) -> Vec<f32> {
    let first = at as usize - KERNEL;
    let end = (first + length + 3 * KERNEL).min(recording.len());
    resample(&recording[first..end], at - first as f64, length)
}

/// The mean of sounds that are alike but for their levels, at the level of the first; this much
/// of each tells its level.
fn mean(mut sounds: impl Iterator<Item = Vec<f32>>, telling: usize) -> Vec<f32> {
    let Some(first) = sounds.next() else {
        return Vec::new();
    };
    let mut sum = first.clone();
    let mut squares = 1.0;
    for sound in sounds {
        let level = level(&sound[..telling], &first[..telling]);
        squares += level * level;
        for (sum, value) in sum.iter_mut().zip(&sound) {
            *sum += level * value;
        }
    }
    sum.iter().map(|sum| sum / squares).collect()
}

/// Takes out of a sound the level about which it swings in the end, and fades it out over the block
/// after which it is no louder than there; this much of it stays as it is.
fn fade(sound: &mut Vec<f32>, block: usize, kept: usize) {
    let end = &sound[sound.len() - block..];
    let offset = end.iter().sum::<f32>() / block as f32;
    for value in sound.iter_mut() {
        *value -= offset;
    }
    let power = |block: &[f32]| dot(block, block);
    let least = LEAST_POWER * power(&sound[sound.len() - block..]);
    let loud = sound.chunks_exact(block).rposition(|b| power(b) > least);
    let length = loud.map_or(0, |loud| (loud + 1) * block).max(kept + block);
    sound.truncate(length);
    let first = sound.len().saturating_sub(block).max(kept);
    for (n, value) in sound[first..].iter_mut().enumerate() {
        *value *= 1.0 - n as f32 / block as f32;
    }
}

/// So many samples from a position on, of a sound that began at these times with these levels.
fn sum(sound: &[f32], begun: &[(f64, f32)], first: f64, length: usize) -> Vec<f32> {
    let mut sum = vec![0.0; length];
    for &(at, level) in begun {
        for (sum, value) in sum.iter_mut().zip(resample(sound, first - at, length)) {
            *sum += level * value;
        }
    }
    sum
}

/// How loud one sound is in another, whatever the level about which that swings, in units of its
/// own loudness.
fn level(heard: &[f32], sound: &[f32]) -> f32 {
    let mean = sound.iter().sum::<f32>() / sound.len() as f32;
    let sound: Vec<f32> = sound.iter().map(|value| value - mean).collect();
    dot(heard, &sound) / dot(&sound, &sound).max(f32::MIN_POSITIVE)
}
