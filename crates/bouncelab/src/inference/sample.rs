//! Importance sampling of the posterior of one model.
//!
//! The best fit and its curvature give a normal distribution; draws from a Student's t of that
//! shape, weighted by what the posterior really is, are the posterior. A first round corrects the
//! centre and the shape, the second counts. The largest weights are smoothed by the generalised
//! Pareto distribution that their tail follows, whose shape k tells whether the weights can be
//! trusted at all (A. Vehtari et al., Pareto smoothed importance sampling, JMLR 25, 2024).

use nalgebra::{Cholesky, DMatrix, DVector};
use rand::RngExt;
use rand_chacha::ChaCha8Rng;
use rand_distr::{ChiSquared, Distribution, StandardNormal};

use super::fit::Fit;
use super::likelihood::Evaluator;

/// Degrees of freedom of the proposal: tails heavier than those of a posterior, so that no region
/// is forgotten.
const FREEDOM: f64 = 5.0;

/// The shape of the proposal is that of the posterior, a little wider.
const WIDENING: f64 = 1.1;

/// Above this Pareto shape the weights say nothing.
pub const GREATEST_PARETO_SHAPE: f64 = 0.7;

/// Weighted draws of the posterior of one model.
#[derive(Debug, Clone)]
pub(super) struct Sample {
    pub(super) vectors: Vec<DVector<f64>>,
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
    /// Keeps only how good the draws were; they take a megabyte.
    pub(super) fn forget_draws(&mut self) {
        self.vectors = Vec::new();
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
    fn new(centre: DVector<f64>, covariance: DMatrix<f64>) -> Option<Self> {
        let root = Cholesky::new(covariance * (WIDENING * WIDENING))?.unpack();
        Some(Self { centre, root })
    }

    /// A draw and the logarithm of its density, but for a constant.
    fn draw(&self, rng: &mut ChaCha8Rng) -> (DVector<f64>, f64) {
        let normal = DVector::<f64>::from_fn(self.centre.len(), |_, _| rng.sample(StandardNormal));
        let chi_squared = chi_squared().sample(rng);
        let interval = (FREEDOM / chi_squared).sqrt();
        let square = normal.norm_squared() * interval * interval;
        let dimensions = self.centre.len() as f64;
        let density = -0.5 * (FREEDOM + dimensions) * (square / FREEDOM).ln_1p();
        let offset = &self.root * normal * interval;
        (&self.centre + offset, density)
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

fn chi_squared() -> ChiSquared<f64> {
    // FREEDOM is above zero, which is all it asks for.
    ChiSquared::new(FREEDOM).unwrap_or_else(|_| unreachable!("a positive constant"))
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
    evaluator: &mut Evaluator,
    fit: &Fit,
    effective_draws: usize,
    rng: &mut ChaCha8Rng,
) -> Option<Sample> {
    let pilot_draws = 40 * fit.vector.len();
    let mut proposal = Proposal::new(fit.vector.clone(), fit.covariance.clone())?;
    let mut share = 0.0;
    for _ in 0..MOST_PILOTS {
        let pilot = round(evaluator, &proposal, pilot_draws, rng)?;
        share = pilot.effective_draws / pilot_draws as f64;
        if let Some(adapted) = adapted(&pilot) {
            proposal = adapted;
        }
        if share > GOOD_SHARE {
            break;
        }
    }
    let wanted = (effective_draws as f64 / share.clamp(LEAST_SHARE, 1.0)) as usize;
    let wanted = wanted.max(FEWEST_DRAWS);
    let mut found = round(evaluator, &proposal, wanted, rng)?;
    for _ in 0..MOST_RETRIES {
        if found.pareto_shape < DOUBTFUL_SHAPE {
            break;
        }
        // All these draws know the shape better than the pilots did.
        let Some(adapted) = adapted(&found) else {
            break;
        };
        let again = round(evaluator, &adapted, wanted, rng)?;
        if again.pareto_shape < found.pareto_shape {
            found = again;
        }
    }
    Some(found)
}

/// Pilots that may correct the proposal, and the share of effective draws that needs no more. A normal
/// posterior of ten unknowns would give 0.68; real ones give 0.45 however many pilots go before.
const MOST_PILOTS: usize = 5;
const GOOD_SHARE: f64 = 0.35;

/// Weights with a heavier tail than this are worth another try, but not for ever.
const DOUBTFUL_SHAPE: f64 = 0.6;
const MOST_RETRIES: usize = 2;

/// The weights of fewer draws have no tail whose shape could tell anything.
const FEWEST_DRAWS: usize = 25;

/// A proposal that fits badly is not drawn from for ever: at most three draws for one.
const LEAST_SHARE: f64 = 0.33;

fn round(
    evaluator: &mut Evaluator,
    proposal: &Proposal,
    draws: usize,
    rng: &mut ChaCha8Rng,
) -> Option<Sample> {
    let mut vectors = Vec::with_capacity(draws);
    let mut logs = Vec::with_capacity(draws);
    for _ in 0..draws {
        let (vector, density) = proposal.draw(rng);
        let log = evaluator
            .log_posterior(vector.as_slice())
            .map_or(f64::NEG_INFINITY, |log| log - density);
        vectors.push(vector);
        logs.push(log);
    }
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
fn adapted(pilot: &Sample) -> Option<Proposal> {
    let dimensions = pilot.vectors[0].len();
    let flattened = [1.0, 0.5, 0.25]
        .into_iter()
        .map(|power| {
            let powers: Vec<f64> = pilot.weights.iter().map(|w| w.powf(power)).collect();
            let total: f64 = powers.iter().sum();
            powers.iter().map(|w| w / total).collect::<Vec<f64>>()
        })
        .find(|weights| effective_draws(weights) > 8.0 * dimensions as f64)?;
    let mut mean = DVector::zeros(dimensions);
    for (vector, &weight) in pilot.vectors.iter().zip(&flattened) {
        mean.axpy(weight, vector, 1.0);
    }
    let mut covariance = DMatrix::zeros(dimensions, dimensions);
    for (vector, &weight) in pilot.vectors.iter().zip(&flattened) {
        let off = vector - &mean;
        covariance.ger(weight, &off, &off, 1.0);
    }
    Proposal::new(mean, covariance)
}

/// Replaces the largest weights by the quantiles of the generalised Pareto distribution that fits
/// them; its shape. With too few weights for a tail the shape is infinite.
fn smooth_tail(weights: &mut [f64]) -> f64 {
    let count = weights.len();
    let tail = (0.2 * count as f64).min(3.0 * (count as f64).sqrt()) as usize;
    if tail < 5 {
        return f64::INFINITY;
    }
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|&a, &b| weights[a].total_cmp(&weights[b]));
    let cutoff = weights[order[count - tail - 1]];
    let greatest = weights[order[count - 1]];
    let excesses: Vec<f64> = order[count - tail..]
        .iter()
        .map(|&index| weights[index] - cutoff)
        .collect();
    if excesses[tail - 1] <= 1e-12 * greatest {
        // All weights alike: nothing to smooth.
        return f64::NEG_INFINITY;
    }
    let (shape, scale) = generalised_pareto(&excesses);
    for (rank, &index) in order[count - tail..].iter().enumerate() {
        let probability = (rank as f64 + 0.5) / tail as f64;
        let excess = if shape.abs() < 1e-9 {
            -scale * (-probability).ln_1p()
        } else {
            scale * ((-shape * (-probability).ln_1p()).exp_m1()) / shape
        };
        weights[index] = (cutoff + excess).min(greatest);
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
    let thetas: Vec<f64> = (1..=candidates)
        .map(|j| {
            let spread = 1.0 - (candidates as f64 / (j as f64 - 0.5)).sqrt();
            1.0 / greatest + spread / (3.0 * quartile)
        })
        .collect();
    let profiles: Vec<f64> = thetas
        .iter()
        .map(|&theta| {
            let shape = shape_at(theta);
            count * ((-theta / shape).ln() - shape - 1.0)
        })
        .collect();
    let best = profiles.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let (mut sum, mut total) = (0.0, 0.0);
    for (&theta, &profile) in thetas.iter().zip(&profiles) {
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
