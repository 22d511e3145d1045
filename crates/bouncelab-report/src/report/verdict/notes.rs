//! What a laboratory states of a test besides its result (ISO/IEC 17025:2017, 7.8.2 and 7.8.3).

use bouncelab::Plain;
use serde::Deserialize;

use crate::messages::{Translator, capital};
use crate::quantity::{Quantity, Unit};
use crate::report::page::{Block, Section};

/// The notes of a test; what is empty is stated as not given, since a report must not hide it.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct TestNotes {
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
    /// Temperature, humidity and whatever else matters, of each place.
    pub conditions: String,
    /// The reference, where the rule compares with one.
    pub reference: String,
    /// Equipment, each with its number and calibration.
    pub equipment: Vec<String>,
    /// Name and function of who authorises the report.
    pub authorised: String,
    /// The check of the method, made by the program.
    #[serde(skip)]
    pub check: Option<MethodCheck>,
}

/// Whether the method finds what is known, on a synthesised recording (validation of software).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MethodCheck {
    /// The first rebound that was synthesised, m.
    pub truth_m: f64,
    /// The first rebound that was found, m; `None` if none was.
    pub found_m: Option<f64>,
}

impl MethodCheck {
    fn text(&self, translator: &Translator) -> String {
        let length = |height_m: f64| Quantity::rounded(height_m, 4, Unit::Length).text(translator);
        let found = self
            .found_m
            .map_or_else(|| translator.text("unit-cannot-tell"), length);
        translator.text_with(
            "test-checked",
            &[
                ("truth", length(self.truth_m).into()),
                ("found", found.into()),
            ],
        )
    }
}

impl TestNotes {
    /// What a title begins with.
    pub(super) fn title(&self, translator: &Translator) -> String {
        let number = plain(&self.number);
        translator
            .text_with("test-title", &[("number", number.into())])
            .trim()
            .to_owned()
            + ", "
    }

    /// The facts at the head of a report.
    pub(super) fn section(
        &self,
        method: &str,
        issued: Option<&str>,
        translator: &Translator,
    ) -> Section {
        let equipment = self.equipment.join("; ");
        let facts: [(&str, &str); 15] = [
            ("number", &self.number),
            ("laboratory", &self.laboratory),
            ("client", &self.client),
            ("item", &self.item),
            ("sample", &self.sample),
            ("received", &self.received),
            ("tested", &self.tested),
            ("issued", issued.unwrap_or_default()),
            ("location", &self.location),
            ("operator", &self.operator),
            ("method", method),
            ("deviations", &self.deviations),
            ("conditions", &self.conditions),
            ("reference", &self.reference),
            ("equipment", &equipment),
        ];
        let shown =
            |id: &str, value: &str| (capital(&label(id, translator)), given(value, translator));
        let mut facts: Vec<(String, String)> =
            facts.iter().map(|(id, value)| shown(id, value)).collect();
        facts.extend(
            self.check
                .map(|check| shown("check", &check.text(translator))),
        );
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
