//! What the machine must have for the page: a compiler for WebAssembly, Node.js, a browser.

use std::fs;
use std::path::Path;
use std::process::Command;

use crate::Result;
use crate::cargo::{install, succeeds};

/// The oldest Node.js on which the tools of the page run.
const OLDEST_NODE: (u32, u32) = (20, 19);

/// Whether the compiler has this target; rustup may add it.
pub(crate) fn has_target(target: &str) -> bool {
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

/// How browsers are called that the end-to-end tests can use.
const BROWSERS: [&str; 4] = [
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
];

/// The fonts with which the layout is tested, as Debian calls their packages: those that a Chromium
/// brings along, and those that it recommends. `web/tests/harness/fonts.ts` says what is in them.
const FONTS: [(&str, &str); 2] = [
    ("fonts-dejavu-core", "DejaVuSans.ttf"),
    ("fonts-liberation", "LiberationSans-Regular.ttf"),
];

/// Whether there is a Chromium: it is installed where that is allowed, else the command is printed. So are the
/// fonts; without them the tests skip what takes them.
pub(crate) fn has_browser() -> bool {
    let is_there = || BROWSERS.iter().any(|name| succeeds(&[name, "--version"]));
    if std::env::var_os("BOUNCELAB_CHROMIUM").is_none() && !is_there() {
        let installed = install(&["chromium"], "the end-to-end tests of the page") && is_there();
        if !installed {
            println!("there is no Chromium; one can be named in BOUNCELAB_CHROMIUM");
            return false;
        }
    }
    let missing: Vec<&str> = FONTS
        .iter()
        .filter(|(_, file)| !has_font(Path::new("/usr/share/fonts"), file))
        .map(|(package, _)| *package)
        .collect();
    if cfg!(target_os = "linux") && !missing.is_empty() {
        install(&missing, "the layout of the page with several fonts");
    }
    true
}

/// Debian's Firefox.
pub(super) const FIREFOX: &str = "/usr/bin/firefox-esr";

/// Whether there is a Firefox, and a sound server without which it cannot listen; they are installed where that is
/// allowed.
pub(crate) fn has_firefox() -> bool {
    let are_there = || {
        [FIREFOX, "pulseaudio"]
            .iter()
            .all(|name| succeeds(&[name, "--version"]))
    };
    let packages = ["firefox-esr", "pulseaudio"];
    are_there() || install(&packages, "the end-to-end tests in Firefox") && are_there()
}

/// Whether there is `WebKitGTK` with what drives it, and a screen without hardware; they are installed where that is
/// allowed.
pub(crate) fn has_webkit() -> bool {
    let are_there = || {
        ["WebKitWebDriver", "Xvfb"]
            .iter()
            .all(|name| succeeds(&["sh", "-c", &format!("command -v {name}")]))
    };
    let packages = ["webkit2gtk-driver", "xvfb"];
    cfg!(target_os = "linux")
        && (are_there() || install(&packages, "the page in WebKit") && are_there())
}

fn has_font(folder: &Path, file: &str) -> bool {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    entries.map(|entry| entry.path()).any(|path| {
        path.file_name().is_some_and(|name| name == file) || path.is_dir() && has_font(&path, file)
    })
}
