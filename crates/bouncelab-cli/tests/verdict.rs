//! `bouncelab verdict` and `bouncelab rules`, as their users meet them.

mod support;

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use predicates::prelude::*;
use serde_json::Value;
use support::write_simulated_times;
use tempfile::TempDir;

fn bouncelab() -> Command {
    Command::cargo_bin("bouncelab").unwrap()
}

/// Impact times of a simulated drop, as a list.
fn drop(folder: &Path, name: &str, height: &str, restitution: &str) {
    let arguments = [
        "--height",
        height,
        "--restitution",
        restitution,
        "--bounces",
        "25",
    ];
    // As somebody would read them off.
    write_simulated_times(&folder.join(name), &arguments, 4);
}

fn verdict(folder: &TempDir, arguments: &[&str]) -> Command {
    let mut command = bouncelab();
    command
        .current_dir(folder)
        .args(["verdict", "--draws", "500"])
        .args(arguments);
    command
}

/// e = 0.935 rebounds to 25 cm, e = 0.90 to 23 cm (the drag-free e² h, less 3 % for the fall).
#[test]
fn a_ball_conforms_or_not_with_its_exit_status() {
    let folder = TempDir::new().unwrap();
    drop(folder.path(), "good.txt", "30.5cm", "0.935");
    drop(folder.path(), "dull.txt", "30.5cm", "0.9");
    let shown = ["--height", "30.5cm", "--kept", "surface"];
    verdict(
        &folder,
        &[&["--rule", "ittf-ball", "good.txt"], &shown[..]].concat(),
    )
    .assert()
    .code(0)
    .stdout(predicate::str::contains("\nCONFORMS. Within the limits"));
    verdict(
        &folder,
        &["--rule", "ittf-ball", "good.txt", "--kept", "weather"],
    )
    .assert()
    .code(2)
    .stderr(predicate::str::contains("weather"));
    verdict(&folder, &["--rule", "ittf-ball", "good.txt"])
        .assert()
        .code(5)
        .stdout(predicate::str::contains(
            "CONFORMS AS FAR AS SHOWN. Within the limits",
        ))
        .stdout(predicate::str::contains("steel block  not shown"))
        .stdout(predicate::str::contains("JCGM 106"))
        .stdout(predicate::str::contains(
            "The ball is table tennis 40+, as in the rule",
        ));
    verdict(&folder, &["--rule", "ittf-ball", "dull.txt"])
        .assert()
        .code(3)
        .stdout(predicate::str::contains("DOES NOT CONFORM."));
}

#[test]
fn the_document_has_the_verdict_and_its_reasons() {
    let folder = TempDir::new().unwrap();
    drop(folder.path(), "good.txt", "30.5cm", "0.935");
    let output = verdict(
        &folder,
        &["--rule", "ittf-ball", "good.txt", "--format", "json"],
    )
    .output()
    .unwrap();
    let document: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(document["schema"], "bouncelab.verdict/4");
    assert_eq!(document["outcome"], "conforms-as-far-as-shown");
    assert_eq!(document["rule"]["source"]["read"], "secondary");
    assert_eq!(document["decision"]["risk"], 0.05);
    assert!(document["probability_wrong_accept"].as_f64().unwrap() <= 0.05);
    let drop = &document["drops"][0];
    let sum: f64 = document["budget"]
        .as_array()
        .unwrap()
        .iter()
        .map(|part| part["correction_m"].as_f64().unwrap())
        .sum();
    let plain = drop["drag_free_m"].as_f64().unwrap();
    let height = drop["height_m"].as_f64().unwrap();
    assert!((plain + sum - height).abs() < 1e-9);
    assert_eq!(document["procedure"][0]["item"], "release");
    assert_eq!(document["procedure"][0]["state"], "not-shown");
}

