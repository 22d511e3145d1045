//! Where ink goes.
//!
//! The only room that knows the drawing library. It adds what the library leaves out: points
//! that are not numbers are skipped instead of drawn, dashes run on across the points of a
//! curve (the library starts them anew at each point when it makes a PNG), and the SVG
//! scales with the page and can be read aloud.
//!
//! What is drawn is kept as a list until a picture is asked for, so that its words can be said in
//! another language.

use std::borrow::Cow;

use kuva::backend::svg::SvgBackend;
use kuva::render::color::Color;
use kuva::render::render::{PathData, Primitive, Scene, TextAnchor, TextSpan};

use crate::language::{Say, said};
use crate::shape::{Dash, Point, Rect, dashes, is_finite, within};
use crate::theme::{self, Colour};

/// How a line looks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Pen {
    pub(crate) colour: Colour,
    pub(crate) width: f64,
    pub(crate) dash: Option<Dash>,
}

impl Pen {
    pub(crate) const fn solid(colour: Colour, width: f64) -> Self {
        Self {
            colour,
            width,
            dash: None,
        }
    }

    /// The same with strokes and gaps of these lengths.
    pub(crate) const fn dashed(self, stroke: f64, gap: f64) -> Self {
        Self {
            dash: Some(Dash { stroke, gap }),
            ..self
        }
    }
}

/// Which part of a text lies at its place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

/// How a text looks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Style {
    pub(crate) size: u32,
    pub(crate) colour: Colour,
    pub(crate) anchor: Anchor,
    pub(crate) bold: bool,
}

impl Style {
    pub(crate) const fn new(size: u32, colour: Colour, anchor: Anchor) -> Self {
        Self {
            size,
            colour,
            anchor,
            bold: false,
        }
    }
}

/// Something drawn.
#[derive(Debug, Clone)]
enum Ink {
    Stroke {
        points: Vec<Point>,
        pen: Pen,
    },
    Area {
        corners: Vec<Point>,
        colour: Colour,
    },
    Circle {
        centre: Point,
        radius: f64,
        fill: Colour,
        edge: Option<Colour>,
    },
    Text {
        place: Point,
        words: String,
        style: Style,
        /// A text that is wider goes on in another line.
        room: f64,
        /// What does not fit into so many lines is left out.
        lines: usize,
    },
}

/// A sheet being drawn on.
#[derive(Debug)]
pub(crate) struct Canvas {
    width: f64,
    height: f64,
    ink: Vec<Ink>,
}

impl Canvas {
    pub(crate) fn new(width: f64, height: f64) -> Self {
        Self {
            width,
            height,
            ink: Vec::new(),
        }
    }

    pub(crate) fn width(&self) -> f64 {
        self.width
    }

    pub(crate) fn height(&self) -> f64 {
        self.height
    }

    /// Says every text on it in another language.
    pub(crate) fn translate(&mut self, say: &mut Say<'_>) {
        for ink in &mut self.ink {
            if let Ink::Text { words, .. } = ink {
                said(words, say);
            }
        }
    }

    /// Draws all of another sheet, so far below where it was there.
    pub(crate) fn take(&mut self, other: &Self, below: f64) {
        let moved = other.ink.iter().map(|ink| ink.moved(below));
        self.ink.extend(moved);
    }

    /// A curve through the points; it is interrupted where a point is not a number.
    pub(crate) fn polyline(&mut self, points: &[Point], pen: Pen) {
        for run in points.split(|&point| !is_finite(point)) {
            match pen.dash {
                None => self.stroke(run.to_vec(), pen),
                Some(dash) => {
                    for piece in dashes(run, dash) {
                        self.stroke(piece, pen);
                    }
                }
            }
        }
    }

    /// The same, without the parts outside `rect`.
    pub(crate) fn polyline_within(&mut self, rect: Rect, points: &[Point], pen: Pen) {
        for run in points.split(|&point| !is_finite(point)) {
            for piece in within(rect, run) {
                self.polyline(&piece, pen);
            }
        }
    }

    pub(crate) fn line(&mut self, from: Point, to: Point, pen: Pen) {
        self.polyline(&[from, to], pen);
    }

