//! The ball: mass, diameter, presets with their source.
//!
//! ```
//! use bouncelab::ball::{self, Ball};
//!
//! let ball = ball::preset("table-tennis-38")?.ball;
//! assert_eq!(ball, Ball::new(2.5e-3, 38e-3)?);
//! assert_eq!(format!("{:.3e}", ball.weight_n(9.81)), "2.453e-2");
//! # Ok::<(), bouncelab::Error>(())
//! ```

use std::f64::consts::PI;

use crate::error::{Error, Quantity, Result, of_a_size};

/// Density of bearing steel (100Cr6, ISO 683-17), kg/m³.
const STEEL_KG_M3: f64 = 7810.0;

/// Density of soda-lime glass, of which marbles are made, kg/m³.
const GLASS_KG_M3: f64 = 2500.0;

/// A sphere with a mass and a diameter.
///
/// Both are from 1e-20 to 1e20: nothing outside bounces, and numbers end not far beyond.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Ball {
    mass_kg: f64,
    diameter_m: f64,
}

impl Ball {
    /// A ball of any mass and diameter.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless both are from 1e-20 to 1e20.
    ///
    /// ```
    /// use bouncelab::ball::Ball;
    ///
    /// let superball = Ball::new(46.9e-3, 0.047)?;
    /// assert_eq!(superball.mass_kg(), 46.9e-3);
    /// assert!(Ball::new(0.0, 0.047).is_err());
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn new(mass_kg: f64, diameter_m: f64) -> Result<Self> {
        Ok(Self {
            mass_kg: of_a_size(Quantity::BallMass, mass_kg)?,
            diameter_m: of_a_size(Quantity::BallDiameter, diameter_m)?,
        })
    }

    /// A solid steel bearing ball (density 7810 kg/m³).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless diameter and mass are from 1e-20 to 1e20.
    ///
    /// ```
    /// // A bearing ball of 10 mm weighs 4.09 g.
    /// let ball = bouncelab::ball::Ball::steel(0.01)?;
    /// assert_eq!(format!("{:.2} g", 1e3 * ball.mass_kg()), "4.09 g");
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn steel(diameter_m: f64) -> Result<Self> {
        Self::solid(STEEL_KG_M3, diameter_m)
    }

    /// A solid glass marble (density 2500 kg/m³).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless diameter and mass are from 1e-20 to 1e20.
    ///
    /// ```
    /// let marble = bouncelab::ball::Ball::glass(0.016)?;
    /// assert_eq!(format!("{:.2} g", 1e3 * marble.mass_kg()), "5.36 g");
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn glass(diameter_m: f64) -> Result<Self> {
        Self::solid(GLASS_KG_M3, diameter_m)
    }

    fn solid(density_kg_m3: f64, diameter_m: f64) -> Result<Self> {
        let diameter_m = of_a_size(Quantity::BallDiameter, diameter_m)?;
        Self::new(density_kg_m3 * sphere_volume_m3(diameter_m), diameter_m)
    }

    /// Mass in kilograms.
    pub fn mass_kg(&self) -> f64 {
        self.mass_kg
    }

    /// Diameter in metres.
    pub fn diameter_m(&self) -> f64 {
        self.diameter_m
    }

    /// Cross-section A = π D²/4 in square metres.
    pub fn area_m2(&self) -> f64 {
        PI / 4.0 * self.diameter_m * self.diameter_m
    }

    /// Volume V = π D³/6 in cubic metres.
    pub fn volume_m3(&self) -> f64 {
        sphere_volume_m3(self.diameter_m)
    }

    /// Weight m g in newtons.
    ///
    /// ```
    /// let ball = bouncelab::ball::preset("table-tennis-38")?.ball;
    /// assert_eq!(format!("{:.4} N", ball.weight_n(9.81)), "0.0245 N");
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn weight_n(&self, gravity_m_s2: f64) -> f64 {
        self.mass_kg * gravity_m_s2
    }
}

