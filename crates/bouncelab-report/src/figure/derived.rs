//! What figures show besides the results: calculations that are not drawing.

use bouncelab::Result;
use bouncelab::analysis::{self, Drop, Options};
use bouncelab::drag::DragLaw;
use bouncelab::drop::{self, Start, Stop};
use bouncelab::flight::{Environment, FlightModel};
use bouncelab::impact::{Contact, Restitution};
use bouncelab::inference::{InferenceOptions, SamplerConfig};

use super::Curve;
use crate::chart::Point;
use crate::messages::Translator;
use crate::tables::drag_law;
use crate::theme::Meaning;

/// The height of the ball by the flight model, from impact to impact.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct History {
    /// Time in s and height in m; a height that is not a number parts flights between which an
    /// impact was missed.
    pub(super) points: Vec<Point>,
    /// Time in s and height in m of each apex.
    pub(super) apexes: Vec<Point>,
}

/// The height of each flight by the flight model; nothing if the impacts allow none.
pub(super) fn history(drop: &Drop, settings: &Options) -> History {
    /// Points along each flight.
    const POINTS: usize = 24;
    let mut history = History::default();
    let (Ok(found), Ok(model)) = (&drop.per_impact, settings.model()) else {
        return history;
    };
    let mut last = None;
    for timed in &found.flights {
        let mut impacts = drop.impacts.iter();
        let Some(impact) = impacts.find(|impact| impact.number == timed.number) else {
            continue;
        };
        let start_s = impact.time_s + settings.contact_time_s;
        if last.is_some_and(|last| last + 1 != timed.number) {
            history.points.push([start_s, f64::NAN]);
        }
        last = Some(timed.number);
        history.points.extend((0..=POINTS).map(|point| {
            let after_s = timed.flight.time_s() * point as f64 / POINTS as f64;
            let height_m = model.state(&timed.flight, after_s).height_m;
            [start_s + after_s, height_m]
        }));
        let apex_s = start_s + timed.flight.rise_time_s;
        history.apexes.push([apex_s, timed.flight.apex_m]);
    }
    history
}

/// The drop that the answers describe, from its release on, in the time of the recording: time in s
/// and height in m. Nothing without inference.
pub(super) fn best_fit(drop: &Drop, settings: &Options) -> Result<Vec<Point>> {
    /// Points of the whole curve for each bounce.
    const POINTS: usize = 40;
    let Ok(found) = &drop.posterior else {
        return Ok(Vec::new());
    };
    let law = Restitution::power(
        found.restitution.value,
        found.at_speed_m_s,
        found.restitution_slope.value,
    )?;
    let contact = Contact::new(law, settings.contact_time_s)?;
    let bounces = drop.impacts.last().map_or(1, |last| last.number);
    let start = Start::Height(found.drop_height_m.value);
    let missed = found
        .missed_first_impacts
        .as_deref()
        .map_or(0, most_probable);
    let stop = Stop::after(bounces + missed);
    let history = drop::simulate(&settings.model()?, &contact, start, stop)?;
    // The first impact that was heard is at the time at which it was heard.
    let first_heard_s = history.bounces().get(missed).map_or(0.0, |b| b.time_s);
    let shift_s = drop.impacts.first().map_or(0.0, |first| first.time_s) - first_heard_s;
    let end_s = history.total_time_s();
    let points = POINTS * (bounces + missed);
    let points = (0..=points).map(|point| {
        let time_s = end_s * point as f64 / points as f64;
        [time_s + shift_s, history.height_at(time_s)]
    });
    Ok(points.collect())
}

fn most_probable(probabilities: &[f64]) -> usize {
    let numbered = probabilities.iter().enumerate();
    numbered
        .max_by(|a, b| a.1.total_cmp(b.1))
        .map_or(0, |(number, _)| number)
}

