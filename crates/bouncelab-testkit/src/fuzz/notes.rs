//! Bytes as what people write of their recordings: a session.toml, a table, a file of rules.

use std::fs;
use std::path::{Component, Path, PathBuf};

use bouncelab::settings::Settings;
use bouncelab_report::messages::Translator;
use bouncelab_report::rules;
use bouncelab_session::hash::hash;
use bouncelab_session::{Advice, KnownRecording, MetadataOptions, Result, Session, Sources};
use tempfile::TempDir;

/// Recordings of a session, which nobody reads.
const RECORDINGS: [&str; 3] = ["red_30cm_1.wav", "red_30cm_2.wav", "blue_40cm_1.wav"];

/// Reads a session.toml.
pub(super) fn read_session(bytes: &[u8]) {
    // It may name folders and files, and so the whole disk.
    let text = std::str::from_utf8(bytes).unwrap_or_default();
    let written: toml::Table = text
        .trim_start_matches('\u{feff}')
        .parse()
        .unwrap_or_default();
    let folders = written.get("folders").and_then(toml::Value::as_array);
    let mut named = folders.into_iter().flatten().chain(written.get("notes"));
    let is_within = |path: &str| {
        let mut parts = Path::new(path).components();
        parts.all(|part| matches!(part, Component::Normal(_) | Component::CurDir))
    };
    if !named.all(|path| path.as_str().is_none_or(is_within)) {
        return;
    }
    let folder = folder(&RECORDINGS);
    fs::write(folder.path().join("session.toml"), bytes).expect("a file in an own folder");
    // It may name the folder twice, or none with recordings in it.
    fs::write(folder.path().join("notes.csv"), "recording,surface\n")
        .expect("a file in an own folder");
    if let Err(problem) = gather(vec![folder.path().to_owned()], None, None) {
        assert!(!problem.to_string().is_empty());
    }
}

/// Reads a table of notes.
pub(super) fn read_notes(bytes: &[u8]) {
    let folder = folder(&RECORDINGS);
    let table = folder.path().join("notes.csv");
    fs::write(&table, bytes).expect("a file in an own folder");
    check(&gather(vec![folder.path().to_owned()], Some(table), None));
}

/// Opens an archive of recordings, and unpacks them.
pub(super) fn read_archive(bytes: &[u8]) {
    let folder = folder(&[]);
    let archive = folder.path().join("class.zip");
    fs::write(&archive, bytes).expect("a file in an own folder");
    for recording in gather(vec![archive], None, None).into_iter().flatten() {
        // It is unpacked to be compared with what was asked for.
        assert!(recording.record(hash(b"another content")).is_none());
    }
}

/// Reads rules.
pub(super) fn read_rules(bytes: &[u8]) {
    let text = String::from_utf8_lossy(bytes);
    for rule in rules::read(&text, "fuzz.toml").into_iter().flatten() {
        let words = Translator::english();
        assert!(rule.drop_height_m.is_none_or(f64::is_finite));
        assert!(!rules::words::facts(&rule, &words).is_empty());
    }
}

/// A folder of recordings.
pub(super) fn folder(recordings: &[&str]) -> TempDir {
    let folder = tempfile::tempdir().expect("an own folder");
    for name in recordings {
        fs::write(folder.path().join(name), name).expect("a file in an own folder");
    }
    folder
}

/// The recordings with what is noted of them, as the program finds them.
pub(super) fn gather(
    inputs: Vec<PathBuf>,
    table: Option<PathBuf>,
    pattern: Option<String>,
) -> Result<Vec<KnownRecording>> {
    let session = Session::gather(&Sources {
        inputs,
        pattern,
        notes: table,
    })?;
    MetadataOptions {
        settings: &Settings::of_ball("tennis").without_inference(),
        allow_implausible: true,
        allow_missing: true,
        translator: &Translator::english(),
        advice: Advice {
            implausible: "",
            missing: "",
            ball: "",
        },
    }
    .read(session)
}

fn check(read: &Result<Vec<KnownRecording>>) {
    match read {
        Ok(recordings) => assert_eq!(recordings.len(), RECORDINGS.len()),
        Err(problem) => assert!(!problem.to_string().is_empty()),
    }
}
