//! Repeatability and reproducibility of rebounds, after ISO 5725-2:2019.

use statrs::distribution::{ChiSquared, ContinuousCDF};

use crate::estimate::Estimate;
use crate::stats;

/// How results differ under equal conditions, and under conditions that differ in one factor, as the place or the operator.
#[derive(Debug, Clone, Copy, PartialEq)]
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
    /// By an analysis of variance (ISO 5725-2:2019, 7.4) of the heights at each level, in metres; `None` unless there are two
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
        let sum: f64 = parts.iter().map(|(variance, _)| variance).sum();
        let weights: f64 = parts
            .iter()
            .map(|(variance, degrees)| variance.powi(2) / degrees)
            .sum();
        let degrees = if weights > 0.0 {
            sum.powi(2) / weights
        } else {
            within
        };
        Some(Self {
            levels: counts.len(),
            drops: drops as usize,
            repeatability_m: deviation(repeated, within),
            reproducibility_m: deviation(sum.max(repeated), degrees),
        })
    }

    /// What two results under these conditions differ by with a probability of 95 %, m (ISO 5725-6:1994, 4.1.4).
    ///
    /// ```
    /// assert_eq!(bouncelab::rulebook::Precision::limit_m(0.01), 0.028);
    /// ```
    pub fn limit_m(standard_deviation_m: f64) -> f64 {
        2.8 * standard_deviation_m
    }
}

/// A standard deviation of which the square has so many degrees of freedom (of several variances by Welch and
/// Satterthwaite), with the intervals of the chi-squared distribution.
fn deviation(variance: f64, degrees: f64) -> Estimate {
    let value = variance.sqrt();
    let Ok(chi) = ChiSquared::new(degrees) else {
        return Estimate::unbounded(value);
    };
    let end = |share: f64| (variance * degrees / chi.inverse_cdf(share)).sqrt();
    let interval = |tail: f64| [end(1.0 - tail), end(tail)];
    Estimate {
        value,
        sd: value / (2.0 * degrees).sqrt(),
        interval68: interval(0.158_655),
        interval95: interval(0.025),
    }
}
