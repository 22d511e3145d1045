//! The underlying paper, recomputed: its numbers, its figures, its discrepancy.
//!
//! M. Nagurka, "Aerodynamic Effects in a Dropped Ping-Pong Ball Experiment".
//!
//! ```
//! use bouncelab_report::paper;
//!
//! let chapters = paper::chapters()?;
//! let weight = &chapters[0].facts[0];
//! assert_eq!((weight.code().as_str(), weight.printed), ("weight", Some("2.45")));
//! assert_eq!(weight.verdict(), paper::Verdict::Agrees);
//! # Ok::<(), bouncelab::Error>(())
//! ```

mod experiment;
mod facts;
mod figures;
pub mod lesson;
mod puzzle;

pub use facts::{Chapter, Fact, Verdict, chapters};
pub use figures::figures;
pub use puzzle::{Explanation, explanations};

use serde::Serialize;

use crate::messages::Translator;

/// Name and version of the schema of [`Document`].
pub const SCHEMA: &str = "bouncelab.paper/2";

/// The paper as data for other programs.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(rename = "PaperDocument"))]
pub struct Document {
    schema: &'static str,
    /// Version of the program that made it.
    bouncelab: &'static str,
    facts: Vec<Row>,
    /// What would make the log-linear fit give its result in the paper.
    puzzle: Vec<Explanation>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(rename = "PaperFact"))]
struct Row {
    /// What it is about, as a text.
    chapter: String,
    /// What it is, as a code that no other number has.
    code: String,
    /// What it is, as a text.
    quantity: String,
    /// As the paper prints it, to its digits; `null` if it does not state it.
    printed: Option<&'static str>,
    computed: f64,
    unit: &'static str,
    /// The result of the comparison, as a code; `null` if the paper does not state it.
    verdict: Option<&'static str>,
    /// What to know about it.
    note: Option<String>,
}

impl Document {
    /// The document of these facts and explanations.
    pub fn new(chapters: &[Chapter], puzzle: Vec<Explanation>, translator: &Translator) -> Self {
        let rows = chapters.iter().flat_map(|chapter| {
            chapter.facts.iter().map(|fact| Row {
                chapter: chapter.title(translator),
                code: fact.code(),
                quantity: fact.quantity(translator),
                printed: fact.printed,
                computed: fact.computed,
                unit: fact.unit,
                verdict: fact.verdict().code(),
                note: fact.note(translator),
            })
        });
        Self {
            schema: SCHEMA,
            bouncelab: env!("CARGO_PKG_VERSION"),
            facts: rows.collect(),
            puzzle,
        }
    }
}
