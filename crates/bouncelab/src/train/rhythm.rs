//! Sounds that keep time: the third explanation, beside a drop and unrelated sounds.
//!
//! People knock, clap, walk and drum at intervals of their own choice, and they speed up; machines tick.
//! Their intervals differ from those of a ball in one thing: each is a fresh try at the same tempo, so
//! their logarithms scatter about a line of time, while what a ball lost in one impact it lost for all
//! flights to come. And a tempo changes slowly, if at all, where a ball's flights shrink by several
//! percent. An engine, a voice or a string gives pulses of its own rate, which wanders, up as well as
//! down, where no flight of a ball is longer than the one before.

use super::chain::{self, Link};
use super::evidence;
use crate::onset::Onset;
use crate::stats::{median, softplus};
use std::f64::consts::TAU;

/// Rhythms are more usual than drops: logarithm of the ratio. People, machines, and voices and strings keep time, and
/// none of the three is less usual than somebody who drops a ball.
pub(super) const LN_USUAL: f64 = 1.1;

/// How somebody, or something, keeps time.
struct TempoModel {
    /// Scatter of an interval, as a share of it.
    jitter: f64,
    /// By how much the tempo changes from one interval to the next, as a share of it.
    drift: f64,
}

/// Machines keep time within a percent and do not speed up; people do within some percent (Repp 2005)
/// and speed up by as much. All are equally usual.
const KEEPERS: [TempoModel; 5] = [
    TempoModel {
        jitter: 0.001,
        drift: 0.0,
    },
    TempoModel {
        jitter: 0.005,
        drift: 0.0,
    },
    TempoModel {
        jitter: 0.02,
        drift: 0.03,
    },
    TempoModel {
        jitter: 0.04,
        drift: 0.03,
    },
    TempoModel {
        jitter: 0.08,
        drift: 0.03,
    },
];

/// Logarithm of the factor by which a tempo changes in all: few go on to speed up beyond.
const LN_CHANGE: f64 = std::f64::consts::LN_2;

/// Logarithm of how likely an interval is that has nothing to do with the rhythm: one in twenty, and
/// it may be anything within a factor of e.
const LN_ODD: f64 = -3.0;

/// Logarithm of how likely the first interval of a rhythm is, which may be anything within a factor of ten.
pub(super) const LN_ANY: f64 = -0.83;

/// An interval: its place in the rhythm, and its logarithm.
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

/// By how much the interval of a pulse changes from one to the next, as a share of it: that of a
/// machine hardly, of a voice by up to some percent. All are equally usual.
const WANDERINGS: [f64; 4] = [0.001, 0.003, 0.01, 0.03];

/// Logarithm of how likely these intervals are, given the first, if they keep time or are those of
/// a pulse.
pub(super) fn ln_likelihood(beats: &[Beat]) -> f64 {
    let keepers = KEEPERS.map(|keeper| keeper.ln_likelihood(beats.to_vec()));
    let pulses = WANDERINGS.map(|wandering| ln_pulse(beats, wandering));
    let (keepers, pulses) = (ln_mean(&keepers), ln_mean(&pulses));
    keepers.max(pulses) + softplus(-(keepers - pulses).abs())
}

/// Where a ball most likely ends and a pulse goes on: how many of the intervals are of the ball, if `ball` are the
/// logarithms of how likely it makes each change from one interval to the next. At least `fewest` are left to each.
pub(super) fn likeliest_beginning(beats: &[Beat], ball: &[f64], fewest: usize) -> Option<usize> {
    let best = |wandering: f64| {
        let changes = beats.windows(2).zip(ball);
        let gains = changes.map(|(pair, ball)| {
            let change = pair[1].ln_interval - pair[0].ln_interval;
            evidence::ln_ratio(change, wandering * wandering) - ball
        });
        let gains: Vec<f64> = gains.collect();
        let mut gained = 0.0;
        let from_each = gains.iter().enumerate().rev().map(|(place, gain)| {
            gained += gain;
            (gained, place)
        });
        let places = fewest..=gains.len().saturating_sub(fewest);
        let possible = from_each.filter(|(_, place)| places.contains(place));
        possible.max_by(|a, b| a.0.total_cmp(&b.0))
    };
    let best = WANDERINGS.into_iter().filter_map(best);
    let best = best.max_by(|a, b| a.0.total_cmp(&b.0));
    best.map(|(_, place)| place)
}

