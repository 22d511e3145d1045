//! Impacts as other programs read them, and back.

use std::fs;
use std::path::Path;
use std::process::Command as Program;

use assert_cmd::Command;
use bouncelab_audio::{SoundReader, times};
use predicates::prelude::*;
use tempfile::TempDir;

const TIMES_S: [f64; 6] = [0.25, 0.7105, 1.1377, 1.5354, 1.9068, 2.2545];

/// Runs the program in a folder that has the times above in `drop.txt`.
fn analyze(folder: &TempDir, arguments: &[&str]) -> assert_cmd::assert::Assert {
    let list = TIMES_S.map(|time_s| time_s.to_string()).join("\n");
    fs::write(folder.path().join("drop.txt"), list).unwrap();
    Command::cargo_bin("bouncelab")
        .unwrap()
        .current_dir(folder)
        .args(["analyze", "--no-inference"])
        .args(arguments)
        .assert()
}

/// What a run prints.
fn printed(folder: &TempDir, format: &str) -> String {
    let run = analyze(folder, &["drop.txt", "--format", format]).success();
    String::from_utf8(run.get_output().stdout.clone()).unwrap()
}

#[test]
fn labels_of_audacity_and_praat_come_back() {
    let folder = TempDir::new().unwrap();
    for (format, name) in [("audacity", "labels.txt"), ("textgrid", "drop.TextGrid")] {
        let labels = printed(&folder, format);
        assert_eq!(
            times::parse(labels.as_bytes(), name).unwrap().times_s,
            TIMES_S,
            "{format}"
        );
    }
}

/// A label track as the manual of Audacity describes it ("Importing and Exporting Labels"): a line has start and end in
/// seconds and the text of the label, separated by tabs; a line that begins with a backslash gives the lowest and the
/// highest frequency of the label before it. Start and text of each label.
fn audacity_labels(track: &str) -> Vec<(f64, String)> {
    let mut labels = Vec::new();
    for line in track.lines() {
        let cells: Vec<&str> = line.split('\t').collect();
        let [first, second, third] = cells[..] else {
            panic!("{line:?} has not three parts");
        };
        if first == "\\" {
            let [low, high]: [f64; 2] = [second, third].map(|cell| cell.parse().unwrap());
            assert!(!labels.is_empty() && low <= high, "{line:?}");
        } else {
            let [start_s, end_s]: [f64; 2] = [first, second].map(|cell| cell.parse().unwrap());
            assert!(start_s <= end_s, "{line:?}");
            labels.push((start_s, third.to_owned()));
        }
    }
    labels
}

#[test]
fn the_labels_are_those_that_audacity_describes() {
    let numbered: Vec<(f64, String)> = (1..)
        .zip(TIMES_S)
        .map(|(number, time_s): (u32, f64)| (time_s, number.to_string()))
        .collect();
    let written = printed(&TempDir::new().unwrap(), "audacity");
    assert_eq!(audacity_labels(&written), numbered);
    // With ranges of time and of frequency, as Audacity may write them.
    let edited =
        "0.25\t0.30\tfirst\n\\\t200.0\t4000.0\n0.7105\t0.7105\t\n1.1377\t1.2\tthird, and so on\n";
    let starts: Vec<f64> = audacity_labels(edited)
        .into_iter()
        .map(|(start_s, _)| start_s)
        .collect();
    assert_eq!(
        times::parse(edited.as_bytes(), "labels.txt")
            .unwrap()
            .times_s,
        starts
    );
}

