//! `bouncelab listen`: live detection and analysis.
//!
//! Sound comes from a microphone or, by the same path, from a file (`sound`). A thread of its own
//! (`recording`) saves it as it comes (`save`), whatever happens to the rest: it is searched for drops
//! (`watch`), the progress shows on the terminal (`screen`), and each drop is analysed once it is over
//! (`session`).

mod recording;
mod save;
mod screen;
mod session;
mod sketch;
mod sound;
mod summary;
mod watch;

use std::path::{Path, PathBuf};

use bouncelab::settings::Setup;
use clap::{Args, ValueEnum};

use crate::failure::Failure;
use crate::settings::RecordingArguments;
use crate::synth::wav;
use crate::units;

/// Record with the microphone and analyse drops live, until Ctrl-C
///
/// Each drop is analysed when the ball rests, with the results of `analyze`; a table of all drops
/// follows at the end. The sound is saved as WAV while it is recorded. Exit status: 0 if a drop was
/// detected, 1 if none was or the sound was interrupted, 2 for wrong usage.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
#[expect(clippy::struct_excessive_bools, reason = "each is a flag of its own")]
pub(crate) struct Arguments {
    /// Play a recording instead of using the microphone
    #[arg(long, value_name = "FILE")]
    from: Option<PathBuf>,
    /// Play it as fast as possible instead of in real time
    #[arg(long, requires = "from")]
    fast: bool,
    /// The microphone, by its name in --devices or a part of it (default: that of the system)
    #[arg(long, value_name = "NAME", conflicts_with = "from")]
    device: Option<String>,
    /// List the microphones and exit
    #[arg(long, conflicts_with_all = ["from", "device", "save"])]
    devices: bool,
    /// The WAV file to save the sound in; no file is overwritten (default: bouncelab- and the date;
    /// with --from, none)
    #[arg(long, value_name = "FILE.wav", conflicts_with = "no_save", value_parser = wav())]
    save: Option<PathBuf>,
    /// Do not save the sound
    #[arg(long)]
    no_save: bool,
    /// Stop after this number of drops
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    drops: Option<u64>,
    /// Stop after this time, as in 60s or 5min
    #[arg(long, value_name = "TIME", value_parser = duration)]
    seconds: Option<f64>,
    /// How to print the result; JSON is documented in docs/json.md
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Print also the probability of each impact, the compared laws, the uncertainty budget and the
    /// priors
    #[arg(long)]
    details: bool,
    #[command(flatten)]
    recording: RecordingArguments,
}

const EXAMPLES: &str = "\
Examples:
  bouncelab listen                                 until Ctrl-C
  bouncelab listen --ball tennis --drops 10 --save class.wav
  bouncelab listen --devices                       the microphones of this computer
  bouncelab listen --device USB --seconds 5min --format json
  bouncelab listen --which-ball                    which of the known balls fits each drop best?
  bouncelab listen --from drop.wav                 play a recording in real time
  bouncelab listen --from drop.wav --fast";

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// For people
    Text,
    /// For programs: one object per line, for each drop
    Json,
}

impl Arguments {
    fn task(&self) -> Task {
        Task {
            source: Source {
                from: self.from.clone(),
                fast: self.fast,
                device: self.device.clone(),
            },
            save: match &self.save {
                Some(file) => Save::Named(file.clone()),
                None if self.no_save || self.from.is_some() => Save::Nowhere,
                None => Save::Dated,
            },
            drops: self.drops,
            seconds: self.seconds,
            output: match self.format {
                Format::Text => Output::Text {
                    details: self.details,
                },
                Format::Json => Output::Json,
            },
        }
    }
}

/// A microphone, or a recording that is played.
#[derive(Clone)]
pub(crate) struct Source {
    /// The recording; without one the microphone.
    pub(crate) from: Option<PathBuf>,
    /// Whether it is played as fast as possible.
    pub(crate) fast: bool,
    /// The microphone, by a part of its name; without one that of the system.
    #[cfg_attr(
        not(feature = "microphone"),
        expect(
            dead_code,
            reason = "a program built without the microphone never reads it"
        )
    )]
    pub(crate) device: Option<String>,
}

/// Where the sound is saved.
enum Save {
    Nowhere,
    Named(PathBuf),
    /// In the current folder, named after the date.
    Dated,
}

/// What is printed of each drop.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Output {
    Text { details: bool },
    Json,
    Nothing,
}

/// What is listened to, for how long, and what becomes of it.
struct Task {
    source: Source,
    save: Save,
    drops: Option<u64>,
    seconds: Option<f64>,
    output: Output,
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), Failure> {
    if arguments.devices {
        return sound::list_devices();
    }
    session::run(&arguments.task(), arguments.recording.resolve()?)
}

/// Records one drop into a file, with nothing printed but the progress.
pub(crate) fn one_drop(source: &Source, setup: Setup, file: &Path) -> Result<(), Failure> {
    let task = Task {
        source: source.clone(),
        save: Save::Named(file.to_owned()),
        drops: Some(1),
        seconds: None,
        output: Output::Nothing,
    };
    session::run(&task, setup)
}

fn duration(text: &str) -> Result<f64, String> {
    let time_s = units::time(text)?;
    if time_s > 0.0 {
        Ok(time_s)
    } else {
        Err("the time must be more than 0".to_owned())
    }
}
