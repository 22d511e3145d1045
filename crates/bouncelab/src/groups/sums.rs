//! Sums over drops from which a group is fitted: a million drops are as many numbers as one.

use std::collections::BTreeSet;

use nalgebra::{DMatrix, DVector, SMatrix};

use super::evidence::{CurveEvidence, SHARED_INPUTS};
use super::fit::{Inputs, Shared};
use super::study::{Asked, StudyDrop};
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
///
/// The knots are powers of two of 1 m/s, whatever the range: a wider basis has the functions of a narrower one, and more.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Basis {
    /// The first and the last knot, in units of [`KNOTS`].
    first: i32,
    last: i32,
}

impl Basis {
    /// The basis that covers a range of speeds, m/s.
    pub(super) fn covering([slowest_m_s, fastest_m_s]: [f64; 2]) -> Self {
        let first = (slowest_m_s.ln() / KNOTS).floor() as i32;
        let last = (fastest_m_s.ln() / KNOTS).ceil() as i32;
        Self {
            first,
            last: last.max(first + 1),
        }
    }

    /// The narrowest basis that has the functions of both.
    pub(super) fn joined(self, other: Self) -> Self {
        Self {
            first: self.first.min(other.first),
            last: self.last.max(other.last),
        }
    }

    fn intervals(self) -> usize {
        (self.last - self.first) as usize
    }

    /// Number of functions.
    pub(super) fn len(self) -> usize {
        self.intervals() + 3
    }

