//! Which law may be true, and what each says.

use super::Figure;
use crate::canvas::{Anchor, Pen, Style};
use crate::scale::Scale;
use crate::shape::Rect;
use crate::sheet::{Panel, Sheet, Swatch};
use crate::theme::{self, Meaning};

const TITLE: &str = "Which law is it?";
/// Two lines of a name have room.
const ROW: f64 = 32.0;

/// A model with its probability and what it says of a quantity.
#[derive(Debug, Clone, PartialEq)]
pub struct ModelWeight {
    /// Its name in a few words.
    pub name: String,
    /// Probability, 0 to 1.
    pub weight: f64,
    /// What it says of the quantity: median and 68 % interval, if it was worked out.
    pub value: Option<(f64, [f64; 2])>,
}

/// Probability of each model as a bar, and beside it what it says of a quantity.
pub fn models(models: &[ModelWeight], quantity: &str) -> Figure {
    let mut usable: Vec<&ModelWeight> = models
        .iter()
        .filter(|model| model.weight.is_finite())
        .collect();
    usable.sort_by(|a, b| b.weight.total_cmp(&a.weight));
    if usable.is_empty() {
        return Figure::empty(200.0, TITLE, "There are no models to compare.");
    }
    let height = 140.0 + ROW * usable.len() as f64;
    let mut sheet = Sheet::new(height, TITLE);
    let top = 72.0;
    let bottom = top + ROW * usable.len() as f64;
    let heading = Style::new(theme::LABEL_SIZE, theme::SOFT_INK, Anchor::Start);
    sheet.canvas.text((230.0, 60.0), "probability", heading);
    let values = usable.iter().filter_map(|model| model.value);
    let ends = values.flat_map(|(value, [low, high])| [value, low, high]);
    let x = Scale::linear(ends).padded(0.08, 0.08);
    let y = Scale::linear([0.0, usable.len() as f64]);
    let frame = Rect {
        left: 410.0,
        top,
        right: 616.0,
        bottom,
    };
    let panel = Panel::inset(&mut sheet.canvas, frame, [x, y], [Some(quantity), None]);
    for (row, model) in usable.iter().enumerate() {
        let middle = top + ROW * (row as f64 + 0.5);
        name_and_bar(&mut sheet, middle, model);
        if let Some((value, [low, high])) = model.value {
            let place = usable.len() as f64 - row as f64 - 0.5;
            let colour = Meaning::Measured.colour();
            let whisker = [(low, place), (high, place)];
            panel.curve(
                &mut sheet.canvas,
                &whisker,
                Pen::solid(colour.mixed(0.4), 5.0),
            );
            panel.point(&mut sheet.canvas, (value, place), Swatch::Dot(colour));
        }
    }
    Figure::new(
        sheet,
        "The longer the bar, the more probable the law; where no bar wins, the answer is an average \
         over all of them.",
    )
}

fn name_and_bar(sheet: &mut Sheet, middle: f64, model: &ModelWeight) {
    const LEFT: f64 = 230.0;
    const LENGTH: f64 = 110.0;
    let style = Style::new(theme::TICK_SIZE, theme::INK, Anchor::Start);
    let place = (16.0, middle + 4.5);
    let name = model.name.as_str();
    sheet.canvas.text_wrapped(LEFT - 26.0, place, name, style);
    let bar = Rect {
        left: LEFT,
        top: middle - 8.0,
        right: LEFT + LENGTH * model.weight.clamp(0.0, 1.0),
        bottom: middle + 8.0,
    };
    sheet.canvas.block(bar, Meaning::Drag.colour());
    let text = format!("{:.1} %", model.weight * 100.0);
    let place = (bar.right + 6.0, middle + 4.5);
    sheet.canvas.text(place, text, style);
}
