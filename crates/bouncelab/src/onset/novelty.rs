//! Novelty: how much louder a moment is than what came before.
//!
//! In each band the mean energy after a moment is divided by the mean energy before it. For noise the logarithm of this
//! ratio has a known standard deviation, so a rise is counted in units of it; the strength of a moment is the root of the
//! sum of squares of the rises of all bands.

use super::bands::{BANDS, FilterBank, FrameEnergies};
use super::floor::Quantile;
use super::parameters::{
    AFTER_S, BEFORE_S, FLOOR_HOPS, FLOOR_QUANTILE, FLOOR_S, FRAME_HOPS, FRAMES_SUMMED, MAX_HOPS,
    MIN_POWER, MIN_PRE_ECHO_RATIO, MIN_RISE, SCREEN_SHARE, SCREENED_HOPS,
};

/// A moment and what begins there.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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

impl Novelty {
    /// Whether this is so much louder than an earlier moment, in any band, that the earlier one is its precursor.
    pub(super) fn dwarfs(&self, earlier: &Self) -> bool {
        (0..BANDS).any(|band| {
            let earlier_power = earlier.gain[band].max(earlier.before[band]);
            self.gain[band] > MIN_PRE_ECHO_RATIO * earlier_power
        })
    }
}

/// The latest energies of one band, and what is expected of them.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
struct Band {
    /// Hops after and before a moment that are compared.
    after: usize,
    before: usize,
    /// Standard deviation of the logarithm of the energy ratio of stationary noise; infinite if no
    /// rise counts here.
    chance: f64,
    /// Share of the power of white noise in this band.
    share: f64,
    floor: Quantile,
    /// Minimum power that the band holds: the noise floor or the noise of rounding.
    quiet: f64,
}

/// The band energies of the latest hops.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct HopEnergies {
    bands: Vec<Band>,
    /// For each band the sum of the energies before each hop: the energy of any stretch is a difference of two.
    sums: [Vec<f64>; BANDS],
    /// Index in them of the first hop that is remembered.
    first: usize,
    /// Hops that are remembered from frame to frame.
    history: usize,
    /// Hops after a moment that its evaluation needs.
    look_ahead: usize,
    /// Number of the first hop of the next frame.
    next: u64,
}

/// The number of hops of a time, at least one.
pub(super) fn hops(time_s: f64, hop_s: f64) -> usize {
    ((time_s / hop_s).round() as usize).clamp(1, MAX_HOPS)
}

impl HopEnergies {
    pub(super) fn new(bank: &FilterBank, hop_s: f64) -> Self {
        let after = AFTER_S.map(|time_s| hops(time_s, hop_s));
        let before = BEFORE_S.map(|time_s| hops(time_s, hop_s));
        let look_ahead = after[0];
        let history = look_ahead + before[0];
        let bands = (0..bank.bands)
            .map(|band| {
                // The energy of noise of bandwidth B in a time t is chi-squared with 2 B t degrees of freedom, so that
                // the logarithm of its mean has the variance 2 / (2 B t); the two sides of a moment are independent.
                let freedom = 2.0 * bank.width_hz[band] * hop_s;
                let variance = |hops: usize| 2.0 / (freedom * hops as f64);
                let chance = (variance(after[band]) + variance(before[band])).sqrt();
                Band {
                    after: after[band],
                    before: before[band],
                    chance: if bank.watched[band] {
                        chance
                    } else {
                        f64::INFINITY
                    },
                    share: bank.share[band],
                    floor: Quantile::new(FLOOR_QUANTILE, hops(FLOOR_S, hop_s) / FLOOR_HOPS),
                    quiet: 0.0,
                }
            })
            .collect();
        Self {
            bands,
            sums: std::array::from_fn(|_| vec![0.0; history + 1 + FRAMES_SUMMED * FRAME_HOPS]),
            first: 0,
            history,
            look_ahead,
            next: 0,
        }
    }

    /// Hops after a moment that its evaluation needs.
    pub(super) fn look_ahead(&self) -> usize {
        self.look_ahead
    }

    /// Number of the first hop that is not yet evaluated.
    pub(super) fn evaluated(&self) -> u64 {
        self.next.saturating_sub(self.look_ahead as u64)
    }

    /// Takes the energies of the next frame; `noise_power` is that of rounding. Appends the
    /// moments that can now be evaluated and whose strength is at least `min_strength`.
    pub(super) fn push(
        &mut self,
        energies: &FrameEnergies,
        noise_power: f64,
        min_strength: f64,
        moments: &mut Vec<Novelty>,
    ) {
        self.add(energies);
        for (band, energies) in self.bands.iter_mut().zip(energies) {
            band.push(energies, noise_power);
        }
        let first = self.first + self.history - self.look_ahead;
        // First pass: an upper bound of the square of the strength of each moment, without logarithms.
        let mut bounds = [0.0; FRAME_HOPS];
        // The first moments of a recording have little before them, so the bound does not hold for them.
        if self.next < self.history as u64 {
            bounds.fill(f32::INFINITY);
        } else {
            for (band, sums) in self.bands.iter().zip(&self.sums) {
                band.add_bound(sums, first, &mut bounds);
            }
        }
        // Rounding of the bound must not hide a moment.
        let min_bound = (SCREEN_SHARE * min_strength * min_strength) as f32;
        // Second pass: nearly all blocks of hops have no such moment, and each is excluded by one comparison of its maximum.
        let blocks = bounds.as_chunks::<SCREENED_HOPS>().0;
        for (from, block) in (0..).step_by(SCREENED_HOPS).zip(blocks) {
            if block
                .iter()
                .map(|bound| u8::from(*bound >= min_bound))
                .max()
                == Some(1)
            {
                self.evaluate_block(from, block, min_bound, min_strength, moments);
            }
        }
        self.next += FRAME_HOPS as u64;
    }

