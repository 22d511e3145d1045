//! The metadata of recordings as quantities, and their checks.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::sync::Arc;

use bouncelab::settings::{
    AirSettings, BallSettings, DropSettings, EditSettings, Settings, Setup, plausibility,
};
use bouncelab::{Diagnostic, Options, ball};
use bouncelab_report::groups::some_of;
use bouncelab_report::messages::Translator;
use bouncelab_report::units;
use serde::Serialize;

use crate::error::{Error, Result};
use crate::hash::{Hash, hash_of};
use crate::journal::Key;
use crate::notes::{Note, Notes};
use crate::record::{RECORD, Record};
use crate::recordings::{RecordingFile, Session};

/// Reads a quantity with its unit.
type Reader = fn(&str) -> std::result::Result<f64, String>;

/// Fields that are quantities.
const QUANTITIES: [(&str, Reader); 8] = [
    ("height", units::length),
    ("height_sd", units::length),
    ("mass", units::mass),
    ("diameter", units::length),
    ("contact_time", units::time),
    ("temperature", units::temperature),
    ("pressure", units::pressure),
    ("humidity", units::share),
];

/// Quantities by which drops are compared too.
const COMPARED: [&str; 2] = ["height", "temperature"];

/// Other fields with a meaning of their own.
const NAMES: [&str; 3] = ["ball", "surface", "operator"];

/// Fields that a ball in a session file may have.
const OF_A_BALL: [&str; 4] = ["kind", "mass", "diameter", "contact_time"];

/// A recording and what is known of it.
#[derive(Debug, Clone)]
pub struct KnownRecording {
    /// The recording.
    pub recording: RecordingFile,
    /// What its notes mean.
    pub metadata: Arc<Metadata>,
}

/// The versions of the libraries, and the hash of their sources.
pub const BUILD: [&str; 4] = [
    env!("CARGO_PKG_VERSION"),
    bouncelab::VERSION,
    bouncelab_audio::VERSION,
    env!("BOUNCELAB_BUILD"),
];

/// The hash of settings, and of this very build of the science: equal only for equal results.
pub(crate) fn hash_of_build(settings: &impl Serialize) -> Hash {
    hash_of(&(BUILD, settings))
}

impl KnownRecording {
    /// What its result depends on: its content, the settings, and this very build of the science.
    pub fn key(&self, content: Hash) -> Key {
        Key {
            content,
            settings: self.settings(),
        }
    }

    /// Hash of the settings of its result, and of this build.
    pub(crate) fn settings(&self) -> Hash {
        hash_of_build(&(RECORD, self.options()))
    }

    /// What it says; `None` if this is not its content, or no longer.
    pub fn record(&self, content: Hash) -> Option<Record> {
        self.recording.record(content, self.options())
    }

    /// How it is analysed.
    pub fn options(&self) -> &Options {
        &self.metadata.setup.options
    }

    /// What it is called in tables.
    pub fn name(&self) -> &str {
        &self.recording.name
    }
}

/// What the notes of a recording mean; recordings with the same notes share it.
#[derive(Debug)]
pub struct Metadata {
    /// What was stated, of all recordings and of this one.
    pub settings: Settings,
    /// The options that follow, and what was assumed.
    pub setup: Setup,
    /// What its drops are compared by: "surface", "steel".
    pub factors: BTreeMap<String, String>,
    /// The drop height as noted, m.
    pub height_m: Option<f64>,
    /// The temperature as noted, K.
    pub temperature_k: Option<f64>,
}

impl Metadata {
    /// Whether there is to be an inference.
    pub fn asks_inference(&self) -> bool {
        self.setup.options.inference.is_some()
    }
}

/// What is stated first, and of the rest what is stated second.
///
/// A ball replaces a ball, whose mass and diameter are not its own; and the uncertainty of one height is not that of
/// another.
fn completed(first: &Settings, second: &Settings) -> Settings {
    let mut rest = second.clone();
    if first.ball.kind.is_some() {
        (rest.ball.kind, rest.ball.mass_kg, rest.ball.diameter_m) = (None, None, None);
    }
    if first.drop.height_m.is_some() {
        rest.drop.height_sd_m = None;
    }
    let [first, mut both] = [first, &rest].map(|settings| {
        let plain = serde_json::to_value(settings).expect("settings are plain data");
        serde_json::from_value::<Groups>(plain).expect("settings are in groups")
    });
    for (group, settings) in first {
        let stated = settings.into_iter().filter(|(_, value)| !value.is_null());
        both.entry(group).or_default().extend(stated);
    }
    let both = serde_json::to_value(both).expect("settings are plain data");
    serde_json::from_value(both).expect("these are settings")
}