    fn stroke(&mut self, points: Vec<Point>, pen: Pen) {
        if points.len() < 2 {
            return;
        }
        self.ink.push(Ink::Stroke { points, pen });
    }

    /// A filled shape; nothing if a corner is not a number.
    pub(crate) fn area(&mut self, corners: &[Point], colour: Colour) {
        if corners.len() < 3 || !corners.iter().copied().all(is_finite) {
            return;
        }
        let corners = corners.to_vec();
        self.ink.push(Ink::Area { corners, colour });
    }

    /// A filled rectangle.
    pub(crate) fn block(&mut self, rect: Rect, colour: Colour) {
        let Rect {
            left,
            top,
            right,
            bottom,
        } = rect;
        let corners = [(left, top), (right, top), (right, bottom), (left, bottom)];
        self.area(&corners, colour);
    }

    /// A filled circle.
    pub(crate) fn dot(&mut self, (cx, cy): Point, r: f64, colour: Colour) {
        self.circle((cx, cy), r, colour, None);
    }

    /// An open circle, white inside so that lines do not run through it.
    pub(crate) fn ring(&mut self, (cx, cy): Point, r: f64, colour: Colour) {
        self.circle((cx, cy), r, theme::PAPER, Some(colour));
    }

    fn circle(&mut self, centre: Point, radius: f64, fill: Colour, edge: Option<Colour>) {
        if is_finite(centre) {
            self.ink.push(Ink::Circle {
                centre,
                radius,
                fill,
                edge,
            });
        }
    }

    pub(crate) fn text(&mut self, place: Point, words: impl Into<String>, style: Style) {
        self.text_in((f64::INFINITY, 1), place, words, style);
    }

    /// A text that is shortened if it is wider than `room` figure pixels.
    pub(crate) fn text_within(
        &mut self,
        room: f64,
        place: Point,
        words: impl Into<String>,
        style: Style,
    ) {
        self.text_in((room, 1), place, words, style);
    }

    /// A text that is broken into lines if it is wider than `room` figure pixels. Where one line would
    /// stand is the middle of them.
    pub(crate) fn text_wrapped(
        &mut self,
        room: f64,
        place: Point,
        words: impl Into<String>,
        style: Style,
    ) {
        self.text_in((room, MOST_LINES), place, words, style);
    }

    fn text_in(
        &mut self,
        (room, lines): (f64, usize),
        place: Point,
        words: impl Into<String>,
        style: Style,
    ) {
        if is_finite(place) {
            self.ink.push(Ink::Text {
                place,
                words: words.into(),
                style,
                room,
                lines,
            });
        }
    }

    fn scene(&self) -> Scene {
        let mut scene = Scene::new(self.width, self.height);
        scene.background_color = Some(theme::PAPER.to_string());
        scene.text_color = Some(theme::INK.to_string());
        scene.font_family = Some(theme::FONT_FAMILY.to_owned());
        for ink in &self.ink {
            for primitive in ink.primitives() {
                scene.add(primitive);
            }
        }
        scene
    }

    /// The drawing as SVG that scales with its container, with a title and a description for
    /// those who cannot see it.
    pub(crate) fn svg(&self, title: &str, description: &str) -> String {
        let drawn = SvgBackend::new().render_scene(&self.scene());
        let opening = format!(
            r#"<svg viewBox="0 0 {} {}" role="img" stroke-linejoin="round" stroke-linecap="round" "#,
            self.width(),
            self.height()
        );
        let spoken = format!(
            "><title>{}</title><desc>{}</desc>",
            escape(title),
            escape(description)
        );
        drawn
            .replacen("<svg ", &opening, 1)
            .replacen('>', &spoken, 1)
    }

    /// The drawing as a PNG picture of the given width in pixels.
    #[cfg(feature = "png")]
    pub(crate) fn png(&self, width_px: u32) -> std::result::Result<Vec<u8>, String> {
        crate::picture::png(&self.scene(), width_px)
    }
}