/// A beat is found this share of the interval off at most.
const OFF: f64 = 0.08;

/// Sounds that keep time among others.
pub(super) struct Pulse<'a> {
    onsets: &'a [Onset],
    is_beat: Vec<bool>,
    /// What is louder is another sound over the beat.
    loudest_db: f64,
}

impl<'a> Pulse<'a> {
    /// This much above its usual level a beat is not heard for what is over it.
    const OVER_DB: f64 = 12.0;

    /// A pulse whose beats sound as loud as these onsets, none of which is taken yet.
    pub(super) fn like(onsets: &'a [Onset], links: &[Link]) -> Self {
        let levels_db = links.iter().map(|link| onsets[link.onset].level_db);
        Self {
            onsets,
            is_beat: vec![false; onsets.len()],
            loudest_db: median(levels_db).unwrap_or(0.0) + Self::OVER_DB,
        }
    }

    /// Takes the beats of a chain, those that divide its intervals evenly, and those with which it goes on.
    pub(super) fn take(&mut self, links: &[Link]) {
        for link in links {
            self.mark(link.onset);
        }
        let parts = self.parts(links);
        for pair in links.windows(2) {
            for (time_s, off_s) in self.divisions(pair, parts) {
                if let Some(index) = self.find(time_s, off_s) {
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

    /// Into how many parts other sounds of the pulse divide its intervals: a chain takes every second or third of fast
    /// ones, as no ball begins with such flights.
    fn parts(&self, links: &[Link]) -> u32 {
        const MOST: u32 = 6;
        /// Of the divisions so many are heard.
        const HEARD: f64 = 0.75;
        let is_pulse = |parts: &u32| {
            let divisions = links
                .windows(2)
                .flat_map(|pair| self.divisions(pair, *parts));
            let (mut heard, mut all) = (0.0, 0.0);
            for (time_s, off_s) in divisions {
                all += 1.0;
                heard += f64::from(u8::from(self.find(time_s, off_s).is_some()));
            }
            heard > HEARD * all
        };
        (2..=MOST).rev().find(is_pulse).unwrap_or(1)
    }

    /// The times that divide an interval evenly, and how far off a beat may be.
    fn divisions(&self, pair: &[Link], parts: u32) -> impl Iterator<Item = (f64, f64)> + use<> {
        let [from_s, to_s] = [pair[0], pair[1]].map(|link| self.onsets[link.onset].time_s);
        let all = (pair[1].number - pair[0].number) * parts;
        let part_s = (to_s - from_s) / f64::from(all);
        (1..all).map(move |n| (from_s + f64::from(n) * part_s, OFF * part_s))
    }

    /// Goes on with a beat from this onset on, backwards if the interval is negative.
    pub(super) fn follow(&mut self, from: usize, interval_s: f64) {
        /// After so many that are not found it has ended, but for as long as a loud sound and its echoes may be over
        /// it, in seconds.
        const MOST_MISSED: u32 = 2;
        const HIDDEN_S: f64 = 0.15;
        let most_missed = MOST_MISSED.max((HIDDEN_S / interval_s.abs()) as u32);
        let mut last_s = self.onsets[from].time_s;
        let mut missed = 0;
        while missed <= most_missed {
            let next_s = last_s + f64::from(missed + 1) * interval_s;
            if let Some(index) = self.find(next_s, OFF * interval_s.abs()) {
                self.mark(index);
                last_s = self.onsets[index].time_s;
                missed = 0;
            } else {
                missed += 1;
            }
        }
    }

    /// The onset nearest to this time, if it is no farther off than this.
    fn find(&self, time_s: f64, off_s: f64) -> Option<usize> {
        let distance_s = |index: &usize| (self.onsets[*index].time_s - time_s).abs();
        let after = self.onsets.partition_point(|o| o.time_s < time_s);
        let near = after.saturating_sub(1)..(after + 1).min(self.onsets.len());
        near.min_by(|a, b| distance_s(a).total_cmp(&distance_s(b)))
            .filter(|index| distance_s(index) < off_s)
    }

    fn mark(&mut self, index: usize) {
        let is_over = self.onsets[index].level_db > self.loudest_db;
        self.is_beat[index] = !is_over;
    }

    /// The onsets that are its beats, or those that are not.
    pub(super) fn onsets(&self, are_beats: bool) -> impl Iterator<Item = (usize, &Onset)> {
        let all = self.onsets.iter().enumerate();
        all.filter(move |(index, _)| self.is_beat[*index] == are_beats)
    }
}

/// Logarithm of the mean of numbers that are known by their logarithms.
fn ln_mean(logarithms: &[f64]) -> f64 {
    let greatest = logarithms.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let sum: f64 = logarithms.iter().map(|ln| (ln - greatest).exp()).sum();
    greatest + (sum / logarithms.len() as f64).ln()
}

/// Logarithm of how likely these intervals are for a pulse: each is like the last, give or take so
/// much, and now and then quite another, as where an octave is sung.
fn ln_pulse(beats: &[Beat], wandering: f64) -> f64 {
    let changes = beats
        .windows(2)
        .map(|p| p[1].ln_interval - p[0].ln_interval);
    changes
        .map(|change| evidence::ln_ratio(change, wandering * wandering))
        .sum()
}

impl TempoModel {
    /// The beats that are better explained as odd ones are left out, the worst first.
    fn ln_likelihood(&self, mut beats: Vec<Beat>) -> f64 {
        let mut line = Line::through(&beats, self);
        let mut odd = 0.0;
        while beats.len() > 2 {
            beats.remove(line.farthest(&beats));
            let without = Line::through(&beats, self);
            if without.ln_likelihood + LN_ODD <= line.ln_likelihood {
                break;
            }
            odd += LN_ODD;
            line = without;
        }
        line.ln_likelihood + odd
    }
}

/// A tempo that changes steadily.
struct Line {
    middle: Beat,
    slope: f64,
    ln_likelihood: f64,
}

impl Line {
    /// The line that a keeper of time most likely meant. It may begin anywhere; its slope is 0, give
    /// or take the drift; the beats are distributed normally about it.
    fn through(beats: &[Beat], keeper: &TempoModel) -> Self {
        let count = beats.len() as f64;
        let middle = Beat {
            number: beats.iter().map(|b| b.number).sum::<f64>() / count,
            ln_interval: beats.iter().map(|b| b.ln_interval).sum::<f64>() / count,
        };
        let (mut xx, mut xy, mut yy) = (0.0, 0.0, 0.0);
        for beat in beats {
            let x = beat.number - middle.number;
            let y = beat.ln_interval - middle.ln_interval;
            xx += x * x;
            xy += x * y;
            yy += y * y;
        }
        let drift = keeper.drift.min(LN_CHANGE / count);
        let (jitter2, drift2) = (keeper.jitter.powi(2), drift.powi(2));
        let slope = drift2 * xy / (jitter2 + drift2 * xx);
        let misfit = (yy - slope * xy) / jitter2 + (count - 1.0) * (TAU * jitter2).ln();
        let known = (1.0 + drift2 * xx / jitter2).ln() + count.ln();
        Self {
            middle,
            slope,
            ln_likelihood: -0.5 * (misfit + known),
        }
    }

    /// The place of the beat that is farthest from the line.
    fn farthest(&self, beats: &[Beat]) -> usize {
        let off = |beat: &Beat| {
            let x = beat.number - self.middle.number;
            (beat.ln_interval - self.middle.ln_interval - self.slope * x).abs()
        };
        let places = 0..beats.len();
        let farthest = places.max_by(|&a, &b| off(&beats[a]).total_cmp(&off(&beats[b])));
        farthest.unwrap_or_default()
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
        let found = search((0..36).map(|n| 0.06 * swing(n)));
        assert_eq!(found.trains.len(), 0);
        assert!(!found.periodic.is_empty());
    }

    /// Steel on amorphous metal: the ratio of its flights is 0.984, and scatters by half a percent.
    #[test]
    fn a_ball_that_hardly_loses_height_is_a_drop() {
        let found = search((0..60).map(|n| {
            let scatter = 0.005 * (f64::from(n) * 2.4).sin();
            0.18 * 0.984_f64.powi(n) * (1.0 + scatter)
        }));
        assert_eq!(found.trains.len(), 1);
        assert!(found.trains[0].impacts().len() >= 58);
    }
}
