//! The measuring programs of `bouncelab-bench`, and the check `measurements`: those that take minutes or hours run on
//! little.

use std::process::Command;

use crate::Result;
use crate::cargo::{built, cargo, emptied, run as run_command, target};

const CRATE: &str = "bouncelab-bench";

/// A measuring program: `cargo xtask NAME ARGUMENTS`.
pub(crate) struct Program {
    pub(crate) name: &'static str,
    pub(crate) arguments: &'static str,
    pub(crate) about: &'static str,
}

pub(crate) const PROGRAMS: [Program; 8] = [
    Program {
        name: "net",
        arguments: "[drops=1000] [sounds=FOLDER]... [out=FILE] [compare=FILE] [store=FILE]",
        about: "Every number of simulated drops and of sounds, or how they differ from those of an earlier run",
    },
    Program {
        name: "calibrate",
        arguments: "[DROPS [FOLDER]] | scenarios [DROPS] [impacts=N] [SCENARIO...] [LAW...] | \
                    tape FILE [without=DROP...] [later=MS] [each] | recordings FOLDER",
        about: "Infer DROPS simulated drops for each scenario, print the table, write the ranks into FOLDER; \
                or where the model or what is stated is not true; or real drops against a tape measure; \
                or recordings without their first impacts",
    },
    Program {
        name: "verdicts",
        arguments: "[BALLS]",
        about: "Measure how often verdicts on simulated balls and floors of known rebound are wrong, and undecided",
    },
    Program {
        name: "balls",
        arguments: "[DROPS]",
        about: "Measure how often a drop shows that the stated ball is wrong",
    },
    Program {
        name: "detection",
        arguments: "[PART...] [drops=20] [hours=1] [only=SOUND] [wav=FOLDER]",
        about: "Measure how impacts are detected in synthetic recordings: cells, timing, silence, steady",
    },
    Program {
        name: "damage",
        arguments: "[FORMAT] [quick] [step=N]",
        about: "Damage a known drop in every FORMAT at every (Nth) percent in eleven ways; print the table",
    },
    Program {
        name: "laboratory",
        arguments: "FOLDER COUNT",
        about: "Write COUNT recordings with known truth, to measure sessions with",
    },
    Program {
        name: "sessions",
        arguments: "[STUDIES]",
        about: "Measure whether the intervals of sessions hold; print the table",
    },
];

/// Runs a program, optimised.
pub(crate) fn run(name: &str, arguments: &[String]) -> Result {
    let run_it = ["run", "--release", "--package", CRATE, "--", name];
    run_command(cargo(run_it).args(arguments))
}

/// Programs and their arguments in the check. What makes recordings comes before what takes them.
const ON_LITTLE: [&[&str]; 9] = [
    &["net", "drops=3", "out=net.txt"],
    &["calibrate", "2"],
    &["calibrate", "scenarios", "2", "true"],
    &["balls", "1"],
    &["damage", "wav-float", "quick", "step=9"],
    &["detection", "cells", "timing", "drops=1"],
    &["detection", "silence", "hours=0.002"],
    &["laboratory", "laboratory", "3"],
    &["sessions", "2"],
];

pub(crate) fn check() -> Result {
    let folder = target().join("measurements");
    emptied(&folder)?;
    let program = built("--bin", CRATE)?;
    for arguments in ON_LITTLE {
        run_command(Command::new(&program).args(arguments).current_dir(&folder))?;
    }
    let mut session = Command::new(built("--bin", "bouncelab")?);
    session.args([
        "session",
        "laboratory",
        "--pattern",
        "{ball}_{surface}_{height}_{}",
    ]);
    let settings = ["--ball", "table-tennis-40", "--jobs", "2", "--no-inference"];
    run_command(session.args(settings).current_dir(&folder))
}
