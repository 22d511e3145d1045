//! `cargo xtask bench`: benchmarks.

use crate::Result;
use crate::cargo::{cargo, run as run_command};

pub(crate) const ABOUT: &str = "Run all benchmarks, or those whose name contains a FILTER";

pub(crate) fn run(filters: &[String]) -> Result {
    // Only the benchmarks themselves: unit tests would not understand the filters.
    let words = ["bench", "--workspace", "--bench", "*", "--"];
    run_command(cargo(words).args(filters))
}