impl Ink {
    fn moved(&self, below: f64) -> Self {
        let down = |&(x, y): &Point| (x, y + below);
        let mut moved = self.clone();
        match &mut moved {
            Self::Stroke { points, .. }
            | Self::Area {
                corners: points, ..
            } => {
                *points = points.iter().map(down).collect();
            }
            Self::Circle { centre: place, .. } | Self::Text { place, .. } => *place = down(place),
        }
        moved
    }

    /// The same for the drawing library.
    fn primitives(&self) -> Vec<Primitive> {
        let primitive = match self {
            Self::Stroke { points, pen } => Primitive::PolyLine {
                points: points.clone(),
                stroke: color(pen.colour),
                stroke_width: pen.width,
                stroke_dasharray: None,
            },
            Self::Area { corners, colour } => Primitive::Path(Box::new(PathData {
                d: outline(corners),
                fill: Some(color(*colour)),
                stroke: Color::None,
                stroke_width: 0.0,
                opacity: None,
                stroke_dasharray: None,
            })),
            Self::Circle {
                centre: (cx, cy),
                radius,
                fill,
                edge,
            } => Primitive::Circle {
                cx: *cx,
                cy: *cy,
                r: *radius,
                fill: color(*fill),
                fill_opacity: None,
                stroke: edge.map(color),
                stroke_width: edge.map(|_| 1.5),
            },
            Self::Text {
                place,
                words,
                style,
                room,
                lines,
            } => {
                let lines = wrapped(words, style.size, *room, *lines);
                let (x, mut y) = *place;
                let height = line_height(style.size);
                y -= height * (lines.len() - 1) as f64 / 2.0;
                let place_of = |line: usize| (x, y + height * line as f64);
                let lines = lines.iter().enumerate();
                return lines
                    .map(|(line, words)| text(place_of(line), words, *style))
                    .collect();
            }
        };
        vec![primitive]
    }
}

fn text((x, y): Point, words: &str, style: Style) -> Primitive {
    let mut span = TextSpan::plain(printable(words));
    span.bold = style.bold;
    Primitive::RichText {
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
    }
}

/// A closed path through the corners, as SVG writes it.
fn outline(corners: &[Point]) -> String {
    let corner = |(i, (x, y)): (usize, &Point)| {
        let command = if i == 0 { 'M' } else { 'L' };
        format!("{command}{x:.2} {y:.2}")
    };
    let mut path: String = corners.iter().enumerate().map(corner).collect();
    path.push('Z');
    path
}

const SOFT_HYPHEN: char = '\u{ad}';

/// Width of a text in figure pixels, rather too wide than too narrow: by the classes of
/// letters of `DejaVu Sans`, which is wider than the fonts of most systems.
pub(crate) fn text_width(text: &str, size: u32) -> f64 {
    let em: f64 = text.chars().map(letter_width).sum();
    em * f64::from(size)
}

fn letter_width(letter: char) -> f64 {
    match letter {
        SOFT_HYPHEN => 0.0,
        ' ' | '.' | ',' | 'i' | 'j' | 'l' | 'I' | '\'' => 0.32,
        'f' | 't' | 'r' | '(' | ')' | '-' | '/' | ':' | ';' | '|' | '!' => 0.42,
        'w' | '=' | '+' | '<' | '>' | '±' | '×' | '−' | '≈' => 0.84,
        'm' | 'M' | 'W' | '%' | '@' => 1.0,
        'A'..='Z' => 0.79,
        '⁰'..='⁹' | '⁻' | '¹' | '²' | '³' => 0.5,
        _ if (letter as u32) < 0x80 => 0.64,
        _ if (letter as u32) < 0x0250 => 0.75,
        _ => 1.1,
    }
}

/// Names of more lines than this are left out in part.
pub(crate) const MOST_LINES: usize = 4;

/// From line to line, in figure pixels.
pub(crate) fn line_height(size: u32) -> f64 {
    1.15 * f64::from(size)
}

/// The text in lines no wider than `width` figure pixels, at least one and at most so many: broken
/// between words where that goes, within one where not, and shortened where even that is too long.
pub(crate) fn wrapped(text: &str, size: u32, width: f64, most: usize) -> Vec<Cow<'_, str>> {
    let mut lines = Vec::new();
    let mut rest = text.trim();
    while lines.len() + 1 < most && text_width(rest, size) > width {
        let Some(end) = line_end(rest, size, width) else {
            break;
        };
        let (line, following) = rest.split_at(end);
        lines.push(Cow::Borrowed(line.trim_end()));
        rest = following.trim_start();
    }
    lines.push(shortened(rest, size, width));
    lines
}

