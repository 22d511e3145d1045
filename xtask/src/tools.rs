//! Programs of others that a chore needs, from crates.io. A chore that was asked for installs them into the target folder;
//! the checks, whose time is limited, use those that are there.

use std::path::{Path, PathBuf};

use crate::Result;
use crate::cargo::{cargo, run as run_command, succeeds, target};

/// A program, and the package of that name.
pub(crate) struct Tool {
    name: &'static str,
    /// A subcommand or an option with which it only says its version.
    version: &'static [&'static str],
    /// The chore that installs it.
    chore: &'static str,
}

pub(crate) const MDBOOK: Tool = Tool {
    name: "mdbook",
    version: &["--version"],
    chore: "book",
};

pub(crate) const CARGO_DEB: Tool = Tool {
    name: "cargo-deb",
    version: &["deb", "--version"],
    chore: "release",
};

impl Tool {
    /// Where it is: in the target folder, or on the path.
    pub(crate) fn find(&self) -> Option<PathBuf> {
        let places = [folder().join("bin").join(self.name), self.name.into()];
        let runs = |place: &PathBuf| {
            let program = place.to_string_lossy();
            succeeds(&[&[program.as_ref()], self.version].concat())
        };
        places.into_iter().find(runs)
    }

    /// The same; if it is not there, it is said how to get it.
    pub(crate) fn find_or_say(&self) -> Option<PathBuf> {
        let found = self.find();
        if found.is_none() {
            let Self { name, chore, .. } = self;
            println!(
                "{name} is not installed: cargo xtask {chore} installs it, or cargo install {name} --locked"
            );
        }
        found
    }

    /// The same; if it is not there, it is installed.
    pub(crate) fn find_or_install(&self) -> Result<PathBuf> {
        if let Some(found) = self.find() {
            return Ok(found);
        }
        let folder = folder();
        println!(
            "{} is not installed: it is compiled into {}, which takes minutes",
            self.name,
            folder.display()
        );
        run_command(&mut install(&folder, self.name))?;
        self.find()
            .ok_or_else(|| format!("{} was installed and does not run", self.name))
    }
}

fn install(folder: &Path, name: &str) -> std::process::Command {
    let mut install = cargo(["install", "--locked", "--root"]);
    install.arg(folder).arg(name);
    install
}

fn folder() -> PathBuf {
    target().join("tools")
}
