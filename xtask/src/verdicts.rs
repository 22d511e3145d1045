//! `cargo xtask verdicts`: rate of wrong verdicts.

use crate::Result;
use crate::cargo::run_example;

pub(crate) const ABOUT: &str =
    "Judge BALLS simulated balls a line, in all lines or those of DROPS drops; print the table";

pub(crate) fn run(words: &[String]) -> Result {
    run_example("bouncelab", "verdicts", words)
}
