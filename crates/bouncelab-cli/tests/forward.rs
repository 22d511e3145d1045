//! `simulate`, `synth`, `paper` and `demo` as their users meet them.

use std::fs;

use assert_cmd::Command;
use predicates::prelude::*;
use serde_json::Value;
use tempfile::TempDir;

fn bouncelab(arguments: &[&str]) -> Command {
    let mut command = Command::cargo_bin("bouncelab").unwrap();
    command.args(arguments);
    command
}

fn json(command: &mut Command) -> Value {
    serde_json::from_slice(&command.output().unwrap().stdout).unwrap()
}

#[test]
fn simulate_prints_totals_and_bounces() {
    bouncelab(&["simulate", "--compare", "none"])
        .assert()
        .success()
        .stdout(
            predicate::str::contains("time until the end")
                .and(predicate::str::contains("standard curve of a sphere"))
                .and(predicate::str::contains("none"))
                .and(predicate::str::contains("Assumed")),
        );
}

/// Eq. 15 of the paper: 2.405 m/s, with its ball, air and gravity.
#[test]
fn simulate_reproduces_the_first_impact_of_the_paper() {
    let words = "simulate --ball table-tennis-38 --drag constant:0.4 --air-density 1.2276 --gravity 9.81 \
                 --no-buoyancy --no-added-mass --format json";
    let arguments: Vec<&str> = words.split_whitespace().collect();
    let result = json(&mut bouncelab(&arguments));
    assert_eq!(result["schema"], "bouncelab.simulation/2");
    let speed = result["simulations"][0]["bounces"][0]["impact_speed_m_s"]
        .as_f64()
        .unwrap();
    assert!((speed - 2.4053).abs() < 5e-5, "{speed}");
}

#[test]
fn simulate_writes_csv_and_a_figure() {
    let folder = TempDir::new().unwrap();
    let output = bouncelab(&["simulate", "--bounces", "3", "--format", "csv", "--figures"])
        .arg(folder.path())
        .output()
        .unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.starts_with("drag,number,time_s,"));
    assert_eq!(text.lines().count(), 4);
    assert!(folder.path().join("height.svg").exists() && folder.path().join("height.png").exists());
}

#[test]
fn absurd_drops_are_refused() {
    for (words, reason) in [
        ("--restitution 1.2", "restitution"),
        ("--height -1m", "height"),
        ("--mass -2.5g --diameter 38mm", "mass"),
        ("--mass 2.5g --diameter 0", "diameter"),
        ("--restitution 1 --drag none", "bounces"),
        ("--mass 1g --diameter 1m", "floats"),
        (
            "--ball football --height 10km --drag table:100=1,9000=0.4",
            "reynolds",
        ),
    ] {
        bouncelab(&["simulate", "--allow-implausible"])
            .args(words.split(' '))
            .assert()
            .code(2)
            .stderr(predicate::function(|text: &str| {
                text.to_lowercase().contains(reason)
            }));
    }
}

#[test]
fn synth_then_analyze_is_a_round_trip() {
    let folder = TempDir::new().unwrap();
    let (sound, truth) = (
        folder.path().join("drop.wav"),
        folder.path().join("truth.csv"),
    );
    bouncelab(&["synth", "--restitution", "0.9", "--truth"])
        .args([&truth, &sound])
        .assert()
        .success()
        .stdout(predicate::str::contains("impacts"));
    let times = |file| {
        let drops = json(bouncelab(&["analyze", "--format", "json"]).arg(file));
        let impacts = drops["drops"][0]["impacts"].as_array().unwrap().clone();
        impacts
            .iter()
            .map(|i| i["time_s"].as_f64().unwrap())
            .collect::<Vec<f64>>()
    };
    let (detected, true_times) = (times(&sound), times(&truth));
    assert_eq!(detected.len(), true_times.len());
    for (detected, truth) in detected.windows(2).zip(true_times.windows(2)) {
        assert!(((detected[1] - detected[0]) - (truth[1] - truth[0])).abs() < 5e-5);
    }
    let restitution = |file| {
        let result = json(bouncelab(&["analyze", "--format", "json"]).arg(file));
        result["drops"][0]["per_impact"]["restitution"]["value"]
            .as_f64()
            .unwrap()
    };
    assert!((restitution(&sound) / 0.9 - 1.0).abs() < 1e-3);
}

