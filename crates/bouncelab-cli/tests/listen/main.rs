//! `bouncelab listen` as its users meet it: played files, a microphone that is a file, and all that
//! can go wrong.

#![expect(clippy::disallowed_methods, reason = "names of files of the project")]

#[cfg(all(feature = "microphone", target_os = "linux"))]
mod card;

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use assert_cmd::Command;
use bouncelab::analysis::Gap;
use bouncelab::impact::ImpactEvent;
use bouncelab::synth::{self, Scene};
use bouncelab_audio::{Recorder, SampleFormat, SoundReader};
use bouncelab_testkit::{impact_events, write_wav};
use predicates::prelude::*;
use serde_json::Value;
use tempfile::TempDir;

const RATE_HZ: u32 = 48_000;

fn bouncelab(arguments: &[&str]) -> Command {
    let mut command = Command::cargo_bin("bouncelab").unwrap();
    command.args(arguments).timeout(Duration::from_mins(5));
    command
}

fn analyze(file: &Path) -> Value {
    let mut command = bouncelab(&["analyze", "--format", "json"]);
    let output = command.arg(file).output().unwrap();
    serde_json::from_slice(&output.stdout).unwrap()
}

/// Plays a file as fast as it goes.
fn play(file: &Path) -> Command {
    let mut command = bouncelab(&["listen", "--fast", "--from"]);
    command.arg(file);
    command
}

/// One JSON document for each line of the output.
fn lines(output: &[u8]) -> Vec<Value> {
    let text = String::from_utf8(output.to_vec()).unwrap();
    text.lines()
        .map(|line| serde_json::from_str(line).unwrap())
        .collect()
}

fn drops(documents: &[Value]) -> Vec<Value> {
    let drops = |document: &Value| document["drops"].as_array().unwrap().clone();
    documents.iter().flat_map(drops).collect()
}

/// The sound of drag-free drops that begin at these times: fifteen impacts, 2.4 m/s at first.
fn sound(starts_s: &[f64], restitution: f64, tail_s: f64) -> Vec<f32> {
    let drop = |&start_s: &f64| {
        let later = move |event: ImpactEvent| ImpactEvent {
            time_s: start_s + event.time_s,
            ..event
        };
        impact_events(2.4, restitution).take(15).map(later)
    };
    let events: Vec<ImpactEvent> = starts_s.iter().flat_map(drop).collect();
    let scene = Scene {
        sample_rate_hz: RATE_HZ,
        tail_s,
        ..Scene::default()
    };
    synth::render(&events, &scene, 5).unwrap().samples
}

fn recording(folder: &TempDir, samples: &[f32]) -> PathBuf {
    let path = folder.path().join("drop.wav");
    write_wav(&path, RATE_HZ, SampleFormat::Float32, &[samples]);
    path
}

fn one_drop(folder: &TempDir) -> PathBuf {
    recording(folder, &sound(&[0.0], 0.88, 5.0))
}

fn three_drops(folder: &TempDir) -> PathBuf {
    recording(folder, &sound(&[0.0, 8.0, 16.5], 0.88, 1.0))
}

/// The first channel of a file.
fn samples(file: &Path) -> Vec<f32> {
    let mut source = SoundReader::open(file).unwrap();
    let mut samples = Vec::new();
    while let Some(block) = source.next_block().unwrap() {
        samples.extend_from_slice(block.channel(0));
    }
    samples
}

#[test]
fn balls_are_compared_for_each_drop_where_that_is_asked() {
    let folder = TempDir::new().unwrap();
    let file = one_drop(&folder);
    let balls = |arguments: &[&str]| {
        let played = play(&file)
            .args(["--format", "json"])
            .args(arguments)
            .output();
        let drop = drops(&lines(&played.unwrap().stdout)).remove(0);
        drop["balls"].as_array().unwrap().len()
    };
    assert!(balls(&["--which-ball"]) > 3);
    assert_eq!(balls(&[]), 0);
}