fn sphere_volume_m3(diameter_m: f64) -> f64 {
    PI / 6.0 * diameter_m.powi(3)
}

/// A ball one can name.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Preset {
    /// The name by which it is looked up, as in "table-tennis-40".
    pub name: &'static str,
    /// The name for people.
    pub label: &'static str,
    /// Mass and diameter.
    pub ball: Ball,
    /// How long one impact lasts on a hard surface, in seconds.
    ///
    /// An order of magnitude from the sports literature, good to a factor of two: it depends on
    /// the surface, the speed and the inflation. Measure it where it matters (it is 2 % of a late
    /// flight of a table-tennis ball).
    pub contact_time_s: f64,
    /// How well the rules fix the mass: relative standard uncertainty, the range as a rectangle.
    pub mass_sd: f64,
    /// The same for the diameter.
    pub diameter_sd: f64,
    /// How far its drag coefficient may lie from that of a smooth sphere: relative standard
    /// uncertainty. Felt, seams, holes and dimples are a judgement; the smooth laws themselves
    /// differ by 4 %.
    pub drag_sd: f64,
    /// Where mass and diameter come from.
    pub source: &'static str,
}

/// Every preset: the balls of sports whose rules fix mass and size.
///
/// Steel and glass balls come in any size: see [`Ball::steel`] and [`Ball::glass`].
///
/// ```
/// let names: Vec<_> = bouncelab::ball::presets().iter().map(|preset| preset.name).collect();
/// assert!(names.contains(&"tennis") && names.contains(&"basketball"));
/// ```
pub fn presets() -> &'static [Preset] {
    &PRESETS
}

/// The ball that is assumed where nobody says which: the first of the list.
pub(crate) fn usual() -> &'static Preset {
    &PRESETS[0]
}

/// The preset with a name.
///
/// # Errors
/// [`Error::UnknownName`] with the nearest name if there is none.
///
/// ```
/// let error = bouncelab::ball::preset("table-tenis").unwrap_err();
/// assert!(error.to_string().contains("the nearest is \"table-tennis-"));
/// ```
pub fn preset(name: &str) -> Result<&'static Preset> {
    PRESETS
        .iter()
        .find(|preset| preset.name == name)
        .ok_or_else(|| {
            let known: Vec<&str> = PRESETS.iter().map(|preset| preset.name).collect();
            Error::unknown_name("ball", name, &known)
        })
}

const fn ball(mass_g: f64, diameter_mm: f64) -> Ball {
    Ball {
        mass_kg: mass_g / 1000.0,
        diameter_m: diameter_mm / 1000.0,
    }
}

