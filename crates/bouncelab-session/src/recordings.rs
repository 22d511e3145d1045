//! Finds the recordings and their metadata.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::Cursor;
use std::path::{Path, PathBuf};

use bouncelab::{Options, Plain};
use bouncelab_audio::{Input, SoundFormat};
use bouncelab_report::groups::some_of;
use bouncelab_report::messages::Translator;

use crate::archive::{self, Entry};
use crate::error::{Error, Result};
use crate::hash::{Hash, hash, hash_of_file};
use crate::name::{name, shown};
use crate::notes::{Listed, Note, Notes, SessionFile, read_csv};
use crate::pattern::Pattern;
use crate::record::Record;

/// What a session file is called when only its folder is named.
pub const SESSION_FILE: &str = "session.toml";

/// Where to look.
#[derive(Debug, Clone, Default)]
pub struct Sources {
    /// Recordings, folders or ZIP archives with recordings, session files.
    pub inputs: Vec<PathBuf>,
    /// What file names say; before that of a session file.
    pub pattern: Option<String>,
    /// A CSV of notes; before that of a session file.
    pub table: Option<PathBuf>,
}

/// A recording.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Recording {
    /// Where it is, or the archive that holds it.
    pub path: PathBuf,
    /// Which file of the archive it is, if it is in one.
    pub entry: Option<Entry>,
    /// What it is called in tables: relative to the folder of the session, as text.
    pub name: String,
}

impl Recording {
    /// The name of its file, with folders.
    fn file(&self) -> &Path {
        self.entry.as_ref().map_or(&self.path, |entry| &entry.name)
    }

    /// The hash of its content.
    pub(crate) fn content(&self) -> Result<Hash> {
        match &self.entry {
            None => hash_of_file(&self.path),
            Some(entry) => archive::hash(&self.path, entry),
        }
    }

    /// What it says; `None` if this is not its content, or no longer.
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
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Session {
    /// What it is called.
    pub title: Option<String>,
    /// The recordings, in the order of their names.
    pub recordings: Vec<Recording>,
    /// The balls that the session file describes.
    pub balls: BTreeMap<String, Notes>,
    /// Names that do not fit the pattern.
    pub odd_names: OddNames,
    /// What the names of the files say.
    pattern: Option<Pattern>,
    /// What files of notes say of a recording, by its place.
    listed: BTreeMap<usize, Vec<Notes>>,
    /// What is said of all.
    all: Notes,
    /// The files of notes that were read.
    notes_files: Vec<PathBuf>,
}

/// Names of files that do not fit the pattern.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct OddNames {
    pattern: String,
    names: Vec<String>,
}

impl OddNames {
    /// What to say of them, if there are any.
    pub fn remark(&self, words: &Translator) -> Option<String> {
        let arguments = [
            ("count", self.names.len().into()),
            ("pattern", self.pattern.as_str().into()),
            ("names", some_of(&self.names, words).into()),
        ];
        (!self.names.is_empty()).then(|| words.text_with("session-odd-names", &arguments))
    }
}

impl Session {
    /// Finds the recordings and reads the notes.
    ///
    /// # Errors
    /// If a file or folder cannot be read, a file of notes is damaged or speaks of recordings that
    /// are not there, the pattern makes no sense, or there is no recording.
    pub fn gather(sources: &Sources) -> Result<Self> {
        let mut found = Found {
            alone: sources.inputs.len() == 1,
            file: None,
            recordings: Vec::new(),
        };
        for input in &sources.inputs {
            found.add(input)?;
        }
        let Found {
            file,
            mut recordings,
            ..
        } = found;
        if recordings.is_empty() {
            let looked: Vec<String> = sources.inputs.iter().map(|path| shown(path)).collect();
            return Err(Error::NoRecordings {
                what: format!("there is no recording in {}", looked.join(", ")),
            });
        }
        let mut seen = BTreeSet::new();
        recordings.retain(|it| seen.insert((it.path.clone(), it.name.clone())));
        recordings.sort_by(|a, b| a.name.cmp(&b.name));
        let (file_path, file) =
            file.map_or_else(Default::default, |(path, file)| (Some(path), *file));
        let folder = file_path.as_deref().and_then(Path::parent);
        let folder = folder.unwrap_or(Path::new("")).to_owned();
        let mut session = Self {
            title: file.title,
            recordings,
            balls: file.balls,
            odd_names: OddNames::default(),
            pattern: None,
            listed: BTreeMap::new(),
            all: file.all,
            notes_files: file_path.into_iter().collect(),
        };
        if let Some(pattern) = sources.pattern.clone().or(file.pattern) {
            session.pattern = Some(Pattern::new(&pattern)?);
            session.odd_names = session.odd_names();
        }
        session.take(file.recordings)?;
        let table = sources.table.clone();
        if let Some(table) = table.or_else(|| Some(folder.join(file.table?))) {
            session.take(read_csv(&table)?)?;
            session.notes_files.push(table);
        }
        Ok(session)
    }

