//! Finds the recordings and their metadata.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::Cursor;
use std::path::{Path, PathBuf};

use bouncelab::settings::Settings;
use bouncelab::{Options, Plain};
use bouncelab_audio::{Error as Unread, Input, SoundFormat, TimesProblem, times};
use bouncelab_report::groups::some_of;
use bouncelab_report::messages::Translator;

use crate::archive::{self, ArchiveEntry};
use crate::error::{Error, Result};
use crate::hash::{Hash, hash, hash_of_file};
use crate::name::{name, shown};
use crate::notes::{Listed, Note, Notes, SessionFile, read_csv};
use crate::pattern::Pattern;
use crate::record::Record;

/// Name of the session file of a folder.
pub const SESSION_FILE: &str = "session.toml";

/// The inputs of a session.
#[derive(Debug, Clone, Default)]
pub struct Sources {
    /// Recordings, folders or ZIP archives with recordings, session files.
    pub inputs: Vec<PathBuf>,
    /// A pattern for file names; it replaces that of a session file.
    pub pattern: Option<String>,
    /// A CSV of notes; it replaces that of a session file.
    pub notes: Option<PathBuf>,
}

/// A recording as a file, or as an entry of an archive.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RecordingFile {
    /// Its path, or that of its archive.
    pub path: PathBuf,
    /// Its entry in the archive, if it is in one.
    pub entry: Option<ArchiveEntry>,
    /// Its name in tables: the path relative to the folder of the session, as text.
    pub name: String,
}

impl RecordingFile {
    /// The name of its file, with folders.
    fn file(&self) -> &Path {
        self.entry.as_ref().map_or(&self.path, |entry| &entry.name)
    }

    /// Whether its content is a list of times, or was meant to be one; what cannot be read is reported with its reason.
    fn holds_times(&self) -> bool {
        let list = match &self.entry {
            None => times::read(&self.path),
            Some(entry) => match archive::read(&self.path, entry) {
                Ok(content) => times::parse(&content, &self.name),
                Err(_) => return true,
            },
        };
        match list {
            Err(Unread::Times { problem, .. }) => !matches!(
                problem,
                TimesProblem::NoTimeColumn { .. }
                    | TimesProblem::NamelessColumns { .. }
                    | TimesProblem::OfRecordings
                    | TimesProblem::NotArray { .. }
                    | TimesProblem::NotText
                    | TimesProblem::NoList { .. }
            ),
            Err(Unread::Empty { .. }) => false,
            _ => true,
        }
    }

    /// The hash of its content.
    pub(crate) fn content(&self) -> Result<Hash> {
        match &self.entry {
            None => hash_of_file(&self.path),
            Some(entry) => archive::hash(&self.path, entry),
        }
    }

    /// Analyses it; `None` if it no longer has this content.
    pub(crate) fn record(&self, content: Hash, options: &Options) -> Option<Record> {
        let Some(entry) = &self.entry else {
            return Record::of_file(&self.path, content, options);
        };
        let bytes = archive::read(&self.path, entry).ok()?;
        let open = |bytes| Input::from_reader(Cursor::new(bytes), &self.name);
        (hash(&bytes) == content).then(|| Record::of(content, &self.name, options, || open(bytes)))
    }
}

/// All recordings of a session.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Session {
    /// Its title.
    pub title: Option<String>,
    /// The recordings, in the order of their names.
    pub recordings: Vec<RecordingFile>,
    /// What the session file states for all recordings; what is stated elsewhere goes before.
    pub settings: Settings,
    /// The balls that the session file describes.
    pub balls: BTreeMap<String, Notes>,
    /// Names that do not match the pattern.
    pub unmatched_names: UnmatchedNames,
    /// The pattern for file names.
    pattern: Option<Pattern>,
    /// The notes of files about a recording, by its index.
    listed: BTreeMap<usize, Vec<Notes>>,
    /// The notes about all recordings.
    all: Notes,
    /// The files of notes that were read.
    notes_files: Vec<PathBuf>,
}

/// Names of files that do not match the pattern.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct UnmatchedNames {
    pattern: String,
    names: Vec<String>,
}

impl UnmatchedNames {
    /// A remark about them, if there are any.
    pub fn remark(&self, translator: &Translator) -> Option<String> {
        let arguments = [
            ("count", self.names.len().into()),
            ("pattern", self.pattern.as_str().into()),
            ("names", some_of(&self.names, translator).into()),
        ];
        (!self.names.is_empty())
            .then(|| translator.text_with("session-unmatched-names", &arguments))
    }
}

