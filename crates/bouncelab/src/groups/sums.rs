//! Sums over drops from which a group is fitted: a million drops are as many numbers as one.

use nalgebra::{DMatrix, DVector};

use super::evidence::{CurveEvidence, SHARED_INPUTS};
use crate::restitution::WALK;

/// Distance of the knots of the curve in ln v: an octave.
const KNOTS: f64 = std::f64::consts::LN_2;

/// Standard deviations of the mean of ln e and of its slope over the range of speeds: any ball.
const LEVEL: f64 = 1.0;
const SLOPE: f64 = 0.3;

/// Scatters between drops, relative, at which sums are kept: zero, and then each larger by [`SCATTER_STEP`].
pub(super) const SCATTERS: usize = 33;
/// The smallest of them above zero.
const MIN_SCATTER: f64 = 1e-5;
/// ln of the factor between neighbours.
pub(super) const SCATTER_STEP: f64 = 0.335;

/// The scatter of this number.
pub(super) fn scatter_at(index: usize) -> f64 {
    match index {
        0 => 0.0,
        _ => MIN_SCATTER * (SCATTER_STEP * (index as f64 - 1.0)).exp(),
    }
}

/// ln e as a cubic B-spline of ln v. Its functions sum to one, so that all coefficients move by as much as the level.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Basis {
    /// The first knot, in units of [`KNOTS`].
    first: f64,
    intervals: usize,
}

impl Basis {
    /// The basis that covers a range of speeds, m/s.
    pub(super) fn covering([slowest_m_s, fastest_m_s]: [f64; 2]) -> Self {
        let first = (slowest_m_s.ln() / KNOTS).floor();
        let last = (fastest_m_s.ln() / KNOTS).ceil();
        Self {
            first,
            intervals: (last - first).max(1.0) as usize,
        }
    }

    /// Number of functions.
    pub(super) fn len(&self) -> usize {
        self.intervals + 3
    }

    /// The functions at a speed; beyond the knots they stay.
    pub(super) fn at(&self, speed_m_s: f64) -> DVector<f64> {
        let x = (speed_m_s.ln() / KNOTS - self.first).clamp(0.0, self.intervals as f64);
        let interval = (x as usize).min(self.intervals - 1);
        let t = x - interval as f64;
        let mut values = DVector::zeros(self.len());
        let rest = 1.0 - t;
        values[interval] = rest.powi(3) / 6.0;
        values[interval + 1] = (3.0 * t.powi(3) - 6.0 * t * t + 4.0) / 6.0;
        values[interval + 2] = (3.0 * rest.powi(3) - 6.0 * rest * rest + 4.0) / 6.0;
        values[interval + 3] = t.powi(3) / 6.0;
        values
    }

    /// The precision of the coefficients before the data: the slope walks at random, so second differences have the variance
    /// WALK² KNOTS³; level and mean slope are nearly free.
    pub(super) fn prior(&self) -> DMatrix<f64> {
        let len = self.len();
        let mut precision = DMatrix::zeros(len, len);
        let mut add = |row: DVector<f64>, sd: f64| {
            precision.ger(1.0 / (sd * sd), &row, &row, 1.0);
        };
        for middle in 1..len - 1 {
            let mut row = DVector::zeros(len);
            (row[middle - 1], row[middle], row[middle + 1]) = (1.0, -2.0, 1.0);
            add(row, WALK * KNOTS.powf(1.5));
        }
        add(DVector::from_element(len, 1.0 / len as f64), LEVEL);
        let mut ends = DVector::zeros(len);
        (ends[0], ends[len - 1]) = (-1.0, 1.0);
        add(ends, SLOPE * KNOTS * (len as f64 - 1.0));
        precision
    }
}

/// The readings of a drop as rows over coefficients of the curve, shared inputs and value.
#[derive(Debug)]
pub(super) struct Rows {
    /// Coefficients, shared inputs, value: as many columns.
    pub(super) table: DMatrix<f64>,
    /// What the level of the drop adds to each row.
    pub(super) level: DVector<f64>,
}

impl Rows {
    pub(super) fn new(basis: &Basis, evidence: &CurveEvidence) -> Self {
        let functions = evidence.speeds_m_s.iter().map(|&speed| basis.at(speed));
        let functions = DMatrix::from_columns(&functions.collect::<Vec<_>>());
        let len = basis.len();
        let mut table = DMatrix::zeros(evidence.readings.len(), len + SHARED_INPUTS + 1);
        for (row, reading) in evidence.readings.iter().enumerate() {
            let of_curve = &functions * DVector::from_column_slice(&reading.weights);
            let others = reading.shared.iter().chain([&reading.value]);
            for (column, &value) in of_curve.iter().chain(others).enumerate() {
                table[(row, column)] = value;
            }
        }
        let level = evidence
            .readings
            .iter()
            .map(|reading| reading.weights.iter().sum());
        Self {
            table,
            level: DVector::from_vec(level.collect()),
        }
    }

    /// The precision with which the drop alone tells its level, given the curve.
    pub(super) fn precision(&self) -> f64 {
        self.level.norm_squared()
    }

    /// The part of its covariance that is due to a scatter: with a row a for the level, (1 + τ² a a')⁻¹ = 1 - k a a'.
    pub(super) fn shrinkage(&self, scatter: f64) -> f64 {
        let variance = scatter * scatter;
        variance / (1.0 + variance * self.precision())
    }
}

/// Sums over the drops of a group that have the same operator.
#[derive(Debug, Clone)]
pub(super) struct Sums {
    pub(super) drops: usize,
    /// Products of the columns of [`Rows`], without scatter between drops.
    plain: DMatrix<f64>,
    /// What each scatter takes off them.
    scattered: Vec<DMatrix<f64>>,
    /// Sum of ln(1 + τ² a'a).
    log_determinants: [f64; SCATTERS],
    /// Sum of the variances of the levels by the drops' own errors.
    own_variance: f64,
}

impl Sums {
    pub(super) fn new(basis: &Basis) -> Self {
        let columns = basis.len() + SHARED_INPUTS + 1;
        let zeros = DMatrix::zeros(columns, columns);
        Self {
            drops: 0,
            scattered: vec![zeros.clone(); SCATTERS],
            plain: zeros,
            log_determinants: [0.0; SCATTERS],
            own_variance: 0.0,
        }
    }

    pub(super) fn add(&mut self, rows: &Rows) {
        self.drops += 1;
        self.plain.gemm_tr(1.0, &rows.table, &rows.table, 1.0);
        self.own_variance += 1.0 / rows.precision();
        let along = rows.table.tr_mul(&rows.level);
        for index in 1..SCATTERS {
            let scatter = scatter_at(index);
            self.scattered[index].ger(rows.shrinkage(scatter), &along, &along, 1.0);
            self.log_determinants[index] += (scatter * scatter * rows.precision()).ln_1p();
        }
    }

    /// The products at a scatter, and the logarithm of the determinant of the covariance.
    pub(super) fn at(&self, scatter: usize) -> (DMatrix<f64>, f64) {
        (
            &self.plain - &self.scattered[scatter],
            self.log_determinants[scatter],
        )
    }

    /// Sum of the variances of the levels by the drops' own errors.
    pub(super) fn own_variance(&self) -> f64 {
        self.own_variance
    }
}
