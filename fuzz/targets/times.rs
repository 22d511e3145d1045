//! Lists of impact times, as text, CSV and JSON.

#![no_main]

use bouncelab_fuzz::decode;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| decode::read_times(bytes));
