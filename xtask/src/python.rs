//! `cargo xtask wheel` and the check `python`: the Python package, as one wheel.
//!
//! Everything goes into virtual environments in the target folder. The wheel of the check is built in the
//! profile of the other checks, without link-time optimisation, and shares their compiled dependencies.

use std::collections::BTreeSet;
use std::env;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::thread;

use crate::cargo::{cargo, cargo_all, emptied, root, run as run_command, succeeds, target};
use crate::steps::skip;
use crate::{Result, file_error, notices, release};

pub(crate) const ABOUT: &str = "Build the wheel of the Python package into target/wheels";

/// What makes the environments, and installs into them; the first is made by Python itself.
const UV: &str = "uv==0.13.9";

/// The interpreters that must pass all tests with the same wheel; the first that is there builds it.
const VERSIONS: [&str; 3] = ["3.11", "3.12", "3.13"];

/// The interpreter without a global lock, which takes a wheel of its own.
const FREE_THREADED: &str = "3.14t";

/// What builds and checks the package, pinned; the other interpreters take the second list.
const REQUIREMENTS: &str = "requirements-test.txt";
const REQUIREMENTS_OF_OTHERS: &str = "requirements-other.txt";

/// Of that list, what there is for the free-threaded interpreter.
const REQUIREMENTS_OF_FREE_THREADED: &str = "requirements-free-threaded.txt";

/// What builds a wheel that shares compiled dependencies with the checks.
const SHARED: &[&str] = &["--features", "shared-build"];

/// Programs of others that are not written in Python: `PyPI` has them compiled.
const PROGRAMS: &str = "requirements-programs.txt";

/// The task: the wheel for users, and that for the free-threaded interpreter where there is one.
pub(crate) fn run(_: &[String]) -> Result {
    let wheel = released_wheel()?;
    println!("built {}", wheel.display());
    if let Some(python) = interpreter(FREE_THREADED) {
        let wheel = first_venv()?.wheel_for(&python, "free-threaded", "python", &[])?;
        println!("built {}", wheel.display());
    }
    Ok(())
}

/// The wheel for users.
pub(crate) fn released_wheel() -> Result<PathBuf> {
    first_venv()?.wheel("python", &[])
}

/// The wheel of the checks.
pub(crate) fn checked_wheel() -> Result<PathBuf> {
    first_venv()?.shared_wheel()
}

/// The sources of the package, as an archive that `pip install` builds.
pub(crate) fn sources() -> Result<PathBuf> {
    let folder = target().join("wheels/sources");
    emptied(&folder)?;
    notices::write(&package())?;
    let mut pack = first_venv()?.tool("maturin");
    pack.args(["sdist", "--out"]).arg(&folder);
    run_command(pack.env("SOURCE_DATE_EPOCH", release::EPOCH))?;
    only_file(&folder)
}

/// Whether unpacked sources hold all crates that the package is made of.
pub(crate) fn have_all_sources(unpacked: &Path) -> Result {
    // Of the lock file, maturin leaves out the crates that it leaves out; the versions of the others stay.
    let mut tree = cargo([
        "tree",
        "--offline",
        "--quiet",
        "--package",
        "bouncelab-python",
    ]);
    run_command(tree.args(["--depth", "1"]).current_dir(unpacked))
}

/// The first notebook of the package, run with the wheel of the checks and shown as a page of HTML.
pub(crate) fn notebook() -> Result<PathBuf> {
    let mut convert = venv_of_book()?.python(&["-m", "nbconvert", "--execute", "--to", "html"]);
    convert.arg("--output-dir").arg(target());
    run_command(convert.arg("notebooks/1-a-first-drop.ipynb"))?;
    Ok(target().join("1-a-first-drop.html"))
}

/// Writes what the package documents of its public names into a folder, as pages of HTML.
pub(crate) fn reference(folder: &Path) -> Result {
    let mut write = venv_of_book()?.python(&["-m", "pdoc", "--docformat", "numpy"]);
    write.arg("--output-directory").arg(folder);
    run_command(write.args(["bouncelab", "bouncelab.batch"]))
}

/// What makes parts of the book, with the wheel of the checks.
fn venv_of_book() -> Result<Venv> {
    let found = interpreters();
    let (_, python) = found.first().ok_or(MISSING)?;
    let venv = Venv::named("book", python, "requirements-book.txt")?;
    venv.take(&checked_wheel()?)?;
    Ok(venv)
}

