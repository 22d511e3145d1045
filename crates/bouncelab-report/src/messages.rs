//! Stand-in until the messages are files: English texts by their names.

use std::collections::HashMap;

const ENGLISH: &str = include_str!("../messages/en/figures.ftl");

/// An argument of a message.
#[derive(Debug, Clone)]
#[allow(missing_docs)]
pub enum Value {
    Text(String),
    Number(f64),
}

impl From<&str> for Value {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}
impl From<String> for Value {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}
impl From<crate::Quantity> for Value {
    fn from(quantity: crate::Quantity) -> Self {
        Self::Text(quantity.to_string())
    }
}
impl From<usize> for Value {
    fn from(number: usize) -> Self {
        Self::Number(number as f64)
    }
}

/// Says messages in a language.
#[derive(Debug, Clone)]
pub struct Translator(HashMap<&'static str, &'static str>);

impl Default for Translator {
    fn default() -> Self {
        let lines = ENGLISH.lines().filter_map(|line| line.split_once(" = "));
        Self(lines.collect())
    }
}

impl Translator {
    pub fn text(&self, id: &str) -> String {
        self.text_with(id, &[])
    }

    pub fn text_with(&self, id: &str, arguments: &[(&str, Value)]) -> String {
        let mut text = self
            .0
            .get(id)
            .map_or_else(|| panic!("no message {id}"), |text| (*text).to_owned());
        for (name, value) in arguments {
            let value = match value {
                Value::Text(text) => text.clone(),
                Value::Number(number) => number.to_string(),
            };
            text = text.replace(&format!("{{ ${name} }}"), &value);
        }
        text
    }

    pub fn number(&self, written: &str) -> String {
        written.to_owned()
    }
}