#[test]
fn what_is_wrong_with_a_played_file_is_said_though_its_drop_is_over() {
    let folder = TempDir::new().unwrap();
    let file = one_drop(&folder);
    let length = fs::metadata(&file).unwrap().len();
    let open = fs::File::options().write(true).open(&file).unwrap();
    // The last half second, long after the drop.
    open.set_len(length - u64::from(RATE_HZ) * 2).unwrap();
    play(&file)
        .assert()
        .success()
        .stderr(predicate::str::contains("drop.wav: The file is truncated"));
}

#[test]
fn a_played_file_says_what_analyze_says() {
    let folder = TempDir::new().unwrap();
    let file = one_drop(&folder);
    let output = play(&file).args(["--format", "json"]).output().unwrap();
    assert!(output.status.success());
    let (printed, expected) = (lines(&output.stdout), analyze(&file));
    assert_eq!(printed.len(), 1);
    for part in [
        "schema",
        "recording",
        "settings",
        "drops",
        "diagnostics",
        "no_drop",
    ] {
        assert_eq!(printed[0][part], expected[part], "{part}");
    }
    // The report is that of analyze, but for the length of what was heard.
    let report = |command: &mut Command| {
        let text = String::from_utf8(command.output().unwrap().stdout).unwrap();
        let from = text.find("Drop: 15 impacts").unwrap();
        text[from..].to_owned()
    };
    let analyzed = report(bouncelab(&["analyze"]).arg(&file));
    assert_eq!(report(&mut play(&file)), analyzed);
}

#[test]
fn a_release_is_of_the_drop_that_begins_next() {
    let folder = TempDir::new().unwrap();
    let file = three_drops(&folder);
    // A quarter of a second before the first impact of the second drop.
    let stated = ["--format", "json", "--release", "8.255s"];
    let printed = lines(&play(&file).args(stated).output().unwrap().stdout);
    let expected = bouncelab(&["analyze"]).args(stated).arg(&file).output();
    let expected: Value = serde_json::from_slice(&expected.unwrap().stdout).unwrap();
    assert_eq!(Value::from(drops(&printed)), expected["drops"]);
    let uses_it = |drop: &Value| !drop["posterior"]["missed_first_impacts"].is_null();
    let uses_it: Vec<bool> = drops(&printed).iter().map(uses_it).collect();
    assert_eq!(uses_it, [false, true, false]);
}

#[test]
fn a_release_after_every_drop_is_of_none() {
    let folder = TempDir::new().unwrap();
    let file = three_drops(&folder);
    let stated = ["--format", "json", "--release", "500s", "--draws", "100"];
    let said = predicate::str::contains("No drop begins after");
    let played = play(&file).args(stated).assert().success();
    let printed = lines(&played.stderr(said).get_output().stdout);
    let expected = bouncelab(&["analyze"]).args(stated).arg(&file).output();
    let expected: Value = serde_json::from_slice(&expected.unwrap().stdout).unwrap();
    assert_eq!(Value::from(drops(&printed)), expected["drops"]);
    let warning = expected["diagnostics"][0]["message"].as_str().unwrap();
    assert!(warning.contains("No drop begins after"), "{warning}");
}

/// They begin at equal distances, as the impacts of no ball do, and each begins 0.7 s after the end of the one before.
#[test]
fn drops_at_equal_distances_are_those_of_analyze() {
    let folder = TempDir::new().unwrap();
    let starts_s: Vec<f64> = (0..6).map(|number| 1.2 * f64::from(number)).collect();
    let file = recording(&folder, &sound(&starts_s, 0.5, 3.0));
    let printed = lines(
        &play(&file)
            .args(["--format", "json"])
            .output()
            .unwrap()
            .stdout,
    );
    let times = |drop: &Value| -> Vec<Value> {
        let impacts = drop["impacts"].as_array().unwrap().iter();
        impacts.map(|impact| impact["time_s"].clone()).collect()
    };
    let detected: Vec<_> = drops(&printed).iter().map(times).collect();
    let expected = analyze(&file)["drops"].as_array().unwrap().clone();
    assert_eq!(detected.len(), 6);
    assert_eq!(detected, expected.iter().map(times).collect::<Vec<_>>());
}

