//! `bouncelab session` as its users meet it: notes good and bad, runs that are stopped.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command as Plain, Stdio};
use std::thread;

use assert_cmd::Command;
use bouncelab::impact::ImpactEvent;
use bouncelab::synth::{self, Rendered, Scene};
use bouncelab_audio::SampleFormat;
use bouncelab_testkit::{impact_events, write_wav};
use predicates::prelude::*;
use predicates::str::contains;
use tempfile::TempDir;

/// The sound of a dozen impacts.
fn drop_of(seed: u16) -> Rendered {
    let first_speed_m_s = 2.2 + 0.01 * f64::from(seed);
    let events: Vec<ImpactEvent> = impact_events(first_speed_m_s, 0.9).take(12).collect();
    let scene = Scene {
        lead_in_s: 0.2,
        tail_s: 0.2,
        ..Scene::default()
    };
    synth::render(&events, &scene, seed.into()).unwrap()
}

/// A folder for recordings and one for results.
struct Workspace(TempDir);

impl Workspace {
    /// A workspace with these files of notes.
    fn new(notes: &[(&str, &str)]) -> Self {
        let workspace = Self(TempDir::new().unwrap());
        fs::create_dir(workspace.recordings()).unwrap();
        for (name, text) in notes {
            fs::write(workspace.recordings().join(name), text).unwrap();
        }
        workspace
    }

    fn recordings(&self) -> PathBuf {
        self.0.path().join("recordings")
    }

    fn results(&self) -> PathBuf {
        self.0.path().join("results")
    }

    /// Adds a recording of a dozen impacts.
    fn record(&self, name: impl AsRef<Path>, seed: u16) -> &Self {
        let sound = drop_of(seed);
        let path = self.recordings().join(name);
        write_wav(
            path,
            sound.sample_rate_hz,
            SampleFormat::Int16,
            &[&sound.samples],
        );
        self
    }

    fn session(&self) -> Command {
        let mut command = Command::cargo_bin("bouncelab").unwrap();
        command.args(self.arguments());
        command
    }

    /// A session of the rows that a cluster wrote.
    fn cluster_session(&self, rows: &Path) -> Command {
        let mut command = Command::cargo_bin("bouncelab").unwrap();
        command.args(["session", "--from"]).arg(rows);
        command.arg("--output").arg(self.results());
        command
    }

    /// A session in the background.
    fn start(&self, more: &[&str]) -> Child {
        let program = Command::cargo_bin("bouncelab").unwrap();
        Plain::new(program.get_program())
            .args(self.arguments())
            .args(more)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap()
    }

    fn arguments(&self) -> Vec<std::ffi::OsString> {
        let (from, to) = (self.recordings(), self.results());
        let words: [&std::ffi::OsStr; 6] = [
            "session".as_ref(),
            from.as_ref(),
            "--output".as_ref(),
            to.as_ref(),
            "--draws".as_ref(),
            "100".as_ref(),
        ];
        words.map(ToOwned::to_owned).into()
    }

    /// The content of every table.
    fn tables(&self) -> Vec<(String, Vec<u8>)> {
        let names = [
            "drops.parquet",
            "drops.csv",
            "drops.jsonl",
            "impacts.parquet",
            "impacts.csv",
            "impacts.jsonl",
            "session.json",
        ];
        let content = |name: &str| fs::read(self.results().join(name)).unwrap();
        names.map(|name| (name.to_owned(), content(name))).into()
    }
}

