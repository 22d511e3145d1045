//! The evidence that each impact contributes for a drop.
//!
//! All terms are ratios: the probability of a sound if it is the next impact of a drop, over
//! its probability if it is some other sound. Their logarithms add up to the evidence.

use super::parameters::{
    ASSUMED_SOUNDS, FIRST_RATIO_DENSITY, GRAVITY_M_S2, HIGH_DROP_M, LEVEL_FALL_DB,
    LEVEL_FALL_DB_PER_E_FOLD, LEVEL_RANGE_DB, LEVEL_SCATTER_DB, LN_DROP, MAX_BAND_DEPTH_DB,
    MIN_BETWEEN_DROPS_S, MIN_COMPARED_BANDS, MIN_DULL_LN_RATIO, MIN_OBSERVED_S,
    MIN_OTHERS_PER_FLIGHT, OUTLIER_SOUND_SHARE, QUIET_DB, RHYTHM_JITTER, RHYTHM_WEIGHT,
    SHORT_FIRST_FLIGHT_S, SOUNDS_PER_DROP, SURROUNDINGS_S, TIMBRE_RANGE_DB, TIMBRE_SCATTER_DB,
};
use crate::onset::{BANDS, Onset};
use std::f64::consts::{PI, SQRT_2};

/// A kind of surface that a ball bounces on.
pub(super) struct Surface {
    /// Scatter of the ratio of successive flights about its slow trend, a Student distribution:
    /// impacts have heavy tails (Montaine et al. 2011).
    pub(super) scatter: f64,
    /// Logarithm of its prior probability.
    pub(super) ln_prior: f64,
}

/// Density of the Student distribution with two degrees of freedom; `scale2` is the square of its scale.
fn student(x: f64, scale2: f64) -> f64 {
    // With two degrees of freedom it needs no power but a square root: s² / (s² + x²/2)^(3/2) / 2√2.
    let spread = scale2 + 0.5 * x * x;
    scale2 / (spread * spread.sqrt()) / (2.0 * SQRT_2)
}

/// Log prior of the duration of a first flight.
pub(super) fn ln_first_flight(flight_s: f64) -> f64 {
    3.0 * (flight_s / SHORT_FIRST_FLIGHT_S).min(1.0).ln()
}

/// Log prior of the level of the loudest impact.
pub(super) fn ln_loudest(level_db: f64) -> f64 {
    (level_db - QUIET_DB).min(0.0) / LEVEL_FALL_DB_PER_E_FOLD
}

/// Evidence of the third impact: `change` is the logarithm of the ratio of the first two flights, and `ln_flight` that of
/// the first flight in seconds.
pub(super) fn ln_first_ratio(change: f64, ln_flight: f64) -> f64 {
    // A flight of T rises to g T²/8. The flight to the first impact was longer than the first one by the same ratio.
    let ln_height = (GRAVITY_M_S2 / 8.0).ln() + 2.0 * (ln_flight - change);
    let ln_prior = -2.0 * (ln_height - HIGH_DROP_M.ln()).max(0.0);
    (FIRST_RATIO_DENSITY / rhythm(change)).ln() + ln_prior
}

/// Probability ratio of a later impact: `change` is the logarithm of the interval over the last flight, `surprise` its
/// difference from the prediction, whose variance is `variance`.
pub(super) fn next_ratio(change: f64, surprise: f64, variance: f64) -> f64 {
    student(surprise, variance) / rhythm(change)
}

/// Log density of a surprise for a ball.
pub(super) fn ln_ratio(surprise: f64, variance: f64) -> f64 {
    student(surprise, variance).ln()
}

/// Upper bound of [`next_ratio`] for ratios that scatter with this variance.
pub(super) fn max_next_ratio(scatter2: f64) -> f64 {
    student(0.0, scatter2)
}

/// Log density of a level that exceeds the expected one by `louder_db`, over that of the expected level.
pub(super) fn ln_level(louder_db: f64) -> f64 {
    (Fall::density(louder_db) / Fall::density(0.0)).ln()
}

/// Factor by which an interval is more likely for other sounds, since they may keep time: one plus a peak at equal
/// intervals, whose tails fall with the fourth power.
fn rhythm(change: f64) -> f64 {
    let off_beat = 1.0 + 0.5 * (change / RHYTHM_JITTER).powi(2);
    1.0 + RHYTHM_WEIGHT / (off_beat * off_beat)
}

/// Logarithm of the probability ratio of the level and the spectrum of two sounds, if they are impacts of one ball.
pub(super) fn ln_alike(onset: &Onset, next: &Onset) -> f64 {
    Sound::of(onset).similarity(&Sound::of(next)).ln()
}

