//! `cargo xtask damage`: what becomes of the result when a file is damaged.

use crate::Result;
use crate::cargo::run_example;

pub(crate) const ABOUT: &str =
    "Damage a known drop in every FORMAT at every percent in four ways; print the table";

pub(crate) fn run(words: &[String]) -> Result {
    run_example("bouncelab-testkit", "damage", words)
}
