//! A job: a test by a rule, drop after drop and place after place. Here is what its files say; who keeps them, the program
//! in a folder or the page in the database of a browser, reads and writes them.
//!
//! A job has its notes, `job.toml`, every recording in the folder `sounds`, and a [journal](crate::journal) of [`Event`]s and
//! of the rebounds in each recording.

mod notes;

use std::collections::BTreeMap;
use std::ops::RangeInclusive;
use std::path::PathBuf;

use bouncelab::Plain;
use bouncelab::rulebook::{Decision, Item, Precision, Rebound, Rule};
use bouncelab::settings::Setup;
use serde::{Deserialize, Serialize};

use crate::document::verdict::{Evaluation, Surface};
use crate::hash::{Hash, hash, hash_of};
use crate::journal::Key;
use crate::messages::Translator;
use crate::report::verdict::{MethodCheck, TestNotes};

pub use notes::Notes;

/// Name and version of the format.
pub const SCHEMA: &str = "bouncelab.job/2";
/// The notes, which people write.
pub const NOTES: &str = "job.toml";
/// The folder of the recordings.
pub const SOUNDS: &str = "sounds";
/// Maximum number of places of a new job, and of drops in each.
pub const MAX_NUMBER: u16 = 1000;
/// What a check of the method is called in the journal.
const CHECK: &str = "check";

/// What happened in a job, a line of the journal.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "event", rename_all = "kebab-case")]
pub enum Event {
    /// The method was checked, at the start.
    Checked(MethodCheck),
    /// A recording was added.
    Added(Recorded),
    /// A recording does not count any more: why. Its sound is kept.
    Repeated {
        /// Its number.
        number: usize,
        /// Why.
        reason: String,
    },
}

/// A recording of a job.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Recorded {
    /// Its number, 1 for the first.
    pub number: usize,
    /// The place, 1 for the first; 0 is the reference.
    pub place: usize,
    /// How many drops it holds.
    pub drops: usize,
    /// Its file, relative to the job.
    pub file: PathBuf,
    /// The SHA-256 of this file.
    pub sha256: Hash,
    /// The SHA-256 of the recording that was played in place of the microphone.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub played: Option<Hash>,
    /// The name under which it was given.
    pub given_as: String,
    /// Who dropped the ball, if that was stated.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub operator: String,
    /// Date and time.
    pub added: String,
    /// Why it was repeated, if it was.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub repeated: Option<String>,
}

impl Recorded {
    /// What its lines in the journal are called.
    pub fn name(&self) -> String {
        self.file.to_string_lossy().into_owned()
    }

    /// Under what the journal has its result with these settings.
    pub fn key(&self, settings: Hash) -> Key {
        Key {
            content: self.sha256,
            settings,
        }
    }

    /// The recording in words: its place, and what else is known of it.
    pub fn line(&self, translator: &Translator) -> String {
        let about = [&self.given_as, &self.operator, &self.added];
        let about = about.into_iter().filter(|part| !part.is_empty());
        let about: Vec<&str> = about.map(String::as_str).collect();
        let place = place_name(self.place, translator);
        let repeated = self.repeated.as_ref().map_or_else(String::new, |reason| {
            let reason = String::from(Plain::of(reason));
            let words = [("reason", reason.into())];
            format!(" ({})", translator.text_with("job-repeated", &words))
        });
        format!("{place}  {}{repeated}", about.join("  "))
    }
}

/// What happened so far.
#[derive(Clone, Debug, Default)]
pub struct History {
    /// All recordings, also those that were repeated.
    pub recorded: Vec<Recorded>,
    /// The checks of the method at the start.
    pub checks: Vec<MethodCheck>,
}

impl History {
    /// Under what the journal has events in place of results.
    pub fn events() -> Hash {
        hash(SCHEMA.as_bytes())
    }

    /// What an event is called in the journal, and under what it stands.
    pub fn line_of(&self, event: &Event) -> (String, Key) {
        let of_name = |name: &str| Key {
            content: hash(name.as_bytes()),
            settings: Self::events(),
        };
        let of = |recorded: &Recorded| (recorded.name(), recorded.key(Self::events()));
        match event {
            Event::Checked(check) => (CHECK.to_owned(), of_name(&check.made)),
            Event::Added(recorded) => of(recorded),
            Event::Repeated { number, .. } => self
                .counting(*number)
                .map_or_else(|| (number.to_string(), of_name("")), of),
        }
    }

    /// Takes what happened.
    pub fn apply(&mut self, event: Event) {
        match event {
            Event::Checked(check) => self.checks.push(check),
            Event::Added(recorded) => self.recorded.push(recorded),
            Event::Repeated { number, reason } => {
                let mut recorded = self.recorded.iter_mut();
                if let Some(recorded) = recorded.find(|recorded| recorded.number == number) {
                    recorded.repeated = Some(reason);
                }
            }
        }
    }

    /// The recording of this number, if it counts.
    pub fn counting(&self, number: usize) -> Option<&Recorded> {
        let mut recorded = self.recorded.iter();
        recorded.find(|recorded| recorded.number == number && recorded.repeated.is_none())
    }

    /// The recording of this content, as it was kept or as it was played.
    pub fn of_content(&self, content: Hash) -> Option<&Recorded> {
        let mut recorded = self.recorded.iter();
        recorded.find(|recorded| recorded.sha256 == content || recorded.played == Some(content))
    }

