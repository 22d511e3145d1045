//! Stated quantities of a drop, and assumptions for the others.
//!
//! Whoever asks (a command line, a page) fills in what is known and leaves the rest out. What is
//! left out is assumed, every assumption is told in words, and what is stated counts as measured
//! with ordinary care.
//!
//! ```
//! use bouncelab::setup::{SetupInput, BallInput};
//!
//! let stated = SetupInput { ball: Some(BallInput::Named("tennis".to_owned())), ..SetupInput::default() };
//! let setup = stated.resolve()?;
//! assert_eq!(setup.ball, BallInput::Named("tennis".to_owned()));
//! let codes: Vec<_> = setup.assumptions.iter().map(|assumed| assumed.code.name()).collect();
//! assert!(codes.contains(&"assumed-gravity"));
//! # Ok::<(), bouncelab::Error>(())
//! ```

mod contrasts;
mod settings;

use crate::Result;
use crate::air::{Air, Conditions};
use crate::analysis::Options;
use crate::ball::{self, Ball};
use crate::diagnostic::{Code, Diagnostic};
use crate::drag::DragLaw;
use crate::flight::Environment;
use crate::gravity;
use crate::inference::{Measured, Priors, UNKNOWN};
use crate::restitution::LawKind;
use crate::rulebook::Rule;

pub use contrasts::BallContrast;
pub use settings::Settings;

/// Heights are measured with a ruler: standard uncertainty in metres.
const HEIGHT_SD_M: f64 = 0.002;
/// A release is seen in a video, or heard: standard uncertainty in seconds.
const RELEASE_SD_S: f64 = 0.005;

/// What is stated of ball, air, drag and gravity.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SetupInput {
    /// The ball; if left out, the first of [`ball::presets`].
    pub ball: Option<BallInput>,
    /// Mass in kilograms, where a ball of a known kind was weighed besides.
    pub weighed_kg: Option<f64>,
    /// Diameter in metres, where a ball of a known kind was measured besides.
    pub measured_m: Option<f64>,
    /// How long it touches the surface, in seconds.
    pub contact_time_s: Option<f64>,
    /// The drag law; if left out, the standard drag curve.
    pub drag: Option<DragLaw>,
    /// The air.
    pub air: AirInput,
    /// Leaves out the buoyancy of the ball in air.
    pub no_buoyancy: bool,
    /// Leaves out the mass of the air that moves with the ball.
    pub no_added_mass: bool,
    /// Gravity; if left out, the standard.
    pub gravity: Option<GravityInput>,
}

