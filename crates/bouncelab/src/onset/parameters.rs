//! Every number of the onset detector, with unit, meaning and source.
//!
//! A number without another source was chosen during development on the detection benchmark and on
//! seed 1 of the mixtures, and checked on mixtures of other seeds (`docs/listening.md`).

use super::bands::BANDS;

// The onset that stands for an impact known by its time alone.

/// Standard error of a stated time, s.
pub(super) const CLICK_SIGMA_S: f64 = 1e-4;
/// Strength of a click without noise: far above that of any noise.
pub(super) const CLICK_STRENGTH: f64 = 30.0;
/// Level of a click in dB relative to full scale: an ordinary recording.
pub(super) const CLICK_LEVEL_DB: f64 = -20.0;
/// Level of a click in each band, dB: a fifth of its power.
pub(super) const CLICK_BAND_LEVEL_DB: f32 = -27.0;
/// Noise of each band under a click, dB: that of 16 bits or so.
pub(super) const CLICK_BAND_NOISE_DB: f32 = -90.0;

// Candidates.

/// Minimum strength of a candidate. White noise reaches it about once a second, other backgrounds more often.
pub(super) const MIN_STRENGTH: f64 = 1.5;
/// Minimum strength of a candidate that stands out: white noise hardly ever reaches it.
pub(super) const MIN_DISTINCT_STRENGTH: f64 = 2.0;
/// A candidate is the strongest moment within this time before and after it, s.
pub(super) const SPACING_S: f64 = 0.006;
/// Maximum time by which a precursor comes before its sound, s. A codec smears a sound over its block, half of which
/// lies before the sound (MP3 or AAC at 48 kHz). A microphone close to the surface picks up the ball or the hand
/// before the impact.
pub(super) const MAX_PRECURSOR_S: f64 = 0.010;
/// Minimum power ratio of a sound over its precursor: coders keep pre-echo below what an ear hears, 10 dB and more
/// below the sound.
pub(super) const MIN_PRE_ECHO_RATIO: f64 = 10.0;
/// Hops at the end of a sound in which there is no candidate: where the sound breaks off is not an onset.
pub(super) const END_HOPS: f64 = 2.0;
/// Floor of powers in decibels: -140 dB, the step of 24 bits.
pub(super) const MIN_DECIBEL_POWER: f64 = 1e-14;

// Bands.

/// Edges of the lower bands, Hz; a band above the Nyquist frequency is cut or dropped.
pub(super) const LOW_EDGES_HZ: [(f64, f64); 2] = [(80.0, 400.0), (400.0, 1500.0)];
/// The octaves halve the rate until it is below this, Hz: 4 to 8 kHz for most recordings. The third band takes two
/// octaves from there, each band above it one.
pub(super) const MAX_LOW_RATE_HZ: f64 = 8000.0;
/// Maximum number of octaves that are split off: rates up to 2 MHz.
pub(super) const MAX_HALVINGS: f64 = 8.0;
/// Maximum upper edge of a lower band, in units of the low rate: below the Nyquist frequency by a tenth.
pub(super) const MAX_LOW_EDGE: f64 = 0.45;
/// Minimum ratio of the edges of a lower band; a narrower band is dropped.
pub(super) const MIN_EDGE_RATIO: f64 = 1.3;
/// Minimum share of a band that lies in the range of frequencies to use.
pub(super) const MIN_SHARE_IN_RANGE: f64 = 0.5;
/// Time of each value of band energy, s, to the nearest whole number of low-rate samples.
pub(super) const HOP_S: f64 = 0.0005;
/// Maximum samples of a hop, whatever sample rate a broken file states.
pub(super) const MAX_HOP: usize = 2048;
/// Hops of a frame, which are evaluated together.
pub(super) const FRAME_HOPS: usize = 64;
/// Real backgrounds fluctuate more than steady noise: as if their bands were narrower by this factor.
pub(super) const STEADINESS: f64 = 0.65;
/// Offset that keeps recursive filters out of denormal numbers in digital silence, -200 dB of full scale.
pub(super) const DENORMAL_GUARD: f32 = 1e-10;

// Novelty.

/// Time after a moment in which the energy is compared, s, by band: a low band needs longer for as many independent
/// values.
pub(super) const AFTER_S: [f64; BANDS] = [0.008, 0.004, 0.002, 0.002, 0.002];
/// Time before a moment with which it is compared, s, by band.
pub(super) const BEFORE_S: [f64; BANDS] = [0.030, 0.016, 0.012, 0.012, 0.012];
/// Minimum rise that counts, in standard deviations of the rises that noise makes.
pub(super) const MIN_RISE: f64 = 1.0;
/// Share of the minimum novelty from which a moment is evaluated in full: the approximation of the first pass is rounded
/// to single precision.
pub(super) const SCREEN_SHARE: f64 = 0.99;
/// Hops that are screened at a time.
pub(super) const SCREENED_HOPS: usize = 16;
/// Maximum hops of any time, whatever sample rate a broken file states.
pub(super) const MAX_HOPS: usize = 512;
/// Frames after which the sums of energies start afresh, so that a loud past does not swallow the digits of a quiet
/// present.
pub(super) const FRAMES_SUMMED: usize = 8;

// Noise floor.

/// Time over which the noise floor is a quantile of the band energy, s.
pub(super) const FLOOR_S: f64 = 0.6;
/// That quantile is low: the sound between the impacts, however dense they are.
pub(super) const FLOOR_QUANTILE: f64 = 0.3;
/// Hops over which each value of the floor is a mean.
pub(super) const FLOOR_HOPS: usize = 4;
/// Power of digital silence: its square still differs from 0 in single precision.
pub(super) const MIN_POWER: f64 = 1e-18;
/// Share of the samples of a frame, as a divisor, in which the steps of the format are searched for.
pub(super) const STEP_DIVISOR: usize = 8;

// The time of an onset.

/// Time before the rough time from which the linear prediction is learnt, s.
pub(super) const LEARN_S: f64 = 0.020;
/// Time before the rough time in which the onset is searched for, s.
pub(super) const PICK_BEFORE_S: f64 = 0.005;
/// Time after the rough time in which the onset is searched for, s.
pub(super) const PICK_AFTER_S: f64 = 0.004;
/// Minimum time from the beginning of a precursor to the onset, s: pre-echo of a codec, the air that the ball pushes, a
/// noise gate that opens.
pub(super) const MIN_PRECURSOR_S: f64 = 0.001;
/// Minimum ratio of the power after the onset over that of its precursor.
pub(super) const MIN_PRECURSOR_RATIO: f64 = 10.0;
/// Minimum samples from which a variance is estimated.
pub(super) const MIN_VARIANCE_SAMPLES: usize = 4;
/// Moments that are less likely than the best by more than this are left out of the mean, nats.
pub(super) const MAX_NATS: f32 = 30.0;

// Samples.

/// Maximum rate that is analysed, Hz; higher rates are divided by the smallest whole number that lowers them to it.
pub(super) const MAX_RATE_HZ: u32 = 96_000;
/// Reach of the filter that lowers the rate, to each side, in samples of the new rate.
pub(super) const DECIMATOR_REACH: usize = 16;
/// Frequency at which half of the power passes that filter, in units of the new rate.
pub(super) const DECIMATOR_CUT: f64 = 0.415;
/// Frames of a piece of the remembered samples.
pub(super) const PIECE_FRAMES: usize = 32;
