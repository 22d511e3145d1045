//! What a person states of a drop, and what is assumed of the rest.
//!
//! Whoever asks (a command line, a page) fills in what is known and leaves the rest out. What is
//! left out is assumed, every assumption is told in words, and what is stated counts as measured
//! with ordinary care.
//!
//! ```
//! use bouncelab::stated::{Stated, StatedBall};
//!
//! let stated = Stated { ball: Some(StatedBall::Named("tennis".to_owned())), ..Stated::default() };
//! let understood = stated.understand()?;
//! assert_eq!(understood.ball_label, "tennis");
//! assert!(understood.assumptions.iter().any(|words| words.starts_with("gravity")));
//! # Ok::<(), bouncelab::Error>(())
//! ```

use crate::Result;
use crate::air::{Air, Conditions};
use crate::analysis::Settings;
use crate::ball::{self, Ball};
use crate::drag::DragLaw;
use crate::estimate::{Knowledge, LawKind, Measured, UNKNOWN};
use crate::flight::Environment;
use crate::gravity;

/// Heights are measured with a ruler: standard uncertainty in metres.
const HEIGHT_SD_M: f64 = 0.002;
/// A release is seen in a video, or heard: standard uncertainty in seconds.
const RELEASE_SD_S: f64 = 0.005;

/// What is stated of ball, air, drag and gravity.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Stated {
    /// The ball; if left out, the first of [`ball::presets`].
    pub ball: Option<StatedBall>,
    /// Mass in kilograms, where a ball of a known kind was weighed besides.
    pub weighed_kg: Option<f64>,
    /// Diameter in metres, where a ball of a known kind was measured besides.
    pub measured_m: Option<f64>,
    /// How long it touches the surface, in seconds.
    pub contact_time_s: Option<f64>,
    /// The drag law; if left out, the standard drag curve.
    pub drag: Option<DragLaw>,
    /// The air.
    pub air: StatedAir,
    /// Leaves out the buoyancy of the ball in air.
    pub no_buoyancy: bool,
    /// Leaves out the mass of the air that moves with the ball.
    pub no_added_mass: bool,
    /// Gravity; if left out, the standard.
    pub gravity: Option<StatedGravity>,
}

/// What is stated of the ball.
#[derive(Clone, Debug, PartialEq)]
pub enum StatedBall {
    /// The name of a preset.
    Named(String),
    /// A steel ball of this diameter in metres.
    Steel(f64),
    /// A glass ball of this diameter in metres.
    Glass(f64),
    /// Weighed and measured.
    Measured {
        /// Mass in kilograms.
        mass_kg: f64,
        /// Diameter in metres.
        diameter_m: f64,
    },
}

/// What is stated of the air.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StatedAir {
    /// By a thermometer, a barometer and a hygrometer, or some of them.
    Weather {
        /// Temperature in kelvin.
        temperature_k: Option<f64>,
        /// Pressure in pascal.
        pressure_pa: Option<f64>,
        /// Relative humidity, 0 to 1.
        relative_humidity: Option<f64>,
    },
    /// By its density.
    Density {
        /// Density in kg/m³; 0 is vacuum.
        density_kg_m3: f64,
        /// Viscosity in Pa s; if left out, that of ordinary air.
        viscosity_pa_s: Option<f64>,
    },
}

impl Default for StatedAir {
    fn default() -> Self {
        Self::Weather {
            temperature_k: None,
            pressure_pa: None,
            relative_humidity: None,
        }
    }
}

/// What is stated of gravity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StatedGravity {
    /// As measured, in m/s².
    Measured(f64),
    /// By the place on earth.
    Place {
        /// Latitude in degrees.
        latitude_deg: f64,
        /// Height above the sea in metres.
        altitude_m: f64,
    },
}

/// What was understood.
#[derive(Clone, Debug)]
pub struct Understood {
    /// The settings for the science, without a question.
    pub settings: Settings,
    /// The ball in words.
    pub ball_label: String,
    /// What was assumed, one phrase for each.
    pub assumptions: Vec<String>,
}

/// A ball and what goes with it.
struct KnownBall {
    ball: Ball,
    label: String,
    contact_time_s: f64,
    knowledge: Knowledge,
}

