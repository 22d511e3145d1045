//! `bouncelab job`: a test by a rule, drop after drop and place after place.

mod record;

use std::path::{Path, PathBuf};

use bouncelab::Plain;
use bouncelab::rulebook::{self, Rebound, Rule};
use bouncelab_report::document::verdict::{Evaluation, VerdictDocument};
use bouncelab_report::job::{Event, MAX_NUMBER, Rebounds, Recorded};
use bouncelab_report::report::Provenance;
use bouncelab_report::report::verdict::{MethodCheck, TestNotes, of_verdict, so_far};
use bouncelab_session::hash::{Hash, hash_of_file};
use clap::{Args, Subcommand};
use jiff::Zoned;
use rayon::prelude::*;
use record::Folder;
use serde::Serialize;

use crate::analyze::{Analysed, read};
use crate::failure::Failure;
use crate::interrupt::Stop;
use crate::language::{text, text_with, translator};
use crate::listen::{self, Source};
use crate::report::{OutputArguments, ReportFile, provenance, quoted, wrote};
use crate::rules::Files;
use crate::terminal::{print, print_json, say};
use crate::verdict::{self, Format, rebounds};

/// Test by a rule, drop after drop and place after place, and report it
///
/// A job is a folder: notes to fill in (job.toml), every recording with its SHA-256, and a journal. After a crash it goes on
/// where it was.
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    what: What,
}

const EXAMPLES: &str = "\
Examples:
  bouncelab job new court --rule itf-court --places 5
  bouncelab job listen court                            with the microphone, until every place has its drops
  bouncelab job add court drop1.wav drop2.wav           the next place with too few drops
  bouncelab job add court drop3.wav --place 2
  bouncelab job repeat court 3 --reason 'a door slammed'
  bouncelab job show court --report court.html";

