//! `bouncelab demo`: a drop from end to end, with the truth beside the result.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use bouncelab::Estimate;
use bouncelab::drop::History;
use bouncelab::synth::Rendered;
use bouncelab::{ball, demo};
use bouncelab_audio::{SampleFormat, encode_wav};
use bouncelab_report::file::write_whole;
use bouncelab_report::{Align, CANNOT_TELL, Quantity, Table, Unit};
use clap::Args;

use crate::analyze::{Analysed, Stems, read, save_figures};
use crate::failure::Failure;
use crate::physics::Physics;

/// Make, hear and analyse a drop, and print the truth beside the result
///
/// The drop is that of the paper: a 38 mm table-tennis ball from 30.5 cm, with drag. Its sound is
/// written to a WAV file, analysed as if it had been recorded, and drawn.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Folder for the recording and the figures
    #[arg(long, value_name = "DIR", default_value = "bouncelab-demo")]
    output: PathBuf,
    /// Seed of the noise and of the small differences between impacts
    #[arg(long, default_value_t = 1)]
    seed: u64,
}

const EXAMPLES: &str = "\
Examples:
  bouncelab demo
  bouncelab demo --output /tmp/demo --seed 7";

pub(crate) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let physics = Physics {
        options: demo::settings()?,
        ball_label: ball::preset(demo::BALL)?.label.to_owned(),
        assumptions: Vec::new(),
    };
    let history = demo::history()?;
    let sound = demo::sound(&history, arguments.seed)?;
    let recording = write_recording(&sound, &arguments.output)?;
    let analysed = read(&recording, &physics.options, false)?;
    print(&analysed, &history, &sound, &recording)?;
    save_figures(
        &analysed,
        &physics,
        &arguments.output,
        &mut Stems::default(),
    )
}

fn write_recording(sound: &Rendered, folder: &Path) -> Result<PathBuf, Failure> {
    std::fs::create_dir_all(folder).map_err(|reason| {
        Failure::Input(format!(
            "cannot make the folder {}: {reason}",
            folder.display()
        ))
    })?;
    let path = folder.join("demo.wav");
    let format = SampleFormat::Int16;
    let wav = encode_wav(sound.sample_rate_hz, format, &[&sound.samples])?;
    write_whole(&path, &wav).map_err(|reason| Failure::unwritable(&path, &reason))?;
    eprintln!("wrote {}", path.display());
    Ok(path)
}

fn print(
    analysed: &Analysed,
    history: &History,
    sound: &Rendered,
    recording: &Path,
) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    writeln!(
        out,
        "A drop from 30.5 cm, made, heard and analysed ({})",
        recording.display()
    )?;
    writeln!(out)?;
    writeln!(out, "{}", comparison(analysed, history, sound))?;
    writeln!(
        out,
        "The straight line takes the drag for lost bounciness and falls short in height;"
    )?;
    writeln!(
        out,
        "the inference knows the air, and finds the restitution and the height again."
    )?;
    Ok(())
}

/// Truth and result side by side.
fn comparison(analysed: &Analysed, history: &History, sound: &Rendered) -> Table {
    let mut table = Table::new([
        ("", Align::Left),
        ("truth", Align::Right),
        ("heard", Align::Right),
    ]);
    let Some(drop) = analysed.result.drops.first() else {
        table.row(["drop", "1", CANNOT_TELL]);
        return table;
    };
    let number = |value: f64| Quantity::rounded(value, 4, Unit::Number).to_string();
    table.row([
        "impacts".to_owned(),
        sound.impacts.len().to_string(),
        drop.impacts.len().to_string(),
    ]);
    table.row([
        "largest error of a flight time".to_owned(),
        "0 \u{b5}s".to_owned(),
        largest_error(analysed, sound),
    ]);
    let estimate = |found: Option<Estimate>, unit: Unit| {
        found.map_or_else(
            || CANNOT_TELL.to_owned(),
            |e| Quantity::measured(e.value, e.known_sd().unwrap_or(0.0), unit).to_string(),
        )
    };
    let line = drop.log_linear_fit.as_ref().ok();
    table.row([
        "e, straight line of ten flights".to_owned(),
        number(demo::RESTITUTION),
        estimate(line.map(|line| line.restitution), Unit::Number),
    ]);
    let inferred = drop.posterior.as_ref().ok();
    let answer = |found: Option<Estimate>, unit: Unit| {
        found.map_or_else(
            || CANNOT_TELL.to_owned(),
            |s| Quantity::measured(s.value, s.sd, unit).to_string(),
        )
    };
    table.row([
        "e, inference".to_owned(),
        number(demo::RESTITUTION),
        answer(inferred.map(|found| found.restitution), Unit::Number),
    ]);
    table.row([
        "drop height, straight line".to_owned(),
        Quantity::rounded(demo::DROP_HEIGHT_M, 3, Unit::Length).to_string(),
        estimate(line.map(|line| line.drop_height_m), Unit::Length),
    ]);
    table.row([
        "drop height, inference".to_owned(),
        Quantity::rounded(demo::DROP_HEIGHT_M, 3, Unit::Length).to_string(),
        answer(inferred.map(|found| found.drop_height_m), Unit::Length),
    ]);
    let second = history
        .bounces()
        .get(1)
        .map_or(f64::NAN, |bounce| bounce.impact_speed_m_s);
    let found = drop
        .corrected
        .as_ref()
        .ok()
        .and_then(|found| found.impacts.first());
    table.row([
        "speed of the second impact".to_owned(),
        Quantity::rounded(second, 4, Unit::Speed).to_string(),
        found.map_or_else(
            || CANNOT_TELL.to_owned(),
            |impact| Quantity::rounded(impact.impact_speed_m_s, 4, Unit::Speed).to_string(),
        ),
    ]);
    table
}

/// The largest difference between a flight time heard and the true one.
fn largest_error(analysed: &Analysed, sound: &Rendered) -> String {
    let truth = sound
        .impacts
        .windows(2)
        .map(|pair| pair[1].time_s - pair[0].time_s);
    let heard = &analysed.result.drops[0].flights;
    let errors = heard.iter().map(|flight| {
        let true_s = truth.clone().nth(flight.number - 1).unwrap_or(f64::NAN);
        (flight.time_s - true_s).abs()
    });
    Quantity::rounded(errors.fold(0.0, f64::max), 2, Unit::Time).to_string()
}
