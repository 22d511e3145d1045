//! `bouncelab analyze --report`, as its users meet it.

use std::fs;

use assert_cmd::Command;
use predicates::prelude::*;
use tempfile::TempDir;

fn bouncelab() -> Command {
    Command::cargo_bin("bouncelab").unwrap()
}

/// A folder with a list of impact times in `drop.txt`.
fn folder() -> TempDir {
    let folder = TempDir::new().unwrap();
    let times = "0.0\n0.4605\n0.8877\n1.2854\n1.6568\n2.0045\n2.3308\n";
    fs::write(folder.path().join("drop.txt"), times).unwrap();
    folder
}

#[test]
fn a_report_is_one_file_with_the_hash_and_the_command() {
    let folder = folder();
    bouncelab()
        .current_dir(&folder)
        .args(["analyze", "drop.txt", "--report", "my report.html"])
        .assert()
        .success();
    let html = fs::read_to_string(folder.path().join("my report.html")).unwrap();
    // sha256sum drop.txt
    let hash = "2b19ae9f7097a4427de380abe84c48c425961d97f51ed38d3e1bfa59af1a543d";
    assert!(html.contains(hash));
    assert!(html.contains("bouncelab analyze drop.txt --report 'my report.html'"));
    let files = fs::read_dir(&folder).unwrap().count();
    assert_eq!(files, 2, "nothing else is left behind");
}

#[test]
fn a_notebook_has_its_figures_beside_it() {
    let folder = folder();
    bouncelab()
        .current_dir(&folder)
        .args(["analyze", "drop.txt", "--report", "drop.md"])
        .assert()
        .success();
    let text = fs::read_to_string(folder.path().join("drop.md")).unwrap();
    assert!(text.starts_with("# drop.txt\n"));
    assert!(text.contains("](<drop-figures/height.svg>)"));
    assert!(folder.path().join("drop-figures/height.svg").is_file());
}

#[test]
fn what_cannot_be_written_is_said_before_any_work() {
    let folder = folder();
    let report = |path: &str, says: &str| {
        bouncelab()
            .current_dir(&folder)
            .args(["analyze", "drop.txt", "--report", path])
            .assert()
            .failure()
            .stdout("")
            .stderr(predicate::str::contains(says));
    };
    report("drop.txt", "must end in .html, .md or .pdf");
    report("nowhere/drop.html", "does its folder exist");
    bouncelab()
        .current_dir(&folder)
        .args(["analyze", "drop.txt", "drop.txt", "--report", "a.html"])
        .assert()
        .code(2)
        .stderr(predicate::str::contains("a report is for one recording"));
}
