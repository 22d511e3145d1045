//! A ball means the same however it is stated: as a preset or by a word in the library, as an argument of the program, in
//! the notes of a session; and `bouncelab balls` lists what can be stated.

#![expect(clippy::float_cmp, reason = "the same ball gives the same digits")]

use std::fs;
use std::path::Path;

use assert_cmd::Command;
use bouncelab::ball::{self, Ball};
use bouncelab::inference::SamplerConfig;
use bouncelab::settings::Settings;
use bouncelab::{Options, analyze_times};
use bouncelab_testkit::impact_events;
use predicates::prelude::*;
use predicates::str::contains;
use serde_json::Value;
use tempfile::TempDir;

const DRAWS: usize = 1000;

fn bouncelab() -> Command {
    Command::cargo_bin("bouncelab").unwrap()
}

/// Impact times as a list has them, and as numbers.
fn times() -> (String, Vec<f64>) {
    let lines = impact_events(2.4, 0.85).take(8);
    let lines: Vec<String> = lines.map(|it| format!("{:.6}", it.time_s)).collect();
    let numbers = lines.iter().map(|line| line.parse().unwrap());
    (lines.join("\n"), numbers.collect())
}

/// Restitution and drop height with their standard uncertainties.
type Answer = [f64; 4];

fn of_options(options: Options) -> Answer {
    let options = options.with_sampler(SamplerConfig {
        draws: DRAWS,
        ..SamplerConfig::default()
    });
    let recording = analyze_times(&times().1, &options);
    let posterior = recording.drops[0].posterior.as_ref().unwrap();
    let (e, h) = (&posterior.restitution, &posterior.drop_height_m);
    [e.value, e.sd, h.value, h.sd]
}

fn of_settings(kind: &str, mass_kg: Option<f64>) -> Answer {
    let mut settings = Settings::of_ball(kind);
    settings.ball.mass_kg = mass_kg;
    of_options(settings.resolve().unwrap().options)
}

fn of_program(list: &Path, arguments: &[&str]) -> Answer {
    let mut command = bouncelab();
    command.arg("analyze").arg(list).args(arguments);
    command.args(["--draws", &DRAWS.to_string(), "--format", "json"]);
    let output = command.output().unwrap();
    let document: Value = serde_json::from_slice(&output.stdout).unwrap();
    let posterior = &document["drops"][0]["posterior"];
    ["restitution", "drop_height_m"]
        .map(|name| &posterior[name])
        .iter()
        .flat_map(|estimate| [&estimate["value"], &estimate["sd"]])
        .map(|number| number.as_f64().unwrap())
        .collect::<Vec<_>>()
        .try_into()
        .unwrap()
}

/// By the notes of a session: fields, and what is noted.
fn of_session(folder: &Path, fields: &str, noted: &str) -> Answer {
    let file = folder.join("notes.csv");
    fs::write(&file, format!("recording,{fields}\ndrop.txt,{noted}\n")).unwrap();
    let results = folder.join("results");
    let mut command = bouncelab();
    command.arg("session").arg(folder.join("drop.txt"));
    command
        .arg("--notes")
        .arg(file)
        .arg("--output")
        .arg(&results);
    command.args(["--draws", &DRAWS.to_string(), "--tables", "jsonl"]);
    command.assert().success();
    let drops = fs::read_to_string(results.join("drops.jsonl")).unwrap();
    let drop: Value = serde_json::from_str(drops.lines().next().unwrap()).unwrap();
    [
        "restitution",
        "restitution_sd",
        "drop_height_m",
        "drop_height_sd_m",
    ]
    .map(|column| drop[column].as_f64().unwrap_or_else(|| panic!("{drop}")))
}

/// A session samples without the single impacts, so that its draws are others: as far apart as two seeds. With a contact
/// time known to 10 instead of 50 % the uncertainties would be those of another ball.
fn are_alike(a: Answer, b: Answer) -> bool {
    [0, 2].into_iter().all(|value| {
        let sd = value + 1;
        (a[value] - b[value]).abs() < 0.5 * b[sd] && (0.6..1.6).contains(&(a[sd] / b[sd]))
    })
}

