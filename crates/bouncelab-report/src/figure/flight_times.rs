//! Flight time against bounce number, with the straight line of the paper (Fig. 5).

use super::{Figure, LINE, count, robust_scale};
use crate::canvas::Pen;
use crate::quantity::{Quantity, Unit};
use crate::scale::{Scale, extent};
use crate::sheet::{Axis, KeyEntry, Measured, Panel, Sheet, Swatch};
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
    /// How long a flight lasts as a share of the one before.
    fn ratio(self) -> Quantity {
        Quantity::rounded(10_f64.powf(self.slope), 4, Unit::Number)
    }

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
    let numbers = flights.iter().map(|flight| flight.number);
    let x = Axis::new(
        Scale::counting(numbers).padded(0.03, 0.03),
        "number of the flight",
    );
    let times = Scale::log(flights.iter().flat_map(|flight| {
        let error = flight.standard_error_s.unwrap_or(0.0);
        [flight.time_s, flight.time_s - error, flight.time_s + error]
    }));
    let y = Axis::new(times.padded(0.06, 0.06), "flight time (s)");

    let mut sheet = Sheet::new(HEIGHT, TITLE);
    sheet.key(&key(&flights, line));
    let time = |flight: &TimedFlight| Measured {
        place: (f64::from(flight.number), flight.time_s),
        standard_error: flight.standard_error_s,
    };
    let Some(line) = line else {
        let panel = Panel::fill(&mut sheet, &x, &y, 0.0);
        draw_flights(&mut sheet, &panel, &flights, time);
        return Figure::new(sheet, caption(&flights, None));
    };
    let off_line = |flight: &TimedFlight| {
        let number = f64::from(flight.number);
        let percent = 100.0 / line.time_s(number);
        Measured {
            place: (number, flight.time_s * percent - 100.0),
            standard_error: flight.standard_error_s.map(|error| error * percent),
        }
    };
    let lower = Axis::new(residual_scale(&flights, off_line), "off the line (%)");
    let [panel, below] = Panel::stack(&mut sheet, &x, [&y, &lower], 0.57);
    draw_line(&mut sheet, &panel, &x, &flights, line);
    draw_flights(&mut sheet, &panel, &flights, time);
    let pen = Pen::solid(Meaning::NoDrag.colour(), LINE);
    below.level(&mut sheet.canvas, 0.0, pen);
    draw_flights(&mut sheet, &below, &flights, off_line);
    Figure::new(sheet, caption(&flights, Some(line)))
}

/// Shows zero and the flights used, with as much room again for the others.
fn residual_scale(flights: &[TimedFlight], off_line: impl Fn(&TimedFlight) -> Measured) -> Scale {
    let any_used = flights.iter().any(|flight| flight.used);
    let shown: Vec<_> = flights
        .iter()
        .filter(|flight| flight.used || !any_used)
        .map(|flight| {
            let point = off_line(flight);
            (point.place.1, point.standard_error)
        })
        .collect();
    let bulk = robust_scale(&shown);
    let room = if flights.iter().all(|flight| flight.used) {
        0.12
    } else {
        0.5
    };
    Scale::linear([bulk.low().min(0.0), bulk.high().max(0.0)]).padded(room, room)
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
        let name = format!("straight line: × {} each time", line.ratio());
        let pen = Pen::solid(Meaning::NoDrag.colour(), LINE);
        key.push(KeyEntry::new(Swatch::Line(pen), name));
    }
    key
}

/// Solid over the flights it was fitted to, dashed beyond.
fn draw_line(sheet: &mut Sheet, panel: &Panel, x: &Axis, flights: &[TimedFlight], line: Line) {
    let used = flights.iter().filter(|flight| flight.used);
    let pen = Pen::solid(Meaning::NoDrag.colour(), LINE);
    let dashed = pen.dashed(5.0, 4.0);
    let mut segment = |from: f64, to: f64, pen: Pen| {
        let points = [from, to].map(|number| (number, line.time_s(number)));
        panel.curve(&mut sheet.canvas, &points, pen);
    };
    let Some((first, last)) = extent(used.map(|flight| f64::from(flight.number))) else {
        segment(x.scale.low(), x.scale.high(), dashed);
        return;
    };
    segment(first, last, pen);
    segment(first, x.scale.low(), dashed);
    segment(last, x.scale.high(), dashed);
}

/// The flights in a panel, at the places that `point` gives.
fn draw_flights(
    sheet: &mut Sheet,
    panel: &Panel,
    flights: &[TimedFlight],
    point: impl Fn(&TimedFlight) -> Measured,
) {
    let colour = Meaning::Measured.colour();
    for flight in flights {
        panel.uncertainty(&mut sheet.canvas, point(flight), colour);
    }
    for flight in flights {
        let swatch = if flight.used {
            Swatch::Dot(colour)
        } else {
            Swatch::Ring(colour)
        };
        panel.point(&mut sheet.canvas, point(flight).place, swatch);
    }
}

fn caption(flights: &[TimedFlight], line: Option<Line>) -> String {
    let Some(line) = line else {
        return format!(
            "{}, without a line through them.",
            count(flights.len(), "flight")
        );
    };
    format!(
        "Without air each flight would last the same share of the one before, {} by the line; a bend in the lower panel shows air drag, or a bounciness that changes with speed.",
        line.ratio()
    )
}
