//! An order of draws in which neighbours are alike, so that one of every n represents all.

use nalgebra::DMatrix;

/// Weighted draws and the unknowns in which neighbours are to be alike.
struct Draws<'a> {
    /// One in each column.
    vectors: &'a DMatrix<f64>,
    weights: &'a [f64],
    unknowns: &'a [usize],
    /// Variance of each of the unknowns among all draws.
    variances: Vec<f64>,
}

/// The numbers of the draws, each in a column, in an order in which neighbours are alike in these unknowns: that of
/// the leaves of a k-d tree (J. L. Bentley, Commun. ACM 18, 509, 1975).
pub(super) fn order(vectors: &DMatrix<f64>, weights: &[f64], unknowns: &[usize]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..weights.len()).collect();
    let mut draws = Draws {
        vectors,
        weights,
        unknowns,
        variances: Vec::new(),
    };
    draws.variances = unknowns
        .iter()
        .map(|&u| draws.mean_and_variance(&order, u).1)
        .collect();
    draws.sort_into_sides(&mut order);
    order
}

impl Draws<'_> {
    /// Sorts draws into those below and above the mean of the unknown that varies most among them, and each side in the
    /// same way.
    fn sort_into_sides(&self, draws: &mut [usize]) {
        let (mut widest, mut centre, mut greatest) = (0, f64::NAN, f64::NEG_INFINITY);
        for (&unknown, all) in self.unknowns.iter().zip(&self.variances) {
            let (mean, variance) = self.mean_and_variance(draws, unknown);
            if variance / all > greatest {
                (widest, centre, greatest) = (unknown, mean, variance / all);
            }
        }
        let mut below = 0;
        for index in 0..draws.len() {
            if self.vectors[(widest, draws[index])] < centre {
                draws.swap(index, below);
                below += 1;
            }
        }
        // Alike, or without weight.
        if below == 0 || below == draws.len() {
            return;
        }
        let (lower, upper) = draws.split_at_mut(below);
        self.sort_into_sides(lower);
        self.sort_into_sides(upper);
    }

    /// The mean and the variance of an unknown among draws.
    fn mean_and_variance(&self, draws: &[usize], unknown: usize) -> (f64, f64) {
        let first = draws
            .first()
            .map_or(0.0, |&draw| self.vectors[(unknown, draw)]);
        let [mut total, mut sum, mut squares] = [0.0; 3];
        for &draw in draws {
            let (weight, off) = (self.weights[draw], self.vectors[(unknown, draw)] - first);
            total += weight;
            sum += weight * off;
            squares += weight * off * off;
        }
        let mean = sum / total;
        (first + mean, squares / total - mean * mean)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The points of a grid of 8 by 8, in the order of a sieve: every 16 in a row fill a quarter of the grid.
    #[test]
    fn neighbours_are_alike() {
        let points = (0..64)
            .map(|number| number * 27 % 64)
            .map(|point| [point / 8, point % 8]);
        let coordinates: Vec<f64> = points.flatten().map(f64::from).collect();
        let vectors = DMatrix::from_vec(2, 64, coordinates);
        let order = order(&vectors, &[1.0 / 64.0; 64], &[0, 1]);
        let mut quarters: Vec<[bool; 2]> = Vec::new();
        for sixteen in order.chunks(16) {
            let quarter = |draw: &usize| [0, 1].map(|unknown| vectors[(unknown, *draw)] < 4.0);
            assert!(
                sixteen
                    .iter()
                    .all(|draw| quarter(draw) == quarter(&sixteen[0]))
            );
            quarters.push(quarter(&sixteen[0]));
        }
        quarters.sort_unstable();
        quarters.dedup();
        assert_eq!(quarters.len(), 4);
    }
}
