//! `bouncelab job`: a test by a rule, drop after drop and place after place.

mod record;

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use bouncelab::rulebook::{self, Conditions, Decision, Item, Precision, Rebound, Rule};
use bouncelab::{Plain, demo};
use bouncelab_report::document::verdict::VerdictDocument;
use bouncelab_report::report::Provenance;
use bouncelab_report::report::verdict::{MethodCheck, TestNotes};
use bouncelab_report::rules;
use bouncelab_session::hash::{Hash, hash_of_file};
use bouncelab_session::hash_of_build;
use clap::{Args, Subcommand};
use jiff::Zoned;
use rayon::prelude::*;
use record::{Job, Recorded};
use serde::Serialize;

use crate::analyze::read;
use crate::failure::Failure;
use crate::interrupt::Stop;
use crate::language::{text, text_with, translator};
use crate::listen::{self, Source};
use crate::report::{OutputArguments, ReportFile, provenance, quoted, wrote};
use crate::rules::Files;
use crate::terminal::{print, print_json, say};
use crate::verdict::{Format, Surface, Test, rebounds, setup_of_rule};

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
        #[arg(long, value_name = "NUMBER", value_parser = clap::value_parser!(u16).range(1..=1000))]
        places: Option<u16>,
        /// How many drops in each place [default: as many as the rule asks for]
        #[arg(long, value_name = "NUMBER", value_parser = clap::value_parser!(u16).range(1..=1000))]
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
        } => Job::open(folder)?.repeat(*number, &String::from(Plain::of(reason))),
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
    wrote(&Job::create(folder, &notes)?);
    Job::open(folder)?.checked(check)
}

/// What a job is called: its folder, as a text of TOML.
fn name_of(folder: &Path) -> String {
    let name = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
    let name = name.file_name().unwrap_or_default().to_string_lossy();
    let plain = |c: &char| c.is_alphanumeric() || " -_.".contains(*c);
    name.chars().filter(plain).collect()
}

/// A job with what follows from its notes.
struct Opened {
    job: Job,
    rule: Rule,
    setup: bouncelab::settings::Setup,
    /// What results depend on besides the sound.
    settings: Hash,
}

impl Opened {
    fn new(folder: &Path) -> Result<Self, Failure> {
        let job = Job::open(folder)?;
        let files: Vec<PathBuf> = job
            .notes
            .rules
            .iter()
            .map(|path| folder.join(path))
            .collect();
        let rules = rules::all(&files)?;
        let rule = rulebook::find(&rules, &job.notes.rule)?.clone();
        let mut setup = setup_of_rule(&job.notes.settings, &rule, |settings| {
            Ok(settings.resolve()?)
        })?;
        let kept = job.notes.kept.iter().map(|name| Item::stated(name));
        setup.conditions.kept = kept.collect::<Result<_, _>>()?;
        if job.damaged > 0 {
            let words = [
                ("count", job.damaged.into()),
                (
                    "file",
                    String::from(Plain::path(&job.journal_file())).into(),
                ),
            ];
            say(text_with("job-damaged", &words));
        }
        let settings = hash_of_build(&(&setup.options, &rule));
        Ok(Self {
            job,
            rule,
            setup,
            settings,
        })
    }

    /// The places in their order, the reference first.
    fn places(&self) -> std::ops::RangeInclusive<usize> {
        usize::from(!self.rule.needs_reference())..=self.job.notes.places
    }

    fn next_place(&self) -> Option<usize> {
        self.places()
            .find(|&place| self.job.drops(place) < self.job.notes.drops)
    }

    /// The place that is meant, or the next with too few drops.
    fn place(&self, stated: Option<usize>) -> Result<Option<usize>, Failure> {
        match stated {
            Some(place) if !self.places().contains(&place) => {
                Err(Failure::Usage(format!("the job has no place {place}")))
            }
            Some(place) => Ok(Some(place)),
            None => Ok(self.next_place()),
        }
    }

    /// "place 2 of 5, drop 3 of 5", of the drop of this number.
    fn position(&self, place: usize, drop: usize) -> String {
        let id = if place == 0 {
            "job-reference"
        } else {
            "job-place"
        };
        let words = [
            ("place", place.into()),
            ("places", self.job.notes.places.into()),
            ("drop", drop.into()),
            ("drops", self.job.notes.drops.into()),
        ];
        text_with(id, &words)
    }

    /// The rebounds in a recording.
    fn rebounds(&self, recorded: &Recorded) -> Result<Vec<Rebound>, Failure> {
        self.job.result(recorded, self.settings, |path| {
            let analysed = read(path, &self.setup.options, true)?;
            Ok(rebounds(&analysed, &self.rule, &self.setup))
        })
    }

