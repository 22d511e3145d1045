//! Mixtures of normal distributions: a posterior given each value of what it was integrated over.

use statrs::distribution::{ContinuousCDF, Normal};

use crate::estimate::Estimate;

/// Components of less weight than this are left out.
const NEGLIGIBLE: f64 = 1e-4;

const TAIL68: f64 = 0.158_655;
const TAIL95: f64 = 0.025;

/// Weight, mean and variance of each component.
#[derive(Debug, Clone, Default)]
pub(super) struct Mixture(Vec<[f64; 3]>);

impl Mixture {
    pub(super) fn add(&mut self, weight: f64, mean: f64, variance: f64) {
        self.0.push([weight, mean, variance]);
    }

    fn weight(&self) -> f64 {
        self.0.iter().map(|[weight, ..]| weight).sum()
    }

    pub(super) fn mean(&self) -> f64 {
        self.0
            .iter()
            .map(|[weight, mean, _]| weight * mean)
            .sum::<f64>()
            / self.weight()
    }

    pub(super) fn variance(&self) -> f64 {
        let about = self.mean();
        let square =
            |[weight, mean, variance]: &[f64; 3]| weight * (variance + (mean - about).powi(2));
        self.0.iter().map(square).sum::<f64>() / self.weight()
    }

    /// The probability of a value below this.
    pub(super) fn below(&self, value: f64) -> f64 {
        let normal = Normal::standard();
        let below = |[weight, mean, variance]: &[f64; 3]| {
            let off = value - mean;
            weight
                * if *variance > 0.0 {
                    normal.cdf(off / variance.sqrt())
                } else {
                    f64::from(off >= 0.0)
                }
        };
        self.0.iter().map(below).sum::<f64>() / self.weight()
    }

    /// Median, standard deviation and central intervals, of a function of the value that grows with it and has this derivative.
    pub(super) fn estimate(&self, of: impl Fn(f64) -> f64, slope: impl Fn(f64) -> f64) -> Estimate {
        let quantile = |share: f64| of(self.quantile(share));
        Estimate {
            value: quantile(0.5),
            sd: self.variance().sqrt() * slope(self.mean()),
            interval68: [quantile(TAIL68), quantile(1.0 - TAIL68)],
            interval95: [quantile(TAIL95), quantile(1.0 - TAIL95)],
        }
    }

    fn quantile(&self, share: f64) -> f64 {
        /// Standard deviations from the mean beyond which a component has no weight.
        const REACH: f64 = 8.0;
        const HALVINGS: usize = 30;
        let end =
            |side: f64| move |[_, mean, variance]: &[f64; 3]| mean + side * REACH * variance.sqrt();
        let mut low = self.0.iter().map(end(-1.0)).fold(f64::INFINITY, f64::min);
        let mut high = self
            .0
            .iter()
            .map(end(1.0))
            .fold(f64::NEG_INFINITY, f64::max);
        for _ in 0..HALVINGS {
            let middle = f64::midpoint(low, high);
            if self.below(middle) < share {
                low = middle;
            } else {
                high = middle;
            }
        }
        f64::midpoint(low, high)
    }
}

/// The values with their weights, which sum to one, but for negligible ones.
pub(super) fn relevant<T>(weighted: impl IntoIterator<Item = (f64, T)>) -> Vec<(f64, T)> {
    let mut weighted: Vec<(f64, T)> = weighted.into_iter().collect();
    let largest = weighted
        .iter()
        .map(|(weight, _)| *weight)
        .fold(0.0, f64::max);
    weighted.retain(|(weight, _)| *weight > NEGLIGIBLE * largest);
    let sum: f64 = weighted.iter().map(|(weight, _)| weight).sum();
    for (weight, _) in &mut weighted {
        *weight /= sum;
    }
    weighted
}

/// Weights of logarithms of densities.
pub(super) fn weights(logs: &[f64]) -> Vec<f64> {
    let largest = logs.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let weights: Vec<f64> = logs.iter().map(|log| (log - largest).exp()).collect();
    let sum: f64 = weights.iter().sum();
    weights.into_iter().map(|weight| weight / sum).collect()
}

/// The median, standard deviation and intervals of a value that is above zero and has this weight at each of its increasing
/// values.
pub(super) fn of_weighted(values: &[f64], weights: &[f64]) -> Estimate {
    let mean: f64 = std::iter::zip(values, weights)
        .map(|(value, weight)| value * weight)
        .sum();
    let square = |(value, weight): (&f64, &f64)| weight * (value - mean).powi(2);
    let variance: f64 = std::iter::zip(values, weights).map(square).sum();
    let quantile = |share: f64| {
        let (mut below, mut last) = (0.0, 0.0);
        for (&value, &weight) in std::iter::zip(values, weights) {
            if below + weight >= share {
                return last + (value - last) * (share - below) / weight;
            }
            below += weight;
            last = value;
        }
        last
    };
    Estimate {
        value: quantile(0.5),
        sd: variance.sqrt(),
        interval68: [quantile(TAIL68), quantile(1.0 - TAIL68)],
        interval95: [quantile(TAIL95), quantile(1.0 - TAIL95)],
    }
}