#[test]
fn each_drop_is_reported_in_turn_and_in_the_table() {
    let folder = TempDir::new().unwrap();
    let file = three_drops(&folder);
    let output = play(&file).args(["--format", "json"]).output().unwrap();
    let printed = lines(&output.stdout);
    assert_eq!(printed.len(), 3);
    assert_eq!(Value::from(drops(&printed)), analyze(&file)["drops"]);

    let text = String::from_utf8(play(&file).output().unwrap().stdout).unwrap();
    let table = &text[text.find("All drops:").unwrap()..];
    // A heading, a rule, three drops, mean and scatter, below a title.
    assert_eq!(table.trim().lines().count(), 2 + 2 + 3 + 2, "{table}");
    assert!(table.contains("mean") && table.contains("scatter"));
    // v0^2 / 2 g is 29.4 cm.
    assert!(table.contains("29.") && table.contains("cm"), "{table}");
}

#[test]
fn it_ends_after_so_many_drops_or_seconds() {
    let folder = TempDir::new().unwrap();
    let file = three_drops(&folder);
    let count = |arguments: &[&str]| {
        let mut command = play(&file);
        command.args(["--no-inference", "--format", "json"]);
        let output = command.args(arguments).output();
        drops(&lines(&output.unwrap().stdout)).len()
    };
    assert_eq!(count(&["--drops", "2"]), 2);
    assert_eq!(count(&["--seconds", "14s"]), 2);
    // Cut off in the middle: what was heard of the drop until then is analysed.
    assert_eq!(count(&["--seconds", "10s"]), 2);
    assert_eq!(count(&["--seconds", "0.2"]), 0);
}

#[test]
fn the_sound_is_saved_unchanged_and_never_over_another_file() {
    let folder = TempDir::new().unwrap();
    let file = one_drop(&folder);
    let saved = folder.path().join("saved here.wav");
    let command = format!("bouncelab analyze '{}'", saved.display());
    play(&file)
        .arg("--save")
        .arg(&saved)
        .assert()
        .success()
        .stderr(predicate::str::contains(command));
    assert_eq!(samples(&saved), samples(&file));
    play(&file)
        .arg("--save")
        .arg(&saved)
        .assert()
        .code(1)
        .stderr(predicate::str::contains("saved here.wav: exists already"));
    // A file that is played is not saved again unless that is asked for.
    let count = fs::read_dir(folder.path()).unwrap().count();
    play(&file).current_dir(&folder).assert().success();
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), count);
}

#[test]
fn what_makes_no_sound_is_refused_with_a_reason() {
    let folder = TempDir::new().unwrap();
    let file = one_drop(&folder);
    let times = folder.path().join("times.txt");
    fs::write(&times, "0.1\n0.5\n").unwrap();
    let missing = folder.path().join("missing.wav");
    for (file, arguments, code, reason) in [
        (&times, &[][..], 2, "list of numbers"),
        (&missing, &[], 1, "no such file"),
        (&folder.path().to_owned(), &[], 1, "folder"),
        (&file, &["--channel", "2"], 2, "no channel 2"),
        (&file, &["--save", "drop.txt"], 2, "ends in .wav"),
        (&file, &["--seconds", "0"], 2, "more than 0"),
        (&file, &["--drops", "0"], 2, "0"),
        (&file, &["--device", "USB"], 2, "cannot be used with"),
        (
            &file,
            &["--no-save", "--save", "x.wav"],
            2,
            "cannot be used with",
        ),
        (
            &file,
            &["--save", "/no/such/folder/x.wav"],
            1,
            "/no/such/folder",
        ),
    ] {
        let command = &mut play(file);
        let assertion = command.args(arguments).assert().code(code);
        assertion.stderr(predicate::str::contains(reason));
    }
}

