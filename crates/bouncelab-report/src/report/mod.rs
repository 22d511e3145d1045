//! An analysis as a page: to read, to print, and to repeat.
//!
//! A [`Page`] says what there is to say (headings, words, tables, figures, formulas); it becomes one
//! HTML file that needs nothing else, or Markdown for a notebook. [`of_recording`] makes the page of
//! a recording and [`verdict::of_verdict`] that of a verdict; the sections they are made of stand here one
//! by one, for pages of other things.
//!
//! ```
//! use bouncelab::analyze_times;
//! use bouncelab::setup::SetupInput;
//! use bouncelab_report::messages::Translator;
//! use bouncelab_report::report::{self, Provenance, Recording};
//!
//! let setup = SetupInput::default().resolve()?;
//! let result = analyze_times(&[0.0, 0.4605, 0.8877, 1.2854, 1.6568], &setup.options);
//! let recording = Recording { name: "drop.txt", setup: &setup, result: &result };
//! let page = report::of_recording(&recording, &Provenance::default(), &Translator::english());
//! assert!(page.html().starts_with("<!DOCTYPE html>"));
//! assert!(page.markdown("figures").text.starts_with("# drop.txt"));
//! # Ok::<(), bouncelab::Error>(())
//! ```

mod conditions;
mod drop;
mod equation;
mod html;
mod markdown;
mod method;
mod page;
mod recording;
mod subject;
pub mod verdict;

pub use conditions::{conditions, priors, shared_conditions};
pub use drop::{drop, drop_details, in_words};
pub use equation::Equation;
pub use markdown::Markdown;
pub use method::{method, method_in_short};
pub use page::{Block, Language, Page, Section, ended};
pub use recording::{made_by, of_recording, repeat};
pub use subject::{Provenance, Recording};