/// Praat reads the file, and what it saves again, long or short, has the same impacts.
#[test]
#[ignore = "needs Praat: cargo xtask test praat"]
fn praat_reads_the_text_grid() {
    let folder = TempDir::new().unwrap();
    let place = folder.path();
    fs::write(place.join("drop.TextGrid"), printed(&folder, "textgrid")).unwrap();
    let script = [
        r#"Read from file: "drop.TextGrid""#,
        "name$ = Get tier name: 1",
        "writeInfoLine: name$",
        r#"Save as text file: "long.TextGrid""#,
        r#"Save as short text file: "short.TextGrid""#,
    ];
    fs::write(place.join("again.praat"), script.join("\n")).unwrap();
    let run = Program::new("praat")
        .args(["--run", "--no-pref-files", "--no-plugins"])
        .arg(place.join("again.praat"))
        .output()
        .unwrap();
    assert!(
        run.status.success(),
        "{}",
        String::from_utf8_lossy(&run.stderr)
    );
    assert_eq!(String::from_utf8_lossy(&run.stdout).trim(), "impacts");
    for saved in ["long.TextGrid", "short.TextGrid"] {
        assert_eq!(
            times::read(place.join(saved)).unwrap().times_s,
            TIMES_S,
            "{saved}"
        );
    }
}

#[test]
fn tracker_gets_the_motion_between_the_impacts() {
    let folder = TempDir::new().unwrap();
    let table = printed(&folder, "tracker");
    let mut lines = table.lines();
    assert_eq!(lines.next(), Some("t,x,y"));
    let rows: Vec<[f64; 3]> = lines
        .map(|line| {
            let cells: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
            cells.try_into().unwrap()
        })
        .collect();
    // The flight of 0.4605 s rises to about g T^2/8 = 26 cm.
    let highest = rows.iter().map(|[_, _, y]| *y).fold(0.0, f64::max);
    assert!((0.24..0.28).contains(&highest), "{highest}");
    assert!(
        rows.iter()
            .all(|[t, x, y]| (0.25..2.3).contains(t) && *x == 0.0 && *y > -1e-6)
    );
    // Read back, it is no list of impacts, whatever its columns are called.
    let refused = times::parse(table.as_bytes(), "motion.csv").unwrap_err();
    assert!(
        refused.to_string().contains("positions over time"),
        "{refused}"
    );
    let renamed = table.replace("t,x,y", "time_s,n,height");
    let times_s = times::parse(renamed.as_bytes(), "motion.csv")
        .unwrap()
        .times_s;
    let read = bouncelab::analyze_times(&times_s, &bouncelab::Options::default());
    assert!(read.drops.is_empty(), "{:?}", read.drops);
}

/// A simulated drop as `drop.wav`, with its impacts in `truth.csv`, and its copy with markers as `marked.wav`.
fn marked(folder: &TempDir) {
    let height = ["--height", "20cm", "--restitution", "0.8"];
    Command::cargo_bin("bouncelab")
        .unwrap()
        .current_dir(folder)
        .args(["synth", "drop.wav", "--truth", "truth.csv"])
        .args(height)
        .assert()
        .success();
    analyze(folder, &["drop.wav", "--cues", "marked.wav"]).success();
}

/// The true times of the impacts are those of the frames at which the markers stand.
fn assert_true(folder: &TempDir, rate_hz: u32, markers: &[u32]) {
    let truth_s = times::read(folder.path().join("truth.csv"))
        .unwrap()
        .times_s;
    assert!(markers.len() > 5 && markers.len() <= truth_s.len());
    for (marker, truth_s) in markers.iter().zip(truth_s) {
        let time_s = f64::from(*marker) / f64::from(rate_hz);
        assert!(
            (time_s - truth_s).abs() < 1e-4,
            "{time_s} s, not {truth_s} s"
        );
    }
}

