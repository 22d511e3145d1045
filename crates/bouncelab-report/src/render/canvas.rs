//! A canvas for lines, areas, circles and texts.
//!
//! Points that are not numbers are skipped, and dashes run on across the points of a curve. What comes of it
//! is drawn by `svg`, `picture` and `pdf`.

use super::clip::{Dash, Position, Rect, dashes, is_finite, within};
use super::text::{line_height, printable, wrapped};
use crate::theme::{self, Colour};

/// How a line looks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pen {
    pub(super) colour: Colour,
    pub(super) width: f64,
    pub(super) dash: Option<Dash>,
}

impl Pen {
    pub(super) const fn solid(colour: Colour, width: f64) -> Self {
        Self {
            colour,
            width,
            dash: None,
        }
    }
}

/// Which part of a text is at its position.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Anchor {
    Start,
    Middle,
    End,
}

/// How a text looks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Style {
    pub(super) size: u32,
    pub(super) colour: Colour,
    pub(super) anchor: Anchor,
    pub(super) bold: bool,
}

impl Style {
    pub(super) const fn new(size: u32, colour: Colour, anchor: Anchor) -> Self {
        Self {
            size,
            colour,
            anchor,
            bold: false,
        }
    }

    pub(super) const fn bold(self) -> Self {
        Self { bold: true, ..self }
    }
}

/// What can be drawn. The coordinates are numbers.
#[derive(Debug)]
pub(super) enum Shape {
    Line {
        points: Vec<Position>,
        colour: Colour,
        width: f64,
    },
    Area {
        corners: Vec<Position>,
        colour: Colour,
    },
    Circle {
        centre: Position,
        radius: f64,
        fill: Colour,
        rim: Option<Colour>,
    },
    Text {
        position: Position,
        words: String,
        style: Style,
    },
}

/// Width of the rim of a circle.
pub(super) const RIM: f64 = 1.5;

/// A drawing.
#[derive(Debug)]
pub(super) struct Canvas {
    size: (f64, f64),
    shapes: Vec<Shape>,
}

impl Canvas {
    pub(super) fn new(width: f64, height: f64) -> Self {
        Self {
            size: (width, height),
            shapes: Vec::new(),
        }
    }

    /// A curve through the points, without the parts outside a rectangle; it is interrupted where a
    /// point is not a number.
    pub(super) fn curve(&mut self, rect: Rect, points: &[Position], pen: Pen) {
        for run in points.split(|&point| !is_finite(point)) {
            for piece in within(rect, run) {
                match pen.dash {
                    None => self.stroke(piece, pen),
                    Some(dash) => {
                        for stroke in dashes(&piece, dash) {
                            self.stroke(stroke, pen);
                        }
                    }
                }
            }
        }
    }

    pub(super) fn line(&mut self, from: Position, to: Position, pen: Pen) {
        let (left, right) = (from.0.min(to.0), from.0.max(to.0));
        let (top, bottom) = (from.1.min(to.1), from.1.max(to.1));
        let all = Rect {
            left,
            top,
            right,
            bottom,
        };
        self.curve(all, &[from, to], pen);
    }

    fn stroke(&mut self, points: Vec<Position>, pen: Pen) {
        if points.len() < 2 {
            return;
        }
        self.shapes.push(Shape::Line {
            points,
            colour: pen.colour,
            width: pen.width,
        });
    }

    /// A filled shape; nothing if a corner is not a number.
    pub(super) fn area(&mut self, corners: &[Position], colour: Colour) {
        if corners.len() < 3 || !corners.iter().copied().all(is_finite) {
            return;
        }
        self.shapes.push(Shape::Area {
            corners: corners.to_vec(),
            colour,
        });
    }

    /// A filled rectangle.
    pub(super) fn block(&mut self, rect: Rect, colour: Colour) {
        let Rect {
            left,
            top,
            right,
            bottom,
        } = rect;
        let corners = [(left, top), (right, top), (right, bottom), (left, bottom)];
        self.area(&corners, colour);
    }

    /// A circle: filled, or white inside so that lines do not run through it.
    pub(super) fn circle(&mut self, centre: Position, radius: f64, colour: Colour, filled: bool) {
        if !is_finite(centre) {
            return;
        }
        self.shapes.push(Shape::Circle {
            centre,
            radius,
            fill: if filled { colour } else { theme::PAPER },
            rim: (!filled).then_some(colour),
        });
    }

    pub(super) fn text(&mut self, position: Position, words: &str, style: Style) {
        if !is_finite(position) {
            return;
        }
        self.shapes.push(Shape::Text {
            position,
            words: printable(words),
            style,
        });
    }

    /// A text broken into lines where it is wider than `width` figure pixels, at most `most`. The position
    /// is that of the middle line.
    pub(super) fn text_within(
        &mut self,
        (width, most): (f64, usize),
        (x, y): Position,
        words: &str,
        style: Style,
    ) {
        let lines = wrapped(words, style.size, width, most);
        let height = line_height(style.size);
        let first = y - height * (lines.len() - 1) as f64 / 2.0;
        for (line, words) in lines.iter().enumerate() {
            self.text((x, first + height * line as f64), words, style);
        }
    }

    /// The drawing as SVG that scales with its container, with a title and a description for
    /// those who cannot see it.
    pub(super) fn svg(&self, title: &str, description: &str) -> String {
        super::svg::svg(&self.shapes, self.size, title, description)
    }

    /// The drawing as a PNG picture of the given width in pixels.
    #[cfg(feature = "pictures")]
    pub(super) fn png(&self, width_px: u32) -> Result<Vec<u8>, String> {
        super::picture::png(&self.shapes, self.size, width_px)
    }

    /// The drawing as a PDF with this title.
    #[cfg(feature = "pictures")]
    pub(super) fn pdf(&self, title: &str) -> Result<Vec<u8>, String> {
        super::pdf::pdf(&self.shapes, self.size, title)
    }
}
