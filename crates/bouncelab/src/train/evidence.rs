//! What each impact adds to the evidence for a drop.
//!
//! All terms are ratios: the probability of what was heard if it is the next impact of a drop, over
//! its probability if it is some other sound. Their logarithms add up to the evidence.

use crate::onset::{BANDS, Onset};
use std::f64::consts::{PI, SQRT_2};

/// Drops are rarer than sounds: logarithm of the ratio at the first pair of impacts. The prior
/// expectation is one drop among four hundred sounds, and first flights equally likely, on a
/// logarithmic scale, over a factor of four.
pub(super) const LN_BIRTH: f64 = -7.4;

/// Nor do more drops begin because more else sounds: the prior expectation is no more than one in
/// this time, in seconds. Else, the denser the sounds, the more chains of coincidences would pass.
const BETWEEN_DROPS_S: f64 = 300.0;
/// Sounds a drop is expected among, whatever their density.
const AMONG_SOUNDS: f64 = 400.0;

/// A first flight shorter than this, in seconds, is rarer with its third power: few balls are let go
/// from below 2 cm, and the louder impacts of one let go from higher would have been heard.
const SHORT_FIRST_S: f64 = 0.12;

/// A drop from higher than this, in metres, is rarer with its second power.
const HIGH_M: f64 = 3.0;
/// Height of the apex of a flight of one second, in metres.
const APEX_M: f64 = 9.81 / 8.0;

/// The ratio of the first two flights is uniform in its logarithm between that of a dead ball
/// (0.4) and that of a perfect one.
pub(super) const FIRST_RATIO_DENSITY: f64 = 1.1;

/// Logarithm of the odds that a drop, once it is believed, goes on after an impact that was heard: of three at
/// least, two are not the last.
pub(super) const LN_GOES_ON: f64 = 0.7;

/// A drop whose loudest impact lies below this level, in dB relative to full scale, is rarer in proportion to its
/// amplitude: recorders are set so that they use their range, and its last bits make sounds of their own.
const QUIET_DB: f64 = -60.0;

/// Logarithm of the ratio for an impact that was not heard.
pub(crate) const LN_MISSED: f64 = -3.0;

/// Other sounds do not come at random alone: people knock, clap and play at intervals of their own
/// choice. So their rate is taken to be at least this many in the time of one flight.
const LEAST_RATE: f64 = 0.5;

/// They also keep time: the next interval is like the last, give or take 10 %, with three times
/// the probability of anything else.
const RHYTHM_WEIGHT: f64 = 3.0;
const RHYTHM_JITTER: f64 = 0.1;

/// What a ball bounces on.
pub(super) struct Surface {
    /// Scatter of the ratio of successive flights about its slow trend, a Student distribution:
    /// impacts have heavy tails (Montaine et al. 2011).
    pub(super) scatter: f64,
    /// Logarithm of how usual it is.
    pub(super) ln_prior: f64,
}

/// On a good surface the ratio scatters by 1.3 %. On a rough one, and for a ball that spins, by
/// several times as much; that is one drop in seven.
pub(super) const SURFACES: [Surface; 2] = [
    Surface {
        scatter: 0.013,
        ln_prior: -0.15,
    },
    Surface {
        scatter: 0.05,
        ln_prior: -2.0,
    },
];

/// No surface is known to be smoother than this.
pub(super) const LEAST_SCATTER: f64 = 0.003;
/// Scatter in dB of the level from impact to impact, about a slow fall.
const LEVEL_SCATTER_DB: f64 = 3.5;
/// Usual fall of the level from impact to impact in dB, as long as the flights are not known.
const LEVEL_FALL_DB: f64 = 1.0;
/// The sound of an impact is proportional to its speed (synth: `Voice::level_exponent`), and the
/// speed to the flight before: dB for a change of the flight by a factor e.
const LEVEL_FALL_DB_A_FOLD: f64 = 20.0 * std::f64::consts::LOG10_E;
/// Levels of unrelated sounds spread over this range in dB.
const LEVEL_RANGE_DB: f64 = 40.0;
/// Scatter in dB of the spectrum from impact to impact.
const TIMBRE_SCATTER_DB: f64 = 3.0;
/// Spectra of unrelated sounds differ by up to this much in dB.
const TIMBRE_RANGE_DB: f64 = 20.0;
/// Share of impacts that sound unlike the one before: an edge, a finger, a noise over it.
const ODD_SOUND: f64 = 0.15;

/// Density of the Student distribution with two degrees of freedom and this scale, squared.
fn student(x: f64, scale2: f64) -> f64 {
    let spread = scale2 + 0.5 * x * x;
    scale2 / (spread * spread.sqrt()) / (2.0 * SQRT_2)
}

