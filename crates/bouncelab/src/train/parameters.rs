//! Every number of the search for trains, with unit, meaning and source.
//!
//! None of them is a setting: each has a physical or a statistical meaning. A number without another source was chosen
//! during development on the detection benchmark and on seeds 1 and 11 to 14 of the mixtures, and checked on mixtures of
//! other seeds (`docs/listening.md`).

use super::evidence::Surface;
use super::rhythm::TempoModel;

/// Gravity that the detector assumes, m/s²: it converts flight times to heights and speeds to within some percent.
pub(super) const GRAVITY_M_S2: f64 = 9.81;

// Which trains are reported.

/// Minimum evidence of a train, nats: from there on a drop is more likely than other sounds.
pub(super) const MIN_EVIDENCE: f64 = 0.0;
/// Minimum evidence of a train that is offered where no drop is certain, nats: one in two hundred is a drop.
pub(super) const MIN_CANDIDATE_EVIDENCE: f64 = -5.3;
/// Minimum number of impacts of such a train: two flights show whether they shrink. If there are no three, two sounds that are alike
/// may be the impacts of a ball that soon rests.
pub(super) const MIN_CANDIDATE_IMPACTS: [usize; 2] = [3, 2];
/// Maximum number of such trains of a recording.
pub(super) const MAX_CANDIDATES: usize = 3;
/// Time after a train in which one that begins before the same ball could fall again is searched for, s.
pub(super) const FOLLOWING_REACH_S: f64 = 5.0;
/// Maximum size of the evidence at which the waveforms are compared, nats: they contribute no more than this.
pub(super) const MAX_DOUBT: f64 = 8.0;
/// Maximum number of chains whose sounds are weighed where that of the most evidence is no drop.
pub(super) const MAX_DOUBTED: usize = 3;
/// Minimum evidence of such a chain, nats: sounds seldom add more.
pub(super) const MIN_DOUBTED_EVIDENCE: f64 = -10.0;
/// Minimum difference of level at equal impact speed from which a train is another ball farther away, dB: 12 dB are four
/// times the distance.
pub(super) const MIN_DISTANT_DB: f64 = 12.0;
/// Maximum difference of the times of an impact in two trains that share it, s: alignment moves them.
pub(super) const MAX_SHARED_S: f64 = 0.003;
/// Minimum impacts of a concurrent drop during another one: three determine the ratio of the flights.
pub(super) const MIN_CONCURRENT_IMPACTS: usize = 3;
/// Maximum difference of a delay from the median one for which impacts are echoes, s.
pub(super) const MAX_ECHO_S: f64 = 0.002;

/// Number of the next impacts with which the sound of the first is compared: one of them may be odd.
pub(super) const COMPARED_WITH_FIRST: usize = 3;

// Missed impacts.

/// Minimum flight time of an impact that is searched for, s: a shorter flight is drowned in the ringing of the impact
/// before.
pub(super) const MIN_SEARCHED_FLIGHT_S: f64 = 0.012;
/// Scatter of a predicted flight time, as a share of it.
pub(super) const PREDICTED_FLIGHT_SCATTER: f64 = 0.02;
/// Probability of an impact that only the sound of the others revealed; from which its odds are required.
pub(super) const REVEALED_PROBABILITY: f64 = 0.95;
/// Impacts to each side from which the ratio of the flights is taken.
pub(super) const RATIO_REACH: usize = 6;
/// Maximum time between a drop and its rattling, s.
pub(super) const MAX_RATTLE_GAP_S: f64 = 1.0;
/// Maximum last flight of a drop that may rattle, and first flight of the rattling, s: a rise of 2 cm.
pub(super) const MAX_RATTLE_FLIGHT_S: f64 = 0.13;
/// Maximum difference of the logarithm of a first flight from the expected one for which two trains are one drop.
pub(super) const MAX_JOINED_LN_RATIO: f64 = 0.3;

// When a drop is over.

