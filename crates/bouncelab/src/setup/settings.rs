//! What a person states, as plain data.

use std::ops::RangeInclusive;

use super::{AirInput, BallInput, DropInput, GravityInput, Inferred, Setup, SetupInput};
use crate::Result;
use crate::ball::Ball;
use crate::diagnostic::Diagnostic;
use crate::error::{Quantity, within};
use crate::inference::{ApexTarget, InferenceOptions, SamplerConfig};
use crate::plausibility;

/// What a person says of ball, air, gravity and drop; what is left out is assumed.
///
/// It is the form in which front ends without types of their own, a page or Python, send it.
///
/// ```
/// use bouncelab::setup::Settings;
///
/// let stated = Settings { ball: Some("steel:0.01".to_owned()), ..Settings::default() };
/// let setup = stated.resolve(true)?;
/// assert!((setup.options.ball.mass_kg() - 0.0041).abs() < 1e-4);
/// # Ok::<(), bouncelab::Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(optional_fields))]
pub struct Settings {
    /// Name of a preset, or `steel:0.01` or `glass:0.016` with the diameter in metres.
    pub ball: Option<String>,
    /// Mass of the ball; with the diameter in place of a name, else as weighed.
    pub mass_kg: Option<f64>,
    /// Diameter of the ball.
    pub diameter_m: Option<f64>,
    /// How long the ball touches the surface.
    pub contact_time_s: Option<f64>,
    /// `none`, `constant:0.4` or the name of a drag law.
    pub drag: Option<String>,
    /// Temperature of the air.
    pub temperature_k: Option<f64>,
    /// Pressure of the air.
    pub pressure_pa: Option<f64>,
    /// Relative humidity of the air, 0 to 1.
    pub relative_humidity: Option<f64>,
    /// Density of the air, in place of temperature, pressure and humidity; 0 is vacuum.
    pub air_density_kg_m3: Option<f64>,
    /// Viscosity of the air; goes with the density.
    pub air_viscosity_pa_s: Option<f64>,
    /// Whether the ball floats in air, if only a little. Usually it does.
    pub buoyancy: Option<bool>,
    /// Whether air moves with the ball. Usually it does.
    pub added_mass: Option<bool>,
    /// Gravity.
    pub gravity_m_s2: Option<f64>,
    /// Latitude in degrees, north positive, from which gravity follows.
    pub latitude_deg: Option<f64>,
    /// Height above the sea; goes with the latitude.
    pub altitude_m: Option<f64>,
    /// Measured drop height, surface to lowest point of the ball.
    pub height_m: Option<f64>,
    /// Its standard uncertainty; 2 mm if left out.
    pub height_sd_m: Option<f64>,
    /// When the ball was released, in the time of the recording.
    pub release_s: Option<f64>,
    /// Its standard uncertainty; 5 ms if left out.
    pub release_sd_s: Option<f64>,
    /// Whether the first impact detected is the first there was.
    pub first_detected: Option<bool>,
    /// Families of restitution laws to consider; all that the impacts can tell apart if left out.
    pub restitution_laws: Option<Vec<String>>,
    /// What to leave to the data, as if nothing were known of it.
    pub infer: Option<Vec<Inferred>>,
    /// First and last flight for the log-linear fit.
    pub flights: Option<(u32, u32)>,
    /// Impact speed at which to state the restitution.
    pub at_speed_m_s: Option<f64>,
    /// From which height does a bounce reach an apex?
    pub reach: Option<Vec<ApexTarget>>,
    /// Independent draws of the posterior to aim at, 100 to 100,000; 1,000 if left out.
    pub draws: Option<usize>,
    /// Seed of the random numbers of the inference; 1 if left out.
    pub seed: Option<u64>,
}

/// How many draws an inference may aim at: fewer say nothing of the tails, more take minutes.
const DRAWS: RangeInclusive<usize> = 100..=100_000;

impl Settings {
    /// What follows from them, with the inference or without.
    ///
    /// # Errors
    ///
    /// If something in them makes no sense, or does not go together.
    pub fn resolve(&self, inference: bool) -> Result<Setup> {
        let mut setup = self.setup()?.resolve()?;
        let options = &mut setup.options;
        options.flights = self
            .flights
            .map(|(first, last)| first as usize..=last as usize);
        options.priors = self.drop()?.add_to(&options.priors)?;
        options.inference = inference.then(|| self.inference()).transpose()?;
        Ok(setup)
    }

