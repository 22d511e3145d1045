//! What a laboratory states of a test besides its result (ISO/IEC 17025:2017, 7.8.2 and 7.8.3).

use bouncelab::rulebook::Precision;
use bouncelab::{Estimate, Plain};
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
    #[serde(skip_deserializing)]
    pub checks: Vec<MethodCheck>,
    /// The precision over operators, where several worked in one place.
    #[serde(skip_deserializing)]
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

impl TestNotes {
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
        let equipment = self.equipment.join("; ");
        let facts: [(&str, &str); 17] = [
            ("number", &self.number),
            ("laboratory", &self.laboratory),
            ("client", &self.client),
            ("item", &self.item),
            ("sample", &self.sample),
            ("from-client", &self.from_client),
            ("received", &self.received),
            ("tested", &self.tested),
            ("issued", issued.unwrap_or_default()),
            ("location", &self.location),
            ("operator", &self.operator),
            ("method", method),
            ("deviations", &self.deviations),
            ("external", &self.external),
            ("conditions", &self.conditions),
            ("reference", &self.reference),
            ("equipment", &equipment),
        ];
        let shown =
            |id: &str, value: &str| (capital(&label(id, translator)), given(value, translator));
        let is_shown = |(_, value): &&(&str, &str)| !self.one_page || !value.trim().is_empty();
        let facts = facts.iter().filter(is_shown);
        let mut facts: Vec<(String, String)> = facts.map(|(id, value)| shown(id, value)).collect();
        let checks = self.checks.iter().filter(|_| !self.one_page);
        facts.extend(checks.map(|check| shown("check", &check.text(translator))));
        Section::new(label("heading", translator), vec![Block::Facts(facts)])
    }

    /// What closes a report.
    pub(super) fn closing(&self, translator: &Translator) -> Section {
        let authorised = (
            capital(&label("authorised", translator)),
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
