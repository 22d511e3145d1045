//! What a chart shows, as data: panels with axes, and layers of lines, points, bands and boxes in the
//! values of those axes.
//!
//! A figure makes a [`Chart`] and draws nothing. [`Chart::svg`] and `Chart::png` draw it; the page
//! draws the same description so that it can be zoomed.

mod nullable;
mod rows;

use serde::{Deserialize, Serialize};

use crate::messages::Translator;
pub use crate::scale::Scale;
use crate::theme::{Colour, Meaning};
pub use rows::Row;

/// A horizontal and a vertical value. One that is not a number, `null` in JSON, interrupts a line and
/// leaves a point out.
pub type Point = [f64; 2];

/// A chart. Without panels there is nothing to show, and the caption states why.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Chart {
    /// The title.
    pub title: String,
    /// One sentence on what it shows.
    pub caption: String,
    /// Relative widths of the columns of panels.
    pub columns: Vec<f64>,
    /// The panels.
    pub panels: Vec<Panel>,
    /// The decimal point of its language.
    pub decimal_separator: char,
}

/// A region with two axes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Panel {
    /// The title above it; may be empty.
    pub title: String,
    /// Its row, from 0 at the top.
    pub row: usize,
    /// Its column, from 0 at the left.
    pub column: usize,
    /// Height of the region that holds the data, in figure pixels; rows of names take more if they
    /// must.
    pub height: f64,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// What it shows, the first layer below all others.
    pub layers: Vec<Layer>,
}

/// An axis.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Axis {
    /// The quantity.
    pub quantity: String,
    /// Its unit; empty for none.
    pub unit: String,
    /// Which values it shows.
    pub scale: Scale,
    /// What of it is drawn.
    pub ticks: Ticks,
    /// Names in place of numbers, one for each row of the height 1, the first on top. What follows a
    /// line break is written below the name.
    pub names: Vec<String>,
}

/// What is drawn of an axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "kebab-case")]
pub enum Ticks {
    /// Grid lines and numbers or names.
    Labelled,
    /// Grid lines only.
    Grid,
    /// Nothing.
    Hidden,
}

/// Something shown in a panel.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Layer {
    /// Its name in the legend; empty if it has none. Layers of the same name share an entry.
    pub name: String,
    /// What it shows, which decides its colour.
    #[cfg_attr(feature = "typescript", ts(type = "string"))]
    pub meaning: Meaning,
    /// How much of the colour is mixed with that of the paper, 0 to 1.
    pub strength: f64,
    /// What is drawn.
    #[serde(flatten)]
    pub shape: Shape,
}

/// What a layer draws.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Shape {
    /// A curve.
    Line {
        /// Its points in the order of drawing.
        #[cfg_attr(feature = "typescript", ts(type = "[number | null, number | null][]"))]
        #[serde(deserialize_with = "nullable::rows")]
        points: Vec<Point>,
        /// Width in figure pixels.
        width: f64,
        /// Its dashes.
        dashes: Dashes,
    },
    /// Single points. One above or below the panel is an arrow head at its edge.
    Points {
        /// Where they lie.
        #[cfg_attr(feature = "typescript", ts(type = "[number | null, number | null][]"))]
        #[serde(deserialize_with = "nullable::rows")]
        points: Vec<Point>,
        /// Standard error of each vertical value; empty if none is known.
        #[cfg_attr(feature = "typescript", ts(type = "(number | null)[]"))]
        #[serde(deserialize_with = "nullable::numbers")]
        errors: Vec<f64>,
        /// How they look.
        marker: Marker,
    },
    /// The region between two curves.
    Band {
        /// Horizontal value, lower and upper vertical one.
        #[cfg_attr(
            feature = "typescript",
            ts(type = "[number | null, number | null, number | null][]")
        )]
        #[serde(deserialize_with = "nullable::rows")]
        points: Vec<[f64; 3]>,
    },
    /// Rectangles: bars, cells and ranges.
    Boxes {
        /// Left, right, bottom and top.
        #[cfg_attr(
            feature = "typescript",
            ts(type = "[number | null, number | null, number | null, number | null][]")
        )]
        #[serde(deserialize_with = "nullable::rows")]
        boxes: Vec<[f64; 4]>,
    },
    /// A line across the panel. An upright one has its name next to it.
    Rule {
        /// Its value.
        #[cfg_attr(feature = "typescript", ts(type = "number | null"))]
        #[serde(deserialize_with = "nullable::number")]
        at: f64,
        /// Whether it is upright, at a horizontal value.
        upright: bool,
        /// Width in figure pixels.
        width: f64,
        /// Its dashes.
        dashes: Dashes,
    },
    /// Texts, which begin a little to the right of their points.
    Labels {
        /// The points.
        #[cfg_attr(feature = "typescript", ts(type = "[number | null, number | null][]"))]
        #[serde(deserialize_with = "nullable::rows")]
        points: Vec<Point>,
        /// A text for each.
        texts: Vec<String>,
    },
    /// Triangles above the panel that mark positions along it, numbered where the numbers fit.
    Marks {
        /// The horizontal values, in ascending order.
        #[cfg_attr(feature = "typescript", ts(type = "(number | null)[]"))]
        #[serde(deserialize_with = "nullable::numbers")]
        positions: Vec<f64>,
        /// The number of each that may be written above it.
        numbers: Vec<u32>,
        /// What may be written above all of them.
        group: String,
        /// Whether they are filled.
        filled: bool,
    },
}