#[test]
fn without_a_drop_it_says_why_as_analyze_does() {
    let folder = TempDir::new().unwrap();
    let file = recording(&folder, &vec![0.0; RATE_HZ as usize]);
    play(&file)
        .args(["--format", "json"])
        .assert()
        .code(1)
        .stderr(predicate::str::contains(
            "no drop found: The recording is silent",
        ))
        .stdout(predicate::function(|text: &str| {
            let printed = lines(text.as_bytes());
            printed.len() == 1
                && printed[0]["no_drop"]["message"].is_string()
                && drops(&printed).is_empty()
        }));
    let short = recording(&folder, &[0.5]);
    play(&short).assert().code(1);
}

/// Of a length that is known, so that times hold, and of another.
#[test]
fn a_saved_recording_says_where_sound_was_lost() {
    let folder = TempDir::new().unwrap();
    let sound = samples(&one_drop(&folder));
    let [lossy, saved] = ["lossy.wav", "saved.wav"].map(|name| folder.path().join(name));
    for (frames, certain, code) in [(2_400, true, "sound-missing"), (0, false, "clock-lost")] {
        let gap = Gap {
            start_s: 1.0,
            duration_s: f64::from(frames) / f64::from(RATE_HZ),
            certain,
        };
        let mut recorder = Recorder::create(&lossy, RATE_HZ, 1, SampleFormat::Float32).unwrap();
        let (before, after) = sound.split_at(RATE_HZ as usize);
        recorder.push(&[before]).unwrap();
        recorder.note_gap(gap);
        recorder.push(&[&vec![0.0; frames as usize]]).unwrap();
        recorder.push(&[after]).unwrap();
        recorder.finish().unwrap();
        play(&lossy).arg("--save").arg(&saved).assert().success();
        assert_eq!(SoundReader::open(&saved).unwrap().gaps(), [gap]);
        assert_eq!(samples(&saved), samples(&lossy));
        let analysed = analyze(&saved);
        assert!(analysed.to_string().contains(code), "{analysed}");
        let is_across = |drop: &Value| {
            let impacts = drop["impacts"].as_array().unwrap();
            let time_s = |impact: &Value| impact["time_s"].as_f64().unwrap();
            time_s(&impacts[0]) < 1.0 && time_s(&impacts[impacts.len() - 1]) > 1.0
        };
        assert!(!drops(&[analysed]).iter().any(is_across));
        for file in [&lossy, &saved] {
            fs::remove_file(file).unwrap();
        }
    }
}

#[cfg(not(feature = "microphone"))]
#[test]
fn without_the_microphone_it_says_how_to_build_it_in() {
    for arguments in [&["listen"][..], &["listen", "--devices"]] {
        bouncelab(arguments)
            .assert()
            .code(2)
            .stderr(predicate::str::contains("cargo xtask install"))
            .stderr(predicate::str::contains("--from FILE"));
    }
}

/// Signals, limits on files, and word of their changes, as Linux has them.
#[cfg(target_os = "linux")]
mod linux {
    use std::mem::MaybeUninit;
    use std::process::{Child, Stdio};

    use rustix::event::{PollFd, PollFlags, Timespec, poll};
    use rustix::fs::inotify::{self, CreateFlags, WatchFlags};

    use super::*;

    /// Starts the program in the background.
    pub(crate) fn start(arguments: &[&str], environment: &[(&str, &Path)]) -> Child {
        std::process::Command::new(assert_cmd::cargo::cargo_bin("bouncelab"))
            .args(arguments)
            .envs(environment.iter().copied())
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap()
    }

