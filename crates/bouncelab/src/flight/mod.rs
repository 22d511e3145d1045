//! One flight: duration, apex and impact speed from the launch speed, and the inverse.
//!
//! A [`FlightModel`] is a ball in its surroundings. Where the drag coefficient is constant (or there
//! is no drag) every answer is the exact closed form of the paper (Eqs. 11 to 17), written so that
//! it passes to the drag-free limit without losing a digit. Where it follows the Reynolds number
//! the same answers come from quadrature, to 1e-11 relative.
//!
//! ```
//! use bouncelab::air::Air;
//! use bouncelab::ball;
//! use bouncelab::drag::DragLaw;
//! use bouncelab::flight::{Environment, FlightModel};
//!
//! // The paper's ball, air and constant drag coefficient.
//! let surroundings = Environment {
//!     gravity_m_s2: 9.81,
//!     air: Air::new(1.2276, 1.8414e-5)?,
//!     drag: DragLaw::Constant(0.4),
//!     buoyancy: false,
//!     added_mass: false,
//! };
//! let model = FlightModel::new(&ball::preset("table-tennis-38")?.known.ball, &surroundings)?;
//! assert_eq!(format!("{:.2}", model.terminal_speed_m_s().unwrap()), "9.38");
//!
//! // Dropped from 30.5 cm it arrives with 2.405 m/s (Eq. 15).
//! assert_eq!(format!("{:.3}", model.fall(0.305)?.impact_speed_m_s), "2.405");
//!
//! // The time between two impacts gives the launch speed.
//! let flight = model.from_flight_time(0.4272)?;
//! assert!((flight.time_s() - 0.4272).abs() < 1e-15);
//! assert!(flight.impact_speed_m_s < flight.launch_speed_m_s);
//! # Ok::<(), bouncelab::Error>(())
//! ```

mod quadratic;
mod quadrature;
mod reynolds;
pub(crate) mod table;
#[cfg(test)]
mod tests;

use crate::air::Air;
use crate::ball::Ball;
use crate::drag::DragLaw;
use crate::error::{Error, Quantity, Result, of_a_size, positive, within};
use quadratic::QuadraticDrag;
use reynolds::ReynoldsDrag;

/// What a ball flies through.
///
/// Plain numbers; they are checked when a [`FlightModel`] is made of them.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Environment {
    /// Gravity in m/s², above zero.
    pub gravity_m_s2: f64,
    /// The air.
    pub air: Air,
    /// The drag of the ball in the air.
    pub drag: DragLaw,
    /// Whether the air carries its share of the weight (off in the paper).
    pub buoyancy: bool,
    /// Whether the ball accelerates half its volume of air along with it
    /// (off in the paper). The flow of a bouncing ball is not the potential flow of the textbook, so
    /// one half is an estimate.
    pub added_mass: bool,
}

/// A flight from a launch off the surface to the next impact on it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Flight {
    /// Speed just after the impact that starts the flight, m/s.
    pub launch_speed_m_s: f64,
    /// Speed just before the impact that ends it, m/s.
    pub impact_speed_m_s: f64,
    /// Maximum height above the surface, m.
    pub apex_m: f64,
    /// Time from the launch to the apex, s.
    pub rise_time_s: f64,
    /// Time from the apex to the impact, s.
    pub fall_time_s: f64,
}

impl Flight {
    /// The flight time, s: from leaving the surface to touching it again.
    ///
    /// ```
    /// use bouncelab::flight::FlightModel;
    ///
    /// let flight = FlightModel::drag_free(9.81)?.launch(1.0)?;
    /// assert_eq!(flight.time_s(), flight.rise_time_s + flight.fall_time_s);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn time_s(&self) -> f64 {
        self.rise_time_s + self.fall_time_s
    }
}

/// A fall from rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fall {
    /// Height of the lowest point of the ball above the surface at release, m.
    pub height_m: f64,
    /// Time from release to impact, s.
    pub time_s: f64,
    /// Speed just before the impact, m/s.
    pub impact_speed_m_s: f64,
}

