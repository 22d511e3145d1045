//! The furniture of a figure: a title, a key, and panels with axes.

use std::borrow::Cow;

use crate::canvas::{Anchor, Canvas, MOST_LINES, Pen, Style, line_height, text_width, wrapped};
use crate::language::{Say, said};
use crate::scale::{Scale, Tick, Ticks};
use crate::shape::{Point, Rect};
use crate::theme::{self, Colour};

/// Distance of everything from the edge of the sheet.
const MARGIN: f64 = 16.0;
/// Where the title ends.
const BELOW_TITLE: f64 = 40.0;
/// Between what stands for something in the key and its name.
const AFTER_SWATCH: f64 = 7.0;
/// Points off the sheet are at most this far away, so that curves to them can be cut at the
/// frame in finite numbers.
const FAR: f64 = 1e9;

const AXIS_NAME: Style = Style::new(theme::LABEL_SIZE, theme::SOFT_INK, Anchor::Start);
const KEY_TEXT: Style = Style::new(theme::LABEL_SIZE, theme::INK, Anchor::Start);

/// What stands before a name in the key.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Swatch {
    Line(Pen),
    Dot(Colour),
    Ring(Colour),
    /// A triangle that points down, filled or open.
    Mark {
        colour: Colour,
        filled: bool,
    },
}

/// A name in the key.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct KeyEntry {
    pub(crate) swatch: Swatch,
    pub(crate) name: String,
}

impl KeyEntry {
    pub(crate) fn new(swatch: Swatch, name: impl Into<String>) -> Self {
        Self {
            swatch,
            name: name.into(),
        }
    }
}

/// A sheet with its title and key; what is below `top` is free.
///
/// Title and key are drawn last: in another language the key may take more rows, and then all that
/// is below moves down.
#[derive(Debug)]
pub(crate) struct Sheet {
    title: String,
    key: Vec<KeyEntry>,
    /// What lies below title and key.
    pub(crate) canvas: Canvas,
    top: f64,
}

/// An entry of the key in its place.
struct Placed<'a> {
    swatch: Swatch,
    place: Point,
    lines: Vec<Cow<'a, str>>,
}

impl Sheet {
    pub(crate) fn new(height: f64, title: &str) -> Self {
        Self {
            title: title.to_owned(),
            key: Vec::new(),
            canvas: Canvas::new(theme::WIDTH, height),
            top: BELOW_TITLE,
        }
    }

    pub(crate) fn title(&self) -> &str {
        &self.title
    }

    /// A key under the title, in as many rows as it needs.
    pub(crate) fn key(&mut self, entries: &[KeyEntry]) {
        self.key = entries.to_vec();
        self.top = self.placed_key().1;
    }

    /// Says every word on it in another language.
    pub(crate) fn translate(&mut self, say: &mut Say<'_>) {
        said(&mut self.title, say);
        for entry in &mut self.key {
            said(&mut entry.name, say);
        }
        self.canvas.translate(say);
    }

    /// Width and height.
    pub(crate) fn size(&self) -> (f64, f64) {
        let lower = self.placed_key().1 - self.top;
        (self.canvas.width(), self.canvas.height() + lower)
    }

    /// All of it.
    pub(crate) fn drawn(&self) -> Canvas {
        let (width, height) = self.size();
        let mut canvas = Canvas::new(width, height);
        let mut style = Style::new(theme::TITLE_SIZE, theme::INK, Anchor::Start);
        style.bold = true;
        canvas.text((MARGIN, 29.0), self.title.as_str(), style);
        for entry in self.placed_key().0 {
            let (x, y) = entry.place;
            entry.swatch.draw(&mut canvas, entry.place);
            let x = x + entry.swatch.width() + AFTER_SWATCH;
            for (line, words) in entry.lines.into_iter().enumerate() {
                let y = y + 5.0 + line_height(KEY_TEXT.size) * line as f64;
                canvas.text((x, y), words, KEY_TEXT);
            }
        }
        canvas.take(&self.canvas, height - self.canvas.height());
        canvas
    }