impl Session {
    /// Searches for the recordings and reads the notes.
    ///
    /// # Errors
    /// If a file or folder cannot be read, a file of notes is malformed or names recordings that
    /// do not exist, the pattern is malformed, or there is no recording.
    pub fn gather(sources: &Sources) -> Result<Self> {
        let mut search = Search {
            is_alone: sources.inputs.len() == 1,
            ..Search::default()
        };
        for input in &sources.inputs {
            search.add(input)?;
        }
        let Search {
            file,
            mut recordings,
            lists,
            ..
        } = search;
        if recordings.is_empty() {
            recordings = whole_lists(lists);
        }
        if recordings.is_empty() {
            let searched: Vec<String> = sources.inputs.iter().map(|path| shown(path)).collect();
            return Err(Error::NoRecordings {
                what: format!("there is no recording in {}", searched.join(", ")),
            });
        }
        let mut seen = BTreeSet::new();
        recordings.retain(|it| seen.insert((it.path.clone(), it.name.clone())));
        recordings.sort_by(|a, b| a.name.cmp(&b.name));
        let (file_path, file) =
            file.map_or_else(Default::default, |(path, file)| (Some(path), *file));
        let parent = file_path.as_deref().and_then(Path::parent);
        let folder = parent.unwrap_or(Path::new("")).to_owned();
        let mut session = Self {
            title: file.title,
            recordings,
            settings: file.settings,
            balls: file.balls,
            unmatched_names: UnmatchedNames::default(),
            pattern: None,
            listed: BTreeMap::new(),
            all: file.all,
            notes_files: file_path.into_iter().collect(),
        };
        if let Some(pattern) = sources.pattern.clone().or(file.pattern) {
            session.pattern = Some(Pattern::new(&pattern)?);
            session.unmatched_names = session.unmatched_names();
        }
        session.take(file.recordings)?;
        let of_file = || Some(folder.join(file.notes?));
        if let Some(notes) = sources.notes.clone().or_else(of_file) {
            session.take(read_csv(&notes)?)?;
            session.notes_files.push(notes);
        }
        Ok(session)
    }

    /// A session of one recording, with the notes of its name and these notes.
    pub(crate) fn of_one(recording: RecordingFile, pattern: Option<Pattern>, notes: Notes) -> Self {
        Self {
            recordings: vec![recording],
            pattern,
            listed: BTreeMap::from([(0, vec![notes])]),
            ..Self::default()
        }
    }

    /// All files that were or will be read, recordings and notes, none of which may be written.
    pub fn inputs(&self) -> impl Iterator<Item = &Path> {
        let recordings = self.recordings.iter().map(|recording| &recording.path);
        recordings.chain(&self.notes_files).map(PathBuf::as_path)
    }

    /// All notes about the recording of an index, by field. Several notes may be about the same field; a note
    /// about all recordings counts only for fields without another note.
    ///
    /// They are collected at each call: stored for all recordings they would take more memory than
    /// the results.
    pub fn notes(&self, index: usize) -> BTreeMap<String, Vec<Note>> {
        let mut notes: BTreeMap<String, Vec<Note>> = BTreeMap::new();
        let mut add = |field: &str, note: Note| match notes.get_mut(field) {
            Some(others) => others.push(note),
            None => drop(notes.insert(field.to_owned(), vec![note])),
        };
        for (field, text) in self.fields_of_name(index).unwrap_or_default() {
            let text = Plain::of(&text).into();
            let said_by = "the file name".into();
            add(field, Note { text, said_by });
        }
        for (field, note) in self.listed.get(&index).into_iter().flatten().flatten() {
            add(field, note.clone());
        }
        for (field, note) in &self.all {
            if !notes.contains_key(field) {
                notes.insert(field.clone(), vec![note.clone()]);
            }
        }
        notes
    }

    /// The fields in the name of a file; `None` if the name does not match the pattern, or no pattern was stated.
    fn fields_of_name(&self, index: usize) -> Option<Vec<(&str, String)>> {
        let stem = self.recordings[index].file().file_stem()?.to_str()?;
        self.pattern.as_ref()?.fields(stem)
    }

    fn unmatched_names(&self) -> UnmatchedNames {
        let is_unmatched = |index: &usize| self.fields_of_name(*index).is_none();
        let unmatched = (0..self.recordings.len()).filter(is_unmatched);
        UnmatchedNames {
            pattern: self.pattern.as_ref().map_or("", Pattern::text).to_owned(),
            names: unmatched
                .map(|index| self.recordings[index].name.clone())
                .collect(),
        }
    }

