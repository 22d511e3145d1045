//! The check `fresh`: what the repository holds is enough. A clean clone, in an environment as empty as can
//! be made on this machine, compiles and runs the demo, and makes a page that works.
//!
//! It has a home folder, a target folder, and folders of cargo and npm of its own, all empty; only the
//! variables of the environment that are needed to find programs and the network; and what was committed. It
//! shares with the machine the programs on the path (packages of the system, the compiler, what was
//! installed with cargo) and the crates of others, downloaded and compiled, whose hashes are in `Cargo.lock`. What would
//! take minutes and could find little more is left out: the compiled science for the page is that of the
//! check `web`, and the program has the profile of the tests.

use std::env;
use std::ffi::OsString;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::cargo::{cargo_all, emptied, root, run as run_command, succeeds, target};
use crate::steps::skip;
use crate::{Result, file_error, web};

/// Whether there is something to clone, and something to clone it with.
pub(crate) fn has_repository() -> bool {
    let has_it = root().join(".git").exists() && succeeds(&["git", "--version"]);
    if !has_it {
        println!("this is no repository of git, so there is nothing to clone");
    }
    has_it
}

pub(crate) fn run() -> Result {
    let place = Place::make()?;
    println!(
        "In a clone of what was committed, with an empty home, target and cache of npm. It shares with \
         this machine:\nthe programs on the path, the crates of others, and the WebAssembly compiled for the check `web`."
    );
    report_uncommitted();
    place.clone_repository()?;
    // Everything is there that any crate, test or example names. The compiled crates of others are shared.
    let mut check = cargo_all(&["check"]);
    check.args(["--all-targets", "--locked"]);
    place.run_sharing_target(&mut check)?;
    // What `cargo xtask install` does after the page, without the microphone, and the demo, which finds everything
    // compiled: with the profile of the tests, so that only the crates of the clone are compiled; and those not optimised,
    // since optimising them takes longer than the demo without it.
    for words in [
        "install --locked --profile dev --path crates/bouncelab-cli --root installed",
        "run --locked -- demo",
    ] {
        let mut command = Command::new("cargo");
        for name in ["bouncelab", "bouncelab-audio"] {
            for setting in ["opt-level=0", "codegen-units=16"] {
                let setting = format!("profile.dev.package.{name}.{setting}");
                command.args(["--config", &setting]);
            }
        }
        place.run_sharing_target(command.args(words.split(' ')))?;
    }
    place.check_without_microphone()?;
    place.run(Command::new("cargo").args(["xtask", "test", "format"]))?;
    if web::has_node() {
        place.check_page()?;
    }
    Ok(())
}

/// Says what this check does not see.
fn report_uncommitted() {
    let mut ask = Command::new("git");
    ask.args(["status", "--porcelain"]).current_dir(root());
    let changes = ask.output().map(|output| output.stdout).unwrap_or_default();
    let changes = String::from_utf8_lossy(&changes);
    if !changes.is_empty() {
        println!("Not committed, so not part of it:\n{}", changes.trim_end());
    }
}

/// The folders of the empty environment.
struct Place {
    clone: PathBuf,
    home: PathBuf,
    cargo_home: PathBuf,
}

impl Place {
    /// Empties what an earlier run left.
    fn make() -> Result<Self> {
        let folder = target().join("fresh");
        emptied(&folder)?;
        let place = Self {
            clone: folder.join("clone"),
            home: folder.join("home"),
            cargo_home: folder.join("cargo"),
        };
        for folder in [&place.home, &place.cargo_home] {
            fs::create_dir_all(folder).map_err(|reason| file_error(folder, &reason))?;
        }
        share_downloads(&place.cargo_home)?;
        Ok(place)
    }

    fn clone_repository(&self) -> Result {
        let mut clone = Command::new("git");
        clone.args(["clone", "--quiet", "--local"]).arg(root());
        run_command(clone.arg(&self.clone))
    }

