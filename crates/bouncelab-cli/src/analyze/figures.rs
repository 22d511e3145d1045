//! The figures of an analysis.

use std::path::Path;

use bouncelab::analysis::Analysis;
use bouncelab::drag::DragLaw;
use bouncelab::estimate::Impact;
use bouncelab::flight::{Environment, FlightModel};
use bouncelab_report::figure::{
    self, Curve, DragAxes, Envelope, Line, Mark, Restitution, TimedFlight,
};
use bouncelab_report::theme::Meaning;
use bouncelab_report::{Figure, save};

use super::hear::Hearing;
use super::inferred;
use crate::failure::Failure;
use crate::physics::Physics;

/// Points along each flight of a drawn curve.
const POINTS: usize = 24;

/// Writes the figures of a hearing into a folder and names them on stderr.
pub(crate) fn save_figures(
    hearing: &Hearing,
    physics: &Physics,
    folder: &Path,
) -> Result<(), Failure> {
    if hearing.drops.is_empty() && hearing.envelope.is_none() {
        return Ok(());
    }
    let stem = stem(&hearing.name);
    for (name, drawn) in figures(hearing, physics)? {
        let saved = save(&drawn, folder, &format!("{stem}-{name}"))?;
        eprintln!("wrote {} and .png", saved.svg.display());
    }
    Ok(())
}

/// Name and drawing of every figure.
fn figures(hearing: &Hearing, physics: &Physics) -> Result<Vec<(String, Figure)>, Failure> {
    let mut figures = Vec::new();
    if let Some(waveform) = waveform(hearing)? {
        figures.push(("waveform".to_owned(), waveform));
    }
    for (index, drop) in hearing.drops.iter().enumerate() {
        let of_drop = |name: &str| match hearing.drops.len() {
            1 => name.to_owned(),
            _ => format!("drop{}-{name}", index + 1),
        };
        figures.push((of_drop("flight-times"), flight_times(drop)));
        figures.push((of_drop("restitution"), restitution(drop)));
        figures.push((of_drop("height"), height(drop, physics)));
        for (name, drawn) in inferred::figures(drop, &physics.settings) {
            figures.push((of_drop(name), drawn));
        }
    }
    if let Some(fastest_m_s) = fastest_m_s(hearing) {
        let curves = drag_curves(physics, fastest_m_s)?;
        let drawn = figure::drag(&curves, DragAxes::Linear, Some(fastest_m_s));
        figures.push(("drag".to_owned(), drawn));
        let drawn = figure::drag(&curves, DragAxes::Logarithmic, Some(fastest_m_s));
        figures.push(("drag-log".to_owned(), drawn));
    }
    Ok(figures)
}

/// The name of a file without folder and ending, fit for the name of another file.
fn stem(name: &str) -> String {
    let stem = Path::new(name)
        .file_stem()
        .map(|stem| stem.to_string_lossy().into_owned());
    let kept: String = stem
        .unwrap_or_default()
        .chars()
        .map(|c| {
            if c.is_alphanumeric() || matches!(c, '-' | '_') {
                c
            } else {
                '-'
            }
        })
        .collect();
    if kept.is_empty() {
        "drop".to_owned()
    } else {
        kept
    }
}

fn waveform(hearing: &Hearing) -> Result<Option<Figure>, Failure> {
    let Some(heard) = &hearing.envelope else {
        return Ok(None);
    };
    let (least, greatest) = (heard.least().to_vec(), heard.greatest().to_vec());
    let envelope = Envelope::new(0.0, heard.step_s(), least, greatest)?;
    let marks: Vec<Mark> = hearing
        .drops
        .iter()
        .zip(1..)
        .flat_map(|(found, drop)| {
            found.impacts.iter().map(move |impact| Mark {
                time_s: impact.time_s,
                probability: impact.probability,
                drop,
            })
        })
        .collect();
    Ok(Some(figure::waveform(&envelope, &marks)))
}

fn flight_times(drop: &Analysis) -> Figure {
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
    let line = drop.line.as_ref().ok().map(|fit| Line {
        slope: fit.slope().value,
        intercept: fit.intercept().value,
    });
    figure::flight_times(&flights, line)
}

fn restitution(drop: &Analysis) -> Figure {
    let is_odd = |number: usize| {
        let found = drop.estimate.as_ref().ok();
        found.is_some_and(|found| {
            let impact = found.impacts.iter().find(|impact| impact.number == number);
            impact.is_some_and(Impact::is_odd)
        })
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

/// The height of each flight by the flight model, from impact to impact.
fn height(drop: &Analysis, physics: &Physics) -> Figure {
    let mut points = Vec::new();
    let mut apexes = Vec::new();
    if let (Ok(found), Ok(model)) = (&drop.corrected, physics.settings.model()) {
        for timed in &found.flights {
            let impact = drop
                .impacts
                .iter()
                .find(|impact| impact.number == timed.number);
            let Some(impact) = impact else { continue };
            let start_s = impact.time_s + physics.settings.contact_time_s;
            points.extend((0..=POINTS).map(|point| {
                let after_s = timed.flight.time_s() * point as f64 / POINTS as f64;
                (
                    start_s + after_s,
                    model.state(&timed.flight, after_s).height_m,
                )
            }));
            apexes.push((start_s + timed.flight.rise_time_s, timed.flight.apex_m));
        }
    }
    let name = format!("flight model, drag {}", physics.settings.environment.drag);
    figure::height(
        &[Curve {
            name,
            meaning: Meaning::Drag,
            points,
        }],
        &apexes,
    )
}

fn fastest_m_s(hearing: &Hearing) -> Option<f64> {
    let speeds = hearing.drops.iter().filter_map(Analysis::speed_range_m_s);
    speeds.map(|(_, fastest)| fastest).reduce(f64::max)
}

/// Drag over weight of the chosen law, and of a constant coefficient that agrees with it at the
/// fastest impact.
fn drag_curves(physics: &Physics, fastest_m_s: f64) -> Result<Vec<Curve>, Failure> {
    let settings = &physics.settings;
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
    let constant = DragLaw::Constant((100.0 * share / unit_share).round() / 100.0);
    let mut curves = vec![drag_curve(
        &model,
        settings.environment.drag,
        Meaning::Drag,
        fastest_m_s,
    )];
    if matches!(
        settings.environment.drag,
        DragLaw::Constant(_) | DragLaw::None
    ) {
        return Ok(curves);
    }
    let environment = Environment {
        drag: constant,
        ..settings.environment
    };
    let model = FlightModel::new(&settings.ball, &environment)?;
    curves.push(drag_curve(&model, constant, Meaning::NoDrag, fastest_m_s));
    Ok(curves)
}

fn drag_curve(model: &FlightModel, law: DragLaw, meaning: Meaning, fastest_m_s: f64) -> Curve {
    // From a fiftieth of the fastest impact to half above it, in equal ratios.
    let (from, to) = (0.02 * fastest_m_s, 1.5 * fastest_m_s);
    let points = (0..=200)
        .map(|step| from * (to / from).powf(f64::from(step) / 200.0))
        // Beyond the range of the law the curve ends.
        .map_while(|speed| Some((speed, model.drag_over_weight(speed).ok()?)))
        .collect();
    Curve {
        name: law.to_string(),
        meaning,
        points,
    }
}