    /// A single recording, of which its name and these notes say something.
    pub(crate) fn of_one(recording: Recording, pattern: Option<Pattern>, notes: Notes) -> Self {
        Self {
            recordings: vec![recording],
            pattern,
            listed: BTreeMap::from([(0, vec![notes])]),
            ..Self::default()
        }
    }

    /// Every file that was read, or will be: recordings and notes. None of them may be written.
    pub fn inputs(&self) -> impl Iterator<Item = &Path> {
        let recordings = self.recordings.iter().map(|recording| &recording.path);
        recordings.chain(&self.notes_files).map(PathBuf::as_path)
    }

    /// All that was said of the recording at a place, by field. Several may have said something of
    /// the same; what is said of all counts only where nobody else says anything.
    ///
    /// It is put together anew each time: kept for all recordings it would take more memory than
    /// their results.
    pub fn notes(&self, place: usize) -> BTreeMap<String, Vec<Note>> {
        let mut notes: BTreeMap<String, Vec<Note>> = BTreeMap::new();
        let mut say = |field: &str, note: Note| match notes.get_mut(field) {
            Some(said) => said.push(note),
            None => drop(notes.insert(field.to_owned(), vec![note])),
        };
        for (field, text) in self.fields_of_name(place).unwrap_or_default() {
            let text = Plain::of(&text).into();
            let said_by = "the file name".into();
            say(field, Note { text, said_by });
        }
        for (field, note) in self.listed.get(&place).into_iter().flatten().flatten() {
            say(field, note.clone());
        }
        for (field, note) in &self.all {
            if !notes.contains_key(field) {
                notes.insert(field.clone(), vec![note.clone()]);
            }
        }
        notes
    }

    /// What the name of a file says; `None` if it does not fit the pattern, or there is none.
    fn fields_of_name(&self, place: usize) -> Option<Vec<(&str, String)>> {
        let stem = self.recordings[place].file().file_stem()?.to_str()?;
        self.pattern.as_ref()?.fields(stem)
    }

    fn odd_names(&self) -> OddNames {
        let is_odd = |place: &usize| self.fields_of_name(*place).is_none();
        let odd = (0..self.recordings.len()).filter(is_odd);
        OddNames {
            pattern: self.pattern.as_ref().map_or("", Pattern::text).to_owned(),
            names: odd
                .map(|place| self.recordings[place].name.clone())
                .collect(),
        }
    }

    /// Notes of a file, each to the recording that it names.
    fn take(&mut self, listed: Listed) -> Result<()> {
        let index = Index::new(&self.recordings);
        for (named, line, notes) in listed.rows {
            let place = index
                .find(&named)
                .map_err(|problem| Error::notes(&listed.file, line, problem))?;
            self.listed.entry(place).or_default().push(notes);
        }
        Ok(())
    }
}

/// Recordings by their name, the name of their file, and that without its ending.
struct Index {
    places: BTreeMap<String, Vec<usize>>,
}

impl Index {
    fn new(recordings: &[Recording]) -> Self {
        let mut places: BTreeMap<String, Vec<usize>> = BTreeMap::new();
        for (place, recording) in recordings.iter().enumerate() {
            let short = |part: Option<&std::ffi::OsStr>| part.map(|part| name(Path::new(part)));
            let names = [
                Some(recording.name.clone()),
                short(recording.file().file_name()),
                short(recording.file().file_stem()),
            ];
            for name in names.into_iter().flatten().collect::<BTreeSet<_>>() {
                places.entry(name).or_default().push(place);
            }
        }
        Self { places }
    }

