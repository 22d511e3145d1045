//! What each impact adds to the evidence for a drop, in nats.
//!
//! All terms are logarithms of a ratio: the probability of what was heard if it is the next impact
//! of a drop, over its probability if it is some other sound.

use crate::onset::Onset;

/// Drops are rarer than sounds: evidence at the first pair of impacts. The prior expectation is
/// one drop among four hundred sounds, and flights from 10 ms to 2 s long, equally likely on a
/// logarithmic scale.
pub(super) const BIRTH: f64 = -7.4;

/// The ratio of the first two flights: uniform in its logarithm between those of a dead ball
/// (0.4) and a perfect one, over the interval of other sounds, equally broad.
pub(super) const FIRST_RATIO: f64 = 0.1;

/// An impact that was not heard, for each one.
pub(super) const MISSED: f64 = -3.0;

/// Other sounds do not come at random alone: people knock, clap and play at intervals of their own
/// choice. So their rate is taken to be at least this many in the time of one flight.
const LEAST_RATE: f64 = 0.5;

/// They also keep time: the next interval is like the last, give or take 10 %, with three times
/// the probability of anything else.
const RHYTHM_WEIGHT: f64 = 3.0;
const RHYTHM_JITTER: f64 = 0.1;

/// Scatter of the ratio of successive flights about its slow trend: 1.3 % on a good surface, with
/// the heavy tails that impacts have (Montaine et al. 2011): a Student distribution.
const RATIO_SCATTER: f64 = 0.013;
/// Scatter in dB of the level from impact to impact, about a slow fall.
const LEVEL_SCATTER_DB: f64 = 3.5;
/// Usual fall of the level from impact to impact in dB.
const LEVEL_FALL_DB: f64 = 1.0;
/// Levels of unrelated sounds spread over this range in dB.
const LEVEL_RANGE_DB: f64 = 40.0;
/// Scatter in dB of the spectrum from impact to impact.
const TIMBRE_SCATTER_DB: f64 = 3.0;
/// Spectra of unrelated sounds differ by up to this much in dB.
const TIMBRE_RANGE_DB: f64 = 20.0;
/// Share of impacts that sound unlike the one before: an edge, a finger, a noise over it.
const ODD_SOUND: f64 = 0.15;

/// Logarithm of the Student density with two degrees of freedom and this scale.
fn ln_student(x: f64, scale: f64) -> f64 {
    /// ln(1 / (2 sqrt 2))
    const NORM: f64 = -1.039_720_770_839_918;
    NORM - scale.ln() - 1.5 * (0.5 * (x / scale).powi(2)).ln_1p()
}

/// The largest value of [`ratio_change`].
pub(super) fn most_from_ratio() -> f64 {
    ln_student(0.0, RATIO_SCATTER)
}

/// The change of the logarithm of the flight ratio against its prediction, whose standard error
/// from timing and from the prediction itself is `sd`.
pub(super) fn ratio_change(change: f64, sd: f64) -> f64 {
    ln_student(change, RATIO_SCATTER.hypot(sd))
}

/// What speaks for a rhythm instead, if the logarithm of the interval changed by this much.
pub(super) fn against_rhythm(change: f64) -> f64 {
    -(RHYTHM_WEIGHT * (-0.5 * (change / RHYTHM_JITTER).powi(2)).exp()).ln_1p()
}

/// A sound of this strength, this interval after another.
///
/// The density of other sounds is taken over the logarithm of the interval, as that of a drop is.
pub(super) fn unlikely_by_chance(around: &Surroundings, interval_s: f64) -> f64 {
    -(around.rate_hz * interval_s).max(LEAST_RATE).ln()
}

/// How much alike two sounds are, against how much alike those around are: in steady noise all
/// candidates sound alike, and it means nothing.
pub(super) fn likeness(earlier: &Onset, later: &Onset, around_earlier: &Surroundings) -> f64 {
    similarity(earlier, later) - around_earlier.ln_mean_likeness
}

