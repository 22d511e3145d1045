//! The decoders with what fuzzing found worth keeping. The allocator fails, and so ends the test, at
//! a quarter of a gigabyte.

use std::alloc::System;

use bouncelab_testkit::fuzz::{corpus, decode_all, read_times};
use cap::Cap;

#[global_allocator]
static ALLOCATOR: Cap<System> = Cap::new(System, 256 << 20);

#[test]
fn every_recording_of_the_corpus_is_decoded_or_refused() {
    for target in ["wav", "aiff", "flac", "mp3", "aac", "ogg", "mp4", "mkv"] {
        for bytes in corpus(target) {
            decode_all(&bytes);
        }
    }
}

#[test]
fn every_list_of_the_corpus_is_read_or_refused() {
    for bytes in corpus("times") {
        read_times(&bytes);
    }
}
