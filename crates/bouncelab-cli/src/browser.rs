//! A browser that prints pages as PDF, tagged and with its fonts.

use std::ffi::{OsStr, OsString};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use bouncelab::Plain;

use crate::failure::Failure;
use crate::language::text_with;

/// Names of Chromium and its relatives, which print alike.
const NAMES: [&str; 7] = [
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
    "chrome",
    "microsoft-edge",
    "msedge",
];

/// Where they are if not on the path.
const PLACES: [&str; 5] = [
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "/Applications/Chromium.app/Contents/MacOS/Chromium",
    "/Applications/Microsoft Edge.app/Contents/MacOS/Microsoft Edge",
    r"C:\Program Files\Google\Chrome\Application\chrome.exe",
    r"C:\Program Files (x86)\Microsoft\Edge\Application\msedge.exe",
];

/// An installed Chromium, Chrome or Edge.
pub(crate) struct Browser(PathBuf);

impl Browser {
    /// The first that is found.
    pub(crate) fn find() -> Option<Self> {
        let paths = std::env::var_os("PATH").unwrap_or_default();
        let folders: Vec<PathBuf> = std::env::split_paths(&paths).collect();
        let named = NAMES.iter().flat_map(|name| {
            let file = format!("{name}{}", std::env::consts::EXE_SUFFIX);
            folders.iter().map(move |folder| folder.join(&file))
        });
        let mut places = named.chain(PLACES.iter().map(PathBuf::from));
        places.find(|path| path.is_file()).map(Self)
    }

    /// A page as PDF. The browser gets it from a file, in a profile of its own, and may load nothing else.
    pub(crate) fn print(&self, html: &str) -> Result<Vec<u8>, Failure> {
        let folder = tempfile::tempdir()?;
        let (page, pdf) = (
            folder.path().join("page.html"),
            folder.path().join("page.pdf"),
        );
        // Without a size it takes Letter, wherever it is.
        fs::write(
            &page,
            html.replacen("</style>", "@page { size: A4; }</style>", 1),
        )?;
        let mut command = Command::new(&self.0);
        command
            .args([
                "--headless",
                "--disable-gpu",
                "--no-first-run",
                "--no-pdf-header-footer",
            ])
            .arg(option("--user-data-dir=", &folder.path().join("profile")))
            .arg(option("--print-to-pdf=", &pdf));
        #[cfg(target_os = "linux")]
        if rustix::process::geteuid().is_root() {
            // It refuses to start as root otherwise. The page has no scripts.
            command.arg("--no-sandbox");
        }
        let output = command.arg(&page).stdin(Stdio::null()).output();
        let failed = |reason: &str| {
            let words = [
                ("browser", String::from(Plain::path(&self.0)).into()),
                ("reason", String::from(Plain::of(reason)).into()),
            ];
            Failure::Input(text_with("terminal-not-printed", &words))
        };
        let output = output.map_err(|reason| failed(&reason.to_string()))?;
        fs::read(&pdf).map_err(|_| {
            let said = String::from_utf8_lossy(&output.stderr);
            failed(said.lines().last().unwrap_or_default())
        })
    }
}

/// An option with a path, which need not be text.
fn option(name: &str, path: &Path) -> OsString {
    [OsStr::new(name), path.as_os_str()].into_iter().collect()
}