/// Installs a wheel into a folder of its own.
pub(crate) fn install_into(folder: &Path, wheel: &Path) -> Result {
    let mut install = first_venv()?.install();
    install.args(["--no-deps", "--target"]).arg(folder);
    run_command(install.arg(wheel))
}

/// Checks documents against the schemas that check-jsonschema has under these names.
pub(crate) fn validate(documents: impl IntoIterator<Item = (&'static str, PathBuf)>) -> Result {
    let venv = first_venv()?;
    documents.into_iter().try_for_each(|(schema, document)| {
        let mut check = venv.tool("check-jsonschema");
        check.args(["--builtin-schema", schema]);
        run_command(check.arg(document))
    })
}

/// Where a program of [`PROGRAMS`] is, now that they were installed if that was possible; else that on the path.
pub(crate) fn program(name: &str) -> Option<PathBuf> {
    let installed = || {
        let found = interpreters();
        let (_, python) = found.first().ok_or(MISSING)?;
        let venv = Venv::with_uv(folder_of(python), python, PROGRAMS)?;
        Ok::<_, String>(venv.program(name))
    };
    installed()
        .inspect_err(|reason| println!("{name} could not be installed from PyPI: {reason}"))
        .ok()
        .or_else(|| succeeds(&[name, "--version"]).then(|| name.into()))
}

/// The interpreter of the environment that builds and checks the package.
pub(crate) fn first_interpreter() -> Result<PathBuf> {
    Ok(first_venv()?.program("python"))
}

/// The environment of the first interpreter, which builds and checks the package.
fn first_venv() -> Result<Venv> {
    let found = interpreters();
    let (_, python) = found.first().ok_or(MISSING)?;
    Venv::first(python)
}

pub(crate) const MISSING: &str =
    "it takes Python 3.11, 3.12 or 3.13, as python3.11 or in the folder of pyenv";

/// Whether there is an interpreter, and what the check needs could be installed.
pub(crate) fn have_package_index() -> bool {
    let made = first_venv();
    if let Err(reason) = &made {
        println!("the Python package cannot be checked: {reason}");
    }
    made.is_ok()
}

/// The check.
pub(crate) fn check() -> Result {
    let found = interpreters();
    let (first, others) = found.split_first().ok_or(MISSING)?;
    shares_dependencies()?;
    let venv = Venv::first(&first.1)?;
    let wheel = venv.shared_wheel()?;
    venv.take(&wheel)?;
    // What checks types takes one processor, beside tests that wait now and then.
    let (types, tests) = thread::scope(|threads| {
        let types = threads.spawn(|| venv.check_types());
        let tests = venv.test().and_then(|()| {
            others.iter().try_for_each(|(_, python)| {
                let other = venv.other(python, REQUIREMENTS_OF_OTHERS)?;
                other.take(&wheel)?;
                other.test()
            })
        });
        (types.join().expect("it returns what is wrong"), tests)
    });
    tests.and(types)?;
    run_command(venv.tool("abi3audit").arg("--strict").arg(&wheel))?;
    // Two commands of the documents.
    let mut measure = venv.python(&["benchmarks/measure.py", "import", "--wheel"]);
    run_command(measure.arg(&wheel))?;
    let mut without_installing = Command::new(program_in(&venv.folder, "uvx"));
    without_installing
        .arg("--python")
        .arg(&first.1)
        .arg("--from");
    run_command(without_installing.arg(&wheel).args(["bouncelab", "paper"]))?;
    match interpreter(FREE_THREADED) {
        Some(python) => {
            let wheel = venv.wheel_for(&python, "free-threaded-dev", "dev", SHARED)?;
            let other = venv.other(&python, REQUIREMENTS_OF_FREE_THREADED)?;
            other.take(&wheel)?;
            other.test()?;
        }
        None => skip(&format!(
            "the tests with free-threaded Python {FREE_THREADED}, which is missing"
        )),
    }
    let missing = VERSIONS
        .iter()
        .filter(|&version| found.iter().all(|(it, _)| it != version));
    for version in missing {
        skip(&format!(
            "the tests with Python {version}, which is missing"
        ));
    }
    Ok(())
}

/// Whether the dependencies of the wheel of the checks have the features that the other checks give them: else each such
/// crate, and all that depend on it, are compiled twice.
fn shares_dependencies() -> Result {
    let features_of = |command: &mut Command| -> Result<BTreeSet<String>> {
        let made = command.args(["--prefix", "none", "--format", "{p} {f}"]);
        let made = made.output().map_err(|reason| reason.to_string())?;
        if !made.status.success() {
            return Err(String::from_utf8_lossy(&made.stderr).into_owned());
        }
        let lines = String::from_utf8_lossy(&made.stdout).into_owned();
        let lines = lines.lines().map(|line| line.trim_end_matches(" (*)"));
        // The crates of the workspace, which have a path, differ in what only some machines can build.
        let of_others = lines.filter(|line| !line.contains("(/"));
        Ok(of_others.map(str::to_owned).collect())
    };
    let all = features_of(&mut cargo_all(&["tree", "--edges", "normal,build,dev"]))?;
    let mut tree = cargo(["tree", "--package", "bouncelab-python"]);
    let shared = features_of(tree.args(["--edges", "normal,build"]).args(SHARED))?;
    let others: Vec<_> = shared.difference(&all).map(String::as_str).collect();
    if others.is_empty() {
        return Ok(());
    }
    Err(format!(
        "the feature shared-build of bouncelab-python gives these crates other features than the workspace does, so that \
         they are compiled twice:\n{}",
        others.join("\n")
    ))
}

/// Version and place of the interpreters that there are.
pub(crate) fn interpreters() -> Vec<(&'static str, PathBuf)> {
    let found = VERSIONS
        .iter()
        .filter_map(|&version| Some((version, interpreter(version)?)));
    found.collect()
}

fn interpreter(version: &str) -> Option<PathBuf> {
    let name = format!("python{version}");
    if succeeds(&[&name, "-c", "import venv"]) {
        return Some(name.into());
    }
    let home = env::var_os("PYENV_ROOT").map(PathBuf::from);
    let home = home.or_else(|| Some(env::home_dir()?.join(".pyenv")))?;
    let installed = fs::read_dir(home.join("versions")).ok()?.flatten();
    let mut installed = installed.map(|entry| entry.path().join("bin").join(&name));
    installed.find(|python| python.is_file())
}

/// A virtual environment with what is pinned in a list, and the uv that installs it.
pub(crate) struct Venv {
    folder: PathBuf,
    uv: PathBuf,
}

impl Venv {
    /// With everything that builds and checks the package.
    fn first(python: &Path) -> Result<Self> {
        Self::with_uv(folder_of(python), python, REQUIREMENTS)
    }

    /// One of this name in the target folder, with what is pinned in a list.
    pub(crate) fn named(name: &str, python: &Path, requirements: &str) -> Result<Self> {
        let folder = target().join(format!("{name}-venv"));
        Self::with_uv(folder, python, requirements)
    }

    fn with_uv(folder: PathBuf, python: &Path, requirements: &str) -> Result<Self> {
        let uv = program_in(&folder, "uv");
        let venv = Self { folder, uv };
        if !venv.uv.is_file() {
            println!(
                "what {requirements} lists goes into {}",
                venv.folder.display()
            );
            run_command(Command::new(python).args(["-m", "venv"]).arg(&venv.folder))?;
            let mut pip = venv.python(&["-m", "pip", "install", "--quiet", UV]);
            run_command(pip.arg("--disable-pip-version-check"))?;
        }
        venv.install_requirements(requirements)?;
        Ok(venv)
    }

    /// With what the tests take, of another interpreter.
    fn other(&self, python: &Path, requirements: &str) -> Result<Self> {
        let venv = Self {
            folder: folder_of(python),
            uv: self.uv.clone(),
        };
        let mut make = Command::new(&venv.uv);
        make.args(["venv", "--quiet", "--clear", "--python"]);
        run_command(make.arg(python).arg(&venv.folder))?;
        venv.install_requirements(requirements)?;
        Ok(venv)
    }

    fn install_requirements(&self, list: &str) -> Result {
        let mut install = self.install();
        run_command(install.arg("--requirement").arg(package().join(list)))
    }

    fn program(&self, name: &str) -> PathBuf {
        program_in(&self.folder, name)
    }

    fn tool(&self, name: &str) -> Command {
        let mut command = Command::new(self.program(name));
        command.current_dir(package());
        command
    }

    pub(crate) fn python(&self, words: &[&str]) -> Command {
        let mut command = self.tool("python");
        command.args(words);
        command
    }

    fn install(&self) -> Command {
        let mut command = Command::new(&self.uv);
        command.args(["pip", "install", "--quiet", "--python"]);
        command.arg(self.program("python"));
        command
    }

    /// The programs of the environment, before all others.
    fn path(&self) -> Result<OsString> {
        let own = self.program("python").parent().map(Path::to_owned);
        let others = env::var_os("PATH").unwrap_or_default();
        let folders = own.into_iter().chain(env::split_paths(&others));
        env::join_paths(folders).map_err(|reason| reason.to_string())
    }

    /// Builds the wheel of the checks, which shares compiled dependencies with them.
    pub(crate) fn shared_wheel(&self) -> Result<PathBuf> {
        self.wheel("dev", SHARED)
    }

    /// Builds the wheel that every interpreter with a global lock takes.
    fn wheel(&self, profile: &str, options: &[&str]) -> Result<PathBuf> {
        self.wheel_for(&self.program("python"), profile, profile, options)
    }

    /// Builds the wheel for an interpreter, into a folder of this name.
    fn wheel_for(
        &self,
        python: &Path,
        name: &str,
        profile: &str,
        options: &[&str],
    ) -> Result<PathBuf> {
        let folder = target().join("wheels").join(name);
        fs::remove_dir_all(&folder).ok();
        notices::write(&package())?;
        let mut build = self.tool("maturin");
        build.args(["build", "--profile", profile, "--compression-level", "9"]);
        build.arg("--interpreter");
        build.arg(python).arg("--out").arg(&folder);
        build.args(options);
        build.env("SOURCE_DATE_EPOCH", release::EPOCH);
        run_command(build.env("CARGO_TARGET_DIR", target()))?;
        only_file(&folder)
    }

    /// Runs the tests and the examples of the documentation on what the wheel installed, a process for each core.
    fn test(&self) -> Result {
        let mut tests = self.python(&["-m", "pytest", "--numprocesses", "logical"]);
        tests.args(["--dist", "worksteal", "--durations", "10"]);
        // The examples of engines that are not installed are left out.
        tests.args(["--doctest-modules", "--doctest-ignore-import-errors"]);
        tests.args(["--pyargs", "./tests", "bouncelab"]);
        run_command(tests.env("BOUNCELAB_ROOT", root()))
    }

    /// Installs the wheel, in place of an earlier one.
    pub(crate) fn take(&self, wheel: &Path) -> Result {
        let mut install = self.install();
        run_command(install.args(["--force-reinstall", "--no-deps"]).arg(wheel))
    }

    fn check_types(&self) -> Result {
        run_command(self.tool("mypy").args(["--strict", "python/bouncelab"]))?;
        run_command(self.tool("stubtest").args(["bouncelab._core"]))?;
        let mut pyright = self.tool("pyright");
        pyright.arg("--pythonpath").arg(self.program("python"));
        run_command(pyright.arg("python/bouncelab"))?;
        // Of the installed package, which pyright finds by the Python that is first on the path.
        let mut public = self.tool("pyright");
        public.args(["--ignoreexternal", "--verifytypes", "bouncelab"]);
        run_command(public.env("PATH", self.path()?).current_dir(&self.folder))
    }
}

/// What maturin made in an empty folder.
fn only_file(folder: &Path) -> Result<PathBuf> {
    let mut files = fs::read_dir(folder).map_err(|reason| file_error(folder, &reason))?;
    let file = files.find_map(|entry| Some(entry.ok()?.path()));
    file.ok_or_else(|| format!("maturin made nothing in {}", folder.display()))
}

/// Where the environment of an interpreter is.
fn folder_of(python: &Path) -> PathBuf {
    let name = python.file_name().unwrap_or_default().to_string_lossy();
    target().join(format!("{name}-venv"))
}

/// A program of an environment.
fn program_in(folder: &Path, name: &str) -> PathBuf {
    if cfg!(windows) {
        folder.join("Scripts").join(format!("{name}.exe"))
    } else {
        folder.join("bin").join(name)
    }
}

/// The folder of the package.
fn package() -> PathBuf {
    root().join("crates/bouncelab-python")
}
