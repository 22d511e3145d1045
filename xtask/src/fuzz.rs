//! `cargo xtask fuzz`: arbitrary bytes for the decoders, arbitrary sound for the detector.

use crate::Result;
use crate::cargo::{has, root, run as run_command};
use std::fs;
use std::process::Command;

pub(crate) const ABOUT: &str = "Fuzz the decoders and the detector (nightly, cargo-fuzz)";

/// What reads bytes or sound.
struct Target {
    name: &'static str,
    /// The ends of the names of the recordings that it begins with.
    ends: &'static [&'static str],
    /// What watches it: panics, hangs and memory are sought everywhere, faults of memory where code that is
    /// not safe reads the bytes, which is Opus alone.
    sanitizer: &'static str,
}

impl Target {
    const fn safe(name: &'static str, ends: &'static [&'static str]) -> Self {
        let sanitizer = "none";
        Self {
            name,
            ends,
            sanitizer,
        }
    }

    const fn with_opus(name: &'static str, ends: &'static [&'static str]) -> Self {
        let sanitizer = "address";
        Self {
            name,
            ends,
            sanitizer,
        }
    }
}

const TARGETS: [Target; 11] = [
    Target::safe("wav", &["wav"]),
    Target::safe("aiff", &["aiff"]),
    Target::safe("caf", &["caf"]),
    Target::safe("flac", &["flac"]),
    Target::safe("mp3", &["mp3"]),
    Target::safe("aac", &["aac"]),
    Target::with_opus("ogg", &["ogg"]),
    Target::with_opus("mp4", &["m4a", "mp4", "mov"]),
    Target::with_opus("mkv", &["webm"]),
    Target::safe("times", &[]),
    Target::safe("detection", &[]),
];
const FIXTURES: &str = "crates/bouncelab-audio/tests/fixtures";

pub(crate) fn run(words: &[String]) -> Result {
    if !has("fuzz") {
        return Err("cargo-fuzz is not installed: cargo install cargo-fuzz".into());
    }
    let mut seconds = 60;
    let mut targets = Vec::new();
    for word in words {
        match word.strip_prefix("seconds=") {
            Some(number) => seconds = number.parse().map_err(|_| format!("'{word}'"))?,
            None => targets.push(word.as_str()),
        }
    }
    let known = |name: &&str| TARGETS.iter().any(|target| target.name == *name);
    if let Some(unknown) = targets.iter().find(|name| !known(name)) {
        let names = TARGETS.map(|target| target.name).join(", ");
        return Err(format!("'{unknown}' is none of: {names}"));
    }
    unpack_corpus()?;
    for target in TARGETS {
        if targets.is_empty() || targets.contains(&target.name) {
            fuzz(&target, seconds)?;
        }
    }
    Ok(())
}

/// The inputs worth keeping are one archive in the repository, which the tests read as it is; here
/// they are files in `fuzz/corpus`, where cargo-fuzz looks for them.
fn unpack_corpus() -> Result {
    let words = ["-xzf", "fuzz/corpus.tar.gz", "-C", "fuzz"];
    run_command(Command::new("tar").current_dir(root()).args(words))
}

/// What is new goes to `target/fuzz`; a finding, to `fuzz/artifacts`.
fn fuzz(target: &Target, seconds: u32) -> Result {
    let Target {
        name: target,
        ends,
        sanitizer,
    } = target;
    let found = root().join("target/fuzz").join(target);
    fs::create_dir_all(&found).map_err(|reason| format!("{}: {reason}", found.display()))?;
    let recordings = fs::read_dir(root().join(FIXTURES)).map_err(|e| format!("{FIXTURES}: {e}"))?;
    for recording in recordings.flatten().map(|entry| entry.path()) {
        let end = recording.extension().and_then(|end| end.to_str());
        if let (Some(name), true) = (
            recording.file_name(),
            end.is_some_and(|e| ends.contains(&e)),
        ) {
            fs::copy(&recording, found.join(name)).map_err(|e| e.to_string())?;
        }
    }
    // The sanitiser takes memory of its own.
    let most_mb = if *sanitizer == "none" { 512 } else { 2048 };
    let mut command = Command::new("cargo");
    command
        .current_dir(root())
        // The chore runs under the stable compiler, and says so to what it starts.
        .env_remove("RUSTUP_TOOLCHAIN")
        .args(["+nightly", "fuzz", "run", "-s", sanitizer, target])
        .arg(found)
        .arg(format!("fuzz/corpus/{target}"))
        .args(["--", "-malloc_limit_mb=256", "-timeout=20"])
        .args([
            format!("-rss_limit_mb={most_mb}"),
            "-max_len=20000".to_owned(),
            format!("-max_total_time={seconds}"),
        ]);
    run_command(&mut command)
}
