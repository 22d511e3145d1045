//! Height against time (paper, Figs. 2 and 8).

use bouncelab::analysis::{HeightHistory, SimulatedHistory};

use super::{Curve, FigureInput, curve_layers};
use crate::chart::{Axis, Chart, Layer, Marker, Panel, Point, Scale, xs, ys};
use crate::messages::Translator;
use crate::quantity::Unit;
use crate::tables::drag_law;
use crate::theme::Meaning;

/// Height against time by the flight model, from impact to impact, with the measured apexes.
pub(super) fn of_drop(input: &FigureInput<'_>, translator: &Translator) -> Chart {
    let HeightHistory { points, apexes, .. } = input.drop.height_history(input.settings);
    let drag = drag_law(&input.settings.environment.drag, translator);
    let name = translator.text_with("figure-height-model", &[("drag", drag.into())]);
    let meaning = Meaning::Drag;
    let curve = Curve {
        name,
        meaning,
        points,
    };
    height("height", &[curve], &apexes, translator)
}

/// Height against time as measured, over the drop that the posterior describes or a simulation of the reader.
pub(super) fn comparison(input: &FigureInput<'_>, translator: &Translator) -> Chart {
    let text = |id: &str| translator.text(&format!("figure-comparison-{id}"));
    let (name, points, band) = if let Some(points) = input.simulation {
        (text("simulation"), points.to_vec(), Vec::new())
    } else {
        let simulated = input.drop.simulated_history(input.settings);
        let SimulatedHistory { points, band, .. } = simulated.unwrap_or_default();
        (text("best-fit"), points, band)
    };
    let measured = input.drop.height_history(input.settings).points;
    let curves = [
        Curve {
            name,
            meaning: Meaning::Drag,
            points,
        },
        Curve {
            name: text("measured"),
            meaning: Meaning::Measured,
            points: measured,
        },
    ];
    let mut chart = with_band("comparison", &curves, &band, &[], translator);
    if let Some(measured) = chart.panels.first_mut().and_then(|p| p.layers.pop()) {
        chart.panels[0].layers.push(measured.with_width(1.25));
    }
    chart
}

/// Curves of height in metres against time in seconds, and measured apexes as dots. The axis is in
/// micrometres to metres, whichever suits.
pub fn height(id: &str, curves: &[Curve], apexes: &[Point], translator: &Translator) -> Chart {
    with_band(id, curves, &[], apexes, translator)
}

/// The same over a band: time in seconds, lower and upper height in metres.
fn with_band(
    id: &str,
    curves: &[Curve],
    band: &[[f64; 3]],
    apexes: &[Point],
    translator: &Translator,
) -> Chart {
    let layers = curve_layers(curves);
    let highest = ys(&layers).chain(apexes.iter().map(|p| p[1]));
    let highest = highest.fold(0.0, f64::max);
    if xs(&layers).next().is_none() && apexes.is_empty() {
        return Chart::empty(translator, id);
    }
    let (metres, unit) = Unit::Length.step_for(highest);
    let scaled = |points: &[Point]| points.iter().map(|[t, h]| [*t, h / metres]).collect();
    let curves: Vec<Curve> = curves
        .iter()
        .map(|curve| Curve {
            points: scaled(&curve.points),
            ..curve.clone()
        })
        .collect();
    let mut layers = curve_layers(&curves);
    if !band.is_empty() {
        let band = band
            .iter()
            .map(|[t, low, high]| [*t, low / metres, high / metres]);
        layers.insert(0, Layer::band(Meaning::Drag, band.collect()).pale(0.3));
    }
    if !apexes.is_empty() {
        let name = translator.text("figure-height-apexes");
        let apexes = Layer::points(Meaning::Measured, Marker::Dot, scaled(apexes));
        layers.push(apexes.named(name));
    }
    let x = Axis::new(
        translator.text("axis-time"),
        "s",
        Scale::linear(xs(&layers)),
    );
    let heights = Scale::linear(ys(&layers).chain([0.0])).padded(0.0, 0.04);
    let y = Axis::new(translator.text("axis-height"), unit, heights);
    let kind = match (id, apexes.is_empty(), curves.len()) {
        ("height", false, _) => "-apexes",
        ("height", true, 2..) => "-models",
        _ => "",
    };
    let caption = translator.text(&format!("figure-{id}-caption{kind}"));
    Chart::new(
        translator,
        id,
        caption,
        vec![Panel::new(235.0, x, y, layers)],
    )
}
