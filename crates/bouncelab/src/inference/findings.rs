//! The diagnostics of an inference.

use super::candidates::SampledPosterior;
use super::fit;
use super::identify::{PriorContraction, Unknown};
use super::likelihood::Innovation;
use super::parameters::{
    CLEAR_LAW_WEIGHT, CONTRADICTION_SDS, FEW_IMPACTS, LARGE_SCATTER_FACTOR, MANY_RESTITUTIONS,
    MAX_PARETO_SHAPE, OUTLIER_WEIGHT, RELEVANT_WEIGHT, UNINFORMATIVE,
};
use super::pool::Pool;
use super::priors::{Measured, Priors};
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
    diagnostics.extend(about_the_height(posterior, innovations));
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

fn about_the_height(
    posterior: &SampledPosterior,
    innovations: &[Innovation],
) -> Option<Diagnostic> {
    let Priors {
        drop_height_m,
        release_s,
        ..
    } = posterior.priors;
    if drop_height_m.is_none() && release_s.is_none() {
        return Some(Diagnostic::new(Code::HeightOfFirstDetected));
    }
    let contradicts = |measured| contradiction(posterior, innovations, measured);
    if let Some(contradiction) = drop_height_m.and_then(contradicts) {
        return Some(contradiction);
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

/// Whether even the best number of missed impacts leaves a gap between the measured height and the
/// first flight. The gap shows in the first innovation, or as a height far from the measured one.
fn contradiction(
    posterior: &SampledPosterior,
    innovations: &[Innovation],
    measured: Measured,
) -> Option<Diagnostic> {
    let candidate = &posterior.candidates[0];
    let model = posterior.model(candidate);
    let point = model.point(candidate.fit.vector.as_slice())?;
    let fitted_m = model.drop_height_m(&point)?;
    let off = ((fitted_m - measured.value) / measured.sd).abs();
    let first = innovations
        .iter()
        .filter(|innovation| innovation.impact == 0)
        .map(|innovation| innovation.standardised.abs())
        .fold(0.0, f64::max);
    if off.max(first) < CONTRADICTION_SDS {
        return None;
    }
    let detected_m = detected_height_m(posterior, candidate.law, candidate.medium)?;
    // A height from a flight time goes as gravity.
    let gravity_m_s2 = posterior.environment.gravity_m_s2 * measured.value / detected_m;
    Some(
        Diagnostic::new(Code::HeightContradictsTimes)
            .with("measured_m", measured.value)
            .with("detected_m", detected_m)
            .with("gravity_m_s2", gravity_m_s2),
    )
}

/// The height of the fall before the first impact detected, from the times alone.
fn detected_height_m(posterior: &SampledPosterior, law: LawKind, medium: usize) -> Option<f64> {
    let without = SampledPosterior {
        priors: Priors {
            drop_height_m: None,
            release_s: None,
            ..posterior.priors.clone()
        },
        numberings: vec![posterior.numbering().clone()],
        media: posterior.media.clone(),
        candidates: Vec::new(),
        draws: Pool::default(),
        ..*posterior
    };
    let model = without.model_of(law, medium, 0, 0);
    let fit = fit::best_fit(&model, model.start(), f64::NEG_INFINITY)?;
    let point = model.point(fit.vector.as_slice())?;
    model.drop_height_m(&point)
}
