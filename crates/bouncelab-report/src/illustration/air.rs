//! The figures of the air: drag over weight at the speeds of a drop.

use bouncelab::Result;
use bouncelab::analysis::Options;
use bouncelab::drag::DragLaw;
use bouncelab::flight::{Environment, FlightModel};

use crate::figure::{self, Curve, DragAxes, Figure};
use crate::theme::Meaning;

/// Drag over weight against speed; `None` without drag, or beyond what the law knows.
pub fn drag(settings: &Options, fastest_m_s: f64) -> Option<Figure> {
    drawn(settings, fastest_m_s, DragAxes::Linear)
}

/// The same on logarithmic axes, where a constant coefficient is a straight line.
pub fn drag_log(settings: &Options, fastest_m_s: f64) -> Option<Figure> {
    drawn(settings, fastest_m_s, DragAxes::Logarithmic)
}

fn drawn(settings: &Options, fastest_m_s: f64, axes: DragAxes) -> Option<Figure> {
    let curves = drag_curves(settings, fastest_m_s).ok()?;
    let shown = !curves.is_empty();
    shown.then(|| figure::drag(&curves, axes, Some(fastest_m_s)))
}

/// Drag over weight of the chosen law, and of a constant coefficient that agrees with it at the
/// fastest impact; none without drag.
///
/// # Errors
///
/// If the law does not reach the fastest impact, and the errors of [`FlightModel::new`].
pub fn drag_curves(settings: &Options, fastest_m_s: f64) -> Result<Vec<Curve>> {
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
    let mut curves = vec![curve(
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
    curves.push(curve(&model, constant, Meaning::NoDrag, fastest_m_s));
    Ok(curves)
}

fn curve(model: &FlightModel, law: DragLaw, meaning: Meaning, fastest_m_s: f64) -> Curve {
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
