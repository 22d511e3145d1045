//! Simulates drops and their sound.

use bouncelab::analysis::Options;
use bouncelab::demo;
use bouncelab::drag::DragLaw;
use bouncelab::drop::{History, Start, Stop};
use bouncelab::impact::ImpactEvent;
use bouncelab::synth::{self, BitDepth, Noise, Rendered, Scene, Voice};
use bouncelab_report::Chart;
use bouncelab_report::chart::Point;
use bouncelab_report::document::simulation::{Document, Run};
use bouncelab_report::figure;
use bouncelab_report::messages::Translator;
use bouncelab_report::theme::Meaning;

use crate::refusal::{Result, unknown};
use crate::wire::{Demo, SceneRequest, SimulationRequest, SimulationRun};

/// Points of a curve.
const POINTS: usize = 4000;

/// Simulates the drop of a request under each of its drag laws.
///
/// # Errors
///
/// If something in the request is out of range.
pub fn simulate(request: &SimulationRequest, translator: &Translator) -> Result<Document> {
    let setup = request.settings.resolve()?;
    let settings = &setup.options;
    let compared = request.compare.iter().flatten();
    let compared: Vec<DragLaw> = compared
        .map(|law| law.parse())
        .collect::<bouncelab::Result<_>>()?;
    let laws = std::iter::once(settings.environment.drag.clone()).chain(compared);
    let runs = laws
        .map(|law| run(law, settings, request))
        .collect::<Result<Vec<Run>>>()?;
    let mut assumptions = setup.assumptions.clone();
    translator.complete_each(&mut assumptions);
    Ok(Document::new(&runs, settings, &assumptions))
}

/// Time and height of the drop of a request, moved so that its first impact is at a given time.
///
/// # Errors
///
/// If something in the request is out of range.
pub fn moved_curve(request: &SimulationRequest, first_s: f64) -> Result<Vec<Point>> {
    let history = history(&request.settings.resolve()?.options, request)?;
    let first_bounce = history.bounces().first();
    let shift_s = first_s - first_bounce.map_or(0.0, |bounce| bounce.time_s);
    let points = figure::curve_of(&history, POINTS).into_iter();
    Ok(points
        .map(|[time_s, height_m]| [time_s + shift_s, height_m])
        .collect())
}

/// Charts that compare simulated drops, the last of which is the present one.
///
/// # Errors
///
/// If something in a request is out of range.
pub fn charts(runs: &[SimulationRun], translator: &Translator) -> Result<[Chart; 2]> {
    let histories = runs.iter().map(|run| {
        let settings = run.request.settings.resolve()?.options;
        let present = if settings.environment.drag == DragLaw::None {
            Meaning::Plain
        } else {
            Meaning::Drag
        };
        Ok((present, history(&settings, &run.request)?))
    });
    let histories = histories.collect::<Result<Vec<(Meaning, History)>>>()?;
    let drawn = runs.iter().zip(&histories).enumerate();
    let drawn = drawn.map(|(index, (run, (present, history)))| figure::Run {
        name: run.name.clone(),
        meaning: if index + 1 == runs.len() {
            *present
        } else {
            Meaning::Group(index + 2)
        },
        history,
    });
    Ok(figure::runs(&drawn.collect::<Vec<_>>(), translator))
}

fn run(law: DragLaw, settings: &Options, request: &SimulationRequest) -> Result<Run> {
    let start = Start::Height(request.height_m);
    let bounces = request.bounces.map(|bounces| bounces as usize);
    let stop = Stop::asked(request.until_m, bounces);
    let restitution = request.restitution.parse()?;
    Ok(Run::simulate(law, settings, restitution, start, stop)?)
}

fn history(settings: &Options, request: &SimulationRequest) -> Result<History> {
    Ok(run(settings.environment.drag.clone(), settings, request)?.history)
}

/// The sound of the drop of a request, under the drag law of its settings.
///
/// # Errors
///
/// If something in the request or the scene is out of range.
pub fn synthesise(request: &SimulationRequest, scene: &SceneRequest) -> Result<Rendered> {
    let setup = request.settings.resolve()?;
    let history = history(&setup.options, request)?;
    let voice =
        Voice::named(&scene.voice).ok_or_else(|| unknown("voice", &scene.voice, &Voice::NAMES))?;
    let events: Vec<ImpactEvent> = history.impact_events().collect();
    let scene_of_it = Scene {
        sample_rate_hz: scene.sample_rate_hz,
        lead_in_s: scene.lead_in_s,
        tail_s: scene.tail_s,
        voice,
        noise: scene.snr_db.map(Noise::pink),
        bit_depth: BitDepth::Float,
        ..Scene::default()
    };
    Ok(synth::render(&events, &scene_of_it, u64::from(scene.seed))?)
}

/// The drop of the demo, and how it sounds.
///
/// # Errors
///
/// None with the numbers of the demo.
pub fn demo(seed: u64) -> Result<(Demo, Rendered)> {
    let sound = demo::sound(&demo::history()?, seed)?;
    let demo = Demo {
        name: "demo.wav".to_owned(),
        settings: demo::settings(),
        restitution: demo::RESTITUTION,
        drop_height_m: demo::DROP_HEIGHT_M,
    };
    Ok((demo, sound))
}
