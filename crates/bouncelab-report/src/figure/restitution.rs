//! Restitution against impact speed.

use bouncelab::analysis::Drop;
use bouncelab::inference::ImpactPosterior;
use bouncelab::restitution::ImpactRestitution;

use super::FigureInput;
use crate::chart::{Axis, Chart, Layer, Marker, Panel, Point, Scale, xs, ys};
use crate::messages::Translator;
use crate::quantity::{Quantity, Unit};
use crate::theme::Meaning;

/// Without air most restitutions are near each other, and those of fast impacts far below: they are
/// shown as long as they lie within this multiple of the interquartile range.
const TAIL: f64 = 15.0;

/// Restitution of each impact against its speed: as if there were no air (the ratio of neighbouring
/// flight times), corrected for air drag, the fitted law with its intervals, and the one value of the
/// straight line. The vertical axis shows the bulk of the values; those far off are arrow heads at its
/// edge.
pub(super) fn restitution(input: &FigureInput<'_>, translator: &Translator) -> Chart {
    let drop = input.drop;
    let text = |id: &str| translator.text(&format!("figure-restitution-{id}"));
    let impacts = drop
        .per_impact
        .as_ref()
        .map_or(&[][..], |per_impact| &per_impact.impacts);
    if impacts.is_empty() {
        return Chart::empty(translator, "restitution");
    }
    let corrected = points(impacts, |impact| impact.restitution.value);
    let errors = impacts
        .iter()
        .map(|impact| impact.restitution.known_sd().unwrap_or(f64::NAN));
    let measured = vec![
        Layer::points(
            Meaning::Plain,
            Marker::Ring,
            points(impacts, |impact| impact.flight_time_ratio),
        )
        .named(text("raw")),
        Layer::points(Meaning::Measured, Marker::Dot, corrected.clone())
            .named(text("corrected"))
            .with_errors(errors.collect()),
    ];
    let law = law(drop, &text("law"));
    let line = line(drop, translator);
    let [x, y] = axes(&measured, &law, line.as_ref(), translator);
    let outliers = outliers(drop, &corrected);
    let outliers = (!outliers.is_empty())
        .then(|| Layer::points(Meaning::Drag, Marker::OpenTriangle, outliers).named(text("odd")));
    let layers = law.into_iter().chain(line).chain(measured).chain(outliers);
    let panel = Panel::new(250.0, x, y, layers.collect());
    Chart::new(translator, "restitution", text("caption"), vec![panel])
}

/// A value of each impact against its speed.
fn points(impacts: &[ImpactRestitution], value: fn(&ImpactRestitution) -> f64) -> Vec<Point> {
    let points = impacts
        .iter()
        .map(|impact| [impact.impact_speed_m_s, value(impact)]);
    points.collect()
}

/// The one restitution of the log-linear fit.
fn line(drop: &Drop, translator: &Translator) -> Option<Layer> {
    let value = drop.log_linear_fit.as_ref().ok()?.restitution.value;
    let written = Quantity::rounded(value, 4, Unit::Number);
    let name = translator.text_with("figure-restitution-line", &[("value", written.into())]);
    Some(Layer::level(Meaning::Plain, value).named(name))
}

/// The horizontal axis shows all speeds from zero, the vertical one the bulk of the measured values, the law and the line.
fn axes(
    measured: &[Layer],
    law: &[Layer],
    line: Option<&Layer>,
    translator: &Translator,
) -> [Axis; 2] {
    let bulk = Scale::within(TAIL, ys(measured));
    let fitted: Vec<Layer> = law.last().into_iter().chain(line).cloned().collect();
    let ends = ys(&fitted).chain([bulk.low(), bulk.high()]);
    let y = Scale::linear(ends).padded(0.08, 0.08);
    let speeds = xs(measured).chain(xs(law)).chain([0.0]);
    let x = Scale::linear(speeds).padded(0.0, 0.04);
    [
        Axis::new(translator.text("axis-impact-speed"), "m/s", x),
        Axis::new(translator.text("axis-restitution"), "", y),
    ]
}

/// The fitted law with the 95 and the 68 % interval below it; nothing without inference.
fn law(drop: &Drop, name: &str) -> Vec<Layer> {
    let Ok(posterior) = &drop.posterior else {
        return Vec::new();
    };
    let band = &posterior.band;
    let points = band.iter().map(|p| [p.speed_m_s, p.restitution.value]);
    let points: Vec<Point> = points.collect();
    let interval = |of: fn(&bouncelab::Estimate) -> [f64; 2]| {
        let points = band.iter().map(|p| {
            let [low, high] = of(&p.restitution);
            [p.speed_m_s, low, high]
        });
        Layer::band(Meaning::Drag, points.collect())
    };
    vec![
        interval(|value| value.interval95).pale(0.13),
        interval(|value| value.interval68).pale(0.3),
        Layer::line(Meaning::Drag, points).named(name),
    ]
}

/// The points of the impacts that the inference treats as outliers.
fn outliers(drop: &Drop, corrected: &[Point]) -> Vec<Point> {
    let (Ok(per_impact), Ok(posterior)) = (&drop.per_impact, &drop.posterior) else {
        return Vec::new();
    };
    let numbered = per_impact.impacts.iter().zip(corrected);
    let is_outlier = |number| {
        posterior
            .impact(number)
            .is_some_and(ImpactPosterior::is_outlier)
    };
    numbered
        .filter(|(impact, _)| is_outlier(impact.number))
        .map(|(_, &point)| point)
        .collect()
}
