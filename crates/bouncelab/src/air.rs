//! Density and viscosity of air.
//!
//! ```
//! use bouncelab::air::{Air, Conditions};
//!
//! let air = Air::moist(&Conditions::default())?; // 20 °C, 101 325 Pa, half saturated
//! assert_eq!(format!("{:.4}", air.density_kg_m3()), "1.1993");
//! # Ok::<(), bouncelab::Error>(())
//! ```

use crate::ball::Ball;
use crate::error::{Quantity, Result, of_a_size, within};

/// A still gas (or liquid) of uniform density and viscosity, or nothing at all.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Air {
    density_kg_m3: f64,
    viscosity_pa_s: f64,
}

impl Air {
    /// Air of a known density and dynamic viscosity.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) unless both are from 1e-20 to 1e20. For no air
    /// at all use [`Air::vacuum`].
    ///
    /// ```
    /// use bouncelab::air::Air;
    ///
    /// let water = Air::new(998.2, 1.002e-3)?;
    /// assert_eq!(water.density_kg_m3(), 998.2);
    /// assert!(Air::new(-1.2, 1.8e-5).is_err());
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn new(density_kg_m3: f64, viscosity_pa_s: f64) -> Result<Self> {
        Ok(Self {
            density_kg_m3: of_a_size(Quantity::AirDensity, density_kg_m3)?,
            viscosity_pa_s: of_a_size(Quantity::AirViscosity, viscosity_pa_s)?,
        })
    }

    /// No air: no drag, no buoyancy, no added mass.
    ///
    /// ```
    /// let nothing = bouncelab::air::Air::vacuum();
    /// assert!(nothing.is_vacuum());
    /// ```
    pub const fn vacuum() -> Self {
        Self {
            density_kg_m3: 0.0,
            viscosity_pa_s: 0.0,
        }
    }

    /// Moist air: density by the CIPM-2007 equation (Picard et al. 2008, with 400 ppm of carbon
    /// dioxide), viscosity by Sutherland's law (US Standard Atmosphere 1976, which neglects
    /// humidity: less than 1 % indoors).
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) outside 250 to 330 K, 30 to 120 kPa or a
    /// relative humidity of 0 to 1. The equation promises its 22 ppm in a narrower range: see
    /// [`Conditions::within_cipm_range`].
    ///
    /// ```
    /// use bouncelab::air::{Air, Conditions};
    ///
    /// let usual = Conditions::default();
    /// let hot = Conditions { temperature_k: 308.15, ..usual };
    /// assert!(Air::moist(&hot)?.density_kg_m3() < Air::moist(&usual)?.density_kg_m3());
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn moist(conditions: &Conditions) -> Result<Self> {
        let Conditions {
            temperature_k,
            pressure_pa,
            relative_humidity,
        } = *conditions;
        within(Quantity::AirTemperature, temperature_k, 250.0..=330.0)?;
        within(Quantity::AirPressure, pressure_pa, 30e3..=120e3)?;
        within(Quantity::Humidity, relative_humidity, 0.0..=1.0)?;
        Self::new(
            cipm_2007_density_kg_m3(conditions),
            sutherland_viscosity_pa_s(temperature_k),
        )
    }

    /// Density in kg/m³; zero in a vacuum.
    pub fn density_kg_m3(&self) -> f64 {
        self.density_kg_m3
    }

    /// Dynamic viscosity in Pa s; zero in a vacuum.
    pub fn viscosity_pa_s(&self) -> f64 {
        self.viscosity_pa_s
    }

    /// Whether there is no air.
    pub fn is_vacuum(&self) -> bool {
        self.density_kg_m3 == 0.0
    }

    /// Reynolds number ρ v D/μ of a ball at a speed; zero in a vacuum.
    ///
    /// ```
    /// use bouncelab::air::Air;
    /// use bouncelab::ball;
    ///
    /// // The paper: 6200 at the first impact.
    /// let air = Air::new(1.2276, 1.8414e-5)?;
    /// let ball = ball::preset("table-tennis-38")?.known.ball;
    /// assert_eq!(air.reynolds(&ball, 2.446).round(), 6197.0);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn reynolds(&self, ball: &Ball, speed_m_s: f64) -> f64 {
        if self.is_vacuum() {
            return 0.0;
        }
        self.density_kg_m3 * speed_m_s * ball.diameter_m() / self.viscosity_pa_s
    }
}

