//! What is known of several quantities together.

use super::{Figure, LINE};
use crate::canvas::Pen;
use crate::scale::{Scale, extent};
use crate::shape::Rect;
use crate::sheet::{KeyEntry, Panel, Sheet, Swatch};
use crate::theme::{self, Colour, Meaning};

const TITLE: &str = "What is known of them together";

/// Cells along each side of a panel: with some thousand draws, each has enough.
const CELLS: usize = 28;

/// Draws left out at each end, so that a few far ones do not squeeze the rest.
const TRIMMED: f64 = 0.004;

/// One quantity of a corner plot.
#[derive(Debug, Clone, PartialEq)]
pub struct CornerParameter {
    /// Name with its unit, as in "drop height (cm)".
    pub name: String,
    /// Equally likely values; those of the same index belong together.
    pub values: Vec<f64>,
    /// What was known before, as mean and standard deviation of a normal distribution.
    pub prior: Option<(f64, f64)>,
}

/// Histogram of each quantity on the diagonal, with what was known before as a grey curve, and below
/// it each pair: the regions that hold 68 and 95 %.
pub fn corner(parameters: &[CornerParameter]) -> Figure {
    let usable: Vec<&CornerParameter> = parameters
        .iter()
        .filter(|parameter| varies(&parameter.values))
        .collect();
    let count = usable.len();
    if count == 0 {
        return Figure::empty(200.0, TITLE, "There are no quantities to show.");
    }
    let side = (theme::WIDTH - 90.0) / count as f64;
    let mut sheet = Sheet::new(140.0 + side * count as f64, TITLE);
    let blue = Meaning::Measured.colour();
    let prior_pen = prior_pen();
    let mut key = vec![KeyEntry::new(
        Swatch::Dot(blue),
        "after the data: 68 % dark, 95 % light",
    )];
    if usable.iter().any(|parameter| parameter.prior.is_some()) {
        key.push(KeyEntry::new(Swatch::Line(prior_pen), "before the data"));
    }
    sheet.key(&key);
    let scales: Vec<Scale> = usable.iter().map(|p| scale(&p.values)).collect();
    for row in 0..count {
        for column in 0..=row {
            let frame = Rect {
                left: 66.0 + side * column as f64,
                top: 92.0 + side * row as f64,
                right: 66.0 + side * (column + 1) as f64 - 14.0,
                bottom: 92.0 + side * (row + 1) as f64 - 26.0,
            };
            let x_name = (row == count - 1).then_some(usable[column].name.as_str());
            if row == column {
                let names = [x_name, None];
                draw_histogram(&mut sheet, frame, scales[row], names, usable[row]);
            } else {
                let y_name = (column == 0).then_some(usable[row].name.as_str());
                let scales = [scales[column], scales[row]];
                let panel = Panel::inset(&mut sheet.canvas, frame, scales, [x_name, y_name]);
                draw_pair(
                    &panel,
                    &mut sheet,
                    scales,
                    [usable[column], usable[row]],
                    blue,
                );
            }
        }
    }
    Figure::new(
        sheet,
        "A round cloud: the data tell the two quantities apart. A tilted one: what is added to one \
         can be taken from the other. A histogram as wide as the grey curve: the data told nothing.",
    )
}

fn prior_pen() -> Pen {
    Pen::solid(Meaning::NoDrag.colour(), LINE).dashed(6.0, 4.0)
}

fn varies(values: &[f64]) -> bool {
    let finite = values.iter().copied().filter(|v| v.is_finite());
    extent(finite).is_some_and(|(low, high)| low < high)
}

fn scale(values: &[f64]) -> Scale {
    let mut sorted: Vec<f64> = values.iter().copied().filter(|v| v.is_finite()).collect();
    sorted.sort_unstable_by(f64::total_cmp);
    let trimmed = (TRIMMED * sorted.len() as f64) as usize;
    let kept = &sorted[trimmed..sorted.len() - trimmed];
    Scale::linear(kept.iter().copied()).padded(0.05, 0.05)
}

/// The cell of a value, from 0, if it lies within the scale.
fn cell(scale: &Scale, value: f64) -> Option<usize> {
    let share = scale.share(value);
    (0.0..1.0)
        .contains(&share)
        .then_some((share * CELLS as f64) as usize)
}

/// Where a cell begins; with the number after the last, where that ends.
fn edge(scale: &Scale, cell: usize) -> f64 {
    scale.low() + (scale.high() - scale.low()) * cell as f64 / CELLS as f64
}

