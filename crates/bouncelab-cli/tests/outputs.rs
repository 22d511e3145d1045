//! Nothing of the person's is lost: which files a command replaces, and what it does when nobody takes
//! what it prints.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command as Plain, Stdio};
use std::time::Duration;

use assert_cmd::Command;
use predicates::prelude::*;
use predicates::str::contains;
use tempfile::TempDir;

/// Impacts of a ball with restitution 0.9, dropped from 30.5 cm.
const TIMES: &str = "0\n0.4489\n0.8529\n1.2165\n1.5437\n1.8383\n2.1034\n";

struct Folder(TempDir);

impl Folder {
    fn new() -> Self {
        let folder = Self(TempDir::new().unwrap());
        fs::write(folder.path("drop.txt"), TIMES).unwrap();
        folder
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn read(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap()
    }

    fn run(&self, words: &str) -> Command {
        let mut command = Command::cargo_bin("bouncelab").unwrap();
        command.args(words.split(' ')).current_dir(self.0.path());
        command.timeout(Duration::from_mins(2));
        command
    }
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let mut names: Vec<String> = entries
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

#[cfg(unix)]
#[test]
fn a_report_never_replaces_the_recording_by_whatever_name() {
    let folder = Folder::new();
    fs::hard_link(folder.path("drop.txt"), folder.path("hard.html")).unwrap();
    std::os::unix::fs::symlink("drop.txt", folder.path("link.md")).unwrap();
    for report in ["hard.html", "link.md"] {
        for force in ["", " --force"] {
            let words = format!("analyze drop.txt --no-inference --report {report}{force}");
            let refused = folder.run(&words).assert().code(1);
            refused.stderr(contains("is an input of this command"));
        }
        folder
            .run(&format!(
                "verdict --rule ittf-ball drop.txt --report {report} --force"
            ))
            .assert()
            .code(1);
    }
    assert_eq!(folder.read("drop.txt"), TIMES);
}

#[test]
fn the_notes_of_a_session_survive_its_tables() {
    let folder = Folder::new();
    let notes = "recording,ball,surface\ndrop.txt,tennis,steel\n";
    fs::create_dir(folder.path("s")).unwrap();
    fs::write(folder.path("s/drops.csv"), notes).unwrap();
    folder
        .run("session drop.txt --notes s/drops.csv --output s --no-inference --force")
        .assert()
        .code(1)
        .stderr(contains("s/drops.csv").and(contains("is an input")));
    assert_eq!(folder.read("s/drops.csv"), notes);
    assert_eq!(
        names(&folder.path("s")),
        ["drops.csv"],
        "before the work, not after it"
    );
}

#[test]
fn files_of_others_are_replaced_only_by_force_and_own_ones_always() {
    const SESSION: &str = "session drop.txt --ball tennis --no-inference --output .";
    const FIGURES: &str = "analyze drop.txt --no-inference --figures .";
    let report = |name| format!("analyze drop.txt --no-inference --report {name}");
    let cases = [
        (SESSION, "impacts.csv"),
        (SESSION, "drops.jsonl"),
        (SESSION, "drops.parquet"),
        (SESSION, "session.json"),
        (SESSION, "journal.jsonl"),
        (&report("notes.md"), "notes.md"),
        (&report("notes.html"), "notes.html"),
        (FIGURES, "drop-flight-times.svg"),
        (FIGURES, "drop-flight-times.png"),
        (FIGURES, "drop-flight-times.pdf"),
        ("simulate --figures .", "height.svg"),
        ("demo --output .", "demo.wav"),
    ];
    for (words, name) in cases {
        let folder = Folder::new();
        // Tables of others may begin as those of a session do.
        let mine = match name {
            "impacts.csv" => "recording,drop,what I saw\n",
            "drops.jsonl" => "{\"recording\":\"drop.txt\",\"seen\":\"nothing\"}\n",
            _ => "mine",
        };
        fs::write(folder.path(name), mine).unwrap();
        let refused = folder.run(words).assert().code(1);
        let is_journal = name == "journal.jsonl";
        let reason = if is_journal {
            "is no journal"
        } else {
            "--force"
        };
        refused.stderr(contains(reason));
        assert_eq!(folder.read(name), mine, "{words}");
        if !is_journal {
            folder.run(&format!("{words} --force")).assert().success();
            folder.run(words).assert().success();
            assert_ne!(
                fs::read(folder.path(name)).unwrap(),
                mine.as_bytes(),
                "{words}"
            );
        }
    }
}

/// Linux has a device that is always full.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_a_failure_of_every_command() {
    let folder = Folder::new();
    folder.run("synth played.wav --force").assert().success();
    for words in [
        "analyze drop.txt --no-inference",
        "analyze drop.txt --no-inference --format json",
        "analyze drop.txt --no-inference --format csv",
        "analyze drop.txt --no-inference --format audacity",
        "analyze drop.txt --no-inference --format textgrid",
        "analyze drop.txt --no-inference --format tracker",
        "listen --from played.wav --fast --no-inference",
        "listen --from played.wav --fast --no-inference --format json",
        "verdict --rule ittf-ball drop.txt",
        "verdict --rule ittf-ball drop.txt --format json",
        "session drop.txt --ball tennis --no-inference",
        "session drop.txt --ball tennis --no-inference --format json",
        "rules list",
        "rules show ittf-ball",
        "simulate",
        "simulate --format json",
        "simulate --format csv",
        "synth drop.wav --force",
        "paper --no-figures",
        "paper --no-figures --format json",
        "demo",
        "completions bash",
        "--help",
        "analyze --help",
        "--version",
    ] {
        let full = fs::File::options().write(true).open("/dev/full").unwrap();
        let mut run = Plain::new(assert_cmd::cargo::cargo_bin("bouncelab"));
        run.args(words.split(' ')).current_dir(folder.0.path());
        let output = run.stdout(full).stderr(Stdio::piped()).output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{words}: {said}");
        assert!(said.contains("cannot write the result"), "{words}: {said}");
    }
}

/// A reader of stderr that has gone is no reason to fail, whatever is to be said.
#[cfg(unix)]
#[test]
fn a_closed_stderr_changes_nothing() {
    let folder = Folder::new();
    for (words, code) in [
        ("analyze drop.txt --no-inference --figures figures", 0),
        ("analyze nowhere.wav", 1),
        (
            "session drop.txt --ball tennis --no-inference --report s.html",
            0,
        ),
        ("simulate --figures figures", 0),
        ("analyze", 2),
    ] {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let mut run = Plain::new(assert_cmd::cargo::cargo_bin("bouncelab"));
        run.args(words.split(' ')).current_dir(folder.0.path());
        let output = run.stderr(writer).stdout(Stdio::null()).status().unwrap();
        assert_eq!(output.code(), Some(code), "{words}");
    }
}

/// The limit of the size of files is a full disk, not the end by a signal.
#[cfg(target_os = "linux")]
#[test]
fn a_file_that_may_not_grow_further_is_an_error() {
    let folder = Folder::new();
    let run = Plain::new("sh")
        .args(["-c", "ulimit -f 100; exec \"$0\" synth drop.wav"])
        .arg(assert_cmd::cargo::cargo_bin("bouncelab"))
        .current_dir(folder.0.path())
        .output()
        .unwrap();
    assert_eq!(run.status.code(), Some(1));
    let said = String::from_utf8_lossy(&run.stderr);
    assert!(said.contains("cannot write drop.wav"), "{said}");
    assert_eq!(names(folder.0.path()), ["drop.txt"]);
}

/// What is not finished is removed, as the library's own tests show; here, that signals get there, also where a
/// closed terminal is ignored, as by `nohup`.
#[cfg(unix)]
#[test]
fn signals_end_in_order_and_leave_no_drafts() {
    for (before, signal) in [("", "-INT"), ("", "-HUP"), ("trap '' HUP;", "-TERM")] {
        ends_in_order(before, signal);
    }
}

/// Ends a session by a signal; a shell that runs `before` starts it.
#[cfg(unix)]
fn ends_in_order(before: &str, signal: &str) {
    let folder = Folder::new();
    // A drop, with draws that take seconds: the signal comes before they are done.
    let impacts = bouncelab_testkit::impact_events(4.4, 0.96).take(60);
    let times = impacts.map(|impact| format!("{}\n", impact.time_s));
    let times = times.collect::<String>();
    fs::write(folder.path("long.txt"), times).unwrap();
    let mut run = Plain::new("sh");
    run.args(["-c", &format!("{before} exec \"$0\" \"$@\"")])
        .arg(assert_cmd::cargo::cargo_bin("bouncelab"))
        .args("session long.txt --ball tennis --draws 100000 --output s".split(' '));
    run.current_dir(folder.0.path())
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    let mut child = run.spawn().unwrap();
    while !folder.path("s/journal.jsonl").exists() {
        assert!(
            child.try_wait().unwrap().is_none(),
            "it ended before it began"
        );
    }
    let process = child.id().to_string();
    Plain::new("kill")
        .args([signal, &process])
        .status()
        .unwrap();
    let code = child.wait().unwrap().code();
    assert_eq!(code, Some(130), "{before} {signal}");
    assert_eq!(names(&folder.path("s")), ["journal.jsonl"]);
}