impl Stated {
    /// The settings that follow, and what was assumed.
    ///
    /// # Errors
    ///
    /// [`Error::UnknownName`](crate::Error::UnknownName) for a ball that nobody knows,
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) for a number that makes no sense, and the
    /// errors of [`FlightModel::new`](crate::flight::FlightModel::new) where things do not go
    /// together.
    pub fn understand(&self) -> Result<Understood> {
        let mut assumptions = Vec::new();
        let known = self.ball(&mut assumptions)?;
        let drag = self.drag.unwrap_or(DragLaw::CliftGraceWeber);
        let environment = Environment {
            gravity_m_s2: self.gravity(&mut assumptions)?,
            air: self.air(&mut assumptions)?,
            drag,
            // No drag means as if there were no air at all.
            buoyancy: !self.no_buoyancy && drag != DragLaw::None,
            added_mass: !self.no_added_mass && drag != DragLaw::None,
        };
        let settings = Settings {
            ball: known.ball,
            environment,
            contact_time_s: known.contact_time_s,
            flights: None,
            knowledge: self.knowledge(known.knowledge),
            question: None,
        };
        // Whatever does not go together is found here, before anything is heard.
        settings.model()?;
        Ok(Understood {
            settings,
            ball_label: known.label,
            assumptions,
        })
    }

    /// How well the inputs are known that were stated.
    fn knowledge(&self, usual: Knowledge) -> Knowledge {
        /// What is stated is taken to be measured with ordinary care.
        const STATED_AIR: f64 = 0.003;
        const STATED_GRAVITY: f64 = 1e-4;
        const STATED_CONTACT: f64 = 0.1;
        let air_stated = match self.air {
            StatedAir::Weather {
                temperature_k,
                pressure_pa,
                ..
            } => temperature_k.is_some() && pressure_pa.is_some(),
            StatedAir::Density { .. } => true,
        };
        let or = |stated: bool, known: f64, usual: f64| if stated { known } else { usual };
        Knowledge {
            air_density: or(air_stated, STATED_AIR, usual.air_density),
            gravity: or(self.gravity.is_some(), STATED_GRAVITY, usual.gravity),
            contact_time: or(
                self.contact_time_s.is_some(),
                STATED_CONTACT,
                usual.contact_time,
            ),
            ..usual
        }
    }

    fn ball(&self, assumptions: &mut Vec<String>) -> Result<KnownBall> {
        let mut known = match &self.ball {
            Some(StatedBall::Named(name)) => KnownBall::of_preset(ball::preset(name)?),
            &Some(StatedBall::Steel(diameter_m)) => {
                let ball = Ball::steel(diameter_m)?;
                KnownBall::measured(ball, "steel", KnownBall::HARD_CONTACT_S)
            }
            &Some(StatedBall::Glass(diameter_m)) => {
                let ball = Ball::glass(diameter_m)?;
                KnownBall::measured(ball, "glass", KnownBall::HARD_CONTACT_S)
            }
            &Some(StatedBall::Measured {
                mass_kg,
                diameter_m,
            }) => {
                let ball = Ball::new(mass_kg, diameter_m)?;
                let weight = format!("{} g", rounded(mass_kg * 1e3));
                KnownBall::measured(ball, &weight, KnownBall::CONTACT_S)
            }
            None => {
                let preset = ball::usual();
                assumptions.push(format!("the ball is {}", preset.label));
                KnownBall::of_preset(preset)
            }
        };
        if let Some(mass_kg) = self.weighed_kg {
            known.ball = Ball::new(mass_kg, known.ball.diameter_m())?;
            known.knowledge.mass = KnownBall::WEIGHED;
        }
        if let Some(diameter_m) = self.measured_m {
            known.ball = Ball::new(known.ball.mass_kg(), diameter_m)?;
            known.knowledge.diameter = KnownBall::CALLIPERED;
        }
        match self.contact_time_s {
            Some(contact_time_s) => known.contact_time_s = contact_time_s,
            None => assumptions.push(format!(
                "it touches for {} ms",
                rounded(known.contact_time_s * 1e3)
            )),
        }
        Ok(known)
    }

    fn air(&self, assumptions: &mut Vec<String>) -> Result<Air> {
        let usual = Conditions::default();
        match self.air {
            StatedAir::Density {
                density_kg_m3,
                viscosity_pa_s: Some(viscosity_pa_s),
            } => Air::new(density_kg_m3, viscosity_pa_s),
            StatedAir::Density {
                density_kg_m3: 0.0, ..
            } => Ok(Air::vacuum()),
            StatedAir::Density { density_kg_m3, .. } => {
                Air::new(density_kg_m3, Air::moist(&usual)?.viscosity_pa_s())
            }
            StatedAir::Weather {
                temperature_k,
                pressure_pa,
                relative_humidity,
            } => {
                let conditions = Conditions {
                    temperature_k: temperature_k.unwrap_or(usual.temperature_k),
                    pressure_pa: pressure_pa.unwrap_or(usual.pressure_pa),
                    relative_humidity: relative_humidity.unwrap_or(usual.relative_humidity),
                };
                if temperature_k.is_none() || pressure_pa.is_none() || relative_humidity.is_none() {
                    assumptions.push(format!(
                        "air of {} C, {} hPa, {} % humidity",
                        rounded(conditions.temperature_k - 273.15),
                        rounded(conditions.pressure_pa / 100.0),
                        rounded(conditions.relative_humidity * 100.0),
                    ));
                }
                Air::moist(&conditions)
            }
        }
    }

    fn gravity(&self, assumptions: &mut Vec<String>) -> Result<f64> {
        match self.gravity {
            Some(StatedGravity::Measured(gravity_m_s2)) => Ok(gravity_m_s2),
            Some(StatedGravity::Place {
                latitude_deg,
                altitude_m,
            }) => gravity::at(latitude_deg, altitude_m),
            None => {
                assumptions.push(format!("gravity {} m/s2", gravity::STANDARD_M_S2));
                Ok(gravity::STANDARD_M_S2)
            }
        }
    }
}

