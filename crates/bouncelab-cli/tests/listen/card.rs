//! A sound card without hardware: what is played to it can be recorded from it. It is a null sink of a
//! `PulseAudio` that belongs to the test alone, and `listen` finds it through ALSA as any other card.
//!
//! `cargo xtask test card` runs these tests where `PulseAudio` and its plugin of ALSA are installed.

use std::fs;
use std::io::{BufRead, BufReader, Read};
use std::path::PathBuf;
use std::process::{Child, ChildStderr, Command, Output, Stdio};

use bouncelab::impact::ImpactEvent;
use tempfile::TempDir;

use super::linux::wait_for;
use super::{RATE_HZ, drops, lines, samples, sound};

/// A sound server and its only card, which end with it.
struct Server {
    folder: TempDir,
}

impl Server {
    /// A server whose card has this rate; none has no card.
    fn start(card_hz: Option<u32>) -> Self {
        let server = Self {
            folder: TempDir::new().unwrap(),
        };
        let hint = "hint { show on description \"a simulated card\" }";
        let card = format!("pcm.!default {{ type pulse {hint} }}\n");
        fs::write(server.alsa(), card).unwrap();
        let mut command = server.command("pulseaudio");
        // It goes to the background when it is ready.
        command.args([
            "-n",
            "--daemonize=yes",
            "--exit-idle-time=-1",
            "--disable-shm=yes",
        ]);
        let socket = server.socket();
        command.arg(format!(
            "--load=module-native-protocol-unix socket={socket}"
        ));
        if let Some(rate_hz) = card_hz {
            let layout = format!("format=float32le channels=1 rate={rate_hz}");
            command.arg(format!("--load=module-null-sink sink_name=card {layout}"));
        }
        assert!(command.stderr(Stdio::null()).status().unwrap().success());
        server
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn socket(&self) -> String {
        self.path("socket").to_str().unwrap().to_owned()
    }

    fn alsa(&self) -> PathBuf {
        self.path("asound.conf")
    }

    /// A program that knows this server and no other.
    fn command(&self, program: impl AsRef<std::ffi::OsStr>) -> Command {
        let mut command = Command::new(program);
        command
            .env("HOME", self.folder.path())
            .env("XDG_RUNTIME_DIR", self.folder.path())
            .env("PULSE_RUNTIME_PATH", self.path("runtime"))
            .env("PULSE_SERVER", format!("unix:{}", self.socket()))
            .env("ALSA_CONFIG_PATH", self.alsa())
            .current_dir(self.folder.path())
            .stdin(Stdio::null());
        command
    }

    fn listen(&self, arguments: &[&str]) -> ListenProcess {
        let mut command = self.command(assert_cmd::cargo::cargo_bin("bouncelab"));
        command.args(["listen", "--language", "en", "--save", "mic.wav"]);
        command.args(arguments);
        command.stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut program = command.spawn().unwrap();
        let stderr = BufReader::new(program.stderr.take().unwrap());
        ListenProcess {
            program,
            stderr,
            said: String::new(),
        }
    }

    /// Plays samples to the card; returns when the last one was heard.
    fn play(&self, samples: &[f32]) {
        let raw: Vec<u8> = samples.iter().flat_map(|it| it.to_le_bytes()).collect();
        fs::write(self.path("played.raw"), raw).unwrap();
        let mut command = self.command("pacat");
        command.args(["--playback", "--device=card", "--channels=1"]);
        command.args(["--format=float32le", &format!("--rate={RATE_HZ}")]);
        let status = command.arg("played.raw").status().unwrap();
        assert!(status.success());
    }

    /// Pulls the card out.
    fn unplug(&self) {
        let mut command = self.command("pactl");
        let status = command.args(["unload-module", "module-null-sink"]).status();
        assert!(status.unwrap().success());
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        if let Ok(id) = fs::read_to_string(self.path("runtime/pid")) {
            let _ = Command::new("kill").arg(id.trim()).status();
        }
    }
}

/// `listen` at work.
struct ListenProcess {
    program: Child,
    stderr: BufReader<ChildStderr>,
    said: String,
}

impl ListenProcess {
    /// Waits until it says that it listens.
    fn listening(mut self) -> Self {
        while !self.said.contains("listening to") {
            assert_ne!(
                self.stderr.read_line(&mut self.said).unwrap(),
                0,
                "{}",
                self.said
            );
        }
        self
    }

