//! How far each impact lies from what was foretold.

use super::Figure;
use crate::canvas::Pen;
use crate::scale::Scale;
use crate::sheet::{Axis, KeyEntry, Panel, Sheet, Swatch};
use crate::theme::{self, Meaning};

const TITLE: &str = "How odd is each impact?";
const HEIGHT: f64 = 300.0;

/// Beyond this many standard deviations a residual is an arrow head at the edge.
const MOST: f64 = 5.0;

/// The residual of one impact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Residual {
    /// Number of the impact.
    pub number: u32,
    /// In standard deviations.
    pub standardised: f64,
    /// Whether it counts less in the fit.
    pub odd: bool,
}

/// Standardised residual of each impact against its number, with the bands in which 68 and 95 % of
/// them should lie.
pub fn residuals(residuals: &[Residual]) -> Figure {
    let usable: Vec<&Residual> = residuals
        .iter()
        .filter(|residual| residual.standardised.is_finite())
        .collect();
    let (Some(first), Some(last)) = (usable.first(), usable.last()) else {
        return Figure::empty(HEIGHT, TITLE, "There are no residuals to show.");
    };
    let blue = Meaning::Measured.colour();
    let odd = Swatch::Mark {
        colour: Meaning::Drag.colour(),
        filled: true,
    };
    let mut key = vec![KeyEntry::new(Swatch::Dot(blue), "impact")];
    if usable.iter().any(|residual| residual.odd) {
        key.push(KeyEntry::new(odd, "odd, counts less"));
    }
    let mut sheet = Sheet::new(HEIGHT, TITLE);
    sheet.key(&key);
    let numbers = usable.iter().map(|residual| residual.number);
    let x = Axis::new(Scale::counting(numbers).padded(0.03, 0.03), "impact");
    let highest = usable
        .iter()
        .map(|residual| residual.standardised.abs())
        .fold(3.0, f64::max)
        .min(MOST);
    let y = Axis::new(
        Scale::linear([-highest, highest]).padded(0.05, 0.05),
        "residual (standard deviations)",
    );
    let panel = Panel::fill(&mut sheet, &x, &y, 0.0);
    let span = [
        f64::from(first.number) - 99.0,
        f64::from(last.number) + 99.0,
    ];
    let canvas = &mut sheet.canvas;
    panel.block(canvas, span, [-2.0, 2.0], theme::BASE_LINE.mixed(0.18));
    panel.block(canvas, span, [-1.0, 1.0], theme::BASE_LINE.mixed(0.38));
    panel.level(canvas, 0.0, Pen::solid(theme::BASE_LINE, 1.0));
    for residual in usable {
        let point = (f64::from(residual.number), residual.standardised);
        let outside = residual.standardised.abs() > highest;
        let swatch = match (residual.odd, outside) {
            (true, false) => odd,
            (true, true) => Swatch::Dot(Meaning::Drag.colour()),
            _ => Swatch::Dot(blue),
        };
        panel.point(canvas, point, swatch);
    }
    Figure::new(
        sheet,
        "Two of three impacts should lie in the dark band, 19 of 20 in the light one; one far \
         outside hit an edge, or is no impact.",
    )
}