    /// The key laid out, and where it ends.
    fn placed_key(&self) -> (Vec<Placed<'_>>, f64) {
        const GAP: f64 = 22.0;
        const ROW: f64 = 21.0;
        let right = self.canvas.width() - MARGIN;
        let mut x = MARGIN;
        let mut y = BELOW_TITLE + 10.0;
        // By how much the lines after the first of an entry make its row higher.
        let mut more = 0.0;
        let mut placed = Vec::new();
        for entry in &self.key {
            let before_name = entry.swatch.width() + AFTER_SWATCH;
            let room = right - MARGIN - before_name;
            let lines = wrapped(&entry.name, KEY_TEXT.size, room, MOST_LINES);
            let widths = lines.iter().map(|line| text_width(line, KEY_TEXT.size));
            let width = before_name + widths.fold(0.0, f64::max);
            if x > MARGIN && x + width > right {
                x = MARGIN;
                y += ROW + more;
                more = 0.0;
            }
            more = more.max(line_height(KEY_TEXT.size) * (lines.len() - 1) as f64);
            placed.push(Placed {
                swatch: entry.swatch,
                place: (x, y),
                lines,
            });
            x += width + GAP;
        }
        let end = if placed.is_empty() {
            BELOW_TITLE
        } else {
            y + more + 14.0
        };
        (placed, end)
    }

    /// A sentence in the middle, where a figure without data would have its panel.
    pub(crate) fn message(&mut self, text: &str) {
        let style = Style::new(theme::LABEL_SIZE, theme::SOFT_INK, Anchor::Middle);
        let middle = (
            self.canvas.width() / 2.0,
            f64::midpoint(self.top, self.canvas.height()),
        );
        let room = self.canvas.width() - 2.0 * MARGIN;
        self.canvas.text_wrapped(room, middle, text, style);
    }
}

impl Swatch {
    /// The mark of a group by its place: with four shapes and seven colours 28 differ.
    pub(crate) const fn of_group(place: usize) -> Self {
        let colour = theme::group(place);
        match place % 4 {
            0 => Self::Dot(colour),
            1 => Self::Mark {
                colour,
                filled: true,
            },
            2 => Self::Ring(colour),
            _ => Self::Mark {
                colour,
                filled: false,
            },
        }
    }

    fn width(self) -> f64 {
        match self {
            Self::Line(_) => 28.0,
            Self::Dot(_) | Self::Ring(_) | Self::Mark { .. } => 12.0,
        }
    }

    /// Draws it with its left end at `x`, its middle at `y`.
    fn draw(self, canvas: &mut Canvas, (x, y): Point) {
        let middle = x + self.width() / 2.0;
        match self {
            Self::Line(pen) => canvas.line((x, y), (x + self.width(), y), pen),
            Self::Dot(colour) => canvas.dot((middle, y), DOT, colour),
            Self::Ring(colour) => canvas.ring((middle, y), DOT, colour),
            Self::Mark { colour, filled } => {
                mark(canvas, (middle, y + 5.0), MARK, colour, filled);
            }
        }
    }
}

/// Radius of the dot of a measured point.
pub(crate) const DOT: f64 = 4.0;

/// Half the width of a mark that has room.
pub(crate) const MARK: f64 = 5.0;

/// A triangle standing on its tip, of the given half width; an open one is white inside.
pub(crate) fn mark(canvas: &mut Canvas, (x, y): Point, half: f64, colour: Colour, filled: bool) {
    let top = y - 2.0 * MARK + 1.0;
    let corners = [(x, y), (x - half, top), (x + half, top)];
    canvas.area(&corners, if filled { colour } else { theme::PAPER });
    if !filled {
        let outline = [corners[0], corners[1], corners[2], corners[0]];
        canvas.polyline(&outline, Pen::solid(colour, 1.5));
    }
}

/// An axis: its scale and its name with the unit.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Axis {
    pub(crate) scale: Scale,
    pub(crate) name: String,
}

impl Axis {
    pub(crate) fn new(scale: Scale, name: impl Into<String>) -> Self {
        Self {
            scale,
            name: name.into(),
        }
    }
}

