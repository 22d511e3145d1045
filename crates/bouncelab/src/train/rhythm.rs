//! Sounds that keep time: the third explanation, after a drop and unrelated sounds.
//!
//! People knock, clap, walk and drum at intervals of their own choice, and they speed up; machines tick.
//! Their intervals differ from those of a ball: each is a new attempt at the same tempo, so
//! their logarithms scatter about a line, while the energy that a ball loses in one impact it lacks in all
//! later flights. A tempo changes slowly, if at all, where the flights of a ball shrink by several
//! percent. An engine, a voice or a string makes pulses of its own rate, which wanders up and
//! down, where no flight of a ball is longer than the one before.

use super::chain::{self, Link};
use super::evidence;
use super::parameters::{
    HIDDEN_S, LN_OUTLIER_INTERVAL, MAX_BEAT_OFFSET, MAX_LN_TEMPO_CHANGE, MAX_MISSING_BEATS,
    MAX_PARTS, MIN_DIVISIONS, OVER_BEAT_DB, PULSE_CHANGES, TEMPO_MODELS,
};
use crate::onset::Onset;
use crate::stats::{median, softplus};
use std::f64::consts::TAU;

/// How well a person or a machine keeps time.
pub(super) struct TempoModel {
    /// Scatter of an interval, as a share of it.
    pub(super) jitter: f64,
    /// Change of the tempo from one interval to the next, as a share of it.
    pub(super) drift: f64,
}

/// An interval: its number in the rhythm, and its logarithm.
#[derive(Clone, Copy)]
pub(super) struct Beat {
    pub(super) number: f64,
    pub(super) ln_interval: f64,
}

impl Beat {
    pub(super) fn interval_s(&self) -> f64 {
        self.ln_interval.exp()
    }
}

/// Log likelihood of these intervals, given the first, if they keep a tempo or are those of
/// a pulse.
pub(super) fn ln_likelihood(beats: &[Beat]) -> f64 {
    let tempo = ln_mean(&TEMPO_MODELS.map(|model| model.ln_likelihood(beats.to_vec())));
    let pulse = ln_mean(&PULSE_CHANGES.map(|change| ln_pulse(beats, change)));
    // ln(exp a + exp b) without overflow.
    tempo.max(pulse) + softplus(-(tempo - pulse).abs())
}

/// The most likely number of intervals after which a ball ends and a pulse continues. `ball` are the log densities of each
/// change from one interval to the next for the ball. Each of the two keeps at least `min` intervals.
pub(super) fn likeliest_beginning(beats: &[Beat], ball: &[f64], min: usize) -> Option<usize> {
    let best_of_pulse = |pulse_change: f64| {
        // Log likelihood of the pulse over the ball for each change.
        let gains: Vec<f64> = beats
            .windows(2)
            .zip(ball)
            .map(|(pair, ball)| {
                let change = pair[1].ln_interval - pair[0].ln_interval;
                evidence::ln_ratio(change, pulse_change * pulse_change) - ball
            })
            .collect();
        // Their sum from each index to the end is the gain if the pulse begins there.
        let mut sum = 0.0;
        let from_each = gains.iter().enumerate().rev().map(|(index, gain)| {
            sum += gain;
            (sum, index)
        });
        let allowed = min..=gains.len().saturating_sub(min);
        from_each
            .filter(|(_, index)| allowed.contains(index))
            .max_by(|a, b| a.0.total_cmp(&b.0))
    };
    let best = PULSE_CHANGES
        .into_iter()
        .filter_map(best_of_pulse)
        .max_by(|a, b| a.0.total_cmp(&b.0));
    best.map(|(_, index)| index)
}

/// Sounds that keep time among others.
pub(super) struct Pulse<'a> {
    onsets: &'a [Onset],
    is_beat: Vec<bool>,
    /// Maximum level of a beat; a louder sound is another one over the beat.
    max_db: f64,
}

impl<'a> Pulse<'a> {
    /// A pulse whose beats are about as loud as these onsets; it has no beats yet.
    pub(super) fn like(onsets: &'a [Onset], links: &[Link]) -> Self {
        let levels_db = links.iter().map(|link| onsets[link.onset].level_db);
        Self {
            onsets,
            is_beat: vec![false; onsets.len()],
            max_db: median(levels_db).unwrap_or(0.0) + OVER_BEAT_DB,
        }
    }

