//! The notes of a job: what a person states of it.

use std::path::PathBuf;

use bouncelab::settings::Settings;
use serde::{Deserialize, Serialize};

use super::SCHEMA;
use crate::report::verdict::TestNotes;

/// What a person states of a job.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Notes {
    schema: String,
    /// Name of the rule.
    pub rule: String,
    /// Files with rules of one's own, relative to the job.
    #[serde(default)]
    pub rules: Vec<PathBuf>,
    /// How many places are tested.
    pub places: usize,
    /// How many drops in each place, and on the reference.
    pub drops: usize,
    /// Parts of the procedure that were kept and that nothing else shows.
    #[serde(default)]
    pub kept: Vec<String>,
    /// A file with name, address and logo of the laboratory, relative to the job.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub laboratory: Option<PathBuf>,
    /// What the report states.
    #[serde(default)]
    pub test: TestNotes,
    /// Any setting, by the names of the JSON.
    #[serde(default)]
    pub settings: Settings,
}

impl Notes {
    /// Of a test by this rule, with so many drops in each of so many places, and nothing else stated.
    pub fn new(rule: String, places: usize, drops: usize) -> Self {
        Self {
            schema: SCHEMA.to_owned(),
            rule,
            rules: Vec::new(),
            places,
            drops,
            kept: Vec::new(),
            laboratory: None,
            test: TestNotes::default(),
            settings: Settings::default(),
        }
    }

    /// Reads the text of the notes.
    ///
    /// # Errors
    /// What is wrong with it, and where.
    pub fn read(text: &str) -> Result<Self, String> {
        let notes: Self = toml::from_str(text).map_err(|fault| fault.to_string())?;
        if notes.schema == SCHEMA {
            Ok(notes)
        } else {
            Err(format!("the schema must be \"{SCHEMA}\""))
        }
    }

    /// The text of the notes.
    ///
    /// # Errors
    /// None of what a text, a number or a list can hold.
    pub fn toml(&self) -> Result<String, String> {
        toml::to_string(self).map_err(|fault| fault.to_string())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn notes_come_back_as_they_were_written() {
        let mut notes = Notes::new("itf-court".to_owned(), 5, 3);
        notes.kept.push("surface".to_owned());
        notes.test.client = "A \"club\"\nin a town".to_owned();
        notes.test.equipment = vec!["tape 7".to_owned(), "scale".to_owned()];
        notes.settings.drop.height_m = Some(2.54);
        notes.settings.ball.kind = Some("tennis".to_owned());
        assert_eq!(Notes::read(&notes.toml().unwrap()), Ok(notes.clone()));
        let foreign = notes.toml().unwrap().replace(SCHEMA, "bouncelab.job/1");
        assert!(Notes::read(&foreign).unwrap_err().contains(SCHEMA));
    }
}
