//! How many impacts detectors find, against the noise.

use super::{Curve, Figure, curve_key, is_finite, pens};
use crate::scale::Scale;
use crate::sheet::{Axis, Panel, Sheet};

const TITLE: &str = "Impacts found in noise";
const HEIGHT: f64 = 360.0;

/// Curves of F1, from 0 to 1, against the signal-to-noise ratio of the loudest impact in dB.
pub fn listening(curves: &[Curve]) -> Figure {
    let points = curves.iter().flat_map(|curve| curve.points.iter().copied());
    let ratios: Vec<f64> = points.filter(|p| is_finite(*p)).map(|p| p.0).collect();
    if ratios.is_empty() {
        return Figure::empty(HEIGHT, TITLE, "There are no detectors to compare.");
    }
    let x = Axis::new(Scale::linear(ratios), "loudest impact above the noise (dB)");
    let y = Axis::new(Scale::linear([0.0, 1.0]).padded(0.0, 0.03), "F1");
    let pens = pens(curves);
    let mut sheet = Sheet::new(HEIGHT, TITLE);
    sheet.key(&curve_key(curves, &pens));
    let panel = Panel::fill(&mut sheet, &x, &y, 0.0);
    for (curve, pen) in curves.iter().zip(pens) {
        panel.curve(&mut sheet.canvas, &curve.points, pen);
    }
    Figure::new(
        sheet,
        TITLE,
        "F1 is 1 where every impact as loud as the noise is found and nothing else is.",
    )
}