#[test]
fn synth_does_not_overwrite_and_says_where_it_cannot_write() {
    let folder = TempDir::new().unwrap();
    let sound = folder.path().join("drop.wav");
    fs::write(&sound, "precious").unwrap();
    bouncelab(&["synth"])
        .arg(&sound)
        .assert()
        .code(1)
        .stderr(predicate::str::contains("--force"));
    assert_eq!(fs::read_to_string(&sound).unwrap(), "precious");
    bouncelab(&["synth", "--force"])
        .arg(&sound)
        .assert()
        .success();
    bouncelab(&["synth"])
        .arg(sound.join("inside.wav"))
        .assert()
        .code(1)
        .stderr(predicate::str::contains("inside.wav"));
    bouncelab(&["synth", "--force"])
        .arg(folder.path().join("drop.mp3"))
        .assert()
        .code(2)
        .stderr(predicate::str::contains("ends in .wav"));
    fs::create_dir(folder.path().join("folder.wav")).unwrap();
    bouncelab(&["synth", "--force"])
        .arg(folder.path().join("folder.wav"))
        .assert()
        .code(1)
        .stderr(predicate::str::contains("is a folder"));
    bouncelab(&["synth", "--bounces", "0"])
        .arg(folder.path().join("one.wav"))
        .assert()
        .success()
        .stdout(predicate::str::contains(": 1 impact in "));
    bouncelab(&["synth", "--sample-rate", "10"])
        .arg(folder.path().join("slow.wav"))
        .assert()
        .code(2)
        .stderr(predicate::str::contains("Sample rate"));
    bouncelab(&["synth", "--voice", "violin", "x.wav"])
        .assert()
        .code(2)
        .stderr(predicate::str::contains("table-tennis"));
}

#[test]
fn the_same_seed_makes_the_same_recording() {
    let folder = TempDir::new().unwrap();
    let make = |name: &str, seed: &str| {
        let path = folder.path().join(name);
        bouncelab(&["synth", "--clicks", "2", "--lost", "10%", "--seed", seed])
            .arg(&path)
            .assert()
            .success();
        fs::read(path).unwrap()
    };
    assert!(make("a.wav", "5") == make("b.wav", "5"));
    assert!(make("c.wav", "5") != make("d.wav", "6"));
}

#[test]
fn paper_prints_the_numbers_and_draws_the_figures() {
    let folder = TempDir::new().unwrap();
    bouncelab(&["paper", "--figures"])
        .arg(folder.path())
        .assert()
        .success()
        .stdout(
            predicate::str::contains("misprint").and(predicate::str::contains("differs").not()),
        );
    // Each of six figures as SVG, PNG, PDF and CSV.
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 24);
    let result = json(&mut bouncelab(&[
        "paper",
        "--no-figures",
        "--format",
        "json",
    ]));
    assert_eq!(result["schema"], "bouncelab.paper/2");
    assert_eq!(result["facts"][0]["verdict"], "agrees");
}

#[test]
fn demo_recovers_the_drop_that_it_synthesised() {
    let folder = TempDir::new().unwrap();
    bouncelab(&["demo", "--output"])
        .arg(folder.path())
        .assert()
        .success()
        .stdout(predicate::str::contains("truth").and(predicate::str::contains("0.9529")));
    assert!(folder.path().join("demo.wav").exists());
    assert!(folder.path().join("demo-waveform.png").exists());
    bouncelab(&["demo", "--output"])
        .arg(folder.path().join("demo.wav/inside"))
        .assert()
        .code(1)
        .stderr(predicate::str::contains("folder"));
}

#[test]
fn every_command_explains_itself_with_examples() {
    for command in ["analyze", "simulate", "synth", "paper", "demo"] {
        bouncelab(&[command, "--help"])
            .assert()
            .success()
            .stdout(predicate::str::contains("Examples:").and(predicate::str::contains("Usage:")));
    }
    bouncelab(&[]).assert().code(2);
}

/// The endings of the two have nothing in common, so no file can be both.
#[test]
fn the_truth_does_not_overwrite_its_recording() {
    let folder = TempDir::new().unwrap();
    for name in ["drop.csv", "drop.wav"] {
        bouncelab(&["synth", name, "--truth", name, "--force"])
            .current_dir(&folder)
            .assert()
            .code(2)
            .stderr(predicate::str::contains("end"));
        assert!(!folder.path().join(name).exists());
    }
}
