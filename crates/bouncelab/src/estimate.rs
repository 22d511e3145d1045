//! An estimate: a value with its uncertainty.

use statrs::distribution::{ContinuousCDF, Normal, StudentsT};

use crate::stats::{quantiles, sd};

/// A number found from data, with its uncertainty.
///
/// ```
/// use bouncelab::Estimate;
///
/// let height_m = Estimate::normal(0.305, 0.002);
/// assert!((height_m.interval95[1] - 0.3089).abs() < 1e-4);
/// assert_eq!(Estimate::unbounded(0.9).known_sd(), None);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Estimate {
    /// The number: of a posterior, the median.
    pub value: f64,
    /// Standard uncertainty, in the same unit; infinite if the data leave nothing to judge it by
    /// (`null` in JSON).
    #[cfg_attr(feature = "serde", serde(with = "number"))]
    #[cfg_attr(feature = "typescript", ts(type = "number | null"))]
    pub sd: f64,
    /// The middle 68.27 %: what one standard deviation either way holds of a normal distribution.
    #[cfg_attr(feature = "serde", serde(with = "interval"))]
    #[cfg_attr(feature = "typescript", ts(type = "[number, number] | null"))]
    pub interval68: [f64; 2],
    /// The middle 95 %.
    #[cfg_attr(feature = "serde", serde(with = "interval"))]
    #[cfg_attr(feature = "typescript", ts(type = "[number, number] | null"))]
    pub interval95: [f64; 2],
}

/// Half of 1 - 0.6827.
const TAIL68: f64 = 0.158_655;
const TAIL95: f64 = 0.025;

impl Estimate {
    /// The summary of equally likely values: median, standard deviation and central intervals; `None`
    /// without a finite value.
    ///
    /// ```
    /// use bouncelab::Estimate;
    ///
    /// let estimate = Estimate::of_draws((0..=100).map(f64::from)).unwrap();
    /// assert_eq!(estimate.value, 50.0);
    /// assert!(estimate.interval95[0] < 3.0 && estimate.interval95[1] > 97.0);
    /// assert_eq!(Estimate::of_draws([]), None);
    /// ```
    pub fn of_draws(values: impl IntoIterator<Item = f64>) -> Option<Self> {
        let mut values: Vec<f64> = values.into_iter().collect();
        values.retain(|value| value.is_finite());
        let sd = sd(&values);
        let shares = [TAIL95, TAIL68, 0.5, 1.0 - TAIL68, 1.0 - TAIL95];
        let [low95, low68, value, high68, high95] = quantiles(&mut values, shares)?;
        Some(Self {
            value,
            sd,
            interval68: [low68, high68],
            interval95: [low95, high95],
        })
    }

    /// The same value with intervals that hold those of another estimate too.
    #[must_use]
    pub(crate) fn covering(self, other: &Self) -> Self {
        let both = |[low, high]: [f64; 2], other: [f64; 2]| [low.min(other[0]), high.max(other[1])];
        Self {
            interval68: both(self.interval68, other.interval68),
            interval95: both(self.interval95, other.interval95),
            ..self
        }
    }

    /// A normally distributed quantity.
    pub fn normal(value: f64, sd: f64) -> Self {
        Self::with_tails(value, sd, |share| {
            Normal::standard().inverse_cdf(1.0 - share)
        })
    }

    /// A quantity whose standard uncertainty was itself estimated with so many degrees of freedom:
    /// the intervals are those of Student's t (JCGM 100:2008, annex G).
    ///
    /// ```
    /// use bouncelab::Estimate;
    ///
    /// // Few degrees of freedom: wider than a normal distribution.
    /// let [low, high] = Estimate::student(0.0, 1.0, 3.0).interval95;
    /// assert!((high - 3.18).abs() < 0.01 && (low + high).abs() < 1e-9);
    /// ```
    pub fn student(value: f64, sd: f64, degrees_of_freedom: f64) -> Self {
        match StudentsT::new(0.0, 1.0, degrees_of_freedom) {
            Ok(t) => Self::with_tails(value, sd, |share| t.inverse_cdf(1.0 - share)),
            Err(_) => Self::unbounded(value),
        }
    }

    /// A number of which the data do not say how certain it is.
    pub const fn unbounded(value: f64) -> Self {
        let all = [f64::NEG_INFINITY, f64::INFINITY];
        Self {
            value,
            sd: f64::INFINITY,
            interval68: all,
            interval95: all,
        }
    }

    /// The standard uncertainty, if the data say how large it is.
    pub fn known_sd(&self) -> Option<f64> {
        Some(self.sd).filter(|sd| sd.is_finite())
    }

    fn with_tails(value: f64, sd: f64, quantile: impl Fn(f64) -> f64) -> Self {
        if !sd.is_finite() {
            return Self::unbounded(value);
        }
        let interval = |tail: f64| {
            let half = quantile(tail) * sd;
            [value - half, value + half]
        };
        Self {
            value,
            sd,
            interval68: interval(TAIL68),
            interval95: interval(TAIL95),
        }
    }
}

/// A number that is `null` in JSON if it is infinite.
#[cfg(feature = "serde")]
pub(crate) mod number {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    #[expect(
        clippy::trivially_copy_pass_by_ref,
        reason = "the signature is serde's"
    )]
    pub(crate) fn serialize<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
        Some(*value)
            .filter(|value| value.is_finite())
            .serialize(serializer)
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
        Ok(Option::deserialize(from)?.unwrap_or(f64::INFINITY))
    }
}

/// An interval that is `null` in JSON if it is unbounded.
#[cfg(feature = "serde")]
mod interval {
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    pub(crate) fn serialize<S: Serializer>(ends: &[f64; 2], to: S) -> Result<S::Ok, S::Error> {
        Some(*ends)
            .filter(|ends| ends.iter().all(|end| end.is_finite()))
            .serialize(to)
    }

    pub(crate) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<[f64; 2], D::Error> {
        Ok(Option::deserialize(from)?.unwrap_or([f64::NEG_INFINITY, f64::INFINITY]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_summary_of_evenly_spread_values() {
        let summary = Estimate::of_draws((0..1000).map(|i| (f64::from(i) + 0.5) / 1000.0)).unwrap();
        assert!((summary.value - 0.5).abs() < 1e-9);
        assert!((summary.sd - 12.0_f64.sqrt().recip()).abs() < 1e-6);
        assert!((summary.interval95[0] - 0.025).abs() < 1e-9);
        assert!((summary.interval68[1] - 0.841_345).abs() < 1e-9);
        assert_eq!(Estimate::of_draws([f64::NAN]), None);
    }

    /// Textbook quantiles: 1.960 for the normal distribution, 4.303 for t with two degrees of freedom.
    #[test]
    fn intervals_are_quantiles() {
        let normal = Estimate::normal(1.0, 0.1);
        assert!((normal.interval95[1] - 1.195_996).abs() < 1e-6);
        assert!((normal.interval68[1] - 1.1).abs() < 1e-5);
        let student = Estimate::student(0.0, 1.0, 2.0);
        assert!((student.interval95[1] - 4.302_65).abs() < 1e-4);
        assert_eq!(Estimate::student(3.0, 1.0, 0.0), Estimate::unbounded(3.0));
    }

    #[cfg(feature = "serde")]
    #[test]
    fn what_is_unbounded_is_null() {
        let json = serde_json::to_value(Estimate::unbounded(0.9)).unwrap();
        assert!(json["sd"].is_null() && json["interval95"].is_null());
        let back: Estimate = serde_json::from_value(json).unwrap();
        assert_eq!(back, Estimate::unbounded(0.9));
    }
}
