//! Writes the lesson sheets into the folder given as argument, in every language.
//!
//! ```sh
//! cargo run -p bouncelab-report --example sheets -- docs/lessons
//! ```

use std::path::PathBuf;

use bouncelab_report::messages::{Translator, languages};
use bouncelab_report::sheets::Sheet;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args_os().nth(1).map(PathBuf::from);
    let folder = folder.ok_or("give a folder: cargo run --example sheets -- FOLDER")?;
    std::fs::create_dir_all(&folder)?;
    for language in languages() {
        let translator = Translator::new(language).ok_or("a language has no messages")?;
        for sheet in Sheet::ALL {
            let name = format!("{}.{language}.html", sheet.name());
            std::fs::write(folder.join(name), sheet.html(None, &translator)?)?;
        }
    }
    Ok(())
}
