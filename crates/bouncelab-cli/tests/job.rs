//! A job of five places by five drops, from its folder to its report, and what happens to it on the way.

mod support;

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use bouncelab::synth::{self, Scene};
use bouncelab_audio::{SampleFormat, SoundReader};
use bouncelab_session::hash::hash_of_file;
use bouncelab_testkit::{impact_events, write_wav};
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
    let laboratory =
        "name = \"Laboratory & Sons\"\naddress = \"Road 1, Town\"\nlogo = \"logo.svg\"\n";
    fs::write(folder.path().join("laboratory.toml"), laboratory).unwrap();
    let logo = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 40 20\"><circle cx=\"20\" cy=\"10\" r=\"9\"/></svg>";
    fs::write(folder.path().join("logo.svg"), logo).unwrap();
    let path = folder.path().join("court/job.toml");
    let notes = fs::read_to_string(&path).unwrap();
    assert!(
        notes.contains("rule = \"itf-court\"\n") && notes.contains("drops = 5 "),
        "{notes}"
    );
    let filled = notes
        .replace("kept = []", "kept = [\"reference\", \"conditioning\"]")
        .replace("number = \"\"", "number = \"2026-17\"")
        .replace("# laboratory = \"../", "laboratory = \"../")
        .replace("client = \"\"", "client = \"Tennis club <Grün>\"")
        .replace("deviations = \"\"", "deviations = \"none\"")
        .replace(
            "item = \"\"",
            "item = \"Court 3, acrylic on asphalt, dry, four years old\"",
        )
        .replace(
            "sample = \"\"",
            "sample = \"five places, chosen by the laboratory on 2026-11-26\"",
        )
        .replace("location = \"\"", "location = \"Parkweg 2, 12345 Town\"")
        .replace(
            "conditions = \"\"",
            "conditions = \"dry; 21 °C, 48 %, in all places\"",
        )
        .replace(
            "authorised = \"\"",
            "authorised = \"C. Head, head of laboratory\"",
        )
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
        "of a synthesised drop with a first rebound of",
        "they agree within the uncertainty",
        "Laboratory &amp; Sons, Road 1, Town",
        "src=\"data:image/svg+xml;base64,PHN2Zy",
        "over places (5, reproducibility)",
        "Test report 2026-17, court",
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
    assert_eq!(document["test"]["number"], "2026-17");
    assert_eq!(
        document["test"]["equipment"][0],
        "tape 7, calibrated 2026-03-01"
    );
    assert_eq!(document["test"]["checks"].as_array().unwrap().len(), 2);
    assert_eq!(document["precision"]["levels"], 5);
    let repeated = document["recordings"].as_array().unwrap().iter();
    let reasons: Vec<&Value> = repeated.filter_map(|line| line.get("repeated")).collect();
    assert_eq!(reasons, ["a door slammed"]);
    print_as_pdf(&folder);
}

/// The reports as PDF: tagged, in a language, with a title, with every font in the file; that for the client is one page.
/// Chromium writes its objects as plain text.
fn print_as_pdf(folder: &TempDir) {
    for (name, options, expected) in [
        ("court.pdf", &[][..], 3..=7),
        ("page.pdf", &["--one-page"], 1..=1),
    ] {
        let words = [&["show", "court", "--report", name], options].concat();
        let shown = job(folder, &words).assert();
        let said = String::from_utf8_lossy(&shown.get_output().stderr).into_owned();
        // Where no browser is installed, there is nothing to print with.
        if said.contains("none was found") {
            return;
        }
        shown.code(0);
        let pdf = fs::read(folder.path().join(name)).unwrap();
        let pdf = String::from_utf8_lossy(&pdf);
        for part in [
            "/MarkInfo <</Type /MarkInfo\n/Marked true>>",
            "/StructTreeRoot",
            "/Lang (en)",
            "/Title (",
        ] {
            assert!(pdf.contains(part), "{name}: {part}");
        }
        let count = |part: &str| pdf.matches(part).count();
        assert!(
            expected.contains(&count("/Type /Page\n")),
            "{name}: {} pages",
            count("/Type /Page\n")
        );
        // Each font has a descriptor, and each descriptor a file.
        assert!(count("/Type /FontDescriptor") > 0);
        assert_eq!(
            count("/FontFile2 ") + count("/FontFile3 "),
            count("/Type /FontDescriptor"),
            "{name}"
        );
        // One of bouncelab may be replaced.
        job(folder, &words).assert().code(0);
    }
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
    let journal = folder.path().join("court/journal.jsonl");
    let whole = fs::read_to_string(&journal).unwrap();
    // The crash cut off the line of the second recording; its result was not written yet.
    let lines: Vec<&str> = whole.lines().collect();
    // The check of the method, and each recording with its result.
    assert_eq!(lines.len(), 5, "{whole}");
    let torn = &lines[3][..lines[3].len() - 10];
    fs::write(&journal, [lines[0], lines[1], lines[2], torn].join("\n")).unwrap();
    job(&folder, &["add", "court", "c.txt"])
        .assert()
        .success()
        .stdout(predicate::str::contains("3  reference, drop 2 of 5"));
    // The sound of the second is kept, and named until it is counted.
    let second = folder.path().join("court/sounds/002.txt");
    job(&folder, &["show", "court"])
        .assert()
        .stderr(predicate::str::contains(
            "002.txt is kept but does not count",
        ));
    job(&folder, &["add", "court", "court/sounds/002.txt"])
        .assert()
        .success()
        .stdout(predicate::str::contains("2  reference, drop 3 of 5"));
    assert!(second.is_file() && !folder.path().join("court/sounds/004.txt").exists());
    job(&folder, &["show", "court"])
        .assert()
        .stderr(predicate::str::contains("does not count").not());
    fs::write(folder.path().join("court/sounds/001.txt"), "0\n1\n").unwrap();
    job(&folder, &["show", "court"])
        .assert()
        .code(1)
        .stderr(predicate::str::contains("001.txt: it was changed"));
    // A damaged line within the journal does not go unnoticed, nor is a file of another kind taken for one.
    let damaged = fs::read_to_string(&journal)
        .unwrap()
        .replacen("a.txt", "A.txt", 1);
    fs::write(&journal, damaged).unwrap();
    job(&folder, &["show", "court"])
        .assert()
        .stderr(predicate::str::contains("journal.jsonl is damaged"))
        .stderr(predicate::str::contains(
            "001.txt is kept but does not count",
        ));
    fs::write(&journal, "{}\n").unwrap();
    job(&folder, &["show", "court"])
        .assert()
        .code(1)
        .stderr(predicate::str::contains("no journal of bouncelab"));
}