/// Where the first line of a text that is too wide ends; `None` if not even a letter fits.
fn line_end(text: &str, size: u32, width: f64) -> Option<usize> {
    let fits = |&end: &usize| text_width(text[..end].trim_end(), size) <= width;
    let ends = text.char_indices().map(|(end, _)| end).skip(1);
    let ends: Vec<usize> = ends.take_while(fits).collect();
    let after = |signs: &[char]| {
        let is_after = |end: &&usize| text[..**end].ends_with(signs);
        ends.iter().rfind(is_after)
    };
    let end = after(&[' ']).or_else(|| after(&['-', '_', '/']));
    end.or(ends.last()).copied()
}

/// The text, shortened with an ellipsis if it is wider than `width` figure pixels.
fn shortened(text: &str, size: u32, width: f64) -> Cow<'_, str> {
    if text_width(text, size) <= width {
        return Cow::Borrowed(text);
    }
    let mut short = String::new();
    for letter in text.chars() {
        if text_width(&short, size) + f64::from(size) * (letter_width(letter) + 1.1) > width {
            break;
        }
        short.push(letter);
    }
    short.truncate(short.trim_end().len());
    short.push('…');
    Cow::Owned(short)
}

fn color(colour: Colour) -> Color {
    let [red, green, blue] = colour.rgb;
    Color::Rgb(red, green, blue)
}

/// Without the control characters that XML forbids, nor hyphens for the end of a line: a drawing
/// breaks none.
fn printable(text: &str) -> String {
    text.chars()
        .filter(|&c| c != SOFT_HYPHEN)
        .map(|c| if c.is_control() { ' ' } else { c })
        .collect()
}

fn escape(text: &str) -> String {
    printable(text)
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_that_are_not_numbers_interrupt_a_curve() {
        let mut canvas = Canvas::new(100.0, 100.0);
        let nan = (f64::NAN, 1.0);
        canvas.polyline(
            &[(0.0, 0.0), (1.0, 1.0), nan, (2.0, 2.0), (3.0, 3.0), nan],
            Pen::solid(theme::INK, 1.0),
        );
        let svg = canvas.svg("", "");
        assert_eq!(svg.matches("<path").count(), 2);
        assert!(!svg.contains("NaN"));
    }

    #[test]
    fn shortened_texts_fit() {
        let text = "a rather long name of a curve";
        let short = shortened(text, 14, 100.0);
        assert!(
            short.ends_with('…') && text_width(&short, 14) <= 100.0,
            "{short}"
        );
        assert_eq!(shortened(text, 14, 1000.0), text);
    }

    #[test]
    fn long_texts_are_broken_between_words_and_nothing_is_lost() {
        let text = "blue ball of the school, old-gymnasium";
        for width in [60.0, 100.0, 150.0, 1000.0] {
            let lines = wrapped(text, 13, width, 20);
            assert!(lines.iter().all(|line| text_width(line, 13) <= width));
            let letters = |text: &str| text.replace(' ', "");
            assert_eq!(letters(&lines.concat()), letters(text), "{width}");
        }
        assert_eq!(
            wrapped(text, 13, 150.0, 4),
            ["blue ball of the", "school,", "old-gymnasium"]
        );
    }

    #[test]
    fn what_has_no_words_is_broken_anywhere_and_shortened_at_last() {
        let text = "a".repeat(60);
        let lines = wrapped(&text, 13, 100.0, 3);
        assert_eq!(lines.len(), 3);
        assert!(lines[2].ends_with('…'), "{lines:?}");
        assert_eq!(wrapped("one-two-three", 13, 70.0, 3), ["one-two-", "three"]);
        assert_eq!(wrapped(&text, 13, 0.0, 3).len(), 1);
        assert_eq!(wrapped("", 13, 10.0, 3), [""]);
    }
}
