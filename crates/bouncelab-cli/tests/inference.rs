//! The inference as the users of `bouncelab analyze` meet it.

use std::fs;
use std::path::PathBuf;

use assert_cmd::Command;
use predicates::prelude::*;
use serde_json::Value;
use tempfile::TempDir;

/// Schwarz, Vogt and Kuhn (2013), a ball dropped from 0.7 m: they found g = 9.82 m/s².
const SCHWARZ: &str = "0.248\n0.955\n1.617\n";

/// Flight times of the paper's ball with constant e = 0.9529 and drag, s, recomputed independently.
const PAPER: [f64; 10] = [
    0.4605, 0.4272, 0.3977, 0.3714, 0.3477, 0.3263, 0.3067, 0.2887, 0.2722, 0.2569,
];

fn bouncelab() -> Command {
    Command::cargo_bin("bouncelab").unwrap()
}

fn written(folder: &TempDir, text: &str) -> PathBuf {
    let path = folder.path().join("times.txt");
    fs::write(&path, text).unwrap();
    path
}

fn paper_times() -> String {
    let mut time_s = 0.0;
    let times = PAPER.map(|flight_s| {
        time_s += flight_s;
        format!("{time_s:.4}")
    });
    format!("0\n{}\n", times.join("\n"))
}

fn posterior(text: &str, arguments: &str) -> Value {
    let folder = TempDir::new().unwrap();
    let output = bouncelab()
        .arg("analyze")
        .arg(written(&folder, text))
        .args(["--format", "json"])
        .args(arguments.split_whitespace())
        .output()
        .unwrap();
    let result: Value = serde_json::from_slice(&output.stdout).unwrap();
    result["drops"][0]["posterior"].clone()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

/// The paths that other programs rely on, each with value, sd and intervals that hold the value.
#[test]
fn the_fixed_paths_of_the_document() {
    let found = posterior(&paper_times(), "--height 30.5cm");
    for path in ["restitution", "drop_height_m", "drag_coefficient"] {
        let quantity = &found[path];
        let value = number(&quantity["value"]);
        assert!(number(&quantity["sd"]) > 0.0);
        for interval in ["interval68", "interval95"] {
            let [low, high] = [0, 1].map(|end| number(&quantity[interval][end]));
            assert!(low < value && value < high, "{path} {interval}");
        }
    }
    let missed = found["missed_first_impacts"].as_array().unwrap();
    let sum: f64 = missed.iter().map(number).sum();
    assert!((sum - 1.0).abs() < 1e-9);
}

/// The paper's ball, without buoyancy and contact as there: the inference finds e and the height
/// that the log-linear fit misses by 1.7 cm.
#[test]
fn the_papers_drop_is_found_again() {
    let found = posterior(
        &paper_times(),
        "--mass 2.5g --diameter 38mm --drag constant:0.4 --air-density 1.2276kg/m3 --no-buoyancy \
         --no-added-mass --contact-time 0 --gravity 9.81 --law constant",
    );
    let within = |path: &str, truth: f64| {
        let off = (number(&found[path]["value"]) - truth).abs();
        assert!(off < 2.0 * number(&found[path]["sd"]), "{path}: {off}");
    };
    within("restitution", 0.9529);
    within("drop_height_m", 0.305);
    assert!((number(&found["restitution"]["value"]) - 0.9529).abs() < 5e-4);
    assert!((number(&found["drop_height_m"]["value"]) - 0.305).abs() < 0.004);
    assert!(found["missed_first_impacts"].is_null());
}

/// Without air and contact, as their authors reckoned.
#[test]
fn gravity_from_published_times() {
    // The uncertainty is 0.6: of the usual draws, the value scatters over seeds by nearly the bound.
    let found = posterior(
        SCHWARZ,
        "--height 0.7m --infer gravity --drag none --contact-time 0 --law constant --draws 8000",
    );
    let g = number(&found["gravity_m_s2"]["value"]);
    assert!((g / 9.82 - 1.0).abs() < 1e-3, "{g}");
}

#[test]
fn predictions_and_stated_speeds() {
    let found = posterior(
        &paper_times(),
        "--reach 2:20cm --reach 1:5m --at-speed 2m/s",
    );
    assert!((number(&found["at_speed_m_s"]) - 2.0).abs() < 1e-12);
    let predictions = found["predictions"].as_array().unwrap();
    assert_eq!(predictions.len(), 2);
    assert!(number(&predictions[0]["drop_height_m"]["value"]) > 0.2);
}

/// What can be said of few or wrong times, and why no more.
#[test]
fn bad_input_is_answered() {
    for (times, status, words) in [
        ("", 1, "empty"),
        ("1.0\n", 1, "fewer"),
        ("0.3\n0.86\n", 0, "too few impacts"),
        ("0.3\n0.86\n1.36\n", 0, "a single restitution"),
        ("time_ms\n0\n460\n888\n1285\n1657\n", 0, "cm"),
        ("0.3\n0.86\n0.86\n1.2\n", 1, "0.86"),
        ("0.3\n1.2\n0.86\n1.5\n", 1, "0.86"),
        ("0\n460\n888\n1285\n1657\n", 1, "milliseconds"),
        ("0\n0.2\n0.45\n0.78\n1.2\n", 1, "do not get shorter"),
    ] {
        let folder = TempDir::new().unwrap();
        let output = bouncelab()
            .arg("analyze")
            .arg(written(&folder, times))
            .output()
            .unwrap();
        let said = String::from_utf8_lossy(&output.stdout).into_owned()
            + &String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(status), "{times:?}: {said}");
        assert!(said.contains(words), "{times:?}: {said}");
    }
}

