//! How far a moment stands out of what came before.

use super::bands::{BANDS, FilterBank};
use std::collections::VecDeque;

/// Seconds after and before a moment that are compared, for each band: a low band needs longer to
/// gather as many independent values.
const AFTER_S: [f64; BANDS] = [0.008, 0.004, 0.002, 0.002, 0.002];
const BEFORE_S: [f64; BANDS] = [0.030, 0.016, 0.012, 0.012, 0.012];
/// The noise floor is a low quantile of the band energy over this time: the sound between the
/// impacts, however dense they are.
const FLOOR_S: f64 = 0.6;
const FLOOR_QUANTILE: f64 = 0.3;
/// Each value of the floor is an average over this many hops.
const FLOOR_HOPS: usize = 4;
/// A rise counts from this many standard deviations.
const LEAST_RISE: f64 = 1.0;
/// The sums start afresh after this many hops, lest a loud past swallows a quiet present.
const REBASE_HOPS: u64 = 2048;

/// A moment and what begins there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Novelty {
    /// Number of the hop that begins here.
    pub(super) hop: u64,
    /// See [`super::Onset::strength`].
    pub(super) strength: f64,
    /// Power that each band gained.
    pub(super) gain: [f64; BANDS],
    /// Power of each band before.
    pub(super) before: [f64; BANDS],
}

/// The band energies of the latest hops, as running sums.
#[derive(Clone)]
pub(super) struct HopEnergies {
    bands: usize,
    after: [usize; BANDS],
    before: [usize; BANDS],
    /// Standard deviation of the logarithm of the energy ratio of stationary noise.
    chance: [f64; BANDS],
    share: [f64; BANDS],
    /// Sums of the energy before each hop; the front is that of hop number `first`.
    sums: VecDeque<[f64; BANDS]>,
    first: u64,
    floors: Vec<Quantile>,
}

impl HopEnergies {
    pub(super) fn new(bank: &FilterBank, hop_s: f64) -> Self {
        let hops = |time_s: f64| ((time_s / hop_s).round() as usize).max(1);
        let after = AFTER_S.map(hops);
        let before = BEFORE_S.map(hops);
        let chance = std::array::from_fn(|band| {
            // Noise of bandwidth B has 2 B t degrees of freedom in a time t.
            let freedom = 2.0 * bank.width_hz[band] * hop_s;
            (2.0 / (freedom * after[band] as f64) + 2.0 / (freedom * before[band] as f64)).sqrt()
        });
        let capacity = hops(FLOOR_S) / FLOOR_HOPS;
        Self {
            bands: bank.bands,
            after,
            before,
            chance,
            share: bank.share,
            sums: VecDeque::from([[0.0; BANDS]]),
            first: 0,
            floors: (0..BANDS)
                .map(|_| Quantile::new(FLOOR_QUANTILE, capacity))
                .collect(),
        }
    }

    /// Hops after a moment that it takes to judge it.
    pub(super) fn look_ahead(&self) -> usize {
        self.after[0]
    }

    /// Takes the energies of the next hop; `noise_power` is that of rounding. Returns the moment
    /// that can now be judged, if any.
    pub(super) fn push(&mut self, energies: [f64; BANDS], noise_power: f64) -> Option<Novelty> {
        let last = self.sums[self.sums.len() - 1];
        self.sums
            .push_back(std::array::from_fn(|band| last[band] + energies[band]));
        let hops = self.first + self.sums.len() as u64 - 1;
        if hops.is_multiple_of(FLOOR_HOPS as u64) {
            let start = self.sums[self.sums.len() - 1 - FLOOR_HOPS];
            let end = self.sums[self.sums.len() - 1];
            for (band, floor) in self.floors.iter_mut().enumerate() {
                floor.push((end[band] - start[band]) / FLOOR_HOPS as f64);
            }
        }
        let moment = self.judge(noise_power);
        self.forget(hops);
        moment
    }

