//! The physics of a bouncing ball, from the silence between its bounces.
//!
//! Drop a ball on a table and listen. The ball is heard only when it hits, yet the pauses between
//! the hits tell how high it rose, how much of its speed each impact kept, from what height it was
//! dropped and how much the air held it back (M. Nagurka, "Aerodynamic Effects in a Dropped
//! Ping-Pong Ball Experiment"). This crate computes both ways: from samples to the physics, and from
//! the physics to samples.
//!
//! # Samples to a result
//!
//! ```
//! use bouncelab::{Options, analyze, ball, demo};
//!
//! // A recording: samples with full scale 1, and their rate. Here one is made.
//! let recording = demo::sound(&demo::history()?, 1)?;
//!
//! let options = Options::new(ball::preset("table-tennis-38")?);
//! let result = analyze(&recording.samples, recording.sample_rate_hz, &options)?;
//! for drop in &result.drops {
//!     println!("{} impacts, probability {:.2}", drop.impacts.len(), drop.probability);
//!     if let Ok(posterior) = &drop.posterior {
//!         let (e, h) = (posterior.restitution, posterior.drop_height_m);
//!         println!("e = {:.4} ± {:.4}, dropped from {:.3} ± {:.3} m", e.value, e.sd, h.value, h.sd);
//!     }
//!     for known in &drop.diagnostics {
//!         println!("{}", known.code);
//!     }
//! }
//! assert_eq!(result.drops.len(), 1);
//! # Ok::<(), bouncelab::Error>(())
//! ```
//!
//! [`analyze_times`] does the same for a list of impact times. A stream goes block by block through a
//! [`Detector`], and its result is made by a [`Plan`](analysis::Plan), whose drops are analysed by
//! whoever has the threads:
//!
//! ```
//! use bouncelab::analysis::{DropTask, Plan};
//! use bouncelab::{Detector, Options, demo};
//!
//! let recording = demo::sound(&demo::history()?, 1)?;
//! let mut detector = Detector::new(recording.sample_rate_hz, 1);
//! for block in recording.samples.chunks(4096) {
//!     detector.push(&[block]);
//! }
//! let plan = Plan::of_detection(detector.finish(), &Options::default().without_inference());
//! let drops = plan.tasks().iter().map(DropTask::run).collect(); // or in parallel
//! let result = plan.finish(drops);
//! assert_eq!(result.drops[0].impacts.len(), 61);
//! # Ok::<(), bouncelab::Error>(())
//! ```
//!
//! # Physics to samples
//!
//! ```
//! use bouncelab::drop::{self, Start, Stop};
//! use bouncelab::impact::{Contact, Restitution};
//! use bouncelab::synth::{self, Scene};
//! use bouncelab::{Options, ball};
//!
//! let preset = ball::preset("table-tennis-40")?;
//! let model = Options::new(preset).model()?;
//! let contact = Contact::new(Restitution::constant(0.93)?, preset.contact_time_s)?;
//! let history = drop::simulate(&model, &contact, Start::Height(0.305), Stop::below(0.001))?;
//! assert_eq!(history.bounces().len(), 36);
//!
//! let strikes: Vec<_> = history.strikes().collect();
//! let sound = synth::render(&strikes, &Scene::default(), 7)?;
//! assert!(sound.samples.len() > sound.sample_rate_hz as usize);
//! # Ok::<(), bouncelab::Error>(())
//! ```
//!
//! # The modules
//!
//! An **impact** is a contact with the surface, a **flight** the time between two, a **drop** the
//! whole history, a **train** the impacts of one drop as detected, an **onset** a candidate for an
//! impact. Data passes through the modules in this order, and a module uses only those above it:
//!
//! | module | question it answers |
//! |---|---|
//! | [`diagnostic`], [`Estimate`] | what there is to know about a result; a number with its uncertainty |
//! | [`ball`] | what falls: mass, diameter, presets with their source |
//! | [`air`], [`gravity`] | what it falls through and how hard it is pulled |
//! | [`drag`] | C<sub>D</sub> at a Reynolds number |
//! | [`flight`] | launch speed to time, apex and impact speed; and back |
//! | [`impact`] | what a bounce keeps |
//! | [`drop`](mod@drop) | release to rest; height at any time; totals |
//! | [`synth`] | a history as sound, with noise of known strength |
//! | [`onset`] | samples to onset candidates |
//! | [`train`] | which candidates are the impacts of one drop |
//! | [`detection`] | a stream of samples to trains |
//! | [`regression`] | the paper's log-linear fit, Eqs. 4 to 8 |
//! | [`restitution`] | the restitution of each impact, corrected for drag |
//! | [`inference`] | the posterior of everything that the impacts determine |
//! | [`analysis`] | the pipeline: samples or times to a [`Recording`] |
//! | [`plausibility`] | which stated values look like mistakes of units |
//! | [`groups`] | what many drops say together |
//! | [`rulebook`] | whether a ball or a floor obeys a rule |
//! | [`setup`] | what a person states, and what is assumed |
//! | [`demo`] | a drop whose truth is known |
//!
//! # Features
//!
//! - `serde`: [`Recording`] and all types in it serialise as the JSON schema `bouncelab.analysis/2`.
//! - `typescript`: the same types for TypeScript, for the page.
//!
//! # Conventions
//!
//! Quantities are in SI units and say so in their names (`height_m`, `speed_m_s`). Bad input is an
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
pub mod plausibility;
pub mod regression;
pub mod restitution;
pub mod rulebook;
pub mod setup;
mod simd;
mod stats;
pub mod synth;
pub mod train;
mod whiten;

pub use analysis::{Options, Recording, analyze, analyze_channels, analyze_times};
pub use detection::Detector;
pub use diagnostic::Diagnostic;
pub use error::{Error, InferenceFailure, Result};
pub use estimate::Estimate;
pub use impact::Impact;
