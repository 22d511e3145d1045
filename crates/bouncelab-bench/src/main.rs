//! The measuring programs: `cargo xtask help` lists them.

#![expect(clippy::print_stderr, reason = "it prints for contributors")]

use std::process::ExitCode;

use bouncelab_bench::{
    Result, balls, calibration, call, damage, detection, drop_sounds, laboratory, net, sessions,
    verdicts,
};

type Program = fn(&[String]) -> Result;

const PROGRAMS: [(&str, Program); 10] = [
    ("balls", balls::run),
    ("calibrate", calibration::run),
    ("call", call::run),
    ("damage", damage::run),
    ("detection", detection::run),
    ("drop-sounds", drop_sounds::run),
    ("laboratory", laboratory::run),
    ("net", net::run),
    ("sessions", sessions::run),
    ("verdicts", verdicts::run),
];

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (name, arguments) = match arguments.split_first() {
        Some((name, arguments)) => (name.as_str(), arguments),
        None => ("", &[][..]),
    };
    let Some((_, run)) = PROGRAMS.iter().find(|(program, _)| *program == name) else {
        let names = PROGRAMS.map(|(name, _)| name).join(", ");
        eprintln!("'{name}' is no measuring program; there are {names}");
        return ExitCode::from(2);
    };
    match run(arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(reason) => {
            eprintln!("{name}: {reason}");
            ExitCode::FAILURE
        }
    }
}