#[test]
fn a_folder_with_names_that_speak() {
    let workspace = Workspace::new(&[]);
    for (seed, name) in ["red_25cm_1", "red_25cm_2", "blue_25cm_1", "blue_25cm_2"]
        .iter()
        .enumerate()
    {
        workspace.record(format!("{name}.wav"), seed as u16);
    }
    let report = workspace.0.path().join("session.html");
    workspace
        .session()
        .args(["--pattern", "{ball}_{height}_{}"])
        .args(["--ball", "table-tennis-40", "--figures", "--details"])
        .arg("--report")
        .arg(&report)
        .assert()
        .success()
        .stdout(contains("4 drops in 4 recordings"))
        .stdout(contains("Differences of groups"))
        .stdout(contains("drops.parquet"));
    for figure in ["groups.svg", "intervals.png", "run.svg"] {
        assert!(workspace.results().join(figure).is_file(), "{figure}");
    }
    let page = fs::read_to_string(report).unwrap();
    assert!(page.contains("4 drops in 4 recordings") && page.contains("<svg"));
    let csv = fs::read_to_string(workspace.results().join("drops.csv")).unwrap();
    assert!(csv.starts_with("recording,drop,ball,height,start_s,impacts,"));
    assert!(csv.contains("blue_25cm_1.wav,1,blue,25 cm,0."), "{csv}");
    let lines = fs::read_to_string(workspace.results().join("drops.jsonl")).unwrap();
    let first: serde_json::Value = serde_json::from_str(lines.lines().next().unwrap()).unwrap();
    assert_eq!(first["recording"], "blue_25cm_1.wav");
    assert_eq!(first["noted_height_m"], 0.25);
}

/// With the same names, and by processes of their own, so that they find the same recordings.
#[test]
fn an_archive_gives_the_tables_of_its_folder() {
    let workspace = Workspace::new(&[]);
    for (seed, name) in ["red_25cm_1.wav", "blue_25cm_1.wav"].iter().enumerate() {
        workspace.record(name, seed as u16);
    }
    let archive = workspace.0.path().join("class.zip");
    let mut writer = zip::ZipWriter::new(fs::File::create(&archive).unwrap());
    for entry in fs::read_dir(workspace.recordings()).unwrap() {
        let entry = entry.unwrap();
        let name = entry.file_name().into_string().unwrap();
        let packed = zip::write::SimpleFileOptions::default();
        writer.start_file(name, packed).unwrap();
        std::io::copy(&mut fs::File::open(entry.path()).unwrap(), &mut writer).unwrap();
    }
    writer.finish().unwrap();
    let words = "--pattern {ball}_{height}_{} --ball table-tennis-40";
    let words: Vec<&str> = words.split(' ').collect();
    workspace.session().args(&words).assert().success();
    let of_folder = workspace.tables();
    fs::remove_dir_all(workspace.results()).unwrap();
    let mut arguments = workspace.arguments();
    arguments[1] = archive.into();
    let mut session = Command::cargo_bin("bouncelab").unwrap();
    session.args(arguments).args(&words).assert().success();
    assert_eq!(workspace.tables(), of_folder);
}

#[test]
fn a_broken_session_file_has_a_line_and_a_column() {
    let workspace = Workspace::new(&[("session.toml", "title = \"x\"\n[all]\nheight = 30,5\n")]);
    workspace.record("a.wav", 1);
    workspace
        .session()
        .assert()
        .code(2)
        .stderr(contains("session.toml, line 3, column"));
}

#[test]
fn implausible_units_are_rejected_unless_allowed() {
    let notes = "[all]\nheight = \"30.5 m\"\nball = \"own\"\n[balls.own]\nmass = \"2.5kg\"\ndiameter = \"38mm\"\n";
    let workspace = Workspace::new(&[("session.toml", notes)]);
    workspace.record("a.wav", 1);
    workspace
        .session()
        .assert()
        .code(2)
        .stderr(contains("30.5 m? Did you mean 30.5 cm?").and(contains("session.toml, line 2")))
        .stderr(contains("2.50 kg").and(contains("Did you mean 2.5 g?")));
    assert!(
        !workspace.results().exists(),
        "nothing is heard before the notes are clear"
    );
    workspace
        .session()
        .arg("--allow-implausible")
        .assert()
        .success();
}

