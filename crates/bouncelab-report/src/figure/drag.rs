//! Air drag relative to weight against speed (paper, Figs. 6 and 7).

use super::{Curve, Figure, curve_key, is_finite, pens};
use crate::canvas::Rect;
use crate::scale::Scale;
use crate::sheet::{Axis, KeyEntry, Panel, Sheet, Swatch};
use crate::theme::Meaning;

const TITLE: &str = "Air drag relative to weight";
const HEIGHT: f64 = 400.0;

/// The axes of a [`drag`] figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DragAxes {
    /// Both linear, from zero (paper, Fig. 6).
    Linear,
    /// Both logarithmic: a constant drag coefficient is a straight line of slope 2 (paper,
    /// Fig. 7).
    Logarithmic,
}

/// Curves of drag divided by weight against speed in m/s, with the speeds that the drop
/// reached shaded, up to `fastest_m_s`.
pub fn drag(curves: &[Curve], axes: DragAxes, fastest_m_s: Option<f64>) -> Figure {
    let usable = |&(speed, drag): &(f64, f64)| {
        is_finite((speed, drag)) && (axes == DragAxes::Linear || (speed > 0.0 && drag > 0.0))
    };
    let points: Vec<(f64, f64)> = curves
        .iter()
        .flat_map(|curve| curve.points.iter().copied().filter(usable))
        .collect();
    if points.is_empty() {
        return Figure::empty(HEIGHT, TITLE, "There are no drag curves to show.");
    }
    let (speeds, drags) = (points.iter().map(|p| p.0), points.iter().map(|p| p.1));
    let (x, y) = match axes {
        DragAxes::Linear => (
            Scale::linear(speeds.chain([0.0])),
            Scale::linear(drags.chain([0.0])).padded(0.0, 0.03),
        ),
        DragAxes::Logarithmic => (Scale::log(speeds), Scale::log(drags).padded(0.03, 0.03)),
    };
    let fastest = fastest_m_s.filter(|v| v.is_finite() && *v > x.low());
    let x = Axis::new(x, "speed (m/s)");
    let y = Axis::new(y, "drag / weight");

    let pens = pens(curves);
    let mut sheet = Sheet::new(HEIGHT, TITLE);
    let mut key = curve_key(curves, &pens);
    let reached = Meaning::Measured.colour().tint();
    if fastest.is_some() {
        key.push(KeyEntry::new(Swatch::Patch(reached), "speeds of this drop"));
    }
    sheet.key(&key);
    let panel = Panel::fill(&mut sheet, &x, &y, 0.0);
    if let Some(fastest) = fastest {
        let (right, _) = panel.at((fastest, 0.0));
        let patch = Rect {
            right: right.min(panel.frame.right),
            ..panel.frame
        };
        sheet.canvas.rect(patch, reached);
    }
    for (curve, pen) in curves.iter().zip(pens) {
        panel.curve(&mut sheet.canvas, &curve.points, pen);
    }
    Figure::new(sheet, TITLE, caption(axes, fastest))
}

fn caption(axes: DragAxes, fastest_m_s: Option<f64>) -> String {
    let what = match axes {
        DragAxes::Linear => {
            "Drag grows nearly with the square of the speed and balances the weight at the terminal speed, where the curve reaches 1"
        }
        DragAxes::Logarithmic => {
            "A constant drag coefficient is a straight line here; the laws part at low speed, where drag is too weak to matter"
        }
    };
    let reached = fastest_m_s.map_or(String::new(), |speed| {
        format!("; this drop reached {speed:.1} m/s (shaded)")
    });
    format!("{what}{reached}.")
}
