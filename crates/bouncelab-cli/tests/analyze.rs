//! `bouncelab analyze` as its users meet it: good files, bad files, wrong arguments.

#![expect(clippy::disallowed_methods, reason = "names of files of the project")]

use std::fs;
use std::path::{Path, PathBuf};

use assert_cmd::Command;
use bouncelab::impact::ImpactEvent;
use bouncelab::synth::{self, Noise, Scene};
use bouncelab_audio::SampleFormat;
use bouncelab_report::figure;
use bouncelab_testkit::{impact_events, write_wav};
use predicates::prelude::*;
use serde_json::Value;
use tempfile::TempDir;

const RATE_HZ: u32 = 44_100;

fn bouncelab() -> Command {
    Command::cargo_bin("bouncelab").unwrap()
}

fn analyze(file: &Path) -> Command {
    let mut command = bouncelab();
    command.arg("analyze").arg(file);
    command
}

fn json(command: &mut Command) -> Value {
    let output = command.args(["--format", "json"]).output().unwrap();
    serde_json::from_slice(&output.stdout).unwrap()
}

/// The first impact times of a drag-free drop whose first impact, at 2.4 m/s, is at time zero.
fn times(count: usize) -> Vec<f64> {
    impact_events(2.4, 0.9)
        .map(|event| event.time_s)
        .take(count)
        .collect()
}

fn write_samples(folder: &TempDir, name: &str, samples: &[f32]) -> PathBuf {
    let path = folder.path().join(name);
    write_wav(&path, RATE_HZ, SampleFormat::Float32, &[samples]);
    path
}

/// A recording of twenty impacts with restitution 0.9.
fn recording(folder: &TempDir) -> PathBuf {
    let events: Vec<ImpactEvent> = impact_events(2.4, 0.9).take(20).collect();
    let sound = synth::render(&events, &Scene::default(), 3).unwrap();
    write_samples(folder, "drop.wav", &sound.samples)
}

fn write_text(folder: &TempDir, name: &str, text: &str) -> PathBuf {
    let path = folder.path().join(name);
    fs::write(&path, text).unwrap();
    path
}

/// Sound and lists may come from another program, as by `ffmpeg ... | bouncelab analyze -`.
#[test]
fn standard_input_is_read_as_sound_or_as_a_list() {
    let folder = TempDir::new().unwrap();
    let of_file = json(&mut analyze(&recording(&folder)));
    let bytes = fs::read(recording(&folder)).unwrap();
    let of_input = json(analyze(Path::new("-")).write_stdin(bytes));
    assert_eq!(of_input["drops"], of_file["drops"]);
    assert_eq!(of_input["recording"], "-");

    let list: Vec<String> = times(9).iter().map(ToString::to_string).collect();
    let of_list = json(analyze(Path::new("-")).write_stdin(list.join("\n")));
    assert_eq!(of_list["drops"][0]["impacts"].as_array().unwrap().len(), 9);

    let wide: Vec<u8> = format!("\u{feff}{}", list.join("\n"))
        .encode_utf16()
        .flat_map(u16::to_le_bytes)
        .collect();
    json(analyze(Path::new("-")).write_stdin(wide));
    analyze(Path::new("-")).write_stdin("").assert().code(1);
    let cues = folder.path().join("cues.wav");
    let refused = analyze(Path::new("-"))
        .arg("--cues")
        .arg(cues)
        .write_stdin("")
        .assert();
    refused
        .code(2)
        .stderr(predicate::str::contains("needs a file"));
}

/// `--help` is short; `--help all` has everything.
#[test]
fn help_shows_what_a_first_user_needs() {
    let help = |words: &[&str]| {
        let output = bouncelab().args(words).output().unwrap();
        assert!(output.status.success());
        String::from_utf8(output.stdout).unwrap()
    };
    let short = help(&["analyze", "--help"]);
    let options = short
        .lines()
        .filter(|line| line.trim_start().starts_with("--"));
    assert_eq!(options.count(), 5, "{short}");
    assert!(
        short.contains("--ball") && short.contains("bouncelab analyze --help all"),
        "{short}"
    );
    let all = help(&["analyze", "--help", "all"]);
    assert!(
        all.contains("--air-viscosity") && !all.contains("All options:"),
        "{all}"
    );
}

