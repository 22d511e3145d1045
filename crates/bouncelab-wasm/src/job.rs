//! A job: a test by a rule, drop after drop, as the page keeps it. Its files are those of a job of the program.

use std::path::Path;

use bouncelab::rulebook::{self, Rebound};
use bouncelab_report::job::{
    Event, History, Job, NOTES, Notes, Rebounds, Recorded, SOUNDS, file_name,
};
use bouncelab_report::journal;
use bouncelab_report::messages::{Translator, capital};
use bouncelab_report::report::Provenance;
use bouncelab_report::report::verdict::{MethodCheck, TestNotes, of_verdict, so_far};
use bouncelab_report::rules::{self, words};

use crate::refusal::{Reason, Refusal, Result};
use crate::verdict::{judged, setup};
use crate::wire::{JobChange, JobFiles, JobPlace, JobRecording, JobShown, NewJob};

/// The versions of the libraries, and the hash of their sources.
const BUILD: [&str; 3] = [
    bouncelab::VERSION,
    bouncelab_audio::VERSION,
    env!("BOUNCELAB_BUILD"),
];

/// The files of a new job.
///
/// # Errors
///
/// If there is no such rule.
pub fn new(request: &NewJob) -> Result<JobFiles> {
    let rules = rules::built_in()?;
    let rule = rulebook::find(&rules, &request.rule)?;
    let places = request.places.unwrap_or_else(|| rule.places());
    let drops = request.drops.unwrap_or(rule.fewest_drops);
    let mut notes = Notes::new(rule.name.clone(), places, drops);
    notes.settings = request.settings.clone();
    notes.test.name.clone_from(&request.name);
    Ok(JobFiles {
        notes: notes.toml().map_err(Refusal::fault)?,
        journal: String::new(),
    })
}

/// A job after a change, if there is one.
///
/// # Errors
///
/// If its notes cannot be read, if the change is a recording that the job has, or of one that it does not have.
pub fn show(
    files: JobFiles,
    change: Option<JobChange>,
    translator: &Translator,
) -> Result<JobShown> {
    let mut kept = Kept::open(files)?;
    if let Some(change) = change {
        kept.take(change)?;
    }
    kept.shown(translator)
}

/// The report of a job as one HTML file.
///
/// # Errors
///
/// As those of [`show`]; and if rebounds of a recording are missing.
pub fn report(
    files: JobFiles,
    check: MethodCheck,
    one_page: bool,
    translator: &Translator,
) -> Result<String> {
    let Kept { job, rebounds, .. } = Kept::open(files)?;
    let provenance = Provenance {
        made: Some(check.made.clone()),
        files: job.files(translator),
        command: None,
    };
    let notes = TestNotes {
        one_page,
        ..job.test(&rebounds, check)
    };
    let evaluation = job.evaluation(&rebounds, translator)?;
    Ok(of_verdict(&evaluation, &provenance, Some(&notes), translator).html())
}

/// A job with its files.
struct Kept {
    files: JobFiles,
    job: Job,
    /// Under the settings of now.
    rebounds: Rebounds,
    damaged: usize,
}

impl Kept {
    fn open(files: JobFiles) -> Result<Self> {
        let unreadable = |reason: String| Refusal::fault(format!("{NOTES}: {reason}"));
        let job = job_of(Notes::read(&files.notes).map_err(unreadable)?)?;
        let mut kept = Self {
            files,
            job,
            rebounds: Rebounds::new(),
            damaged: 0,
        };
        kept.read()?;
        Ok(kept)
    }

    /// Reads the journal: what happened, and the rebounds that are known.
    fn read(&mut self) -> Result<()> {
        let events = History::events();
        let mut results = Vec::new();
        let whole = self.files.journal.rfind('\n').map_or(0, |end| end + 1);
        for line in self
            .files
            .journal
            .as_bytes()
            .split_inclusive(|&byte| byte == b'\n')
        {
            let Some(text) = journal::checked(line) else {
                self.damaged += 1;
                continue;
            };
            let of = journal::of(text)?;
            if of.key.settings == events {
                self.job.history.apply(journal::result(text)?);
            } else if of.key.settings == self.job.settings {
                results.push((of, journal::result::<Vec<Rebound>>(text)?));
            }
        }
        // What is written next begins a line.
        self.files.journal.truncate(whole);
        for (of, rebounds) in results {
            let mut recorded = self.job.history.recorded.iter();
            let is_it = |it: &&Recorded| it.name() == of.name && it.sha256 == of.key.content;
            if let Some(recorded) = recorded.find(is_it) {
                self.rebounds.insert(recorded.number, rebounds);
            }
        }
        Ok(())
    }

