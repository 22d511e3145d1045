//! Air drag relative to weight against speed (paper, Figs. 6 and 7).

use bouncelab::analysis::Options;

use super::{Curve, curve_layers};
use crate::chart::{Axis, Chart, Layer, Panel, Point, Scale, xs, ys};
use crate::messages::Translator;
use crate::quantity::{Quantity, Unit};
use crate::tables::drag_law;
use crate::theme::Meaning;

/// The axes of a [`drag`] figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DragAxes {
    /// Both linear, from zero (paper, Fig. 6).
    Linear,
    /// Both logarithmic: a constant drag coefficient is a straight line of slope 2 (paper,
    /// Fig. 7).
    Logarithmic,
}

impl DragAxes {
    /// The name of the figure.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Linear => "drag",
            Self::Logarithmic => "drag-log",
        }
    }
}

/// Drag over weight by the law of the settings up to beyond the fastest impact; `None` without drag,
/// or beyond what the law knows.
pub fn drag_of_settings(
    settings: &Options,
    fastest_m_s: f64,
    axes: DragAxes,
    translator: &Translator,
) -> Option<Chart> {
    let curves = settings.drag_curves(fastest_m_s).ok()?.into_iter();
    let curves: Vec<Curve> = curves
        .map(|curve| Curve {
            name: drag_law(&curve.law, translator),
            meaning: if curve.is_chosen {
                Meaning::Drag
            } else {
                Meaning::Plain
            },
            points: curve.points,
        })
        .collect();
    let some = !curves.is_empty();
    some.then(|| drag(&curves, axes, Some(fastest_m_s), translator))
}

/// Curves of drag divided by weight against speed in m/s, with a line at the fastest speed
/// that the drop reached, if it lies on the axis.
pub fn drag(
    curves: &[Curve],
    axes: DragAxes,
    fastest_m_s: Option<f64>,
    translator: &Translator,
) -> Chart {
    let id = axes.name();
    let is_usable = |&[speed, drag]: &Point| {
        axes == DragAxes::Linear || (speed > 0.0 && drag > 0.0) || !drag.is_finite()
    };
    let curves: Vec<Curve> = curves
        .iter()
        .map(|curve| Curve {
            points: curve.points.iter().copied().filter(is_usable).collect(),
            ..curve.clone()
        })
        .collect();
    let mut layers = curve_layers(&curves);
    if xs(&layers).next().is_none() || ys(&layers).next().is_none() {
        return Chart::empty(translator, id);
    }
    let (x, y) = match axes {
        DragAxes::Linear => (
            Scale::linear(xs(&layers).chain([0.0])),
            Scale::linear(ys(&layers).chain([0.0])).padded(0.0, 0.03),
        ),
        DragAxes::Logarithmic => (
            Scale::log(xs(&layers)),
            Scale::log(ys(&layers)).padded(0.03, 0.03),
        ),
    };
    let fastest = fastest_m_s.filter(|v| *v > 0.0 && (x.low()..=x.high()).contains(v));
    let mut arguments = Vec::new();
    if let Some(fastest) = fastest {
        let speed = Quantity::rounded(fastest, 2, Unit::Speed);
        arguments.push(("speed", speed.into()));
        let name = translator.text_with("figure-drag-fastest", &arguments);
        layers.insert(0, Layer::upright(Meaning::Measured, fastest, name));
    }
    let reached = if fastest.is_some() {
        "reached"
    } else {
        "caption"
    };
    let caption = translator.text_with(&format!("figure-{id}-{reached}"), &arguments);
    let x = Axis::new(translator.text("axis-speed"), "m/s", x);
    let y = Axis::new(translator.text("axis-drag"), "", y);
    Chart::new(
        translator,
        id,
        caption,
        vec![Panel::new(255.0, x, y, layers)],
    )
}
