//! The best fit of a model, and its curvature.

use std::cell::RefCell;
use std::convert::Infallible;

use basin::{Bfgs, CostFunction, DenseMatrix, Executor, FirstOrderState, Gradient};
use nalgebra::{Cholesky, DMatrix, DVector};

use super::likelihood::Evaluator;

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

/// Step of a central difference, in standard deviations.
const DIFFERENCE: f64 = 0.01;

/// Slope of the cost by a coordinate of unit standard deviation at which the search ends: the rest
/// is a thousandth of a standard deviation. The sampling would mind less, but so the end does not
/// depend on the way there, and the answer not on the last bit of a machine's arithmetic.
const FLAT: f64 = 1e-3;

const MOST_STEPS: u64 = 40;

/// The cost in coordinates u in which the posterior is round: vector = start + root u.
struct Problem<'a, 'b> {
    evaluator: RefCell<&'b mut Evaluator<'a>>,
    start: DVector<f64>,
    root: DMatrix<f64>,
}

impl Problem<'_, '_> {
    fn vector(&self, u: &[f64]) -> DVector<f64> {
        &self.start + &self.root * DVector::from_column_slice(u)
    }
}

impl CostFunction for Problem<'_, '_> {
    type Param = Vec<f64>;
    type Output = f64;
    type Error = Infallible;

    fn cost(&self, u: &Vec<f64>) -> Result<f64, Infallible> {
        let vector = self.vector(u);
        let log = self.evaluator.borrow_mut().log_posterior(vector.as_slice());
        Ok(log.map_or(NOWHERE, |log| -log))
    }
}

impl Gradient for Problem<'_, '_> {
    type Gradient = Vec<f64>;

    fn gradient(&self, u: &Vec<f64>) -> Result<Vec<f64>, Infallible> {
        let mut moved = u.clone();
        let mut gradient = Vec::with_capacity(u.len());
        for i in 0..u.len() {
            moved[i] = u[i] + DIFFERENCE;
            let above = self.cost(&moved)?;
            moved[i] = u[i] - DIFFERENCE;
            let below = self.cost(&moved)?;
            moved[i] = u[i];
            gradient.push((above - below) / (2.0 * DIFFERENCE));
        }
        Ok(gradient)
    }
}

/// Finds the best fit by BFGS, in coordinates in which the information at the start makes the
/// posterior round.
///
/// `None` if no vector near the start makes sense.
pub(super) fn best_fit(evaluator: &mut Evaluator) -> Option<Fit> {
    let start = DVector::from_vec(evaluator.model.start());
    evaluator.log_posterior(start.as_slice())?;
    let covariance = covariance(evaluator, start.as_slice())?;
    let problem = Problem {
        root: Cholesky::new(covariance)?.l(),
        start,
        evaluator: RefCell::new(&mut *evaluator),
    };
    let state = FirstOrderState::new(vec![0.0; problem.start.len()]);
    let (start, root) = (problem.start.clone(), problem.root.clone());
    let identity =
        DenseMatrix::from_fn(start.len(), start.len(), |i, j| f64::from(u8::from(i == j)));
    let solver = Bfgs::<Vec<f64>>::new()
        .with_initial_inverse_hessian(identity)
        .with_absolute_gradient_tolerance(FLAT);
    let result = Executor::new(problem, solver, state)
        .max_iter(MOST_STEPS)
        .run()
        .ok()?;
    let vector = start + root * DVector::from_column_slice(result.best_param());
    Some(Fit {
        covariance: self::covariance(evaluator, vector.as_slice())?,
        vector,
        log_posterior: -result.best_cost(),
    })
}

/// Inverse of the information at a vector.
fn covariance(evaluator: &mut Evaluator, vector: &[f64]) -> Option<DMatrix<f64>> {
    Some(Cholesky::new(evaluator.information(vector)?)?.inverse())
}
