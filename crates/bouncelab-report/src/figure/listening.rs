//! How well a listener hears, against the noise.

use super::{Curve, Figure, curve_key, is_finite, pens};
use crate::scale::Scale;
use crate::sheet::{Axis, Panel, Sheet};

const HEIGHT: f64 = 360.0;

/// What curves of a listener show.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hearing {
    /// F1, from 0 to 1.
    Found,
    /// Median error of the times over that of the Cramér-Rao bound.
    Timing,
    /// Percentage of errors within the stated standard error.
    SetupInput,
    /// How much later than the loudest impact of a drop others are found, in microseconds, against
    /// how loud they are.
    Late,
}

impl Hearing {
    fn title(self) -> &'static str {
        match self {
            Self::Found => "Impacts found in noise",
            Self::Timing => "Errors of flight times and the physical limit",
            Self::SetupInput => "Errors of flight times and what is stated of them",
            Self::Late => "Faint impacts are found no later than loud ones",
        }
    }

    fn loudness(self) -> &'static str {
        match self {
            Self::Late => "impact above the noise (dB)",
            Self::Found | Self::Timing | Self::SetupInput => "loudest impact above the noise (dB)",
        }
    }

    fn axis(self, values: impl Iterator<Item = f64>) -> Axis {
        match self {
            Self::Found => Axis::new(Scale::linear([0.0, 1.0]).padded(0.0, 0.03), "F1"),
            Self::Timing => Axis::new(
                Scale::linear([0.0, 2.2]),
                "median error over that of the bound",
            ),
            Self::SetupInput => Axis::new(
                Scale::linear([40.0, 100.0]),
                "within one standard error (%)",
            ),
            Self::Late => Axis::new(
                Scale::linear(values.chain([0.0])).padded(0.05, 0.05),
                "later than the loudest (µs)",
            ),
        }
    }

    fn caption(self) -> &'static str {
        match self {
            Self::Found => {
                "F1 is 1 where every impact as loud as the noise is found and nothing else is."
            }
            Self::Timing => {
                "The Cramér-Rao bound is the least error with which a known sound in white noise \
                 can be timed."
            }
            Self::SetupInput => "Of normal errors 68 % lie within one standard error.",
            Self::Late => {
                "The first sample above a fixed level comes the later, the fainter the impact; where \
                 the whole sound fits best does not depend on loudness."
            }
        }
    }
}

/// Curves against the signal-to-noise ratio in dB: that of the loudest impact, but for lateness
/// that of the impact itself.
pub fn listening(hearing: Hearing, curves: &[Curve]) -> Figure {
    let points = curves.iter().flat_map(|curve| curve.points.iter().copied());
    let (ratios, values): (Vec<f64>, Vec<f64>) = points.filter(|p| is_finite(*p)).unzip();
    if ratios.is_empty() {
        return Figure::empty(HEIGHT, hearing.title(), "There is nothing to compare.");
    }
    let x = Axis::new(Scale::linear(ratios), hearing.loudness());
    let y = hearing.axis(values.into_iter());
    let pens = pens(curves);
    let mut sheet = Sheet::new(HEIGHT, hearing.title());
    sheet.key(&curve_key(curves, &pens));
    let panel = Panel::fill(&mut sheet, &x, &y, 0.0);
    for (curve, pen) in curves.iter().zip(pens) {
        panel.curve(&mut sheet.canvas, &curve.points, pen);
    }
    Figure::new(sheet, hearing.caption())
}
