//! The diagnostics of an inference.

use super::candidates::SampledPosterior;
use super::likelihood::Innovation;
use super::parameters::{
    FEW_IMPACTS, LARGE_SCATTER_FACTOR, MANY_RESTITUTIONS, MAX_DOUBLED, MIN_DOUBLED_HEIGHT_M,
    OUTLIER_WEIGHT, RELEVANT_WEIGHT,
};
use crate::diagnostic::{Code, Diagnostic};
use crate::restitution::LawKind;

/// Every diagnostic that applies.
pub(super) fn diagnostics(
    posterior: &SampledPosterior,
    innovations: &[Innovation],
) -> Vec<Diagnostic> {
    let mut diagnostics = Vec::new();
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
    diagnostics.extend(posterior.left_out.iter().cloned());
    diagnostics.extend(posterior.doubt());
    diagnostics.extend(posterior.contradictions.iter().cloned());
    diagnostics.extend(missed_first(posterior));
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

/// A diagnostic if each flight between few impacts may be two, of which nobody heard the impact in between: their times fit as
/// well. Not if the other drop height is one from which nobody lets a ball fall, or if the height was measured.
///
/// Two flights of one ball last t (1 + e') together, and those of the next pair e'² as long, so that e' is the root of the
/// restitution e that is found. From 2 e v / g = (1 + e') 2 e' v' / g follows v' = v e' / (1 + e'), and the height by its square.
pub(super) fn doubled(
    posterior: &SampledPosterior,
    restitution: f64,
    drop_height_m: f64,
) -> Option<Diagnostic> {
    let impacts = &posterior.observed().impacts;
    let counted = impacts
        .windows(2)
        .all(|pair| pair[1].number == pair[0].number + 1);
    let is_known = posterior.priors.drop_height_m.is_some() || posterior.priors.release_s.is_some();
    let other = restitution.sqrt();
    let height_m = drop_height_m * (other / (1.0 + other)).powi(2);
    let may_be = impacts.len() <= MAX_DOUBLED && counted && !is_known;
    (may_be && height_m >= MIN_DOUBLED_HEIGHT_M).then(|| {
        Diagnostic::new(Code::FlightsMayBeTwo)
            .with("count", impacts.len())
            .with("restitution", other)
            .with("height_m", height_m)
    })
}

fn missed_first(posterior: &SampledPosterior) -> Option<Diagnostic> {
    let missed: f64 = posterior
        .candidates
        .iter()
        .filter(|candidate| candidate.missed_first > 0)
        .map(|candidate| candidate.weight)
        .sum();
    (missed > RELEVANT_WEIGHT)
        .then(|| Diagnostic::new(Code::FirstImpactsMissed).with("probability", missed))
}
