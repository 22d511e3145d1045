//! A drawing as SVG that scales with the page and can be read aloud.

use kuva::backend::svg::SvgBackend;
use kuva::render::color::Color;
use kuva::render::render::{PathData, Primitive, Scene, TextAnchor, TextSpan};

use super::canvas::{Anchor, RIM, Shape};
use super::clip::Place;
use super::text::escape;
use crate::MARK;
use crate::theme::{self, Colour};

/// Writes shapes of a width and a height, in figure pixels, with a title and a description for those who
/// cannot see them.
pub(super) fn svg(
    shapes: &[Shape],
    (width, height): Place,
    title: &str,
    description: &str,
) -> String {
    let mut scene = Scene::new(width, height);
    scene.background_color = Some(theme::PAPER.to_string());
    scene.text_color = Some(theme::INK.to_string());
    scene.font_family = Some(theme::FONT_FAMILY.to_owned());
    for shape in shapes {
        scene.add(primitive(shape));
    }
    let opening = format!(
        r#"<svg viewBox="0 0 {width} {height}" role="img" stroke-linejoin="round" stroke-linecap="round" "#,
    );
    let spoken = format!(
        "><title>{}</title><desc>{}</desc><metadata>{MARK}</metadata>",
        escape(title),
        escape(description)
    );
    SvgBackend::new()
        .render_scene(&scene)
        .replacen("<svg ", &opening, 1)
        .replacen('>', &spoken, 1)
}

fn primitive(shape: &Shape) -> Primitive {
    match shape {
        Shape::Line {
            points,
            colour,
            width,
        } => Primitive::PolyLine {
            points: points.clone(),
            stroke: color(*colour),
            stroke_width: *width,
            stroke_dasharray: None,
        },
        Shape::Area { corners, colour } => Primitive::Path(Box::new(PathData {
            d: outline(corners),
            fill: Some(color(*colour)),
            stroke: Color::None,
            stroke_width: 0.0,
            opacity: None,
            stroke_dasharray: None,
        })),
        &Shape::Circle {
            centre: (cx, cy),
            radius,
            fill,
            rim,
        } => Primitive::Circle {
            cx,
            cy,
            r: radius,
            fill: color(fill),
            fill_opacity: None,
            stroke: rim.map(color),
            stroke_width: rim.map(|_| RIM),
        },
        Shape::Text {
            place: (x, y),
            words,
            style,
        } => {
            let mut span = TextSpan::plain(words.clone());
            span.bold = style.bold;
            Primitive::RichText {
                x: *x,
                y: *y,
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