    fn judge(&self, noise_power: f64) -> Option<Novelty> {
        let at = self.sums.len().checked_sub(1 + self.look_ahead())?;
        let mut moment = Novelty {
            hop: self.first + at as u64,
            strength: 0.0,
            gain: [0.0; BANDS],
            before: [0.0; BANDS],
        };
        for band in 0..self.bands {
            let before = self.before[band].min(at);
            let sum = |hop: usize| self.sums[hop][band];
            let new = (sum(at + self.after[band]) - sum(at)) / self.after[band] as f64;
            let quiet = self.floors[band]
                .value()
                .max(noise_power * self.share[band]);
            let old = if before == 0 {
                // The first moment of a recording has nothing before it.
                new
            } else {
                (sum(at) - sum(at - before)) / before as f64
            };
            let old = old.max(quiet).max(f64::MIN_POSITIVE);
            moment.before[band] = old;
            moment.gain[band] = (new - old).max(0.0);
            let chance = self.chance[band];
            // ln(1 + x) < x: most moments need no logarithm.
            if moment.gain[band] > LEAST_RISE * chance * old {
                let rise = (new / old).ln() / chance - LEAST_RISE;
                moment.strength += rise.max(0.0).powi(2);
            }
        }
        moment.strength = moment.strength.sqrt();
        Some(moment)
    }

    fn forget(&mut self, hops: u64) {
        if self.sums.len() > self.before[0] + self.look_ahead() + 1 {
            self.sums.pop_front();
            self.first += 1;
        }
        if hops.is_multiple_of(REBASE_HOPS) {
            let base = self.sums[0];
            for sums in &mut self.sums {
                for (sum, base) in sums.iter_mut().zip(base) {
                    *sum -= base;
                }
            }
        }
    }
}

/// A quantile of the latest values.
#[derive(Clone)]
struct Quantile {
    share: f64,
    capacity: usize,
    recent: VecDeque<f64>,
    sorted: Vec<f64>,
}

impl Quantile {
    fn new(share: f64, capacity: usize) -> Self {
        Self {
            share,
            capacity: capacity.max(1),
            recent: VecDeque::new(),
            sorted: Vec::new(),
        }
    }

    fn push(&mut self, value: f64) {
        if self.recent.len() == self.capacity
            && let Some(old) = self.recent.pop_front()
        {
            let at = self.sorted.partition_point(|v| *v < old);
            self.sorted.remove(at);
        }
        self.recent.push_back(value);
        let at = self.sorted.partition_point(|v| *v < value);
        self.sorted.insert(at, value);
    }

    fn value(&self) -> f64 {
        let at = (self.sorted.len() as f64 * self.share) as usize;
        self.sorted.get(at).copied().unwrap_or(0.0)
    }
}

/// The smallest step between samples. What the format cannot resolve is noise, even where a
/// recording is digitally silent.
#[derive(Clone, Default)]
pub(super) struct QuantisationStep {
    last: f32,
    smallest: Option<f32>,
}

impl QuantisationStep {
    pub(super) fn see(&mut self, samples: &[f32]) {
        for &sample in samples {
            let step = (sample - self.last).abs();
            self.last = sample;
            if step > 0.0 && self.smallest.is_none_or(|smallest| step < smallest) {
                self.smallest = Some(step);
            }
        }
    }

    /// Power of the noise that rounding to such steps makes.
    pub(super) fn power(&self) -> f64 {
        f64::from(self.smallest.unwrap_or(0.0)).powi(2) / 12.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantile_is_that_of_the_latest_values() {
        let mut quantile = Quantile::new(0.3, 10);
        for value in 0..100 {
            quantile.push(f64::from((value * 37) % 100));
        }
        // The last ten values, sorted, at position 3.
        let mut last: Vec<f64> = (90..100).map(|v| f64::from((v * 37) % 100)).collect();
        last.sort_by(f64::total_cmp);
        assert!((quantile.value() - last[3]).abs() < f64::EPSILON);
    }

    #[test]
    fn quantisation_step_is_the_smallest_change() {
        let mut step = QuantisationStep::default();
        step.see(&[0.5, 0.5, 0.25, 0.375, 0.375]);
        assert!((step.power() - 0.125f64.powi(2) / 12.0).abs() < f64::EPSILON);
    }
}