#[test]
fn contradictions_name_both_sides() {
    let workspace = Workspace::new(&[
        (
            "session.toml",
            "pattern = \"{ball}_{height}\"\nnotes = \"notes.csv\"\n",
        ),
        (
            "notes.csv",
            "recording,ball,height (mm)\nred_25cm.wav,blue,250\n",
        ),
    ]);
    workspace.record("red_25cm.wav", 1);
    workspace
        .session()
        .args(["--ball", "tennis"])
        .assert()
        .code(2)
        .stderr(contains("\"red\" by the file name").and(contains("\"blue\" by ")))
        .stderr(contains("notes.csv, line 2"))
        // 25 cm and 250 mm are the same.
        .stderr(contains("height").not());
}

#[test]
fn what_is_missing_is_asked_for() {
    let workspace = Workspace::new(&[(
        "session.toml",
        "[recordings.\"a.wav\"]\nsurface = \"steel\"\n",
    )]);
    workspace.record("a.wav", 1).record("b.wav", 2);
    workspace
        .session()
        .assert()
        .code(2)
        .stderr(contains("b.wav: no surface is noted").and(contains("[recordings.\"b.wav\"]")))
        .stderr(contains("CSV").and(contains("{surface}")));
    workspace
        .session()
        .arg("--allow-missing")
        .assert()
        .success();
}

#[test]
fn an_unknown_ball_is_asked_for() {
    let workspace = Workspace::new(&[]);
    workspace.record("red_1.wav", 1);
    workspace
        .session()
        .args(["--pattern", "{ball}_{}"])
        .assert()
        .code(2)
        .stderr(contains("what ball is \"red\"?").and(contains("[balls.red]")))
        .stderr(contains("table-tennis-40"));
}

#[test]
fn one_bad_recording_does_not_stop_the_rest() {
    let workspace = Workspace::new(&[("broken.wav", "RIFFnonsense"), ("empty.wav", "")]);
    workspace.record("a.wav", 1).record("b.wav", 1);
    workspace
        .session()
        .assert()
        .success()
        .stdout(contains(
            "1 drop in 4 recordings, 2 not readable, 1 the same as another",
        ))
        .stdout(contains("broken.wav: "))
        .stdout(contains("b.wav: a.wav"));
}

#[test]
fn nothing_but_bad_recordings_is_a_failure() {
    let workspace = Workspace::new(&[("broken.wav", "RIFFnonsense")]);
    workspace
        .session()
        .assert()
        .code(1)
        .stderr(contains("no recording holds a drop"));
}

#[cfg(target_os = "linux")]
#[test]
fn names_that_are_no_text_are_written_out() {
    use std::os::unix::ffi::OsStrExt;
    let workspace = Workspace::new(&[]);
    workspace.record(std::ffi::OsStr::from_bytes(b"caf\xe9.wav"), 1);
    workspace.session().assert().success();
    let csv = fs::read_to_string(workspace.results().join("drops.csv")).unwrap();
    assert!(csv.contains("\ncaf\\xe9.wav,1,"));
}

#[test]
fn an_output_that_cannot_be_written_is_said_at_once() {
    let workspace = Workspace::new(&[]);
    workspace.record("a.wav", 1);
    fs::write(workspace.results(), "a file where the folder should be").unwrap();
    workspace
        .session()
        .assert()
        .code(1)
        .stderr(contains("cannot write").and(contains("--output DIR")));
}

#[test]
fn a_changed_recording_is_analysed_again() {
    let workspace = Workspace::new(&[]);
    workspace.record("a.wav", 1).record("b.wav", 2);
    let again = |more: &[&str], kept: &str| {
        workspace
            .session()
            .args(more)
            .assert()
            .success()
            .stderr(contains(kept));
    };
    workspace
        .session()
        .assert()
        .success()
        .stderr(contains("earlier").not());
    again(&[], "2 of 2 recordings were analysed in an earlier run");
    workspace.record("a.wav", 3);
    again(&[], "1 of 2 recordings");
    // Another ball, other results; grouping alone changes none.
    workspace
        .session()
        .args(["--ball", "tennis"])
        .assert()
        .success()
        .stderr(contains("earlier").not());
    again(
        &["--ball", "tennis", "--compare-at", "1.2"],
        "2 of 2 recordings",
    );
}

