//! The arguments that say what falls, through what, and how hard it is pulled.

use bouncelab::air::{Air, Conditions};
use bouncelab::analysis::Settings;
use bouncelab::ball::{self, Ball};
use bouncelab::drag::DragLaw;
use bouncelab::estimate::Knowledge;
use bouncelab::flight::Environment;
use bouncelab::gravity;
use bouncelab::rulebook;
use clap::Args;

use crate::failure::Failure;
use crate::units;

/// Ball, air, drag and gravity.
#[derive(Args, Clone, Debug)]
pub(crate) struct PhysicsArguments {
    /// The ball: a name such as table-tennis-40, tennis or basketball, or steel:10mm, glass:16mm
    /// (default: table-tennis-40)
    #[arg(long, value_name = "NAME", help_heading = "Ball", conflicts_with_all = ["mass", "diameter"])]
    ball: Option<String>,
    /// Mass of the ball, as in 2.5g; goes with --diameter
    #[arg(long, allow_hyphen_values = true, value_parser = units::mass, help_heading = "Ball", requires = "diameter")]
    mass: Option<f64>,
    /// Diameter of the ball, as in 38mm; goes with --mass
    #[arg(long, allow_hyphen_values = true, value_parser = units::length, help_heading = "Ball", requires = "mass")]
    diameter: Option<f64>,
    /// How long the ball touches the surface, as in 1ms (default: typical of the ball)
    #[arg(long, value_name = "TIME", allow_hyphen_values = true, value_parser = units::time, help_heading = "Ball")]
    contact_time: Option<f64>,

    /// Drag law: none (as if there were no air), constant:0.4, or a sphere law such as clift-grace-weber or morrison
    #[arg(
        value_parser = drag_law,
        long,
        value_name = "LAW",
        default_value = "clift-grace-weber",
        help_heading = "Air"
    )]
    drag: DragLaw,
    /// Temperature of the air, as in 20C
    #[arg(long, value_parser = units::temperature, allow_hyphen_values = true, help_heading = "Air")]
    temperature: Option<f64>,
    /// Pressure of the air, as in 1013hPa
    #[arg(long, allow_hyphen_values = true, value_parser = units::pressure, help_heading = "Air")]
    pressure: Option<f64>,
    /// Relative humidity of the air, as in 50%
    #[arg(long, allow_hyphen_values = true, value_parser = units::share, help_heading = "Air")]
    humidity: Option<f64>,
    /// Density of the air instead, as in 1.2kg/m3; 0 is vacuum
    #[arg(
        long, value_name = "DENSITY", allow_hyphen_values = true, value_parser = units::density, help_heading = "Air",
        conflicts_with_all = ["temperature", "pressure", "humidity"]
    )]
    air_density: Option<f64>,
    /// Viscosity of the air, as in 18.1uPa.s; goes with --air-density
    #[arg(
        long, value_name = "VISCOSITY", allow_hyphen_values = true, value_parser = units::viscosity, help_heading = "Air",
        requires = "air_density"
    )]
    air_viscosity: Option<f64>,
    /// Leave out the buoyancy of the ball in air
    #[arg(long, help_heading = "Air")]
    no_buoyancy: bool,
    /// Leave out the mass of the air that moves with the ball
    #[arg(long, help_heading = "Air")]
    no_added_mass: bool,

    /// Gravity, as in 9.81 (default: the standard 9.80665 m/s2)
    #[arg(
        long, allow_hyphen_values = true, value_parser = units::acceleration, help_heading = "Gravity",
        conflicts_with_all = ["latitude", "altitude"]
    )]
    gravity: Option<f64>,
    /// Latitude, from which gravity follows, as in 47.5 or 33.9S
    #[arg(long, value_parser = units::latitude, allow_hyphen_values = true, help_heading = "Gravity")]
    latitude: Option<f64>,
    /// Height above the sea, as in 500m; goes with --latitude
    #[arg(
        long, allow_hyphen_values = true, value_parser = units::length, help_heading = "Gravity",
        requires = "latitude"
    )]
    altitude: Option<f64>,
}

/// The physics of a run, and what of it nobody stated.
pub(crate) struct Physics {
    /// The settings for the science.
    pub(crate) settings: Settings,
    /// The ball in words.
    pub(crate) ball_label: String,
    /// What was assumed, one phrase for each.
    pub(crate) assumptions: Vec<String>,
}

