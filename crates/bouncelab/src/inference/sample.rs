//! Importance sampling of the posterior of one model.
//!
//! The best fit and its curvature give a normal distribution; draws from a Student's t of that
//! shape, weighted by what the posterior really is, are the posterior. Where a first round shows that they do not
//! fit, it corrects centre and shape; where that does not help, the widths follow the scatter. The draws are those
//! of a scrambled Sobol sequence: each of them is as random as any, but together they cover the distribution more
//! evenly than independent ones, so that fewer do (A. Owen, Ann. Stat. 25, 1541, 1997). The largest weights are
//! smoothed by the generalised Pareto distribution that their tail follows, whose shape k shows whether the weights
//! can be trusted at all (A. Vehtari et al., Pareto smoothed importance sampling, JMLR 25, 2024).

use std::array;
use std::f64::consts::SQRT_2;
use std::ops::Add;

use nalgebra::{Cholesky, DMatrix, DVector};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use sobol_burley::{NUM_DIMENSION_SETS_4D, sample_4d};

use super::fit::Fit;
use super::parameters::{
    DOUBTFUL_SHAPE, ENOUGH_DRAWS, FLATTENING_POWERS, MAX_PARETO_SHAPE, MAX_ROUNDS, MIN_DRAWS,
    MIN_DRAWS_PER_UNKNOWN, MIN_SHARE, MIN_TAIL, PILOT_DRAWS, PROPOSAL_EXPONENTIALS,
    PROPOSAL_FREEDOM, TAIL_ROOTS, TAIL_SHARE, USUAL_SHARE, WIDENING,
};
use super::unknowns::{Model, Slot};
use crate::simd::{LANES, Lanes, dispatch};
use crate::stats::sorted;

/// Weighted draws of the posterior of one model.
#[derive(Debug, Clone)]
pub(super) struct Sample {
    /// One in each column.
    pub(super) vectors: DMatrix<f64>,
    /// Weights, which add up to one.
    pub(super) weights: Vec<f64>,
    /// Number of independent draws with the same information.
    pub(super) effective_draws: f64,
    /// Logarithm of the evidence, but for a constant that all models of the same data share.
    pub(super) log_evidence: f64,
    /// Shape of the tail of the weights.
    pub(super) pareto_shape: f64,
}

impl Sample {
    /// Whether its weights can be trusted more; if both can be trusted, whether it has more effective draws.
    fn is_better_than(&self, other: &Self) -> bool {
        if self.pareto_shape.max(other.pareto_shape) < DOUBTFUL_SHAPE {
            self.effective_draws > other.effective_draws
        } else {
            self.pareto_shape < other.pareto_shape
        }
    }

    /// Frees the memory of the draws, a megabyte; what they were worth remains.
    pub(super) fn forget_draws(&mut self) {
        self.vectors = DMatrix::zeros(0, 0);
        self.weights = Vec::new();
    }
}

/// A multivariate Student's t, or a funnel of it.
struct Proposal {
    centre: DVector<f64>,
    /// Lower triangular root of its shape.
    root: DMatrix<f64>,
    funnel: Option<Funnel>,
}

/// How the widths of all other unknowns follow one of them (R. M. Neal, Ann. Stat. 31, 705, section 8, 2003).
struct Funnel {
    by: usize,
    /// Derivatives by it of the means of all unknowns.
    slopes: DVector<f64>,
    /// Derivative by it of the logarithms of their widths.
    rate: f64,
}

