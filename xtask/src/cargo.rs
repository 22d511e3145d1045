//! Running cargo, and other commands, in the root of the workspace.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use crate::{Result, file_error, steps};

/// The cargo that runs this task, in the root of the workspace.
pub(crate) fn cargo<'a>(words: impl IntoIterator<Item = &'a str>) -> Command {
    let program = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let mut command = Command::new(program);
    command.args(words).current_dir(root());
    command
}

/// The same work on everything that the checks build. All of them name the same packages and features,
/// so that nothing is compiled once for each.
pub(crate) fn cargo_all(work: &[&str]) -> Command {
    let mut command = cargo(work.iter().copied());
    command.arg("--workspace");
    if has_sound_headers() {
        command.args(MICROPHONE);
    }
    command
}

/// A program or an example, built as the tests of the workspace build it.
pub(crate) fn built(kind: &str, name: &str) -> Result<PathBuf> {
    // With a test, the features of all dependencies are those of the tests: nothing is compiled anew.
    run(cargo_all(&["build"]).args([kind, name, "--test", "tables"]))?;
    let folder = target().join("debug");
    let folder = if kind == "--example" {
        folder.join("examples")
    } else {
        folder
    };
    Ok(folder.join([name, std::env::consts::EXE_SUFFIX].concat()))
}

/// Copies the program from where it was built, without what a debugger needs; where it is then.
pub(crate) fn copy_program(built: &Path, folder: &Path) -> Result<PathBuf> {
    let name = ["bouncelab", std::env::consts::EXE_SUFFIX].concat();
    let program = folder.join(&name);
    fs::create_dir_all(folder).map_err(|reason| file_error(folder, &reason))?;
    fs::copy(built.join(name), &program).map_err(|reason| file_error(&program, &reason))?;
    succeeds(&["strip", &program.display().to_string()]);
    Ok(program)
}

/// Makes a folder, without what an earlier run left.
pub(crate) fn emptied(folder: &Path) -> Result {
    if folder.exists() {
        fs::remove_dir_all(folder).map_err(|reason| file_error(folder, &reason))?;
    }
    fs::create_dir_all(folder).map_err(|reason| file_error(folder, &reason))
}

/// The feature that not every system can build.
pub(crate) const MICROPHONE: [&str; 2] = ["--features", "bouncelab-cli/microphone"];

/// Whether the microphone can be built in: Linux needs the headers of ALSA.
pub(crate) fn has_sound_headers() -> bool {
    !cfg!(target_os = "linux") || succeeds(&["pkg-config", "--exists", "alsa"])
}

/// The same, now that they were installed if that was possible.
pub(crate) fn ensure_sound_headers() -> bool {
    has_sound_headers() || install(&["libasound2-dev", "pkg-config"], "the microphone")
}

/// Runs a command to its end, its output going where ours goes; how long it takes is noted.
pub(crate) fn run(command: &mut Command) -> Result {
    let name = command.get_program().display().to_string();
    let status = steps::run(command).map_err(|error| format!("cannot start {name}: {error}"))?;
    if status.success() {
        Ok(())
    } else {
        Err(format!("{name} ended with {status}"))
    }
}

/// Whether cargo knows this subcommand.
pub(crate) fn has(subcommand: &str) -> bool {
    let mut command = cargo([subcommand, "--version"]);
    is_silent_success(&mut command)
}

/// The root of the workspace.
pub(crate) fn root() -> &'static Path {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.parent().expect("xtask is a folder of the workspace")
}

/// Where cargo builds.
pub(crate) fn target() -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from)
}

/// Whether this runs as the administrator, who may install packages.
fn is_root() -> bool {
    let id = Command::new("id").arg("-u").output();
    id.is_ok_and(|id| id.stdout.trim_ascii() == b"0")
}

/// Installs packages of Debian where that is allowed; else says how to. Whether they are there then.
pub(crate) fn install(packages: &[&str], purpose: &str) -> bool {
    let mut words = vec!["apt-get", "install", "--yes", "--no-install-recommends"];
    words.extend(packages);
    let command = words.join(" ");
    println!("missing, for {purpose}: {command}");
    let installed = is_root() && succeeds(&["apt-get", "update"]) && succeeds(&words);
    if !installed {
        println!("they could not be installed. By hand, on Debian and Ubuntu: sudo {command}");
    }
    installed
}

/// Runs a command of the system without a word of it.
pub(crate) fn succeeds(words: &[&str]) -> bool {
    let mut command = Command::new(words[0]);
    is_silent_success(command.args(&words[1..]))
}

fn is_silent_success(command: &mut Command) -> bool {
    command.stdout(Stdio::null()).stderr(Stdio::null());
    command.status().is_ok_and(|status| status.success())
}
