//! The uncertainty budget, in the form of the GUM.
//!
//! At the best fit the estimate is a linear function of its inputs: the errors of the times, the scatter of the
//! impacts, and each prior, which is an input like any other. With the derivatives J of the residuals, their covariance C
//! and the prior information P, the unknowns have the covariance V = (J' C⁻¹ J + P)⁻¹ and the gain G = V J' C⁻¹. A
//! quantity with the gradient g has the variance g' G Cₛ G' g by the part Cₛ of C that is due to a source, and (g' V)² by
//! a prior of unit variance. So its variance is a sum over sources (JCGM 100:2008, clause 5).

use nalgebra::{Cholesky, DMatrix, DVector};

use super::banded::Banded;
use super::candidates::{Candidate, SampledPosterior};
use super::likelihood::Differences;
use super::parameters::DIFFERENCE_STEP;
use super::residual::Noise;
use super::unknowns::{Model, Slot};
use crate::restitution::MAX_SHAPES;
use crate::simd::Lanes;
use crate::stats::sort_by_number;

/// The contribution of one source to the uncertainty of a quantity.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[non_exhaustive]
pub struct Share {
    /// The source: a stable name.
    pub source: &'static str,
    /// The standard uncertainty by this source alone, in the unit of the quantity.
    pub sd: f64,
    /// Its share of the variance, from 0 to 1.
    pub share: f64,
}

/// The budget of the restitution and of the drop height, largest share first.
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[non_exhaustive]
pub struct Budget {
    /// Of the restitution at the reported speed.
    pub restitution: Vec<Share>,
    /// Of the drop height, m.
    pub drop_height_m: Vec<Share>,
}

/// The budget at the best fit of the best model; what differs between models and between numbers of
/// missed impacts comes from all of them, by the restitution and the height of each draw. `None` if the fit is
/// not a maximum.
pub(super) fn budget(
    posterior: &SampledPosterior,
    at_speed_m_s: f64,
    restitution: &[f64],
    drop_height_m: &[f64],
) -> Option<Budget> {
    let candidate = posterior.candidates.first()?;
    let model = posterior.model(candidate);
    let vector = candidate.fit.vector.as_slice();
    let linear = Linear::new(&model, vector)?;
    let [between_laws, between_balls, between_missed] =
        between(posterior, [restitution, drop_height_m]);
    let restitution =
        |model: &Model, vector: &[f64]| Some(model.point(vector)?.law.at(at_speed_m_s));
    let height = |model: &Model, vector: &[f64]| model.drop_height_m(&model.point(vector)?);
    let mut of_restitution = linear.sources(&gradient(&model, vector, restitution)?, &model);
    of_restitution.push(("choice-of-law", between_laws[0]));
    of_restitution.push(("choice-of-ball", between_balls[0]));
    of_restitution.push(("number-of-impacts", between_missed[0]));
    let mut of_height = linear.sources(&gradient(&model, vector, height)?, &model);
    of_height.push(("choice-of-law", between_laws[1]));
    of_height.push(("choice-of-ball", between_balls[1]));
    of_height.push(("number-of-impacts", between_missed[1]));
    Some(Budget {
        restitution: shares(of_restitution),
        drop_height_m: shares(of_height),
    })
}

/// The estimate as a linear function of its inputs.
struct Linear {
    /// Covariance of the unknowns.
    covariance: DMatrix<f64>,
    /// Change of the unknowns for one unit of each residual.
    gain: DMatrix<f64>,
    by_time: Banded<1>,
    by_scatter: Banded<1>,
    by_release: Banded<1>,
}

impl Linear {
    fn new(model: &Model, vector: &[f64]) -> Option<Self> {
        let Differences {
            point,
            details,
            residuals: slopes,
            ..
        } = model.differences(vector)?;
        let noise = Noise::new(&model.observed.sigma_s, &[point]);
        let weights = details.innovations.iter().map(|it| Lanes([it.weight]));
        let [by_time, by_scatter, by_release] = noise.covariances(&details.residuals, weights);
        let covariance = Banded::sum([&by_time, &by_scatter, &by_release]);
        let precise = covariance.solve_columns(slopes.clone())?;
        let slots = model.slots().iter();
        let priors = slots.map(|&slot| model.prior_information(slot, &point));
        let priors = DMatrix::from_diagonal(&DVector::from_iterator(vector.len(), priors));
        let information = slopes.transpose() * &precise + priors;
        let covariance = Cholesky::new(information)?.inverse();
        Some(Self {
            gain: &covariance * precise.transpose(),
            covariance,
            by_time,
            by_scatter,
            by_release,
        })
    }

