//! What does the page state, in the words of the science?

use bouncelab::analysis::Impact;
use bouncelab::estimate;
use bouncelab::stated::{
    self, Stated, StatedAir, StatedBall, StatedDrop, StatedGravity, Understood,
};

use crate::refusal::{Refusal, RefusalKind, Result};
use crate::wire::{Effort, Inferred, Mark, Settings};

impl Settings {
    /// What follows from them, with what is to be asked.
    ///
    /// # Errors
    ///
    /// If something in them makes no sense, or does not go together.
    pub fn understand(&self, effort: Effort) -> Result<Understood> {
        let mut understood = self.stated()?.understand()?;
        let settings = &mut understood.settings;
        settings.flights = self
            .flights
            .map(|(first, last)| first as usize..=last as usize);
        settings.knowledge = self.stated_drop()?.add_to(&settings.knowledge)?;
        settings.question = (effort == Effort::Full).then(|| self.question());
        Ok(understood)
    }

    fn stated(&self) -> Result<Stated> {
        Ok(Stated {
            ball: self.stated_ball()?,
            contact_time_s: self.contact_time_s,
            drag: self.drag.as_deref().map(str::parse).transpose()?,
            air: match self.air_density_kg_m3 {
                Some(density_kg_m3) => StatedAir::Density {
                    density_kg_m3,
                    viscosity_pa_s: self.air_viscosity_pa_s,
                },
                None => StatedAir::Weather {
                    temperature_k: self.temperature_k,
                    pressure_pa: self.pressure_pa,
                    relative_humidity: self.relative_humidity,
                },
            },
            no_buoyancy: self.buoyancy == Some(false),
            no_added_mass: self.added_mass == Some(false),
            gravity: self.stated_gravity(),
            ..Stated::default()
        })
    }

    fn stated_ball(&self) -> Result<Option<StatedBall>> {
        match (self.mass_kg, self.diameter_m) {
            (Some(mass_kg), Some(diameter_m)) => {
                return Ok(Some(StatedBall::Measured {
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
            Some(("steel", diameter)) => StatedBall::Steel(diameter_m(diameter)?),
            Some(("glass", diameter)) => StatedBall::Glass(diameter_m(diameter)?),
            _ => StatedBall::Named(name.to_owned()),
        }))
    }

    fn stated_gravity(&self) -> Option<StatedGravity> {
        let place = |latitude_deg| StatedGravity::Place {
            latitude_deg,
            altitude_m: self.altitude_m.unwrap_or(0.0),
        };
        self.gravity_m_s2
            .map(StatedGravity::Measured)
            .or(self.latitude_deg.map(place))
    }

    fn stated_drop(&self) -> Result<StatedDrop> {
        let laws = self.restitution_laws.iter().flatten();
        let inferred = self.infer.iter().flatten();
        Ok(StatedDrop {
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

    fn question(&self) -> estimate::Question {
        let reach = self.reach.iter().flatten();
        estimate::Question {
            at_speed_m_s: self.at_speed_m_s,
            reach: reach
                .map(|reach| estimate::Reach {
                    bounce: reach.bounce as usize,
                    apex_m: reach.apex_m,
                })
                .collect(),
            effort: estimate::Effort::default(),
        }
    }
}

impl From<Inferred> for stated::Inferred {
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