impl Funnel {
    /// That of draws off their mean with weights that add up to one, and where its axis has the mean of the unknown. The axis
    /// is the regression by the widths, the rate is half the slope of the logarithm of the squared distance from it; each
    /// takes the other.
    fn of(by: usize, off: &DMatrix<f64>, weights: &DVector<f64>) -> Option<(Self, DVector<f64>)> {
        const ROUNDS: usize = 5;
        let position = off.row(by).transpose();
        // Slopes of rows of values, and the values at the mean.
        let regression = |values: &DMatrix<f64>, weights: &DVector<f64>| {
            let total = weights.sum();
            let mean = position.dot(weights) / total;
            let leverage = position.add_scalar(-mean).component_mul(weights);
            let slopes = values * &leverage / position.dot(&leverage);
            let at_mean = values * weights / total - &slopes * mean;
            (slopes, at_mean)
        };
        let precise =
            |rate: f64| weights.component_mul(&position.map(|by| (-2.0 * rate * by).exp()));
        let mut rate = 0.0;
        let (mut slopes, mut axis) = regression(off, weights);
        for _ in 0..ROUNDS {
            let mut others = off - &slopes * position.transpose();
            for mut off in others.column_iter_mut() {
                off -= &axis;
            }
            let others = others.remove_row(by);
            let information = Cholesky::new(covariance_of(&others, &precise(rate)))?;
            let squares = information.solve(&others).component_mul(&others);
            let logs = DMatrix::from_rows(&[squares.row_sum().map(f64::ln)]);
            rate = 0.5 * regression(&logs, weights).0[0];
            (slopes, axis) = regression(off, &precise(rate));
        }
        let funnel = Self { by, slopes, rate };
        rate.is_finite().then_some((funnel, axis))
    }

    /// Takes the funnel out of draws off its axis.
    fn straighten(&self, off: &mut DMatrix<f64>) {
        for mut off in off.column_iter_mut() {
            let by = off[self.by];
            let narrow = (-self.rate * by).exp();
            let expected = &self.slopes * by;
            off.copy_from(&(&expected + (&off - &expected) * narrow));
        }
    }
}

/// The covariance of draws off their mean.
fn covariance_of(off: &DMatrix<f64>, weights: &DVector<f64>) -> DMatrix<f64> {
    let mut weighted = off.clone();
    for (mut column, weight) in weighted.column_iter_mut().zip(weights) {
        column *= weight.sqrt();
    }
    &weighted * weighted.transpose()
}

impl Proposal {
    fn new(centre: DVector<f64>, covariance: DMatrix<f64>, widening: f64) -> Option<Self> {
        let root = Cholesky::new(covariance * (widening * widening))?.unpack();
        Some(Self {
            centre,
            root,
            funnel: None,
        })
    }

    /// Writes the draws that points of the unit cube stand for, from one of their sequence on, one in each column; the
    /// logarithms of their densities, but for a constant.
    fn draw(&self, seed: u32, from: usize, draws: &mut DMatrix<f64>) -> Vec<f64> {
        let dimensions = self.centre.len();
        let mut densities = Vec::with_capacity(draws.ncols());
        for first in (0..draws.ncols()).step_by(LANES) {
            let numbers = array::from_fn(|lane| (from + first + lane) as u32);
            let (drawn, density) = dispatch(
                #[inline(always)]
                || {
                    self.transformed(&coordinates::<LANES>(
                        numbers,
                        seed,
                        dimensions + PROPOSAL_EXPONENTIALS,
                    ))
                },
            );
            let used = LANES.min(draws.ncols() - first);
            for (unknown, drawn) in drawn.iter().enumerate() {
                for (lane, drawn) in drawn.0[..used].iter().enumerate() {
                    draws[(unknown, first + lane)] = *drawn;
                }
            }
            densities.extend_from_slice(&density.0[..used]);
        }
        densities
    }

