//! Makes the message files part of the crate: every folder in `messages/` is a language.
//!
//! What the page in a browser says by itself, it reads by itself. The engine in a browser gets English
//! only, without what a terminal says; the page loads the other languages when a reader chooses them.

#![expect(clippy::disallowed_methods, reason = "names of files of the project")]

use std::env;
use std::fmt::Write as _;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

const OF_PAGE: &str = "page.ftl";
const OF_TERMINAL: &str = "terminal.ftl";

fn main() -> io::Result<()> {
    println!("cargo::rerun-if-changed=messages");
    let folder =
        Path::new(&env::var("CARGO_MANIFEST_DIR").expect("cargo names it")).join("messages");
    let browser = env::var("CARGO_CFG_TARGET_FAMILY").is_ok_and(|family| family == "wasm");
    let mut code = "&[".to_owned();
    for language in sorted(&folder)? {
        let name = file_name(&language);
        if browser && name != "en" {
            continue;
        }
        write!(code, "({name:?}, &[").expect("a string takes all");
        for file in sorted(&language)? {
            let name = file_name(&file);
            if name != OF_PAGE && !(browser && name == OF_TERMINAL) {
                write!(code, "include_str!(r#\"{}\"#), ", file.display())
                    .expect("a string takes all");
            }
        }
        code.push_str("]), ");
    }
    code.push(']');
    let out = Path::new(&env::var("OUT_DIR").expect("cargo names it")).join("messages.rs");
    fs::write(out, code)
}

fn sorted(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut paths = fs::read_dir(folder)?
        .map(|entry| Ok(entry?.path()))
        .collect::<io::Result<Vec<_>>>()?;
    paths.sort();
    Ok(paths)
}

fn file_name(path: &Path) -> &str {
    path.file_name()
        .and_then(|name| name.to_str())
        .expect("names of languages and files are plain")
}