    /// Assigns the notes of a file to the recordings that they name.
    fn take(&mut self, listed: Listed) -> Result<()> {
        let names = Names::new(&self.recordings);
        for (named, line, notes) in listed.rows {
            let index = names
                .find(&named)
                .map_err(|problem| Error::notes(&listed.file, line, problem))?;
            self.listed.entry(index).or_default().push(notes);
        }
        Ok(())
    }
}

/// Indices of recordings by name: that of the recording, that of its file, and that without its ending.
struct Names(BTreeMap<String, Vec<usize>>);

impl Names {
    fn new(recordings: &[RecordingFile]) -> Self {
        let mut by_name: BTreeMap<String, Vec<usize>> = BTreeMap::new();
        for (index, recording) in recordings.iter().enumerate() {
            let short = |part: Option<&std::ffi::OsStr>| part.map(|part| name(Path::new(part)));
            let names = [
                Some(recording.name.clone()),
                short(recording.file().file_name()),
                short(recording.file().file_stem()),
            ];
            for name in names.into_iter().flatten().collect::<BTreeSet<_>>() {
                by_name.entry(name).or_default().push(index);
            }
        }
        Self(by_name)
    }

    fn find(&self, named: &str) -> std::result::Result<usize, String> {
        let name = name(Path::new(named));
        match self.0.get(&name).map(Vec::as_slice) {
            Some([index]) => Ok(*index),
            Some(_) => Err(format!(
                "\"{named}\" is the name of several recordings; write the folder too"
            )),
            None => Err(format!(
                "names \"{named}\", but there is no such recording; is it misspelt, or in \
                 another folder?"
            )),
        }
    }
}

/// A search for recordings.
#[derive(Default)]
struct Search {
    /// Whether a single input was given, so that names are relative to it.
    is_alone: bool,
    /// The session file.
    file: Option<(PathBuf, Box<SessionFile>)>,
    recordings: Vec<RecordingFile>,
    /// Lists of times in folders and archives, which count where no sound is: beside sound, tables are notes and labels.
    lists: Vec<RecordingFile>,
}

impl Search {
    fn add(&mut self, input: &Path) -> Result<()> {
        let about = fs::metadata(input).map_err(Error::read(input))?;
        let is_notes = input.extension().is_some_and(|ending| ending == "toml");
        if about.is_dir() {
            let file = input.join(SESSION_FILE);
            if file.is_file() {
                self.add_session(&file)
            } else {
                self.add_folder(input, input)
            }
        } else if is_notes {
            self.add_session(input)
        } else if archive::is_archive(input) {
            self.add_archive(input)
        } else {
            self.recordings.push(RecordingFile {
                path: input.to_owned(),
                entry: None,
                name: name(input),
            });
            Ok(())
        }
    }

    /// Adds all recordings in an archive.
    fn add_archive(&mut self, path: &Path) -> Result<()> {
        let entries = archive::entries(path, |name| is_recording(name) || is_list(name))?;
        // An export of a stopwatch is one list in an archive.
        if !entries.iter().any(|entry| is_recording(&entry.name)) && times::read(path).is_ok() {
            self.recordings.push(RecordingFile {
                path: path.to_owned(),
                entry: None,
                name: name(path),
            });
            return Ok(());
        }
        for entry in entries {
            let alone = name(&entry.name);
            self.push(RecordingFile {
                path: path.to_owned(),
                name: if self.is_alone {
                    alone
                } else {
                    format!("{}/{alone}", name(path))
                },
                entry: Some(entry),
            });
        }
        Ok(())
    }

    /// Adds what was found in a folder or an archive.
    fn push(&mut self, found: RecordingFile) {
        if is_recording(found.file()) {
            self.recordings.push(found);
        } else {
            self.lists.push(found);
        }
    }

    fn add_session(&mut self, path: &Path) -> Result<()> {
        if self.file.is_some() {
            return Err(Error::notes(
                path,
                None,
                "is a second session file; name one",
            ));
        }
        let file = SessionFile::read(path)?;
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        for within in file.folders.clone().unwrap_or_else(|| vec![PathBuf::new()]) {
            let joined = folder.join(within);
            let searched = if joined.as_os_str().is_empty() {
                Path::new(".")
            } else {
                &joined
            };
            self.add_folder(&folder, searched)?;
        }
        self.file = Some((path.to_owned(), Box::new(file)));
        Ok(())
    }

