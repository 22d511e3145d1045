//! The ball: mass, diameter, contact time, and how well they are known; presets with their source.
//!
//! ```
//! use bouncelab::ball::{self, Ball};
//!
//! let ball = ball::preset("table-tennis-38")?.known.ball;
//! assert_eq!(ball, Ball::new(2.5e-3, 38e-3)?);
//! assert_eq!(format!("{:.3e}", ball.weight_n(9.81)), "2.453e-2");
//! # Ok::<(), bouncelab::Error>(())
//! ```

mod contact;
mod presets;

use std::f64::consts::PI;

use crate::error::{Quantity, Result, of_a_size};

pub(crate) use presets::usual;
pub use presets::{Density, Preset, preset, presets};

/// A sphere with a mass and a diameter.
///
/// Both are from 1e-20 to 1e20: nothing outside bounces, and numbers end not far beyond.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Ball {
    mass_kg: f64,
    diameter_m: f64,
}

impl Ball {
    /// A ball of any mass and diameter.
    ///
    /// # Errors
    /// [`Error::OutOfRange`](crate::Error::OutOfRange) unless both are from 1e-20 to 1e20.
    ///
    /// ```
    /// use bouncelab::ball::Ball;
    ///
    /// let superball = Ball::new(46.9e-3, 0.047)?;
    /// assert_eq!(superball.mass_kg(), 46.9e-3);
    /// assert!(Ball::new(0.0, 0.047).is_err());
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn new(mass_kg: f64, diameter_m: f64) -> Result<Self> {
        Ok(Self {
            mass_kg: of_a_size(Quantity::BallMass, mass_kg)?,
            diameter_m: of_a_size(Quantity::BallDiameter, diameter_m)?,
        })
    }

    /// A ball of the list, in g and mm.
    pub(crate) const fn nominal(mass_g: f64, diameter_mm: f64) -> Self {
        Self {
            mass_kg: mass_g / 1000.0,
            diameter_m: diameter_mm / 1000.0,
        }
    }

    /// A solid ball.
    fn solid(density_kg_m3: f64, diameter_m: f64) -> Result<Self> {
        let diameter_m = of_a_size(Quantity::BallDiameter, diameter_m)?;
        Self::new(density_kg_m3 * sphere_volume_m3(diameter_m), diameter_m)
    }

    /// Mass in kilograms.
    pub fn mass_kg(&self) -> f64 {
        self.mass_kg
    }

    /// Diameter in metres.
    pub fn diameter_m(&self) -> f64 {
        self.diameter_m
    }

    /// Cross-section A = π D²/4 in square metres.
    pub fn area_m2(&self) -> f64 {
        PI / 4.0 * self.diameter_m * self.diameter_m
    }

    /// Mean density in kilograms per cubic metre.
    pub(crate) fn density_kg_m3(&self) -> f64 {
        self.mass_kg / self.volume_m3()
    }

    /// Volume V = π D³/6 in cubic metres.
    pub fn volume_m3(&self) -> f64 {
        sphere_volume_m3(self.diameter_m)
    }

    /// Weight m g in newtons.
    ///
    /// ```
    /// let ball = bouncelab::ball::preset("table-tennis-38")?.known.ball;
    /// assert_eq!(format!("{:.4} N", ball.weight_n(9.81)), "0.0245 N");
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn weight_n(&self, gravity_m_s2: f64) -> f64 {
        self.mass_kg * gravity_m_s2
    }
}

/// A ball, its contact time, and how well they are known.
///
/// The uncertainties are relative standard uncertainties, that of the contact time the standard deviation of its
/// logarithm.
///
/// ```
/// use bouncelab::ball::{self, Ball, KnownBall};
///
/// let basketball = KnownBall::from(ball::preset("basketball")?);
/// // Of a ball that was weighed and measured, the mean density tells how long an impact takes.
/// let weighed = KnownBall::from(Ball::new(0.6, 0.243)?);
/// assert!((0.5..2.0).contains(&(weighed.contact_time_s / basketball.contact_time_s)));
/// assert!(weighed.contact_time_rel_sd > basketball.contact_time_rel_sd);
/// # Ok::<(), bouncelab::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct KnownBall {
    /// Mass and diameter.
    pub ball: Ball,
    /// How long one impact lasts on a hard surface, in seconds.
    pub contact_time_s: f64,
    /// Of the mass.
    pub mass_rel_sd: f64,
    /// Of the diameter.
    pub diameter_rel_sd: f64,
    /// Of the contact time: it depends on the surface, the speed and the inflation.
    pub contact_time_rel_sd: f64,
    /// Of the drag coefficient: how far it may lie from that of a smooth sphere. Felt, seams, holes and dimples are a
    /// judgement; the smooth laws themselves differ by 4 %.
    pub drag_rel_sd: f64,
}

/// Relative standard uncertainty of a mass by a scale.
pub(crate) const WEIGHED_REL_SD: f64 = 0.003;
/// Relative standard uncertainty of a diameter by a calliper.
pub(crate) const CALLIPERED_REL_SD: f64 = 0.002;
/// Relative standard uncertainty of the drag coefficient of a ball whose surface nobody stated: felt adds a quarter
/// or more to that of a smooth sphere (of a tennis ball it is 0.5 to 0.65, R. D. Mehta and J. M. Pallis, Sports
/// Engineering 4, 177, 2001), which is two of them.
const UNKNOWN_SURFACE_REL_SD: f64 = 0.15;

/// A ball of which only mass and diameter are known, as by a scale and a calliper.
impl From<Ball> for KnownBall {
    fn from(ball: Ball) -> Self {
        let contact = contact::of_density(&ball);
        Self {
            ball,
            contact_time_s: contact.time_s,
            mass_rel_sd: WEIGHED_REL_SD,
            diameter_rel_sd: CALLIPERED_REL_SD,
            contact_time_rel_sd: contact.rel_sd,
            drag_rel_sd: UNKNOWN_SURFACE_REL_SD,
        }
    }
}

impl From<&Preset> for KnownBall {
    fn from(preset: &Preset) -> Self {
        preset.known
    }
}

fn sphere_volume_m3(diameter_m: f64) -> f64 {
    PI / 6.0 * diameter_m.powi(3)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Error;

    #[test]
    fn absurd_balls_are_refused() {
        for (mass_kg, diameter_m) in [
            (-1.0, 0.04),
            (0.0, 0.04),
            (0.0027, 0.0),
            (f64::NAN, 0.04),
            (0.0027, f64::INFINITY),
        ] {
            assert!(matches!(
                Ball::new(mass_kg, diameter_m),
                Err(Error::OutOfRange { .. })
            ));
        }
    }
}
