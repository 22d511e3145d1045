//! Draws the detection benchmark: from what `benchmarks/compare.py` printed, the comparison of
//! detectors; from what `cargo xtask detection timing` printed, the errors of the times.
//!
//! ```sh
//! cargo run -p bouncelab-report --example listening -- TABLE FOLDER
//! ```

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use bouncelab_report::Chart;
use bouncelab_report::figure::{self, Curve, Detection};
use bouncelab_report::file::Outputs;
use bouncelab_report::messages::Translator;
use bouncelab_report::save;
use bouncelab_report::theme::Meaning;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<PathBuf> = std::env::args_os().skip(1).map(PathBuf::from).collect();
    let [table, folder] = arguments.as_slice() else {
        return Err("give a table and a folder".into());
    };
    let table = std::fs::read_to_string(table)?;
    let translator = Translator::english();
    if let Some((table, lateness)) = table.split_once("| ball | level |") {
        let timing = balls(table, 4, &[("the bound:", 1.0), ("the goal: at most", 2.0)]);
        draw(
            &figure::detection(Detection::Timing, &timing, &translator),
            folder,
            "timing",
        )?;
        let stated = balls(table, 5, &[("the goal: from", 60.0), ("to", 76.0)]);
        draw(
            &figure::detection(Detection::Stated, &stated, &translator),
            folder,
            "stated",
        )?;
        return draw(
            &figure::detection(Detection::Late, &late(lateness), &translator),
            folder,
            "late",
        );
    }
    let found = detectors(&table);
    draw(
        &figure::detection(Detection::Found, &found, &translator),
        folder,
        "listening",
    )
}

fn draw(chart: &Chart, folder: &Path, name: &str) -> Result<(), Box<dyn std::error::Error>> {
    let saved = save(chart, folder, name, &Outputs::default())?;
    println!(
        "{}\n    {}",
        bouncelab::Plain::path(&saved.svg),
        chart.caption
    );
    Ok(())
}

/// One curve for each ball from a column of the table of timing, and a level line for each limit.
fn balls(text: &str, column: usize, limits: &[(&str, f64)]) -> Vec<Curve> {
    let mut curves: Vec<Curve> = Vec::new();
    for row in text.lines().map(cells) {
        let point = row.get(1).and_then(|cell| decibels(cell)).zip(
            row.get(column)
                .and_then(|cell| cell.split(' ').next()?.parse().ok()),
        );
        let Some((ratio, value)) = point else {
            continue;
        };
        let point = [f64::from(ratio), value];
        let name = row[0].replace('-', " ");
        match curves.iter_mut().find(|curve| curve.name == name) {
            Some(curve) => curve.points.push(point),
            None => curves.push(Curve {
                name,
                meaning: Meaning::Measured,
                points: vec![point],
            }),
        }
    }
    let ends = curves.first().map_or_else(Vec::new, |curve| {
        curve.points.iter().map(|point| point[0]).collect()
    });
    curves.extend(limits.iter().map(|&(name, level)| Curve {
        name: format!("{name} {level}"),
        meaning: Meaning::Plain,
        points: ends.iter().map(|&ratio| [ratio, level]).collect(),
    }));
    curves
}

/// How late a bright and a dull ball are found, by bouncelab and by the first sample above a fixed
/// level.
fn late(text: &str) -> Vec<Curve> {
    /// A median of fewer impacts says little.
    const FEWEST: u32 = 20;
    let curve = |ball: &str, column: usize, by: &str, meaning| {
        let rows = text.lines().map(cells).filter(|row| row[0] == ball);
        let points = rows.filter_map(|row| {
            let count: u32 = row.get(2)?.parse().ok()?;
            let late_us: f64 = row.get(column)?.strip_suffix(" us")?.parse().ok()?;
            (count >= FEWEST).then_some([f64::from(decibels(row[1])?), late_us])
        });
        Curve {
            name: format!("{}, {by}", ball.replace('-', " ")),
            meaning,
            points: points.collect(),
        }
    };
    let by_both =
        |column, by, meaning| ["table-tennis", "tennis"].map(|b| curve(b, column, by, meaning));
    [
        by_both(3, "whole sound", Meaning::Measured),
        by_both(4, "fixed level", Meaning::Plain),
    ]
    .concat()
}

/// One curve for each detector: the mean over the balls at each ratio.
fn detectors(text: &str) -> Vec<Curve> {
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
                Meaning::Plain
            },
            points: sums
                .into_iter()
                .map(|(ratio, (sum, count))| [f64::from(ratio), sum / count])
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
