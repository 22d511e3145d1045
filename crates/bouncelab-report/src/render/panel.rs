//! The layers of a panel.

use super::LegendMarker;
use super::axis::{self, Frame};
use super::canvas::{Anchor, Canvas, Pen, Style};
use super::clip::{Dash, Position, Rect};
use super::text::text_width;
use crate::chart::{Dashes, Layer, Marker, Panel, Point, Shape};
use crate::theme::{self, Colour};

/// Radius of a dot.
const DOT: f64 = 4.0;
/// Radius of one of many dots.
const SPECK: f64 = 1.8;
/// Half the width of a triangle that touches no other.
const TRIANGLE: f64 = 5.0;
/// Between a position and the text next to it.
const BESIDE: f64 = 8.0;

/// Draws a panel: axes, then areas and standard errors, then lines, points and texts.
pub(super) fn draw(canvas: &mut Canvas, panel: &Panel, frame: &Frame) {
    axis::draw(canvas, panel, frame);
    let marks: Vec<Mark> = panel.layers.iter().flat_map(Mark::of).collect();
    let marks = Marks::new(marks, frame);
    marks.draw_hairlines(canvas);
    for layer in &panel.layers {
        draw_below(canvas, layer, frame);
    }
    for layer in &panel.layers {
        draw_above(canvas, layer, frame);
    }
    marks.draw_numbers(canvas);
}

/// The symbol of a layer in the legend.
pub(super) fn marker_of(layer: &Layer) -> LegendMarker {
    let colour = layer.colour();
    match &layer.shape {
        Shape::Line { width, dashes, .. } | Shape::Rule { width, dashes, .. } => {
            LegendMarker::Line(pen(colour, *width, *dashes))
        }
        Shape::Points { marker, .. } => LegendMarker::Point(*marker, colour),
        Shape::Marks { filled: true, .. } => LegendMarker::Point(Marker::Triangle, colour),
        Shape::Marks { filled: false, .. } => LegendMarker::Point(Marker::OpenTriangle, colour),
        Shape::Band { .. } | Shape::Boxes { .. } | Shape::Labels { .. } => {
            LegendMarker::Patch(colour)
        }
    }
}

fn pen(colour: Colour, width: f64, dashes: Dashes) -> Pen {
    let dash = match dashes {
        Dashes::Solid => None,
        Dashes::Dashed => Some((6.0, 4.0)),
        Dashes::Dotted => Some((2.5, 4.0)),
        Dashes::Long => Some((18.0, 5.0)),
    };
    Pen {
        colour,
        width,
        dash: dash.map(|(stroke, gap)| Dash { stroke, gap }),
    }
}

/// Areas and standard errors, which must not hide points.
fn draw_below(canvas: &mut Canvas, layer: &Layer, frame: &Frame) {
    let colour = layer.colour();
    match &layer.shape {
        Shape::Band { points } => {
            for run in points.split(|point| !point.iter().all(|value| value.is_finite())) {
                let lower = run.iter().map(|&[x, low, _]| [x, low]);
                let upper = run.iter().rev().map(|&[x, _, high]| [x, high]);
                let corners = lower.chain(upper).map(|point| clamped(frame, point));
                canvas.area(&corners.collect::<Vec<Position>>(), colour);
            }
        }
        Shape::Boxes { boxes } => {
            for &[left, right, bottom, top] in boxes {
                let (left, bottom) = clamped(frame, [left, bottom]);
                let (right, top) = clamped(frame, [right, top]);
                let rect = Rect {
                    left,
                    top,
                    right,
                    bottom,
                };
                canvas.block(rect, colour);
            }
        }
        Shape::Points { points, errors, .. } => {
            let pen = Pen::solid(colour.tint(), 5.0);
            for (&[x, y], error) in points.iter().zip(errors).filter(|(_, e)| **e > 0.0) {
                let ends = [y - error, y + error].map(|end| frame.at([x, end]));
                canvas.curve(frame.rect, &ends, pen);
            }
        }
        _ => {}
    }
}

/// The position of a point, moved to the edge of the frame if it lies outside.
fn clamped(frame: &Frame, point: Point) -> Position {
    let (x, y) = frame.at(point);
    let Rect {
        left,
        top,
        right,
        bottom,
    } = frame.rect;
    (x.clamp(left, right), y.clamp(top, bottom))
}