/// The settings as plain data, by group and name.
type Groups = BTreeMap<String, BTreeMap<String, serde_json::Value>>;

/// How notes are read.
#[derive(Clone, Copy)]
#[expect(missing_debug_implementations, reason = "a translator cannot be shown")]
pub struct MetadataOptions<'a> {
    /// What holds for all recordings. If it says the ball, any name in the notes may stand for it.
    pub settings: &'a Settings,
    /// Whether to believe what looks like a mistake.
    pub allow_implausible: bool,
    /// Whether recordings may lack what others have.
    pub allow_missing: bool,
    /// The language of questions.
    pub translator: &'a Translator,
    /// How the reader of a question allows it.
    pub advice: Advice<'a>,
}

/// Sentences of the front end that end a question.
#[derive(Debug, Clone, Copy)]
pub struct Advice<'a> {
    /// How to allow what looks like a mistake: "Correct it, or ...".
    pub implausible: &'a str,
    /// How to go on where something is missing: "or ...".
    pub missing: &'a str,
    /// How to state the ball of all recordings: "or ...".
    pub ball: &'a str,
}

impl MetadataOptions<'_> {
    /// Finds out what the notes of every recording mean.
    ///
    /// # Errors
    /// [`Error::Metadata`] with all that is wrong, so that it can be mended at once.
    pub fn read(&self, session: Session) -> Result<Vec<KnownRecording>> {
        let mut problems = Problems::default();
        self.question_settings(&session.settings, &mut problems);
        let settings = completed(self.settings, &session.settings);
        let options = MetadataOptions {
            settings: &settings,
            ..*self
        };
        let mut known: HashMap<BTreeMap<String, String>, Arc<Metadata>> = HashMap::new();
        let all: Vec<Option<Arc<Metadata>>> = (0..session.recordings.len())
            .map(|place| {
                let (texts, metadata) = options.one(&session, place, &mut problems)?;
                let shared = known.entry(texts).or_insert_with(|| Arc::new(metadata));
                Some(Arc::clone(shared))
            })
            .collect();
        if !self.allow_missing {
            problems.missing(&session, self.advice.missing);
        }
        if let Some(problem) = problems.message(self.advice.ball) {
            return Err(Error::Metadata { problem });
        }
        let known = std::iter::zip(session.recordings, all);
        let known = known.filter_map(|(recording, metadata)| {
            metadata.map(|metadata| KnownRecording {
                recording,
                metadata,
            })
        });
        Ok(known.collect())
    }

    /// Questions what the session file states for all recordings.
    fn question_settings(&self, settings: &Settings, problems: &mut Problems) {
        if settings.edits != EditSettings::default() {
            let problem = "[settings.edits]: impacts are excluded and included in single recordings, by \
                           'bouncelab analyze'; leave it out";
            problems.general.insert(problem.to_owned());
        }
        let questions = settings.questions().into_iter();
        for question in questions.filter(|_| !self.allow_implausible) {
            let question = self.translator.diagnostic(&question);
            let advice = self.advice.implausible;
            problems
                .general
                .insert(format!("[settings]: {question} {advice}"));
        }
    }

    /// The texts noted of a recording, and what they mean.
    fn one(
        &self,
        session: &Session,
        place: usize,
        problems: &mut Problems,
    ) -> Option<(BTreeMap<String, String>, Metadata)> {
        let mut one = One {
            options: self,
            name: &session.recordings[place].name,
            said: BTreeMap::new(),
            problems,
        };
        one.agree(&session.notes(place));
        one.question_fields();
        let said = one.said.clone();
        let mut values = one.values(&said);
        let kind = one.ball(&session.balls, &mut values);
        let value = |field: &str| values.get(field).copied();
        let kind = kind.map(|kind| units::ball(&kind)).transpose();
        let kind = kind.map_err(|problem| one.problem(problem)).ok()?;
        let noted = Settings {
            ball: BallSettings {
                kind,
                mass_kg: value("mass"),
                diameter_m: value("diameter"),
                contact_time_s: value("contact_time"),
            },
            air: AirSettings {
                temperature_k: value("temperature"),
                pressure_pa: value("pressure"),
                relative_humidity: value("humidity"),
                ..AirSettings::default()
            },
            drop: DropSettings {
                height_m: value("height"),
                height_sd_m: value("height_sd"),
                ..DropSettings::default()
            },
            ..Settings::default()
        };
        let settings = completed(&noted, self.settings);
        let setup = settings.resolve();
        let setup = setup
            .map_err(|refusal| one.problem(self.translator.diagnostic(&refusal.diagnostic())))
            .ok()?;
        if let Some(question) = plausibility::of_ball(&setup.options.ball) {
            one.question(&question, "");
        }
        let texts = said.into_iter().map(|(field, note)| (field, note.text));
        let texts: BTreeMap<String, String> = texts.collect();
        let mut factors = texts.clone();
        factors.retain(|field, _| COMPARED.contains(&&**field) || reader(field).is_none());
        // The same height in other words is the same level.
        if let Some(height_m) = noted.drop.height_m {
            let level = format!("{} cm", rounded(height_m * 100.0));
            factors.insert("height".to_owned(), level);
        }
        if let Some(kelvin) = noted.air.temperature_k {
            let level = format!("{} \u{b0}C", rounded(kelvin - 273.15));
            factors.insert("temperature".to_owned(), level);
        }
        let metadata = Metadata {
            settings,
            setup,
            factors,
            height_m: noted.drop.height_m,
            temperature_k: noted.air.temperature_k,
        };
        Some((texts, metadata))
    }
}

