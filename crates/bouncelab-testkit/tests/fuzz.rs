//! What fuzzing found worth keeping, and mutations of it. The allocator fails, and so ends the test, at a quarter of
//! a gigabyte.

use std::alloc::System;

use bouncelab_testkit::damage::Damage;
use bouncelab_testkit::fuzz::{TARGETS, Target, corpus};
use cap::Cap;

#[global_allocator]
static ALLOCATOR: Cap<System> = Cap::new(System, 256 << 20);

/// Number of mutations of each input.
const MUTATIONS: usize = 8;

#[test]
fn every_input_of_the_corpus_is_read_or_refused() {
    for target in TARGETS {
        for input in corpus(target.name) {
            (target.run)(&input);
        }
    }
}

/// As many notes as fit into the longest files that are read.
#[test]
fn the_longest_notes_fit() {
    let run = |target: &str, text: &str| {
        (Target::named(target).unwrap().run)(text.as_bytes());
    };
    let keys = (0..250_000).map(|key| format!("{key:x}=1"));
    let keys: Vec<String> = keys.collect();
    run("session", &format!("[all]\n{}\n", keys.join("\n")));
    let columns: Vec<String> = (0..999).map(|column| column.to_string()).collect();
    let row = format!("red_30cm_1.wav{}\n", ",a".repeat(999));
    run(
        "notes",
        &format!("recording,{}\n{}", columns.join(","), row.repeat(8_000)),
    );
}

#[test]
fn every_mutation_of_the_corpus_is_read_or_refused() {
    for target in TARGETS {
        for (number, input) in corpus(target.name).iter().enumerate() {
            for mutation in 0..MUTATIONS {
                // Another place in each input, and another damage in each mutation.
                let percent = (37 * number + 23 * mutation) % 100;
                let damage = Damage::ALL[(number + mutation) % Damage::ALL.len()];
                (target.run)(&damage.at(percent, input));
            }
        }
    }
}
