//! Repeatability and reproducibility of rebounds, after ISO 5725-2.

use statrs::distribution::{ChiSquared, ContinuousCDF};

use crate::estimate::Estimate;
use crate::stats;

/// How results differ under equal conditions, and under conditions that differ in one factor, as the place or the operator.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Precision {
    /// How many levels of the factor there are.
    pub levels: usize,
    /// How many drops.
    pub drops: usize,
    /// Standard deviation of drops at one level, m.
    pub repeatability_m: Estimate,
    /// Standard deviation of drops of which each is at another level, m.
    pub reproducibility_m: Estimate,
}

impl Precision {
    /// By an analysis of variance (ISO 5725-2) of the heights at each level, in metres; `None` unless there are two
    /// levels, one of which has two drops.
    ///
    /// ```
    /// use bouncelab::rulebook::Precision;
    ///
    /// // Variance within 0.5, of the means 2: between levels 2 - 0.5/2 = 1.75.
    /// let precision = Precision::of(&[vec![1.0, 2.0], vec![3.0, 4.0]]).unwrap();
    /// assert!((precision.repeatability_m.value - 0.5_f64.sqrt()).abs() < 1e-12);
    /// assert!((precision.reproducibility_m.value - 1.5).abs() < 1e-12);
    /// ```
    pub fn of(levels: &[Vec<f64>]) -> Option<Self> {
        let levels: Vec<&Vec<f64>> = levels.iter().filter(|level| !level.is_empty()).collect();
        let counts: Vec<f64> = levels.iter().map(|level| level.len() as f64).collect();
        let drops: f64 = counts.iter().sum();
        let between = counts.len() as f64 - 1.0;
        let within = drops - counts.len() as f64;
        if between < 1.0 || within < 1.0 {
            return None;
        }
        let means: Vec<f64> = levels.iter().map(|level| stats::mean(level)).collect();
        let weighted = means.iter().zip(&counts).map(|(mean, count)| mean * count);
        let grand = weighted.sum::<f64>() / drops;
        let squares = |values: &[f64], mean: f64| -> f64 {
            values.iter().map(|value| (value - mean).powi(2)).sum()
        };
        let of_levels = levels.iter().zip(&means);
        let repeated = of_levels
            .map(|(level, mean)| squares(level, *mean))
            .sum::<f64>()
            / within;
        let of_means = means.iter().zip(&counts);
        let spread = of_means
            .map(|(mean, count)| count * (mean - grand).powi(2))
            .sum::<f64>()
            / between;
        // The mean number of drops of a level, as the standard weighs it.
        let count =
            (drops - counts.iter().map(|count| count.powi(2)).sum::<f64>() / drops) / between;
        // s_R² = s_L² + s_r² with s_L² = (s_d² - s_r²)/n, which is not below 0.
        let parts = [
            (spread / count, between),
            ((1.0 - 1.0 / count) * repeated, within),
        ];
        Some(Self {
            levels: counts.len(),
            drops: drops as usize,
            repeatability_m: deviation(&[(repeated, within)], 0.0),
            reproducibility_m: deviation(&parts, repeated),
        })
    }

    /// What two results under these conditions differ by with a probability of 95 %, m (ISO 5725-6).
    ///
    /// ```
    /// assert!((bouncelab::rulebook::Precision::limit_m(0.01) - 0.028).abs() < 1e-12);
    /// ```
    pub fn limit_m(standard_deviation_m: f64) -> f64 {
        2.8 * standard_deviation_m
    }
}

/// The root of a sum of independent variances, each with its degrees of freedom, which is not below `least`. Its intervals
/// are those of Graybill and Wang (Journal of the American Statistical Association 75 (1980) 869), for one variance the exact
/// ones of the chi-squared distribution; with the degrees of freedom of Welch and Satterthwaite they would be too short.
fn deviation(parts: &[(f64, f64)], least: f64) -> Estimate {
    let sum: f64 = parts.iter().map(|(variance, _)| variance).sum();
    let value = sum.max(least).sqrt();
    // How far the end of the interval is from the sum: of each part its own, and of all the root of their squares.
    let off = |share: f64| -> f64 {
        let squares = parts.iter().map(|(variance, degrees)| {
            let quantile = ChiSquared::new(*degrees).map_or(0.0, |chi| chi.inverse_cdf(share));
            (variance * (1.0 - degrees / quantile)).powi(2)
        });
        squares.sum::<f64>().sqrt()
    };
    let interval = |tail: f64| {
        [
            (sum - off(1.0 - tail)).max(0.0).sqrt(),
            (sum + off(tail)).sqrt(),
        ]
    };
    let scatter = parts
        .iter()
        .map(|(variance, degrees)| 2.0 * variance.powi(2) / degrees);
    Estimate {
        value,
        sd: if value > 0.0 {
            scatter.sum::<f64>().sqrt() / (2.0 * value)
        } else {
            0.0
        },
        interval68: interval(0.158_655),
        interval95: interval(0.025),
    }
}