    /// The functions at a speed; beyond the knots they stay.
    pub(super) fn at(self, speed_m_s: f64) -> DVector<f64> {
        let x =
            (speed_m_s.ln() / KNOTS - f64::from(self.first)).clamp(0.0, self.intervals() as f64);
        let interval = (x as usize).min(self.intervals() - 1);
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
    pub(super) fn prior(self) -> DMatrix<f64> {
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
    pub(super) fn new(basis: Basis, evidence: &CurveEvidence) -> Self {
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
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Sums {
    pub(super) drops: usize,
    basis: Basis,
    /// Products of the columns of [`Rows`], without scatter between drops.
    plain: DMatrix<f64>,
    /// What each scatter takes off them.
    scattered: Vec<DMatrix<f64>>,
    /// Sum of ln(1 + τ² a'a).
    log_determinants: Vec<f64>,
    /// Sum of the variances of the levels by the drops' own errors.
    own_variance: f64,
}

impl Sums {
    fn new(basis: Basis) -> Self {
        let columns = basis.len() + SHARED_INPUTS + 1;
        let zeros = DMatrix::zeros(columns, columns);
        Self {
            drops: 0,
            basis,
            scattered: vec![zeros.clone(); SCATTERS],
            plain: zeros,
            log_determinants: vec![0.0; SCATTERS],
            own_variance: 0.0,
        }
    }

    fn add(&mut self, evidence: &CurveEvidence) {
        let basis = self.basis.joined(Basis::covering(evidence.range_m_s));
        if basis != self.basis {
            *self = self.over(basis);
        }
        let rows = Rows::new(basis, evidence);
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

    /// The same sums by a basis that has all functions of this one.
    pub(super) fn over(&self, basis: Basis) -> Self {
        let (before, len) = (self.basis.len(), self.plain.ncols());
        let more = basis.len() - before;
        let offset = (self.basis.first - basis.first) as usize;
        let place = |column: usize| column + if column < before { offset } else { more };
        let widened = |sums: &DMatrix<f64>| {
            let mut wide = DMatrix::zeros(len + more, len + more);
            for column in 0..len {
                for row in 0..len {
                    wide[(place(row), place(column))] = sums[(row, column)];
                }
            }
            wide
        };
        Self {
            basis,
            plain: widened(&self.plain),
            scattered: self.scattered.iter().map(widened).collect(),
            log_determinants: self.log_determinants.clone(),
            ..*self
        }
    }

    fn merge(&mut self, other: &Self) {
        let basis = self.basis.joined(other.basis);
        let (mut sum, other) = (self.over(basis), other.over(basis));
        sum.drops += other.drops;
        sum.plain += other.plain;
        sum.own_variance += other.own_variance;
        for (scattered, of_other) in sum.scattered.iter_mut().zip(other.scattered) {
            *scattered += of_other;
        }
        for (log, of_other) in sum.log_determinants.iter_mut().zip(other.log_determinants) {
            *log += of_other;
        }
        *self = sum;
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

/// What the drops of a group add to a study, as sums: of parts that were read apart they are merged.
///
/// ```
/// use bouncelab::groups::{Asked, CurveEvidence, GroupSums, Study, StudyDrop};
/// use bouncelab::inference::Measured;
///
/// let asked = Asked::default();
/// let sums = |values: &[f64]| {
///     let mut sums = GroupSums::default();
///     for &value in values {
///         let evidence = CurveEvidence::measured(&[(1.0, Measured { value, sd: 0.001 })]);
///         sums.add(&StudyDrop { evidence, scatter: None, levels: Vec::new() }, &asked);
///     }
///     sums
/// };
/// let mut all = sums(&[0.921, 0.924]);
/// all.merge(&sums(&[0.919, 0.926]));
/// let study = Study::of_sums(&[(Vec::new(), all)], &asked)?;
/// assert!((study.groups[0].restitution.unwrap().value - 0.9225).abs() < 2e-4);
/// # Ok::<(), bouncelab::Error>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct GroupSums {
    drops: usize,
    range_m_s: Option<[f64; 2]>,
    balls: BTreeSet<Option<usize>>,
    /// Sums over the drops of what each knows of the inputs that all of a ball share.
    inputs: Shared,
    inputs_covariance: SMatrix<f64, SHARED_INPUTS, SHARED_INPUTS>,
    /// Sum of the logarithms of the scatters from impact to impact, and of how many drops.
    ln_scatter: f64,
    with_scatter: usize,
    /// The sums for each choice of levels of the factors that scatter, in their order.
    cells: Vec<(Vec<Option<usize>>, Sums)>,
}

impl GroupSums {
    /// Adds a drop, with what will be asked; one whose evidence is not usable adds nothing.
    pub fn add(&mut self, drop: &StudyDrop, asked: &Asked) {
        let evidence = &drop.evidence;
        if !evidence.is_usable() {
            return;
        }
        self.drops += 1;
        self.range_m_s = self
            .range_m_s
            .into_iter()
            .chain([evidence.range_m_s])
            .reduce(wider);
        self.balls
            .insert(asked.ball.and_then(|factor| drop.levels[factor]));
        self.inputs += Shared::from(evidence.inputs);
        self.inputs_covariance += SMatrix::from(evidence.inputs_covariance);
        if let Some(scatter) = drop.scatter {
            self.ln_scatter += scatter.ln();
            self.with_scatter += 1;
        }
        self.cell(asked.effects_of(drop), Basis::covering(evidence.range_m_s))
            .add(evidence);
    }

    /// Adds the drops of other sums, which were made with the same question and the same numbers of levels.
    pub fn merge(&mut self, other: &Self) {
        self.drops += other.drops;
        self.range_m_s = self
            .range_m_s
            .into_iter()
            .chain(other.range_m_s)
            .reduce(wider);
        self.balls.extend(&other.balls);
        self.inputs += other.inputs;
        self.inputs_covariance += other.inputs_covariance;
        self.ln_scatter += other.ln_scatter;
        self.with_scatter += other.with_scatter;
        for (levels, sums) in &other.cells {
            self.cell(levels.clone(), sums.basis).merge(sums);
        }
    }

    /// Number of drops.
    pub fn drops(&self) -> usize {
        self.drops
    }

    /// The slowest and the fastest of their impacts, m/s; `None` without a drop.
    pub fn range_m_s(&self) -> Option<[f64; 2]> {
        self.range_m_s
    }

    fn cell(&mut self, levels: Vec<Option<usize>>, basis: Basis) -> &mut Sums {
        let place = match self.cells.binary_search_by(|(of, _)| of.cmp(&levels)) {
            Ok(place) => place,
            Err(place) => {
                self.cells.insert(place, (levels, Sums::new(basis)));
                place
            }
        };
        &mut self.cells[place].1
    }

    /// The balls that the drops are of, `None` being one without a name.
    pub(super) fn balls(&self) -> &BTreeSet<Option<usize>> {
        &self.balls
    }

    /// Typical scatter from impact to impact, relative: the geometric mean.
    pub(super) fn between_impacts(&self) -> Option<f64> {
        (self.with_scatter > 0).then(|| (self.ln_scatter / self.with_scatter as f64).exp())
    }

    /// Sums of what drops know of the inputs, over groups of one ball: the mean over their drops.
    pub(super) fn inputs<'a>(groups: impl IntoIterator<Item = &'a Self>) -> Inputs {
        let (mut mean, mut covariance, mut drops) = (Shared::zeros(), SMatrix::zeros(), 0.0);
        for group in groups {
            mean += group.inputs;
            covariance += group.inputs_covariance;
            drops += group.drops as f64;
        }
        Inputs {
            mean: mean / drops,
            covariance: covariance / drops,
        }
    }

    /// The sums over a basis of all groups.
    pub(super) fn cells(&self, basis: Basis) -> impl Iterator<Item = (&[Option<usize>], Sums)> {
        self.cells
            .iter()
            .map(move |(levels, sums)| (levels.as_slice(), sums.over(basis)))
    }

    /// The levels of the factors that scatter.
    pub(super) fn levels(&self) -> impl Iterator<Item = &[Option<usize>]> {
        self.cells.iter().map(|(levels, _)| levels.as_slice())
    }
}

/// The range that holds both.
pub(super) fn wider(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0].min(b[0]), a[1].max(b[1])]
}
