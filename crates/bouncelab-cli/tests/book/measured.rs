//! The figures of what takes minutes or hours to measure are those of the tables that the measuring commands printed.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use bouncelab_report::Chart;
use bouncelab_report::figure::{self, Curve, Detection, RankHistogram};
use bouncelab_report::messages::Translator;
use bouncelab_report::theme::Meaning;

use super::{Page, docs, made};

fn is_made(name: &str, chart: &Chart) {
    let path = Path::new("images").join(name).with_extension("svg");
    made(&path, chart.svg().as_bytes());
}

/// The tables are in the page, as `cargo xtask detection timing` and `benchmarks/compare.py` print them.
#[test]
fn figures_of_detection_are_those_of_its_tables() {
    let page = Page::read("listening.md".into());
    let table = |heading: &str| {
        let from = page.text.find(heading);
        let from = from.unwrap_or_else(|| panic!("no table {heading}"));
        let lines = page.text[from..].lines();
        let lines = lines.take_while(|line| line.starts_with('|'));
        lines.map(cells).collect::<Vec<_>>()
    };
    let timing = table("| ball | noise | flights |");
    let bounds = [("the bound:", 1.0), ("the goal: at most", 2.0)];
    let shares = [("the goal: from", 60.0), ("to", 76.0)];
    let lateness = late(&table("| ball | level | late |"));
    let found = detectors(&table("| ball and noise | bouncelab |"));
    for (name, what, curves) in [
        ("timing", Detection::Timing, balls(&timing, 4, &bounds)),
        ("stated", Detection::Stated, balls(&timing, 5, &shares)),
        ("late", Detection::Late, lateness),
        ("listening", Detection::Found, found),
    ] {
        let chart = figure::detection(what, &curves, &Translator::english());
        is_made(name, &chart);
    }
}

/// The table is what `cargo xtask calibrate 4000 docs/images` writes.
#[test]
fn the_figure_of_calibration_is_that_of_its_table() {
    let table = fs::read_to_string(docs().join("images/calibration.csv")).unwrap();
    let histograms = table.lines().skip(1).map(|line| {
        let mut cells = line.split(',');
        RankHistogram {
            scenario: cells.next().unwrap().to_owned(),
            quantity: cells.next().unwrap().to_owned(),
            bins: cells.map(|cell| cell.parse().unwrap()).collect(),
        }
    });
    let histograms: Vec<RankHistogram> = histograms.collect();
    let chart = figure::calibration(&histograms, &Translator::english());
    is_made("calibration", &chart);
}

/// One curve for each ball from a column of the table of timing, and a level line for each limit.
fn balls(rows: &[Vec<&str>], column: usize, limits: &[(&str, f64)]) -> Vec<Curve> {
    let mut curves: Vec<Curve> = Vec::new();
    for row in rows {
        let Some(ratio) = decibels(row[1]) else {
            continue;
        };
        let value = row[column].split(' ').next().unwrap();
        let point = [f64::from(ratio), value.parse().unwrap()];
        match curves.iter_mut().find(|curve| curve.name == row[0]) {
            Some(curve) => curve.points.push(point),
            None => curves.push(Curve {
                name: row[0].to_owned(),
                meaning: Meaning::Measured,
                points: vec![point],
            }),
        }
    }
    let ends: Vec<f64> = curves[0].points.iter().map(|point| point[0]).collect();
    curves.extend(limits.iter().map(|&(name, level)| Curve {
        name: format!("{name} {level}"),
        meaning: Meaning::Plain,
        points: ends.iter().map(|&ratio| [ratio, level]).collect(),
    }));
    curves
}

/// How late a bright and a dull ball are found, by bouncelab and by the first sample above a fixed
/// level.
fn late(rows: &[Vec<&str>]) -> Vec<Curve> {
    let curve = |ball: &str, column: usize, by: &str, meaning| {
        let rows = rows.iter().filter(|row| row[0] == ball);
        let points = rows.map(|row| {
            let late_us = row[column].strip_suffix(" us").unwrap();
            [
                f64::from(decibels(row[1]).unwrap()),
                late_us.parse().unwrap(),
            ]
        });
        Curve {
            name: format!("{ball}, {by}"),
            meaning,
            points: points.collect(),
        }
    };
    let by_both = |column, by, meaning| {
        ["table tennis", "tennis ball"].map(|ball| curve(ball, column, by, meaning))
    };
    [
        by_both(2, "whole sound", Meaning::Measured),
        by_both(3, "fixed level", Meaning::Plain),
    ]
    .concat()
}

/// One curve for each detector: the mean over the balls at each ratio.
fn detectors(rows: &[Vec<&str>]) -> Vec<Curve> {
    let names = &rows[0];
    // Of each detector the sum and the count at each ratio.
    let mut sums: Vec<BTreeMap<i32, (f64, f64)>> = vec![BTreeMap::new(); names.len()];
    let of_balls = rows.iter().skip(2).map_while(|row| {
        let (_, noise) = row[0].split_once(", ")?;
        Some((decibels(noise)?, row))
    });
    for (ratio, row) in of_balls {
        for (cell, sums) in row.iter().zip(&mut sums).skip(1) {
            let f1: f64 = cell.split(',').next().unwrap().parse().unwrap();
            let (sum, count) = sums.entry(ratio).or_default();
            *sum += f1;
            *count += 1.0;
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
