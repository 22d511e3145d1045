//! The arguments for ball, air and gravity.

use bouncelab::ball::Ball;
use bouncelab::drag::DragLaw;
use bouncelab::rulebook;
use bouncelab::setup::{AirInput, BallInput, GravityInput, Setup, SetupInput};
use bouncelab::{Diagnostic, plausibility};
use bouncelab_session::Noted;
use clap::Args;

use crate::failure::Failure;
use crate::language::{text, translator};
use crate::units;

/// Ball, air, drag and gravity.
#[derive(Args, Clone, Debug)]
pub(crate) struct PhysicsArguments {
    /// The ball: a name such as table-tennis-40, tennis or basketball, or steel:10mm, glass:16mm
    /// (default: table-tennis-40)
    #[arg(long, value_name = "NAME", help_heading = "Ball", conflicts_with_all = ["mass", "diameter"])]
    ball: Option<String>,
    /// Mass of the ball, as in 2.5g; requires --diameter
    #[arg(long, allow_hyphen_values = true, value_parser = units::mass, help_heading = "Ball", requires = "diameter")]
    mass: Option<f64>,
    /// Diameter of the ball, as in 38mm; requires --mass
    #[arg(long, allow_hyphen_values = true, value_parser = units::length, help_heading = "Ball", requires = "mass")]
    diameter: Option<f64>,
    /// Contact time of ball and surface, as in 1ms (default: typical of the ball)
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
    /// Density of the air, instead of the three above, as in 1.2kg/m3; 0 is vacuum
    #[arg(
        long, value_name = "DENSITY", allow_hyphen_values = true, value_parser = units::density, help_heading = "Air",
        conflicts_with_all = ["temperature", "pressure", "humidity"]
    )]
    air_density: Option<f64>,
    /// Viscosity of the air, as in 18.1uPa.s; requires --air-density
    #[arg(
        long, value_name = "VISCOSITY", allow_hyphen_values = true, value_parser = units::viscosity, help_heading = "Air",
        requires = "air_density"
    )]
    air_viscosity: Option<f64>,
    /// Neglect the buoyancy of the ball in air
    #[arg(long, help_heading = "Air")]
    no_buoyancy: bool,
    /// Neglect the added mass of the air that moves with the ball
    #[arg(long, help_heading = "Air")]
    no_added_mass: bool,

    /// Acceleration of gravity, as in 9.81 (default: standard gravity, 9.80665 m/s2)
    #[arg(
        long, allow_hyphen_values = true, value_parser = units::acceleration, help_heading = "Gravity",
        conflicts_with_all = ["latitude", "altitude"]
    )]
    gravity: Option<f64>,
    /// Latitude, from which gravity is computed, as in 47.5 or 33.9S
    #[arg(long, value_parser = units::latitude, allow_hyphen_values = true, help_heading = "Gravity")]
    latitude: Option<f64>,
    /// Height above sea level, as in 500m; requires --latitude
    #[arg(
        long, allow_hyphen_values = true, value_parser = units::length, help_heading = "Gravity",
        requires = "latitude"
    )]
    altitude: Option<f64>,

    /// Accept values that look like a wrong unit, as a drop from 30.5m or a ball of 2.5kg
    #[arg(long)]
    allow_implausible: bool,
}

