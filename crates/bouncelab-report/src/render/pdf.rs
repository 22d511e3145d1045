//! A drawing as a PDF of one page, for papers and slides.

use miniz_oxide::deflate::compress_to_vec_zlib;
use pdf_writer::types::{LineCapStyle, LineJoinStyle};
use pdf_writer::{Content, Filter, Pdf, Rect, Ref, TextStr};
use tiny_skia::{Path, PathSegment, Point};

use super::canvas::Shape;
use super::clip::Position;
use super::paths::{Surface, paint};
use crate::mark::MARK;
use crate::theme::Colour;

/// Points of a PDF in a figure pixel, as on a page of HTML.
const POINTS: f32 = 0.75;
/// How thoroughly drawings are compressed, of 10.
const EFFORT: u8 = 6;

/// Draws shapes of a width and a height, in figure pixels, as a page of that size.
pub(super) fn pdf(
    shapes: &[Shape],
    (width, height): Position,
    title: &str,
) -> Result<Vec<u8>, String> {
    let (width, height) = (POINTS * width as f32, POINTS * height as f32);
    let mut drawing = Drawing(Content::new());
    let content = &mut drawing.0;
    // Here the vertical axis points upwards.
    content.transform([POINTS, 0.0, 0.0, -POINTS, 0.0, height]);
    content.set_line_cap(LineCapStyle::RoundCap);
    content.set_line_join(LineJoinStyle::RoundJoin);
    paint(shapes, &mut drawing)?;
    let content = compress_to_vec_zlib(&drawing.0.finish(), EFFORT);

    let [catalog, pages, page, stream, about] = [1, 2, 3, 4, 5].map(Ref::new);
    let mut pdf = Pdf::new();
    pdf.catalog(catalog).pages(pages);
    pdf.pages(pages).kids([page]).count(1);
    let mut only = pdf.page(page);
    only.media_box(Rect::new(0.0, 0.0, width, height));
    only.parent(pages).contents(stream).resources();
    drop(only);
    let mut written = pdf.stream(stream, &content);
    written.filter(Filter::FlateDecode);
    drop(written);
    let mut info = pdf.document_info(about);
    info.title(TextStr(title)).producer(TextStr(MARK));
    drop(info);
    Ok(pdf.finish())
}

/// The operators of a page.
struct Drawing(Content);

impl Drawing {
    fn add(&mut self, path: &Path) {
        let mut last = Point::zero();
        for segment in path.segments() {
            match segment {
                PathSegment::MoveTo(to) => {
                    self.0.move_to(rounded(to.x), rounded(to.y));
                    last = to;
                }
                PathSegment::LineTo(to) => {
                    self.0.line_to(rounded(to.x), rounded(to.y));
                    last = to;
                }
                PathSegment::QuadTo(bend, to) => {
                    // A PDF has cubic curves only.
                    self.cubic(towards(last, bend), towards(to, bend), to);
                    last = to;
                }
                PathSegment::CubicTo(first, second, to) => {
                    self.cubic(first, second, to);
                    last = to;
                }
                PathSegment::Close => {
                    self.0.close_path();
                }
            }
        }
    }

    fn cubic(&mut self, first: Point, second: Point, to: Point) {
        let [a, b, c, d, e, f] = [first.x, first.y, second.x, second.y, to.x, to.y].map(rounded);
        self.0.cubic_to(a, b, c, d, e, f);
    }
}

impl Surface for Drawing {
    fn fill(&mut self, path: &Path, colour: Colour) {
        let [red, green, blue] = shares(colour);
        self.0.set_fill_rgb(red, green, blue);
        self.add(path);
        self.0.fill_nonzero();
    }

    fn stroke(&mut self, path: &Path, colour: Colour, width: f64) {
        let [red, green, blue] = shares(colour);
        self.0.set_stroke_rgb(red, green, blue);
        self.0.set_line_width(width as f32);
        self.add(path);
        self.0.stroke();
    }
}

/// Two thirds of the way from the end of a quadratic curve to its bend: there a cubic one bends the same.
fn towards(end: Point, bend: Point) -> Point {
    let part = |end: f32, bend: f32| end + (bend - end) * 2.0 / 3.0;
    Point::from_xy(part(end.x, bend.x), part(end.y, bend.y))
}

fn shares(colour: Colour) -> [f32; 3] {
    colour.rgb.map(|part| f32::from(part) / 255.0)
}

/// A drawing is printed at any size, so finer than that of a screen, but not to the last bit.
fn rounded(position: f32) -> f32 {
    (position * 1000.0).round() / 1000.0
}
