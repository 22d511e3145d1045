//! Comparison of simulated drops.

use bouncelab::drop::History;

use super::{Curve, height};
use crate::chart::{Axis, Chart, Dashes, Layer, Marker, Panel, Point, Scale, xs, ys};
use crate::messages::Translator;
use crate::theme::Meaning;

/// Points along a curve.
const POINTS: usize = 2000;

/// A simulated drop.
#[derive(Debug, Clone)]
pub struct Run<'a> {
    /// Name, as in the legend.
    pub name: String,
    /// What it is, which decides its colour.
    pub meaning: Meaning,
    /// What happens.
    pub history: &'a History,
}

/// Time in s and height in m of a simulated drop.
pub fn curve_of(history: &History, points: usize) -> Vec<Point> {
    let end_s = history.total_time_s();
    let times = (0..=points).map(|point| end_s * point as f64 / points as f64);
    times
        .map(|time_s| [time_s, history.height_at(time_s)])
        .collect()
}

/// Height against time, and flight times on a logarithmic axis; the last run is drawn solid, those
/// before it dashed.
pub fn runs(runs: &[Run<'_>], translator: &Translator) -> [Chart; 2] {
    let last = runs.len().saturating_sub(1);
    let curves: Vec<Curve> = runs
        .iter()
        .map(|run| Curve {
            name: run.name.clone(),
            meaning: run.meaning,
            points: curve_of(run.history, POINTS),
        })
        .collect();
    let mut heights = height("runs", &curves, &[], translator);
    let layers = heights
        .panels
        .iter_mut()
        .flat_map(|panel| &mut panel.layers);
    for layer in layers.take(last) {
        *layer = layer.clone().with_width(1.5).with_dashes(Dashes::Dashed);
    }
    let times = runs.iter().enumerate().map(|(index, run)| {
        let flights = (1..).zip(run.history.bounces());
        let points = flights
            .map(|(number, bounce)| [f64::from(number), bounce.flight.time_s()])
            .filter(|[_, time_s]| *time_s > 0.0);
        let marker = if index == last {
            Marker::Dot
        } else {
            Marker::Ring
        };
        Layer::points(run.meaning, marker, points.collect()).named(&*run.name)
    });
    [
        heights,
        flight_times("run-flight-times", times.collect(), translator),
    ]
}

/// Flight times against their number, on a logarithmic axis.
pub(crate) fn flight_times(id: &str, layers: Vec<Layer>, translator: &Translator) -> Chart {
    if ys(&layers).next().is_none() {
        return Chart::empty(translator, id);
    }
    let x = Scale::counting(xs(&layers)).padded(0.03, 0.03);
    let y = Scale::log(ys(&layers)).padded(0.06, 0.06);
    let x = Axis::new(translator.text("axis-flight"), "", x);
    let y = Axis::new(translator.text("axis-flight-time"), "s", y);
    let caption = translator.text(&format!("figure-{id}-caption"));
    Chart::new(
        translator,
        id,
        caption,
        vec![Panel::new(200.0, x, y, layers)],
    )
}
