//! The numbers of the inference: each with its unit, what it means and where it comes from.
//!
//! A number without a source was chosen on simulated drops, on which results hardly depend on it. The numbers of a
//! restitution law are in its file, those of a published formula beside the formula, and the priors that a user can
//! change are the defaults of [`Priors`](super::Priors).

use std::f64::consts::LN_2;

// ---- The data.

/// Standard error of times that come without one, s: what a person reads off a waveform.
pub(super) const READ_OFF_S: f64 = 1e-4;

/// Steps to which times of a list may be rounded, s, coarsest first.
pub(super) const ROUNDED_TO_S: [f64; 2] = [1e-2, 1e-3];

/// How far a time may lie from a multiple of such a step, in steps.
pub(super) const ROUNDING_TOLERANCE: f64 = 1e-6;

/// Least standard error of a time, s. Without any error and scatter the covariance would be singular.
pub(super) const MIN_TIME_SD_S: f64 = 1e-9;

/// Maximum number of impacts missed between two that were detected.
pub(super) const MAX_MISSED: usize = 8;

// ---- How many flights lie between two impacts.

/// Standard deviation of the logarithm of a flight time, as the one before predicts it: drag changes the ratio of
/// successive flights along a drop, and impacts scatter.
pub(super) const FLIGHT_RATIO_SD: f64 = 0.06;

/// Largest cost of a flight, as a log likelihood. One that is less likely under every number of flights is an outlier.
pub(super) const OUTLIER_COST: f64 = 20.0;

/// The ratio of successive flights follows its deviations as the mean of this number of flights.
pub(super) const RATIO_MEMORY: f64 = 4.0;

/// The ratio does not follow deviations of more than this number of standard deviations.
pub(super) const MAX_RATIO_SDS: f64 = 3.0;

/// Largest ratio of successive flights.
pub(super) const MAX_RATIO: f64 = 0.999;

/// The searches begin with ratios from this one, of a dead ball, to 1, evenly in the logarithm.
pub(super) const MIN_START_RATIO: f64 = 0.4;

/// Number of these ratios.
pub(super) const START_RATIOS: usize = 24;

/// Maximum number of flights in the first interval with which a search begins.
pub(super) const MAX_FIRST_FLIGHTS: usize = 4;

/// A numbering whose cost exceeds the least by more than this is not fitted. Generous, because the ratio of two flights
/// contains less information than the fit.
pub(super) const MAX_EXCESS_COST: f64 = 14.0;

/// Maximum number of numberings that are fitted besides the one given.
pub(super) const MAX_OTHER_NUMBERINGS: usize = 12;

// ---- The flights.

/// Steps of a flight table up to the launch speed that the longest flight would have without air;
/// at a drag of a third of the weight they are accurate to 1e-6.
pub(super) const TABLE_STEPS: f64 = 26.0;

/// Least and greatest end of a flight table, over that launch speed: more for drag, and for the fall before a dead first
/// impact.
pub(super) const TABLE_REACH: [f64; 2] = [2.2, 6.0];

/// Relative distance from the nominal duration of a flight at which the parabola through it meets the table again.
pub(super) const PARABOLA_REACH: f64 = 0.02;

/// Logarithm of the speeds of a flight that the tables do not contain: no likelihood is left, but a weight of zero still
/// gives zero.
pub(super) const IMPOSSIBLE_LOG_SPEED: f64 = 1e200;

// ---- The reference speed.

/// Largest median of ln e that is accepted: a ball cannot gain speed, but few impacts with errors may suggest it.
pub(super) const MAX_LOG_RESTITUTION: f64 = 0.1;

/// Least ratio of the fastest to the slowest impact, since laws with a knee need a range.
pub(super) const MIN_SPEED_RATIO: f64 = 1.05;

/// Least restitution of the first impact that widens the range of speeds: a dead ball shows little of its own curve.
pub(super) const MIN_FIRST_RESTITUTION: f64 = 0.2;

/// The restitution with which a search starts where no impact shows one.
pub(super) const START_RESTITUTION: f64 = 0.8;

/// Limits of the restitution with which a search starts.
pub(super) const START_RESTITUTIONS: [f64; 2] = [0.05, 0.995];

/// Least scatter with which a search starts.
pub(super) const MIN_START_SCATTER: f64 = 1e-4;

/// Largest absolute value of the standard normals of scatter and timing with which a search starts.
pub(super) const MAX_START_NORMAL: f64 = 3.0;

// ---- The unknowns.