/// Flights after the last impact in which another may come: two missed impacts and the detected one.
pub(super) const MAX_LAST_FLIGHTS: f64 = 3.0;
/// Maximum delay after which an impact is detected, s.
pub(super) const MAX_NOTICE_S: f64 = 0.3;
/// Minimum time between two drops, s: a fall from 60 cm. Sounds that come sooner are of the same ball, which comes to rest
/// or is not yet released.
pub(super) const MIN_FALL_S: f64 = 0.35;

// Sounds that no train explains.

/// Time before the first and after the last impact of a train in which they are counted, s.
pub(super) const UNUSED_REACH_S: f64 = 1.0;
/// Maximum difference of their level from that of the loudest impact, dB.
pub(super) const UNUSED_BELOW_DB: f64 = 3.0;
/// Number of them from which they are reported: one or two are a hand, a step or a click.
pub(crate) const MIN_UNUSED: usize = 3;
/// How far an earlier impact that sounds alike may be from the expected time, as a share of the flight after it: sound may have been
/// lost.
pub(super) const EARLIER_FLIGHT_REACH: f64 = 0.12;
/// The same for any sound, which may hide the impact: the ratio of two flights scatters by a percent, and the noise of a
/// damaged packet may begin 20 ms before the impact.
pub(super) const HIDDEN_FLIGHT_REACH: f64 = 0.06;
/// Maximum depth of its level below that of the first impact, dB: noise that hides it may begin softly.
pub(super) const HIDDEN_BELOW_DB: f64 = 20.0;
/// Maximum number of such sounds within two flights before the first impact: among more, one is there by chance.
pub(super) const MAX_HIDING: usize = 8;

// Crowds of faint onsets.

/// Time to each side in which faint onsets are counted, s.
pub(super) const CROWD_REACH_S: f64 = 3.0;
/// Maximum number of faint onsets in that time. Among more, some always lie like the impacts of a drop.
pub(super) const MAX_FAINT_ONSETS: usize = 12;

// Concurrent drops.

/// Logarithm of the prior odds of a concurrent drop: one drop in a hundred has another at the same time.
pub(super) const LN_CONCURRENT: f64 = -4.6;
/// Time before and after a drop in which a concurrent drop may begin or end, s.
pub(super) const CONCURRENT_REACH_S: f64 = 10.0;

// Evidence from the sounds around a chain.

/// Time before the first and after the last impact in which other sounds count against isolated impacts, s.
pub(super) const ISOLATION_REACH_S: f64 = 0.5;
/// Time before the first and after the last impact in which other sounds are compared with the impacts, s.
pub(super) const COMPARED_REACH_S: f64 = 1.0;
/// Time before and after those sounds that the waveforms need, s.
pub(super) const COMPARED_MARGIN_S: f64 = 0.1;
/// Maximum number of other onsets compared.
pub(super) const MAX_COMPARED: usize = 20;
/// Factors, each on top of the one before, by which the rate is lowered to compare the waveforms of dull balls. At 44.1 kHz
/// they leave the frequencies below some 5 kHz, 2.5 kHz and 0.7 kHz, the last those of a basketball.
pub(super) const LOWERED_BY: [usize; 3] = [4, 2, 4];
/// Maximum logarithm of how much more probable the waveform of one sound is for an impact, nats: among twenty others one in
/// forty agrees by chance.
pub(super) const MAX_LN_ALIKE: f64 = 3.7;
/// Maximum growth of a flight after the last impact over the one before, in units of the scatter, if the waveform is evidence for it.
pub(super) const MAX_GROWTH_SIGMA: f64 = 3.0;
/// Time before and after a train in which more of its impacts may be found, s.
pub(crate) const ALIGNED_REACH_S: f64 = 2.5;
/// Parameters of the beta distribution of the share of impacts whose sounds agree: uniform, since it depends on ball and
/// recorder.
pub(super) const AGREEING_IMPACTS: (f64, f64) = (1.0, 1.0);
/// The same for all sounds, if there is no drop: rather small, because unrelated sounds are rather unlike.
pub(super) const AGREEING_SOUNDS: (f64, f64) = (1.0, 2.0);
/// The same for the sounds that are no impacts, if there is a drop: one in twenty.
pub(super) const AGREEING_OTHERS: (f64, f64) = (1.0, 19.0);

