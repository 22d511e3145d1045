//! Draws every figure with realistic data, into the folder given as argument: once as saved,
//! and once 480 pixels wide as on a phone.
//!
//! ```sh
//! cargo run -p bouncelab-report --example gallery -- FOLDER
//! ```

#![expect(clippy::print_stdout, reason = "it prints for contributors")]

use std::path::PathBuf;

use bouncelab_report::file::Outputs;
use bouncelab_report::messages::Translator;
use bouncelab_report::save;

#[path = "../tests/charts/mod.rs"]
mod charts;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args_os().nth(1).map(PathBuf::from);
    let folder = folder.ok_or("give a folder: cargo run --example gallery -- FOLDER")?;
    for (name, chart, _) in charts::all(&Translator::default()) {
        let saved = save(&chart, &folder, &name, &Outputs::default())?;
        std::fs::write(folder.join(format!("{name}-480.png")), chart.png(480)?)?;
        println!(
            "{}\n    {}",
            bouncelab::Plain::path(&saved.svg),
            chart.caption
        );
    }
    Ok(())
}
