//! The physics of a bouncing ball, from the silence between its bounces.

pub mod air;
pub mod ball;
pub mod drag;
pub mod drop;
mod error;
pub mod flight;
pub mod gravity;
pub mod impact;
pub mod listen;
pub mod onset;
pub mod regression;
pub mod restitution;
pub mod synth;
pub mod train;
mod whiten;

pub use error::{Error, Result};
