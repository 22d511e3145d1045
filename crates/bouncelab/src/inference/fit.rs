//! The best fit of a model, and its curvature.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

use super::likelihood::Differences;
use super::parameters::{
    LARGE_GAIN, MAX_FIT_STEPS, MAX_GAIN_OVER_PROMISE, NEAR_SDS, SHORT_STEP, SMALL_GAIN,
    STEP_FRACTIONS,
};
use super::unknowns::{ExpectedRestitution, Model, Slot};

/// The best vector of a model and the curvature there.
#[derive(Debug, Clone)]
pub(super) struct Fit {
    pub(super) vector: DVector<f64>,
    /// Logarithm of prior times likelihood there.
    pub(super) log_posterior: f64,
    /// Covariance of the normal distribution with the curvature of the posterior there.
    pub(super) covariance: DMatrix<f64>,
}

impl Fit {
    /// Logarithm of the evidence in Laplace's approximation, as if the posterior were normal.
    pub(super) fn log_laplace_evidence(&self) -> f64 {
        let scaled = &self.covariance * (2.0 * std::f64::consts::PI);
        self.log_posterior + 0.5 * scaled.determinant().ln()
    }

    /// The restitution that is expected given the unknowns that impacts hardly determine, and its index in the vector: the
    /// regression of its logit on each of them. They are as independent of each other as before the data.
    pub(super) fn expected_restitution(
        &self,
        model: &Model,
    ) -> Option<(usize, ExpectedRestitution)> {
        let index = model.index(Slot::Restitution)?;
        let by = ExpectedRestitution::BY.map(|slot| model.index(slot));
        let slope = |by: usize| self.covariance[(index, by)] / self.covariance[(by, by)];
        let moved = by.iter().flatten().map(|&by| slope(by) * self.vector[by]);
        let expected = ExpectedRestitution {
            logit: self.vector[index] - moved.sum::<f64>(),
            slopes: by.map(|by| by.map_or(0.0, slope)),
        };
        Some((index, expected))
    }
}

/// A vector of the search, with the posterior there.
struct Iterate {
    vector: DVector<f64>,
    log_posterior: f64,
    slope: DVector<f64>,
    /// The expected information there.
    expected: Cholesky<f64, Dyn>,
}

impl Iterate {
    /// `None` if the vector is not valid.
    fn new(model: &Model, vector: DVector<f64>) -> Option<Self> {
        let Differences {
            point,
            details,
            residuals,
            log_posterior,
            slope,
        } = model.differences(vector.as_slice())?;
        let information = model.information(vector.as_slice(), &point, residuals, &details);
        Some(Self {
            vector,
            log_posterior,
            slope,
            expected: Cholesky::new(information)?,
        })
    }

    /// The vector after the best fraction of a step; `None` if none of them leads uphill.
    fn uphill(&self, model: &Model, step: &DVector<f64>) -> Option<DVector<f64>> {
        let tried = DMatrix::from_fn(step.len(), STEP_FRACTIONS.len(), |unknown, index| {
            self.vector[unknown] + STEP_FRACTIONS[index] * step[unknown]
        });
        let found = model.log_posteriors(&tried).into_iter().enumerate();
        let found = found.filter_map(|(index, log)| Some((index, log?)));
        let (index, highest) = found.max_by(|(_, a), (_, b)| a.total_cmp(b))?;
        (highest > self.log_posterior).then(|| tried.column(index).into_owned())
    }
}