    /// The draws that uniform numbers stand for, of which the last few, as many as there are exponentials, are multiplied;
    /// and the logarithms of their densities.
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    fn transformed<const L: usize>(&self, uniform: &[Lanes<L>]) -> (Vec<Lanes<L>>, Lanes<L>) {
        let dimensions = self.centre.len();
        let (uniform, exponential) = uniform.split_at(dimensions);
        let normal: Vec<Lanes<L>> = uniform.iter().copied().map(normal_quantile).collect();
        let product = exponential
            .iter()
            .fold(Lanes::all(1.0), |product, &it| product * it);
        let chi_squared = product.ln() * -2.0;
        let stretch = (Lanes::all(PROPOSAL_FREEDOM) / chi_squared).sqrt();
        let off = (0..dimensions).map(|row| {
            let terms = (0..=row).map(|column| normal[column] * self.root[(row, column)]);
            terms.fold(Lanes::all(0.0), Add::add) * stretch
        });
        let mut off: Vec<Lanes<L>> = off.collect();
        let squares = normal
            .iter()
            .fold(Lanes::all(0.0), |sum, normal| sum + *normal * *normal);
        let square = squares * stretch * stretch;
        let density = (square * (1.0 / PROPOSAL_FREEDOM) + 1.0).ln()
            * (-0.5 * (PROPOSAL_FREEDOM + dimensions as f64));
        let mut log_volume = Lanes::all(0.0);
        if let Some(Funnel { by, slopes, rate }) = &self.funnel {
            let by = off[*by];
            let log_width = by * *rate;
            for (off, slope) in off.iter_mut().zip(slopes) {
                let expected = by * *slope;
                *off = expected + (*off - expected) * log_width.exp();
            }
            log_volume = log_width * (dimensions as f64 - 1.0);
        }
        let drawn = off.into_iter().zip(&self.centre);
        let drawn = drawn.map(|(off, centre)| off + *centre).collect();
        (drawn, density - log_volume)
    }

    /// Logarithm of the constant that [`Self::draw`] leaves out of the density.
    fn log_constant(&self) -> f64 {
        let dimensions = self.centre.len() as f64;
        let log_root: f64 = self.root.diagonal().iter().map(|d| d.ln()).sum();
        log_gamma(0.5 * (PROPOSAL_FREEDOM + dimensions))
            - log_gamma(0.5 * PROPOSAL_FREEDOM)
            - 0.5 * dimensions * (PROPOSAL_FREEDOM * std::f64::consts::PI).ln()
            - log_root
    }
}

/// Coordinates of points of a scrambled Sobol sequence, by the numbers of the points, each above 0 and below 1.
#[cfg_attr(not(target_family = "wasm"), inline(always))]
fn coordinates<const L: usize>(numbers: [u32; L], seed: u32, dimensions: usize) -> Vec<Lanes<L>> {
    /// As many points as a sequence has; those beyond belong to another.
    const LENGTH: u32 = 1 << 16;
    /// Half of the last digit: the sequence has zero, but not one.
    const HALF: f64 = 1.0 / (1 << 25) as f64;
    let mut coordinates = vec![Lanes::all(0.5); dimensions.next_multiple_of(4)];
    let sets = coordinates
        .chunks_exact_mut(4)
        .zip(0..NUM_DIMENSION_SETS_4D);
    for (four, set) in sets {
        for (lane, number) in numbers.iter().enumerate() {
            let seed = seed.wrapping_add(number / LENGTH);
            let of_point = sample_4d(number % LENGTH, set, seed);
            for (coordinate, of_point) in four.iter_mut().zip(of_point) {
                coordinate.0[lane] = f64::from(of_point) + HALF;
            }
        }
    }
    coordinates.truncate(dimensions);
    coordinates
}

/// One of a sequence of numbers that are normal together, evenly so over any part of it.
pub(super) fn standard_normal(number: u32) -> f64 {
    normal_quantile(coordinates([number], 0, 1)[0]).0[0]
}

/// The number below which a standard normal is with a probability from 2^-25 to 1 - 2^-25, to 1e-6: 2^1/2 times the
/// inverse error function of M. Giles (GPU Computing Gems, Jade edition, chapter 10, 2011).
#[cfg_attr(not(target_family = "wasm"), inline(always))]
fn normal_quantile<const L: usize>(probability: Lanes<L>) -> Lanes<L> {
    const MIDDLE: [f64; 9] = [
        2.810_226_36e-8,
        3.432_739_39e-7,
        -3.523_387_7e-6,
        -4.391_506_54e-6,
        2.185_808_7e-4,
        -1.253_725_03e-3,
        -4.177_681_64e-3,
        0.246_640_727,
        1.501_409_41,
    ];
    const TAILS: [f64; 9] = [
        -2.002_142_57e-4,
        1.009_505_58e-4,
        1.349_343_22e-3,
        -3.673_428_44e-3,
        5.739_507_73e-3,
        -7.622_461_3e-3,
        9.438_870_47e-3,
        1.001_674_06,
        2.832_976_82,
    ];
    let polynomial = |coefficients: [f64; 9], x: Lanes<L>| {
        let [first, rest @ ..] = coefficients;
        rest.into_iter()
            .fold(Lanes::all(first), |sum, next| sum * x + next)
    };
    let off = probability * 2.0 - 1.0;
    let far = -((Lanes::all(1.0) - off) * (off + 1.0)).ln();
    let middle = polynomial(MIDDLE, far - 2.5);
    let tails = polynomial(TAILS, far.sqrt() - 3.0);
    off * (far - 5.0).if_positive(tails, middle) * SQRT_2
}

