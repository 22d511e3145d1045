//! `cargo xtask fuzz`: arbitrary bytes for everything that reads files, arbitrary sound for the detector.

use crate::Result;
use crate::cargo::{cargo, has, root, run as run_command};
use std::fs;
use std::process::Command;

pub(crate) const ABOUT: &str = "Fuzz what reads files, and the detector (nightly, cargo-fuzz)";

/// A target of `bouncelab_testkit::fuzz`.
struct Target {
    name: String,
    /// Whether faults of memory are sought too, because code that is not safe reads the bytes. Panics, hangs and memory are
    /// sought everywhere.
    is_unsafe: bool,
    /// Endings of the names of the recordings it begins with.
    endings: Vec<String>,
}

/// The targets, as the testkit prints them.
fn targets() -> Result<Vec<Target>> {
    let print = ["run", "--quiet", "--package", "bouncelab-testkit", "--bin"];
    let output = cargo(print).arg("fuzz-targets").output();
    let output = output.map_err(|reason| format!("the list of targets: {reason}"))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    let list = String::from_utf8_lossy(&output.stdout);
    let targets = list.lines().filter_map(|line| {
        let mut words = line.split(' ').map(str::to_owned);
        Some(Target {
            name: words.next()?,
            is_unsafe: words.next()? == "unsafe",
            endings: words.collect(),
        })
    });
    Ok(targets.collect())
}

const FIXTURES: &str = "crates/bouncelab-audio/tests/fixtures";

pub(crate) fn run(words: &[String]) -> Result {
    if !has("fuzz") {
        return Err("cargo-fuzz is not installed: cargo install cargo-fuzz".into());
    }
    let mut seconds = 60;
    let mut names = Vec::new();
    for word in words {
        match word.strip_prefix("seconds=") {
            Some(number) => seconds = number.parse().map_err(|_| format!("'{word}'"))?,
            None => names.push(word),
        }
    }
    let targets = targets()?;
    let is_target = |name: &String| targets.iter().any(|target| target.name == *name);
    if let Some(unknown) = names.iter().find(|name| !is_target(name)) {
        let all: Vec<&str> = targets.iter().map(|target| target.name.as_str()).collect();
        return Err(format!("'{unknown}' is none of: {}", all.join(", ")));
    }
    unpack_corpus()?;
    for target in &targets {
        if names.is_empty() || names.contains(&&target.name) {
            fuzz(target, seconds)?;
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
        name,
        is_unsafe,
        endings,
    } = target;
    let found = root().join("target/fuzz").join(name);
    let artifacts = root().join("fuzz/artifacts").join(name);
    for folder in [&found, &artifacts] {
        fs::create_dir_all(folder).map_err(|reason| format!("{}: {reason}", folder.display()))?;
    }
    let recordings = fs::read_dir(root().join(FIXTURES)).map_err(|e| format!("{FIXTURES}: {e}"))?;
    for recording in recordings.flatten().map(|entry| entry.path()) {
        let ending = recording.extension().and_then(|ending| ending.to_str());
        if let (Some(name), Some(ending)) = (recording.file_name(), ending)
            && endings.iter().any(|it| it == ending)
        {
            fs::copy(&recording, found.join(name)).map_err(|e| e.to_string())?;
        }
    }
    // The sanitiser takes memory of its own.
    let (sanitizer, max_mb) = if *is_unsafe {
        ("address", 2048)
    } else {
        ("none", 512)
    };
    let mut command = Command::new("cargo");
    command
        .current_dir(root())
        // The task runs under the stable compiler, whose name it would pass on.
        .env_remove("RUSTUP_TOOLCHAIN")
        .env("BOUNCELAB_FUZZ", name)
        .args(["+nightly", "fuzz", "run", "-s", sanitizer, "target"])
        .arg(found)
        .arg(format!("fuzz/corpus/{name}"))
        .args(["--", "-malloc_limit_mb=256", "-timeout=20"])
        .args([
            format!("-rss_limit_mb={max_mb}"),
            "-max_len=20000".to_owned(),
            format!("-artifact_prefix={}/", artifacts.display()),
            format!("-max_total_time={seconds}"),
        ]);
    run_command(&mut command)
}
