//! `cargo xtask grid`: how well the listener hears.

use crate::Result;
use crate::cargo::{cargo, run as run_command};

pub(crate) const ABOUT: &str =
    "Measure the listener on synthetic recordings: cells, timing, silence";

pub(crate) fn run(words: &[String]) -> Result {
    let example = [
        "run",
        "--quiet",
        "--release",
        "-p",
        "bouncelab",
        "--example",
        "grid",
        "--",
    ];
    run_command(cargo(example).args(words))
}
