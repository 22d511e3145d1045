//! The candidates: every model of a drop, each with its best fit and its evidence.

use std::collections::{BTreeMap, BTreeSet};

use super::BestFit;
use super::fit::{self, Fit};
use super::likelihood::Innovation;
use super::medium::Medium;
use super::numbering;
use super::observed::Observed;
use super::parameters::{
    ALLOWED_BALL, LN_MISSED_FIRST, LN_UNDETECTED, MAX_MISSED_FIRST, OTHER_FIRST, PRUNE_BELOW,
};
use super::pool::{Draw, Pool, SamplerConfig};
use super::possible_balls::PossibleBall;
use super::priors::Priors;
use super::reference_speed::ReferenceSpeed;
use super::sample::Sample;
use super::timed_flights::TimedFlights;
use super::unknowns::{ExpectedRestitution, Model};
use crate::ball::Ball;
use crate::diagnostic::Diagnostic;
use crate::error::{Error, InferenceFailure, Quantity, Result, within};
use crate::flight::Environment;
use crate::impact::Impact;
use crate::restitution::LawKind;
use crate::stats::sort_by_number;
use crate::train::LN_MISSED;

/// A model of the drop, with its fit, its evidence and its sample.
#[derive(Debug, Clone)]
pub(super) struct Candidate {
    pub(super) law: LawKind,
    /// Index of its ball among the media.
    pub(super) medium: usize,
    pub(super) missed_first: usize,
    /// Index of its numbering.
    pub(super) numbering: usize,
    pub(super) fit: Fit,
    /// Origin of the coordinate of the restitution, if it is sampled in units of the noise.
    pub(super) expected_restitution: Option<ExpectedRestitution>,
    /// Logarithm of prior probability times evidence.
    pub(super) log_evidence: f64,
    pub(super) weight: f64,
    pub(super) sample: Option<Sample>,
}

/// The impacts in one numbering, with their flights in each of the media.
#[derive(Debug, Clone)]
pub(super) struct Numbering {
    pub(super) observed: Observed,
    flights: Vec<TimedFlights>,
}

/// Speeds of the impacts that were followed by a flight, m/s.
#[expect(clippy::struct_field_names, reason = "units stand in names")]
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct FittedSpeeds {
    /// That of the first impact detected.
    pub(super) first_m_s: f64,
    pub(super) slowest_m_s: f64,
    pub(super) fastest_m_s: f64,
}

/// The posterior over all candidates.
#[derive(Debug, Clone)]
pub(super) struct SampledPosterior {
    /// The impacts, numbered as given and otherwise.
    pub(super) numberings: Vec<Numbering>,
    pub(super) media: Vec<Medium>,
    pub(super) reference: ReferenceSpeed,
    pub(super) priors: Priors,
    pub(super) environment: Environment,
    /// Most probable first.
    pub(super) candidates: Vec<Candidate>,
    /// What was stated of the fall, contradicts the times or the sound, and is left out.
    pub(super) contradictions: Vec<Diagnostic>,
    /// What was left out before the first impact, as another sound.
    pub(super) left_out: Vec<Diagnostic>,
    /// What is added to the evidence of the candidates with the first impact, since the second may be odd.
    pub(super) ln_odd_second: f64,
    pub(super) draws: Pool,
}

impl SampledPosterior {
    /// Fits, samples and weighs every model that the priors admit.
    ///
    /// # Errors
    /// [`Error::CannotInfer`] if no model can explain the times at all, [`Error::OutOfRange`] if the
    /// release is not before the first impact, and the errors of
    /// [`FlightModel::new`](crate::flight::FlightModel::new) and [`Observed::new`].
    pub(super) fn new(
        impacts: &[Impact],
        ball: &Ball,
        environment: &Environment,
        contact_time_s: f64,
        priors: &Priors,
        sampler: &SamplerConfig,
    ) -> Result<Self> {
        let mut posterior =
            Self::fitted_to_what_holds(impacts, ball, environment, contact_time_s, priors)?;
        if posterior.first_is_other_sound() > OTHER_FIRST
            && let Some(doubt) = posterior.doubt()
        {
            let rest = &impacts[1..];
            let mut rest = Self::new(rest, ball, environment, contact_time_s, priors, sampler)?;
            rest.left_out.insert(0, doubt);
            return Ok(rest);
        }
        posterior.sample(sampler);
        Ok(posterior)
    }