fn draw_histogram(
    sheet: &mut Sheet,
    frame: Rect,
    scale: Scale,
    names: [Option<&str>; 2],
    parameter: &CornerParameter,
) {
    let mut counts = [0.0_f64; CELLS];
    for place in parameter.values.iter().filter_map(|&v| cell(&scale, v)) {
        counts[place] += 1.0;
    }
    let width = (scale.high() - scale.low()) / CELLS as f64;
    let area: f64 = counts.iter().sum::<f64>() * width;
    let density = counts.map(|count| count / area);
    let prior: Vec<(f64, f64)> = parameter.prior.map_or_else(Vec::new, |(mean, sd)| {
        (0..=4 * CELLS)
            .map(|step| {
                let x = scale.low() + width * step as f64 / 4.0;
                let off = (x - mean) / sd;
                let height = (-0.5 * off * off).exp() / (sd * (2.0 * std::f64::consts::PI).sqrt());
                (x, height)
            })
            .collect()
    });
    let highest = prior
        .iter()
        .map(|point| point.1)
        .chain(density)
        .fold(0.0, f64::max);
    let heights = Scale::linear([0.0, highest]).padded(0.0, 0.08);
    let panel = Panel::inset(&mut sheet.canvas, frame, [scale, heights], names);
    let colour = Meaning::Measured.colour().mixed(0.55);
    for (place, &height) in density.iter().enumerate() {
        if height > 0.0 {
            let x = [edge(&scale, place), edge(&scale, place + 1)];
            panel.block(&mut sheet.canvas, x, [0.0, height], colour);
        }
    }
    panel.curve(&mut sheet.canvas, &prior, prior_pen());
}

fn draw_pair(
    panel: &Panel,
    sheet: &mut Sheet,
    [x, y]: [Scale; 2],
    [of_x, of_y]: [&CornerParameter; 2],
    colour: Colour,
) {
    let mut counts = vec![0.0_f64; CELLS * CELLS];
    for (&a, &b) in of_x.values.iter().zip(&of_y.values) {
        if let (Some(column), Some(row)) = (cell(&x, a), cell(&y, b)) {
            counts[row * CELLS + column] += 1.0;
        }
    }
    let counts = smoothed(&counts);
    let levels = [0.95, 0.68].map(|share| level(&counts, share));
    for (level, share) in levels.into_iter().zip([0.22, 0.6]) {
        for row in 0..CELLS {
            // Neighbours in a row are one block: fewer shapes, and no seams.
            let mut column = 0;
            while column < CELLS {
                let begin = column;
                while column < CELLS && counts[row * CELLS + column] >= level {
                    column += 1;
                }
                if column > begin {
                    let across = [edge(&x, begin), edge(&x, column)];
                    let along = [edge(&y, row), edge(&y, row + 1)];
                    panel.block(&mut sheet.canvas, across, along, colour.mixed(share));
                } else {
                    column += 1;
                }
            }
        }
    }
}

/// Each cell averaged with its neighbours, which takes the chance out of the counts.
fn smoothed(counts: &[f64]) -> Vec<f64> {
    const KERNEL: [f64; 5] = [1.0, 4.0, 6.0, 4.0, 1.0];
    // Across, then down: the kernel is a product.
    let across = convolved(counts, &KERNEL, 1);
    convolved(&across, &KERNEL, CELLS)
}

/// Convolution along a row (stride 1) or a column (stride of a row) of the cells.
fn convolved(counts: &[f64], kernel: &[f64; 5], stride: usize) -> Vec<f64> {
    let place_along = |index: usize| (index / stride) % CELLS;
    (0..counts.len())
        .map(|index| {
            kernel
                .iter()
                .enumerate()
                .filter(|(step, _)| (2..CELLS + 2).contains(&(place_along(index) + step)))
                .map(|(step, weight)| weight * counts[index + step * stride - 2 * stride])
                .sum()
        })
        .collect()
}

/// The count above which the cells hold a share of all.
fn level(counts: &[f64], share: f64) -> f64 {
    let mut sorted = counts.to_vec();
    sorted.sort_unstable_by(|a, b| b.total_cmp(a));
    let total: f64 = sorted.iter().sum();
    let mut sum = 0.0;
    for count in sorted {
        sum += count;
        if sum >= share * total {
            return count.max(f64::MIN_POSITIVE);
        }
    }
    f64::INFINITY
}
