//! Symmetric matrices with two bands beside the diagonal, such as covariances of neighbours.
//!
//! A long train has thousands of residuals: as dense matrices their covariances would take
//! gigabytes, and minutes to invert.

use std::ops::{Div, Mul, Sub};

use nalgebra::{DMatrix, DVector};

/// A symmetric matrix that is zero more than two places from the diagonal.
#[derive(Debug, Clone, Default)]
pub(super) struct Banded {
    /// Of each row the entries two, one and no places before the diagonal.
    rows: Vec<[f64; 3]>,
}

impl Banded {
    /// Adds a row: its entries two, one and no places before the diagonal. Entries before the first
    /// column count for nothing.
    pub(super) fn push(&mut self, row: [f64; 3]) {
        self.rows.push(row);
    }

    /// An entry of the diagonal.
    pub(super) fn diagonal(&self, row: usize) -> f64 {
        self.rows[row][2]
    }

    /// The sum of matrices of the same size.
    pub(super) fn sum(matrices: [&Self; 3]) -> Self {
        let [a, b, c] = matrices.map(|matrix| matrix.rows.iter());
        let rows = a.zip(b).zip(c);
        Self {
            rows: rows
                .map(|((a, b), c)| [0, 1, 2].map(|place| a[place] + b[place] + c[place]))
                .collect(),
        }
    }

    /// x' M x.
    pub(super) fn quadratic(&self, x: &DVector<f64>) -> f64 {
        let terms = self.rows.iter().enumerate();
        terms
            .map(|(i, row)| {
                let before = |places: usize| i.checked_sub(places).map_or(0.0, |place| x[place]);
                x[i] * (row[2] * x[i] + 2.0 * (row[1] * before(1) + row[0] * before(2)))
            })
            .sum()
    }

    /// M⁻¹ times a matrix, by the factors L D L'; `None` unless M is positive definite.
    pub(super) fn solve(&self, mut right: DMatrix<f64>) -> Option<DMatrix<f64>> {
        let factors = self.factors()?;
        let count = factors.len();
        for mut column in right.column_iter_mut() {
            for i in 0..count {
                let before = |places: usize| i.checked_sub(places).map_or(0.0, |it| column[it]);
                let [second, first, _] = factors[i];
                column[i] -= second * before(2) + first * before(1);
            }
            for i in (0..count).rev() {
                let after = |places: usize| {
                    let entry = factors.get(i + places).map(|row| row[2 - places]);
                    entry.map_or(0.0, |entry| entry * column[i + places])
                };
                column[i] = column[i] / factors[i][2] - after(1) - after(2);
            }
        }
        Some(right)
    }

    /// Of each row of the factors the entries of L two and one place before the diagonal, and that of D.
    fn factors(&self) -> Option<Vec<[f64; 3]>> {
        let mut factors: Vec<[f64; 3]> = Vec::with_capacity(self.rows.len());
        // Before the first row stands a matrix that is one.
        let [mut one, mut two] = [[0.0, 0.0, 1.0]; 2];
        for (i, &[second, first, diagonal]) in self.rows.iter().enumerate() {
            let second = if i < 2 { 0.0 } else { second };
            let first = if i < 1 { 0.0 } else { first };
            let factor = next_factor([second, first, diagonal], [one, two]);
            if factor[2].is_nan() || factor[2] <= 0.0 {
                return None;
            }
            (two, one) = (one, factor);
            factors.push(one);
        }
        Some(factors)
    }
}

/// A row of the factors L D L' of a banded matrix: the entries of L two and one places before the diagonal,
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
    // As they stand in L D: a division later.
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

    /// Some positive definite bands, and the same as a dense matrix.
    fn example(rows: usize) -> (Banded, DMatrix<f64>) {
        let mut banded = Banded::default();
        let mut dense = DMatrix::zeros(rows, rows);
        for i in 0..rows {
            let wave = (i as f64).sin();
            let row = [0.3 * wave, 0.7 - 0.2 * wave, 3.0 + wave];
            banded.push(row);
            for places in 0..=i.min(2) {
                dense[(i, i - places)] = row[2 - places];
                dense[(i - places, i)] = row[2 - places];
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
            assert!((banded.solve(right).unwrap() - expected).amax() < 1e-12);
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
        let mut banded = Banded::default();
        banded.push([0.0, 0.0, 1.0]);
        banded.push([0.0, 2.0, 1.0]);
        assert!(banded.solve(DMatrix::zeros(2, 1)).is_none());
    }
}
