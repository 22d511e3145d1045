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

use bouncelab_audio::SoundFormat;
use flate2::read::GzDecoder;
use tar::Archive;

/// A target.
#[derive(Debug, Clone, Copy)]
pub struct Target {
    /// Its name, as in `cargo xtask fuzz NAME`.
    pub name: &'static str,
    /// The formats of sound that it reads: it begins with recordings of these.
    formats: &'static [SoundFormat],
    /// What it does with bytes; it panics where something does not hold.
    pub run: fn(&[u8]),
}

/// All targets.
pub const TARGETS: [Target; 21] = {
    use SoundFormat::{Aac, Aiff, Caf, Flac, M4a, Matroska, Mov, Mp3, Mp4, Ogg, Wav, WebM};
    [
        target("wav", &[Wav], decode::decode_all),
        target("aiff", &[Aiff], decode::decode_all),
        target("caf", &[Caf], decode::decode_all),
        target("flac", &[Flac], decode::flac),
        target("mp3", &[Mp3], decode::decode_all),
        target("aac", &[Aac], decode::decode_all),
        target("ogg", &[Ogg], decode::ogg),
        target("mp4", &[Mp4, M4a, Mov], decode::decode_all),
        target("mkv", &[WebM, Matroska], decode::decode_all),
        target("times", &[], decode::read_times),
        target("waveform", &[], decode::read_waveform),
        target("detection", &[], detect::detect),
        target("long", &[], detect::detect_long),
        target("session", &[], notes::read_session),
        target("notes", &[], notes::read_notes),
        target("archive", &[], notes::read_archive),
        target("rules", &[], notes::read_rules),
        target("link", &[], kept::read_link),
        target("record", &[], kept::read_record),
        target("rows", &[], kept::read_rows),
        target("journal", &[], kept::read_journal),
    ]
};

const fn target(name: &'static str, formats: &'static [SoundFormat], run: fn(&[u8])) -> Target {
    Target { name, formats, run }
}

impl Target {
    /// The target with a name.
    pub fn named(name: &str) -> Option<Self> {
        TARGETS.into_iter().find(|target| target.name == name)
    }

    /// Endings of the names of the recordings that it begins with.
    pub fn endings(&self) -> impl Iterator<Item = &'static str> {
        self.formats.iter().flat_map(|it| it.endings()).copied()
    }

    /// Whether code that is not safe reads the bytes, which is that of Opus alone: faults of memory are sought too.
    pub fn is_unsafe(&self) -> bool {
        self.formats.iter().any(|it| it.codecs().contains(&"Opus"))
    }
}

/// Panics inside a third-party decoder are caught and become errors; only those that get out are
/// findings. libFuzzer's hook would end the process at each.
pub fn let_decoders_panic() {
    std::panic::set_hook(Box::new(|_| ()));
}

/// The inputs that were worth keeping for a fuzz target.
///
/// # Panics
///
/// If the archive has no input for the target.
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
