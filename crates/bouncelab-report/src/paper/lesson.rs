//! The argument of the paper with free parameters: the log-linear fit without air, the effect of the air,
//! and the discrepancy.

use bouncelab::Result;
use bouncelab::drag::DragLaw;
use bouncelab::drop::Stop;
use bouncelab::flight::FlightModel;
use bouncelab::regression::{self, LogLinearFit, NumberedFlight};
use bouncelab::restitution::Restitution;
use serde::{Deserialize, Serialize};

use super::experiment::{
    self, CONSTANT, DROP_HEIGHT_M, GRAVITY_M_S2, REGRESSED, SIMULATED, bisected, dropped,
    dropped_by, model,
};
use super::figures;
use super::puzzle::{LAST_DIGIT_M, REGRESSED_HEIGHT_M};
use crate::chart::{Axis, Chart, Dashes, Layer, Marker, Panel, Point, Scale, xs, ys};
use crate::figure::{self, Curve, DragAxes, curve_of};
use crate::messages::Translator;
use crate::theme::Meaning;

/// Points along a curve.
const POINTS: usize = 2000;
/// The restitution of a slider is that at this speed.
const AT_SPEED_M_S: f64 = 1.0;
/// The minimum number of flights of a line.
const MIN_FLIGHTS: usize = 3;
/// The longest line that is tried.
const MAX_FLIGHTS: usize = 40;

/// The figures of the lesson: flight times without air on a straight line, drag over weight, and the
/// height with and without air.
///
/// # Errors
///
/// Those of the physics; none with the numbers of the paper.
pub fn charts(translator: &Translator) -> crate::Result<[Chart; 3]> {
    let drag = figures::drag(DragAxes::Logarithmic, 10.0, translator)?;
    Ok([straight_line(translator)?, drag, heights(translator)?])
}

fn straight_line(translator: &Translator) -> Result<Chart> {
    let history = dropped(&model(DragLaw::None)?, REGRESSED, Stop::after(30))?;
    let flights = experiment::flights(&history);
    let line = figure::Line::from(&regression::fit(&flights, GRAVITY_M_S2)?);
    let points = flights
        .iter()
        .map(|flight| [flight.number as f64, flight.time_s]);
    let points: Vec<Point> = points.collect();
    let fitted = points.iter().map(|[n, _]| [*n, line.time_s(*n)]).collect();
    let name = translator.text("figure-lesson-line-line");
    let layers = vec![
        Layer::line(Meaning::Plain, fitted).named(name),
        Layer::points(Meaning::Plain, Marker::Dot, points),
    ];
    Ok(figure::flight_times_of("lesson-line", layers, translator))
}

fn heights(translator: &Translator) -> Result<Chart> {
    let curve = |id: &str, meaning, law| -> Result<Curve> {
        let history = dropped(&model(law)?, SIMULATED, Stop::below(1e-3))?;
        Ok(Curve {
            name: translator.text(id),
            meaning,
            points: curve_of(&history, POINTS),
        })
    };
    let curves = [
        curve("figure-lesson-no-air", Meaning::Plain, DragLaw::None)?,
        curve("figure-lesson-air", Meaning::Drag, CONSTANT)?,
    ];
    Ok(figure::height("lesson-height", &curves, &[], translator))
}

/// What a reader chooses: the truth, and how it is looked at.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct PuzzleChoice {
    /// Restitution at 1 m/s.
    pub restitution: f64,
    /// What it loses for each m/s.
    pub loss_per_speed_s_m: f64,
    /// Flights in the log-linear fit.
    pub flights: usize,
}

/// What the log-linear fit makes of a choice.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct PuzzleAnswer {
    /// Its restitution.
    pub restitution: f64,
    /// Its drop height, m.
    pub drop_height_m: f64,
    /// Whether both are those of the paper, to its digits.
    pub reproduces: bool,
    /// The drop height that the line finds against how many flights it is given, with and without air.
    pub chart: Chart,
}

impl PuzzleChoice {
    fn law(&self) -> Result<Restitution> {
        let Self {
            restitution,
            loss_per_speed_s_m: loss,
            ..
        } = *self;
        if loss > 0.0 {
            Restitution::linear(restitution + loss * AT_SPEED_M_S, loss)
        } else {
            Restitution::constant(restitution)
        }
    }

    fn times(&self, model: &FlightModel) -> Result<Vec<NumberedFlight>> {
        let history = dropped_by(model, self.law()?, Stop::after(MAX_FLIGHTS))?;
        Ok(experiment::flights(&history))
    }

