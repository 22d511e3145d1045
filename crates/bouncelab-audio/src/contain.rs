//! Catches panics of third-party code that reads files.
//!
//! Some of it panics at damaged files (by an assertion in a codebook, an overflow in a timestamp) where it should
//! return an error. One bad recording in a folder of good ones must not end a program, so such a
//! panic is caught here and becomes an ordinary error. Where panics abort, as on wasm, none is caught.

use std::cell::Cell;
use std::panic::{self, AssertUnwindSafe, catch_unwind};

use symphonia::core::errors::{Error, Result};

thread_local! {
    /// Whether this thread runs contained code.
    static CONTAINED: Cell<bool> = const { Cell::new(false) };
}

/// Runs third-party code; `None` if it panicked.
///
/// After a panic nothing that the closure has touched may be used: its state is undefined. A memory fault of
/// unsafe code is not caught; of the decoders only `opus-pure` has such code.
///
/// ```
/// assert_eq!(bouncelab_audio::contain(|| "0x10".len()), Some(4));
/// assert_eq!(bouncelab_audio::contain(|| -> usize { panic!("damaged") }), None);
/// ```
pub fn contain<T>(work: impl FnOnce() -> T) -> Option<T> {
    let outer = CONTAINED.replace(true);
    let result = catch_unwind(AssertUnwindSafe(work)).ok();
    CONTAINED.set(outer);
    result
}

/// Stops the printing of panics that [`contain`] catches; an error reports those. Other panics are printed as before.
///
/// Meant for the start of a program, since the printing of panics concerns the whole process.
pub fn silence_contained_panics() {
    let print = panic::take_hook();
    panic::set_hook(Box::new(move |panic| {
        if !CONTAINED.get() {
            print(panic);
        }
    }));
}

/// As [`contain`], for decoders: a panic becomes an error for which [`is_panic`] holds. Callers end the stream then.
pub(crate) fn contain_decoder<T>(work: impl FnOnce() -> Result<T>) -> Result<T> {
    contain(work).unwrap_or(Err(Error::LimitError(PANICKED)))
}

/// The message of a contained panic.
const PANICKED: &str = "the decoder gave up on damaged data";

/// Whether this error stands for a contained panic.
pub(crate) fn is_panic(error: &Error) -> bool {
    matches!(error, Error::LimitError(PANICKED))
}