/// Finds the best fit by Fisher scoring: Newton's method with the expected curvature, which is that of
/// a least-squares fit with weights (M. R. Osborne, Int. Stat. Rev. 60, 99, 1992), corrected by the
/// real curvature along earlier steps.
///
/// A search that would end below the log posterior `least` ends early, where it is. `None` if no vector near the start is
/// valid.
pub(super) fn best_fit(model: &Model, start: Vec<f64>, least: f64) -> Option<Fit> {
    let mut here = Iterate::new(model, DVector::from_vec(start))?;
    let mut secants = Secants::default();
    for _ in 0..MAX_FIT_STEPS {
        let expected = here.expected.solve(&here.slope);
        let promise = here.slope.dot(&expected);
        if promise > LARGE_GAIN {
            secants = Secants::default();
        }
        if here.log_posterior + MAX_GAIN_OVER_PROMISE * promise < least {
            break;
        }
        if promise < NEAR_SDS * NEAR_SDS {
            here.log_posterior += 0.5 * promise;
            here.vector += expected;
            break;
        }
        let step = secants.corrected(&here.expected, &here.slope);
        let whole = (promise < SMALL_GAIN).then(|| Iterate::new(model, &here.vector + &step));
        let higher = |it: &Iterate| it.log_posterior > here.log_posterior;
        let next = if let Some(next) = whole.flatten().filter(higher) {
            next
        } else {
            let steps = [&step, &expected, &(SHORT_STEP * &expected)];
            let Some(next) = steps.into_iter().find_map(|step| here.uphill(model, step)) else {
                break;
            };
            Iterate::new(model, next)?
        };
        secants.add(&next.vector - &here.vector, &here.slope - &next.slope);
        here = next;
    }
    Some(Fit {
        covariance: here.expected.inverse(),
        vector: here.vector,
        log_posterior: here.log_posterior,
    })
}

/// Steps of a search, each with the decrease of the slope along it: they correct an expected curvature (the recursion of
/// limited-memory BFGS, D. C. Liu and J. Nocedal, Math. Program. 45, 503, 1989; the steps near a maximum are so few
/// that all are kept).
#[derive(Default)]
struct Secants(Vec<Secant>);

struct Secant {
    step: DVector<f64>,
    fall: DVector<f64>,
}

impl Secants {
    fn add(&mut self, step: DVector<f64>, fall: DVector<f64>) {
        // Where the slope grows along a step the posterior is not concave.
        if step.dot(&fall) <= 0.0 {
            return;
        }
        self.0.push(Secant { step, fall });
    }