    /// The rebounds of places.
    fn surface(&self, places: impl Iterator<Item = usize>) -> Result<Surface, Failure> {
        let mut surface = Surface::default();
        for place in places {
            let recorded: Vec<&Recorded> = self.job.of_place(place).collect();
            if recorded.is_empty() {
                continue;
            }
            let of_place = recorded.par_iter().map(|recorded| self.rebounds(recorded));
            let of_place: Vec<Vec<Rebound>> = of_place.collect::<Result<_, Failure>>()?;
            surface.push(place_name(place), of_place.concat());
        }
        Ok(surface)
    }

    /// Keeps a recording of one or more drops, and counts it.
    fn count(
        &mut self,
        path: &Path,
        place: usize,
        given_as: String,
        operator: Option<&str>,
    ) -> Result<(), Failure> {
        let sha256 = hash_of_file(path)?;
        let mut recorded = self.job.recorded.iter();
        if let Some(same) = recorded.find(|recorded| recorded.sha256 == sha256) {
            return Err(Failure::Usage(format!(
                "{} is recording {} of the job; each recording counts once",
                Plain::path(path),
                same.number
            )));
        }
        let analysed = read(path, &self.setup.options, false)?;
        if let Some(reason) = analysed.no_drop() {
            return Err(Failure::Input(reason));
        }
        let (file, number) = self.job.numbered(&self.job.keep(path)?);
        let recorded = Recorded {
            number,
            place,
            drops: analysed.result.drops.len(),
            file,
            sha256,
            given_as,
            operator: String::from(Plain::of(operator.unwrap_or(&self.job.notes.test.operator))),
            added: Zoned::now().strftime("%Y-%m-%d %H:%M:%S %z").to_string(),
            repeated: None,
        };
        self.job.add(recorded.clone())?;
        let found = rebounds(&analysed, &self.rule, &self.setup);
        self.job.result(&recorded, self.settings, |_| Ok(found))?;
        print(format!(
            "{number}  {}\n",
            self.position(place, self.job.drops(place))
        ))
    }

    /// How drops repeat over operators, if several dropped the ball in the only place. Over places it would be unknown what
    /// differs by the operator.
    fn of_operators(&self) -> Result<Option<Precision>, Failure> {
        if self.job.notes.places > 1 {
            return Ok(None);
        }
        let mut levels: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
        for recorded in self.job.of_place(1) {
            let heights_m = self.rebounds(recorded)?.into_iter();
            let of_operator = levels.entry(&recorded.operator).or_default();
            of_operator.extend(heights_m.filter_map(|rebound| rebound.height_m));
        }
        Ok(Precision::of(&levels.into_values().collect::<Vec<_>>()))
    }

    /// What the report states, with the checks of the method at the start and now.
    fn notes(&self) -> Result<TestNotes, Failure> {
        let checks = self.job.checks.iter().cloned();
        Ok(TestNotes {
            checks: checks.chain([method_check()?]).collect(),
            of_operators: self.of_operators()?,
            ..self.job.notes.test.clone()
        })
    }

    /// The verdict on all that was recorded.
    fn test(&self) -> Result<Test<'_>, Failure> {
        let reference = self.surface(std::iter::once(0))?;
        let surface = self.surface(1..=self.job.notes.places)?;
        Test::new(
            &self.rule,
            &self.setup,
            surface,
            reference,
            Decision::default(),
        )
    }
}

fn place_name(place: usize) -> String {
    if place == 0 {
        text("verdict-item-reference")
    } else {
        text_with("job-place-name", &[("place", place.into())])
    }
}

fn add(
    folder: &Path,
    files: &[PathBuf],
    place: Option<usize>,
    operator: Option<&str>,
) -> Result<(), Failure> {
    let mut opened = Opened::new(folder)?;
    for path in files {
        let Some(place) = opened.place(place)? else {
            return Err(Failure::Usage(
                "every place has its drops; state one with --place to add more".to_owned(),
            ));
        };
        opened.count(path, place, String::from(Plain::path(path)), operator)?;
    }
    print(opened.test()?.so_far() + "\n")
}

