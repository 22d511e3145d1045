//! An answer against how many flights it uses.

use super::{Figure, LINE};
use crate::canvas::Pen;
use crate::scale::Scale;
use crate::sheet::{Axis, KeyEntry, Measured, Panel, Sheet, Swatch};
use crate::theme::{self, Meaning};

const TITLE: &str = "Does the answer depend on how many flights are used?";
const HEIGHT: f64 = 360.0;

/// An answer from so many flights.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CutPoint {
    /// How many flights it uses.
    pub flights: u32,
    /// The answer.
    pub value: f64,
    /// Its standard uncertainty.
    pub sd: f64,
}

/// The answers of one method.
#[derive(Debug, Clone, PartialEq)]
pub struct CutSeries {
    /// Name, as in the key.
    pub name: String,
    /// What it is, which decides its colour.
    pub meaning: Meaning,
    /// The answers.
    pub points: Vec<CutPoint>,
}

/// Answers of several methods against the number of flights used, and the truth if it is known.
pub fn cut(series: &[CutSeries], quantity: &str, truth: Option<f64>) -> Figure {
    let all = || {
        series
            .iter()
            .flat_map(|series| &series.points)
            .filter(|point| point.value.is_finite())
    };
    if all().next().is_none() {
        return Figure::empty(HEIGHT, TITLE, "There are no answers to compare.");
    }
    let ends = all().flat_map(|point| {
        let sd = if point.sd.is_finite() { point.sd } else { 0.0 };
        [point.value - sd, point.value + sd]
    });
    let y = Axis::new(
        Scale::linear(ends.chain(truth)).padded(0.08, 0.08),
        quantity,
    );
    let numbers = all().map(|point| point.flights);
    let x = Axis::new(Scale::counting(numbers).padded(0.04, 0.04), "flights used");
    let mut key: Vec<KeyEntry> = series
        .iter()
        .map(|series| KeyEntry::new(Swatch::Dot(series.meaning.colour()), series.name.clone()))
        .collect();
    let pen = Pen::solid(theme::INK, 1.5).dashed(6.0, 4.0);
    if truth.is_some() {
        key.push(KeyEntry::new(Swatch::Line(pen), "truth"));
    }
    let mut sheet = Sheet::new(HEIGHT, TITLE);
    sheet.key(&key);
    let panel = Panel::fill(&mut sheet, &x, &y, 0.0);
    if let Some(truth) = truth {
        panel.level(&mut sheet.canvas, truth, pen);
    }
    for series in series {
        let colour = series.meaning.colour();
        let places: Vec<(f64, f64)> = series
            .points
            .iter()
            .map(|point| (f64::from(point.flights), point.value))
            .collect();
        for (point, &place) in series.points.iter().zip(&places) {
            let point = Measured {
                place,
                standard_error: Some(point.sd).filter(|sd| sd.is_finite()),
            };
            panel.uncertainty(&mut sheet.canvas, point, colour);
        }
        panel.curve(&mut sheet.canvas, &places, Pen::solid(colour, 0.5 * LINE));
        for place in places {
            panel.point(&mut sheet.canvas, place, Swatch::Dot(colour));
        }
    }
    Figure::new(
        sheet,
        "A model that is right gives the same answer however many flights it uses; the answer of a \
         straight line moves, because it knows no air.",
    )
}
