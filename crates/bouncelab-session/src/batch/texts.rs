//! Columns of texts in Parquet files.
//!
//! The library trusts numbers in a file, and takes time and memory accordingly. So they are checked before, as far as
//! possible, and pages are unpacked here.

use std::fs::File;
use std::io::{self, BufReader, Read, Seek, SeekFrom};
use std::path::Path;
use std::sync::Arc;

use bytes::Bytes;
use parquet::basic::{Compression, Encoding, Type};
use parquet::column::page::{Page, PageMetadata, PageReader};
use parquet::column::reader::ColumnReaderImpl;
use parquet::data_type::{ByteArray, ByteArrayType};
use parquet::errors::{ParquetError, Result as Parquet};
use parquet::file::reader::{ChunkReader, FileReader, Length, RowGroupReader};
use parquet::file::serialized_reader::{SerializedFileReader, SerializedPageReader};

use crate::error::{Error, Result};

/// Number of rows of a file that are in memory at once.
const ROWS: usize = 64;

/// Maximum length in bytes of a page in the file.
const MAX_PACKED: usize = 96 << 20;

/// A column of texts that is read.
pub(super) struct Column {
    name: &'static str,
    /// Maximum length in bytes of a text.
    max_text: usize,
    /// Maximum length in bytes of a page, unpacked, and of the dictionary that it refers to.
    max_page: usize,
}

impl Column {
    /// One of names, hashes, messages and notes.
    pub(super) const fn short(name: &'static str) -> Self {
        Self {
            name,
            max_text: 64 << 10,
            max_page: 12 << 20,
        }
    }

    /// One of records: a drop takes 35 kB, and a recording has a thousand at most.
    pub(super) const fn long(name: &'static str) -> Self {
        Self {
            name,
            max_text: 48 << 20,
            max_page: MAX_PACKED,
        }
    }
}

