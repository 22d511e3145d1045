//! A drawing as a PNG picture.

use tiny_skia::{
    Color, FillRule, LineCap, LineJoin, Paint, Path, PathBuilder, Pixmap, Stroke, Transform,
};

use super::canvas::{RIM, Shape};
use super::clip::Place;
use super::font::Fonts;
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
        fonts: Fonts::parse().map_err(|error| error.to_string())?,
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
    fonts: Fonts,
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
                let letters = self.fonts.outline(*place, words, *style);
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