    /// Adds the beats of a chain, those that divide its intervals evenly, and those that continue it to both sides.
    pub(super) fn take(&mut self, links: &[Link]) {
        for link in links {
            self.mark(link.onset);
        }
        let parts = self.parts(links);
        for pair in links.windows(2) {
            for (time_s, max_off_s) in self.divisions(pair, parts) {
                if let Some(index) = self.find(time_s, max_off_s) {
                    self.mark(index);
                }
            }
        }
        let beats = chain::beats(self.onsets, links);
        let part_s = |beat: Beat| beat.interval_s() / f64::from(parts);
        self.follow(links[0].onset, -part_s(beats[0]));
        let last = links.len() - 1;
        self.follow(links[last].onset, part_s(beats[last - 1]));
    }

    /// The number of parts into which other sounds of the pulse divide the intervals of a chain: a chain takes every second
    /// or third beat of a fast pulse, since no ball begins with flights so short.
    fn parts(&self, links: &[Link]) -> u32 {
        let is_pulse = |parts: &u32| {
            let divisions = links
                .windows(2)
                .flat_map(|pair| self.divisions(pair, *parts));
            let (mut detected, mut all) = (0.0, 0.0);
            for (time_s, max_off_s) in divisions {
                all += 1.0;
                detected += f64::from(u8::from(self.find(time_s, max_off_s).is_some()));
            }
            detected > MIN_DIVISIONS * all
        };
        (2..=MAX_PARTS).rev().find(is_pulse).unwrap_or(1)
    }

    /// The times that divide an interval evenly, and the maximum distance of a beat from them, s.
    fn divisions(&self, pair: &[Link], parts: u32) -> impl Iterator<Item = (f64, f64)> + use<> {
        let [from_s, to_s] = [pair[0], pair[1]].map(|link| self.onsets[link.onset].time_s);
        let all = (pair[1].number - pair[0].number) * parts;
        let part_s = (to_s - from_s) / f64::from(all);
        (1..all).map(move |n| (from_s + f64::from(n) * part_s, MAX_BEAT_OFFSET * part_s))
    }

    /// Adds the beats that continue from this onset on, backwards if the interval is negative.
    pub(super) fn follow(&mut self, from: usize, interval_s: f64) {
        let max_missing = MAX_MISSING_BEATS.max((HIDDEN_S / interval_s.abs()) as u32);
        let mut last_s = self.onsets[from].time_s;
        let mut missing = 0;
        while missing <= max_missing {
            let next_s = last_s + f64::from(missing + 1) * interval_s;
            if let Some(index) = self.find(next_s, MAX_BEAT_OFFSET * interval_s.abs()) {
                self.mark(index);
                last_s = self.onsets[index].time_s;
                missing = 0;
            } else {
                missing += 1;
            }
        }
    }

    /// The onset nearest to this time, if it is nearer than `max_off_s`.
    fn find(&self, time_s: f64, max_off_s: f64) -> Option<usize> {
        let distance_s = |index: &usize| (self.onsets[*index].time_s - time_s).abs();
        let after = self.onsets.partition_point(|o| o.time_s < time_s);
        let near = after.saturating_sub(1)..(after + 1).min(self.onsets.len());
        near.min_by(|a, b| distance_s(a).total_cmp(&distance_s(b)))
            .filter(|index| distance_s(index) < max_off_s)
    }

    fn mark(&mut self, index: usize) {
        let is_over = self.onsets[index].level_db > self.max_db;
        self.is_beat[index] = !is_over;
    }

    /// The onsets that are its beats, or those that are not.
    pub(super) fn onsets(&self, are_beats: bool) -> impl Iterator<Item = (usize, &Onset)> {
        let all = self.onsets.iter().enumerate();
        all.filter(move |(index, _)| self.is_beat[*index] == are_beats)
    }
}

/// Logarithm of the mean of numbers that are given by their logarithms.
pub(super) fn ln_mean(logarithms: &[f64]) -> f64 {
    let max = logarithms.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let sum: f64 = logarithms.iter().map(|ln| (ln - max).exp()).sum();
    max + (sum / logarithms.len() as f64).ln()
}

/// Log likelihood of these intervals for a pulse: each is like the last within this relative change, and occasionally
/// different (the tails of the Student distribution), such as where an octave is sung.
fn ln_pulse(beats: &[Beat], pulse_change: f64) -> f64 {
    let changes = beats
        .windows(2)
        .map(|p| p[1].ln_interval - p[0].ln_interval);
    changes
        .map(|change| evidence::ln_ratio(change, pulse_change * pulse_change))
        .sum()
}