/// A ball that keeps 28 % of its speed rests after three impacts: it is offered, and its restitution is that of the flights.
#[test]
fn a_dull_ball_is_offered_and_answered_with_its_width() {
    let folder = TempDir::new().unwrap();
    let few: Vec<ImpactEvent> = impact_events(3.43, 0.28).take(3).collect();
    let sound = synth::render(&few, &Scene::default(), 3).unwrap();
    let file = write_samples(&folder, "dull.wav", &sound.samples);
    assert_eq!(
        json(&mut analyze(&file))["drops"].as_array().unwrap().len(),
        0
    );
    let accepted = json(analyze(&file).args(["--accept", "1"]));
    let posterior = &accepted["drops"][0]["posterior"];
    for (name, truth, most_sd) in [("restitution", 0.28, 0.1), ("drop_height_m", 0.6, 0.4)] {
        let [value, sd] = ["value", "sd"].map(|it| posterior[name][it].as_f64().unwrap());
        let is_right = (value - truth).abs() < 3.0 * sd && sd > 0.01 && sd < most_sd;
        assert!(is_right, "{name}: {value} ± {sd}");
    }
}

/// Four clear impacts are too few to be taken for a drop: they are offered, count nowhere, and are analysed once accepted.
#[test]
fn what_may_be_a_drop_is_offered_and_counts_once_it_is_accepted() {
    let folder = TempDir::new().unwrap();
    let few: Vec<ImpactEvent> = impact_events(2.4, 0.9).take(4).collect();
    let sound = synth::render(&few, &Scene::default(), 3).unwrap();
    let file = write_samples(&folder, "few.wav", &sound.samples);
    let offered = json(&mut analyze(&file));
    assert_eq!(offered["drops"].as_array().unwrap().len(), 0);
    let [candidate] = offered["candidates"].as_array().unwrap().as_slice() else {
        panic!("{}", offered["candidates"])
    };
    let probability = candidate["probability"].as_f64().unwrap();
    assert!((0.01..=0.5).contains(&probability), "{probability}");
    assert_eq!(candidate["impacts"].as_array().unwrap().len(), 4);
    let offers = predicate::str::contains("Possible drop 1: from")
        .and(predicate::str::contains("--accept 1"));
    analyze(&file).assert().code(1).stdout("").stderr(offers);

    let accepted = json(analyze(&file).args(["--accept", "1"]));
    let [drop] = accepted["drops"].as_array().unwrap().as_slice() else {
        panic!("{}", accepted["drops"])
    };
    assert_eq!(drop["probability"], candidate["probability"]);
    let restitution = &drop["posterior"]["restitution"];
    let (value, sd) = (
        restitution["value"].as_f64().unwrap(),
        restitution["sd"].as_f64().unwrap(),
    );
    assert!(
        (value - 0.9).abs() < 3.0 * sd && sd < 0.05,
        "{value} ± {sd}"
    );

    let unknown = predicate::str::contains("no possible drop of the number 2");
    analyze(&file)
        .args(["--accept", "2"])
        .assert()
        .code(1)
        .stderr(unknown);
}

/// A table-tennis ball that was said to be of steel, which the air hardly slows.
#[test]
fn balls_are_compared_where_that_is_asked() {
    let folder = TempDir::new().unwrap();
    let file = folder.path().join("drop.wav");
    let mut synth = bouncelab();
    synth.arg("synth").arg(&file);
    let truth = "--ball table-tennis-40 --height 1m --restitution 0.9";
    synth.args(truth.split(' ')).assert().success();
    let stated = || {
        let mut command = analyze(&file);
        command.args(["--ball", "steel:20mm"]);
        command
    };
    let compared = json(stated().arg("--which-ball"));
    let balls = compared["drops"][0]["balls"].as_array().unwrap();
    let evidence = |ball: &Value| ball["log_bayes_factor"].as_f64().unwrap();
    assert!(balls.is_sorted_by(|a, b| evidence(a) >= evidence(b)));
    let of_truth = balls.iter().find(|ball| ball["ball"] == "table-tennis-40");
    assert!(evidence(of_truth.unwrap()) > 10.0_f64.ln(), "{balls:?}");
    let codes = compared["drops"][0]["diagnostics"].as_array().unwrap();
    assert!(
        codes
            .iter()
            .any(|it| it["code"] == "other-ball-fits-better")
    );
    let unasked = json(&mut stated());
    assert_eq!(unasked["drops"][0]["balls"], serde_json::json!([]));
    let table = stated().arg("--which-ball").assert().success();
    table.stdout(predicate::str::contains(
        "The times fit another kind of ball better",
    ));
}

