//! The motion of a drop from release to rest.
//!
//! ```
//! use bouncelab::drop::{self, Start, Stop};
//! use bouncelab::flight::FlightModel;
//! use bouncelab::restitution::{Contact, Restitution};
//!
//! // The paper's Fig. 8: constant drag coefficient, e = 0.935, from 30.5 cm.
//! let model = FlightModel::with_terminal_speed(9.81, 9.385)?;
//! let contact = Contact::instantaneous(Restitution::constant(0.935)?);
//! let history = drop::simulate(&model, &contact, Start::Height(0.305), Stop::below(1e-9))?;
//!
//! assert_eq!(format!("{:.2}", history.total_time_s()), "6.45");
//! assert_eq!(format!("{:.2}", history.total_path_m()), "3.68");
//! assert_eq!(history.impact_events().count(), history.bounces().len() + 1);
//! # Ok::<(), bouncelab::Error>(())
//! ```

use crate::error::{Error, Quantity, Result, of_a_size, positive, within};
use crate::flight::{Fall, Flight, FlightModel, State};
use crate::impact::ImpactEvent;
use crate::restitution::Contact;

/// Maximum number of bounces of a history.
pub const MAX_BOUNCES: usize = 100_000;

/// How a drop begins, at time zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Start {
    /// Released from rest at a height in m.
    Height(f64),
    /// Launched upwards off the surface at a speed in m/s.
    Launch(f64),
}

/// When a drop counts as over.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stop {
    apex_m: f64,
    bounces: usize,
}

impl Stop {
    /// At the first impact after which the ball would rise no higher than this (m, not below zero).
    ///
    /// ```
    /// use bouncelab::drop::{self, Start, Stop};
    /// use bouncelab::flight::FlightModel;
    /// use bouncelab::restitution::{Contact, Restitution};
    ///
    /// let contact = Contact::instantaneous(Restitution::constant(0.5)?);
    /// let model = FlightModel::drag_free(10.0)?;
    /// // Bounces of 20 cm, 5 cm, 1.25 cm ...
    /// let history = drop::simulate(&model, &contact, Start::Height(0.8), Stop::below(0.02))?;
    /// assert_eq!(history.bounces().len(), 2);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub const fn below(apex_m: f64) -> Self {
        Self {
            apex_m,
            bounces: usize::MAX,
        }
    }

    /// After a number of bounces: impacts that are followed by a flight.
    ///
    /// ```
    /// use bouncelab::drop::{self, Start, Stop};
    /// use bouncelab::flight::FlightModel;
    /// use bouncelab::restitution::{Contact, Restitution};
    ///
    /// let contact = Contact::instantaneous(Restitution::constant(0.5)?);
    /// let model = FlightModel::drag_free(10.0)?;
    /// let history = drop::simulate(&model, &contact, Start::Launch(2.0), Stop::after(3))?;
    /// assert_eq!(history.bounces().len(), 3);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub const fn after(bounces: usize) -> Self {
        Self {
            apex_m: 0.0,
            bounces,
        }
    }

    /// By the given limits: when the ball rises no higher than this (m), after this number of bounces, or whichever comes
    /// first; without either, when it rises no higher than a millimetre.
    ///
    /// ```
    /// use bouncelab::drop::Stop;
    ///
    /// assert_eq!(Stop::asked(None, None), Stop::below(1e-3));
    /// assert_eq!(Stop::asked(None, Some(5)), Stop::after(5));
    /// assert_eq!(Stop::asked(Some(0.01), Some(5)), Stop::below(0.01).or_after(5));
    /// ```
    pub fn asked(apex_m: Option<f64>, bounces: Option<usize>) -> Self {
        /// The height of bounce at which a drop counts as over.
        const REST_M: f64 = 1e-3;
        match (apex_m, bounces) {
            (None, None) => Self::below(REST_M),
            (Some(apex_m), None) => Self::below(apex_m),
            (None, Some(bounces)) => Self::after(bounces),
            (Some(apex_m), Some(bounces)) => Self::below(apex_m).or_after(bounces),
        }
    }

    /// The same, but after a number of bounces at the latest.
    ///
    /// ```
    /// use bouncelab::drop::Stop;
    ///
    /// // Down to bounces of a millimetre, but a hundred at most.
    /// let stop = Stop::below(1e-3).or_after(100);
    /// # let _ = stop;
    /// ```
    #[must_use]
    pub const fn or_after(self, bounces: usize) -> Self {
        Self { bounces, ..self }
    }
}

/// The motion to the first impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum InitialFall {
    /// A fall from rest.
    Fall(Fall),
    /// A flight off the surface.
    Flight(Flight),
}