/// Prior standard deviation of the logarithm of the factor on the standard errors of the times, if they were not given:
/// stopwatches that a threshold stops were off by 0.4 ms for table tennis and 3 ms for rubber and tennis, as errors of one
/// sign in a flight and of the other in the next show.
pub(super) const UNSTATED_TIMING_SD: f64 = 2.0;

/// With this number of flights the data determine the noise to about a fifth; the precision of the restitution
/// then depends little on it.
pub(super) const MANY_FLIGHTS: usize = 16;

/// Mean of the standard deviations of the logarithm of the scatter below and above its median, before the data, and half
/// their difference.
pub(super) const SCATTER_LOG_SD: f64 = 0.85;
pub(super) const SCATTER_SKEW: f64 = 0.15;

/// Least scatter of ln e from impact to impact. The best surfaces repeat to a few parts in ten thousand, and no law holds
/// better: with less, a drop that was simulated without any scatter would determine combinations of drag and law to more
/// digits than either is known.
pub(super) const MIN_SCATTER: f64 = 2e-4;

/// Least derivative of ln(launch speed) by ln(impact speed) in Newton's method, which needs a slope.
pub(super) const MIN_KEPT: f64 = 0.1;

/// Newton's method ends when a step of the logarithm of a speed is below this.
pub(super) const NEWTON_TOLERANCE: f64 = 1e-9;

/// Maximum number of Newton steps for the first launch of an interval with missed impacts, and for a terminal speed.
pub(super) const MAX_GAP_STEPS: usize = 40;
pub(super) const MAX_TERMINAL_SPEED_STEPS: usize = 30;

// ---- The likelihood.

/// A chi-squared variable with twice this number of degrees of freedom is a sum of this number of exponential ones.
pub(super) const SCATTER_EXPONENTIALS: usize = 3;

/// Degrees of freedom of the scatter: nearly normal in the middle, with the fourth moment (an excess of 3) of the two
/// exponentials that were measured (J.-Y. Montaine et al., arXiv 1104.0049).
pub(super) const SCATTER_FREEDOM: f64 = 2.0 * SCATTER_EXPONENTIALS as f64;

/// Degrees of freedom above which a Student's t is taken as normal.
pub(super) const MAX_FREEDOM: f64 = 1e6;

/// Beyond about this number of standard deviations an innovation is an outlier, and does not affect its neighbours.
pub(super) const OUTLIER_SDS: f64 = 3.0;

/// Least weight of a residual: its variance is divided by it.
pub(super) const MIN_WEIGHT: f64 = 1e-3;

/// Factors of a likelihood that are multiplied before their logarithm is taken: none is so small or large
/// that their product leaves the range of numbers.
pub(super) const FACTORS_PER_LOGARITHM: usize = 8;

/// Step of central differences, in the coordinates of the unknowns, whose priors have a standard deviation of about 1.
pub(super) const DIFFERENCE_STEP: f64 = 1e-4;

// ---- The search for the best fit.

/// Distance from the best fit, in standard deviations, from which the step that the expected curvature suggests ends so
/// near to it that nothing need be evaluated there. The sampling would tolerate more, but so the end hardly depends on
/// the path.
pub(super) const NEAR_SDS: f64 = 3e-2;

/// Maximum number of steps.
pub(super) const MAX_FIT_STEPS: usize = 40;

/// Fractions of a step that are tried: in the lanes they take little longer than one.
pub(super) const STEP_FRACTIONS: [f64; 8] = [
    1.0 / 64.0,
    1.0 / 32.0,
    1.0 / 16.0,
    0.125,
    0.25,
    0.5,
    1.0,
    2.0,
];

/// Where none of them leads uphill, steps shorter by this factor are tried: far from the maximum the expected curvature
/// may be wrong.
pub(super) const SHORT_STEP: f64 = 1.0 / 256.0;

/// A step that promises more than this of the log posterior starts too far away for earlier steps to show the curvature at
/// the maximum.
pub(super) const LARGE_GAIN: f64 = 1.0;

/// If a step promises less than this, the whole is hardly ever worse than a fraction.
pub(super) const SMALL_GAIN: f64 = 0.1;

/// Hardly a search gains more than this number of times what its next step promises.
pub(super) const MAX_GAIN_OVER_PROMISE: f64 = 20.0;

// ---- The candidates.

/// A candidate that is more probable than this is relevant for diagnostics.
pub(super) const RELEVANT_WEIGHT: f64 = 0.05;

/// A candidate whose log evidence is lower than the best by more than this is not sampled: at most one
/// draw in a thousand would come from it.
pub(super) const PRUNE_BELOW: f64 = 7.0;

