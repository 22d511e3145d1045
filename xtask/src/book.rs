//! `cargo xtask book` and the check `book`: the documents as a book, static pages with a search.
//!
//! That its commands run, its links lead somewhere, and its figures and its reference are those of the program, is
//! tested by `crates/bouncelab-cli/tests/book`.

use std::process::Command;

use crate::cargo::{cargo_all, root, run as run_command, target};
use crate::steps::skip;
use crate::{Result, python, web};

pub(crate) const ABOUT: &str = "Draw the figures of the book, take its pictures, write its reference, and build it into target/book";

/// The task.
pub(crate) fn run(_: &[String]) -> Result {
    let mut write = cargo_all(&["test"]);
    run_command(
        write
            .args(["--test", "book"])
            .env("BOUNCELAB_BOOK", "write"),
    )?;
    take_pictures()?;
    build()
}

/// The pictures of the page and of a notebook, as a browser shows them.
fn take_pictures() -> Result {
    if !(web::has_node() && web::has_browser()) {
        skip("the pictures of the page and of a notebook: Node.js or a browser is missing");
        return Ok(());
    }
    let notebook = if python::interpreters().is_empty() {
        skip(&format!("the picture of a notebook: {}", python::MISSING));
        None
    } else {
        Some(python::notebook()?)
    };
    web::pictures(notebook.as_deref())
}

/// Builds the book of what is there: the check.
pub(crate) fn build() -> Result {
    let mdbook = python::program("mdbook").ok_or("there is no mdBook")?;
    let folder = target().join("book");
    let mut build = Command::new(mdbook);
    build.arg("build").arg(root()).arg("--dest-dir");
    run_command(build.arg(&folder))?;
    if python::interpreters().is_empty() {
        skip(&format!("the reference of Python: {}", python::MISSING));
    } else {
        python::reference(&folder.join("python-reference"))?;
    }
    println!("made in {}", folder.display());
    Ok(())
}