impl InitialFall {
    fn time_s(&self) -> f64 {
        match self {
            Self::Fall(fall) => fall.time_s,
            Self::Flight(flight) => flight.time_s(),
        }
    }

    fn impact_speed_m_s(&self) -> f64 {
        match self {
            Self::Fall(fall) => fall.impact_speed_m_s,
            Self::Flight(flight) => flight.impact_speed_m_s,
        }
    }

    fn path_m(&self) -> f64 {
        match self {
            Self::Fall(fall) => fall.height_m,
            Self::Flight(flight) => 2.0 * flight.apex_m,
        }
    }
}

/// An impact and the flight after it.
///
/// Energies are per kilogram of [`FlightModel::moving_mass_kg`]: multiply to get joules.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Bounce {
    /// When the ball touches the surface, s after the start. It leaves a contact time later.
    pub time_s: f64,
    /// Speed just before the impact, m/s.
    pub impact_speed_m_s: f64,
    /// Coefficient of restitution of the impact.
    pub restitution: f64,
    /// The flight after the impact.
    pub flight: Flight,
    /// Energy that the impact takes, J/kg.
    pub lost_to_surface_j_kg: f64,
    /// Energy that the air takes in the flight, J/kg.
    pub lost_to_air_j_kg: f64,
}

/// A drop from its start to the impact with which it ends.
///
/// The history is an opening, then bounces, each an impact with the flight after it, and at last a
/// landing: the impact after which the ball counts as at rest.
#[derive(Debug, Clone, PartialEq)]
pub struct History {
    model: FlightModel,
    contact_time_s: f64,
    opening: InitialFall,
    bounces: Vec<Bounce>,
    landing: ImpactEvent,
}

/// Simulates a drop.
///
/// # Errors
/// [`Error::OutOfRange`] for a start or stop outside its range, [`Error::ReynoldsTooHigh`] if the
/// ball exceeds the range of the drag law, [`Error::EndlessDrop`] if the drop is not over after
/// [`MAX_BOUNCES`].
///
/// ```
/// use bouncelab::drop::{self, Start, Stop};
/// use bouncelab::flight::FlightModel;
/// use bouncelab::restitution::{Contact, Restitution};
///
/// let contact = Contact::instantaneous(Restitution::constant(0.5)?);
/// let model = FlightModel::drag_free(10.0)?;
/// let history = drop::simulate(&model, &contact, Start::Height(0.8), Stop::after(2))?;
/// // Falls for 0.4 s, then flies for 0.4 s and for 0.2 s.
/// assert!((history.total_time_s() - 1.0).abs() < 1e-12);
/// # Ok::<(), bouncelab::Error>(())
/// ```
pub fn simulate(
    model: &FlightModel,
    contact: &Contact,
    start: Start,
    stop: Stop,
) -> Result<History> {
    let by_law = |_, speed_m_s| contact.restitution().at(speed_m_s);
    simulate_each(model, contact.contact_time_s(), by_law, start, stop)
}

/// Simulates a drop whose impacts each have a restitution of their own, such as one that scatters: `restitution` gives it by
/// the index of the impact, from 0, and its speed in m/s. The contact takes a time in s.
///
/// # Errors
/// Those of [`simulate`].
///
/// ```
/// use bouncelab::drop::{self, Start, Stop};
/// use bouncelab::flight::FlightModel;
///
/// let model = FlightModel::drag_free(10.0)?;
/// let each = [0.5, 0.25];
/// let start = Start::Height(0.8);
/// let history = drop::simulate_each(&model, 0.0, |impact, _| each[impact], start, Stop::after(2))?;
/// // Falls for 0.4 s, then flies for 0.4 s and for 0.1 s.
/// assert!((history.total_time_s() - 0.9).abs() < 1e-12);
/// # Ok::<(), bouncelab::Error>(())
/// ```
pub fn simulate_each(
    model: &FlightModel,
    contact_time_s: f64,
    mut restitution: impl FnMut(usize, f64) -> f64,
    start: Start,
    stop: Stop,
) -> Result<History> {
    within(Quantity::StopHeight, stop.apex_m, 0.0..)?;
    let opening = match start {
        Start::Height(height_m) => {
            InitialFall::Fall(model.fall(of_a_size(Quantity::Height, height_m)?)?)
        }
        Start::Launch(speed_m_s) => {
            InitialFall::Flight(model.launch(of_a_size(Quantity::LaunchSpeed, speed_m_s)?)?)
        }
    };
    let mut landing = ImpactEvent {
        time_s: opening.time_s(),
        speed_m_s: opening.impact_speed_m_s(),
    };
    let mut bounces = Vec::with_capacity(stop.bounces.min(64));
    while bounces.len() < stop.bounces {
        let kept = restitution(bounces.len(), landing.speed_m_s);
        let bounce = bounce(model, kept, landing)?;
        if bounce.flight.apex_m <= stop.apex_m {
            break;
        }
        if bounces.len() == MAX_BOUNCES {
            let apex_m = bounce.flight.apex_m;
            return Err(Error::EndlessDrop {
                bounces: MAX_BOUNCES,
                apex_m,
            });
        }
        landing = ImpactEvent {
            time_s: bounce.time_s + contact_time_s + bounce.flight.time_s(),
            speed_m_s: bounce.flight.impact_speed_m_s,
        };
        bounces.push(bounce);
    }
    Ok(History {
        model: model.clone(),
        contact_time_s,
        opening,
        bounces,
        landing,
    })
}

