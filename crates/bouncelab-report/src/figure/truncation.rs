//! An answer against how many flights it uses.

use super::{Subject, derived};
use crate::chart::{Axis, Chart, Dashes, Layer, Marker, Panel, Scale, xs, ys};
use crate::messages::Translator;
use crate::theme::Meaning;

/// The drop height by the straight line and by the inference against the number of flights used, and
/// the stated height if there is one.
pub(super) fn truncation(subject: &Subject<'_>, translator: &Translator) -> Chart {
    let text = |id: &str| translator.text(&format!("figure-truncation-{id}"));
    let found = derived::truncated(subject.drop, subject.settings);
    let mut layers = Vec::new();
    for (meaning, name, answers) in [
        (Meaning::Plain, "line", found.line),
        (Meaning::Measured, "inference", found.inference),
    ] {
        let points: Vec<_> = answers.iter().map(|[n, h, _]| [*n, 100.0 * h]).collect();
        let errors = answers.iter().map(|[.., sd]| 100.0 * sd).collect();
        layers.push(Layer::line(meaning, points.clone()).with_width(1.125));
        let points = Layer::points(meaning, Marker::Dot, points).with_errors(errors);
        layers.push(points.named(text(name)));
    }
    if ys(&layers).next().is_none() {
        return Chart::empty(translator, "truncation");
    }
    if let Some(stated) = &subject.settings.priors.drop_height_m {
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
