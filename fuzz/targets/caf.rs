//! Bytes that begin as CAF files.

#![no_main]

use bouncelab_testkit::fuzz::{decode_all, let_decoders_panic};
use libfuzzer_sys::fuzz_target;

fuzz_target!(init: let_decoders_panic(), |bytes: &[u8]| decode_all(bytes));