/// Reads columns of texts, row by row.
pub(super) fn read<const COLUMNS: usize>(
    path: &Path,
    wanted: &[Column; COLUMNS],
    mut take: impl FnMut([Option<&str>; COLUMNS]) -> Result<()>,
) -> Result<()> {
    let wrong = |fault: ParquetError| Error::rows(path, fault);
    let mut file = File::open(path).map_err(Error::read(path))?;
    check_footer(&mut file).map_err(wrong)?;
    let pages = file.try_clone().map_err(Error::read(path))?;
    let pages = Arc::new(EndingFile(pages));
    let reader = contain(|| SerializedFileReader::new(EndingFile(file))).map_err(wrong)?;
    for number in 0..reader.num_row_groups() {
        let group = contain(|| reader.get_row_group(number)).map_err(wrong)?;
        let mut columns = Vec::new();
        for column in wanted {
            let texts = contain(|| Texts::new(&*group, &pages, column)).map_err(wrong)?;
            columns.push(texts.ok_or_else(|| {
                let name = column.name;
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
            for row in 0..count {
                let mut cells = [None; COLUMNS];
                for (cell, column) in cells.iter_mut().zip(&rows_of_columns) {
                    *cell = column[row]
                        .as_ref()
                        .map(ByteArray::as_utf8)
                        .transpose()
                        .map_err(wrong)?;
                }
                take(cells)?;
            }
        }
    }
    Ok(())
}

/// Refuses a description of the columns, at the end of the file, for which the library would take much memory.
fn check_footer(file: &mut File) -> Parquet<()> {
    /// Its length in bytes, and the mark of the format behind that.
    const END: i64 = 8;
    /// Maximum length in bytes: that of three hundred groups of rows.
    const MAX: u32 = 4 << 20;
    let mut len = [0; 4];
    // What is too short is refused by the library.
    if file.seek(SeekFrom::End(-END)).is_ok() && file.read_exact(&mut len).is_ok() {
        let len = u32::from_le_bytes(len);
        if len > MAX {
            let problem =
                format!("the description of its columns takes {len} bytes, more than {MAX}");
            return Err(ParquetError::General(problem));
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
        check_page(length, MAX_PACKED)?;
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

/// Refuses a page that is too long.
fn check_page(length: usize, max: usize) -> Parquet<()> {
    if length <= max {
        return Ok(());
    }
    let problem =
        format!("a page takes {length} bytes, more than {max}; write pages of fewer rows");
    Err(ParquetError::General(problem))
}

/// The pages of a column of texts. Those for which the library would take as much memory as a damaged number states are
/// refused.
struct Pages {
    /// Those as they are in the file.
    packed: SerializedPageReader<EndingFile>,
    is_packed: bool,
    max_page: usize,
    /// Length in bytes of the dictionary, which stays in memory.
    dictionary: usize,
}

impl Pages {
    /// The bytes of a page, of which the first `levels` are never packed.
    fn unpack(&self, bytes: &Bytes, levels: u32, is_packed: bool) -> Parquet<Bytes> {
        let fault = |fault: snap::Error| ParquetError::General(fault.to_string());
        let left = self.max_page.saturating_sub(self.dictionary);
        if !(is_packed && self.is_packed) {
            check_page(bytes.len(), left)?;
            return Ok(bytes.clone());
        }
        let Some((levels, packed)) = bytes.split_at_checked(levels as usize) else {
            return Err(ParquetError::EOF("a page ends early".to_owned()));
        };
        if packed.is_empty() {
            return Ok(bytes.clone());
        }
        let length = snap::raw::decompress_len(packed).map_err(fault)?;
        check_page(levels.len() + length, left)?;
        let mut unpacked = vec![0; levels.len() + length];
        unpacked[..levels.len()].copy_from_slice(levels);
        snap::raw::Decoder::new()
            .decompress(packed, &mut unpacked[levels.len()..])
            .map_err(fault)?;
        Ok(unpacked.into())
    }
}

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
        let mut page = self.packed.get_next_page()?;
        match &mut page {
            Some(Page::DictionaryPage { buf, .. }) => {
                *buf = self.unpack(buf, 0, true)?;
                self.dictionary = buf.len();
            }
            Some(Page::DataPage { buf, .. }) => *buf = self.unpack(buf, 0, true)?,
            Some(Page::DataPageV2 {
                buf,
                def_levels_byte_len,
                rep_levels_byte_len,
                is_compressed,
                ..
            }) => {
                let levels = def_levels_byte_len.saturating_add(*rep_levels_byte_len);
                *buf = self.unpack(buf, levels, *is_compressed)?;
            }
            None => {}
        }
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
        self.packed.peek_next_page()
    }

    fn skip_next_page(&mut self) -> Parquet<()> {
        self.packed.skip_next_page()
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
    max_text: usize,
}

impl Texts {
    fn new(
        group: &dyn RowGroupReader,
        file: &Arc<EndingFile>,
        wanted: &Column,
    ) -> Parquet<Option<Self>> {
        let schema = group.metadata().schema_descr();
        let mut columns = schema.columns().iter();
        let Some(index) = columns.position(|column| column.path().string() == wanted.name) else {
            return Ok(None);
        };
        let column = schema.column(index);
        if column.physical_type() != Type::BYTE_ARRAY {
            return Ok(None);
        }
        let in_file = group.metadata().column(index);
        let codec = in_file.compression();
        if !matches!(codec, Compression::UNCOMPRESSED | Compression::SNAPPY) {
            let problem = format!(
                "is compressed with {codec}; only SNAPPY and no compression are read, which Spark writes with \
                 spark.sql.parquet.compression.codec=snappy"
            );
            return Err(ParquetError::General(problem));
        }
        let rows = usize::try_from(group.metadata().num_rows())?;
        let as_is = in_file.clone().into_builder();
        let as_is = as_is.set_compression(Compression::UNCOMPRESSED).build()?;
        let pages = Pages {
            packed: SerializedPageReader::new(Arc::clone(file), &as_is, rows, None)?,
            is_packed: codec == Compression::SNAPPY,
            max_page: wanted.max_page,
            dictionary: 0,
        };
        Ok(Some(Self {
            max_text: wanted.max_text,
            level: column.max_def_level(),
            reader: ColumnReaderImpl::new(column, Box::new(pages)),
        }))
    }

    /// The next cells.
    fn next(&mut self, count: usize) -> Parquet<Vec<Option<ByteArray>>> {
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
        if let Some(long) = values
            .iter()
            .find(|it: &&ByteArray| it.len() > self.max_text)
        {
            let (len, max) = (long.len(), self.max_text);
            let problem = format!("a text takes {len} bytes, more than {max}");
            return Err(ParquetError::General(problem));
        }
        let mut values = values.into_iter();
        let cell = |level: i16| (level == self.level).then(|| values.next()).flatten();
        Ok(levels.into_iter().map(cell).collect())
    }
}

#[cfg(test)]
mod tests {
    use parquet::file::properties::{WriterProperties, WriterVersion};
    use parquet::file::writer::SerializedFileWriter;
    use parquet::schema::parser::parse_message_type;

    use super::*;

    /// A file with a column `name` of these texts.
    fn written(texts: &[&str], properties: WriterProperties) -> tempfile::NamedTempFile {
        let file = tempfile::NamedTempFile::new().unwrap();
        let schema = parse_message_type("message rows { optional binary name (UTF8); }").unwrap();
        let to = file.reopen().unwrap();
        let mut writer =
            SerializedFileWriter::new(to, Arc::new(schema), Arc::new(properties)).unwrap();
        let mut group = writer.next_row_group().unwrap();
        let mut column = group.next_column().unwrap().unwrap();
        // Behind each text is a null.
        let levels: Vec<i16> = texts.iter().flat_map(|_| [1, 0]).collect();
        let values: Vec<ByteArray> = texts.iter().map(|&it| it.into()).collect();
        let typed = column.typed::<ByteArrayType>();
        typed.write_batch(&values, Some(&levels), None).unwrap();
        column.close().unwrap();
        group.close().unwrap();
        writer.close().unwrap();
        file
    }

    fn read_back(file: &tempfile::NamedTempFile) -> Result<Vec<Option<String>>> {
        let mut found = Vec::new();
        read(file.path(), &[Column::short("name")], |[cell]| {
            found.push(cell.map(str::to_owned));
            Ok(())
        })?;
        Ok(found)
    }

    #[test]
    fn pages_of_both_versions_are_unpacked() {
        let texts = ["one", "two", "one", "three"];
        let expected: Vec<Option<String>> = texts
            .iter()
            .flat_map(|&text| [Some(text.to_owned()), None])
            .collect();
        for version in [WriterVersion::PARQUET_1_0, WriterVersion::PARQUET_2_0] {
            for codec in [Compression::UNCOMPRESSED, Compression::SNAPPY] {
                for has_dictionary in [true, false] {
                    let properties = WriterProperties::builder()
                        .set_writer_version(version)
                        .set_compression(codec)
                        .set_encoding(Encoding::PLAIN)
                        .set_dictionary_enabled(has_dictionary)
                        .build();
                    let read = read_back(&written(&texts, properties)).unwrap();
                    assert_eq!(read, expected, "{version:?} {codec} {has_dictionary}");
                }
            }
        }
    }

    /// Equal letters are packed to a twentieth: the file is small, and its pages are not.
    #[test]
    fn what_takes_much_memory_is_refused() {
        let packed = || WriterProperties::builder().set_compression(Compression::SNAPPY);
        for (texts, properties, said) in [
            (vec!["x".repeat(20 << 20)], packed(), "a page takes"),
            (vec!["x".repeat(100 << 10)], packed(), "a text takes"),
            (
                vec!["x".to_owned()],
                packed().set_key_value_metadata(Some(vec![
                    parquet::file::metadata::KeyValue::new("k".to_owned(), "v".repeat(5 << 20)),
                ])),
                "the description of its columns takes",
            ),
        ] {
            let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
            let refused = read_back(&written(&texts, properties.build())).unwrap_err();
            assert!(refused.to_string().contains(said), "{refused}");
        }
    }
}
