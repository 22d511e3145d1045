//! `bouncelab session`: statistics of many drops.

mod text;
mod work;
mod worker;

use std::io;
use std::path::PathBuf;

use bouncelab::Plain;
use bouncelab_report::columns::TableKind;
use bouncelab_report::file::{Outputs, remove_drafts};
use bouncelab_report::groups::Question;
use bouncelab_report::mark;
use bouncelab_session::batch::Batch;
use bouncelab_session::journal::{JOURNAL, Journal};
use bouncelab_session::table::Form;
use bouncelab_session::{
    Advice, DOCUMENT_MARK, MetadataOptions, Outcome, Results, Session, Sources, Store,
    StudyOptions, figures, report, write_tables,
};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};

use crate::analyze::formulas;
use crate::failure::Failure;
use crate::language::{text as message, text_with, translator};
use crate::report::{OutputArguments, ReportFile, provenance, wrote_figure};
use crate::settings::{SettingsArguments, impact_speed};
use crate::terminal::{print, print_data, say};

/// Analyse many recordings: restitution curves, scatter and differences of their drops
///
/// Takes recordings, folders or ZIP archives of recordings, or a session.toml with their metadata (see
/// docs/session.md). Results are saved after each recording: a stopped run continues when it is
/// started again. Exit status: 0 if there is a result, 1 if no drop was found, 2 for wrong usage or
/// contradictory metadata.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
#[expect(clippy::struct_excessive_bools, reason = "each is a flag of its own")]
pub(crate) struct Arguments {
    /// Recordings, folders, ZIP archives, or a session.toml
    #[arg(
        required_unless_present = "from",
        value_name = "DIR|FILE|FILE.zip|session.toml"
    )]
    inputs: Vec<PathBuf>,
    /// Take the results of a cluster, a folder of Parquet, in place of recordings (see docs/cluster.md)
    #[arg(
        long,
        value_name = "DIR",
        conflicts_with_all = [
            "inputs", "pattern", "notes", "allow_missing", "jobs", "memory", "time_limit",
            "PhysicsArguments", "InferenceArguments"
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
    /// Metadata in a CSV with a column `recording` and one for each field
    #[arg(long, value_name = "FILE", help_heading = "Metadata")]
    notes: Option<PathBuf>,
    /// Accept recordings that lack a metadata field which others have
    #[arg(long, help_heading = "Metadata")]
    allow_missing: bool,
    /// Group the drops by these fields, or by '' all as one group [default: ball, surface and other fields, except
    /// operator, student, place, height and temperature]
    #[arg(
        long,
        value_name = "FIELDS",
        value_delimiter = ',',
        help_heading = "Comparison"
    )]
    by: Option<Vec<String>>,
    /// Compare the groups at this impact speed, as in 1.5m/s [default: a round one that they have in common]
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true, value_parser = impact_speed, help_heading = "Comparison")]
    compare_at: Option<f64>,
    /// State the number of drops needed for this half width of the 95 % interval of restitution, as in
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
    /// Formats of the tables of results
    #[arg(
        long,
        value_name = "FORMS",
        value_delimiter = ',',
        value_parser = form(),
        default_values = Form::ALL.map(Form::ending)
    )]
    tables: Vec<Form>,
    /// Leave texts in CSV as they are, even if a spreadsheet would run them as formulas
    #[arg(long)]
    csv_raw: bool,
    /// Write figures as SVG, PNG and PDF, and their data as CSV, into the output folder
    #[arg(long)]
    figures: bool,
    /// Write a report as one HTML file, as Markdown, or as PDF (printed by an installed Chromium, Chrome or Edge)
    #[arg(long, value_name = "FILE.html|FILE.md|FILE.pdf")]
    report: Option<PathBuf>,
    /// Recordings analysed in parallel [default: the number of processors]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    jobs: Option<u16>,
    /// Memory for the analysis of one recording, in MB; one that needs more is named, and the others go
    /// on (Linux)
    #[arg(long, value_name = "MB", default_value_t = 1024, value_parser = clap::value_parser!(u64).range(1..=1 << 20))]
    memory: u64,
    /// Processor time for the analysis of one recording, in seconds; one that takes longer is named, and the
    /// others go on (Linux)
    #[arg(long, value_name = "SECONDS", default_value_t = 600, value_parser = clap::value_parser!(u64).range(1..=1 << 20))]
    time_limit: u64,
    /// Analyse recordings for another process
    #[arg(long = worker::WORKER, hide = true)]
    worker: bool,
    #[command(flatten)]
    outputs: OutputArguments,
    #[command(flatten)]
    settings: SettingsArguments,
}