#[test]
fn a_recording_gives_restitution_and_height() {
    let folder = TempDir::new().unwrap();
    let result = json(&mut analyze(&recording(&folder)));
    assert_eq!(result["schema"], "bouncelab.analysis/3");
    let drop = &result["drops"][0];
    assert_eq!(drop["impacts"].as_array().unwrap().len(), 20);
    assert!((drop["impacts"][0]["time_s"].as_f64().unwrap() - 0.5).abs() < 1e-4);
    let fit = &drop["log_linear_fit"];
    assert!((fit["restitution"]["value"].as_f64().unwrap() - 0.9).abs() < 1e-4);
    // v0^2 / 2 g.
    let height_m = 2.4 * 2.4 / 2.0 / 9.806_65;
    assert!((fit["drop_height_m"]["value"].as_f64().unwrap() - height_m).abs() < 1e-3);
    assert!(drop["probability"].as_f64().unwrap() > 0.99);
    let assumed = &result["settings"]["assumptions"][0];
    assert_eq!(assumed["code"], "ball-not-stated");
}

#[test]
fn text_is_read_at_a_glance() {
    let folder = TempDir::new().unwrap();
    analyze(&recording(&folder)).assert().success().stdout(
        predicate::str::contains("20 impacts")
            .and(predicate::str::contains("restitution"))
            .and(predicate::str::contains("drop height"))
            .and(predicate::str::contains("The ball was not stated")),
    );
}

#[test]
fn csv_has_a_row_for_each_impact() {
    let folder = TempDir::new().unwrap();
    let output = analyze(&recording(&folder))
        .args(["--format", "csv"])
        .output()
        .unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.starts_with("recording,drop,number,time_s,"));
    assert_eq!(text.lines().count(), 21);
}

#[test]
fn lists_of_times_are_read_in_three_formats() {
    let folder = TempDir::new().unwrap();
    let lines: Vec<String> = times(8).iter().map(ToString::to_string).collect();
    let files = [
        write_text(&folder, "a.txt", &lines.join("\n")),
        write_text(&folder, "a.csv", &format!("time_s\n{}\n", lines.join("\n"))),
        write_text(&folder, "a.json", &format!("[{}]", lines.join(","))),
    ];
    for file in files {
        let result = json(&mut analyze(&file));
        let restitution = result["drops"][0]["log_linear_fit"]["restitution"]["value"]
            .as_f64()
            .unwrap();
        assert!((restitution - 0.9).abs() < 1e-9, "{}", file.display());
    }
}

#[test]
fn a_missed_impact_in_a_list_leaves_a_gap() {
    let folder = TempDir::new().unwrap();
    let mut times: Vec<String> = times(9).iter().map(ToString::to_string).collect();
    times.remove(4);
    let file = write_text(&folder, "gap.txt", &times.join("\n"));
    let result = json(&mut analyze(&file));
    let drop = &result["drops"][0];
    assert_eq!(drop["impacts"][4]["number"], 6);
    let restitution = &drop["log_linear_fit"]["restitution"]["value"];
    assert!((restitution.as_f64().unwrap() - 0.9).abs() < 1e-9);
    assert_eq!(drop["diagnostics"][0]["code"], "impacts-missed");
}

#[test]
fn impacts_are_left_out_and_added_by_hand() {
    let folder = TempDir::new().unwrap();
    let file = recording(&folder);
    let time = (0.5 + times(20)[5]).to_string();
    let without = json(analyze(&file).args(["--exclude", &time]));
    assert_eq!(without["drops"][0]["impacts"].as_array().unwrap().len(), 19);
    assert_eq!(without["drops"][0]["impacts"][5]["number"], 7);
    let back = json(analyze(&file).args(["--exclude", &time, "--include", &time]));
    assert_eq!(back["drops"][0]["impacts"].as_array().unwrap().len(), 20);
    assert_eq!(back["drops"][0]["impacts"][5]["number"], 6);
}