impl Ball {
    /// Buoyancy ρ g V in newtons.
    ///
    /// ```
    /// use bouncelab::air::Air;
    /// use bouncelab::ball;
    ///
    /// // The paper: 1.41 % of the weight.
    /// let air = Air::new(1.2276, 1.8414e-5)?;
    /// let ball = ball::preset("table-tennis-38")?.known.ball;
    /// let share = ball.buoyancy_n(&air, 9.81) / ball.weight_n(9.81);
    /// assert_eq!(format!("{:.2} %", 100.0 * share), "1.41 %");
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn buoyancy_n(&self, air: &Air, gravity_m_s2: f64) -> f64 {
        air.density_kg_m3 * gravity_m_s2 * self.volume_m3()
    }
}

/// Ambient conditions.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Conditions {
    /// Temperature in kelvin.
    pub temperature_k: f64,
    /// Pressure in pascal, as it is at the place (not reduced to sea level).
    pub pressure_pa: f64,
    /// Relative humidity from 0 (dry) to 1 (saturated).
    pub relative_humidity: f64,
}

impl Default for Conditions {
    /// Indoors at sea level: 20 °C, 101 325 Pa, half saturated.
    fn default() -> Self {
        Self {
            temperature_k: 293.15,
            pressure_pa: 101_325.0,
            relative_humidity: 0.5,
        }
    }
}

impl Conditions {
    /// Whether the density is as good as CIPM-2007 states (22 ppm): 15 to 27 °C, 600 to 1100 hPa.
    ///
    /// Outside, over all that [`Air::moist`] accepts, the equation lies within 0.4 % of the law of
    /// ideal gases: far closer than the drag of a ball is known.
    ///
    /// ```
    /// use bouncelab::air::Conditions;
    ///
    /// let usual = Conditions::default();
    /// let freezing = Conditions { temperature_k: 273.15, ..usual };
    /// assert!(usual.within_cipm_range() && !freezing.within_cipm_range());
    /// ```
    pub fn within_cipm_range(&self) -> bool {
        (288.15..=300.15).contains(&self.temperature_k)
            && (60e3..=110e3).contains(&self.pressure_pa)
    }
}

/// Density of moist air, CIPM-2007: Picard, Davis, Gläser & Fujii 2008, Metrologia 45, 149.
fn cipm_2007_density_kg_m3(conditions: &Conditions) -> f64 {
    const GAS_CONSTANT: f64 = 8.314_472;
    const MOLAR_MASS_DRY: f64 = 28.965_46e-3;
    const MOLAR_MASS_WATER: f64 = 18.015_28e-3;

    let Conditions {
        temperature_k,
        pressure_pa,
        relative_humidity,
    } = *conditions;
    let celsius = temperature_k - 273.15;
    let saturation_pa = (1.237_884_7e-5 * temperature_k * temperature_k
        - 1.912_131_6e-2 * temperature_k
        + 33.937_110_47
        - 6.343_164_5e3 / temperature_k)
        .exp();
    let enhancement = 1.000_62 + 3.14e-8 * pressure_pa + 5.6e-7 * celsius * celsius;
    let vapour = relative_humidity * enhancement * saturation_pa / pressure_pa;
    let z = compressibility(pressure_pa / temperature_k, celsius, vapour);
    pressure_pa * MOLAR_MASS_DRY / (z * GAS_CONSTANT * temperature_k)
        * (1.0 - vapour * (1.0 - MOLAR_MASS_WATER / MOLAR_MASS_DRY))
}

/// Compressibility factor Z of moist air, CIPM-2007; `vapour` is the mole fraction of water.
fn compressibility(pressure_over_temperature: f64, celsius: f64, vapour: f64) -> f64 {
    let a = 1.581_23e-6 - 2.9331e-8 * celsius + 1.1043e-10 * celsius * celsius;
    let b = 5.707e-6 - 2.051e-8 * celsius;
    let c = 1.9898e-4 - 2.376e-6 * celsius;
    1.0 - pressure_over_temperature * (a + b * vapour + c * vapour * vapour)
        + pressure_over_temperature.powi(2) * (1.83e-11 - 0.765e-8 * vapour * vapour)
}

