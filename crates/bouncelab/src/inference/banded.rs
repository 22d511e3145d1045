//! Symmetric matrices with two bands on each side of the diagonal, such as covariances of neighbours.
//!
//! A long train has thousands of residuals: as dense matrices their covariances would take
//! gigabytes, and minutes to invert.

use std::ops::{Div, Mul, Sub};

use nalgebra::{DMatrix, DVector};

use crate::simd::Lanes;

/// A symmetric matrix that is zero more than two columns from the diagonal, in each lane.
#[derive(Debug, Clone, Default)]
pub(super) struct Banded<const L: usize> {
    /// Of each row the entries two columns and one column before the diagonal, and on it.
    rows: Vec<[Lanes<L>; 3]>,
}

impl<const L: usize> Banded<L> {
    /// Adds a row: its entries two columns and one column before the diagonal, and on it. Entries before the first
    /// column are ignored.
    #[inline(always)]
    pub(super) fn push(&mut self, row: [Lanes<L>; 3]) {
        self.rows.push(row);
    }

    /// An entry of the diagonal.
    #[inline(always)]
    pub(super) fn diagonal(&self, row: usize) -> Lanes<L> {
        self.rows[row][2]
    }

    /// The sum of matrices of the same size.
    #[inline(always)]
    pub(super) fn sum(matrices: [&Self; 3]) -> Self {
        let [a, b, c] = matrices.map(|matrix| matrix.rows.iter());
        let rows = a.zip(b).zip(c);
        Self {
            rows: rows
                .map(|((a, b), c)| [0, 1, 2].map(|column| a[column] + b[column] + c[column]))
                .collect(),
        }
    }

    /// Turns a vector into M⁻¹ times it: with M = L D L' forward substitution by L, then division by D and backward
    /// substitution by L'. Not a number in a lane where M is not positive definite.
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    pub(super) fn solve(&self, right: &mut [Lanes<L>]) {
        let factors = self.factors();
        for (i, [second, first, _]) in factors.iter().enumerate() {
            if let Some(before) = i.checked_sub(1) {
                right[i] = right[i] - *first * right[before];
            }
            if let Some(before) = i.checked_sub(2) {
                right[i] = right[i] - *second * right[before];
            }
        }
        for i in (0..factors.len()).rev() {
            right[i] = right[i] / factors[i][2];
            for (columns, row) in factors[i + 1..].iter().take(2).enumerate() {
                right[i] = right[i] - row[1 - columns] * right[i + 1 + columns];
            }
        }
    }

    /// Of each row of the factors the entries of L two and one columns before the diagonal, and that of D.
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    fn factors(&self) -> Vec<FactorRow<Lanes<L>>> {
        let [zero, one] = [0.0, 1.0].map(Lanes::all);
        // The matrix is continued upwards by the unit matrix.
        let mut before = [[zero, zero, one]; 2];
        let rows = self.rows.iter().enumerate();
        rows.map(|(i, &[second, first, diagonal])| {
            let second = if i < 2 { zero } else { second };
            let first = if i < 1 { zero } else { first };
            let [second, first, variance] = next_factor([second, first, diagonal], before);
            let positive = variance.if_positive(variance, Lanes::all(f64::NAN));
            before = [[second, first, positive], before[0]];
            before[0]
        })
        .collect()
    }
}

impl Banded<1> {
    /// x' M x.
    pub(super) fn quadratic(&self, x: &DVector<f64>) -> f64 {
        let terms = self.rows.iter().enumerate();
        terms
            .map(|(i, row)| {
                let [second, first, diagonal] = row.map(|entry| entry.0[0]);
                let before =
                    |columns: usize| i.checked_sub(columns).map_or(0.0, |column| x[column]);
                x[i] * (diagonal * x[i] + 2.0 * (first * before(1) + second * before(2)))
            })
            .sum()
    }

    /// M⁻¹ times a matrix; `None` unless M is positive definite.
    pub(super) fn solve_columns(&self, mut right: DMatrix<f64>) -> Option<DMatrix<f64>> {
        for mut column in right.column_iter_mut() {
            let mut solved: Vec<Lanes<1>> = column.iter().map(|&entry| Lanes([entry])).collect();
            self.solve(&mut solved);
            for (entry, Lanes([solved])) in column.iter_mut().zip(solved) {
                *entry = solved;
            }
        }
        right.iter().all(|entry| entry.is_finite()).then_some(right)
    }
}

/// A row of the factors L D L' of a banded matrix: the entries of L two and one columns before the diagonal,
/// and that of D.
pub(super) type FactorRow<T> = [T; 3];

/// The next row of the factors of a banded matrix, from its row and the factors one and two rows before.
#[inline(always)]
pub(super) fn next_factor<T>(
    [second, first, diagonal]: [T; 3],
    [one, two]: [FactorRow<T>; 2],
) -> FactorRow<T>
where
    T: Copy + Sub<Output = T> + Mul<Output = T> + Div<Output = T>,
{
    // The entries of L D first: row i of L D L' at column j is the sum over k <= j of (L D)_ik L_jk.
    let (second_d, first_d) = (second, first - second * one[1]);
    let (second, first) = (second_d / two[2], first_d / one[2]);
    [
        second,
        first,
        diagonal - first * first_d - second * second_d,
    ]
}

#[cfg(test)]
mod tests {
    use nalgebra::{Cholesky, DMatrix, DVector};

    use super::Banded;
    use crate::simd::Lanes;

    /// Some positive definite bands, and the same as a dense matrix.
    fn example(rows: usize) -> (Banded<1>, DMatrix<f64>) {
        let mut banded = Banded::default();
        let mut dense = DMatrix::zeros(rows, rows);
        for i in 0..rows {
            let wave = (i as f64).sin();
            let row = [0.3 * wave, 0.7 - 0.2 * wave, 3.0 + wave];
            banded.push(row.map(Lanes::all));
            for columns in 0..=i.min(2) {
                dense[(i, i - columns)] = row[2 - columns];
                dense[(i - columns, i)] = row[2 - columns];
            }
        }
        (banded, dense)
    }

    #[test]
    fn bands_are_solved_as_the_dense_matrix_is() {
        for rows in 1..8 {
            let (banded, dense) = example(rows);
            let right = DMatrix::from_fn(rows, 2, |i, j| (3 * i + j) as f64 - 2.0);
            let expected = Cholesky::new(dense).unwrap().solve(&right);
            assert!((banded.solve_columns(right).unwrap() - expected).amax() < 1e-12);
        }
    }

    #[test]
    fn a_quadratic_form_is_that_of_the_dense_matrix() {
        let (banded, dense) = example(6);
        let x = DVector::from_fn(6, |i, _| 1.5 - i as f64);
        let expected = x.dot(&(&dense * &x));
        assert!((banded.quadratic(&x) - expected).abs() < 1e-12);
        let sum = Banded::sum([&banded, &banded, &banded]);
        assert!((sum.quadratic(&x) - 3.0 * expected).abs() < 1e-12);
    }

    #[test]
    fn what_is_not_positive_definite_is_not_solved() {
        let mut banded = Banded::<1>::default();
        banded.push([0.0, 0.0, 1.0].map(Lanes::all));
        banded.push([0.0, 2.0, 1.0].map(Lanes::all));
        assert!(banded.solve_columns(DMatrix::zeros(2, 1)).is_none());
    }
}
