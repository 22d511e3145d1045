//! Inference of a whole drop from its impact times: the posterior of restitution, drop height and drag.
//!
//! The paper fits a straight line to the logarithms of the flight times. Its result depends on the
//! number of flights, because it neglects the air, and its standard errors know
//! neither that the errors of neighbouring flights are linked nor that the impacts themselves
//! scatter. Here a physical model of the whole drop explains the times: a fall from a height, air
//! that drags, impacts that obey a restitution law but for scatter, and times with errors. The
//! unknowns have priors with the usual knowledge of balls and ambient conditions ([`Priors`]), and the
//! answer is the posterior over all of them, and over the kinds of ball if none was stated.
//!
//! ```
//! use bouncelab::ball;
//! use bouncelab::analysis::Options;
//! use bouncelab::inference::{self, SamplerConfig, Priors, Measured, InferenceOptions};
//! use bouncelab::Impact;
//!
//! // Nine flights of a ball that was dropped from 30.5 cm.
//! let times_s = [0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045, 2.3308, 2.6375, 2.9262, 3.1984];
//! let impacts: Vec<Impact> = (1..)
//!     .zip(times_s)
//!     .map(|(number, time_s)| Impact::new(number, time_s).with_time_sd_s(5e-5))
//!     .collect();
//! let priors = Priors {
//!     drop_height_m: Some(Measured { value: 0.305, sd: 0.002 }),
//!     ..Priors::default()
//! };
//! let Options { ball, environment, contact_time_s, .. } = Options::default();
//! let asked = InferenceOptions { sampler: SamplerConfig { draws: 500, seed: 1 }, ..InferenceOptions::default() };
//! let found =
//!     inference::infer(&impacts, &ball, &environment, contact_time_s, &priors, &asked)?;
//! assert!((found.restitution.value - 0.95).abs() < 0.01);
//! assert!(found.missed_first_impacts.unwrap()[0] > 0.99);
//! # Ok::<(), bouncelab::Error>(())
//! ```
//!
//! # How it is done
//!
//! For each kind of ball that it may be, restitution law and number of impacts missed before the first one detected, the
//! best fit is found by quasi-Newton search, and the posterior around it by importance sampling;
//! the Pareto shape of the weights shows whether that worked. The evidence of each model is its
//! weight in the average, but each kind of ball that the times allow has the same, and intervals cover those of each. The likelihood is that of two kinds of noise, errors of the times and
//! scatter of the impacts, with their banded covariance and the Jacobian from times to speeds, in
//! one pass over the impacts.

mod answers;
mod banded;
mod budget;
mod candidates;
mod drawn;
mod evidence;
mod findings;
mod first_impact;
mod fit;
mod identify;
mod likelihood;
mod medium;
mod numbering;
mod observed;
mod order;
mod parameters;
mod pool;
mod possible_balls;
mod posterior;
mod predict;
mod prior_draw;
mod priors;
mod reference_speed;
mod residual;
mod sample;
mod scatter_prior;
mod smoothing;
mod stated;
mod tail;
mod timed_flights;
mod trials;
mod unknowns;

pub use budget::{Budget, Share};
pub use drawn::{Axis, DrawnUnknowns, Variable};
pub use identify::{Correlations, PriorContraction, Unknown};
pub use parameters::{MAX_PARETO_SHAPE, UNINFORMATIVE, UNKNOWN};
pub use pool::SamplerConfig;
pub use possible_balls::PossibleBall;
pub use posterior::{BandPoint, Draws, ImpactPosterior, Model, Posterior, Sampling};
pub use prior_draw::PriorDraw;
pub use priors::{Measured, Priors};

use crate::ball::Ball;
use crate::error::{Error, InferenceFailure, Quantity, Result, positive};
use crate::estimate::Estimate;
use crate::flight::Environment;
use crate::impact::Impact;
use crate::restitution::{LawKind, Restitution};
use answers::Answers;
use candidates::SampledPosterior;

/// What to ask of the posterior.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct InferenceOptions {
    /// The impact speed at which to state the restitution, m/s; if `None`, that of the first impact detected.
    pub at_speed_m_s: Option<f64>,
    /// From which height does the flight after a bounce (1 for the first) rise to an apex, in m?
    pub reach: Vec<ApexTarget>,
    /// How much to compute.
    pub sampler: SamplerConfig,
    /// Whether to summarise each impact and flight. A drop that is only compared with others does not need that, and its
    /// inference takes a third less time: [`Posterior::impacts`] is empty then, and time and path until rest follow from
    /// fewer draws.
    #[cfg_attr(feature = "serde", serde(skip, default = "each_impact"))]
    #[cfg_attr(feature = "typescript", ts(skip))]
    pub each_impact: bool,
}

impl Default for InferenceOptions {
    fn default() -> Self {
        Self {
            at_speed_m_s: None,
            reach: Vec::new(),
            sampler: SamplerConfig::default(),
            each_impact: true,
        }
    }
}

/// What options that come as text ask for.
#[cfg(feature = "serde")]
fn each_impact() -> bool {
    InferenceOptions::default().each_impact
}

/// A bounce and the apex that it is to reach.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct ApexTarget {
    /// Number of the bounce, 1 for the first.
    pub bounce: usize,
    /// Apex of the flight after it, m.
    pub apex_m: f64,
}

