//! Flight time against bounce number, with the log-linear fit of the paper (Fig. 5).

use super::FigureInput;
use crate::chart::{Axis, Chart, Dashes, Layer, Marker, Panel, Point, Scale, xs, ys};
use crate::messages::Translator;
use crate::quantity::{Quantity, Unit};
use crate::theme::Meaning;

const ID: &str = "flight-times";

/// A flight with its time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TimedFlight {
    /// Number of the flight: the flight after the first impact is number 1.
    pub number: usize,
    /// How long it lasts, in seconds.
    pub time_s: f64,
    /// Whether the straight line was fitted to it.
    pub used: bool,
}

/// The straight line `log10(T_n / 1 s) = slope * n + intercept` (paper, Eq. 4).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// Slope: the logarithm to base ten of the restitution, if there were no air.
    pub slope: f64,
    /// Intercept at n = 0: the logarithm to base ten of a flight time in seconds.
    pub intercept: f64,
}

impl Line {
    pub(crate) fn time_s(self, number: f64) -> f64 {
        10_f64.powf(self.slope * number + self.intercept)
    }
}

impl From<&bouncelab::regression::LogLinearFit> for Line {
    fn from(fit: &bouncelab::regression::LogLinearFit) -> Self {
        Self {
            slope: fit.slope.value,
            intercept: fit.intercept.value,
        }
    }
}

pub(super) fn of_drop(input: &FigureInput<'_>, translator: &Translator) -> Chart {
    let flights = input.drop.flights.iter().map(|flight| TimedFlight {
        number: flight.number,
        time_s: flight.flight_time_s,
        used: flight.in_fit,
    });
    let line = input.drop.log_linear_fit.as_ref().ok().map(Line::from);
    flight_times(&flights.collect::<Vec<_>>(), line, translator)
}

/// Flight times on a logarithmic axis against their number, the line if there is one, and
/// below how far each flight lies from the line, in per cent. Flights that the line was not
/// fitted to are open circles; those far off the line are arrow heads at the edge of the
/// lower panel.
pub fn flight_times(flights: &[TimedFlight], line: Option<Line>, translator: &Translator) -> Chart {
    let flights: Vec<TimedFlight> = flights
        .iter()
        .copied()
        .filter(|flight| flight.time_s.is_finite() && flight.time_s > 0.0)
        .collect();
    if flights.is_empty() {
        return Chart::empty(translator, ID);
    }
    let line = line.filter(|line| line.slope.is_finite() && line.intercept.is_finite());
    let mut times = points(&flights, translator, &|flight| flight.time_s);
    let x = Axis::new(
        translator.text("axis-flight"),
        "",
        Scale::counting(xs(&times)).padded(0.03, 0.03),
    );
    let scale = Scale::log(ys(&times)).padded(0.06, 0.06);
    let y = Axis::new(translator.text("axis-flight-time"), "s", scale);
    let Some(line) = line else {
        let caption = translator.text_with(
            "figure-flight-times-no-line",
            &[("count", flights.len().into())],
        );
        let panel = Panel::new(330.0, x, y, times);
        return Chart::new(translator, ID, caption, vec![panel]);
    };
    let ratio = Quantity::rounded(10_f64.powf(line.slope), 4, Unit::Number);
    let name = translator.text_with("figure-flight-times-line", &[("ratio", ratio.into())]);
    times.splice(0..0, curves(line, &flights, &x.scale, &name));
    let off_line = points(&flights, translator, &|flight| {
        100.0 * flight.time_s / line.time_s(flight.number as f64) - 100.0
    });
    let scale = off_line_scale(&off_line, &flights);
    let zero = std::iter::once(Layer::level(Meaning::Plain, 0.0));
    let below = Panel::new(
        90.0,
        x.clone(),
        Axis::new(translator.text("axis-off-line"), "%", scale),
        zero.chain(off_line).collect(),
    );
    let caption = translator.text_with("figure-flight-times-caption", &[("ratio", ratio.into())]);
    Chart::new(
        translator,
        ID,
        caption,
        vec![Panel::new(190.0, x, y, times)],
    )
    .with_below(below)
}

/// A value of each flight against its number: dots for those in the fit, rings for the others.
fn points(
    flights: &[TimedFlight],
    translator: &Translator,
    value: &dyn Fn(&TimedFlight) -> f64,
) -> Vec<Layer> {
    let of = |used: bool, marker, name: &str| {
        let flights = flights.iter().filter(|flight| flight.used == used);
        let points: Vec<Point> = flights
            .map(|flight| [flight.number as f64, value(flight)])
            .collect();
        let name = translator.text(&format!("figure-{ID}-{name}"));
        (!points.is_empty()).then(|| Layer::points(Meaning::Measured, marker, points).named(name))
    };
    let all_used = flights.iter().all(|flight| flight.used);
    let used = of(true, Marker::Dot, if all_used { "all" } else { "used" });
    let unused = of(false, Marker::Ring, "unused");
    used.into_iter().chain(unused).collect()
}

/// Solid over the flights it was fitted to, dashed beyond.
fn curves(line: Line, flights: &[TimedFlight], x: &Scale, name: &str) -> Vec<Layer> {
    let segment = |from: f64, to: f64| {
        let points = [from, to].map(|number| [number, line.time_s(number)]);
        Layer::line(Meaning::Plain, points.to_vec())
    };
    let dashed = |from, to| segment(from, to).with_dashes(Dashes::Dashed);
    let used = || flights.iter().filter(|flight| flight.used);
    let first = used().map(|flight| flight.number).min();
    let last = used().map(|flight| flight.number).max();
    let (Some(first), Some(last)) = (first, last) else {
        return vec![dashed(x.low(), x.high()).named(name)];
    };
    let (first, last) = (first as f64, last as f64);
    vec![
        dashed(x.low(), first),
        dashed(last, x.high()),
        segment(first, last).named(name),
    ]
}

/// Shows zero and the flights used, with margins as wide again for the others.
fn off_line_scale(off_line: &[Layer], flights: &[TimedFlight]) -> Scale {
    let bulk = Scale::bulk(ys(&off_line[..1]));
    let all_used = flights.iter().all(|flight| flight.used);
    let margin = if all_used { 0.12 } else { 0.5 };
    Scale::linear([bulk.low().min(0.0), bulk.high().max(0.0)]).padded(margin, margin)
}