/// ln of the gamma function for arguments of half and whole numbers from 1/2 on.
fn log_gamma(x: f64) -> f64 {
    let mut sum = 0.0;
    let mut argument = x;
    while argument > 1.5 {
        argument -= 1.0;
        sum += argument.ln();
    }
    if argument < 0.75 {
        sum + 0.5 * std::f64::consts::PI.ln()
    } else if argument < 1.25 {
        sum
    } else {
        sum + (0.5 * std::f64::consts::PI.sqrt()).ln()
    }
}

/// Draws from the posterior around a best fit, about as many as give this number of effective draws;
/// `None` if no draw is valid.
pub(super) fn sample(
    model: &Model,
    fit: &Fit,
    effective_draws: usize,
    rng: &mut ChaCha8Rng,
) -> Option<Sample> {
    let proposal = Proposal::new(fit.vector.clone(), fit.covariance.clone(), WIDENING)?;
    let sample = rounds(model, proposal, None, effective_draws, rng)?;
    if sample.pareto_shape < MAX_PARETO_SHAPE {
        return Some(sample);
    }
    // Where the scatter is hardly seen, the widths of the other unknowns follow it.
    let scatter = model.index(Slot::Scatter);
    let of_funnel = scatter.and_then(|_| {
        let proposal = adapted(&sample, WIDENING, scatter)?;
        rounds(model, proposal, scatter, effective_draws, rng)
    });
    let better = of_funnel.filter(|found| found.is_better_than(&sample));
    Some(better.unwrap_or(sample))
}

/// Draws of a proposal, and of those [`adapted`] to what they find, until they fit.
fn rounds(
    model: &Model,
    mut proposal: Proposal,
    funnel_by: Option<usize>,
    effective_draws: usize,
    rng: &mut ChaCha8Rng,
) -> Option<Sample> {
    let enough = |share: f64| {
        let draws = effective_draws as f64 / share.clamp(MIN_SHARE, 1.0);
        (draws as usize).max(MIN_DRAWS)
    };
    let pilot = PILOT_DRAWS * proposal.centre.len();
    let mut draws = enough(USUAL_SHARE).min(pilot);
    let mut drawn = Drawn::new(rng);
    let mut best: Option<Sample> = None;
    for tries in 1..=MAX_ROUNDS {
        drawn.draw_until(draws, model, &proposal);
        let found = drawn.weighed(&proposal)?;
        let complete = found.effective_draws >= ENOUGH_DRAWS * effective_draws as f64;
        let trusted = found.pareto_shape < DOUBTFUL_SHAPE;
        let share = found.effective_draws / draws as f64;
        let fits = trusted && (complete || share >= USUAL_SHARE);
        let adapted = if fits {
            None
        } else {
            adapted(&found, WIDENING.powi(tries), funnel_by)
        };
        draws = enough(share).max(draws);
        if best.as_ref().is_none_or(|best| found.is_better_than(best)) {
            best = Some(found);
        }
        match adapted {
            Some(adapted) => (proposal, drawn) = (adapted, Drawn::new(rng)),
            None if complete => break,
            // More of the same.
            None if fits => {}
            None => drawn = Drawn::new(rng),
        }
    }
    best
}

