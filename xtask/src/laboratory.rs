//! `cargo xtask laboratory`: recordings to measure sessions with.

use crate::Result;
use crate::cargo::run_example;

pub(crate) const ABOUT: &str = "Make COUNT recordings of ten seconds with known truth in FOLDER";

pub(crate) fn run(words: &[String]) -> Result {
    run_example("bouncelab-cli", "laboratory", words)
}