// Chains.

/// Maximum time between two detected impacts, s: an apex of 4.9 m.
pub(super) const MAX_INTERVAL_S: f64 = 2.0;
/// Minimum flight time, s: an apex of 0.1 mm, where the sounds run into each other.
pub(super) const MIN_FLIGHT_S: f64 = 0.008;
/// Minimum first flight of a train, s: the pitch of a voice looks like shorter flights.
pub(super) const MIN_FIRST_FLIGHT_S: f64 = 0.04;
/// Maximum number of missed impacts in a row.
pub(super) const MAX_MISSED: usize = 2;
/// Logarithm of the minimum flight ratio of a drop of [`MIN_IMPACTS`](super::MIN_IMPACTS) impacts (0.41).
pub(super) const MIN_LN_RATIO: f64 = -0.9;
/// Logarithm of the minimum flight ratio of fewer impacts, which are only offered (0.1).
pub(super) const MIN_DULL_LN_RATIO: f64 = -2.3;
/// Logarithm of the flight ratio of a nearly perfect bounce (0.995).
pub(super) const MAX_LN_RATIO: f64 = -0.005;
/// Maximum difference of the logarithm of an interval from the predicted one.
pub(super) const MAX_SURPRISE: f64 = 0.3;
/// The scatter of the ratios is learnt from the drop itself; its prior counts as this many ratios.
pub(super) const SCATTER_PRIOR_COUNT: f64 = 3.0;
/// Maximum surprise, in units of the scatter, from which the scatter learns: a single outlier teaches no more. (The most
/// likely scatter of a Student distribution with two degrees of freedom counts the square of a surprise of z times the
/// scatter as 3 z² / (2 + z²) times that of the scatter: 2 at twice, and never more than 3.)
pub(super) const MAX_LEARNT_SURPRISE: f64 = 2.0;
/// Maximum hypotheses that are kept for each pair of impacts: which is right often shows only one or two impacts later.
pub(super) const MAX_HYPOTHESES: usize = 4;
/// Minimum difference of the logarithms of the ratios of two kept hypotheses: ratios that differ by less, three times
/// the scatter on a good surface, predict about the same.
pub(super) const MIN_RATIO_DIFFERENCE: f64 = 0.04;
/// Minimum ratio of the variances of two kept hypotheses whose ratios differ by less.
pub(super) const MIN_SCATTER_RATIO: f64 = 3.0;
/// Minimum evidence of a hypothesis that is pursued, nats. Drops begin at about -9, and in a crowd of similar sounds the
/// second and third impacts reduce the evidence more than they add to it.
pub(super) const MIN_PURSUED_EVIDENCE: f64 = -16.0;
/// Minimum evidence of a step, nats: an onset that fits worse is better explained as a missed impact.
pub(super) const MIN_STEP_EVIDENCE: f64 = -4.0;

// The trend of the flights: a - b T².

/// Prior mean of b, 1/s². Drag alone makes it about (g / 2 v)², with v the terminal speed: 0.15 for a table-tennis ball,
/// 0.03 for a basketball, and nearly zero for a steel ball.
pub(super) const TREND_FALL: f64 = 0.07;
/// Prior standard deviation of b, 1/s².
pub(super) const TREND_FALL_SD: f64 = 0.07;
/// Variance by which a changes from flight to flight, as a share of the variance of the ratios (a sixth of the scatter,
/// squared). The filter then remembers six or seven flights, in which a ball with a restitution of 0.9 loses half of its
/// speed; over more the restitution itself changes with speed.
pub(super) const TREND_WANDERING: f64 = 0.0265;
/// Maximum surprise from which the trend learns, so that a single outlier does not bend it.
pub(super) const MAX_TREND_STEP: f64 = 0.05;

