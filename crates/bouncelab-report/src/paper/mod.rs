//! The paper that started it, computed again: its numbers, its figures, its puzzle.
//!
//! M. Nagurka, "Aerodynamic Effects in a Dropped Ping-Pong Ball Experiment".
//!
//! ```
//! use bouncelab_report::paper;
//!
//! let chapters = paper::chapters()?;
//! let weight = &chapters[0].facts[0];
//! assert_eq!((weight.quantity, weight.printed), ("weight", Some("2.45")));
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

/// Name and version of the schema of [`Document`].
pub const SCHEMA: &str = "bouncelab.paper/1";

/// The paper as data for other programs.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(rename = "PaperDocument"))]
pub struct Document {
    schema: &'static str,
    /// Version of the program that made it.
    bouncelab: &'static str,
    facts: Vec<Row>,
    /// What would make the straight line say what it says in the paper.
    puzzle: Vec<Explanation>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(rename = "PaperFact"))]
struct Row {
    chapter: &'static str,
    quantity: &'static str,
    /// As the paper prints it, to its digits; `null` if it does not say.
    printed: Option<&'static str>,
    computed: f64,
    unit: &'static str,
    verdict: String,
    note: &'static str,
}

impl Document {
    /// The document of these facts and explanations.
    pub fn new(chapters: &[Chapter], puzzle: Vec<Explanation>) -> Self {
        let rows = chapters.iter().flat_map(|chapter| {
            chapter.facts.iter().map(|fact| Row {
                chapter: chapter.title,
                quantity: fact.quantity,
                printed: fact.printed,
                computed: fact.computed,
                unit: fact.unit,
                verdict: fact.verdict().to_string(),
                note: fact.note,
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