    /// Fits every model, most probable first, and draws nothing.
    ///
    /// # Errors
    /// Those of [`SampledPosterior::new`].
    pub(super) fn fitted_only(
        impacts: &[Impact],
        ball: &Ball,
        environment: &Environment,
        contact_time_s: f64,
        priors: &Priors,
    ) -> Result<Self> {
        priors.check()?;
        let balls = if priors.possible_balls.is_empty() {
            vec![PossibleBall::stated(*ball, contact_time_s, priors)]
        } else {
            priors.possible_balls.clone()
        };
        let observed = Observed::new(impacts)?;
        if let Some(release) = priors.release_s {
            within(
                Quantity::ReleaseTime,
                release.value,
                ..observed.impacts[0].time_s,
            )?;
        }
        let (media, reference) = media(&balls, environment, &observed, priors)?;
        let mut numberings = numbering::plausible(&observed);
        if !priors.first_was_detected {
            for with_first in 0..numberings.len() {
                let without = numberings[with_first].without_first();
                numberings.extend(without.filter(|without| !numberings.contains(without)));
            }
        }
        let numberings = numberings.into_iter().map(|observed| Numbering {
            flights: media
                .iter()
                .map(|medium| TimedFlights::new(&observed, medium))
                .collect(),
            observed,
        });
        let mut posterior = Self {
            numberings: numberings.collect(),
            media,
            reference,
            priors: priors.clone(),
            environment: environment.clone(),
            candidates: Vec::new(),
            contradictions: Vec::new(),
            left_out: Vec::new(),
            ln_odd_second: 0.0,
            draws: Pool::default(),
        };
        posterior.keep_likely_numberings();
        posterior.candidates = posterior.fitted();
        posterior.weigh_first_impact();
        if posterior.candidates.is_empty() {
            return Err(Error::CannotInfer(InferenceFailure::NoModelFits));
        }
        weigh(&mut posterior.candidates);
        Ok(posterior)
    }

    /// The impacts as the most probable candidate numbers them.
    pub(super) fn observed(&self) -> &Observed {
        &self.numbering().observed
    }

    /// The numbering of the most probable candidate.
    pub(super) fn numbering(&self) -> &Numbering {
        let best = self.candidates.first();
        &self.numberings[best.map_or(0, |candidate| candidate.numbering)]
    }

