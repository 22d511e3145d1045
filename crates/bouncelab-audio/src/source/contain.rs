//! A wall around the third-party demuxers and decoders.
//!
//! Damaged files make some of them panic (an assertion in a codebook, an overflow in a timestamp)
//! where they should return an error. A measurement program must not die of one bad recording
//! in a folder of good ones, so such a panic is caught here and becomes an ordinary decoding
//! error. Where panics abort, as on wasm, nothing is caught.

use std::panic::{AssertUnwindSafe, catch_unwind};

use symphonia::core::errors::{Error, Result};

/// Runs third-party code; a panic becomes [`PANICKED`].
///
/// Nothing touched by the closure may be used again after a panic: its state is undefined.
/// Callers end the stream. A fault of memory in unsafe code is not caught; of the decoders only `opus-pure`
/// has such code.
pub(super) fn contain<T>(work: impl FnOnce() -> Result<T>) -> Result<T> {
    catch_unwind(AssertUnwindSafe(work)).unwrap_or(Err(Error::LimitError(PANICKED)))
}

/// The message of a contained panic.
const PANICKED: &str = "the decoder gave up on damaged data";

/// Whether this error stands for a contained panic.
pub(super) fn is_panic(error: &Error) -> bool {
    matches!(error, Error::LimitError(PANICKED))
}
