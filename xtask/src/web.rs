//! `cargo xtask web`: the browser laboratory, from the sources to `web/dist`.

mod debian;
mod e2e;
mod system;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use crate::cargo::{built, cargo, root, run as run_command};
use crate::steps::skip;
use crate::{Result, file_error, notices};

pub(crate) use e2e::{class, firefox, pictures, run as e2e, webkit};
pub(crate) use system::{has_browser, has_firefox, has_node, has_target, has_webkit};

pub(crate) const ABOUT: &str = "Build the page into web/dist; or only its engine; or the package for other pages; or check it; or run its end-to-end tests";

const TARGET: &str = "wasm32-unknown-unknown";

/// Builds `engine` (the WebAssembly), the whole page (no word), runs `check` (types, lints, unit
/// tests) or `e2e` (the end-to-end tests, in a real browser).
pub(crate) fn run(words: &[String]) -> Result {
    system::need_node()?;
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    match words[..] {
        [] => build(),
        ["engine"] => engine(),
        ["package"] => package().map(|packed| println!("made {}", packed.display())),
        ["check"] => check(),
        ["e2e", ref words @ ..] => e2e(words),
        _ => Err(format!(
            "\"{}\" is none of engine, package, check, e2e",
            words.join(" ")
        )),
    }
}

/// The whole page, and how large it is.
pub(crate) fn build() -> Result {
    page()?;
    npm(&["run", "size"])
}

/// Built once, however many checks want it.
fn page() -> Result {
    static MADE: OnceLock<Result> = OnceLock::new();
    let make = || engine().and_then(|()| npm(&["run", "build"]));
    MADE.get_or_init(make).clone()
}

/// The package of npm for pages of others, packed into the target folder.
pub(crate) fn package() -> Result<PathBuf> {
    engine()?;
    unpacked()?;
    npm(&[
        "pack",
        "./package",
        "--pack-destination",
        &target().display().to_string(),
    ])?;
    Ok(target().join(concat!("bouncelab-", env!("CARGO_PKG_VERSION"), ".tgz")))
}

/// What the package holds, in its folder; made once, however many checks want it.
fn unpacked() -> Result {
    static MADE: OnceLock<Result> = OnceLock::new();
    MADE.get_or_init(make_package).clone()
}

fn make_package() -> Result {
    let folder = web().join("package");
    for licence in ["LICENSE-MIT", "LICENSE-APACHE"] {
        fs::copy(root().join(licence), folder.join(licence))
            .map_err(|reason| file_error(&folder, &reason))?;
    }
    notices::write(&folder)?;
    npm(&["run", "package"])
}

/// Every check of the page that needs no browser.
pub(crate) fn check() -> Result {
    engine()?;
    lint()?;
    npm(&["run", "check"])?;
    npm(&["run", "lint"])?;
    npm(&["run", "test"])?;
    audit()
}

/// What is known against the packages takes a registry that tells it; not every mirror does.
fn audit() -> Result {
    let words = ["audit", "--package-lock-only", "--json"];
    let made = npm_command(&words).output();
    let made = made.map_err(|reason| format!("npm audit: {reason}"))?;
    let report = String::from_utf8_lossy(&made.stdout);
    if !report.contains("\"auditReportVersion\"") {
        skip("advisories on the npm packages: no registry answers");
        return Ok(());
    }
    if made.status.success() {
        return Ok(());
    }
    Err(format!("npm audit found something:\n{report}"))
}

/// What the page loads: the science at once, the decoders when a file is opened.
const PARTS: [&str; 2] = ["engine", "decoders"];

/// Where the page looks for the science.
pub(crate) const ENGINE: &str = "src/lab/engine";

/// Compiles the science for the browser and puts it where the page looks for it: once, however many
/// checks want it. Cargo knows whether the science has changed since the last run, and what follows
/// depends on its result.
///
/// Binaryen's `wasm-opt` is left out: `-Oz` makes these bytes a tenth fewer, but orders functions and
/// locals so that they compress worse, by 5 % in the end; without that it gains 1 %.
fn engine() -> Result {
    static MADE: OnceLock<Result> = OnceLock::new();
    MADE.get_or_init(make_engine).clone()
}

