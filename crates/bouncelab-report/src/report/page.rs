//! A page without a format: headings, sentences, tables, figures and equations in order.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::equation::Equation;
use crate::chart::Chart;
use crate::messages::{Translator, capital};
use crate::table::Table;

/// A document to read: its content, not its layout.
///
/// [`Page::html`] and [`Page::markdown`] give it a form. Texts are plain: whatever they contain is
/// shown as it is, markup too.
#[derive(Debug, Serialize, Deserialize)]
pub struct Page {
    /// The heading of the whole page.
    pub title: String,
    /// One line below it: what made the page, and of what.
    pub subtitle: String,
    /// The beginning: the answer in sentences.
    pub lead: Vec<Block>,
    /// What most readers want to see.
    pub sections: Vec<Section>,
    /// What some readers want to see: folded, and then not on paper.
    pub details: Vec<Section>,
    /// Whether the details are unfolded from the start, so that paper has them too.
    pub unfolded: bool,
    /// What stands at the foot of each printed page, beside its number.
    pub foot: String,
    /// Whether it is to fit on one printed page.
    pub compact: bool,
    /// A picture above the heading, as the address of its data (`data:image/png;base64,...`).
    pub logo: Option<String>,
    /// The language of all this.
    pub language: Language,
}

/// A language, and the words that the form of a page adds.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Language {
    /// Its code, as in "en" or "de-AT".
    pub code: String,
    /// The word before a warning.
    pub note: String,
    /// The word before the number of a figure.
    pub figure: String,
    /// The heading of the details.
    pub details: String,
    /// What stands before, between and behind the number of a printed page and the number of all.
    pub page: [String; 3],
}

impl Language {
    /// That of the translator.
    pub fn new(translator: &Translator) -> Self {
        Self {
            code: translator.language().to_owned(),
            note: translator.text("report-note"),
            figure: translator.text("report-figure"),
            details: translator.text("report-details"),
            page: page_number(translator),
        }
    }
}

/// The words around the numbers in "page 1 of 2".
fn page_number(translator: &Translator) -> [String; 3] {
    const NUMBER: &str = "#";
    let words = [("page", NUMBER.into()), ("pages", NUMBER.into())];
    let text = translator.text_with("report-page", &words);
    let mut parts = text.splitn(3, NUMBER).map(str::to_owned);
    std::array::from_fn(|_| parts.next().unwrap_or_default())
}

/// A heading and what belongs to it.
#[derive(Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub struct Section {
    /// The heading.
    pub heading: String,
    /// Its content.
    pub blocks: Vec<Block>,
    /// Sections within it.
    pub parts: Vec<Section>,
}

impl Section {
    /// A section without parts.
    pub fn new(heading: impl Into<String>, blocks: Vec<Block>) -> Self {
        Self {
            heading: heading.into(),
            blocks,
            parts: Vec::new(),
        }
    }

    /// Whether it has nothing but its heading.
    pub fn is_empty(&self) -> bool {
        self.blocks.is_empty() && self.parts.is_empty()
    }
}

/// A piece of a section.
#[derive(Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[non_exhaustive]
pub enum Block {
    /// The sentence that everybody reads, in large letters.
    Lead(String),
    /// A paragraph.
    Text(String),
    /// Something to be careful with.
    Note(String),
    /// A list of sentences.
    List(Vec<String>),
    /// Names and values.
    Facts(Vec<(String, String)>),
    /// A table, with what it shows.
    Table {
        /// What it shows, in a few words.
        caption: String,
        /// The table.
        table: Table,
    },
    /// A figure, with its name in links and files.
    Figure {
        /// Lower-case letters, digits and hyphens; made unique where the same name comes again.
        name: String,
        /// The chart, with its caption below it.
        chart: Box<Chart>,
    },
    /// A formula on a line of its own.
    Equation(Equation),
    /// Something to type, or to compare letter by letter.
    Code(String),
}

impl Block {
    /// A paragraph.
    pub fn text(words: impl Into<String>) -> Self {
        Self::Text(words.into())
    }

    /// A table with its caption.
    pub fn table(caption: impl Into<String>, table: Table) -> Self {
        Self::Table {
            caption: caption.into(),
            table,
        }
    }

    /// A figure with its name.
    pub fn figure(name: impl Into<String>, chart: Chart) -> Self {
        Self::Figure {
            name: name.into(),
            chart: Box::new(chart),
        }
    }
}

/// A remark as a sentence: with a capital letter and a full stop.
pub(super) fn sentence(remark: &str) -> String {
    ended(capital(remark))
}

/// With a full stop, unless it has an end already: it may be a question.
pub fn ended(words: impl fmt::Display) -> String {
    let words = words.to_string();
    let end = if words.ends_with(['.', '?', '!']) {
        ""
    } else {
        "."
    };
    words + end
}

#[cfg(test)]
mod tests {
    use super::ended;

    #[test]
    fn questions_need_no_full_stop() {
        assert_eq!(ended("it is so"), "it is so.");
        assert_eq!(ended("is it so?"), "is it so?");
    }
}
