//! What is recorded of a drop: what its rows are made of, and what a session keeps.

use bouncelab::analysis::{Drop, MeasuredFlight};
use bouncelab::diagnostic::Code;
use bouncelab::groups::RestitutionCurve;
use bouncelab::inference::Posterior;
use bouncelab::restitution::ImpactRestitution;
use bouncelab::{Diagnostic, Estimate, Impact};
use serde::{Deserialize, Serialize};

/// The result of one drop.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DropRecord {
    /// Probability that it is a drop.
    pub probability: f64,
    /// Its impacts, in order of time.
    pub impacts: Vec<ImpactRecord>,
    /// Median of the restitutions of its impacts, corrected for drag.
    pub per_impact_restitution: Option<Estimate>,
    /// The log-linear fit: the straight line through the logarithms of the flight times.
    pub log_linear_fit: Option<FitRecord>,
    /// The result of the inference.
    pub posterior: Option<PosteriorRecord>,
    /// Why there is no posterior.
    pub no_posterior: Option<Diagnostic>,
    /// Diagnostics of this drop, without those that hold for all drops like it.
    pub diagnostics: Vec<Diagnostic>,
}

/// One impact and the flight after it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct ImpactRecord {
    /// The impact.
    pub impact: Impact,
    /// Its restitution, corrected for drag.
    pub restitution: Option<ImpactRestitution>,
    /// The flight after it.
    pub flight: Option<MeasuredFlight>,
    /// Its weight in the inference.
    pub weight: Option<f64>,
}

/// The results of the log-linear fit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FitRecord {
    /// Restitution.
    pub restitution: Estimate,
    /// Drop height, m.
    pub drop_height_m: Estimate,
}

/// The results of the inference by which drops are compared.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PosteriorRecord {
    /// The impact speed of [`Self::restitution`], m/s.
    pub at_speed_m_s: f64,
    /// Restitution at that speed.
    pub restitution: Estimate,
    /// Height of the fall, m.
    pub drop_height_m: Estimate,
    /// Drag coefficient at the fastest impact.
    pub drag_coefficient: Option<Estimate>,
    /// Standard deviation of ln e from impact to impact.
    pub restitution_scatter: Estimate,
    /// Root mean square standard error of the times, s.
    pub timing_s: Estimate,
    /// Probabilities of 0, 1, 2, ... impacts before the first one detected.
    pub missed_first_impacts: Option<Vec<f64>>,
    /// Whether the sampling can be trusted.
    pub converged: bool,
    /// Restitution at speeds that all drops share; empty unless drops are compared.
    pub curve: RestitutionCurve,
}

impl From<&Drop> for DropRecord {
    /// Everything but the curve, which takes long.
    fn from(drop: &Drop) -> Self {
        let posterior = drop.posterior.as_ref();
        let weight = |number: usize| posterior.ok()?.weight(number);
        let impacts = drop.impacts.iter().map(|&impact| ImpactRecord {
            impact,
            restitution: drop.impact_restitution(impact.number).copied(),
            flight: drop.flight(impact.number).copied(),
            weight: weight(impact.number),
        });
        let fit = drop.log_linear_fit.as_ref().ok();
        let own = drop.diagnostics.iter().filter(|it| is_of_this_drop(it));
        Self {
            probability: drop.probability,
            impacts: impacts.collect(),
            per_impact_restitution: drop.per_impact_restitution(),
            log_linear_fit: fit.map(|fit| FitRecord {
                restitution: fit.restitution,
                drop_height_m: fit.drop_height_m,
            }),
            posterior: posterior.ok().map(PosteriorRecord::from),
            no_posterior: posterior.err().map(bouncelab::Error::diagnostic),
            diagnostics: own.cloned().collect(),
        }
    }
}

/// Whether a diagnostic concerns this drop, and not all drops like it.
fn is_of_this_drop(diagnostic: &Diagnostic) -> bool {
    !matches!(
        diagnostic.code,
        Code::HeightOfFirstDetected
            | Code::DragFromPrior
            | Code::DragOrSlope
            | Code::NoLawWins
            | Code::ImpactsOdd
    )
}

impl From<&Posterior> for PosteriorRecord {
    fn from(posterior: &Posterior) -> Self {
        Self {
            at_speed_m_s: posterior.at_speed_m_s,
            restitution: posterior.restitution,
            drop_height_m: posterior.drop_height_m,
            drag_coefficient: posterior.drag_coefficient,
            restitution_scatter: posterior.restitution_scatter,
            timing_s: posterior.timing_s,
            missed_first_impacts: posterior.missed_first_impacts.clone(),
            converged: posterior.sampling.converged,
            curve: RestitutionCurve::default(),
        }
    }
}

impl PosteriorRecord {
    /// The most probable number of impacts missed before the first one detected.
    pub fn missed_first_impacts_mode(&self) -> Option<usize> {
        let numbered = self.missed_first_impacts.as_ref()?.iter().enumerate();
        let likeliest = numbered.max_by(|a, b| a.1.total_cmp(b.1))?;
        Some(likeliest.0)
    }
}

impl DropRecord {
    /// Whether the stated height contradicts the flight times.
    pub fn height_contradicts(&self) -> bool {
        let mut diagnostics = self.diagnostics.iter();
        diagnostics.any(|diagnostic| diagnostic.code == Code::HeightContradictsTimes)
    }
}