#[test]
fn questions_that_make_no_sense_are_refused() {
    let workspace = Workspace::new(&[]);
    workspace.record("a.wav", 1);
    let refused = |arguments: &[&str], words: &str| {
        workspace
            .session()
            .args(arguments)
            .assert()
            .code(2)
            .stderr(contains(words.to_owned()));
    };
    refused(&["--by", "colour"], "nothing is noted of that");
    refused(&["--exclude", "z.wav"], "there is no such drop");
    refused(
        &["--exclude", "a.wav,a.wav"],
        "--exclude before each of several",
    );
    refused(&["--pattern", "{ball"], "has a { without a }");
    workspace
        .session()
        .args(["--notes", "nowhere.csv"])
        .assert()
        .code(1)
        .stderr(contains("cannot read nowhere.csv"));
}

/// The name is one argument, whatever stands in it.
#[test]
fn a_name_with_a_comma_can_be_excluded() {
    let workspace = Workspace::new(&[]);
    for (seed, name) in ["one, two.wav", "three.wav", "four.wav"].iter().enumerate() {
        workspace.record(name, seed as u16);
    }
    workspace
        .session()
        .args(["--exclude", "one, two.wav", "--exclude", "three.wav"])
        .assert()
        .success()
        .stdout(contains("one, two.wav: left out by hand"))
        .stdout(contains("three.wav: left out by hand"));
}

/// Names that do not fit, the same sound noted twice, what is left out by hand, and why nothing is compared.
#[test]
fn what_is_said_of_recordings_is_in_the_language_of_the_results() {
    let workspace = Workspace::new(&[]);
    for (seed, name) in [(1, "a_rot.wav"), (1, "b_blau.wav"), (2, "c_rot.wav")] {
        workspace.record(name, seed);
    }
    for seed in 3..9 {
        workspace.record(format!("{seed}.wav"), seed);
    }
    let said = |arguments: &[&str]| {
        let mut session = workspace.session();
        session.args(["--language", "de", "--ball", "golf"]);
        session.args(["--pattern", "{}_{surface}", "--allow-missing"]);
        let run = session.args(arguments).assert().success();
        String::from_utf8(run.get_output().stdout.clone()).unwrap()
    };
    let compared = said(&["--exclude", "c_rot.wav"]);
    for words in [
        "6 Namen passen nicht zum Muster „{}_{surface}“: 3.wav, 4.wav, 5.wav, 6.wav und 2 weitere",
        "a_rot.wav und b_blau.wav sind derselbe Ton",
        "c_rot.wav: von Hand ausgelassen",
    ] {
        assert!(compared.contains(words), "{compared}");
    }
    let all = compared + &said(&["--no-inference"]);
    let english = [" and ", " not ", " the ", " left out "];
    let found: Vec<_> = english.iter().filter(|it| all.contains(**it)).collect();
    assert!(found.is_empty(), "{found:?}: {all}");
}

#[test]
fn what_was_assumed_is_said_of_the_recordings_that_it_concerns() {
    let workspace = Workspace::new(&[(
        "notes.csv",
        "recording,ball\na.wav,tennis\nb.wav,basketball\n",
    )]);
    workspace.record("a.wav", 1).record("b.wav", 2);
    let notes = workspace.recordings().join("notes.csv");
    let mut session = workspace.session();
    session.arg("--no-inference").arg("--notes").arg(notes);
    session.assert().success().stdout(contains(
        "Assumed: The ball touches the surface for 15.0 ms (in 1 of 2 recordings). The ball touches the surface for \
         5.00 ms (in 1 of 2 recordings). Air of",
    ));
}