#[test]
fn a_report_says_what_the_screen_says() {
    let folder = TempDir::new().unwrap();
    drop(folder.path(), "one.txt", "30.5cm", "0.935");
    drop(folder.path(), "two & <b>.txt", "30.5cm", "0.936");
    let arguments = [
        "--rule",
        "ittf-ball",
        "one.txt",
        "two & <b>.txt",
        "--report",
    ];
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
    let mut said = String::new();
    for report in ["verdict.html", "verdict.md"] {
        let output = verdict(&folder, &[&arguments[..], &[report]].concat())
            .assert()
            .code(5);
        said = String::from_utf8_lossy(&output.get_output().stdout).into_owned();
    }
    let decided = said
        .lines()
        .find(|line| line.starts_with("CONFORMS"))
        .unwrap();
    let (html, markdown) = (read("verdict.html"), read("verdict.md"));
    for words in [
        decided,
        "Guarded acceptance",
        "ITTF, Technical Leaflet T3",
        "24 to 26 cm",
        "contact time, which is no flight",
        "The lowest point of the ball fell",
        "--report verdict",
    ] {
        assert!(html.contains(words) && markdown.contains(words), "{words}");
    }
    assert!(html.contains("two &amp; &lt;b&gt;.txt") && !html.contains("<b>.txt"));
    assert!(folder.path().join("verdict-figures/verdict.svg").is_file());
}

#[test]
fn a_report_that_cannot_be_written_is_said_before_any_work() {
    let folder = TempDir::new().unwrap();
    verdict(
        &folder,
        &[
            "--rule",
            "ittf-ball",
            "nowhere.wav",
            "--report",
            "no/verdict.html",
        ],
    )
    .assert()
    .code(1)
    .stdout("")
    .stderr(predicate::str::contains("no/verdict.html"));
}

#[test]
fn a_floor_takes_a_reference() {
    let folder = TempDir::new().unwrap();
    for (name, restitution) in [
        ("a.txt", "0.74"),
        ("b.txt", "0.741"),
        ("c.txt", "0.77"),
        ("d.txt", "0.771"),
    ] {
        drop(folder.path(), name, "180cm", restitution);
    }
    // No basketball was simulated: the ball is that of the simulation.
    let floor = [
        "--rule",
        "indoor-floor-basketball",
        "--ball",
        "table-tennis-40",
    ];
    verdict(&folder, &[&floor[..], &["a.txt", "b.txt"]].concat())
        .assert()
        .code(4)
        .stdout(predicate::str::contains("not kept: drops on the reference"));
    verdict(
        &folder,
        &[
            &floor[..],
            &["a.txt", "b.txt", "--reference", "c.txt", "d.txt"],
        ]
        .concat(),
    )
    .assert()
    .stdout(predicate::str::contains("share of the reference"));
}

#[test]
fn rules_of_ones_own_are_read_and_wrong_ones_refused() {
    let folder = TempDir::new().unwrap();
    drop(folder.path(), "good.txt", "30.5cm", "0.935");
    let own = |limits: &str| {
        format!(
            "schema = \"bouncelab.rules/2\"\n\n[[rule]]\nname = \"ours\"\ntitle = \"Ours\"\n\
             source = {{ publisher = \"us\", read = \"memory\" }}\nball = \"table-tennis-40\"\n\
             drop = {{ height = \"30.5cm\" }}\nrebound = {{ {limits} }}\n"
        )
    };
    let path = folder.path().join("own.toml");
    let asking = own("least = \"20cm\"") + "note = \"was the floor oiled?\"\n";
    fs::write(&path, asking).unwrap();
    let arguments = ["--rule", "ours", "--rules", "own.toml", "good.txt"];
    verdict(&folder, &arguments)
        .assert()
        .code(5)
        .stdout(predicate::str::contains(
            "This rule was written from memory",
        ))
        .stdout(predicate::str::contains("Note: was the floor oiled?\n"));
    fs::write(&path, own("least = \"20kg\"")).unwrap();
    verdict(&folder, &arguments)
        .assert()
        .failure()
        .stderr(predicate::str::contains("own.toml, line 9, column "))
        .stderr(predicate::str::contains("\"kg\" is not a unit for this"));
}