/// Logarithm by which the fall of the level between two sounds is more likely if they may be those of a dull ball.
pub(super) fn ln_fall_of_two(onset: &Onset, next: &Onset) -> f64 {
    Sound::of(onset).fall(&Sound::of(next)).of_two().ln()
}

/// Level and spectrum of a sound, for the comparison with others.
#[derive(Clone, Copy)]
struct Sound {
    level_db: f64,
    /// Level of the loudest noise in a band: the level of a fainter sound is only known to be at most this.
    noise_db: f64,
    /// Levels of the bands in dB relative to the loudest, and the lowest that can be measured.
    bands: [f32; BANDS],
    floor: [f32; BANDS],
}

impl Sound {
    fn of(onset: &Onset) -> Self {
        let loudest_db = loudest(&onset.band_levels_db);
        Self {
            level_db: onset.level_db,
            noise_db: loudest(&onset.band_noise_db).into(),
            bands: onset.band_levels_db.map(|db| db - loudest_db),
            floor: onset
                .band_noise_db
                .map(|db| (db - loudest_db).max(-MAX_BAND_DEPTH_DB)),
        }
    }

    /// The fall of the level to the next sound.
    fn fall(&self, next: &Self) -> Fall {
        // Below the noise of either sound no difference can be measured.
        let noise_db = louder(self.noise_db, next.noise_db);
        Fall {
            db: louder(self.level_db, noise_db) - louder(next.level_db, noise_db),
        }
    }

    /// Probability ratio of this and the next sound, in level and in spectrum, if they are impacts of one ball.
    fn similarity(&self, next: &Self) -> f64 {
        self.fall(next).prior_density() * LEVEL_RANGE_DB * self.timbre(next)
    }

    /// The same of the spectrum alone.
    fn timbre(&self, next: &Self) -> f64 {
        let Some(distance2) = self.timbre_distance2_db(next) else {
            return 1.0;
        };
        // The density of half a normal distribution over that of a uniform one.
        let peak = (2.0 / PI).sqrt() / TIMBRE_SCATTER_DB * TIMBRE_RANGE_DB;
        let alike = peak * (-0.5 * distance2 / (TIMBRE_SCATTER_DB * TIMBRE_SCATTER_DB)).exp();
        (1.0 - OUTLIER_SOUND_SHARE) * alike + OUTLIER_SOUND_SHARE
    }

    /// Mean square difference of two spectra in dB, relative to their loudest bands.
    ///
    /// A band at the noise in one of them only shows that the sound is not louder there, so both are compared from the
    /// higher of their floors up. `None` if fewer than two bands can be compared.
    fn timbre_distance2_db(&self, next: &Self) -> Option<f64> {
        let (mut bands, mut sum) = (0, 0.0);
        for band in 0..BANDS {
            let floor = louder(self.floor[band], next.floor[band]);
            let a = louder(self.bands[band], floor);
            let b = louder(next.bands[band], floor);
            bands += i32::from(louder(a, b) > floor);
            sum += (a - b) * (a - b);
        }
        (bands >= MIN_COMPARED_BANDS).then(|| f64::from(sum) / f64::from(bands))
    }
}

/// The larger level; faster than `max`, since levels are never NaN.
fn louder<T: PartialOrd>(a: T, b: T) -> T {
    if b > a { b } else { a }
}

fn loudest(bands_db: &[f32; BANDS]) -> f32 {
    bands_db.iter().copied().fold(f32::NEG_INFINITY, louder)
}

/// A fall of the level from one impact to the next.
pub(super) struct Fall {
    db: f64,
}

impl Fall {
    fn density(db: f64) -> f64 {
        student(db, LEVEL_SCATTER_DB * LEVEL_SCATTER_DB)
    }

    /// Its density while the flights are unknown.
    fn prior_density(&self) -> f64 {
        Self::density(self.db - LEVEL_FALL_DB)
    }

    /// Its density over the prior one, given the logarithm of the ratio of the flights before the two impacts.
    pub(super) fn given_ratio(&self, ln_ratio: f64) -> f64 {
        Self::density(self.db + LEVEL_FALL_DB_PER_E_FOLD * ln_ratio) / self.prior_density()
    }

    /// Its density over the prior one for two impacts, whose ratio no third shows: of a ball that was caught, or of a dull one,
    /// whose falls are equally likely up to that of the least ratio.
    fn of_two(&self) -> f64 {
        let most_db = LEVEL_SCATTER_DB - MIN_DULL_LN_RATIO * LEVEL_FALL_DB_PER_E_FOLD;
        let of_dull = if (0.0..most_db).contains(&self.db) {
            1.0 / most_db
        } else {
            0.0
        };
        0.5 + 0.5 * of_dull / self.prior_density()
    }