/// Logarithm of how usual a first flight of this duration is.
pub(super) fn ln_first_flight(flight_s: f64) -> f64 {
    3.0 * (flight_s / SHORT_FIRST_S).min(1.0).ln()
}

/// Logarithm of how usual a drop is whose loudest impact has this level.
pub(super) fn ln_loudest(level_db: f64) -> f64 {
    (level_db - QUIET_DB).min(0.0) / LEVEL_FALL_DB_A_FOLD
}

/// The third impact: `change` is the logarithm of the ratio of the first two flights, which tells
/// from how high the ball came to the first, and `ln_flight` that of the first flight in seconds.
pub(super) fn ln_first_ratio(change: f64, ln_flight: f64) -> f64 {
    let ln_height = APEX_M.ln() + 2.0 * (ln_flight - change);
    let ln_usual = -2.0 * (ln_height - HIGH_M.ln()).max(0.0);
    (FIRST_RATIO_DENSITY / rhythm(change)).ln() + ln_usual
}

/// A later impact: `change` is the logarithm of the interval over the last flight, `surprise` its
/// difference from the prediction, which has this variance.
pub(super) fn next_ratio(change: f64, surprise: f64, variance: f64) -> f64 {
    student(surprise, variance) / rhythm(change)
}

/// Logarithm of how likely this surprise is for a ball.
pub(super) fn ln_ratio(surprise: f64, variance: f64) -> f64 {
    student(surprise, variance).ln()
}

/// The largest value of [`next_ratio`] for ratios that scatter with this variance.
pub(super) fn most_from_ratio(scatter2: f64) -> f64 {
    student(0.0, scatter2)
}

/// Logarithm of how likely it is that an impact is so much louder than expected, over that of the expected level.
pub(super) fn ln_level(louder_db: f64) -> f64 {
    (Fall::density(louder_db) / Fall::density(0.0)).ln()
}

/// How much more likely other sounds are if they keep time.
fn rhythm(change: f64) -> f64 {
    let off_beat = 1.0 + 0.5 * (change / RHYTHM_JITTER).powi(2);
    1.0 + RHYTHM_WEIGHT / (off_beat * off_beat)
}

/// How a sound compares with others, in dB.
#[derive(Clone, Copy)]
struct Sound {
    level_db: f64,
    /// Level of the loudest noise in a band: a level below it is not known, only that it is no
    /// louder.
    noise_db: f64,
    /// Levels of the bands in dB relative to the loudest, and what can be measured of them.
    bands: [f32; BANDS],
    floor: [f32; BANDS],
}

impl Sound {
    fn of(onset: &Onset) -> Self {
        /// Bands this far below the loudest are left out: side lobes of its filter.
        const DEPTH_DB: f32 = 15.0;
        let loudest_db = loudest(&onset.band_levels_db);
        Self {
            level_db: onset.level_db,
            noise_db: loudest(&onset.band_noise_db).into(),
            bands: onset.band_levels_db.map(|db| db - loudest_db),
            floor: onset
                .band_noise_db
                .map(|db| (db - loudest_db).max(-DEPTH_DB)),
        }
    }

    /// By how much the next sound is fainter.
    fn fall(&self, next: &Self) -> Fall {
        let noise_db = louder(self.noise_db, next.noise_db);
        Fall {
            db: louder(self.level_db, noise_db) - louder(next.level_db, noise_db),
        }
    }

    /// How much alike this and the next sound are, in level and in spectrum.
    fn similarity(&self, next: &Self) -> f64 {
        self.fall(next).usual() * LEVEL_RANGE_DB * self.timbre(next)
    }

    fn timbre(&self, next: &Self) -> f64 {
        let Some(distance2) = self.timbre_distance2_db(next) else {
            return 1.0;
        };
        // Half a normal distribution, over a uniform one.
        let peak = (2.0 / PI).sqrt() / TIMBRE_SCATTER_DB * TIMBRE_RANGE_DB;
        let alike = peak * (-0.5 * distance2 / (TIMBRE_SCATTER_DB * TIMBRE_SCATTER_DB)).exp();
        (1.0 - ODD_SOUND) * alike + ODD_SOUND
    }

    /// Mean square difference of two spectra in dB, after the difference in level is taken out.
    ///
    /// A band that lies at the noise in one of them says only that the sound is not louder there.
    /// `None` if fewer than two bands can be compared.
    fn timbre_distance2_db(&self, next: &Self) -> Option<f64> {
        let (mut bands, mut sum) = (0, 0.0);
        for band in 0..BANDS {
            let floor = louder(self.floor[band], next.floor[band]);
            let a = louder(self.bands[band], floor);
            let b = louder(next.bands[band], floor);
            bands += i32::from(louder(a, b) > floor);
            sum += (a - b) * (a - b);
        }
        (bands >= 2).then(|| f64::from(sum) / f64::from(bands))
    }
}

