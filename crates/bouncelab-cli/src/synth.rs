//! `bouncelab synth`: the synthetic recording of a drop.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};

use bouncelab::Plain;
use bouncelab::impact::ImpactEvent;
use bouncelab::synth::{self, BitDepth, Clicks, Hum, Lost, Noise, Rendered, Reverb, Scene, Voice};
use bouncelab_audio::{SampleFormat, encode_wav};
use bouncelab_report::columns;
use bouncelab_report::data_table::Formulas;
use bouncelab_report::mark::Mark;
use bouncelab_report::messages::Value;
use clap::builder::{PathBufValueParser, TypedValueParser};
use clap::{Args, ValueEnum};

use crate::failure::Failure;
use crate::history::HistoryArguments;
use crate::language::text_with;
use crate::report::OutputArguments;
use crate::settings::PhysicsArguments;
use crate::terminal::print;
use crate::units;

/// Synthesise the recording of a drop as a WAV file
///
/// The same arguments and seed give the same recording. `--truth` writes the true impact times in a
/// form that `analyze` reads.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// The recording to write
    #[arg(value_name = "OUT.wav", value_parser = wav())]
    output: PathBuf,
    /// Write the true impact times, as .txt, .csv or .json
    #[arg(long, value_name = "FILE")]
    truth: Option<PathBuf>,
    #[command(flatten)]
    outputs: OutputArguments,
    /// Seed of the random numbers
    #[arg(long, default_value_t = 1, help_heading = "Sound")]
    seed: u64,
    /// Sound of an impact: table-tennis, steel-ball, basketball or tennis
    #[arg(long, default_value = "table-tennis", help_heading = "Sound", value_parser = voice)]
    voice: Voice,
    /// Signal-to-noise ratio of the first impact, in dB
    #[arg(
        long,
        value_name = "DB",
        default_value_t = 40.0,
        allow_hyphen_values = true,
        help_heading = "Sound"
    )]
    snr: f64,
    /// Spectrum of the background noise
    #[arg(long, value_enum, default_value_t = Background::Pink, help_heading = "Sound")]
    noise: Background,
    /// Mains hum of this frequency in Hz, 20 dB below the first impact
    #[arg(
        long,
        value_name = "HZ",
        allow_hyphen_values = true,
        help_heading = "Sound"
    )]
    hum: Option<f64>,
    /// Reverberation time (decay by 60 dB), as in 0.4s
    #[arg(long, value_name = "TIME", allow_hyphen_values = true, value_parser = units::time, help_heading = "Sound")]
    reverb: Option<f64>,
    /// Clicks per second that are not impacts
    #[arg(
        long,
        value_name = "RATE",
        allow_hyphen_values = true,
        help_heading = "Sound"
    )]
    clicks: Option<f64>,
    /// Share of the impacts left out of the sound, as in 10%
    #[arg(long, value_name = "SHARE", allow_hyphen_values = true, value_parser = units::share, help_heading = "Sound")]
    lost: Option<f64>,
    /// Clip the signal at this share of full scale, as in 50%
    #[arg(long, value_name = "SHARE", allow_hyphen_values = true, value_parser = units::share, help_heading = "Sound")]
    clip: Option<f64>,
    /// Time before the release, as in 0.5s
    #[arg(long, value_name = "TIME", default_value = "0.5s", allow_hyphen_values = true, value_parser = units::time, help_heading = "Sound")]
    lead_in: f64,
    /// Time after the last impact, as in 0.5s
    #[arg(long, value_name = "TIME", default_value = "0.5s", allow_hyphen_values = true, value_parser = units::time, help_heading = "Sound")]
    tail: f64,
    /// Sample rate
    #[arg(
        long,
        value_name = "HZ",
        default_value_t = 44_100,
        help_heading = "Sound"
    )]
    sample_rate: u32,
    /// Sample format
    #[arg(long, value_enum, default_value_t = Bits::Sixteen, help_heading = "Sound")]
    bits: Bits,
    #[command(flatten)]
    history: HistoryArguments,
    #[command(flatten)]
    physics: PhysicsArguments,
}

