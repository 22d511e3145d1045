//! Hypotheses: what a sequence of onsets up to a pair of impacts predicts of the next impact, and its evidence.

use super::trend::Trend;
use crate::onset::Onset;
use crate::train::MIN_IMPACTS;
use crate::train::evidence::{self, Fall, Surroundings};
use crate::train::parameters::{
    FIRST_RATIO_DENSITY, LN_MISSED, MAX_LEARNT_SURPRISE, MAX_MISSED, MAX_SURPRISE,
    MIN_DULL_LN_RATIO, MIN_FIRST_FLIGHT_S, MIN_SCATTER, SCATTER_PRIOR_COUNT, SURFACES,
};

/// The hypothesis that a sequence of onsets is the impacts of a drop, and what was learnt from them.
#[derive(Clone, Copy)]
pub(super) struct Hypothesis {
    pub(super) evidence: f64,
    /// Logarithm of the last flight in seconds.
    ln_flight: f64,
    /// The square of the last flight, in s².
    flight2: f64,
    trend: Trend,
    /// Number of ratios of flights from which the trend was learnt.
    pub(super) ratios: u32,
    /// Variance of the ratios about their trend.
    pub(super) scatter2: f64,
}

/// The next interval that a hypothesis predicts.
#[derive(Clone, Copy)]
pub(super) struct Prediction {
    /// Logarithm of the interval over the last flight.
    ln_interval: f64,
    /// Logarithm of the last flight in the interval over the last flight.
    ln_last: f64,
}

/// A hypothesis with its predictions, which many steps share.
pub(super) struct State {
    pub(super) hypothesis: Hypothesis,
    /// Upper bound of the evidence that the next ratio can contribute.
    pub(super) max_ratio: f64,
    /// The predictions for 0, 1, 2 impacts missed in the interval.
    predictions: [Prediction; MAX_MISSED + 1],
}

/// A step from one onset to a later one.
pub(super) struct Step {
    pub(super) interval_s: f64,
    ln_interval: f64,
    /// Variance of `ln_interval` over the last flight due to the errors of the times.
    variance: f64,
    /// Evidence that does not depend on the hypothesis.
    pub(super) common: f64,
    /// The fall of the level, and the upper bound of the evidence that it can contribute.
    fall: Fall,
    pub(super) max_fall: f64,
}

/// A step of a chain, with the number of impacts missed in it.
pub(super) struct Transition {
    pub(super) from: usize,
    pub(super) step: Step,
    pub(super) missed: usize,
}

impl Step {
    pub(super) fn new(onsets: &[Onset], around: &[Surroundings], pair: (usize, usize)) -> Self {
        let (earlier, later) = (&onsets[pair.0], &onsets[pair.1]);
        let interval_s = later.time_s - earlier.time_s;
        let timing = earlier.sigma_s.powi(2) + later.sigma_s.powi(2);
        let similarity = around[pair.0].relative_similarity(&around[pair.1]);
        let fall = around[pair.0].fall(&around[pair.1]);
        Self {
            interval_s,
            ln_interval: interval_s.ln(),
            // The ratio has the errors of three times, (e1 - 2 e2 + e3)/T for nearly equal flights: three times the variance
            // of an interval if all are equal. Four times, to be on the safe side.
            variance: 4.0 * timing / interval_s.powi(2),
            common: (similarity * around[pair.1].by_chance(interval_s)).ln(),
            max_fall: fall.max_given_ratio().ln(),
            fall,
        }
    }
}

impl Hypothesis {
    /// The initial states: the first two impacts of a train, on a smooth and on a rough surface.
    pub(super) fn initial(step: &Step, around_first: &Surroundings) -> impl Iterator<Item = Self> {
        let by_chance = around_first.by_chance(step.interval_s).ln();
        let first_flight = evidence::ln_first_flight(step.interval_s);
        let evidence = around_first.ln_drop() + first_flight + step.common + by_chance;
        let ln_flight = step.ln_interval;
        let flight2 = step.interval_s * step.interval_s;
        let surfaces = if step.interval_s < MIN_FIRST_FLIGHT_S {
            &[]
        } else {
            SURFACES.as_slice()
        };
        surfaces.iter().map(move |surface| Self {
            evidence: evidence + surface.ln_prior,
            ln_flight,
            flight2,
            trend: Trend::default(),
            ratios: 0,
            scatter2: surface.scatter.powi(2),
        })
    }

    /// Number of impacts of the sequence that were detected.
    pub(super) fn impacts(&self) -> usize {
        self.ratios as usize + 2
    }

    /// Logarithm of the next flight over the last.
    pub(super) fn ln_ratio(&self) -> f64 {
        self.trend.ln_ratio(self.flight2)
    }

    /// The predictions for 0, 1, 2... impacts missed in the next interval.
    fn predictions(&self) -> impl Iterator<Item = Prediction> {
        // In units of the last flight: the latest flight, the time until its end, and the logarithm of the flight.
        let (mut flight, mut time, mut ln_last) = (1.0, 0.0, 0.0);
        (0..).map(move |missed| {
            ln_last += self.trend.ln_ratio(self.flight2 * flight * flight);
            flight = ln_last.exp();
            time += flight;
            let ln_interval = if missed == 0 { ln_last } else { time.ln() };
            Prediction {
                ln_interval,
                ln_last,
            }
        })
    }

