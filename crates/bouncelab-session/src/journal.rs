//! A journal of results that survives a crash: [lines](bouncelab_report::journal) in a file.

use std::collections::HashMap;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use bouncelab_report::file::{create_folder, sync_name};
use bouncelab_report::journal::{self, Of, begins_line, checked};
pub use bouncelab_report::journal::{JOURNAL, Key};
use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::error::{Error, Result};
use crate::hash::{Hash, hash};

/// Number of results after which the file is synced to the disk: a loss of power loses at most this number.
const SYNC_EVERY: usize = 50;

/// Maximum length of a line in bytes; the result of an hour of drops has some megabytes.
const MAX_LINE_LEN: u64 = 1 << 26;

/// The journal of a folder, open for writing by this run alone.
#[derive(Debug)]
pub struct Journal {
    path: PathBuf,
    /// The end of the file, to which one thread at a time appends.
    end: Mutex<End>,
    /// Number of damaged lines when it was opened.
    damaged: usize,
}

#[derive(Debug)]
struct End {
    file: File,
    length: u64,
    /// Results that may not be on the disk yet.
    unsynced: usize,
    /// Position of the latest line of each recording and key.
    index: HashMap<Id, u64>,
}

/// Identifies a result by name and key, in as few bytes as exclude that two are equal by chance.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
struct Id([u8; 16]);

impl Id {
    fn of(name: &str, key: &Key) -> Self {
        // Hashes contain no line break, so that different parts always give different texts.
        let text = format!("{}\n{}\n{name}", key.content, key.settings);
        Self(hash(text.as_bytes()).half())
    }
}

impl Journal {
    /// Opens the journal of a folder, which is created if needed, and reads its index.
    ///
    /// # Errors
    /// [`Error::Output`] if the folder cannot be written into, or the file with the name of the journal is another one,
    /// [`Error::Busy`] if another run has it open, [`Error::Read`] if the journal cannot be read.
    pub fn open(folder: &Path) -> Result<Self> {
        Self::locked(folder, |file| match file.try_lock() {
            Err(TryLockError::WouldBlock) => Err(Error::Busy {
                path: folder.to_owned(),
            }),
            // Some network drives have no locks; the run continues without one.
            _ => Ok(()),
        })
    }

    /// The same for a moment: waits until no other run has it open.
    ///
    /// # Errors
    /// As [`Journal::open`], without [`Error::Busy`].
    pub fn open_in_turn(folder: &Path) -> Result<Self> {
        Self::locked(folder, |file| {
            // As above.
            let _ = file.lock();
            Ok(())
        })
    }

    fn locked(folder: &Path, lock: impl FnOnce(&File) -> Result<()>) -> Result<Self> {
        create_folder(folder).map_err(Error::output(folder))?;
        let path = folder.join(JOURNAL);
        // A device or a pipe may have no end.
        if fs::metadata(&path).is_ok_and(|about| !about.is_file()) {
            let problem = "it is a device, a pipe or a folder, and no journal of bouncelab";
            let reason = std::io::Error::new(std::io::ErrorKind::InvalidInput, problem);
            return Err(Error::output(&path)(reason));
        }
        let file = OpenOptions::new()
            .read(true)
            .append(true)
            .create(true)
            .open(&path)
            .map_err(Error::output(folder))?;
        lock(&file)?;
        sync_name(&path).map_err(Error::output(folder))?;
        let scan = Scan::of(&file).map_err(Error::read(&path))?;
        if scan.is_foreign {
            let problem = "it exists, and is no journal of bouncelab";
            let reason = std::io::Error::new(std::io::ErrorKind::AlreadyExists, problem);
            return Err(Error::output(&path)(reason));
        }
        // An incomplete line at the end is removed, so that the next result begins a new line.
        if scan.whole < scan.length {
            file.set_len(scan.whole).map_err(Error::output(folder))?;
        }
        Ok(Self {
            path,
            damaged: scan.damaged,
            end: Mutex::new(End {
                file,
                length: scan.whole,
                unsynced: 0,
                index: scan.index,
            }),
        })
    }

