//! The rows that an engine wrote as Parquet, as the results of a session.
//!
//! They are read in the order of the files, a few at a time. Only the columns that identify a row, and the notes, are
//! kept in memory.

use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use bouncelab::Plain;

use super::row::KnownMetadata;
use super::texts::{Column, read};
use crate::error::{Error, Result};
use crate::hash::Hash;
use crate::journal::Key;
use crate::metadata::{KnownRecording, Metadata};
use crate::record::Record;
use crate::recordings::RecordingFile;
use crate::results::{Results, Store};
use crate::work::Done;

/// Columns of texts that identify the recording of a row.
const WHICH: [Column; 6] = [
    Column::short("recording"),
    Column::short("kernel_sha256"),
    Column::short("content_sha256"),
    Column::short("settings_sha256"),
    Column::short("failure.message"),
    Column::short("metadata"),
];

/// Columns of texts with its result.
const RESULT: [Column; 3] = [
    Column::short("settings_sha256"),
    Column::short("failure.message"),
    Column::long("record"),
];

/// The rows of a folder of Parquet files.
#[derive(Debug)]
pub struct Batch {
    files: Vec<PathBuf>,
    /// The index of the recording of each row, in the order of the rows; `None` if the row is a copy of an earlier one.
    indices: Vec<Option<usize>>,
    recordings: Vec<KnownRecording>,
    done: Vec<Done>,
}

/// What identifies the recordings of the rows that were read.
#[derive(Default)]
struct Rows {
    /// The kernel of all of them.
    kernel: Option<String>,
    notes: KnownMetadata,
    /// The number of each recording in `found`, by its name.
    known: HashMap<String, usize>,
    found: Vec<Found>,
    /// The number of the recording of each row; `None` if the row is a copy of an earlier one.
    numbers: Vec<Option<usize>>,
    /// Memory in bytes that all this takes, about.
    memory: usize,
}

/// A recording, but for its name.
struct Found {
    metadata: Arc<Metadata>,
    settings: Option<Hash>,
    content: std::result::Result<Hash, String>,
}

impl Batch {
    /// The files with the rows.
    pub fn files(&self) -> &[PathBuf] {
        &self.files
    }

    /// Reads the recordings of the rows of a file or folder of Parquet. A row that occurs twice counts once;
    /// files and folders whose names begin with a dot or an underscore are left out.
    ///
    /// # Errors
    /// [`Error::Read`] and [`Error::Rows`] if it cannot be read, is not a result of bouncelab, or has results
    /// of two kernels, or of the same recording with different notes or contents.
    pub fn open(path: &Path) -> Result<Self> {
        let mut files = Vec::new();
        find(path, &mut files)?;
        if files.is_empty() {
            return Err(Error::rows(path, "there is no Parquet file in it"));
        }
        let mut rows = Rows::default();
        for file in &files {
            read(file, &WHICH, |cells| {
                let added = rows.add(cells);
                added.map_err(|problem| Error::rows(file, problem))
            })?;
        }
        Ok(rows.batch(files))
    }

    /// The rows as the results of a session.
    pub fn results(&self) -> Results<'_> {
        Results {
            recordings: &self.recordings,
            done: &self.done,
            store: Store::Batch(self),
        }
    }

    /// Calls `take` with the results of the wanted recordings, in the order of the rows.
    pub(crate) fn each(
        &self,
        is_wanted: impl Fn(usize) -> bool,
        mut take: impl FnMut(usize, &Key, Record) -> Result<()>,
    ) -> Result<()> {
        let mut indices = self.indices.iter();
        for file in &self.files {
            read(file, &RESULT, |[settings, failure, record]| {
                let index = indices.next().copied().flatten();
                let Some(index) = index.filter(|&index| is_wanted(index)) else {
                    return Ok(());
                };
                let wrong = |problem: String| Error::rows(file, problem);
                let content = self.done[index].content.clone().map_err(wrong)?;
                let digits = settings.unwrap_or_default();
                let settings = digits
                    .parse()
                    .map_err(|problem: &str| wrong(problem.to_owned()))?;
                let record = match (record, failure) {
                    (Some(record), _) => serde_json::from_str(record).map_err(|fault| {
                        wrong(format!("the record is not one of this version: {fault}"))
                    })?,
                    (None, failure) => {
                        Record::failed(Plain::of(failure.unwrap_or_default()).into())
                    }
                };
                take(index, &Key { content, settings }, record)
            })?;
        }
        Ok(())
    }
}