    /// Adds all recordings in a folder and the folders in it, without hidden ones. Folders that are links
    /// are left out: they may form a circle.
    fn add_folder(&mut self, base: &Path, folder: &Path) -> Result<()> {
        let mut entries = fs::read_dir(folder)
            .and_then(Iterator::collect::<std::io::Result<Vec<_>>>)
            .map_err(Error::read(folder))?;
        entries.sort_by_key(fs::DirEntry::file_name);
        for entry in entries {
            let path = entry.path();
            if entry.file_name().as_encoded_bytes().starts_with(b".") {
                continue;
            }
            let kind = entry.file_type().map_err(Error::read(&path))?;
            if kind.is_dir() {
                self.add_folder(base, &path)?;
            } else if (is_recording(&path) || is_list(&path)) && path.is_file() {
                let below_base = path.strip_prefix(base).unwrap_or(&path);
                let relative = below_base.strip_prefix(".").unwrap_or(below_base);
                let called = name(if self.is_alone { relative } else { &path });
                self.push(RecordingFile {
                    path,
                    entry: None,
                    name: called,
                });
            }
        }
        Ok(())
    }
}

/// Whether a file of a folder or an archive has the name of a list of times.
fn is_list(path: &Path) -> bool {
    path.to_str().is_some_and(times::is_list)
}

/// The files that are lists of one drop each, or damaged ones. Files of other content are left out, and so are `Simple` and
/// `Multiple` beside `All`: a stopwatch exports the same run as each of them, and `All` has most of it.
fn whole_lists(mut found: Vec<RecordingFile>) -> Vec<RecordingFile> {
    let has_stem =
        |found: &RecordingFile, stem| found.file().file_stem().is_some_and(|own| own == stem);
    let whole = found.iter().filter(|found| has_stem(found, "All"));
    let whole: BTreeSet<PathBuf> = whole
        .filter_map(|all| Some(all.file().parent()?.to_owned()))
        .collect();
    let is_part = |found: &RecordingFile| {
        let parts = ["Simple", "Multiple"]
            .iter()
            .any(|stem| has_stem(found, stem));
        parts
            && found
                .file()
                .parent()
                .is_some_and(|folder| whole.contains(folder))
    };
    found.retain(|found| !is_part(found) && found.holds_times());
    found
}

