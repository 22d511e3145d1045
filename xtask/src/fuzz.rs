//! `cargo xtask fuzz`: arbitrary bytes for everything that reads files, arbitrary sound for the detector.

use crate::Result;
use crate::cargo::{has, root, run as run_command};
use std::fs;
use std::process::Command;

pub(crate) const ABOUT: &str = "Fuzz what reads files, and the detector (nightly, cargo-fuzz)";

/// Code that is not safe reads the bytes, which is that of Opus alone: faults of memory are sought too.
const ADDRESS: &str = "address";
/// Panics, hangs and memory are sought, as everywhere.
const NONE: &str = "none";

/// The targets, the ends of the names of the recordings they begin with, and the sanitiser.
const TARGETS: [(&str, &[&str], &str); 21] = [
    ("wav", &["wav"], NONE),
    ("aiff", &["aiff"], NONE),
    ("caf", &["caf"], NONE),
    ("flac", &["flac"], NONE),
    ("mp3", &["mp3"], NONE),
    ("aac", &["aac"], NONE),
    ("ogg", &["ogg"], ADDRESS),
    ("mp4", &["m4a", "mp4", "mov"], ADDRESS),
    ("mkv", &["webm"], ADDRESS),
    ("times", &[], NONE),
    ("waveform", &[], NONE),
    ("detection", &[], NONE),
    ("long", &[], NONE),
    ("session", &[], NONE),
    ("notes", &[], NONE),
    ("archive", &[], NONE),
    ("rules", &[], NONE),
    ("link", &[], NONE),
    ("record", &[], NONE),
    ("rows", &[], NONE),
    ("journal", &[], NONE),
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
    let known = |name: &&str| TARGETS.iter().any(|target| target.0 == *name);
    if let Some(unknown) = targets.iter().find(|name| !known(name)) {
        let names = TARGETS.map(|target| target.0).join(", ");
        return Err(format!("'{unknown}' is none of: {names}"));
    }
    unpack_corpus()?;
    for (target, ends, sanitizer) in TARGETS {
        if targets.is_empty() || targets.contains(&target) {
            fuzz(target, ends, sanitizer, seconds)?;
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
fn fuzz(target: &str, ends: &[&str], sanitizer: &str, seconds: u32) -> Result {
    let found = root().join("target/fuzz").join(target);
    let artifacts = root().join("fuzz/artifacts").join(target);
    for folder in [&found, &artifacts] {
        fs::create_dir_all(folder).map_err(|reason| format!("{}: {reason}", folder.display()))?;
    }
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
    let most_mb = if sanitizer == NONE { 512 } else { 2048 };
    let mut command = Command::new("cargo");
    command
        .current_dir(root())
        // The chore runs under the stable compiler, and says so to what it starts.
        .env_remove("RUSTUP_TOOLCHAIN")
        .env("BOUNCELAB_FUZZ", target)
        .args(["+nightly", "fuzz", "run", "-s", sanitizer, "target"])
        .arg(found)
        .arg(format!("fuzz/corpus/{target}"))
        .args(["--", "-malloc_limit_mb=256", "-timeout=20"])
        .args([
            format!("-rss_limit_mb={most_mb}"),
            "-max_len=20000".to_owned(),
            format!("-artifact_prefix={}/", artifacts.display()),
            format!("-max_total_time={seconds}"),
        ]);
    run_command(&mut command)
}
