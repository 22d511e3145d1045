//! The fuzz targets, and their corpus.
//!
//! The tests of the workspace do the same with the corpus, so that a stable compiler checks it too.

mod decode;
mod detect;

pub use decode::{decode_all, read_times};
pub use detect::detect;

use std::io::Read;
use std::path::Path;

use flate2::read::GzDecoder;
use tar::Archive;

/// Panics inside a third-party decoder are caught and become errors; only those that get out are
/// findings. libFuzzer's hook would end the process at each.
pub fn let_decoders_panic() {
    std::panic::set_hook(Box::new(|_| ()));
}

/// The inputs that were worth keeping for a fuzz target.
///
/// # Panics
///
/// If there are none.
pub fn corpus(target: &str) -> Vec<Vec<u8>> {
    const ARCHIVE: &[u8] = include_bytes!("../../../../fuzz/corpus.tar.gz");
    let folder = Path::new("corpus").join(target);
    let mut archive = Archive::new(GzDecoder::new(ARCHIVE));
    let mut inputs = Vec::new();
    for entry in archive.entries().expect("a readable archive") {
        let mut entry = entry.expect("a readable entry");
        let path = entry.path().expect("a path in UTF-8");
        if entry.header().entry_type().is_file() && path.starts_with(&folder) {
            let mut bytes = Vec::new();
            entry.read_to_end(&mut bytes).expect("a whole entry");
            inputs.push(bytes);
        }
    }
    assert!(!inputs.is_empty(), "no corpus for {target}");
    inputs
}