/// Results are kept with the hash of what they depend on: another setting has other results, the same has the same.
#[test]
fn a_result_is_worked_out_once_for_each_setting() {
    let folder = TempDir::new().unwrap();
    court(&folder);
    drop(folder.path(), "a.txt", 0.80);
    job(&folder, &["add", "court", "a.txt"]).assert().success();
    let lines = || {
        let journal = fs::read_to_string(folder.path().join("court/journal.jsonl"));
        journal.unwrap().lines().count()
    };
    let shown = || job(&folder, &["show", "court"]).output().unwrap().stdout;
    let (first, before) = (shown(), lines());
    assert_eq!((shown(), lines()), (first.clone(), before));
    let path = folder.path().join("court/job.toml");
    let notes = fs::read_to_string(&path).unwrap();
    fs::write(&path, notes.replace("height_m = 1.27", "height_m = 1.28")).unwrap();
    assert_ne!(shown(), first);
    assert_eq!(lines(), before + 1);
    fs::write(&path, notes).unwrap();
    assert_eq!((shown(), lines()), (first, before + 1));
}

/// A recording of a drop of a table-tennis ball from 30.5 cm.
fn sound(folder: &Path, name: &str, seed: u64) {
    // Without drag, e² 30.5 cm are 25.6 cm, of which the correction for the air takes 0.6 cm.
    let impacts: Vec<_> = impact_events(2.446, 0.917).take(12).collect();
    let scene = Scene {
        tail_s: 5.0,
        ..Scene::default()
    };
    let sound = synth::render(&impacts, &scene, seed).unwrap();
    let (path, rate_hz) = (folder.join(name), sound.sample_rate_hz);
    write_wav(&path, rate_hz, SampleFormat::Float32, &[&sound.samples]);
}

/// A job of a ball with three drops.
fn ball(folder: &TempDir) {
    let new = ["new", "ball", "--rule", "ittf-ball", "--drops", "3"];
    job(folder, &new).assert().success();
}

/// Where several drop the ball in one place, the report has the reproducibility over them.
#[test]
fn operators_are_compared_in_one_place() {
    let folder = TempDir::new().unwrap();
    let new = ["new", "ball", "--rule", "itf-tennis", "--drops", "4"];
    job(&folder, &new).assert().success();
    let path = folder.path().join("ball/job.toml");
    let notes = fs::read_to_string(&path).unwrap();
    fs::write(&path, notes + "\n[settings.drop]\nheight_m = 1.27\n").unwrap();
    for (number, operator) in ["Ada", "Ben", "Ada", "Ben"].into_iter().enumerate() {
        let name = format!("{number}.txt");
        drop(folder.path(), &name, 0.75 + 0.001 * number as f64);
        job(&folder, &["add", "ball", &name, "--operator", operator])
            .assert()
            .success();
    }
    let shown = job(&folder, &["show", "ball", "--report", "ball.md"]).output();
    assert!(shown.unwrap().status.code() != Some(1));
    let report = fs::read_to_string(folder.path().join("ball.md")).unwrap();
    assert!(
        report.contains("over operators (2, reproducibility)"),
        "{report}"
    );
    assert!(report.contains("0.txt  Ada"), "{report}");
}