    /// The log-linear fit of it.
    ///
    /// # Errors
    ///
    /// If the restitution is out of range, or there are too few flights.
    pub fn answer(&self, translator: &Translator) -> Result<PuzzleAnswer> {
        let drag = self.times(&model(CONSTANT)?)?;
        let vacuum = self.times(&model(DragLaw::None)?)?;
        let flights = self.flights.clamp(MIN_FLIGHTS, drag.len().max(MIN_FLIGHTS));
        let line = fitted(&drag, flights)?;
        let (restitution, height_m) = (line.restitution.value, line.drop_height_m.value);
        let is_near = |a: f64, b: f64, digit: f64| (a - b).abs() < digit;
        Ok(PuzzleAnswer {
            restitution,
            drop_height_m: height_m,
            reproduces: is_near(restitution, REGRESSED, 5e-4)
                && is_near(height_m, REGRESSED_HEIGHT_M, LAST_DIGIT_M),
            chart: Self::chart(
                [&vacuum, &drag],
                [flights as f64, 100.0 * height_m],
                translator,
            )?,
        })
    }

    fn chart(
        [vacuum, drag]: [&[NumberedFlight]; 2],
        now: Point,
        translator: &Translator,
    ) -> Result<Chart> {
        let curve = |times: &[NumberedFlight]| -> Result<Vec<Point>> {
            let counts = MIN_FLIGHTS..=times.len();
            counts
                .map(|count| {
                    let height_m = fitted(times, count)?.drop_height_m.value;
                    Ok([count as f64, 100.0 * height_m])
                })
                .collect()
        };
        let text = |id: &str| translator.text(&format!("figure-lesson-{id}"));
        let level = |meaning, height_m: f64, id| {
            let level = Layer::level(meaning, 100.0 * height_m).with_width(1.5);
            level.with_dashes(Dashes::Dashed).named(text(id))
        };
        let layers = vec![
            level(Meaning::Measured, REGRESSED_HEIGHT_M, "paper"),
            level(Meaning::Ink, DROP_HEIGHT_M, "truth"),
            Layer::line(Meaning::Plain, curve(vacuum)?).named(text("no-air")),
            Layer::line(Meaning::Drag, curve(drag)?).named(text("air")),
            Layer::points(Meaning::Drag, Marker::Dot, vec![now]),
        ];
        let x = Axis::new(
            text("flights"),
            "",
            Scale::counting(xs(&layers)).padded(0.03, 0.03),
        );
        let scale = Scale::linear(ys(&layers).chain([25.0, 31.0])).padded(0.05, 0.05);
        let y = Axis::new(text("height-of-line"), "cm", scale);
        let panel = Panel::new(260.0, x, y, layers);
        Ok(Chart::new(
            translator,
            "lesson",
            text("caption"),
            vec![panel],
        ))
    }

    /// The restitution with which the line gives the paper's restitution, the rest being as chosen.
    ///
    /// # Errors
    ///
    /// If the choice is out of range.
    pub fn solved(self) -> Result<Self> {
        let model = model(CONSTANT)?;
        let [restitution, _] = bisected([0.88, 0.995], 1e-5, |restitution| {
            let choice = Self {
                restitution,
                ..self
            };
            let line = fitted(&choice.times(&model)?, self.flights)?;
            Ok(line.restitution.value < REGRESSED)
        })?;
        Ok(Self {
            restitution,
            ..self
        })
    }
}

/// The log-linear fit through the first flights.
fn fitted(flights: &[NumberedFlight], count: usize) -> Result<LogLinearFit> {
    regression::fit(&flights[..count.min(flights.len())], GRAVITY_M_S2)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The three ways out of the puzzle that the lesson offers.
    #[test]
    fn solutions_reproduce_the_restitution_of_the_paper() {
        for (loss_per_speed_s_m, flights, reproduces) in
            [(0.0, 10, false), (0.0, 21, true), (0.02374, 10, true)]
        {
            let choice = PuzzleChoice {
                restitution: 0.9,
                loss_per_speed_s_m,
                flights,
            };
            let solved = choice.solved().unwrap();
            let answer = solved.answer(&Translator::english()).unwrap();
            assert!((answer.restitution - REGRESSED).abs() < 5e-5, "{flights}");
            assert_eq!(answer.reproduces, reproduces, "{flights}");
        }
    }
}