const EXAMPLES: &str = "\
Examples:
  bouncelab synth drop.wav
  bouncelab synth drop.wav --height 1m --restitution 0.9 --snr 20 --truth truth.csv
  bouncelab synth gym.wav --ball basketball --voice basketball --height 1.8m --restitution 0.85
  bouncelab synth hard.wav --snr 10 --clicks 2 --lost 10% --reverb 0.4s --hum 50 --seed 7";

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Background {
    /// Equal power per hertz
    White,
    /// Equal power per octave, like most background noise indoors
    Pink,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Bits {
    /// 8-bit integers
    #[value(name = "8")]
    Eight,
    /// 16-bit integers
    #[value(name = "16")]
    Sixteen,
    /// 24-bit integers
    #[value(name = "24")]
    TwentyFour,
    /// 32-bit floating point
    #[value(name = "float")]
    Float,
}

impl Bits {
    fn depth(self) -> BitDepth {
        match self {
            Self::Eight => BitDepth::Eight,
            Self::Sixteen => BitDepth::Sixteen,
            Self::TwentyFour => BitDepth::TwentyFour,
            Self::Float => BitDepth::Float,
        }
    }

    fn format(self) -> SampleFormat {
        match self {
            Self::Eight => SampleFormat::Int8,
            Self::Sixteen => SampleFormat::Int16,
            Self::TwentyFour => SampleFormat::Int24,
            Self::Float => SampleFormat::Float32,
        }
    }
}

/// A name that says what is in the file, since other names mean other things to `analyze`.
pub(crate) fn wav() -> impl TypedValueParser<Value = PathBuf> {
    PathBufValueParser::new().try_map(|file| {
        let ending = file.extension().unwrap_or_default();
        if ending.eq_ignore_ascii_case("wav") {
            Ok(file)
        } else {
            Err("the sound is saved as WAV: name a file that ends in .wav")
        }
    })
}

fn voice(name: &str) -> Result<Voice, String> {
    Voice::named(name).ok_or_else(|| {
        format!(
            "no voice is called \"{name}\"; known: {}",
            Voice::NAMES.join(", ")
        )
    })
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let physics = arguments.physics.resolve(arguments.history.question())?;
    let truth = arguments
        .truth
        .as_deref()
        .map(TruthFormat::of)
        .transpose()?;
    let outputs = arguments.outputs.of_no_input();
    for file in std::iter::once(&arguments.output).chain(&arguments.truth) {
        let allowed = outputs.check(file, Mark::NONE);
        allowed.map_err(|reason| Failure::unwritable(file, &reason))?;
    }
    let options = &physics.options;
    let run = arguments
        .history
        .run(options.environment.drag.clone(), options)?;
    let events: Vec<ImpactEvent> = run.history.impact_events().collect();
    let sound = synth::render(&events, &arguments.scene(), arguments.seed)?;
    let format = arguments.bits.format();
    let wav = encode_wav(sound.sample_rate_hz, format, &[&sound.samples])?;
    let write = |file: &Path, bytes: &[u8]| {
        let written = outputs.write(file, Mark::NONE, bytes);
        written.map_err(|reason| Failure::unwritable(file, &reason))
    };
    write(&arguments.output, &wav)?;
    if let (Some(file), Some(format)) = (&arguments.truth, truth) {
        write(file, format.text(&sound).as_bytes())?;
    }
    let seconds = sound.samples.len() as f64 / f64::from(sound.sample_rate_hz);
    let audible = sound.impacts.iter().filter(|impact| !impact.lost).count();
    let made = [
        ("file", String::from(Plain::path(&arguments.output)).into()),
        ("count", audible.into()),
        ("seconds", Value::fixed(seconds, 1)),
        ("rate", sound.sample_rate_hz.into()),
        ("seed", arguments.seed.into()),
    ];
    print(text_with("synth-made", &made) + "\n")
}

impl Arguments {
    fn scene(&self) -> Scene {
        Scene {
            sample_rate_hz: self.sample_rate,
            lead_in_s: self.lead_in,
            tail_s: self.tail,
            voice: self.voice.clone(),
            noise: Some(match self.noise {
                Background::White => Noise::white(self.snr),
                Background::Pink => Noise::pink(self.snr),
            }),
            hum: self.hum.map(Hum::mains),
            reverb: self.reverb.map(Reverb::of_time),
            clicks: self.clicks.map(Clicks::often),
            lost: self.lost.map_or(Lost::None, Lost::Chance),
            clip_at: self.clip,
            bit_depth: self.bits.depth(),
            ..Scene::default()
        }
    }
}

/// How true impact times are written; `analyze` reads all three.
#[derive(Clone, Copy)]
enum TruthFormat {
    Text,
    Csv,
    Json,
}

impl TruthFormat {
    fn of(file: &Path) -> Result<Self, Failure> {
        let ending = file.extension().map(OsStr::to_ascii_lowercase);
        match ending.as_ref().and_then(|ending| ending.to_str()) {
            Some("txt") => Ok(Self::Text),
            Some("csv") => Ok(Self::Csv),
            Some("json") => Ok(Self::Json),
            _ => Err(Failure::Usage(format!(
                "--truth {}: the name must end in .txt, .csv or .json",
                Plain::path(file)
            ))),
        }
    }

    fn text(self, sound: &Rendered) -> String {
        let times = sound.impacts.iter().map(|impact| impact.time_s.to_string());
        match self {
            Self::Text => times.map(|time| time + "\n").collect::<Vec<_>>().concat(),
            Self::Json => format!("[{}]\n", times.collect::<Vec<_>>().join(", ")),
            Self::Csv => columns::truth(sound).csv(Formulas::Guarded),
        }
    }
}
