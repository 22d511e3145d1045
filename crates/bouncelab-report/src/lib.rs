//! Figures, tables, documents and reports: how bouncelab shows what it found.
//!
//! Figures, tables and quantities take plain data with its unit in the name and give back text or
//! a picture; only [`illustration`], [`tables`], [`document`], [`paper`] and [`report`] know how the
//! numbers were found.
//!
//! ```
//! use bouncelab_report::figure::{self, Line, TimedFlight};
//! use bouncelab_report::{Quantity, Unit};
//!
//! let flights: Vec<_> = (1..=10)
//!     .map(|number| TimedFlight {
//!         number,
//!         time_s: 0.4605 * 0.94_f64.powi(number as i32),
//!         standard_error_s: None,
//!         used: true,
//!     })
//!     .collect();
//! let line = Line { slope: 0.94_f64.log10(), intercept: 0.4605_f64.log10() };
//! let figure = figure::flight_times(&flights, Some(line));
//! assert!(figure.svg().starts_with("<svg"));
//! println!("{}", figure.caption());
//!
//! let height = Quantity::measured(0.3042, 0.0061, Unit::Length);
//! assert_eq!(height.to_string(), "30.4 ± 0.6 cm");
//! ```
//!
//! The rooms, each using only those before it:
//!
//! | room | inference it answers |
//! |---|---|
//! | [`error`](Error) | what can go wrong |
//! | [`language`] | how the English here becomes another language |
//! | [`units`] | which quantity somebody wrote down |
//! | `digits` | how signs and exponents are written |
//! | [`quantity`](Quantity) | how many digits, and which prefix |
//! | [`table`](Table) | how numbers stand under each other |
//! | [`theme`] | what a colour means |
//! | `picture` | how a drawing becomes pixels |
//! | `shape` | which parts of a curve are drawn |
//! | `canvas` | where ink goes: the only room besides that knows the drawing library |
//! | `scale` | where a value lies on an axis, and which values get a tick |
//! | `sheet` | title, key, panels with axes |
//! | [`figure`] | one file a figure |
//! | [`save()`] | figures as files |
//! | [`rules`] | which rules there are, built in and in files |
//! | [`illustration`] | which figures an analysis has |
//! | [`tables`] | which tables an analysis has |
//! | [`document`] | an analysis as data for other programs |
//! | [`paper`] | what the paper says, and what its numbers are |
//! | [`report`] | an analysis as a page to read, print and repeat |
//!
//! All but [`save()`] work in a browser. The feature `png` (on by default) adds
//! [`Figure::png`](figure::Figure::png) and [`save()`].

mod canvas;
mod digits;
pub mod document;
mod error;
pub mod figure;
pub mod illustration;
pub mod language;
pub mod paper;
#[cfg(feature = "png")]
mod picture;
mod quantity;
pub mod report;
pub mod rules;
#[cfg(all(feature = "png", not(target_family = "wasm")))]
mod save;
mod scale;
mod shape;
mod sheet;
mod table;
pub mod tables;
pub mod theme;
pub mod units;

pub use error::{Error, Result};
pub use figure::Figure;
pub use quantity::{CANNOT_TELL, Quantity, Unit};
#[cfg(all(feature = "png", not(target_family = "wasm")))]
pub use save::{Saved, save};
pub use table::{Align, Table};