#[test]
fn wrong_input_is_questioned() {
    let folder = TempDir::new().unwrap();
    drop(folder.path(), "good.txt", "30.5cm", "0.935");
    let refused = |arguments: &[&str], says: &str| {
        verdict(&folder, arguments)
            .assert()
            .code(2)
            .stdout("")
            .stderr(predicate::str::contains(says));
    };
    refused(
        &["--rule", "itf-tenis", "good.txt"],
        "nearest is \u{201c}itf-tennis\u{201d}",
    );
    refused(
        &["--rule", "ittf-ball", "--height", "3.05m", "good.txt"],
        "10 times the rule's 0.305 m: is the unit right?",
    );
    refused(&["--rule", "astm-f2117", "good.txt"], "names no known ball");
    refused(
        &["--rule", "ittf-ball", "good.txt", "./good.txt"],
        "good.txt and ./good.txt are the same recording",
    );
    refused(
        &["--rule", "ittf-ball", "--risk", "80", "good.txt"],
        "a risk is above 0",
    );
    verdict(
        &folder,
        &[
            "--rule",
            "itf-court",
            "--ball",
            "table-tennis-40",
            "good.txt",
        ],
    )
    .assert()
    .code(4)
    .stdout(predicate::str::contains("not kept: number of drops"));
    verdict(
        &folder,
        &["--rule", "racquetball", "--temperature", "10C", "good.txt"],
    )
    .assert()
    .code(4)
    .stdout(predicate::str::contains("not kept: temperature"));
    verdict(&folder, &["--rule", "ittf-ball", "nothing.wav"])
        .assert()
        .code(1)
        .stderr(predicate::str::contains("nothing.wav"));
}

#[test]
fn rules_are_listed_and_shown() {
    bouncelab()
        .args(["rules", "list"])
        .assert()
        .success()
        .stdout(predicate::str::contains("fiba-basketball"))
        .stdout(predicate::str::contains("103.5 to 108.5 cm"));
    bouncelab()
        .args(["rules", "show", "fifa-turf-quality"])
        .assert()
        .success()
        .stdout(predicate::str::contains("H = 1.23 (T - 0.025)²"))
        .stdout(predicate::str::contains("from memory"));
    let template = bouncelab().args(["rules", "new"]).output().unwrap();
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("own.toml"), template.stdout).unwrap();
    bouncelab()
        .current_dir(&folder)
        .args(["rules", "show", "our-rule", "--rules", "own.toml"])
        .assert()
        .success()
        .stdout(predicate::str::contains("rules of the hall"));
}

#[cfg(unix)]
#[test]
fn rules_without_end_are_refused() {
    bouncelab()
        .args(["rules", "list", "--rules", "/dev/zero"])
        .assert()
        .code(1)
        .stderr(predicate::str::contains("cannot read the rules /dev/zero"));
}

#[test]
fn a_copy_of_a_recording_is_no_second_drop() {
    let folder = TempDir::new().unwrap();
    drop(folder.path(), "good.txt", "30.5cm", "0.935");
    fs::copy(
        folder.path().join("good.txt"),
        folder.path().join("copy.txt"),
    )
    .unwrap();
    verdict(&folder, &["--rule", "ittf-ball", "good.txt", "copy.txt"])
        .assert()
        .code(2)
        .stderr(predicate::str::contains(
            "good.txt and copy.txt are the same recording",
        ));
}

#[test]
fn another_ball_than_the_rules_is_questioned() {
    let folder = TempDir::new().unwrap();
    drop(folder.path(), "good.txt", "30.5cm", "0.935");
    let inference = "is it the right rule?\n";
    let says = |ball: &[&str], expected: bool| {
        let arguments = [&["--rule", "ittf-ball", "good.txt"], ball].concat();
        let says = predicate::str::contains(inference);
        let assert = verdict(&folder, &arguments).assert();
        if expected {
            assert.stdout(says)
        } else {
            assert.stdout(says.not())
        }
    };
    says(&["--ball", "tennis"], true);
    says(&["--mass", "2.65g", "--diameter", "40mm"], false);
}

#[test]
fn a_simple_decision_takes_no_risk() {
    let folder = TempDir::new().unwrap();
    let arguments = [
        "--rule",
        "ittf-ball",
        "--decision",
        "simple",
        "--risk",
        "1%",
        "x.txt",
    ];
    verdict(&folder, &arguments)
        .assert()
        .code(2)
        .stderr(predicate::str::contains("knows no --risk"));
}

#[test]
fn a_rule_of_heights_takes_no_reference() {
    let folder = TempDir::new().unwrap();
    drop(folder.path(), "good.txt", "30.5cm", "0.935");
    drop(folder.path(), "other.txt", "30.5cm", "0.93");
    let arguments = [
        "--rule",
        "ittf-ball",
        "good.txt",
        "--reference",
        "other.txt",
    ];
    verdict(&folder, &arguments)
        .assert()
        .code(2)
        .stderr(predicate::str::contains("omit --reference"));
}
