//! The target that the environment names: `BOUNCELAB_FUZZ=ogg`.

#![no_main]

use std::env;
use std::sync::LazyLock;

use bouncelab_testkit::fuzz::{TARGETS, Target, let_decoders_panic};
use libfuzzer_sys::fuzz_target;

static TARGET: LazyLock<Target> = LazyLock::new(|| {
    let name = env::var("BOUNCELAB_FUZZ").expect("BOUNCELAB_FUZZ names the target");
    let mut targets = TARGETS.into_iter();
    let target = targets.find(|target| target.0 == name);
    target.expect("BOUNCELAB_FUZZ is the name of a target")
});

fuzz_target!(init: let_decoders_panic(), |bytes: &[u8]| (TARGET.1)(bytes));
