//! Comparison of single drops.

use crate::chart::{Axis, Chart, Layer, Marker, Panel, Point, Scale, xs, ys};
use crate::messages::Translator;
use crate::theme::Meaning;

/// More drops cannot be distinguished by eye.
const MAX_DROPS: usize = 6;

/// A drop in the figure.
#[derive(Debug, Clone, PartialEq)]
pub struct DropSummary {
    /// Name, as in the legend.
    pub name: String,
    /// Restitution with its standard deviation, which is NaN if it is unknown.
    pub restitution: Option<(f64, f64)>,
    /// Speed in m/s and restitution of each impact.
    pub impacts: Vec<Point>,
}

/// The restitution of each drop, in their order.
pub fn drops(drops: &[DropSummary], translator: &Translator) -> Chart {
    let numbered = (1..).map(f64::from).zip(drops);
    let known = numbered.filter_map(|(number, drop)| Some((number, drop.restitution?)));
    let (points, errors) = known
        .map(|(number, (value, sd))| ([number, value], sd))
        .unzip();
    let points = Layer::points(Meaning::Measured, Marker::Dot, points).with_errors(errors);
    let layers = vec![points];
    if ys(&layers).next().is_none() {
        return Chart::empty(translator, "drops");
    }
    let numbers = [0.5, drops.len() as f64 + 0.5];
    let x = Axis::new(translator.text("axis-drop"), "", Scale::counting(numbers));
    let y = restitution_axis(&layers, translator);
    let caption = translator.text("figure-drops-caption");
    Chart::new(
        translator,
        "drops",
        caption,
        vec![Panel::new(200.0, x, y, layers)],
    )
}

/// Restitution against impact speed of the last drops.
pub fn drop_impacts(drops: &[DropSummary], translator: &Translator) -> Chart {
    let id = "drop-impacts";
    let shown = &drops[drops.len().saturating_sub(MAX_DROPS)..];
    let layers = shown.iter().enumerate().map(|(index, drop)| {
        let (meaning, marker) = (Meaning::Group(index), Marker::of_group(index));
        Layer::points(meaning, marker, drop.impacts.clone()).named(&*drop.name)
    });
    let layers: Vec<Layer> = layers.collect();
    if ys(&layers).next().is_none() {
        return Chart::empty(translator, id);
    }
    let speeds = Scale::linear(xs(&layers).chain([0.0])).padded(0.0, 0.04);
    let x = Axis::new(translator.text("axis-impact-speed"), "m/s", speeds);
    let y = restitution_axis(&layers, translator);
    let mut caption = translator.text("figure-drop-impacts-caption");
    if shown.len() < drops.len() {
        let counts = [("shown", shown.len().into()), ("all", drops.len().into())];
        caption.push(' ');
        caption.push_str(&translator.text_with("figure-drop-impacts-more", &counts));
    }
    Chart::new(
        translator,
        id,
        caption,
        vec![Panel::new(200.0, x, y, layers)],
    )
}

/// An axis on which noise does not look large.
fn restitution_axis(layers: &[Layer], translator: &Translator) -> Axis {
    /// Differences below this are of no interest.
    const MIN_HALF_WIDTH: f64 = 0.01;
    let bulk = Scale::bulk(ys(layers));
    let middle = f64::midpoint(bulk.low(), bulk.high());
    let half = (0.5 * (bulk.high() - bulk.low())).max(MIN_HALF_WIDTH);
    let scale = Scale::linear([middle - half, middle + half]).padded(0.06, 0.06);
    Axis::new(translator.text("axis-restitution"), "", scale)
}