/// What is stated of the ball.
#[derive(Clone, Debug, PartialEq)]
pub enum BallInput {
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
pub enum AirInput {
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

impl Default for AirInput {
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
pub enum GravityInput {
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

/// What follows from what was stated.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct Setup {
    /// The options of the analysis, without the inference.
    pub options: Options,
    /// The ball, stated or assumed.
    pub ball: BallInput,
    /// What was assumed, one diagnostic for each.
    pub assumptions: Vec<Diagnostic>,
}

impl Setup {
    /// Assumes what a rule says of the drops that it judges: their height, unless one is known, and, where
    /// nobody stated a ball and this is of that of the rule, that it is.
    ///
    /// ```
    /// use bouncelab::rulebook::Rule;
    /// use bouncelab::setup::SetupInput;
    ///
    /// let mut setup = SetupInput::default().resolve()?;
    /// setup.assume(&Rule::new("a", "A rule", 0.305), false);
    /// assert_eq!(setup.options.priors.drop_height_m.map(|height| height.value), Some(0.305));
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn assume(&mut self, rule: &Rule, is_its_ball: bool) {
        if is_its_ball {
            let ball = Diagnostic::new(Code::AssumedRuleBall);
            let name = rule.ball.as_deref().unwrap_or_default();
            self.assumptions.insert(0, ball.with("ball", name));
        }
        let fall_m = rule.fall_m(self.options.ball.diameter_m(), None);
        if let (None, Some(fall_m)) = (self.options.priors.drop_height_m, fall_m) {
            let sd = rule.drop_tolerance_m.map_or(HEIGHT_SD_M, |tolerance| {
                // Anywhere within the tolerance.
                tolerance / 3.0_f64.sqrt()
            });
            self.assumptions.push(
                Diagnostic::new(Code::AssumedRuleHeight)
                    .with("height_m", fall_m)
                    .with("sd_m", sd),
            );
            self.options.priors.drop_height_m = Some(Measured { value: fall_m, sd });
        }
    }
}

/// A ball and what goes with it.
struct KnownBall {
    ball: Ball,
    contact_time_s: f64,
    priors: Priors,
}

impl SetupInput {
    /// The settings that follow, and what was assumed.
    ///
    /// # Errors
    ///
    /// [`Error::UnknownName`](crate::Error::UnknownName) for a ball that nobody knows,
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) for a number that makes no sense, and the
    /// errors of [`FlightModel::new`](crate::flight::FlightModel::new) where things do not go
    /// together.
    pub fn resolve(&self) -> Result<Setup> {
        let mut assumptions = Vec::new();
        let ball = self.ball.clone().unwrap_or_else(|| {
            let usual = ball::usual().name;
            assumptions.push(Diagnostic::new(Code::AssumedBall).with("ball", usual));
            BallInput::Named(usual.to_owned())
        });
        let known = self.known(&ball, &mut assumptions)?;
        let drag = self.drag.unwrap_or(DragLaw::CliftGraceWeber);
        let environment = Environment {
            gravity_m_s2: self.gravity(&mut assumptions)?,
            air: self.air(&mut assumptions)?,
            drag,
            // No drag means as if there were no air at all.
            buoyancy: !self.no_buoyancy && drag != DragLaw::None,
            added_mass: !self.no_added_mass && drag != DragLaw::None,
        };
        let options = Options {
            ball: known.ball,
            environment,
            contact_time_s: known.contact_time_s,
            priors: self.priors(known.priors),
            inference: None,
            ..Options::default()
        };
        // Whatever does not go together is found here, before anything is heard.
        options.model()?;
        Ok(Setup {
            options,
            ball,
            assumptions,
        })
    }

    /// How well the inputs are known that were stated.
    fn priors(&self, usual: Priors) -> Priors {
        /// What is stated is taken to be measured with ordinary care.
        const STATED_AIR: f64 = 0.003;
        const STATED_GRAVITY: f64 = 1e-4;
        const STATED_CONTACT: f64 = 0.1;
        let air_stated = match self.air {
            AirInput::Weather {
                temperature_k,
                pressure_pa,
                ..
            } => temperature_k.is_some() && pressure_pa.is_some(),
            AirInput::Density { .. } => true,
        };
        let or = |stated: bool, known: f64, usual: f64| if stated { known } else { usual };
        Priors {
            air_density_rel_sd: or(air_stated, STATED_AIR, usual.air_density_rel_sd),
            gravity_rel_sd: or(self.gravity.is_some(), STATED_GRAVITY, usual.gravity_rel_sd),
            contact_time_rel_sd: or(
                self.contact_time_s.is_some(),
                STATED_CONTACT,
                usual.contact_time_rel_sd,
            ),
            ..usual
        }
    }

    fn known(&self, ball: &BallInput, assumptions: &mut Vec<Diagnostic>) -> Result<KnownBall> {
        let mut known = match *ball {
            BallInput::Named(ref name) => KnownBall::of_preset(ball::preset(name)?),
            BallInput::Steel(diameter_m) => {
                KnownBall::measured(Ball::steel(diameter_m)?, KnownBall::HARD_CONTACT_S)
            }
            BallInput::Glass(diameter_m) => {
                KnownBall::measured(Ball::glass(diameter_m)?, KnownBall::HARD_CONTACT_S)
            }
            BallInput::Measured {
                mass_kg,
                diameter_m,
            } => KnownBall::measured(Ball::new(mass_kg, diameter_m)?, KnownBall::CONTACT_S),
        };
        if let Some(mass_kg) = self.weighed_kg {
            known.ball = Ball::new(mass_kg, known.ball.diameter_m())?;
            known.priors.mass_rel_sd = KnownBall::WEIGHED;
        }
        if let Some(diameter_m) = self.measured_m {
            known.ball = Ball::new(known.ball.mass_kg(), diameter_m)?;
            known.priors.diameter_rel_sd = KnownBall::CALLIPERED;
        }
        if let Some(contact_time_s) = self.contact_time_s {
            known.contact_time_s = contact_time_s;
        } else {
            let assumed = Diagnostic::new(Code::AssumedContactTime);
            assumptions.push(assumed.with("contact_time_s", known.contact_time_s));
        }
        Ok(known)
    }