fn draw_above(canvas: &mut Canvas, layer: &Layer, frame: &Frame) {
    let colour = layer.colour();
    match &layer.shape {
        Shape::Line {
            points,
            width,
            dashes,
        } => {
            let positions: Vec<Position> = points.iter().map(|&point| frame.at(point)).collect();
            canvas.curve(frame.rect, &positions, pen(colour, *width, *dashes));
        }
        Shape::Rule {
            at,
            upright: false,
            width,
            dashes,
        } => {
            let y = frame.y_at(*at);
            let ends = [(frame.rect.left, y), (frame.rect.right, y)];
            canvas.curve(frame.rect, &ends, pen(colour, *width, *dashes));
        }
        Shape::Rule {
            at,
            upright: true,
            width,
            dashes,
        } => {
            let x = frame.x_at(*at);
            let ends = [(x, frame.rect.top), (x, frame.rect.bottom)];
            canvas.curve(frame.rect, &ends, pen(colour, *width, *dashes));
            draw_rule_name(canvas, layer, x, frame.rect);
        }
        Shape::Points { points, marker, .. } => {
            for &position in points {
                point_within(canvas, frame.rect, frame.at(position), (*marker, colour));
            }
        }
        Shape::Labels { points, texts } => {
            let style = Style::new(theme::TICK_SIZE, colour, Anchor::Start);
            for (&point, text) in points.iter().zip(texts) {
                let (x, y) = frame.at(point);
                canvas.text((x + BESIDE, y + 4.5), text, style);
            }
        }
        Shape::Band { .. } | Shape::Boxes { .. } | Shape::Marks { .. } => {}
    }
}

/// The name of an upright line next to its top: before it if it fits there.
fn draw_rule_name(canvas: &mut Canvas, layer: &Layer, x: f64, rect: Rect) {
    if !(rect.left..=rect.right).contains(&x) {
        return;
    }
    let fits_before = x - rect.left > text_width(&layer.name, theme::LABEL_SIZE) + BESIDE;
    let (x, anchor) = if fits_before {
        (x - BESIDE, Anchor::End)
    } else {
        (x + BESIDE, Anchor::Start)
    };
    let style = Style::new(theme::LABEL_SIZE, layer.colour(), anchor);
    canvas.text((x, rect.top + 15.0), &layer.name, style);
}

/// A point; one above or below the frame becomes an arrow head at its edge, so that none is lost
/// unseen.
fn point_within(
    canvas: &mut Canvas,
    rect: Rect,
    (x, y): Position,
    (marker, colour): (Marker, Colour),
) {
    let Rect {
        left,
        top,
        right,
        bottom,
    } = rect;
    // Rounding may put the outermost point a hair outside.
    if !(left - 1.0..=right + 1.0).contains(&x) {
        return;
    }
    let is_speck = marker == Marker::Speck;
    if y < top && !is_speck {
        canvas.area(&arrow_head((x, top + 1.0), 7.0), colour);
    } else if y > bottom && !is_speck {
        canvas.area(&arrow_head((x, bottom - 1.0), -7.0), colour);
    } else if !is_speck || (top..=bottom).contains(&y) {
        point(canvas, (x, y), marker, colour);
    }
}

fn arrow_head((x, tip): Position, length: f64) -> [Position; 3] {
    let base = tip + length;
    [(x, tip), (x - 4.0, base), (x + 4.0, base)]
}

/// A point at a position.
pub(super) fn point(canvas: &mut Canvas, (x, y): Position, marker: Marker, colour: Colour) {
    match marker {
        Marker::Dot => canvas.circle((x, y), DOT, colour, true),
        Marker::Ring => canvas.circle((x, y), DOT, colour, false),
        Marker::Speck => canvas.circle((x, y), SPECK, colour, true),
        Marker::Triangle => triangle(canvas, (x, y + 5.0), TRIANGLE, colour, true),
        Marker::OpenTriangle => triangle(canvas, (x, y + 5.0), TRIANGLE, colour, false),
    }
}

/// A triangle standing on its tip, of the given half width; an open one is white inside.
fn triangle(canvas: &mut Canvas, (x, y): Position, half: f64, colour: Colour, filled: bool) {
    let top = y - 2.0 * TRIANGLE + 1.0;
    let corners = [(x, y), (x - half, top), (x + half, top)];
    canvas.area(&corners, if filled { colour } else { theme::PAPER });
    if !filled {
        let pen = Pen::solid(colour, 1.5);
        for (from, to) in [(0, 1), (1, 2), (2, 0)] {
            canvas.line(corners[from], corners[to], pen);
        }
    }
}

/// How high the marks above a panel are.
pub(super) fn height_of_marks(panel: &Panel) -> f64 {
    let groups = panel.layers.iter().filter_map(|layer| match &layer.shape {
        Shape::Marks {
            positions, group, ..
        } if !positions.is_empty() => Some(group.is_empty()),
        _ => None,
    });
    // Numbers take one row, names of groups another.
    let rows = groups.map(|is_unnamed| if is_unnamed { 1.0 } else { 2.0 });
    rows.reduce(f64::max).map_or(0.0, |rows| 14.0 + 16.0 * rows)
}

/// One mark above a panel.
#[derive(Debug, Clone, Copy)]
struct Mark<'a> {
    value: f64,
    number: u32,
    group: &'a str,
    filled: bool,
    colour: Colour,
}