    /// Waits until a file has `bytes` bytes, woken by whatever is written in its folder.
    pub(crate) fn wait_for(file: &Path, bytes: u64) {
        const PATIENCE: Timespec = Timespec {
            tv_sec: 300,
            tv_nsec: 0,
        };
        let watch = inotify::init(CreateFlags::CLOEXEC).unwrap();
        let written = WatchFlags::CREATE | WatchFlags::MODIFY;
        inotify::add_watch(&watch, file.parent().unwrap(), written).unwrap();
        let mut buffer = [MaybeUninit::uninit(); 4096];
        while fs::metadata(file).map_or(0, |file| file.len()) < bytes {
            let changes = poll(&mut [PollFd::new(&watch, PollFlags::IN)], Some(&PATIENCE));
            assert_eq!(changes, Ok(1), "nothing is saved");
            inotify::Reader::new(&watch, &mut buffer).next().unwrap();
        }
    }

    pub(crate) fn signal(child: &Child, signal: &str) {
        let id = child.id().to_string();
        let sent = std::process::Command::new("kill")
            .args([signal, &id])
            .status();
        assert!(sent.unwrap().success());
    }

    /// Plays a drop in real time, saves it, and sends a signal after two seconds of sound.
    fn interrupted(folder: &TempDir, with: &str) -> (std::process::Output, PathBuf) {
        let (file, saved) = (one_drop(folder), folder.path().join("saved.wav"));
        let (from, to) = (file.to_str().unwrap(), saved.to_str().unwrap());
        let child = start(&["listen", "--from", from, "--save", to], &[]);
        // Four bytes for each sample.
        wait_for(&saved, 2 * u64::from(RATE_HZ) * 4);
        signal(&child, with);
        (child.wait_with_output().unwrap(), saved)
    }

    #[test]
    fn after_ctrl_c_all_is_saved_and_analysed() {
        let folder = TempDir::new().unwrap();
        let (output, saved) = interrupted(&folder, "-INT");
        assert!(output.status.success());
        // The first impact sounds after half a second, so some are in the first two.
        let report = String::from_utf8(output.stdout).unwrap();
        assert!(report.contains("restitution"), "{report}");
        let (saved, original) = (samples(&saved), samples(&folder.path().join("drop.wav")));
        assert!(saved.len() >= 2 * RATE_HZ as usize);
        assert_eq!(saved, original[..saved.len()]);
    }

    /// As `nohup` starts it: it goes on without its terminal, and ends in order all the same.
    #[test]
    fn a_recording_that_ignores_its_terminal_outlives_it() {
        let folder = TempDir::new().unwrap();
        let (file, saved) = (one_drop(&folder), folder.path().join("saved.wav"));
        let child = std::process::Command::new("sh")
            .args(["-c", "trap '' HUP; exec \"$0\" \"$@\""])
            .arg(assert_cmd::cargo::cargo_bin("bouncelab"))
            .args(["listen", "--from", file.to_str().unwrap(), "--save"])
            .arg(&saved)
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let second = u64::from(RATE_HZ) * 4;
        wait_for(&saved, second);
        signal(&child, "-HUP");
        wait_for(&saved, 2 * second);
        signal(&child, "-TERM");
        let output = child.wait_with_output().unwrap();
        assert!(output.status.success());
        let report = String::from_utf8(output.stdout).unwrap();
        assert!(report.contains("restitution"), "{report}");
    }

    #[test]
    fn after_a_crash_all_but_the_last_second_can_be_read() {
        let folder = TempDir::new().unwrap();
        let (_, saved) = interrupted(&folder, "-KILL");
        let (saved, original) = (samples(&saved), samples(&folder.path().join("drop.wav")));
        assert!(saved.len() >= RATE_HZ as usize);
        assert_eq!(saved, original[..saved.len()]);
    }

    /// Nobody reads what is said from the very beginning, and then nobody reads the results.
    #[test]
    fn the_recording_outlives_closed_outputs() {
        let folder = TempDir::new().unwrap();
        let (file, saved) = (one_drop(&folder), folder.path().join("saved.wav"));
        let mut arguments = vec!["listen", "--fast", "--from", file.to_str().unwrap()];
        arguments.extend(["--save", saved.to_str().unwrap()]);
        let mut child = start(&arguments, &[]);
        drop((child.stdout.take(), child.stderr.take()));
        assert_eq!(child.wait().unwrap().code(), Some(1));
        assert_eq!(samples(&saved), samples(&file));
    }