#[derive(Subcommand)]
enum What {
    /// Make a job
    New {
        /// Its folder
        folder: PathBuf,
        /// The rule, one of `bouncelab rules list`
        #[arg(long, value_name = "NAME")]
        rule: String,
        /// How many places are tested [default: as many as the rule asks for]
        #[arg(long, value_name = "NUMBER", value_parser = clap::value_parser!(u16).range(1..=i64::from(MAX_NUMBER)))]
        places: Option<u16>,
        /// How many drops in each place [default: as many as the rule asks for]
        #[arg(long, value_name = "NUMBER", value_parser = clap::value_parser!(u16).range(1..=i64::from(MAX_NUMBER)))]
        drops: Option<u16>,
        #[command(flatten)]
        rules: Files,
    },
    /// Record drop after drop with the microphone, until every place has its drops or Ctrl-C
    ///
    /// Each drop is a recording of its own, saved while it is recorded, and counts when the ball rests. `job repeat` lets a
    /// drop be repeated, also from another terminal. Exit status: 0 if a drop was added, 1 if none was.
    Listen {
        /// The folder of the job
        folder: PathBuf,
        /// The place, 1 for the first; 0 is the reference [default: the next with too few drops]
        #[arg(long, value_name = "NUMBER")]
        place: Option<usize>,
        /// Play recordings of a drop each instead of using the microphone
        #[arg(long, value_name = "FILE", num_args = 1..)]
        from: Vec<PathBuf>,
        /// Play them as fast as possible instead of in real time
        #[arg(long, requires = "from")]
        fast: bool,
        /// The microphone, by its name in `listen --devices` or a part of it (default: that of the system)
        #[arg(long, value_name = "NAME", conflicts_with = "from")]
        device: Option<String>,
        /// Who drops the ball [default: the operator in job.toml]
        #[arg(long, value_name = "NAME")]
        operator: Option<String>,
    },
    /// Add recordings; each is kept, and counts in its place
    Add {
        /// The folder of the job
        folder: PathBuf,
        /// Recordings, or lists of impact times
        #[arg(required = true, value_name = "FILE")]
        files: Vec<PathBuf>,
        /// The place, 1 for the first; 0 is the reference [default: the next with too few drops]
        #[arg(long, value_name = "NUMBER")]
        place: Option<usize>,
        /// Who dropped the ball [default: the operator in job.toml]
        #[arg(long, value_name = "NAME")]
        operator: Option<String>,
    },
    /// Let a recording be repeated: it stays, and counts no more
    Repeat {
        /// The folder of the job
        folder: PathBuf,
        /// The number of the recording
        number: usize,
        /// Why
        #[arg(long, value_name = "TEXT")]
        reason: String,
    },
    /// Show what there is, and the verdict so far
    Show {
        /// The folder of the job
        folder: PathBuf,
        /// How to print the result; JSON is documented in docs/json.md
        #[arg(long, value_enum, default_value_t = Format::Text)]
        format: Format,
        /// Write the test report: .html (one file), .md (with its figures in a folder) or .pdf (printed by an installed
        /// Chromium, Chrome or Edge)
        #[arg(long, value_name = "FILE")]
        report: Option<PathBuf>,
        /// Report on one page for the client: the result, its decision, and what it is of
        #[arg(long, requires = "report")]
        one_page: bool,
        #[command(flatten)]
        outputs: OutputArguments,
    },
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), Failure> {
    match &arguments.what {
        What::New {
            folder,
            rule,
            places,
            drops,
            rules,
        } => {
            let known = rules.read()?;
            let rule = rulebook::find(&known, &String::from(Plain::of(rule)))?;
            new(folder, rule, [*places, *drops], rules.paths())
        }
        What::Add {
            folder,
            files,
            place,
            operator,
        } => add(folder, files, *place, operator.as_deref()),
        What::Listen {
            folder,
            place,
            from,
            fast,
            device,
            operator,
        } => {
            let operator = operator.as_deref();
            let source = |from: Option<&PathBuf>| Source {
                from: from.cloned(),
                fast: *fast,
                device: device.clone(),
            };
            let sources: Box<dyn Iterator<Item = Source>> = if from.is_empty() {
                // The microphone has no end: it stops when all places have their drops.
                Box::new(std::iter::repeat_with(|| source(None)))
            } else {
                Box::new(from.iter().map(|from| source(Some(from))))
            };
            listen(folder, *place, operator, sources)
        }
        What::Repeat {
            folder,
            number,
            reason,
        } => Folder::open(folder)?.repeat(*number, String::from(Plain::of(reason))),
        What::Show {
            folder,
            format,
            report,
            one_page,
            outputs,
        } => show(folder, *format, report.as_deref(), *one_page, outputs),
    }
}

fn new(
    folder: &Path,
    rule: &Rule,
    [places, drops]: [Option<u16>; 2],
    files: &[PathBuf],
) -> Result<(), Failure> {
    let number =
        |given: Option<u16>, of_rule: usize| given.map_or(of_rule, usize::from).to_string();
    let files = files.iter().map(|path| {
        path.canonicalize()
            .map(|path| format!("{:?}", path.to_string_lossy()))
    });
    let files = files.collect::<Result<Vec<String>, _>>()?.join(", ");
    let notes = include_str!("template.toml")
        .replace("RULE", &rule.name)
        .replace("NAME", &name_of(folder))
        .replace("PLACES", &number(places, rule.places()))
        .replace("DROPS", &number(drops, rule.fewest_drops))
        .replace("rules = []", &format!("rules = [{files}]"));
    let check = method_check()?;
    say(check.text(translator()));
    if !check.agrees() {
        return Err(Failure::Input(text("job-check-failed")));
    }
    wrote(&Folder::create(folder, &notes)?);
    Folder::open(folder)?.write(Event::Checked(check))
}

/// What a job is called: its folder, as a text of TOML.
fn name_of(folder: &Path) -> String {
    let name = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    let name = name.file_name().unwrap_or_default().to_string_lossy();
    let plain = |c: &char| c.is_alphanumeric() || " -_.".contains(*c);
    name.chars().filter(plain).collect()
}

