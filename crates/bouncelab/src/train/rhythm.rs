//! Sounds that keep time: the third explanation, beside a drop and unrelated sounds.
//!
//! People knock, clap, walk and drum at intervals of their own choice, and they speed up; machines tick.
//! Their intervals differ from those of a ball in one thing: each is a fresh try at the same tempo, so
//! their logarithms scatter about a line of time, while what a ball lost in one impact it lost for all
//! flights to come. And a tempo changes slowly, if at all, where a ball's flights shrink by several
//! percent.

use std::f64::consts::TAU;

/// Rhythms are more usual than drops: logarithm of the ratio.
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

/// An interval: its place in the rhythm, and its logarithm.
#[derive(Clone, Copy)]
pub(super) struct Beat {
    pub(super) number: f64,
    pub(super) ln_interval: f64,
}

/// Logarithm of how likely these intervals are, given the first, if they keep time.
pub(super) fn ln_likelihood(beats: &[Beat]) -> f64 {
    let keepers = KEEPERS.map(|keeper| keeper.ln_likelihood(beats.to_vec()));
    let best = keepers.into_iter().fold(f64::NEG_INFINITY, f64::max);
    let sum: f64 = keepers.iter().map(|ln| (ln - best).exp()).sum();
    best + (sum / KEEPERS.len() as f64).ln()
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
