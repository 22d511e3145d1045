//! The trend of the ratio of successive flights, learnt by a Kalman filter.

use crate::train::parameters::{
    MAX_LN_RATIO, MAX_TREND_STEP, MIN_LN_RATIO, TREND_FALL, TREND_FALL_SD, TREND_WANDERING,
};

/// How the ratio of successive flights changes as they get shorter: its logarithm is a - b T², with T the
/// duration of the longer flight. Drag takes a share of the speed that grows with its square, and most
/// surfaces take more of a fast impact.
///
/// The state of the filter is (a, b); an observed ratio measures a - b T², that is, its measurement matrix is (1, -T²).
#[derive(Clone, Copy, Default)]
pub(super) struct Trend {
    /// a: logarithm of the ratio of short flights.
    ln_ratio: f64,
    /// b, in 1/s².
    fall: f64,
    /// Covariance of the two: of a with a, of a with b, of b with b.
    covariance: [f64; 3],
}

impl Trend {
    /// The trend after the ratio of the first two flights; `flight2` is the square of the first flight, in s².
    pub(super) fn new(ln_ratio: f64, flight2: f64, scatter2: f64) -> Self {
        // b has its prior, and a = ln_ratio + b T² follows from both: the covariance is that of this sum.
        let fall2 = TREND_FALL_SD * TREND_FALL_SD;
        Self {
            ln_ratio: ln_ratio + TREND_FALL * flight2,
            fall: TREND_FALL,
            covariance: [scatter2 + flight2 * flight2 * fall2, flight2 * fall2, fall2],
        }
    }

    /// Logarithm of the next flight over one whose duration has this square, in s².
    pub(super) fn ln_ratio(&self, flight2: f64) -> f64 {
        let ln_ratio = self.ln_ratio - self.fall * flight2;
        ln_ratio.clamp(MIN_LN_RATIO.min(self.ln_ratio), MAX_LN_RATIO)
    }

    /// Whether the ball keeps less of its speed than any of which a drop is recognised.
    pub(super) fn is_dull(&self) -> bool {
        self.ln_ratio < MIN_LN_RATIO
    }

    /// The variance of this prediction due to the uncertainty of a and b.
    pub(super) fn variance(&self, flight2: f64) -> f64 {
        let [ratio, both, fall] = self.covariance;
        ratio - flight2 * (2.0 * both - flight2 * fall)
    }

    /// The trend after a ratio that differs from the predicted one by `surprise`, whose variance is `variance`.
    pub(super) fn learn(&self, surprise: f64, variance: f64, flight2: f64, scatter2: f64) -> Self {
        let [ratio, both, fall] = self.covariance;
        // The Kalman gain: the covariance of (a, b) with the prediction, over the variance of the surprise.
        let gains = [ratio - flight2 * both, both - flight2 * fall].map(|it| it / variance);
        let step = surprise.clamp(-MAX_TREND_STEP, MAX_TREND_STEP);
        // The covariance shrinks by gain times variance times gain, whatever the surprise; then a wanders.
        Self {
            ln_ratio: self.ln_ratio + gains[0] * step,
            fall: self.fall + gains[1] * step,
            covariance: [
                ratio - gains[0] * gains[0] * variance + TREND_WANDERING * scatter2,
                both - gains[0] * gains[1] * variance,
                fall - gains[1] * gains[1] * variance,
            ],
        }
    }
}