/// Records drop after drop. The job is read anew for each: another terminal may have a drop repeated.
fn listen(
    folder: &Path,
    stated: Option<usize>,
    operator: Option<&str>,
    sources: impl Iterator<Item = Source>,
) -> Result<(), Failure> {
    let stop = Stop::on_request();
    let mut added = 0;
    for source in sources {
        let mut opened = Opened::new(folder)?;
        let Some(place) = opened.place(stated)? else {
            break;
        };
        say(opened.position(place, opened.job.drops(place) + 1));
        let file = opened.job.free("wav");
        let mut setup = opened.setup.clone();
        // Only whether the drop is over matters now; it is analysed as a recording of the job.
        setup.options.inference = None;
        let listened = listen::one_drop(&source, setup, &file);
        if listened.is_err() && stop.requested() {
            break;
        }
        listened?;
        let microphone = || text("job-microphone");
        let given_as = source
            .from
            .as_ref()
            .map_or_else(microphone, |from| String::from(Plain::path(from)));
        opened.count(&file, place, given_as, operator)?;
        print(opened.test()?.so_far() + "\n")?;
        added += 1;
    }
    if added == 0 {
        return Err(Failure::Input(text("job-no-drop-added")));
    }
    Ok(())
}

fn show(
    folder: &Path,
    format: Format,
    report: Option<&Path>,
    one_page: bool,
    outputs: &OutputArguments,
) -> Result<(), Failure> {
    let opened = Opened::new(folder)?;
    let sounds = opened
        .job
        .recorded
        .iter()
        .map(|recorded| folder.join(&recorded.file))
        .chain([opened.job.journal_file()]);
    let outputs = outputs.outputs(sounds);
    let report = report
        .map(|path| ReportFile::new(path, &outputs))
        .transpose()?;
    let test = opened.test()?;
    if let Some(file) = report {
        let recorded = opened.job.recorded.iter();
        let files =
            recorded.map(|recorded| (line(recorded, "\n    "), recorded.sha256.to_string()));
        let provenance = Provenance {
            files: files.collect(),
            ..provenance()
        };
        let notes = TestNotes {
            one_page,
            ..opened.notes()?
        };
        file.write(&test.page(&provenance, Some(&notes)))?;
    }
    match format {
        Format::Text => {
            let lines = opened
                .job
                .recorded
                .iter()
                .map(|recorded| format!("{:3}  {}\n", recorded.number, line(recorded, "  ")));
            let places = opened
                .places()
                .map(|place| opened.position(place, opened.job.drops(place)) + "\n");
            print(lines.chain(places).collect::<String>() + "\n" + &test.text())?;
            for sound in opened.job.uncounted()? {
                let file = String::from(Plain::path(&sound));
                let command = format!(
                    "bouncelab job add {} {}",
                    quoted(&folder.to_string_lossy()),
                    quoted(&sound.to_string_lossy())
                );
                let words = [("file", file.into()), ("command", command.into())];
                say(text_with("job-uncounted", &words));
            }
        }
        Format::Json => print_json(&JobDocument {
            verdict: test.document(),
            test: opened.notes()?,
            recordings: &opened.job.recorded,
        })?,
    }
    test.status()
}

/// The verdict on a job, with what its report states.
#[derive(Serialize)]
struct JobDocument<'a> {
    #[serde(flatten)]
    verdict: VerdictDocument,
    test: TestNotes,
    recordings: &'a [Recorded],
}

/// The method on a synthesised recording: from the sound to the height of the first rebound.
fn method_check() -> Result<MethodCheck, Failure> {
    let history = demo::history()?;
    let sound = demo::sound(&history, 1)?;
    let mut options = demo::settings().resolve()?.options;
    options.inference = None;
    let recording = bouncelab::analyze(&sound.samples, sound.sample_rate_hz, &options)?;
    let place = vec![recording.drops.iter().collect()];
    let rule = Rule::new("check", "check of the method", demo::DROP_HEIGHT_M);
    let nothing = Conditions::default();
    let verdict = rulebook::judge(&rule, &options, &nothing, &place, &[], Decision::default())?;
    Ok(MethodCheck {
        made: Zoned::now().strftime("%Y-%m-%d").to_string(),
        version: env!("CARGO_PKG_VERSION").to_owned(),
        truth_m: history
            .bounces()
            .first()
            .map_or(0.0, |bounce| bounce.flight.apex_m),
        found_m: verdict.rebound.map(|mean| mean.height_m),
    })
}

/// A recording: its file, and what is known of it.
fn line(recorded: &Recorded, between: &str) -> String {
    let place = place_name(recorded.place);
    let file = String::from(Plain::path(&recorded.file));
    let repeated = recorded
        .repeated
        .as_ref()
        .map_or_else(String::new, |reason| {
            let reason = String::from(Plain::of(reason));
            format!(
                " ({})",
                text_with("job-repeated", &[("reason", reason.into())])
            )
        });
    let about = [&recorded.given_as, &recorded.operator, &recorded.added];
    let about = about.into_iter().filter(|part| !part.is_empty());
    let about: Vec<&str> = about.map(String::as_str).collect();
    format!("{file}{between}{place}  {}{repeated}", about.join("  "))
}
