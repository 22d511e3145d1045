//! The posterior as a result: estimates and their diagnostics.

use super::budget::Budget;
use super::candidates::SampledPosterior;
use super::identify::{Correlations, PriorContraction};
use super::parameters::{BAND_ENDS, BAND_POINTS, OUTLIER_WEIGHT, THINNING};
use super::predict;
use super::priors::Measured;
use super::{BestFit, Prediction};
use crate::ball::Ball;
use crate::diagnostic::Diagnostic;
use crate::estimate::Estimate;
use crate::restitution::LawKind;

/// The posterior of one drop, over all models.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[non_exhaustive]
pub struct Posterior {
    /// The impact speed of [`Self::restitution`], m/s: [`Self::first_speed_m_s`] unless another was
    /// [asked for](super::InferenceOptions::at_speed_m_s).
    pub at_speed_m_s: f64,
    /// The restitution law at that speed.
    pub restitution: Estimate,
    /// The speed of the first impact detected, at the best fit, m/s.
    pub first_speed_m_s: f64,
    /// The share of its kinetic energy that the ball kept at the first impact detected: e² at that speed.
    pub energy_kept: Estimate,
    /// An impact speed at which drops can be compared, m/s: of the round speeds 1, 2, 5, 10, ... between the slowest and the
    /// fastest impact, the nearest to 1 m/s; `None` if no round speed lies between them.
    pub round_speed_m_s: Option<f64>,
    /// The restitution law at that speed.
    pub round_speed_restitution: Option<Estimate>,
    /// -d ln e/d ln v at [`Self::at_speed_m_s`]: by how many per cent restitution falls when speed grows by one.
    pub restitution_slope: Estimate,
    /// Height of the fall: before the first impact if a height or release was given, else before
    /// the first impact detected, m.
    pub drop_height_m: Estimate,
    /// The drag coefficient at [`Self::drag_reynolds`], if there is drag.
    pub drag_coefficient: Option<Estimate>,
    /// The Reynolds number of the drag coefficient: of the fastest impact, where drag shows most.
    pub drag_reynolds: Option<f64>,
    /// The drag coefficient before the data.
    pub drag_coefficient_prior: Option<Measured>,
    /// The terminal speed, m/s, if there is drag and its law reaches it.
    pub terminal_speed_m_s: Option<Estimate>,
    /// Gravity, m/s².
    pub gravity_m_s2: Estimate,
    /// Standard deviation of ln e from impact to impact.
    pub restitution_scatter: Estimate,
    /// Root mean square standard error of the times, s.
    pub timing_s: Estimate,
    /// Contact time, s.
    pub contact_time_s: Estimate,
    /// From the release until the ball rests, s.
    pub total_time_s: Option<Estimate>,
    /// Path from the release until the ball rests, m.
    pub total_path_m: Option<Estimate>,
    /// Probabilities of 0, 1, 2, ... impacts before the first one detected, if a height or a release
    /// time was given.
    pub missed_first_impacts: Option<Vec<f64>>,
    /// Probability that the first impact detected is another sound, or of an earlier drop. The draws contain both
    /// possibilities; nearly certain other sounds are left out.
    pub first_is_other_sound: f64,
    /// The answers to [`InferenceOptions::reach`](super::InferenceOptions::reach).
    pub predictions: Vec<Prediction>,
    /// The impacts detected.
    pub impacts: Vec<ImpactPosterior>,
    /// The models that were weighed, most probable first.
    pub models: Vec<Model>,
    /// Natural logarithm of the evidence of all models together, but for a constant of the times: the
    /// difference between two posteriors of the same times is the logarithm of their Bayes factor.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub log_evidence: f64,
    /// How much the data contracted the priors.
    pub prior_contraction: Vec<PriorContraction>,
    /// Correlations between the answers.
    pub correlations: Correlations,
    /// Where the uncertainty comes from.
    pub budget: Budget,
    /// Equally likely values of the answers together.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub draws: Draws,
    /// Whether and how well the sampling worked.
    pub sampling: Sampling,
    /// What was assumed before the data.
    pub priors: Vec<Diagnostic>,
    /// The restitution law over the impact speeds, from a little below the slowest to a little above
    /// the fastest.
    pub band: Vec<BandPoint>,
    /// What to know before believing it; among the diagnostics of the drop too.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub diagnostics: Vec<Diagnostic>,
    /// The slowest and the fastest of the impacts that the ball left again, at the best fit, m/s.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub fitted_speeds_m_s: [f64; 2],
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(super) weights: Vec<f64>,
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(super) sampled: SampledPosterior,
}