/// How much alike two successive impacts of a drop sound, in level and in spectrum.
fn similarity(earlier: &Onset, later: &Onset) -> f64 {
    let fall_db = earlier.level_db - later.level_db - LEVEL_FALL_DB;
    let level = ln_student(fall_db, LEVEL_SCATTER_DB) + LEVEL_RANGE_DB.ln();
    level + timbre(earlier, later)
}

fn timbre(earlier: &Onset, later: &Onset) -> f64 {
    let Some(distance) = timbre_distance_db(earlier, later) else {
        return 0.0;
    };
    // Half a normal distribution, over a uniform one.
    let alike = (-0.5 * (distance / TIMBRE_SCATTER_DB).powi(2)).exp() * 0.797_884_560_802_865
        / TIMBRE_SCATTER_DB;
    ((1.0 - ODD_SOUND) * alike * TIMBRE_RANGE_DB + ODD_SOUND).ln()
}

/// Root mean square difference of two spectra in dB, after the difference in level is taken out.
///
/// A band that lies at the noise in one of them says only that the sound is not louder there.
/// `None` if fewer than two bands can be compared.
fn timbre_distance_db(a: &Onset, b: &Onset) -> Option<f64> {
    /// Bands this far below the loudest are left out: side lobes of its filter.
    const DEPTH_DB: f32 = 15.0;
    let shift = loudest_band_db(b) - loudest_band_db(a);
    let (mut bands, mut sum) = (0, 0.0);
    let pairs = a.band_levels_db.iter().zip(&a.band_noise_db);
    for ((&level_a, &noise_a), (&level_b, &noise_b)) in
        pairs.zip(b.band_levels_db.iter().zip(&b.band_noise_db))
    {
        let floor = (noise_a + shift)
            .max(noise_b)
            .max(loudest_band_db(b) - DEPTH_DB);
        let (level_a, level_b) = (level_a + shift, level_b);
        if level_a.max(level_b) > floor {
            bands += 1;
            sum += f64::from(level_a.max(floor) - level_b.max(floor)).powi(2);
        }
    }
    (bands >= 2).then(|| (sum / f64::from(bands)).sqrt())
}

fn loudest_band_db(onset: &Onset) -> f32 {
    onset
        .band_levels_db
        .iter()
        .copied()
        .fold(f32::NEG_INFINITY, f32::max)
}

/// What surrounds each onset, which says how remarkable a next impact would be.
pub(super) struct Surroundings {
    /// How many onsets at least as strong come each second, itself included.
    rate_hz: f64,
    /// Logarithm of the mean of the exponential of `similarity` to the onsets around.
    ln_mean_likeness: f64,
}

impl Surroundings {
    /// The surroundings of each of these onsets.
    pub(super) fn of(onsets: &[Onset]) -> Vec<Self> {
        const REACH_S: f64 = 3.0;
        /// Unrelated sounds that are imagined beside those around, so that a few impacts alone in
        /// a quiet room are not taken for the rule.
        const IMAGINED: f64 = 10.0;
        let mut first = 0;
        let mut end = 0;
        onsets
            .iter()
            .map(|onset| {
                while onsets[first].time_s < onset.time_s - REACH_S {
                    first += 1;
                }
                while end < onsets.len() && onsets[end].time_s <= onset.time_s + REACH_S {
                    end += 1;
                }
                let near = &onsets[first..end];
                let stronger = near.iter().filter(|o| o.strength >= onset.strength).count();
                let likeness: f64 = near.iter().map(|o| similarity(onset, o).exp()).sum();
                Self {
                    rate_hz: stronger as f64 / (2.0 * REACH_S),
                    ln_mean_likeness: ((IMAGINED + likeness) / (IMAGINED + near.len() as f64)).ln(),
                }
            })
            .collect()
    }
}
