//! An analysis as a page: to read, to print, and to repeat.
//!
//! A [`Page`] has the content (headings, sentences, tables, figures, formulas); it becomes one
//! HTML file that needs nothing else, or Markdown for a notebook. [`of_recording`] makes the page of
//! a recording and [`verdict::of_verdict`] that of a verdict; their sections are public too, for
//! pages of other things.
//!
//! ```
//! use bouncelab::analyze_times;
//! use bouncelab::settings::Settings;
//! use bouncelab_report::messages::Translator;
//! use bouncelab_report::report::{self, Provenance, ReportInput};
//!
//! let setup = Settings::default().without_inference().resolve()?;
//! let result = analyze_times(&[0.0, 0.4605, 0.8877, 1.2854, 1.6568], &setup.options);
//! let recording = ReportInput { name: "drop.txt", setup: &setup, result: &result };
//! let page = report::of_recording(&recording, &Provenance::default(), &Translator::english());
//! assert!(page.html().starts_with("<!DOCTYPE html>"));
//! assert!(page.markdown("figures").text.starts_with("# drop.txt"));
//! # Ok::<(), bouncelab::Error>(())
//! ```

mod conditions;
mod drop;
mod equation;
pub(crate) mod html;
mod input;
pub(crate) mod markdown;
mod method;
mod page;
mod recording;
pub mod verdict;

pub use conditions::{conditions, priors, shared_conditions};
pub use drop::{drop, drop_details, in_words};
pub use equation::Equation;
pub use input::{Provenance, ReportInput};
pub use markdown::Markdown;
pub use method::{method, method_in_short};
pub use page::{Block, Language, Page, Section, ended};
pub use recording::{MAX_DROPS_SHOWN, made_by, of_recording, repeat};
