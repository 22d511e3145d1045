//! Detected, missed and false impacts, for each combination of scene and background (a cell).

use super::drops::{Cell, Recording, cells};
use super::reliability::Reliability;
use crate::held::median;
use bouncelab::detection::Detection;

/// An impact is found if the times agree within this, in seconds, after the middle of the errors
/// of the drop is taken out: the sound of a soft ball begins after first contact.
const SAME_S: f64 = 0.003;
const SAME_BEFORE_S: f64 = 0.008;

/// Counts of one cell.
#[derive(Default)]
struct Tally {
    audible: usize,
    found: usize,
    made_up: usize,
    drops: usize,
    detected: usize,
    false_drops: usize,
    errors_s: Vec<f64>,
}

pub(crate) fn print(drops: u64) {
    let mut group = "";
    let mut reliability = Reliability::default();
    for cell in cells() {
        if cell.group != group {
            group = cell.group;
            println!(
                "\n| {group} | F1 | precision | recall | drops detected | false drops | median error |"
            );
            println!("|---|---|---|---|---|---|---|");
        }
        println!("{}", row(&cell, drops, &mut reliability));
    }
    reliability.print("drops of all cells");
}

fn row(cell: &Cell, drops: u64, reliability: &mut Reliability) -> String {
    let mut tally = Tally::default();
    for seed in 0..drops {
        let recording = cell.record(seed);
        tally.add(&recording, &recording.detect(), reliability);
    }
    if tally.audible == 0 {
        let Tally {
            drops,
            detected,
            false_drops,
            ..
        } = tally;
        return format!(
            "| {} | - | - | - | {detected}/{drops} | {false_drops} | - |",
            cell.name
        );
    }
    let precision = share(tally.found, tally.found + tally.made_up);
    let recall = share(tally.found.min(tally.audible), tally.audible);
    let f1 = 2.0 * precision * recall / (precision + recall).max(1e-9);
    format!(
        "| {} | {f1:.3} | {precision:.3} | {recall:.3} | {}/{} | {} | {} |",
        cell.name,
        tally.detected,
        tally.drops,
        tally.false_drops,
        median(tally.errors_s).map_or("-".into(), |e| format!("{:.1} us", 1e6 * e)),
    )
}

/// `part` of `whole`, 1 if there is nothing.
fn share(part: usize, whole: usize) -> f64 {
    if whole == 0 {
        1.0
    } else {
        part as f64 / whole as f64
    }
}

impl Tally {
    fn add(&mut self, recording: &Recording, detection: &Detection, reliability: &mut Reliability) {
        let truth: Vec<f64> = recording.sound.impacts.iter().map(|i| i.time_s).collect();
        let audible = recording.audible();
        self.audible += audible.len();
        self.drops += 1;
        let trains = &detection.found.trains;
        let is_true =
            |start_s: f64, end_s: f64| truth.iter().any(|t| (start_s..=end_s).contains(t));
        let true_trains = trains
            .iter()
            .filter(|t| is_true(t.start_s(), t.end_s()))
            .count();
        self.false_drops += trains.len() - true_trains;
        self.detected += usize::from(true_trains == 1);
        for train in trains {
            let errors: Vec<f64> = train
                .impacts()
                .iter()
                .filter_map(|impact| nearest(&truth, impact.onset.time_s))
                .collect();
            self.made_up += train.impacts().len() - errors.len();
            reliability.add(train, errors.len());
            let Some(middle) = median(errors) else {
                continue;
            };
            for impact in train.impacts() {
                let near = nearest(&audible, impact.onset.time_s);
                if let Some(error) = near.filter(|e| (e - middle).abs() < SAME_S) {
                    self.found += 1;
                    self.errors_s.push((error - middle).abs());
                }
            }
        }
    }
}

/// Distance from the nearest true time, if it is near.
fn nearest(truth: &[f64], time_s: f64) -> Option<f64> {
    let errors = truth.iter().map(|t| time_s - t);
    errors
        .min_by(|a, b| a.abs().total_cmp(&b.abs()))
        .filter(|e| e.abs() < SAME_BEFORE_S)
}
