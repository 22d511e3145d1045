//! Values with their intervals, and the limits that they must keep.

use super::Figure;
use super::rows::{Name, Rows};
use crate::canvas::Pen;
use crate::scale::Scale;
use crate::sheet::{Panel, Sheet, Swatch};
use crate::theme::{self, Meaning};

const ROW: f64 = 30.0;
/// More rows than this are no figure any more.
const MOST: usize = 40;

/// A value to be held against limits.
#[derive(Debug, Clone, PartialEq)]
pub struct Judged {
    /// Name in a few words.
    pub name: String,
    /// The value.
    pub value: f64,
    /// Where it lies with 95 % probability, if that can be told.
    pub interval95: Option<[f64; 2]>,
    /// Whether the decision is about this value; the others lead to it.
    pub decides: bool,
}

/// One row for each value, over the range between the limits and, darker, the range in which a value
/// of this uncertainty is accepted.
pub fn limits(
    title: &str,
    judged: &[Judged],
    limits: [Option<f64>; 2],
    accepted: [Option<f64>; 2],
    quantity: &str,
) -> Figure {
    let usable = judged.iter().filter(|judged| judged.value.is_finite());
    let usable: Vec<&Judged> = usable.take(MOST).collect();
    if usable.is_empty() {
        return Figure::empty(
            200.0,
            title,
            "There is no value to hold against the limits.",
        );
    }
    let values = usable.iter().flat_map(|judged| {
        judged
            .interval95
            .into_iter()
            .flatten()
            .chain([judged.value])
    });
    let ends = values.chain(limits.into_iter().flatten());
    let x = Scale::linear(ends.filter(|end| end.is_finite())).padded(0.08, 0.08);
    let legend =
        "pale: within the limits \u{b7} darker: accepted at this uncertainty \u{b7} bars: 95 %";
    let names = usable.iter().map(|judged| Name {
        name: &judged.name,
        below: None,
    });
    let names: Vec<Name> = names.collect();
    let mut rows = Rows::new(title, legend, (&names, ROW), x, quantity);
    let green = theme::group(2);
    shade(&mut rows, limits, green.mixed(0.12));
    shade(&mut rows, accepted, green.mixed(0.25));
    for limit in limits.into_iter().flatten() {
        let line = rows.span().map(|end| (limit, end));
        let pen = Pen::solid(green, 1.5);
        rows.panel.curve(&mut rows.sheet.canvas, &line, pen);
    }
    for (row, judged) in usable.iter().enumerate() {
        let middle = rows.middle(row);
        draw_row(&rows.panel, &mut rows.sheet, middle, judged);
    }
    Figure::new(
        rows.sheet,
        "A value whose bar lies between the limits is within them with a probability of 95 % or more.",
    )
}

/// Everything between two ends, as far as it is in the frame.
fn shade(rows: &mut Rows, [least, greatest]: [Option<f64>; 2], colour: theme::Colour) {
    if least.is_none() && greatest.is_none() {
        return;
    }
    // Far beyond any axis.
    let ends = [
        least.unwrap_or(f64::from(f32::MIN)),
        greatest.unwrap_or(f64::from(f32::MAX)),
    ];
    let span = rows.span();
    rows.panel.block(&mut rows.sheet.canvas, ends, span, colour);
}

fn draw_row(panel: &Panel, sheet: &mut Sheet, middle: f64, judged: &Judged) {
    let colour = if judged.decides {
        Meaning::Measured.colour()
    } else {
        theme::SOFT_INK
    };
    if let Some([low, high]) = judged.interval95 {
        let bar = [(low, middle), (high, middle)];
        let width = if judged.decides { 8.0 } else { 4.0 };
        panel.curve(
            &mut sheet.canvas,
            &bar,
            Pen::solid(colour.mixed(0.45), width),
        );
    }
    panel.point(
        &mut sheet.canvas,
        (judged.value, middle),
        Swatch::Dot(colour),
    );
}