    fn take(&mut self, change: JobChange) -> Result<()> {
        match change {
            JobChange::Stated {
                fields,
                kept,
                settings,
            } => {
                let mut notes = self.job.notes.clone();
                for (name, value) in &fields {
                    let stated = notes.test.with(name, value);
                    let unknown = || Refusal::fault(format!("{NOTES} has no part {name}"));
                    notes.test = stated.ok_or_else(unknown)?;
                }
                (notes.kept, notes.settings) = (kept, settings);
                // What the settings refuse is not written down.
                job_of(notes.clone())?;
                let files = JobFiles {
                    notes: notes.toml().map_err(Refusal::fault)?,
                    ..std::mem::take(&mut self.files)
                };
                *self = Self::open(files)?;
                Ok(())
            }
            JobChange::Checked { check } => self.write(Event::Checked(check)),
            JobChange::Added {
                sha256,
                ending,
                given_as,
                operator,
                added,
                rebounds,
            } => {
                if let Some(same) = self.job.history.of_content(sha256) {
                    return Err(counted(same.number));
                }
                let number = self.job.history.next_number();
                let last = *self.job.places().end();
                let operator = if operator.is_empty() {
                    self.job.notes.test.operator.clone()
                } else {
                    operator
                };
                let recorded = Recorded {
                    number,
                    place: self.job.next_place().unwrap_or(last),
                    drops: rebounds.len(),
                    file: Path::new(SOUNDS).join(file_name(number, &ending)),
                    sha256,
                    played: None,
                    given_as,
                    operator,
                    added,
                    repeated: None,
                };
                self.write(Event::Added(recorded))?;
                self.keep(number, rebounds)
            }
            JobChange::Computed { number, rebounds } => self.keep(number, rebounds),
            JobChange::Repeated { number, reason } => {
                if self.job.history.counting(number).is_none() {
                    return Err(Refusal::fault("the job has no such recording that counts"));
                }
                self.write(Event::Repeated { number, reason })
            }
        }
    }

    fn write(&mut self, event: Event) -> Result<()> {
        let (name, key) = self.job.history.line_of(&event);
        self.files.journal += &journal::line(&name, &key, &event)?;
        self.job.history.apply(event);
        Ok(())
    }

    fn keep(&mut self, number: usize, rebounds: Vec<Rebound>) -> Result<()> {
        let mut recorded = self.job.history.recorded.iter();
        let recorded = recorded.find(|recorded| recorded.number == number);
        let recorded = recorded.ok_or_else(|| Refusal::fault("the job has no such recording"))?;
        let key = recorded.key(self.job.settings);
        self.files.journal += &journal::line(&recorded.name(), &key, &rebounds)?;
        self.rebounds.insert(number, rebounds);
        Ok(())
    }

    fn shown(self, translator: &Translator) -> Result<JobShown> {
        let Self { job, rebounds, .. } = &self;
        let history = &job.history;
        let drops = |place: usize| history.drops(place);
        let is_known = |recorded: &Recorded| rebounds.contains_key(&recorded.number);
        let counting = || history.recorded.iter().filter(|it| it.repeated.is_none());
        let evaluation = if counting().next().is_some() && counting().all(is_known) {
            Some(job.evaluation(rebounds, translator)?)
        } else {
            None
        };
        let next = job.next_place();
        Ok(JobShown {
            name: job.notes.test.name.clone(),
            title: words::title(&job.rule, translator),
            rule: job.rule.clone(),
            settings: job.notes.settings.clone(),
            next: next.map(|place| capital(&job.position(place, drops(place) + 1, translator))),
            places: job
                .places()
                .map(|place| JobPlace {
                    place,
                    words: capital(&job.position(place, drops(place), translator)),
                    is_done: drops(place) >= job.notes.drops,
                })
                .collect(),
            recordings: history
                .recorded
                .iter()
                .map(|recorded| JobRecording {
                    number: recorded.number,
                    file: recorded.name(),
                    words: recorded.line(translator),
                    sha256: recorded.sha256.to_string(),
                    counts: recorded.repeated.is_none(),
                    is_known: is_known(recorded),
                })
                .collect(),
            so_far: evaluation
                .as_ref()
                .map(|it| so_far(&it.verdict, translator)),
            judged: evaluation.as_ref().map(|it| judged(it, translator)),
            fields: job.notes.test.fields(translator),
            kept: job.notes.kept.clone(),
            checks: history
                .checks
                .iter()
                .map(|check| check.text(translator))
                .collect(),
            damaged: self.damaged,
            files: self.files,
        })
    }
}

/// The job of these notes, before anything happened.
fn job_of(notes: Notes) -> Result<Job> {
    let rule = rulebook::find(&rules::built_in()?, &notes.rule)?.clone();
    let setup = setup(&rule, &notes.settings)?;
    Ok(Job::new(notes, rule, setup, &BUILD)?)
}

/// The refusal of a recording that counts already.
fn counted(number: usize) -> Refusal {
    Refusal {
        reason: Some(Box::new(Reason::Counted { number })),
        ..Refusal::fault(format!(
            "it is recording {number} of the job; each counts once"
        ))
    }
}
