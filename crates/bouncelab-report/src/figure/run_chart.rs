//! The drops in the order in which they were made.

use std::collections::BTreeSet;

use crate::chart::{Axis, Chart, Dashes, Layer, Marker, Panel, Scale, xs, ys};
use crate::messages::Translator;
use crate::theme::Meaning;

const ID: &str = "run";
/// With more groups than this a legend would hide the drops.
const MAX_NAMED: usize = 8;
/// With more drops than this they are specks without errors.
const CROWDED: usize = 400;

/// A drop in a run chart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RunPoint {
    /// Its value less the median of its group.
    pub off: f64,
    /// Its own standard error, if it has one.
    pub standard_error: Option<f64>,
    /// The index of its group.
    pub group: usize,
    /// Whether it does not belong to its group.
    pub outlier: bool,
}

/// Each drop less the median of its group, in the order of the list, with the limits within which
/// drops lie as long as nothing changes. `groups` are the names of the groups, by index.
pub fn run_chart(
    points: &[RunPoint],
    groups: &[String],
    limit: Option<f64>,
    translator: &Translator,
) -> Chart {
    let text = |id: &str| translator.text(&format!("figure-{ID}-{id}"));
    let numbered: Vec<(f64, &RunPoint)> = (1..)
        .map(f64::from)
        .zip(points)
        .filter(|(_, point)| point.off.is_finite())
        .collect();
    if numbered.is_empty() {
        return Chart::empty(translator, ID);
    }
    let mut layers = of_groups(&numbered, groups);
    let bulk = Scale::bulk(ys(&layers));
    let levels = levels(limit, &text("unchanged"));
    let ends = ys(&levels).chain([bulk.low(), bulk.high()]);
    let y = Scale::linear(ends).padded(0.08, 0.08);
    let outliers = layer(&numbered, Meaning::Warning, Marker::Ring, &|point| {
        point.outlier
    });
    if xs(std::slice::from_ref(&outliers)).next().is_some() {
        layers.push(outliers.named(text("outlier")));
    }
    let x = Scale::linear(xs(&layers).chain([0.0])).padded(0.0, 0.02);
    let x = Axis::new(text("order"), "", x);
    let y = Axis::new(text("off"), "", y);
    let panel = Panel::new(225.0, x, y, levels.into_iter().chain(layers).collect());
    Chart::new(translator, ID, text("caption"), vec![panel])
}

/// The points without outliers, a layer for each group.
fn of_groups(numbered: &[(f64, &RunPoint)], groups: &[String]) -> Vec<Layer> {
    let named = (2..=MAX_NAMED).contains(&groups.len());
    let indices: BTreeSet<usize> = numbered.iter().map(|(_, point)| point.group).collect();
    let layers = indices.into_iter().map(|index| {
        let marker = if numbered.len() > CROWDED {
            Marker::Speck
        } else {
            Marker::of_group(index)
        };
        let is_of = |point: &RunPoint| point.group == index && !point.outlier;
        let name = groups.get(index).filter(|_| named);
        let layer = layer(numbered, Meaning::Group(index), marker, &is_of);
        layer.named(name.cloned().unwrap_or_default())
    });
    layers.collect()
}

/// The points that are shown in this layer, with their standard errors unless there are too many.
fn layer(
    numbered: &[(f64, &RunPoint)],
    meaning: Meaning,
    marker: Marker,
    shown: &dyn Fn(&RunPoint) -> bool,
) -> Layer {
    let shown = || numbered.iter().filter(|(_, point)| shown(point));
    let positions = shown().map(|(order, point)| [*order, point.off]).collect();
    let errors = shown().map(|(_, point)| point.standard_error.unwrap_or(f64::NAN));
    let errors = if numbered.len() > CROWDED {
        Vec::new()
    } else {
        errors.collect()
    };
    Layer::points(meaning, marker, positions).with_errors(errors)
}

/// Zero, and the limits within which drops lie as long as nothing changes.
fn levels(limit: Option<f64>, name: &str) -> Vec<Layer> {
    let level = |value: f64| Layer::level(Meaning::Plain, value);
    let limit = limit.filter(|limit| limit.is_finite());
    let limits = limit.into_iter().flat_map(|limit| [-limit, limit]);
    let limits = limits.map(|limit| {
        let level = level(limit).with_width(1.5).with_dashes(Dashes::Dashed);
        level.named(name)
    });
    std::iter::once(level(0.0)).chain(limits).collect()
}
