//! What is recorded of a drop: what its rows are made of, and what a session keeps.

use std::collections::BTreeMap;

use bouncelab::analysis::{Drop, MeasuredFlight};
use bouncelab::diagnostic::Code;
use bouncelab::groups::CurveEvidence;
use bouncelab::inference::Posterior;
use bouncelab::restitution::ImpactRestitution;
use bouncelab::{Diagnostic, Estimate, Impact};
use serde::{Deserialize, Serialize};

use crate::quantities;

/// The result of one drop.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct DropRecord {
    /// Probability that it is a drop.
    pub probability: f64,
    /// Its impacts, in order of time.
    pub impacts: Vec<ImpactRecord>,
    /// The [reported quantities](crate::quantities), by the names of their columns.
    pub quantities: BTreeMap<String, Estimate>,
    /// What belongs to the quantities of the inference; `None` if there is no posterior.
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

/// What belongs to the quantities of an inference, and by which drops are compared.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PosteriorRecord {
    /// The impact speed of `restitution`, m/s.
    pub at_speed_m_s: f64,
    /// The impact speed of `energy_kept`, m/s.
    pub first_speed_m_s: f64,
    /// The impact speed of `round_speed_restitution`, m/s.
    pub round_speed_m_s: Option<f64>,
    /// Probabilities of 0, 1, 2, ... impacts before the first one detected.
    pub missed_first_impacts: Option<Vec<f64>>,
    /// What it says of the restitution curve, if drops are compared.
    pub evidence: Option<CurveEvidence>,
}

impl From<&Drop> for DropRecord {
    /// Everything but the evidence, which takes long.
    fn from(drop: &Drop) -> Self {
        let posterior = drop.posterior.as_ref();
        let weight = |number: usize| posterior.ok()?.weight(number);
        let impacts = drop.impacts.iter().map(|&impact| ImpactRecord {
            impact,
            restitution: drop.impact_restitution(impact.number).copied(),
            flight: drop.flight(impact.number).copied(),
            weight: weight(impact.number),
        });
        let own = drop
            .diagnostics
            .iter()
            .filter(|it| it.code != Code::ImpactsOdd);
        Self {
            probability: drop.probability,
            impacts: impacts.collect(),
            quantities: quantities::estimates(drop),
            posterior: posterior.ok().map(PosteriorRecord::from),
            no_posterior: posterior.err().map(bouncelab::Error::diagnostic),
            diagnostics: own.cloned().collect(),
        }
    }
}

impl From<&Posterior> for PosteriorRecord {
    fn from(posterior: &Posterior) -> Self {
        Self {
            at_speed_m_s: posterior.at_speed_m_s,
            first_speed_m_s: posterior.first_speed_m_s,
            round_speed_m_s: posterior.round_speed_m_s,
            missed_first_impacts: posterior.missed_first_impacts.clone(),
            evidence: None,
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
