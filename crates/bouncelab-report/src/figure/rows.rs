//! What figures with one named row for each value have in common.

use crate::canvas::{Anchor, Canvas, MOST_LINES, Style, line_height, wrapped};
use crate::scale::Scale;
use crate::shape::Rect;
use crate::sheet::{Panel, Sheet};
use crate::theme;

const TOP: f64 = 78.0;
/// Where the names end and the values begin.
const LEFT: f64 = 216.0;

/// What stands before the values of a row.
pub(super) struct Name<'a> {
    /// The name itself, which may take several lines.
    pub(super) name: &'a str,
    /// What there is to say below it.
    pub(super) below: Option<String>,
}

impl Name<'_> {
    /// How much room it may take.
    const WIDTH: f64 = LEFT - 28.0;

    fn lines(&self) -> usize {
        wrapped(self.name, theme::TICK_SIZE, Self::WIDTH, MOST_LINES).len()
    }

    /// Height of all of it.
    fn height(&self) -> f64 {
        let lines = self.lines() + usize::from(self.below.is_some());
        line_height(theme::TICK_SIZE) * lines as f64
    }

    /// Writes it around a height.
    fn write(&self, canvas: &mut Canvas, middle: f64) {
        let line = line_height(theme::TICK_SIZE);
        let style = Style::new(theme::TICK_SIZE, theme::INK, Anchor::Start);
        let base = middle + 4.0;
        let up = if self.below.is_some() {
            line / 2.0
        } else {
            0.0
        };
        canvas.text_wrapped(Self::WIDTH, (16.0, base - up), self.name, style);
        let Some(below) = &self.below else { return };
        let soft = Style::new(theme::TICK_SIZE - 1, theme::SOFT_INK, Anchor::Start);
        let down = line * self.lines() as f64 / 2.0;
        canvas.text((16.0, base + down), below.as_str(), soft);
    }
}

/// A panel of rows, the first on top; along its other axis each row has the height 1.
pub(super) struct Rows {
    pub(super) sheet: Sheet,
    pub(super) panel: Panel,
    count: f64,
}

impl Rows {
    /// Rows with these names, over values on a scale; each at least so high, in figure pixels, and as
    /// high as the highest name.
    pub(super) fn new(
        title: &str,
        legend: &str,
        (names, least_height): (&[Name<'_>], f64),
        values: Scale,
        quantity: &str,
    ) -> Self {
        const BETWEEN: f64 = 4.0;
        let heights = names.iter().map(|name| name.height() + BETWEEN);
        let height = heights.fold(least_height, f64::max);
        let count = names.len() as f64;
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
        for (row, name) in names.iter().enumerate() {
            name.write(&mut sheet.canvas, TOP + height * (row as f64 + 0.5));
        }
        Self {
            sheet,
            panel,
            count,
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
}