/// Height and velocity of a ball.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// Height of its lowest point above the surface, m.
    pub height_m: f64,
    /// Velocity, upwards positive, m/s.
    pub velocity_m_s: f64,
}

/// How a flight changes with its launch speed; exact for every drag law.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct LaunchDerivatives {
    /// d(flight time)/d(launch speed), s²/m.
    pub time: f64,
    /// d(impact speed)/d(launch speed).
    pub impact_speed: f64,
    /// d(apex)/d(launch speed), s.
    pub apex: f64,
}

impl LaunchDerivatives {
    /// With v the launch speed, v' the impact speed, h the apex and η drag over weight, energy gives
    /// dh/dv = v/(g (1 + η(v))) = (dv'/dv) v'/(g (1 - η(v'))), and from there dT/dv =
    /// (1 + v/v')/(g (1 + η(v))). So no drag law needs a quadrature for them.
    fn of(flight: &Flight, gravity: f64, eta_at_launch: f64, eta_at_impact: f64) -> Self {
        let Flight {
            launch_speed_m_s,
            impact_speed_m_s,
            ..
        } = *flight;
        let slowing = gravity * (1.0 + eta_at_launch);
        let gaining = gravity * (1.0 - eta_at_impact);
        let ratio = if impact_speed_m_s > 0.0 {
            launch_speed_m_s / impact_speed_m_s
        } else {
            1.0
        };
        Self {
            time: (1.0 + ratio) / slowing,
            impact_speed: ratio * gaining / slowing,
            apex: launch_speed_m_s / slowing,
        }
    }
}

/// A ball in its surroundings, ready to fly.
#[derive(Debug, Clone, PartialEq)]
pub struct FlightModel {
    resistance: Resistance,
    moving_mass_kg: Option<f64>,
}

/// The two methods of solving a flight.
#[derive(Debug, Clone, PartialEq)]
enum Resistance {
    Quadratic(QuadraticDrag),
    Reynolds(ReynoldsDrag),
}

impl FlightModel {
    /// A ball in an environment.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a gravity or a constant drag coefficient outside its range,
    /// [`Error::Floats`] if buoyancy is on and the ball is lighter than air.
    ///
    /// ```
    /// use bouncelab::air::{Air, Conditions};
    /// use bouncelab::ball::{self, Ball};
    /// use bouncelab::drag::DragLaw;
    /// use bouncelab::flight::{Environment, FlightModel};
    ///
    /// let environment = Environment {
    ///     gravity_m_s2: 9.81,
    ///     air: Air::moist(&Conditions::default())?,
    ///     drag: DragLaw::Standard,
    ///     buoyancy: true,
    ///     added_mass: true,
    /// };
    /// let model = FlightModel::new(&ball::preset("steel")?.known.ball, &environment)?;
    /// assert!(model.gravity_m_s2() < 9.81);
    /// // A balloon does not fall.
    /// assert!(FlightModel::new(&Ball::new(1e-3, 0.3)?, &environment).is_err());
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn new(ball: &Ball, environment: &Environment) -> Result<Self> {
        let Environment {
            gravity_m_s2,
            air,
            ref drag,
            buoyancy,
            added_mass,
        } = *environment;
        of_a_size(Quantity::Gravity, gravity_m_s2)?;
        drag.check()?;
        let displaced_kg = air.density_kg_m3() * ball.volume_m3();
        let carried_kg = if buoyancy { displaced_kg } else { 0.0 };
        if carried_kg >= ball.mass_kg() {
            return Err(Error::Floats {
                mass_kg: ball.mass_kg(),
                displaced_kg,
            });
        }
        let moving_mass_kg = ball.mass_kg() + if added_mass { displaced_kg / 2.0 } else { 0.0 };
        let weight_n = (ball.mass_kg() - carried_kg) * gravity_m_s2;
        let gravity = weight_n / moving_mass_kg;
        let coefficient = match *drag {
            DragLaw::None => Some(0.0),
            DragLaw::Constant(coefficient) => Some(coefficient),
            _ if air.is_vacuum() => Some(0.0),
            _ => None,
        };
        let resistance = match coefficient {
            Some(coefficient) => {
                let force_per_speed_squared =
                    air.density_kg_m3() * ball.area_m2() * coefficient / 2.0;
                Resistance::Quadratic(QuadraticDrag::new(
                    gravity,
                    (force_per_speed_squared / weight_n).sqrt(),
                ))
            }
            None => Resistance::Reynolds(ReynoldsDrag::new(
                ball,
                &air,
                drag.clone(),
                weight_n,
                gravity,
            )),
        };
        Ok(Self {
            resistance,
            moving_mass_kg: Some(moving_mass_kg),
        })
    }