impl<'a> Mark<'a> {
    /// The marks of a layer.
    fn of(layer: &'a Layer) -> Vec<Self> {
        let Shape::Marks {
            positions,
            numbers,
            group,
            filled,
        } = &layer.shape
        else {
            return Vec::new();
        };
        let marks = positions.iter().zip(numbers).map(|(&value, &number)| Self {
            value,
            number,
            group,
            filled: *filled,
            colour: layer.colour(),
        });
        marks.collect()
    }
}

/// The marks of a panel from left to right, each with its position.
struct Marks<'a> {
    marks: Vec<(f64, Mark<'a>)>,
    rect: Rect,
}

impl<'a> Marks<'a> {
    fn new(marks: Vec<Mark<'a>>, frame: &Frame) -> Self {
        let rect = frame.rect;
        let positions = marks.into_iter().map(|mark| (frame.x_at(mark.value), mark));
        let mut marks: Vec<_> = positions
            .filter(|(x, _)| (rect.left..=rect.right).contains(x))
            .collect();
        marks.sort_by(|a, b| a.0.total_cmp(&b.0));
        Self { marks, rect }
    }

    /// A hairline through the panel and a triangle above it for each mark, narrower where they are
    /// dense. The open ones last: a filled one nearby must not hide one.
    fn draw_hairlines(&self, canvas: &mut Canvas) {
        for filled in [true, false] {
            for (i, (x, mark)) in self.marks.iter().enumerate() {
                if mark.filled != filled {
                    continue;
                }
                let pen = Pen::solid(mark.colour.tint(), 1.0);
                canvas.line((*x, self.rect.top), (*x, self.rect.bottom), pen);
                let before = i.checked_sub(1).map(|j| x - self.marks[j].0);
                let after = self.marks.get(i + 1).map(|(next, _)| next - x);
                let near = before
                    .into_iter()
                    .chain(after)
                    .fold(f64::INFINITY, f64::min);
                let half = (0.45 * near).clamp(1.5, TRIANGLE);
                let tip = (*x, self.rect.top - 2.0);
                triangle(canvas, tip, half, mark.colour, mark.filled);
            }
        }
    }

    /// Above the triangles the numbers, where they fit; above those the groups.
    fn draw_numbers(&self, canvas: &mut Canvas) {
        let style = Style::new(theme::TICK_SIZE, theme::SOFT_INK, Anchor::Middle);
        let groups = self.groups();
        let middles: Vec<f64> = groups.iter().map(|(_, marks)| middle(marks)).collect();
        let mut free = f64::NEG_INFINITY;
        for (index, (name, marks)) in groups.iter().enumerate() {
            let mut taken = free;
            for (number, x) in numbers(marks) {
                let half = text_width(&number, style.size) / 2.0 + 2.0;
                if x - half > taken {
                    canvas.text((x, self.rect.top - 16.0), &number, style);
                    taken = x + half;
                }
            }
            let half = text_width(name, style.size) / 2.0 + 2.0;
            let middle = middles[index];
            if !name.is_empty() && middle - half > free {
                // Long names end where those of the neighbours begin.
                let before = index.checked_sub(1).map(|i| middle - middles[i]);
                let after = middles.get(index + 1).map(|next| next - middle);
                let near = before
                    .into_iter()
                    .chain(after)
                    .fold(f64::INFINITY, f64::min);
                let position = (middle, self.rect.top - 34.0);
                canvas.text_within((near.max(2.0 * half), 1), position, name, style);
                taken = taken.max(middle + half);
            }
            free = taken;
        }
    }

    /// Names of the groups with number and position of their marks, in the order of their first marks.
    fn groups(&self) -> Vec<(&'a str, Vec<(u32, f64)>)> {
        let mut groups: Vec<(&str, Vec<(u32, f64)>)> = Vec::new();
        for (x, mark) in &self.marks {
            let position = (mark.number, *x);
            match groups.iter_mut().find(|(group, _)| *group == mark.group) {
                Some((_, positions)) => positions.push(position),
                None => groups.push((mark.group, vec![position])),
            }
        }
        groups
    }
}

/// The middle between the first and the last mark of a group.
fn middle(marks: &[(u32, f64)]) -> f64 {
    f64::midpoint(marks[0].1, marks[marks.len() - 1].1)
}

/// The numbers worth writing, each with its position: the first, every fifth and the last, or one text
/// for all if they are too close.
fn numbers(marks: &[(u32, f64)]) -> Vec<(String, f64)> {
    const CLOSE: f64 = 24.0;
    let ((first, from), (last, to)) = (marks[0], marks[marks.len() - 1]);
    if first != last && to - from < CLOSE {
        return vec![(format!("{first}–{last}"), f64::midpoint(from, to))];
    }
    let is_worth = |number: u32| number == first || number == last || number.is_multiple_of(5);
    let worth = marks.iter().filter(|(number, _)| is_worth(*number));
    worth.map(|&(number, x)| (number.to_string(), x)).collect()
}