    /// Variance of a quantity with this gradient by the unknowns, source by source.
    fn sources(&self, gradient: &DVector<f64>, model: &Model) -> Vec<(&'static str, f64)> {
        let pull = self.gain.transpose() * gradient;
        let of_noise = |noise: &Banded<1>| noise.quadratic(&pull);
        let mut sources = vec![
            ("impact-timing", of_noise(&self.by_time)),
            ("restitution-scatter", of_noise(&self.by_scatter)),
            ("release-time", of_noise(&self.by_release)),
        ];
        let response = &self.covariance * gradient;
        let of_slot = |slot: Slot| model.index(slot).map_or(0.0, |index| response[index]);
        sources.push((
            "restitution-slope",
            (0..MAX_SHAPES)
                .map(|n| of_slot(Slot::Shape(n)).powi(2))
                .sum(),
        ));
        if model.height_m.is_some() {
            sources.push(("measured-height", of_slot(Slot::Height).powi(2)));
        }
        sources.extend(self.inputs(gradient, model));
        sources
    }

    /// Variance by the inputs that other drops of the ball share: they do not average out.
    fn inputs(&self, gradient: &DVector<f64>, model: &Model) -> Vec<(&'static str, f64)> {
        // A prior with unit variance moves the unknowns by its column of the covariance.
        let response = &self.covariance * gradient;
        let of_slot = |slot: Slot| model.index(slot).map_or(0.0, |index| response[index]);
        let mut inputs = vec![
            ("drag-law", of_slot(Slot::Drag).powi(2)),
            ("contact-time", of_slot(Slot::Contact).powi(2)),
        ];
        for (index, (name, ..)) in model.medium.inputs.sources.iter().enumerate() {
            let [on_gravity, on_drag] = model.medium.inputs.whitened(index);
            let moved = of_slot(Slot::Gravity) * on_gravity + of_slot(Slot::Inputs) * on_drag;
            inputs.push((name, moved * moved));
        }
        inputs
    }
}

/// Derivatives of a quantity by the unknowns, by central differences.
fn gradient(
    model: &Model,
    vector: &[f64],
    quantity: impl Fn(&Model, &[f64]) -> Option<f64>,
) -> Option<DVector<f64>> {
    let mut moved = vector.to_vec();
    let mut gradient = DVector::zeros(vector.len());
    for i in 0..vector.len() {
        moved[i] = vector[i] + DIFFERENCE_STEP;
        let above = quantity(model, &moved)?;
        moved[i] = vector[i] - DIFFERENCE_STEP;
        let below = quantity(model, &moved)?;
        moved[i] = vector[i];
        gradient[i] = (above - below) / (2.0 * DIFFERENCE_STEP);
    }
    Some(gradient)
}

/// Variance of the means of quantities of each draw between laws, between balls, and between numbers of missed impacts.
fn between(posterior: &SampledPosterior, quantities: [&[f64]; 2]) -> [[f64; 2]; 3] {
    let law = |it: &Candidate| it.law as usize;
    let ball = |it: &Candidate| it.medium;
    let missed = |it: &Candidate| it.missed_first * posterior.numberings.len() + it.numbering;
    let variance = |key: &dyn Fn(&Candidate) -> usize, values: &[f64]| {
        let of_draw = posterior.draws.iter().zip(values);
        variance_of_means(
            of_draw.map(|(draw, &value)| (key(&posterior.candidates[draw.candidate]), value)),
        )
    };
    [
        quantities.map(|values| variance(&law, values)),
        quantities.map(|values| variance(&ball, values)),
        quantities.map(|values| variance(&missed, values)),
    ]
}

fn variance_of_means(values: impl Iterator<Item = (usize, f64)>) -> f64 {
    let mut groups = std::collections::BTreeMap::<usize, (f64, f64)>::new();
    for (key, value) in values {
        let (count, sum) = groups.entry(key).or_default();
        *count += 1.0;
        *sum += value;
    }
    let (count, sum) = groups
        .values()
        .fold((0.0, 0.0), |(c, s), (count, sum)| (c + count, s + sum));
    let mean = sum / count;
    groups
        .values()
        .map(|(n, sum)| n * (sum / n - mean).powi(2))
        .sum::<f64>()
        / count
}

/// Sorted, with the share of each.
fn shares(sources: Vec<(&'static str, f64)>) -> Vec<Share> {
    let total: f64 = sources.iter().map(|(_, variance)| variance).sum();
    let mut shares: Vec<Share> = sources
        .into_iter()
        .filter(|(_, variance)| *variance > 0.0)
        .map(|(source, variance)| Share {
            source,
            sd: variance.sqrt(),
            share: variance / total,
        })
        .collect();
    sort_by_number(&mut shares, |share| -share.share);
    shares
}
