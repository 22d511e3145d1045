//! Arbitrary sound at arbitrary rates in arbitrary blocks.

#![no_main]

use bouncelab_fuzz::listener;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| listener::listen(bytes));