    #[test]
    fn when_the_disk_is_full_listening_goes_on() {
        let folder = TempDir::new().unwrap();
        let (file, saved) = (one_drop(&folder), folder.path().join("saved.wav"));
        let program = assert_cmd::cargo::cargo_bin("bouncelab");
        // No file may exceed 200 blocks of 512 or 1024 bytes: half a second of sound or one.
        let limited = "ulimit -f 200; exec \"$0\" listen --fast --from \"$1\" --save \"$2\"";
        let mut command = Command::new("sh");
        command
            .args(["-c", limited])
            .args([&program, &file, &saved]);
        command
            .assert()
            .code(1)
            .stdout(predicate::str::contains("15 impacts"))
            .stderr(predicate::str::contains("saving the sound failed").count(1));
        let saved = samples(&saved);
        assert!(saved.len() > RATE_HZ as usize / 3, "{}", saved.len());
        assert_eq!(saved, samples(&file)[..saved.len()]);
    }
}

/// The real path from the sound system on: ALSA takes a file for the microphone.
#[cfg(all(feature = "microphone", target_os = "linux"))]
mod microphone {
    use super::linux::{signal, start, wait_for};
    use super::*;

    /// A sound system whose default input gives these samples, in stereo, as fast as they are
    /// taken; then it goes on with the last ones for ever.
    fn sound_system(folder: &TempDir, samples: &[f32]) -> PathBuf {
        let raw = folder.path().join("input.raw");
        let frames = samples.iter().flat_map(|sample| [sample.to_le_bytes(); 2]);
        fs::write(&raw, frames.flatten().collect::<Vec<u8>>()).unwrap();
        let settings = format!(
            "pcm.!default {{ type file slave.pcm {{ type null }} \
             file /dev/null infile {} format raw }}\n",
            raw.display()
        );
        let path = folder.path().join("asound.conf");
        fs::write(&path, settings).unwrap();
        path
    }

    fn listen(folder: &TempDir, system: &Path) -> Command {
        let mut command = bouncelab(&["listen"]);
        command.env("ALSA_CONFIG_PATH", system).current_dir(folder);
        command
    }

    #[test]
    fn a_drop_is_detected_through_the_microphone_and_saved_bit_by_bit() {
        let folder = TempDir::new().unwrap();
        let samples = sound(&[0.0], 0.88, 5.0);
        let system = sound_system(&folder, &samples);
        let mut command = listen(&folder, &system);
        command.args(["--drops", "1", "--save", "mic.wav", "--format", "json"]);
        let output = command.output().unwrap();
        // This microphone gives minutes of sound in a moment. What comes after the drop may be too much.
        let stderr = String::from_utf8_lossy(&output.stderr);
        let is_lost = stderr.contains("not all of the sound was saved");
        assert_eq!(output.status.code(), Some(i32::from(is_lost)), "{stderr}");
        let printed = lines(&output.stdout);
        assert_eq!(printed[0]["recording"], "mic.wav");
        assert_eq!(drops(&printed).len(), 1);

        let saved = super::samples(&folder.path().join("mic.wav"));
        let common = saved.len().min(samples.len());
        assert!(common > 5 * RATE_HZ as usize);
        assert_eq!(saved[..common], samples[..common]);
        // The sound that came directly says the same.
        let direct = analyze(&recording(&folder, &samples));
        assert_eq!(printed[0]["drops"], direct["drops"]);
    }

    #[test]
    fn the_sound_goes_to_a_file_named_by_the_date_by_default() {
        let folder = TempDir::new().unwrap();
        let system = sound_system(&folder, &sound(&[0.0], 0.88, 1.0));
        let recordings = || {
            let entries = fs::read_dir(folder.path()).unwrap();
            let names = entries.map(|it| it.unwrap().file_name().into_string().unwrap());
            names
                .filter(|name| name.contains(".wav"))
                .collect::<Vec<_>>()
        };
        let listen = || {
            let mut command = listen(&folder, &system);
            command.args(["--no-inference", "--seconds", "5"]);
            command
        };
        listen().arg("--no-save").assert().success();
        assert!(recordings().is_empty());
        listen().assert().success();
        listen().assert().success();
        let names = recordings();
        assert_eq!(names.len(), 2, "{names:?}");
        assert!(names[0].starts_with("bouncelab-20"), "{names:?}");
    }

