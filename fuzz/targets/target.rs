//! The target that the environment names: `BOUNCELAB_FUZZ=ogg`.

#![no_main]

use std::env;
use std::sync::LazyLock;

use bouncelab_testkit::fuzz::{Target, let_decoders_panic};
use libfuzzer_sys::fuzz_target;

static TARGET: LazyLock<Target> = LazyLock::new(|| {
    let name = env::var("BOUNCELAB_FUZZ").expect("BOUNCELAB_FUZZ names the target");
    Target::named(&name).expect("BOUNCELAB_FUZZ is the name of a target")
});

fuzz_target!(init: let_decoders_panic(), |bytes: &[u8]| (TARGET.run)(bytes));
