//! Draws a chart as SVG, PNG and PDF.
//!
//! Everything is measured in figure pixels: a chart is [`theme::WIDTH`] of them wide and as high as its
//! legend and its panels need.

mod axis;
mod canvas;
mod clip;
#[cfg(feature = "pictures")]
mod font;
mod panel;
#[cfg(feature = "pictures")]
mod paths;
#[cfg(feature = "pictures")]
mod pdf;
#[cfg(feature = "pictures")]
mod picture;
mod svg;
mod text;

use std::borrow::Cow;

use crate::chart::{Chart, Marker, Panel, Shape, Ticks};
use crate::theme::{self, Colour};
use axis::Frame;
use canvas::{Anchor, Canvas, Pen, Style};
use clip::{Position, Rect};
use text::{MAX_LINES, line_height, text_width, wrapped};

/// The narrowest picture, in pixels: below it nothing can be read.
pub const MIN_WIDTH_PX: u32 = 120;
/// The widest picture, in pixels.
pub const MAX_WIDTH_PX: u32 = 8000;

/// Distance of everything from the edge of the drawing.
const MARGIN: f64 = 16.0;
/// Where the title ends.
const BELOW_TITLE: f64 = 40.0;
/// Between the symbol of an entry of the legend and its name.
const AFTER_MARKER: f64 = 7.0;
/// Between two columns of panels.
const BETWEEN_COLUMNS: f64 = 14.0;
/// Height of a drawing without panels.
const EMPTY: f64 = 200.0;

const AXIS_NAME: Style = Style::new(theme::LABEL_SIZE, theme::SOFT_INK, Anchor::Start);
const TEXT: Style = Style::new(theme::LABEL_SIZE, theme::INK, Anchor::Start);

impl Chart {
    /// Width and height in figure pixels: its natural size on a page.
    pub fn size(&self) -> (f64, f64) {
        (theme::WIDTH, Layout::of(self).height)
    }

    /// The chart as SVG, which scales to any size; the caption is its description for those who
    /// cannot see it.
    pub fn svg(&self) -> String {
        self.drawn().svg(&self.title, &self.caption)
    }

    /// The chart as a PNG picture of the given width in pixels.
    ///
    /// # Errors
    ///
    /// [`Error::PictureWidth`](crate::Error::PictureWidth) if the width is not from
    /// [`MIN_WIDTH_PX`] to [`MAX_WIDTH_PX`], [`Error::Picture`](crate::Error::Picture) if the
    /// drawing library fails.
    #[cfg(feature = "pictures")]
    pub fn png(&self, width_px: u32) -> crate::Result<Vec<u8>> {
        if !(MIN_WIDTH_PX..=MAX_WIDTH_PX).contains(&width_px) {
            return Err(crate::Error::PictureWidth { width_px });
        }
        self.drawn()
            .png(width_px)
            .map_err(|problem| self.not_drawn(problem))
    }

    /// The chart as a PDF of one page of its natural size, which scales to any. Letters are shapes, so that it looks
    /// the same everywhere.
    ///
    /// # Errors
    ///
    /// [`Error::Picture`](crate::Error::Picture) if the drawing library fails.
    #[cfg(feature = "pictures")]
    pub fn pdf(&self) -> crate::Result<Vec<u8>> {
        self.drawn()
            .pdf(&self.title)
            .map_err(|problem| self.not_drawn(problem))
    }

    #[cfg(feature = "pictures")]
    fn not_drawn(&self, problem: String) -> crate::Error {
        crate::Error::Picture {
            title: self.title.clone(),
            problem,
        }
    }

    fn drawn(&self) -> Canvas {
        let layout = Layout::of(self);
        let mut canvas = Canvas::new(theme::WIDTH, layout.height);
        let title = Style::new(theme::TITLE_SIZE, theme::INK, Anchor::Start).bold();
        canvas.text((MARGIN, 29.0), &self.title, title);
        for entry in &layout.legend {
            entry.draw(&mut canvas);
        }
        for (panel, frame) in self.panels.iter().zip(&layout.frames) {
            panel::draw(&mut canvas, panel, frame);
        }
        if self.panels.is_empty() {
            let style = Style::new(theme::LABEL_SIZE, theme::SOFT_INK, Anchor::Middle);
            let middle = (
                theme::WIDTH / 2.0,
                f64::midpoint(BELOW_TITLE, layout.height),
            );
            let limits = (theme::WIDTH - 2.0 * MARGIN, MAX_LINES);
            canvas.text_within(limits, middle, &self.caption, style);
        }
        canvas
    }
}

/// The symbol before a name in the legend.
#[derive(Debug, Clone, Copy, PartialEq)]
enum LegendMarker {
    Line(Pen),
    Point(Marker, Colour),
    Patch(Colour),
}

impl LegendMarker {
    fn width(self) -> f64 {
        match self {
            Self::Line(_) => 28.0,
            Self::Point(..) | Self::Patch(_) => 12.0,
        }
    }

    /// Draws it with its left end at `x`, its middle at `y`.
    fn draw(self, canvas: &mut Canvas, (x, y): Position) {
        let middle = x + self.width() / 2.0;
        match self {
            Self::Line(pen) => canvas.line((x, y), (x + self.width(), y), pen),
            Self::Point(marker, colour) => panel::point(canvas, (middle, y), marker, colour),
            Self::Patch(colour) => {
                let patch = Rect {
                    left: x,
                    top: y - 5.0,
                    right: x + self.width(),
                    bottom: y + 6.0,
                };
                canvas.block(patch, colour);
            }
        }
    }
}

