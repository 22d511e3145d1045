//! The probability of each law, and its result.

use bouncelab::inference::Posterior;

use crate::chart::{Axis, Chart, Layer, Marker, Panel, Scale, Ticks, row_middle, ys};
use crate::messages::Translator;
use crate::tables::restitution_law;
use crate::theme::Meaning;

/// Height of a row.
const ROW: f64 = 32.0;

/// Probability of each model as a bar, and next to it the drop height by that model.
pub(super) fn models(posterior: &Posterior, translator: &Translator) -> Chart {
    let text = |id: &str| translator.text(&format!("figure-models-{id}"));
    let models = &posterior.models;
    let (rows, height) = (models.len(), ROW * models.len() as f64);
    let (mut bars, mut ends, mut shares) = (Vec::new(), Vec::new(), Vec::new());
    let (mut intervals, mut values) = (Vec::new(), Vec::new());
    for (row, model) in models.iter().enumerate() {
        let middle = row_middle(rows, row);
        let percent = 100.0 * model.probability;
        bars.push([0.0, percent, middle - 0.25, middle + 0.25]);
        ends.push([percent, middle]);
        shares.push(translator.number(&format!("{percent:.1}\u{a0}%")));
        if let Some(height) = &model.drop_height_m {
            let [low, high] = height.interval68.map(|end| 100.0 * end);
            intervals.extend([[low, middle], [high, middle], [f64::NAN; 2]]);
            values.push([100.0 * height.value, middle]);
        }
    }
    let names = models.iter().map(|model| {
        let law = restitution_law(model.restitution_law, translator);
        let ball = model.ball.map(|kind| translator.named("ball", kind));
        ball.map_or_else(|| law.clone(), |ball| format!("{law}, {ball}"))
    });
    let names = Axis::of_names(names.collect());
    // A margin for the share to the right of the longest bar.
    let probability = Axis::new(text("probability"), "%", Scale::linear([0.0, 160.0]));
    let heights = Scale::linear(intervals.iter().map(|p| p[0])).padded(0.08, 0.08);
    let heights = Axis::new(translator.text("axis-drop-height"), "cm", heights);
    let left = Panel::new(
        height,
        probability.with_ticks(Ticks::Hidden),
        names.clone(),
        vec![
            Layer::boxes(Meaning::Drag, bars).named(text("probability")),
            Layer::labels(ends, shares),
        ],
    );
    let interval = Layer::line(Meaning::Measured, intervals).with_width(5.0);
    let mut right = Panel::new(
        height,
        heights,
        names.with_ticks(Ticks::Hidden),
        vec![
            interval.pale(0.4).named(text("interval")),
            Layer::points(Meaning::Measured, Marker::Dot, values),
        ],
    );
    right.column = 1;
    right.y.names.clear();
    let mut panels = vec![left];
    if ys(&right.layers).next().is_some() {
        panels.push(right);
    }
    let mut chart = Chart::new(translator, "models", text("caption"), panels);
    chart.columns = vec![0.45, 0.55];
    chart
}
