//! The arguments for ball, air and gravity.

use bouncelab::Diagnostic;
use bouncelab::drag::DragLaw;
use bouncelab::rulebook;
use bouncelab::setup::{Settings, Setup};
use clap::Args;

use crate::failure::Failure;
use crate::language::{text, translator};
use crate::units;

/// Ball, air, drag and gravity.
#[derive(Args, Clone, Debug)]
pub(crate) struct PhysicsArguments {
    /// The ball: a name such as table-tennis-40, tennis or basketball, or steel:10mm, glass:16mm
    /// (default: table-tennis-40)
    #[arg(long, value_name = "NAME", value_parser = units::ball, help_heading = "Ball", conflicts_with_all = ["mass", "diameter"])]
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
        long,
        value_name = "LAW",
        default_value = "clift-grace-weber",
        help_heading = "Air"
    )]
    drag: String,
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

impl PhysicsArguments {
    /// What they say.
    pub(crate) fn settings(&self) -> Settings {
        Settings {
            ball: self.ball.clone(),
            mass_kg: self.mass,
            diameter_m: self.diameter,
            contact_time_s: self.contact_time,
            drag: Some(self.drag.clone()),
            temperature_k: self.temperature,
            pressure_pa: self.pressure,
            relative_humidity: self.humidity,
            air_density_kg_m3: self.air_density,
            air_viscosity_pa_s: self.air_viscosity,
            buoyancy: Some(!self.no_buoyancy),
            added_mass: Some(!self.no_added_mass),
            gravity_m_s2: self.gravity,
            latitude_deg: self.latitude,
            altitude_m: self.altitude,
            ..Settings::default()
        }
    }

    /// The same with a ball for those who state none; whether they did not.
    pub(crate) fn or_ball(mut self, name: Option<&str>) -> (Self, bool) {
        let assumed = self.ball.is_none() && self.mass.is_none();
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

    /// Ball, air and gravity of these arguments, unless something looks like a mistake: one of these
    /// or one of the `others` that were stated beside them.
    pub(crate) fn questioned(
        &self,
        others: impl IntoIterator<Item = Diagnostic>,
    ) -> Result<Setup, Failure> {
        let settings = self.settings();
        self.settle(settings.questions().into_iter().chain(others))?;
        Ok(settings.resolve(false)?)
    }

    /// Refuses to go on while there are questions, unless the person allows implausible values.
    pub(crate) fn settle(
        &self,
        questions: impl IntoIterator<Item = Diagnostic>,
    ) -> Result<(), Failure> {
        let questions = questions.into_iter();
        let questions: Vec<String> = questions
            .map(|question| translator().diagnostic(&question))
            .collect();
        if self.allow_implausible || questions.is_empty() {
            return Ok(());
        }
        let advice = text("advice-allow-implausible");
        Err(Failure::Usage(format!("{} {advice}", questions.join(" "))))
    }
}

/// The drag law that an argument names.
pub(crate) fn drag_law(text: &str) -> Result<DragLaw, String> {
    text.parse()
        .map_err(|refusal: bouncelab::Error| refusal.to_string())
}