/// A ball is possible unless the log evidence of another is higher by more than this: odds of 1 to 20.
pub(super) const ALLOWED_BALL: f64 = 3.0;

/// Logarithm of the prior probability of one more impact before the first one detected: half as likely.
pub(super) const LN_MISSED_FIRST: f64 = -LN_2;

/// Logarithm of the probability that an impact as loud as the first one detected is not detected where nothing is nearly as
/// loud: one in a hundred thousand.
pub(super) const LN_UNDETECTED: f64 = -11.5;

/// Logarithm of the probability that a height or a release is stated wrongly: one in ten.
pub(super) const LN_STATED_WRONG: f64 = -2.3;

/// Logarithm of the range of the logarithm of heights that are stated wrongly: anything from 2 cm to 10 m.
pub(super) const LN_HEIGHTS: f64 = 1.8;

/// Logarithm of the range of releases that are stated wrongly, in s: anything within ten seconds.
pub(super) const LN_RELEASES: f64 = 2.3;

/// An impact so shortly before a sound may be that sound, s: its time is known by a fit alone.
pub(super) const SAME_SOUND_S: f64 = 0.05;

/// Maximum number of impacts missed before the first one detected. They are the loudest.
pub(super) const MAX_MISSED_FIRST: usize = 12;

// ---- Whether the first impact belongs to the drop.

/// ln (2 π)^1/2: the constant of a normal density, which the likelihood leaves out of each time and each stated number.
pub(super) const LN_NORMAL: f64 = 0.918_938_533_204_672_7;

/// Logarithm of the probability that the first impact detected is another sound: one in ten.
pub(super) const LN_OTHER_SOUND: f64 = -2.3;

/// Share of these sounds that are impacts of the same ball, such as of an earlier drop, and sound like it.
pub(super) const OTHER_SOUND_ALIKE: f64 = 0.5;

/// Logarithm of the range of their times before the next impact, of which all are equally likely on a logarithmic scale:
/// those of 0.04 to 2 s are taken for flights.
pub(super) const LN_INTERVALS: f64 = 3.9;

/// Difference of the logarithm of the first flight from the expected one up to which an odd impact explains it, and the one
/// further in which that is less probable by a factor e.
pub(super) const MAX_ODD_SECOND: f64 = 0.25;
pub(super) const ODD_SECOND_FALL: f64 = 0.04;

/// Least number of impacts after another sound: three show a restitution.
pub(super) const MIN_REST: usize = 3;

/// A first impact that is another sound with less than this probability is not doubted: an interval of 95 % does not reach to
/// it. With more than the second it is left out.
pub(super) const DOUBTFUL_FIRST: f64 = 0.025;
pub(super) const OTHER_FIRST: f64 = 0.99;

// ---- The sampling.

/// Exponential variables of the proposal, as of the scatter.
pub(super) const PROPOSAL_EXPONENTIALS: usize = 3;

/// Degrees of freedom of the proposal: tails heavier than those of a posterior, so that no region
/// is forgotten.
pub(super) const PROPOSAL_FREEDOM: f64 = 2.0 * PROPOSAL_EXPONENTIALS as f64;

/// The proposal is wider than the posterior by this factor, and by its powers in further rounds.
pub(super) const WIDENING: f64 = 1.1;

/// Draws of a first round for each unknown: enough to determine centre and shape.
pub(super) const PILOT_DRAWS: usize = 40;

/// Share of effective draws that proposals usually have. A normal posterior of ten unknowns would give 0.7.
pub(super) const USUAL_SHARE: f64 = 0.4;

/// From a proposal that fits badly at most three draws are made for one.
pub(super) const MIN_SHARE: f64 = 0.33;

/// With this fraction of the draws requested, another round is not worthwhile.
pub(super) const ENOUGH_DRAWS: f64 = 0.8;

/// Pareto shape of the weights above which another round is worthwhile.
pub(super) const DOUBTFUL_SHAPE: f64 = 0.6;

/// Maximum number of rounds.
pub(super) const MAX_ROUNDS: i32 = 6;

/// The weights of fewer draws have a tail too short to show its shape.
pub(super) const MIN_DRAWS: usize = 128;

/// Powers of the weights that are tried until there are enough effective draws to adapt the proposal.
pub(super) const FLATTENING_POWERS: [f64; 3] = [1.0, 0.5, 0.25];

/// Effective draws for each unknown that determine a covariance.
pub(super) const MIN_DRAWS_PER_UNKNOWN: f64 = 8.0;

