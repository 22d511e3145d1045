//! What is left on a disk that fails, and after a kill.
//!
//! `strace` makes calls to the system fail, and shows their order. The tests are ignored unless asked for, which
//! `cargo xtask test faults` does.

#![cfg(target_os = "linux")]

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::thread;

use bouncelab::synth::{self, Scene};
use bouncelab_audio::{SampleFormat, SoundReader};
use bouncelab_testkit::{impact_events, write_wav};
use tempfile::TempDir;

/// A command that reads from the folder `in` and writes into the folder `out`.
struct Case {
    arguments: &'static str,
    /// What it writes while it runs; the rest appears whole or not at all.
    grows: Option<&'static str>,
}

const CASES: [Case; 10] = [
    Case {
        arguments: "synth out/drop.wav --truth out/drop.csv --force",
        grows: None,
    },
    Case {
        arguments: "analyze in/a.wav --no-inference --figures out --report out/report.html",
        grows: None,
    },
    Case {
        arguments: "session in --output out --no-inference --jobs 1 --figures --report out/report.html",
        grows: Some("journal.jsonl"),
    },
    Case {
        arguments: "listen --fast --from in/a.wav --no-inference --save out/saved.wav",
        grows: Some("saved.wav"),
    },
    Case {
        arguments: "analyze in/a.wav --no-inference --cues out/cues.wav --force",
        grows: None,
    },
    Case {
        arguments: "verdict --rule ittf-38-table in/a.wav --drag none --height 30.5cm --kept surface --report out/report.html",
        grows: None,
    },
    Case {
        arguments: "simulate --figures out",
        grows: None,
    },
    Case {
        arguments: "paper --figures out",
        grows: None,
    },
    Case {
        arguments: "demo --output out --force",
        grows: None,
    },
    Case {
        arguments: "manual out",
        grows: None,
    },
];

/// The calls that bring bytes and names onto a disk.
const CALLS: [&str; 9] = [
    "write",
    "pwrite64",
    "writev",
    "fsync",
    "fdatasync",
    "rename",
    "renameat",
    "renameat2",
    "ftruncate",
];

/// The maximum number of calls of one kind that fail, spread over all of them; and that of a command that writes so many
/// files that most calls repeat those for another file.
const MAX_FAULTS: usize = 20;
const MAX_FAULTS_OF_MANY: usize = 10;
const MANY_FILES: usize = 20;

/// A folder with two recordings of a drop, and one for outputs.
struct Workspace(TempDir);

impl Workspace {
    fn new() -> Self {
        let workspace = Self(TempDir::new().unwrap());
        fs::create_dir(workspace.path("in")).unwrap();
        fs::create_dir(workspace.path("out")).unwrap();
        for (name, seed) in [("a.wav", 1), ("b.wav", 2)] {
            // From 30.5 cm, the height of the rule in `CASES`.
            let impacts: Vec<_> = impact_events(2.44, 0.88).take(8).collect();
            let sound = synth::render(&impacts, &Scene::default(), seed).unwrap();
            let path = workspace.path("in").join(name);
            let rate_hz = sound.sample_rate_hz;
            write_wav(&path, rate_hz, SampleFormat::Int16, &[&sound.samples]);
        }
        workspace
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// A command that runs in the folder, under strace with these options if there are any.
    fn command(&self, strace: &[&str], case: &Case) -> Command {
        let program = env!("CARGO_BIN_EXE_bouncelab");
        let mut command = match strace {
            [] => Command::new(program),
            options => {
                let mut command = Command::new("strace");
                command
                    .args(["-f", "-qq", "-o", "trace"])
                    .args(options)
                    .arg(program);
                command
            }
        };
        command
            .args(case.arguments.split(' '))
            .current_dir(self.0.path());
        command
    }

    fn run(&self, strace: &[&str], case: &Case) -> Output {
        self.command(strace, case).output().unwrap()
    }

    /// The undisturbed command, with the calls that it made; its outputs stay.
    fn undisturbed(&self, case: &Case) -> Vec<Call> {
        let traced = format!("trace={}", CALLS.map(|call| format!("?{call}")).join(","));
        let output = self.run(&["-y", "-e", &traced], case);
        assert!(
            output.status.success(),
            "{} {}",
            text(&output.stderr),
            text(&output.stdout)
        );
        let trace = fs::read(self.path("trace")).unwrap();
        text(&trace).lines().filter_map(Call::parse).collect()
    }

    fn empty_outputs(&self) {
        fs::remove_dir_all(self.path("out")).unwrap();
        fs::create_dir(self.path("out")).unwrap();
    }

    /// Every file in one of the folders, by its name. A report tells the day in its header.
    fn files(&self, folder: &str) -> BTreeMap<String, Vec<u8>> {
        let entries = fs::read_dir(self.path(folder)).unwrap();
        let files = entries.map(|entry| {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_str().unwrap().to_owned();
            let content = fs::read(&path).unwrap();
            let body = text(&content)
                .find("</header>")
                .filter(|_| has_extension(&path, "html"));
            (name, content[body.unwrap_or(0)..].to_vec())
        });
        files.collect()
    }
}

/// A call to the system: process, name, and the rest of the line.
#[derive(Debug)]
struct Call {
    process: String,
    name: String,
    rest: String,
}

impl Call {
    /// `None` for a line about something else, such as a signal.
    fn parse(line: &str) -> Option<Self> {
        let (process, call) = line.split_once(' ')?;
        let (name, rest) = call.trim_start().split_once('(')?;
        CALLS.contains(&name).then(|| Self {
            process: process.to_owned(),
            name: name.to_owned(),
            rest: rest.to_owned(),
        })
    }