/// What was noted of the ball and the air of one recording.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Noted {
    /// Name of the kind of ball, as after `--ball`.
    pub(crate) ball: Option<String>,
    /// Its mass in kg.
    pub(crate) mass: Option<f64>,
    /// Its diameter in m.
    pub(crate) diameter: Option<f64>,
    /// How long it touches the surface, in s.
    pub(crate) contact_time: Option<f64>,
    /// Temperature of the air in K.
    pub(crate) temperature: Option<f64>,
    /// Pressure of the air in Pa.
    pub(crate) pressure: Option<f64>,
    /// Relative humidity of the air.
    pub(crate) humidity: Option<f64>,
}

impl PhysicsArguments {
    /// Whether they say what ball it is.
    pub(crate) fn names_ball(&self) -> bool {
        self.ball.is_some() || self.mass.is_some()
    }

    /// The same with what was noted of a recording, which goes before what these say.
    pub(crate) fn with(&self, noted: &Noted) -> Self {
        let mut both = self.clone();
        if noted.ball.is_some() {
            both.ball.clone_from(&noted.ball);
            both.mass = None;
            both.diameter = None;
        }
        both.mass = noted.mass.or(both.mass);
        both.diameter = noted.diameter.or(both.diameter);
        both.contact_time = noted.contact_time.or(both.contact_time);
        both.temperature = noted.temperature.or(both.temperature);
        both.pressure = noted.pressure.or(both.pressure);
        both.humidity = noted.humidity.or(both.humidity);
        both
    }

    /// The same with a ball for those who state none; whether they did not.
    pub(crate) fn or_ball(mut self, name: Option<&str>) -> (Self, bool) {
        let assumed = !self.names_ball();
        if assumed {
            self.ball = name.map(str::to_owned);
        }
        (self, assumed)
    }

    /// What was stated of the room.
    pub(crate) fn conditions(&self) -> rulebook::Conditions {
        rulebook::Conditions {
            temperature_k: self.temperature,
            altitude_m: self.altitude,
        }
    }

    /// Ball, air and gravity of these arguments.
    pub(crate) fn physics(&self) -> Result<Physics, Failure> {
        let mut assumptions = Vec::new();
        let (ball, ball_label, contact_time_s, of_ball) = self.ball(&mut assumptions)?;
        let environment = Environment {
            gravity_m_s2: self.gravity(&mut assumptions)?,
            air: self.air(&mut assumptions)?,
            drag: self.drag,
            // No drag means as if there were no air at all.
            buoyancy: !self.no_buoyancy && self.drag != DragLaw::None,
            added_mass: !self.no_added_mass && self.drag != DragLaw::None,
        };
        let settings = Settings {
            ball,
            environment,
            contact_time_s,
            flights: None,
            knowledge: self.knowledge(of_ball),
            question: None,
        };
        // Whatever does not go together is found here, before any file is read.
        settings.model()?;
        Ok(Physics {
            settings,
            ball_label,
            assumptions,
        })
    }

    /// How well the inputs are known that these arguments give.
    fn knowledge(&self, of_ball: Knowledge) -> Knowledge {
        /// What is stated is taken to be measured with ordinary care.
        const STATED_AIR: f64 = 0.003;
        const STATED_GRAVITY: f64 = 1e-4;
        const STATED_CONTACT: f64 = 0.1;
        let usual = of_ball;
        let air_stated =
            self.temperature.is_some() && self.pressure.is_some() || self.air_density.is_some();
        let gravity_stated = self.gravity.is_some() || self.latitude.is_some();
        let or = |stated: bool, known: f64, usual: f64| if stated { known } else { usual };
        Knowledge {
            air_density: or(air_stated, STATED_AIR, usual.air_density),
            gravity: or(gravity_stated, STATED_GRAVITY, usual.gravity),
            contact_time: or(
                self.contact_time.is_some(),
                STATED_CONTACT,
                usual.contact_time,
            ),
            ..usual
        }
    }