fn bounce(model: &FlightModel, restitution: f64, event: ImpactEvent) -> Result<Bounce> {
    let flight = model.launch(restitution * event.speed_m_s)?;
    let launch_energy = kinetic_j_kg(flight.launch_speed_m_s);
    Ok(Bounce {
        time_s: event.time_s,
        impact_speed_m_s: event.speed_m_s,
        restitution,
        flight,
        lost_to_surface_j_kg: kinetic_j_kg(event.speed_m_s) - launch_energy,
        lost_to_air_j_kg: launch_energy - kinetic_j_kg(flight.impact_speed_m_s),
    })
}

fn kinetic_j_kg(speed_m_s: f64) -> f64 {
    0.5 * speed_m_s * speed_m_s
}

impl History {
    /// The motion to the first impact.
    pub fn opening(&self) -> InitialFall {
        self.opening
    }

    /// The impacts that are followed by a flight, in order; the first is bounce 1 of the paper.
    pub fn bounces(&self) -> &[Bounce] {
        &self.bounces
    }

    /// The impact with which the history ends.
    pub fn landing(&self) -> ImpactEvent {
        self.landing
    }

    /// All impacts in order, the landing included.
    ///
    /// ```
    /// use bouncelab::{demo, synth};
    ///
    /// // What the synthesiser takes.
    /// let history = demo::history()?;
    /// let events: Vec<_> = history.impact_events().collect();
    /// let sound = synth::render(&events, &synth::Scene::default(), 1)?;
    /// assert_eq!(sound.impacts.len(), events.len());
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn impact_events(&self) -> impl Iterator<Item = ImpactEvent> + '_ {
        self.bounces
            .iter()
            .map(|bounce| ImpactEvent {
                time_s: bounce.time_s,
                speed_m_s: bounce.impact_speed_m_s,
            })
            .chain([self.landing])
    }

    /// Time from the start to the landing, s.
    pub fn total_time_s(&self) -> f64 {
        self.landing.time_s
    }

    /// Length of the way from the start to the landing, m.
    ///
    /// ```
    /// use bouncelab::drop::{self, Start, Stop};
    /// use bouncelab::flight::FlightModel;
    /// use bouncelab::restitution::{Contact, Restitution};
    ///
    /// let contact = Contact::instantaneous(Restitution::constant(0.5)?);
    /// let model = FlightModel::drag_free(10.0)?;
    /// let history = drop::simulate(&model, &contact, Start::Height(0.8), Stop::after(2))?;
    /// // Down 80 cm, up and down 20 cm, up and down 5 cm.
    /// assert!((history.total_path_m() - 1.3).abs() < 1e-12);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn total_path_m(&self) -> f64 {
        let flights: f64 = self
            .bounces
            .iter()
            .map(|bounce| 2.0 * bounce.flight.apex_m)
            .sum();
        self.opening.path_m() + flights
    }

    /// Energy at the start, J/kg.
    pub fn initial_energy_j_kg(&self) -> f64 {
        match self.opening {
            InitialFall::Fall(fall) => self.model.gravity_m_s2() * fall.height_m,
            InitialFall::Flight(flight) => kinetic_j_kg(flight.launch_speed_m_s),
        }
    }

    /// Energy that the air takes before the first impact, J/kg.
    pub fn opening_lost_to_air_j_kg(&self) -> f64 {
        let speed_m_s = self.opening.impact_speed_m_s();
        if self.model.drag_over_weight(speed_m_s) == Ok(0.0) {
            // Without drag the difference would be rounding.
            return 0.0;
        }
        (self.initial_energy_j_kg() - kinetic_j_kg(speed_m_s)).max(0.0)
    }

    /// Height of the lowest point of the ball at a time after the start, m.
    ///
    /// The ball stays at zero while it touches the surface and after the landing; before the start
    /// it is where it starts.
    ///
    /// ```
    /// let history = bouncelab::demo::history()?;
    /// assert!((history.height_at(0.0) - 0.305).abs() < 1e-12);
    /// assert_eq!(history.height_at(1e9), 0.0);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn height_at(&self, time_s: f64) -> f64 {
        self.state_at(time_s).height_m
    }

    /// Height and velocity at a time after the start, as [`History::height_at`].
    ///
    /// The velocity counts as zero while the ball touches the surface.
    ///
    /// ```
    /// use bouncelab::drop::{self, Start, Stop};
    /// use bouncelab::flight::FlightModel;
    /// use bouncelab::restitution::{Contact, Restitution};
    ///
    /// let contact = Contact::instantaneous(Restitution::constant(0.5)?);
    /// let model = FlightModel::drag_free(10.0)?;
    /// let history = drop::simulate(&model, &contact, Start::Height(0.8), Stop::after(2))?;
    /// let at_the_top = history.state_at(0.6);
    /// assert!((at_the_top.height_m - 0.2).abs() < 1e-12 && at_the_top.velocity_m_s.abs() < 1e-12);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn state_at(&self, time_s: f64) -> State {
        const AT_REST: State = State {
            height_m: 0.0,
            velocity_m_s: 0.0,
        };
        if time_s >= self.landing.time_s {
            return AT_REST;
        }
        let started = self
            .bounces
            .partition_point(|bounce| bounce.time_s <= time_s);
        let Some(bounce) = started.checked_sub(1).map(|last| &self.bounces[last]) else {
            return match &self.opening {
                InitialFall::Fall(fall) => self.model.fall_state(fall, time_s),
                InitialFall::Flight(flight) => self.model.state(flight, time_s),
            };
        };
        let since_launch = time_s - bounce.time_s - self.contact_time_s;
        if since_launch < 0.0 {
            AT_REST
        } else {
            self.model.state(&bounce.flight, since_launch)
        }
    }
}