    fn find(&self, named: &str) -> std::result::Result<usize, String> {
        let name = name(Path::new(named));
        match self.places.get(&name).map(Vec::as_slice) {
            Some([place]) => Ok(*place),
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

/// Recordings as they are found.
struct Found {
    /// Whether a single input was named, so that names need not say in which folder.
    alone: bool,
    /// The session file.
    file: Option<(PathBuf, Box<SessionFile>)>,
    recordings: Vec<Recording>,
}

impl Found {
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
            self.recordings.push(Recording {
                path: input.to_owned(),
                entry: None,
                name: name(input),
            });
            Ok(())
        }
    }

    /// All recordings in an archive.
    fn add_archive(&mut self, path: &Path) -> Result<()> {
        for entry in archive::entries(path, is_recording)? {
            let alone = name(&entry.name);
            self.recordings.push(Recording {
                path: path.to_owned(),
                name: if self.alone {
                    alone
                } else {
                    format!("{}/{alone}", name(path))
                },
                entry: Some(entry),
            });
        }
        Ok(())
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
            let within = folder.join(within);
            let within = if within.as_os_str().is_empty() {
                PathBuf::from(".")
            } else {
                within
            };
            self.add_folder(&folder, &within)?;
        }
        self.file = Some((path.to_owned(), Box::new(file)));
        Ok(())
    }

    /// All recordings in a folder and the folders in it, but for hidden ones. Folders that are links
    /// are left out: they may lead round in a circle.
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
            } else if is_recording(&path) && path.is_file() {
                let relative = path.strip_prefix(base).unwrap_or(&path);
                let relative = relative.strip_prefix(".").unwrap_or(relative);
                let called = name(if self.alone { relative } else { &path });
                self.recordings.push(Recording {
                    path,
                    entry: None,
                    name: called,
                });
            }
        }
        Ok(())
    }
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

    fn said(session: &Session, name: &str, field: &str) -> Vec<String> {
        let place = session.recordings.iter().position(|r| r.name == name);
        let notes = session.notes(place.unwrap()).remove(field);
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
    fn notes_come_together_from_everywhere() {
        let folder = folder(&[
            (
                "session.toml",
                "pattern = \"{ball}_{height}_{}\"\ntable = \"notes.csv\"\n[all]\noperator = \"Ada\"\n\
                 [recordings.\"red_30cm_1.wav\"]\nsurface = \"steel\"\n",
            ),
            (
                "notes.csv",
                "file,operator,surface\nred_30cm_1,Bob,\nsub/blue_40cm_2.wav,,glass\n",
            ),
            ("red_30cm_1.wav", ""),
            ("sub/blue_40cm_2.wav", ""),
            ("odd.wav", ""),
        ]);
        let session = gather(&folder).unwrap();
        assert_eq!(said(&session, "red_30cm_1.wav", "ball"), ["red"]);
        assert_eq!(said(&session, "red_30cm_1.wav", "operator"), ["Bob"]);
        assert_eq!(said(&session, "red_30cm_1.wav", "surface"), ["steel"]);
        assert_eq!(said(&session, "sub/blue_40cm_2.wav", "operator"), ["Ada"]);
        assert_eq!(said(&session, "sub/blue_40cm_2.wav", "surface"), ["glass"]);
        assert!(said(&session, "odd.wav", "ball").is_empty());
        let remark = session.odd_names.remark(&Translator::english());
        let expected = "1 name does not fit the pattern \"{ball}_{height}_{}\": odd.wav";
        assert_eq!(remark.as_deref(), Some(expected));
    }

    #[test]
    fn contradictions_are_kept_for_who_can_judge_them() {
        let folder = folder(&[
            (
                "session.toml",
                "pattern = \"{ball}_{}\"\ntable = \"notes.csv\"",
            ),
            ("notes.csv", "file,ball\nred_1.wav,blue\n"),
            ("red_1.wav", ""),
        ]);
        assert_eq!(
            said(&gather(&folder).unwrap(), "red_1.wav", "ball"),
            ["red", "blue"]
        );
    }

    #[test]
    fn notes_of_what_is_not_there_are_refused() {
        let files = [
            ("notes.csv", "file,ball\nred_1.wav,red\nred_2.wav,red\n"),
            ("red_1.wav", ""),
        ];
        let folder = folder(&files);
        let refused = Session::gather(&Sources {
            inputs: vec![folder.path().join("red_1.wav")],
            table: Some(folder.path().join("notes.csv")),
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

    #[cfg(target_os = "linux")]
    #[test]
    fn names_that_are_no_text_have_names() {
        use std::os::unix::ffi::OsStrExt;
        let folder = folder(&[]);
        let raw = std::ffi::OsStr::from_bytes(b"red\xff_1.wav");
        fs::write(folder.path().join(raw), "").unwrap();
        let session = gather(&folder).unwrap();
        assert_eq!(session.recordings[0].name, "red\\xff_1.wav");
    }
}
