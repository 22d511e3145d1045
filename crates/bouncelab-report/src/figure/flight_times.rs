//! Flight time against bounce number, with the straight line of the paper (Fig. 5).

use super::{Figure, count, robust_scale};
use crate::canvas::{Dash, Pen};
use crate::scale::Scale;
use crate::sheet::{Axis, KeyEntry, Panel, Sheet, Swatch};
use crate::theme::Meaning;

const TITLE: &str = "Flight times and the straight line";
const HEIGHT: f64 = 460.0;

/// A flight with its time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TimedFlight {
    /// Number of the flight: the flight after the first impact is number 1.
    pub number: u32,
    /// How long it lasts, in seconds, above zero.
    pub time_s: f64,
    /// Standard error of the time in seconds, if known.
    pub standard_error_s: Option<f64>,
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
    fn time_s(self, number: f64) -> f64 {
        10_f64.powf(self.slope * number + self.intercept)
    }
}

/// Flight times on a logarithmic axis against their number, the line if there is one, and
/// below how far each flight lies from the line, in per cent. Flights that the line was not
/// fitted to are open circles; those far off the line are arrow heads at the edge of the
/// lower panel.
pub fn flight_times(flights: &[TimedFlight], line: Option<Line>) -> Figure {
    let flights: Vec<TimedFlight> = flights
        .iter()
        .copied()
        .filter(|flight| flight.time_s.is_finite() && flight.time_s > 0.0)
        .collect();
    if flights.is_empty() {
        return Figure::empty(HEIGHT, TITLE, "There are no flights to show.");
    }
    let line = line.filter(|line| line.slope.is_finite() && line.intercept.is_finite());
    let numbers = || flights.iter().map(|flight| f64::from(flight.number));
    let x = Axis::new(
        Scale::linear(numbers()).padded(0.03, 0.03),
        "number of the flight",
    );
    let times = Scale::log(flights.iter().flat_map(|flight| {
        let error = flight.standard_error_s.unwrap_or(0.0);
        [flight.time_s, flight.time_s - error, flight.time_s + error]
    }));
    let y = Axis::new(times.padded(0.06, 0.06), "flight time (s)");

    let mut sheet = Sheet::new(HEIGHT, TITLE);
    sheet.key(&key(&flights, line));
    let Some(line) = line else {
        let panel = Panel::fill(&mut sheet, &x, &y, 0.0);
        draw_flights(&mut sheet, &panel, &flights, |flight| {
            (flight.time_s, flight.standard_error_s)
        });
        return Figure::new(sheet, TITLE, caption(&flights, None));
    };
    let percent = |flight: &TimedFlight| {
        let fitted = line.time_s(f64::from(flight.number));
        let share = |time_s: f64| 100.0 * time_s / fitted;
        (
            share(flight.time_s) - 100.0,
            flight.standard_error_s.map(share),
        )
    };
    let (used, others): (Vec<_>, Vec<_>) = flights.iter().partition(|flight| flight.used);
    let bulk = if used.is_empty() { others } else { used };
    let residuals: Vec<_> = bulk.into_iter().map(percent).collect();
    let lower = Axis::new(around_zero(robust_scale(&residuals)), "off the line (%)");
    let [panel, below] = Panel::stack(&mut sheet, &x, [&y, &lower], 0.6);
    draw_line(&mut sheet, &panel, &x, &flights, line);
    below.level(
        &mut sheet.canvas,
        0.0,
        Pen::solid(Meaning::NoDrag.colour(), 2.0),
    );
    draw_flights(&mut sheet, &panel, &flights, |flight| {
        (flight.time_s, flight.standard_error_s)
    });
    draw_flights(&mut sheet, &below, &flights, percent);
    Figure::new(sheet, TITLE, caption(&flights, Some(line)))
}

fn key(flights: &[TimedFlight], line: Option<Line>) -> Vec<KeyEntry> {
    let measured = Meaning::Measured.colour();
    let mut key = Vec::new();
    let unused = flights.iter().any(|flight| !flight.used);
    let used = flights.iter().any(|flight| flight.used);
    if used {
        let name = if unused {
            "flights used"
        } else {
            "measured flights"
        };
        key.push(KeyEntry::new(Swatch::Dot(measured), name));
    }
    if unused {
        let name = if used { "not used" } else { "measured flights" };
        key.push(KeyEntry::new(Swatch::Ring(measured), name));
    }
    if let Some(line) = line {
        let name = format!("straight line: × {:.4} each time", 10_f64.powf(line.slope));
        let pen = Pen::solid(Meaning::NoDrag.colour(), 2.0);
        key.push(KeyEntry::new(Swatch::Line(pen), name));
    }
    key
}

/// Solid over the flights it was fitted to, dashed beyond.
fn draw_line(sheet: &mut Sheet, panel: &Panel, x: &Axis, flights: &[TimedFlight], line: Line) {
    let used = flights.iter().filter(|flight| flight.used);
    let (first, last) = used.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), flight| {
        let number = f64::from(flight.number);
        (low.min(number), high.max(number))
    });
    let pen = Pen::solid(Meaning::NoDrag.colour(), 2.0);
    let dashed = Pen {
        dash: Some(Dash {
            stroke: 5.0,
            gap: 4.0,
        }),
        ..pen
    };
    let mut segment = |from: f64, to: f64, pen: Pen| {
        let points = [from, to].map(|number| (number, line.time_s(number)));
        panel.curve(&mut sheet.canvas, &points, pen);
    };
    if first > last {
        segment(x.scale.low(), x.scale.high(), dashed);
        return;
    }
    segment(first, last, pen);
    segment(first, x.scale.low(), dashed);
    segment(last, x.scale.high(), dashed);
}

/// The flights in a panel; `value` gives the value shown and its standard error.
fn draw_flights(
    sheet: &mut Sheet,
    panel: &Panel,
    flights: &[TimedFlight],
    value: impl Fn(&TimedFlight) -> (f64, Option<f64>),
) {
    let colour = Meaning::Measured.colour();
    for flight in flights {
        let (y, error) = value(flight);
        let swatch = if flight.used {
            Swatch::Dot(colour)
        } else {
            Swatch::Ring(colour)
        };
        let point = (f64::from(flight.number), y);
        panel.measured(&mut sheet.canvas, point, error, swatch);
    }
}

/// The scale, widened to show zero, with room for the dots.
fn around_zero(scale: Scale) -> Scale {
    Scale::linear([scale.low().min(0.0), scale.high().max(0.0)]).padded(0.12, 0.12)
}

fn caption(flights: &[TimedFlight], line: Option<Line>) -> String {
    let Some(line) = line else {
        return format!(
            "{}, without a line through them.",
            count(flights.len(), "flight")
        );
    };
    let ratio = 10_f64.powf(line.slope);
    format!(
        "Without air each flight would last the same share of the one before, {ratio:.4} by the line; a bend in the lower panel is what the air does."
    )
}
