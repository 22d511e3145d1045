//! Whitening by linear prediction.
//!
//! A linear prediction learnt from the background removes hum, rumble and ringing from a signal;
//! the prediction error is white where there is only the background.

use crate::simd::{add_weighted, sum_of_products};

/// Number of samples before, from which the next one is predicted. Few, because the prediction is learnt from a few
/// milliseconds.
pub(crate) const ORDER: usize = 10;
/// White noise that is added to the autocovariance, as a share of its power (-70 dB), so that the recursion stays well
/// conditioned for a pure tone.
const WHITE_SHARE: f64 = 1e-7;

/// A prediction of the next sample from the ones before.
pub(crate) struct Autoregression {
    mean: f64,
    /// Weights of the samples before, the earliest first.
    weights: [f64; ORDER],
}

impl Autoregression {
    /// Learns from a stretch of background; `noise_power` is the minimum power of its noise.
    pub(crate) fn learn(samples: &[f32], noise_power: f64) -> Self {
        let (mean, mut covariance) = moments(samples);
        // White noise adds to the covariance at lag 0 alone. Digital silence, whose covariance is zero, predicts zero.
        covariance[0] = covariance[0] * (1.0 + WHITE_SHARE) + noise_power + f64::MIN_POSITIVE;
        Self {
            mean,
            weights: levinson_durbin(&covariance),
        }
    }

    /// Learns from several stretches, each weighted by the inverse of its power.
    pub(crate) fn learn_from_many<'a>(stretches: impl Iterator<Item = &'a [f32]>) -> Self {
        let mut mean = 0.0;
        let mut sum = [0.0; ORDER + 1];
        let mut count = 0.0;
        for stretch in stretches {
            let (stretch_mean, covariance) = moments(stretch);
            mean += stretch_mean;
            count += 1.0;
            if covariance[0] > 0.0 {
                for (sum, value) in sum.iter_mut().zip(covariance) {
                    *sum += value / covariance[0];
                }
            }
        }
        sum[0] = sum[0] * (1.0 + WHITE_SHARE) + f64::MIN_POSITIVE;
        Self {
            mean: mean / f64::max(count, 1.0),
            weights: levinson_durbin(&sum),
        }
    }

    /// The prediction errors of all samples but the first `ORDER`.
    pub(crate) fn errors(&self, samples: &[f32]) -> Vec<f32> {
        let centre = |&v: &f32| (f64::from(v) - self.mean) as f32;
        let centred: Vec<f32> = samples.iter().map(centre).collect();
        // The prediction is a filter of finite length: the error is each sample less the weighted ones before it.
        let mut errors = centred.get(ORDER..).unwrap_or_default().to_vec();
        add_weighted(
            &mut errors,
            &centred,
            &self.weights.map(|weight| -weight as f32),
        );
        errors
    }
}

/// Mean and autocovariance.
fn moments(samples: &[f32]) -> (f64, [f64; ORDER + 1]) {
    let n = samples.len().max(1) as f64;
    let mean = samples.iter().map(|&v| f64::from(v)).sum::<f64>() / n;
    let centred: Vec<f64> = samples.iter().map(|&v| f64::from(v) - mean).collect();
    let covariance = std::array::from_fn(|lag| {
        let later = centred.get(lag..).unwrap_or_default();
        // Divided by n for every lag (the biased estimate), which makes the matrix positive definite.
        sum_of_products::<8, _>(later, &centred) / n
    });
    (mean, covariance)
}

/// Solves the Toeplitz system of linear prediction by the recursion of Levinson (1947) and Durbin (1960); the earliest
/// weight first.
fn levinson_durbin(covariance: &[f64; ORDER + 1]) -> [f64; ORDER] {
    let mut weights = [0.0; ORDER];
    // Power of the prediction error of order m.
    let mut error = covariance[0];
    for m in 0..ORDER {
        // The covariance at the next lag that the prediction of order m does not explain, as a share of its error.
        let explained: f64 = (0..m).map(|i| weights[i] * covariance[m - i]).sum();
        let reflection = (covariance[m + 1] - explained) / error;
        // Each weight changes by the reflection coefficient times its mirror image.
        let old = weights;
        for i in 0..m {
            weights[i] = old[i] - reflection * old[m - 1 - i];
        }
        weights[m] = reflection;
        error *= 1.0 - reflection * reflection;
    }
    weights.reverse();
    weights
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levinson_durbin_recovers_an_autoregression() {
        // x[n] = 0.9 x[n-1] + w has covariance 0.9^k.
        let covariance = std::array::from_fn(|k| 0.9f64.powf(k as f64));
        let weights = levinson_durbin(&covariance);
        assert!((weights[ORDER - 1] - 0.9).abs() < 1e-12);
        assert!(weights[..ORDER - 1].iter().all(|w| w.abs() < 1e-12));
    }

    #[test]
    fn a_tone_with_an_offset_is_predicted() {
        let tone: Vec<f32> = (0..600)
            .map(|n| 0.3 + 0.5 * (0.2 * n as f32).sin())
            .collect();
        let model = Autoregression::learn(&tone[..400], 1e-12);
        let error: f32 = model
            .errors(&tone[400..])
            .iter()
            .map(|e| e * e)
            .sum::<f32>()
            / 190.0;
        assert!(error < 1e-4 * 0.125, "{error}");
    }
}
