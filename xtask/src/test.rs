//! `cargo xtask test`: every check that a change must pass.

use std::process::Command;
use std::time::{Duration, Instant};

use crate::Result;
use crate::cargo::{cargo, has, is_root, run as run_command, succeeds};
use crate::tables;
use crate::web;

pub(crate) const ABOUT: &str = "Run every check, or only the named ones";

/// One check: a name, and the words after `cargo`.
pub(crate) struct Check {
    pub(crate) name: &'static str,
    pub(crate) words: &'static [&'static str],
    /// What it takes besides Rust.
    needs: Needs,
}

/// What the machine must have for a check; without it the check is skipped, and that is said.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Needs {
    /// Nothing but Rust.
    Nothing,
    /// The headers of the sound system, for the microphone.
    Sound,
    /// Python with the programs that open the tables of a session.
    Python,
    /// Node.js, for the page.
    Node,
    /// Node.js and a browser, for the end-to-end tests of the page.
    Browser,
}

impl Needs {
    /// Whether it is there, now that what can be installed was installed.
    fn are_met(self) -> bool {
        match self {
            Self::Nothing => true,
            Self::Sound => has_sound_headers(),
            Self::Python => tables::have_readers(),
            Self::Node => web::has_node(),
            Self::Browser => web::has_node() && web::has_chromium(),
        }
    }
}

/// All checks, in the order in which they run. They share one target folder and one profile:
/// clippy and the documentation use the same metadata of the dependencies, tests and doc tests
/// the same code, so that a dependency is compiled at most twice.
pub(crate) const CHECKS: [Check; 11] = [
    Check {
        name: "format",
        words: &["fmt", "--all", "--check"],
        needs: Needs::Nothing,
    },
    Check {
        name: "clippy",
        words: &[
            "clippy",
            "--workspace",
            "--features",
            "bouncelab-cli/serve",
            "--all-targets",
            "--",
            "-D",
            "warnings",
        ],
        needs: Needs::Nothing,
    },
    Check {
        name: "tests",
        words: &NEXTEST,
        needs: Needs::Nothing,
    },
    Check {
        name: "doctests",
        words: &["test", "--workspace", "--doc"],
        needs: Needs::Nothing,
    },
    Check {
        name: "docs",
        words: &["doc", "--workspace", "--no-deps"],
        needs: Needs::Nothing,
    },
    Check {
        name: "tables",
        words: &["test", "--package", "bouncelab-cli", "--test", "tables"],
        needs: Needs::Python,
    },
    Check {
        name: "live",
        words: &[
            "clippy",
            "--package",
            "bouncelab-audio",
            "--package",
            "bouncelab-cli",
            "--features",
            "bouncelab-cli/microphone",
            "--all-targets",
            "--",
            "-D",
            "warnings",
        ],
        needs: Needs::Sound,
    },
    Check {
        name: "microphone",
        words: &NEXTEST_LIVE,
        needs: Needs::Sound,
    },
    Check {
        name: "page",
        words: &["xtask", "web", "check"],
        needs: Needs::Node,
    },
    Check {
        name: "web",
        words: &["xtask", "web"],
        needs: Needs::Node,
    },
    Check {
        name: "e2e",
        words: &["xtask", "web", "e2e"],
        needs: Needs::Browser,
    },
];

const NEXTEST: [&str; 5] = [
    "nextest",
    "run",
    "--workspace",
    "--features",
    "bouncelab-cli/serve",
];

/// The same tests where nextest is not installed. Benchmarks are left to `cargo xtask bench`.
const LIBTEST: [&str; 8] = [
    "test",
    "--workspace",
    "--features",
    "bouncelab-cli/serve",
    "--lib",
    "--bins",
    "--tests",
    "--examples",
];

/// The tests that need a microphone, or rather a sound system: those in rooms of that name.
const NEXTEST_LIVE: [&str; 9] = [
    "nextest",
    "run",
    "--package",
    "bouncelab-audio",
    "--package",
    "bouncelab-cli",
    "--features",
    "bouncelab-cli/microphone",
    "microphone::",
];

const LIBTEST_LIVE: [&str; 8] = [
    "test",
    "--package",
    "bouncelab-audio",
    "--package",
    "bouncelab-cli",
    "--features",
    "bouncelab-cli/microphone",
    "microphone::",
];

