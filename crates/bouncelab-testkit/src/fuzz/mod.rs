//! What is fuzzed, and the inputs that were worth keeping.
//!
//! `cargo xtask fuzz` mutates inputs for as long as it is told; the test `fuzz` of this crate tries those that were
//! kept, and some mutations of them, with the stable compiler.

mod decode;
mod detect;
mod kept;
mod mend;
mod notes;

use std::io::Read;
use std::path::Path;

use flate2::read::GzDecoder;
use tar::Archive;

/// The name of a target, and what it does with bytes; it panics where something does not hold.
pub type Target = (&'static str, fn(&[u8]));

/// All targets.
pub const TARGETS: [Target; 21] = [
    ("wav", decode::decode_all),
    ("aiff", decode::decode_all),
    ("caf", decode::decode_all),
    ("flac", decode::flac),
    ("mp3", decode::decode_all),
    ("aac", decode::decode_all),
    ("ogg", decode::ogg),
    ("mp4", decode::decode_all),
    ("mkv", decode::decode_all),
    ("times", decode::read_times),
    ("waveform", decode::read_waveform),
    ("detection", detect::detect),
    ("long", detect::detect_long),
    ("session", notes::read_session),
    ("notes", notes::read_notes),
    ("archive", notes::read_archive),
    ("rules", notes::read_rules),
    ("link", kept::read_link),
    ("record", kept::read_record),
    ("rows", kept::read_rows),
    ("journal", kept::read_journal),
];

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