/// The height a panel has: the frame's, when the names of its axes are taken off.
#[derive(Debug, Clone, Copy)]
struct Rows {
    top: f64,
    bottom: f64,
    /// Whether the horizontal axis is labelled.
    labelled: bool,
}

impl Rows {
    fn new(top: f64, bottom: f64, labelled: bool) -> Self {
        Self {
            top: top + 30.0,
            bottom: bottom - if labelled { 52.0 } else { 8.0 },
            labelled,
        }
    }
}

/// A region with two axes, drawn on when made.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Panel {
    /// Where the data go.
    pub(crate) frame: Rect,
    x: Scale,
    y: Scale,
    /// How far a number along the horizontal axis may reach beyond the frame: little where another
    /// panel follows.
    label_room: f64,
}

impl Panel {
    /// A panel over the rest of the sheet, with free room between the name of its vertical
    /// axis and its frame.
    pub(crate) fn fill(sheet: &mut Sheet, x: &Axis, y: &Axis, room: f64) -> Self {
        let rows = Rows::new(sheet.top + room, sheet.canvas.height(), true);
        let left = left_of_labels(&[(y, rows)]);
        Self::draw(sheet, rows, left, x, y, room)
    }

    /// Two panels over the rest of the sheet, one under the other, with the same horizontal
    /// axis; the upper one takes the given share of the height.
    pub(crate) fn stack(
        sheet: &mut Sheet,
        x: &Axis,
        [upper, lower]: [&Axis; 2],
        share: f64,
    ) -> [Self; 2] {
        let (top, bottom) = (sheet.top, sheet.canvas.height());
        let split = top + share * (bottom - top);
        let above = Rows::new(top, split, false);
        let below = Rows::new(split, bottom, true);
        let left = left_of_labels(&[(upper, above), (lower, below)]);
        [(upper, above), (lower, below)].map(|(y, rows)| Self::draw(sheet, rows, left, x, y, 0.0))
    }

    fn draw(sheet: &mut Sheet, rows: Rows, left: f64, x: &Axis, y: &Axis, room: f64) -> Self {
        let canvas = &mut sheet.canvas;
        let name_y = rows.top - 13.0 - room;
        canvas.text((MARGIN, name_y), y.name.as_str(), AXIS_NAME);
        let frame = Rect {
            left,
            top: rows.top,
            right: canvas.width() - MARGIN - 8.0,
            bottom: rows.bottom,
        };
        let panel = Self {
            frame,
            x: x.scale,
            y: y.scale,
            label_room: f64::INFINITY,
        };
        panel.draw_y_axis(canvas);
        panel.draw_x_axis(canvas, rows.labelled.then_some(x.name.as_str()));
        panel
    }

    fn draw_y_axis(&self, canvas: &mut Canvas) {
        let Rect { left, right, .. } = self.frame;
        let style = Style::new(theme::TICK_SIZE, theme::SOFT_INK, Anchor::End);
        let ticks = y_ticks(&self.y, self.frame.height());
        for value in ticks.minor {
            let y = self.y_at(value);
            canvas.line(
                (left - 4.0, y),
                (left, y),
                Pen::solid(theme::BASE_LINE, 1.0),
            );
        }
        for tick in ticks.major {
            let y = self.y_at(tick.value);
            canvas.line((left, y), (right, y), Pen::solid(theme::GRID, 1.0));
            canvas.text((left - 9.0, y + 4.5), tick.label, style);
        }
    }

    fn draw_x_axis(&self, canvas: &mut Canvas, name: Option<&str>) {
        let Rect {
            left,
            top,
            right,
            bottom,
        } = self.frame;
        let ticks = x_ticks(&self.x, self.frame.width());
        for tick in &ticks.major {
            let x = self.x_at(tick.value);
            canvas.line((x, top), (x, bottom), Pen::solid(theme::GRID, 1.0));
        }
        let pen = Pen::solid(theme::BASE_LINE, 1.0);
        canvas.line((left, bottom), (right, bottom), pen);
        let Some(name) = name else { return };
        for value in ticks.minor {
            let x = self.x_at(value);
            canvas.line((x, bottom), (x, bottom + 4.0), pen);
        }
        let style = Style::new(theme::TICK_SIZE, theme::SOFT_INK, Anchor::Middle);
        for tick in ticks.major {
            let x = self.x_at(tick.value);
            canvas.line((x, bottom), (x, bottom + 6.0), pen);
            // A wide number at the end of the axis stays on the sheet.
            let half = text_width(&tick.label, style.size) / 2.0;
            let x = x.min(canvas.width() - half - 6.0);
            if x + half > right + self.label_room {
                continue;
            }
            canvas.text((x, bottom + 20.0), tick.label, style);
        }
        let style = Style::new(theme::LABEL_SIZE, theme::SOFT_INK, Anchor::Middle);
        let middle = f64::midpoint(left, right);
        canvas.text((middle, bottom + 41.0), name, style);
    }