/// Draws of a proposal, so far.
struct Drawn {
    seed: u32,
    /// One after the other.
    vectors: Vec<f64>,
    /// Logarithms of the weights, but for a constant.
    log_weights: Vec<f64>,
}

impl Drawn {
    fn new(rng: &mut ChaCha8Rng) -> Self {
        Self {
            seed: rng.random(),
            vectors: Vec::new(),
            log_weights: Vec::new(),
        }
    }

    /// Continues the draws up to this number.
    fn draw_until(&mut self, draws: usize, model: &Model, proposal: &Proposal) {
        let known = self.log_weights.len();
        let mut vectors = DMatrix::zeros(proposal.centre.len(), draws - known);
        let densities = proposal.draw(self.seed, known, &mut vectors);
        let logs = model.log_posteriors(&vectors).into_iter().zip(densities);
        let logs = logs.map(|(log, density)| log.map_or(f64::NEG_INFINITY, |log| log - density));
        self.log_weights.extend(logs);
        self.vectors.extend_from_slice(vectors.as_slice());
    }

    /// The draws with their weights; `None` if none of them is valid.
    fn weighed(&self, proposal: &Proposal) -> Option<Sample> {
        let draws = self.log_weights.len();
        let greatest = self
            .log_weights
            .iter()
            .copied()
            .fold(f64::NEG_INFINITY, f64::max);
        if !greatest.is_finite() {
            return None;
        }
        let weights = self.log_weights.iter().map(|log| (log - greatest).exp());
        let mut weights: Vec<f64> = weights.collect();
        let pareto_shape = smooth_tail(&mut weights);
        let total: f64 = weights.iter().sum();
        for weight in &mut weights {
            *weight /= total;
        }
        Some(Sample {
            vectors: DMatrix::from_column_slice(proposal.centre.len(), draws, &self.vectors),
            effective_draws: effective_draws(&weights),
            weights,
            log_evidence: greatest + (total / draws as f64).ln() - proposal.log_constant(),
            pareto_shape,
        })
    }
}

/// Number of independent draws with the same information as draws with these weights, which add up to one
/// (L. Kish, Survey Sampling, 1965).
fn effective_draws(weights: &[f64]) -> f64 {
    let squares: f64 = weights.iter().map(|weight| weight * weight).sum();
    1.0 / squares
}

/// The proposal with the mean and covariance that a pilot found. Where few draws have all the
/// weight, the weights are flattened until enough count: a step in the right direction. If an unknown is named, the widths
/// of the others follow it.
fn adapted(pilot: &Sample, widening: f64, funnel_by: Option<usize>) -> Option<Proposal> {
    let dimensions = pilot.vectors.nrows();
    let flattened = FLATTENING_POWERS
        .into_iter()
        .map(|power| {
            let powers: Vec<f64> = pilot.weights.iter().map(|w| w.powf(power)).collect();
            let total: f64 = powers.iter().sum();
            powers.iter().map(|w| w / total).collect::<Vec<f64>>()
        })
        .find(|weights| effective_draws(weights) > MIN_DRAWS_PER_UNKNOWN * dimensions as f64)?;
    let flattened = DVector::from_vec(flattened);
    let mut mean = &pilot.vectors * &flattened;
    let mut off = pilot.vectors.clone();
    for mut column in off.column_iter_mut() {
        column -= &mean;
    }
    let funnel = funnel_by.and_then(|by| Funnel::of(by, &off, &flattened));
    if let Some((funnel, axis)) = &funnel {
        for mut column in off.column_iter_mut() {
            column -= axis;
        }
        mean += axis;
        funnel.straighten(&mut off);
    }
    let proposal = Proposal::new(mean, covariance_of(&off, &flattened), widening)?;
    Some(Proposal {
        funnel: funnel.map(|(funnel, _)| funnel),
        ..proposal
    })
}

