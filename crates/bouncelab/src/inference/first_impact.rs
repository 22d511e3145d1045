//! Whether the first impact detected belongs to the drop.
//!
//! The drop height follows from the first flight. A click before the drop, or the last bounce of an earlier one, looks like a
//! first impact, and the flight from it fits the others badly. So the drop without it is a numbering of its own, weighed like
//! the others.

use super::candidates::{Candidate, SampledPosterior, ln_sum};
use super::observed::Observed;
use super::parameters::{
    DOUBTFUL_FIRST, LN_INTERVALS, LN_NORMAL, LN_OTHER_SOUND, MAX_ODD_SECOND, MIN_REST,
    ODD_SECOND_FALL, OTHER_SOUND_ALIKE,
};
use super::residual::missed_before_s;
use crate::diagnostic::{Code, Diagnostic};

impl Observed {
    /// The same without the first impact, if enough remain: that is another sound.
    pub(super) fn without_first(&self) -> Option<Self> {
        let (other, impacts) = self.impacts.split_first()?;
        (impacts.len() >= MIN_REST).then(|| Self {
            impacts: impacts.to_vec(),
            intervals: self.intervals[1..].to_vec(),
            sigma_s: self.sigma_s[1..].to_vec(),
            sigma_stated: self.sigma_stated,
            other_sound: Some(*other),
        })
    }

    /// Logarithm of the probability that a sound is left out, times the density of its time; 0 if none is.
    pub(super) fn ln_other_sound(&self) -> f64 {
        let Some(other) = self.other_sound else {
            return 0.0;
        };
        let interval_s = self.impacts[0].time_s - other.time_s;
        // Of the other sounds some are impacts of the same ball.
        let unlike = (1.0 - OTHER_SOUND_ALIKE) * (-other.ln_alike.unwrap_or(0.0)).exp();
        LN_OTHER_SOUND + (OTHER_SOUND_ALIKE + unlike).ln() - (LN_INTERVALS * interval_s).ln()
            + LN_NORMAL
    }
}

impl SampledPosterior {
    /// Whether a candidate leaves out the first impact detected.
    pub(super) fn leaves_out_first(&self, candidate: &Candidate) -> bool {
        self.numberings[candidate.numbering]
            .observed
            .other_sound
            .is_some()
    }

    /// Probability that the first impact detected is another sound.
    pub(super) fn first_is_other_sound(&self) -> f64 {
        let others = self
            .candidates
            .iter()
            .filter(|it| self.leaves_out_first(it));
        others.map(|candidate| candidate.weight).sum()
    }

    /// Removes the candidates that leave out the first impact if they are too improbable for an interval of 95 %. Otherwise
    /// makes them as probable as the others: how often first flights are odd is not known well enough for odds. Where they
    /// are more probable, an odd second impact explains a first flight up to a certain difference from the one expected;
    /// beyond it the odds return to those of the evidence.
    pub(super) fn weigh_first_impact(&mut self) {
        let (others, with_first): (Vec<&Candidate>, Vec<&Candidate>) = self
            .candidates
            .iter()
            .partition(|it| self.leaves_out_first(it));
        if with_first.is_empty() {
            return;
        }
        let ln_odds = ln_sum(others.iter().copied()) - ln_sum(with_first.iter().copied());
        let best = others
            .into_iter()
            .max_by(|a, b| a.log_evidence.total_cmp(&b.log_evidence));
        let too_far = best
            .filter(|_| ln_odds > (DOUBTFUL_FIRST / (1.0 - DOUBTFUL_FIRST)).ln())
            .and_then(|best| self.off_expected_first(best))
            .map(|off| (off.abs() - MAX_ODD_SECOND).max(0.0) / ODD_SECOND_FALL);
        let mut candidates = std::mem::take(&mut self.candidates);
        if let Some(too_far) = too_far {
            self.ln_odd_second = (ln_odds - too_far).max(ln_odds.min(0.0));
            let belonging = candidates
                .iter_mut()
                .filter(|it| !self.leaves_out_first(it));
            belonging.for_each(|candidate| candidate.log_evidence += self.ln_odd_second);
        } else {
            candidates.retain(|it| !self.leaves_out_first(it));
        }
        self.candidates = candidates;
    }

    /// Logarithm of the first flight over that which a candidate without it expects there.
    fn off_expected_first(&self, candidate: &Candidate) -> Option<f64> {
        let model = self.model(candidate);
        let other_s = model.observed.other_sound?.time_s;
        let point = model.point(candidate.fit.vector.as_slice())?;
        let table = model.table(&point)?;
        let expected_s = match candidate.missed_first {
            // The fall is the second half of the flight that would have come before.
            0 => {
                table.launch(point.fall_launch_m_s)?.time / point.gravity_m_s2
                    + point.contact_time_s
            }
            missed => missed_before_s(&table, &point, missed)?.next()?,
        };
        Some(((model.observed.impacts[0].time_s - other_s) / expected_s).ln())
    }

    /// A diagnostic if the first impact detected may be another sound.
    pub(super) fn doubt(&self) -> Option<Diagnostic> {
        let probability = self.first_is_other_sound();
        if probability < DOUBTFUL_FIRST {
            return None;
        }
        let mut candidates = self.candidates.iter();
        let without = candidates.find(|it| self.leaves_out_first(it))?;
        let model = self.model(without);
        let point = model.point(without.fit.vector.as_slice())?;
        Some(
            Diagnostic::new(Code::FirstImpactDoubtful)
                .with("time_s", model.observed.other_sound?.time_s)
                .with("probability", probability)
                .with("height_m", model.drop_height_m(&point)?),
        )
    }
}
