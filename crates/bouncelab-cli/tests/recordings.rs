//! Real recordings: impacts found, drops counted, nothing where nothing is.
//!
//! They are not part of the project. `BOUNCELAB_RECORDINGS` names a folder with them and a
//! `truth.json` of impact times.

use std::path::Path;

use assert_cmd::Command;
use bouncelab_testkit::recordings;
use serde_json::Value;

/// An impact is found if it is heard within this many seconds of the truth.
const TOLERANCE_S: f64 = 0.008;
/// A detector may rightly hear more of a fading drop than the truth lists.
const FADING_S: f64 = 1.2;

#[test]
#[ignore = "reads the recordings in BOUNCELAB_RECORDINGS"]
fn drops_in_real_recordings_are_found_and_none_is_invented() {
    let folder = recordings();
    let truth = std::fs::read(folder.join("truth.json")).expect("truth.json in the folder");
    let truth: Value = serde_json::from_slice(&truth).unwrap();
    let (mut scores, mut counted_right, mut with_drops) = (Vec::new(), 0, 0);
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
        let score = f1(&found.concat(), expected);
        eprintln!(
            "{name}: {} drops of {}, F1 {score:.3}",
            found.len(),
            expected.len()
        );
        with_drops += 1;
        counted_right += usize::from(found.len() == expected.len());
        scores.push(score);
    }
    let mean = scores.iter().sum::<f64>() / scores.len() as f64;
    assert!(mean >= 0.93, "mean F1 {mean:.3}");
    assert!(
        counted_right + 1 >= with_drops,
        "drops counted right in {counted_right}"
    );
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
        .args([
            "--ball",
            "tennis",
            "--height",
            "1.50m",
            "--height-sd",
            "1cm",
        ])
        .args(["--format", "json"])
        .output()
        .unwrap();
    let result: Value = serde_json::from_slice(&output.stdout).unwrap();
    let missed = &result["drops"][0]["posterior"]["missed_first_impacts"];
    assert!(missed[2].as_f64().unwrap() > 0.8, "{missed}");
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

/// Harmonic mean of precision and recall over a whole recording.
fn f1(found: &[f64], drops: &[Value]) -> f64 {
    let numbers = |values: &Value| list(values, |v| v.as_f64().unwrap());
    let mut unmatched = found.to_vec();
    let mut matched = 0;
    let mut expected = 0;
    for drop in drops {
        for time_s in numbers(&drop["impacts_s"]) {
            expected += 1;
            let near = |found: &f64| (found - time_s).abs() <= TOLERANCE_S;
            if let Some(index) = unmatched.iter().position(near) {
                unmatched.remove(index);
                matched += 1;
            }
        }
    }
    for drop in drops {
        let end_s = numbers(&drop["impacts_s"]).last().copied().unwrap();
        let optional = numbers(&drop["optional_s"]);
        let fading = |found: f64| found > end_s && found <= end_s + FADING_S;
        let is_optional = |found: f64| optional.iter().any(|time_s| (found - time_s).abs() <= 0.02);
        unmatched.retain(|&found| !fading(found) && !is_optional(found));
    }
    let precision = f64::from(matched) / (f64::from(matched) + unmatched.len() as f64);
    let recall = f64::from(matched) / f64::from(expected);
    2.0 * precision * recall / (precision + recall)
}
