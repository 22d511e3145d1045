//! `cargo xtask test`: every check that a change must pass.

use std::process::Command;
use std::time::{Duration, Instant};

use crate::Result;
use crate::cargo::{cargo, has, run as run_command};

pub(crate) const ABOUT: &str = "Run every check, or only the named ones";

/// One check: a name, and the words after `cargo`.
pub(crate) struct Check {
    pub(crate) name: &'static str,
    pub(crate) words: &'static [&'static str],
}

/// All checks, in the order in which they run. They share one target folder and one profile:
/// clippy and the documentation use the same metadata of the dependencies, tests and doc tests
/// the same code, so that a dependency is compiled at most twice.
pub(crate) const CHECKS: [Check; 5] = [
    Check {
        name: "format",
        words: &["fmt", "--all", "--check"],
    },
    Check {
        name: "clippy",
        words: &[
            "clippy",
            "--workspace",
            "--all-targets",
            "--",
            "-D",
            "warnings",
        ],
    },
    Check {
        name: "tests",
        words: &NEXTEST,
    },
    Check {
        name: "doctests",
        words: &["test", "--workspace", "--doc"],
    },
    Check {
        name: "docs",
        words: &["doc", "--workspace", "--no-deps"],
    },
];

const NEXTEST: [&str; 3] = ["nextest", "run", "--workspace"];

/// The same tests where nextest is not installed. Benchmarks are left to `cargo xtask bench`.
const LIBTEST: [&str; 6] = [
    "test",
    "--workspace",
    "--lib",
    "--bins",
    "--tests",
    "--examples",
];

/// Runs the named checks, or all. A failure does not keep the later ones from running.
pub(crate) fn run(names: &[String]) -> Result {
    let checks = chosen(names)?;
    ensure_components()?;
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
        let outcome = run_command(&mut command(words));
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

/// The words after `cargo`, allowing for a machine without nextest.
fn words(check: &Check) -> &'static [&'static str] {
    if check.words == NEXTEST && !has("nextest") {
        println!("\ncargo-nextest is not installed: `cargo test` runs the same tests");
        return &LIBTEST;
    }
    check.words
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
        println!("   {name:<9} {word:<7} {:>6.1} s", time.as_secs_f64());
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
