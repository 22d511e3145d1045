//! Estimates the physics of a bouncing ball from its sound: the impact times, the coefficient of
//! restitution, the drop height and the air drag, each with its uncertainty.
//!
//! ```
//! use bouncelab::{Options, analyze, ball};
//!
//! # use bouncelab::demo;
//! # let recording = demo::sound(&demo::history()?, 1)?;
//! # let (samples, sample_rate_hz) = (recording.samples, recording.sample_rate_hz);
//! // Samples of one channel, from a file or a microphone.
//! let options = Options::new(ball::preset("table-tennis-38")?);
//! let result = analyze(&samples, sample_rate_hz, &options)?;
//! for drop in &result.drops {
//!     let posterior = drop.posterior.clone()?;
//!     println!("{} impacts, e = {:.4}", drop.impacts.len(), posterior.restitution.value);
//! }
//! # assert_eq!(result.drops.len(), 1);
//! # Ok::<(), bouncelab::Error>(())
//! ```
//!
//! | from | to | by |
//! |---|---|---|
//! | samples | a [`Recording`] with its drops | [`analyze`], [`analyze_channels`] |
//! | samples as they come | the same, and the result so far | [`Detector`], then [`analysis::Plan`] |
//! | impact times | the same | [`analyze_times`] |
//! | ball, air and surface | flights, heights and times | [`drop::simulate`](drop::simulate()) |
//! | impacts | samples | [`synth::render`] |
//!
//! It implements the experiment of M. Nagurka ("Aerodynamic Effects in a Dropped Ping-Pong Ball
//! Experiment", 2003): the times between the impacts give the apex of each flight, the restitution of each
//! impact, the drop height and the air drag. This crate computes in both directions, from the physics to the
//! sound and back.
//!
//! # Modules
//!
//! An **impact** is a contact with the surface, a **flight** the motion between two impacts, a **drop** the
//! motion from release to rest, a **train** the impacts of one drop as detected, an **onset** a candidate
//! for an impact. Data passes through the modules in this order, and a module uses only those above it:
//!
//! | module | what it computes |
//! |---|---|
//! | [`diagnostic`], [`Estimate`] | warnings and assumptions as data; a value with its uncertainty |
//! | [`ball`] | mass and diameter of the ball, presets with their source |
//! | [`air`], [`gravity`] | density and viscosity of the air, acceleration of gravity |
//! | [`drag`] | C<sub>D</sub> at a Reynolds number |
//! | [`flight`] | duration, apex and impact speed from the launch speed; and the inverse |
//! | [`impact`] | impacts, as measured and as sources of sound |
//! | [`restitution`] | restitution laws, contact time, and the restitution of each impact, corrected for drag |
//! | [`drop`](mod@drop) | motion from release to rest; height at any time; totals |
//! | [`synth`] | sound of a drop, with noise of known level |
//! | [`onset`] | samples to onset candidates |
//! | [`train`] | which candidates are the impacts of one drop |
//! | [`detection`] | a stream of samples to trains |
//! | [`regression`] | the paper's log-linear fit, Eqs. 4 to 8 |
//! | [`inference`] | the posterior of everything that the impacts determine |
//! | [`analysis`] | the pipeline: samples or times to a [`Recording`] |
//! | [`Plain`] | text of others, fit to be shown |
//! | [`groups`] | statistics of many drops |
//! | [`rulebook`] | conformity of a ball or a floor with a rule |
//! | [`settings`] | what is given, assumptions for the rest, values that look like wrong units |
//! | [`demo`] | a drop with known truth |
//!
//! # Features
//!
//! None is on by default.
//!
//! - `serde`: the result types as JSON, which is the schema `bouncelab.analysis/3`.
//! - `typescript`: the same types for TypeScript.
//!
//! # Conventions
//!
//! Quantities are in SI units, given in their names (`height_m`, `speed_m_s`). Bad input is an
//! [`Error`] that says what to do, never a panic. There are no files, clocks, threads or prints in
//! here: the same crate runs in a browser. Spin, sideways motion and uneven surfaces are out of
//! scope: the ball goes straight up and down.

#![warn(missing_docs)]

pub mod air;
pub mod analysis;
pub mod ball;
pub mod demo;
pub mod detection;
pub mod diagnostic;
pub mod drag;
pub mod drop;
mod error;
mod estimate;
pub mod flight;
pub mod gravity;
pub mod groups;
pub mod impact;
pub mod inference;
pub mod onset;
mod plain;
pub mod regression;
pub mod restitution;
pub mod rulebook;
pub mod settings;
mod simd;
mod stats;
pub mod synth;
pub mod train;
mod whiten;

/// The version of this library.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

pub use analysis::{Options, Recording, analyze, analyze_channels, analyze_times};
pub use detection::Detector;
pub use diagnostic::Diagnostic;
pub use error::{Bounds, Error, InferenceFailure, Quantity, Result};
pub use estimate::Estimate;
pub use impact::Impact;
pub use plain::Plain;

/// The examples of the README compile.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
