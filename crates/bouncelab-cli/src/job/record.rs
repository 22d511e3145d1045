//! A job on disk: its notes, its sounds, and the journal of its drops.

use std::collections::BTreeSet;
use std::fmt::Display;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use bouncelab::Plain;
use bouncelab::settings::Settings;
use bouncelab_report::file::{Outputs, create_folder, read_noted, remove_drafts};
use bouncelab_report::mark;
use bouncelab_report::report::verdict::{MethodCheck, TestNotes};
use bouncelab_session::hash::{Hash, hash, hash_of_file};
use bouncelab_session::journal::{JOURNAL, Journal, Key};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::failure::Failure;

/// Name and version of the format.
const SCHEMA: &str = "bouncelab.job/2";
/// The notes, which people write.
const NOTES: &str = "job.toml";
/// The folder of the recordings.
const SOUNDS: &str = "sounds";
/// No notes are longer.
const MAX_MB: u64 = 2;

/// What a person states of a job.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Notes {
    schema: String,
    /// Name of the rule.
    pub(super) rule: String,
    /// Files with rules of one's own, relative to the job.
    #[serde(default)]
    pub(super) rules: Vec<PathBuf>,
    /// How many places are tested.
    pub(super) places: usize,
    /// How many drops in each place, and on the reference.
    pub(super) drops: usize,
    /// Parts of the procedure that were kept and that nothing else shows.
    #[serde(default)]
    pub(super) kept: Vec<String>,
    /// A file with name, address and logo of the laboratory, relative to the job.
    #[serde(default)]
    laboratory: Option<PathBuf>,
    /// What the report states.
    #[serde(default)]
    pub(super) test: TestNotes,
    /// Any setting, by the names of the JSON.
    #[serde(default)]
    pub(super) settings: Settings,
}

/// A laboratory, for all of its jobs.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Laboratory {
    name: String,
    address: String,
    /// As of the accreditation.
    #[serde(default)]
    remarks: String,
    /// A picture, relative to the file.
    #[serde(default)]
    logo: Option<PathBuf>,
}

impl Laboratory {
    fn read(path: &Path, test: &mut TestNotes) -> Result<(), Failure> {
        let laboratory: Self = toml::from_str(&noted(path)?).map_err(unreadable(path))?;
        let parts = [&laboratory.name, &laboratory.address, &laboratory.remarks];
        let parts = parts.into_iter().filter(|part| !part.is_empty());
        test.laboratory = parts.map(String::as_str).collect::<Vec<_>>().join(", ");
        if let Some(logo) = laboratory.logo {
            let logo = path.with_file_name(logo);
            let kind = match logo.extension().and_then(|ending| ending.to_str()) {
                Some("png") => "png",
                Some("jpg" | "jpeg") => "jpeg",
                Some("svg") => "svg+xml",
                _ => return Err(unreadable(&logo)("a logo is a file .png, .jpg or .svg")),
            };
            let bytes = read_noted(&logo, MAX_MB).map_err(unreadable(&logo))?;
            let data = BASE64_STANDARD.encode(bytes);
            test.logo = Some(format!("data:image/{kind};base64,{data}"));
        }
        Ok(())
    }
}

/// The text of a file that people write.
fn noted(path: &Path) -> Result<String, Failure> {
    let bytes = read_noted(path, MAX_MB).map_err(unreadable(path))?;
    String::from_utf8(bytes).map_err(unreadable(path))
}

fn unreadable<R: Display>(path: &Path) -> impl Fn(R) -> Failure {
    move |reason| Failure::Input(format!("{}: {reason}", Plain::path(path)))
}

/// What happened in a job, a line of the journal.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
enum Event {
    /// The method was checked, at the start.
    Checked(MethodCheck),
    /// It was added.
    Added(Recorded),
    /// It does not count any more: why. Its sound is kept.
    Repeated { number: usize, reason: String },
}

/// A recording of a job.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Recorded {
    /// Its number, 1 for the first.
    pub(super) number: usize,
    /// The place, 1 for the first; 0 is the reference.
    pub(super) place: usize,
    /// How many drops it holds.
    pub(super) drops: usize,
    /// Its file, relative to the job.
    pub(super) file: PathBuf,
    /// The SHA-256 of this file.
    pub(super) sha256: Hash,
    /// The name under which it was given.
    pub(super) given_as: String,
    /// Who dropped the ball, if that was stated.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub(super) operator: String,
    /// Date and time.
    pub(super) added: String,
    /// Why it was repeated, if it was.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) repeated: Option<String>,
}