    #[test]
    fn a_killed_program_leaves_its_recording() {
        let folder = TempDir::new().unwrap();
        let samples = sound(&[0.0], 0.88, 1.0);
        let system = sound_system(&folder, &samples);
        let saved = folder.path().join("mic.wav");
        let arguments = ["listen", "--save", saved.to_str().unwrap()];
        let child = start(&arguments, &[("ALSA_CONFIG_PATH", &system)]);
        wait_for(&saved, 4 * 8 * u64::from(RATE_HZ));
        signal(&child, "-KILL");
        let _ = child.wait_with_output().unwrap();
        let saved = super::samples(&saved);
        let common = saved.len().min(samples.len());
        assert!(common > 2 * RATE_HZ as usize);
        assert_eq!(saved[..common], samples[..common]);
    }

    /// A terminal that takes nothing: a pipe that is full before the program says its first word.
    #[test]
    fn a_reader_that_stalls_does_not_stop_the_recording() {
        use std::io::Write;
        use std::process::{Command as Plain, Stdio};

        let folder = TempDir::new().unwrap();
        let samples = sound(&[0.0], 0.88, 1.0);
        let system = sound_system(&folder, &samples);
        let saved = folder.path().join("mic.wav");
        let (reader, mut writer) = std::io::pipe().unwrap();
        let theirs = writer.try_clone().unwrap();
        let filling = std::thread::spawn(move || while writer.write_all(b"....").is_ok() {});
        let mut child = Plain::new(assert_cmd::cargo::cargo_bin("bouncelab"))
            .args(["listen", "--seconds", "3", "--save"])
            .arg(&saved)
            .env("ALSA_CONFIG_PATH", &system)
            .stdout(Stdio::null())
            .stderr(theirs)
            .spawn()
            .unwrap();
        wait_for(&saved, 4096 + 3 * 8 * u64::from(RATE_HZ));
        drop(reader);
        child.wait().unwrap();
        filling.join().unwrap();
        assert_eq!(super::samples(&saved), samples[..3 * RATE_HZ as usize]);
    }

    #[test]
    fn sound_that_comes_too_fast_is_lost_and_counted() {
        // This microphone gives minutes of sound in a moment; half a minute can wait.
        let folder = TempDir::new().unwrap();
        let system = sound_system(&folder, &sound(&[0.0], 0.88, 1.0));
        listen(&folder, &system)
            .args(["--no-inference", "--no-save", "--seconds", "200"])
            .assert()
            .success()
            .stderr(predicate::str::contains("sound was lost").count(1))
            .stderr(predicate::str::contains("samples of each channel"));
    }

    #[test]
    fn a_muted_microphone_is_noticed() {
        let folder = TempDir::new().unwrap();
        let system = sound_system(&folder, &vec![0.0; RATE_HZ as usize]);
        listen(&folder, &system)
            .args(["--no-save", "--seconds", "5"])
            .assert()
            .code(1)
            .stderr(predicate::str::contains("muted").count(1));
    }

    #[test]
    fn without_a_device_or_with_a_wrong_one_it_says_what_to_do() {
        let folder = TempDir::new().unwrap();
        let nothing = folder.path().join("nothing.conf");
        fs::write(&nothing, "").unwrap();
        for arguments in [&[][..], &["--device", "gramophone"]] {
            listen(&folder, &nothing)
                .args(arguments)
                .assert()
                .code(1)
                .stderr(
                    predicate::str::contains("--devices")
                        .and(predicate::str::contains("panicked").not()),
                );
        }
        // Nothing was saved, since nothing was heard.
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }
}
