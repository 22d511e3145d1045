//! `cargo xtask detection`: the detection benchmark.

use crate::Result;
use crate::cargo::run_example;

pub(crate) const ABOUT: &str =
    "Measure how impacts are detected in synthetic recordings: cells, timing, silence";

pub(crate) fn run(words: &[String]) -> Result {
    run_example("bouncelab", "detection", words)
}
