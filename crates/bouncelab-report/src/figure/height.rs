//! Height against time (paper, Figs. 2 and 8).

use super::{Curve, Figure, curve_key, is_finite, pens};
use crate::quantity::Unit;
use crate::scale::Scale;
use crate::sheet::{Axis, KeyEntry, Panel, Sheet, Swatch};
use crate::theme::Meaning;

const TITLE: &str = "Height of the ball";
const HEIGHT: f64 = 380.0;

/// Curves of height in metres against time in seconds, and measured apexes as dots (time in
/// seconds, height in metres). The axis is in micrometres to metres, whichever suits.
pub fn height(curves: &[Curve], apexes: &[(f64, f64)]) -> Figure {
    let points: Vec<(f64, f64)> = curves
        .iter()
        .flat_map(|curve| &curve.points)
        .chain(apexes)
        .copied()
        .filter(|&point| is_finite(point))
        .collect();
    if points.is_empty() {
        return Figure::empty(HEIGHT, TITLE, "There are no heights to show.");
    }
    let highest = points.iter().map(|p| p.1).fold(0.0, f64::max);
    let (metres, unit) = Unit::Length.step_for(highest);
    let x = Axis::new(Scale::linear(points.iter().map(|p| p.0)), "time (s)");
    let heights = points.iter().map(|p| p.1 / metres).chain([0.0]);
    let y = Axis::new(
        Scale::linear(heights).padded(0.0, 0.04),
        format!("height ({unit})"),
    );

    let pens = pens(curves);
    let mut key = curve_key(curves, &pens);
    let colour = Meaning::Measured.colour();
    if !apexes.is_empty() {
        key.push(KeyEntry::new(Swatch::Dot(colour), "measured apexes"));
    }
    let mut sheet = Sheet::new(HEIGHT, TITLE);
    sheet.key(&key);
    let panel = Panel::fill(&mut sheet, &x, &y, 0.0);
    let shown = |&(time, height): &(f64, f64)| (time, height / metres);
    for (curve, pen) in curves.iter().zip(pens) {
        let points: Vec<_> = curve.points.iter().map(shown).collect();
        panel.curve(&mut sheet.canvas, &points, pen);
    }
    for apex in apexes {
        panel.point(&mut sheet.canvas, shown(apex), Swatch::Dot(colour));
    }
    Figure::new(sheet, caption(curves.len(), !apexes.is_empty()))
}

fn caption(curves: usize, apexes: bool) -> String {
    match (curves, apexes) {
        (_, true) => "Each hop is lower and shorter than the one before; dots are the measured tops of the hops.",
        (2.., false) => "The models start alike and part with time, because what a hop loses shortens all that follow.",
        _ => "Each hop is lower and shorter than the one before, so that infinitely many fit into a finite time.",
    }
    .to_owned()
}
