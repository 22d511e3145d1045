//! A drawing as a PNG picture.

use tiny_skia::{Color, FillRule, LineCap, LineJoin, Paint, Path, Pixmap, Stroke, Transform};

use super::canvas::Shape;
use super::clip::Position;
use super::paths::{Surface, paint};
use crate::mark::MARK;
use crate::theme::{self, Colour};

/// Draws shapes of a width and a height, in figure pixels, as a PNG file of the given width.
pub(super) fn png(
    shapes: &[Shape],
    (width, height): Position,
    width_px: u32,
) -> Result<Vec<u8>, String> {
    let scale = f64::from(width_px) / width;
    let height_px = (height * scale).round() as u32;
    let pixels = Pixmap::new(width_px, height_px).ok_or("there are too many pixels")?;
    let mut picture = Picture {
        pixels,
        scale: Transform::from_scale(scale as f32, scale as f32),
    };
    picture.pixels.fill(color(theme::PAPER));
    paint(shapes, &mut picture)?;
    encode(&picture.pixels).map_err(|error| error.to_string())
}

struct Picture {
    pixels: Pixmap,
    scale: Transform,
}

impl Surface for Picture {
    fn fill(&mut self, path: &Path, colour: Colour) {
        let (paint, rule) = (ink(colour), FillRule::Winding);
        self.pixels.fill_path(path, &paint, rule, self.scale, None);
    }

    fn stroke(&mut self, path: &Path, colour: Colour, width: f64) {
        let stroke = Stroke {
            width: width as f32,
            line_cap: LineCap::Round,
            line_join: LineJoin::Round,
            ..Stroke::default()
        };
        self.pixels
            .stroke_path(path, &ink(colour), &stroke, self.scale, None);
    }
}

fn ink(colour: Colour) -> Paint<'static> {
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
