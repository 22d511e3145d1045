//! Accuracy of the detection against the noise.

use super::{Curve, curve_layers};
use crate::chart::{Axis, Chart, Panel, Scale, xs, ys};
use crate::messages::Translator;

/// What curves of a detector show.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Detection {
    /// F1, from 0 to 1.
    Found,
    /// Median error of the times over that of the Cramér-Rao bound.
    Timing,
    /// Percentage of errors within the stated standard error.
    Stated,
    /// How much later than the loudest impact of a drop others are found, in microseconds, against
    /// how loud they are.
    Late,
}

impl Detection {
    const fn id(self) -> &'static str {
        match self {
            Self::Found => "detection-found",
            Self::Timing => "detection-timing",
            Self::Stated => "detection-stated",
            Self::Late => "detection-late",
        }
    }
}

/// Curves against the signal-to-noise ratio in dB: that of the loudest impact, but for lateness
/// that of the impact itself.
pub fn detection(what: Detection, curves: &[Curve], translator: &Translator) -> Chart {
    let layers = curve_layers(curves);
    if xs(&layers).next().is_none() {
        return Chart::empty(translator, what.id());
    }
    let (unit, scale) = match what {
        Detection::Found => ("", Scale::linear([0.0, 1.0]).padded(0.0, 0.03)),
        Detection::Timing => ("", Scale::linear([0.0, 2.2])),
        Detection::Stated => ("%", Scale::linear([40.0, 100.0])),
        Detection::Late => (
            "µs",
            Scale::linear(ys(&layers).chain([0.0])).padded(0.05, 0.05),
        ),
    };
    let text = |id: &str| translator.text(&format!("figure-{}-{id}", what.id()));
    let x = Axis::new(text("loudness"), "dB", Scale::linear(xs(&layers)));
    let y = Axis::new(text("axis"), unit, scale);
    let panel = Panel::new(215.0, x, y, layers);
    Chart::new(translator, what.id(), text("caption"), vec![panel])
}
