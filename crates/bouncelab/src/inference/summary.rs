//! What a posterior says of one quantity.

use crate::stats::sd;
use crate::stats::{quantile, sorted};

/// The posterior of one quantity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Summary {
    /// The median.
    pub value: f64,
    /// Standard deviation.
    pub sd: f64,
    /// The middle 68.27 %: what one standard deviation either way holds of a normal distribution.
    pub interval68: [f64; 2],
    /// The middle 95 %.
    pub interval95: [f64; 2],
}

/// Half of 1 - 0.6827.
const TAIL68: f64 = 0.158_655;
const TAIL95: f64 = 0.025;

impl Summary {
    /// The summary of equally likely values; `None` without a finite value.
    pub fn of(values: impl IntoIterator<Item = f64>) -> Option<Self> {
        let sorted = sorted(values.into_iter().filter(|v| v.is_finite()));
        let at = |share: f64| quantile(&sorted, share);
        Some(Self {
            value: at(0.5)?,
            sd: sd(&sorted),
            interval68: [at(TAIL68)?, at(1.0 - TAIL68)?],
            interval95: [at(TAIL95)?, at(1.0 - TAIL95)?],
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_summary_of_evenly_spread_values() {
        let summary = Summary::of((0..1000).map(|i| (f64::from(i) + 0.5) / 1000.0)).unwrap();
        assert!((summary.value - 0.5).abs() < 1e-9);
        assert!((summary.sd - 12.0_f64.sqrt().recip()).abs() < 1e-6);
        assert!((summary.interval95[0] - 0.025).abs() < 1e-9);
        assert!((summary.interval68[1] - 0.841_345).abs() < 1e-9);
        assert_eq!(Summary::of([f64::NAN]), None);
    }
}