    /// Evaluates the moments of a block that may be strong enough; the block begins at this hop of the frame.
    fn evaluate_block(
        &self,
        from: usize,
        bounds: &[f32; SCREENED_HOPS],
        min_bound: f32,
        min_strength: f64,
        moments: &mut Vec<Novelty>,
    ) {
        let first = self.first + self.history - self.look_ahead;
        for (index, &bound) in (from..).zip(bounds) {
            if bound >= min_bound
                && let Some(hop) = (self.next + index as u64).checked_sub(self.look_ahead as u64)
            {
                let moment = self.evaluate(hop, first + index);
                if moment.strength >= min_strength {
                    moments.push(moment);
                }
            }
        }
    }

    /// Continues the sums. All bands side by side: each addition waits for the one before, so one band alone would leave
    /// the processor idle.
    fn add(&mut self, energies: &FrameEnergies) {
        self.first += FRAME_HOPS;
        if self.first + self.history + FRAME_HOPS >= self.sums[0].len() {
            self.start_afresh();
        }
        let past = self.first + self.history;
        let mut sums = self.sums.each_mut().map(|sums| &mut sums[past..]);
        let mut last = sums.each_ref().map(|sums| sums[0]);
        let new = sums.each_mut().map(|sums| &mut sums[1..=FRAME_HOPS]);
        for hop in 0..FRAME_HOPS {
            for band in 0..BANDS {
                last[band] += f64::from(energies[band][hop]);
                new[band][hop] = last[band];
            }
        }
    }

    /// Moves the sums that are remembered to the front and subtracts the first of them: a sum that grew for ever would
    /// round away a quiet present.
    #[cold]
    fn start_afresh(&mut self) {
        for sums in &mut self.sums {
            let base = sums[self.first];
            sums.copy_within(self.first..=self.first + self.history, 0);
            for sum in &mut sums[..=self.history] {
                *sum -= base;
            }
        }
        self.first = 0;
    }

    /// Evaluates a hop, whose index in the sums is `at`.
    #[inline]
    fn evaluate(&self, hop: u64, at: usize) -> Novelty {
        let mut moment = Novelty {
            hop,
            strength: 0.0,
            gain: [0.0; BANDS],
            before: [0.0; BANDS],
        };
        for (index, (band, sums)) in self.bands.iter().zip(&self.sums).enumerate() {
            let sum = |hop: usize| sums[hop];
            let before = (band.before as u64).min(hop) as usize;
            let new = (sum(at + band.after) - sum(at)) / band.after as f64;
            let mean_before = if before == 0 {
                // The first moment of a recording has nothing before it.
                new
            } else {
                (sum(at) - sum(at - before)) / before as f64
            };
            // Below the noise floor a rise means nothing.
            let old = mean_before.max(band.quiet);
            moment.before[index] = old;
            moment.gain[index] = (new - old).max(0.0);
            // In standard deviations of noise, less what noise often makes.
            let rise = (new / old).ln() / band.chance - MIN_RISE;
            moment.strength += rise.max(0.0).powi(2);
        }
        moment.strength = moment.strength.sqrt();
        moment
    }
}

impl Band {
    fn push(&mut self, energies: &[f32; FRAME_HOPS], noise_power: f64) {
        for hops in energies.chunks_exact(FLOOR_HOPS) {
            let mean: f32 = hops.iter().sum::<f32>() / FLOOR_HOPS as f32;
            self.floor.push(mean);
        }
        self.quiet = f64::from(self.floor.value())
            .max(noise_power * self.share)
            .max(MIN_POWER);
    }

    /// Adds the square of the largest rise that this band can contribute to the hops from `first` on.
    ///
    /// For x > 0, ln(1 + x) < x (6 + x) / (6 + 4 x) (the Padé approximant of order 2/1), and hardly less while x is small:
    /// so nearly all moments need no logarithm.
    fn add_bound(&self, sums: &[f64], first: usize, bounds: &mut [f32; FRAME_HOPS]) {
        let sums_from = |from: usize| &sums[from..][..FRAME_HOPS];
        let (now, end, start) = (
            sums_from(first),
            sums_from(first + self.after),
            sums_from(first - self.before),
        );
        let (after, before) = (1.0 / self.after as f32, 1.0 / self.before as f32);
        let quiet = self.quiet as f32;
        let chance = (1.0 / self.chance) as f32;
        for at in 0..FRAME_HOPS {
            let new = (end[at] - now[at]) as f32 * after;
            let mean_before = (now[at] - start[at]) as f32 * before;
            // Comparisons in place of `max`, which takes care of NaN: one instruction for all lanes.
            let old = if mean_before > quiet {
                mean_before
            } else {
                quiet
            };
            let gain = if new > old { new - old } else { 0.0 };
            // The approximant with x = gain / old, in one division.
            let ln_ratio = gain * (6.0 * old + gain) / (old * (6.0 * old + 4.0 * gain));
            let above = ln_ratio * chance - MIN_RISE as f32;
            let rise = if above > 0.0 { above } else { 0.0 };
            bounds[at] += rise * rise;
        }
    }
}
