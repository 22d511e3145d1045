//! A job in a folder: its notes, its sounds, and the journal of its drops.

use std::collections::BTreeSet;
use std::fmt::Display;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use bouncelab::Plain;
use bouncelab::rulebook::{self, Rebound};
use bouncelab_report::file::{Outputs, create_folder, read_noted, remove_drafts};
use bouncelab_report::job::{Event, History, Job, NOTES, Notes, Recorded, SOUNDS, file_name};
use bouncelab_report::report::verdict::TestNotes;
use bouncelab_report::{mark, rules};
use bouncelab_session::BUILD;
use bouncelab_session::hash::{Hash, hash_of_file};
use bouncelab_session::journal::{JOURNAL, Journal, Key};
use serde::{Deserialize, Serialize};

use crate::failure::Failure;
use crate::verdict::setup_of_rule;

/// No notes are longer.
const MAX_MB: u64 = 2;

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

/// A job in its folder.
pub(super) struct Folder {
    path: PathBuf,
    pub(super) job: Job,
    /// How many lines of the journal are damaged, and do not count.
    pub(super) damaged: usize,
}

impl Folder {
    /// Makes the folder of a job with notes to fill in.
    pub(super) fn create(path: &Path, notes: &str) -> Result<PathBuf, Failure> {
        let file = path.join(NOTES);
        let made = create_folder(&path.join(SOUNDS)).and_then(|()| {
            if file.exists() {
                return Err(io::ErrorKind::AlreadyExists.into());
            }
            Outputs::default().write(&file, mark::DATA, notes.as_bytes())
        });
        made.map_err(|reason| Failure::unwritable(&file, &reason))?;
        Ok(file)
    }

    /// Reads a job.
    pub(super) fn open(path: &Path) -> Result<Self, Failure> {
        let file = path.join(NOTES);
        let mut notes = Notes::read(&noted(&file)?).map_err(unreadable(&file))?;
        if let Some(laboratory) = &notes.laboratory {
            Laboratory::read(&path.join(laboratory), &mut notes.test)?;
        }
        let files: Vec<PathBuf> = notes.rules.iter().map(|rules| path.join(rules)).collect();
        let rule = rulebook::find(&rules::all(&files)?, &notes.rule)?.clone();
        let setup = setup_of_rule(&notes.settings, &rule, |settings| Ok(settings.resolve()?))?;
        let mut folder = Self {
            path: path.to_owned(),
            job: Job::new(notes, rule, setup, &BUILD)?,
            damaged: 0,
        };
        let journal = folder.journal()?;
        folder.damaged = journal.damaged();
        let events = journal.all(&History::events());
        for event in events.map_err(|fault| of_journal(&fault))? {
            folder.job.history.apply(event);
        }
        Ok(folder)
    }

    /// The journal, for a moment: while it is open, others wait who listen, add or show.
    fn journal(&self) -> Result<Journal, Failure> {
        Journal::open_in_turn(&self.path).map_err(|fault| of_journal(&fault))
    }

    /// The rebounds in a recording, from the journal or, if it has none under these settings, made of the file, which must
    /// be as it was added.
    pub(super) fn rebounds(
        &self,
        recorded: &Recorded,
        make: impl FnOnce(&Path) -> Result<Vec<Rebound>, Failure>,
    ) -> Result<Vec<Rebound>, Failure> {
        let path = self.path.join(&recorded.file);
        if hash_of_file(&path)? != recorded.sha256 {
            let changed = "it was changed since it was added: its SHA-256 is another";
            return Err(Failure::Input(format!("{}: {changed}", Plain::path(&path))));
        }
        let (name, key) = (recorded.name(), recorded.key(self.job.settings));
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
        let names = (self.job.history.next_number()..).map(|number| file_name(number, ending));
        let mut paths = names.map(|name| self.path.join(SOUNDS).join(name));
        paths.find(|path| !path.exists()).unwrap_or_default()
    }

    /// Keeps a copy of a recording, whole or not at all; one that is among the sounds is where it belongs.
    pub(super) fn keep(&self, path: &Path) -> Result<PathBuf, Failure> {
        let sounds = self.path.join(SOUNDS);
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

    /// The file of a sound, relative to the job, and its number.
    pub(super) fn numbered(&self, kept: &Path) -> (PathBuf, usize) {
        let file = Path::new(SOUNDS).join(kept.file_name().unwrap_or_default());
        let stated = file
            .file_stem()
            .and_then(|stem| stem.to_str()?.parse().ok());
        (file, stated.unwrap_or(self.job.history.next_number()))
    }

    /// Marks a recording as repeated.
    pub(super) fn repeat(&mut self, number: usize, reason: String) -> Result<(), Failure> {
        if self.job.history.counting(number).is_none() {
            return Err(Failure::Usage(format!(
                "the job has no recording {number} that counts; `bouncelab job show` lists them"
            )));
        }
        self.write(Event::Repeated { number, reason })
    }

    /// Refuses a content that is a recording of the job already.
    pub(super) fn must_be_new(&self, path: &Path, content: Hash) -> Result<(), Failure> {
        match self.job.history.of_content(content) {
            Some(same) => Err(Failure::Usage(format!(
                "{} is recording {} of the job; each recording counts once",
                Plain::path(path),
                same.number
            ))),
            None => Ok(()),
        }
    }

    /// The sounds that have no line, nor are copies of one that has: a crash or Ctrl-C came before it.
    pub(super) fn uncounted(&self) -> Result<Vec<PathBuf>, Failure> {
        let history = &self.job.history;
        let known: BTreeSet<&Path> = history
            .recorded
            .iter()
            .map(|recorded| recorded.file.as_path())
            .collect();
        let mut sounds = Vec::new();
        for entry in fs::read_dir(self.path.join(SOUNDS))? {
            let file = Path::new(SOUNDS).join(entry?.file_name());
            let is_hidden = file
                .file_name()
                .is_some_and(|name| name.as_encoded_bytes().starts_with(b"."));
            let path = self.path.join(&file);
            let is_known = || known.contains(file.as_path());
            if !is_hidden && !is_known() && history.of_content(hash_of_file(&path)?).is_none() {
                sounds.push(path);
            }
        }
        sounds.sort();
        Ok(sounds)
    }

    /// Writes down what happened; it is on the disk when this returns.
    pub(super) fn write(&mut self, event: Event) -> Result<(), Failure> {
        let (name, key) = self.job.history.line_of(&event);
        self.append(&name, &key, &event)?;
        self.job.history.apply(event);
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
        self.path.join(JOURNAL)
    }
}

/// A fault of the journal, without what a session advises: a job cannot name another folder for its output.
fn of_journal(fault: &bouncelab_session::Error) -> Failure {
    Failure::Input(fault.to_string())
}