impl Recorded {
    /// What its results are called in the journal.
    fn name(&self) -> String {
        self.file.to_string_lossy().into_owned()
    }

    fn key(&self, settings: Hash) -> Key {
        Key {
            content: self.sha256,
            settings,
        }
    }
}

/// A job.
pub(super) struct Job {
    folder: PathBuf,
    pub(super) notes: Notes,
    pub(super) recorded: Vec<Recorded>,
    /// The checks of the method at its start.
    pub(super) checks: Vec<MethodCheck>,
    /// How many lines of the journal are damaged, and do not count.
    pub(super) damaged: usize,
}

impl Job {
    /// Makes the folder of a job with notes to fill in.
    pub(super) fn create(folder: &Path, notes: &str) -> Result<PathBuf, Failure> {
        let path = folder.join(NOTES);
        let made = create_folder(&folder.join(SOUNDS)).and_then(|()| {
            if path.exists() {
                return Err(io::ErrorKind::AlreadyExists.into());
            }
            Outputs::default().write(&path, mark::DATA, notes.as_bytes())
        });
        made.map_err(|reason| Failure::unwritable(&path, &reason))?;
        Ok(path)
    }

    /// Reads a job.
    pub(super) fn open(folder: &Path) -> Result<Self, Failure> {
        let path = folder.join(NOTES);
        let mut notes: Notes = toml::from_str(&noted(&path)?).map_err(unreadable(&path))?;
        if notes.schema != SCHEMA {
            return Err(unreadable(&path)(format!(
                "the schema must be \"{SCHEMA}\""
            )));
        }
        if let Some(laboratory) = &notes.laboratory {
            Laboratory::read(&folder.join(laboratory), &mut notes.test)?;
        }
        let mut job = Self {
            folder: folder.to_owned(),
            notes,
            recorded: Vec::new(),
            checks: Vec::new(),
            damaged: 0,
        };
        let journal = job.journal()?;
        job.damaged = journal.damaged();
        for event in journal.all(&events()).map_err(|fault| of_journal(&fault))? {
            job.apply(event);
        }
        Ok(job)
    }

    /// The journal, for a moment: while it is open, others wait who listen, add or show.
    fn journal(&self) -> Result<Journal, Failure> {
        Journal::open_in_turn(&self.folder).map_err(|fault| of_journal(&fault))
    }

    fn apply(&mut self, event: Event) {
        match event {
            Event::Checked(check) => self.checks.push(check),
            Event::Added(recorded) => self.recorded.push(recorded),
            Event::Repeated { number, reason } => {
                let of_number = |recorded: &&mut Recorded| recorded.number == number;
                if let Some(recorded) = self.recorded.iter_mut().find(of_number) {
                    recorded.repeated = Some(reason);
                }
            }
        }
    }

    /// The recordings that count in a place; 0 is the reference.
    pub(super) fn of_place(&self, place: usize) -> impl Iterator<Item = &Recorded> {
        self.recorded
            .iter()
            .filter(move |recorded| recorded.place == place && recorded.repeated.is_none())
    }

    /// How many drops count in a place.
    pub(super) fn drops(&self, place: usize) -> usize {
        self.of_place(place).map(|recorded| recorded.drops).sum()
    }

    /// The result of a recording under these settings, from the journal or, if it has none, made of the file, which must
    /// be as it was added.
    pub(super) fn result<R: Serialize + DeserializeOwned>(
        &self,
        recorded: &Recorded,
        settings: Hash,
        make: impl FnOnce(&Path) -> Result<R, Failure>,
    ) -> Result<R, Failure> {
        let path = self.folder.join(&recorded.file);
        if hash_of_file(&path)? != recorded.sha256 {
            let changed = "it was changed since it was added: its SHA-256 is another";
            return Err(Failure::Input(format!("{}: {changed}", Plain::path(&path))));
        }
        let (name, key) = (recorded.name(), recorded.key(settings));
        if let Some(known) = self
            .journal()?
            .read(&name, &key)
            .map_err(|fault| of_journal(&fault))?
        {
            return Ok(known);
        }
        let made = make(&path)?;
        self.append(&name, &key, &made)?;
        Ok(made)
    }

    /// A name for the next recording that no file has: a sound without a line, as after a crash, is kept too.
    pub(super) fn free(&self, ending: &str) -> PathBuf {
        let after = self.recorded.last().map_or(1, |last| last.number + 1);
        let mut names = (after..).map(|number| {
            self.folder
                .join(SOUNDS)
                .join(format!("{number:03}.{ending}"))
        });
        names.find(|path| !path.exists()).unwrap_or_default()
    }