/// libsndfile tells the rate and, for each marker, its chunk and the frame in it.
#[test]
#[ignore = "needs sndfile-info: cargo xtask test markers"]
fn libsndfile_reads_the_markers() {
    let folder = TempDir::new().unwrap();
    marked(&folder);
    let run = Program::new("sndfile-info")
        .arg(folder.path().join("marked.wav"))
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&run.stdout);
    assert!(run.status.success(), "{said}");
    let number = |line: &str, name: &str| -> Option<u32> {
        let (_, value) = line.split_once(name)?.1.split_once(':')?;
        value.split_whitespace().next()?.parse().ok()
    };
    let rate_hz = said.lines().find_map(|line| number(line, "Sample Rate"));
    let cues = said.lines().filter(|line| line.contains("Cue ID"));
    let markers: Vec<u32> = cues
        .inspect(|line| assert!(line.contains("Chunk : data"), "{line}"))
        .map(|line| number(line, "Offset").unwrap())
        .collect();
    assert_true(&folder, rate_hz.unwrap(), &markers);
}

/// The number of frames per second, and the frames at which the markers of a WAV file stand, as RIFF describes it: `cue `
/// has their count and 24 bytes for each, of which the last four are the frame.
fn markers(wav: &[u8]) -> (u32, Vec<u32>) {
    let number = |at: usize| u32::from_le_bytes(wav[at..at + 4].try_into().unwrap());
    let (mut rate_hz, mut markers) = (0, Vec::new());
    let mut at = 12;
    while at < wav.len() {
        let (name, length) = (&wav[at..at + 4], number(at + 4) as usize);
        let content = at + 8;
        match name {
            b"fmt " => rate_hz = number(content + 4),
            b"cue " => {
                let ends = (1..=number(content) as usize).map(|count| content + 4 + 24 * count);
                markers = ends.map(|end| number(end - 4)).collect();
            }
            _ => {}
        }
        at = content + length + length % 2;
    }
    (rate_hz, markers)
}

#[test]
fn a_copy_has_markers_at_the_impacts() {
    let folder = TempDir::new().unwrap();
    let inside = |name: &str| folder.path().join(name);
    marked(&folder);
    let all = |path: &Path| {
        let mut source = SoundReader::open(path).unwrap();
        let mut samples = Vec::new();
        while let Some(block) = source.next_block().unwrap() {
            samples.extend_from_slice(block.channel(0));
        }
        samples
    };
    assert_eq!(all(&inside("marked.wav")), all(&inside("drop.wav")));
    let (rate_hz, markers) = markers(&fs::read(inside("marked.wav")).unwrap());
    assert_true(&folder, rate_hz, &markers);
    // A recording is not replaced.
    analyze(&folder, &["drop.wav", "--cues", "marked.wav"]).success();
    fs::write(inside("other.wav"), "another sound").unwrap();
    for taken in ["drop.wav", "other.wav"] {
        analyze(&folder, &["drop.wav", "--cues", taken]).failure();
    }
    assert_eq!(fs::read(inside("other.wav")).unwrap(), b"another sound");
}

/// One column of samples is sound at the rate that is stated.
#[test]
fn samples_without_times_are_marked() {
    let folder = TempDir::new().unwrap();
    let inside = |name: &str| folder.path().join(name);
    let rendered = bouncelab_testkit::damage::drop(16_000);
    let column: Vec<String> = rendered.samples.iter().map(f32::to_string).collect();
    fs::write(inside("samples.txt"), column.join("\n")).unwrap();
    let words = ["samples.txt", "--cues", "marked.wav", "--rate", "16000"];
    analyze(&folder, &words).success();
    let (rate_hz, markers) = markers(&fs::read(inside("marked.wav")).unwrap());
    assert_eq!((rate_hz, markers.len()), (16_000, 16));
}

#[test]
fn what_is_of_one_recording_is_refused_for_several_and_without_sound() {
    let folder = TempDir::new().unwrap();
    for format in ["audacity", "textgrid", "tracker"] {
        analyze(&folder, &["drop.txt", "drop.txt", "--format", format])
            .code(2)
            .stderr(predicate::str::contains("one at a time"));
    }
    analyze(&folder, &["drop.txt", "--cues", "marked.wav"])
        .code(2)
        .stderr(predicate::str::contains("has no sound to mark"));
}
