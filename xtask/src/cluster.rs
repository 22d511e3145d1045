//! The check `cluster`: Spark and Ray on small clusters of this machine.
//!
//! It takes a gigabyte of downloads, which stay in the target folder, and twenty minutes; so it is no part of
//! `cargo xtask test` without a name.

use crate::Result;
use crate::cargo::{install, run as run_command, succeeds};
use crate::python::{MISSING, Venv, interpreters};

/// What Spark runs on.
const JAVA: &str = "openjdk-17-jre-headless";

/// One end of the range of versions of the engines that the package takes: the name of its environment, what is
/// pinned in it, and how many recordings are compared with a session.
struct End {
    name: &'static str,
    requirements: &'static str,
    recordings: &'static str,
    tests: &'static [&'static str],
}

const NEWEST: End = End {
    name: "cluster",
    requirements: "requirements-cluster-newest.txt",
    recordings: "2000",
    tests: &["cluster"],
};

/// What is killed does not depend on the version of an engine.
const OLDEST: End = End {
    name: "cluster-oldest",
    requirements: "requirements-cluster-oldest.txt",
    recordings: "300",
    tests: &["cluster/test_spark.py", "cluster/test_ray.py"],
};

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
    let made = [NEWEST, OLDEST]
        .iter()
        .try_for_each(|end| end.venv().map(drop));
    if let Err(reason) = &made {
        println!("Spark and Ray could not be installed: {reason}");
    }
    made.is_ok()
}

/// The tests in the folder `cluster` of the package.
pub(crate) fn check() -> Result {
    let wheel = NEWEST.venv()?.shared_wheel()?;
    for end in [OLDEST, NEWEST] {
        let venv = end.venv()?;
        venv.take(&wheel)?;
        let mut tests = venv.python(&["-m", "pytest", "-s"]);
        tests.env("BOUNCELAB_CLUSTER_RECORDINGS", end.recordings);
        run_command(tests.args(end.tests))?;
    }
    Ok(())
}

impl End {
    fn venv(&self) -> Result<Venv> {
        let found = interpreters();
        let (_, python) = found.first().ok_or(MISSING)?;
        Venv::named(self.name, python, self.requirements)
    }
}
