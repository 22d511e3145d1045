//! The check `cluster`: Spark and Ray on small clusters of this machine.
//!
//! It takes half a gigabyte of downloads, which stay in the target folder, and a quarter of an hour; so it is no
//! part of `cargo xtask test` without a name.

use crate::Result;
use crate::cargo::{cargo_all, install, run as run_command, succeeds};
use crate::python::{MISSING, Venv, interpreters};

/// The newest versions that are supported, and the oldest.
const NEWEST: &str = "requirements-cluster.txt";
const OLDEST: &str = "requirements-cluster-oldest.txt";

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
    let made = venv("cluster", NEWEST).and_then(|_| venv("cluster-oldest", OLDEST));
    if let Err(reason) = &made {
        println!("Spark and Ray could not be installed: {reason}");
    }
    made.is_ok()
}

fn venv(name: &str, requirements: &str) -> Result<Venv> {
    let found = interpreters();
    let (_, python) = found.first().ok_or(MISSING)?;
    Venv::named(name, python, requirements)
}

/// All tests with the newest versions, and those that rows are right with the oldest.
pub(crate) fn check() -> Result {
    let (newest, oldest) = (venv("cluster", NEWEST)?, venv("cluster-oldest", OLDEST)?);
    let mut program = cargo_all(&["build"]);
    run_command(program.args(["--bin", "bouncelab"]))?;
    let wheel = newest.wheel("dev")?;
    let tests = ["-m", "pytest", "-s", "cluster"];
    newest.take(&wheel)?;
    run_command(&mut newest.python(&tests))?;
    oldest.take(&wheel)?;
    let mut few = oldest.python(&tests);
    few.args(["-k", "session or nothing_new"]);
    run_command(few.env("BOUNCELAB_CLUSTER_RECORDINGS", "200"))
}