impl Rows {
    /// Adds a row.
    fn add(
        &mut self,
        [name, kernel, content, settings, failure, known]: [Option<&str>; 6],
    ) -> std::result::Result<(), String> {
        /// Maximum number of rows, and of bytes of memory: that of 250,000 recordings.
        const MAX_ROWS: usize = 2_000_000;
        const MAX_MEMORY: usize = 64 << 20;
        /// Bytes for each recording besides its texts, and those for each byte of new notes.
        const EACH: usize = 200;
        const NOTES: usize = 8;
        if self.numbers.is_empty() {
            self.kernel = kernel.map(str::to_owned);
        }
        if self.kernel.as_deref() != kernel {
            return Err(
                "has results of other settings, or of another version, than those before it; every kernel needs an \
                 output of its own"
                    .to_owned(),
            );
        }
        let name = String::from(Plain::of(name.ok_or("a row names no recording")?));
        let content = match content {
            Some(digits) => Ok(digits.parse()?),
            None => Err(String::from(Plain::of(failure.unwrap_or_default()))),
        };
        let settings = settings.map(str::parse).transpose()?;
        let before = self.notes.len();
        let known = known.unwrap_or_default();
        let metadata = self.notes.of(known)?;
        if let Some(found) = self.known.get(&name).map(|&number| &self.found[number]) {
            let is_same = (&found.settings, &found.content) == (&settings, &content)
                && Arc::ptr_eq(&found.metadata, &metadata);
            if !is_same {
                return Err(format!(
                    "has two results of {name}, of different contents or notes; recordings must not change, nor their \
                     notes"
                ));
            }
            self.numbers.push(None);
        } else {
            let is_new = self.notes.len() > before;
            self.memory += 2 * name.len() + content.as_ref().err().map_or(0, String::len) + EACH;
            self.memory += if is_new { NOTES * known.len() } else { 0 };
            self.numbers.push(Some(self.found.len()));
            self.known.insert(name, self.found.len());
            self.found.push(Found {
                metadata,
                settings,
                content,
            });
        }
        if self.memory > MAX_MEMORY || self.numbers.len() > MAX_ROWS {
            return Err(format!(
                "has more than {MAX_ROWS} rows, or names and notes of more than 250,000 recordings; study parts of them"
            ));
        }
        Ok(())
    }

    /// The rows, with the recordings in the order of their names.
    fn batch(self, files: Vec<PathBuf>) -> Batch {
        let mut names: Vec<(String, usize)> = self.known.into_iter().collect();
        names.sort_unstable();
        let mut ranks = vec![0; names.len()];
        let mut found: Vec<Option<Found>> = self.found.into_iter().map(Some).collect();
        let (mut recordings, mut done) = (Vec::new(), Vec::new());
        for (name, number) in names {
            let Some(found) = found[number].take() else {
                continue;
            };
            ranks[number] = recordings.len();
            recordings.push(KnownRecording {
                recording: RecordingFile {
                    entry: None,
                    path: PathBuf::from(&name),
                    name,
                },
                metadata: found.metadata,
            });
            done.push(Done {
                content: found.content,
                kept: true,
                without_drop: false,
            });
        }
        let rank = |number: Option<usize>| number.map(|number| ranks[number]);
        Batch {
            indices: self.numbers.into_iter().map(rank).collect(),
            files,
            recordings,
            done,
        }
    }
}

/// All Parquet files in a folder and the folders in it, in the order of their names. Folders that are links are left
/// out: they may form a circle.
fn find(path: &Path, files: &mut Vec<PathBuf>) -> Result<()> {
    if path.is_file() {
        files.push(path.to_owned());
        return Ok(());
    }
    let mut entries = fs::read_dir(path)
        .and_then(Iterator::collect::<std::io::Result<Vec<_>>>)
        .map_err(Error::read(path))?;
    entries.retain(|entry| {
        let name = entry.file_name();
        !name.as_encoded_bytes().starts_with(b".") && !name.as_encoded_bytes().starts_with(b"_")
    });
    entries.sort_by_key(fs::DirEntry::file_name);
    for entry in entries {
        let path = entry.path();
        let kind = entry.file_type().map_err(Error::read(&path))?;
        let is_table = path.extension().is_some_and(|ending| ending == "parquet");
        if kind.is_dir() || (is_table && path.is_file()) {
            find(&path, files)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(unix)]
    #[test]
    fn folders_that_are_links_are_left_out() {
        use std::os::unix::fs::symlink;

        let folder = tempfile::tempdir().unwrap();
        let file = folder.path().join("0.parquet");
        fs::write(&file, "").unwrap();
        symlink(".", folder.path().join("round")).unwrap();
        symlink("0.parquet", folder.path().join("1.parquet")).unwrap();
        let mut files = Vec::new();
        find(folder.path(), &mut files).unwrap();
        assert_eq!(files, [file, folder.path().join("1.parquet")]);
    }
}