    /// A flight without air.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless gravity is from 1e-20 to 1e20.
    ///
    /// ```
    /// use bouncelab::flight::FlightModel;
    ///
    /// let flight = FlightModel::drag_free(10.0)?.launch(2.0)?;
    /// assert!((flight.time_s() - 0.4).abs() < 1e-12 && (flight.apex_m - 0.2).abs() < 1e-12);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn drag_free(gravity_m_s2: f64) -> Result<Self> {
        Self::with_terminal_speed(gravity_m_s2, f64::INFINITY)
    }

    /// A flight with a constant drag coefficient, given by the terminal speed it leads to; an
    /// infinite terminal speed means no drag.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless gravity is from 1e-20 to 1e20 and the terminal speed above
    /// zero.
    ///
    /// ```
    /// use bouncelab::flight::FlightModel;
    ///
    /// // The paper's ball with C_D = 0.4.
    /// let model = FlightModel::with_terminal_speed(9.81, 9.385)?;
    /// assert_eq!(format!("{:.4}", model.drag_over_weight(2.4)?), "0.0654");
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn with_terminal_speed(gravity_m_s2: f64, terminal_speed_m_s: f64) -> Result<Self> {
        of_a_size(Quantity::Gravity, gravity_m_s2)?;
        if terminal_speed_m_s != f64::INFINITY {
            positive(Quantity::TerminalSpeed, terminal_speed_m_s)?;
        }
        let drag = QuadraticDrag::new(gravity_m_s2, terminal_speed_m_s.recip());
        Ok(Self {
            resistance: Resistance::Quadratic(drag),
            moving_mass_kg: None,
        })
    }

    /// The flight that starts at a launch speed (paper Eqs. 16 and 17).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the speed is finite and not below zero,
    /// [`Error::ReynoldsTooHigh`] if the speed is above the range of the drag law.
    ///
    /// ```
    /// use bouncelab::flight::FlightModel;
    ///
    /// let flight = FlightModel::with_terminal_speed(9.81, 9.385)?.launch(2.0)?;
    /// assert!(flight.impact_speed_m_s < flight.launch_speed_m_s);
    /// assert!(flight.rise_time_s < flight.fall_time_s);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn launch(&self, speed_m_s: f64) -> Result<Flight> {
        within(Quantity::LaunchSpeed, speed_m_s, 0.0..)?;
        match &self.resistance {
            Resistance::Quadratic(drag) => {
                let flight = drag.launch(speed_m_s);
                let in_numbers = flight.apex_m.is_finite().then_some(flight);
                in_numbers
                    .ok_or_else(|| Error::out_of_range(Quantity::LaunchSpeed, speed_m_s, ..1e150))
            }
            Resistance::Reynolds(drag) => drag.launch(speed_m_s),
        }
    }

    /// The flight that lasts a given time: the inverse of [`FlightModel::launch`], to 1e-12.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the time is finite and not below zero, or if drag makes a flight of this duration
    /// impossible; [`Error::ReynoldsTooHigh`] as for a launch.
    ///
    /// ```
    /// use bouncelab::flight::FlightModel;
    ///
    /// let model = FlightModel::with_terminal_speed(9.81, 9.385)?;
    /// let flight = model.from_flight_time(0.4605)?;
    /// assert_eq!(format!("{:.1} cm", 100.0 * flight.apex_m), "26.0 cm");
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn from_flight_time(&self, time_s: f64) -> Result<Flight> {
        within(Quantity::FlightTime, time_s, 0.0..)?;
        match &self.resistance {
            Resistance::Quadratic(drag) => {
                let speed_m_s = drag.launch_speed_of_time(time_s);
                let flight = speed_m_s.is_finite().then(|| self.launch(speed_m_s));
                // With this drag no launch speed gives such a long flight.
                flight.ok_or_else(|| Error::out_of_range(Quantity::FlightTime, time_s, ..time_s))?
            }
            Resistance::Reynolds(drag) => drag.launch_lasting(time_s),
        }
    }

    /// The flight that rises to a given height.
    ///
    /// # Errors
    /// As for [`FlightModel::from_flight_time`].
    ///
    /// ```
    /// use bouncelab::flight::FlightModel;
    ///
    /// let flight = FlightModel::drag_free(9.81)?.from_apex(0.24)?;
    /// assert_eq!(format!("{:.3} m/s", flight.launch_speed_m_s), "2.170 m/s");
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn from_apex(&self, apex_m: f64) -> Result<Flight> {
        within(Quantity::Apex, apex_m, 0.0..)?;
        match &self.resistance {
            Resistance::Quadratic(drag) => {
                let speed_m_s = drag.launch_speed_of_apex(apex_m);
                let flight = speed_m_s.is_finite().then(|| self.launch(speed_m_s));
                // With this drag no launch speed gives such a high flight.
                flight.ok_or_else(|| Error::out_of_range(Quantity::Apex, apex_m, ..apex_m))?
            }
            Resistance::Reynolds(drag) => drag.launch_rising_to(apex_m),
        }
    }

    /// A fall from rest (paper Eqs. 11 and 13 to 15).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the height is finite and not below zero,
    /// [`Error::ReynoldsTooHigh`] if the ball exceeds the range of the drag law.
    ///
    /// ```
    /// use bouncelab::flight::FlightModel;
    ///
    /// // The paper: 2.45 m/s without air, 2.405 m/s with it.
    /// let impact = |model: FlightModel| model.fall(0.305).map(|fall| fall.impact_speed_m_s);
    /// assert_eq!(format!("{:.3}", impact(FlightModel::drag_free(9.81)?)?), "2.446");
    /// assert_eq!(format!("{:.3}", impact(FlightModel::with_terminal_speed(9.81, 9.385)?)?), "2.405");
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn fall(&self, height_m: f64) -> Result<Fall> {
        within(Quantity::Height, height_m, 0.0..)?;
        match &self.resistance {
            Resistance::Quadratic(drag) => {
                let fall = drag.fall(height_m);
                let in_numbers = fall.time_s.is_finite().then_some(fall);
                in_numbers.ok_or_else(|| Error::out_of_range(Quantity::Height, height_m, ..1e150))
            }
            Resistance::Reynolds(drag) => drag.fall(height_m),
        }
    }

    /// Height and velocity at a time after the launch of a flight of this model (paper Eq. 12 for
    /// the rise, Eqs. 11 and 14 for the fall).
    ///
    /// Times before the launch and after the impact count as launch and impact.
    ///
    /// ```
    /// use bouncelab::flight::FlightModel;
    ///
    /// let model = FlightModel::with_terminal_speed(9.81, 9.385)?;
    /// let flight = model.launch(2.0)?;
    /// let top = model.state(&flight, flight.rise_time_s);
    /// assert!((top.height_m - flight.apex_m).abs() < 1e-12 && top.velocity_m_s.abs() < 1e-12);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn state(&self, flight: &Flight, time_s: f64) -> State {
        let time_s = time_s.clamp(0.0, flight.time_s());
        if time_s < flight.rise_time_s {
            return match &self.resistance {
                Resistance::Quadratic(drag) => drag.rising(flight.launch_speed_m_s, time_s),
                Resistance::Reynolds(drag) => drag.rising(flight, time_s),
            };
        }
        self.fallen(flight.apex_m, time_s - flight.rise_time_s)
    }

    /// Height and velocity at a time after the release of a fall of this model (paper Eqs. 11, 14).
    ///
    /// Times before the release and after the impact count as release and impact.
    ///
    /// ```
    /// use bouncelab::flight::FlightModel;
    ///
    /// let model = FlightModel::drag_free(10.0)?;
    /// let fall = model.fall(1.8)?; // takes 0.6 s
    /// let half_way = model.fall_state(&fall, 0.3);
    /// assert!((half_way.height_m - 1.35).abs() < 1e-12 && (half_way.velocity_m_s + 3.0).abs() < 1e-12);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn fall_state(&self, fall: &Fall, time_s: f64) -> State {
        self.fallen(fall.height_m, time_s.clamp(0.0, fall.time_s))
    }

    /// The state at a time after coming to rest at a height.
    fn fallen(&self, height_m: f64, time_s: f64) -> State {
        let (depth_m, speed_m_s) = match &self.resistance {
            Resistance::Quadratic(drag) => drag.falling(time_s),
            Resistance::Reynolds(drag) => drag.falling(time_s),
        };
        State {
            height_m: (height_m - depth_m).max(0.0),
            velocity_m_s: -speed_m_s,
        }
    }

    /// How a flight of this model changes with its launch speed.
    ///
    /// # Errors
    /// [`Error::ReynoldsTooHigh`] if the flight is not one of this model.
    ///
    /// ```
    /// use bouncelab::flight::FlightModel;
    ///
    /// let model = FlightModel::drag_free(10.0)?;
    /// let slopes = model.launch_derivatives(&model.launch(2.0)?)?;
    /// assert!((slopes.time - 2.0 / 10.0).abs() < 1e-12); // T = 2 v/g
    /// assert!((slopes.apex - 2.0 / 10.0).abs() < 1e-12); // h = v²/2g
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn launch_derivatives(&self, flight: &Flight) -> Result<LaunchDerivatives> {
        Ok(LaunchDerivatives::of(
            flight,
            self.gravity_m_s2(),
            self.drag_over_weight(flight.launch_speed_m_s)?,
            self.drag_over_weight(flight.impact_speed_m_s)?,
        ))
    }

    /// Drag over (buoyant) weight at a speed: the paper's β v² and η(v).
    ///
    /// # Errors
    /// [`Error::ReynoldsTooHigh`] above the range of the drag law.
    ///
    /// ```
    /// use bouncelab::flight::FlightModel;
    ///
    /// let model = FlightModel::with_terminal_speed(9.81, 9.385)?;
    /// assert!((model.drag_over_weight(9.385)? - 1.0).abs() < 1e-12);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn drag_over_weight(&self, speed_m_s: f64) -> Result<f64> {
        within(Quantity::Speed, speed_m_s, 0.0..)?;
        match &self.resistance {
            Resistance::Quadratic(drag) => Ok(drag.over_weight(speed_m_s)),
            Resistance::Reynolds(drag) => {
                drag.check_speed(speed_m_s)?;
                Ok(drag.over_weight(speed_m_s))
            }
        }
    }

    /// The gravity that the ball obeys, m/s²: less than the gravity of the environment by
    /// (1 - r)/(1 + r/2), r = ρV/m, with buoyancy and added mass.
    pub fn gravity_m_s2(&self) -> f64 {
        match &self.resistance {
            Resistance::Quadratic(drag) => drag.gravity(),
            Resistance::Reynolds(drag) => drag.gravity(),
        }
    }

    /// The speed at which drag balances weight, m/s; `None` without drag, or if the drag law ends
    /// before it.
    ///
    /// ```
    /// use bouncelab::flight::FlightModel;
    ///
    /// assert_eq!(FlightModel::drag_free(9.81)?.terminal_speed_m_s(), None);
    /// assert!(FlightModel::with_terminal_speed(9.81, 9.385)?.terminal_speed_m_s().is_some());
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn terminal_speed_m_s(&self) -> Option<f64> {
        match &self.resistance {
            Resistance::Quadratic(drag) => drag.terminal_speed(),
            Resistance::Reynolds(drag) => drag.terminal_speed(),
        }
    }

    /// Mass of the ball and of the air it drags along, kg; `None` if the model was made without a
    /// ball. Energies of a drop are given per kilogram of it.
    pub fn moving_mass_kg(&self) -> Option<f64> {
        self.moving_mass_kg
    }
}
