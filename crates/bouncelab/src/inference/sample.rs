//! Importance sampling of the posterior of one model.
//!
//! The best fit and its curvature give a normal distribution; draws from a Student's t of that
//! shape, weighted by what the posterior really is, are the posterior. Where a first round shows another
//! centre or shape, it corrects them. The draws are those of a scrambled Sobol sequence: each of them is as
//! random as any, but together they cover the distribution more evenly than independent ones, so that fewer
//! do (A. Owen, Ann. Stat. 25, 1541, 1997). The largest weights are smoothed by the generalised
//! Pareto distribution that their tail follows, whose shape k tells whether the weights can be
//! trusted at all (A. Vehtari et al., Pareto smoothed importance sampling, JMLR 25, 2024).

use nalgebra::{Cholesky, DMatrix, DVector, DVectorViewMut};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use sobol_burley::{NUM_DIMENSION_SETS_4D, sample_4d};
use statrs::distribution::{ContinuousCDF, Normal};

use super::fit::Fit;
use super::model::Model;
use crate::stats::sorted;

/// Degrees of freedom of the proposal: tails heavier than those of a posterior, so that no region
/// is forgotten.
const FREEDOM: f64 = 2.0 * EXPONENTIALS as f64;

/// Half of a chi-squared number with so many degrees of freedom is a sum of exponential ones.
const EXPONENTIALS: usize = 3;

/// The shape of the proposal is that of the posterior, a little wider, and wider with each round that did not do.
const WIDENING: f64 = 1.1;

/// Above this Pareto shape the weights say nothing.
pub const GREATEST_PARETO_SHAPE: f64 = 0.7;

/// Weighted draws of the posterior of one model.
#[derive(Debug, Clone)]
pub(super) struct Sample {
    /// One in each column.
    pub(super) vectors: DMatrix<f64>,
    /// Weights, which add up to one.
    pub(super) weights: Vec<f64>,
    /// How many independent draws would say as much.
    pub(super) effective_draws: f64,
    /// Logarithm of the evidence, but for a constant that all models of the same data share.
    pub(super) log_evidence: f64,
    /// Shape of the tail of the weights.
    pub(super) pareto_shape: f64,
}

impl Sample {
    /// Whether its weights can be trusted more; of two that can be trusted, whether it says more.
    fn is_better_than(&self, other: &Self) -> bool {
        if self.pareto_shape.max(other.pareto_shape) < DOUBTFUL_SHAPE {
            self.effective_draws > other.effective_draws
        } else {
            self.pareto_shape < other.pareto_shape
        }
    }

    /// Keeps only how good the draws were; they take a megabyte.
    pub(super) fn forget_draws(&mut self) {
        self.vectors = DMatrix::zeros(0, 0);
        self.weights = Vec::new();
    }
}

/// A multivariate Student's t.
struct Proposal {
    centre: DVector<f64>,
    /// Lower triangular root of its shape.
    root: DMatrix<f64>,
}

impl Proposal {
    fn new(centre: DVector<f64>, covariance: DMatrix<f64>, widening: f64) -> Option<Self> {
        let root = Cholesky::new(covariance * (widening * widening))?.unpack();
        Some(Self { centre, root })
    }

    /// Writes the draw that a point of the unit cube stands for; the logarithm of its density, but for a
    /// constant.
    fn draw(&self, point: &Point, mut draw: DVectorViewMut<f64>) -> f64 {
        let dimensions = self.centre.len();
        let mut coordinates = point.coordinates();
        let normal = DVector::from_fn(dimensions, |_, _| {
            Normal::standard().inverse_cdf(coordinates.next().unwrap_or(0.5))
        });
        let product: f64 = coordinates.take(EXPONENTIALS).product();
        let chi_squared = -2.0 * product.ln();
        let stretch = (FREEDOM / chi_squared).sqrt();
        draw.copy_from(&self.centre);
        draw.gemv(stretch, &self.root, &normal, 1.0);
        let square = normal.norm_squared() * stretch * stretch;
        -0.5 * (FREEDOM + dimensions as f64) * (square / FREEDOM).ln_1p()
    }

    /// Logarithm of the constant that [`Self::draw`] leaves out of the density.
    fn log_constant(&self) -> f64 {
        let dimensions = self.centre.len() as f64;
        let log_root: f64 = self.root.diagonal().iter().map(|d| d.ln()).sum();
        log_gamma(0.5 * (FREEDOM + dimensions))
            - log_gamma(0.5 * FREEDOM)
            - 0.5 * dimensions * (FREEDOM * std::f64::consts::PI).ln()
            - log_root
    }
}

/// A point of a scrambled Sobol sequence.
struct Point {
    number: u32,
    seed: u32,
}

impl Point {
    /// The coordinates of the point, above 0 and below 1, 256 of them.
    fn coordinates(&self) -> impl Iterator<Item = f64> {
        /// As many points as a sequence has; those beyond belong to another.
        const LENGTH: u32 = 1 << 16;
        /// Half of the last digit: the sequence has zero, but not one.
        const HALF: f64 = 1.0 / (1 << 25) as f64;
        let seed = self.seed.wrapping_add(self.number / LENGTH);
        let number = self.number % LENGTH;
        let sets = (0..NUM_DIMENSION_SETS_4D).flat_map(move |set| sample_4d(number, set, seed));
        sets.map(|coordinate| f64::from(coordinate) + HALF)
    }
}

