//! Recordings in a ZIP archive, as a class hands them in.
//!
//! An archive is read in memory, one recording at a time. Nothing in it is written to the disk, so that the names in it
//! are never used as paths.

use std::cell::RefCell;
use std::fmt;
use std::fs::{self, File};
use std::io::{self, BufReader, Read};
use std::path::{Component, Path, PathBuf};
use std::time::SystemTime;

use zip::ZipArchive;
use zip::result::ZipError;

use crate::error::{Error, Result};
use crate::hash::{Hash, hash_of_all};
use crate::name::shown;

/// Maximum number of files in an archive, folders included.
const MAX_FILES: usize = 10_000;
/// Maximum size of one recording, unpacked, in bytes.
const MAX_LEN: u64 = 256 << 20;
/// Maximum size of all recordings together, unpacked, in bytes.
const MAX_TOTAL_LEN: u64 = 16 << 30;

/// A recording in an archive.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ArchiveEntry {
    /// Its index in the archive.
    index: usize,
    /// Its name in the archive.
    pub(crate) name: PathBuf,
}

pub(crate) fn is_archive(path: &Path) -> bool {
    path.extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("zip"))
}

/// The files in an archive whose names are `wanted`, without hidden ones.
///
/// # Errors
/// If the file is not an archive, or holds more than can be read.
pub(crate) fn entries(path: &Path, wanted: impl Fn(&Path) -> bool) -> Result<Vec<ArchiveEntry>> {
    let archive = open(path)?;
    if archive.len() > MAX_FILES {
        return Err(refused(path, &TooMuch("more than 10,000 files")));
    }
    let mut entries = Vec::new();
    let mut bytes = 0_u64;
    for index in 0..archive.len() {
        let file = archive
            .by_index_data(index)
            .map_err(|reason| unread(path, &reason))?;
        let stored = file.name().map_err(|reason| unread(path, &reason))?;
        let whole = Path::new(&*stored);
        // Some programs begin every name with "./". A ".." has no effect, since no name is used as a path.
        let name = whole.strip_prefix(".").unwrap_or(whole).to_owned();
        let is_hidden = name.components().any(|part| {
            matches!(part, Component::Normal(part) if part.as_encoded_bytes().starts_with(b"."))
        });
        if !file.is_file() || is_hidden || !wanted(&name) {
            continue;
        }
        if file.size() > MAX_LEN {
            let problem = format!("\"{}\", which is larger than 256 MB", shown(&name));
            return Err(refused(path, &TooMuch(&problem)));
        }
        bytes = bytes.saturating_add(file.size());
        entries.push(ArchiveEntry { index, name });
    }
    if bytes > MAX_TOTAL_LEN {
        return Err(refused(path, &TooMuch("more than 16 GB of recordings")));
    }
    Ok(entries)
}

/// The content of a recording.
///
/// # Errors
/// If it is damaged, encrypted, packed by another method than deflate, or larger than announced.
pub(crate) fn read(path: &Path, entry: &ArchiveEntry) -> Result<Vec<u8>> {
    let mut content = Vec::new();
    unpack(path, entry, |file| file.read_to_end(&mut content))?;
    Ok(content)
}

/// The hash of the content of a recording, which is unpacked in pieces.
///
/// # Errors
/// As for [`read`].
pub(crate) fn hash(path: &Path, entry: &ArchiveEntry) -> Result<Hash> {
    unpack(path, entry, |file| hash_of_all(file))
}

/// Unpacks a recording with `read`, which reads it to its end.
fn unpack<T>(
    path: &Path,
    entry: &ArchiveEntry,
    read: impl FnOnce(&mut dyn Read) -> io::Result<T>,
) -> Result<T> {
    OPEN.with_borrow_mut(|last| {
        let archive = reopened(last, path)?;
        unpack_from(archive, path, entry, read)
    })
}

thread_local! {
    /// The archive that was read last: its recordings are read one after the other, and its table of contents, which may
    /// have 10,000 lines, only once.
    static OPEN: RefCell<Option<Opened>> = const { RefCell::new(None) };
}