/// The answer to an [`ApexTarget`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[non_exhaustive]
pub struct Prediction {
    /// What was asked.
    #[cfg_attr(feature = "serde", serde(flatten))]
    pub target: ApexTarget,
    /// The drop height, m, with the restitution that the law expects; `None` if no height does.
    pub drop_height_m: Option<Estimate>,
}

/// Infers everything that the times of one drop determine. The [module](self) has an example.
///
/// # Errors
///
/// [`Error::CannotInfer`] with fewer than two impacts, if no physical model explains them, if they do not determine the
/// restitution, or if the sampling does not converge;
/// [`Error::OutOfRange`] and [`Error::NotInOrder`] for times and priors that make no sense, and
/// the errors of [`FlightModel::new`](crate::flight::FlightModel::new).
pub fn infer(
    impacts: &[Impact],
    ball: &Ball,
    environment: &Environment,
    contact_time_s: f64,
    priors: &Priors,
    inference: &InferenceOptions,
) -> Result<Posterior> {
    if let Some(speed_m_s) = inference.at_speed_m_s {
        positive(Quantity::ImpactSpeed, speed_m_s)?;
    }
    for reach in &inference.reach {
        positive(Quantity::Apex, reach.apex_m)?;
    }
    let posterior = SampledPosterior::new(
        impacts,
        ball,
        environment,
        contact_time_s,
        priors,
        &inference.sampler,
    )?;
    let failed = || Error::CannotInfer(InferenceFailure::SamplingFailed);
    if posterior.draws.is_empty() {
        return Err(failed());
    }
    let pareto_shape = posterior.pareto_shape();
    if pareto_shape >= MAX_PARETO_SHAPE {
        let unconverged = InferenceFailure::NotConverged { pareto_shape };
        return Err(Error::CannotInfer(unconverged));
    }
    let speeds = posterior.fitted_speeds();
    let at_speed_m_s = inference.at_speed_m_s.unwrap_or(speeds.first_m_s);
    let answers = Answers::new(&posterior, at_speed_m_s).ok_or_else(failed)?;
    answers.check_restitution(impacts.len())?;
    let found = answers.inference(posterior, speeds, inference);
    found.ok_or_else(failed)
}

/// The kinds of balls that explain the times of a drop better than the given ball: each with the logarithm of its Bayes
/// factor, by the curvature at the best fits (Laplace).
///
/// # Errors
///
/// Those of [`infer`].
pub(crate) fn better_kinds(
    impacts: &[Impact],
    ball: &Ball,
    environment: &Environment,
    contact_time_s: f64,
    priors: &Priors,
) -> Result<Vec<(&'static str, f64)>> {
    let stated = PossibleBall::stated(*ball, contact_time_s, priors);
    let possible_balls = std::iter::once(stated).chain(PossibleBall::kinds().iter().copied());
    let priors = Priors {
        possible_balls: possible_balls.collect(),
        ..priors.clone()
    };
    let fitted =
        SampledPosterior::fitted_only(impacts, ball, environment, contact_time_s, &priors)?;
    let evidence = |kind: &str| fitted.log_evidence_of_ball(kind);
    let stated = evidence("");
    let kinds = PossibleBall::kinds().iter().map(|possible| possible.kind);
    let compared = kinds.map(|kind| (kind, evidence(kind) - stated));
    Ok(compared.filter(|(_, factor)| *factor > 0.0).collect())
}

/// The most probable drop under one law, without uncertainties.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct BestFit {
    /// The restitution law.
    pub law: Restitution,
    /// Height of the fall before the first impact detected, m.
    pub drop_height_m: f64,
    /// Factor on the drag coefficient of the drag law.
    pub drag_scale: f64,
    /// Contact time, s.
    pub contact_time_s: f64,
}

/// The best fit alone: a hundred times faster than [`infer`], for displays while the ball bounces.
///
/// It takes the first restitution law of the priors (constant if it names none) and the drag law
/// of the environment, and every impact from the first one detected.
///
/// ```
/// use bouncelab::analysis::{Options, impacts_of_times};
/// use bouncelab::inference::best_fit;
///
/// let impacts = impacts_of_times(&[0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045, 2.3308]);
/// let Options { ball, environment, contact_time_s, priors, .. } = Options::default();
/// let fit = best_fit(&impacts, &ball, &environment, contact_time_s, &priors)?;
/// assert!((fit.drop_height_m - 0.305).abs() < 0.01);
/// # Ok::<(), bouncelab::Error>(())
/// ```
///
/// # Errors
///
/// Those of [`infer`].
pub fn best_fit(
    impacts: &[Impact],
    ball: &Ball,
    environment: &Environment,
    contact_time_s: f64,
    priors: &Priors,
) -> Result<BestFit> {
    let law = priors.restitution_laws.first();
    let priors = Priors {
        restitution_laws: vec![law.copied().unwrap_or(LawKind::Constant)],
        first_was_detected: true,
        ..priors.clone()
    };
    let posterior =
        SampledPosterior::fitted_only(impacts, ball, environment, contact_time_s, &priors)?;
    posterior
        .best_fit()
        .ok_or(Error::CannotInfer(InferenceFailure::SamplingFailed))
}
