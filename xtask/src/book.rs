//! `cargo xtask book` and the check `book`: the documents as a book, static pages with a search.
//!
//! That its commands run, its links lead somewhere, and its figures and its reference are those of the program, is
//! tested by `crates/bouncelab-cli/tests/book.rs`.

use std::path::PathBuf;
use std::process::Command;

use crate::Result;
use crate::cargo::{cargo_all, root, run as run_command, succeeds, target};

pub(crate) const ABOUT: &str = "Draw the figures of the book, write its reference, and build it into target/book (needs mdBook)";

/// The chore.
pub(crate) fn run(_: &[String]) -> Result {
    let mut write = cargo_all(&["test"]);
    run_command(
        write
            .args(["--test", "book"])
            .env("BOUNCELAB_BOOK", "write"),
    )?;
    if !has_mdbook() {
        return Err("the book is not built for want of mdBook".into());
    }
    build().map(|folder| println!("made in {}", folder.display()))
}

/// Whether mdBook is there, which takes minutes to compile.
pub(crate) fn has_mdbook() -> bool {
    let is_there = succeeds(&["mdbook", "--version"]);
    if !is_there {
        println!("mdBook is not installed: cargo install mdbook --locked");
    }
    is_there
}

/// Builds the book of what is there.
pub(crate) fn build() -> Result<PathBuf> {
    let folder = target().join("book");
    let mut build = Command::new("mdbook");
    build
        .arg("build")
        .arg(root())
        .arg("--dest-dir")
        .arg(&folder);
    run_command(&mut build)?;
    Ok(folder)
}
