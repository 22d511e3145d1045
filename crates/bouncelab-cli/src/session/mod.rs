//! `bouncelab session`: statistics of many drops.

mod report;
mod tables;
mod text;
mod work;

use std::fs;
use std::io::{self, Write};
use std::path::PathBuf;

use bouncelab_report::file::{remove_drafts, write_whole};
use bouncelab_session::batch::Batch;
use bouncelab_session::journal::Journal;
use bouncelab_session::table::Form;
use bouncelab_session::{
    Advice, MetadataOptions, Noted, Outcome, Results, Session, Sources, Store, StudyOptions,
    figures, write_tables,
};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};

use crate::failure::Failure;
use crate::language::{text as message, text_with, translator};
use crate::physics::PhysicsArguments;
use crate::priors::{PriorArguments, impact_speed};
use crate::report::{ReportFile, wrote_figure};
use bouncelab::setup::Setup;

/// Analyse many recordings: means, scatter and differences of their drops
///
/// Takes recordings, folders of recordings, or a session.toml with their metadata (see
/// docs/session.md). Results are saved after each recording: a stopped run continues when it is
/// started again. Exit status: 0 if there is a result, 1 if no drop was found, 2 for wrong usage or
/// contradictory metadata.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Recordings, folders, or a session.toml
    #[arg(required_unless_present = "from", value_name = "DIR|FILE|session.toml")]
    inputs: Vec<PathBuf>,
    /// Take the results of a cluster, a folder of Parquet, in place of recordings (see docs/cluster.md)
    #[arg(
        long,
        value_name = "DIR",
        conflicts_with_all = [
            "inputs", "pattern", "table", "allow_missing", "jobs", "PhysicsArguments", "PriorArguments"
        ]
    )]
    from: Option<PathBuf>,
    /// Folder for tables, journal and figures
    #[arg(long, value_name = "DIR", default_value = "bouncelab-session")]
    output: PathBuf,
    /// Metadata in the file names, as in {ball}_{surface}_{height}_{}; {} is ignored, and {height:cm}
    /// is a height without its unit
    #[arg(long, value_name = "PATTERN", help_heading = "Metadata")]
    pattern: Option<String>,
    /// CSV with a column `file` and one for each metadata field
    #[arg(long, value_name = "FILE", help_heading = "Metadata")]
    table: Option<PathBuf>,
    /// Accept recordings that lack a metadata field which others have
    #[arg(long, help_heading = "Metadata")]
    allow_missing: bool,
    /// Group the drops by these fields [default: ball, surface and other fields, except operator,
    /// height and temperature]
    #[arg(
        long,
        value_name = "FIELDS",
        value_delimiter = ',',
        help_heading = "Comparison"
    )]
    by: Vec<String>,
    /// Compare the drops at this impact speed, as in 1.5m/s [default: a speed that most drops cover]
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true, value_parser = impact_speed, help_heading = "Comparison")]
    compare_at: Option<f64>,
    /// State the number of drops needed for this half width of the 95 % interval of a mean, as in
    /// 0.001 [default: half of the present width]
    #[arg(
        long,
        value_name = "HALF_WIDTH",
        allow_hyphen_values = true,
        value_parser = half_width,
        help_heading = "Comparison"
    )]
    want: Option<f64>,
    /// Exclude a recording from the comparison, or with recording#2 its second drop; may be repeated
    #[arg(long, value_name = "NAME", help_heading = "Comparison")]
    exclude: Vec<String>,
    /// How to print the result; JSON is documented in docs/json.md
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// Print also intervals, all differences and all remarks
    #[arg(long)]
    details: bool,
    /// Tables to write
    #[arg(
        long,
        value_name = "FORMS",
        value_delimiter = ',',
        value_parser = form(),
        default_values = Form::ALL.map(Form::ending)
    )]
    tables: Vec<Form>,
    /// Write figures as SVG and PNG into the output folder
    #[arg(long)]
    figures: bool,
    /// Write a report as one HTML file, or as Markdown
    #[arg(long, value_name = "FILE.html|FILE.md")]
    report: Option<PathBuf>,
    /// Recordings analysed in parallel [default: the number of processors]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    jobs: Option<u16>,
    #[command(flatten)]
    physics: PhysicsArguments,
    #[command(flatten)]
    priors: PriorArguments,
}