    /// Number of damaged lines, which do not count.
    pub fn damaged(&self) -> usize {
        self.damaged
    }

    /// Whether it has a result of this recording for this key.
    pub fn has(&self, name: &str, key: &Key) -> bool {
        self.lock().index.contains_key(&Id::of(name, key))
    }

    /// Appends a result. It is in the file when this returns, and on the disk after 50 others or
    /// [`Journal::sync`].
    ///
    /// # Errors
    /// [`Error::Output`] if it cannot be written; a part that was written is removed.
    pub fn append<R: Serialize>(&self, name: &str, key: &Key, result: &R) -> Result<()> {
        let line = journal::line(name, key, result).map_err(|fault| Error::Table {
            path: self.path.clone(),
            problem: fault.to_string(),
        })?;
        let mut end = self.lock();
        let written = end.file.write_all(line.as_bytes());
        if let Err(fault) = written {
            // If this fails, the next run removes the incomplete line.
            let _ = end.file.set_len(end.length);
            return Err(Error::output(&self.path)(fault));
        }
        let start = end.length;
        end.length += line.len() as u64;
        end.index.insert(Id::of(name, key), start);
        end.unsynced += 1;
        if end.unsynced < SYNC_EVERY {
            return Ok(());
        }
        self.synced(&mut end)
    }

    /// Waits until all results are on the disk.
    ///
    /// # Errors
    /// [`Error::Output`] if the system reports an error.
    pub fn sync(&self) -> Result<()> {
        self.synced(&mut self.lock())
    }

    fn synced(&self, end: &mut End) -> Result<()> {
        end.unsynced = 0;
        end.file.sync_data().map_err(Error::output(&self.path))
    }

    /// Reads the result of a recording; `None` if the journal has none for this key.
    ///
    /// # Errors
    /// [`Error::Read`] if the journal cannot be read, or its content has changed since it was opened.
    pub fn read<R: DeserializeOwned>(&self, name: &str, key: &Key) -> Result<Option<R>> {
        let Some(start) = self.lock().index.get(&Id::of(name, key)).copied() else {
            return Ok(None);
        };
        let read = || -> std::io::Result<R> {
            let mut file = BufReader::new(File::open(&self.path)?);
            file.seek(SeekFrom::Start(start))?;
            let mut line = Vec::new();
            file.take(MAX_LINE_LEN).read_until(b'\n', &mut line)?;
            let text = checked(&line).ok_or(std::io::ErrorKind::InvalidData)?;
            Ok(journal::result(text)?)
        };
        read().map(Some).map_err(Error::read(&self.path))
    }

    /// All results under these settings, in the order in which they were written.
    ///
    /// # Errors
    /// As [`Journal::read`].
    pub fn all<R: DeserializeOwned>(&self, settings: &Hash) -> Result<Vec<R>> {
        let read = || -> std::io::Result<Vec<R>> {
            let mut reader = BufReader::new(File::open(&self.path)?);
            let (mut results, mut line) = (Vec::new(), Vec::new());
            while next_line(&mut reader, &mut line)? > 0 {
                if let Some(text) = checked(&line)
                    && journal::of(text)?.key.settings == *settings
                {
                    results.push(journal::result(text)?);
                }
            }
            Ok(results)
        };
        read().map_err(Error::read(&self.path))
    }

    fn lock(&self) -> std::sync::MutexGuard<'_, End> {
        // No code changes the index and panics after that, so it is valid after a panic.
        self.end
            .lock()
            .unwrap_or_else(std::sync::PoisonError::into_inner)
    }
}

/// The content of a journal.
#[derive(Default)]
struct Scan {
    index: HashMap<Id, u64>,
    damaged: usize,
    /// Whether it has content, but neither a line that matches its checksum nor one that begins as a line does.
    is_foreign: bool,
    length: u64,
    /// Position behind the last line that ends with a line break.
    whole: u64,
}

