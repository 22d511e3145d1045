//! What does the page state, in the words of the science?

use bouncelab::analysis::Impact;
use bouncelab::inference;
use bouncelab::setup::{self, AirInput, BallInput, DropInput, GravityInput, Setup, SetupInput};

use crate::refusal::{Refusal, RefusalKind, Result};
use crate::wire::{Effort, Inferred, Mark, Settings};

impl Settings {
    /// What follows from them, with what is to be asked.
    ///
    /// # Errors
    ///
    /// If something in them makes no sense, or does not go together.
    pub fn resolve(&self, effort: Effort) -> Result<Setup> {
        let mut setup = self.stated()?.resolve()?;
        let settings = &mut setup.settings;
        settings.flights = self
            .flights
            .map(|(first, last)| first as usize..=last as usize);
        settings.priors = self.stated_drop()?.add_to(&settings.priors)?;
        settings.inference = (effort == Effort::Full).then(|| self.inference());
        Ok(setup)
    }

    fn stated(&self) -> Result<SetupInput> {
        Ok(SetupInput {
            ball: self.stated_ball()?,
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
            gravity: self.stated_gravity(),
            ..SetupInput::default()
        })
    }

    fn stated_ball(&self) -> Result<Option<BallInput>> {
        match (self.mass_kg, self.diameter_m) {
            (Some(mass_kg), Some(diameter_m)) => {
                return Ok(Some(BallInput::Measured {
                    mass_kg,
                    diameter_m,
                }));
            }
            (None, None) => {}
            _ => return Err(setting("the mass of a ball goes with its diameter")),
        }
        let Some(name) = self.ball.as_deref() else {
            return Ok(None);
        };
        let diameter_m = |text: &str| {
            let metres = text.parse::<f64>();
            metres.map_err(|_| setting(&format!("\"{text}\" is no diameter in metres")))
        };
        Ok(Some(match name.split_once(':') {
            Some(("steel", diameter)) => BallInput::Steel(diameter_m(diameter)?),
            Some(("glass", diameter)) => BallInput::Glass(diameter_m(diameter)?),
            _ => BallInput::Named(name.to_owned()),
        }))
    }

    fn stated_gravity(&self) -> Option<GravityInput> {
        let place = |latitude_deg| GravityInput::Place {
            latitude_deg,
            altitude_m: self.altitude_m.unwrap_or(0.0),
        };
        self.gravity_m_s2
            .map(GravityInput::Measured)
            .or(self.latitude_deg.map(place))
    }

    fn stated_drop(&self) -> Result<DropInput> {
        let laws = self.restitution_laws.iter().flatten();
        let inferred = self.infer.iter().flatten();
        Ok(DropInput {
            height_m: self.height_m,
            height_sd_m: self.height_sd_m,
            release_s: self.release_s,
            release_sd_s: self.release_sd_s,
            first_heard: self.first_heard == Some(true),
            laws: laws
                .map(|law| law.parse())
                .collect::<bouncelab::Result<_>>()?,
            infer: inferred.map(|&inferred| inferred.into()).collect(),
        })
    }

    fn inference(&self) -> inference::InferenceOptions {
        let reach = self.reach.iter().flatten();
        inference::InferenceOptions {
            at_speed_m_s: self.at_speed_m_s,
            reach: reach
                .map(|reach| inference::ApexTarget {
                    bounce: reach.bounce as usize,
                    apex_m: reach.apex_m,
                })
                .collect(),
            sampler: inference::SamplerConfig::default(),
        }
    }
}

impl From<Inferred> for setup::Inferred {
    fn from(inferred: Inferred) -> Self {
        match inferred {
            Inferred::Gravity => Self::Gravity,
            Inferred::Drag => Self::Drag,
            Inferred::ContactTime => Self::ContactTime,
        }
    }
}

/// A refusal of a setting.
pub(crate) fn setting(message: &str) -> Refusal {
    Refusal::new(RefusalKind::Setting, message)
}

impl From<Impact> for Mark {
    fn from(impact: Impact) -> Self {
        Self {
            number: impact.number as u32,
            time_s: impact.time_s,
            sigma_s: impact.sigma_s,
            probability: impact.probability,
            level_db: impact.level_db,
        }
    }
}

impl From<Mark> for Impact {
    fn from(mark: Mark) -> Self {
        Self {
            number: mark.number as usize,
            time_s: mark.time_s,
            sigma_s: mark.sigma_s,
            probability: mark.probability,
            level_db: mark.level_db,
        }
    }
}
