//! Arbitrary sound at arbitrary rates in arbitrary blocks.

#![no_main]

use bouncelab_testkit::fuzz::detect;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| detect(bytes));
