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

/// The compiler, its libraries and its sources; the names hold versions, which the compiler knows.
fn packages() -> Result<Vec<String>> {
    const COMPILER: &str = "rustc-web";
    let listed = Command::new("apt-cache")
        .args(["depends", COMPILER])
        .output()
        .map_err(|_| "this system has no Debian packages either".to_owned())?;
    let listed = String::from_utf8_lossy(&listed.stdout).into_owned();
    let needed = listed.lines().filter_map(|line| {
        let name = line.trim().strip_prefix("Depends: ")?;
        let is_ours = ["libstd-rust-web", "libllvm"]
            .iter()
            .any(|start| name.to_lowercase().starts_with(start));
        is_ours.then(|| name.to_owned())
    });
    let mut packages = vec![COMPILER.to_owned(), "rust-web-src".to_owned()];
    packages.extend(needed);
    if packages.len() == 2 {
        return Err(format!("Debian has no package {COMPILER} here"));
    }
    packages.push("libstd-rust-web-dev".to_owned());
    packages.sort();
    packages.dedup();
    Ok(packages)
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
