//! The residual of each impact from the prediction of the previous ones.

use bouncelab::inference::Posterior;

use crate::chart::{Axis, Chart, Layer, Marker, Panel, Point, Scale, xs, ys};
use crate::messages::Translator;
use crate::theme::Meaning;

/// Beyond this many standard deviations a residual is an arrow head at the edge.
const MAX_SHOWN: f64 = 5.0;

/// Standardised residual of each impact against its number, with the bands in which 68 and 95 % of
/// them should lie.
pub(super) fn residuals(posterior: &Posterior, translator: &Translator) -> Chart {
    let text = |id: &str| translator.text(&format!("figure-residuals-{id}"));
    let points = |odd: bool| -> Vec<Point> {
        let impacts = posterior
            .impacts
            .iter()
            .filter(|impact| impact.is_outlier() == odd);
        let residuals = impacts.filter_map(|i| Some([i.number as f64, i.standardised_residual?]));
        residuals.collect()
    };
    let mut layers =
        vec![Layer::points(Meaning::Measured, Marker::Dot, points(false)).named(text("impact"))];
    let odd = points(true);
    if !odd.is_empty() {
        layers.push(Layer::points(Meaning::Drag, Marker::Triangle, odd).named(text("odd")));
    }
    if xs(&layers).next().is_none() {
        return Chart::empty(translator, "residuals");
    }
    let x = Scale::counting(xs(&layers)).padded(0.03, 0.03);
    let highest = ys(&layers).map(f64::abs).fold(3.0, f64::max).min(MAX_SHOWN);
    let y = Scale::linear([-highest, highest]).padded(0.05, 0.05);
    let band = |sd: f64| Layer::boxes(Meaning::Expected, vec![[x.low(), x.high(), -sd, sd]]);
    let zero = Layer::level(Meaning::Expected, 0.0).with_width(1.0);
    layers.splice(0..0, [band(2.0).pale(0.18), band(1.0).pale(0.38), zero]);
    let x = Axis::new(translator.text("axis-impact"), "", x);
    let y = Axis::new(text("axis"), "", y);
    let panel = Panel::new(155.0, x, y, layers);
    Chart::new(translator, "residuals", text("caption"), vec![panel])
}
