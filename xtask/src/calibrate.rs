//! `cargo xtask calibrate`: whether the stated uncertainties hold.

use crate::Result;
use crate::cargo::{cargo, run as run_command};

pub(crate) const ABOUT: &str =
    "Infer DROPS simulated drops for each scenario; print the table, draw into FOLDER";

pub(crate) fn run(arguments: &[String]) -> Result {
    let words = [
        "run",
        "--release",
        "--package",
        "bouncelab-report",
        "--example",
        "calibration",
        "--",
    ];
    run_command(cargo(words).args(arguments))
}