/// Sutherland's law with the constants of the US Standard Atmosphere 1976.
fn sutherland_viscosity_pa_s(temperature_k: f64) -> f64 {
    1.458e-6 * temperature_k.powf(1.5) / (temperature_k + 110.4)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn at(celsius: f64, pressure_pa: f64, relative_humidity: f64) -> Air {
        let temperature_k = celsius + 273.15;
        Air::moist(&Conditions {
            temperature_k,
            pressure_pa,
            relative_humidity,
        })
        .unwrap()
    }

    /// Densities computed independently from the published equation, to all their digits.
    #[test]
    fn density_follows_cipm_2007() {
        for (celsius, pressure_pa, humidity, density) in [
            (20.0, 101_325.0, 0.5, "1.1993139"),
            (20.0, 101_325.0, 0.0, "1.2045573"),
            (15.0, 101_325.0, 0.0, "1.2255213"),
            (25.0, 101_325.0, 0.5, "1.1773154"),
            (22.5, 85_000.0, 0.3, "0.9982228"),
        ] {
            assert_eq!(
                format!("{:.7}", at(celsius, pressure_pa, humidity).density_kg_m3()),
                density
            );
        }
    }

    /// US Standard Atmosphere 1976: 1.789 38e-5 Pa s at 15 °C.
    #[test]
    fn viscosity_follows_sutherland() {
        for (celsius, viscosity) in [(20.0, "1.81341e-5"), (15.0, "1.78938e-5")] {
            assert_eq!(
                format!("{:.5e}", at(celsius, 101_325.0, 0.0).viscosity_pa_s()),
                viscosity
            );
        }
    }

    /// Beyond its stated range the equation stays near the ideal gas, so it can be trusted there too.
    #[test]
    fn density_stays_near_the_ideal_gas() {
        for celsius in [-23.0, 0.0, 20.0, 56.0] {
            for pressure_pa in [30e3, 101_325.0, 120e3] {
                let per_kg = 8.314_472 * (celsius + 273.15) / 28.965_46e-3;
                let ratio = at(celsius, pressure_pa, 0.0).density_kg_m3() * per_kg / pressure_pa;
                assert!(
                    (ratio - 1.0).abs() < 3e-3,
                    "{celsius} {pressure_pa}: {ratio}"
                );
                let moist = at(celsius, pressure_pa, 1.0).density_kg_m3();
                let vapour = 611.2 * (17.62 * celsius / (243.12 + celsius)).exp() / pressure_pa;
                let ideal = pressure_pa / per_kg * (1.0 - 0.378 * vapour);
                assert!(
                    (moist / ideal - 1.0).abs() < 4e-3,
                    "{celsius} {pressure_pa}: moist"
                );
            }
        }
    }

    #[test]
    fn absurd_air_is_refused() {
        assert!(Air::new(-1.2, 1.8e-5).is_err());
        assert!(Air::new(1.2, 0.0).is_err());
        let usual = Conditions::default();
        for conditions in [
            Conditions {
                temperature_k: 20.0,
                ..usual
            },
            Conditions {
                pressure_pa: 1013.25,
                ..usual
            },
            Conditions {
                relative_humidity: 50.0,
                ..usual
            },
            Conditions {
                temperature_k: f64::NAN,
                ..usual
            },
        ] {
            assert!(Air::moist(&conditions).is_err(), "{conditions:?}");
        }
    }

    #[test]
    fn the_stated_range_of_cipm_is_known() {
        let usual = Conditions::default();
        assert!(usual.within_cipm_range());
        assert!(
            !Conditions {
                temperature_k: 283.15,
                ..usual
            }
            .within_cipm_range()
        );
        assert!(
            !Conditions {
                pressure_pa: 55e3,
                ..usual
            }
            .within_cipm_range()
        );
    }
}
