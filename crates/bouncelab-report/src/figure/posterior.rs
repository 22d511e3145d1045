//! The joint posterior of several quantities.

use std::borrow::Cow;

use bouncelab::inference::Posterior;

use crate::chart::{Axis, Chart, Dashes, Layer, Panel, Point, Scale, Ticks};
use crate::messages::Translator;
use crate::theme::Meaning;

/// Cells along each side of a panel: with some thousand draws, each has enough.
const CELLS: usize = 28;

/// Draws left out at each end, so that a few far ones do not squeeze the rest.
const TRIMMED: f64 = 0.004;

/// Width of all panels together.
const SIDE: f64 = 540.0;

/// One quantity of a posterior figure.
#[derive(Debug, Clone, PartialEq)]
struct Parameter<'a> {
    axis: Axis,
    /// Equally likely values in the unit of the axis; those of the same index belong together.
    values: Cow<'a, [f64]>,
    /// The prior, as mean and standard deviation of a normal distribution.
    prior: Option<(f64, f64)>,
}

/// The posterior of restitution, drag coefficient and drop height: a histogram of each on the diagonal,
/// with the prior as a grey curve, and below it each pair: the regions that hold 68 and
/// 95 %.
pub(super) fn posterior(posterior: &Posterior, translator: &Translator) -> Chart {
    let mut parameters = parameters(posterior, translator);
    parameters.retain(|parameter| varies(&parameter.values));
    let count = parameters.len();
    if count == 0 {
        return Chart::empty(translator, "posterior");
    }
    let panels = (0..count).flat_map(|row| {
        let columns = 0..=row;
        columns.map(move |column| (row, column))
    });
    let panels = panels.map(|(row, column)| panel(&parameters, row, column, translator));
    let caption = translator.text("figure-posterior-caption");
    let mut chart = Chart::new(translator, "posterior", caption, panels.collect());
    chart.columns = vec![1.0; count];
    chart
}

/// The quantities of the figure, in the order of its rows.
fn parameters<'a>(posterior: &'a Posterior, translator: &Translator) -> Vec<Parameter<'a>> {
    let parameter = |id: &str, unit, values: Cow<'a, [f64]>, prior| Parameter {
        axis: Axis::new(translator.text(id), unit, scale(&values)),
        values,
        prior,
    };
    let draws = &posterior.draws;
    let height = draws.drop_height_m.iter().map(|height| height * 100.0);
    let restitution = Cow::from(&draws.restitution);
    let mut parameters = vec![parameter("axis-restitution-short", "", restitution, None)];
    if posterior.drag_coefficient.is_some() {
        let prior = posterior.drag_coefficient_prior;
        let prior = prior.map(|prior| (prior.value, prior.sd));
        let values = Cow::from(&draws.drag_coefficient);
        parameters.push(parameter("axis-drag-coefficient", "", values, prior));
    }
    parameters.push(parameter("axis-height", "cm", height.collect(), None));
    parameters
}

/// A histogram on the diagonal, the regions of a pair below it.
fn panel(
    parameters: &[Parameter<'_>],
    row: usize,
    column: usize,
    translator: &Translator,
) -> Panel {
    let (of_x, of_y) = (&parameters[column], &parameters[row]);
    // Only panels at the left and at the bottom have numbers.
    let ticks = |is_outer: bool| {
        if is_outer {
            Ticks::Labelled
        } else {
            Ticks::Grid
        }
    };
    let (y, layers) = if row == column {
        histogram(of_x, translator)
    } else {
        let mut y = of_y.axis.clone().with_ticks(ticks(column == 0));
        if column > 0 {
            y.quantity.clear();
        }
        (y, pair(of_x, of_y))
    };
    let x = of_x
        .axis
        .clone()
        .with_ticks(ticks(row + 1 == parameters.len()));
    let height = SIDE / parameters.len() as f64 - 40.0;
    Panel {
        row,
        column,
        ..Panel::new(height, x, y, layers)
    }
}

fn varies(values: &[f64]) -> bool {
    let mut finite = values.iter().filter(|v| v.is_finite());
    let first = finite.next();
    finite.any(|value| Some(value) != first)
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

/// The density of one quantity, and its prior.
fn histogram(parameter: &Parameter, translator: &Translator) -> (Axis, Vec<Layer>) {
    let scale = &parameter.axis.scale;
    let mut counts = [0.0_f64; CELLS];
    for index in parameter.values.iter().filter_map(|&v| cell(scale, v)) {
        counts[index] += 1.0;
    }
    let width = (scale.high() - scale.low()) / CELLS as f64;
    let area: f64 = counts.iter().sum::<f64>() * width;
    let bars = counts.iter().enumerate().filter(|(_, count)| **count > 0.0);
    let bars = bars.map(|(index, count)| {
        [
            edge(scale, index),
            edge(scale, index + 1),
            0.0,
            count / area,
        ]
    });
    let bars: Vec<[f64; 4]> = bars.collect();
    let prior = parameter.prior.map(|(mean, sd)| -> Vec<Point> {
        let steps = (0..=4 * CELLS).map(|step| scale.low() + width * step as f64 / 4.0);
        let density = |x: f64| {
            let off = (x - mean) / sd;
            [
                x,
                (-0.5 * off * off).exp() / (sd * (2.0 * std::f64::consts::PI).sqrt()),
            ]
        };
        steps.map(density).collect()
    });
    let tops = bars.iter().map(|bar| bar[3]);
    let highest = tops.chain(prior.iter().flatten().map(|point| point[1]));
    let heights = Scale::linear([0.0, highest.fold(0.0, f64::max)]).padded(0.0, 0.08);
    let bars = Layer::boxes(Meaning::Measured, bars).pale(0.55);
    let prior = prior.map(|points| {
        let name = translator.text("figure-posterior-prior");
        let curve = Layer::line(Meaning::Plain, points).with_dashes(Dashes::Dashed);
        curve.named(name)
    });
    let name = translator.text("figure-posterior-posterior");
    let layers = std::iter::once(bars.named(name)).chain(prior).collect();
    (
        Axis::new(String::new(), "", heights).with_ticks(Ticks::Grid),
        layers,
    )
}

/// The regions that hold 95 and 68 % of two quantities.
fn pair(of_x: &Parameter, of_y: &Parameter) -> Vec<Layer> {
    let (x, y) = (&of_x.axis.scale, &of_y.axis.scale);
    let mut counts = vec![0.0_f64; CELLS * CELLS];
    for (&a, &b) in of_x.values.iter().zip(&*of_y.values) {
        if let (Some(column), Some(row)) = (cell(x, a), cell(y, b)) {
            counts[row * CELLS + column] += 1.0;
        }
    }
    let counts = smoothed(&counts);
    let region = |(share, strength)| {
        let level = level(&counts, share);
        let mut boxes = Vec::new();
        for row in 0..CELLS {
            // Neighbours in a row are one box: fewer shapes, and no seams.
            let cells = &counts[row * CELLS..(row + 1) * CELLS];
            let mut column = 0;
            for run in cells.chunk_by(|a, b| (*a >= level) == (*b >= level)) {
                let end = column + run.len();
                if run[0] >= level {
                    boxes.push([
                        edge(x, column),
                        edge(x, end),
                        edge(y, row),
                        edge(y, row + 1),
                    ]);
                }
                column = end;
            }
        }
        Layer::boxes(Meaning::Measured, boxes).pale(strength)
    };
    [(0.95, 0.22), (0.68, 0.6)].map(region).into()
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