/// An archive, and the state of its file when it was opened.
struct Opened {
    path: PathBuf,
    state: State,
    archive: Archive,
}

type Archive = ZipArchive<BufReader<File>>;

/// Length and time of the last change of a file.
type State = (u64, Option<SystemTime>);

/// The archive at a path, opened only if it is another one than the last, or was changed.
fn reopened<'a>(last: &'a mut Option<Opened>, path: &Path) -> Result<&'a mut Archive> {
    let about = fs::metadata(path).map_err(Error::read(path))?;
    let state = (about.len(), about.modified().ok());
    let known = last.take_if(|last| last.path == path && last.state == state);
    let opened = match known {
        Some(opened) => opened,
        None => Opened {
            path: path.to_owned(),
            state,
            archive: open(path)?,
        },
    };
    Ok(&mut last.insert(opened).archive)
}

fn unpack_from<T>(
    archive: &mut Archive,
    path: &Path,
    entry: &ArchiveEntry,
    read: impl FnOnce(&mut dyn Read) -> io::Result<T>,
) -> Result<T> {
    let file = archive
        .by_index(entry.index)
        .map_err(|reason| unread(path, &reason))?;
    let size = file.size().min(MAX_LEN);
    // One byte more shows that the recording is larger than announced.
    let mut announced = file.take(size + 1);
    let content = read(&mut announced).map_err(|_| damaged(path))?;
    if announced.limit() == 0 {
        let problem = format!("\"{}\", which is larger than announced", shown(&entry.name));
        return Err(refused(path, &TooMuch(&problem)));
    }
    Ok(content)
}

fn open(path: &Path) -> Result<Archive> {
    let file = crate::hash::open(path).map_err(Error::read(path))?;
    ZipArchive::new(BufReader::new(file)).map_err(|reason| unread(path, &reason))
}

/// The error for an archive that other programs may be able to unpack.
fn refused(path: &Path, problem: &dyn fmt::Display) -> Error {
    Error::Archive {
        path: path.to_owned(),
        problem: format!("{problem}; unpack it into a folder, and name that"),
    }
}

fn damaged(path: &Path) -> Error {
    Error::Archive {
        path: path.to_owned(),
        problem: "it is damaged, or no ZIP archive; copy or download it again".to_owned(),
    }
}

fn unread(path: &Path, reason: &ZipError) -> Error {
    match reason {
        ZipError::InvalidArchive(_) | ZipError::Io(_) => damaged(path),
        _ => refused(path, reason),
    }
}

struct TooMuch<'a>(&'a str);

impl fmt::Display for TooMuch<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "it holds {}", self.0)
    }
}

#[cfg(test)]
mod tests {
    use std::io::Write;

    use proptest::prelude::*;
    use zip::ZipWriter;
    use zip::write::SimpleFileOptions;

    use super::*;

    /// An archive of files with these names and contents.
    fn archive(files: &[(String, Vec<u8>)]) -> tempfile::NamedTempFile {
        let file = tempfile::Builder::new().suffix(".zip").tempfile().unwrap();
        let mut writer = ZipWriter::new(file.reopen().unwrap());
        for (name, content) in files {
            writer
                .start_file(name, SimpleFileOptions::default())
                .unwrap();
            writer.write_all(content).unwrap();
        }
        writer.finish().unwrap();
        file
    }

    proptest! {
        /// Names are returned as they stand in the archive, and none is used as a path.
        #[test]
        fn every_file_comes_back(contents in proptest::collection::btree_map("[a-z/]{0,3}(\\.\\./){0,2}[a-z]{1,8}\\.wav", proptest::collection::vec(any::<u8>(), 0..2000), 0..5)) {
            let files: Vec<_> = contents.into_iter().collect();
            let packed = archive(&files);
            let found = entries(packed.path(), |_| true).unwrap();
            prop_assert_eq!(found.len(), files.len());
            for ((name, content), entry) in files.iter().zip(&found) {
                prop_assert_eq!(Path::new(name), &*entry.name);
                prop_assert_eq!(content, &read(packed.path(), entry).unwrap());
                prop_assert_eq!(crate::hash::hash(content), hash(packed.path(), entry).unwrap());
            }
        }

        /// Damage is refused or harmless, and never a panic.
        #[test]
        fn damage_is_refused(at in any::<prop::sample::Index>(), bit in 0..8_u8) {
            let content = b"0\n0.46\n0.89\n".repeat(20);
            let packed = archive(&[("drop.wav".to_owned(), content.clone())]);
            let mut bytes = std::fs::read(packed.path()).unwrap();
            let at = at.index(bytes.len());
            bytes[at] ^= 1_u8 << bit;
            std::fs::write(packed.path(), bytes).unwrap();
            for entry in entries(packed.path(), |_| true).unwrap_or_default() {
                if let Ok(read) = read(packed.path(), &entry) {
                    prop_assert_eq!(&read, &content);
                }
            }
        }
    }

