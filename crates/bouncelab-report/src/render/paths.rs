//! Shapes as paths to fill and to stroke, letters too: for formats that are drawn without the fonts of a system.

use tiny_skia::{Path, PathBuilder};

use super::canvas::{RIM, Shape};
use super::clip::Position;
use super::font::Fonts;
use crate::theme::Colour;

/// Areas are drawn wider by half of this on every side: without it, the paper would shine through between two
/// that touch.
const OVERLAP: f64 = 0.6;

/// What is painted on, in figure pixels.
pub(super) trait Surface {
    /// Fills a path.
    fn fill(&mut self, path: &Path, colour: Colour);
    /// Draws along a path, with round ends and corners as those of the SVG.
    fn stroke(&mut self, path: &Path, colour: Colour, width: f64);
}

/// Paints shapes one over the other, with fonts of their own.
pub(super) fn paint(shapes: &[Shape], surface: &mut impl Surface) -> Result<(), String> {
    let fonts = Fonts::parse().map_err(|error| error.to_string())?;
    for shape in shapes {
        // There is no path where there is nothing to draw.
        let _ = paint_shape(shape, &fonts, surface);
    }
    Ok(())
}

fn paint_shape(shape: &Shape, fonts: &Fonts, surface: &mut impl Surface) -> Option<()> {
    match shape {
        Shape::Line {
            points,
            colour,
            width,
        } => surface.stroke(&polyline(points, false)?, *colour, *width),
        Shape::Area { corners, colour } => {
            let area = polyline(corners, true)?;
            surface.stroke(&area, *colour, OVERLAP);
            surface.fill(&area, *colour);
        }
        &Shape::Circle {
            centre: (x, y),
            radius,
            fill,
            rim,
        } => {
            let circle = PathBuilder::from_circle(x as f32, y as f32, radius as f32)?;
            surface.fill(&circle, fill);
            if let Some(colour) = rim {
                surface.stroke(&circle, colour, RIM);
            }
        }
        Shape::Text {
            position,
            words,
            style,
        } => {
            let letters = fonts.outline(*position, words, *style)?;
            surface.fill(&letters, style.colour);
        }
    }
    Some(())
}

/// The path through points; back to the first if it is closed.
fn polyline(points: &[Position], closed: bool) -> Option<Path> {
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
