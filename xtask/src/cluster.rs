//! The check `cluster`: Spark and Ray on small clusters of this machine.
//!
//! It takes half a gigabyte of downloads, which stay in the target folder, and a quarter of an hour; so it is no
//! part of `cargo xtask test` without a name.

use crate::Result;
use crate::cargo::{install, run as run_command, succeeds};
use crate::python::{MISSING, Venv, interpreters};

/// Versions are pinned here.
const REQUIREMENTS: &str = "requirements-cluster.txt";

/// What Spark runs on.
const JAVA: &str = "openjdk-17-jre-headless";

/// Whether Java and the engines are there, now that they were installed if that was possible.
pub(crate) fn have_engines() -> bool {
    let has_java = || succeeds(&["java", "-version"]);
    if !has_java() {
        install(&[JAVA], "Spark");
    }
    if !has_java() {
        println!("Spark takes Java 17");
        return false;
    }
    println!("the check of clusters installs Spark and Ray into the target folder");
    let made = venv();
    if let Err(reason) = &made {
        println!("Spark and Ray could not be installed: {reason}");
    }
    made.is_ok()
}

fn venv() -> Result<Venv> {
    let found = interpreters();
    let (_, python) = found.first().ok_or(MISSING)?;
    Venv::named("cluster", python, REQUIREMENTS)
}

/// The tests in the folder `cluster` of the package.
pub(crate) fn check() -> Result {
    let venv = venv()?;
    venv.take(&venv.shared_wheel()?)?;
    run_command(&mut venv.python(&["-m", "pytest", "-s", "cluster"]))
}
