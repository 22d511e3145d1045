//! Files to samples for bouncelab.

mod error;
mod source;
mod warning;

pub use error::{Error, Result, Stage};
pub use source::{Block, MAX_BLOCK_FRAMES, MIN_SAMPLE_RATE_HZ, Source};
pub use warning::Warning;