impl KnownBall {
    /// An order of magnitude, where nothing is known of the ball.
    const CONTACT_S: f64 = 1e-3;
    /// Steel and glass touch far shorter than hollow balls.
    const HARD_CONTACT_S: f64 = 5e-5;

    /// How well a person weighs and measures, by scale and calliper: relative standard uncertainties.
    const WEIGHED: f64 = 0.003;
    const CALLIPERED: f64 = 0.002;

    fn of_preset(preset: &ball::Preset) -> Self {
        Self {
            ball: preset.ball,
            label: preset.label.to_owned(),
            contact_time_s: preset.contact_time_s,
            knowledge: Knowledge::of_preset(preset),
        }
    }

    /// Weighed and measured by the person, or measured and of a known material.
    fn measured(ball: Ball, weight_or_material: &str, contact_time_s: f64) -> Self {
        let diameter_mm = rounded(ball.diameter_m() * 1e3);
        Self {
            ball,
            label: format!("{weight_or_material}, {diameter_mm} mm"),
            contact_time_s,
            knowledge: Knowledge {
                mass: Self::WEIGHED,
                diameter: Self::CALLIPERED,
                ..Knowledge::default()
            },
        }
    }
}

/// What is stated of the drop itself.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StatedDrop {
    /// Measured drop height in metres, surface to lowest point of the ball.
    pub height_m: Option<f64>,
    /// Its standard uncertainty in metres; if left out, that of a ruler: 2 mm.
    pub height_sd_m: Option<f64>,
    /// When the ball was released, in seconds of the recording.
    pub release_s: Option<f64>,
    /// Its standard uncertainty in seconds; if left out, 5 ms.
    pub release_sd_s: Option<f64>,
    /// Whether the first impact heard is the first there was.
    pub first_heard: bool,
    /// Restitution laws to consider; all that the impacts can tell apart if empty.
    pub laws: Vec<LawKind>,
    /// What to leave to the data.
    pub infer: Vec<Inferred>,
}

/// An input that may be left to the data, as if nothing were known of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Inferred {
    /// The acceleration of gravity.
    Gravity,
    /// The drag coefficient.
    Drag,
    /// The contact time.
    ContactTime,
}

impl StatedDrop {
    /// What is known of ball, air and gravity, with this added.
    ///
    /// # Errors
    ///
    /// Those of [`Knowledge::check`].
    pub fn add_to(&self, knowledge: &Knowledge) -> Result<Knowledge> {
        let measured = |value: Option<f64>, sd: f64| value.map(|value| Measured { value, sd });
        let unless_inferred = |input: Inferred, known: f64| {
            let is_inferred = self.infer.contains(&input);
            if is_inferred { UNKNOWN } else { known }
        };
        let all = Knowledge {
            drop_height_m: measured(self.height_m, self.height_sd_m.unwrap_or(HEIGHT_SD_M)),
            first_was_heard: self.first_heard,
            release_s: measured(self.release_s, self.release_sd_s.unwrap_or(RELEASE_SD_S)),
            restitution_laws: self.laws.clone(),
            gravity: unless_inferred(Inferred::Gravity, knowledge.gravity),
            drag: unless_inferred(Inferred::Drag, knowledge.drag),
            contact_time: unless_inferred(Inferred::ContactTime, knowledge.contact_time),
            ..knowledge.clone()
        };
        all.check()?;
        Ok(all)
    }
}

/// A number without the noise of binary fractions.
fn rounded(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}
