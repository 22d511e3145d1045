//! A job of five places by five drops, from its folder to its report, and what happens to it on the way.

mod support;

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use predicates::prelude::*;
use serde_json::Value;
use support::write_simulated_times;
use tempfile::TempDir;

fn job(folder: &TempDir, words: &[&str]) -> Command {
    let mut command = Command::cargo_bin("bouncelab").unwrap();
    command.current_dir(folder).arg("job").args(words);
    command
}

/// Impact times of a simulated tennis ball from 1.27 m.
fn drop(folder: &Path, name: &str, restitution: f64) {
    let restitution = restitution.to_string();
    let ball = ["--ball", "tennis", "--height", "127cm", "--bounces", "8"];
    let arguments = [&ball[..], &["--restitution", &restitution]].concat();
    write_simulated_times(&folder.join(name), &arguments, 5);
}

/// A job of a court, its notes filled in.
fn court(folder: &TempDir) {
    job(
        folder,
        &["new", "court", "--rule", "itf-court", "--places", "5"],
    )
    .assert()
    .success();
    let path = folder.path().join("court/job.toml");
    let notes = fs::read_to_string(&path).unwrap();
    assert!(
        notes.contains("rule = \"itf-court\"\n") && notes.contains("drops = 5 "),
        "{notes}"
    );
    let filled = notes
        .replace("kept = []", "kept = [\"reference\", \"conditioning\"]")
        .replace("number = \"\"", "number = \"2026-17\"")
        .replace("client = \"\"", "client = \"Tennis club <Grün>\"")
        .replace("deviations = \"\"", "deviations = \"none\"")
        .replace(
            "equipment = []",
            "equipment = [\"tape 7, calibrated 2026-03-01\"]",
        );
    fs::write(&path, filled + "\n[settings.drop]\nheight_m = 1.27\n").unwrap();
}

#[test]
fn five_places_by_five_drops_become_a_report() {
    let folder = TempDir::new().unwrap();
    court(&folder);
    let mut names = Vec::new();
    for place in 0..=5 {
        for number in 1..=5 {
            let name = format!("{place}-{number}.txt");
            let of_place = if place == 0 {
                0.82
            } else {
                0.77 + 0.001 * f64::from(place)
            };
            drop(
                folder.path(),
                &name,
                of_place + 0.0007 * f64::from(number - 3),
            );
            names.push(name);
        }
    }
    let add = |names: &[String]| {
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        job(&folder, &[&["add", "court"], &names[..]].concat())
            .assert()
            .success()
    };
    add(&names[..7]).stdout(predicate::str::contains("7  place 1 of 5, drop 2 of 5"));
    // A recording counts once, and one that is repeated no more; its sound stays.
    job(&folder, &["add", "court", &names[0]])
        .assert()
        .code(2)
        .stderr(predicate::str::contains("is recording 1 of the job"));
    job(
        &folder,
        &["repeat", "court", "7", "--reason", "a door slammed"],
    )
    .assert()
    .success();
    job(&folder, &["repeat", "court", "7", "--reason", "again"])
        .assert()
        .code(2);
    drop(folder.path(), "again.txt", 0.7712);
    add(&["again.txt".to_owned()]).stdout(predicate::str::contains("8  place 1 of 5, drop 2 of 5"));
    add(&names[7..]).stdout(predicate::str::contains("place 5 of 5, drop 5 of 5"));
    assert!(folder.path().join("court/sounds/007.txt").is_file());
    job(&folder, &["add", "court", "court/job.toml"])
        .assert()
        .failure();

    let shown = job(&folder, &["show", "court", "--report", "report.html"]).assert();
    let shown = String::from_utf8_lossy(&shown.code(0).get_output().stdout).into_owned();
    assert!(shown.contains("repeated: a door slammed"), "{shown}");
    assert!(shown.contains("\nCONFORMS. Within the limits"), "{shown}");
    let report = fs::read_to_string(folder.path().join("report.html")).unwrap();
    for words in [
        "Test report 2026-17",
        "Tennis club &lt;Grün&gt;",
        "not given",
        "tape 7, calibrated 2026-03-01",
        "relate only to the items tested",
        "ITF, Court testing, ball rebound (predictive method)",
        "repeated: a door slammed",
        "a synthesised drop with a first rebound of",
        "End of the report (2026-17)",
    ] {
        assert!(report.contains(words), "{words}");
    }
    let document = job(&folder, &["show", "court", "--format", "json"])
        .output()
        .unwrap();
    let document: Value = serde_json::from_slice(&document.stdout).unwrap();
    assert_eq!(document["outcome"], "conforms");
    let count = |name: &str| document[name].as_array().unwrap().len();
    assert_eq!((count("drops"), count("reference_drops")), (25, 5));
}

/// A line that a crash cut off is no recording, and the job goes on; a sound that was changed is named.
#[test]
fn a_job_goes_on_after_a_crash() {
    let folder = TempDir::new().unwrap();
    court(&folder);
    for (name, restitution) in [("a.txt", 0.80), ("b.txt", 0.801), ("c.txt", 0.802)] {
        drop(folder.path(), name, restitution);
    }
    job(&folder, &["add", "court", "a.txt", "b.txt"])
        .assert()
        .success();
    let journal = folder.path().join("court/drops.jsonl");
    let whole = fs::read(&journal).unwrap();
    fs::write(&journal, &whole[..whole.len() - 10]).unwrap();
    job(&folder, &["add", "court", "c.txt"])
        .assert()
        .success()
        .stdout(predicate::str::contains("3  reference, drop 2 of 5"));
    let lines = fs::read_to_string(&journal).unwrap();
    assert_eq!(lines.lines().count(), 2, "{lines}");
    assert!(folder.path().join("court/sounds/002.txt").is_file());
    fs::write(folder.path().join("court/sounds/001.txt"), "0\n1\n").unwrap();
    job(&folder, &["show", "court"])
        .assert()
        .code(1)
        .stderr(predicate::str::contains("001.txt: it was changed"));
    // A whole line that is no event is not skipped.
    fs::write(&journal, "{}\n").unwrap();
    job(&folder, &["show", "court"])
        .assert()
        .code(1)
        .stderr(predicate::str::contains("line 1"));
}