impl Scan {
    fn of(file: &File) -> std::io::Result<Self> {
        let mut reader = BufReader::new(file);
        reader.seek(SeekFrom::Start(0))?;
        let mut scan = Self::default();
        let mut line = Vec::new();
        loop {
            let read = next_line(&mut reader, &mut line)?;
            if read == 0 {
                return Ok(scan);
            }
            if scan.length == 0 {
                scan.is_foreign = !begins_line(&line);
            }
            let of = checked(&line).and_then(|text| journal::of(text).ok());
            scan.is_foreign &= of.is_none();
            match of {
                Some(Of { name, key }) => {
                    scan.index.insert(Id::of(&name, &key), scan.length);
                }
                None => scan.damaged += 1,
            }
            scan.length += read;
            if line.ends_with(b"\n") {
                scan.whole = scan.length;
            }
        }
    }
}

/// Reads the next line, and returns its length, 0 at the end.
fn next_line(reader: &mut impl BufRead, line: &mut Vec<u8>) -> std::io::Result<u64> {
    line.clear();
    let read = reader.take(MAX_LINE_LEN).read_until(b'\n', line)?;
    Ok(read as u64)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn key(content: &str) -> Key {
        Key {
            content: hash(content.as_bytes()),
            settings: hash(b"s"),
        }
    }

    #[test]
    fn results_come_back_after_closing() {
        let folder = tempfile::tempdir().unwrap();
        let journal = Journal::open(folder.path()).unwrap();
        journal
            .append("a.wav", &key("1"), &vec![0.1, f64::MIN_POSITIVE])
            .unwrap();
        journal.append("b.wav", &key("2"), &vec![2.0]).unwrap();
        journal.append("a.wav", &key("3"), &vec![3.0]).unwrap();
        journal.sync().unwrap();
        drop(journal);
        let journal = Journal::open(folder.path()).unwrap();
        let read = |name: &str, content: &str| -> Option<Vec<f64>> {
            journal.read(name, &key(content)).unwrap()
        };
        assert_eq!(read("a.wav", "3"), Some(vec![3.0]));
        assert_eq!(read("a.wav", "1"), Some(vec![0.1, f64::MIN_POSITIVE]));
        assert_eq!(read("a.wav", "2"), None, "another content");
        assert_eq!(read("b.wav", "2"), Some(vec![2.0]));
        assert!(journal.has("b.wav", &key("2")) && !journal.has("c.wav", &key("2")));
        let all: Vec<Vec<f64>> = journal.all(&hash(b"s")).unwrap();
        assert_eq!(all.concat(), [0.1, f64::MIN_POSITIVE, 2.0, 3.0]);
        assert!(journal.all::<f64>(&hash(b"t")).unwrap().is_empty());
        assert_eq!(journal.damaged(), 0);
    }

    /// Opening a pipe would wait for its writer, and reading a device would not end.
    #[cfg(unix)]
    #[test]
    fn a_journal_is_a_file() {
        for place in ["/dev/zero", "/dev/null", "/tmp"] {
            let folder = tempfile::tempdir().unwrap();
            std::os::unix::fs::symlink(place, folder.path().join(JOURNAL)).unwrap();
            let refused = Journal::open(folder.path()).unwrap_err().to_string();
            assert!(refused.contains("no journal"), "{place}: {refused}");
        }
    }

    /// Wherever the file is cut, whole lines before the cut are kept and the next run continues.
    #[test]
    fn a_journal_cut_anywhere_keeps_its_whole_lines() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(JOURNAL);
        let journal = Journal::open(folder.path()).unwrap();
        for number in 0..3 {
            let name = number.to_string();
            journal.append(&name, &key("1"), &number).unwrap();
        }
        drop(journal);
        let whole = fs::read(&path).unwrap();
        let ends: Vec<usize> = (0..whole.len()).filter(|&at| whole[at] == b'\n').collect();
        for cut in 0..=whole.len() {
            fs::write(&path, &whole[..cut]).unwrap();
            let journal = Journal::open(folder.path()).unwrap();
            let kept = ends.iter().filter(|&&end| end < cut).count();
            for number in 0..3 {
                let found = journal
                    .read::<usize>(&number.to_string(), &key("1"))
                    .unwrap();
                assert_eq!(found, (number < kept).then_some(number), "cut at {cut}");
            }
            journal.append("next", &key("1"), &7).unwrap();
            drop(journal);
            let journal = Journal::open(folder.path()).unwrap();
            assert_eq!(
                journal.read("next", &key("1")).unwrap(),
                Some(7),
                "cut at {cut}"
            );
        }
    }

    /// Each page that was written since the last sync may be on the disk or empty, and the file may end anywhere: synced
    /// results are kept, a result that is read is whole, and the next run continues.
    #[test]
    fn a_loss_of_power_takes_only_results_that_were_not_synced() {
        const PAGE: usize = 100;
        const RESULTS: usize = 6;
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(JOURNAL);
        let journal = Journal::open(folder.path()).unwrap();
        let mut synced = 0;
        for number in 0..RESULTS {
            let name = number.to_string();
            journal.append(&name, &key("1"), &number).unwrap();
            if number == 2 {
                journal.sync().unwrap();
                synced = fs::metadata(&path).unwrap().len() as usize;
            }
        }
        drop(journal);
        let whole = fs::read(&path).unwrap();
        let pages = (whole.len() - synced).div_ceil(PAGE);
        for kept in 0..1_u32 << pages {
            let mut left = whole.clone();
            for (number, page) in left[synced..].chunks_mut(PAGE).enumerate() {
                if kept >> number & 1 == 0 {
                    page.fill(0);
                }
            }
            // It ends with the last page that is on the disk.
            let end = (32 - kept.leading_zeros()) as usize * PAGE;
            left.truncate(synced + end);
            fs::write(&path, &left).unwrap();
            let journal = Journal::open(folder.path()).unwrap();
            journal.append("next", &key("1"), &7).unwrap();
            for number in 0..RESULTS {
                let found = journal.read(&number.to_string(), &key("1")).unwrap();
                assert!(found.is_none_or(|it: usize| it == number), "{kept:b}");
                assert!(found.is_some() || number > 2, "{kept:b}: {number}");
            }
            assert_eq!(journal.read("next", &key("1")).unwrap(), Some(7));
        }
    }

    #[test]
    fn a_damaged_line_counts_as_never_written() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(JOURNAL);
        let journal = Journal::open(folder.path()).unwrap();
        journal.append("a.wav", &key("1"), &1).unwrap();
        journal.append("b.wav", &key("1"), &2).unwrap();
        drop(journal);
        let text = fs::read_to_string(&path).unwrap();
        fs::write(&path, text.replacen("a.wav", "A.wav", 1)).unwrap();
        let journal = Journal::open(folder.path()).unwrap();
        assert_eq!(journal.damaged(), 1);
        assert!(!journal.has("A.wav", &key("1")) && journal.has("b.wav", &key("1")));
    }

    #[test]
    fn a_foreign_file_is_not_changed() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(JOURNAL);
        for foreign in [
            "{\"day\":1}\n{\"entry\": {\"name\":\"Ada\"},",
            "mine {\"name\":\"a\"}\nand more",
            "0123456789abcde\n",
            "\n",
        ] {
            fs::write(&path, foreign).unwrap();
            let refused = Journal::open(folder.path()).unwrap_err();
            assert!(refused.to_string().contains("no journal of bouncelab"));
            assert_eq!(fs::read_to_string(&path).unwrap(), foreign);
        }
    }

    #[test]
    fn two_runs_do_not_write_into_one_journal() {
        let folder = tempfile::tempdir().unwrap();
        let _first = Journal::open(folder.path()).unwrap();
        assert!(matches!(
            Journal::open(folder.path()),
            Err(Error::Busy { .. })
        ));
    }
}
