//! The check `measurements`: the commands of the documents that measure for minutes or hours run, on little.

use std::process::Command;

use crate::Result;
use crate::cargo::{built, emptied, run as run_command, target};

/// Examples, and what they are told. What makes recordings comes before what takes them.
const ON_LITTLE: [(&str, &[&str]); 4] = [
    ("damage", &["wav-float", "quick"]),
    ("detection", &["cells", "timing", "drops=1"]),
    ("detection", &["silence", "hours=0.002"]),
    ("laboratory", &["laboratory", "3"]),
];

pub(crate) fn check() -> Result {
    let folder = target().join("measurements");
    emptied(&folder)?;
    for (example, words) in ON_LITTLE {
        let program = built("--example", example)?;
        run_command(Command::new(program).args(words).current_dir(&folder))?;
    }
    let mut session = Command::new(built("--bin", "bouncelab")?);
    session.args([
        "session",
        "laboratory",
        "--pattern",
        "{ball}_{surface}_{height}_{}",
    ]);
    let known = ["--ball", "table-tennis-40", "--jobs", "2", "--no-inference"];
    run_command(session.args(known).current_dir(&folder))?;
    // What Python is measured against, which `measure.py` runs.
    built("--example", "call").map(drop)
}
