//! The rows that an engine wrote as Parquet, as the results of a session.
//!
//! They are read in the order in which they lie there, a few at a time. In memory is only what tells them
//! apart, and what was noted.

use std::fs::{self, File};
use std::io::{self, BufReader, Read};
use std::path::{Path, PathBuf};

use bouncelab::Plain;
use bytes::Bytes;
use parquet::basic::{Encoding, Type};
use parquet::column::page::{Page, PageMetadata, PageReader};
use parquet::column::reader::ColumnReaderImpl;
use parquet::data_type::{ByteArray, ByteArrayType};
use parquet::errors::{ParquetError, Result as Parquet};
use parquet::file::reader::{ChunkReader, FileReader, Length, RowGroupReader};
use parquet::file::serialized_reader::SerializedFileReader;

use super::row::KnownMetadata;
use crate::error::{Error, Result};
use crate::hash::Hash;
use crate::journal::Key;
use crate::metadata::KnownRecording;
use crate::record::Record;
use crate::recordings::Recording;
use crate::results::{Results, Store};
use crate::work::Done;

/// So many rows of a file are in memory at once.
const ROWS: usize = 64;

/// Columns of texts that say which recording a row is of.
const WHICH: [&str; 5] = [
    "recording",
    "content_sha256",
    "settings_sha256",
    "failure.message",
    "metadata",
];

/// Columns of texts that hold its result.
const RESULT: [&str; 3] = ["settings_sha256", "failure.message", "record"];

/// The rows of a folder of Parquet files.
#[derive(Debug)]
pub struct Batch {
    files: Vec<PathBuf>,
    /// The place of the recording of each row, in the order of the rows; none if the same row came before.
    places: Vec<Option<usize>>,
    recordings: Vec<KnownRecording>,
    done: Vec<Done>,
}

/// Of which recording a row is.
struct Which {
    recording: KnownRecording,
    settings: Option<String>,
    content: std::result::Result<Hash, String>,
    row: usize,
}

impl Batch {
    /// The files that have the rows.
    pub fn files(&self) -> &[PathBuf] {
        &self.files
    }

    /// Reads which recordings a file or folder of Parquet has rows of. A row that is there twice counts once;
    /// files and folders whose names begin with a dot or an underscore are left out.
    ///
    /// # Errors
    /// [`Error::Read`] and [`Error::Rows`] if it cannot be read, is no result of bouncelab, or has results
    /// of the same recording with different settings or contents.
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
                Ok(())
            })?;
        }
        let mut batch = Self {
            files,
            places: vec![None; rows.len()],
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
                batch.places[row.row] = Some(batch.recordings.len());
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
                    "has two results of {name}, of different contents or settings; every kernel needs an \
                     output of its own"
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

    /// Hands on the results of some recordings, in the order of the rows.
    pub(crate) fn each(
        &self,
        is_wanted: impl Fn(usize) -> bool,
        mut take: impl FnMut(usize, &Key, Record) -> Result<()>,
    ) -> Result<()> {
        let mut places = self.places.iter();
        for file in &self.files {
            read(file, RESULT, |[settings, failure, record]| {
                let place = places.next().copied().flatten();
                let Some(place) = place.filter(|&place| is_wanted(place)) else {
                    return Ok(());
                };
                let wrong = |problem: String| Error::rows(file, problem);
                let content = self.done[place].content.clone().map_err(wrong)?;
                let settings = settings.as_deref().unwrap_or_default().parse();
                let settings = settings.map_err(|problem: &str| wrong(problem.to_owned()))?;
                let record = match (record, failure) {
                    (Some(record), _) => serde_json::from_str(&record).map_err(|fault| {
                        wrong(format!("the record is not one of this version: {fault}"))
                    })?,
                    (None, failure) => {
                        Record::failed(Plain::of(&failure.unwrap_or_default()).into())
                    }
                };
                take(place, &Key { content, settings }, record)
            })?;
        }
        Ok(())
    }
}

impl Which {
    fn of(
        [name, content, settings, failure, known]: [Option<String>; 5],
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
                recording: Recording {
                    entry: None,
                    path: PathBuf::from(&name),
                    name,
                },
                metadata: metadata.of(known.as_deref().unwrap_or_default())?,
            },
            settings,
            content,
            row,
        })
    }
}

/// All Parquet files in a folder and the folders in it, in the order of their names. Folders that are links are left
/// out: they may lead round in a circle.
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

/// Reads columns of texts, row by row.
fn read<const COLUMNS: usize>(
    path: &Path,
    names: [&str; COLUMNS],
    mut take: impl FnMut([Option<String>; COLUMNS]) -> Result<()>,
) -> Result<()> {
    let wrong = |fault: ParquetError| Error::rows(path, fault);
    let file = File::open(path).map_err(Error::read(path))?;
    let reader = contain(|| SerializedFileReader::new(Table(file))).map_err(wrong)?;
    for number in 0..reader.num_row_groups() {
        let group = contain(|| reader.get_row_group(number)).map_err(wrong)?;
        let mut columns = Vec::new();
        for name in names {
            let column = contain(|| Texts::new(&*group, name)).map_err(wrong)?;
            columns.push(column.ok_or_else(|| {
                let problem =
                    format!("has no column {name} of texts; is it a result of bouncelab?");
                Error::rows(path, problem)
            })?);
        }
        let rows = usize::try_from(group.metadata().num_rows()).unwrap_or_default();
        for start in (0..rows).step_by(ROWS) {
            let count = ROWS.min(rows - start);
            let read = columns
                .iter_mut()
                .map(|column| contain(|| column.next(count)));
            let read: Vec<_> = read.collect::<Parquet<_>>().map_err(wrong)?;
            let mut cells: Vec<_> = read.into_iter().map(Vec::into_iter).collect();
            for _ in 0..count {
                take(std::array::from_fn(|column| cells[column].next().flatten()))?;
            }
        }
    }
    Ok(())
}

