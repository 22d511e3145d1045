//! The figures, one file each: data in, a [`Chart`] out.
//!
//! Points that are not numbers are left out; a figure without any usable point states so instead of
//! showing empty axes. A new figure of a drop is a file here and an entry of `OF_DROP`: then the program
//! saves it, the report has it in its section, and the page shows it under its tab.
//!
//! ```
//! use bouncelab::{Options, analyze_times};
//! use bouncelab_report::figure::{self, FigureInput};
//!
//! let options = Options::default().without_inference();
//! let result = analyze_times(&[0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045], &options);
//! let input = FigureInput::new(&result.drops[0], &options);
//! let names: Vec<_> = figure::of_drop(&input).map(|figure| figure.name).collect();
//! let plain = ["restitution", "flight-times", "height", "bounce-heights", "bounce-energies"];
//! assert_eq!(names, plain);
//! ```

mod bounces;
mod budget;
mod calibration;
mod detection;
mod drag;
mod drops;
mod flight_times;
mod groups;
mod height;
mod intervals;
mod limits;
mod models;
mod posterior;
mod residuals;
mod restitution;
mod run_chart;
mod runs;
mod truncation;
mod waveform;

use std::fmt;

use bouncelab::analysis::{Drop, Options};
use bouncelab::inference::Posterior;

pub use calibration::{RankHistogram, calibration};
pub use detection::{Detection, detection};
pub use drag::{DragAxes, drag, drag_of_settings};
pub use drops::{DropSummary, drop_impacts, drops};
pub use flight_times::{Line, TimedFlight, flight_times};
pub use groups::{GroupCurve, groups};
pub use height::height;
pub use intervals::{GroupInterval, intervals};
pub use limits::{EvaluatedValue, limits, verdict};
pub use run_chart::{RunPoint, run_chart};
pub(crate) use runs::flight_times as flight_times_of;
pub use runs::{Run, curve_of, runs};
pub use waveform::{Mark, waveform};

use crate::chart::{Chart, Dashes, Layer, Point};
use crate::messages::Translator;
use crate::theme::Meaning;

/// What the figures of a drop are made of.
#[derive(Debug, Clone, Copy)]
pub struct FigureInput<'a> {
    drop: &'a Drop,
    settings: &'a Options,
    simulation: Option<&'a [Point]>,
}

impl<'a> FigureInput<'a> {
    /// A drop and the settings with which it was analysed.
    pub const fn new(drop: &'a Drop, settings: &'a Options) -> Self {
        Self {
            drop,
            settings,
            simulation: None,
        }
    }

    /// With a simulation to compare with: time in s, in that of the recording, and
    /// height in m.
    #[must_use]
    pub const fn with_simulation(self, simulation: Option<&'a [Point]>) -> Self {
        Self { simulation, ..self }
    }

    fn inference(&self) -> Option<&'a Posterior> {
        self.drop.posterior.as_ref().ok()
    }
}

/// A section of the report of a drop.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ReportSection {
    /// The answer itself.
    Answer,
    /// The impacts.
    Impacts,
    /// The log-linear fit.
    LogLinearFit,
    /// Where the uncertainty comes from.
    Uncertainty,
    /// The comparison of the laws.
    Laws,
    /// What the data determined.
    Contraction,
    /// How well the inference fits.
    Fit,
}

/// A figure of a drop.
#[derive(Clone, Copy)]
pub struct Figure {
    /// Lower-case letters and hyphens: its name in files, links and messages (`figure-NAME-title`, `-caption`,
    /// `-empty`, and `-tab` for a few letters that name it on the page).
    pub name: &'static str,
    /// Where the report has it.
    pub section: ReportSection,
    applies: fn(&FigureInput<'_>) -> bool,
    draw: Draw,
}

impl Figure {
    /// The chart of a drop.
    pub fn chart(&self, input: &FigureInput<'_>, translator: &Translator) -> Chart {
        (self.draw)(input, translator)
    }
}

impl fmt::Debug for Figure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Figure").field(&self.name).finish()
    }
}

