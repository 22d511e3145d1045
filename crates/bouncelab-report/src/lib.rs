//! Figures, tables, documents and reports of the results of bouncelab.
//!
//! A figure is a [`Chart`]: data that describes what is shown. One renderer draws any chart as SVG, PNG
//! or PDF, and the page draws the same description so that it can be zoomed.
//!
//! ```
//! use bouncelab_report::figure::{self, Line, TimedFlight};
//! use bouncelab_report::messages::Translator;
//! use bouncelab_report::{Quantity, Unit};
//!
//! let flights: Vec<_> = (1..=10)
//!     .map(|number| TimedFlight {
//!         number,
//!         time_s: 0.4605 * 0.94_f64.powi(number as i32),
//!         used: true,
//!     })
//!     .collect();
//! let line = Line { slope: 0.94_f64.log10(), intercept: 0.4605_f64.log10() };
//! let chart = figure::flight_times(&flights, Some(line), &Translator::english());
//! assert!(chart.svg().starts_with("<svg"));
//! println!("{}", chart.caption);
//!
//! let height = Quantity::measured(0.3042, 0.0061, Unit::Length);
//! assert_eq!(height.to_string(), "30.4 ± 0.6 cm");
//! ```
//!
//! The modules, each using only those before it:
//!
//! | module | what it does |
//! |---|---|
//! | [`error`](Error) | errors |
//! | [`messages`] | messages by id and language |
//! | [`csv`] | lines of CSV |
//! | [`hash`](mod@hash) | SHA-256 hashes |
//! | [`journal`] | lines of a journal of results |
//! | [`data_table`] | columns and rows as data |
//! | [`units`] | reads quantities with units |
//! | `digits` | signs and exponents |
//! | [`quantity`](Quantity) | digits and prefixes |
//! | [`table`](Table) | plain-text tables |
//! | [`theme`] | meanings of colours |
//! | `scale` | scales and ticks |
//! | [`chart`] | charts as data |
//! | `render` | draws charts |
//! | [`figure`] | the figures, one file each |
//! | [`file`](mod@file) | which files may be written; completely or not at all |
//! | [`save()`] | charts as files |
//! | [`rules`] | rules, built in and in files |
//! | [`tables`] | tables of an analysis |
//! | [`quantities`] | the catalogue of reported quantities |
//! | [`document`] | an analysis as data for other programs |
//! | [`columns`] | the tables of drops, impacts and flights as data |
//! | [`link`] | a drop as the end of a link |
//! | [`paper`] | the paper, recomputed |
//! | [`report`] | an analysis as a page to read, print and repeat |
//! | [`job`] | a test by a rule, drop after drop |
//! | [`groups`] | the study of many drops |
//! | [`sheets`] | lesson sheets |
//!
//! All but [`file`](mod@file) and [`save()`] work in a browser. The feature `pictures` (on by default)
//! adds [`Chart::png`], [`Chart::pdf`] and [`save()`].

#![warn(missing_docs)]

pub mod chart;
pub mod columns;
pub mod csv;
pub mod data_table;
mod digits;
pub mod document;
mod error;
pub mod figure;
#[cfg(not(target_family = "wasm"))]
pub mod file;
pub mod groups;
pub mod hash;
pub mod job;
pub mod journal;
pub mod link;
pub mod mark;
pub mod messages;
pub mod paper;
pub mod quantities;
mod quantity;
mod render;
pub mod report;
pub mod rules;
#[cfg(all(feature = "pictures", not(target_family = "wasm")))]
mod save;
mod scale;
pub mod sheets;
mod table;
pub mod tables;
pub mod theme;
pub mod units;

pub use chart::Chart;
pub use error::{Error, Result, advice};
pub use quantity::{CANNOT_TELL, Quantity, Unit};
pub use render::{MAX_WIDTH_PX, MIN_WIDTH_PX};
#[cfg(all(feature = "pictures", not(target_family = "wasm")))]
pub use save::{Saved, save};
pub use table::{Align, Table};
