//! The best fit of a model, and its curvature.

use nalgebra::{Cholesky, DMatrix, DVector};

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

/// A step is halved at most so often before the search ends where it is.
const MOST_HALVES: usize = 10;

/// Finds the best fit by Fisher scoring: Newton's method with the expected curvature, which is that of
/// a least-squares fit with weights (M. R. Osborne, Int. Stat. Rev. 60, 99, 1992).
///
/// `None` if no vector near the start makes sense.
pub(super) fn best_fit(model: &Model, start: Vec<f64>) -> Option<Fit> {
    let mut vector = DVector::from_vec(start);
    let mut log_posterior = model.log_posterior(vector.as_slice())?;
    let mut steps = 0;
    loop {
        let (slope, information) = model.slope_and_information(vector.as_slice())?;
        let information = Cholesky::new(information)?;
        let step = information.solve(&slope);
        let better = if slope.dot(&step) < NEAR * NEAR || steps == MOST_STEPS {
            None
        } else {
            uphill(model, &vector, step, log_posterior)
        };
        let Some(better) = better else {
            return Some(Fit {
                covariance: information.inverse(),
                vector,
                log_posterior,
            });
        };
        (vector, log_posterior) = better;
        steps += 1;
    }
}

/// The vector after a step, or the greatest part of it that leads to a better fit, and its log posterior.
fn uphill(
    model: &Model,
    from: &DVector<f64>,
    mut step: DVector<f64>,
    log_posterior: f64,
) -> Option<(DVector<f64>, f64)> {
    for _ in 0..MOST_HALVES {
        let vector = from + &step;
        match model.log_posterior(vector.as_slice()) {
            Some(better) if better > log_posterior => return Some((vector, better)),
            _ => step *= 0.5,
        }
    }
    None
}
