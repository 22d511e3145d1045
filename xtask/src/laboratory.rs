//! `cargo xtask laboratory`: recordings to measure sessions with.

use crate::Result;
use crate::cargo::{cargo, run as run_command};

pub(crate) const ABOUT: &str = "Make COUNT recordings of ten seconds with known truth in FOLDER";

pub(crate) fn run(words: &[String]) -> Result {
    let example = [
        "run",
        "--quiet",
        "--release",
        "-p",
        "bouncelab-cli",
        "--example",
        "laboratory",
        "--",
    ];
    run_command(cargo(example).args(words))
}
