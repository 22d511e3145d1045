//! Makes the message files part of the crate: every folder in `messages/` is a language.
//!
//! A browser gets English only, without what a terminal or the page itself says; it loads the other
//! languages when a reader chooses them.

use std::env;
use std::fmt::Write as _;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// What the engine in a browser has no use for.
const OF_FRONT_ENDS: [&str; 2] = ["page.ftl", "terminal.ftl"];

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
            if !(browser && OF_FRONT_ENDS.contains(&file_name(&file))) {
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
