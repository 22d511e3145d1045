//! The diagnostics of an inference.

use super::candidates::SampledPosterior;
use super::identify::{PriorContraction, Unknown};
use super::likelihood::Innovation;
use super::parameters::{
    CLEAR_LAW_WEIGHT, FEW_IMPACTS, LARGE_SCATTER_FACTOR, MANY_RESTITUTIONS, MAX_PARETO_SHAPE,
    OUTLIER_WEIGHT, RELEVANT_WEIGHT, UNINFORMATIVE,
};
use crate::diagnostic::{Code, Diagnostic};
use crate::restitution::LawKind;

/// Every diagnostic that applies.
pub(super) fn diagnostics(
    posterior: &SampledPosterior,
    innovations: &[Innovation],
    prior_contraction: &[PriorContraction],
) -> Vec<Diagnostic> {
    let mut diagnostics = Vec::new();
    if !posterior.converged() {
        diagnostics.push(
            Diagnostic::new(Code::SamplingNotConverged)
                .with("pareto_shape", posterior.pareto_shape())
                .with("greatest", MAX_PARETO_SHAPE),
        );
    }
    let impacts = &posterior.observed().impacts;
    if impacts.len() < FEW_IMPACTS {
        diagnostics.push(Diagnostic::new(Code::FewImpacts).with("count", impacts.len()));
    }
    let seen = posterior.observed().restitutions();
    let asked = |law: &LawKind| posterior.priors.restitution_laws.contains(law);
    diagnostics.extend(
        LawKind::ALL
            .into_iter()
            .filter(|law| asked(law) && law.restitutions_needed() > seen.max(1))
            .map(|law| {
                Diagnostic::new(Code::LawNeedsImpacts)
                    .with("law", law.name())
                    .with("needed", law.restitutions_needed())
                    .with("seen", seen)
            }),
    );
    // The first innovation belongs to the drop height, and is no impact of its own.
    let outliers: Vec<usize> = innovations
        .iter()
        .filter(|innovation| innovation.impact > 0 && innovation.weight < OUTLIER_WEIGHT)
        .map(|innovation| impacts[innovation.impact].number)
        .collect();
    if !outliers.is_empty() {
        diagnostics.push(
            Diagnostic::new(Code::ImpactsOdd)
                .with("count", outliers.len())
                .with("impacts", outliers.as_slice()),
        );
    }
    diagnostics.extend(posterior.contradictions.iter().cloned());
    diagnostics.extend(about_the_height(posterior));
    let remaining = |unknown: Unknown| {
        let found = prior_contraction.iter().find(|n| n.unknown == unknown);
        found.map(|n| n.remaining)
    };
    let drag_unknown = remaining(Unknown::Drag).is_some_and(|share| share > UNINFORMATIVE);
    if drag_unknown {
        diagnostics.push(Diagnostic::new(Code::DragFromPrior));
    }
    let slope_possible = posterior
        .candidates
        .iter()
        .any(|candidate| candidate.law != LawKind::Constant && candidate.weight > RELEVANT_WEIGHT);
    if drag_unknown && slope_possible {
        diagnostics.push(Diagnostic::new(Code::DragOrSlope));
    }
    if law_weight(posterior) < CLEAR_LAW_WEIGHT {
        diagnostics.push(Diagnostic::new(Code::NoLawWins));
    }
    diagnostics
}

/// A diagnostic if restitution scatters far more than its prior assumes. Few impacts do not overcome a prior, and the
/// intervals are too narrow on such a surface (`docs/validation.md`, scenarios).
pub(super) fn scattered(posterior: &SampledPosterior, scatter: f64) -> Option<Diagnostic> {
    let assumed = posterior.priors.restitution_scatter;
    let few = posterior.observed().restitutions() < MANY_RESTITUTIONS;
    (few && scatter > LARGE_SCATTER_FACTOR * assumed).then(|| {
        let scattered = Diagnostic::new(Code::ScatterExceedsPrior);
        let scattered = scattered.with("relative_sd", scatter);
        scattered.with("assumed_relative_sd", assumed)
    })
}

/// Probability of the most probable restitution law.
fn law_weight(posterior: &SampledPosterior) -> f64 {
    LawKind::ALL
        .into_iter()
        .map(|law| {
            let of_law = posterior.candidates.iter().filter(|c| c.law == law);
            of_law.map(|c| c.weight).sum::<f64>()
        })
        .fold(0.0, f64::max)
}

fn about_the_height(posterior: &SampledPosterior) -> Option<Diagnostic> {
    let priors = &posterior.priors;
    if priors.drop_height_m.is_none() && priors.release_s.is_none() {
        let unknown = posterior.contradictions.is_empty();
        return unknown.then(|| Diagnostic::new(Code::HeightOfFirstDetected));
    }
    let missed: f64 = posterior
        .candidates
        .iter()
        .filter(|candidate| candidate.missed_first > 0)
        .map(|candidate| candidate.weight)
        .sum();
    (missed > RELEVANT_WEIGHT)
        .then(|| Diagnostic::new(Code::FirstImpactsMissed).with("probability", missed))
}
