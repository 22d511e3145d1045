//! What figures with one named row for each value have in common.

use crate::canvas::{Anchor, Style};
use crate::scale::Scale;
use crate::shape::Rect;
use crate::sheet::{Panel, Sheet};
use crate::theme;

const TOP: f64 = 78.0;
/// Where the names end and the values begin.
const LEFT: f64 = 216.0;

/// A panel of rows, the first on top; along its other axis each row has the height 1.
pub(super) struct Rows {
    pub(super) sheet: Sheet,
    pub(super) panel: Panel,
    count: f64,
    height: f64,
}

impl Rows {
    /// So many rows of a height in figure pixels, over values on a scale.
    pub(super) fn new(
        title: &str,
        legend: &str,
        (count, height): (usize, f64),
        values: Scale,
        quantity: &str,
    ) -> Self {
        let count = count as f64;
        let mut sheet = Sheet::new(TOP + height * count + 56.0, title);
        let style = Style::new(theme::TICK_SIZE, theme::SOFT_INK, Anchor::Start);
        sheet.canvas.text((16.0, 54.0), legend, style);
        let frame = Rect {
            left: LEFT,
            top: TOP,
            right: theme::WIDTH - 24.0,
            bottom: TOP + height * count,
        };
        let scales = [values, Scale::linear([0.0, count])];
        let panel = Panel::inset(&mut sheet.canvas, frame, scales, [Some(quantity), None]);
        Self {
            sheet,
            panel,
            count,
            height,
        }
    }

    /// The middle of a row, along the other axis.
    pub(super) fn middle(&self, row: usize) -> f64 {
        self.count - row as f64 - 0.5
    }

    /// From the lowest row to the highest, along the other axis.
    pub(super) fn span(&self) -> [f64; 2] {
        [0.0, self.count]
    }

    /// Writes the name of a row, and what there is to say below it.
    pub(super) fn name(&mut self, row: usize, name: &str, below: Option<&str>) {
        let middle = TOP + self.height * (row as f64 + 0.5);
        let style = Style::new(theme::TICK_SIZE, theme::INK, Anchor::Start);
        let canvas = &mut self.sheet.canvas;
        let up = if below.is_some() { -1.0 } else { 4.0 };
        canvas.text_within(LEFT - 28.0, (16.0, middle + up), name, style);
        let Some(below) = below else { return };
        let soft = Style::new(theme::TICK_SIZE - 1, theme::SOFT_INK, Anchor::Start);
        canvas.text((16.0, middle + 13.0), below, soft);
    }
}
