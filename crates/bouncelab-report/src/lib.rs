//! Figures, tables, documents and reports: how bouncelab shows what it found.
//!
//! A figure is a [`Chart`]: data that describes what is shown. One renderer draws any chart as SVG or
//! PNG, and the page draws the same description so that it can be zoomed.
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
//! | module | question it answers |
//! |---|---|
//! | [`error`](Error) | what can go wrong |
//! | [`messages`] | what people read, by id and language |
//! | [`units`] | which quantity somebody wrote down |
//! | `digits` | how signs and exponents are written |
//! | [`quantity`](Quantity) | how many digits, and which prefix |
//! | [`table`](Table) | how numbers stand under each other |
//! | [`theme`] | what a colour means |
//! | `scale` | where a value lies on an axis, and which values get a tick |
//! | [`chart`] | what a chart shows, as data |
//! | `render` | how a chart is drawn |
//! | [`figure`] | which chart shows what: one file a figure |
//! | [`file`](mod@file) | files that appear whole or not at all |
//! | [`save()`] | charts as files |
//! | [`rules`] | which rules there are, built in and in files |
//! | [`tables`] | which tables an analysis has |
//! | [`document`] | an analysis as data for other programs |
//! | [`paper`] | what the paper says, and what its numbers are |
//! | [`report`] | an analysis as a page to read, print and repeat |
//!
//! All but [`file`](mod@file) and [`save()`] work in a browser. The feature `png` (on by default) adds
//! [`Chart::png`] and [`save()`].

#![warn(missing_docs)]

pub mod chart;
mod digits;
pub mod document;
mod error;
pub mod figure;
#[cfg(not(target_family = "wasm"))]
pub mod file;
pub mod messages;
pub mod paper;
mod quantity;
mod render;
pub mod report;
pub mod rules;
#[cfg(all(feature = "png", not(target_family = "wasm")))]
mod save;
mod scale;
mod table;
pub mod tables;
pub mod theme;
pub mod units;

pub use chart::Chart;
pub use error::{Error, Result};
pub use quantity::{CANNOT_TELL, Quantity, Unit};
pub use render::{MAX_WIDTH_PX, MIN_WIDTH_PX};
#[cfg(all(feature = "png", not(target_family = "wasm")))]
pub use save::{Saved, save};
pub use table::{Align, Table};