    /// The ball, its name, its contact time and how well it is known.
    fn ball(
        &self,
        assumptions: &mut Vec<String>,
    ) -> Result<(Ball, String, f64, Knowledge), Failure> {
        /// An order of magnitude, where nothing is known of the ball.
        const CONTACT_S: f64 = 1e-3;
        /// Steel and glass touch far shorter than hollow balls.
        const HARD_CONTACT_S: f64 = 5e-5;
        // Measured by the person, by scale and calliper.
        const WEIGHED: f64 = 0.003;
        const CALLIPERED: f64 = 0.002;
        let measured = Knowledge {
            mass: WEIGHED,
            diameter: CALLIPERED,
            ..Knowledge::default()
        };
        let (mut ball, label, typical_s, mut known) =
            if let (None, Some(mass), Some(diameter)) = (&self.ball, self.mass, self.diameter) {
                let label = format!("{} g, {} mm", rounded(mass * 1e3), rounded(diameter * 1e3));
                (Ball::new(mass, diameter)?, label, CONTACT_S, measured)
            } else {
                let name = self.ball.as_deref().unwrap_or("table-tennis-40");
                if let Some((material @ ("steel" | "glass"), diameter)) = name.split_once(':') {
                    let diameter_m = units::length(diameter).map_err(Failure::Usage)?;
                    let make = if material == "steel" {
                        Ball::steel
                    } else {
                        Ball::glass
                    };
                    let label = format!("{material}, {} mm", rounded(diameter_m * 1e3));
                    (make(diameter_m)?, label, HARD_CONTACT_S, measured)
                } else {
                    let preset = ball::preset(name)?;
                    if self.ball.is_none() {
                        assumptions.push(format!("the ball is {}", preset.label));
                    }
                    (
                        preset.ball,
                        preset.label.to_owned(),
                        preset.contact_time_s,
                        Knowledge::of_preset(preset),
                    )
                }
            };
        // A ball of a known kind may have been weighed or measured besides.
        if let Some(mass) = self.mass {
            ball = Ball::new(mass, ball.diameter_m())?;
            known.mass = WEIGHED;
        }
        if let Some(diameter) = self.diameter {
            ball = Ball::new(ball.mass_kg(), diameter)?;
            known.diameter = CALLIPERED;
        }
        if self.contact_time.is_none() {
            assumptions.push(format!("it touches for {} ms", rounded(typical_s * 1e3)));
        }
        Ok((ball, label, self.contact_time.unwrap_or(typical_s), known))
    }

    fn air(&self, assumptions: &mut Vec<String>) -> Result<Air, Failure> {
        let usual = Conditions::default();
        if let Some(density) = self.air_density {
            let viscosity = match self.air_viscosity {
                Some(viscosity) => viscosity,
                None if density > 0.0 => Air::moist(&usual)?.viscosity_pa_s(),
                None => return Ok(Air::vacuum()),
            };
            return Ok(Air::new(density, viscosity)?);
        }
        let conditions = Conditions {
            temperature_k: self.temperature.unwrap_or(usual.temperature_k),
            pressure_pa: self.pressure.unwrap_or(usual.pressure_pa),
            relative_humidity: self.humidity.unwrap_or(usual.relative_humidity),
        };
        if self.temperature.is_none() || self.pressure.is_none() || self.humidity.is_none() {
            assumptions.push(format!(
                "air of {} C, {} hPa, {} % humidity",
                rounded(conditions.temperature_k - 273.15),
                rounded(conditions.pressure_pa / 100.0),
                rounded(conditions.relative_humidity * 100.0),
            ));
        }
        Ok(Air::moist(&conditions)?)
    }

    fn gravity(&self, assumptions: &mut Vec<String>) -> Result<f64, Failure> {
        match (self.gravity, self.latitude) {
            (Some(gravity), _) => Ok(gravity),
            (None, Some(latitude)) => Ok(gravity::at(latitude, self.altitude.unwrap_or(0.0))?),
            (None, None) => {
                assumptions.push(format!("gravity {} m/s2", gravity::STANDARD_M_S2));
                Ok(gravity::STANDARD_M_S2)
            }
        }
    }
}

/// A number without the noise of binary fractions.
fn rounded(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}

/// The drag law that an argument names.
pub(crate) fn drag_law(text: &str) -> Result<DragLaw, String> {
    text.parse()
        .map_err(|refusal: bouncelab::Error| refusal.to_string())
}
