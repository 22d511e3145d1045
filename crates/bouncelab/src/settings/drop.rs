//! The drop: its height, its release and its first impact.

use super::plausibility::{Ordinary, reading, shown};
use crate::inference::{Measured, Priors};

/// Standard uncertainty of a height by a ruler, in metres.
pub(super) const HEIGHT_SD_M: f64 = 0.002;
/// Standard uncertainty of a release that is seen in a video, or heard, in seconds.
const RELEASE_SD_S: f64 = 0.005;

/// What is given of the drop.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(optional_fields))]
pub struct DropSettings {
    /// Measured drop height, surface to lowest point of the ball.
    pub height_m: Option<f64>,
    /// Its standard uncertainty; that of a ruler, 2 mm, if left out.
    pub height_sd_m: Option<f64>,
    /// Time of the release in the recording.
    pub release_s: Option<f64>,
    /// Its standard uncertainty; 5 ms if left out.
    pub release_sd_s: Option<f64>,
    /// Whether the first impact detected is the first impact of the drop; `false` if left out.
    pub first_detected: Option<bool>,
}

/// Ordinary values.
pub(super) const ORDINARY: &[Ordinary] = &[
    Ordinary {
        quantity: "height",
        given: |settings| settings.drop.height_m,
        range: 0.01..=10.0,
        shown: shown("m"),
        readings: &[
            reading(0.01, "cm"),
            reading(0.001, "mm"),
            reading(0.0254, "in"),
        ],
    },
    Ordinary {
        quantity: "height-sd",
        given: |settings| settings.drop.height_sd_m,
        range: 1e-5..=0.1,
        shown: shown("m"),
        readings: &[reading(0.01, "cm"), reading(0.001, "mm")],
    },
];

impl DropSettings {
    pub(super) fn inform(&self, priors: &mut Priors) {
        let measured = |value: Option<f64>, sd: f64| value.map(|value| Measured { value, sd });
        let height_sd_m = self.height_sd_m.unwrap_or(HEIGHT_SD_M);
        let release_sd_s = self.release_sd_s.unwrap_or(RELEASE_SD_S);
        priors.drop_height_m = measured(self.height_m, height_sd_m);
        priors.release_s = measured(self.release_s, release_sd_s);
        priors.first_was_detected = self.first_detected == Some(true);
    }
}