    /// The number of the next recording.
    pub fn next_number(&self) -> usize {
        self.recorded.last().map_or(1, |last| last.number + 1)
    }

    /// The recordings that count in a place; 0 is the reference.
    pub fn of_place(&self, place: usize) -> impl Iterator<Item = &Recorded> {
        let recorded = self.recorded.iter();
        recorded.filter(move |recorded| recorded.place == place && recorded.repeated.is_none())
    }

    /// How many drops count in a place.
    pub fn drops(&self, place: usize) -> usize {
        self.of_place(place).map(|recorded| recorded.drops).sum()
    }
}

/// The name of the file of a recording of this number.
pub fn file_name(number: usize, ending: &str) -> String {
    format!("{number:03}.{ending}")
}

/// What a place is called; 0 is the reference.
pub fn place_name(place: usize, translator: &Translator) -> String {
    if place == 0 {
        translator.text("verdict-item-reference")
    } else {
        translator.text_with("job-place-name", &[("place", place.into())])
    }
}

/// The rebounds in recordings, by their numbers.
pub type Rebounds = BTreeMap<usize, Vec<Rebound>>;

/// A job: its notes with what follows from them, and what happened so far.
#[derive(Clone, Debug)]
pub struct Job {
    /// What a person states.
    pub notes: Notes,
    /// The rule.
    pub rule: Rule,
    /// The settings of all drops, and what was kept.
    pub setup: Setup,
    /// What results depend on besides the sound.
    pub settings: Hash,
    /// What happened so far.
    pub history: History,
}

impl Job {
    /// Of these notes, with the rule and the settings that they name; `build` is that of the program.
    ///
    /// # Errors
    /// [`bouncelab::Error::UnknownName`] for a part of the procedure that nobody can state.
    pub fn new(
        notes: Notes,
        rule: Rule,
        mut setup: Setup,
        build: &impl Serialize,
    ) -> bouncelab::Result<Self> {
        let kept = notes.kept.iter().map(|name| Item::stated(name));
        setup.conditions.kept = kept.collect::<Result<_, _>>()?;
        let settings = hash_of(&(build, (&setup.options, &rule)));
        Ok(Self {
            notes,
            rule,
            setup,
            settings,
            history: History::default(),
        })
    }

    /// The places in their order, the reference first.
    pub fn places(&self) -> RangeInclusive<usize> {
        usize::from(!self.rule.needs_reference())..=self.notes.places
    }

    /// The next place with too few drops.
    pub fn next_place(&self) -> Option<usize> {
        self.places()
            .find(|&place| self.history.drops(place) < self.notes.drops)
    }

    /// "place 2 of 5, drop 3 of 5", of the drop of this number.
    pub fn position(&self, place: usize, drop: usize, translator: &Translator) -> String {
        let id = if place == 0 {
            "job-reference"
        } else {
            "job-place"
        };
        let words = [
            ("place", place.into()),
            ("places", self.notes.places.into()),
            ("drop", drop.into()),
            ("drops", self.notes.drops.into()),
        ];
        translator.text_with(id, &words)
    }

    /// The verdict on all that was recorded.
    ///
    /// # Errors
    /// As [`Evaluation::new`].
    pub fn evaluation(
        &self,
        rebounds: &Rebounds,
        translator: &Translator,
    ) -> bouncelab::Result<Evaluation> {
        let surface = |places: RangeInclusive<usize>| {
            let mut surface = Surface::default();
            for place in places {
                let of_place: Vec<Rebound> = self.rebounds_of(place, rebounds);
                if !of_place.is_empty() {
                    surface.push(place_name(place, translator), of_place);
                }
            }
            surface
        };
        let (there, here) = (surface(0..=0), surface(1..=self.notes.places));
        Evaluation::new(&self.rule, &self.setup, here, there, Decision::default())
    }

    fn rebounds_of(&self, place: usize, rebounds: &Rebounds) -> Vec<Rebound> {
        let of_place = self.history.of_place(place);
        let known = of_place.filter_map(|recorded| rebounds.get(&recorded.number));
        known.flatten().cloned().collect()
    }

    /// How drops repeat over operators, if several dropped the ball in the only place. Over places it would be unknown what
    /// differs by the operator.
    fn of_operators(&self, rebounds: &Rebounds) -> Option<Precision> {
        if self.notes.places > 1 {
            return None;
        }
        let mut levels: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
        for recorded in self.history.of_place(1) {
            let known = rebounds.get(&recorded.number).into_iter().flatten();
            let of_operator = levels.entry(&recorded.operator).or_default();
            of_operator.extend(known.filter_map(|rebound| rebound.height_m));
        }
        Precision::of(&levels.into_values().collect::<Vec<_>>())
    }

    /// What the report states, with the checks of the method at the start and `now`.
    pub fn test(&self, rebounds: &Rebounds, now: MethodCheck) -> TestNotes {
        TestNotes {
            checks: self.history.checks.iter().cloned().chain([now]).collect(),
            of_operators: self.of_operators(rebounds),
            ..self.notes.test.clone()
        }
    }

    /// Each recording in words, with its SHA-256.
    pub fn files(&self, translator: &Translator) -> Vec<(String, String)> {
        let recorded = self.history.recorded.iter();
        let about = |recorded: &Recorded| {
            let file = String::from(Plain::path(&recorded.file));
            format!("{file}\n    {}", recorded.line(translator))
        };
        recorded
            .map(|recorded| (about(recorded), recorded.sha256.to_string()))
            .collect()
    }
}