/// The physics of a run, and what of it nobody stated.
pub(crate) type Physics = Setup;

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
        both.mass = noted.mass_kg.or(both.mass);
        both.diameter = noted.diameter_m.or(both.diameter);
        both.contact_time = noted.contact_time_s.or(both.contact_time);
        both.temperature = noted.temperature_k.or(both.temperature);
        both.pressure = noted.pressure_pa.or(both.pressure);
        both.humidity = noted.relative_humidity.or(both.humidity);
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

    /// What was stated of temperature and altitude.
    pub(crate) fn conditions(&self) -> rulebook::Conditions {
        rulebook::Conditions {
            temperature_k: self.temperature,
            altitude_m: self.altitude,
        }
    }

    /// Whether to accept what looks like a wrong unit.
    pub(crate) fn allow_implausible(&self) -> bool {
        self.allow_implausible
    }

    /// Values that look like a wrong unit.
    fn questions(&self) -> Vec<Diagnostic> {
        let of_ball = self.mass.zip(self.diameter).and_then(|(mass, diameter)| {
            // What is no ball at all is refused as such.
            plausibility::of_ball(&Ball::new(mass, diameter).ok()?)
        });
        let mut questions = of_quantities(&[
            ("contact-time", self.contact_time),
            ("temperature", self.temperature),
            ("pressure", self.pressure),
            ("humidity", self.humidity),
            ("air-density", self.air_density),
            ("gravity", self.gravity),
            ("altitude", self.altitude),
        ]);
        questions.extend(of_ball);
        questions
    }

    /// Ball, air and gravity of these arguments, unless something looks like a mistake: one of these
    /// or one of the `others` that were stated beside them.
    pub(crate) fn questioned(&self, others: Vec<Diagnostic>) -> Result<Physics, Failure> {
        let mut questions = self.questions();
        questions.extend(others);
        settle(&questions, self.allow_implausible)?;
        self.physics()
    }

    /// Ball, air and gravity of these arguments.
    pub(crate) fn physics(&self) -> Result<Physics, Failure> {
        let stated = SetupInput {
            ball: self.ball()?,
            weighed_kg: self.mass.filter(|_| self.ball.is_some()),
            measured_m: self.diameter.filter(|_| self.ball.is_some()),
            contact_time_s: self.contact_time,
            drag: Some(self.drag),
            air: self.air(),
            no_buoyancy: self.no_buoyancy,
            no_added_mass: self.no_added_mass,
            gravity: self.gravity(),
        };
        Ok(stated.resolve()?)
    }

    fn ball(&self) -> Result<Option<BallInput>, Failure> {
        if let (None, Some(mass_kg), Some(diameter_m)) = (&self.ball, self.mass, self.diameter) {
            return Ok(Some(BallInput::Measured {
                mass_kg,
                diameter_m,
            }));
        }
        let Some(name) = &self.ball else {
            return Ok(None);
        };
        let make = match name.split_once(':') {
            Some(("steel", diameter)) => (BallInput::Steel as fn(f64) -> BallInput, diameter),
            Some(("glass", diameter)) => (BallInput::Glass as fn(f64) -> BallInput, diameter),
            _ => return Ok(Some(BallInput::Named(name.clone()))),
        };
        let diameter_m = units::length(make.1).map_err(Failure::Usage)?;
        Ok(Some(make.0(diameter_m)))
    }

    fn air(&self) -> AirInput {
        match self.air_density {
            Some(density_kg_m3) => AirInput::Density {
                density_kg_m3,
                viscosity_pa_s: self.air_viscosity,
            },
            None => AirInput::Weather {
                temperature_k: self.temperature,
                pressure_pa: self.pressure,
                relative_humidity: self.humidity,
            },
        }
    }

    fn gravity(&self) -> Option<GravityInput> {
        let place = |latitude_deg| GravityInput::Place {
            latitude_deg,
            altitude_m: self.altitude.unwrap_or(0.0),
        };
        self.gravity
            .map(GravityInput::Measured)
            .or(self.latitude.map(place))
    }
}

/// Questions about what was stated of some quantities.
pub(crate) fn of_quantities(stated: &[(&str, Option<f64>)]) -> Vec<Diagnostic> {
    let stated = stated.iter();
    stated
        .filter_map(|&(quantity, value)| plausibility::of_quantity(quantity, value?))
        .collect()
}

/// Refuses to go on while there are questions, unless the person allows implausible values.
pub(crate) fn settle(questions: &[Diagnostic], allow_implausible: bool) -> Result<(), Failure> {
    if allow_implausible || questions.is_empty() {
        return Ok(());
    }
    let questions: Vec<String> = questions
        .iter()
        .map(|question| translator().diagnostic(question))
        .collect();
    let advice = text("advice-allow-implausible");
    Err(Failure::Usage(format!("{} {advice}", questions.join(" "))))
}

/// The drag law that an argument names.
pub(crate) fn drag_law(text: &str) -> Result<DragLaw, String> {
    text.parse()
        .map_err(|refusal: bouncelab::Error| refusal.to_string())
}
