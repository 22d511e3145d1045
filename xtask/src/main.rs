//! The project's own tasks: `cargo xtask help` lists them.
//!
//! One module for each task; a new one is a module and a line in [`TASKS`]. It uses few crates, all small, so that a
//! fresh clone starts checking at once.

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
mod notices;
mod package;
mod python;
mod release;
mod steps;
mod test;
mod web;

use std::io;
use std::path::Path;
use std::process::ExitCode;

/// Why a task did not succeed, ready to be printed.
type Result<T = ()> = std::result::Result<T, String>;

/// An error of the system with the file that it concerns.
fn file_error(path: &Path, reason: &io::Error) -> String {
    format!("{}: {reason}", path.display())
}

struct Task {
    name: &'static str,
    arguments: &'static str,
    about: &'static str,
    run: fn(&[String]) -> Result,
}

const TASKS: [Task; 8] = [
    Task {
        name: "test",
        arguments: "[CHECK...]",
        about: test::ABOUT,
        run: test::run,
    },
    Task {
        name: "bench",
        arguments: "[FILTER...]",
        about: bench::ABOUT,
        run: bench::run,
    },
    Task {
        name: "install",
        arguments: "[OPTION OF cargo install...]",
        about: release::ABOUT_INSTALL,
        run: release::install_program,
    },
    Task {
        name: "wheel",
        arguments: "",
        about: python::ABOUT,
        run: python::run,
    },
    Task {
        name: "release",
        arguments: "[documents | target=TRIPLE]",
        about: release::ABOUT,
        run: release::run,
    },
    Task {
        name: "book",
        arguments: "",
        about: book::ABOUT,
        run: book::run,
    },
    Task {
        name: "fuzz",
        arguments: "[TARGET...] [seconds=60]",
        about: fuzz::ABOUT,
        run: fuzz::run,
    },
    Task {
        name: "web",
        arguments: "[engine | package | check | e2e [FILE...] [--firefox] [--repeat N] [--load] [--slowdown N] [--pictures]]",
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
    let result = if let Some(task) = TASKS.iter().find(|task| task.name == name) {
        (task.run)(&arguments)
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
    let tasks = TASKS.iter();
    let tasks: String = tasks
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
        "The tasks of the project:\n{tasks}\nIts measuring programs:\n{programs}\nThe checks of `cargo xtask test`, in order:\n{}\nOnly where it is \
         named:\n{}",
        list(&test::CHECKS),
        list(&test::ON_REQUEST)
    )
}
