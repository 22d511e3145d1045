//! The ball.

use super::plausibility::{Ordinary, reading, shown};
use crate::Result;
use crate::ball::{self, Ball};
use crate::diagnostic::{Code, Diagnostic};
use crate::inference::Priors;

/// Contact time where nothing is known of the ball, in seconds: an order of magnitude.
const CONTACT_S: f64 = 1e-3;
/// Contact time of steel and glass, in seconds, which is far shorter than that of hollow balls.
const HARD_CONTACT_S: f64 = 5e-5;

/// Relative standard uncertainty of a mass by a scale.
const WEIGHED_REL_SD: f64 = 0.003;
/// Relative standard uncertainty of a diameter by a calliper.
const CALLIPERED_REL_SD: f64 = 0.002;
/// Relative standard uncertainty of a measured contact time.
const CONTACT_REL_SD: f64 = 0.1;

/// What is given of the ball.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(default, deny_unknown_fields))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(optional_fields))]
pub struct BallSettings {
    /// Name of a [preset](ball::presets), or `steel:0.01` or `glass:0.016` with the diameter in metres; the first
    /// preset if left out.
    pub kind: Option<String>,
    /// Mass: as weighed, or with the diameter in place of a kind.
    pub mass_kg: Option<f64>,
    /// Diameter: as measured, or with the mass in place of a kind.
    pub diameter_m: Option<f64>,
    /// Contact time of ball and surface; typical of the kind if left out.
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
#[derive(Clone, Debug, PartialEq)]
pub enum BallKind {
    /// The name of a preset.
    Preset(String),
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

/// A ball, its contact time, and how well both are known.
pub(super) struct KnownBall {
    pub(super) ball: Ball,
    pub(super) contact_time_s: f64,
    pub(super) priors: Priors,
}

impl BallSettings {
    pub(super) fn resolve(
        &self,
        assumptions: &mut Vec<Diagnostic>,
    ) -> Result<(BallKind, KnownBall)> {
        let kind = self.kind().unwrap_or_else(|| {
            let usual = ball::usual().name;
            assumptions.push(Diagnostic::new(Code::AssumedBall).with("ball", usual));
            BallKind::Preset(usual.to_owned())
        });
        let mut known = kind.known()?;
        if self.kind.is_some() {
            let mass_kg = self.mass_kg.unwrap_or(known.ball.mass_kg());
            let diameter_m = self.diameter_m.unwrap_or(known.ball.diameter_m());
            known.ball = Ball::new(mass_kg, diameter_m)?;
        }
        if let Some(contact_time_s) = self.contact_time_s {
            known.contact_time_s = contact_time_s;
        } else {
            let assumed = Diagnostic::new(Code::AssumedContactTime);
            assumptions.push(assumed.with("contact_time_s", known.contact_time_s));
        }
        Ok((kind, known))
    }

    /// What was measured is known well, whatever the kind.
    pub(super) fn inform(&self, priors: &mut Priors) {
        if self.mass_kg.is_some() {
            priors.mass_rel_sd = WEIGHED_REL_SD;
        }
        if self.diameter_m.is_some() {
            priors.diameter_rel_sd = CALLIPERED_REL_SD;
        }
        if self.contact_time_s.is_some() {
            priors.contact_time_rel_sd = CONTACT_REL_SD;
        }
    }

    /// The kind that is given. A mass without a diameter, or a diameter that is no number, becomes NaN, which
    /// [`Ball::new`] refuses by name.
    fn kind(&self) -> Option<BallKind> {
        let Some(name) = self.kind.as_deref() else {
            let is_measured = self.mass_kg.is_some() || self.diameter_m.is_some();
            return is_measured.then(|| BallKind::Measured {
                mass_kg: self.mass_kg.unwrap_or(f64::NAN),
                diameter_m: self.diameter_m.unwrap_or(f64::NAN),
            });
        };
        let metres = |text: &str| text.parse().unwrap_or(f64::NAN);
        Some(match name.split_once(':') {
            Some(("steel", diameter)) => BallKind::Steel(metres(diameter)),
            Some(("glass", diameter)) => BallKind::Glass(metres(diameter)),
            _ => BallKind::Preset(name.to_owned()),
        })
    }
}

impl BallKind {
    fn known(&self) -> Result<KnownBall> {
        let measured = |ball, contact_time_s| KnownBall {
            ball,
            contact_time_s,
            priors: Priors {
                mass_rel_sd: WEIGHED_REL_SD,
                diameter_rel_sd: CALLIPERED_REL_SD,
                ..Priors::default()
            },
        };
        Ok(match *self {
            Self::Preset(ref name) => {
                let preset = ball::preset(name)?;
                KnownBall {
                    ball: preset.ball,
                    contact_time_s: preset.contact_time_s,
                    priors: Priors::of_preset(preset),
                }
            }
            Self::Steel(diameter_m) => measured(Ball::steel(diameter_m)?, HARD_CONTACT_S),
            Self::Glass(diameter_m) => measured(Ball::glass(diameter_m)?, HARD_CONTACT_S),
            Self::Measured {
                mass_kg,
                diameter_m,
            } => measured(Ball::new(mass_kg, diameter_m)?, CONTACT_S),
        })
    }
}
