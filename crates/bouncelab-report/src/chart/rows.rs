//! The data of a chart as rows of one table, for other drawing programs.

use super::{Chart, Shape};
use crate::data_table::{CellOf, DataTable, Definition, Formulas};
use crate::define_columns;

/// A point, a bar, a piece of a band, a rule or a text of a chart. What does not apply is `None`.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Row {
    /// The panel, from 0.
    pub panel: usize,
    /// Label of the horizontal axis of the panel.
    pub x_axis: String,
    /// Label of the vertical axis of the panel.
    pub y_axis: String,
    /// Name of the layer, as in the legend; may be empty.
    pub layer: String,
    /// What it is: "line", "points", "band", "boxes", "rule", "labels" or "marks".
    pub kind: &'static str,
    /// Horizontal value, or the left end.
    pub x: Option<f64>,
    /// Right end of a box.
    pub x_high: Option<f64>,
    /// Vertical value, or the lower end.
    pub y: Option<f64>,
    /// Upper end of a band or a box.
    pub y_high: Option<f64>,
    /// Standard error of the vertical value.
    pub y_sd: Option<f64>,
    /// A text at a point.
    pub text: Option<String>,
}

impl Chart {
    /// Its data, panel by panel and layer by layer.
    ///
    /// ```
    /// use bouncelab_report::figure::{self, TimedFlight};
    /// use bouncelab_report::messages::Translator;
    ///
    /// let flights = [1, 2, 3].map(|number| TimedFlight { number, time_s: 0.5, used: true });
    /// let chart = figure::flight_times(&flights, None, &Translator::english());
    /// assert_eq!(chart.rows().iter().filter(|row| row.kind == "points").count(), 3);
    /// ```
    pub fn rows(&self) -> Vec<Row> {
        let panels = self.panels.iter().enumerate();
        let layers = panels.flat_map(|at| at.1.layers.iter().map(move |layer| (at, layer)));
        let rows = layers.flat_map(|((index, panel), layer)| {
            rows_of(&layer.shape).into_iter().map(move |row| Row {
                panel: index,
                x_axis: panel.x.label(),
                y_axis: panel.y.label(),
                layer: layer.name.clone(),
                ..row
            })
        });
        rows.collect()
    }

    /// Its [rows](Self::rows) as a table.
    pub fn data(&self) -> DataTable {
        DataTable::of(COLUMNS, self.rows())
    }

    /// Its data as CSV.
    pub fn csv(&self) -> String {
        self.data().csv(Formulas::Guarded)
    }
}

/// The columns of the data of a figure, by whose first ones bouncelab knows that the file is its own.
const COLUMNS: &[Definition<CellOf<Row>>] = define_columns! { |row: Row|
    panel: Count [""] "panel, from 0" = Some(row.panel);
    x_axis: Text [""] "label of the horizontal axis of the panel" = Some(row.x_axis.clone());
    y_axis: Text [""] "label of the vertical axis of the panel" = Some(row.y_axis.clone());
    layer: Text [""] "name in the legend" = Some(row.layer.clone());
    kind: Text [""] "line, points, band, boxes, rule, labels or marks" = Some(row.kind.to_owned());
    x: Number [""] "horizontal value, or left end" = row.x;
    x_high: Number [""] "right end of a box" = row.x_high;
    y: Number [""] "vertical value, or lower end" = row.y;
    y_high: Number [""] "upper end of a band or a box" = row.y_high;
    y_sd: Number [""] "standard error of the vertical value" = row.y_sd;
    text: Text [""] "text at a point" = row.text.clone();
};

fn rows_of(shape: &Shape) -> Vec<Row> {
    let at = |kind, [x, y]: [f64; 2]| Row {
        kind,
        x: Some(x),
        y: Some(y),
        ..Row::default()
    };
    match shape {
        Shape::Line { points, .. } => points.iter().map(|&point| at("line", point)).collect(),
        Shape::Points { points, errors, .. } => {
            let points = points.iter().enumerate();
            let row = |(index, &point)| Row {
                y_sd: errors.get(index).copied(),
                ..at("points", point)
            };
            points.map(row).collect()
        }
        Shape::Band { points } => {
            let row = |&[x, low, high]: &[f64; 3]| Row {
                y_high: Some(high),
                ..at("band", [x, low])
            };
            points.iter().map(row).collect()
        }
        Shape::Boxes { boxes } => {
            let row = |&[left, right, bottom, top]: &[f64; 4]| Row {
                x_high: Some(right),
                y_high: Some(top),
                ..at("boxes", [left, bottom])
            };
            boxes.iter().map(row).collect()
        }
        &Shape::Rule {
            at: position,
            upright,
            ..
        } => vec![Row {
            kind: "rule",
            x: upright.then_some(position),
            y: (!upright).then_some(position),
            ..Row::default()
        }],
        Shape::Labels { points, texts } => {
            let row = |(&point, text): (_, &String)| Row {
                text: Some(text.clone()),
                ..at("labels", point)
            };
            points.iter().zip(texts).map(row).collect()
        }
        Shape::Marks { positions, .. } => {
            let row = |&position: &f64| Row {
                kind: "marks",
                x: Some(position),
                ..Row::default()
            };
            positions.iter().map(row).collect()
        }
    }
}
