//! The tables of a session, opened by the programs that people use.
//!
//! `BOUNCELAB_PYTHON` names a Python that has Polars, `DuckDB`, pandas and `PyArrow`, which
//! `cargo xtask test tables` makes.

use std::fs;
use std::path::Path;
use std::process::Command as Plain;

use assert_cmd::Command;
use tempfile::TempDir;

#[test]
#[ignore = "runs the Python in BOUNCELAB_PYTHON"]
fn polars_duckdb_and_pandas_see_the_same() {
    let python = std::env::var_os("BOUNCELAB_PYTHON").expect("BOUNCELAB_PYTHON names a Python");
    let folder = TempDir::new().unwrap();
    let times = folder.path().join("red steel.txt");
    // Flight times of the paper's ball with drag, s,.
    fs::write(
        &times,
        "0\n0.4605\n0.8877\n1.2854\n1.6568\n2.0045\n2.3308\n",
    )
    .unwrap();
    let results = folder.path().join("results");
    Command::cargo_bin("bouncelab")
        .unwrap()
        .arg("session")
        .arg(&times)
        .arg("--output")
        .arg(&results)
        .args(["--pattern", "{ball} {surface}"])
        .args(["--ball", "table-tennis-38", "--draws", "200"])
        .assert()
        .success();
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/open_tables.py");
    let output = Plain::new(python)
        .arg(script)
        .arg(&results)
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
}
