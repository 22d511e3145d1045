//! The detector with what fuzzing found worth keeping.

use bouncelab_testkit::fuzz::{corpus, detect};

#[test]
fn every_sound_of_the_corpus_is_searched() {
    for bytes in corpus("detection") {
        detect(&bytes);
    }
}
