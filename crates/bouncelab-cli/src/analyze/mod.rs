//! `bouncelab analyze`: recordings, or lists of impact times, to results.

mod answers;
mod cues;
mod figures;
mod read;
mod report;
mod text;

use cues::write_cues;
pub(crate) use figures::{Stems, save_figures};
use read::is_standard_input;
pub(crate) use read::{Analysed, read};
use report::ReportArguments;
pub(crate) use text::{assumed, note, report};

use std::path::PathBuf;

use bouncelab::Diagnostic;
use bouncelab::Plain;
use bouncelab::diagnostic::Code;
use bouncelab::settings::Setup;
use bouncelab_audio::SoundFormat;
use bouncelab_report::columns::{TableKind, WHICH};
use bouncelab_report::data_table::{Formulas, columns};
use bouncelab_report::document::{Document, FailedDocument, labels, tracker};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};
use serde::Serialize;

use crate::failure::Failure;
use crate::language::{text, translator};
use crate::report::OutputArguments;
use crate::settings::{EditArguments, RecordingArguments};
use crate::terminal::{print, print_data, print_json, print_json_line, say};

/// Detect and analyse the drops in recordings, or in lists of impact times
#[derive(Args)]
#[command(long_about = about(), after_help = EXAMPLES)]
pub(crate) struct Arguments {
    /// Recordings, or lists of impact times; - is standard input, with sound or a list as text
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// How to print the result; JSON is documented in docs/json.md
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,
    /// What has a row in CSV [default: impacts]
    #[arg(long, value_name = "WHAT", value_parser = table_kind())]
    rows: Option<TableKind>,
    /// Write figures as SVG, PNG and PDF, and their data as CSV, into this folder
    #[arg(long, value_name = "DIR")]
    figures: Option<PathBuf>,
    #[command(flatten)]
    report: ReportArguments,
    /// Write a copy of one recording as WAV with a marker at each impact, which sound editors show
    #[arg(long, value_name = "FILE")]
    cues: Option<PathBuf>,
    #[command(flatten)]
    edits: EditArguments,
    /// Print also the probability of each impact, the frequency band, the compared laws, the
    /// uncertainty budget and the priors
    #[arg(long)]
    details: bool,
    /// Leave names in CSV as they are, even if a spreadsheet would run them as formulas
    #[arg(long)]
    csv_raw: bool,
    #[command(flatten)]
    outputs: OutputArguments,
    #[command(flatten)]
    recording: RecordingArguments,
}

/// The long description, with the formats that are read.
fn about() -> String {
    format!(
        "Detect and analyse the drops in recordings, or in lists of impact times\n\n\
         Reads sound ({}) and lists of impact times: texts, tables and sheets (.txt, .csv, .xls, .xlsx, .ods; \
         headings such as `Time (s)`, `interval_s`), exports of phyphox (.zip), .json (an array), labels of \
         Audacity, Praat and Sonic Visualiser. A table of times at equal distances, with a column for each \
         channel, is sound. \
         Exit status: 0 if every file has a drop, 1 if a file has none or cannot be read, 2 for wrong usage.",
        SoundFormat::names()
    )
}