/// Opens a job, and says what of its journal is damaged.
fn opened(path: &Path) -> Result<Folder, Failure> {
    let folder = Folder::open(path)?;
    if folder.damaged > 0 {
        let file = String::from(Plain::path(&folder.journal_file()));
        let words = [("count", folder.damaged.into()), ("file", file.into())];
        say(text_with("job-damaged", &words));
    }
    Ok(folder)
}

impl Folder {
    /// The place that is meant, or the next with too few drops.
    fn place(&self, stated: Option<usize>) -> Result<Option<usize>, Failure> {
        match stated {
            Some(place) if !self.job.places().contains(&place) => {
                Err(Failure::Usage(format!("the job has no place {place}")))
            }
            Some(place) => Ok(Some(place)),
            None => Ok(self.job.next_place()),
        }
    }

    fn position(&self, place: usize, drop: usize) -> String {
        self.job.position(place, drop, translator())
    }

    /// The rebounds in all recordings that count.
    fn all_rebounds(&self) -> Result<Rebounds, Failure> {
        let (history, options) = (&self.job.history, &self.job.setup.options);
        let recorded = self.job.places().flat_map(|place| history.of_place(place));
        let recorded: Vec<&Recorded> = recorded.collect();
        let known = recorded.par_iter().map(|recorded| {
            let make = |path: &Path| Ok(self.found(&read(path, options, true)?));
            Ok((recorded.number, self.rebounds(recorded, make)?))
        });
        known.collect()
    }

    fn found(&self, analysed: &Analysed) -> Vec<Rebound> {
        rebounds(analysed, &self.job.rule, &self.job.setup)
    }

    /// The verdict on all that was recorded.
    fn evaluation(&self) -> Result<Evaluation, Failure> {
        Ok(self.job.evaluation(&self.all_rebounds()?, translator())?)
    }

    /// What the report states.
    fn test(&self) -> Result<TestNotes, Failure> {
        Ok(self.job.test(&self.all_rebounds()?, method_check()?))
    }

    /// Keeps a recording of one or more drops, and counts it.
    fn count(&mut self, path: &Path, place: usize, given: Given<'_>) -> Result<(), Failure> {
        let sha256 = hash_of_file(path)?;
        self.must_be_new(path, sha256)?;
        let analysed = read(path, &self.job.setup.options, false)?;
        if let Some(reason) = analysed.no_drop() {
            return Err(Failure::Input(reason));
        }
        let (file, number) = self.numbered(&self.keep(path)?);
        let operator = given.operator.unwrap_or(&self.job.notes.test.operator);
        let recorded = Recorded {
            number,
            place,
            drops: analysed.result.drops.len(),
            file,
            sha256,
            played: given.played,
            given_as: given.name,
            operator: String::from(Plain::of(operator)),
            added: Zoned::now().strftime("%Y-%m-%d %H:%M:%S %z").to_string(),
            repeated: None,
        };
        self.write(Event::Added(recorded.clone()))?;
        self.rebounds(&recorded, |_| Ok(self.found(&analysed)))?;
        let drops = self.job.history.drops(place);
        print(format!("{number}  {}\n", self.position(place, drops)))
    }

    /// Prints the result so far.
    fn print_so_far(&self) -> Result<(), Failure> {
        print(so_far(&self.evaluation()?.verdict, translator()) + "\n")
    }
}

/// How a recording came into the job.
struct Given<'a> {
    /// The name under which it was given.
    name: String,
    /// The recording that was played in place of the microphone.
    played: Option<Hash>,
    operator: Option<&'a str>,
}

fn add(
    folder: &Path,
    files: &[PathBuf],
    place: Option<usize>,
    operator: Option<&str>,
) -> Result<(), Failure> {
    let mut folder = opened(folder)?;
    for path in files {
        let Some(place) = folder.place(place)? else {
            return Err(Failure::Usage(
                "every place has its drops; state one with --place to add more".to_owned(),
            ));
        };
        let given = Given {
            name: String::from(Plain::path(path)),
            played: None,
            operator,
        };
        folder.count(path, place, given)?;
    }
    folder.print_so_far()
}

