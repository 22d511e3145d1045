//! What the fuzzer found worth keeping (`fuzz/corpus`) is decoded as the fuzzer does it, but with a
//! stable compiler. The allocator fails, and so ends the test, at a quarter of a gigabyte.

#[expect(unreachable_pub, reason = "the crate of the fuzz targets exports it")]
#[path = "../../../fuzz/src/decode.rs"]
mod decode;

use std::alloc::System;
use std::fs;
use std::path::PathBuf;

use cap::Cap;

#[global_allocator]
static ALLOCATOR: Cap<System> = Cap::new(System, 256 << 20);

fn corpus(target: &str) -> Vec<Vec<u8>> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus");
    let entries = fs::read_dir(folder.join(target)).unwrap();
    let corpus: Vec<_> = entries
        .map(|entry| fs::read(entry.unwrap().path()).unwrap())
        .collect();
    assert!(!corpus.is_empty(), "{target}");
    corpus
}

#[test]
fn no_recording_of_the_corpus_is_too_broken() {
    for target in ["wav", "aiff", "flac", "mp3", "aac", "ogg", "mp4", "mkv"] {
        for bytes in corpus(target) {
            decode::exhaust(&bytes);
        }
    }
}

#[test]
fn no_list_of_the_corpus_is_too_broken() {
    for bytes in corpus("times") {
        decode::read_times(&bytes);
    }
}
