//! The drops in the order in which they were made.

use super::{Figure, LINE, robust_scale};
use crate::canvas::Pen;
use crate::scale::Scale;
use crate::sheet::{Axis, KeyEntry, Measured, Panel, Sheet, Swatch};
use crate::theme::{self, Meaning};

const TITLE: &str = "Does anything drift?";
const HEIGHT: f64 = 360.0;

/// A drop in a run chart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunPoint {
    /// Its value less the median of its group.
    pub off: f64,
    /// Its own standard error, if known.
    pub standard_error: Option<f64>,
    /// The place of its group.
    pub group: usize,
    /// Whether it does not belong to its group.
    pub outlier: bool,
}

/// Each drop less the median of its group, in the order of the list, with the limits within which
/// drops lie as long as nothing changes. `groups` are the names of the groups, by their place.
pub fn run_chart(points: &[RunPoint], groups: &[String], limit: Option<f64>) -> Figure {
    /// With more groups than this a key would hide the drops.
    const MOST_NAMED: usize = 8;
    let numbered: Vec<(f64, &RunPoint)> = (1..)
        .map(f64::from)
        .zip(points)
        .filter(|(_, point)| point.off.is_finite())
        .collect();
    if numbered.is_empty() {
        return Figure::empty(HEIGHT, TITLE, "There are no drops to show.");
    }
    let limit = limit.filter(|limit| limit.is_finite());
    let limits = limit.map(|limit| [-limit, limit]);
    let offs: Vec<_> = numbered
        .iter()
        .map(|(_, point)| (point.off, point.standard_error))
        .collect();
    let bulk = robust_scale(&offs);
    let ends = [bulk.low(), bulk.high(), 0.0].into_iter();
    let y = Axis::new(
        Scale::linear(ends.chain(limits.into_iter().flatten())).padded(0.08, 0.08),
        "restitution less the median of the group",
    );
    let orders = numbered.iter().map(|(order, _)| *order).chain([0.0]);
    let x = Axis::new(Scale::linear(orders).padded(0.0, 0.02), "drop, in order");
    let mut sheet = Sheet::new(HEIGHT, TITLE);
    let pen = Pen::solid(Meaning::NoDrag.colour(), 1.5).dashed(7.0, 5.0);
    let mut key = Vec::new();
    if groups.len() > 1 && groups.len() <= MOST_NAMED {
        let named = groups.iter().enumerate();
        key.extend(named.map(|(place, name)| KeyEntry::new(Swatch::of_group(place), name.clone())));
    }
    if limit.is_some() {
        key.push(KeyEntry::new(Swatch::Line(pen), "if nothing changes"));
    }
    if numbered.iter().any(|(_, point)| point.outlier) {
        key.push(KeyEntry::new(odd(), "does not belong"));
    }
    sheet.key(&key);
    let panel = Panel::fill(&mut sheet, &x, &y, 0.0);
    panel.level(
        &mut sheet.canvas,
        0.0,
        Pen::solid(Meaning::NoDrag.colour(), LINE),
    );
    for level in limits.into_iter().flatten() {
        panel.level(&mut sheet.canvas, level, pen);
    }
    let crowded = numbered.len() > 400;
    for &(order, point) in &numbered {
        let measured = Measured {
            place: (order, point.off),
            standard_error: point.standard_error,
        };
        let colour = theme::group(point.group);
        if point.outlier {
            panel.point(&mut sheet.canvas, measured.place, odd());
        } else if crowded {
            panel.speck(&mut sheet.canvas, measured.place, colour);
        } else {
            panel.uncertainty(&mut sheet.canvas, measured, colour);
            panel.point(
                &mut sheet.canvas,
                measured.place,
                Swatch::of_group(point.group),
            );
        }
    }
    Figure::new(
        sheet,
        "Each drop less the median of its group, in order: a slope or a step means that ball, surface \
         or air have changed on the way.",
    )
}

fn odd() -> Swatch {
    Swatch::Ring(Meaning::Warning.colour())
}
