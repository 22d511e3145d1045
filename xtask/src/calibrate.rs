//! `cargo xtask calibrate`: calibration of the inference.

use crate::Result;
use crate::cargo::run_example;

pub(crate) const ABOUT: &str =
    "Infer DROPS simulated drops for each scenario; print the table, draw into FOLDER";

pub(crate) fn run(words: &[String]) -> Result {
    run_example("bouncelab-report", "calibration", words)
}