#[test]
fn a_drop_left_out_by_hand_is_gone_and_another_may_come() {
    let folder = TempDir::new().unwrap();
    let file = recording(&folder);
    let options = |option: &str, times_s: &[f64]| -> Vec<String> {
        let words = times_s
            .iter()
            .flat_map(|t| [option.to_owned(), t.to_string()]);
        words.collect()
    };
    let impacts_s: Vec<f64> = times(20).iter().map(|time_s| 0.5 + time_s).collect();
    let all = options("--exclude", &impacts_s);
    let assert = analyze(&file).args(&all).assert().code(1);
    assert.stderr(predicate::str::contains("no flight remains"));
    let added_s = [40.0, 40.5, 40.9];
    let other = json(
        analyze(&file)
            .args(&all)
            .args(options("--include", &added_s)),
    );
    assert_eq!(other["drops"].as_array().unwrap().len(), 1);
    assert_eq!(other["drops"][0]["impacts"][0]["time_s"], 40.0);
}

#[test]
fn the_detected_channel_and_band_are_stated_and_can_be_overridden() {
    let folder = TempDir::new().unwrap();
    let file = recording(&folder);
    let details = analyze(&file).arg("--details").assert().success();
    details.stdout(predicate::str::contains(
        "20 impacts were detected, with the highest contrast from ",
    ));
    let low = json(analyze(&file).args(["--band", "..1500"]));
    let fit = &low["drops"][0]["log_linear_fit"];
    assert!((fit["restitution"]["value"].as_f64().unwrap() - 0.9).abs() < 1e-3);
    let none = analyze(&file).args(["--band", "30000.."]).assert().code(2);
    none.stderr(predicate::str::contains("above 30000 Hz"));
}

#[test]
fn a_range_of_flights_goes_into_the_line() {
    let folder = TempDir::new().unwrap();
    let result = json(analyze(&recording(&folder)).args(["--flights", "1..10"]));
    assert_eq!(result["drops"][0]["log_linear_fit"]["flights"], 10);
}

#[test]
fn figures_are_written_whole() {
    let folder = TempDir::new().unwrap();
    let figures = folder.path().join("figures");
    analyze(&recording(&folder))
        .arg("--figures")
        .arg(&figures)
        .assert()
        .success();
    let others = ["waveform", "drag", "drag-log"];
    let names = [&figure::names()[..], &others].concat();
    for name in &names {
        for ending in ["svg", "png", "pdf"] {
            let file = figures.join(format!("drop-{name}.{ending}"));
            assert!(
                fs::metadata(&file).unwrap().len() > 1000,
                "{}",
                file.display()
            );
        }
        let data = fs::read_to_string(figures.join(format!("drop-{name}.csv"))).unwrap();
        assert!(data.starts_with("panel,x_axis,"), "{data}");
        assert!(data.lines().count() > 1, "{name}");
    }
    assert_eq!(fs::read_dir(&figures).unwrap().count(), 4 * names.len());
}

#[test]
fn a_folder_that_cannot_be_made_is_an_error() {
    let folder = TempDir::new().unwrap();
    let file = recording(&folder);
    let inside_a_file = file.join("figures");
    analyze(&file)
        .arg("--figures")
        .arg(inside_a_file)
        .assert()
        .code(1)
        .stderr(predicate::str::contains("figures"));
}

#[test]
fn several_files_give_one_json_object_a_line_and_one_bad_file_does_not_stop_the_rest() {
    let folder = TempDir::new().unwrap();
    let good = recording(&folder);
    let missing = folder.path().join("missing.wav");
    let output = bouncelab()
        .args(["analyze", "--format", "json"])
        .args([&missing, &good])
        .assert()
        .code(1)
        .stderr(predicate::str::contains("missing.wav"))
        .get_output()
        .clone();
    let lines: Vec<Value> = String::from_utf8(output.stdout)
        .unwrap()
        .lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect();
    assert_eq!(lines[0]["drops"].as_array().unwrap().len(), 0);
    assert_eq!(lines[1]["drops"].as_array().unwrap().len(), 1);
}