/// A file that ends with an error where more is read than there is: the library takes such an end for nothing to skip,
/// and would skip a billion numbers that a damaged header announces one by one.
struct Table(File);

/// A part of it.
struct Part(BufReader<File>);

impl Length for Table {
    fn len(&self) -> u64 {
        Length::len(&self.0)
    }
}

impl ChunkReader for Table {
    type T = Part;

    fn get_read(&self, start: u64) -> Parquet<Part> {
        self.0.get_read(start).map(Part)
    }

    fn get_bytes(&self, start: u64, length: usize) -> Parquet<Bytes> {
        self.0.get_bytes(start, length)
    }
}

impl Read for Part {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        match self.0.read(buffer)? {
            0 if !buffer.is_empty() => Err(io::ErrorKind::UnexpectedEof.into()),
            read => Ok(read),
        }
    }
}

/// Runs code of the library, which panics at some damaged files where it should return an error. Nothing that the work
/// touched may be used after that.
fn contain<T>(work: impl FnOnce() -> Parquet<T>) -> Parquet<T> {
    let damaged = || ParquetError::General("the file is damaged".to_owned());
    bouncelab_audio::contain(work).unwrap_or_else(|| Err(damaged()))
}

/// The pages of a column of texts, without those for which the library would take as much memory as a damaged number
/// says.
struct Pages(Box<dyn PageReader>);

impl Iterator for Pages {
    type Item = Parquet<Page>;

    fn next(&mut self) -> Option<Self::Item> {
        self.get_next_page().transpose()
    }
}

impl PageReader for Pages {
    fn get_next_page(&mut self) -> Parquet<Option<Page>> {
        /// Before each text in a dictionary stands its length.
        const LENGTH: usize = size_of::<u32>();
        let page = self.0.get_next_page()?;
        match &page {
            Some(Page::DictionaryPage {
                buf, num_values, ..
            }) if *num_values as usize > buf.len() / LENGTH => {
                let problem = "a dictionary has fewer texts than it says";
                Err(ParquetError::EOF(problem.to_owned()))
            }
            Some(Page::DataPage { encoding, .. } | Page::DataPageV2 { encoding, .. })
                if !ENCODINGS.contains(encoding) =>
            {
                let problem =
                    format!("its texts are written as {encoding}, not plain or with a dictionary");
                Err(ParquetError::NYI(problem))
            }
            _ => Ok(page),
        }
    }

    fn peek_next_page(&mut self) -> Parquet<Option<PageMetadata>> {
        self.0.peek_next_page()
    }

    fn skip_next_page(&mut self) -> Parquet<()> {
        self.0.skip_next_page()
    }
}

/// How engines write texts unless somebody asks them for something else.
const ENCODINGS: [Encoding; 3] = [
    Encoding::PLAIN,
    Encoding::PLAIN_DICTIONARY,
    Encoding::RLE_DICTIONARY,
];

/// A column of texts of a row group.
struct Texts {
    reader: ColumnReaderImpl<ByteArrayType>,
    /// The definition level of a text that is there.
    level: i16,
}

impl Texts {
    fn new(group: &dyn RowGroupReader, name: &str) -> Parquet<Option<Self>> {
        let schema = group.metadata().schema_descr();
        let mut columns = schema.columns().iter();
        let Some(place) = columns.position(|column| column.path().string() == name) else {
            return Ok(None);
        };
        let column = schema.column(place);
        if column.physical_type() != Type::BYTE_ARRAY {
            return Ok(None);
        }
        let pages = Pages(group.get_column_page_reader(place)?);
        Ok(Some(Self {
            level: column.max_def_level(),
            reader: ColumnReaderImpl::new(column, Box::new(pages)),
        }))
    }

    /// The next cells.
    fn next(&mut self, count: usize) -> Parquet<Vec<Option<String>>> {
        let (mut levels, mut values) = (Vec::new(), Vec::new());
        let read = self
            .reader
            .read_records(count, Some(&mut levels), None, &mut values)?;
        if read.0 != count {
            return Err(ParquetError::EOF(
                "it has fewer rows than it says".to_owned(),
            ));
        }
        if self.level == 0 {
            levels = vec![0; count];
        }
        let mut values = values
            .iter()
            .map(|text: &ByteArray| text.as_utf8().map(str::to_owned));
        let cell = |level: i16| (level == self.level).then(|| values.next()).flatten();
        levels
            .into_iter()
            .map(cell)
            .map(Option::transpose)
            .collect()
    }
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