/// Records drop after drop. The job is read anew for each: another terminal may have a drop repeated.
fn listen(
    path: &Path,
    stated: Option<usize>,
    operator: Option<&str>,
    sources: impl Iterator<Item = Source>,
) -> Result<(), Failure> {
    let stop = Stop::on_request();
    let mut added = 0;
    for source in sources {
        let mut folder = opened(path)?;
        let Some(place) = folder.place(stated)? else {
            break;
        };
        let played = source.from.as_deref().map(hash_of_file).transpose()?;
        // Before it is played: what is played is saved.
        if let Some((from, content)) = source.from.as_deref().zip(played) {
            folder.must_be_new(from, content)?;
        }
        say(folder.position(place, folder.job.history.drops(place) + 1));
        let file = folder.free("wav");
        let mut setup = folder.job.setup.clone();
        // Only whether the drop is over matters now; it is analysed as a recording of the job.
        setup.options.inference = None;
        let recorded = listen::one_drop(&source, setup, &file);
        if recorded.is_err() && stop.requested() {
            break;
        }
        recorded?;
        let microphone = || text("job-microphone");
        let from = source.from.as_ref();
        let given = Given {
            name: from.map_or_else(microphone, |from| String::from(Plain::path(from))),
            played,
            operator,
        };
        folder.count(&file, place, given)?;
        folder.print_so_far()?;
        added += 1;
    }
    if added == 0 {
        return Err(Failure::Input(text("job-no-drop-added")));
    }
    Ok(())
}

fn show(
    path: &Path,
    format: Format,
    report: Option<&Path>,
    one_page: bool,
    outputs: &OutputArguments,
) -> Result<(), Failure> {
    let folder = opened(path)?;
    let job = &folder.job;
    let recorded = job.history.recorded.iter();
    let sounds = recorded
        .clone()
        .map(|recorded| path.join(&recorded.file))
        .chain([folder.journal_file()]);
    let outputs = outputs.outputs(sounds);
    let report = report
        .map(|path| ReportFile::new(path, &outputs))
        .transpose()?;
    let evaluation = folder.evaluation()?;
    if let Some(file) = report {
        let provenance = Provenance {
            files: job.files(translator()),
            ..provenance()
        };
        let notes = TestNotes {
            one_page,
            ..folder.test()?
        };
        file.write(&of_verdict(
            &evaluation,
            &provenance,
            Some(&notes),
            translator(),
        ))?;
    }
    match format {
        Format::Text => {
            let lines = recorded.map(|recorded| {
                let file = Plain::path(&recorded.file);
                let line = recorded.line(translator());
                format!("{:3}  {file}  {line}\n", recorded.number)
            });
            let places = job
                .places()
                .map(|place| folder.position(place, job.history.drops(place)) + "\n");
            let verdict = verdict::text(&evaluation);
            print(lines.chain(places).collect::<String>() + "\n" + &verdict)?;
            for sound in folder.uncounted()? {
                let file = String::from(Plain::path(&sound));
                let command = format!(
                    "bouncelab job add {} {}",
                    quoted(&path.to_string_lossy()),
                    quoted(&sound.to_string_lossy())
                );
                let words = [("file", file.into()), ("command", command.into())];
                say(text_with("job-uncounted", &words));
            }
        }
        Format::Json => print_json(&JobDocument {
            verdict: VerdictDocument::new(&evaluation, translator()),
            test: folder.test()?,
            recordings: &job.history.recorded,
        })?,
    }
    verdict::status(evaluation.verdict.outcome)
}

/// The verdict on a job, with what its report states.
#[derive(Serialize)]
struct JobDocument<'a> {
    #[serde(flatten)]
    verdict: VerdictDocument,
    test: TestNotes,
    recordings: &'a [Recorded],
}

/// The check of the method, today.
fn method_check() -> Result<MethodCheck, Failure> {
    let today = Zoned::now().strftime("%Y-%m-%d").to_string();
    Ok(MethodCheck::run(today)?)
}
