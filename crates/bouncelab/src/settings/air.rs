//! The air, and its forces on the ball.

use super::plausibility::{Ordinary, Reading, Shown, reading, shown};
use crate::Result;
use crate::air::{Air, Conditions};
use crate::diagnostic::{Code, Diagnostic};
use crate::drag::DragLaw;
use crate::inference::Priors;

/// Relative standard uncertainty of the density of air that was measured.
const DENSITY_REL_SD: f64 = 0.003;

/// What is given of the air.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(optional_fields))]
pub struct AirSettings {
    /// `none`, `constant:0.4` or the name of a drag law; the standard drag curve if left out.
    pub drag: Option<String>,
    /// Temperature.
    pub temperature_k: Option<f64>,
    /// Pressure.
    pub pressure_pa: Option<f64>,
    /// Relative humidity, 0 to 1.
    pub relative_humidity: Option<f64>,
    /// Density, in place of temperature, pressure and humidity; 0 is vacuum.
    pub density_kg_m3: Option<f64>,
    /// Viscosity; goes with the density.
    pub viscosity_pa_s: Option<f64>,
    /// Whether buoyancy acts on the ball; `true` if left out.
    pub buoyancy: Option<bool>,
    /// Whether the ball accelerates the air around it; `true` if left out.
    pub added_mass: Option<bool>,
}

/// Ordinary values.
pub(super) const ORDINARY: &[Ordinary] = &[
    Ordinary {
        quantity: "temperature",
        given: |settings| settings.air.temperature_k,
        range: 233.15..=333.15,
        shown: Shown {
            factor: 1.0,
            offset: -273.15,
            unit: "°C",
        },
        // Other scales do not begin at zero: `plausibility` handles them.
        readings: &[],
    },
    Ordinary {
        quantity: "pressure",
        given: |settings| settings.air.pressure_pa,
        range: 3e4..=1.2e5,
        shown: shown("Pa"),
        readings: &[
            reading(100.0, "hPa"),
            reading(1000.0, "kPa"),
            Reading {
                factor: 0.01,
                written: 0.01,
                unit: "Pa",
            },
            Reading {
                factor: 10.0,
                written: 0.01,
                unit: "kPa",
            },
        ],
    },
    Ordinary {
        quantity: "humidity",
        given: |settings| settings.air.relative_humidity,
        range: 0.0..=1.0,
        shown: Shown {
            factor: 100.0,
            offset: 0.0,
            unit: "%",
        },
        readings: &[reading(0.01, "%")],
    },
    Ordinary {
        quantity: "air-density",
        given: |settings| settings.air.density_kg_m3,
        range: 0.0..=20.0,
        shown: shown("kg/m3"),
        readings: &[reading(1e-3, "g/m3")],
    },
];

impl AirSettings {
    pub(super) fn drag(&self) -> Result<DragLaw> {
        let named = self.drag.as_deref().map(str::parse).transpose()?;
        Ok(named.unwrap_or(DragLaw::Standard))
    }

    pub(super) fn resolve(&self, assumptions: &mut Vec<Diagnostic>) -> Result<Air> {
        let usual = Conditions::default();
        match (self.density_kg_m3, self.viscosity_pa_s) {
            (Some(density_kg_m3), Some(viscosity_pa_s)) => {
                return Air::new(density_kg_m3, viscosity_pa_s);
            }
            (Some(0.0), None) => return Ok(Air::vacuum()),
            (Some(density_kg_m3), None) => {
                return Air::new(density_kg_m3, Air::moist(&usual)?.viscosity_pa_s());
            }
            (None, _) => {}
        }
        let conditions = Conditions {
            temperature_k: self.temperature_k.unwrap_or(usual.temperature_k),
            pressure_pa: self.pressure_pa.unwrap_or(usual.pressure_pa),
            relative_humidity: self.relative_humidity.unwrap_or(usual.relative_humidity),
        };
        let given = [self.temperature_k, self.pressure_pa, self.relative_humidity];
        if given.contains(&None) {
            assumptions.push(
                Diagnostic::new(Code::AssumedAir)
                    .with("temperature_k", conditions.temperature_k)
                    .with("pressure_pa", conditions.pressure_pa)
                    .with("relative_humidity", conditions.relative_humidity),
            );
        }
        Air::moist(&conditions)
    }

    /// The density is known well if it was given, or if temperature and pressure were: humidity hardly changes it.
    pub(super) fn inform(&self, priors: &mut Priors) {
        let by_weather = self.temperature_k.is_some() && self.pressure_pa.is_some();
        if self.density_kg_m3.is_some() || by_weather {
            priors.air_density_rel_sd = DENSITY_REL_SD;
        }
    }
}
