//! A drawing as a PNG picture.

use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, Stroke, Transform,
};
use ttf_parser::{Face, GlyphId, OutlineBuilder};

use super::canvas::{Anchor, RIM, Shape, Style};
use super::clip::Place;
use crate::MARK;
use crate::theme::{self, Colour};

/// Areas are drawn wider by half of this on every side: without it, the paper would shine through between two
/// that touch.
const OVERLAP: f64 = 0.6;

/// Draws shapes of a width and a height, in figure pixels, as a PNG file of the given width.
pub(super) fn png(
    shapes: &[Shape],
    (width, height): Place,
    width_px: u32,
) -> Result<Vec<u8>, String> {
    let scale = f64::from(width_px) / width;
    let height_px = (height * scale).round() as u32;
    let pixels = Pixmap::new(width_px, height_px).ok_or("there are too many pixels")?;
    let mut picture = Picture {
        pixels,
        scale: Transform::from_scale(scale as f32, scale as f32),
        font: Face::parse(dejavu::sans::regular(), 0).map_err(|error| error.to_string())?,
    };
    picture.pixels.fill(color(theme::PAPER));
    for shape in shapes {
        picture.draw(shape);
    }
    encode(&picture.pixels).map_err(|error| error.to_string())
}

struct Picture {
    pixels: Pixmap,
    scale: Transform,
    /// One of its own, since a picture needs none of the system.
    font: Face<'static>,
}

impl Picture {
    fn draw(&mut self, shape: &Shape) {
        match shape {
            Shape::Line {
                points,
                colour,
                width,
            } => self.stroke(polyline(points, false), *colour, *width),
            Shape::Area { corners, colour } => {
                let area = polyline(corners, true);
                self.stroke(area.clone(), *colour, OVERLAP);
                self.fill(area, *colour);
            }
            &Shape::Circle {
                centre: (x, y),
                radius,
                fill,
                rim,
            } => {
                let circle = || PathBuilder::from_circle(x as f32, y as f32, radius as f32);
                self.fill(circle(), fill);
                if let Some(colour) = rim {
                    self.stroke(circle(), colour, RIM);
                }
            }
            Shape::Text {
                place,
                words,
                style,
            } => {
                let letters = outline(&self.font, *place, words, *style);
                if style.bold {
                    self.stroke(letters.clone(), style.colour, thicker(*style));
                }
                self.fill(letters, style.colour);
            }
        }
    }

    /// Fills a path, if it holds anything.
    fn fill(&mut self, path: Option<Path>, colour: Colour) {
        if let Some(path) = path {
            let (paint, rule) = (paint(colour), FillRule::Winding);
            self.pixels.fill_path(&path, &paint, rule, self.scale, None);
        }
    }

    /// Strokes a path, if it holds anything, with ends and corners as those of the SVG.
    fn stroke(&mut self, path: Option<Path>, colour: Colour, width: f64) {
        let stroke = Stroke {
            width: width as f32,
            line_cap: LineCap::Round,
            line_join: LineJoin::Round,
            ..Stroke::default()
        };
        if let Some(path) = path {
            let paint = paint(colour);
            self.pixels
                .stroke_path(&path, &paint, &stroke, self.scale, None);
        }
    }
}

/// The path through points; back to the first if it is closed.
fn polyline(points: &[Place], closed: bool) -> Option<Path> {
    let mut path = PathBuilder::new();
    let (&(x, y), others) = points.split_first()?;
    path.move_to(x as f32, y as f32);
    for &(x, y) in others {
        path.line_to(x as f32, y as f32);
    }
    if closed {
        path.close();
    }
    path.finish()
}

/// The letters of a text.
fn outline(font: &Face, (x, y): Place, words: &str, style: Style) -> Option<Path> {
    let scale = f64::from(style.size) / f64::from(font.units_per_em());
    // A letter that the font lacks is shown as its sign for that, which is the first.
    let glyphs = words
        .chars()
        .map(|letter| font.glyph_index(letter).unwrap_or(GlyphId(0)));
    let advance = |glyph| {
        let own = f64::from(font.glyph_hor_advance(glyph).unwrap_or(0));
        scale * own + thicker(style)
    };
    let before = match style.anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => 0.5,
        Anchor::End => 1.0,
    };
    let width: f64 = glyphs.clone().map(advance).sum();
    let mut letters = Letters {
        path: PathBuilder::new(),
        origin: ((x - before * width) as f32, y as f32),
        scale: scale as f32,
    };
    for glyph in glyphs {
        font.outline_glyph(glyph, &mut letters);
        letters.origin.0 += advance(glyph) as f32;
    }
    letters.path.finish()
}

/// By how much the strokes of letters are thicker than those of the font, which has none that are bold: one
/// that has would be as large again.
fn thicker(style: Style) -> f64 {
    let share = if style.bold { 0.05 } else { 0.0 };
    share * f64::from(style.size)
}

/// Outlines of letters, in the units of a font with its vertical axis upwards, as a path.
struct Letters {
    path: PathBuilder,
    origin: (f32, f32),
    scale: f32,
}

impl Letters {
    fn at(&self, x: f32, y: f32) -> (f32, f32) {
        (
            self.origin.0 + self.scale * x,
            self.origin.1 - self.scale * y,
        )
    }
}

impl OutlineBuilder for Letters {
    fn move_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.path.move_to(x, y);
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let (x, y) = self.at(x, y);
        self.path.line_to(x, y);
    }

    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        let ((x1, y1), (x, y)) = (self.at(x1, y1), self.at(x, y));
        self.path.quad_to(x1, y1, x, y);
    }

    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        let ((x1, y1), (x2, y2)) = (self.at(x1, y1), self.at(x2, y2));
        let (x, y) = self.at(x, y);
        self.path.cubic_to(x1, y1, x2, y2, x, y);
    }

    fn close(&mut self) {
        self.path.close();
    }
}

fn paint(colour: Colour) -> Paint<'static> {
    let mut paint = Paint::default();
    paint.set_color(color(colour));
    paint
}

fn color(colour: Colour) -> Color {
    let [red, green, blue] = colour.rgb;
    Color::from_rgba8(red, green, blue, u8::MAX)
}

/// The file; every pixel is opaque.
fn encode(pixels: &Pixmap) -> Result<Vec<u8>, png::EncodingError> {
    let (rgba, _) = pixels.data().as_chunks::<4>();
    let rgb: Vec<[u8; 3]> = rgba
        .iter()
        .map(|&[red, green, blue, _]| [red, green, blue])
        .collect();
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(&mut file, pixels.width(), pixels.height());
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.add_text_chunk("Software".to_owned(), MARK.to_owned())?;
    let mut writer = encoder.write_header()?;
    writer.write_image_data(rgb.as_flattened())?;
    writer.finish()?;
    Ok(file)
}
