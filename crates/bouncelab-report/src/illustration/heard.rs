//! The figures of what was heard.

use bouncelab::analysis::{CONFIDENT_PROBABILITY, Drop, Options};
use bouncelab::detection;
use bouncelab::inference::Impact;
use bouncelab::regression::Regression;

use super::inferred;
use crate::error::Result;
use crate::figure::{
    self, BounceHeight, BounceLoss, Curve, Envelope, Figure, Line, Mark, Restitution, TimedFlight,
};
use crate::theme::Meaning;

/// Points along each flight of a drawn curve.
const POINTS: usize = 24;

/// The sound and the impacts of every drop in it.
///
/// # Errors
///
/// [`Error::Envelope`](crate::Error::Envelope) if the sound is longer than thirty years.
pub fn waveform(sound: &detection::Envelope, drops: &[Drop]) -> Result<Figure> {
    let envelope = envelope(sound)?;
    let marks: Vec<Mark> = drops
        .iter()
        .zip(1..)
        .flat_map(|(found, drop)| {
            found.impacts.iter().map(move |impact| Mark {
                time_s: impact.time_s,
                sure: impact.probability >= CONFIDENT_PROBABILITY,
                drop,
            })
        })
        .collect();
    Ok(figure::waveform(&envelope, &marks))
}

/// The loudness of a sound, to be drawn.
pub(crate) fn envelope(sound: &detection::Envelope) -> Result<Envelope> {
    let (least, greatest) = (sound.least().to_vec(), sound.greatest().to_vec());
    Envelope::new(0.0, sound.step_s(), least, greatest)
}

/// A straight line, to be drawn.
pub(crate) fn line(fit: &Regression) -> Line {
    Line {
        slope: fit.slope().value,
        intercept: fit.intercept().value,
    }
}

/// The flight times and the straight line through their logarithms.
pub fn flight_times(drop: &Drop) -> Figure {
    let flights: Vec<TimedFlight> = drop
        .flights
        .iter()
        .map(|flight| TimedFlight {
            number: flight.number as u32,
            time_s: flight.time_s,
            standard_error_s: None,
            used: flight.in_line,
        })
        .collect();
    let line = drop.line.as_ref().ok().map(line);
    figure::flight_times(&flights, line)
}

/// The restitution of each impact, with the fitted law if there is an inference.
pub fn restitution(drop: &Drop) -> Figure {
    let is_odd = |number: usize| {
        let found = drop.estimate.as_ref().ok();
        let impact = found.and_then(|found| found.impact(number));
        impact.is_some_and(Impact::is_odd)
    };
    let impacts = drop
        .corrected
        .as_ref()
        .map_or(&[][..], |found| &found.impacts);
    let raw: Vec<Restitution> = impacts
        .iter()
        .map(|impact| Restitution {
            speed_m_s: impact.impact_speed_m_s,
            value: impact.raw_ratio,
            standard_error: None,
            odd: false,
        })
        .collect();
    let corrected: Vec<Restitution> = impacts
        .iter()
        .map(|impact| Restitution {
            speed_m_s: impact.impact_speed_m_s,
            value: impact.restitution.value,
            standard_error: impact.restitution.standard_error,
            odd: is_odd(impact.number),
        })
        .collect();
    let line = drop.line.as_ref().ok().map(|fit| fit.restitution().value);
    let band = drop
        .estimate
        .as_ref()
        .map_or_else(|_| Vec::new(), inferred::band);
    figure::restitution(&raw, &corrected, &band, line)
}

/// The height of the ball by the flight model, from impact to impact.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Flown {
    /// Time in s and height in m; a height that is not a number parts flights between which an
    /// impact was missed.
    pub points: Vec<(f64, f64)>,
    /// Time in s and height in m of each apex.
    pub apexes: Vec<(f64, f64)>,
}