    /// Upper bound of [`Self::given_ratio`].
    pub(super) fn max_given_ratio(&self) -> f64 {
        Self::density(0.0) / self.prior_density()
    }
}

/// The sum of 1/k for k up to n, to within 1/24 n².
fn harmonic(n: usize) -> f64 {
    /// The constant of Euler and Mascheroni.
    const GAMMA: f64 = 0.577_215_664_9;
    (n as f64 + 0.5).ln() + GAMMA
}

/// A time span of a recording of which all onsets are given, in seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Span {
    pub(crate) start_s: f64,
    pub(crate) end_s: f64,
}

impl Span {
    /// Unbounded.
    pub(crate) const UNBOUNDED: Self = Self {
        start_s: f64::NEG_INFINITY,
        end_s: f64::INFINITY,
    };
}

/// The sounds around an onset, which determine how improbable a next impact would be by chance.
pub(super) struct Surroundings {
    sound: Sound,
    /// Rate of the onsets that are at least as strong, itself included, Hz.
    rate_hz: f64,
    /// Rate of all onsets, Hz.
    any_rate_hz: f64,
    /// Mean similarity of the onset and those around: in steady noise all candidates sound alike, so that similarity is no
    /// evidence.
    mean_similarity: f64,
}

impl Surroundings {
    /// The surroundings of each of these onsets, which are all onsets of this span.
    pub(super) fn of(onsets: &[Onset], span: Span) -> Vec<Self> {
        let sounds: Vec<Sound> = onsets.iter().map(Sound::of).collect();
        let (mut first, mut end) = (0, 0);
        std::iter::zip(onsets, &sounds)
            .map(|(onset, &sound)| {
                while onsets[first].time_s < onset.time_s - SURROUNDINGS_S {
                    first += 1;
                }
                while end < onsets.len() && onsets[end].time_s <= onset.time_s + SURROUNDINGS_S {
                    end += 1;
                }
                let near = &onsets[first..end];
                let stronger = near.iter().filter(|o| o.strength >= onset.strength).count();
                // Outside of the span nothing is known, so only the part inside of it is counted.
                let inside_s = (onset.time_s + SURROUNDINGS_S).min(span.end_s)
                    - (onset.time_s - SURROUNDINGS_S).max(span.start_s);
                let observed_s = inside_s.max(MIN_OBSERVED_S);
                let similarities = sounds[first..end].iter().map(|o| sound.similarity(o));
                let similarity: f64 = similarities.sum();
                // As if an impact were the k-th strongest of n sounds with probability 1/(k Hₙ), Hₙ the harmonic number,
                // where any other sound has 1/n: their ratio makes of the rate n/T of all sounds the rate k Hₙ/T.
                Self {
                    sound,
                    rate_hz: stronger as f64 * harmonic(near.len()) / observed_s,
                    any_rate_hz: near.len() as f64 / observed_s,
                    mean_similarity: (ASSUMED_SOUNDS + similarity)
                        / (ASSUMED_SOUNDS + near.len() as f64),
                }
            })
            .collect()
    }

    /// The reciprocal of the density of a sound as strong as the one here, at this interval from another. The density
    /// is over the logarithm of the interval, as that of the next impact is: the rate times the interval.
    pub(super) fn by_chance(&self, interval_s: f64) -> f64 {
        1.0 / (self.rate_hz * interval_s).max(MIN_OTHERS_PER_FLIGHT)
    }

    /// The same for any sound, however faint.
    pub(super) fn any_by_chance(&self, interval_s: f64) -> f64 {
        1.0 / (self.any_rate_hz * interval_s).max(MIN_OTHERS_PER_FLIGHT)
    }

    /// Logarithm of the prior odds that a drop begins here, over other sounds.
    pub(super) fn ln_drop(&self) -> f64 {
        let sounds = MIN_BETWEEN_DROPS_S * self.rate_hz;
        LN_DROP - (sounds / SOUNDS_PER_DROP).max(1.0).ln()
    }

    /// Similarity of the onset here and the next, over that of the onset and all around.
    pub(super) fn relative_similarity(&self, next: &Self) -> f64 {
        self.sound.similarity(&next.sound) / self.mean_similarity
    }

    /// The fall of the level to the next onset.
    pub(super) fn fall(&self, next: &Self) -> Fall {
        self.sound.fall(&next.sound)
    }
}