/// By what a session says of one recording: the ball, and the drag law of its settings.
#[test]
fn settings_of_the_session_file_hold_unless_stated_elsewhere() {
    let file =
        "[settings.air]\ndrag = \"none\"\n[settings.ball]\nkind = \"tennis\"\nmass_kg = 0.058\n";
    let contact_time_s = |arguments: &[&str], notes: &str| {
        let workspace = Workspace::new(&[("session.toml", &[file, notes].concat())]);
        workspace.record("a.wav", 1);
        let mut session = workspace.session();
        session.arg("--no-inference").args(arguments);
        let output = session.assert().success().get_output().stdout.clone();
        String::from_utf8(output).unwrap()
    };
    let of_file = contact_time_s(&[], "");
    assert!(of_file.contains("for 5.00 ms"), "{of_file}");
    let of_argument = contact_time_s(&["--ball", "basketball"], "");
    assert!(of_argument.contains("for 15.0 ms"), "{of_argument}");
    let of_notes = contact_time_s(&["--ball", "basketball"], "[all]\nball = \"football\"\n");
    assert!(of_notes.contains("for 10.0 ms"), "{of_notes}");

    let refused = |settings: &str, problem: &str| {
        let workspace = Workspace::new(&[("session.toml", settings)]);
        workspace.record("a.wav", 1);
        let refused = workspace.session().assert().code(2);
        refused.stderr(contains(problem.to_owned()));
    };
    refused("[settings.ball]\nkind = \"steel:10\"\n", "10 mm?");
    refused("[settings.edits]\nexclude_s = [1.0]\n", "[settings.edits]");
    refused("[settings.ball]\nkind = \"pingpogn\"\n", "table-tennis-40");
}

/// A field of any name may be noted, so a slip would make one more and lose what was meant.
#[test]
fn slips_of_the_pen_are_questioned() {
    let asks = |notes: &str, inference: &str| {
        let workspace = Workspace::new(&[("session.toml", notes)]);
        workspace.record("a.wav", 1);
        let refused = workspace.session().assert().code(2);
        refused.stderr(contains(inference.to_owned()));
    };
    asks(
        "[all]\ntemprature = \"20C\"\n",
        "a temprature? Did you mean temperature?",
    );
    asks("[all]\nbal = \"red\"\n", "a bal? Did you mean ball?");
    asks(
        "[all]\nball = \"tenniss\"\n",
        "what ball is \"tenniss\"? Did you mean tennis?",
    );
}

#[test]
fn the_same_sound_noted_differently_is_remarked_on() {
    let workspace = Workspace::new(&[("session.toml", "pattern = \"{surface}_{}\"\n")]);
    workspace.record("glass_1.wav", 1);
    let recordings = workspace.recordings();
    fs::copy(
        recordings.join("glass_1.wav"),
        recordings.join("wood_1.wav"),
    )
    .unwrap();
    workspace.session().assert().success().stdout(contains(
        "the surface of the one is \"glass\" and that of the other \"wood\"",
    ));
}

/// The order of work is nobody's business.
#[test]
fn any_number_of_threads_gives_the_same_tables() {
    let workspace = Workspace::new(&[]);
    for seed in 0..6 {
        workspace.record(format!("{seed}.wav"), seed);
    }
    workspace.session().args(["--jobs", "1"]).assert().success();
    let one = workspace.tables();
    fs::remove_dir_all(workspace.results()).unwrap();
    workspace.session().args(["--jobs", "4"]).assert().success();
    assert!(one == workspace.tables());
}

/// Killed once a number of recordings are analysed, and resumed: the tables are those of a run that nobody disturbed.
/// `cargo xtask test faults` kills at other moments too.
#[test]
fn a_killed_run_goes_on_and_ends_the_same() {
    const RECORDINGS: u16 = 10;
    let workspace = Workspace::new(&[("session.toml", "pattern = \"{operator}_{}\"\n")]);
    for seed in 0..RECORDINGS {
        let operator = if seed % 2 == 0 { "ada" } else { "bob" };
        workspace.record(format!("{operator}_{seed}.wav"), seed);
    }
    workspace.session().assert().success();
    let undisturbed = workspace.tables();
    for analysed in 0..=RECORDINGS {
        fs::remove_dir_all(workspace.results()).unwrap();
        let mut session = workspace.start(&[]);
        let journal = workspace.results().join("journal.jsonl");
        let lines = || fs::read_to_string(&journal).map_or(0, |text| text.lines().count());
        while lines() < analysed.into() && session.try_wait().unwrap().is_none() {
            thread::yield_now();
        }
        // It may have ended by itself.
        let _ = session.kill();
        session.wait().unwrap();
        let output = workspace.session().output().unwrap();
        assert!(output.status.success());
        let said = String::from_utf8_lossy(&output.stderr);
        let goes_on = said.contains("analysed in an earlier run");
        assert!(goes_on || analysed == 0, "{analysed}: {said}");
        assert!(workspace.tables() == undisturbed, "killed after {analysed}");
        assert_eq!(drafts(&workspace.results()), [""; 0]);
    }
}

