//! What a laboratory states of a test besides its result (ISO/IEC 17025:2017, 7.8.2 and 7.8.3).

use bouncelab::rulebook::{self, Conditions, Decision, Precision, Rule};
use bouncelab::{Estimate, Plain, demo};
use serde::{Deserialize, Serialize};

use crate::messages::{Translator, capital};
use crate::quantity::{Quantity, Unit};
use crate::report::page::{Block, Section};

/// The notes of a test; what is empty is stated as not given, since a report must not hide it.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct TestNotes {
    /// What the report is called, as the place or the ball that is tested.
    pub name: String,
    /// Number of the report.
    pub number: String,
    /// Name and address of the laboratory.
    pub laboratory: String,
    /// Name and contact of the client.
    pub client: String,
    /// What was tested: ball or surface, with its condition.
    pub item: String,
    /// Brand, batch and number of the sample, and how it was sampled.
    pub sample: String,
    /// What the client stated of it, which the laboratory did not check.
    pub from_client: String,
    /// When the item was received.
    pub received: String,
    /// When it was tested.
    pub tested: String,
    /// Where it was tested.
    pub location: String,
    /// Who tested it.
    pub operator: String,
    /// Deviations from the method, additions and exclusions.
    pub deviations: String,
    /// Results of other laboratories, and whose they are.
    pub external: String,
    /// Temperature, humidity and whatever else matters, of each place.
    pub conditions: String,
    /// The reference, where the rule compares with one.
    pub reference: String,
    /// Equipment, each with its number and calibration.
    pub equipment: Vec<String>,
    /// Name and function of who authorises the report.
    pub authorised: String,
    /// The checks of the method, made by the program.
    #[serde(skip_deserializing, skip_serializing_if = "Vec::is_empty")]
    pub checks: Vec<MethodCheck>,
    /// The precision over operators, where several worked in one place.
    #[serde(skip_deserializing, skip_serializing_if = "Option::is_none")]
    pub of_operators: Option<Precision>,
    /// The logo of the laboratory, as the address of its data (`data:image/png;base64,...`).
    #[serde(skip)]
    pub logo: Option<String>,
    /// Whether the report is one page for the client: the result, its decision and what it is of.
    #[serde(skip)]
    pub one_page: bool,
}

/// Whether the method finds what is known, on a synthesised recording (validation of software).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MethodCheck {
    /// The day.
    pub made: String,
    /// The version of the program.
    pub version: String,
    /// The first rebound that was synthesised, m.
    pub truth_m: f64,
    /// The first rebound that was found, m; `None` if none was.
    pub found_m: Option<Estimate>,
}

impl MethodCheck {
    /// From the sound of a synthesised recording to the height of the first rebound, on this day.
    ///
    /// # Errors
    /// None with the numbers of the [demo].
    pub fn run(made: String) -> bouncelab::Result<Self> {
        let history = demo::history()?;
        let sound = demo::sound(&history, 1)?;
        let mut options = demo::settings().resolve()?.options;
        options.inference = None;
        let recording = bouncelab::analyze(&sound.samples, sound.sample_rate_hz, &options)?;
        let place = vec![recording.drops.iter().collect()];
        let rule = Rule::new("check", "check of the method", demo::DROP_HEIGHT_M);
        let nothing = Conditions::default();
        let verdict = rulebook::judge(&rule, &options, &nothing, &place, &[], Decision::default())?;
        let first = history.bounces().first();
        Ok(Self {
            made,
            version: env!("CARGO_PKG_VERSION").to_owned(),
            truth_m: first.map_or(0.0, |bounce| bounce.flight.apex_m),
            found_m: verdict.rebound.map(|mean| mean.height_m),
        })
    }

    /// Whether what was found is what is known, within the expanded uncertainty.
    pub fn agrees(&self) -> bool {
        self.found_m.is_some_and(|found| {
            let [low, high] = found.interval95;
            (low..=high).contains(&self.truth_m)
        })
    }

    /// The check in a sentence.
    pub fn text(&self, translator: &Translator) -> String {
        let found = self.found_m.map_or_else(
            || translator.text("unit-cannot-tell"),
            |found| Quantity::of(&found, Unit::Length).text(translator),
        );
        let truth = Quantity::rounded(self.truth_m, 4, Unit::Length).text(translator);
        let agrees = if self.agrees() { "yes" } else { "no" };
        let words = [
            ("made", self.made.as_str().into()),
            ("version", self.version.as_str().into()),
            ("truth", truth.into()),
            ("found", found.into()),
            ("agrees", agrees.into()),
        ];
        translator.text_with("test-checked", &words)
    }
}

/// The facts at the head of a report, in their order. Two are not stated: the day on which it is issued, and the method.
const FACTS: [&str; 17] = [
    "number",
    "laboratory",
    "client",
    "item",
    "sample",
    "from-client",
    "received",
    "tested",
    ISSUED,
    "location",
    "operator",
    METHOD,
    "deviations",
    "external",
    "conditions",
    "reference",
    EQUIPMENT,
];
const ISSUED: &str = "issued";
const METHOD: &str = "method";
const AUTHORISED: &str = "authorised";
/// A list of parts.
const EQUIPMENT: &str = "equipment";

/// A part of the notes, for a form.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct NoteField {
    /// Its name.
    pub name: &'static str,
    /// What it is called.
    pub label: String,
    /// What is stated; a list has a line for each part.
    pub value: String,
    /// Whether it is a list.
    pub is_list: bool,
}