/// An impact detected, and the flight after it.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[non_exhaustive]
pub struct ImpactPosterior {
    /// Its number.
    pub number: usize,
    /// Speed just before it, m/s.
    pub impact_speed_m_s: Estimate,
    /// What it kept of the speed; unknown for the last, and where the next was missed.
    pub restitution: Option<Estimate>,
    /// Apex of the flight after it, m.
    pub apex_m: Option<Estimate>,
    /// Energy it took, J.
    pub lost_to_surface_j: Option<Estimate>,
    /// Energy the air took in the flight after it, J.
    pub lost_to_air_j: Option<Estimate>,
    /// Deviation from the prediction by the impacts before it, in standard deviations; unknown
    /// for the last.
    pub standardised_residual: Option<f64>,
    /// Its weight in the fit: 1 for an impact as good as any, near 0 for an outlier.
    pub weight: f64,
}

/// A model with its probability and its results.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[non_exhaustive]
pub struct Model {
    /// Restitution law.
    #[cfg_attr(feature = "typescript", ts(type = "string"))]
    pub restitution_law: LawKind,
    /// The kind of ball, if none was stated.
    pub ball: Option<&'static str>,
    /// Its posterior probability, over all numbers of missed impacts.
    pub probability: f64,
    /// Natural logarithm of its probability over that of the most probable.
    pub log_odds: f64,
    /// The restitution if it is true; `None` if it is too improbable to have been sampled.
    pub restitution: Option<Estimate>,
    /// The drop height if it is true, m.
    pub drop_height_m: Option<Estimate>,
}

/// Equally likely values of the answers; those with the same index belong together.
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[non_exhaustive]
pub struct Draws {
    /// Restitution at the stated speed.
    pub restitution: Vec<f64>,
    /// Drag coefficient; empty if there is no drag.
    pub drag_coefficient: Vec<f64>,
    /// Drop height, m.
    pub drop_height_m: Vec<f64>,
    /// Time from release to rest, s, of every second draw; empty if some do not come to rest.
    pub total_time_s: Vec<f64>,
}

/// How the sampling went.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[non_exhaustive]
pub struct Sampling {
    /// Draws that count as independent.
    pub effective_draws: f64,
    /// Shape of the tail of the weights: below [`MAX_PARETO_SHAPE`](super::MAX_PARETO_SHAPE), above which there is no
    /// posterior.
    pub pareto_shape: f64,
}

/// The restitution law at one speed.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[non_exhaustive]
pub struct BandPoint {
    /// Impact speed, m/s.
    pub speed_m_s: f64,
    /// Restitution there.
    pub restitution: Estimate,
}

impl ImpactPosterior {
    /// Whether it is an outlier, which has little weight in the fit.
    pub fn is_outlier(&self) -> bool {
        self.weight < OUTLIER_WEIGHT
    }
}

impl Posterior {
    /// The impact of this number, if it was detected.
    pub fn impact(&self, number: usize) -> Option<&ImpactPosterior> {
        self.impacts.iter().find(|impact| impact.number == number)
    }

    /// The weight of an impact in the fit, as [`ImpactPosterior::weight`], whether or not each impact was asked for; `None`
    /// if none of this number was detected.
    pub fn weight(&self, number: usize) -> Option<f64> {
        let mut impacts = self.sampled.observed().impacts.iter();
        let index = impacts.position(|it| it.number == number)?;
        self.weights.get(index).copied()
    }

    /// Whether the impact of this number is an outlier, which has little weight in the fit.
    pub fn is_outlier(&self, number: usize) -> bool {
        self.weight(number)
            .is_some_and(|weight| weight < OUTLIER_WEIGHT)
    }

    /// Number of the first impact that most probably belongs to the drop.
    pub fn first_impact(&self) -> usize {
        self.sampled.observed().impacts[0].number
    }

