//! What fuzzing found worth keeping, and mutations of it. The allocator fails, and so ends the test, at a quarter of
//! a gigabyte.

use std::alloc::System;

use bouncelab_testkit::damage::Damage;
use bouncelab_testkit::fuzz::{TARGETS, corpus};
use cap::Cap;

#[global_allocator]
static ALLOCATOR: Cap<System> = Cap::new(System, 256 << 20);

/// So many mutations of each input are tried.
const MUTATIONS: usize = 8;

#[test]
fn every_input_of_the_corpus_is_read_or_refused() {
    for (name, run) in TARGETS {
        for input in corpus(name) {
            run(&input);
        }
    }
}

#[test]
fn every_mutation_of_the_corpus_is_read_or_refused() {
    for (name, run) in TARGETS {
        for (number, input) in corpus(name).iter().enumerate() {
            for mutation in 0..MUTATIONS {
                // Another place in each input, and another damage in each mutation.
                let percent = (37 * number + 23 * mutation) % 100;
                let damage = Damage::ALL[(number + mutation) % Damage::ALL.len()];
                run(&damage.at(percent, input));
            }
        }
    }
}