static PRESETS: [Preset; 10] = [
    Preset {
        name: "table-tennis-40",
        label: "table tennis 40+",
        ball: ball(2.7, 40.0),
        contact_time_s: 1e-3,
        mass_sd: 0.011,
        diameter_sd: 0.004,
        drag_sd: 0.04,
        source: "ITTF: 2.67-2.77 g, 40.00-40.60 mm; the nominal 2.7 g and 40.0 mm",
    },
    Preset {
        name: "table-tennis-38",
        label: "table tennis 38 mm (to 2000)",
        ball: ball(2.5, 38.0),
        contact_time_s: 1e-3,
        mass_sd: 0.012,
        diameter_sd: 0.004,
        drag_sd: 0.04,
        source: "ITTF rules until September 2000: 2.5 g, 38 mm",
    },
    Preset {
        name: "tennis",
        label: "tennis",
        ball: ball(57.7, 66.0),
        contact_time_s: 5e-3,
        mass_sd: 0.017,
        diameter_sd: 0.014,
        drag_sd: 0.3,
        source: "ITF: 56.0-59.4 g, 65.4-68.6 mm; the middle mass, 66 mm",
    },
    Preset {
        name: "football",
        label: "football, size 5",
        ball: ball(430.0, 220.0),
        contact_time_s: 1e-2,
        mass_sd: 0.027,
        diameter_sd: 0.008,
        drag_sd: 0.15,
        source: "IFAB law 2: 410-450 g, circumference 68-70 cm; the middle",
    },
    Preset {
        name: "basketball",
        label: "basketball, size 7",
        ball: ball(600.0, 243.0),
        contact_time_s: 1.5e-2,
        mass_sd: 0.019,
        diameter_sd: 0.008,
        drag_sd: 0.15,
        source: "FIBA: 580-620 g, circumference 75-77 cm; the middle mass, 76.3 cm",
    },
    Preset {
        name: "golf",
        label: "golf",
        ball: ball(45.93, 42.67),
        contact_time_s: 5e-4,
        mass_sd: 0.005,
        diameter_sd: 0.002,
        drag_sd: 0.15,
        source: "R&A: at most 45.93 g, at least 42.67 mm; both limits, as balls are made",
    },
    Preset {
        name: "squash",
        label: "squash",
        ball: ball(24.0, 40.0),
        contact_time_s: 4e-3,
        mass_sd: 0.024,
        diameter_sd: 0.007,
        drag_sd: 0.06,
        source: "World Squash: 23-25 g, 39.5-40.5 mm; the middle",
    },
    Preset {
        name: "racquetball",
        label: "racquetball",
        ball: ball(39.7, 57.15),
        contact_time_s: 4e-3,
        mass_sd: 0.01,
        diameter_sd: 0.006,
        drag_sd: 0.06,
        source: "USA Racquetball: 1.4 oz, 2 1/4 in",
    },
    Preset {
        name: "pickleball",
        label: "pickleball",
        ball: ball(24.3, 74.2),
        contact_time_s: 2e-3,
        mass_sd: 0.052,
        diameter_sd: 0.007,
        drag_sd: 0.3,
        source: "USA Pickleball: 0.78-0.935 oz, 2.87-2.97 in; the middle",
    },
    Preset {
        name: "padel",
        label: "padel",
        ball: ball(57.7, 65.6),
        contact_time_s: 5e-3,
        mass_sd: 0.017,
        diameter_sd: 0.019,
        drag_sd: 0.3,
        source: "FIP: 56.0-59.4 g, 63.5-67.7 mm; the middle",
    },
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn presets_have_unique_names_and_valid_balls() {
        for (i, preset) in presets().iter().enumerate() {
            assert!(presets()[..i].iter().all(|other| other.name != preset.name));
            assert_eq!(
                Ball::new(preset.ball.mass_kg(), preset.ball.diameter_m()),
                Ok(preset.ball),
                "{}",
                preset.name
            );
            assert!(preset.contact_time_s > 0.0);
        }
    }

    /// A 10 mm bearing ball weighs 4.09 g.
    #[test]
    fn solid_balls_follow_from_their_diameter() {
        assert!((Ball::steel(0.01).unwrap().mass_kg() - 4.09e-3).abs() < 5e-6);
        assert!((Ball::glass(0.016).unwrap().mass_kg() - 5.36e-3).abs() < 5e-6);
    }

    #[test]
    fn absurd_balls_are_refused() {
        for (mass_kg, diameter_m) in [
            (-1.0, 0.04),
            (0.0, 0.04),
            (0.0027, 0.0),
            (f64::NAN, 0.04),
            (0.0027, f64::INFINITY),
        ] {
            assert!(matches!(
                Ball::new(mass_kg, diameter_m),
                Err(Error::OutOfRange { .. })
            ));
        }
        assert!(Ball::steel(-0.01).is_err());
    }

    #[test]
    fn an_unknown_preset_offers_the_nearest_and_the_list() {
        let message = preset("golfball").unwrap_err().to_string();
        assert!(message.contains("nearest is \"golf\""), "{message}");
        assert!(
            message.contains("table-tennis-40, table-tennis-38, tennis"),
            "{message}"
        );
    }
}