    /// The step to the maximum by the corrected curvature: the two loops of the recursion, with the expected curvature
    /// between them.
    fn corrected(&self, expected: &Cholesky<f64, Dyn>, slope: &DVector<f64>) -> DVector<f64> {
        let mut left = slope.clone();
        let mut parts = Vec::with_capacity(self.0.len());
        for Secant { step, fall } in self.0.iter().rev() {
            let part = step.dot(&left) / step.dot(fall);
            left.axpy(-part, fall, 1.0);
            parts.push(part);
        }
        let mut corrected = expected.solve(&left);
        for (Secant { step, fall }, part) in self.0.iter().zip(parts.into_iter().rev()) {
            let taken = fall.dot(&corrected) / step.dot(fall);
            corrected.axpy(part - taken, step, 1.0);
        }
        corrected
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::inference::likelihood::tests::{impacts, with_model};
    use crate::inference::priors::Priors;
    use crate::inference::unknowns::Point;
    use crate::restitution::LawKind;
    use crate::simd::Lanes;

    /// The log posterior at the best fit is the one reported, and a step to either side of each unknown leads down.
    #[test]
    fn nothing_around_the_best_fit_is_better() {
        with_model(&impacts(), |model, _| {
            let fit = best_fit(model, model.start(), f64::NEG_INFINITY).unwrap();
            let unknowns = fit.vector.len();
            let around = DMatrix::from_fn(unknowns, 2 * unknowns + 1, |unknown, column| {
                let step = 0.3 * fit.covariance[(unknown, unknown)].sqrt();
                let moved = unknown == column % unknowns && column < 2 * unknowns;
                let sign = if column < unknowns { step } else { -step };
                fit.vector[unknown] + if moved { sign } else { 0.0 }
            });
            let mut logs = model.log_posteriors(&around);
            let there = logs.pop().flatten().unwrap();
            assert!((there - fit.log_posterior).abs() < 1e-3);
            for log in logs {
                assert!(log.unwrap() < there - 0.01);
            }
        });
    }

    /// The same restitution in units of the noise is the same point, and as probable but for the unit.
    #[test]
    fn a_restitution_in_units_of_the_noise_is_as_probable() {
        with_model(&impacts(), |model, _| {
            let fit = best_fit(model, model.start(), f64::NEG_INFINITY).unwrap();
            let (index, expected) = fit.expected_restitution(model).unwrap();
            let counted = model.clone().with_expected_restitution(Some(expected));
            let shifted = fit.vector.map(|value| value + 0.3);
            let point = model.point(shifted.as_slice()).unwrap();
            let by = ExpectedRestitution::BY.into_iter().zip(expected.slopes);
            let by = by.map(|(slot, slope)| slope * shifted[model.index(slot).unwrap()]);
            let middle = model.observed.intervals.len() / 2;
            let [unit] = model
                .noise(middle, Lanes([point.scatter]), Lanes([point.timing]))
                .0;
            let mut in_units = shifted.clone();
            in_units[index] = (shifted[index] - expected.logit - by.sum::<f64>()) / unit;
            let same = counted.point(in_units.as_slice()).unwrap();
            let e = |point: &Point| point.law.at(model.reference.speeds.reference_m_s);
            assert!((e(&same) / e(&point) - 1.0).abs() < 1e-12);
            assert!((same.fall_launch_m_s / point.fall_launch_m_s - 1.0).abs() < 1e-12);
            let log = |model: &Model, vector: &DVector<f64>| {
                let vector = DMatrix::from_column_slice(vector.len(), 1, vector.as_slice());
                model.log_posteriors(&vector)[0].unwrap()
            };
            let gained = log(&counted, &in_units) - log(model, &shifted);
            assert!((gained - unit.ln()).abs() < 1e-9, "{gained}");
        });
    }

    /// Another law starts with the restitution of the fitted one at the reference speed, and with its slope if the law has a
    /// free slope.
    #[test]
    fn another_law_starts_with_the_same_restitution_and_slope() {
        with_model(&impacts(), |linear, vector| {
            let priors = Priors {
                release_s: linear.release_s,
                ..Priors::default()
            };
            let of_law = |law: LawKind| {
                let (observed, flights) = (linear.observed, linear.timed_flights);
                let (medium, reference) = (linear.medium, linear.reference);
                Model::new(observed, flights, medium, reference, law, 1, &priors)
            };
            let [power, constant] = [LawKind::Power, LawKind::Constant].map(of_law);
            let at_reference = |model: &Model, vector: &[f64]| {
                let law = model.point(vector).unwrap().law;
                law.at_with_log_slope(model.reference.speeds.reference_m_s)
            };
            let (e, log_slope) = at_reference(linear, vector);
            assert!(log_slope < -0.01);
            let as_power = power.start_from(linear, vector);
            let back = linear.start_from(&power, &as_power);
            for found in [at_reference(&power, &as_power), at_reference(linear, &back)] {
                assert!((found.0 - e).abs() < 1e-12 && (found.1 - log_slope).abs() < 1e-12);
            }
            let as_constant = constant.start_from(linear, vector);
            let (same, flat) = at_reference(&constant, &as_constant);
            assert!((same - e).abs() < 1e-12 && flat == 0.0);
        });
    }

    /// After a step the corrected curvature reproduces the decrease of the slope along it (the secant equation), whatever
    /// was expected; without a step it is the expected one.
    #[test]
    fn a_corrected_step_knows_the_last_one() {
        let expected = Cholesky::new(DMatrix::identity(3, 3)).unwrap();
        let vector = |values: [f64; 3]| DVector::from_column_slice(&values);
        let mut secants = Secants::default();
        let slope = vector([1.0, 2.0, 3.0]);
        assert_eq!(secants.corrected(&expected, &slope), slope);
        secants.add(vector([1.0, 0.0, 0.5]), vector([4.0, 1.0, 0.0]));
        let (step, fall) = (vector([0.1, 0.3, -0.2]), vector([0.3, 0.9, -0.1]));
        secants.add(step.clone(), fall.clone());
        secants.add(vector([1.0, 0.0, 0.0]), vector([-1.0, 0.0, 0.0]));
        assert!((secants.corrected(&expected, &fall) - step).norm() < 1e-12);
    }
}
