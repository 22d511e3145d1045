//! The mean of several drops, with conservative uncertainty.
//!
//! Drops of the same ball share what is not known of the ball, the air and the drag law, so that a
//! mean does not make that smaller; what differs between drops shows in their scatter. How much of the
//! uncertainty of one drop is shared is not asked: all of it is taken to be. A ratio of two sets is the
//! other way round: what they share would cancel, so it is taken to be nothing.

use rand::seq::SliceRandom;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StudentT};

use crate::estimate::Estimate;
use crate::stats::sorted;

/// Equally likely values of the mean over drops, in random order.
///
/// Every drop is as high in its distribution as the others, and the standard error of the mean, from
/// the scatter between the drops, is added as a Student's t.
pub(super) fn mean(drops: &[&[f64]], rng: &mut ChaCha8Rng) -> Vec<f64> {
    let Some(count) = drops.iter().map(|draws| draws.len()).min() else {
        return Vec::new();
    };
    let sorted: Vec<Vec<f64>> = drops
        .iter()
        .map(|draws| sorted(draws.iter().copied()))
        .collect();
    let mut mean: Vec<f64> = (0..count)
        .map(|place| {
            let at = |draws: &Vec<f64>| draws[place * draws.len() / count];
            sorted.iter().map(at).sum::<f64>() / drops.len() as f64
        })
        .collect();
    mean.shuffle(rng);
    let middles: Vec<f64> = sorted.iter().map(|draws| draws[draws.len() / 2]).collect();
    if let Some((error, freedom)) = standard_error(&middles)
        && let Ok(student) = StudentT::new(freedom)
    {
        for value in &mut mean {
            *value += error * student.sample(rng);
        }
    }
    mean
}

/// Standard error of a mean from the scatter, and its degrees of freedom; a single value has none.
fn standard_error(values: &[f64]) -> Option<(f64, f64)> {
    if values.len() < 2 {
        return None;
    }
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    Some(((squares / (count - 1.0) / count).sqrt(), count - 1.0))
}

/// Values of a ratio of two independent quantities.
pub(super) fn ratio(above: &[f64], below: &[f64]) -> Vec<f64> {
    above.iter().zip(below).map(|(a, b)| a / b).collect()
}

/// Values of something told of several quantities together, taken as independent of each other.
pub(super) fn across(columns: &[Vec<f64>], value: impl Fn(&[f64]) -> f64) -> Vec<f64> {
    let count = columns.iter().map(Vec::len).min().unwrap_or(0);
    let mut row = vec![0.0; columns.len()];
    (0..count)
        .map(|place| {
            for (cell, column) in row.iter_mut().zip(columns) {
                *cell = column[place];
            }
            value(&row)
        })
        .collect()
}

/// The summary of values. Its standard deviation is half the middle 68 %: a Student's t of few drops
/// has none.
pub(super) fn summary(values: &[f64]) -> Option<Estimate> {
    let summary = Estimate::of_draws(values.iter().copied())?;
    let [low, high] = summary.interval68;
    Some(Estimate {
        sd: (high - low) / 2.0,
        ..summary
    })
}

#[cfg(test)]
mod tests {
    use rand::SeedableRng;

    use super::*;

    /// Equal drops are no better known than one of them.
    #[test]
    fn what_is_shared_does_not_average_out() {
        let draws: Vec<f64> = (0..1000).map(|i| f64::from(i) / 1000.0).collect();
        let mut rng = ChaCha8Rng::seed_from_u64(1);
        let one = summary(&mean(&[&draws], &mut rng)).unwrap();
        let four = summary(&mean(&[&draws, &draws, &draws, &draws], &mut rng)).unwrap();
        assert!((four.sd - one.sd).abs() < 1e-9);
    }

    /// Two drops that differ by 2: the standard error is 1, and Student's t with one degree of
    /// freedom has its quartiles at 1.
    #[test]
    fn drops_that_differ_make_the_mean_uncertain() {
        let drops = [vec![0.0; 4000], vec![2.0; 4000]];
        let mut rng = ChaCha8Rng::seed_from_u64(2);
        let mut values = mean(&[&drops[0], &drops[1]], &mut rng);
        values.sort_unstable_by(f64::total_cmp);
        assert!((values[2000] - 1.0).abs() < 0.06);
        assert!((values[3000] - 2.0).abs() < 0.12, "{}", values[3000]);
    }
}
