//! Figures and summaries of long measurements are those of the tables that the measuring commands printed.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

use bouncelab_report::Chart;
use bouncelab_report::figure::{self, Curve, Detection, RankHistogram};
use bouncelab_report::messages::Translator;
use bouncelab_report::theme::Meaning;
use bouncelab_testkit::damage::Damage;

use super::{Page, docs, made, name, readme};

fn is_made(name: &str, chart: &Chart) {
    let path = Path::new("images").join(name).with_extension("svg");
    made(&path, chart.svg().as_bytes());
}

/// A table of `docs/tables`, as a measuring command printed it: a heading, a line, and rows.
fn table(name: &str) -> String {
    let file = Path::new("tables").join(name).with_extension("txt");
    fs::read_to_string(docs().join(&file)).unwrap_or_else(|reason| panic!("{name}: {reason}"))
}

/// The rows of a table or of a part of a page.
fn rows(text: &str) -> Vec<Vec<&str>> {
    let lines = text.lines().filter(|line| line.starts_with('|'));
    lines.map(cells).collect()
}

/// The tables are those of `cargo xtask detection timing` and `benchmarks/compare.py`.
#[test]
fn figures_of_detection_are_those_of_its_tables() {
    let [timing, late_by, found_by] = ["timing", "late", "detectors"].map(table);
    let timing = rows(&timing);
    let bounds = [("the bound:", 1.0), ("the goal: at most", 2.0)];
    let shares = [("the goal: from", 60.0), ("to", 76.0)];
    let lateness = late(&rows(&late_by));
    let found = detectors(&rows(&found_by));
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

/// The cells after the first of the row of a page that begins with `start`.
fn row<'a>(page: &'a Page, start: &str) -> Vec<&'a str> {
    let line = page.text.lines().find(|line| line.starts_with(start));
    let line = line.unwrap_or_else(|| panic!("{}: no row {start}", name(&page.path)));
    cells(line).split_off(1)
}

/// For each quantity of a scenario, the percentages of the 68 % and of the 95 % intervals that contain the truth.
fn coverage<'a>(table: &'a str, scenario: &str) -> Vec<[&'a str; 2]> {
    let rows = rows(table).into_iter().filter(|row| row[0] == scenario);
    rows.map(|row| [row[3], row[4]]).collect()
}

/// Pages repeat the numbers of the tables, and of each other, unchanged.
#[test]
fn summaries_have_the_numbers_of_the_tables() {
    let page = |name: &str| Page::read(name.into());
    let (trust, inference) = (page("trust.md"), page("validation.md"));
    let detection = page("listening.md");

    for (name, quote, after) in [("calibration", "", " |"), ("scenarios", "`", ":")] {
        let table = table(name);
        let scenarios: BTreeSet<&str> = rows(&table)[2..].iter().map(|row| row[0]).collect();
        for scenario in scenarios {
            let coverage = coverage(&table, scenario);
            let pairs: Vec<String> = coverage.iter().map(|both| both.join(", ")).collect();
            let of_95: Vec<&str> = coverage.iter().map(|both| both[1]).collect();
            let start = format!("| {scenario} | {}", pairs[0]);
            assert_eq!(row(&inference, &start)[..pairs.len()], pairs);
            let start = format!("| {quote}{scenario}{quote}{after}");
            assert_eq!(row(&trust, &start), of_95);
        }
    }
    let verdicts = table("verdicts");
    for measured in rows(&verdicts)
        .into_iter()
        .filter(|row| row[0] == "height" && row[2] == "5")
    {
        let here = row(&trust, &format!("| {} |", measured[1]));
        assert_eq!(here, measured[4..], "{}", measured[1]);
    }
    let balls = table("balls");
    for dropped_from in ["0.3 to 1.5 m", "2.5 m"] {
        let wrong = rows(&balls)
            .into_iter()
            .filter(|row| row[0] == dropped_from && row[1] != "table tennis 40+");
        let unnoticed: Vec<u32> = wrong.map(|row| row[7].parse().unwrap()).collect();
        let drops = 12 * unnoticed.len() as u32;
        let noticed = drops - unnoticed.iter().sum::<u32>();
        let here = row(&trust, &format!("| {dropped_from} |"));
        assert_eq!(here, [drops, noticed].map(|count| count.to_string()));
    }

    let detectors = table("detectors");
    let detectors = rows(&detectors);
    let mean = detectors.iter().find(|row| row[0].starts_with("mean of"));
    assert_eq!(
        row(&trust, "| synthesised, from 10 dB up |"),
        mean.unwrap()[1..]
    );
    assert_eq!(
        row(&detection, "| mean of the 42 cells"),
        mean.unwrap()[1..]
    );
    let mixtures = row(&detection, "| mean (133) |");
    assert_eq!(row(&trust, "| mixtures of real sounds |"), mixtures);
    let noise = row(&detection, "| mean |");
    assert_eq!(row(&trust, "| mean of four balls |"), noise);

    let damage = table("damage");
    let all = rows(&damage).pop().unwrap().split_off(1);
    for (kind, all) in Damage::ALL.iter().zip(all) {
        let kind = format!("| {} |", kind.words());
        assert_eq!(row(&trust, &kind).join(" · "), all, "{kind}");
    }

    let [f1, late_counted] = row(&trust, "| mean | | | |")[3..] else {
        panic!("the mean of the recordings has no F1")
    };
    let bouncelab = mean.unwrap()[1];
    let all_cells = "The mean over all cells of 10 dB and more is ";
    let (_, after) = detection.text.split_once(all_cells).unwrap();
    let f1_of_cells = after.split([',', ' ']).next().unwrap();
    let answer = format!("Nearly all from 10 dB up, F1 {f1_of_cells} ");
    assert!(trust.text.contains(&answer), "trust.md: {answer}");
    let quoted = [
        format!("F1 {f1_of_cells} from 10 dB up"),
        format!("mean F1 is {f1}, and {late_counted} if"),
        format!("bouncelab reaches {bouncelab},"),
        format!("{:.2} at\n  5 dB", noise[1].parse::<f64>().unwrap()),
    ];
    for words in quoted {
        assert!(readme().text.contains(&words), "README.md: {words}");
    }
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
        .map(|(index, (name, sums))| Curve {
            name: (*name).to_owned(),
            meaning: if index == 1 {
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
