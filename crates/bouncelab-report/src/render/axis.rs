//! The axes of a panel, and the positions of values in it.

use super::canvas::{Anchor, Canvas, Pen, Style};
use super::clip::{Position, Rect};
use super::text::{MAX_LINES, line_height, text_width, wrapped};
use super::{AXIS_NAME, TEXT, above};
use crate::chart::{Axis, Panel, Point, Ticks};
use crate::scale::{Scale, Tick, TickMarks};
use crate::theme;

/// Points outside are at most this far away, so that curves to them can be cut at the frame in finite
/// numbers.
const MAX_PIXELS: f64 = 1e9;
/// How wide the names of rows may be.
const NAME_WIDTH: f64 = 188.0;
/// Between numbers and the frame.
const BEFORE_FRAME: f64 = 9.0;

const NUMBER: Style = Style::new(theme::TICK_SIZE, theme::SOFT_INK, Anchor::Middle);
const NUMBER_BEFORE: Style = Style::new(theme::TICK_SIZE, theme::SOFT_INK, Anchor::End);
const ROW_NAME: Style = Style::new(theme::TICK_SIZE, theme::INK, Anchor::End);
const BELOW_NAME: Style = Style::new(theme::TICK_SIZE - 1, theme::SOFT_INK, Anchor::End);

/// Where the data of a panel go.
#[derive(Debug, Clone, Copy)]
pub(super) struct Frame {
    pub(super) rect: Rect,
    pub(super) x: Scale,
    pub(super) y: Scale,
    /// Whether no other panel follows at its right, so that numbers may reach beyond it.
    pub(super) is_last: bool,
    pub(super) decimal_separator: char,
}

impl Frame {
    pub(super) fn x_at(&self, x: f64) -> f64 {
        (self.rect.left + self.x.share(x) * self.rect.width()).clamp(-MAX_PIXELS, MAX_PIXELS)
    }

    pub(super) fn y_at(&self, y: f64) -> f64 {
        (self.rect.bottom - self.y.share(y) * self.rect.height()).clamp(-MAX_PIXELS, MAX_PIXELS)
    }

    /// The position of a point, which may lie outside; NaN for a point without numbers.
    pub(super) fn at(&self, [x, y]: Point) -> Position {
        (self.x_at(x), self.y_at(y))
    }
}

/// How wide the numbers or names before a panel are.
pub(super) fn width_of_labels(panel: &Panel) -> f64 {
    if panel.y.ticks != Ticks::Labelled {
        return 0.0;
    }
    let names = panel.y.names.iter().flat_map(|name| parts(name));
    let names = names.flat_map(|part| wrapped(part, theme::TICK_SIZE, NAME_WIDTH, MAX_LINES));
    let widths = names.map(|line| text_width(&line, theme::TICK_SIZE));
    let ticks = y_ticks(&panel.y, panel.height).major;
    let numbers = ticks
        .iter()
        .map(|tick| text_width(&tick.label, theme::TICK_SIZE));
    BEFORE_FRAME + widths.chain(numbers).fold(0.0, f64::max)
}

/// The height of the frame of a panel: each row has that of the highest name.
pub(super) fn height_of_rows(panel: &Panel) -> f64 {
    const BETWEEN: f64 = 4.0;
    let lines = panel.y.names.iter().map(|name| {
        let lines = parts(name).map(|part| lines_of(part).len());
        lines.sum::<usize>()
    });
    let highest = lines.max().unwrap_or(0) as f64 * line_height(theme::TICK_SIZE) + BETWEEN;
    (highest * panel.y.names.len() as f64).max(panel.height)
}

/// A name, and the text below it.
fn parts(name: &str) -> impl Iterator<Item = &str> {
    name.splitn(2, '\n')
}

fn lines_of(name: &str) -> Vec<std::borrow::Cow<'_, str>> {
    wrapped(name, theme::TICK_SIZE, NAME_WIDTH, MAX_LINES)
}

/// Draws title, axes and grid of a panel.
pub(super) fn draw(canvas: &mut Canvas, panel: &Panel, frame: &Frame) {
    let start = frame.rect.left - width_of_labels(panel);
    let top = frame.rect.top - above(panel);
    let mut baseline = top + 19.0;
    if !panel.title.is_empty() {
        canvas.text((start, baseline), &panel.title, TEXT.bold());
        baseline += 22.0;
    }
    if !panel.y.quantity.is_empty() {
        canvas.text((start, baseline), &panel.y.label(), AXIS_NAME);
    }
    draw_y(canvas, &panel.y, frame);
    draw_x(canvas, &panel.x, frame);
}

