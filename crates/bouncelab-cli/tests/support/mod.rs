//! Lists of impact times for tests.

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use serde_json::Value;

/// Writes the impact times of a drop that `bouncelab simulate` makes of these arguments, a line each, in seconds with this number
/// of decimals.
pub(crate) fn write_simulated_times(path: &Path, arguments: &[&str], decimals: usize) {
    let output = Command::cargo_bin("bouncelab")
        .unwrap()
        .arg("simulate")
        .args(arguments)
        .args(["--format", "json"])
        .output()
        .unwrap();
    let history: Value = serde_json::from_slice(&output.stdout).unwrap();
    let bounces = history["simulations"][0]["bounces"].as_array().unwrap();
    let times: Vec<String> = bounces
        .iter()
        .map(|bounce| format!("{:.decimals$}", bounce["time_s"].as_f64().unwrap()))
        .collect();
    fs::write(path, times.join("\n")).unwrap();
}