const EXAMPLES: &str = "\
Examples:
  bouncelab session recordings --pattern '{ball}_{surface}_{height}_{}'
  bouncelab session recordings --notes notes.csv --ball tennis
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
        // Only its lock is needed, which keeps other runs out of the folder.
        let _journal = Journal::open(&arguments.output)?;
        let batch = Batch::open(from)?;
        let outputs = arguments.outputs.outputs(batch.files());
        arguments.check(&outputs)?;
        let targets = Targets::new(arguments, &outputs)?;
        return targets.write(arguments, &batch.results(), None, None);
    }
    let settings = arguments.settings.settings()?;
    arguments.settings.resolve(&settings)?;
    let mut session = Session::gather(&Sources {
        inputs: arguments.inputs.clone(),
        pattern: arguments.pattern.clone(),
        notes: arguments.notes.clone(),
    })?;
    let outputs = arguments.outputs.outputs(session.inputs());
    arguments.check(&outputs)?;
    let title = session.title.take();
    let remark = session.unmatched_names.remark(translator());
    let recordings = MetadataOptions {
        settings: &settings,
        allow_implausible: arguments.settings.allow_implausible(),
        allow_missing: arguments.allow_missing,
        translator: translator(),
        advice: Advice {
            implausible: &message("advice-allow-implausible"),
            missing: "or go on without by --allow-missing",
            ball: "or give the kind of all balls by --ball",
        },
    }
    .read(session)?;
    if arguments.worker {
        return worker::serve(&recordings, arguments.memory, arguments.time_limit);
    }
    let journal = Journal::open(&arguments.output)?;
    let targets = Targets::new(arguments, &outputs)?;
    if journal.damaged() > 0 {
        let count = [("count", journal.damaged().into())];
        let damaged = text_with("session-damaged-journal", &count);
        say(format_args!("bouncelab: {damaged}"));
    }
    let jobs = arguments.jobs.map(usize::from);
    let done = work::analyze_all(&recordings, &journal, jobs, arguments.time_limit)?;
    let kept = done.iter().filter(|done| done.kept).count();
    if kept > 0 {
        let counts = [("kept", kept.into()), ("all", recordings.len().into())];
        let known = text_with("session-known", &counts);
        say(format_args!("bouncelab: {known}"));
    }
    let results = Results {
        recordings: &recordings,
        done: &done,
        store: Store::Journal(&journal),
    };
    targets.write(arguments, &results, title, remark)
}

/// Where to write, opened before the long work.
struct Targets<'a> {
    outputs: &'a Outputs,
    report: Option<ReportFile<'a>>,
}

impl<'a> Targets<'a> {
    fn new(arguments: &Arguments, outputs: &'a Outputs) -> Result<Self, Failure> {
        let folder = &arguments.output;
        remove_drafts(folder).map_err(|reason| Failure::unwritable(folder, &reason))?;
        // It may lie in the same folder.
        let report = arguments.report.as_deref();
        let report = report.map(|path| ReportFile::new(path, outputs));
        Ok(Self {
            outputs,
            report: report.transpose()?,
        })
    }

    /// Studies results, and writes the requested output.
    fn write(
        self,
        arguments: &Arguments,
        results: &Results<'_>,
        title: Option<String>,
        remark: Option<String>,
    ) -> Result<(), Failure> {
        let (folder, outputs) = (&arguments.output, self.outputs);
        let mut outcome = Outcome::of(results, &arguments.study(), translator())?;
        outcome.groups.about.title = title;
        outcome.groups.about.remarks.extend(remark);
        let written = write_tables(&outcome, results, folder, &arguments.forms(), outputs)?;
        let json =
            serde_json::to_string_pretty(&outcome.document()).map_err(io::Error::from)? + "\n";
        let file = folder.join(DOCUMENT);
        let kept = outputs.write(&file, DOCUMENT_MARK, json.as_bytes());
        kept.map_err(|reason| Failure::unwritable(&file, &reason))?;
        let charts = if arguments.figures || self.report.is_some() {
            figures(&outcome, results, translator())?
        } else {
            Vec::new()
        };
        if arguments.figures {
            for (name, chart) in &charts {
                wrote_figure(&bouncelab_report::save(chart, folder, name, outputs)?);
            }
        }
        if let Some(file) = self.report {
            let page = report(&outcome, results, &charts, provenance(), translator());
            file.write(&page)?;
        }
        match arguments.format {
            Format::Json => print_data(&json)?,
            Format::Text => {
                let report = text::report(&outcome, arguments.details, arguments.want);
                let list = text_with("session-tables", &[("list", shown(&written).into())]);
                print(format_args!("{report}  {list}\n"))?;
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
        .map(|file| String::from(Plain::path(file)))
        .collect();
    names.join(", ")
}

/// The result for programs, in the folder of the results.
const DOCUMENT: &str = "session.json";

impl Arguments {
    /// The forms of tables.
    fn forms(&self) -> Vec<Form> {
        let form = |form: &Form| match form {
            Form::Csv(_) => Form::Csv(formulas(self.csv_raw)),
            form => *form,
        };
        self.tables.iter().map(form).collect()
    }

    /// Checks before the work that every output may be written.
    fn check(&self, outputs: &Outputs) -> Result<(), Failure> {
        let tables = self.tables.iter().flat_map(|form| {
            let tables = [TableKind::Drops, TableKind::Impacts];
            tables.map(|table| (form.path(&self.output, table.name()), form.mark()))
        });
        let pictures = ["groups", "intervals", "run"]
            .into_iter()
            .flat_map(|figure| {
                let marks = mark::FIGURES.into_iter().chain([("csv", mark::DATA)]);
                marks.map(move |(ending, mark)| {
                    (self.output.join(format!("{figure}.{ending}")), mark)
                })
            });
        let pictures = pictures.filter(|_| self.figures);
        let document = (self.output.join(DOCUMENT), DOCUMENT_MARK);
        let mut files = tables.chain(pictures).chain([document]);
        files.try_for_each(|(path, mark)| {
            let allowed = outputs.check(&path, mark);
            allowed.map_err(|reason| Failure::unwritable(&path, &reason))
        })?;
        let journal = self.output.join(JOURNAL);
        let allowed = outputs.check_unused(&journal);
        allowed.map_err(|reason| Failure::unwritable(&journal, &reason))
    }

    fn study(&self) -> StudyOptions {
        StudyOptions {
            question: Question {
                by: self.by.as_ref().map(|by| {
                    by.iter()
                        .filter(|field| !field.is_empty())
                        .cloned()
                        .collect()
                }),
                at_speed_m_s: self.compare_at,
                wanted: self.want,
            },
            exclude: self.exclude.clone(),
        }
    }
}