// Evidence of an impact.

/// Logarithm of the prior odds of a drop at its first pair of impacts. Drops are rarer than sounds: the expectation is
/// one drop among four hundred sounds, and first flights equally likely, on a logarithmic scale, over a factor of four.
pub(super) const LN_DROP: f64 = -7.4;
/// Minimum expected time between drops, s. The prior rate of drops does not grow with the density of other sounds;
/// otherwise more chains of coincidences would pass, the denser the sounds.
pub(super) const MIN_BETWEEN_DROPS_S: f64 = 300.0;
/// Number of sounds among which one drop is expected, up to that rate.
pub(super) const SOUNDS_PER_DROP: f64 = 400.0;
/// A first flight shorter than this, s, is rarer with its third power: few balls are released below 2 cm, and the louder
/// impacts of one released higher would have been detected.
pub(super) const SHORT_FIRST_FLIGHT_S: f64 = 0.12;
/// A drop from higher than this, m, is rarer with its second power.
pub(super) const HIGH_DROP_M: f64 = 3.0;
/// Density of the logarithm of the ratio of the first two flights: uniform between that of a dead ball (0.4) and 1.
pub(super) const FIRST_RATIO_DENSITY: f64 = 1.1;
/// Logarithm of the odds that an accepted drop continues after a detected impact: of at least three impacts, two are not
/// the last.
pub(super) const LN_CONTINUES: f64 = 0.7;
/// A drop whose loudest impact lies below this level, dB relative to full scale, is rarer in proportion to its amplitude:
/// recorders are set to use their range, and the last bits of a recording make sounds of their own.
pub(super) const QUIET_DB: f64 = -60.0;
/// Logarithm of the probability ratio of an impact that was not detected.
pub(crate) const LN_MISSED: f64 = -3.0;
/// Minimum rate of other sounds, in one flight time. Other sounds do not come at random alone: people knock, clap and play
/// at intervals of their own choice.
pub(super) const MIN_OTHERS_PER_FLIGHT: f64 = 0.5;
/// Other sounds also keep time: the next interval equals the last, within `RHYTHM_JITTER`, with this many times the
/// probability of any other.
pub(super) const RHYTHM_WEIGHT: f64 = 3.0;
/// Scatter of such an interval, as a share of it.
pub(super) const RHYTHM_JITTER: f64 = 0.1;
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
/// Minimum scatter of the ratios: no surface is known to be smoother.
pub(super) const MIN_SCATTER: f64 = 0.003;
/// Scatter of the level from impact to impact about a slow fall, dB.
pub(super) const LEVEL_SCATTER_DB: f64 = 3.5;
/// Expected fall of the level from impact to impact while the flights are unknown, dB.
pub(super) const LEVEL_FALL_DB: f64 = 1.0;
/// Fall of the level for a flight that is shorter by a factor e, dB: the sound pressure is proportional to the impact
/// speed (`synth::Voice::level_exponent`), and the speed to the flight before.
pub(super) const LEVEL_FALL_DB_PER_E_FOLD: f64 = 20.0 * std::f64::consts::LOG10_E;
/// Range of the levels of unrelated sounds, dB.
pub(super) const LEVEL_RANGE_DB: f64 = 40.0;
/// Scatter of the spectrum from impact to impact, dB.
pub(super) const TIMBRE_SCATTER_DB: f64 = 3.0;
/// Range of the difference of the spectra of unrelated sounds, dB.
pub(super) const TIMBRE_RANGE_DB: f64 = 20.0;
/// Share of impacts that sound unlike the one before: an edge, a finger, a noise over it.
pub(super) const OUTLIER_SOUND_SHARE: f64 = 0.15;
/// Maximum depth below the loudest band at which a band is compared, dB: the filters have side lobes.
pub(super) const MAX_BAND_DEPTH_DB: f32 = 15.0;
/// Minimum number of bands of which spectra are compared.
pub(super) const MIN_COMPARED_BANDS: i32 = 2;
/// Time to each side of an onset from which the rate of other sounds is estimated, s.
pub(super) const SURROUNDINGS_S: f64 = 3.0;
/// Lower bound of the observation window, s.
pub(super) const MIN_OBSERVED_S: f64 = 0.5;
/// Unrelated sounds that are assumed in addition to those around, so that a few impacts alone in silence do not define
/// what is usual.
pub(super) const ASSUMED_SOUNDS: f64 = 10.0;

