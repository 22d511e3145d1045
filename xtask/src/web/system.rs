//! What the machine must have for the page: a compiler for WebAssembly, Node.js, a browser.

use std::process::Command;

use crate::Result;
use crate::cargo::{is_root, succeeds};

/// The oldest Node.js on which the tools of the page run.
const OLDEST_NODE: (u32, u32) = (20, 19);

/// Whether the compiler has this target; rustup may add it.
pub(super) fn has_target(target: &str) -> bool {
    let listed = Command::new("rustup")
        .args(["target", "list", "--installed"])
        .output();
    let is_listed = listed.is_ok_and(|listed| {
        let listed = String::from_utf8_lossy(&listed.stdout).into_owned();
        listed.lines().any(|line| line.trim() == target)
    });
    is_listed || {
        println!("the compiler lacks {target}, adding it: rustup target add {target}");
        succeeds(&["rustup", "target", "add", target])
    }
}

/// Whether there is a Node.js that is new enough.
pub(crate) fn has_node() -> bool {
    need_node().is_ok()
}

pub(super) fn need_node() -> Result {
    let (major, minor) = OLDEST_NODE;
    let advice = format!(
        "the page is built with Node.js {major}.{minor} or later and its npm: install it from your \
         system's packages or https://nodejs.org"
    );
    let version = Command::new("node").arg("--version").output();
    let version = version.map_err(|_| format!("there is no Node.js here; {advice}"))?;
    let version = String::from_utf8_lossy(&version.stdout).trim().to_owned();
    let mut numbers = version.trim_start_matches('v').split('.');
    let mut number = || numbers.next().and_then(|number| number.parse::<u32>().ok());
    match (number(), number()) {
        (Some(found_major), Some(found_minor)) if (found_major, found_minor) >= OLDEST_NODE => {
            Ok(())
        }
        _ => Err(format!("Node.js is {version} here; {advice}")),
    }
}

/// Where browsers lie that the end-to-end tests can use.
const BROWSERS: [&str; 4] = [
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
];

const INSTALL: [&str; 5] = [
    "apt-get",
    "install",
    "--yes",
    "--no-install-recommends",
    "chromium",
];

/// Whether there is a Chromium: it is installed where that is allowed, else it is said how to.
pub(crate) fn has_chromium() -> bool {
    match need_chromium() {
        Ok(()) => true,
        Err(reason) => {
            println!("{reason}");
            false
        }
    }
}

pub(super) fn need_chromium() -> Result {
    let is_there = || BROWSERS.iter().any(|name| succeeds(&[name, "--version"]));
    if std::env::var_os("BOUNCELAB_CHROMIUM").is_some() || is_there() {
        return Ok(());
    }
    let words = INSTALL.join(" ");
    println!("there is no Chromium, for the end-to-end tests of the page: {words}");
    let installed = is_root() && succeeds(&["apt-get", "update"]) && succeeds(&INSTALL);
    if installed && is_there() {
        return Ok(());
    }
    Err(format!(
        "Chromium could not be installed: install it by hand (Debian: sudo {words}), or name one in \
         BOUNCELAB_CHROMIUM"
    ))
}