const EXAMPLES: &str = "\
Examples:
  bouncelab analyze drop.wav
  bouncelab analyze drop.m4a --ball tennis --temperature 25C --figures figures
  bouncelab analyze drop.wav --mass 2.5g --diameter 38mm --drag constant:0.4
  bouncelab analyze drop.wav --height 30.5cm --height-sd 1mm
  bouncelab analyze drop.wav --law constant --infer drag
  bouncelab analyze drop.wav --which-ball               which of the known balls fits best?
  bouncelab analyze drop.wav --reach 2:28cm             from which height does bounce 2 reach 28 cm?
  bouncelab analyze drop.wav --flights 1..10            the paper's ten flights
  bouncelab analyze drop.wav --report drop.html         or drop.md
  bouncelab analyze drop.wav --exclude 2.317 --include 4.1,4.25
  bouncelab analyze times.csv --format json
  ffmpeg -i film.avi -f wav - | bouncelab analyze -      sound from another program
  bouncelab analyze drop.wav --format audacity > labels.txt   or textgrid, tracker
  bouncelab analyze class/*.wav --format csv > impacts.csv
  bouncelab analyze class/*.wav --format csv --rows drops > drops.csv";

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Format {
    /// For people
    Text,
    /// For programs: one object; for several files, one object per line
    Json,
    /// One row for each impact, or for each drop or flight by --rows
    Csv,
    /// The impacts of one recording as a label track of Audacity
    Audacity,
    /// The impacts of one recording as a `TextGrid` of Praat
    #[value(name = "textgrid")]
    TextGrid,
    /// The height of the ball against time in one recording, for Tracker
    Tracker,
}

impl Format {
    /// Whether it describes one recording only.
    const fn is_of_one(self) -> bool {
        matches!(self, Self::Audacity | Self::TextGrid | Self::Tracker)
    }
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let setup = arguments.recording.resolve_with(&arguments.edits)?;
    let is_for_one = arguments.format.is_of_one() || arguments.cues.is_some();
    if is_for_one && arguments.files.len() > 1 {
        return Err(Failure::Usage(text("analyze-one-labelled")));
    }
    if arguments.cues.is_some() && arguments.files.iter().any(|file| is_standard_input(file)) {
        return Err(Failure::Usage(text("analyze-cues-of-file")));
    }
    if arguments.rows.is_some() && arguments.format != Format::Csv {
        let problem = "--rows is of a table; add --format csv";
        return Err(Failure::Usage(problem.to_owned()));
    }
    let outputs = arguments.outputs.outputs(&arguments.files);
    let mut report_file = arguments.report.file(&arguments.files, &outputs)?;
    let printer = Printer::new(arguments)?;
    let mut stems = Stems::default();
    let mut empty_handed = false;
    for file in &arguments.files {
        let name = String::from(Plain::path(file));
        match read(file, &setup.options, false) {
            Ok(analysed) => {
                empty_handed |= analysed.result.drops.is_empty();
                if let Some(reason) = analysed.no_drop() {
                    say(format_args!("bouncelab: {reason}"));
                }
                if let Some(folder) = &arguments.figures {
                    save_figures(&analysed, &setup, folder, &mut stems, &outputs)?;
                }
                if let Some(report_file) = report_file.take() {
                    let page = arguments.report.page(file, &analysed, &setup)?;
                    report_file.write(&page)?;
                }
                if let Some(target) = &arguments.cues {
                    write_cues(
                        file,
                        setup.options.detection.rate_hz,
                        &analysed,
                        target,
                        &outputs,
                    )?;
                }
                printer.print(&analysed, &setup)?;
            }
            Err(failure @ (Failure::Usage(_) | Failure::Output(_) | Failure::NoPass(_))) => {
                return Err(failure);
            }
            Err(Failure::Input(reason)) => {
                empty_handed = true;
                say(format_args!("bouncelab: {reason}"));
                printer.print_failed(&name, &reason)?;
            }
        }
    }
    if empty_handed {
        Err(Failure::Input(String::new()))
    } else {
        Ok(())
    }
}

/// The result for other programs.
pub(crate) fn document<'a>(analysed: &'a Analysed, setup: &Setup) -> Document<'a> {
    let mut assumptions = setup.assumptions.clone();
    translator().complete_each(&mut assumptions);
    Document::new(
        &analysed.name,
        &analysed.result,
        &setup.options,
        &assumptions,
    )
}

/// Prints results in the chosen format, as they come.
struct Printer {
    format: Format,
    details: bool,
    several: bool,
    rows: TableKind,
    formulas: Formulas,
}

impl Printer {
    fn new(arguments: &Arguments) -> Result<Self, Failure> {
        let printer = Self {
            format: arguments.format,
            details: arguments.details,
            several: arguments.files.len() > 1,
            rows: arguments.rows.unwrap_or(TableKind::Impacts),
            formulas: formulas(arguments.csv_raw),
        };
        if printer.format == Format::Csv {
            let columns = [columns(WHICH), printer.rows.columns()].concat();
            print_data(printer.formulas.header(&columns))?;
        }
        Ok(printer)
    }

    fn print(&self, analysed: &Analysed, setup: &Setup) -> Result<(), Failure> {
        match self.format {
            Format::Text if analysed.result.drops.is_empty() => Ok(()),
            Format::Text => print(report(analysed, setup, self.details)),
            Format::Json => self.print_document(&document(analysed, setup)),
            Format::Audacity => print_data(labels::audacity(&analysed.result)),
            Format::TextGrid => print_data(labels::text_grid(&analysed.result)),
            Format::Tracker => print_data(tracker(&analysed.result, &setup.options)),
            Format::Csv => {
                let table = self.rows.table(&analysed.name, &analysed.result);
                print_data(table.lines(self.formulas))
            }
        }
    }

    fn print_failed(&self, name: &str, reason: &str) -> Result<(), Failure> {
        match self.format {
            Format::Json => {
                let mut unreadable = Diagnostic::new(Code::FileUnreadable);
                unreadable.message = Some(reason.to_owned());
                self.print_document(&FailedDocument::new(name, &unreadable))
            }
            Format::Text | Format::Csv | Format::Audacity | Format::TextGrid | Format::Tracker => {
                Ok(())
            }
        }
    }

    fn print_document(&self, document: &impl Serialize) -> Result<(), Failure> {
        if self.several {
            print_json_line(document)
        } else {
            print_json(document)
        }
    }
}

/// How texts in CSV are written that a spreadsheet would run, by `--csv-raw`.
pub(crate) const fn formulas(csv_raw: bool) -> Formulas {
    if csv_raw {
        Formulas::Raw
    } else {
        Formulas::Guarded
    }
}

/// A kind of table by its name.
fn table_kind() -> impl TypedValueParser<Value = TableKind> {
    PossibleValuesParser::new(TableKind::ALL.map(TableKind::name)).try_map(|name| {
        let mut kinds = TableKind::ALL.into_iter();
        kinds
            .find(|kind| kind.name() == name)
            .ok_or("unknown table")
    })
}
