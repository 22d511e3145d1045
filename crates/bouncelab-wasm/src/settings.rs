//! Converts the settings of the page to those of the science.

use bouncelab::ball::Ball;
use bouncelab::diagnostic::Diagnostic;
use bouncelab::inference::InferenceOptions;
use bouncelab::plausibility;
use bouncelab::setup::{AirInput, BallInput, DropInput, GravityInput, Setup, SetupInput};

use crate::refusal::Result;
use crate::wire::Settings;

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
        options.inference = inference.then(|| InferenceOptions {
            at_speed_m_s: self.at_speed_m_s,
            reach: self.reach.clone().unwrap_or_default(),
            ..InferenceOptions::default()
        });
        Ok(setup)
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
            ..SetupInput::default()
        })
    }

    /// What is missing, or is no number, is refused as a quantity that is none.
    fn ball(&self) -> Option<BallInput> {
        if self.mass_kg.is_some() || self.diameter_m.is_some() {
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
            first_heard: self.first_heard == Some(true),
            laws: laws
                .map(|law| law.parse())
                .collect::<bouncelab::Result<_>>()?,
            infer: self.infer.clone().unwrap_or_default(),
        })
    }
}
