//! `cargo xtask calibrate`: calibration of the inference.

use crate::Result;
use crate::cargo::run_example;

pub(crate) const ABOUT: &str = "Infer DROPS simulated drops for each scenario, print the table, draw into FOLDER; \
     or for each world in which the model is not true";

pub(crate) fn run(words: &[String]) -> Result {
    match words {
        [first, rest @ ..] if first == "worlds" => run_example("bouncelab", "worlds", rest),
        _ => run_example("bouncelab-report", "calibration", words),
    }
}