    /// The model of a candidate.
    pub(super) fn model(&self, candidate: &Candidate) -> Model<'_> {
        let Candidate {
            law,
            medium,
            missed_first,
            numbering,
            expected_restitution,
            ..
        } = *candidate;
        self.model_of(law, medium, missed_first, numbering)
            .with_expected_restitution(expected_restitution)
    }

    /// The models of the candidates, in their order.
    pub(super) fn models(&self) -> Vec<Model<'_>> {
        self.candidates.iter().map(|c| self.model(c)).collect()
    }

    /// A model of these data.
    pub(super) fn model_of(
        &self,
        law: LawKind,
        medium: usize,
        missed_first: usize,
        numbering: usize,
    ) -> Model<'_> {
        let Numbering { observed, flights } = &self.numberings[numbering];
        Model::new(
            observed,
            &flights[medium],
            &self.media[medium],
            &self.reference,
            law,
            missed_first,
            &self.priors,
        )
    }

    /// Removes numberings that are unlikely under the first law, which represents all. Of those with the first impact the
    /// likeliest stay: where that fits badly, the second may be odd.
    fn keep_likely_numberings(&mut self) {
        if self.numberings.len() == 1 {
            return;
        }
        let law = self.laws()[0];
        let evidences: Vec<f64> = (0..self.numberings.len())
            .map(|numbering| {
                let mut fits = Vec::new();
                self.fit_missed(law, 0, numbering, &mut fits);
                best_evidence(&fits)
            })
            .collect();
        let best = |with_first: bool| {
            let numbered = self.numberings.iter().zip(&evidences);
            let counted =
                numbered.filter(|(it, _)| !with_first || it.observed.other_sound.is_none());
            counted
                .map(|(_, evidence)| *evidence)
                .fold(f64::NEG_INFINITY, f64::max)
        };
        let (best, best_with_first) = (best(false), best(true));
        let mut evidences = evidences.into_iter();
        // If none is valid under this law, each may be under another.
        self.numberings.retain(|numbering| {
            let least = match numbering.observed.other_sound {
                None => best_with_first - PRUNE_BELOW,
                Some(_) => best - PRUNE_BELOW,
            };
            evidences.next().is_none_or(|evidence| evidence >= least)
        });
    }

    /// The laws to consider. The first represents all where one must, and the searches of others start from its fit: a power
    /// of the speed is similar to most of them.
    pub(super) fn laws(&self) -> Vec<LawKind> {
        let mut laws = self.priors.laws();
        if let Some(power) = laws.iter().position(|&law| law == LawKind::Power) {
            laws[..=power].rotate_right(1);
        }
        laws
    }

    /// Logarithm of the evidence of all models together, but for a constant of the times.
    pub(super) fn log_evidence(&self) -> f64 {
        ln_sum(&self.candidates)
    }

    /// The best fit of every model, with the evidence that its curvature suggests (Laplace).
    fn fitted(&self) -> Vec<Candidate> {
        let mut candidates = Vec::new();
        for law in self.laws() {
            for medium in 0..self.media.len() {
                for numbering in 0..self.numberings.len() {
                    self.fit_missed(law, medium, numbering, &mut candidates);
                }
            }
        }
        candidates
    }

    /// Fits a model with 0, 1, 2, ... impacts before the first one detected, until the evidence falls.
    fn fit_missed(
        &self,
        law: LawKind,
        medium: usize,
        numbering: usize,
        candidates: &mut Vec<Candidate>,
    ) {
        let most = if self.priors.determine_missed() {
            max_missed_first(law, numbering, candidates)
        } else {
            0
        };
        let mut best = f64::NEG_INFINITY;
        for missed_first in 0..=most {
            let model = self.model_of(law, medium, missed_first, numbering);
            let start = self.fitted_like(&model, medium, numbering, candidates);
            let least = highest_posterior(candidates, numbering) - 2.0 * PRUNE_BELOW;
            let fit = start.and_then(|start| fit::best_fit(&model, start, least));
            let Some(fit) = fit.or_else(|| fit::best_fit(&model, model.start(), least)) else {
                continue;
            };
            let mut candidate = Candidate {
                law,
                medium,
                missed_first,
                numbering,
                log_evidence: fit.log_laplace_evidence(),
                fit,
                expected_restitution: None,
                weight: 0.0,
                sample: None,
            };
            candidate.log_evidence += self.log_prior(&candidate);
            let log_evidence = candidate.log_evidence;
            if !log_evidence.is_finite() {
                continue;
            }
            candidates.push(candidate);
            if log_evidence < best - 2.0 * PRUNE_BELOW {
                break;
            }
            best = best.max(log_evidence);
        }
    }

    /// Start of a search by the fits of the same numbering: the fit of the first law, plus the difference between this law and
    /// the first with the other ball. With more impacts missed than before everything may differ, so the most probable
    /// of several starts.
    fn fitted_like(
        &self,
        model: &Model,
        medium: usize,
        numbering: usize,
        candidates: &[Candidate],
    ) -> Option<Vec<f64>> {
        let fits = || candidates.iter().filter(|it| it.numbering == numbering);
        let fit = |law: LawKind, medium: usize, missed: usize| {
            fits().find(|it| (it.law, it.medium, it.missed_first) == (law, medium, missed))
        };
        let from = |it: &Candidate| self.start_from(model, it);
        let first = fits().next()?.law;
        let first_here = fit(first, medium, model.missed_first).map(from);
        // Fit of the first law here + (fit of this law - fit of the first law) there.
        let moved = |other: &Candidate| {
            let start = first_here.clone()?.into_iter();
            let first_there = from(fit(first, other.medium, other.missed_first)?);
            let by = from(other).into_iter().zip(first_there);
            Some(
                start
                    .zip(by)
                    .map(|(start, (to, from))| start + (to - from))
                    .collect(),
            )
        };
        let of_law = || fits().filter(|it| it.law == model.law);
        let as_many_missed = of_law().find(|it| it.missed_first == model.missed_first);
        let other = as_many_missed.or_else(|| of_law().next_back());
        let (moved, itself) = (other.and_then(moved), other.map(from));
        if as_many_missed.is_some() {
            return moved.or(itself);
        }
        let starts = [first_here.clone(), moved, itself];
        let mut starts: Vec<Vec<f64>> = starts.into_iter().flatten().collect();
        if first_here.is_none() {
            starts.push(model.start());
        }
        Some(model.most_probable(starts))
    }

    /// Start of a search by the fit of a candidate.
    fn start_from(&self, model: &Model, fitted: &Candidate) -> Vec<f64> {
        model.start_from(&self.model(fitted), fitted.fit.vector.as_slice())
    }

    /// Logarithm of the prior probability of a candidate, but for a constant.
    pub(super) fn log_prior(&self, candidate: &Candidate) -> f64 {
        let observed = &self.numberings[candidate.numbering].observed;
        candidate.missed_first as f64 * LN_MISSED_FIRST
            + self.undetected(candidate) as f64 * LN_UNDETECTED
            + observed.missed() as f64 * LN_MISSED
            + match observed.other_sound {
                None => self.ln_odd_second,
                Some(_) => observed.ln_other_sound(),
            }
    }

    /// The fit of the most probable candidate; `None` if it is not valid.
    pub(super) fn best_fit(&self) -> Option<BestFit> {
        let candidate = self.candidates.first()?;
        Self::drop_at(&self.model(candidate), candidate.fit.vector.as_slice())
    }

    /// The drop of some draws, evenly spaced, of the ball and the number of missed first impacts that are most probable.
    pub(super) fn some_draws(&self, count: usize) -> Vec<BestFit> {
        let Some(best) = self.candidates.first() else {
            return Vec::new();
        };
        let alike = |draw: &Draw<'_>| {
            let candidate = &self.candidates[draw.candidate];
            (candidate.medium, candidate.missed_first) == (best.medium, best.missed_first)
        };
        let draws: Vec<Draw<'_>> = self.draws.iter().filter(alike).collect();
        let every = draws.len().div_ceil(count).max(1);
        let some = draws.into_iter().step_by(every);
        some.filter_map(|draw| {
            let model = self.model(&self.candidates[draw.candidate]);
            Self::drop_at(&model, draw.vector)
        })
        .collect()
    }

    fn drop_at(model: &Model<'_>, vector: &[f64]) -> Option<BestFit> {
        let point = model.point(vector)?;
        Some(BestFit {
            law: point.law,
            drop_height_m: model.drop_height_m(&point)?,
            drag_scale: point.drag_scale,
            contact_time_s: point.contact_time_s,
        })
    }

    /// The ball of a candidate, by the index of the candidate, in its air.
    pub(super) fn medium_of(&self, candidate: usize) -> &Medium {
        &self.media[self.candidates[candidate].medium]
    }

    /// Logarithm of the evidence of a kind of ball, but for a constant of the times; -∞ if it explains nothing.
    pub(super) fn log_evidence_of_ball(&self, kind: &str) -> f64 {
        let of_kind = |candidate: &&Candidate| self.media[candidate.medium].kind == kind;
        ln_sum(self.candidates.iter().filter(of_kind))
    }

    /// Frees the memory of the flights, which is that of the draws again; they are computed anew when they are needed.
    pub(super) fn forget_flights(&mut self) {
        for medium in &mut self.media {
            medium.flights.forget();
        }
        for flights in self.numberings.iter_mut().flat_map(|it| &mut it.flights) {
            flights.forget();
        }
    }

    /// The innovations at the best fit of the best candidate.
    pub(super) fn innovations(&self) -> Vec<Innovation> {
        let candidate = &self.candidates[0];
        let model = self.model(candidate);
        let details = model.details(candidate.fit.vector.as_slice());
        // A fit that is not valid has none.
        details.map_or_else(Vec::new, |details| details.innovations)
    }

    /// Speeds of the impacts that were followed by a flight, at the best fit of the best candidate.
    pub(super) fn fitted_speeds(&self) -> FittedSpeeds {
        let rough = &self.reference.speeds;
        self.fitted_ends().unwrap_or(FittedSpeeds {
            first_m_s: rough.fastest_m_s,
            slowest_m_s: rough.slowest_m_s,
            fastest_m_s: rough.fastest_m_s,
        })
    }

    fn fitted_ends(&self) -> Option<FittedSpeeds> {
        let candidate = &self.candidates[0];
        let model = self.model(candidate);
        let point = model.point(candidate.fit.vector.as_slice())?;
        let ends = model.evaluate(&[point])?.ends;
        let (_, left) = ends.split_last()?;
        let speeds = || left.iter().map(|end| end.log_impact.0[0].exp());
        Some(FittedSpeeds {
            first_m_s: speeds().next()?,
            slowest_m_s: speeds().fold(f64::INFINITY, f64::min),
            fastest_m_s: speeds().fold(0.0, f64::max),
        })
    }
}