/// Every figure of a drop, in the order in which they are shown.
const OF_DROP: [Figure; 11] = {
    use ReportSection::{Answer, Contraction, Fit, Impacts, Laws, LogLinearFit, Uncertainty};
    [
        always("restitution", Answer, restitution::restitution),
        always("flight-times", LogLinearFit, flight_times::of_drop),
        always("height", Answer, height::of_drop),
        always("bounce-heights", Impacts, bounces::heights),
        always("bounce-energies", Impacts, bounces::energies),
        Figure {
            applies: |input| input.inference().is_some() || input.simulation.is_some(),
            ..always("comparison", Fit, height::comparison)
        },
        inferred("posterior", Contraction, |s, translator| {
            of_inference(s, "posterior", translator, posterior::posterior)
        }),
        inferred("residuals", Fit, |s, translator| {
            of_inference(s, "residuals", translator, residuals::residuals)
        }),
        inferred("budget", Uncertainty, |s, translator| {
            of_inference(s, "budget", translator, budget::budget)
        }),
        Figure {
            applies: |input| {
                input
                    .inference()
                    .is_some_and(|posterior| posterior.models.len() > 1)
            },
            ..inferred("models", Laws, |s, translator| {
                of_inference(s, "models", translator, models::models)
            })
        },
        Figure {
            applies: |input| {
                input.inference().is_some() && input.drop.truncation_points().len() > 2
            },
            ..inferred("truncation", Fit, truncation::truncation)
        },
    ]
};

/// How a figure is drawn.
type Draw = fn(&FigureInput<'_>, &Translator) -> Chart;

const fn always(name: &'static str, section: ReportSection, draw: Draw) -> Figure {
    Figure {
        name,
        section,
        applies: |_| true,
        draw,
    }
}

const fn inferred(name: &'static str, section: ReportSection, draw: Draw) -> Figure {
    Figure {
        applies: |input| input.inference().is_some(),
        ..always(name, section, draw)
    }
}

fn of_inference(
    input: &FigureInput<'_>,
    name: &str,
    translator: &Translator,
    draw: fn(&Posterior, &Translator) -> Chart,
) -> Chart {
    match input.inference() {
        Some(posterior) => draw(posterior, translator),
        None => Chart::empty(translator, name),
    }
}

/// The names of the figures that there may be of a drop, in the order in which they are shown.
pub fn names() -> [&'static str; OF_DROP.len()] {
    OF_DROP.map(|figure| figure.name)
}

/// What names a figure of a drop or of the air in a few letters.
pub fn tab(name: &str, translator: &Translator) -> String {
    translator.text(&format!("figure-{name}-tab"))
}

/// The figures that there are of a drop: of what was detected, and of the inference if there is one.
pub fn of_drop(input: &FigureInput<'_>) -> impl Iterator<Item = Figure> {
    OF_DROP.into_iter().filter(|figure| (figure.applies)(input))
}

/// The chart of a drop by its name; `None` if there is no such figure of this drop.
pub fn chart(name: &str, input: &FigureInput<'_>, translator: &Translator) -> Option<Chart> {
    let figure = of_drop(input).find(|figure| figure.name == name)?;
    Some(figure.chart(input, translator))
}

/// The figures of the air with their names, up to the fastest impact of the drops; none without drag,
/// or if no speed is available.
pub fn of_air(
    drops: &[Drop],
    settings: &Options,
    translator: &Translator,
) -> Vec<(&'static str, Chart)> {
    let speeds = drops.iter().filter_map(Drop::speed_range_m_s);
    let Some(fastest) = speeds.map(|(_, fastest)| fastest).reduce(f64::max) else {
        return Vec::new();
    };
    let charts = [DragAxes::Linear, DragAxes::Logarithmic].into_iter();
    charts
        .filter_map(|axes| {
            let chart = drag_of_settings(settings, fastest, axes, translator)?;
            Some((axes.name(), chart))
        })
        .collect()
}

/// A named curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// Name, as in the legend: short, plain text.
    pub name: String,
    /// What it shows, which decides its colour. Curves with the same meaning differ by their
    /// dashes.
    pub meaning: Meaning,
    /// The points in the order of drawing; the figure defines the units. A point that is
    /// not a number interrupts the curve.
    pub points: Vec<Point>,
}

/// The curves as layers: the colour by its meaning, dashes by how many of the same meaning came
/// before.
fn curve_layers(curves: &[Curve]) -> Vec<Layer> {
    const DASHES: [Dashes; 4] = [Dashes::Solid, Dashes::Dashed, Dashes::Dotted, Dashes::Long];
    let numbered = curves.iter().enumerate();
    let layers = numbered.map(|(i, curve)| {
        let before = &curves[..i];
        let same = before.iter().filter(|c| c.meaning == curve.meaning).count();
        let dashes = DASHES[same % DASHES.len()];
        let layer = Layer::line(curve.meaning, curve.points.clone()).with_dashes(dashes);
        layer.named(&*curve.name)
    });
    layers.collect()
}
