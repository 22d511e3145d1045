//! Gravity.

use super::plausibility::{Ordinary, reading, shown};
use crate::Result;
use crate::diagnostic::{Code, Diagnostic};
use crate::gravity;
use crate::inference::Priors;

/// Relative standard uncertainty of gravity that was measured, or computed of the place.
const REL_SD: f64 = 1e-4;

/// What is given of gravity.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(optional_fields))]
pub struct GravitySettings {
    /// Acceleration of gravity; standard gravity if left out.
    pub gravity_m_s2: Option<f64>,
    /// Latitude in degrees, north positive, from which gravity follows in place of a measurement.
    pub latitude_deg: Option<f64>,
    /// Height above the sea; goes with the latitude, 0 if left out.
    pub altitude_m: Option<f64>,
}

/// Ordinary values.
pub(super) const ORDINARY: &[Ordinary] = &[
    Ordinary {
        quantity: "gravity",
        given: |settings| settings.gravity.gravity_m_s2,
        // From a small moon to the largest planet.
        range: 0.1..=30.0,
        shown: shown("m/s2"),
        readings: &[reading(0.01, "cm/s2")],
    },
    Ordinary {
        quantity: "altitude",
        given: |settings| settings.gravity.altitude_m,
        range: -500.0..=9000.0,
        shown: shown("m"),
        readings: &[reading(0.3048, "ft")],
    },
];

impl GravitySettings {
    pub(super) fn resolve(&self, assumptions: &mut Vec<Diagnostic>) -> Result<f64> {
        match (self.gravity_m_s2, self.latitude_deg) {
            (Some(gravity_m_s2), _) => Ok(gravity_m_s2),
            (None, Some(latitude_deg)) => gravity::at(latitude_deg, self.altitude_m.unwrap_or(0.0)),
            (None, None) => {
                let assumed = Diagnostic::new(Code::AssumedGravity);
                assumptions.push(assumed.with("gravity_m_s2", gravity::STANDARD_M_S2));
                Ok(gravity::STANDARD_M_S2)
            }
        }
    }

    pub(super) fn inform(&self, priors: &mut Priors) {
        if self.gravity_m_s2.is_some() || self.latitude_deg.is_some() {
            priors.gravity_rel_sd = REL_SD;
        }
    }
}
