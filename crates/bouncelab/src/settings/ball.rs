//! The ball.

use super::plausibility::{Ordinary, reading, shown};
use crate::ball::{self, Ball, KnownBall, Preset};
use crate::diagnostic::{Code, Diagnostic};
use crate::{Error, Result};

/// Relative standard uncertainty of a measured contact time.
const CONTACT_REL_SD: f64 = 0.1;

/// What is given of the ball.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(optional_fields))]
pub struct BallSettings {
    /// Name of a [preset](ball::preset), also with the diameter in metres, as in `steel:0.01`; one of the unknowns
    /// if left out.
    pub kind: Option<String>,
    /// Mass as weighed: of a ball of this kind, whose drag and contact time stay, or without a kind, with the diameter.
    pub mass_kg: Option<f64>,
    /// Diameter as measured: of a ball of this kind, or without a kind, with the mass.
    pub diameter_m: Option<f64>,
    /// Contact time of ball and surface; typical of the kind, or of the mean density, if left out.
    pub contact_time_s: Option<f64>,
}

/// Ordinary values.
pub(super) const ORDINARY: &[Ordinary] = &[Ordinary {
    quantity: "contact-time",
    given: |settings| settings.ball.contact_time_s,
    range: 0.0..=0.05,
    shown: shown("s"),
    readings: &[reading(1e-3, "ms"), reading(1e-6, "us")],
}];

/// Which ball it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BallKind {
    /// Nobody stated it: it is one of the unknowns.
    Unstated,
    /// A preset.
    Preset(&'static Preset),
    /// A preset with a diameter of its own, in metres.
    Sized(&'static Preset, f64),
    /// Weighed and measured.
    Measured(Ball),
}

impl BallSettings {
    /// The ball, and the assumptions that were made of it.
    pub(super) fn resolve(
        &self,
        assumptions: &mut Vec<Diagnostic>,
    ) -> Result<(BallKind, KnownBall)> {
        let (kind, mut known) = self.known()?;
        if let Some(contact_time_s) = self.contact_time_s {
            known.contact_time_s = contact_time_s;
            known.contact_time_rel_sd = CONTACT_REL_SD;
        } else if kind != BallKind::Unstated {
            let assumed = Diagnostic::new(Code::AssumedContactTime);
            assumptions.push(assumed.with("contact_time_s", known.contact_time_s));
        }
        Ok((kind, known))
    }

    /// The ball, before its contact time. A mass without a diameter, or a diameter that is no number, becomes NaN, which
    /// [`Ball::new`] refuses by name.
    pub(super) fn known(&self) -> Result<(BallKind, KnownBall)> {
        let Some(name) = self.kind.as_deref() else {
            return match (self.mass_kg, self.diameter_m) {
                (None, None) => Ok((BallKind::Unstated, ball::usual().known)),
                (mass_kg, diameter_m) => {
                    let given = |value: Option<f64>| value.unwrap_or(f64::NAN);
                    let ball = Ball::new(given(mass_kg), given(diameter_m))?;
                    Ok((BallKind::Measured(ball), ball.into()))
                }
            };
        };
        let (preset, diameter_m) = match (name.split_once(':'), self.diameter_m) {
            (None, diameter_m) => (ball::preset(name)?, diameter_m),
            (Some((kind, size)), None) => {
                (ball::preset(kind)?, Some(size.parse().unwrap_or(f64::NAN)))
            }
            (Some(_), Some(diameter_m)) => {
                let other = format!("diameter {diameter_m} m");
                return Err(Error::contradiction(&format!("ball {name}"), &other));
            }
        };
        let kind = match diameter_m {
            Some(diameter_m) => BallKind::Sized(preset, diameter_m),
            None => BallKind::Preset(preset),
        };
        Ok((kind, preset.measured(self.mass_kg, diameter_m)?))
    }
}
