//! `bouncelab demo`: a drop synthesised and analysed, with a comparison of truth and result.

use std::path::{Path, PathBuf};

use bouncelab::Estimate;
use bouncelab::Plain;
use bouncelab::demo;
use bouncelab::drop::History;
use bouncelab::synth::Rendered;
use bouncelab_audio::{SampleFormat, encode_wav};
use bouncelab_report::file::{Outputs, create_folder};
use bouncelab_report::mark::Mark;
use bouncelab_report::{Align, Quantity, Table, Unit};
use clap::Args;

use crate::analyze::{Analysed, Stems, read, save_figures};
use crate::failure::Failure;
use crate::language::{text, text_with, translator};
use crate::report::{OutputArguments, write};
use crate::terminal::print as print_result;

/// Synthesise and analyse a known drop, and compare the result with the truth
///
/// The drop is that of the paper: a 38 mm table-tennis ball from 30.5 cm, with drag. Its sound is
/// written to a WAV file and analysed like a recording; figures are drawn.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Folder for the recording and the figures
    #[arg(long, value_name = "DIR", default_value = "bouncelab-demo")]
    output: PathBuf,
    /// Seed of the noise and of the differences between impacts
    #[arg(long, default_value_t = 1)]
    seed: u64,
    #[command(flatten)]
    outputs: OutputArguments,
}

const EXAMPLES: &str = "\
Examples:
  bouncelab demo
  bouncelab demo --output /tmp/demo --seed 7";

pub(crate) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let setup = demo::settings().resolve()?;
    let history = demo::history()?;
    let sound = demo::sound(&history, arguments.seed)?;
    let outputs = arguments.outputs.of_no_input();
    let recording = write_recording(&sound, &arguments.output, &outputs)?;
    let analysed = read(&recording, &setup.options, false)?;
    print(&analysed, &history, &sound, &recording)?;
    save_figures(
        &analysed,
        &setup,
        &arguments.output,
        &mut Stems::default(),
        &outputs,
    )
}

fn write_recording(sound: &Rendered, folder: &Path, outputs: &Outputs) -> Result<PathBuf, Failure> {
    create_folder(folder).map_err(|reason| {
        Failure::Input(format!(
            "cannot make the folder {}: {reason}",
            Plain::path(folder)
        ))
    })?;
    let path = folder.join("demo.wav");
    let format = SampleFormat::Int16;
    let wav = encode_wav(sound.sample_rate_hz, format, &[&sound.samples])?;
    write(outputs, &path, Mark::NONE, &wav)?;
    Ok(path)
}

fn print(
    analysed: &Analysed,
    history: &History,
    sound: &Rendered,
    recording: &Path,
) -> Result<(), Failure> {
    let file = String::from(Plain::path(recording));
    let heading = text_with("demo-heading", &[("file", file.into())]);
    let table = comparison(analysed, history, sound);
    let conclusion = text("demo-conclusion");
    print_result(format_args!("{heading}\n\n{table}\n{conclusion}\n"))
}

/// Truth and result side by side.
fn comparison(analysed: &Analysed, history: &History, sound: &Rendered) -> Table {
    let mut table = Table::with_headings(
        translator(),
        [
            ("", Align::Left),
            ("demo-truth", Align::Right),
            ("demo-detected", Align::Right),
        ],
    );
    let cannot_tell = || text("unit-cannot-tell");
    let Some(drop) = analysed.result.drops.first() else {
        table.row([text("column-drop"), "1".to_owned(), cannot_tell()]);
        return table;
    };
    table.row([
        text("column-impacts"),
        sound.impacts.len().to_string(),
        drop.impacts.len().to_string(),
    ]);
    let exact = Quantity::rounded(0.0, 1, Unit::Time);
    let mut row = |id: &str, truth: Quantity, found: Option<Quantity>| {
        let found = found.map_or_else(cannot_tell, |found| found.text(translator()));
        table.row([text(id), truth.text(translator()), found]);
    };
    let error = largest_error(analysed, sound);
    row("demo-flight-time-error", exact, Some(error));
    let restitution = Quantity::rounded(demo::RESTITUTION, 4, Unit::Number);
    let height = Quantity::rounded(demo::DROP_HEIGHT_M, 3, Unit::Length);
    let shown = |found: Option<Estimate>, unit: Unit| found.map(|found| Quantity::of(&found, unit));
    let line = drop.log_linear_fit.as_ref().ok();
    let inferred = drop.posterior.as_ref().ok();
    let found = shown(line.map(|line| line.restitution), Unit::Number);
    row("demo-restitution-line", restitution, found);
    let found = shown(inferred.map(|found| found.restitution), Unit::Number);
    row("demo-restitution-inference", restitution, found);
    let found = shown(line.map(|line| line.drop_height_m), Unit::Length);
    row("demo-height-line", height, found);
    let found = shown(inferred.map(|found| found.drop_height_m), Unit::Length);
    row("demo-height-inference", height, found);
    let second = history.bounces().get(1);
    let second = second.map_or(f64::NAN, |bounce| bounce.impact_speed_m_s);
    let speed = |value| Quantity::rounded(value, 4, Unit::Speed);
    let per_impact = drop.per_impact.as_ref().ok();
    let found = per_impact.and_then(|found| found.impacts.first());
    let found = found.map(|impact| speed(impact.impact_speed_m_s));
    row("demo-second-speed", speed(second), found);
    table
}

/// The largest difference between a measured flight time and the true one.
fn largest_error(analysed: &Analysed, sound: &Rendered) -> Quantity {
    let truth = sound
        .impacts
        .windows(2)
        .map(|pair| pair[1].time_s - pair[0].time_s);
    let measured = &analysed.result.drops[0].flights;
    let errors = measured.iter().map(|flight| {
        let true_s = truth.clone().nth(flight.number - 1).unwrap_or(f64::NAN);
        (flight.flight_time_s - true_s).abs()
    });
    Quantity::rounded(errors.fold(0.0, f64::max), 2, Unit::Time)
}
