//! The rows that an engine wrote as Parquet, as the results of a session.
//!
//! They are read in the order of the files, a few at a time. Only the columns that identify a row, and the notes, are
//! kept in memory.

use std::fs;
use std::path::{Path, PathBuf};

use bouncelab::Plain;

use super::row::KnownMetadata;
use super::texts::read;
use crate::error::{Error, Result};
use crate::hash::Hash;
use crate::journal::Key;
use crate::metadata::KnownRecording;
use crate::record::Record;
use crate::recordings::RecordingFile;
use crate::results::{Results, Store};
use crate::work::Done;

/// Columns of texts that identify the recording of a row.
const WHICH: [&str; 6] = [
    "recording",
    "kernel_sha256",
    "content_sha256",
    "settings_sha256",
    "failure.message",
    "metadata",
];

/// Columns of texts with its result.
const RESULT: [&str; 3] = ["settings_sha256", "failure.message", "record"];

/// The rows of a folder of Parquet files.
#[derive(Debug)]
pub struct Batch {
    files: Vec<PathBuf>,
    /// The index of the recording of each row, in the order of the rows; `None` if the row is a copy of an earlier one.
    indices: Vec<Option<usize>>,
    recordings: Vec<KnownRecording>,
    done: Vec<Done>,
}

/// The recording of a row.
struct Which {
    recording: KnownRecording,
    kernel: Option<String>,
    settings: Option<String>,
    content: std::result::Result<Hash, String>,
    row: usize,
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
        let mut rows: Vec<Which> = Vec::new();
        let mut metadata = KnownMetadata::default();
        for file in &files {
            let wrong = |problem: String| Error::rows(file, problem);
            read(file, WHICH, |cells| {
                let which = Which::of(cells, rows.len(), &mut metadata);
                rows.push(which.map_err(wrong)?);
                if rows.last().map(|it| &it.kernel) == rows.first().map(|it| &it.kernel) {
                    return Ok(());
                }
                let problem = "has results of other settings, or of another version, than those before it; \
                               every kernel needs an output of its own";
                Err(wrong(problem.to_owned()))
            })?;
        }
        let mut batch = Self {
            files,
            indices: vec![None; rows.len()],
            recordings: Vec::new(),
            done: Vec::new(),
        };
        rows.sort_by(|a, b| {
            let name = a.recording.name().cmp(b.recording.name());
            name.then(a.row.cmp(&b.row))
        });
        let mut last: Option<(Option<String>, std::result::Result<Hash, String>)> = None;
        for row in rows {
            let is_known =
                batch.recordings.last().map(KnownRecording::name) == Some(row.recording.name());
            let key = (row.settings, row.content);
            if !is_known {
                batch.indices[row.row] = Some(batch.recordings.len());
                batch.recordings.push(row.recording);
                batch.done.push(Done {
                    content: key.1.clone(),
                    kept: true,
                    without_drop: false,
                });
                last = Some(key);
            } else if last.as_ref() != Some(&key) {
                let name = row.recording.name();
                let problem = format!(
                    "has two results of {name}, of different contents or notes; recordings must not change, \
                     nor their notes"
                );
                return Err(Error::rows(path, problem));
            }
        }
        Ok(batch)
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
            read(file, RESULT, |[settings, failure, record]| {
                let index = indices.next().copied().flatten();
                let Some(index) = index.filter(|&index| is_wanted(index)) else {
                    return Ok(());
                };
                let wrong = |problem: String| Error::rows(file, problem);
                let content = self.done[index].content.clone().map_err(wrong)?;
                let digits = settings.as_deref().unwrap_or_default();
                let settings = digits
                    .parse()
                    .map_err(|problem: &str| wrong(problem.to_owned()))?;
                let record = match (record, failure) {
                    (Some(record), _) => serde_json::from_str(&record).map_err(|fault| {
                        wrong(format!("the record is not one of this version: {fault}"))
                    })?,
                    (None, failure) => {
                        Record::failed(Plain::of(&failure.unwrap_or_default()).into())
                    }
                };
                take(index, &Key { content, settings }, record)
            })?;
        }
        Ok(())
    }
}

impl Which {
    fn of(
        [name, kernel, content, settings, failure, known]: [Option<String>; 6],
        row: usize,
        metadata: &mut KnownMetadata,
    ) -> std::result::Result<Self, String> {
        let name = name.ok_or("a row names no recording")?;
        let name = String::from(Plain::of(&name));
        let content = match content {
            Some(digits) => Ok(digits.parse()?),
            None => Err(Plain::of(&failure.unwrap_or_default()).into()),
        };
        Ok(Self {
            recording: KnownRecording {
                recording: RecordingFile {
                    entry: None,
                    path: PathBuf::from(&name),
                    name,
                },
                metadata: metadata.of(known.as_deref().unwrap_or_default())?,
            },
            kernel,
            settings,
            content,
            row,
        })
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
