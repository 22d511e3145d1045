//! What the notes of a recording mean, and what is wrong with them.

use std::collections::{BTreeMap, BTreeSet, HashMap};
use std::sync::Arc;

use bouncelab::ball;
use bouncelab_session::{KnownRecording, Metadata, Note, Notes, Session};

use crate::doubt;
use crate::failure::Failure;
use crate::physics::{Noted, Physics, PhysicsArguments};
use crate::priors::PriorArguments;
use crate::units;

/// Fields that describe the set-up; by all others, and by ball, height and temperature, drops are
/// compared.
const CONDITIONS: [&str; 6] = [
    "height_sd",
    "mass",
    "diameter",
    "contact_time",
    "pressure",
    "humidity",
];

/// Other fields with a meaning of their own.
const KNOWN: [&str; 5] = ["ball", "surface", "operator", "height", "temperature"];

/// Fields that a ball in a session file may have.
const OF_A_BALL: [&str; 4] = ["kind", "mass", "diameter", "contact_time"];

/// Reads a quantity with its unit.
type Reader = fn(&str) -> Result<f64, String>;

/// How notes are read.
pub(super) struct Reading<'a> {
    pub(super) physics: &'a PhysicsArguments,
    pub(super) priors: &'a PriorArguments,
    /// Whether recordings may lack what others say.
    pub(super) allow_missing: bool,
}

impl Reading<'_> {
    /// Understands every recording, or says all that stands against it.
    pub(super) fn resolve(&self, session: Session) -> Result<Vec<KnownRecording>, Failure> {
        let mut problems = Problems::default();
        // Recordings of which the same was noted share what it means.
        let mut known: HashMap<BTreeMap<String, String>, Arc<Metadata>> = HashMap::new();
        let all: Vec<Option<Arc<Metadata>>> = (0..session.recordings.len())
            .map(|place| {
                let (noted, metadata) = self.one(&session, place, &mut problems)?;
                let known = known.entry(noted).or_insert_with(|| Arc::new(metadata));
                Some(Arc::clone(known))
            })
            .collect();
        if !self.allow_missing {
            problems.missing(&session);
        }
        if let Some(message) = problems.message() {
            return Err(Failure::Usage(message));
        }
        let known = session.recordings.into_iter().zip(all);
        Ok(known
            .filter_map(|(recording, metadata)| {
                let metadata = metadata?;
                Some(KnownRecording {
                    recording,
                    metadata,
                })
            })
            .collect())
    }

    /// What was noted of a recording, and what it means.
    fn one(
        &self,
        session: &Session,
        place: usize,
        problems: &mut Problems,
    ) -> Option<(BTreeMap<String, String>, Metadata)> {
        let mut one = One {
            name: &session.recordings[place].name,
            allow_implausible: self.physics.allow_implausible(),
            said: BTreeMap::new(),
            problems,
        };
        one.agree(&session.notes(place));
        one.doubt_fields();
        let height_m = one.quantity("height", units::length);
        let height_sd_m = one.quantity("height_sd", units::length);
        let temperature_k = one.quantity("temperature", units::temperature);
        let mut noted = one.ball(&session.balls, self.physics.names_ball());
        noted.mass = one.quantity("mass", units::mass).or(noted.mass);
        noted.diameter = one.quantity("diameter", units::length).or(noted.diameter);
        let contact_time = one.quantity("contact_time", units::time);
        noted.contact_time = contact_time.or(noted.contact_time);
        noted.temperature = temperature_k;
        noted.pressure = one.quantity("pressure", units::pressure);
        noted.humidity = one.quantity("humidity", units::share);
        let said = one.said.iter();
        let said: BTreeMap<String, String> = said
            .map(|(field, note)| (field.clone(), note.text.clone()))
            .collect();
        let mut factors = said.clone();
        factors.retain(|field, _| !CONDITIONS.contains(&field.as_str()));
        // The same height in other words is the same level.
        let mut as_level = |field: &str, text: Option<String>| {
            if let Some(text) = text {
                factors.insert(field.to_owned(), text);
            }
        };
        as_level(
            "height",
            height_m.map(|height| format!("{} cm", rounded(height * 100.0))),
        );
        let celsius = temperature_k.map(|kelvin| kelvin - 273.15);
        as_level(
            "temperature",
            celsius.map(|celsius| format!("{} \u{b0}C", rounded(celsius))),
        );
        match self.physics_of(&noted, height_m, height_sd_m) {
            Ok(setup) => {
                one.doubt_ball(&setup);
                let metadata = Metadata {
                    setup,
                    factors,
                    height_m,
                    temperature_k,
                };
                Some((said, metadata))
            }
            Err(failure) => {
                one.problem(failure.to_string());
                None
            }
        }
    }

    fn physics_of(
        &self,
        noted: &Noted,
        height_m: Option<f64>,
        height_sd_m: Option<f64>,
    ) -> Result<Physics, Failure> {
        let mut physics = self.physics.with(noted).physics()?;
        let priors = self.priors.with_height(height_m, height_sd_m);
        priors.add_to(&mut physics.settings)?;
        Ok(physics)
    }
}