    /// Waits for its end; what it said, and its output.
    fn end(mut self) -> (String, Output) {
        self.stderr.read_to_string(&mut self.said).unwrap();
        (self.said, self.program.wait_with_output().unwrap())
    }
}

/// A drop through the card, whatever its rate: what is measured agrees with the truth.
fn hears_a_drop(card_hz: u32) {
    let restitution = 0.88;
    let server = Server::start(Some(card_hz));
    let until = ["--drops", "1", "--seconds", "120s", "--format", "json"];
    let listener = server
        .listen(&[&until[..], &["--drag", "none"]].concat())
        .listening();
    server.play(&sound(&[0.0], restitution, 1.0));
    let (said, output) = listener.end();
    assert!(output.status.success(), "{said}");
    let detected = drops(&lines(&output.stdout));
    assert_eq!(detected.len(), 1);
    let e = &detected[0]["posterior"]["restitution"];
    let (value, sd) = (e["value"].as_f64().unwrap(), e["sd"].as_f64().unwrap());
    assert!((value - restitution).abs() < 4.0 * sd, "{value} +- {sd}");
    let times: Vec<f64> = detected[0]["impacts"]
        .as_array()
        .unwrap()
        .iter()
        .map(|impact| impact["time_s"].as_f64().unwrap())
        .collect();
    let truth: Vec<ImpactEvent> = bouncelab_testkit::impact_events(2.4, restitution)
        .take(15)
        .collect();
    for (flight, truth) in times.windows(2).zip(truth.windows(2)) {
        let error_s = (flight[1] - flight[0]) - (truth[1].time_s - truth[0].time_s);
        assert!(error_s.abs() < 1e-4, "{error_s} s in {times:?}");
    }
}

#[test]
#[ignore = "needs PulseAudio: cargo xtask test card"]
fn a_drop_that_a_card_hears_is_measured() {
    hears_a_drop(RATE_HZ);
}

#[test]
#[ignore = "needs PulseAudio: cargo xtask test card"]
fn a_card_of_another_rate_measures_the_same() {
    hears_a_drop(22_050);
}

#[test]
#[ignore = "needs PulseAudio: cargo xtask test card"]
fn a_card_that_vanishes_ends_the_recording_and_leaves_it() {
    let server = Server::start(Some(RATE_HZ));
    let listener = server.listen(&["--seconds", "300s"]).listening();
    // Half a second in stereo, or a second.
    wait_for(&server.path("mic.wav"), 4 * u64::from(RATE_HZ));
    server.unplug();
    let (said, output) = listener.end();
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("still plugged in"), "{said}");
    assert!(samples(&server.path("mic.wav")).len() > RATE_HZ as usize / 3);
}

#[test]
#[ignore = "needs PulseAudio: cargo xtask test card"]
fn a_card_is_in_the_list_of_devices() {
    let server = Server::start(Some(RATE_HZ));
    let mut command = server.command(assert_cmd::cargo::cargo_bin("bouncelab"));
    let output = command.args(["listen", "--devices"]).output().unwrap();
    let listed = String::from_utf8(output.stdout).unwrap();
    assert!(output.status.success(), "{listed}");
    assert!(listed.contains("a simulated card"), "{listed}");
}

#[test]
#[ignore = "needs PulseAudio: cargo xtask test card"]
fn without_any_card_it_says_so() {
    let server = Server::start(None);
    let (said, output) = server.listen(&["--seconds", "10s"]).end();
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert!(said.contains("--devices"), "{said}");
    assert!(!server.path("mic.wav").exists());
}