    fn x_at(&self, x: f64) -> f64 {
        (self.frame.left + self.x.share(x) * self.frame.width()).clamp(-FAR, FAR)
    }

    fn y_at(&self, y: f64) -> f64 {
        (self.frame.bottom - self.y.share(y) * self.frame.height()).clamp(-FAR, FAR)
    }

    /// The place of a point, which may lie outside the frame; not numbers where there is
    /// none.
    pub(crate) fn at(&self, (x, y): (f64, f64)) -> Point {
        (self.x_at(x), self.y_at(y))
    }

    /// A small panel in a given place. An axis without a name has no numbers either.
    pub(crate) fn inset(
        canvas: &mut Canvas,
        frame: Rect,
        [x, y]: [Scale; 2],
        [x_name, y_name]: [Option<&str>; 2],
    ) -> Self {
        let panel = Self {
            frame,
            x,
            y,
            label_room: 4.0,
        };
        panel.draw_x_axis(canvas, x_name);
        match y_name {
            Some(name) => {
                panel.draw_y_axis(canvas);
                let place = (frame.left - 40.0, frame.top - 9.0);
                canvas.text(place, name, AXIS_NAME);
            }
            None => panel.draw_grid(canvas),
        }
        panel
    }

    fn draw_grid(&self, canvas: &mut Canvas) {
        let Rect { left, right, .. } = self.frame;
        for tick in y_ticks(&self.y, self.frame.height()).major {
            let y = self.y_at(tick.value);
            canvas.line((left, y), (right, y), Pen::solid(theme::GRID, 1.0));
        }
    }

    /// The region between two curves over the same points, cut off above and below the frame.
    pub(crate) fn band(
        &self,
        canvas: &mut Canvas,
        lower: &[(f64, f64)],
        upper: &[(f64, f64)],
        colour: Colour,
    ) {
        let Rect { left, right, .. } = self.frame;
        let within = |&point: &(f64, f64)| {
            let (x, y) = self.at(point);
            (
                x.clamp(left, right),
                y.clamp(self.frame.top, self.frame.bottom),
            )
        };
        let corners: Vec<Point> = lower
            .iter()
            .map(within)
            .chain(upper.iter().rev().map(within))
            .collect();
        if corners.len() > 3 {
            canvas.area(&corners, colour);
        }
    }

    /// A rectangle between two values of each axis, cut off at the frame.
    pub(crate) fn block(&self, canvas: &mut Canvas, x: [f64; 2], y: [f64; 2], colour: Colour) {
        let corners = [(x[0], y[0]), (x[1], y[0])];
        let above = [(x[0], y[1]), (x[1], y[1])];
        self.band(canvas, &corners, &above, colour);
    }

    /// A curve, cut off at the frame.
    pub(crate) fn curve(&self, canvas: &mut Canvas, points: &[(f64, f64)], pen: Pen) {
        let places: Vec<Point> = points.iter().map(|&point| self.at(point)).collect();
        canvas.polyline_within(self.frame, &places, pen);
    }

    /// A horizontal line over the whole width.
    pub(crate) fn level(&self, canvas: &mut Canvas, y: f64, pen: Pen) {
        let y = self.y_at(y);
        if (self.frame.top..=self.frame.bottom).contains(&y) {
            canvas.line((self.frame.left, y), (self.frame.right, y), pen);
        }
    }

