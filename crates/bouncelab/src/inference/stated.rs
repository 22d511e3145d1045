//! What was stated of the fall, held against the times and the sound.
//!
//! A height or a release that is wrong either leaves a gap to the first flight, or needs impacts before the first one
//! detected. These were faster and so as loud: where the recording was quiet, there were none.

use super::candidates::{Candidate, SampledPosterior};
use super::parameters::{CONTRADICTION_SDS, UNKNOWN};
use super::priors::{Measured, Priors};
use super::residual::{InitialFall, missed_before_s};
use crate::ball::Ball;
use crate::diagnostic::{Code, Diagnostic};
use crate::error::Result;
use crate::flight::Environment;
use crate::impact::Impact;

impl SampledPosterior {
    /// Fits every model, without what was stated of the fall and is contradicted, and reports that.
    ///
    /// # Errors
    /// Those of [`Self::fitted_only`].
    pub(super) fn fitted_to_what_holds(
        impacts: &[Impact],
        ball: &Ball,
        environment: &Environment,
        contact_time_s: f64,
        priors: &Priors,
    ) -> Result<Self> {
        let fitted =
            |priors: &Priors| Self::fitted_only(impacts, ball, environment, contact_time_s, priors);
        let mut posterior = fitted(priors)?;
        for fewer in with_less_stated(priors) {
            if !posterior.contradicts_what_was_stated() {
                break;
            }
            posterior = fitted(&fewer)?;
        }
        posterior.contradictions = posterior.contradictions_to(priors);
        Ok(posterior)
    }

    /// Number of impacts before the first one detected that a candidate needs in a time in which none was heard.
    pub(super) fn unheard(&self, candidate: &Candidate) -> usize {
        let model = self.model(candidate);
        let quiet_s = model.observed.impacts[0].quiet_before_s;
        let unheard = |quiet_s: f64| {
            let point = model.point(candidate.fit.vector.as_slice())?;
            let table = model.table(&point)?;
            let before_s = missed_before_s(&table, &point, candidate.missed_first)?;
            Some(before_s.filter(|before_s| *before_s < quiet_s).count())
        };
        quiet_s
            .filter(|_| candidate.missed_first > 0)
            .and_then(unheard)
            .unwrap_or(0)
    }

    /// Whether even the most probable number of missed impacts needs unheard ones, or leaves a gap between what was stated
    /// and the first flight. The gap shows in the first innovations, or as a height far from the stated one.
    fn contradicts_what_was_stated(&self) -> bool {
        let candidate = &self.candidates[0];
        let first = self.innovations().into_iter().filter(|it| it.impact == 0);
        let gap = first.map(|it| it.standardised.abs()).fold(0.0, f64::max);
        let model = self.model(candidate);
        let height_m = model
            .point(candidate.fit.vector.as_slice())
            .and_then(|point| model.drop_height_m(&point));
        let off = |stated: Measured| Some(((height_m? - stated.value) / stated.sd).abs());
        let off = self.priors.drop_height_m.and_then(off).unwrap_or(0.0);
        self.unheard(candidate) > 0 || off.max(gap) > CONTRADICTION_SDS
    }

    /// A diagnostic for the height and for the release, if it was stated and is left out here.
    fn contradictions_to(&self, stated: &Priors) -> Vec<Diagnostic> {
        let (height_m, release_s) = (stated.drop_height_m, stated.release_s);
        let mut contradictions = Vec::new();
        let candidate = &self.candidates[0];
        let model = self.model(candidate);
        let Some(point) = model.point(candidate.fit.vector.as_slice()) else {
            return contradictions;
        };
        if let (Some(height), None, Some(detected_m)) = (
            height_m,
            self.priors.drop_height_m,
            model.drop_height_m(&point),
        ) {
            // A height from a flight time goes as gravity.
            let gravity_m_s2 = self.environment.gravity_m_s2 * height.value / detected_m;
            contradictions.push(
                Diagnostic::new(Code::HeightContradictsTimes)
                    .with("measured_m", height.value)
                    .with("detected_m", detected_m)
                    .with("gravity_m_s2", gravity_m_s2),
            );
        }
        let fall = model
            .table(&point)
            .and_then(|table| InitialFall::new(&table, &point, candidate.missed_first));
        if let (Some(release), None, Some(fall)) = (release_s, self.priors.release_s, fall) {
            let first_s = self.observed().impacts[0].time_s;
            contradictions.push(
                Diagnostic::new(Code::ReleaseContradictsTimes)
                    .with("stated_s", first_s - release.value)
                    .with("detected_s", fall.time_s),
            );
        }
        contradictions
    }
}

/// The same priors without the height, without the release, and without both, as far as they are stated. A height
/// determines an unknown gravity, so that nothing contradicts it.
fn with_less_stated(priors: &Priors) -> Vec<Priors> {
    let (height, release) = (priors.drop_height_m, priors.release_s);
    let [without_height, without_release, without_both] =
        [(None, release), (height, None), (None, None)].map(|(drop_height_m, release_s)| Priors {
            drop_height_m,
            release_s,
            ..priors.clone()
        });
    match (height, release) {
        _ if priors.gravity_rel_sd >= UNKNOWN => Vec::new(),
        (Some(_), Some(_)) => vec![without_height, without_release, without_both],
        (None, None) => Vec::new(),
        _ => vec![without_both],
    }
}