fn draw_y(canvas: &mut Canvas, axis: &Axis, frame: &Frame) {
    let Rect {
        left,
        right,
        bottom,
        top,
    } = frame.rect;
    let height = bottom - top;
    for (row, name) in axis.names.iter().enumerate() {
        let middle = top + height * (row as f64 + 0.5) / axis.names.len() as f64;
        draw_name(canvas, name, (left - BEFORE_FRAME, middle + 4.5));
    }
    if axis.ticks == Ticks::Hidden {
        return;
    }
    let ticks = y_ticks(axis, height);
    let is_labelled = axis.ticks == Ticks::Labelled;
    for value in ticks.minor.into_iter().filter(|_| is_labelled) {
        let y = frame.y_at(value);
        canvas.line(
            (left - 4.0, y),
            (left, y),
            Pen::solid(theme::BASE_LINE, 1.0),
        );
    }
    for tick in ticks.major {
        let y = frame.y_at(tick.value);
        canvas.line((left, y), (right, y), Pen::solid(theme::GRID, 1.0));
        if is_labelled {
            let label = localised(&tick.label, frame);
            canvas.text((left - BEFORE_FRAME, y + 4.5), &label, NUMBER_BEFORE);
        }
    }
}

/// A name with the text below it, around a position.
fn draw_name(canvas: &mut Canvas, name: &str, (x, y): Position) {
    let line = line_height(theme::TICK_SIZE);
    let mut parts = parts(name);
    let name = parts.next().unwrap_or_default();
    let limits = (NAME_WIDTH, MAX_LINES);
    match parts.next() {
        None => canvas.text_within(limits, (x, y), name, ROW_NAME),
        Some(below) => {
            canvas.text_within(limits, (x, y - line / 2.0), name, ROW_NAME);
            let down = line * lines_of(name).len() as f64 / 2.0;
            canvas.text((x, y + down), below, BELOW_NAME);
        }
    }
}

fn draw_x(canvas: &mut Canvas, axis: &Axis, frame: &Frame) {
    let Rect {
        left,
        top,
        right,
        bottom,
    } = frame.rect;
    if axis.ticks == Ticks::Hidden {
        return;
    }
    let ticks = x_ticks(&axis.scale, frame.rect.width());
    for tick in &ticks.major {
        let x = frame.x_at(tick.value);
        canvas.line((x, top), (x, bottom), Pen::solid(theme::GRID, 1.0));
    }
    let pen = Pen::solid(theme::BASE_LINE, 1.0);
    canvas.line((left, bottom), (right, bottom), pen);
    if axis.ticks == Ticks::Grid {
        return;
    }
    for value in ticks.minor {
        let x = frame.x_at(value);
        canvas.line((x, bottom), (x, bottom + 4.0), pen);
    }
    for tick in ticks.major {
        let x = frame.x_at(tick.value);
        canvas.line((x, bottom), (x, bottom + 6.0), pen);
        // A wide number at the end of the axis stays in the drawing, and off a neighbour.
        let half = text_width(&tick.label, NUMBER.size) / 2.0;
        let x = x.min(theme::WIDTH - half - 6.0);
        if frame.is_last || x + half <= right + 4.0 {
            canvas.text((x, bottom + 20.0), &localised(&tick.label, frame), NUMBER);
        }
    }
    let style = Style::new(theme::LABEL_SIZE, theme::SOFT_INK, Anchor::Middle);
    let middle = f64::midpoint(left, right);
    canvas.text((middle, bottom + 41.0), &axis.label(), style);
}

fn localised(label: &str, frame: &Frame) -> String {
    label.replace('.', &frame.decimal_separator.to_string())
}

fn y_ticks(axis: &Axis, height: f64) -> TickMarks {
    if axis.names.is_empty() {
        axis.scale.ticks(((height / 32.0) as usize).max(3))
    } else {
        TickMarks::default()
    }
}

fn x_ticks(scale: &Scale, width: f64) -> TickMarks {
    // Of wide labels only few fit, and fewer labels may be narrower.
    (2..=10)
        .rev()
        .map(|most| scale.ticks(most))
        .find(|ticks| widest(&ticks.major) * ticks.major.len() as f64 <= width)
        .unwrap_or_else(|| outermost(scale, width))
}

/// Of few wide numbers the first and the last, or one of them: enough to locate the axis.
fn outermost(scale: &Scale, width: f64) -> TickMarks {
    let mut major = scale.ticks(2).major;
    let last = major.split_off(1.min(major.len())).pop();
    let apart = |a: &Tick, b: &Tick| (scale.share(b.value) - scale.share(a.value)) * width;
    let spacing = widest(&major);
    let last = last.filter(|last| major.iter().all(|first| apart(first, last) >= spacing));
    major.extend(last);
    TickMarks {
        major,
        minor: Vec::new(),
    }
}

/// The width of the widest number, and the space left next to it.
fn widest(ticks: &[Tick]) -> f64 {
    let widths = ticks
        .iter()
        .map(|tick| text_width(&tick.label, theme::TICK_SIZE) + 16.0);
    widths.fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Restitution known to a few millionths, in a panel as narrow as those of the posterior.
    #[test]
    fn an_axis_of_wide_numbers_has_some() {
        for width in [30.0, 100.0, 157.0, 300.0] {
            let scale = Scale::linear([0.934_96, 0.935_04]);
            let ticks = x_ticks(&scale, width).major;
            assert!(!ticks.is_empty(), "{width}");
            for pair in ticks.windows(2) {
                let apart = (scale.share(pair[1].value) - scale.share(pair[0].value)) * width;
                assert!(
                    apart >= text_width(&pair[0].label, theme::TICK_SIZE),
                    "{width}"
                );
            }
        }
    }
}
