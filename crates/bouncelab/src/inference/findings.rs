//! What a person should know about an inference before believing it.

use std::fmt;

use super::LawKind;
use super::fit;
use super::identify::{PriorContraction, UNINFORMATIVE, Unknown};
use super::likelihood::{Evaluator, Innovation};
use super::priors::{Measured, Priors};
use super::sampled::{MATTERS, SampledPosterior};
use crate::text::list;

/// Something to know about an inference.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Remark {
    /// The sampling did not converge: the Pareto shape of its weights is this.
    NotConverged(f64),
    /// So few impacts leave most to the priors.
    FewImpacts(usize),
    /// A restitution law was asked for that needs more restitutions than were seen.
    TooFewFor {
        /// The law.
        law: LawKind,
        /// How many restitutions were seen.
        seen: usize,
    },
    /// These impacts (by number) are odd and count less.
    Odd(Vec<usize>),
    /// The measured height does not go with the flight times, whatever number of impacts was
    /// missed.
    HeightContradicts {
        /// The height that was measured, m.
        measured_m: f64,
        /// The height from which the flight times say the ball fell before the first impact heard,
        /// m.
        heard_m: f64,
        /// The gravity that would make both true, m/s².
        gravity_m_s2: f64,
    },
    /// Impacts before the first one heard were missed, with this probability.
    MissedFirst(f64),
    /// Neither height nor release was measured: the drop height is that of the fall before the first
    /// impact *heard*.
    HeightIsOfFirstHeard,
    /// The data say nothing of the drag coefficient: it is what the sphere laws say.
    DragFromPrior,
    /// Drag and a restitution that falls with speed make the same flight times.
    DragOrSlope,
    /// No model wins; the answer is an average over several.
    NoLawWins,
    /// The restitution is so close to 1 that the ball does not come to rest.
    NeverRests,
}

impl fmt::Display for Remark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotConverged(shape) => write!(
                f,
                "the sampling did not converge (Pareto shape {shape:.2}; it should be below 0.7), \
                 so the intervals cannot be trusted; the impacts may not be of one drop"
            ),
            Self::FewImpacts(count) => write!(
                f,
                "{count} impacts show {} of the ball; the rest of the answer is what is \
                 known of balls in general",
                match count {
                    2 => "a single flight and no restitution",
                    3 => "a single restitution, taken to be the same at every speed,",
                    _ => "few restitutions",
                }
            ),
            Self::TooFewFor { law, seen } => write!(
                f,
                "the {law} restitution law takes {} impacts between two flights to be state from a \
                 constant, and there {} {seen}: how restitution changes is what was assumed",
                law.needs(),
                if *seen == 1 { "is" } else { "are" },
            ),
            Self::Odd(numbers) => write!(
                f,
                "impact{} {} {} odd and count{} less: the ball may have drifted, hit an edge, or \
                 the sound is something else",
                if numbers.len() == 1 { "" } else { "s" },
                list(numbers),
                if numbers.len() == 1 { "is" } else { "are" },
                if numbers.len() == 1 { "s" } else { "" },
            ),
            Self::HeightContradicts {
                measured_m,
                heard_m,
                gravity_m_s2,
            } => write!(
                f,
                "the measured height of {measured_m:.3} m does not go with the flight times, which \
                 speak of {heard_m:.3} m: both would be true if gravity were {gravity_m_s2:.2} \
                 m/s2; a wrong sample rate, a wrong ball, or a wrong height"
            ),
            Self::MissedFirst(probability) => write!(
                f,
                "impacts before the first one heard were missed, with probability {probability:.3}"
            ),
            Self::HeightIsOfFirstHeard => write!(
                f,
                "the drop height is of the fall before the first impact heard; with the measured \
                 height (--height) missed impacts would show"
            ),
            Self::DragFromPrior => write!(
                f,
                "these flight times say next to nothing about drag: the drag coefficient is what \
                 is known of spheres"
            ),
            Self::DragOrSlope => write!(
                f,
                "drag and falling restitution cannot be state apart from this recording; a measured \
                 drop height or a denser ball would"
            ),
            Self::NoLawWins => write!(
                f,
                "no restitution law wins; the answer is averaged over those that may be true"
            ),
            Self::NeverRests => write!(
                f,
                "with so little loss the ball does not come to rest in any reasonable time"
            ),
        }
    }
}

/// An impact with less weight than this is called odd.
pub(super) const ODD_WEIGHT: f64 = 0.55;

/// Fewer impacts than this leave most to the priors.
const FEW: usize = 5;