/// Drag over weight of the chosen law, and of a constant coefficient that agrees with it at the
/// fastest impact; none without drag.
///
/// # Errors
///
/// If the law does not reach the fastest impact, and the errors of [`FlightModel::new`].
pub(super) fn drag_curves(
    settings: &Options,
    fastest_m_s: f64,
    translator: &Translator,
) -> Result<Vec<Curve>> {
    let model = settings.model()?;
    let share = model.drag_over_weight(fastest_m_s)?;
    let unit = Environment {
        drag: DragLaw::Constant(1.0),
        ..settings.environment
    };
    let unit_share = FlightModel::new(&settings.ball, &unit)?.drag_over_weight(fastest_m_s)?;
    if unit_share <= 0.0 {
        return Ok(Vec::new());
    }
    let law = settings.environment.drag;
    let curve = |model: &FlightModel, law, meaning| {
        drag_curve(model, drag_law(law, translator), meaning, fastest_m_s)
    };
    let mut curves = vec![curve(&model, law, Meaning::Drag)];
    if matches!(law, DragLaw::Constant(_) | DragLaw::None) {
        return Ok(curves);
    }
    let constant = DragLaw::Constant((100.0 * share / unit_share).round() / 100.0);
    let environment = Environment {
        drag: constant,
        ..settings.environment
    };
    let model = FlightModel::new(&settings.ball, &environment)?;
    curves.push(curve(&model, constant, Meaning::Plain));
    Ok(curves)
}

fn drag_curve(model: &FlightModel, name: String, meaning: Meaning, fastest_m_s: f64) -> Curve {
    // From a fiftieth of the fastest impact to half above it, in equal ratios.
    let (from, to) = (0.02 * fastest_m_s, 1.5 * fastest_m_s);
    let points = (0..=200)
        .map(|step| from * (to / from).powf(f64::from(step) / 200.0))
        // Beyond the range of the law the curve ends.
        .map_while(|speed| Some([speed, model.drag_over_weight(speed).ok()?]))
        .collect();
    Curve {
        name,
        meaning,
        points,
    }
}

/// The drop height from the first flights only.
#[derive(Default)]
pub(super) struct Truncated {
    /// By the straight line: number of flights, height and standard error in m.
    pub(super) line: Vec<[f64; 3]>,
    /// By the inference, which runs anew for each number of flights.
    pub(super) inference: Vec<[f64; 3]>,
}

/// So many flights, and all of them; fewer than three choices for a short drop.
pub(super) fn truncations(drop: &Drop) -> Vec<usize> {
    const TRUNCATIONS: [usize; 4] = [6, 10, 20, 40];
    let all = drop.impacts.len().saturating_sub(1);
    let shorter = TRUNCATIONS.into_iter().filter(|&flights| flights < all);
    shorter.chain([all]).collect()
}

/// Fits the first flights only, in the numbers of [`truncations`].
pub(super) fn truncated(drop: &Drop, settings: &Options) -> Truncated {
    /// A figure needs fewer draws than an answer.
    const DRAWS: usize = 600;
    let mut truncated = Truncated::default();
    for flights in truncations(drop) {
        let mut settings = Options {
            flights: Some(1..=drop.impacts[flights].number),
            inference: Some(InferenceOptions {
                sampler: SamplerConfig {
                    draws: DRAWS,
                    seed: 1,
                },
                ..InferenceOptions::default()
            }),
            ..settings.clone()
        };
        // Not to lean on a height that the person stated.
        settings.priors.drop_height_m = None;
        settings.priors.release_s = None;
        let found = analysis::analyze_impacts(drop.impacts[..=flights].to_vec(), &settings);
        if let Ok(fit) = &found.log_linear_fit {
            let height = fit.drop_height_m;
            let error = height.known_sd().unwrap_or(f64::NAN);
            truncated.line.push([flights as f64, height.value, error]);
        }
        if let Ok(found) = &found.posterior {
            let height = &found.drop_height_m;
            truncated
                .inference
                .push([flights as f64, height.value, height.sd]);
        }
    }
    truncated
}
