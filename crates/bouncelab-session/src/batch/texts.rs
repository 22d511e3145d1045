//! Columns of texts in Parquet files.
//!
//! The library trusts numbers in a file, and takes time and memory accordingly. So they are checked before, as far as
//! possible.

use std::fs::File;
use std::io::{self, BufReader, Read};
use std::path::Path;

use bytes::Bytes;
use parquet::basic::{Compression, Encoding, Type};
use parquet::column::page::{Page, PageMetadata, PageReader};
use parquet::column::reader::ColumnReaderImpl;
use parquet::data_type::{ByteArray, ByteArrayType};
use parquet::errors::{ParquetError, Result as Parquet};
use parquet::file::reader::{ChunkReader, FileReader, Length, RowGroupReader};
use parquet::file::serialized_reader::SerializedFileReader;

use crate::error::{Error, Result};

/// Number of rows of a file that are in memory at once.
const ROWS: usize = 64;

/// Reads columns of texts, row by row.
pub(super) fn read<const COLUMNS: usize>(
    path: &Path,
    names: [&str; COLUMNS],
    mut take: impl FnMut([Option<String>; COLUMNS]) -> Result<()>,
) -> Result<()> {
    let wrong = |fault: ParquetError| Error::rows(path, fault);
    let file = File::open(path).map_err(Error::read(path))?;
    let reader = contain(|| SerializedFileReader::new(EndingFile(file))).map_err(wrong)?;
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
            let reads = columns
                .iter_mut()
                .map(|column| contain(|| column.next(count)));
            let rows_of_columns: Vec<_> = reads.collect::<Parquet<_>>().map_err(wrong)?;
            let mut cells: Vec<_> = rows_of_columns.into_iter().map(Vec::into_iter).collect();
            for _ in 0..count {
                take(std::array::from_fn(|column| cells[column].next().flatten()))?;
            }
        }
    }
    Ok(())
}

/// A file that returns an error where more is read than it has. Otherwise the library would skip a billion numbers that
/// a damaged header announces, one by one, beyond the end of the file.
struct EndingFile(File);

/// A reader of a part of it.
struct Part(BufReader<File>);

impl Length for EndingFile {
    fn len(&self) -> u64 {
        Length::len(&self.0)
    }
}

impl ChunkReader for EndingFile {
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

/// Runs code of the library, which panics at some damaged files where it should return an error. After a panic nothing
/// that the closure has touched may be used.
fn contain<T>(work: impl FnOnce() -> Parquet<T>) -> Parquet<T> {
    let damaged = || ParquetError::General("the file is damaged".to_owned());
    bouncelab_audio::contain(work).unwrap_or_else(|| Err(damaged()))
}

/// The pages of a column of texts. Those for which the library would take as much memory as a damaged number states are
/// refused.
struct Pages(Box<dyn PageReader>);

impl Iterator for Pages {
    type Item = Parquet<Page>;

    fn next(&mut self) -> Option<Self::Item> {
        self.get_next_page().transpose()
    }
}

impl PageReader for Pages {
    fn get_next_page(&mut self) -> Parquet<Option<Page>> {
        /// Length in bytes of the number in front of each text in a dictionary.
        const LENGTH: usize = size_of::<u32>();
        let page = self.0.get_next_page()?;
        match &page {
            Some(Page::DictionaryPage {
                buf, num_values, ..
            }) if *num_values as usize > buf.len() / LENGTH => {
                let problem = "a dictionary has fewer texts than it states";
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

/// The encodings that engines use for texts by default.
const ENCODINGS: [Encoding; 3] = [
    Encoding::PLAIN,
    Encoding::PLAIN_DICTIONARY,
    Encoding::RLE_DICTIONARY,
];

/// A column of texts of a row group.
struct Texts {
    reader: ColumnReaderImpl<ByteArrayType>,
    /// The definition level of a text that is not null.
    level: i16,
}

impl Texts {
    fn new(group: &dyn RowGroupReader, name: &str) -> Parquet<Option<Self>> {
        let schema = group.metadata().schema_descr();
        let mut columns = schema.columns().iter();
        let Some(index) = columns.position(|column| column.path().string() == name) else {
            return Ok(None);
        };
        let column = schema.column(index);
        if column.physical_type() != Type::BYTE_ARRAY {
            return Ok(None);
        }
        let codec = group.metadata().column(index).compression();
        if !matches!(codec, Compression::UNCOMPRESSED | Compression::SNAPPY) {
            let problem = format!(
                "is compressed with {codec}; only SNAPPY and no compression are read, which Spark writes with \
                 spark.sql.parquet.compression.codec=snappy"
            );
            return Err(ParquetError::General(problem));
        }
        let pages = Pages(group.get_column_page_reader(index)?);
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
                "it has fewer rows than it states".to_owned(),
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