/// Whether a file of a folder or an archive has the name of a recording; one that is named itself may have any.
fn is_recording(path: &Path) -> bool {
    let ending = path.extension().and_then(|ending| ending.to_str());
    ending.is_some_and(|ending| {
        SoundFormat::endings_of_all().any(|known| known.eq_ignore_ascii_case(ending))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A folder with these files.
    fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
        let folder = tempfile::tempdir().unwrap();
        for (name, text) in files {
            let path = folder.path().join(name);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        }
        folder
    }

    fn gather(folder: &tempfile::TempDir) -> Result<Session> {
        Session::gather(&Sources {
            inputs: vec![folder.path().to_owned()],
            ..Sources::default()
        })
    }

    fn texts(session: &Session, name: &str, field: &str) -> Vec<String> {
        let index = session.recordings.iter().position(|r| r.name == name);
        let notes = session.notes(index.unwrap()).remove(field);
        let notes = notes.unwrap_or_default().into_iter();
        notes.map(|note| note.text).collect()
    }

    #[test]
    fn a_folder_is_searched_for_recordings() {
        let folder = folder(&[
            ("b.wav", ""),
            ("a.WAV", ""),
            ("monday/c.m4a", ""),
            (".hidden.wav", ""),
            ("notes.txt", ""),
        ]);
        let session = gather(&folder).unwrap();
        let names: Vec<&str> = session.recordings.iter().map(|r| r.name.as_str()).collect();
        assert_eq!(names, ["a.WAV", "b.wav", "monday/c.m4a"]);
    }

    #[test]
    fn a_folder_without_sound_is_searched_for_lists() {
        let times = "Time (s)\n0.8\n1.4\n1.94\n";
        let files = [
            ("ada.csv", times),
            (
                "ben/All.csv",
                "\"Event time (s)\",\"Interval (s)\"\n0.8,0.6\n1.4,0.54\n",
            ),
            (
                "ben/Simple.csv",
                "\"Start (s)\",\"Stop (s)\",\"Difference (s)\"\n0.8,1.4,0.6\n",
            ),
            (
                "ben/meta/device.csv",
                "\"property\",\"value\"\ndeviceModel,Seven\n",
            ),
            ("damaged.csv", "Time (s)\n0.8\noops\n"),
            ("notes.csv", "recording,ball\nada.csv,golf\n"),
            ("readme.txt", "Dropped from the table\n"),
        ];
        let names = |folder: &tempfile::TempDir| {
            let session = gather(folder).unwrap();
            session
                .recordings
                .into_iter()
                .map(|found| found.name)
                .collect::<Vec<_>>()
        };
        assert_eq!(
            names(&folder(&files)),
            ["ada.csv", "ben/All.csv", "damaged.csv"]
        );
        // Beside sound they are labels of it.
        assert_eq!(names(&folder(&[files[0], ("ada.wav", "")])), ["ada.wav"]);
    }

    #[test]
    fn an_archive_has_the_lists_of_a_class_or_the_tables_of_one_stopwatch() {
        let times = "Time (s)\n0.8\n1.4\n1.94\n";
        let names = |files: &[(&str, &str)]| {
            let file = tempfile::Builder::new().suffix(".zip").tempfile().unwrap();
            let mut writer = zip::ZipWriter::new(file.reopen().unwrap());
            for (name, text) in files {
                writer
                    .start_file(name, zip::write::SimpleFileOptions::default())
                    .unwrap();
                std::io::Write::write_all(&mut writer, text.as_bytes()).unwrap();
            }
            writer.finish().unwrap();
            let session = Session::gather(&Sources {
                inputs: vec![file.path().to_owned()],
                ..Sources::default()
            });
            let own = name(file.path());
            let names = session
                .unwrap()
                .recordings
                .into_iter()
                .map(|found| found.name.replace(&own, "export.zip"));
            names.collect::<Vec<_>>()
        };
        let other = "Time (s)\n0.3\n0.9\n1.44\n";
        assert_eq!(
            names(&[("ada.csv", times), ("ben.csv", other)]),
            ["ada.csv", "ben.csv"]
        );
        let export = [
            ("All.csv", times),
            ("Simple.csv", "Start (s),Stop (s)\n0.8,1.4\n"),
        ];
        assert_eq!(names(&export), ["export.zip"]);
    }

    #[test]
    fn notes_come_together_from_everywhere() {
        let folder = folder(&[
            (
                "session.toml",
                "pattern = \"{ball}_{height}_{}\"\nnotes = \"notes.csv\"\n[all]\noperator = \"Ada\"\n\
                 [recordings.\"red_30cm_1.wav\"]\nsurface = \"steel\"\n",
            ),
            (
                "notes.csv",
                "recording,operator,surface\nred_30cm_1,Bob,\nsub/blue_40cm_2.wav,,glass\n",
            ),
            ("red_30cm_1.wav", ""),
            ("sub/blue_40cm_2.wav", ""),
            ("odd.wav", ""),
        ]);
        let session = gather(&folder).unwrap();
        assert_eq!(texts(&session, "red_30cm_1.wav", "ball"), ["red"]);
        assert_eq!(texts(&session, "red_30cm_1.wav", "operator"), ["Bob"]);
        assert_eq!(texts(&session, "red_30cm_1.wav", "surface"), ["steel"]);
        assert_eq!(texts(&session, "sub/blue_40cm_2.wav", "operator"), ["Ada"]);
        assert_eq!(texts(&session, "sub/blue_40cm_2.wav", "surface"), ["glass"]);
        assert!(texts(&session, "odd.wav", "ball").is_empty());
        let remark = session.unmatched_names.remark(&Translator::english());
        let expected = "1 name does not fit the pattern \"{ball}_{height}_{}\": odd.wav";
        assert_eq!(remark.as_deref(), Some(expected));
    }

    #[test]
    fn notes_of_what_is_not_there_are_refused() {
        let files = [
            (
                "notes.csv",
                "recording,ball\nred_1.wav,red\nred_2.wav,red\n",
            ),
            ("red_1.wav", ""),
        ];
        let folder = folder(&files);
        let refused = Session::gather(&Sources {
            inputs: vec![folder.path().join("red_1.wav")],
            notes: Some(folder.path().join("notes.csv")),
            pattern: None,
        });
        let message = refused.unwrap_err().to_string();
        assert!(
            message.contains("line 3") && message.contains("red_2.wav"),
            "{message}"
        );
    }

    #[test]
    fn a_short_name_of_two_recordings_is_refused() {
        let folder = folder(&[
            ("session.toml", "[recordings.\"a.wav\"]\nball = \"red\"\n"),
            ("one/a.wav", ""),
            ("two/a.wav", ""),
        ]);
        assert!(gather(&folder).unwrap_err().to_string().contains("several"));
    }

    #[test]
    fn no_recordings_are_an_error() {
        let empty = folder(&[("notes.txt", "")]);
        assert!(matches!(gather(&empty), Err(Error::NoRecordings { .. })));
        let missing = Sources {
            inputs: vec![empty.path().join("nowhere")],
            ..Sources::default()
        };
        assert!(matches!(Session::gather(&missing), Err(Error::Read { .. })));
    }
}