/// How a point looks.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "kebab-case")]
pub enum Marker {
    /// A filled circle.
    Dot,
    /// An open circle.
    Ring,
    /// A filled triangle that points down.
    Triangle,
    /// An open triangle that points down.
    OpenTriangle,
    /// A small dot, one of many; left out where it lies outside.
    Speck,
}

impl Marker {
    /// The marker of a group by its index: with four shapes and seven colours, 28 differ.
    pub(crate) const fn of_group(index: usize) -> Self {
        match index % 4 {
            0 => Self::Dot,
            1 => Self::Triangle,
            2 => Self::Ring,
            _ => Self::OpenTriangle,
        }
    }
}

/// The dashes of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(rename_all = "kebab-case")]
pub enum Dashes {
    /// None.
    Solid,
    /// Short strokes.
    Dashed,
    /// Dots.
    Dotted,
    /// Long strokes.
    Long,
}

impl Chart {
    /// The chart `figure-ID`, with this caption, of panels in one column.
    pub(crate) fn new(
        translator: &Translator,
        id: &str,
        caption: String,
        panels: Vec<Panel>,
    ) -> Self {
        Self {
            title: translator.text(&format!("figure-{id}-title")),
            caption,
            columns: vec![1.0],
            panels,
            decimal_separator: translator.number("0.0").chars().nth(1).unwrap_or('.'),
        }
    }

    /// The same with a panel of the same horizontal axis below; the axis is labelled there only.
    pub(crate) fn with_below(mut self, mut below: Panel) -> Self {
        below.row = self.panels.len();
        if let Some(above) = self.panels.last_mut() {
            above.x.ticks = Ticks::Grid;
        }
        self.panels.push(below);
        self
    }

    /// One without data: its caption states so.
    pub(crate) fn empty(translator: &Translator, id: &str) -> Self {
        let caption = translator.text(&format!("figure-{id}-empty"));
        Self::new(translator, id, caption, Vec::new())
    }
}

impl Panel {
    pub(crate) const fn new(height: f64, x: Axis, y: Axis, layers: Vec<Layer>) -> Self {
        Self {
            title: String::new(),
            row: 0,
            column: 0,
            height,
            x,
            y,
            layers,
        }
    }
}

impl Axis {
    pub(crate) fn new(quantity: String, unit: &str, scale: Scale) -> Self {
        Self {
            quantity,
            unit: unit.to_owned(),
            scale,
            ticks: Ticks::Labelled,
            names: Vec::new(),
        }
    }

    /// A vertical axis of named rows; the middle of the first is [`row_middle`] of 0.
    pub(crate) fn of_names(names: Vec<String>) -> Self {
        let scale = Scale::linear([0.0, names.len() as f64]);
        Self {
            names,
            ..Self::new(String::new(), "", scale)
        }
    }

    pub(crate) fn with_ticks(self, ticks: Ticks) -> Self {
        Self { ticks, ..self }
    }

    /// The quantity with its unit, as in "height (cm)".
    pub fn label(&self) -> String {
        if self.unit.is_empty() {
            self.quantity.clone()
        } else {
            format!("{} ({})", self.quantity, self.unit)
        }
    }
}

/// The middle of a row on an axis of names.
pub(crate) fn row_middle(rows: usize, row: usize) -> f64 {
    rows as f64 - row as f64 - 0.5
}

/// Width of a line that shows data, in figure pixels.
const LINE: f64 = 2.25;

impl Layer {
    pub(crate) fn new(meaning: Meaning, shape: Shape) -> Self {
        Self {
            name: String::new(),
            meaning,
            strength: 1.0,
            shape,
        }
    }