/// A number without the noise of binary fractions.
fn rounded(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}

/// One recording while its notes are read.
struct One<'a> {
    name: &'a str,
    allow_implausible: bool,
    /// The statement that counts, by field.
    said: BTreeMap<String, Note>,
    problems: &'a mut Problems,
}

impl One<'_> {
    fn problem(&mut self, text: String) {
        self.problems.of_recording(self.name, text);
    }

    /// Takes one statement for each field, if all made of it agree.
    fn agree(&mut self, notes: &BTreeMap<String, Vec<Note>>) {
        for (field, statements) in notes {
            let Some(first) = statements.iter().find(|note| !note.text.is_empty()) else {
                continue;
            };
            let other = statements
                .iter()
                .find(|note| !note.text.is_empty() && !same(field, &note.text, &first.text));
            if let Some(other) = other {
                let text = format!(
                    "the {field} is \"{}\" by {}, but \"{}\" by {}; correct one of them",
                    first.text, first.said_by, other.text, other.said_by
                );
                self.problem(text);
            }
            self.said.insert(field.clone(), first.clone());
        }
    }

    /// Any field may be noted, but one that looks like a slip would be lost.
    fn doubt_fields(&mut self) {
        if self.allow_implausible {
            return;
        }
        let known = || CONDITIONS.into_iter().chain(KNOWN);
        let odd = self
            .said
            .keys()
            .filter(|field| !known().any(|known| known == *field));
        let doubts: Vec<String> = odd
            .filter_map(|field| {
                let meant = near(field, known())?;
                Some(format!(
                    "a {field}? Did you mean {meant}? Correct it, or insist by --allow-implausible"
                ))
            })
            .collect();
        for doubt in doubts {
            self.problem(doubt);
        }
    }

    /// The value of a field, if it was noted, makes sense and looks right.
    fn quantity(&mut self, field: &'static str, read: Reader) -> Option<f64> {
        let note = self.said.get(field)?.clone();
        self.value(field, &note, read)
    }

    fn value(&mut self, field: &'static str, note: &Note, read: Reader) -> Option<f64> {
        match read(&note.text) {
            Ok(value) => {
                if let Some(doubt) =
                    doubt::of_quantity(field, value).filter(|_| !self.allow_implausible)
                {
                    self.problem(format!("{doubt} (\"{}\" by {})", note.text, note.said_by));
                }
                Some(value)
            }
            Err(problem) => {
                self.problem(format!("{field}, by {}: {problem}", note.said_by));
                None
            }
        }
    }

    /// What is known of the ball that was noted.
    fn ball(&mut self, balls: &BTreeMap<String, Notes>, named_for_all: bool) -> Noted {
        let Some(label) = self.said.get("ball").cloned() else {
            return Noted::default();
        };
        if let Some(of_ball) = balls.get(&label.text) {
            return self.described(&label.text, of_ball);
        }
        let is_kind = ball::preset(&label.text).is_ok() || label.text.contains(':');
        if is_kind {
            return Noted {
                ball: Some(label.text),
                ..Noted::default()
            };
        }
        let measured = self.said.contains_key("mass") && self.said.contains_key("diameter");
        if !named_for_all && !measured {
            self.problems.unknown_balls.insert(label.text);
        }
        Noted::default()
    }

    fn described(&mut self, label: &str, of_ball: &Notes) -> Noted {
        for (field, note) in of_ball {
            if !OF_A_BALL.contains(&field.as_str()) {
                self.problems.general.insert(format!(
                    "[balls.{label}]: {field} (by {}) is none of {}",
                    note.said_by,
                    OF_A_BALL.join(", ")
                ));
            }
        }
        let mut quantity = |field: &'static str, read| {
            let note = of_ball.get(field)?;
            self.value(field, note, read)
        };
        Noted {
            mass: quantity("mass", units::mass),
            diameter: quantity("diameter", units::length),
            contact_time: quantity("contact_time", units::time),
            ball: of_ball.get("kind").map(|note| note.text.clone()),
            ..Noted::default()
        }
    }

    fn doubt_ball(&mut self, physics: &Physics) {
        let ball = &physics.settings.ball;
        if let Some(doubt) = doubt::of_ball(ball).filter(|_| !self.allow_implausible) {
            self.problem(doubt.to_string());
        }
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
    let read: Option<Reader> = match field {
        "height" | "height_sd" | "diameter" => Some(units::length),
        "mass" => Some(units::mass),
        "contact_time" => Some(units::time),
        "temperature" => Some(units::temperature),
        "pressure" => Some(units::pressure),
        "humidity" => Some(units::share),
        _ => None,
    };
    let values = read.and_then(|read| Some((read(a).ok()?, read(b).ok()?)));
    match values {
        Some((a, b)) => (a - b).abs() <= 1e-9 * a.abs().max(b.abs()),
        None => a == b,
    }
}

