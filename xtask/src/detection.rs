//! `cargo xtask detection`: how well the listener hears.

use crate::Result;
use crate::cargo::run_example;

pub(crate) const ABOUT: &str =
    "Measure the listener on synthetic recordings: cells, timing, silence";

pub(crate) fn run(words: &[String]) -> Result {
    run_example("bouncelab", "detection", words)
}