impl TestNotes {
    /// What a person can state, in the order of the report.
    pub fn fields(&self, translator: &Translator) -> Vec<NoteField> {
        let stated = |id: &&str| ![ISSUED, METHOD].contains(id);
        let names = ["name"].into_iter().chain(FACTS).chain([AUTHORISED]);
        let field = |name: &'static str| NoteField {
            name,
            label: capital(&label(name, translator)),
            value: self.stated(name, "\n"),
            is_list: name == EQUIPMENT,
        };
        names.filter(stated).map(field).collect()
    }

    /// The part of this name as a text, of a list with this between its parts.
    fn stated(&self, name: &str, between: &str) -> String {
        match name {
            EQUIPMENT => self.equipment.join(between),
            _ => self.clone().part(name).cloned().unwrap_or_default(),
        }
    }

    /// The notes with this part stated as in a form; `None` if there is no such part.
    #[must_use]
    pub fn with(mut self, name: &str, value: &str) -> Option<Self> {
        let value = value.trim();
        if name == EQUIPMENT {
            let lines = value.lines().map(str::trim);
            let parts = lines.filter(|line| !line.is_empty());
            self.equipment = parts.map(str::to_owned).collect();
        } else {
            value.clone_into(self.part(name)?);
        }
        Some(self)
    }

    /// The part of this name, if it is a text.
    fn part(&mut self, name: &str) -> Option<&mut String> {
        Some(match name {
            "name" => &mut self.name,
            "number" => &mut self.number,
            "laboratory" => &mut self.laboratory,
            "client" => &mut self.client,
            "item" => &mut self.item,
            "sample" => &mut self.sample,
            "from-client" => &mut self.from_client,
            "received" => &mut self.received,
            "tested" => &mut self.tested,
            "location" => &mut self.location,
            "operator" => &mut self.operator,
            "deviations" => &mut self.deviations,
            "external" => &mut self.external,
            "conditions" => &mut self.conditions,
            "reference" => &mut self.reference,
            AUTHORISED => &mut self.authorised,
            _ => return None,
        })
    }

    /// What a title begins with, and what stands at the foot of each page.
    pub(super) fn title(&self, translator: &Translator) -> String {
        let number = plain(&self.number);
        let title = translator.text_with("test-title", &[("number", number.into())]);
        let parts = [title.trim().to_owned(), plain(&self.name)];
        joined(parts)
    }

    /// The facts at the head of a report.
    pub(super) fn section(
        &self,
        method: &str,
        issued: Option<&str>,
        translator: &Translator,
    ) -> Section {
        let facts = FACTS.map(|id| match id {
            ISSUED => (id, issued.unwrap_or_default().to_owned()),
            METHOD => (id, method.to_owned()),
            _ => (id, self.stated(id, "; ")),
        });
        let shown =
            |id: &str, value: &str| (capital(&label(id, translator)), given(value, translator));
        let is_shown = |(_, value): &&(&str, String)| !self.one_page || !value.trim().is_empty();
        let facts = facts.iter().filter(is_shown);
        let mut facts: Vec<(String, String)> = facts.map(|(id, value)| shown(id, value)).collect();
        let checks = self.checks.iter().filter(|_| !self.one_page);
        facts.extend(checks.map(|check| shown("check", &check.text(translator))));
        Section::new(label("heading", translator), vec![Block::Facts(facts)])
    }

    /// What closes a report.
    pub(super) fn closing(&self, translator: &Translator) -> Section {
        let authorised = (
            capital(&label(AUTHORISED, translator)),
            given(&self.authorised, translator),
        );
        let end = if self.number.is_empty() {
            String::new()
        } else {
            format!(" ({})", plain(&self.number))
        };
        Section::new(
            label("closing", translator),
            vec![
                Block::text(label("only-items", translator)),
                Block::Facts(vec![authorised]),
                Block::text(label("end", translator) + &end),
            ],
        )
    }
}

/// Parts of a title, without those that are empty.
pub(super) fn joined(parts: [String; 2]) -> String {
    let parts = parts.into_iter().filter(|part| !part.is_empty());
    parts.collect::<Vec<_>>().join(", ")
}

fn label(id: &str, translator: &Translator) -> String {
    translator.text(&format!("test-{id}"))
}

fn given(value: &str, translator: &Translator) -> String {
    if value.trim().is_empty() {
        label("not-given", translator)
    } else {
        plain(value)
    }
}

fn plain(value: &str) -> String {
    String::from(Plain::of(&value.replace('\n', ", ")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_form_states_is_what_it_shows() {
        let translator = Translator::english();
        let fields = TestNotes::default().fields(&translator);
        assert_eq!(fields.len(), FACTS.len());
        let mut notes = TestNotes::default();
        for field in &fields {
            let value = format!("{}\nsecond", field.name);
            notes = notes.with(field.name, &value).unwrap();
        }
        for field in notes.fields(&translator) {
            assert_eq!(field.value, format!("{}\nsecond", field.name));
        }
        assert_eq!(notes.equipment, ["equipment", "second"]);
        assert!(notes.with("colour", "red").is_none());
    }

    #[test]
    fn the_method_finds_what_was_synthesised() {
        let check = MethodCheck::run("2026-11-28".to_owned()).unwrap();
        assert!(check.agrees(), "{check:?}");
        let wrong = MethodCheck {
            truth_m: 1.1 * check.truth_m,
            ..check
        };
        assert!(!wrong.agrees());
    }
}