/// A file without a drop: exit status 1, the reason on stderr, and empty `drops` in JSON.
#[track_caller]
fn no_drop(file: &Path, reason: &str) {
    analyze(file)
        .args(["--format", "json"])
        .assert()
        .code(1)
        .stderr(predicate::str::contains(reason).and(predicate::str::contains("panicked").not()))
        .stdout(predicate::function(|text: &str| {
            let result: Value = serde_json::from_str(text).unwrap();
            result["drops"].as_array().unwrap().is_empty()
                && result["no_drop"]["message"].is_string()
        }));
}

#[test]
fn bad_files_get_a_clear_message() {
    let folder = TempDir::new().unwrap();
    no_drop(&folder.path().join("missing.wav"), "missing.wav");
    no_drop(folder.path(), "folder");
    no_drop(&write_text(&folder, "empty.wav", ""), "empty");
    no_drop(
        &write_text(&folder, "text.wav", "Dear diary, today a ball bounced."),
        "text.wav",
    );
    no_drop(&write_text(&folder, "words.txt", "one\ntwo\n"), "line 1");
    no_drop(&write_text(&folder, "one.txt", "1.5\n"), "two impact times");
    no_drop(&write_text(&folder, "unsorted.txt", "1\n3\n2\n"), "line 3");
}

#[test]
fn sounds_without_a_drop_say_why() {
    let folder = TempDir::new().unwrap();
    let quiet = |name: &str, samples: &[f32]| write_samples(&folder, name, samples);
    no_drop(&quiet("silence.wav", &vec![0.0; 44_100]), "silent");
    no_drop(&quiet("constant.wav", &vec![0.3; 44_100]), "silent");
    no_drop(&quiet("one.wav", &[0.5]), "no drop found");
    no_drop(&not_numbers(&folder), "no drop found");
    let noise = synth::render(
        &[],
        &Scene {
            tail_s: 600.0,
            noise: Some(Noise::pink(0.0)),
            ..Scene::default()
        },
        5,
    );
    no_drop(
        &quiet("noise.wav", &noise.unwrap().samples),
        "no drop found",
    );
    let clock: Vec<ImpactEvent> = (0..20)
        .map(|n| ImpactEvent {
            time_s: 0.5 * f64::from(n),
            speed_m_s: 1.0,
        })
        .collect();
    let clock = synth::render(&clock, &Scene::default(), 5).unwrap();
    no_drop(
        &quiet("clock.wav", &clock.samples),
        "are periodic, about every 500 ms, like",
    );
}

/// A recording of which every sample is NaN, as no writer would make it.
fn not_numbers(folder: &TempDir) -> PathBuf {
    let path = write_samples(folder, "nan.wav", &vec![0.25; 44_100]);
    let mut bytes = fs::read(&path).unwrap();
    let (from, to) = (0.25_f32.to_le_bytes(), f32::NAN.to_le_bytes());
    let header = bytes.windows(4).position(|window| window == from).unwrap();
    bytes[header..]
        .as_chunks_mut::<4>()
        .0
        .iter_mut()
        .for_each(|sample| *sample = to);
    fs::write(&path, bytes).unwrap();
    path
}

#[test]
fn absurd_arguments_are_refused_before_any_file_is_read() {
    for (arguments, reason) in [
        (&["--mass", "-2.5g", "--diameter", "38mm"][..], "mass"),
        (&["--mass", "2.5g", "--diameter", "0"], "diameter"),
        (&["--mass", "2.5g"], "--diameter"),
        (&["--ball", "tenniss"], "tennis"),
        (&["--drag", "constnt:0.4"], "drag law"),
        (&["--drag", "constant:-1"], "drag coefficient"),
        (&["--temperature", "1000C"], "temperature"),
        (&["--humidity", "140%"], "humidity"),
        (&["--gravity", "0"], "gravity"),
        (&["--latitude", "95"], "latitude"),
        (&["--flights", "10..1"], "range"),
        (&["--channel", "0"], "channel"),
        (&["--pressure", "3kg"], "hpa"),
    ] {
        bouncelab()
            .args(["analyze", "nothing.wav"])
            .args(arguments)
            .assert()
            .code(2)
            .stderr(predicate::function(|text: &str| {
                text.to_lowercase().contains(reason)
            }));
    }
}

#[test]
fn a_channel_that_is_not_there_is_wrong_usage() {
    let folder = TempDir::new().unwrap();
    analyze(&recording(&folder))
        .args(["--channel", "3"])
        .assert()
        .code(2)
        .stderr(predicate::str::contains("no channel 3"));
}
