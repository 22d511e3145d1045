//! How far a moment stands out of what came before.

use super::bands::{BANDS, FRAME_HOPS, FilterBank, FrameEnergies};
use super::floor::Quantile;

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
/// Power of digital silence: its square can still be told from 0 in single precision.
const LEAST_POWER: f64 = 1e-18;
/// No time counts more hops than this, whatever sample rate a broken file claims.
const MOST_HOPS: usize = 512;
/// So many hops of a frame are screened at a time.
const STRETCH: usize = 16;
/// The sums of energies start afresh after so many frames, lest a loud past swallows a quiet
/// present.
const FRAMES_SUMMED: usize = 8;

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
    /// Whether this is so much louder than an earlier moment, in the band that it fills best, that the
    /// earlier one only announced it.
    pub(super) fn dwarfs(&self, earlier: &Self) -> bool {
        /// Coders keep pre-echo below what an ear hears, 10 dB and more below the sound.
        const PRE_ECHO_RATIO: f64 = 10.0;
        let mut rises = (0..BANDS).map(|band| {
            let heard = earlier.gain[band].max(earlier.before[band]);
            self.gain[band] > PRE_ECHO_RATIO * heard
        });
        rises.any(|rise| rise)
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
    /// The least that the band holds, noise floor or rounding.
    quiet: f64,
}

/// The band energies of the latest hops.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct HopEnergies {
    bands: Vec<Band>,
    /// Of each band the sums of the energies before each hop.
    sums: [Vec<f64>; BANDS],
    /// Where in them the first hop lies that is remembered.
    first: usize,
    /// Hops that are remembered from frame to frame.
    history: usize,
    /// Hops after a moment that it takes to judge it.
    look_ahead: usize,
    /// Number of the first hop of the next frame.
    next: u64,
}

/// So many hops make this time, nearly.
pub(super) fn hops(time_s: f64, hop_s: f64) -> usize {
    ((time_s / hop_s).round() as usize).clamp(1, MOST_HOPS)
}

impl HopEnergies {
    pub(super) fn new(bank: &FilterBank, hop_s: f64) -> Self {
        let after = AFTER_S.map(|time_s| hops(time_s, hop_s));
        let before = BEFORE_S.map(|time_s| hops(time_s, hop_s));
        let look_ahead = after[0];
        let history = look_ahead + before[0];
        let bands = (0..bank.bands)
            .map(|band| {
                // Noise of bandwidth B has 2 B t degrees of freedom in a time t.
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

    /// Hops after a moment that it takes to judge it.
    pub(super) fn look_ahead(&self) -> usize {
        self.look_ahead
    }

    /// Number of the first hop that is not yet judged.
    pub(super) fn judged(&self) -> u64 {
        self.next.saturating_sub(self.look_ahead as u64)
    }

    /// Takes the energies of the next frame; `noise_power` is that of rounding. Appends the
    /// moments that can now be judged and are at least as strong as `bar`.
    #[inline(always)]
    pub(super) fn push(
        &mut self,
        energies: &FrameEnergies,
        noise_power: f64,
        bar: f64,
        moments: &mut Vec<Novelty>,
    ) {
        self.add(energies);
        for (band, energies) in self.bands.iter_mut().zip(energies) {
            band.push(energies, noise_power);
        }
        let first = self.first + self.history - self.look_ahead;
        // How novel each moment can be at most: the square of its strength.
        let mut most = [0.0; FRAME_HOPS];
        // The first moments of a recording have little before them.
        if self.next < self.history as u64 {
            most.fill(f32::INFINITY);
        } else {
            for (band, sums) in self.bands.iter().zip(&self.sums) {
                band.add_most(sums, first, &mut most);
            }
        }
        // Rounding of the bound must not hide a moment.
        let screen = (0.99 * bar * bar) as f32;
        // Most stretches have no such moment; each is asked at once.
        for (from, most) in (0..).step_by(STRETCH).zip(most.as_chunks::<STRETCH>().0) {
            if most.iter().map(|m| u8::from(*m >= screen)).max() == Some(1) {
                self.judge_stretch(from, most, screen, bar, moments);
            }
        }
        self.next += FRAME_HOPS as u64;
    }

    /// Judges the moments from this one on that may be strong enough.
    fn judge_stretch(
        &self,
        from: usize,
        most: &[f32; STRETCH],
        screen: f32,
        bar: f64,
        moments: &mut Vec<Novelty>,
    ) {
        let first = self.first + self.history - self.look_ahead;
        for (at, &most) in (from..).zip(most) {
            if most >= screen
                && let Some(hop) = (self.next + at as u64).checked_sub(self.look_ahead as u64)
            {
                let moment = self.judge(hop, first + at);
                if moment.strength >= bar {
                    moments.push(moment);
                }
            }
        }
    }

    /// Goes on with the sums; all bands side by side, because each sum waits for the last.
    #[inline(always)]
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

    /// Moves the sums that are remembered to the front, counted from the first of them on.
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

    /// Judges a hop, which lies here in the arrays.
    #[inline]
    fn judge(&self, hop: u64, at: usize) -> Novelty {
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
            let old = if before == 0 {
                // The first moment of a recording has nothing before it.
                new
            } else {
                (sum(at) - sum(at - before)) / before as f64
            };
            let old = old.max(band.quiet);
            moment.before[index] = old;
            moment.gain[index] = (new - old).max(0.0);
            let rise = (new / old).ln() / band.chance - LEAST_RISE;
            moment.strength += rise.max(0.0).powi(2);
        }
        moment.strength = moment.strength.sqrt();
        moment
    }
}

impl Band {
    #[inline(always)]
    fn push(&mut self, energies: &[f32; FRAME_HOPS], noise_power: f64) {
        for means in energies.chunks_exact(FLOOR_HOPS) {
            let mean: f32 = means.iter().sum::<f32>() / FLOOR_HOPS as f32;
            self.floor.push(mean);
        }
        self.quiet = f64::from(self.floor.value())
            .max(noise_power * self.share)
            .max(LEAST_POWER);
    }

    /// Adds how novel this band can make the hops from this one on, at most.
    ///
    /// For x > 0, ln(1 + x) < x (6 + x) / (6 + 4 x), and hardly less while x is small: so nearly
    /// all moments need no logarithm.
    #[inline(always)]
    fn add_most(&self, sums: &[f64], first: usize, most: &mut [f32; FRAME_HOPS]) {
        let sums = |from: usize| &sums[from..][..FRAME_HOPS];
        let (now, end, start) = (
            sums(first),
            sums(first + self.after),
            sums(first - self.before),
        );
        let (after, before) = (1.0 / self.after as f32, 1.0 / self.before as f32);
        let quiet = self.quiet as f32;
        let chance = (1.0 / self.chance) as f32;
        for at in 0..FRAME_HOPS {
            let new = (end[at] - now[at]) as f32 * after;
            let old = (now[at] - start[at]) as f32 * before;
            let old = if old > quiet { old } else { quiet };
            let gain = if new > old { new - old } else { 0.0 };
            // x = gain / old, in one division.
            let rise = gain * (6.0 * old + gain) / (old * (6.0 * old + 4.0 * gain));
            let rise = rise * chance - LEAST_RISE as f32;
            let rise = if rise > 0.0 { rise } else { 0.0 };
            most[at] += rise * rise;
        }
    }
}