#[test]
fn a_contradicting_height_is_named() {
    let folder = TempDir::new().unwrap();
    bouncelab()
        .arg("analyze")
        .arg(written(&folder, &paper_times()))
        .args(["--height", "15cm"])
        .assert()
        .success()
        .stdout(predicate::str::contains("contradict"));
}

#[test]
fn wrong_arguments_are_refused() {
    for arguments in [
        ["--law", "elastic"],
        ["--reach", "28cm"],
        ["--height", "30.5kg"],
        ["--height", "-1m"],
        ["--infer", "mass"],
        ["--draws", "1"],
    ] {
        let folder = TempDir::new().unwrap();
        bouncelab()
            .arg("analyze")
            .arg(written(&folder, &paper_times()))
            .args(arguments)
            .assert()
            .failure()
            .code(2);
    }
}

/// With few draws each model still has enough to judge its sampling by.
#[test]
fn few_draws_have_a_shape() {
    let folder = TempDir::new().unwrap();
    for times in ["0\n1.4538\n2.0717\n2.6314\n", "-5\n-3.3745\n"] {
        let file = folder.path().join("times.txt");
        fs::write(&file, times).unwrap();
        bouncelab()
            .arg("analyze")
            .arg(&file)
            .args(["--draws", "100", "--details", "--height", "0.95m"])
            .assert()
            .success()
            .stdout(predicate::str::contains("Pareto shape inf").not());
    }
}

#[test]
fn an_impact_before_time_zero_can_be_left_out() {
    let folder = TempDir::new().unwrap();
    let file = folder.path().join("times.txt");
    fs::write(&file, "-1\n-0.5\n-0.05\n0.36\n0.72\n").unwrap();
    bouncelab()
        .arg("analyze")
        .arg(&file)
        .args(["--no-inference", "--exclude", "-0.5"])
        .assert()
        .success()
        .stdout(predicate::str::contains("Drop: 4 impacts"));
}

/// What contradicts each other is not settled by chance: both are named.
#[test]
fn contradictions_are_refused() {
    for (arguments, words) in [
        ("--known mass=1%,mass=2%", "mass twice"),
        (
            "--known drag=1% --infer drag",
            "Infer drag and known drag contradict",
        ),
        ("--infer drag --drag none", "drag none"),
        ("--infer drag --air-density 0", "air density 0"),
        (
            "--infer contact-time --contact-time 0",
            "contact time of exactly 0",
        ),
        ("--no-inference --reach 2:28cm", "--reach"),
        ("--no-inference --infer drag", "--infer"),
    ] {
        bouncelab()
            .args(["analyze", "nowhere.txt"])
            .args(arguments.split(' '))
            .assert()
            .code(2)
            .stderr(predicate::str::contains(words));
    }
}

/// Without an inference nothing can leave the ball open.
#[test]
fn a_ball_that_is_not_stated_is_left_open_by_the_inference_alone() {
    let folder = TempDir::new().unwrap();
    let said = |arguments: &[&str]| {
        let mut analyze = bouncelab();
        analyze
            .arg("analyze")
            .arg(written(&folder, &paper_times()))
            .args(arguments);
        let output = analyze.assert().success().get_output().stdout.clone();
        let text = String::from_utf8(output).unwrap();
        ["The ball was not stated", "The ball is table tennis 40+"].map(|it| text.contains(it))
    };
    assert_eq!(said(&[]), [true, false]);
    assert_eq!(said(&["--no-inference"]), [false, true]);
    assert_eq!(said(&["--ball", "tennis"]), [false, false]);
}