fn make_engine() -> Result {
    modules()?;
    let folder = web().join(ENGINE);
    fs::create_dir_all(&folder).map_err(|reason| file_error(&folder, &reason))?;
    for part in PARTS {
        let compiled = compile(part)?;
        let stamp = target().join(format!("{part}.wasm"));
        let made = folder.join(format!("{part}_bg.wasm"));
        if same_content(&compiled, &stamp) && made.is_file() {
            continue;
        }
        run_command(
            Command::new(bindgen()?)
                .arg(&compiled)
                .arg(&folder)
                .arg(part),
        )?;
        fs::copy(&compiled, &stamp).map_err(|reason| file_error(&stamp, &reason))?;
    }
    types(&folder.join("types.ts"))
}

/// Writes the types of what the engine takes and gives.
fn types(file: &Path) -> Result {
    let program = built("--example", "types")?;
    let made = Command::new(&program).output();
    let made = made.map_err(|reason| file_error(&program, &reason))?;
    fs::write(file, made.stdout).map_err(|reason| file_error(file, &reason))
}

/// Compiles a part of the science as WebAssembly.
fn compile(part: &str) -> Result<PathBuf> {
    let mut command = for_the_browser("build", part);
    if !system::has_target(TARGET) {
        println!("rustup has no {TARGET} here: trying the compiler of Debian");
        debian::set_up(&mut command, &target().join("debian"))?;
    }
    run_command(&mut command)?;
    Ok(target().join(TARGET).join("web/bouncelab_wasm.wasm"))
}

/// Looks at the code that exists in the browser only; Debian's compiler comes without clippy.
fn lint() -> Result {
    if !system::has_target(TARGET) {
        println!(
            "without the target {TARGET} of rustup, clippy sees nothing of the browser's part"
        );
        return Ok(());
    }
    let mut command = for_the_browser("clippy", &PARTS.join(","));
    run_command(command.args(["--no-deps", "--", "-D", "warnings"]))
}

/// Cargo at work on parts of the science for the browser, in a target folder of its own: another
/// profile and another target would only push the usual build out of it.
fn for_the_browser(work: &str, parts: &str) -> Command {
    let mut command = cargo([work, "--package", "bouncelab-wasm", "--profile", "web"]);
    command.args(["--features", parts, "--target", TARGET, "--target-dir"]);
    command.arg(target());
    // Every browser of the last years computes with four numbers at once.
    command.env("RUSTFLAGS", "-C target-feature=+simd128");
    command
}

/// The tool that makes the JavaScript side, built once.
fn bindgen() -> Result<PathBuf> {
    let folder = target().join("bindgen");
    let mut command = cargo(["build", "--locked", "--manifest-path"]);
    command.arg(root().join("xtask/bindgen/Cargo.toml"));
    run_command(command.arg("--target-dir").arg(&folder))?;
    Ok(folder.join("debug/bindgen"))
}

/// Installs what the page is built with, if it is not what the lock file says.
fn modules() -> Result {
    let lock = web().join("package-lock.json");
    let stamp = web().join("node_modules/.installed-from.json");
    if same_content(&lock, &stamp) {
        return Ok(());
    }
    run_command(npm_command(&["ci", "--no-audit", "--no-fund"]).current_dir(web()))?;
    fs::copy(&lock, &stamp)
        .map(drop)
        .map_err(|reason| file_error(&stamp, &reason))
}

fn npm(words: &[&str]) -> Result {
    run_command(&mut npm_command(words))
}

fn npm_command(words: &[&str]) -> Command {
    let mut command = Command::new("npm");
    command.args(words).current_dir(web());
    command
}

pub(crate) fn web() -> PathBuf {
    root().join("web")
}

fn target() -> PathBuf {
    crate::cargo::target().join("web")
}

fn same_content(a: &Path, b: &Path) -> bool {
    matches!((fs::read(a), fs::read(b)), (Ok(a), Ok(b)) if a == b)
}