/// How the text of a field is read, if it is a quantity.
fn reader(field: &str) -> Option<Reader> {
    let mut quantities = QUANTITIES.iter();
    let (_, read) = quantities.find(|(name, _)| *name == field)?;
    Some(*read)
}

/// A number without the noise of binary fractions.
fn rounded(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}

/// One recording while its notes are read.
struct One<'a> {
    options: &'a MetadataOptions<'a>,
    name: &'a str,
    /// The statement that counts, by field.
    said: BTreeMap<String, Note>,
    problems: &'a mut Problems,
}

impl One<'_> {
    fn problem(&mut self, text: String) {
        let names = self.problems.recordings.entry(text).or_default();
        names.push(self.name.to_owned());
    }

    /// Questions what looks like a mistake, unless that is allowed.
    fn question(&mut self, question: &Diagnostic, source: &str) {
        let MetadataOptions {
            translator, advice, ..
        } = self.options;
        if !self.options.allow_implausible {
            let question = translator.diagnostic(question);
            self.problem(format!("{question} {}{source}", advice.implausible));
        }
    }

    /// Takes one statement for each field, if all made of it agree.
    fn agree(&mut self, notes: &BTreeMap<String, Vec<Note>>) {
        for (field, statements) in notes {
            let mut statements = statements.iter().filter(|note| !note.text.is_empty());
            let Some(first) = statements.next() else {
                continue;
            };
            if let Some(other) = statements.find(|other| !same(field, &other.text, &first.text)) {
                self.problem(format!(
                    "the {field} is \"{}\" by {}, but \"{}\" by {}; correct one of them",
                    first.text, first.said_by, other.text, other.said_by
                ));
            }
            self.said.insert(field.clone(), first.clone());
        }
    }

    /// Any field may be noted, but one that looks like a slip would be lost.
    fn question_fields(&mut self) {
        if self.options.allow_implausible {
            return;
        }
        let known = || {
            let quantities = QUANTITIES.iter().map(|(name, _)| *name);
            quantities.chain(NAMES)
        };
        let odd = self
            .said
            .keys()
            .filter(|field| !known().any(|name| name == *field));
        let advice = self.options.advice.implausible;
        let questions: Vec<String> = odd
            .filter_map(|field| {
                let meant = near(field, known())?;
                Some(format!("a {field}? Did you mean {meant}? {advice}"))
            })
            .collect();
        for question in questions {
            self.problem(question);
        }
    }

    /// The values of quantities that were noted and make sense.
    fn values(&mut self, notes: &Notes) -> BTreeMap<&'static str, f64> {
        let mut values = BTreeMap::new();
        for (field, read) in QUANTITIES {
            let Some(Note { text, said_by }) = notes.get(field) else {
                continue;
            };
            match read(text) {
                Ok(value) => {
                    let quantity = field.replace('_', "-");
                    if let Some(question) = plausibility::of_quantity(&quantity, value) {
                        self.question(&question, &format!(" (\"{text}\" by {said_by})"));
                    }
                    values.insert(field, value);
                }
                Err(problem) => self.problem(format!("{field}, by {said_by}: {problem}")),
            }
        }
        values
    }

    /// The kind of the ball that was noted, if it has one; adds what is known of it to the values.
    fn ball(
        &mut self,
        balls: &BTreeMap<String, Notes>,
        values: &mut BTreeMap<&'static str, f64>,
    ) -> Option<String> {
        let label = self.said.get("ball")?.text.clone();
        if let Some(of_ball) = balls.get(&label) {
            for (field, note) in of_ball {
                if !OF_A_BALL.contains(&field.as_str()) {
                    self.problems.general.insert(format!(
                        "[balls.{label}]: {field} (by {}) is no field of a ball; these are {}",
                        note.said_by,
                        OF_A_BALL.join(", ")
                    ));
                }
            }
            let mut of_ball = of_ball.clone();
            of_ball.retain(|field, _| OF_A_BALL.contains(&field.as_str()));
            for (field, value) in self.values(&of_ball) {
                values.entry(field).or_insert(value);
            }
            return of_ball.remove("kind").map(|note| note.text);
        }
        if ball::preset(&label).is_ok() || label.contains(':') {
            return Some(label);
        }
        let is_measured = ["mass", "diameter"].map(|field| self.said.contains_key(field));
        let of_all = self.options.settings;
        let is_known = of_all.ball.kind.is_some() || of_all.ball.mass_kg.is_some();
        if !is_known && is_measured != [true, true] {
            self.problems.unknown_balls.insert(label);
        }
        None
    }
}