/// All that stands against a session, so that it can be mended at once.
#[derive(Default)]
struct Problems {
    general: BTreeSet<String>,
    unknown_balls: BTreeSet<String>,
    /// What is wrong, and with which recordings.
    recordings: BTreeMap<String, Vec<String>>,
}

impl Problems {
    fn of_recording(&mut self, name: &str, text: String) {
        self.recordings
            .entry(text)
            .or_default()
            .push(name.to_owned());
    }

    /// Fields that some recordings have and others lack.
    fn missing(&mut self, session: &Session) {
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
                 [recordings.\"{first}\"] or [all] in session.toml, by a column {field} of a CSV \
                 (--table), or by {{{field}}} in the pattern of the names (--pattern); or go on \
                 without by --allow-missing"
            );
            self.recordings.insert(text, names);
        }
    }

    fn message(self) -> Option<String> {
        let mut lines: Vec<String> = self.general.into_iter().collect();
        for ball in &self.unknown_balls {
            let kinds: Vec<&str> = ball::presets().iter().map(|preset| preset.name).collect();
            let meant = near(ball, kinds.iter().copied());
            let meant = meant.map_or_else(String::new, |kind| format!(" Did you mean {kind}?"));
            lines.push(format!(
                "what ball is \"{ball}\"?{meant} Write [balls.{ball}] with kind = \"...\" (or mass and \
                 diameter) in session.toml, or give the kind of all balls by --ball. Kinds: {}, \
                 steel:10mm, glass:16mm",
                kinds.join(", ")
            ));
        }
        lines.extend(
            self.recordings
                .into_iter()
                .map(|(text, names)| format!("{}: {text}", some_of(&names))),
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

/// The first few of many names.
pub(super) fn some_of(names: &[String]) -> String {
    const SHOWN: usize = 4;
    match names.len() {
        count if count > SHOWN + 1 => {
            format!("{} and {} more", names[..SHOWN].join(", "), count - SHOWN)
        }
        _ => names.join(", "),
    }
}
