//! A Python with the programs that open the tables of a session, for the check of that name.

use std::path::PathBuf;
use std::process::Command;

use crate::cargo::{root, run as run_command, target};

/// Versions are pinned here.
const REQUIREMENTS: &str = "benchmarks/requirements-tables.txt";

/// The Python of a virtual environment in the target folder.
pub(crate) fn python() -> PathBuf {
    let folder = environment();
    if cfg!(windows) {
        folder.join("Scripts").join("python.exe")
    } else {
        folder.join("bin").join("python")
    }
}

fn environment() -> PathBuf {
    target().join("tables-venv")
}

/// Whether [`python`] has them, now that they were installed if that was possible.
pub(crate) fn have_readers() -> bool {
    let folder = environment();
    let (python, requirements) = (python(), root().join(REQUIREMENTS));
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
    let installed = made && run_command(&mut install).is_ok();
    if !installed {
        println!(
            "they could not be installed: it takes Python 3.11 or later and its package index"
        );
    }
    installed
}
