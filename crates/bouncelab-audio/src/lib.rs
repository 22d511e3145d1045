//! Reads files and microphones as samples.
//!
//! [`SoundReader`] reads a recording of nearly any format as a stream of blocks of `f32` samples, in
//! memory that does not grow with its length; [`times`] reads impact times that something else
//! measured; [`Input`] takes either. [`encode_wav`] encodes a synthesised recording,
//! [`copy_with_cues`] a copy of a recording with its impacts marked, a [`Recorder`]
//! one that is still going on. With the feature `microphone`, `microphone::Microphone` listens.
//!
//! [`SoundFormat`] lists the formats and the codecs that are decoded in each, such as AAC in M4A and Opus in `WebM`.
//! Not decoded are HE-AAC, surround Opus, ADPCM, AC-3 and WMA; the error states the codec and how to convert the file.
//!
//! What a program needs to know of a damaged recording is in [`SoundReader::warnings`]; what makes it
//! useless is an [`Error`]. No content of a file, however broken, makes this crate panic.
//!
//! Opus is decoded by opus-pure, whose samples are those of libopus; ffmpeg's own Opus decoder
//! differs from both in speech modes.
//!
//! Only the microphone starts a thread; without that feature the crate builds for wasm32, where
//! [`SoundReader::from_bytes`] and [`Input::from_bytes`] take the place of files.

#![warn(missing_docs)]

mod contain;
mod cues;
mod error;
mod formats;
mod input;
mod lost_chunk;
#[cfg(feature = "microphone")]
pub mod microphone;
mod problem;
mod recorder;
mod source;
pub mod times;
mod warning;
mod wav;
mod waveform;

/// The version of this library.
pub const VERSION: &str = env!("CARGO_PKG_VERSION");

pub use contain::{contain, silence_contained_panics};
pub use cues::{Cue, copy_with_cues};
pub use error::{Error, Result};
pub use formats::SoundFormat;
pub use input::Input;
pub use problem::{LayoutProblem, LooksLike, MissingContent, Stage, TimesProblem};
pub use recorder::{Recorder, Store};
pub use source::{
    Block, MAX_BLOCK_FRAMES, MAX_SAMPLE_RATE_HZ, MIN_SAMPLE_RATE_HZ, SoundReader, check_layout,
    position_after,
};
pub use warning::Warning;
pub use wav::{SampleFormat, encode_wav, note_gaps};
pub use waveform::Samples;
