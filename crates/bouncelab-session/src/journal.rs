//! A journal of results that survives a crash.
//!
//! Every result is one line: a checksum and a JSON object. A line that was cut off, or damaged, does
//! not fit its checksum and counts as never written; all others are as good as new. A result is
//! valid for one recording with one content under one set of settings, which its key names.

use std::collections::HashMap;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::sync::Mutex;

use bouncelab_report::file::{create_folder, sync_name};
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use crate::error::{Error, Result};
use crate::hash::{Hash, hash};

/// Name of the journal in the folder of the results.
pub const JOURNAL: &str = "journal.jsonl";

/// How every line goes on behind its checksum.
const NAMED: &str = " {\"name\":";

/// So many results are at most lost when the power fails.
const SYNC_EVERY: usize = 50;

/// A line is no longer than this, in bytes; the result of an hour of drops has some megabytes.
const LONGEST: u64 = 1 << 26;

/// So many characters of a checksum stand before each line.
const CHECK: usize = 16;

/// What a result is of: the content of a recording and the settings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Key {
    /// Hash of the content of the recording.
    pub content: Hash,
    /// Hash of everything else that the result depends on.
    pub settings: Hash,
}

/// The journal of a folder, open for writing by this run alone.
#[derive(Debug)]
pub struct Journal {
    path: PathBuf,
    /// The end of the file, to which one thread at a time appends.
    end: Mutex<End>,
    /// Lines that were found damaged when it was opened.
    damaged: usize,
}

#[derive(Debug)]
struct End {
    file: File,
    length: u64,
    /// Results that may not be on the disk yet.
    unsynced: usize,
    /// Where the newest line of each recording and key begins.
    index: HashMap<Id, u64>,
}

/// Tells results apart by name and key, in as little memory as keeps two from meeting by chance.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
struct Id([u8; 16]);

impl Id {
    fn of(name: &str, key: &Key) -> Self {
        Self::of_text(name, &key.content.to_string(), &key.settings.to_string())
    }

    fn of_text(name: &str, content: &str, settings: &str) -> Self {
        // No hash contains a line break, so no two differ only in where one part ends.
        Self(hash(format!("{content}\n{settings}\n{name}").as_bytes()).half())
    }
}

#[derive(Serialize)]
struct Line<'a, R> {
    name: &'a str,
    key: &'a Key,
    result: &'a R,
}

/// Who a line is of, without its result.
#[derive(Deserialize)]
struct Of {
    name: String,
    key: KeyOf,
}

#[derive(Deserialize)]
struct KeyOf {
    content: String,
    settings: String,
}

#[derive(Deserialize)]
struct Held<R> {
    result: R,
}

impl Journal {
    /// Opens the journal of a folder, which is made if needed, and reads what is in it.
    ///
    /// # Errors
    /// [`Error::Output`] if the folder cannot be written into, or what has the name of the journal is none,
    /// [`Error::Busy`] if another run has it open, [`Error::Read`] if the journal cannot be read.
    pub fn open(folder: &Path) -> Result<Self> {
        create_folder(folder).map_err(Error::output(folder))?;
        let path = folder.join(JOURNAL);
        // A device or a pipe may have no end.
        if fs::metadata(&path).is_ok_and(|about| !about.is_file()) {
            let reason = "it is a device, a pipe or a folder, and no journal of bouncelab";
            let reason = std::io::Error::new(std::io::ErrorKind::InvalidInput, reason);
            return Err(Error::output(&path)(reason));
        }
        let file = OpenOptions::new()
            .read(true)
            .append(true)
            .create(true)
            .open(&path)
            .map_err(Error::output(folder))?;
        // Some network drives know no locks; the run goes on without.
        if let Err(TryLockError::WouldBlock) = file.try_lock() {
            return Err(Error::Busy {
                path: folder.to_owned(),
            });
        }
        sync_name(&path).map_err(Error::output(folder))?;
        let scan = Scan::of(&file).map_err(Error::read(&path))?;
        if scan.is_foreign {
            let reason = "it exists, and is no journal of bouncelab";
            let reason = std::io::Error::new(std::io::ErrorKind::AlreadyExists, reason);
            return Err(Error::output(&path)(reason));
        }
        // What was cut off at the end is cut away, so that the next line begins a line.
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

    /// How many lines were damaged, and do not count.
    pub fn damaged(&self) -> usize {
        self.damaged
    }

    /// Whether there is a result of this recording for this key.
    pub fn has(&self, name: &str, key: &Key) -> bool {
        self.lock().index.contains_key(&Id::of(name, key))
    }

    /// Appends a result. It is in the file when this returns, and on the disk after 50 others or
    /// [`Journal::sync`].
    ///
    /// # Errors
    /// [`Error::Output`] if it cannot be written; what was written in part is taken back.
    pub fn append<R: Serialize>(&self, name: &str, key: &Key, result: &R) -> Result<()> {
        let text =
            serde_json::to_string(&Line { name, key, result }).map_err(|fault| Error::Table {
                path: self.path.clone(),
                problem: fault.to_string(),
            })?;
        let line = format!("{} {text}\n", check(&text));
        let mut end = self.lock();
        let written = end.file.write_all(line.as_bytes());
        if let Err(fault) = written {
            // Whether this works does not matter: the next run cuts it away too.
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

    /// Makes sure that all is on the disk.
    ///
    /// # Errors
    /// [`Error::Output`] if the system says that it is not.
    pub fn sync(&self) -> Result<()> {
        self.synced(&mut self.lock())
    }

    fn synced(&self, end: &mut End) -> Result<()> {
        end.unsynced = 0;
        end.file.sync_data().map_err(Error::output(&self.path))
    }

    /// Reads the result of a recording back; `None` if there is none for this key.
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
            file.take(LONGEST).read_until(b'\n', &mut line)?;
            let text = checked(&line).ok_or(std::io::ErrorKind::InvalidData)?;
            Ok(serde_json::from_str::<Held<R>>(text)?.result)
        };
        read().map(Some).map_err(Error::read(&self.path))
    }

    fn lock(&self) -> std::sync::MutexGuard<'_, End> {
        // A thread that panicked in here had not begun to change anything.
        self.end
            .lock()
            .unwrap_or_else(std::sync::PoisonError::into_inner)
    }
}