    #[test]
    fn an_archive_that_was_changed_is_opened_again() {
        let one = |content: &str| archive(&[("a.csv".to_owned(), content.into())]);
        let (first, second) = (one("1"), one("2, and longer"));
        let entry = &entries(first.path(), |_| true).unwrap()[0];
        assert_eq!(read(first.path(), entry).unwrap(), b"1");
        std::fs::copy(second.path(), first.path()).unwrap();
        assert_eq!(read(first.path(), entry).unwrap(), b"2, and longer");
    }

    #[test]
    fn hidden_files_are_left_out_and_names_lose_the_current_folder() {
        let names = [
            "./drop.wav",
            "class/./a.wav",
            ".b.wav",
            "__MACOSX/._a.wav",
            ".git/c.wav",
        ];
        let files: Vec<_> = names.map(|name| (name.to_owned(), Vec::new())).to_vec();
        let entries = entries(archive(&files).path(), |_| true).unwrap();
        let names: Vec<_> = entries.iter().map(|entry| &*entry.name).collect();
        assert_eq!(names, [Path::new("drop.wav"), Path::new("class/a.wav")]);
    }

    #[test]
    fn what_is_no_archive_or_too_much_is_refused() {
        let nothing = tempfile::NamedTempFile::new().unwrap();
        let refused = entries(nothing.path(), |_| true).unwrap_err().to_string();
        assert!(refused.ends_with("copy or download it again"), "{refused}");
        let many: Vec<_> = (0..=MAX_FILES)
            .map(|n| (format!("{n}.wav"), Vec::new()))
            .collect();
        let refused = entries(archive(&many).path(), |_| true)
            .unwrap_err()
            .to_string();
        assert!(
            refused.contains("more than 10,000 files; unpack it"),
            "{refused}"
        );
    }

    /// The size that an archive announces is changed in its list of contents, as an archive that bursts does.
    #[test]
    fn a_file_larger_than_it_says_is_refused() {
        let content = vec![0_u8; 100_000];
        let packed = archive(&[("drop.wav".to_owned(), content.clone())]);
        let bytes = std::fs::read(packed.path()).unwrap();
        let stated = (content.len() as u32).to_le_bytes();
        let less = 10_u32.to_le_bytes();
        let mut changed = bytes.clone();
        for at in 0..bytes.len() - 3 {
            if bytes[at..at + 4] == stated {
                changed[at..at + 4].copy_from_slice(&less);
            }
        }
        std::fs::write(packed.path(), changed).unwrap();
        let entry = &entries(packed.path(), |_| true).unwrap()[0];
        assert!(matches!(
            read(packed.path(), entry),
            Err(Error::Archive { .. })
        ));
        assert!(matches!(
            hash(packed.path(), entry),
            Err(Error::Archive { .. })
        ));
    }

    #[test]
    fn a_damaged_recording_is_to_be_copied_again() {
        let packed = archive(&[("drop.wav".to_owned(), (0..200).collect())]);
        let mut bytes = std::fs::read(packed.path()).unwrap();
        bytes[100] ^= 1;
        std::fs::write(packed.path(), bytes).unwrap();
        let entry = &entries(packed.path(), |_| true).unwrap()[0];
        let refused = read(packed.path(), entry).unwrap_err().to_string();
        assert!(refused.contains("copy or download it again"), "{refused}");
    }
}
