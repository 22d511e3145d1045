//! `cargo xtask verdicts`: how often verdicts by rule books are wrong.

use crate::Result;
use crate::cargo::{cargo, run as run_command};

pub(crate) const ABOUT: &str =
    "Judge BALLS simulated balls on and beside the limits; print the table";

pub(crate) fn run(arguments: &[String]) -> Result {
    let words = [
        "run",
        "--release",
        "--package",
        "bouncelab",
        "--example",
        "verdicts",
        "--",
    ];
    run_command(cargo(words).args(arguments))
}
