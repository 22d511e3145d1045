//! The rebound of one drop: by the procedure of the rule, by g T²/8, and by the model.

use super::rule::Rule;
use crate::analysis::{Drop, Options};
use crate::diagnostic::{Code, Diagnostic};
use crate::estimate::Estimate;
use crate::regression::height_of_flight_m;

/// The rebound of one drop. Heights are those of the point at which the rule measures.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Rebound {
    /// Which place it is of, counted from 0.
    pub place: usize,
    /// Time between its first and second impact, s, if both were detected.
    pub first_flight_s: Option<f64>,
    /// That flight as g T²/8.
    pub drag_free_m: Option<f64>,
    /// That flight by the procedure of the rule: by its formula, or the height that the ball reached.
    pub height_m: Option<f64>,
    /// Standard uncertainty of this height from the times of the two impacts, m.
    pub times_sd_m: f64,
    /// The rebound that the model predicts at the height of the rule, from all impacts; `None` without an inference.
    pub predicted_m: Option<Estimate>,
    /// What the height differs by from g T²/8 where the rule has no formula: contact, buoyancy, drag, m.
    pub(super) corrections_m: [f64; 3],
    /// Why the drop cannot tell: its times contradict the height, or its first impact is doubtful.
    pub(super) doubts: Vec<Diagnostic>,
}

impl Rebound {
    /// The rebound of a drop that was analysed with these settings, of the first place.
    pub fn new(drop: &Drop, rule: &Rule, settings: &Options) -> Self {
        let fall_m = rule.fall_of(settings);
        let above_m = rule.point().above_bottom_m(settings.ball.diameter_m());
        let predicted = match (&drop.posterior, fall_m) {
            (Ok(found), Some(fall_m)) => found.rebounds_m(fall_m),
            _ => Vec::new(),
        };
        let first_flight_s = first_flight_s(drop);
        let measured = first_flight_s.and_then(|time_s| measured(time_s, rule, settings));
        let plain = |time_s| height_of_flight_m(time_s, settings.environment.gravity_m_s2);
        let (height_m, slope_m_s, corrections_m) = measured.unwrap_or_default();
        Self {
            place: 0,
            first_flight_s,
            drag_free_m: first_flight_s.map(|time_s| plain(time_s) + above_m),
            height_m: measured.map(|_| height_m + above_m),
            times_sd_m: slope_m_s * first_flight_sd_s(drop),
            predicted_m: Estimate::of_draws(predicted.into_iter().map(|height| height + above_m)),
            corrections_m,
            doubts: doubts(drop),
        }
    }
}

fn doubts(drop: &Drop) -> Vec<Diagnostic> {
    let known = drop.posterior.iter().flat_map(|found| &found.diagnostics);
    let doubtful = |known: &&Diagnostic| {
        matches!(
            known.code,
            Code::HeightContradictsTimes | Code::FirstImpactDoubtful
        )
    };
    known.filter(doubtful).cloned().collect()
}

/// The first flight, if the impacts at both ends were detected and nothing says that others came before.
fn first_flight_s(drop: &Drop) -> Option<f64> {
    let found = drop.posterior.as_ref().ok();
    let missed = found.and_then(|found| found.missed_first_impacts.as_ref());
    if missed.is_some_and(|probabilities| probabilities[0] < 0.5) {
        return None;
    }
    Some(drop.flight(1)?.flight_time_s)
}

/// Standard uncertainty of the first flight time, s: of each impact as detected, else as inferred from all of them.
fn first_flight_sd_s(drop: &Drop) -> f64 {
    let inferred = drop
        .posterior
        .as_ref()
        .map_or(0.0, |found| found.timing_s.value);
    let ends = drop.impacts.iter().filter(|impact| impact.number <= 2);
    let squares = ends.map(|impact| impact.time_sd_s.unwrap_or(inferred).powi(2));
    squares.sum::<f64>().sqrt()
}

/// The height of the lowest point of the ball in a flight of this time, m, how it grows with the time, m/s, and what it
/// differs by from g T²/8.
fn measured(time_s: f64, rule: &Rule, settings: &Options) -> Option<(f64, f64, [f64; 3])> {
    if let Some(formula) = &rule.formula {
        let slope_m_s = 2.0 * formula.factor_m_s2 * (time_s - formula.offset_s);
        return Some((formula.rebound_m(time_s), slope_m_s, [0.0; 3]));
    }
    let model = settings.model().ok()?;
    let air_s = time_s - settings.contact_time_s;
    let stations = [
        height_of_flight_m(time_s, settings.environment.gravity_m_s2),
        height_of_flight_m(air_s, settings.environment.gravity_m_s2),
        height_of_flight_m(air_s, model.gravity_m_s2()),
        model.from_flight_time(air_s).ok()?.apex_m,
    ];
    let corrections_m = std::array::from_fn(|step| stations[step + 1] - stations[step]);
    Some((stations[3], 2.0 * stations[3] / air_s, corrections_m))
}
