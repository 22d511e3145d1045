//! The best fit of a model, and how sharp it is.

use std::cell::RefCell;
use std::convert::Infallible;

use basin::{Bfgs, CostFunction, DenseMatrix, Executor, FirstOrderState, Gradient};
use nalgebra::{DMatrix, DVector};

use super::likelihood::Evaluator;
use super::model::{Model, Slot};

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

/// Where a vector makes no sense, the cost is this: far above any other, and finite, so that a line
/// search steps back from it.
const NOWHERE: f64 = 1e9;

/// Step of a central difference, as a share of the scale of the coordinate.
const DIFFERENCE: f64 = 1e-3;

struct Problem<'a, 'b> {
    evaluator: RefCell<&'b mut Evaluator<'a>>,
    /// Scale of each coordinate.
    scales: &'b [f64],
}

impl Problem<'_, '_> {
    fn cost_at(&self, vector: &[f64]) -> f64 {
        self.evaluator
            .borrow_mut()
            .log_posterior(vector)
            .map_or(NOWHERE, |log| -log)
    }

    /// Central differences; the cost of one is a table, and there are about ten.
    fn gradient_at(&self, vector: &[f64]) -> Vec<f64> {
        let mut moved = vector.to_vec();
        (0..vector.len())
            .map(|i| {
                let step = DIFFERENCE * self.scales[i];
                moved[i] = vector[i] + step;
                let above = self.cost_at(&moved);
                moved[i] = vector[i] - step;
                let below = self.cost_at(&moved);
                moved[i] = vector[i];
                (above - below) / (2.0 * step)
            })
            .collect()
    }
}

impl CostFunction for Problem<'_, '_> {
    type Param = Vec<f64>;
    type Output = f64;
    type Error = Infallible;

    fn cost(&self, vector: &Vec<f64>) -> Result<f64, Infallible> {
        Ok(self.cost_at(vector))
    }
}

impl Gradient for Problem<'_, '_> {
    type Gradient = Vec<f64>;

    fn gradient(&self, vector: &Vec<f64>) -> Result<Vec<f64>, Infallible> {
        Ok(self.gradient_at(vector))
    }
}

/// Finds the best fit by BFGS. The scales of the coordinates, known from the noise, are its first
/// guess at the curvature, which saves it half its steps.
///
/// `None` if no vector near the start makes sense, or the best is no maximum.
pub(super) fn best_fit(evaluator: &mut Evaluator) -> Option<Fit> {
    const MOST_STEPS: u64 = 60;
    let start = evaluator.model.start();
    evaluator.log_posterior(&start)?;
    let scales = scales(evaluator.model);
    let problem = Problem {
        evaluator: RefCell::new(&mut *evaluator),
        scales: &scales,
    };
    let seed = DenseMatrix::from_fn(scales.len(), scales.len(), |i, j| {
        if i == j { scales[i] * scales[i] } else { 0.0 }
    });
    let solver = Bfgs::<Vec<f64>>::new().with_initial_inverse_hessian(seed);
    let state = FirstOrderState::new(start);
    let result = Executor::new(problem, solver, state)
        .max_iter(MOST_STEPS)
        .run()
        .ok()?;
    let vector = result.best_param().clone();
    let log_posterior = -result.best_cost();
    let covariance = covariance(evaluator, &vector, &scales)?;
    Some(Fit {
        vector: DVector::from_vec(vector),
        log_posterior,
        covariance,
    })
}

/// About how far each coordinate may move: one where it is a standard normal, and what the scatter
/// leaves of e* and the height.
fn scales(model: &Model) -> Vec<f64> {
    let count = model.observed.stretches.len() as f64;
    let scatter = model.middle.scatter.clamp(1e-4, 0.3);
    let e = model.middle.restitution.clamp(0.05, 0.995);
    model
        .slots()
        .iter()
        .map(|slot| match slot {
            Slot::Restitution => scatter / count.sqrt() / (1.0 - e),
            Slot::Height => scatter,
            Slot::Scatter => 1.0 / (2.0 * count).sqrt(),
            _ => 0.5,
        })
        .collect()
}

/// Inverse of the Hessian of the cost, by central differences of its gradient; directions in which
/// it is not a bowl take the scale of their coordinate.
fn covariance(evaluator: &mut Evaluator, vector: &[f64], scales: &[f64]) -> Option<DMatrix<f64>> {
    let n = vector.len();
    let problem = Problem {
        evaluator: RefCell::new(evaluator),
        scales,
    };
    let mut hessian = DMatrix::zeros(n, n);
    let mut moved = vector.to_vec();
    for i in 0..n {
        let step = 0.1 * scales[i];
        moved[i] = vector[i] + step;
        let above = problem.gradient_at(&moved);
        moved[i] = vector[i] - step;
        let below = problem.gradient_at(&moved);
        moved[i] = vector[i];
        for j in 0..n {
            // In units of the scales, where all entries are alike in size.
            hessian[(i, j)] = (above[j] - below[j]) / (2.0 * step) * scales[i] * scales[j];
        }
    }
    let symmetric = 0.5 * (&hessian + hessian.transpose());
    if symmetric.iter().any(|entry| !entry.is_finite()) {
        return None;
    }
    let eigen = symmetric.symmetric_eigen();
    let inverse = eigen.eigenvalues.map(|value| 1.0 / value.max(LEAST_CURVATURE));
    let scaled = &eigen.eigenvectors * DMatrix::from_diagonal(&inverse) * eigen.eigenvectors.transpose();
    let unit = DMatrix::from_diagonal(&DVector::from_column_slice(scales));
    Some(&unit * scaled * &unit)
}

/// No direction is taken to be wider than some ten of its scales.
const LEAST_CURVATURE: f64 = 1e-2;
