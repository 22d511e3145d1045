//! Lists of impact times, as text, CSV and JSON.

#![no_main]

use bouncelab_testkit::fuzz::read_times;
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| read_times(bytes));
