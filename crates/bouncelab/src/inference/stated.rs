//! What was stated of the fall, held against the times and the sound.
//!
//! A height or a release that is wrong either fits the first flight badly, or needs impacts before the first one detected.
//! These were faster and so as loud: where the recording was quiet, there were none. What was stated is left out if the times
//! are more probable when it is wrong.

use super::candidates::{Candidate, SampledPosterior};
use super::parameters::{
    LN_HEIGHTS, LN_NORMAL, LN_RELEASES, LN_STATED_WRONG, SAME_SOUND_S, UNKNOWN,
};
use super::priors::Priors;
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
        let mut likeliest = fitted(priors)?;
        let mut highest = likeliest.log_evidence();
        for (fewer, ln_prior) in with_less_stated(priors) {
            let other = fitted(&fewer)?;
            let log_evidence = other.log_evidence() + ln_prior;
            if log_evidence > highest {
                (likeliest, highest) = (other, log_evidence);
            }
        }
        likeliest.contradictions = likeliest.contradictions_to(priors);
        Ok(likeliest)
    }

    /// Number of impacts before the first one detected that a candidate needs in a time in which none was detected.
    pub(super) fn undetected(&self, candidate: &Candidate) -> usize {
        let model = self.model(candidate);
        let first = &model.observed.impacts[0];
        // If it is another sound, the time before that was as quiet.
        let first_sound = model.observed.other_sound.as_ref().unwrap_or(first);
        let since_s = first.time_s - first_sound.time_s;
        let undetected = |quiet_s: f64| {
            let point = model.point(candidate.fit.vector.as_slice())?;
            let table = model.table(&point)?;
            let before_s = missed_before_s(&table, &point, candidate.missed_first)?;
            let quiet_s = since_s + SAME_SOUND_S..since_s + quiet_s;
            Some(
                before_s
                    .filter(|before_s| quiet_s.contains(before_s))
                    .count(),
            )
        };
        let quiet_s = first_sound.quiet_before_s;
        quiet_s
            .filter(|_| candidate.missed_first > 0)
            .and_then(undetected)
            .unwrap_or(0)
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

/// The same priors without the height, without the release, and without both, as far as they are stated; each with the
/// logarithm of its prior probability, and of the density of a wrong number, but for the constants that the likelihood of one
/// that is used leaves out. A height determines an unknown gravity, so that nothing contradicts it.
fn with_less_stated(priors: &Priors) -> Vec<(Priors, f64)> {
    if priors.gravity_rel_sd >= UNKNOWN {
        return Vec::new();
    }
    let wrong = |ln_range: f64| LN_STATED_WRONG - ln_range + LN_NORMAL;
    let (height, release) = (priors.drop_height_m, priors.release_s);
    let (without_height, without_release) = (wrong(LN_HEIGHTS), wrong(LN_RELEASES));
    let fewer = [
        (None, release, without_height),
        (height, None, without_release),
        (None, None, without_height + without_release),
    ];
    let without = |(drop_height_m, release_s, ln_prior): (_, _, f64)| {
        let priors = Priors {
            drop_height_m,
            release_s,
            ..priors.clone()
        };
        (priors, ln_prior)
    };
    let used = match (height, release) {
        (None, None) => 0..0,
        (Some(_), None) => 0..1,
        (None, Some(_)) => 1..2,
        (Some(_), Some(_)) => 0..3,
    };
    fewer[used].iter().copied().map(without).collect()
}
