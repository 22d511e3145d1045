//! A result against the number of flights that it uses.

use bouncelab::Estimate;
use bouncelab::analysis::Truncation;

use super::FigureInput;
use crate::chart::{Axis, Chart, Dashes, Layer, Marker, Panel, Scale, xs, ys};
use crate::messages::Translator;
use crate::theme::Meaning;

/// One of the heights of a truncation.
type Height = fn(&Truncation) -> Option<Estimate>;

/// The drop height by the log-linear fit and by the inference against the number of flights used, and
/// the stated height if there is one.
pub(super) fn truncation(input: &FigureInput<'_>, translator: &Translator) -> Chart {
    let text = |id: &str| translator.text(&format!("figure-truncation-{id}"));
    let truncations = input.drop.truncations(input.settings);
    let mut layers = Vec::new();
    let answers: [(Meaning, &str, Height); 2] = [
        (Meaning::Plain, "line", |it| it.log_linear_fit_m),
        (Meaning::Measured, "inference", |it| it.posterior_m),
    ];
    for (meaning, name, height_m) in answers {
        let heights = truncations.iter();
        let heights: Vec<(f64, Estimate)> = heights
            .filter_map(|it| Some((it.flights as f64, height_m(it)?)))
            .collect();
        let points: Vec<_> = heights.iter().map(|(n, h)| [*n, 100.0 * h.value]).collect();
        let errors = heights
            .iter()
            .map(|(_, h)| 100.0 * h.known_sd().unwrap_or(f64::NAN));
        let errors = errors.collect();
        layers.push(Layer::line(meaning, points.clone()).with_width(1.125));
        let points = Layer::points(meaning, Marker::Dot, points).with_errors(errors);
        layers.push(points.named(text(name)));
    }
    if xs(&layers).next().is_none() || ys(&layers).next().is_none() {
        return Chart::empty(translator, "truncation");
    }
    if let Some(stated) = &input.settings.priors.drop_height_m {
        let level = Layer::level(Meaning::Ink, 100.0 * stated.value).with_width(1.5);
        layers.push(level.with_dashes(Dashes::Dashed).named(text("stated")));
    }
    let x = Scale::counting(xs(&layers)).padded(0.04, 0.04);
    let y = Scale::linear(ys(&layers)).padded(0.08, 0.08);
    let x = Axis::new(text("flights"), "", x);
    let y = Axis::new(translator.text("axis-drop-height"), "cm", y);
    let panel = Panel::new(220.0, x, y, layers);
    Chart::new(translator, "truncation", text("caption"), vec![panel])
}