    pub(crate) fn line(meaning: Meaning, points: Vec<Point>) -> Self {
        let (width, dashes) = (LINE, Dashes::Solid);
        Self::new(
            meaning,
            Shape::Line {
                points,
                width,
                dashes,
            },
        )
    }

    pub(crate) fn points(meaning: Meaning, marker: Marker, points: Vec<Point>) -> Self {
        let errors = Vec::new();
        Self::new(
            meaning,
            Shape::Points {
                points,
                errors,
                marker,
            },
        )
    }

    pub(crate) fn band(meaning: Meaning, points: Vec<[f64; 3]>) -> Self {
        Self::new(meaning, Shape::Band { points })
    }

    pub(crate) fn boxes(meaning: Meaning, boxes: Vec<[f64; 4]>) -> Self {
        Self::new(meaning, Shape::Boxes { boxes })
    }

    /// A horizontal line.
    pub(crate) fn level(meaning: Meaning, at: f64) -> Self {
        let (width, dashes) = (LINE, Dashes::Solid);
        Self::new(
            meaning,
            Shape::Rule {
                at,
                upright: false,
                width,
                dashes,
            },
        )
    }

    /// A vertical line with its name next to it.
    pub(crate) fn upright(meaning: Meaning, at: f64, name: String) -> Self {
        let (width, dashes) = (1.5, Dashes::Solid);
        let shape = Shape::Rule {
            at,
            upright: true,
            width,
            dashes,
        };
        Self::new(meaning, shape).named(name)
    }

    pub(crate) fn labels(points: Vec<Point>, texts: Vec<String>) -> Self {
        Self::new(Meaning::Ink, Shape::Labels { points, texts })
    }

    pub(crate) fn named(self, name: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            ..self
        }
    }

    /// Paler than the colour of its meaning.
    pub(crate) fn pale(self, strength: f64) -> Self {
        Self { strength, ..self }
    }

    pub(crate) fn with_width(mut self, new: f64) -> Self {
        if let Shape::Line { width, .. } | Shape::Rule { width, .. } = &mut self.shape {
            *width = new;
        }
        self
    }

    pub(crate) fn with_dashes(mut self, new: Dashes) -> Self {
        if let Shape::Line { dashes, .. } | Shape::Rule { dashes, .. } = &mut self.shape {
            *dashes = new;
        }
        self
    }

    pub(crate) fn with_errors(mut self, new: Vec<f64>) -> Self {
        if let Shape::Points { errors, .. } = &mut self.shape {
            *errors = new;
        }
        self
    }

    pub(crate) fn colour(&self) -> Colour {
        self.meaning.colour().mixed(self.strength)
    }

    /// All positions that should be in sight: its points with the ends of their standard errors.
    fn extremes(&self) -> Vec<Point> {
        match &self.shape {
            Shape::Line { points, .. } | Shape::Labels { points, .. } => points.clone(),
            Shape::Points { points, errors, .. } => {
                let errors = errors.iter().copied().chain(std::iter::repeat(0.0));
                let ends =
                    |(&[x, y], error): (&Point, f64)| [y, y - error, y + error].map(|y| [x, y]);
                points.iter().zip(errors).flat_map(ends).collect()
            }
            Shape::Band { points } => {
                let ends = |&[x, low, high]: &[f64; 3]| [[x, low], [x, high]];
                points.iter().flat_map(ends).collect()
            }
            Shape::Boxes { boxes } => {
                let corners =
                    |&[left, right, bottom, top]: &[f64; 4]| [[left, bottom], [right, top]];
                boxes.iter().flat_map(corners).collect()
            }
            Shape::Rule { .. } | Shape::Marks { .. } => Vec::new(),
        }
    }

    /// The value of a rule across this axis.
    fn rule(&self, is_upright: bool) -> Option<f64> {
        match self.shape {
            Shape::Rule { at, upright, .. } if upright == is_upright => Some(at),
            _ => None,
        }
    }
}

/// The horizontal values of layers, where both values are numbers.
pub(crate) fn xs(layers: &[Layer]) -> impl Iterator<Item = f64> {
    values(layers, 0)
}

/// The vertical values of layers with their standard errors, where both values are numbers.
pub(crate) fn ys(layers: &[Layer]) -> impl Iterator<Item = f64> {
    values(layers, 1)
}

fn values(layers: &[Layer], axis: usize) -> impl Iterator<Item = f64> {
    layers.iter().flat_map(move |layer| {
        let extremes = layer.extremes().into_iter();
        let positions = extremes.filter(|[x, y]| x.is_finite() && y.is_finite());
        let rule = layer.rule(axis == 0).filter(|at| at.is_finite());
        positions.map(move |position| position[axis]).chain(rule)
    })
}