/// Above this Pareto shape the weights cannot be trusted (A. Vehtari et al., Pareto smoothed importance sampling, JMLR 25,
/// 2024).
pub const MAX_PARETO_SHAPE: f64 = 0.7;

/// The tail of n weights is a fifth of them, at most 3 n^1/2 (Vehtari et al.).
pub(super) const TAIL_SHARE: f64 = 0.2;
pub(super) const TAIL_ROOTS: f64 = 3.0;

/// Least number of weights in a tail.
pub(super) const MIN_TAIL: usize = 5;

/// A candidate that is sampled gets at least this part of the draws, so that its evidence is known well enough
/// for its small weight.
pub(super) const MIN_PART_OF_DRAWS: usize = 40;

// ---- The answers.

/// Expensive summaries use one of this number of draws.
pub(super) const THINNING: usize = 2;

/// Time and path until rest of a drop that is only compared with others use one of this number of draws: sixty determine
/// a standard uncertainty to a tenth.
pub(super) const SPARSE: usize = 16;

/// Share of the draws that must come to rest: the others last longest, so without them the time would be too short.
pub(super) const MIN_SHARE_AT_REST: f64 = 0.99;

/// Maximum number of bounces until rest: from a height of a metre a ball with more would keep 99.75 % of its speed each
/// time.
pub(super) const MAX_BOUNCES: usize = 2000;

/// At this launch speed, m/s, a ball rises five micrometres: what follows is a geometric series, as it is when flights get
/// shorter than the contact.
pub(super) const REST_M_S: f64 = 0.01;

/// Below the slowest impact detected the ratio of speed lost to speed kept falls no faster than this power of the speed:
/// that of sound waves in elastic bodies, which remain where all other losses have gone (S. C. Hunter, J. Mech. Phys.
/// Solids 5, 162, 1957; of viscous bodies it is 1/5). A law that is extrapolated may fall to nothing.
pub(super) const MAX_LOSS_EXPONENT: f64 = 0.6;

/// Points of the restitution law over speed: enough for a smooth curve.
pub(super) const BAND_POINTS: usize = 40;

/// The curve begins and ends at these multiples of the slowest and the fastest impact speed.
pub(super) const BAND_ENDS: [f64; 2] = [0.9, 1.05];

/// With a relative uncertainty of 1 or more an input is left to the data: its prior is a normal distribution of the
/// logarithm with standard deviation one, which is a factor of 2.7 either way.
pub const UNKNOWN: f64 = 1.0;

/// If the data leave more than this of the standard deviation of a prior, they determine next to nothing.
pub const UNINFORMATIVE: f64 = 0.9;

/// An unknown is summarised if more than one of this number of draws has it.
pub(super) const MIN_PART_WITH_UNKNOWN: usize = 10;

/// A quantity whose relative standard deviation is below this does not vary.
pub(super) const CONSTANT_REL_SD: f64 = 1e-12;

/// If more than this of the standard deviation of its prior remains, the restitution is not determined: two impacts without a
/// drop height leave 0.7, three leave 0.1 or less.
pub(super) const MAX_REMAINING_RESTITUTION: f64 = 0.5;

/// Round speeds at which the restitution is stated, m/s: of 1, 2, 5, 10, ... those that balls reach, the nearest to 1 m/s
/// first.
pub(super) const ROUND_SPEEDS_M_S: [f64; 9] = [1.0, 2.0, 0.5, 5.0, 0.2, 10.0, 0.1, 20.0, 0.05];

// ---- The diagnostics.

/// An impact with less weight than this is an outlier: of regular ones about one in a thousand has so little.
pub(super) const OUTLIER_WEIGHT: f64 = 0.25;

/// Up to so many impacts each flight may be two: that one is missed between each two of more is not to be expected.
pub(super) const MAX_DOUBLED: usize = 6;

/// Drop height in metres below which nobody lets a ball fall to measure it.
pub(super) const MIN_DOUBLED_HEIGHT_M: f64 = 0.15;

/// Fewer impacts than this leave most to the priors.
pub(super) const FEW_IMPACTS: usize = 5;

/// A scatter larger than the typical one by more than this factor contradicts its prior.
pub(super) const LARGE_SCATTER_FACTOR: f64 = 2.0;

/// With this number of restitutions the data determine the logarithm of the scatter to 1/6, five times as well as the
/// prior, which reduces it by a twentieth.
pub(super) const MANY_RESTITUTIONS: usize = 20;