impl TempoModel {
    /// Log likelihood of these intervals. Those that are better explained as outliers are left out, the worst first.
    fn ln_likelihood(&self, mut beats: Vec<Beat>) -> f64 {
        let mut line = Line::through(&beats, self);
        let mut ln_outliers = 0.0;
        while beats.len() > 2 {
            beats.remove(line.farthest(&beats));
            let without = Line::through(&beats, self);
            if without.ln_likelihood + LN_OUTLIER_INTERVAL <= line.ln_likelihood {
                break;
            }
            ln_outliers += LN_OUTLIER_INTERVAL;
            line = without;
        }
        line.ln_likelihood + ln_outliers
    }
}

/// A tempo that changes steadily.
struct Line {
    /// The mean of the beats.
    centre: Beat,
    slope: f64,
    ln_likelihood: f64,
}

impl Line {
    /// The most probable line. Its level has a flat prior, its slope a normal one about 0 with the drift as its standard
    /// deviation, and the beats scatter about it normally with the jitter: a regression with one known variance, whose
    /// marginal likelihood has a closed form.
    fn through(beats: &[Beat], model: &TempoModel) -> Self {
        let count = beats.len() as f64;
        let centre = Beat {
            number: beats.iter().map(|b| b.number).sum::<f64>() / count,
            ln_interval: beats.iter().map(|b| b.ln_interval).sum::<f64>() / count,
        };
        let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
        for beat in beats {
            let x = beat.number - centre.number;
            let y = beat.ln_interval - centre.ln_interval;
            xx += x * x;
            xy += x * y;
            yy += y * y;
        }
        let drift = model.drift.min(MAX_LN_TEMPO_CHANGE / count);
        let (jitter2, drift2) = (model.jitter.powi(2), drift.powi(2));
        // The posterior mean of the slope.
        let slope = drift2 * xy / (jitter2 + drift2 * xx);
        let misfit = (yy - slope * xy) / jitter2 + (count - 1.0) * (TAU * jitter2).ln();
        // The determinants that integrating over slope and level leaves.
        let determinants = (1.0 + drift2 * xx / jitter2).ln() + count.ln();
        Self {
            centre,
            slope,
            ln_likelihood: -0.5 * (misfit + determinants),
        }
    }

    /// The index of the beat that is farthest from the line.
    fn farthest(&self, beats: &[Beat]) -> usize {
        let off = |beat: &Beat| {
            let x = beat.number - self.centre.number;
            (beat.ln_interval - self.centre.ln_interval - self.slope * x).abs()
        };
        (0..beats.len())
            .max_by(|&a, &b| off(&beats[a]).total_cmp(&off(&beats[b])))
            .unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use crate::onset::Onset;
    use crate::train::{TrainSearch, find};
    use std::f64::consts::TAU;

    /// Sounds at these intervals, each fainter than the last by half a decibel.
    fn search(intervals_s: impl Iterator<Item = f64>) -> TrainSearch {
        let mut time_s = 0.0;
        let onsets = intervals_s.zip(0_u8..).map(|(interval_s, n)| {
            time_s += interval_s;
            let mut onset = Onset::click(time_s);
            onset.level_db -= 0.5 * f64::from(n);
            onset.strength -= 0.25 * f64::from(n);
            onset
        });
        find(&onsets.collect::<Vec<_>>())
    }

    /// A bass whose rate swings by 3 % every 24 pulses.
    #[test]
    fn a_pulse_whose_rate_wanders_is_no_drop() {
        let swing = |n: i32| 1.0 + 0.03 * (TAU * f64::from(n) / 24.0).cos();
        let result = search((0..36).map(|n| 0.06 * swing(n)));
        assert_eq!(result.trains.len(), 0);
        assert!(!result.periodic.is_empty());
    }

    /// Steel on amorphous metal: the ratio of its flights is 0.984, and scatters by half a percent.
    #[test]
    fn a_ball_that_hardly_loses_height_is_a_drop() {
        let result = search((0..60).map(|n| {
            let scatter = 0.005 * (f64::from(n) * 2.4).sin();
            0.18 * 0.984_f64.powi(n) * (1.0 + scatter)
        }));
        assert_eq!(result.trains.len(), 1);
        assert!(result.trains[0].impacts().len() >= 58);
    }
}
