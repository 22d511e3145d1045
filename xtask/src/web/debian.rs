//! A compiler for WebAssembly from Debian's packages, where rustup cannot fetch a target.
//!
//! The packages are unpacked into a folder of their own: installing them would push out Debian's
//! ordinary compiler. Only `rustc` and the sources of the standard library come from there; cargo
//! is the usual one, and builds the standard library along.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::Result;
use crate::cargo::{run as run_command, succeeds};

const ADVICE: &str = "install the target by hand (rustup target add wasm32-unknown-unknown), or \
                      build on a machine that has it";

/// Makes this build use that compiler.
pub(super) fn set_up(build: &mut Command, folder: &Path) -> Result {
    let compiler = folder.join("usr/bin/rustc");
    if !compiler.is_file() {
        unpack(folder).map_err(|reason| format!("{reason}; {ADVICE}"))?;
    }
    let libraries = folder.join("usr/lib/x86_64-linux-gnu");
    // The compiler finds its own sources and libraries beside itself.
    build
        .env("RUSTC", compiler)
        .env("LD_LIBRARY_PATH", libraries)
        // Only an unstable option builds the standard library, and this compiler is a stable one.
        .env("RUSTC_BOOTSTRAP", "1")
        .env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER", linker()?)
        .arg("-Zbuild-std=std,panic_abort");
    Ok(())
}

/// Downloads the compiler and unpacks it.
fn unpack(folder: &Path) -> Result {
    let packages = packages()?;
    let downloads = folder.join("packages");
    fs::create_dir_all(&downloads).map_err(|reason| reason.to_string())?;
    let mut download = Command::new("apt-get");
    download.arg("download").args(&packages);
    run_command(download.current_dir(&downloads))?;
    for package in fs::read_dir(&downloads).map_err(|reason| reason.to_string())? {
        let package = package.map_err(|reason| reason.to_string())?.path();
        run_command(Command::new("dpkg").arg("-x").arg(package).arg(folder))?;
    }
    Ok(())
}

/// The compiler, its libraries and its sources. The names of some hold versions, so it is asked what
/// the compiler needs.
fn packages() -> Result<Vec<String>> {
    const COMPILER: &str = "rustc-web";
    /// What ordinary systems lack of what it needs.
    const LIBRARIES: [&str; 4] = ["libstd-rust-web", "libllvm", "libz3", "libedit"];
    let mut ask = Command::new("apt-cache");
    ask.args(["depends", "--recurse", "--no-recommends", "--no-suggests"]);
    ask.args([
        "--no-conflicts",
        "--no-breaks",
        "--no-replaces",
        "--no-enhances",
    ]);
    let listed = ask.arg(COMPILER).output();
    let listed = listed.map_err(|_| "this system has no packages of Debian either".to_owned())?;
    let listed = String::from_utf8_lossy(&listed.stdout).into_owned();
    let is_ours = |name: &&str| LIBRARIES.iter().any(|start| name.starts_with(start));
    let libraries: Vec<String> = listed.lines().filter(is_ours).map(str::to_owned).collect();
    if libraries.is_empty() {
        return Err(format!("Debian has no package {COMPILER} here"));
    }
    let own = [COMPILER, "rust-web-src"].map(str::to_owned);
    Ok(own.into_iter().chain(libraries).collect())
}

/// The linker: the one that comes with rustup's compiler, or LLVM's.
fn linker() -> Result<PathBuf> {
    let sysroot = Command::new("rustc").args(["--print", "sysroot"]).output();
    if let Ok(sysroot) = sysroot {
        let sysroot = String::from_utf8_lossy(&sysroot.stdout).trim().to_owned();
        let own = Path::new(&sysroot).join("lib/rustlib/x86_64-unknown-linux-gnu/bin/rust-lld");
        if own.is_file() {
            return Ok(own);
        }
    }
    ["wasm-ld", "wasm-ld-19"]
        .into_iter()
        .find(|name| succeeds(&[name, "--version"]))
        .map(PathBuf::from)
        .ok_or_else(|| "there is no linker for WebAssembly: install lld".to_owned())
}
