//! The physics of a bouncing ball, from the silence between its bounces.
//!
//! Drop a ball on a table and listen. The ball is heard only when it hits, yet the pauses between
//! the hits tell how high it rose, how much of its speed each impact kept, from what height it was
//! dropped and how much the air held it back (M. Nagurka, "Aerodynamic Effects in a Dropped
//! Ping-Pong Ball Experiment"). This crate computes both ways: forward from the physics to the
//! sound, and back from the sound to the physics.
//!
//! # Forward: a drop
//!
//! ```
//! use bouncelab::air::{Air, Conditions};
//! use bouncelab::drag::DragLaw;
//! use bouncelab::drop::{self, Start, Stop};
//! use bouncelab::flight::{Environment, FlightModel};
//! use bouncelab::impact::{Contact, Restitution};
//! use bouncelab::{ball, gravity};
//!
//! let preset = ball::preset("table-tennis-40")?;
//! let surroundings = Environment {
//!     gravity_m_s2: gravity::STANDARD_M_S2,
//!     air: Air::moist(&Conditions::default())?,
//!     drag: DragLaw::CliftGraceWeber,
//!     buoyancy: true,
//!     added_mass: true,
//! };
//! let model = FlightModel::new(&preset.ball, &surroundings)?;
//! let contact = Contact::new(Restitution::constant(0.93)?, preset.contact_time_s)?;
//! let history = drop::simulate(&model, &contact, Start::Height(0.305), Stop::below(0.001))?;
//!
//! for bounce in history.bounces() {
//!     let silence_s = bounce.flight.time_s();
//!     println!("{:.4} s: rises {:.3} m, silent for {silence_s:.4} s", bounce.time_s, bounce.flight.apex_m);
//! }
//! assert_eq!(history.bounces().len(), 36);
//! # Ok::<(), bouncelab::Error>(())
//! ```
//!
//! # The rooms
//!
//! An **impact** is a contact with the surface, a **flight** the time between two, a **drop** the
//! whole history, a **train** the impacts of one drop as heard, an **onset** a candidate for an
//! impact. Data passes through the modules in this order, and a module uses only those above it:
//!
//! | module | inference it answers |
//! |---|---|
//! | [`ball`] | what falls: mass, diameter, presets with their source |
//! | [`air`], [`gravity`] | what it falls through and how hard it is pulled |
//! | [`drag`] | C<sub>D</sub> at a Reynolds number |
//! | [`flight`] | launch speed to time, apex and impact speed; and back |
//! | [`impact`] | what a bounce keeps |
//! | [`drop`](mod@drop) | release to rest; height at any time; totals |
//! | [`synth`] | a history as sound, with noise of known strength |
//! | [`onset`] | samples to onset candidates |
//! | [`train`] | which candidates are the impacts of one drop |
//! | [`detection`] | samples in, trains out |
//! | [`regression`] | the paper's straight line, Eqs. 4 to 8 |
//! | [`restitution`] | the restitution of each impact, corrected for drag |
//! | [`inference`] | everything that the impacts say together |
//! | [`analysis`] | what the impacts of one drop say |
//! | [`groups`] | what many drops say together |
//! | [`rulebook`] | whether a ball or a floor obeys a rule |
//! | [`setup`] | what a person states, and what is assumed |
//! | [`demo`] | a drop whose truth is known |
//!
//! # Conventions
//!
//! Quantities are in SI units and say so in their names (`height_m`, `speed_m_s`). Bad input is an
//! [`Error`] that says what to do, never a panic. There are no files, clocks, threads or prints in
//! here: the same crate runs in a browser. Spin, sideways motion and uneven surfaces are out of
//! scope: the ball goes straight up and down.

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