const EXAMPLES: &str = "\
Examples:
  bouncelab session recordings --pattern '{ball}_{surface}_{height}_{}'
  bouncelab session recordings --table notes.csv --ball tennis
  bouncelab session session.toml --by surface --want 0.001
  bouncelab session session.toml --exclude red_steel_3.wav --details
  bouncelab session session.toml --report session.html
  bouncelab session --from results.parquet
  bouncelab session session.toml --format json > session.json";

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// For people
    Text,
    /// For programs
    Json,
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), Failure> {
    if let Some(from) = &arguments.from {
        let folder = &arguments.output;
        fs::create_dir_all(folder).map_err(|reason| Failure::unwritable(folder, &reason))?;
        let targets = Targets::new(arguments)?;
        return targets.write(arguments, &Batch::open(from)?.results(), None, Vec::new());
    }
    arguments.physics.questioned(arguments.priors.questions())?;
    let mut session = Session::gather(&Sources {
        inputs: arguments.inputs.clone(),
        pattern: arguments.pattern.clone(),
        table: arguments.table.clone(),
    })?;
    let title = session.title.take();
    let remarks = std::mem::take(&mut session.remarks);
    let recordings = MetadataOptions {
        resolve: &|noted| {
            arguments
                .setup(noted)
                .map_err(|failure| failure.to_string())
        },
        ball_is_known: arguments.physics.names_ball(),
        allow_implausible: arguments.physics.allow_implausible(),
        allow_missing: arguments.allow_missing,
        translator: translator(),
        advice: Advice {
            implausible: &message("advice-allow-implausible"),
            missing: "or go on without by --allow-missing",
            ball: "or give the kind of all balls by --ball",
        },
    }
    .read(session)?;
    let journal = Journal::open(&arguments.output)?;
    let targets = Targets::new(arguments)?;
    if journal.damaged() > 0 {
        let count = [("count", journal.damaged().into())];
        eprintln!(
            "bouncelab: {}",
            text_with("session-damaged-journal", &count)
        );
    }
    let done = work::analyze_all(&recordings, &journal, arguments.jobs.map(usize::from))?;
    let kept = done.iter().filter(|done| done.kept).count();
    if kept > 0 {
        let counts = [("kept", kept.into()), ("all", recordings.len().into())];
        eprintln!("bouncelab: {}", text_with("session-known", &counts));
    }
    let results = Results {
        recordings: &recordings,
        done: &done,
        store: Store::Journal(&journal),
    };
    targets.write(arguments, &results, title, remarks)
}

/// Where to write, opened before the long work.
struct Targets {
    report: Option<ReportFile>,
}

impl Targets {
    fn new(arguments: &Arguments) -> Result<Self, Failure> {
        let folder = &arguments.output;
        remove_drafts(folder).map_err(|reason| Failure::unwritable(folder, &reason))?;
        // It may lie in the same folder.
        let report = arguments.report.as_deref().map(ReportFile::new);
        Ok(Self {
            report: report.transpose()?,
        })
    }

    /// Studies results, and writes all that was asked for.
    fn write(
        self,
        arguments: &Arguments,
        results: &Results<'_>,
        title: Option<String>,
        remarks: Vec<String>,
    ) -> Result<(), Failure> {
        let folder = &arguments.output;
        let mut outcome = Outcome::of(results, &arguments.study(), translator())?;
        outcome.about.title = title;
        outcome.about.remarks.extend(remarks);
        let written = write_tables(&outcome, results, folder, &arguments.tables)?;
        let json =
            serde_json::to_string_pretty(&outcome.document()).map_err(io::Error::from)? + "\n";
        let place = folder.join("session.json");
        write_whole(&place, json.as_bytes())
            .map_err(|reason| Failure::unwritable(&place, &reason))?;
        if arguments.figures {
            for (name, figure) in figures(&outcome, results, translator())? {
                wrote_figure(&bouncelab_report::save(&figure, folder, name)?);
            }
        }
        if let Some(file) = self.report {
            file.write(&report::page(&outcome, results)?)?;
        }
        let mut out = io::stdout().lock();
        match arguments.format {
            Format::Json => out.write_all(json.as_bytes())?,
            Format::Text => {
                let text = text::report(&outcome, arguments.details, arguments.want);
                out.write_all(text.as_bytes())?;
                let list = [("list", shown(&written).into())];
                writeln!(out, "  {}", text_with("session-tables", &list))?;
            }
        }
        if outcome.drops.is_empty() {
            return Err(Failure::Input(message("session-no-drop")));
        }
        Ok(())
    }
}

/// A form of a table by the ending of its file.
fn form() -> impl TypedValueParser<Value = Form> {
    PossibleValuesParser::new(Form::ALL.map(Form::ending)).try_map(|ending| {
        let mut forms = Form::ALL.into_iter();
        forms
            .find(|form| form.ending() == ending)
            .ok_or("unknown form")
    })
}

fn half_width(text: &str) -> Result<f64, String> {
    let width = text.parse().ok();
    let width = width.filter(|&width: &f64| width > 0.0 && width.is_finite());
    width.ok_or_else(|| "a half width is a number above 0, as in 0.001".to_owned())
}

fn shown(files: &[PathBuf]) -> String {
    let names: Vec<String> = files
        .iter()
        .map(|file| file.display().to_string())
        .collect();
    names.join(", ")
}

impl Arguments {
    /// What was noted of a recording, completed by what the arguments say of all.
    fn setup(&self, noted: &Noted) -> Result<Setup, Failure> {
        let mut setup = self.physics.with(noted).physics()?;
        let priors = self.priors.with_height(noted.height_m, noted.height_sd_m);
        priors.add_to(&mut setup.options)?;
        Ok(setup)
    }

    fn study(&self) -> StudyOptions {
        StudyOptions {
            by: self.by.clone(),
            at_speed_m_s: self.compare_at,
            wanted: self.want,
            exclude: self.exclude.clone(),
        }
    }
}
