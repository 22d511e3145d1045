//! The check `package`: whether a registry would take the crates for users.

use crate::Result;
use crate::cargo::{cargo, run as run_command};

/// The crates that stay in the repository.
const UNPUBLISHED: [&str; 5] = [
    "bouncelab-bench",
    "bouncelab-python",
    "bouncelab-testkit",
    "bouncelab-wasm",
    "xtask",
];

/// Publishes all crates in the order of their dependencies, but for sending them: their metadata are complete, each finds the
/// others by version, and nothing unpublished is needed.
///
/// Cargo would also compile each package by itself, all dependencies of it once more. That takes
/// minutes, and could only find that a file is missing: packages hold all files of their folders but
/// tests and benchmarks, so that only one outside of them could be.
pub(crate) fn run() -> Result {
    let mut command = cargo(["publish", "--dry-run", "--workspace", "--no-verify"]);
    command.arg("--allow-dirty");
    for name in UNPUBLISHED {
        command.args(["--exclude", name]);
    }
    run_command(command.arg("--quiet"))
}
