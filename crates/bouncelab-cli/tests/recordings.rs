//! Real recordings: impacts found, drops counted, nothing where nothing is.
//!
//! They are not part of the project. `BOUNCELAB_RECORDINGS` names a folder with them and a
//! `truth.json` of impact times. The tests compare the numbers that `docs/trust.md` and `docs/validation.md` quote.

use std::path::Path;

use assert_cmd::Command;
use bouncelab_testkit::recordings;
use serde_json::Value;
use tempfile::TempDir;

/// An impact is found if it is detected within this many seconds of the truth.
const TOLERANCE_S: f64 = 0.008;
/// A detector may rightly detect more impacts of a fading drop than the truth lists, for this many seconds.
const FADING_S: f64 = 1.2;

#[test]
#[ignore = "reads the recordings in BOUNCELAB_RECORDINGS"]
fn drops_in_real_recordings_are_found_and_none_is_invented() {
    let folder = recordings();
    let truth = std::fs::read(folder.join("truth.json")).expect("truth.json in the folder");
    let truth: Value = serde_json::from_slice(&truth).unwrap();
    let mut scores = Vec::new();
    for (name, recording) in truth["recordings"].as_object().unwrap() {
        let found = drops(&folder.join(name));
        let expected = recording["drops"].as_array().unwrap();
        if expected.is_empty() {
            assert!(
                found.is_empty(),
                "{name} holds no drop, but {} were found",
                found.len()
            );
            continue;
        }
        scores.push(Score::of(name, &found, expected));
    }
    let mean = mean(&scores, |score| score.f1);
    assert!(mean >= 0.93, "mean F1 {mean:.3}");
    let counted_right = scores.iter().filter(|score| score.found == score.drops);
    let counted_right = counted_right.count();
    assert!(
        counted_right + 1 >= scores.len(),
        "drops counted right in {counted_right}"
    );
    is_in_the_documents(&scores);
}

/// `docs/trust.md` has these scores of the recordings that it names, and their means if all of them exist.
fn is_in_the_documents(scores: &[Score]) {
    let page = document("trust");
    let (_, section) = page.split_once("\n## Real recordings\n").unwrap();
    let (section, _) = section.split_once("\n## ").unwrap();
    let rows: Vec<&str> = section
        .lines()
        .filter(|line| line.starts_with("| `"))
        .collect();
    let listed: Vec<&Score> = scores
        .iter()
        .filter(|score| section.contains(&format!("| `{}` |", score.name)))
        .collect();
    for score in &listed {
        assert!(rows.contains(&score.row().as_str()), "{}", score.row());
    }
    if listed.len() == rows.len() {
        let means = [
            |score: &&Score| score.f1,
            |score: &&Score| score.late_counted,
        ];
        let [f1, late_counted] = means.map(|of| mean(&listed, of));
        let row = format!("| mean | | | | {f1:.3} | {late_counted:.3} |");
        assert!(section.lines().any(|line| line == row), "{row}");
    }
}

fn mean<T>(scores: &[T], of: impl Fn(&T) -> f64) -> f64 {
    scores.iter().map(of).sum::<f64>() / scores.len() as f64
}

/// A recorder that started late: the drop from 1.50 m is missing its first impacts. The students
/// who recorded it took the first sound for the first bounce and found 57 cm.
#[test]
#[ignore = "reads the recordings in BOUNCELAB_RECORDINGS"]
fn a_late_start_is_noticed() {
    let output = Command::cargo_bin("bouncelab")
        .unwrap()
        .arg("analyze")
        .arg(recordings().join("tennis-late-start.wav"))
        .args("--ball tennis --height 1.50m --height-sd 1cm".split(' '))
        .args(["--format", "json"])
        .output()
        .unwrap();
    let result: Value = serde_json::from_slice(&output.stdout).unwrap();
    let missed = &result["drops"][0]["posterior"]["missed_first_impacts"];
    let two = missed[2].as_f64().unwrap();
    assert!(two > 0.8, "{missed}");
    let words: Vec<String> = document("validation")
        .split_whitespace()
        .map(str::to_owned)
        .collect();
    let quoted = format!(
        "two impacts were missed with a probability of {:.0} %",
        100.0 * two
    );
    assert!(words.join(" ").contains(&quoted), "{quoted}");
}

