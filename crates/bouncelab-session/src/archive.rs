//! Recordings in a ZIP archive, as a class hands them in.
//!
//! An archive is read in memory, one recording at a time. Nothing in it is written to the disk, so that the names in it
//! are never used as paths.

use std::collections::HashMap;
use std::fmt;
use std::fs::File;
use std::io::{self, BufReader, Read};
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

use zip::HasZipMetadata;
use zip::read::{Config, OwnedZipFileEntry, ZipReadOptions};
use zip::result::ZipError;
use zip::unstable::read::ZipIterable;

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
#[derive(Debug, Clone)]
pub struct ArchiveEntry {
    /// Its line in the table of contents.
    line: Arc<OwnedZipFileEntry>,
    /// Its name in the archive; with a number if another recording has this name.
    pub(crate) name: PathBuf,
}

impl PartialEq for ArchiveEntry {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Eq for ArchiveEntry {}

pub(crate) fn is_archive(path: &Path) -> bool {
    path.extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("zip"))
}

/// The files in an archive whose names are `wanted`, without hidden ones.
///
/// # Errors
/// If the file is not an archive, or holds more than can be read.
pub(crate) fn entries(path: &Path, wanted: impl Fn(&Path) -> bool) -> Result<Vec<ArchiveEntry>> {
    let mut archive = ZipIterable::try_new(open(path)?, Config::default())
        .map_err(|reason| unread(path, &reason))?;
    if archive.len() > MAX_FILES {
        return Err(refused(path, &TooMuch("more than 10,000 files")));
    }
    let mut entries = Vec::new();
    let mut names = HashMap::new();
    let mut bytes = 0_u64;
    let lines = archive.files().map_err(|reason| unread(path, &reason))?;
    for line in lines {
        let line = line.map_err(|reason| unread(path, &reason))?;
        let stored = line.name().map_err(|reason| unread(path, &reason))?;
        let whole = Path::new(&*stored);
        // Some programs begin every name with "./". A ".." has no effect, since no name is used as a path.
        let name = whole.strip_prefix(".").unwrap_or(whole).to_owned();
        let is_hidden = name.components().any(|part| {
            matches!(part, Component::Normal(part) if part.as_encoded_bytes().starts_with(b"."))
        });
        if !line.is_file() || is_hidden || !wanted(&name) {
            continue;
        }
        let size = line.get_metadata().uncompressed_size;
        if size > MAX_LEN {
            let problem = format!("\"{}\", which is larger than 256 MB", shown(&name));
            return Err(refused(path, &TooMuch(&problem)));
        }
        bytes = bytes.saturating_add(size);
        entries.push(ArchiveEntry {
            name: unique(&name, &mut names),
            line: Arc::new(line.into()),
        });
    }
    if bytes > MAX_TOTAL_LEN {
        return Err(refused(path, &TooMuch("more than 16 GB of recordings")));
    }
    Ok(entries)
}

/// The name, with a number before its extension if it is taken: programs that add a file again leave both in the archive.
/// `taken` has the last number that was tried for each name.
fn unique(name: &Path, taken: &mut HashMap<PathBuf, usize>) -> PathBuf {
    let stem = name.file_stem().unwrap_or_default().to_string_lossy();
    let extension = name.extension().unwrap_or_default().to_string_lossy();
    let mut last = taken.get(name).copied().unwrap_or(0);
    let mut free = name.to_owned();
    while taken.contains_key(&free) {
        last += 1;
        free = name.with_file_name(format!("{stem} ({last}).{extension}"));
    }
    taken.insert(name.to_owned(), last);
    taken.insert(free.clone(), 1);
    free
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
    let mut archive = open(path)?;
    let file = entry
        .line
        .as_ref()
        .as_ref()
        .with_reader(&mut archive, ZipReadOptions::new())
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

fn open(path: &Path) -> Result<BufReader<File>> {
    let file = crate::hash::open(path).map_err(Error::read(path))?;
    Ok(BufReader::new(file))
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

    /// The table of contents is that of the archive before.
    #[test]
    fn an_archive_that_was_changed_is_refused() {
        let one = |content: &str| archive(&[("a.csv".to_owned(), content.into())]);
        let (first, second) = (one("1"), one("2, and longer"));
        let entry = &entries(first.path(), |_| true).unwrap()[0];
        assert_eq!(read(first.path(), entry).unwrap(), b"1");
        std::fs::copy(second.path(), first.path()).unwrap();
        let refused = read(first.path(), entry).unwrap_err().to_string();
        assert!(refused.contains("it is damaged"), "{refused}");
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

    /// Archives to which a program adds a file again have it twice.
    #[test]
    fn two_files_of_one_name_are_both_read() {
        // The content of each is its name before.
        let packed = archive_with_a_name_twice(["a.wav", "b.wav"], ["a.wav", "b.wav"]);
        let found = entries(packed.path(), |_| true).unwrap();
        let read = |entry| String::from_utf8(read(packed.path(), entry).unwrap()).unwrap();
        let read: Vec<_> = found.iter().map(|it| (&*it.name, read(it))).collect();
        let expected = [("a.wav", "a.wav"), ("a (2).wav", "b.wav")];
        assert_eq!(
            read,
            expected.map(|(name, content)| (Path::new(name), content.to_owned()))
        );
    }

    /// An archive of lists can be one list, and these are two.
    #[test]
    fn two_lists_of_one_name_are_two_recordings() {
        let lists = ["0\n0.46\n0.89\n", "0\n0.56\n0.99\n"];
        let packed = archive_with_a_name_twice(["a.csv", "b.csv"], lists);
        let sources = crate::Sources {
            inputs: vec![packed.path().to_owned()],
            ..crate::Sources::default()
        };
        assert_eq!(
            crate::Session::gather(&sources).unwrap().recordings.len(),
            2
        );
    }

    /// An archive of two files, the second of which got the name of the first.
    fn archive_with_a_name_twice(names: [&str; 2], contents: [&str; 2]) -> tempfile::NamedTempFile {
        let files = [0, 1].map(|file| (names[file].to_owned(), contents[file].into()));
        let packed = archive(&files);
        let bytes = std::fs::read(packed.path()).unwrap();
        let renamed: Vec<u8> = bytes
            .utf8_chunks()
            .flat_map(|it| {
                let valid = it.valid().replace(names[1], names[0]);
                [valid.into_bytes(), it.invalid().to_vec()]
            })
            .flatten()
            .collect();
        assert_eq!(renamed.len(), bytes.len());
        std::fs::write(packed.path(), renamed).unwrap();
        packed
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