/// Runs the named checks, or all. A failure does not keep the later ones from running.
pub(crate) fn run(names: &[String]) -> Result {
    let mut checks = chosen(names)?;
    ensure_components()?;
    for needs in [Needs::Python, Needs::Sound, Needs::Node, Needs::Browser] {
        if checks.iter().any(|check| check.needs == needs) && !needs.are_met() {
            let (skipped, rest) = checks
                .into_iter()
                .partition::<Vec<_>, _>(|c| c.needs == needs);
            let names: Vec<_> = skipped.iter().map(|check| check.name).collect();
            println!("SKIPPED for want of it: {}", names.join(", "));
            checks = rest;
        }
    }
    let start = Instant::now();
    let mut outcomes = Vec::new();
    for (index, check) in checks.iter().enumerate() {
        let words = words(check);
        println!(
            "\n== {}/{} {}: cargo {}",
            index + 1,
            checks.len(),
            check.name,
            words.join(" ")
        );
        let begun = Instant::now();
        let mut command = command(words);
        if check.needs == Needs::Python {
            command.env("BOUNCELAB_PYTHON", tables::python());
        }
        let outcome = run_command(&mut command);
        outcomes.push((check.name, outcome, begun.elapsed()));
    }
    conclude(&outcomes, start.elapsed())
}

fn chosen(names: &[String]) -> Result<Vec<&'static Check>> {
    if names.is_empty() {
        return Ok(CHECKS.iter().collect());
    }
    let known = CHECKS.map(|check| check.name).join(", ");
    names
        .iter()
        .map(|name| {
            CHECKS
                .iter()
                .find(|check| check.name == name)
                .ok_or_else(|| format!("there is no check '{name}'; there are {known}"))
        })
        .collect()
}

/// `cargo fmt` and `cargo clippy` are components that a minimal toolchain lacks.
fn ensure_components() -> Result {
    for (subcommand, component) in [("fmt", "rustfmt"), ("clippy", "clippy")] {
        if has(subcommand) {
            continue;
        }
        println!("{component} is missing, adding it: rustup component add {component}");
        run_command(Command::new("rustup").args(["component", "add", component])).map_err(
            |reason| {
                format!(
                    "{reason}; install {component} by hand, with rustup or with the packages of \
                     your system"
                )
            },
        )?;
    }
    Ok(())
}

/// Whether the microphone can be built in: Linux needs the headers of ALSA. They are installed
/// where that is allowed; else it is said how to, and those checks are left out.
fn has_sound_headers() -> bool {
    const INSTALL: [&str; 5] = [
        "apt-get",
        "install",
        "--yes",
        "libasound2-dev",
        "pkg-config",
    ];
    if !cfg!(target_os = "linux") || succeeds(&["pkg-config", "--exists", "alsa"]) {
        return true;
    }
    let words = INSTALL.join(" ");
    println!("the headers of ALSA are missing, for the microphone: {words}");
    let installed = is_root()
        && succeeds(&["apt-get", "update"])
        && succeeds(&INSTALL)
        && succeeds(&["pkg-config", "--exists", "alsa"]);
    if !installed {
        println!(
            "they could not be installed. Install them by hand (Debian, Ubuntu: sudo {words}; \
             Fedora: alsa-lib-devel, pkgconf)"
        );
    }
    installed
}

/// The words after `cargo`, allowing for a machine without nextest.
fn words(check: &Check) -> &'static [&'static str] {
    let without_nextest: &[&str] = match check.words {
        words if words == NEXTEST => &LIBTEST,
        words if words == NEXTEST_LIVE => &LIBTEST_LIVE,
        words => return words,
    };
    if has("nextest") {
        return check.words;
    }
    println!("\ncargo-nextest is not installed: `cargo test` runs the same tests");
    without_nextest
}

fn command(words: &[&str]) -> Command {
    let mut command = cargo(words.iter().copied());
    // Only rustdoc reads this: it compiles nothing again.
    command.env("RUSTDOCFLAGS", "-D warnings");
    command
}

/// Prints what became of each check; an error if any failed.
fn conclude(outcomes: &[(&str, Result, Duration)], total: Duration) -> Result {
    println!("\n== summary");
    for (name, outcome, time) in outcomes {
        let word = if outcome.is_ok() { "ok" } else { "FAILED" };
        println!("   {name:<10} {word:<7} {:>6.1} s", time.as_secs_f64());
    }
    let failed: Vec<_> = outcomes
        .iter()
        .filter(|(_, outcome, _)| outcome.is_err())
        .map(|(name, ..)| *name)
        .collect();
    if failed.is_empty() {
        println!("All checks passed in {:.1} s.", total.as_secs_f64());
        return Ok(());
    }
    Err(format!(
        "{} of {} checks failed: {}",
        failed.len(),
        outcomes.len(),
        failed.join(", ")
    ))
}
