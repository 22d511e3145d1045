//! A job on disk: its notes, its sounds, and the journal of its drops.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use bouncelab::Plain;
use bouncelab::settings::Settings;
use bouncelab_report::file::{create_folder, read_noted, sync_name};
use bouncelab_report::report::verdict::TestNotes;
use bouncelab_session::hash::hash_of_file;
use serde::{Deserialize, Serialize};

use crate::failure::Failure;

/// Name and version of the format.
const SCHEMA: &str = "bouncelab.job/1";
/// The notes, which people write.
const NOTES: &str = "job.toml";
/// The journal, which only grows.
const JOURNAL: &str = "drops.jsonl";
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
    /// What the report states.
    #[serde(default)]
    pub(super) test: TestNotes,
    /// Any setting, by the names of the JSON.
    #[serde(default)]
    pub(super) settings: Settings,
}

/// A line of the journal.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
enum Event {
    /// A recording was added.
    Added(Recorded),
    /// A recording does not count any more: why. Its sound is kept.
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
    pub(super) sha256: String,
    /// The name under which it was given.
    pub(super) given_as: String,
    /// Date and time.
    pub(super) added: String,
    /// Why it was repeated, if it was.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(super) repeated: Option<String>,
}

/// A job.
pub(super) struct Job {
    folder: PathBuf,
    pub(super) notes: Notes,
    pub(super) recorded: Vec<Recorded>,
    /// Whether the journal ends within a line, as after a crash.
    torn: bool,
}

impl Job {
    /// Makes the folder of a job with notes to fill in.
    pub(super) fn create(folder: &Path, notes: &str) -> Result<PathBuf, Failure> {
        let path = folder.join(NOTES);
        let made = create_folder(&folder.join(SOUNDS)).and_then(|()| {
            let mut file = OpenOptions::new()
                .write(true)
                .create_new(true)
                .open(&path)?;
            file.write_all(notes.as_bytes())?;
            file.sync_all()?;
            sync_name(&path)
        });
        made.map_err(|reason| Failure::unwritable(&path, &reason))?;
        Ok(path)
    }

    /// Reads a job, up to the last whole line of its journal.
    pub(super) fn open(folder: &Path) -> Result<Self, Failure> {
        let path = folder.join(NOTES);
        let bytes =
            read_noted(&path, MAX_MB).map_err(|reason| unreadable(&path, &reason.to_string()))?;
        let text =
            String::from_utf8(bytes).map_err(|reason| unreadable(&path, &reason.to_string()))?;
        let notes: Notes =
            toml::from_str(&text).map_err(|reason| unreadable(&path, &reason.to_string()))?;
        if notes.schema != SCHEMA {
            return Err(unreadable(
                &path,
                &format!("the schema must be \"{SCHEMA}\""),
            ));
        }
        let journal = match fs::read(folder.join(JOURNAL)) {
            Ok(bytes) => bytes,
            Err(reason) if reason.kind() == io::ErrorKind::NotFound => Vec::new(),
            Err(reason) => return Err(unreadable(&folder.join(JOURNAL), &reason.to_string())),
        };
        let mut job = Self {
            folder: folder.to_owned(),
            notes,
            recorded: Vec::new(),
            torn: !journal.is_empty() && !journal.ends_with(b"\n"),
        };
        for (line, number) in journal.split_inclusive(|&byte| byte == b'\n').zip(1..) {
            match serde_json::from_slice(line) {
                Ok(event) => job.apply(event),
                // A line that a crash cut off was not acknowledged.
                Err(_) if !line.ends_with(b"\n") => {}
                Err(reason) => {
                    let path = folder.join(JOURNAL);
                    return Err(unreadable(&path, &format!("line {number}: {reason}")));
                }
            }
        }
        Ok(job)
    }

    fn apply(&mut self, event: Event) {
        match event {
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

    /// The file of a recording, if it is as it was added.
    pub(super) fn sound(&self, recorded: &Recorded) -> Result<PathBuf, Failure> {
        let path = self.folder.join(&recorded.file);
        let found = hash_of_file(&path)?.to_string();
        if found == recorded.sha256 {
            Ok(path)
        } else {
            Err(unreadable(
                &path,
                "it was changed since it was added: its SHA-256 is another",
            ))
        }
    }

    /// Keeps a copy of a recording, then writes it down. A copy that is not whole has no line.
    pub(super) fn add(
        &mut self,
        path: &Path,
        place: usize,
        drops: usize,
        added: String,
    ) -> Result<usize, Failure> {
        let ending = path
            .extension()
            .map_or_else(|| "wav".into(), |ending| ending.to_string_lossy());
        let after = self.recorded.last().map_or(1, |last| last.number + 1);
        // A sound without a line, as after a crash, is kept too.
        let sounds = (after..).map(|number| {
            (
                number,
                Path::new(SOUNDS).join(format!("{number:03}.{ending}")),
            )
        });
        let free = |(_, file): &(usize, PathBuf)| !self.folder.join(file).exists();
        let (number, file) = sounds.into_iter().find(free).unwrap_or_default();
        let kept = self.folder.join(&file);
        copy(path, &kept).map_err(|reason| Failure::unwritable(&kept, &reason))?;
        let recorded = Recorded {
            number,
            place,
            drops,
            file,
            sha256: hash_of_file(&kept)?.to_string(),
            given_as: String::from(Plain::path(path)),
            added,
            repeated: None,
        };
        self.write(Event::Added(recorded))?;
        Ok(number)
    }

    /// Marks a recording as repeated.
    pub(super) fn repeat(&mut self, number: usize, reason: &str) -> Result<(), Failure> {
        let counts = |recorded: &Recorded| recorded.number == number && recorded.repeated.is_none();
        if !self.recorded.iter().any(counts) {
            return Err(Failure::Usage(format!(
                "the job has no recording {number} that counts; `bouncelab job show` lists them"
            )));
        }
        self.write(Event::Repeated {
            number,
            reason: reason.to_owned(),
        })
    }

    fn write(&mut self, event: Event) -> Result<(), Failure> {
        let path = self.folder.join(JOURNAL);
        let line = serde_json::to_string(&event).map_err(io::Error::from)? + "\n";
        let written = OpenOptions::new()
            .append(true)
            .create(true)
            .open(&path)
            .and_then(|mut file| {
                if self.torn {
                    // What a crash cut off becomes a line of its own no more.
                    let whole = fs::read(&path)?
                        .iter()
                        .rposition(|&byte| byte == b'\n')
                        .map_or(0, |end| end + 1);
                    file.set_len(whole as u64)?;
                }
                file.write_all(line.as_bytes())?;
                file.sync_all()?;
                sync_name(&path)
            });
        written.map_err(|reason| Failure::unwritable(&path, &reason))?;
        self.torn = false;
        self.apply(event);
        Ok(())
    }
}

/// A copy that appears whole or not at all, and is on the disk.
fn copy(from: &Path, to: &Path) -> io::Result<()> {
    let draft = to.with_extension("part");
    fs::copy(from, &draft)?;
    File::open(&draft)?.sync_all()?;
    fs::rename(&draft, to)?;
    sync_name(to)
}

fn unreadable(path: &Path, reason: &str) -> Failure {
    Failure::Input(format!("{}: {reason}", Plain::path(path)))
}