/// What is recorded is kept as it came, with its hash, and counted in its place; what is repeated is recorded anew.
#[test]
fn drops_are_recorded_one_after_the_other() {
    let folder = TempDir::new().unwrap();
    ball(&folder);
    for number in 1..=4 {
        sound(folder.path(), &format!("{number}.wav"), number);
    }
    let listen = |files: &[&str]| {
        job(
            &folder,
            &[&["listen", "ball", "--fast", "--from"], files].concat(),
        )
        .assert()
    };
    listen(&["1.wav", "2.wav"])
        .success()
        .stderr(predicate::str::contains("place 1 of 1, drop 1 of 3"))
        .stdout(predicate::str::contains("2  place 1 of 1, drop 2 of 3"))
        .stdout(predicate::str::contains("So far "));
    job(&folder, &["repeat", "ball", "2", "--reason", "a cough"])
        .assert()
        .success();
    // A recording that is there already is no other drop, and is not saved again, whether it was played or kept.
    for known in ["1.wav", "ball/sounds/001.wav"] {
        listen(&[known])
            .code(2)
            .stderr(predicate::str::contains("is recording 1 of the job"));
        job(&folder, &["add", "ball", known]).assert().code(2);
    }
    let saved = fs::read_dir(folder.path().join("ball/sounds")).unwrap();
    assert_eq!(saved.count(), 2);
    listen(&["3.wav", "4.wav"])
        .success()
        .stderr(predicate::str::contains("place 1 of 1, drop 2 of 3"));
    // Every place has its drops.
    listen(&["4.wav"]).code(1);
    let shown = job(&folder, &["show", "ball"]).assert().code(5);
    let shown = String::from_utf8_lossy(&shown.get_output().stdout).into_owned();
    assert!(shown.contains("repeated: a cough"), "{shown}");
    assert!(shown.contains("place 1 of 1, drop 3 of 3"), "{shown}");
    let events: Vec<Value> = fs::read_to_string(folder.path().join("ball/journal.jsonl"))
        .unwrap()
        .lines()
        .map(|line| serde_json::from_str(line.split_once(' ').unwrap().1).unwrap())
        .collect();
    let added = events
        .iter()
        .filter(|line| line["result"]["event"] == "added");
    for (line, played) in added.zip(["1.wav", "2.wav", "3.wav", "4.wav"]) {
        let file = folder
            .path()
            .join("ball")
            .join(line["name"].as_str().unwrap());
        assert_eq!(
            samples(&file),
            samples(&folder.path().join(played)),
            "{played}"
        );
        let sha256 = hash_of_file(&file).unwrap().to_string();
        assert_eq!(line["result"]["sha256"], sha256);
        assert_eq!(line["result"]["given_as"], *played);
    }
}

/// All samples of the first channel, but for those after the last block that was played.
fn samples(file: &Path) -> Vec<f32> {
    let mut source = SoundReader::open(file).unwrap();
    let mut samples = Vec::new();
    while let Some(block) = source.next_block().unwrap() {
        samples.extend_from_slice(block.channel(0));
    }
    // It is recorded until the drop is over, 2 s after the last impact at the earliest.
    samples.truncate(4 * source.sample_rate_hz() as usize);
    samples
}

/// A disk that is full at any point: what was acknowledged counts, no sound is lost that was, and the job goes on.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_loses_nothing() {
    let folder = TempDir::new().unwrap();
    ball(&folder);
    sound(folder.path(), "1.wav", 1);
    sound(folder.path(), "2.wav", 2);
    job(&folder, &["add", "ball", "1.wav"]).assert().success();
    let journal = folder.path().join("ball/journal.jsonl");
    let before = fs::read(&journal).unwrap();
    let first = fs::read(folder.path().join("ball/sounds/001.wav")).unwrap();
    let whole_kb = fs::metadata(folder.path().join("2.wav"))
        .unwrap()
        .len()
        .div_ceil(1024);
    // No file may be longer than this: the sound does not fit, or the journal cannot grow.
    let journal_kb = before.len() as u64 / 1024;
    for (limit_kb, what) in [
        (1, "add ball 2.wav"),
        (whole_kb / 2, "add ball 2.wav"),
        (journal_kb, "repeat ball 1 --reason noise"),
        (whole_kb / 2, "listen ball --fast --from 2.wav"),
    ] {
        let program = env!("CARGO_BIN_EXE_bouncelab");
        let command = format!("ulimit -f {limit_kb}; exec {program} job {what}");
        let mut shell = Command::new("bash");
        shell.current_dir(&folder).args(["-c", &command]);
        shell
            .assert()
            .code(1)
            .stderr(predicate::str::contains("too large"));
        assert_eq!(fs::read(&journal).unwrap(), before, "{what}");
    }
    assert_eq!(
        fs::read(folder.path().join("ball/sounds/001.wav")).unwrap(),
        first
    );
    // What was heard until the disk was full is kept.
    let saved = folder.path().join("ball/sounds/002.wav");
    assert!(!samples(&saved).is_empty());
    job(&folder, &["add", "ball", "2.wav"])
        .assert()
        .success()
        .stdout(predicate::str::contains("3  place 1 of 1, drop 2 of 3"));
}
