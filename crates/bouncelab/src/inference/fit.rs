//! The best fit of a model, and its curvature.

use nalgebra::{Cholesky, DMatrix, DVector, Dyn};

use super::model::Model;

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
    /// Logarithm of the evidence, were the posterior normal.
    pub(super) fn log_laplace_evidence(&self) -> f64 {
        let scaled = &self.covariance * (2.0 * std::f64::consts::PI);
        self.log_posterior + 0.5 * scaled.determinant().ln()
    }
}

/// Distance from the best fit, in standard deviations, at which the search ends. The sampling would
/// mind less, but so the end does not depend on the way there, and the answer not on the last bit of a
/// machine's arithmetic.
const NEAR: f64 = 1e-3;

const MOST_STEPS: usize = 40;

/// Parts of a step that are tried: side by side they take little longer than one.
const PARTS: [f64; 8] = [
    1.0 / 64.0,
    1.0 / 32.0,
    1.0 / 16.0,
    0.125,
    0.25,
    0.5,
    1.0,
    2.0,
];

/// Where none of them leads uphill, so much shorter ones are tried: far from the maximum the expected curvature may be that
/// of another place.
const SHORT: f64 = 1.0 / 256.0;

/// A step that promises more than this of the log posterior starts too far away for the steps before to tell of
/// the curvature at the maximum.
const LARGE_GAIN: f64 = 1.0;

/// Finds the best fit by Fisher scoring: Newton's method with the expected curvature, which is that of
/// a least-squares fit with weights (M. R. Osborne, Int. Stat. Rev. 60, 99, 1992), corrected by what the
/// steps before tell of the real one.
///
/// `None` if no vector near the start makes sense.
pub(super) fn best_fit(model: &Model, start: Vec<f64>) -> Option<Fit> {
    let mut vector = DVector::from_vec(start);
    let mut log_posterior = model.log_posterior(vector.as_slice())?;
    let mut secants = Secants::default();
    let (mut slope, information) = model.slope_and_information(vector.as_slice())?;
    let mut expected = Cholesky::new(information)?;
    for _ in 0..MOST_STEPS {
        let step = expected.solve(&slope);
        let promise = slope.dot(&step);
        if promise < NEAR * NEAR {
            break;
        }
        if promise > LARGE_GAIN {
            secants = Secants::default();
        }
        let corrected = secants.corrected(&expected, &slope);
        let better = uphill(model, &vector, &corrected, log_posterior)
            .or_else(|| uphill(model, &vector, &step, log_posterior))
            .or_else(|| uphill(model, &vector, &(SHORT * &step), log_posterior));
        let Some((next, better)) = better else {
            break;
        };
        let (next_slope, information) = model.slope_and_information(next.as_slice())?;
        secants.add(&next - &vector, &slope - &next_slope);
        expected = Cholesky::new(information)?;
        (vector, slope, log_posterior) = (next, next_slope, better);
    }
    Some(Fit {
        covariance: expected.inverse(),
        vector,
        log_posterior,
    })
}

/// Steps of a search, each with how much the slope fell along it: they correct an expected curvature (the recursion of
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
        // A slope that grows leads to no maximum.
        if step.dot(&fall) <= 0.0 {
            return;
        }
        self.0.push(Secant { step, fall });
    }

    /// The step that leads to the maximum by the expected curvature, corrected.
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

/// The vector after the best part of a step, and its log posterior; `None` if none of them leads uphill.
fn uphill(
    model: &Model,
    from: &DVector<f64>,
    step: &DVector<f64>,
    log_posterior: f64,
) -> Option<(DVector<f64>, f64)> {
    let tried = DMatrix::from_fn(from.len(), PARTS.len(), |unknown, place| {
        from[unknown] + PARTS[place] * step[unknown]
    });
    let mut best = None;
    let mut highest = log_posterior;
    for (place, found) in model.log_posteriors(&tried).into_iter().enumerate() {
        if let Some(found) = found.filter(|found| *found > highest) {
            (best, highest) = (Some(place), found);
        }
    }
    best.map(|place| (tried.column(place).into_owned(), highest))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// After a step the corrected curvature tells how much the slope fell along it (the secant equation), whatever
    /// was expected; without one it is the expected one.
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
