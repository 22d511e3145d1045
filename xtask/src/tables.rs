//! A Python with the programs that open the tables of a session, for the check of that name.

use std::path::PathBuf;
use std::process::Command;

use crate::cargo::{root, run as run_command};

/// Versions are pinned here.
const REQUIREMENTS: &str = "benchmarks/requirements-tables.txt";

/// The Python of a virtual environment in the target folder, made if needed; `None`, with the reason
/// printed, where there is no Python or no package index.
pub(crate) fn python() -> Option<PathBuf> {
    let folder = root().join("target").join("tables-venv");
    let python = if cfg!(windows) {
        folder.join("Scripts").join("python.exe")
    } else {
        folder.join("bin").join("python")
    };
    let requirements = root().join(REQUIREMENTS);
    println!(
        "the check of tables installs the packages of {REQUIREMENTS} into {}",
        folder.display()
    );
    let made = python.is_file()
        || run_command(Command::new("python3").args(["-m", "venv"]).arg(&folder)).is_ok();
    let mut install = Command::new(&python);
    install.args([
        "-m",
        "pip",
        "install",
        "--quiet",
        "--disable-pip-version-check",
    ]);
    install
        .args(["--only-binary", ":all:", "--requirement"])
        .arg(requirements);
    if made && run_command(&mut install).is_ok() {
        return Some(python);
    }
    println!(
        "they could not be installed (no Python 3.11 or later, or no package index): the check of \
         tables is SKIPPED"
    );
    None
}