/// Total time from release to rest without drag, s (paper Eq. 7).
///
/// # Errors
/// [`Error::OutOfRange`] unless 0 <= e < 1, the height is not negative and gravity above zero.
///
/// ```
/// let time_s = bouncelab::drop::total_time_s(0.938, 0.305, 9.81)?;
/// assert_eq!(format!("{time_s:.1} s"), "7.8 s");
/// # Ok::<(), bouncelab::Error>(())
/// ```
pub fn total_time_s(restitution: f64, drop_height_m: f64, gravity_m_s2: f64) -> Result<f64> {
    check_series(restitution, drop_height_m)?;
    let fall_time_s = fall_time_s(drop_height_m, gravity_m_s2)?;
    Ok((1.0 + restitution) / (1.0 - restitution) * fall_time_s)
}

/// Total length of the path from release to rest without drag, m (paper Eq. 8).
///
/// # Errors
/// [`Error::OutOfRange`] unless 0 <= e < 1 and the height is not negative.
///
/// ```
/// // The paper: 4.94 m at e = 0.94.
/// let path_m = bouncelab::drop::total_path_m(0.94, 0.305)?;
/// assert_eq!(format!("{path_m:.2} m"), "4.94 m");
/// # Ok::<(), bouncelab::Error>(())
/// ```
pub fn total_path_m(restitution: f64, drop_height_m: f64) -> Result<f64> {
    check_series(restitution, drop_height_m)?;
    let energy_kept = restitution * restitution;
    Ok((1.0 + energy_kept) / (1.0 - energy_kept) * drop_height_m)
}

/// The restitution that makes a drop without drag last a given time from release to rest: Eq. 7
/// solved for e.
///
/// # Errors
/// [`Error::OutOfRange`] unless height and gravity are above zero and the time is no shorter than
/// the first fall.
///
/// ```
/// use bouncelab::drop;
///
/// let e = drop::restitution_of_total_time(7.5, 0.305, 9.81)?;
/// assert!((drop::total_time_s(e, 0.305, 9.81)? - 7.5).abs() < 1e-12);
/// # Ok::<(), bouncelab::Error>(())
/// ```
pub fn restitution_of_total_time(
    total_time_s: f64,
    drop_height_m: f64,
    gravity_m_s2: f64,
) -> Result<f64> {
    let fall_time_s = fall_time_s(positive(Quantity::Height, drop_height_m)?, gravity_m_s2)?;
    within(Quantity::TotalTime, total_time_s, fall_time_s..)?;
    Ok((total_time_s - fall_time_s) / (total_time_s + fall_time_s))
}

fn check_series(restitution: f64, drop_height_m: f64) -> Result<()> {
    within(Quantity::Restitution, restitution, 0.0..1.0)?;
    within(Quantity::Height, drop_height_m, 0.0..).map(drop)
}

fn fall_time_s(height_m: f64, gravity_m_s2: f64) -> Result<f64> {
    Ok((2.0 * height_m / positive(Quantity::Gravity, gravity_m_s2)?).sqrt())
}