/// Each ball that can be dropped so, and the speeds by the first of them.
///
/// # Errors
/// The error of the first ball, if none of the balls can be dropped so.
fn media(
    balls: &[PossibleBall],
    environment: &Environment,
    observed: &Observed,
    priors: &Priors,
) -> Result<(Vec<Medium>, ReferenceSpeed)> {
    let tried = balls.iter().map(|possible| {
        observed.check_contact_time(possible.known.contact_time_s)?;
        let medium = Medium::new(possible, environment, observed, priors)?;
        let reference = ReferenceSpeed::new(observed, &medium)?;
        Ok((medium, reference))
    });
    let (mut media, mut first, mut refused) = (Vec::new(), None, None);
    for tried in tried {
        match tried {
            Ok((medium, reference)) => {
                media.push(medium);
                first.get_or_insert(reference);
            }
            Err(reason) => {
                refused.get_or_insert(reason);
            }
        }
    }
    let none_fits = || refused.unwrap_or(Error::CannotInfer(InferenceFailure::NoModelFits));
    first
        .map(|reference| (media, reference))
        .ok_or_else(none_fits)
}

/// The highest evidence of the candidates.
pub(super) fn best_evidence<'a>(candidates: impl IntoIterator<Item = &'a Candidate>) -> f64 {
    let evidences = candidates
        .into_iter()
        .map(|candidate| candidate.log_evidence);
    evidences.fold(f64::NEG_INFINITY, f64::max)
}

