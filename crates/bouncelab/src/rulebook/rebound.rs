//! The rebound of one drop: by the rule, and by simpler formulas.

use std::fmt;

use super::rule::Rule;
use crate::analysis::{Drop, Options};
use crate::estimate::Estimate;
use crate::regression::height_of_flight_m;

/// The rebound that one drop foretells. Heights are those of the point at which the rule measures.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct Rebound {
    /// Which place it is of, counted from 0.
    pub place: usize,
    /// Predicted at the rule's height, with drag; `None` if the drop does not tell.
    pub predicted_m: Option<Estimate>,
    /// Time between its first and second impact, s, if both were heard.
    pub first_flight_s: Option<f64>,
    /// That flight as g T²/8.
    pub drag_free_m: Option<f64>,
    /// That flight by the rule's own formula.
    pub formula_m: Option<f64>,
    /// What lies between the plain height and the predicted one.
    pub steps: Vec<Step>,
    pub(super) draws: Vec<f64>,
}

/// A reason why two heights differ, and by how much.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Step {
    /// The reason.
    pub why: Correction,
    /// What it adds, m.
    pub height_m: f64,
}

/// Why g T²/8 is not the rebound of the rule.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Correction {
    /// The time between impacts includes a contact.
    Contact,
    /// The air carries the ball and moves with it: effective gravity is weaker.
    Buoyancy,
    /// Drag shortens the flight.
    Drag,
    /// This drop: its own height of release, and the scatter of a single impact.
    ThisDrop,
}

impl fmt::Display for Correction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Contact => "contact time, which is no flight",
            Self::Buoyancy => "buoyancy and added mass of the air",
            Self::Drag => "drag in the flight",
            Self::ThisDrop => "this drop's own height and single impact against the rule's",
        })
    }
}

impl Rebound {
    pub(super) fn new(
        place: usize,
        drop: &Drop,
        rule: &Rule,
        fall_m: Option<f64>,
        settings: &Options,
    ) -> Self {
        let above_m = rule.point().above_bottom_m(settings.ball.diameter_m());
        let draws = match (&drop.posterior, fall_m) {
            (Ok(found), Some(fall_m)) => found.rebounds_m(fall_m),
            _ => Vec::new(),
        };
        let draws: Vec<f64> = draws.into_iter().map(|height| height + above_m).collect();
        let predicted_m = Estimate::of_draws(draws.iter().copied());
        let first_flight_s = first_flight_s(drop);
        let gravity_m_s2 = settings.environment.gravity_m_s2;
        let plain = |time_s| height_of_flight_m(time_s, gravity_m_s2) + above_m;
        let steps = match (first_flight_s, predicted_m) {
            (Some(time_s), Some(predicted)) => {
                steps(time_s, predicted.value - above_m, settings).unwrap_or_default()
            }
            _ => Vec::new(),
        };
        let by_formula = |time_s: f64| Some(rule.formula.as_ref()?.rebound_m(time_s) + above_m);
        Self {
            place,
            predicted_m,
            first_flight_s,
            drag_free_m: first_flight_s.map(plain),
            formula_m: first_flight_s.and_then(by_formula),
            steps,
            draws,
        }
    }
}

/// The first flight, if the impacts at both ends were heard and nothing says that others came before.
fn first_flight_s(drop: &Drop) -> Option<f64> {
    let found = drop.posterior.as_ref().ok();
    let missed = found.and_then(|found| found.missed_first_impacts.as_ref());
    if missed.is_some_and(|probabilities| probabilities[0] < 0.5) {
        return None;
    }
    let first = drop.flights.first().filter(|flight| flight.number == 1)?;
    Some(first.flight_time_s)
}

/// From g T²/8 to the predicted rebound of the lowest point, in steps that add up.
fn steps(time_s: f64, predicted_m: f64, settings: &Options) -> Option<Vec<Step>> {
    let model = settings.model().ok()?;
    let air_s = time_s - settings.contact_time_s;
    let gravity_m_s2 = settings.environment.gravity_m_s2;
    let stations = [
        height_of_flight_m(time_s, gravity_m_s2),
        height_of_flight_m(air_s, gravity_m_s2),
        height_of_flight_m(air_s, model.gravity_m_s2()),
        model.from_flight_time(air_s).ok()?.apex_m,
        predicted_m,
    ];
    let reasons = [
        Correction::Contact,
        Correction::Buoyancy,
        Correction::Drag,
        Correction::ThisDrop,
    ];
    let steps = stations.windows(2).zip(reasons);
    Some(
        steps
            .map(|(ends, why)| Step {
                why,
                height_m: ends[1] - ends[0],
            })
            .collect(),
    )
}