/// What a journal holds.
#[derive(Default)]
struct Scan {
    index: HashMap<Id, u64>,
    damaged: usize,
    /// Whether it has content, but no line that fits its checksum, nor begins as one.
    is_foreign: bool,
    length: u64,
    /// Where the last line that ends with a line break ends.
    whole: u64,
}

impl Scan {
    fn of(file: &File) -> std::io::Result<Self> {
        let mut reader = BufReader::new(file);
        reader.seek(SeekFrom::Start(0))?;
        let mut scan = Self::default();
        let mut line = Vec::new();
        loop {
            line.clear();
            let mut bounded = reader.by_ref().take(LONGEST);
            let read = bounded.read_until(b'\n', &mut line)? as u64;
            if read == 0 {
                return Ok(scan);
            }
            if scan.length == 0 {
                scan.is_foreign = !begins_line(&line);
            }
            let of = checked(&line).and_then(|text| serde_json::from_str::<Of>(text).ok());
            scan.is_foreign &= of.is_none();
            match of {
                Some(Of { name, key }) => {
                    let id = Id::of_text(&name, &key.content, &key.settings);
                    scan.index.insert(id, scan.length);
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

/// The text of a whole line that fits its checksum.
fn checked(line: &[u8]) -> Option<&str> {
    let line = std::str::from_utf8(line.strip_suffix(b"\n")?).ok()?;
    let (found, text) = line.split_once(' ')?;
    (found == check(text)).then_some(text)
}

/// Whether this is a line of a journal, or the beginning of one, as far as its first letters say.
fn begins_line(line: &[u8]) -> bool {
    let (check, named) = line.split_at(CHECK.min(line.len()));
    let is_digit = |letter: &u8| matches!(letter, b'0'..=b'9' | b'a'..=b'f');
    let mut letters = std::iter::zip(named, NAMED.as_bytes());
    check.iter().all(is_digit) && letters.all(|(letter, expected)| letter == expected)
}

fn check(text: &str) -> String {
    let mut hash = hash(text.as_bytes()).to_string();
    hash.truncate(CHECK);
    hash
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
        assert_eq!(journal.damaged(), 0);
    }

    /// A pipe would be waited for, and a device read without end.
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

    /// Wherever the file is cut, whole lines before the cut are kept and the next run goes on.
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

    /// Of what was written since the disk was last waited for, each page may be there or empty, and the file may end
    /// anywhere: what was waited for is there, what is there is whole, and the next run goes on.
    #[test]
    fn a_loss_of_power_takes_only_what_was_not_waited_for() {
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
            // It is as long as what is there of it.
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

    /// Of a foreign file nothing is cut away, and nothing is added.
    #[test]
    fn what_is_no_journal_stays_as_it_is() {
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