/// So many standard deviations between what was measured and what was heard are no chance.
const CONTRADICTION: f64 = 3.5;

/// Every remark that applies.
pub(super) fn remarks(
    posterior: &SampledPosterior,
    innovations: &[Innovation],
    prior_contraction: &[PriorContraction],
    rests: bool,
) -> Vec<Remark> {
    let mut remarks = Vec::new();
    if !posterior.converged() {
        remarks.push(Remark::NotConverged(posterior.pareto_shape()));
    }
    let impacts = &posterior.observed.impacts;
    if impacts.len() < FEW {
        remarks.push(Remark::FewImpacts(impacts.len()));
    }
    let seen = posterior.observed.restitutions();
    let considered = posterior.priors.laws(seen).into_iter();
    remarks.extend(
        considered
            .filter(|law| law.needs() > seen.max(1))
            .map(|law| Remark::TooFewFor { law, seen }),
    );
    // The first innovation belongs to the drop height, and is no impact of its own.
    let odd: Vec<usize> = innovations
        .iter()
        .filter(|innovation| innovation.impact > 0 && innovation.weight < ODD_WEIGHT)
        .map(|innovation| impacts[innovation.impact].number)
        .collect();
    if !odd.is_empty() {
        remarks.push(Remark::Odd(odd));
    }
    remarks.extend(about_the_height(posterior, innovations));
    let remaining = |unknown: Unknown| {
        let found = prior_contraction.iter().find(|n| n.unknown == unknown);
        found.map(|n| n.remaining)
    };
    let drag_unknown = remaining(Unknown::Drag).is_some_and(|share| share > UNINFORMATIVE);
    if drag_unknown {
        remarks.push(Remark::DragFromPrior);
    }
    let slope_possible = posterior
        .candidates
        .iter()
        .any(|candidate| candidate.law != LawKind::Constant && candidate.weight > MATTERS);
    if drag_unknown && slope_possible {
        remarks.push(Remark::DragOrSlope);
    }
    if law_weight(posterior) < 0.9 {
        remarks.push(Remark::NoLawWins);
    }
    if !rests {
        remarks.push(Remark::NeverRests);
    }
    remarks
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

fn about_the_height(posterior: &SampledPosterior, innovations: &[Innovation]) -> Option<Remark> {
    let Priors {
        drop_height_m,
        release_s,
        ..
    } = posterior.priors;
    if drop_height_m.is_none() && release_s.is_none() {
        return Some(Remark::HeightIsOfFirstHeard);
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
    (missed > MATTERS).then_some(Remark::MissedFirst(missed))
}

/// Whether even the best number of missed impacts leaves a gap between the measured height and the
/// first flight. The gap shows in the first innovation, or as a height far from the measured one.
fn contradiction(
    posterior: &SampledPosterior,
    innovations: &[Innovation],
    measured: Measured,
) -> Option<Remark> {
    let candidate = &posterior.candidates[0];
    let model = posterior.model(candidate);
    let mut evaluator = Evaluator::new(&model);
    let point = evaluator.point(candidate.fit.vector.as_slice())?;
    let fitted_m = evaluator.state(&point)?.drop_height_m;
    let off = ((fitted_m - measured.value) / measured.sd).abs();
    let first = innovations
        .iter()
        .filter(|innovation| innovation.impact == 0)
        .map(|innovation| innovation.standardised.abs())
        .fold(0.0, f64::max);
    if off.max(first) < CONTRADICTION {
        return None;
    }
    let heard_m = heard_height_m(posterior, candidate.law, candidate.media)?;
    Some(Remark::HeightContradicts {
        measured_m: measured.value,
        heard_m,
        // A height from a flight time goes as gravity.
        gravity_m_s2: posterior.environment.gravity_m_s2 * measured.value / heard_m,
    })
}

/// The height of the fall before the first impact heard, as the times alone have it.
fn heard_height_m(posterior: &SampledPosterior, law: LawKind, media: usize) -> Option<f64> {
    let without = SampledPosterior {
        priors: Priors {
            drop_height_m: None,
            release_s: None,
            ..posterior.priors.clone()
        },
        observed: posterior.observed.clone(),
        media: posterior.media.clone(),
        candidates: Vec::new(),
        draws: Vec::new(),
        ..*posterior
    };
    let model = without.model_of(law, media, 0);
    let mut evaluator = Evaluator::new(&model);
    let fit = fit::best_fit(&mut evaluator)?;
    let point = evaluator.point(fit.vector.as_slice())?;
    Some(evaluator.state(&point)?.drop_height_m)
}