/// The height of each flight by the flight model; nothing if the impacts allow none.
pub fn flown(drop: &Drop, settings: &Options) -> Flown {
    let mut flown = Flown::default();
    let (Ok(found), Ok(model)) = (&drop.corrected, settings.model()) else {
        return flown;
    };
    let mut last = None;
    for timed in &found.flights {
        let mut impacts = drop.impacts.iter();
        let Some(impact) = impacts.find(|impact| impact.number == timed.number) else {
            continue;
        };
        let start_s = impact.time_s + settings.contact_time_s;
        if last.is_some_and(|last| last + 1 != timed.number) {
            flown.points.push((start_s, f64::NAN));
        }
        last = Some(timed.number);
        flown.points.extend((0..=POINTS).map(|point| {
            let after_s = timed.flight.time_s() * point as f64 / POINTS as f64;
            let height_m = model.state(&timed.flight, after_s).height_m;
            (start_s + after_s, height_m)
        }));
        let apex_s = start_s + timed.flight.rise_time_s;
        flown.apexes.push((apex_s, timed.flight.apex_m));
    }
    flown
}

/// The height of each flight by the flight model, from impact to impact.
pub fn height(drop: &Drop, settings: &Options) -> Figure {
    height_with(drop, settings, None)
}

/// The same with a simulation of the reader laid over it: time in s, in that of the recording, and
/// height in m.
pub fn height_with(drop: &Drop, settings: &Options, simulation: Option<Vec<(f64, f64)>>) -> Figure {
    let Flown { points, apexes } = flown(drop, settings);
    let curve = |name: String, points| Curve {
        name,
        meaning: Meaning::Drag,
        points,
    };
    let name = format!("flight model, drag {}", settings.environment.drag);
    let simulation = simulation.map(|points| curve("your simulation".to_owned(), points));
    let curves: Vec<Curve> = std::iter::once(curve(name, points))
        .chain(simulation)
        .collect();
    figure::height(&curves, &apexes)
}

/// The height of each bounce: with the air taken into account where that can be done, else as if there
/// were none.
pub fn bounce_heights(drop: &Drop) -> Figure {
    let bounces: Vec<BounceHeight> = drop
        .flights
        .iter()
        .map(|flight| {
            let found = drop.modelled_flight(flight.number);
            BounceHeight {
                number: flight.number as u32,
                height_m: found.map_or(flight.plain_height_m, |found| found.flight.apex_m),
                standard_error_m: found.and_then(|found| found.apex_standard_error_m),
            }
        })
        .collect();
    figure::bounce_heights(&bounces)
}

/// What became of the energy at an impact and in the flight after it, in joules.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BounceEnergy {
    /// Number of the impact.
    pub number: u32,
    /// Kinetic energy just before it.
    pub before_j: f64,
    /// What the surface took.
    pub lost_to_surface_j: f64,
    /// What the air took in the flight after it.
    pub lost_to_air_j: f64,
}

/// The energies of each impact with a flight on both sides; none if the impacts allow none.
pub fn energies(drop: &Drop, settings: &Options) -> Vec<BounceEnergy> {
    let (Ok(found), Ok(model)) = (&drop.corrected, settings.model()) else {
        return Vec::new();
    };
    let mass_kg = model.moving_mass_kg().unwrap_or(settings.ball.mass_kg());
    let kinetic_j = |speed_m_s: f64| 0.5 * mass_kg * speed_m_s * speed_m_s;
    found
        .impacts
        .iter()
        .filter_map(|impact| {
            let after = drop.modelled_flight(impact.number)?.flight;
            let before_j = kinetic_j(impact.impact_speed_m_s);
            let launched_j = kinetic_j(after.launch_speed_m_s);
            Some(BounceEnergy {
                number: impact.number as u32,
                before_j,
                lost_to_surface_j: before_j - launched_j,
                lost_to_air_j: launched_j - kinetic_j(after.impact_speed_m_s),
            })
        })
        .collect()
}

/// What each bounce loses to the surface and to the air.
pub fn bounce_energies(drop: &Drop, settings: &Options) -> Figure {
    let losses: Vec<BounceLoss> = energies(drop, settings)
        .into_iter()
        .map(|energy| BounceLoss {
            number: energy.number,
            to_surface_j: energy.lost_to_surface_j,
            to_air_j: energy.lost_to_air_j,
        })
        .collect();
    figure::bounce_energies(&losses)
}
