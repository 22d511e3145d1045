//! Simulated drops as data for other programs: the schema `bouncelab.simulation/2`.

use bouncelab::drag::DragLaw;
use bouncelab::drop::{self, History, Start, Stop};
use bouncelab::flight::FlightModel;
use bouncelab::restitution::{Contact, Restitution};
use bouncelab::{Diagnostic, Options};
use serde::Serialize;

use super::SettingsUsed;

/// Name and version of the schema.
pub const SCHEMA: &str = "bouncelab.simulation/2";

/// One simulated drop.
#[derive(Clone, Debug)]
pub struct Run {
    /// Its drag law.
    pub law: DragLaw,
    /// Terminal speed in m/s, if there is drag.
    pub terminal_speed_m_s: Option<f64>,
    /// The mass that moves, in kg: energies of the history are per kilogram of it.
    pub mass_kg: f64,
    /// The drop.
    pub history: History,
}

impl Run {
    /// Simulates a drop under a drag law, all else being as in the options.
    ///
    /// # Errors
    ///
    /// Those of [`Options::model`], [`Contact::new`] and [`drop::simulate`].
    ///
    /// ```
    /// use bouncelab::Options;
    /// use bouncelab::drag::DragLaw;
    /// use bouncelab::drop::{Start, Stop};
    /// use bouncelab::restitution::Restitution;
    /// use bouncelab_report::document::simulation::Run;
    ///
    /// let (bounce, start) = (Restitution::constant(0.9)?, Start::Height(0.3));
    /// let run = Run::simulate(DragLaw::None, &Options::default(), bounce, start, Stop::after(3))?;
    /// assert_eq!(run.history.bounces().len(), 3);
    /// # Ok::<(), bouncelab::Error>(())
    /// ```
    pub fn simulate(
        law: DragLaw,
        options: &Options,
        restitution: Restitution,
        start: Start,
        stop: Stop,
    ) -> bouncelab::Result<Self> {
        let model = options.clone().with_drag(law.clone()).model()?;
        let contact = Contact::new(restitution, options.contact_time_s)?;
        let history = drop::simulate(&model, &contact, start, stop)?;
        Ok(Self::of(law, &model, history))
    }

    /// A drop that was simulated by a model with this drag law.
    pub fn of(law: DragLaw, model: &FlightModel, history: History) -> Self {
        Self {
            law,
            terminal_speed_m_s: model.terminal_speed_m_s(),
            mass_kg: model.moving_mass_kg().unwrap_or(f64::NAN),
            history,
        }
    }

    /// Energy at the start, in J.
    pub fn initial_energy_j(&self) -> f64 {
        self.mass_kg * self.history.initial_energy_j_kg()
    }

    /// Energy that all impacts took, in J.
    pub fn lost_to_surface_j(&self) -> f64 {
        let bounces = self.history.bounces().iter();
        self.mass_kg
            * bounces
                .map(|bounce| bounce.lost_to_surface_j_kg)
                .sum::<f64>()
    }

    /// Energy that the air took, in J.
    pub fn lost_to_air_j(&self) -> f64 {
        let bounces = self.history.bounces().iter();
        let lost = bounces.map(|bounce| bounce.lost_to_air_j_kg).sum::<f64>();
        self.mass_kg * (self.history.opening_lost_to_air_j_kg() + lost)
    }

    /// One row for each bounce.
    pub fn bounces(&self) -> impl Iterator<Item = Bounce> + '_ {
        let bounces = self.history.bounces().iter().zip(1..);
        bounces.map(|(bounce, number)| Bounce {
            drag: self.law.to_string(),
            number,
            time_s: bounce.time_s,
            impact_speed_m_s: bounce.impact_speed_m_s,
            restitution: bounce.restitution,
            launch_speed_m_s: bounce.flight.launch_speed_m_s,
            flight_time_s: bounce.flight.time_s(),
            apex_m: bounce.flight.apex_m,
            lost_to_surface_j: self.mass_kg * bounce.lost_to_surface_j_kg,
            lost_to_air_j: self.mass_kg * bounce.lost_to_air_j_kg,
        })
    }
}

/// Drops of the same ball under several drag laws.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(rename = "SimulationDocument"))]
pub struct Document {
    schema: &'static str,
    /// Version of the program that made it.
    bouncelab: &'static str,
    settings: SettingsUsed,
    simulations: Vec<Simulation>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
struct Simulation {
    drag: String,
    terminal_speed_m_s: Option<f64>,
    total_time_s: f64,
    total_path_m: f64,
    initial_energy_j: f64,
    lost_to_surface_j: f64,
    lost_to_air_j: f64,
    bounces: Vec<Bounce>,
}

/// One bounce: an impact and the flight after it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[non_exhaustive]
pub struct Bounce {
    /// The drag law.
    pub drag: String,
    /// Number of the bounce, 1 for the first.
    pub number: usize,
    /// Time of the impact in s.
    pub time_s: f64,
    /// Speed before it in m/s.
    pub impact_speed_m_s: f64,
    /// Speed after it over speed before.
    pub restitution: f64,
    /// Speed after it in m/s.
    pub launch_speed_m_s: f64,
    /// Time until the next impact in s.
    pub flight_time_s: f64,
    /// Apex of the flight after it in m.
    pub apex_m: f64,
    /// Energy that the surface took, in J.
    pub lost_to_surface_j: f64,
    /// Energy that the air took in the flight after it, in J.
    pub lost_to_air_j: f64,
}

impl Document {
    /// The document of these runs.
    pub fn new(runs: &[Run], settings: &Options, assumptions: &[Diagnostic]) -> Self {
        Self {
            schema: SCHEMA,
            bouncelab: env!("CARGO_PKG_VERSION"),
            settings: SettingsUsed::new(settings, assumptions),
            simulations: runs.iter().map(Simulation::new).collect(),
        }
    }
}

impl Simulation {
    fn new(run: &Run) -> Self {
        Self {
            drag: run.law.to_string(),
            terminal_speed_m_s: run.terminal_speed_m_s,
            total_time_s: run.history.total_time_s(),
            total_path_m: run.history.total_path_m(),
            initial_energy_j: run.initial_energy_j(),
            lost_to_surface_j: run.lost_to_surface_j(),
            lost_to_air_j: run.lost_to_air_j(),
            bounces: run.bounces().collect(),
        }
    }
}
