//! The project's own chores: `cargo xtask help` lists them.
//!
//! One module for each chore; a new one is a module and a line in [`CHORES`]. Only the standard
//! library is used, so that a fresh clone starts checking at once.

#![expect(
    clippy::print_stderr,
    clippy::print_stdout,
    reason = "it prints for contributors"
)]
#![expect(clippy::disallowed_methods, reason = "names of files of the project")]

mod bench;
mod book;
mod calibrate;
mod cargo;
mod cluster;
mod damage;
mod detection;
mod fresh;
mod fuzz;
mod laboratory;
mod measurements;
mod package;
mod python;
mod release;
mod steps;
mod test;
mod verdicts;
mod web;

use std::io;
use std::path::Path;
use std::process::ExitCode;

/// Why a chore did not succeed, ready to be printed.
type Result<T = ()> = std::result::Result<T, String>;

/// What the system says of a file.
fn said(path: &Path, reason: &io::Error) -> String {
    format!("{}: {reason}", path.display())
}

struct Chore {
    name: &'static str,
    arguments: &'static str,
    about: &'static str,
    run: fn(&[String]) -> Result,
}

const CHORES: [Chore; 13] = [
    Chore {
        name: "test",
        arguments: "[CHECK...]",
        about: test::ABOUT,
        run: test::run,
    },
    Chore {
        name: "bench",
        arguments: "[FILTER...]",
        about: bench::ABOUT,
        run: bench::run,
    },
    Chore {
        name: "calibrate",
        arguments: "[DROPS [FOLDER]] | worlds [DROPS] [impacts=N] [WORLD...] [LAW...]",
        about: calibrate::ABOUT,
        run: calibrate::run,
    },
    Chore {
        name: "laboratory",
        arguments: "FOLDER COUNT",
        about: laboratory::ABOUT,
        run: laboratory::run,
    },
    Chore {
        name: "wheel",
        arguments: "",
        about: python::ABOUT,
        run: python::run,
    },
    Chore {
        name: "release",
        arguments: "[documents | target=TRIPLE]",
        about: release::ABOUT,
        run: release::run,
    },
    Chore {
        name: "book",
        arguments: "",
        about: book::ABOUT,
        run: book::run,
    },
    Chore {
        name: "verdicts",
        arguments: "[BALLS [DROPS]]",
        about: verdicts::ABOUT,
        run: verdicts::run,
    },
    Chore {
        name: "detection",
        arguments: "[PART...] [drops=20] [hours=1] [only=SOUND] [wav=FOLDER]",
        about: detection::ABOUT,
        run: detection::run,
    },
    Chore {
        name: "damage",
        arguments: "[FORMAT] [quick]",
        about: damage::ABOUT,
        run: damage::run,
    },
    Chore {
        name: "net",
        arguments: "[drops=1000] [sounds=FOLDER]... [out=FILE] [compare=FILE] [store=FILE]",
        about: "Every number of simulated drops and of sounds, or how they differ from those of an earlier run",
        run: |arguments| cargo::run_measuring_program("net", arguments),
    },
    Chore {
        name: "fuzz",
        arguments: "[TARGET...] [seconds=60]",
        about: fuzz::ABOUT,
        run: fuzz::run,
    },
    Chore {
        name: "web",
        arguments: "[engine | check | e2e [FILE...] [--firefox] [--repeat N] [--load] [--pictures]]",
        about: web::ABOUT,
        run: web::run,
    },
];

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let name = arguments.next().unwrap_or_else(|| "help".into());
    if ["help", "--help", "-h"].contains(&name.as_str()) {
        print!("{}", help());
        return ExitCode::SUCCESS;
    }
    let Some(chore) = CHORES.iter().find(|chore| chore.name == name) else {
        eprint!("There is no chore '{name}'.\n\n{}", help());
        return ExitCode::from(2);
    };
    match (chore.run)(&arguments.collect::<Vec<_>>()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(reason) => {
            eprintln!("cargo xtask {name}: {reason}");
            ExitCode::FAILURE
        }
    }
}

fn help() -> String {
    let chores = CHORES.iter().map(|chore| {
        let usage = format!("{} {}", chore.name, chore.arguments);
        format!("  cargo xtask {usage}\n      {}\n", chore.about)
    });
    let list = |checks: &[test::Check]| -> String {
        let lines = checks.iter();
        let lines = lines.map(|check| format!("  {:<10} {}\n", check.name, check.about));
        lines.collect()
    };
    format!(
        "The project's chores:\n{}\nThe checks of `cargo xtask test`, in order:\n{}\nOnly where it is \
         named:\n{}",
        chores.collect::<String>(),
        list(&test::CHECKS),
        list(&test::ON_REQUEST)
    )
}