#[test]
fn a_ball_means_the_same_in_every_front_end() {
    for (name, words, noted) in [
        ("table-tennis-40", "Ping-Pong", "Tischtennisball"),
        ("tennis", "balle de tennis", "TENNIS"),
        ("steel", "steel bearing", "Stahlkugel"),
        ("basketball", "baloncesto", "Basketball"),
    ] {
        let folder = TempDir::new().unwrap();
        let list = folder.path().join("drop.txt");
        fs::write(&list, times().0).unwrap();
        let preset = ball::preset(name).unwrap();
        let expected = of_options(Options::new(preset));
        assert_eq!(of_options(Options::default().with_ball(preset)), expected);
        assert_eq!(of_settings(words, None), expected, "{words}");
        assert_eq!(of_program(&list, &["--ball", words]), expected, "{words}");
        let noted = of_session(folder.path(), "ball", noted);
        assert!(are_alike(noted, expected), "{noted:?} {expected:?}");
    }
}

#[test]
fn a_weighed_ball_of_a_kind_means_the_same_in_every_front_end() {
    let folder = TempDir::new().unwrap();
    let list = folder.path().join("drop.txt");
    fs::write(&list, times().0).unwrap();
    let weighed = ball::preset("tennis").unwrap().measured(Some(0.058), None);
    let expected = of_options(Options::default().with_ball(weighed.unwrap()));
    assert_eq!(of_settings("tennis", Some(0.058)), expected);
    let arguments = ["--ball", "tennis", "--mass", "58g"];
    assert_eq!(of_program(&list, &arguments), expected);
    let noted = of_session(folder.path(), "ball,mass", "tennis,58g");
    assert!(are_alike(noted, expected), "{noted:?} {expected:?}");
}

/// Only mass and diameter: a basketball has no contact time of a table-tennis ball.
#[test]
fn a_ball_without_a_kind_means_the_same_in_every_front_end() {
    let folder = TempDir::new().unwrap();
    let list = folder.path().join("drop.txt");
    fs::write(&list, times().0).unwrap();
    let own = Options::default().with_ball(Ball::new(0.6, 0.243).unwrap());
    assert!((5e-3..2e-2).contains(&own.contact_time_s));
    let expected = of_options(own);
    let arguments = ["--mass", "600g", "--diameter", "243mm"];
    assert_eq!(of_program(&list, &arguments), expected);
    let noted = of_session(folder.path(), "mass,diameter", "600g,243mm");
    assert!(are_alike(noted, expected), "{noted:?} {expected:?}");
}

#[test]
fn balls_are_listed_with_words_and_source() {
    let listed = bouncelab().arg("balls").assert().success();
    let output = String::from_utf8(listed.get_output().stdout.clone()).unwrap();
    for preset in ball::presets() {
        assert!(output.contains(preset.name) && output.contains(preset.source));
        assert!(preset.words.iter().all(|word| output.contains(word)));
    }
    assert!(
        output.contains("2.7 g, 40 mm, contact 1.0 ± 0.5 ms"),
        "{output}"
    );
}

#[test]
fn an_unknown_ball_gets_the_nearest_and_where_they_are_listed() {
    bouncelab()
        .args(["analyze", "nowhere.txt", "--ball", "pingpog"])
        .assert()
        .code(2)
        .stderr(contains("“table-tennis-40”").and(contains("bouncelab balls")));
}

#[test]
fn a_mass_needs_a_diameter_or_a_kind() {
    for arguments in [["--mass", "58g"], ["--diameter", "66mm"]] {
        let mut command = bouncelab();
        command.args(["analyze", "nowhere.txt"]).args(arguments);
        command.assert().code(2).stderr(contains("--ball"));
    }
}