/// The process in which it analyses is killed, whatever that does then: what was lost is analysed again.
#[cfg(target_os = "linux")]
#[test]
fn a_killed_worker_costs_nothing() {
    let workspace = Workspace::new(&[]);
    for seed in 0..10 {
        workspace.record(format!("{seed}.wav"), seed);
    }
    workspace.session().assert().success();
    let undisturbed = workspace.tables();
    fs::remove_dir_all(workspace.results()).unwrap();
    let mut session = workspace.start(&["--jobs", "1"]);
    let worker = worker_of(&mut session, |_| true);
    Plain::new("kill").args(["-9", &worker]).status().unwrap();
    assert!(session.wait().unwrap().success());
    assert!(workspace.tables() == undisturbed);
}

/// A worker looks for recordings itself, and may find others than its session did.
#[test]
fn a_worker_answers_for_what_it_was_asked() {
    let workspace = Workspace::new(&[]);
    workspace.record("b.wav", 1);
    workspace.session().assert().success();
    let journal = fs::read_to_string(workspace.results().join("journal.jsonl")).unwrap();
    let (_, line) = journal.trim().split_once(' ').unwrap();
    let kept: serde_json::Value = serde_json::from_str(line).unwrap();
    let ask = |name: &str| -> serde_json::Value {
        let request = serde_json::json!({"name": name, "key": kept["key"]});
        let answer = workspace
            .session()
            .arg("--worker")
            .write_stdin(format!("{request}\n"))
            .assert()
            .success();
        serde_json::from_slice(&answer.get_output().stdout).unwrap()
    };
    workspace.record("a.wav", 2);
    assert_eq!(ask("b.wav"), kept["result"], "now it is the second");
    assert!(ask("a.wav").is_null(), "it has another content");
    assert!(ask("c.wav").is_null(), "it is not there");
    workspace.record("b.wav", 3);
    assert!(ask("b.wav").is_null(), "it was replaced");
}

/// Waits for a process that a session has started and of which this holds.
#[cfg(target_os = "linux")]
fn worker_of(session: &mut Child, holds: impl Fn(&str) -> bool) -> String {
    while session.try_wait().unwrap().is_none() {
        if let Some(worker) = child_of(session.id()).filter(|worker| holds(worker)) {
            return worker;
        }
        thread::yield_now();
    }
    panic!("the session has ended");
}

/// A process that was started by this one.
#[cfg(target_os = "linux")]
fn child_of(parent: u32) -> Option<String> {
    let parent = parent.to_string();
    let is_child = |process: &String| {
        let about = fs::read_to_string(format!("/proc/{process}/stat")).unwrap_or_default();
        // The name, which may be anything, then the state and the parent.
        let after_name = about.rsplit_once(") ").map_or("", |(_, rest)| rest);
        after_name.split(' ').nth(1) == Some(&parent)
    };
    let entries = fs::read_dir("/proc").unwrap().flatten();
    let mut names = entries.filter_map(|entry| entry.file_name().into_string().ok());
    names.find(is_child)
}

