//! Has the program compiled again once the page has been built that it contains: of files that were not there, the
//! compiler does not know.

use std::path::Path;

fn main() {
    let page = "../../web/dist/index.html";
    let watched = if Path::new(page).exists() {
        page
    } else {
        "../../web"
    };
    println!("cargo::rerun-if-changed={watched}");
}