/// Replaces the largest weights by the quantiles of the generalised Pareto distribution that fits
/// them; its shape. With too few weights for a tail the shape is infinite.
fn smooth_tail(weights: &mut [f64]) -> f64 {
    let count = weights.len();
    let tail = (TAIL_SHARE * count as f64).min(TAIL_ROOTS * (count as f64).sqrt()) as usize;
    if tail < MIN_TAIL {
        return f64::INFINITY;
    }
    let sorted = sorted(weights.iter().copied());
    let (cutoff, greatest) = (sorted[count - tail - 1], sorted[count - 1]);
    let largest = sorted[count - tail..].iter();
    let excesses: Vec<f64> = largest.map(|weight| weight - cutoff).collect();
    if excesses[tail - 1] <= 1e-12 * greatest {
        // All weights alike: nothing to smooth.
        return f64::NEG_INFINITY;
    }
    let (shape, scale) = generalised_pareto(&excesses);
    for weight in weights.iter_mut().filter(|weight| **weight > cutoff) {
        let rank = excesses.partition_point(|&excess| excess < *weight - cutoff);
        let probability = (rank as f64 + 0.5) / tail as f64;
        let excess = if shape.abs() < 1e-9 {
            -scale * (-probability).ln_1p()
        } else {
            scale * ((-shape * (-probability).ln_1p()).exp_m1()) / shape
        };
        *weight = (cutoff + excess).min(greatest);
    }
    shape
}

/// Shape and scale of the generalised Pareto distribution of sorted excesses, by the nearly
/// unbiased estimator of J. Zhang and M. A. Stephens, Technometrics 51, 316 (2009), with the prior
/// of Vehtari et al. that keeps the shape of small tails from running away.
fn generalised_pareto(sorted: &[f64]) -> (f64, f64) {
    let count = sorted.len() as f64;
    let candidates = 30 + count.sqrt() as usize;
    let greatest = sorted[sorted.len() - 1];
    let quartile = sorted[((count / 4.0 + 0.5) as usize).max(1) - 1].max(1e-300);
    let shape_at = |theta: f64| {
        let sum: f64 = sorted.iter().map(|x| (-theta * x).ln_1p()).sum();
        sum / count
    };
    let profiles: Vec<(f64, f64)> = (1..=candidates)
        .map(|j| {
            let spread = 1.0 - (candidates as f64 / (j as f64 - 0.5)).sqrt();
            let theta = 1.0 / greatest + spread / (3.0 * quartile);
            let shape = shape_at(theta);
            (theta, count * ((-theta / shape).ln() - shape - 1.0))
        })
        .collect();
    let heights = profiles.iter().map(|(_, profile)| *profile);
    let best = heights.fold(f64::NEG_INFINITY, f64::max);
    let (mut sum, mut total) = (0.0, 0.0);
    for (theta, profile) in profiles {
        if profile.is_finite() {
            let weight = (profile - best).exp();
            sum += weight * theta;
            total += weight;
        }
    }
    let theta = sum / total;
    let shape = shape_at(theta);
    let scale = -shape / theta;
    ((count * shape + 5.0) / (count + 10.0), scale)
}

#[cfg(test)]
mod tests {
    use rand::SeedableRng;

    use super::*;
    use crate::inference::likelihood::tests::{impacts, with_model};

    /// The estimator finds the shape of excesses that follow the distribution exactly.
    #[test]
    fn the_shape_of_a_tail_is_found() {
        for shape in [0.2_f64, 0.5, 1.0] {
            let excesses: Vec<f64> = (0..400)
                .map(|i| {
                    let probability = (f64::from(i) + 0.5) / 400.0;
                    ((-shape * (-probability).ln_1p()).exp_m1()) / shape
                })
                .collect();
            let (found, scale) = generalised_pareto(&excesses);
            assert!((found - shape).abs() < 0.05, "{shape}: {found}");
            assert!((scale - 1.0).abs() < 0.1, "{shape}: {scale}");
        }
    }

    /// Against that of a library, from one end to the other.
    #[test]
    fn the_quantiles_of_a_normal_distribution() {
        use statrs::distribution::{ContinuousCDF, Normal};
        let ends = (1..=25).map(|power| 0.5_f64.powi(power));
        let middle = (1..1000).map(|part| f64::from(part) / 1000.0);
        for probability in ends.chain(middle).flat_map(|p| [p, 1.0 - p]) {
            let found = normal_quantile(Lanes([probability])).0[0];
            let expected = Normal::standard().inverse_cdf(probability);
            assert!(
                (found - expected).abs() < 1e-6 * expected.abs().max(1.0),
                "{probability}: {found} {expected}"
            );
        }
    }