/// One of a sequence of numbers that are normal together, evenly so over any part of it.
pub(super) fn standard_normal(number: u32) -> f64 {
    let coordinate = Point { number, seed: 0 }.coordinates().next();
    Normal::standard().inverse_cdf(coordinate.unwrap_or(0.5))
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

/// Draws from the posterior around a best fit, about as many as count as so many independent ones;
/// `None` if no draw makes sense.
pub(super) fn sample(
    model: &Model,
    fit: &Fit,
    effective_draws: usize,
    rng: &mut ChaCha8Rng,
) -> Option<Sample> {
    let enough = |share: f64| {
        let draws = effective_draws as f64 / share.clamp(LEAST_SHARE, 1.0);
        (draws as usize).max(FEWEST_DRAWS)
    };
    let pilot = PILOT_DRAWS * fit.vector.len();
    let mut proposal = Proposal::new(fit.vector.clone(), fit.covariance.clone(), WIDENING)?;
    let mut draws = enough(USUAL_SHARE).min(pilot);
    let mut best: Option<Sample> = None;
    for tries in 1..=MOST_ROUNDS {
        let found = round(model, &proposal, draws, rng)?;
        let complete = found.effective_draws >= ENOUGH * effective_draws as f64;
        let done = complete && found.pareto_shape < DOUBTFUL_SHAPE;
        let adapted = if done {
            None
        } else {
            adapted(&found, WIDENING.powi(tries))
        };
        draws = enough(found.effective_draws / draws as f64).max(draws);
        if best.as_ref().is_none_or(|best| found.is_better_than(best)) {
            best = Some(found);
        }
        match adapted {
            Some(adapted) => proposal = adapted,
            None if complete => break,
            None => {}
        }
    }
    best
}

/// Draws of a first round for each unknown: enough to know centre and shape.
const PILOT_DRAWS: usize = 40;

/// Share of effective draws that proposals have. A normal posterior of ten unknowns would give 0.7.
const USUAL_SHARE: f64 = 0.4;

/// A proposal that fits badly is not drawn from for ever: at most three draws for one.
const LEAST_SHARE: f64 = 0.33;

/// With this part of the draws that were asked for, the rest is not worth another round.
const ENOUGH: f64 = 0.8;

/// Weights with a heavier tail than this are worth another try, but not for ever.
const DOUBTFUL_SHAPE: f64 = 0.6;
const MOST_ROUNDS: i32 = 6;

/// The weights of fewer draws have a tail too short to tell its shape.
const FEWEST_DRAWS: usize = 128;

fn round(model: &Model, proposal: &Proposal, draws: usize, rng: &mut ChaCha8Rng) -> Option<Sample> {
    let seed = rng.random();
    let mut vectors = DMatrix::zeros(proposal.centre.len(), draws);
    let numbered = (0..).zip(vectors.column_iter_mut());
    let densities: Vec<f64> = numbered
        .map(|(number, draw)| proposal.draw(&Point { number, seed }, draw))
        .collect();
    let logs = model.log_posteriors(&vectors).into_iter().zip(densities);
    let logs: Vec<f64> = logs
        .map(|(log, density)| log.map_or(f64::NEG_INFINITY, |log| log - density))
        .collect();
    let greatest = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    if !greatest.is_finite() {
        return None;
    }
    let mut weights: Vec<f64> = logs.iter().map(|log| (log - greatest).exp()).collect();
    let pareto_shape = smooth_tail(&mut weights);
    let total: f64 = weights.iter().sum();
    for weight in &mut weights {
        *weight /= total;
    }
    Some(Sample {
        vectors,
        effective_draws: effective_draws(&weights),
        weights,
        log_evidence: greatest + (total / draws as f64).ln() - proposal.log_constant(),
        pareto_shape,
    })
}

/// How many independent draws would say as much as draws with these weights, which add up to one
/// (L. Kish, Survey Sampling, 1965).
fn effective_draws(weights: &[f64]) -> f64 {
    let squares: f64 = weights.iter().map(|weight| weight * weight).sum();
    1.0 / squares
}

/// The proposal with the mean and covariance that a pilot found. Where few draws have all the
/// weight, the weights are flattened until enough count: a step in the right direction.
fn adapted(pilot: &Sample, widening: f64) -> Option<Proposal> {
    let dimensions = pilot.vectors.nrows();
    let flattened = [1.0, 0.5, 0.25]
        .into_iter()
        .map(|power| {
            let powers: Vec<f64> = pilot.weights.iter().map(|w| w.powf(power)).collect();
            let total: f64 = powers.iter().sum();
            powers.iter().map(|w| w / total).collect::<Vec<f64>>()
        })
        .find(|weights| effective_draws(weights) > 8.0 * dimensions as f64)?;
    let flattened = DVector::from_vec(flattened);
    let mean = &pilot.vectors * &flattened;
    let mut off = pilot.vectors.clone();
    for (mut column, weight) in off.column_iter_mut().zip(&flattened) {
        column -= &mean;
        column *= weight.sqrt();
    }
    Proposal::new(mean, &off * off.transpose(), widening)
}

/// Replaces the largest weights by the quantiles of the generalised Pareto distribution that fits
/// them; its shape. With too few weights for a tail the shape is infinite.
fn smooth_tail(weights: &mut [f64]) -> f64 {
    let count = weights.len();
    let tail = (0.2 * count as f64).min(3.0 * (count as f64).sqrt()) as usize;
    if tail < 5 {
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
    use super::*;

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