    /// The standard error of a point: a broad bar in the tint of its colour.
    pub(crate) fn uncertainty(&self, canvas: &mut Canvas, point: Measured, colour: Colour) {
        let (x, y) = point.place;
        let Some(error) = point.standard_error.filter(|error| *error > 0.0) else {
            return;
        };
        let ends = [y - error, y + error].map(|end| self.at((x, end)));
        canvas.polyline_within(self.frame, &ends, Pen::solid(colour.tint(), 5.0));
    }

    /// A small dot, one of many; left out if it lies outside the frame.
    pub(crate) fn speck(&self, canvas: &mut Canvas, point: (f64, f64), colour: Colour) {
        const SPECK: f64 = 1.8;
        let (x, y) = self.at(point);
        let Rect {
            left,
            top,
            right,
            bottom,
        } = self.frame;
        if (left..=right).contains(&x) && (top..=bottom).contains(&y) {
            canvas.dot((x, y), SPECK, colour);
        }
    }

    /// A point as a dot or ring; one above or below the frame becomes an arrow head at the
    /// edge, so that none is lost unseen.
    pub(crate) fn point(&self, canvas: &mut Canvas, point: (f64, f64), swatch: Swatch) {
        let (x, y) = self.at(point);
        let Rect {
            left,
            top,
            right,
            bottom,
        } = self.frame;
        // Rounding may put the outermost point a hair outside.
        if !(left - 1.0..=right + 1.0).contains(&x) {
            return;
        }
        match swatch {
            Swatch::Dot(colour) | Swatch::Ring(colour) if y < top => {
                canvas.area(&arrow_head((x, top + 1.0), 7.0), colour);
            }
            Swatch::Dot(colour) | Swatch::Ring(colour) if y > bottom => {
                canvas.area(&arrow_head((x, bottom - 1.0), -7.0), colour);
            }
            _ => swatch.draw(canvas, (x - swatch.width() / 2.0, y)),
        }
    }
}

fn arrow_head((x, tip): Point, length: f64) -> [Point; 3] {
    let base = tip + length;
    [(x, tip), (x - 4.0, base), (x + 4.0, base)]
}

/// A value on the axes of a panel with its standard error, if known.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Measured {
    pub(crate) place: (f64, f64),
    pub(crate) standard_error: Option<f64>,
}

fn x_ticks(scale: &Scale, width: f64) -> Ticks {
    // Wide labels leave room for few of them, and fewer labels may be narrower.
    (2..=10)
        .rev()
        .map(|most| scale.ticks(most))
        .find(|ticks| widest(&ticks.major) * ticks.major.len() as f64 <= width)
        .unwrap_or_else(|| outermost(scale, width))
}

/// Of few wide numbers the first and the last, or one of them: an axis says where it is.
fn outermost(scale: &Scale, width: f64) -> Ticks {
    let mut major = scale.ticks(2).major;
    let last = major.split_off(1.min(major.len())).pop();
    let apart = |a: &Tick, b: &Tick| (scale.share(b.value) - scale.share(a.value)) * width;
    let room = widest(&major);
    let last = last.filter(|last| major.iter().all(|first| apart(first, last) >= room));
    major.extend(last);
    Ticks {
        major,
        minor: Vec::new(),
    }
}

/// The width of the widest number, and what stays free beside it.
fn widest(ticks: &[Tick]) -> f64 {
    let widths = ticks
        .iter()
        .map(|tick| text_width(&tick.label, theme::TICK_SIZE) + 16.0);
    widths.fold(0.0, f64::max)
}

fn y_ticks(scale: &Scale, height: f64) -> Ticks {
    scale.ticks(((height / 32.0) as usize).max(3))
}

/// Where a frame must begin for the numbers of its vertical axes to fit.
fn left_of_labels(axes: &[(&Axis, Rows)]) -> f64 {
    let widest = axes
        .iter()
        .flat_map(|(axis, rows)| y_ticks(&axis.scale, rows.bottom - rows.top).major)
        .map(|tick| text_width(&tick.label, theme::TICK_SIZE))
        .fold(0.0, f64::max);
    (MARGIN + widest + 9.0).max(48.0)
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
