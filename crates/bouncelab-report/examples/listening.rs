//! Draws the comparison of detectors from what `benchmarks/compare.py` printed.
//!
//! ```sh
//! cargo run -p bouncelab-report --example listening -- compare.txt FOLDER
//! ```

use std::collections::BTreeMap;
use std::path::PathBuf;

use bouncelab_report::figure::{self, Curve};
use bouncelab_report::save;
use bouncelab_report::theme::Meaning;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    let [table, folder] = arguments.as_slice() else {
        return Err("give the output of compare.py and a folder".into());
    };
    let curves = curves(&std::fs::read_to_string(table)?);
    let figure = figure::listening(&curves);
    let saved = save(&figure, folder, "listening")?;
    println!("{}\n    {}", saved.svg.display(), figure.caption());
    Ok(())
}

/// One curve for each detector: the mean over the balls at each ratio.
fn curves(text: &str) -> Vec<Curve> {
    let mut rows = text.lines().map(cells);
    let names = rows.find(|row| row.first() == Some(&"ball and noise"));
    let names = names.unwrap_or_default();
    // Of each detector the sum and the count at each ratio.
    let mut sums: Vec<BTreeMap<i32, (f64, f64)>> = vec![BTreeMap::new(); names.len()];
    for row in rows.take_while(|row| row.len() > 1) {
        let Some(ratio) = row[0].split(", ").nth(1).and_then(decibels) else {
            continue;
        };
        for (cell, sums) in row.iter().zip(&mut sums).skip(1) {
            if let Some(Ok(f1)) = cell.split(',').next().map(str::parse::<f64>) {
                let (sum, count) = sums.entry(ratio).or_default();
                *sum += f1;
                *count += 1.0;
            }
        }
    }
    let named = names.iter().zip(sums).enumerate().skip(1);
    named
        .map(|(place, (name, sums))| Curve {
            name: (*name).to_owned(),
            meaning: if place == 1 {
                Meaning::Measured
            } else {
                Meaning::NoDrag
            },
            points: sums
                .into_iter()
                .map(|(ratio, (sum, count))| (f64::from(ratio), sum / count))
                .collect(),
        })
        .collect()
}

fn decibels(text: &str) -> Option<i32> {
    text.strip_suffix(" dB")?.parse().ok()
}

/// The cells of a row of a table.
fn cells(line: &str) -> Vec<&str> {
    let inner = line.trim().trim_matches('|');
    inner.split('|').map(str::trim).collect()
}