    /// The restitution law at a speed, m/s.
    ///
    /// ```
    /// use bouncelab::inference::SamplerConfig;
    /// use bouncelab::{Options, analyze_times};
    ///
    /// let times_s = [0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045, 2.3308, 2.6375, 2.9262, 3.1984];
    /// let options = Options::default().with_sampler(SamplerConfig { draws: 300, seed: 1 });
    /// let posterior = analyze_times(&times_s, &options).drops.remove(0).posterior?;
    /// let slow = posterior.restitution_at(1.0).unwrap();
    /// assert!((0.9..1.0).contains(&slow.value) && slow.sd > 0.0);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn restitution_at(&self, speed_m_s: f64) -> Option<Estimate> {
        let laws = self.sampled.laws_drawn(1);
        self.sampled.estimate(1, laws.map(|law| law.at(speed_m_s)))
    }

    /// The apex after the first impact of a drop of this ball from a height, both of the lowest point
    /// of the ball, m: one for each draw, with the restitution that the law expects.
    ///
    /// Empty if the height is so far beyond the detected heights that nothing can be stated.
    ///
    /// ```
    /// use bouncelab::inference::SamplerConfig;
    /// use bouncelab::{Options, analyze_times};
    ///
    /// let times_s = [0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045, 2.3308, 2.6375, 2.9262, 3.1984];
    /// let options = Options::default().with_sampler(SamplerConfig { draws: 300, seed: 1 });
    /// let posterior = analyze_times(&times_s, &options).drops.remove(0).posterior?;
    /// let rebounds_m = posterior.rebounds_m(0.305);
    /// assert!(rebounds_m.iter().all(|height_m| (0.2..0.305).contains(height_m)));
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn rebounds_m(&self, drop_height_m: f64) -> Vec<f64> {
        let rebounds = self.sampled.each(1, |model, point| {
            predict::rebound_m(model, point, drop_height_m)
        });
        // A draw that cannot be worked out would leave the others one-sided.
        if rebounds.len() == self.sampled.draws.len() {
            rebounds
        } else {
            Vec::new()
        }
    }

    /// The restitution law over the impact speeds: what [`Self::band`] holds.
    pub(super) fn compute_band(&self) -> Vec<BandPoint> {
        let points = BAND_POINTS;
        let speeds = &self.sampled.reference.speeds;
        let fastest = speeds.fastest_m_s.max(self.fitted_speeds_m_s[1]);
        let (from, to) = (BAND_ENDS[0] * speeds.slowest_m_s, BAND_ENDS[1] * fastest);
        let speeds_m_s: Vec<f64> = (0..points)
            .map(|point| from + (to - from) * point as f64 / (points.max(2) - 1) as f64)
            .collect();
        let summaries = self.restitution_at_each(&speeds_m_s);
        std::iter::zip(speeds_m_s, summaries)
            .filter_map(|(speed_m_s, restitution)| {
                Some(BandPoint {
                    speed_m_s,
                    restitution: restitution?,
                })
            })
            .collect()
    }

    /// The restitution law at several speeds, m/s, from a fourth of the draws.
    pub fn restitution_at_each(&self, speeds_m_s: &[f64]) -> Vec<Option<Estimate>> {
        let laws = self.sampled.laws_drawn(THINNING);
        let draws: Vec<Vec<f64>> = laws.map(|law| law.at_each(speeds_m_s)).collect();
        (0..speeds_m_s.len())
            .map(|index| {
                let restitutions = draws.iter().map(|draw| draw[index]);
                self.sampled.estimate(THINNING, restitutions)
            })
            .collect()
    }

    /// The most probable drop.
    pub fn best_fit(&self) -> Option<BestFit> {
        self.sampled.best_fit()
    }

    /// The drop of some draws, of the ball and the number of missed first impacts that are most probable.
    pub(crate) fn some_draws(&self, count: usize) -> Vec<BestFit> {
        self.sampled.some_draws(count)
    }

    /// The ball of the most probable drop, and its contact time before the data, s: the ball that was stated, or one of the
    /// kinds that it may be.
    pub(crate) fn most_probable_ball(&self) -> (Ball, f64) {
        let medium = self.sampled.medium_of(0);
        (medium.ball, medium.contact_time_s)
    }

    /// Whether a height was stated, and nothing contradicts it: then it is hardly a result.
    pub fn height_was_stated(&self) -> bool {
        self.sampled.priors.drop_height_m.is_some()
    }
}