/// An entry of the legend at its position.
struct LegendEntry<'a> {
    marker: LegendMarker,
    position: Position,
    lines: Vec<Cow<'a, str>>,
}

impl LegendEntry<'_> {
    fn draw(&self, canvas: &mut Canvas) {
        self.marker.draw(canvas, self.position);
        let (x, y) = self.position;
        let x = x + self.marker.width() + AFTER_MARKER;
        for (line, translator) in self.lines.iter().enumerate() {
            let below = line_height(TEXT.size) * line as f64;
            canvas.text((x, y + 5.0 + below), translator, TEXT);
        }
    }
}

/// Where everything lies.
struct Layout<'a> {
    legend: Vec<LegendEntry<'a>>,
    frames: Vec<Frame>,
    height: f64,
}

impl<'a> Layout<'a> {
    fn of(chart: &'a Chart) -> Self {
        let (legend, top) = legend(chart);
        let (frames, bottom) = frames(chart, top);
        let height = if frames.is_empty() { EMPTY } else { bottom };
        Self {
            legend,
            frames,
            height,
        }
    }
}

/// The legend of the named layers, and where it ends.
fn legend(chart: &Chart) -> (Vec<LegendEntry<'_>>, f64) {
    const GAP: f64 = 22.0;
    const ROW: f64 = 21.0;
    let right = theme::WIDTH - MARGIN;
    let mut x = MARGIN;
    let mut y = BELOW_TITLE + 10.0;
    // By how much the lines after the first of an entry make its row higher.
    let mut more = 0.0;
    let mut placed: Vec<LegendEntry> = Vec::new();
    let mut seen = Vec::new();
    for layer in chart.panels.iter().flat_map(|panel| &panel.layers) {
        let is_labelled = matches!(layer.shape, Shape::Rule { upright: true, .. });
        if layer.name.is_empty() || is_labelled || seen.contains(&layer.name.as_str()) {
            continue;
        }
        seen.push(&layer.name);
        let marker = panel::marker_of(layer);
        let before_name = marker.width() + AFTER_MARKER;
        let most = right - MARGIN - before_name;
        let lines = wrapped(&layer.name, TEXT.size, most, MAX_LINES);
        let widths = lines.iter().map(|line| text_width(line, TEXT.size));
        let width = before_name + widths.fold(0.0, f64::max);
        if x > MARGIN && x + width > right {
            x = MARGIN;
            y += ROW + more;
            more = 0.0;
        }
        more = more.max(line_height(TEXT.size) * (lines.len() - 1) as f64);
        placed.push(LegendEntry {
            marker,
            position: (x, y),
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

/// Where the data of each panel go, and where the last one ends with its axis.
fn frames(chart: &Chart, top: f64) -> (Vec<Frame>, f64) {
    let columns = chart.columns.len();
    let of_column = |column: usize| chart.panels.iter().filter(move |p| p.column == column);
    let gutters: Vec<f64> = (0..columns)
        .map(|column| {
            let labels = of_column(column).map(axis::width_of_labels);
            let least = if column == 0 { 32.0 } else { 0.0 };
            labels.fold(least, f64::max)
        })
        .collect();
    let taken = 2.0 * MARGIN + 8.0 + BETWEEN_COLUMNS * columns.saturating_sub(1) as f64;
    let free = theme::WIDTH - taken - gutters.iter().sum::<f64>();
    let shares: f64 = chart.columns.iter().sum();
    let mut sides = Vec::new();
    let mut x = MARGIN;
    for (gutter, share) in gutters.iter().zip(&chart.columns) {
        let left = x + gutter;
        let right = left + free * share / shares;
        sides.push((left, right));
        x = right + BETWEEN_COLUMNS;
    }
    let mut rows = Vec::new();
    let mut y = top;
    let last = chart.panels.iter().map(|panel| panel.row).max();
    for row in 0..last.map_or(0, |last| last + 1) {
        let of_row = || chart.panels.iter().filter(move |panel| panel.row == row);
        let highest = |height: fn(&Panel) -> f64| of_row().map(height).fold(0.0, f64::max);
        let top = y + highest(above);
        let bottom = top + highest(axis::height_of_rows);
        y = bottom + highest(below);
        rows.push((top, bottom));
    }
    let frames = chart.panels.iter().map(|panel| {
        let (left, right) = sides[panel.column.min(columns - 1)];
        let (top, bottom) = rows[panel.row];
        Frame {
            rect: Rect {
                left,
                top,
                right,
                bottom,
            },
            x: panel.x.scale,
            y: panel.y.scale,
            is_last: panel.column + 1 >= columns,
            decimal_separator: chart.decimal_separator,
        }
    });
    (frames.collect(), y)
}

/// What is above the frame of a panel: its title, the name of its vertical axis, and marks.
fn above(panel: &Panel) -> f64 {
    let title = if panel.title.is_empty() { 0.0 } else { 22.0 };
    let name = if panel.y.quantity.is_empty() {
        0.0
    } else {
        22.0
    };
    8.0 + title + name + panel::height_of_marks(panel)
}

/// What is below: the numbers and the name of its horizontal axis.
fn below(panel: &Panel) -> f64 {
    if panel.x.ticks == Ticks::Labelled {
        52.0
    } else {
        8.0
    }
}