/// The table of `docs/validation.md` has the heights of the figure `truncation`.
#[test]
#[ignore = "reads the recordings in BOUNCELAB_RECORDINGS"]
fn the_heights_of_the_truncation_are_those_of_the_document() {
    let folder = TempDir::new().unwrap();
    let mut command = Command::cargo_bin("bouncelab").unwrap();
    command
        .arg("analyze")
        .arg(recordings().join("pingpong-long.wav"))
        .args(["--ball", "table-tennis-40", "--figures"])
        .arg(folder.path())
        .assert()
        .success();
    let figure = folder.path().join("pingpong-long-truncation.csv");
    let figure = std::fs::read_to_string(figure).unwrap();
    let height = |layer: &str, flights: u32| {
        let mut lines = figure.lines().filter(|line| line.contains(layer));
        let (_, rest) = lines
            .find_map(|line| line.split_once(&format!(",points,{flights},,")))
            .unwrap();
        let numbers: Vec<f64> = rest
            .split(',')
            .filter_map(|cell| cell.parse().ok())
            .collect();
        format!("{:.1} ± {:.1}", numbers[0], numbers[1])
    };
    let page = document("validation");
    for flights in [6, 10, 20, 40, 67] {
        let [fit, inference] = ["log-linear fit", "inference"].map(|layer| height(layer, flights));
        let row = format!("| {flights} | {fit} | {inference} |");
        assert!(page.lines().any(|line| line == row), "{row}");
    }
}

/// A page of the documents.
fn document(name: &str) -> String {
    let file = Path::new("../../docs").join(name).with_extension("md");
    std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(file)).unwrap()
}

/// The impact times of each drop that is found.
fn drops(file: &Path) -> Vec<Vec<f64>> {
    let mut command = Command::cargo_bin("bouncelab").unwrap();
    let output = command
        .args(["analyze", "--format", "json"])
        .arg(file)
        .output()
        .unwrap();
    let result: Value = serde_json::from_slice(&output.stdout).unwrap();
    let times = |drop: &Value| {
        list(&drop["impacts"], |impact| {
            impact["time_s"].as_f64().unwrap()
        })
    };
    list(&result["drops"], times)
}

fn list<T>(values: &Value, of: impl Fn(&Value) -> T) -> Vec<T> {
    values.as_array().into_iter().flatten().map(of).collect()
}

/// How well the drops of a recording are found.
struct Score {
    name: String,
    /// The number of drops in it, and of drops that are found.
    drops: usize,
    found: usize,
    /// The number of impacts that the truth lists, and of those that are reported.
    listed: usize,
    reported: usize,
    /// Harmonic mean of precision and recall, not counting impacts after the last listed one.
    f1: f64,
    /// The same, counting these as false.
    late_counted: f64,
}

impl Score {
    fn of(name: &str, found: &[Vec<f64>], drops: &[Value]) -> Self {
        let numbers = |values: &Value| list(values, |v| v.as_f64().unwrap());
        let listed: Vec<f64> = drops
            .iter()
            .flat_map(|drop| numbers(&drop["impacts_s"]))
            .collect();
        let mut unmatched = found.concat();
        let reported = unmatched.len();
        let mut matched = 0;
        for time_s in &listed {
            let near = |found: &f64| (found - time_s).abs() <= TOLERANCE_S;
            if let Some(index) = unmatched.iter().position(near) {
                unmatched.remove(index);
                matched += 1;
            }
        }
        for drop in drops {
            let optional = numbers(&drop["optional_s"]);
            unmatched.retain(|found| !optional.iter().any(|time_s| (found - time_s).abs() <= 0.02));
        }
        let with_late = unmatched.len();
        for drop in drops {
            let end_s = numbers(&drop["impacts_s"]).last().copied().unwrap();
            unmatched.retain(|&found| found <= end_s || found > end_s + FADING_S);
        }
        let f1 = |false_ones: usize| {
            let precision = f64::from(matched) / (f64::from(matched) + false_ones as f64);
            let recall = f64::from(matched) / listed.len() as f64;
            2.0 * precision * recall / (precision + recall)
        };
        Self {
            name: name.to_owned(),
            drops: drops.len(),
            found: found.len(),
            listed: listed.len(),
            reported,
            f1: f1(unmatched.len()),
            late_counted: f1(with_late),
        }
    }

    /// Its row in the table of `docs/trust.md`.
    fn row(&self) -> String {
        format!(
            "| `{}` | {} of {} | {} | {} | {:.3} | {:.3} |",
            self.name,
            self.found,
            self.drops,
            self.listed,
            self.reported,
            self.f1,
            self.late_counted
        )
    }
}