    /// Draws that are made in two goes are those of one, and so are their weights.
    #[test]
    fn more_draws_of_a_proposal_continue_its_sequence() {
        with_model(&impacts(), |model, vector| {
            let unknowns = vector.len();
            let covariance = DMatrix::identity(unknowns, unknowns) * 1e-4;
            let centre = DVector::from_column_slice(vector);
            let proposal = Proposal::new(centre, covariance, WIDENING).unwrap();
            let drawn_in = |goes: &[usize]| {
                let mut drawn = Drawn::new(&mut ChaCha8Rng::seed_from_u64(1));
                for &draws in goes {
                    drawn.draw_until(draws, model, &proposal);
                }
                (drawn.vectors, drawn.log_weights)
            };
            assert_eq!(drawn_in(&[100]), drawn_in(&[43, 43, 100]));
        });
    }

    fn funnel(slopes: [f64; 3], rate: f64) -> Proposal {
        // Its slopes are those of the others, whose rest is independent.
        let slopes = DVector::from_column_slice(&slopes);
        let rest = DMatrix::from_diagonal(&DVector::from_column_slice(&[1.0, 0.0, 1.0]));
        let covariance = &slopes * slopes.transpose() + rest;
        let proposal = Proposal::new(DVector::zeros(3), covariance, 1.2).unwrap();
        Proposal {
            funnel: Some(Funnel {
                by: 1,
                slopes,
                rate,
            }),
            ..proposal
        }
    }

    /// The density of a funnel is that of its draws: a normal distribution weighed by it has the integral one.
    #[test]
    fn the_density_of_a_funnel() {
        for rate in [-0.5, 0.0, 0.3] {
            let proposal = funnel([0.4, 1.0, -0.2], rate);
            let mut draws = DMatrix::zeros(3, 1 << 14);
            let densities = proposal.draw(1, 0, &mut draws);
            let weights = draws.column_iter().zip(&densities).map(|(draw, density)| {
                let normal = -0.5 * draw.norm_squared() - 1.5 * std::f64::consts::TAU.ln();
                (normal - density - proposal.log_constant()).exp()
            });
            let integral = weights.sum::<f64>() / densities.len() as f64;
            assert!((integral - 1.0).abs() < 0.01, "{rate}: {integral}");
        }
    }

    /// Of the draws of a funnel its slopes and its rate are found, and without it no width follows the unknown any more.
    #[test]
    fn a_funnel_is_found_in_its_draws() {
        let mut draws = DMatrix::zeros(3, 1 << 12);
        funnel([0.4, 1.0, -0.2], 0.4).draw(1, 0, &mut draws);
        let weights = DVector::from_element(draws.ncols(), 1.0 / draws.ncols() as f64);
        let (found, axis) = Funnel::of(1, &draws, &weights).unwrap();
        assert!(axis.norm() < 0.03, "{axis}");
        assert!((found.rate - 0.4).abs() < 0.03, "{}", found.rate);
        assert!((found.slopes[0] - 0.4).abs() < 0.05, "{}", found.slopes);
        found.straighten(&mut draws);
        let (straight, _) = Funnel::of(1, &draws, &weights).unwrap();
        assert!(straight.rate.abs() < 0.03, "{}", straight.rate);
    }

    /// ln Γ at half and whole numbers: Γ(1/2) = π^1/2, Γ(4) = 6, Γ(9/2) = 105 π^1/2/16.
    #[test]
    fn the_gamma_function() {
        let root = std::f64::consts::PI.sqrt();
        for (argument, expected) in [(0.5, root), (4.0, 6.0), (4.5, 105.0 * root / 16.0)] {
            assert!(
                (log_gamma(argument) - f64::ln(expected)).abs() < 1e-12,
                "{argument}"
            );
        }
    }
}