    fn air(&self, assumptions: &mut Vec<Diagnostic>) -> Result<Air> {
        let usual = Conditions::default();
        match self.air {
            AirInput::Density {
                density_kg_m3,
                viscosity_pa_s: Some(viscosity_pa_s),
            } => Air::new(density_kg_m3, viscosity_pa_s),
            AirInput::Density {
                density_kg_m3: 0.0, ..
            } => Ok(Air::vacuum()),
            AirInput::Density { density_kg_m3, .. } => {
                Air::new(density_kg_m3, Air::moist(&usual)?.viscosity_pa_s())
            }
            AirInput::Weather {
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
                    assumptions.push(
                        Diagnostic::new(Code::AssumedAir)
                            .with("temperature_k", conditions.temperature_k)
                            .with("pressure_pa", conditions.pressure_pa)
                            .with("relative_humidity", conditions.relative_humidity),
                    );
                }
                Air::moist(&conditions)
            }
        }
    }

    fn gravity(&self, assumptions: &mut Vec<Diagnostic>) -> Result<f64> {
        match self.gravity {
            Some(GravityInput::Measured(gravity_m_s2)) => Ok(gravity_m_s2),
            Some(GravityInput::Place {
                latitude_deg,
                altitude_m,
            }) => gravity::at(latitude_deg, altitude_m),
            None => {
                let assumed = Diagnostic::new(Code::AssumedGravity);
                assumptions.push(assumed.with("gravity_m_s2", gravity::STANDARD_M_S2));
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
            contact_time_s: preset.contact_time_s,
            priors: Priors::of_preset(preset),
        }
    }

    /// Weighed and measured by the person, or measured and of a known material.
    fn measured(ball: Ball, contact_time_s: f64) -> Self {
        Self {
            ball,
            contact_time_s,
            priors: Priors {
                mass_rel_sd: Self::WEIGHED,
                diameter_rel_sd: Self::CALLIPERED,
                ..Priors::default()
            },
        }
    }
}

/// What is stated of the drop itself.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DropInput {
    /// Measured drop height in metres, surface to lowest point of the ball.
    pub height_m: Option<f64>,
    /// Its standard uncertainty in metres; if left out, that of a ruler: 2 mm.
    pub height_sd_m: Option<f64>,
    /// When the ball was released, in seconds of the recording.
    pub release_s: Option<f64>,
    /// Its standard uncertainty in seconds; if left out, 5 ms.
    pub release_sd_s: Option<f64>,
    /// Whether the first impact detected is the first there was.
    pub first_detected: bool,
    /// Restitution laws to consider; all that the impacts can tell apart if empty.
    pub laws: Vec<LawKind>,
    /// What to leave to the data.
    pub infer: Vec<Inferred>,
}

/// An input that may be left to the data, as if nothing were known of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub enum Inferred {
    /// The acceleration of gravity.
    Gravity,
    /// The drag coefficient.
    Drag,
    /// The contact time.
    ContactTime,
}

impl DropInput {
    /// What is known of ball, air and gravity, with this added.
    ///
    /// # Errors
    ///
    /// Those of [`Priors::check`].
    pub fn add_to(&self, priors: &Priors) -> Result<Priors> {
        let measured = |value: Option<f64>, sd: f64| value.map(|value| Measured { value, sd });
        let unless_inferred = |input: Inferred, known: f64| {
            let is_inferred = self.infer.contains(&input);
            if is_inferred { UNKNOWN } else { known }
        };
        let all = Priors {
            drop_height_m: measured(self.height_m, self.height_sd_m.unwrap_or(HEIGHT_SD_M)),
            first_was_detected: self.first_detected,
            release_s: measured(self.release_s, self.release_sd_s.unwrap_or(RELEASE_SD_S)),
            restitution_laws: self.laws.clone(),
            gravity_rel_sd: unless_inferred(Inferred::Gravity, priors.gravity_rel_sd),
            drag_rel_sd: unless_inferred(Inferred::Drag, priors.drag_rel_sd),
            contact_time_rel_sd: unless_inferred(Inferred::ContactTime, priors.contact_time_rel_sd),
            ..priors.clone()
        };
        all.check()?;
        Ok(all)
    }
}
