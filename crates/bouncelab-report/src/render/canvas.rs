//! A canvas for lines, areas, circles and texts.
//!
//! The only module besides `picture` that knows the drawing library. It adds what the library leaves
//! out: points that are not numbers are skipped instead of drawn, dashes run on across the points of a
//! curve (the library starts them anew at each point when it makes a PNG), and the SVG scales with the
//! page and can be read aloud.

use kuva::backend::svg::SvgBackend;
use kuva::render::color::Color;
use kuva::render::render::{PathData, Primitive, Scene, TextAnchor, TextSpan};

use super::clip::{Dash, Place, Rect, dashes, is_finite, within};
use super::text::{escape, line_height, printable, wrapped};
use crate::MARK;
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

/// Which part of a text lies at its place.
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

/// A drawing.
#[derive(Debug)]
pub(super) struct Canvas(Scene);

impl Canvas {
    pub(super) fn new(width: f64, height: f64) -> Self {
        let mut scene = Scene::new(width, height);
        scene.background_color = Some(theme::PAPER.to_string());
        scene.text_color = Some(theme::INK.to_string());
        scene.font_family = Some(theme::FONT_FAMILY.to_owned());
        Self(scene)
    }

    /// A curve through the points, without the parts outside a rectangle; it is interrupted where a
    /// point is not a number.
    pub(super) fn curve(&mut self, rect: Rect, points: &[Place], pen: Pen) {
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

    pub(super) fn line(&mut self, from: Place, to: Place, pen: Pen) {
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

    fn stroke(&mut self, points: Vec<Place>, pen: Pen) {
        if points.len() < 2 {
            return;
        }
        self.0.add(Primitive::PolyLine {
            points,
            stroke: color(pen.colour),
            stroke_width: pen.width,
            stroke_dasharray: None,
        });
    }

    /// A filled shape; nothing if a corner is not a number.
    pub(super) fn area(&mut self, corners: &[Place], colour: Colour) {
        if corners.len() < 3 || !corners.iter().copied().all(is_finite) {
            return;
        }
        self.0.add(Primitive::Path(Box::new(PathData {
            d: outline(corners),
            fill: Some(color(colour)),
            stroke: Color::None,
            stroke_width: 0.0,
            opacity: None,
            stroke_dasharray: None,
        })));
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
    pub(super) fn circle(&mut self, (cx, cy): Place, r: f64, colour: Colour, filled: bool) {
        if !is_finite((cx, cy)) {
            return;
        }
        let fill = if filled { colour } else { theme::PAPER };
        self.0.add(Primitive::Circle {
            cx,
            cy,
            r,
            fill: color(fill),
            fill_opacity: None,
            stroke: (!filled).then(|| color(colour)),
            stroke_width: (!filled).then_some(1.5),
        });
    }

    pub(super) fn text(&mut self, (x, y): Place, words: &str, style: Style) {
        if !is_finite((x, y)) {
            return;
        }
        let mut span = TextSpan::plain(printable(words));
        span.bold = style.bold;
        self.0.add(Primitive::RichText {
            x,
            y,
            spans: vec![span],
            size: style.size,
            anchor: match style.anchor {
                Anchor::Start => TextAnchor::Start,
                Anchor::Middle => TextAnchor::Middle,
                Anchor::End => TextAnchor::End,
            },
            color: Some(color(style.colour)),
        });
    }

    /// A text broken into lines where it is wider than `width` figure pixels, at most so many. The place
    /// is that of the middle line.
    pub(super) fn text_within(
        &mut self,
        (width, most): (f64, usize),
        (x, y): Place,
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
        let drawn = SvgBackend::new().render_scene(&self.0);
        let (width, height) = (self.0.width, self.0.height);
        let opening = format!(
            r#"<svg viewBox="0 0 {width} {height}" role="img" stroke-linejoin="round" stroke-linecap="round" "#,
        );
        let spoken = format!(
            "><title>{}</title><desc>{}</desc><metadata>{MARK}</metadata>",
            escape(title),
            escape(description)
        );
        drawn
            .replacen("<svg ", &opening, 1)
            .replacen('>', &spoken, 1)
    }

    /// The drawing as a PNG picture of the given width in pixels.
    #[cfg(feature = "png")]
    pub(super) fn png(&self, width_px: u32) -> Result<Vec<u8>, String> {
        super::picture::png(&self.0, width_px)
    }
}

/// A closed path through the corners, as SVG writes it.
fn outline(corners: &[Place]) -> String {
    let corner = |(i, (x, y)): (usize, &Place)| {
        let command = if i == 0 { 'M' } else { 'L' };
        format!("{command}{x:.2} {y:.2}")
    };
    let mut path: String = corners.iter().enumerate().map(corner).collect();
    path.push('Z');
    path
}

fn color(colour: Colour) -> Color {
    let [red, green, blue] = colour.rgb;
    Color::Rgb(red, green, blue)
}