    /// The hypothesis one impact later, if its evidence exceeds `min_evidence`.
    fn next(
        &self,
        step: &Step,
        missed: usize,
        prediction: Prediction,
        min_evidence: f64,
    ) -> Option<Self> {
        let change = step.ln_interval - self.ln_flight;
        if self.ratios == 0 {
            // Without a ratio nothing predicts a missed impact.
            return if missed == 0 {
                self.third(step, change, min_evidence)
            } else {
                None
            };
        }
        let surprise = change - prediction.ln_interval;
        // The flights of a dull ball become too short to be heard before it has the impacts of a drop.
        let is_beyond = self.trend.is_dull() && (missed > 0 || self.impacts() + 1 >= MIN_IMPACTS);
        if surprise.abs() > MAX_SURPRISE || is_beyond {
            return None;
        }
        // The level follows the ratio of the flights before the two impacts: measured, or if impacts were missed, predicted.
        let ln_fall = if missed == 0 {
            change
        } else {
            prediction.ln_last
        };
        let variance = self.variance(step);
        let ratio = evidence::next_ratio(change, surprise, variance);
        let evidence = self.evidence
            + step.common
            + (ratio * step.fall.given_ratio(ln_fall)).ln()
            + missed as f64 * LN_MISSED;
        (evidence > min_evidence).then(|| {
            let scatter2 = self.learn(surprise, variance);
            // The last flight in the interval, as the prediction divides it.
            let last = prediction.ln_last - prediction.ln_interval;
            let ln_flight = step.ln_interval + last;
            Self {
                evidence,
                ln_flight,
                flight2: (2.0 * ln_flight).exp(),
                trend: self.trend.learn(surprise, variance, self.flight2, scatter2),
                ratios: self.ratios + 1,
                scatter2,
            }
        })
    }

    /// The third impact: it sets the ratio.
    fn third(&self, step: &Step, change: f64, min_evidence: f64) -> Option<Self> {
        // No flight is longer than the one before, but for the errors of the times.
        if !(MIN_DULL_LN_RATIO..=step.variance.sqrt()).contains(&change) {
            return None;
        }
        let evidence = self.evidence
            + step.common
            + evidence::ln_first_ratio(change, self.ln_flight)
            + step.fall.given_ratio(change).ln();
        (evidence > min_evidence).then(|| Self {
            evidence,
            ln_flight: step.ln_interval,
            flight2: step.interval_s * step.interval_s,
            trend: Trend::new(change, self.flight2, self.scatter2),
            ratios: 1,
            scatter2: self.scatter2,
        })
    }

    /// Log density of the interval of a transition for a ball, without regard to other explanations.
    pub(super) fn ln_density(&self, transition: &Transition) -> Option<f64> {
        if self.ratios == 0 {
            return Some(FIRST_RATIO_DENSITY.ln());
        }
        let change = transition.step.ln_interval - self.ln_flight;
        let prediction = self.predictions().nth(transition.missed)?;
        let surprise = change - prediction.ln_interval;
        let variance = self.variance(&transition.step);
        Some(evidence::ln_ratio(surprise, variance))
    }

    /// Variance of the predicted ratio: errors of the times, scatter, and the uncertainty of the trend.
    fn variance(&self, step: &Step) -> f64 {
        step.variance + self.scatter2 + self.trend.variance(self.flight2)
    }

    /// The scatter after a surprise whose variance was `variance`.
    fn learn(&self, surprise: f64, variance: f64) -> f64 {
        let counts = SCATTER_PRIOR_COUNT + f64::from(self.ratios - 1);
        // The part of the squared surprise that the scatter explains, in proportion to its share of the variance.
        let share = self.scatter2 / variance;
        let max_learnt = MAX_LEARNT_SURPRISE * MAX_LEARNT_SURPRISE * self.scatter2;
        let observed = (surprise * surprise * share).min(max_learnt);
        // The mean of the squares, in which the prior counts as several of them.
        ((counts * self.scatter2 + observed) / (counts + 1.0)).max(MIN_SCATTER.powi(2))
    }

    /// The hypothesis after a transition, however small its evidence.
    pub(super) fn after(&self, transition: &Transition) -> Option<Self> {
        if transition.missed > MAX_MISSED {
            return None;
        }
        let prediction = self.predictions().nth(transition.missed)?;
        self.next(
            &transition.step,
            transition.missed,
            prediction,
            f64::NEG_INFINITY,
        )
    }

    /// The hypothesis after several transitions.
    pub(super) fn after_all(self, transitions: &[Transition]) -> Option<Self> {
        let mut transitions = transitions.iter();
        transitions.try_fold(self, |hypothesis, transition| hypothesis.after(transition))
    }
}

impl State {
    pub(super) fn new(hypothesis: Hypothesis) -> Self {
        let mut predictions = [Prediction {
            ln_interval: 0.0,
            ln_last: 0.0,
        }; MAX_MISSED + 1];
        let max_ratio = if hypothesis.ratios == 0 {
            FIRST_RATIO_DENSITY
        } else {
            for (own, prediction) in predictions.iter_mut().zip(hypothesis.predictions()) {
                *own = prediction;
            }
            evidence::max_next_ratio(hypothesis.scatter2)
        };
        Self {
            hypothesis,
            max_ratio: max_ratio.ln(),
            predictions,
        }
    }

    /// The hypothesis one impact later, if its evidence exceeds `min_evidence`.
    pub(super) fn next(&self, step: &Step, missed: usize, min_evidence: f64) -> Option<Hypothesis> {
        let prediction = self.predictions[missed];
        self.hypothesis.next(step, missed, prediction, min_evidence)
    }
}
