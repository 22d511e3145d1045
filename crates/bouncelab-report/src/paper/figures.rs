//! The figures of the paper, drawn again.

use super::experiment::{
    self, CONSTANT, GRAVITY_M_S2, REGRESSED, SIMULATED, behind_the_regression, dropped, model,
};
use crate::chart::Chart;
use crate::error::Result;
use crate::figure::{self, Curve, DragAxes, Line, Mark, TimedFlight};
use crate::messages::Translator;
use crate::theme::Meaning;
use bouncelab::analysis::CONFIDENT_PROBABILITY;
use bouncelab::detection::Detector;
use bouncelab::drag::DragLaw;
use bouncelab::drop::{History, Stop};
use bouncelab::impact::ImpactEvent;
use bouncelab::regression;
use bouncelab::synth::{self, Noise, Scene};
use bouncelab::train::Train;

/// Name and drawing of each of its figures that can be computed, in the order of the paper.
///
/// # Errors
///
/// Those of the physics; none with the numbers of the paper.
pub fn figures(translator: &Translator) -> Result<Vec<(&'static str, Chart)>> {
    Ok(vec![
        ("fig2-height-without-drag", height_without_drag(translator)?),
        ("fig4-sound", sound(translator)?),
        ("fig5-flight-times", flight_times(translator)?),
        ("fig6-drag", drag(DragAxes::Linear, 10.0, translator)?),
        (
            "fig7-drag-log",
            drag(DragAxes::Logarithmic, 10.0, translator)?,
        ),
        ("fig8-height-with-drag", height_with_drag(translator)?),
    ])
}

/// Points along a curve.
const POINTS: u32 = 4000;

fn curve(name: &str, meaning: Meaning, history: &History) -> Curve {
    let end_s = history.total_time_s();
    let times = (0..=POINTS).map(|point| end_s * f64::from(point) / f64::from(POINTS));
    let points = times
        .map(|time_s| [time_s, history.height_at(time_s)])
        .collect();
    Curve {
        name: name.to_owned(),
        meaning,
        points,
    }
}

/// Fig. 2: the first few bounces.
fn height_without_drag(translator: &Translator) -> Result<Chart> {
    let history = dropped(&model(DragLaw::None)?, REGRESSED, Stop::after(3))?;
    Ok(figure::height(
        "height",
        &[curve("no drag, e = 0.9375", Meaning::Plain, &history)],
        &[],
        translator,
    ))
}

/// Fig. 4: the sound of the drop, synthesised, with the impacts that are detected in it.
fn sound(translator: &Translator) -> Result<Chart> {
    let history = dropped(
        &model(CONSTANT)?,
        behind_the_regression(10)?,
        Stop::below(5e-4),
    )?;
    let events: Vec<ImpactEvent> = history.impact_events().collect();
    let scene = Scene {
        noise: Some(Noise::pink(40.0)),
        ..Scene::default()
    };
    let recording = synth::render(&events, &scene, 1)?;
    let mut detector = Detector::new(recording.sample_rate_hz, 1);
    detector.push(&[&recording.samples]);
    let detection = detector.finish();
    let marks: Vec<Mark> = detection
        .found
        .trains
        .iter()
        .flat_map(Train::impacts)
        .map(|impact| Mark {
            time_s: impact.onset.time_s,
            sure: impact.probability >= CONFIDENT_PROBABILITY,
            drop: 1,
        })
        .collect();
    Ok(figure::waveform(&detection.envelope, &marks, translator))
}

/// Fig. 5: ten flights of the drop that regresses to the paper's e.
fn flight_times(translator: &Translator) -> Result<Chart> {
    let history = dropped(
        &model(CONSTANT)?,
        behind_the_regression(10)?,
        Stop::after(20),
    )?;
    let flights = experiment::flights(&history);
    let fit = regression::fit(&flights[..10], GRAVITY_M_S2)?;
    let drawn: Vec<TimedFlight> = flights
        .iter()
        .map(|flight| TimedFlight {
            number: flight.number,
            time_s: flight.time_s,
            used: flight.number <= 10,
        })
        .collect();
    let line = Line::from(&fit);
    Ok(figure::flight_times(&drawn, Some(line), translator))
}

/// Figs. 6 and 7: drag over weight, of both models.
pub(super) fn drag(axes: DragAxes, fastest_m_s: f64, translator: &Translator) -> Result<Chart> {
    let curves = [
        (
            "C_D(Re): Clift, Grace, Weber",
            DragLaw::Standard,
            Meaning::Drag,
        ),
        ("C_D = 0.4", CONSTANT, Meaning::Plain),
    ]
    .into_iter()
    .map(|(name, law, meaning)| {
        let model = model(law)?;
        let points = (0..=300)
            .map(|step| 0.1 * (fastest_m_s / 0.1).powf(f64::from(step) / 300.0))
            .map(|speed| Ok([speed, model.drag_over_weight(speed)?]))
            .collect::<bouncelab::Result<Vec<_>>>()?;
        Ok(Curve {
            name: name.to_owned(),
            meaning,
            points,
        })
    })
    .collect::<Result<Vec<Curve>>>()?;
    let fastest = model(CONSTANT)?
        .fall(experiment::DROP_HEIGHT_M)?
        .impact_speed_m_s;
    Ok(figure::drag(&curves, axes, Some(fastest), translator))
}

/// Fig. 8: the whole history with both models: they agree to the eye.
fn height_with_drag(translator: &Translator) -> Result<Chart> {
    let history = |law| dropped(&model(law)?, SIMULATED, Stop::below(1e-5));
    Ok(figure::height(
        "height",
        &[
            curve("C_D = 0.4", Meaning::Plain, &history(CONSTANT)?),
            curve("C_D(Re)", Meaning::Drag, &history(DragLaw::Standard)?),
        ],
        &[],
        translator,
    ))
}