/// The name that was meant, if one letter or two are wrong.
fn near<'a>(written: &str, known: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let slips = |name: &str| strsim::damerau_levenshtein(written, name);
    let nearest = known.min_by_key(|name| slips(name))?;
    let few = if nearest.len() > 5 { 2 } else { 1 };
    (slips(nearest) <= few).then_some(nearest)
}

/// Whether two statements mean the same.
fn same(field: &str, a: &str, b: &str) -> bool {
    let values = reader(field).and_then(|read| Some((read(a).ok()?, read(b).ok()?)));
    match values {
        Some((a, b)) => (a - b).abs() <= 1e-9 * a.abs().max(b.abs()),
        None => a == b,
    }
}

/// All that is wrong with the notes of a session.
#[derive(Default)]
struct Problems {
    general: BTreeSet<String>,
    unknown_balls: BTreeSet<String>,
    /// What is wrong, and with which recordings.
    recordings: BTreeMap<String, Vec<String>>,
}

impl Problems {
    /// Fields that some recordings have and others lack.
    fn missing(&mut self, session: &Session, advice: &str) {
        let places = 0..session.recordings.len();
        let fields: BTreeSet<String> = places
            .clone()
            .flat_map(|place| session.notes(place).into_keys())
            .collect();
        let mut lacking: BTreeMap<&str, Vec<String>> = BTreeMap::new();
        for place in places {
            let notes = session.notes(place);
            let says = |field: &String| {
                let notes = notes.get(field);
                notes.is_some_and(|notes| notes.iter().any(|note| !note.text.is_empty()))
            };
            for field in fields.iter().filter(|field| !says(field)) {
                let names = lacking.entry(field).or_default();
                names.push(session.recordings[place].name.clone());
            }
        }
        for (field, names) in lacking {
            let first = &names[0];
            let text = format!(
                "no {field} is noted, though others have one. Say it by {field} = \"...\" under \
                 [recordings.\"{first}\"] or [all] in session.toml, by a column {field} of a CSV, or \
                 by {{{field}}} in the pattern of the names; {advice}"
            );
            self.recordings.insert(text, names);
        }
    }

    fn message(self, advice: &str) -> Option<String> {
        let english = Translator::english();
        let mut lines: Vec<String> = self.general.into_iter().collect();
        for ball in &self.unknown_balls {
            let kinds: Vec<&str> = ball::presets().iter().map(|preset| preset.name).collect();
            let words = ball::presets().iter().flat_map(|preset| preset.words);
            let meant = near(ball, kinds.iter().chain(words).copied());
            let meant = meant.map_or_else(String::new, |kind| format!(" Did you mean {kind}?"));
            lines.push(format!(
                "what ball is \"{ball}\"?{meant} Write [balls.{ball}] with kind = \"...\" (or mass and \
                 diameter) in session.toml, {advice}. Kinds: {}, also with a diameter, \
                 as in steel:10mm",
                kinds.join(", ")
            ));
        }
        lines.extend(
            self.recordings
                .into_iter()
                .map(|(text, names)| format!("{}: {text}", some_of(&names, &english))),
        );
        match lines.as_slice() {
            [] => None,
            [line] => Some(line.clone()),
            _ => Some(format!(
                "the notes are not clear:\n  {}",
                lines.join("\n  ")
            )),
        }
    }
}
