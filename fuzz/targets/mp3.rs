//! Bytes that begin as MP3 files.

#![no_main]

use bouncelab_fuzz::{decode, let_decoders_panic};
use libfuzzer_sys::fuzz_target;

fuzz_target!(init: let_decoders_panic(), |bytes: &[u8]| decode::exhaust(bytes));