/// Without the care for NaN that `max` takes: these are levels.
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

    /// How likely it is while nothing is known of the flights.
    fn usual(&self) -> f64 {
        Self::density(self.db - LEVEL_FALL_DB)
    }

    /// How much more likely it is, now that the logarithm of the ratio of the flights before the
    /// two impacts is known.
    pub(super) fn knowing(&self, ln_ratio: f64) -> f64 {
        Self::density(self.db + LEVEL_FALL_DB_A_FOLD * ln_ratio) / self.usual()
    }

    /// The greatest value of [`Self::knowing`].
    pub(super) fn most(&self) -> f64 {
        Self::density(0.0) / self.usual()
    }
}

/// The sum of 1/k for k up to n.
fn harmonic(n: usize) -> f64 {
    /// Of Euler and Mascheroni.
    const GAMMA: f64 = 0.577_215_664_9;
    (n as f64 + 0.5).ln() + GAMMA
}

/// A stretch of recording in which all onsets are known, in seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Span {
    pub(crate) start_s: f64,
    pub(crate) end_s: f64,
}

impl Span {
    /// All of time.
    pub(crate) const EVER: Self = Self {
        start_s: f64::NEG_INFINITY,
        end_s: f64::INFINITY,
    };
}

/// What surrounds an onset, which says how remarkable a next impact would be.
pub(super) struct Surroundings {
    sound: Sound,
    /// How many onsets at least as strong come each second, itself included.
    rate_hz: f64,
    /// How many onsets come each second, whatever their strength.
    any_rate_hz: f64,
    /// How much alike the onset and those around are: in steady noise all candidates sound alike,
    /// and it means nothing.
    mean_similarity: f64,
}

impl Surroundings {
    /// The surroundings of each of these onsets, which are all that was heard in this span.
    pub(super) fn of(onsets: &[Onset], span: Span) -> Vec<Self> {
        const REACH_S: f64 = 3.0;
        /// So much is taken for heard at least.
        const LEAST_HEARD_S: f64 = 0.5;
        /// Unrelated sounds that are imagined beside those around, so that a few impacts alone in
        /// silence are not taken for the rule.
        const IMAGINED: f64 = 10.0;
        let sounds: Vec<Sound> = onsets.iter().map(Sound::of).collect();
        let (mut first, mut end) = (0, 0);
        std::iter::zip(onsets, &sounds)
            .map(|(onset, &sound)| {
                while onsets[first].time_s < onset.time_s - REACH_S {
                    first += 1;
                }
                while end < onsets.len() && onsets[end].time_s <= onset.time_s + REACH_S {
                    end += 1;
                }
                let near = &onsets[first..end];
                let stronger = near.iter().filter(|o| o.strength >= onset.strength).count();
                // Where nothing was recorded, it was not silent.
                let heard_s = (onset.time_s + REACH_S).min(span.end_s)
                    - (onset.time_s - REACH_S).max(span.start_s);
                let heard_s = heard_s.max(LEAST_HEARD_S);
                let similarities = sounds[first..end].iter().map(|o| sound.similarity(o));
                let similarities: f64 = similarities.sum();
                Self {
                    sound,
                    rate_hz: stronger as f64 * harmonic(near.len()) / heard_s,
                    any_rate_hz: near.len() as f64 / heard_s,
                    mean_similarity: (IMAGINED + similarities) / (IMAGINED + near.len() as f64),
                }
            })
            .collect()
    }

    /// A sound as strong as the one here, at this interval from another. The density of other
    /// sounds is taken over the logarithm of the interval, as that of the next impact is.
    pub(super) fn by_chance(&self, interval_s: f64) -> f64 {
        1.0 / (self.rate_hz * interval_s).max(LEAST_RATE)
    }

    /// The same for any sound, however faint.
    pub(super) fn any_by_chance(&self, interval_s: f64) -> f64 {
        1.0 / (self.any_rate_hz * interval_s).max(LEAST_RATE)
    }

    /// Logarithm of how likely a drop begins here, rather than other sounds.
    pub(super) fn ln_birth(&self) -> f64 {
        let sounds = BETWEEN_DROPS_S * self.rate_hz;
        LN_BIRTH - (sounds / AMONG_SOUNDS).max(1.0).ln()
    }

    /// How much alike the onset here and the next are.
    pub(super) fn likeness(&self, next: &Self) -> f64 {
        self.sound.similarity(&next.sound) / self.mean_similarity
    }

    /// By how much the next onset is fainter.
    pub(super) fn fall(&self, next: &Self) -> Fall {
        self.sound.fall(&next.sound)
    }
}