/// A minute of bursts of noise, once a second, so that all of it is remembered.
#[cfg(target_os = "linux")]
#[test]
fn a_recording_that_takes_too_much_memory_is_named_and_the_rest_goes_on() {
    const RATE_HZ: u32 = 96_000;
    let workspace = Workspace::new(&[]);
    workspace.record("a.wav", 1).record("b.wav", 2);
    let mut dice = 1_u32;
    let mut noise = || -> Vec<f32> {
        let next = |n| {
            dice = dice.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let level = if n % RATE_HZ < 2_000 { 0.5 } else { 0.001 };
            level * ((dice >> 16) as f32 / 32_768.0 - 1.0)
        };
        (0..60 * RATE_HZ).map(next).collect()
    };
    let channels = [noise(), noise()];
    let path = workspace.recordings().join("long.wav");
    let channels: [&[f32]; 2] = [&channels[0], &channels[1]];
    write_wav(path, RATE_HZ, SampleFormat::Int16, &channels);
    let with_memory = |mb: &str| {
        workspace
            .session()
            .args(["--memory", mb])
            .assert()
            .success()
    };
    with_memory("40")
        .stdout(contains("2 drops in 3 recordings, 1 not readable"))
        .stdout(contains("long.wav: its analysis ended its process twice"));
    // It is not held against it.
    with_memory("256")
        .stderr(contains(
            "2 of 3 recordings were analysed in an earlier run",
        ))
        .stdout(contains("2 drops in 3 recordings").and(contains("not readable").not()));
}

/// The system counts the time of a process, and sends it a signal when it is over; here the test does, as soon as it
/// counts. Twenty drops with the most draws are not analysed before.
#[cfg(target_os = "linux")]
#[test]
fn a_recording_that_takes_too_long_is_named_and_the_rest_goes_on() {
    const LIMIT_S: u64 = 900;
    let workspace = Workspace::new(&[]);
    let sound = drop_of(1);
    let drops: &[f32] = &sound.samples.repeat(20);
    let path = workspace.recordings().join("drops.wav");
    write_wav(path, sound.sample_rate_hz, SampleFormat::Int16, &[drops]);
    fs::write(workspace.recordings().join("empty.wav"), "").unwrap();
    let program = Command::cargo_bin("bouncelab").unwrap();
    let mut session = Plain::new(program.get_program())
        .current_dir(&workspace.0)
        .args(["session", "recordings", "--jobs", "1"])
        .args(["--draws", "100000", "--time-limit", &LIMIT_S.to_string()])
        .stdout(Stdio::piped())
        .spawn()
        .unwrap();
    let limit_s = |worker: &str| {
        let limits = fs::read_to_string(format!("/proc/{worker}/limits")).ok()?;
        let limit = limits
            .lines()
            .find_map(|it| it.strip_prefix("Max cpu time"));
        limit?.split_whitespace().next()?.parse::<u64>().ok()
    };
    // A second more, since the system counts whole ones, and what was used before.
    let is_limited = |worker: &str| limit_s(worker).is_some_and(|it| it > LIMIT_S);
    let worker = worker_of(&mut session, is_limited);
    Plain::new("kill")
        .args(["-XCPU", &worker])
        .status()
        .unwrap();
    let output = session.wait_with_output().unwrap();
    assert!(!output.status.success());
    let said = String::from_utf8(output.stdout).unwrap();
    assert!(
        said.contains("drops.wav: its analysis took more than 900 s"),
        "{said}"
    );
    assert!(said.contains("empty.wav: "), "{said}");
}

/// Drafts of tables, which nobody should be left with.
fn drafts(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    let names = entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned());
    names.filter(|name| name.starts_with('.')).collect()
}

#[test]
fn a_report_may_lie_with_the_tables() {
    let workspace = Workspace::new(&[]);
    workspace.record("a.wav", 1);
    let report = workspace.results().join("session.html");
    // The folder is made by the first run, and cleared of what killed runs left by the second.
    for _ in 0..2 {
        workspace
            .session()
            .arg("--report")
            .arg(&report)
            .assert()
            .success();
        fs::remove_file(&report).unwrap();
    }
}

