//! The mean of each group with its interval, over its drops.

use super::rows::{Name, Rows};
use super::{Figure, count};
use crate::canvas::Pen;
use crate::scale::Scale;
use crate::sheet::{Panel, Sheet, Swatch};
use crate::theme::{self, Meaning};

const ROW: f64 = 34.0;

/// A group of drops and its mean.
#[derive(Debug, Clone, PartialEq)]
pub struct GroupInterval {
    /// Name in a few words.
    pub name: String,
    /// The mean.
    pub mean: f64,
    /// Where it lies with 95 % confidence, if that can be told.
    pub interval95: Option<[f64; 2]>,
    /// Where the next drop lies with 95 % confidence, if that can be told.
    pub next95: Option<[f64; 2]>,
    /// The values of the drops, and whether each is an outlier.
    pub drops: Vec<(f64, bool)>,
}

/// One row for each group: its drops as specks, the range in which the next drop is expected as a
/// pale bar, the interval of the mean as a strong one, the mean as a dot.
pub fn intervals(title: &str, groups: &[GroupInterval], quantity: &str) -> Figure {
    let usable: Vec<&GroupInterval> = groups.iter().filter(|g| g.mean.is_finite()).collect();
    if usable.is_empty() {
        return Figure::empty(200.0, title, "There are no groups to compare.");
    }
    let ends = usable.iter().flat_map(|group| {
        let intervals = group.interval95.into_iter().flatten();
        let drops = group.drops.iter().map(|(value, _)| *value);
        intervals.chain(drops).chain([group.mean])
    });
    let x = Scale::linear(ends.filter(|end| end.is_finite())).padded(0.05, 0.05);
    let legend = "specks: drops \u{b7} pale bar: next drop, 95 % \u{b7} strong bar: mean, 95 %";
    let names = usable.iter().map(|group| Name {
        name: &group.name,
        below: Some(count(group.drops.len(), "drop")),
    });
    let names: Vec<Name> = names.collect();
    let mut rows = Rows::new(title, legend, (&names, ROW), x, quantity);
    for (row, group) in usable.iter().enumerate() {
        let middle = rows.middle(row);
        draw_row(&rows.panel, &mut rows.sheet, middle, group);
    }
    Figure::new(
        rows.sheet,
        "Where the strong bars of two groups are far apart, the groups differ; where one lies within \
         the other's pale bar, single drops cannot tell them apart.",
    )
}

fn draw_row(panel: &Panel, sheet: &mut Sheet, middle: f64, group: &GroupInterval) {
    let blue = Meaning::Measured.colour();
    if let Some([low, high]) = group.next95 {
        let span = [middle - 0.3, middle + 0.3];
        panel.block(&mut sheet.canvas, [low, high], span, blue.mixed(0.12));
    }
    if let Some([low, high]) = group.interval95 {
        let bar = [(low, middle), (high, middle)];
        panel.curve(&mut sheet.canvas, &bar, Pen::solid(blue.mixed(0.45), 7.0));
    }
    for (place, &(value, outlier)) in group.drops.iter().enumerate() {
        // Spread over the row, so that equal values are seen.
        let height = middle + 0.26 * spread(place);
        let colour = if outlier {
            Meaning::Warning.colour()
        } else {
            theme::SOFT_INK
        };
        if outlier {
            panel.point(&mut sheet.canvas, (value, height), Swatch::Ring(colour));
        } else {
            panel.speck(&mut sheet.canvas, (value, height), colour);
        }
    }
    panel.point(&mut sheet.canvas, (group.mean, middle), Swatch::Dot(blue));
}

/// From -1 to 1, evenly for any number of places: multiples of the golden section.
fn spread(place: usize) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_9;
    2.0 * (place as f64 * GOLDEN).fract() - 1.0
}