    /// Keeps a copy of a recording, whole or not at all; one that is among the sounds is where it belongs.
    pub(super) fn keep(&self, path: &Path) -> Result<PathBuf, Failure> {
        let sounds = self.folder.join(SOUNDS);
        let is_here =
            path.canonicalize()?.parent().map(Path::to_owned) == sounds.canonicalize().ok();
        if is_here {
            let name = path.file_name().unwrap_or_default();
            return Ok(sounds.join(name));
        }
        let ending = path
            .extension()
            .map_or_else(|| "wav".into(), |ending| ending.to_string_lossy());
        let kept = self.free(&ending);
        let copied = remove_drafts(&sounds).and_then(|()| {
            let draft = Outputs::default().draft(&kept, mark::DATA)?;
            io::copy(&mut File::open(path)?, &mut draft.file())?;
            draft.file().flush()?;
            draft.finish()
        });
        copied.map_err(|reason| Failure::unwritable(&kept, &reason))?;
        Ok(kept)
    }

    /// Writes down a recording that is among the sounds: from now on it counts.
    pub(super) fn add(&mut self, recorded: Recorded) -> Result<(), Failure> {
        self.write(&recorded.clone(), Event::Added(recorded))
    }

    /// The file of a sound, relative to the job, and its number.
    pub(super) fn numbered(&self, kept: &Path) -> (PathBuf, usize) {
        let file = Path::new(SOUNDS).join(kept.file_name().unwrap_or_default());
        let after = self.recorded.last().map_or(1, |last| last.number + 1);
        let stated = file
            .file_stem()
            .and_then(|stem| stem.to_str()?.parse().ok());
        (file, stated.unwrap_or(after))
    }

    /// Writes down a check of the method.
    pub(super) fn checked(&mut self, check: MethodCheck) -> Result<(), Failure> {
        let key = Key {
            content: hash(check.made.as_bytes()),
            settings: events(),
        };
        let event = Event::Checked(check);
        self.append("check", &key, &event)?;
        self.apply(event);
        Ok(())
    }

    /// Marks a recording as repeated.
    pub(super) fn repeat(&mut self, number: usize, reason: &str) -> Result<(), Failure> {
        let counts =
            |recorded: &&Recorded| recorded.number == number && recorded.repeated.is_none();
        let Some(recorded) = self.recorded.iter().find(counts).cloned() else {
            return Err(Failure::Usage(format!(
                "the job has no recording {number} that counts; `bouncelab job show` lists them"
            )));
        };
        let reason = reason.to_owned();
        self.write(&recorded, Event::Repeated { number, reason })
    }

    /// The sounds that have no line, nor are copies of one that has: a crash or Ctrl-C came before it.
    pub(super) fn uncounted(&self) -> Result<Vec<PathBuf>, Failure> {
        let known: BTreeSet<&Path> = self
            .recorded
            .iter()
            .map(|recorded| recorded.file.as_path())
            .collect();
        let hashes: BTreeSet<Hash> = self
            .recorded
            .iter()
            .map(|recorded| recorded.sha256)
            .collect();
        let mut sounds = Vec::new();
        for entry in fs::read_dir(self.folder.join(SOUNDS))? {
            let file = Path::new(SOUNDS).join(entry?.file_name());
            let is_hidden = file
                .file_name()
                .is_some_and(|name| name.as_encoded_bytes().starts_with(b"."));
            let path = self.folder.join(&file);
            if !is_hidden
                && !known.contains(file.as_path())
                && !hashes.contains(&hash_of_file(&path)?)
            {
                sounds.push(path);
            }
        }
        sounds.sort();
        Ok(sounds)
    }

    /// Writes down what happened to a recording; it is on the disk when this returns.
    fn write(&mut self, recorded: &Recorded, event: Event) -> Result<(), Failure> {
        self.append(&recorded.name(), &recorded.key(events()), &event)?;
        self.apply(event);
        Ok(())
    }

    fn append(&self, name: &str, key: &Key, result: &impl Serialize) -> Result<(), Failure> {
        let journal = self.journal()?;
        let written = journal
            .append(name, key, result)
            .and_then(|()| journal.sync());
        written.map_err(|fault| of_journal(&fault))
    }

    /// The journal's file.
    pub(super) fn journal_file(&self) -> PathBuf {
        self.folder.join(JOURNAL)
    }
}

/// Under what the journal has events in place of results.
fn events() -> Hash {
    hash(SCHEMA.as_bytes())
}

/// A fault of the journal, without what a session advises: a job cannot name another folder for its output.
fn of_journal(fault: &bouncelab_session::Error) -> Failure {
    Failure::Input(fault.to_string())
}
