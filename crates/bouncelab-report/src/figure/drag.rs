//! Air drag relative to weight against speed (paper, Figs. 6 and 7).

use super::{Curve, Figure, curve_key, is_finite, pens};
use crate::canvas::{Anchor, Pen, Style, text_width};
use crate::quantity::{Quantity, Unit};
use crate::scale::Scale;
use crate::shape::Rect;
use crate::sheet::{Axis, Panel, Sheet};
use crate::theme::{self, Meaning};

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

/// Curves of drag divided by weight against speed in m/s, with a line at the fastest speed
/// that the drop reached, if it lies on the axis.
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
    let fastest = fastest_m_s.filter(|v| *v > 0.0 && (x.low()..=x.high()).contains(v));
    let x = Axis::new(x, "speed (m/s)");
    let y = Axis::new(y, "drag / weight");

    let pens = pens(curves);
    let mut sheet = Sheet::new(HEIGHT, TITLE);
    sheet.key(&curve_key(curves, &pens));
    let panel = Panel::fill(&mut sheet, &x, &y, 0.0);
    if let Some(fastest) = fastest {
        draw_fastest(&mut sheet, &panel, fastest);
    }
    for (curve, pen) in curves.iter().zip(pens) {
        panel.curve(&mut sheet.canvas, &curve.points, pen);
    }
    Figure::new(sheet, caption(axes, fastest))
}

/// A vertical line at the fastest speed, with its name beside it at the top, where the curves
/// have not yet come to.
fn draw_fastest(sheet: &mut Sheet, panel: &Panel, fastest_m_s: f64) {
    let Rect {
        left, top, bottom, ..
    } = panel.frame;
    let (x, _) = panel.at((fastest_m_s, 0.0));
    let pen = Pen::solid(Meaning::Measured.colour(), 1.5);
    sheet.canvas.line((x, top), (x, bottom), pen);
    let name = format!("this drop: up to {}", speed(fastest_m_s));
    let fits_before = x - left > text_width(&name, theme::LABEL_SIZE) + 8.0;
    let (place, anchor) = if fits_before {
        (x - 8.0, Anchor::End)
    } else {
        (x + 8.0, Anchor::Start)
    };
    let style = Style::new(theme::LABEL_SIZE, Meaning::Measured.colour(), anchor);
    sheet.canvas.text((place, top + 15.0), name, style);
}

fn speed(speed_m_s: f64) -> Quantity {
    Quantity::rounded(speed_m_s, 2, Unit::Speed)
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
    let reached = fastest_m_s.map_or(String::new(), |fastest| {
        format!("; this drop reached {}", speed(fastest))
    });
    format!("{what}{reached}.")
}
