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
mod cargo;
mod cluster;
mod fresh;
mod fuzz;
mod measure;
mod package;
mod python;
mod release;
mod steps;
mod test;
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

const CHORES: [Chore; 7] = [
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
    let arguments: Vec<String> = arguments.collect();
    let result = if let Some(chore) = CHORES.iter().find(|chore| chore.name == name) {
        (chore.run)(&arguments)
    } else if measure::PROGRAMS.iter().any(|it| it.name == name) {
        measure::run(&name, &arguments)
    } else {
        eprint!("There is no task '{name}'.\n\n{}", help());
        return ExitCode::from(2);
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(reason) => {
            eprintln!("cargo xtask {name}: {reason}");
            ExitCode::FAILURE
        }
    }
}

fn help() -> String {
    let task =
        |name, arguments, about| format!("  cargo xtask {name} {arguments}\n      {about}\n");
    let chores = CHORES.iter();
    let chores: String = chores
        .map(|it| task(it.name, it.arguments, it.about))
        .collect();
    let programs = measure::PROGRAMS.iter();
    let programs: String = programs
        .map(|it| task(it.name, it.arguments, it.about))
        .collect();
    let list = |checks: &[test::Check]| -> String {
        let lines = checks.iter();
        let lines = lines.map(|check| format!("  {:<10} {}\n", check.name, check.about));
        lines.collect()
    };
    format!(
        "The tasks of the project:\n{chores}\nIts measuring programs:\n{programs}\nThe checks of `cargo xtask test`, in order:\n{}\nOnly where it is \
         named:\n{}",
        list(&test::CHECKS),
        list(&test::ON_REQUEST)
    )
}