    fn inference(&self) -> Result<InferenceOptions> {
        let usual = SamplerConfig::default();
        let sampler = SamplerConfig {
            draws: self.draws.unwrap_or(usual.draws),
            seed: self.seed.unwrap_or(usual.seed),
        };
        let draws = *DRAWS.start() as f64..=*DRAWS.end() as f64;
        within(Quantity::Draws, sampler.draws as f64, draws)?;
        Ok(InferenceOptions {
            at_speed_m_s: self.at_speed_m_s,
            reach: self.reach.clone().unwrap_or_default(),
            sampler,
            each_impact: true,
        })
    }

    /// What looks like a mistake of units.
    pub fn questions(&self) -> Vec<Diagnostic> {
        let of_ball = self
            .mass_kg
            .zip(self.diameter_m)
            .and_then(|(mass, diameter)| {
                // What is no ball at all is refused as such.
                plausibility::of_ball(&Ball::new(mass, diameter).ok()?)
            });
        let stated = [
            ("contact-time", self.contact_time_s),
            ("temperature", self.temperature_k),
            ("pressure", self.pressure_pa),
            ("humidity", self.relative_humidity),
            ("air-density", self.air_density_kg_m3),
            ("gravity", self.gravity_m_s2),
            ("altitude", self.altitude_m),
            ("height", self.height_m),
            ("height-sd", self.height_sd_m),
        ];
        let of_quantities = stated.into_iter();
        of_quantities
            .filter_map(|(quantity, value)| plausibility::of_quantity(quantity, value?))
            .chain(of_ball)
            .collect()
    }

    fn setup(&self) -> Result<SetupInput> {
        Ok(SetupInput {
            ball: self.ball(),
            weighed_kg: self.mass_kg.filter(|_| self.ball.is_some()),
            measured_m: self.diameter_m.filter(|_| self.ball.is_some()),
            contact_time_s: self.contact_time_s,
            drag: self.drag.as_deref().map(str::parse).transpose()?,
            air: match self.air_density_kg_m3 {
                Some(density_kg_m3) => AirInput::Density {
                    density_kg_m3,
                    viscosity_pa_s: self.air_viscosity_pa_s,
                },
                None => AirInput::Weather {
                    temperature_k: self.temperature_k,
                    pressure_pa: self.pressure_pa,
                    relative_humidity: self.relative_humidity,
                },
            },
            no_buoyancy: self.buoyancy == Some(false),
            no_added_mass: self.added_mass == Some(false),
            gravity: self.gravity(),
        })
    }

    /// What is missing, or is no number, is refused as a quantity that is none.
    fn ball(&self) -> Option<BallInput> {
        let is_measured = self.mass_kg.is_some() || self.diameter_m.is_some();
        if self.ball.is_none() && is_measured {
            return Some(BallInput::Measured {
                mass_kg: self.mass_kg.unwrap_or(f64::NAN),
                diameter_m: self.diameter_m.unwrap_or(f64::NAN),
            });
        }
        let name = self.ball.as_deref()?;
        let metres = |text: &str| text.parse().unwrap_or(f64::NAN);
        Some(match name.split_once(':') {
            Some(("steel", diameter)) => BallInput::Steel(metres(diameter)),
            Some(("glass", diameter)) => BallInput::Glass(metres(diameter)),
            _ => BallInput::Named(name.to_owned()),
        })
    }

    fn gravity(&self) -> Option<GravityInput> {
        let place = |latitude_deg| GravityInput::Place {
            latitude_deg,
            altitude_m: self.altitude_m.unwrap_or(0.0),
        };
        self.gravity_m_s2
            .map(GravityInput::Measured)
            .or(self.latitude_deg.map(place))
    }

    fn drop(&self) -> Result<DropInput> {
        let laws = self.restitution_laws.iter().flatten();
        Ok(DropInput {
            height_m: self.height_m,
            height_sd_m: self.height_sd_m,
            release_s: self.release_s,
            release_sd_s: self.release_sd_s,
            first_detected: self.first_detected == Some(true),
            laws: laws.map(|law| law.parse()).collect::<Result<_>>()?,
            infer: self.infer.clone().unwrap_or_default(),
        })
    }
}