#[test]
fn wishes_that_make_no_sense_are_refused() {
    let workspace = Workspace::new(&[]);
    workspace.record("a.wav", 1);
    let wishes = "--want=nan --want=0 --want=-1 --compare-at=0 --at-speed=-1m/s";
    for wish in wishes.split(' ') {
        workspace
            .session()
            .arg(wish)
            .assert()
            .code(2)
            .stderr(contains("above 0"));
    }
    // More threads than there is work for are not even made.
    workspace.session().arg("--jobs=65535").assert().success();
}

/// As administrators set it for all that somebody runs.
#[cfg(target_os = "linux")]
#[test]
fn a_stricter_limit_of_memory_stays() {
    let workspace = Workspace::new(&[]);
    workspace.record("a.wav", 1);
    let mut command = Command::new("sh");
    command.args(["-c", "ulimit -d 600000 && exec \"$0\" \"$@\""]);
    command.arg(assert_cmd::cargo::cargo_bin("bouncelab"));
    command.args(["session", "--ball", "tennis", "--no-inference", "--output"]);
    command.arg(workspace.results()).arg(workspace.recordings());
    command.assert().success();
}

/// What lies in the folder may be of the run that works there.
#[test]
fn results_of_a_cluster_wait_for_another_run() {
    let workspace = Workspace::new(&[]);
    let running = bouncelab_session::journal::Journal::open(&workspace.results()).unwrap();
    let draft = workspace.results().join(".bouncelab-1.part");
    fs::write(&draft, "").unwrap();
    let mut command = workspace.cluster_session(&workspace.recordings());
    command.assert().failure().stderr(contains("another run"));
    assert!(draft.exists());
    drop(running);
    command
        .assert()
        .failure()
        .stderr(contains("no Parquet file"));
}

/// An engine may give its files the names of our tables.
#[test]
fn results_of_a_cluster_are_never_replaced_by_tables() {
    use bouncelab_report::file::Outputs;
    use bouncelab_session::table::{Form, Schema, TableWriter};

    let workspace = Workspace::new(&[]);
    let folder = workspace.recordings();
    let schema = Schema {
        name: "drops",
        schema: "none",
        version: "0",
        columns: Vec::new(),
    };
    let rows = TableWriter::new(&folder, &schema, &[Form::Parquet], &Outputs::default());
    rows.unwrap().finish().unwrap();
    let file = folder.join("drops.parquet");
    let before = fs::read(&file).unwrap();
    let mut command = Command::cargo_bin("bouncelab").unwrap();
    command.args(["session", "--force", "--from"]).arg(&folder);
    command.arg("--output").arg(&folder).assert().code(1);
    command.assert().stderr(contains("is an input"));
    assert_eq!(fs::read(&file).unwrap(), before);
}

/// The library that reads them panics at one of the files, whose column ends too early: a user sees what is wrong alone.
#[test]
fn a_damaged_result_of_a_cluster_is_named_in_one_line() {
    let workspace = Workspace::new(&[]);
    let file = workspace.recordings().join("rows.parquet");
    let mut damaged = 0;
    for rows in bouncelab_testkit::fuzz::corpus("rows") {
        fs::write(&file, rows).unwrap();
        let output = workspace.cluster_session(&file).output().unwrap();
        if output.status.success() {
            continue;
        }
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(said.lines().count(), 1, "{said}");
        damaged += usize::from(said.contains("the file is damaged"));
    }
    assert_eq!(damaged, 1);
}

/// How results of a cluster were analysed was decided there.
#[test]
fn results_of_a_cluster_take_no_settings() {
    let workspace = Workspace::new(&[]);
    let from = |more: &[&str]| {
        let mut command = workspace.cluster_session(&workspace.recordings());
        command.args(more).assert()
    };
    from(&["--ball", "tennis"])
        .code(2)
        .stderr(contains("--ball"));
    from(&["--draws", "200"])
        .code(2)
        .stderr(contains("--draws"));
    from(&["drop.wav"]).code(2);
    from(&[]).failure().stderr(contains("no Parquet file"));
}
