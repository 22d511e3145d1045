//! Every command questions a value that looks like a mistake of units.

use std::path::PathBuf;

use assert_cmd::Command;
use predicates::prelude::*;
use predicates::str::contains;
use tempfile::TempDir;

fn bouncelab() -> Command {
    Command::cargo_bin("bouncelab").unwrap()
}

/// A recording of a table-tennis ball from 30.5 cm.
fn recording(folder: &TempDir) -> PathBuf {
    let file = folder.path().join("drop.wav");
    bouncelab().arg("synth").arg(&file).assert().success();
    file
}

#[test]
fn arguments_are_questioned_with_a_guess() {
    let slips: [(&[&str], &str); 13] = [
        (&["--height", "30.5m"], "30.5 m? Did you mean 30.5 cm?"),
        (&["--height", "305m"], "305 m? Did you mean 305 cm?"),
        (&["--mass", "2.5kg", "--diameter", "38mm"], "2.5 g?"),
        (&["--mass", "2.5g", "--diameter", "38m"], "38 mm?"),
        (
            &["--temperature", "293C"],
            "293 \u{b0}C? Did you mean 293 K?",
        ),
        (&["--temperature", "70"], "70 \u{b0}C? Did you mean 70 F?"),
        (&["--pressure", "101325hPa"], "101325 Pa?"),
        (&["--humidity", "45"], "45 %?"),
        (&["--contact-time", "1s"], "1 ms?"),
        (&["--ball", "steel:10"], "10 m? Did you mean 10 mm?"),
        (&["--ball", "tennis", "--mass", "58"], "58 g?"),
        (&["--at-speed", "1e6m/s"], "1000000 m/s?"),
        (&["--reach", "2:28m"], "28 m? Did you mean 28 cm?"),
    ];
    for (arguments, inference) in slips {
        // No file is looked at before.
        bouncelab()
            .args(["analyze", "nowhere.wav"])
            .args(arguments)
            .assert()
            .code(2)
            .stderr(contains(inference).and(contains("--allow-implausible")));
    }
}

#[test]
fn every_command_asks() {
    let commands: [&[&str]; 6] = [
        &["analyze", "a.wav"],
        &["verdict", "--rule", "ittf-ball", "a.wav"],
        &["session", "recordings"],
        &["listen", "--from", "a.wav"],
        &["simulate"],
        &["synth", "a.wav"],
    ];
    for command in commands {
        bouncelab()
            .args(command)
            .args(["--height", "30.5m"])
            .assert()
            .code(2)
            .stderr(contains("Did you mean 30.5 cm?"));
    }
}

#[test]
fn implausible_values_can_be_allowed() {
    bouncelab()
        .args(["simulate", "--height", "100m", "--allow-implausible"])
        .assert()
        .success();
}

/// Ten times the height is ordinary by itself, and enough missed impacts might explain it; but the
/// decimal point is a better explanation.
#[test]
fn a_recording_knows_a_wrong_height() {
    let folder = TempDir::new().unwrap();
    let file = recording(&folder);
    let said = |height: &str| {
        let mut command = bouncelab();
        let command = command.arg("analyze").arg(&file).args(["--draws", "200"]);
        let output = command.args(["--height", height]).output().unwrap();
        String::from_utf8(output.stdout).unwrap()
    };
    for slip in ["3.05m", "3.05cm"] {
        assert!(said(slip).contains("; 30.5"), "{slip}");
    }
    for right in ["30.5cm", "33cm", "27cm"] {
        assert!(!said(right).contains("may be meant"), "{right}");
    }
}