    /// Runs a command in the clone.
    fn run(&self, command: &mut Command) -> Result {
        self.empty(command);
        run_command(command)
    }

    /// The same with the target folder of this machine; with its downloads, because cargo compiles anew
    /// what lies elsewhere.
    fn run_sharing_target(&self, command: &mut Command) -> Result {
        self.empty(command);
        command.env("CARGO_HOME", home_of("CARGO_HOME", ".cargo"));
        run_command(command.env("CARGO_TARGET_DIR", target()))
    }

    /// Leaves a command nothing but the programs, the network and the compiler.
    fn empty(&self, command: &mut Command) {
        let is_needed = |name: &OsString| {
            let name = name.to_string_lossy().to_uppercase();
            let is_network = ["PROXY", "CERT", "SSL"]
                .iter()
                .any(|part| name.contains(part));
            is_network || ["PATH", "LANG", "TERM", "RUSTUP_TOOLCHAIN"].contains(&name.as_str())
        };
        command.env_clear().env("CARGO_INCREMENTAL", "0");
        command.envs(env::vars_os().filter(|(name, _)| is_needed(name)));
        command.env("HOME", &self.home);
        command.env("CARGO_HOME", &self.cargo_home);
        command.env("RUSTUP_HOME", home_of("RUSTUP_HOME", ".rustup"));
        command.current_dir(&self.clone);
    }

    /// The tests are built with the microphone where that is possible; this program is not.
    fn check_without_microphone(&self) -> Result {
        let mut listen = Command::new(self.clone.join("installed/bin/bouncelab"));
        self.empty(listen.arg("listen"));
        let output = listen.output().map_err(|reason| reason.to_string())?;
        let message = String::from_utf8_lossy(&output.stderr);
        if output.status.code() == Some(2) && message.contains("cargo xtask install") {
            return Ok(());
        }
        Err(format!(
            "`bouncelab listen` without the microphone says: {message}"
        ))
    }

    /// What is needed for the page is named in its lock file, and nothing else is.
    fn check_page(&self) -> Result {
        let compiled = web::web().join(web::ENGINE);
        if !compiled.is_dir() {
            skip("the page of the clone, whose science the check `web` compiles");
            return Ok(());
        }
        let copy = self.clone.join("web").join(web::ENGINE);
        fs::create_dir_all(&copy).map_err(|reason| file_error(&copy, &reason))?;
        for file in fs::read_dir(&compiled).map_err(|reason| file_error(&compiled, &reason))? {
            let file = file.map_err(|reason| file_error(&compiled, &reason))?;
            let to = copy.join(file.file_name());
            fs::copy(file.path(), &to).map_err(|reason| file_error(&to, &reason))?;
        }
        let mut steps = vec![
            "ci --no-audit --no-fund",
            "run check",
            "run test",
            "run build",
        ];
        if web::has_browser() {
            steps.push("run e2e -- offline");
        }
        for words in steps {
            let mut npm = Command::new("npm");
            self.empty(npm.args(words.split(' ')));
            run_command(npm.current_dir(self.clone.join("web")))?;
        }
        Ok(())
    }
}

/// Crates that were downloaded need not be downloaded again.
#[cfg(unix)]
fn share_downloads(cargo_home: &Path) -> Result {
    let downloads = home_of("CARGO_HOME", ".cargo").join("registry");
    if !downloads.is_dir() {
        return Ok(());
    }
    let link = cargo_home.join("registry");
    std::os::unix::fs::symlink(downloads, &link).map_err(|reason| file_error(&link, &reason))
}

#[cfg(not(unix))]
fn share_downloads(_: &Path) -> Result {
    Ok(())
}

/// A folder of the toolchain: the one named, or that in the home folder.
fn home_of(variable: &str, folder: &str) -> PathBuf {
    env::var_os(variable).map_or_else(
        || PathBuf::from(env::var_os("HOME").unwrap_or_default()).join(folder),
        PathBuf::from,
    )
}