// Sounds that keep time.

/// Logarithm of the prior odds of a rhythm over a drop. People, machines, and voices and strings keep time, and each of the
/// three is at least as usual as a dropped ball.
pub(super) const LN_RHYTHM: f64 = 1.1;
/// Machines keep time within a percent and do not speed up; people do within some percent (Repp 2005)
/// and speed up by as much. All are equally usual.
pub(super) const TEMPO_MODELS: [TempoModel; 5] = [
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
/// Change of the interval of a pulse from one to the next, as a share of it: tiny for a machine, up to some percent for a
/// voice. All are equally usual.
pub(super) const PULSE_CHANGES: [f64; 4] = [0.001, 0.003, 0.01, 0.03];
/// Logarithm of the maximum factor by which a tempo changes in all: hardly anybody speeds up by more.
pub(super) const MAX_LN_TEMPO_CHANGE: f64 = std::f64::consts::LN_2;
/// Logarithm of the density of an interval that has nothing to do with the rhythm: one in twenty, and
/// anything within a factor of e.
pub(super) const LN_OUTLIER_INTERVAL: f64 = -3.0;
/// Logarithm of the density of the first interval of a rhythm, anything within a factor of ten.
pub(super) const LN_FIRST_INTERVAL: f64 = -0.83;
/// Maximum distance of a beat from its expected time, as a share of the interval.
pub(super) const MAX_BEAT_OFFSET: f64 = 0.08;
/// Level above the usual one from which a sound is another one over the beat, dB.
pub(super) const OVER_BEAT_DB: f64 = 12.0;
/// Maximum number of parts into which other sounds of a pulse divide the intervals of a chain.
pub(super) const MAX_PARTS: u32 = 6;
/// Minimum share of these divisions at which there is a sound.
pub(super) const MIN_DIVISIONS: f64 = 0.75;
/// Maximum number of missing beats in a row before a pulse has ended.
pub(super) const MAX_MISSING_BEATS: u32 = 2;
/// Time for which a loud sound and its echoes may hide the beats, s.
pub(super) const HIDDEN_S: f64 = 0.15;

// Alignment of the waveforms.

/// Compared part of each impact before its time, s.
pub(super) const WAVE_BEFORE_S: f64 = 0.0005;
/// Minimum compared part of each impact after its time, s.
pub(super) const MIN_WAVE_AFTER_S: f64 = 0.0025;
/// Maximum compared part of each impact after its time, s: it ends where the impact is no longer heard, and before the
/// next one.
pub(super) const MAX_WAVE_AFTER_S: f64 = 0.008;
/// The compared part ends where the later sound holds less than this share of the energy.
pub(super) const MIN_LATER_SHARE: f64 = 0.03;
/// Maximum time for which an impact rings, s.
pub(super) const MAX_RINGING_S: f64 = 0.1;
/// Noise before an impact from which the whitening is learnt, s.
pub(super) const NOISE_S: f64 = 0.010;
/// Maximum shift of an impact, s.
pub(super) const MAX_SHIFT_S: f64 = 0.006;
/// Minimum shift that is tried, s: in the ringing of the impact before, the standard error of a pick may be too small.
pub(super) const MIN_SHIFT_S: f64 = 0.003;
/// Maximum shift of an impact, in standard errors of its pick, within these bounds.
pub(super) const MAX_SHIFT_SIGMA: f64 = 6.0;
/// Minimum correlation with the others of an impact that is shifted.
///
/// Of the shortest sounds that are compared some 66 samples are independent at 44.1 kHz, so that noise correlates by 0.12
/// with them, and at the best of a hundred shifts by 0.3.
pub(super) const MIN_CORRELATION: f64 = 0.35;
/// Minimum odds that an impact that is shifted sounds like the others. Of impacts 15 % sound unlike the others
/// (`OUTLIER_SOUND_SHARE`): with odds of 8 before that is counted, one in fifty would be shifted wrongly.
pub(super) const MIN_SHIFT_ODDS: f64 = 8.0;
/// Minimum correlation of sounds that agree.
pub(super) const MIN_AGREEMENT: f64 = 0.6;
/// Samples per independent one: the differences between impacts are not white.
pub(super) const SAMPLES_PER_INDEPENDENT: f64 = 2.0;
/// Share of picks that are wrong by any amount rather than by their standard errors.
pub(super) const WRONG_PICK_SHARE: f64 = 0.1;
/// Rounds of each of two passes. The second pass knows from the first where the impacts are and how they ring, and the
/// times settle to well below their errors in three rounds.
pub(super) const ALIGNMENT_ROUNDS: [usize; 2] = [1, 3];
/// Rounds of a comparison: the first finds the shifts at which the impacts agree, the second counts how many do.
pub(super) const AGREEMENT_ROUNDS: usize = 2;
/// Minimum number of sounds of which a stack of the others is informative.
pub(super) const MIN_STACKED: usize = 3;
/// Minimum number of agreeing impacts for a comparison with other sounds.
pub(super) const MIN_AGREEING: usize = 2;
/// Minimum share of the energy of the impacts that smoothing keeps; high frequencies that hold less are steep, and mostly
/// noise.
pub(super) const MIN_KEPT_ENERGY: f64 = 0.97;
/// Number of the loudest impacts by which the smoothing is chosen.
pub(super) const SMOOTHING_IMPACTS: usize = 6;
/// Reaches of the smoothing kernels, in samples, of which the widest that keeps enough is used.
pub(super) const SMOOTHING_REACHES: [usize; 5] = [16, 8, 4, 2, 1];
/// Half the length of the interpolation kernel, in samples.
pub(super) const KERNEL_REACH: usize = 8;
/// Maximum shift in one round, samples.
pub(super) const MAX_STEP_SAMPLES: f64 = 0.5;

// Ringing of the impacts before.

/// Number of silences after impacts that show how they ring.
pub(super) const RINGING_SILENCES: usize = 6;
/// Minimum number of silences: fewer could be outliers.
pub(super) const MIN_RINGING_SILENCES: usize = 3;
/// Number of blocks of the longest ringing in which its power is measured.
pub(super) const RINGING_BLOCKS: usize = 10;
/// The ringing has decayed where its power is at most this many times that at the end.
pub(super) const MAX_DECAYED_RATIO: f32 = 2.0;

// Errors of the aligned times.

/// Degrees of freedom of the differences between impacts. The residuals of one drop are not noise: they behave like this
/// many random numbers, one or two for each mode that rings. (With modes of random phases, 4 for a steel ball to 7 for a
/// basketball give the errors of the times.)
pub(super) const FREE_DIFFERENCES: f64 = 5.0;
/// Minimum difference of an outlier, in units of the usual one.
pub(super) const MIN_OUTLIER_DIFFERENCE: f64 = 4.0;
/// Standard errors of chance that are added to the largest usual difference.
pub(super) const CHANCE_SIGMAS: f64 = 2.0;
/// Minimum standard errors by which the impacts must differ to be called different: the noise is not quite known.
pub(super) const MIN_DIFFERENT_SIGMA: f64 = 3.0;
/// Rounds of the weighted mean of the differences, whose weights depend on it.
pub(super) const DIFFERENCE_ROUNDS: usize = 8;
/// Minimum share of the slope of a template that belongs to the impacts.
pub(super) const MIN_SIGNAL_SHARE: f64 = 0.1;
/// Minimum standard error of a shift, samples.
pub(super) const MIN_SHIFT_SIGMA: f64 = 0.0001;
