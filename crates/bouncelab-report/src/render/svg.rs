//! A drawing as SVG that scales with the page and can be read aloud.

use maud::{Markup, html};

use super::canvas::{Anchor, RIM, Shape};
use super::clip::Position;
use super::text::printable;
use crate::mark::MARK;
use crate::theme::{self, Colour};

/// Writes shapes of a width and a height, in figure pixels, with a title and a description for those who
/// cannot see them.
pub(super) fn svg(
    shapes: &[Shape],
    (width, height): Position,
    title: &str,
    description: &str,
) -> String {
    html! {
        svg xmlns="http://www.w3.org/2000/svg" width=(width) height=(height)
            viewBox=(format_args!("0 0 {width} {height}")) role="img"
            stroke-linejoin="round" stroke-linecap="round" font-family=(theme::FONT_FAMILY) fill=(theme::INK) {
            title { (printable(title)) }
            desc { (printable(description)) }
            metadata { (MARK) }
            rect width="100%" height="100%" fill=(theme::PAPER) {}
            @for shape in shapes { (element(shape)) }
        }
    }
    .into_string()
}

fn element(shape: &Shape) -> Markup {
    match shape {
        Shape::Line {
            points,
            colour,
            width,
        } => html! {
            path d=(path(points)) stroke=(colour) stroke-width=(width) fill="none" {}
        },
        Shape::Area { corners, colour } => html! {
            path d=(path(corners) + "Z") fill=(colour) {}
        },
        Shape::Circle {
            centre: (x, y),
            radius,
            fill,
            rim,
        } => html! {
            circle cx=(rounded(*x)) cy=(rounded(*y)) r=(radius) fill=(fill)
                stroke=[rim] stroke-width=[rim.map(|_: Colour| RIM)] {}
        },
        Shape::Text {
            position: (x, y),
            words,
            style,
        } => html! {
            text x=(rounded(*x)) y=(rounded(*y)) font-size=(style.size) text-anchor=(anchor(style.anchor))
                font-weight=[style.bold.then_some("bold")] fill=(style.colour) { (words) }
        },
    }
}

fn anchor(anchor: Anchor) -> &'static str {
    match anchor {
        Anchor::Start => "start",
        Anchor::Middle => "middle",
        Anchor::End => "end",
    }
}

/// The straight lines from each point to the next.
fn path(points: &[Position]) -> String {
    let to = |(index, (x, y)): (usize, &Position)| {
        let letter = if index == 0 { 'M' } else { 'L' };
        format!("{letter}{} {}", rounded(*x), rounded(*y))
    };
    points.iter().enumerate().map(to).collect()
}

/// Hundredths of a pixel are invisible.
fn rounded(position: f64) -> f64 {
    (position * 100.0).round() / 100.0
}