    /// Whether it writes to an open file.
    fn writes_to(&self, path: &str) -> bool {
        ["write", "pwrite64", "writev", "ftruncate"].contains(&self.name.as_str())
            && self.file() == path
    }

    /// Whether it brings an open file or folder onto the disk.
    fn syncs(&self, path: &str) -> bool {
        ["fsync", "fdatasync"].contains(&self.name.as_str()) && self.file() == path
    }

    /// The open file that it is about; empty if it is about names.
    fn file(&self) -> &str {
        let (_, file) = self.rest.split_once('<').unwrap_or_default();
        file.split_once('>').map_or("", |(file, _)| file)
    }

    /// The old and the new name, if it renames.
    fn renamed(&self) -> Option<(&str, &str)> {
        let mut quoted = self.rest.split('"').skip(1).step_by(2);
        let names = (quoted.next()?, quoted.next()?);
        self.name.starts_with("rename").then_some(names)
    }
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

fn has_extension(path: &Path, extension: &str) -> bool {
    path.extension().is_some_and(|own| own == extension)
}

/// Of each kind of call the numbers of those that are to fail, as the process counts them that makes them: those that
/// concern outputs. What the processes of a session tell each other is no file, so a number that such a call has too is
/// left out.
fn faults(calls: &[Call], outputs: &str, max: usize) -> Vec<(String, usize)> {
    let mut counts = BTreeMap::<(&str, &str), usize>::new();
    let [mut output, mut other] = [BTreeMap::new(), BTreeMap::new()];
    for call in calls {
        let count = counts.entry((&call.process, &call.name)).or_default();
        *count += 1;
        let concerns_outputs = call.renamed().is_some() || call.file().starts_with(outputs);
        let kinds = if concerns_outputs {
            &mut output
        } else {
            &mut other
        };
        let numbers: &mut BTreeSet<usize> = kinds.entry(call.name.as_str()).or_default();
        numbers.insert(*count);
    }
    let spread = output.into_iter().flat_map(|(kind, numbers)| {
        let others = other.remove(kind).unwrap_or_default();
        let numbers: Vec<usize> = numbers.difference(&others).copied().collect();
        // An odd step meets files and folders, which are synchronised in turns, and files of every format.
        let step = numbers.len().div_ceil(max) | 1;
        let spread = numbers.into_iter().step_by(step);
        spread.map(|number| (kind.to_owned(), number))
    });
    spread.collect()
}

/// Checks the commands side by side: most of the time they wait for strace.
fn for_each_case(check: impl Fn(&Case) + Sync) {
    thread::scope(|scope| {
        for case in &CASES {
            scope.spawn(|| check(case));
        }
    });
}

/// Each call of each command fails once. What is read stays; what appears is whole; success means that all is
/// there; and the next run completes it.
#[test]
#[ignore = "needs strace"]
fn a_call_that_fails_loses_nothing() {
    for_each_case(|case| {
        let workspace = Workspace::new();
        let calls = workspace.undisturbed(case);
        let (inputs, expected) = (workspace.files("in"), workspace.files("out"));
        let outputs = workspace.path("out").canonicalize().unwrap();
        let max = if expected.len() < MANY_FILES {
            MAX_FAULTS
        } else {
            MAX_FAULTS_OF_MANY
        };
        for (kind, number) in faults(&calls, outputs.to_str().unwrap(), max) {
            workspace.empty_outputs();
            // A full disk and a broken one, in turns.
            let error = ["ENOSPC", "EIO"][number % 2];
            let inject = format!("inject={kind}:error={error}:when={number}");
            let output = workspace.run(&["-e", &format!("trace={kind}"), "-e", &inject], case);
            let what = format!(
                "{:?}: {kind} {number}: {}",
                case.arguments,
                text(&output.stderr)
            );
            assert!(!what.contains("panicked"), "{what}");
            assert!(matches!(output.status.code(), Some(0 | 1)), "{what}");
            assert_eq!(workspace.files("in"), inputs, "{what}");
            let found = workspace.files("out");
            for (name, content) in &found {
                if case.grows != Some(name) {
                    assert!(expected.get(name) == Some(content), "{name} after {what}");
                }
            }
            if output.status.success() {
                assert!(found == expected, "{:?} after {what}", found.keys());
            }
            if case.grows == Some("saved.wav") {
                // No recording is replaced, so the next one has its own name.
                assert_prefix(&workspace, "saved.wav");
                workspace.empty_outputs();
            }
            let again = workspace.run(&[], case);
            assert!(
                again.status.success(),
                "again: {what}{}",
                text(&again.stderr)
            );
            assert!(workspace.files("out") == expected, "again: {what}");
        }
    });
}

/// Whatever a power failure takes, of what was written since the disk was last waited for, and whenever it comes: a
/// file that has its name is whole, because all of it was on the disk before, and nothing is written to it any more. The
/// name itself is on the disk before the command ends. Files that grow are the journal and the recording, whose own tests
/// lose any part of what was not waited for.
#[test]
#[ignore = "needs strace"]
fn a_name_appears_after_the_bytes_of_its_file_are_on_the_disk() {
    for_each_case(|case| {
        let workspace = Workspace::new();
        let calls = workspace.undisturbed(case);
        let root = workspace.0.path().canonicalize().unwrap();
        let full = |name: &str| root.join(name).to_str().unwrap().to_owned();
        let mut renames = 0;
        for (place, call) in calls.iter().enumerate() {
            let Some((old, new)) = call.renamed() else {
                continue;
            };
            let (old, new) = (full(old), full(new));
            let (before, after) = (&calls[..place], &calls[place..]);
            let written = before.iter().rposition(|call| call.writes_to(&old));
            let synced = before.iter().rposition(|call| call.syncs(&old));
            assert!(
                synced > written,
                "{new} was named before it was synchronised"
            );
            let folder = Path::new(&new).parent().unwrap().to_str().unwrap();
            let permanent = after.iter().any(|call| call.syncs(folder));
            assert!(permanent, "the name {new} was not synchronised");
            let is_changed = after.iter().any(|call| call.writes_to(&new));
            assert!(!is_changed, "{new} was written to under its name");
            renames += 1;
        }
        let whole = workspace.files("out").len() - usize::from(case.grows.is_some());
        assert_eq!(
            renames, whole,
            "{:?}: every output is renamed",
            case.arguments
        );
        if let Some(grows) = case.grows {
            let grows = full(&format!("out/{grows}"));
            let written = calls.iter().rposition(|call| call.writes_to(&grows));
            let synced = calls.iter().rposition(|call| call.syncs(&grows));
            assert!(synced > written, "{grows} was not synchronised");
        }
    });
}

/// Names of files that grow and of new folders, too: nothing else would bring them there.
#[test]
#[ignore = "needs strace"]
fn new_names_are_on_the_disk() {
    let saved = "listen --fast --from in/a.wav --no-inference --save saved.wav";
    let studied = "session in --no-inference --output out/new/results";
    let cases: [(&str, &[&str]); 2] = [
        (saved, &[""]),
        (studied, &["out", "out/new", "out/new/results"]),
    ];
    for (arguments, folders) in cases {
        let workspace = Workspace::new();
        let calls = workspace.undisturbed(&Case {
            arguments,
            grows: None,
        });
        let root = workspace.0.path().canonicalize().unwrap();
        for folder in folders {
            let folder: PathBuf = root.join(folder).components().collect();
            let synced = calls
                .iter()
                .any(|call| call.syncs(folder.to_str().unwrap()));
            assert!(
                synced,
                "{arguments:?}: the names in {folder:?} are not on the disk"
            );
        }
    }
}

/// A hundred kills, spread over the calls of a command: the kind of each call, and its number among the calls of this kind.
/// Any ten neighbours of the list are spread over all calls.
fn kills(calls: &[Call]) -> Vec<[String; 2]> {
    const KILLS: usize = 100;
    let mut counts = BTreeMap::<(&str, &str), usize>::new();
    let numbered: Vec<[String; 2]> = calls
        .iter()
        .map(|call| {
            let count = counts.entry((&call.process, &call.name)).or_default();
            *count += 1;
            let inject = format!("inject={}:signal=KILL:when={count}", call.name);
            [format!("trace={}", call.name), inject]
        })
        .collect();
    // Without a common factor, so that each comes once.
    let spread = (0..KILLS).map(|kill| kill * 61 % KILLS);
    spread
        .map(|kill| numbered[kill * numbered.len() / KILLS].clone())
        .collect()
}

/// A session is killed a hundred times. After each ten kills it finishes, with the tables of an undisturbed one.
#[test]
#[ignore = "needs strace"]
fn a_session_survives_a_hundred_kills() {
    let case = &CASES[2];
    let workspace = Workspace::new();
    let calls = workspace.undisturbed(case);
    let (inputs, expected) = (workspace.files("in"), workspace.files("out"));
    for ten in kills(&calls).chunks(10) {
        workspace.empty_outputs();
        for [trace, kill] in ten {
            workspace.run(&["-e", trace, "-e", kill], case);
            assert_eq!(workspace.files("in"), inputs, "{kill}");
        }
        let output = workspace.run(&[], case);
        assert!(output.status.success(), "{}", text(&output.stderr));
        let found = workspace.files("out");
        assert!(found == expected, "{ten:?}: {:?}", found.keys());
    }
}

/// A recorder is killed a hundred times: what it saved is the beginning of what it heard.
#[test]
#[ignore = "needs strace"]
fn a_recording_survives_a_hundred_kills() {
    let case = &CASES[3];
    let workspace = Workspace::new();
    let calls = workspace.undisturbed(case);
    let mut kept = BTreeSet::new();
    for [trace, kill] in kills(&calls) {
        workspace.empty_outputs();
        workspace.run(&["-e", &trace, "-e", &kill], case);
        kept.insert(assert_prefix(&workspace, "saved.wav"));
    }
    assert!(kept.len() > 2, "kept were {kept:?} samples");
}

/// A job is killed while a drop is added, by a file and by listening: the drop before stays as it was, and one that was not
/// written down is counted by the next run.
#[test]
#[ignore = "needs strace"]
fn a_job_survives_a_hundred_kills() {
    const ADD: &str = "job add job in/b.wav";
    const LISTEN: &str = "job listen job --fast --from in/b.wav";
    for arguments in [ADD, LISTEN] {
        let case = Case {
            arguments,
            grows: None,
        };
        let workspace = Workspace::new();
        let run = |program: &str, words: &str| {
            let mut command = Command::new(program);
            command
                .args(words.split(' '))
                .current_dir(workspace.0.path());
            command.output().unwrap()
        };
        let bouncelab = env!("CARGO_BIN_EXE_bouncelab");
        let new = "job new kept --rule ittf-38-table --drops 2";
        assert!(run(bouncelab, new).status.success());
        let first = run(bouncelab, "job add kept in/a.wav");
        assert!(first.status.success(), "{}", text(&first.stderr));
        let anew = || {
            run("rm", "-rf job");
            assert!(run("cp", "-r kept job").status.success());
        };
        anew();
        let calls = workspace.undisturbed(&case);
        for [trace, kill] in kills(&calls) {
            anew();
            workspace.run(&["-e", &trace, "-e", &kill], &case);
            // The drop was written down before the kill, and is refused, or is now.
            let again = workspace.run(&[], &case);
            let shown = run(bouncelab, "job show job");
            let said = text(&shown.stdout) + &text(&shown.stderr) + &text(&again.stderr);
            assert!(said.contains("place 1 of 1, drop 2 of 2"), "{kill}: {said}");
            let kept = fs::read(workspace.path("job/sounds/001.wav")).unwrap();
            assert!(
                kept == fs::read(workspace.path("in/a.wav")).unwrap(),
                "{kill}"
            );
        }
    }
}

/// What was saved, if anything was, is a recording, the beginning of the one that was played, and all that the file
/// holds but for a second. How many samples it has.
fn assert_prefix(workspace: &Workspace, saved: &str) -> usize {
    let file = workspace.path("out").join(saved);
    if !file.exists() {
        return 0;
    }
    let played = workspace.path("in").join("a.wav");
    let (saved, played, rate_hz) = (samples(&file), samples(&played), rate_hz(&played));
    assert!(saved.len() <= played.len());
    let alike = saved.iter().zip(&played).all(|(a, b)| (a - b).abs() < 1e-4);
    assert!(alike, "{} samples", saved.len());
    // Four bytes for each sample, behind a header of a page.
    let written = fs::metadata(&file).unwrap().len().saturating_sub(4096) / 4;
    let lost = written - saved.len() as u64;
    assert!(lost <= u64::from(rate_hz), "{lost} samples are not counted");
    saved.len()
}

fn rate_hz(file: &Path) -> u32 {
    SoundReader::open(file).unwrap().sample_rate_hz()
}

/// The samples of a file up to where it ends; none if it ends within its head.
fn samples(file: &Path) -> Vec<f32> {
    let mut samples = Vec::new();
    if let Ok(mut source) = SoundReader::open(file) {
        while let Ok(Some(block)) = source.next_block() {
            samples.extend_from_slice(block.channel(0));
        }
    }
    samples
}