/// Maximum number of missed impacts before the first one detected: that which may explain the times of another ball,
/// if one has been fitted.
fn max_missed_first(law: LawKind, numbering: usize, candidates: &[Candidate]) -> usize {
    let alike = |candidate: &&Candidate| candidate.law == law && candidate.numbering == numbering;
    let alike = || candidates.iter().filter(alike);
    let best = best_evidence(alike());
    let possible = alike().rfind(|candidate| candidate.log_evidence >= best - 2.0 * PRUNE_BELOW);
    possible.map_or(MAX_MISSED_FIRST, |candidate| candidate.missed_first)
}

/// The highest log posterior of the fits of a numbering.
fn highest_posterior(candidates: &[Candidate], numbering: usize) -> f64 {
    candidates
        .iter()
        .filter(|candidate| candidate.numbering == numbering)
        .map(|candidate| candidate.fit.log_posterior)
        .fold(f64::NEG_INFINITY, f64::max)
}

/// Logarithm of the sum of the evidences.
pub(super) fn ln_sum<'a>(candidates: impl IntoIterator<Item = &'a Candidate> + Clone) -> f64 {
    let best = best_evidence(candidates.clone());
    let relative = candidates
        .into_iter()
        .map(|it| (it.log_evidence - best).exp());
    best + relative.sum::<f64>().ln()
}

/// Sorts by evidence, and turns evidence into probability. If the ball was not stated, each ball that the times allow is
/// as probable as the others: which laws and errors surfaces have is not known well enough for odds between balls.
pub(super) fn weigh(candidates: &mut [Candidate]) {
    sort_by_number(candidates, |candidate| -candidate.log_evidence);
    let balls: BTreeSet<usize> = candidates
        .iter()
        .map(|candidate| candidate.medium)
        .collect();
    let its = |ball: usize| candidates.iter().filter(move |it| it.medium == ball);
    let evidences: BTreeMap<usize, f64> =
        balls.into_iter().map(|it| (it, ln_sum(its(it)))).collect();
    let most = evidences
        .values()
        .copied()
        .fold(f64::NEG_INFINITY, f64::max);
    let is_allowed = |evidence: f64| evidence >= most - ALLOWED_BALL;
    let allowed = evidences.values().filter(|evidence| is_allowed(**evidence));
    let share = 1.0 / allowed.count().max(1) as f64;
    for candidate in candidates {
        let of_ball = evidences[&candidate.medium];
        candidate.weight = if is_allowed(of_ball) {
            (candidate.log_evidence - of_ball).exp() * share
        } else {
            0.0
        };
    }
}

/// Number of balls that the times allow; 1 if the ball was stated.
pub(super) fn allowed_balls(candidates: &[Candidate]) -> usize {
    let weighing = candidates.iter().filter(|candidate| candidate.weight > 0.0);
    let balls: BTreeSet<usize> = weighing.map(|candidate| candidate.medium).collect();
    balls.len().max(1)
}
