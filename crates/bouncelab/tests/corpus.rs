//! What the fuzzer found worth keeping (`fuzz/corpus/listener`), with a stable compiler.

#[expect(unreachable_pub, reason = "the crate of the fuzz targets exports it")]
#[path = "../../../fuzz/src/listener.rs"]
mod listener;

use std::fs;
use std::path::PathBuf;

#[test]
fn no_sound_of_the_corpus_is_too_odd() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus/listener");
    let entries = fs::read_dir(folder).unwrap();
    let sounds = entries.map(|entry| fs::read(entry.unwrap().path()).unwrap());
    assert!(sounds.inspect(|bytes| listener::listen(bytes)).count() > 0);
}
