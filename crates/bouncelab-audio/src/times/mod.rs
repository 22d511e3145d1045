//! Lists of impact times: published tables, stopwatch apps, other programs' exports.
//!
//! | ending | content |
//! |---|---|
//! | `.txt` | one time a line, perhaps below a heading; blank lines and lines that start with `#` are skipped; or a label track of Audacity; or columns separated by tabs, as for `.csv` |
//! | `.csv` | one time a line, or columns with a header, one of them a word for time, perhaps with a unit, as in `time_s` and `Time (ms)`; separated by commas, semicolons or tabs; `#` as above |
//! | `.json` | an array of numbers |
//! | `.TextGrid` | a point tier of Praat: the only one, or the one named `impacts` |
//!
//! Decimals follow a point, or a comma where commas do not separate. Of a label with two ends the first counts.
//!
//! Times are in **seconds**, or in the unit that a heading states, on any clock: they may start anywhere, but must
//! increase. Other units are not guessed at.

mod audacity;
pub(crate) mod heading;
mod text_grid;

use std::borrow::Cow;
use std::fs::{self, File};
use std::io::{self, Read, Seek, SeekFrom};
use std::path::Path;

use bouncelab::Plain;

use crate::error::{Error, Result};
use crate::problem::{MissingContent, TimesProblem};

/// A time, and its line in formats that have lines.
type Entry = (Option<usize>, f64);

/// Whether a file of this name is read as a list of times.
pub fn is_list(name: &str) -> bool {
    ListFormat::of(name).is_some()
}

/// Reads the times in a file.
///
/// # Errors
///
/// [`Error::Times`] with the line of the problem if the name has none of the [`endings`], a cell is
/// not a number, or the times do not increase; [`Error::Empty`] without times;
/// [`Error::NotFound`], [`Error::Directory`] or [`Error::Io`] if the file cannot be read.
pub fn read(path: impl AsRef<Path>) -> Result<Vec<f64>> {
    let path = path.as_ref();
    parse(&bytes(path)?, &String::from(Plain::path(path)))
}

/// The content of a list or waveform, if the path is that of a file and the content is not too long.
pub(crate) fn bytes(path: &Path) -> Result<Vec<u8>> {
    let name = String::from(Plain::path(path));
    let failed = |reason| Error::io(&name, reason);
    let about = fs::metadata(path).map_err(failed)?;
    if about.is_dir() {
        return Err(Error::Directory { name });
    }
    if !about.is_file() {
        return List { name: &name }.refuse(None, TimesProblem::NotFile);
    }
    bytes_of(File::open(path).map_err(failed)?, &name)
}

/// The content of a list or waveform from a reader, if it is not too long.
pub(crate) fn bytes_of(mut reader: impl Read + Seek, name: &str) -> Result<Vec<u8>> {
    let read = || -> io::Result<Vec<u8>> {
        let len = reader.seek(SeekFrom::End(0))?.min(MAX_WAVEFORM_LEN + 1);
        reader.rewind()?;
        // A vector that grows would take twice as much memory.
        let mut content = Vec::with_capacity(len as usize);
        reader.take(len).read_to_end(&mut content)?;
        Ok(content)
    };
    let content = read().map_err(|reason| Error::io(name, reason))?;
    List { name }.check_len(&content, MAX_WAVEFORM_LEN)?;
    Ok(content)
}

/// Maximum length of a waveform in bytes, which is kept in memory.
const MAX_WAVEFORM_LEN: u64 = 1 << 26;
/// Maximum length of a list in bytes.
const MAX_LIST_LEN: u64 = 1 << 22;

/// Reads the times in the content of a file; the ending of its name determines the format.
///
/// ```
/// let times = bouncelab_audio::times::parse(b"# seconds\n0.10\n0.45\n0.72\n", "drop.txt")?;
/// assert_eq!(times, [0.10, 0.45, 0.72]);
/// # Ok::<(), bouncelab_audio::Error>(())
/// ```
///
/// # Errors
///
/// As for [`read`], but those of the file system.
pub fn parse(content: &[u8], name: &str) -> Result<Vec<f64>> {
    let list = List { name };
    let Some(format) = ListFormat::of(name) else {
        return list.refuse(None, TimesProblem::Ending);
    };
    list.check_len(content, MAX_LIST_LEN)?;
    let Some(text) = decoded(content) else {
        return list.refuse(None, TimesProblem::NotText);
    };
    let entries = match format {
        ListFormat::Txt if first_line(&text).contains('\t') => {
            audacity::starts(&text).map_or_else(|| list.table(&text), Ok)?
        }
        ListFormat::Txt => list.lines(&text)?,
        ListFormat::Csv if separator(&text).is_none() => list.lines(&text)?,
        ListFormat::Csv => list.table(&text)?,
        ListFormat::Json => list.array(&text)?,
        ListFormat::TextGrid => list.points(&text)?,
    };
    list.check(&entries)?;
    Ok(entries.into_iter().map(|(_, time_s)| time_s).collect())
}

/// The text of a file in UTF-8, or in UTF-16 with a byte order mark, as Praat writes it.
fn decoded(content: &[u8]) -> Option<Cow<'_, str>> {
    let wide = |bytes: &[u8], unit: fn([u8; 2]) -> u16| {
        let (pairs, rest) = bytes.as_chunks::<2>();
        let units: Vec<u16> = pairs.iter().map(|&pair| unit(pair)).collect();
        let text = String::from_utf16(&units).ok()?;
        rest.is_empty().then_some(Cow::Owned(text))
    };
    match content {
        [0xfe, 0xff, rest @ ..] => wide(rest, u16::from_be_bytes),
        [0xff, 0xfe, rest @ ..] => wide(rest, u16::from_le_bytes),
        [0xef, 0xbb, 0xbf, rest @ ..] | rest => str::from_utf8(rest).ok().map(Cow::Borrowed),
    }
}

/// The first line that is neither blank nor a comment.
fn first_line(text: &str) -> &str {
    let mut lines = text.lines();
    let has_content = |line: &&str| !line.trim().is_empty() && !line.starts_with('#');
    lines.find(has_content).unwrap_or_default()
}

#[derive(Clone, Copy)]
enum ListFormat {
    Txt,
    Csv,
    Json,
    TextGrid,
}

/// The formats, by the endings of file names.
const FORMATS: [(&str, ListFormat); 4] = [
    ("txt", ListFormat::Txt),
    ("csv", ListFormat::Csv),
    ("json", ListFormat::Json),
    ("TextGrid", ListFormat::TextGrid),
];

/// Endings of the names of lists, without the dot; capital letters in a name count as small ones.
pub fn endings() -> impl Iterator<Item = &'static str> {
    FORMATS.iter().map(|(ending, _)| *ending)
}

impl ListFormat {
    fn of(name: &str) -> Option<Self> {
        let extension = Path::new(name).extension()?.to_str()?;
        let is_same = |(ending, _): &&(&str, Self)| ending.eq_ignore_ascii_case(extension);
        FORMATS.iter().find(is_same).map(|(_, format)| *format)
    }
}

/// Maximum distance of a time from zero, in seconds: three centuries. Numbers beyond it do not resolve a microsecond.
const MAX_TIME_S: f64 = 1e10;

/// A list that is read, with its name for errors.
struct List<'a> {
    name: &'a str,
}

impl List<'_> {
    fn refuse<T>(&self, line: Option<usize>, problem: TimesProblem) -> Result<T> {
        Err(Error::times(self.name, line, problem))
    }

    fn check_len(&self, content: &[u8], max_len: u64) -> Result<()> {
        if content.len() as u64 <= max_len {
            return Ok(());
        }
        let max_mb = max_len >> 20;
        self.refuse(None, TimesProblem::TooLong { max_mb })
    }

    /// One time on each line, perhaps below a heading.
    fn lines(&self, text: &str) -> Result<Vec<Entry>> {
        let mut lines = text
            .lines()
            .map(str::trim)
            .zip(1..)
            .filter(|(content, _)| !content.is_empty() && !content.starts_with('#'))
            .peekable();
        let heading = lines.peek().and_then(|(first, _)| heading::unit_s(first));
        let unit_s = heading.unwrap_or(1.0);
        lines
            .skip(usize::from(heading.is_some()))
            .map(|(content, line)| self.number(content, line, ',', unit_s))
            .collect()
    }

    fn table(&self, text: &str) -> Result<Vec<Entry>> {
        let separator = separator(text).unwrap_or(b',');
        // Where commas do not separate, one in a number is its decimal point.
        let point = if separator == b',' { '.' } else { ',' };
        let mut reader = csv::ReaderBuilder::new()
            .has_headers(false)
            .flexible(true)
            .delimiter(separator)
            .comment(Some(b'#'))
            .trim(csv::Trim::All)
            .from_reader(text.as_bytes());
        let mut entries = Vec::new();
        let mut heading = None;
        for record in reader.records() {
            let record = match record {
                Ok(record) => record,
                Err(fault) => {
                    return self.refuse(
                        None,
                        TimesProblem::NotTable {
                            detail: fault.to_string(),
                        },
                    );
                }
            };
            let line = record
                .position()
                .map_or(0, |position| position.line() as usize);
            let Some((column, unit_s, columns)) = heading else {
                let is_header = record.iter().any(|cell| to_number(cell, point).is_none());
                let (column, unit_s) = self.column(&record, line, is_header)?;
                heading = Some((column, unit_s, record.len()));
                if !is_header {
                    entries.push(self.number(&record[0], line, point, unit_s)?);
                }
                continue;
            };
            // A decimal comma would count as a separator.
            if record.iter().skip(columns).any(|cell| !cell.is_empty()) {
                let found = record.len();
                return self.refuse(Some(line), TimesProblem::MoreColumns { found, columns });
            }
            match record.get(column) {
                Some(cell) => entries.push(self.number(cell, line, point, unit_s)?),
                None => return self.refuse(Some(line), TimesProblem::Missing),
            }
        }
        Ok(entries)
    }

    /// The column with the times, and their unit in seconds, by the first line of the table.
    fn column(
        &self,
        first: &csv::StringRecord,
        line: usize,
        is_header: bool,
    ) -> Result<(usize, f64)> {
        let mut headings = first.iter().map(heading::unit_s).enumerate();
        match headings.find_map(|(column, unit_s)| Some((column, unit_s?))) {
            Some(found) => Ok(found),
            None if is_header => self.refuse(
                Some(line),
                TimesProblem::NoTimeColumn {
                    found: Plain::of(&first.iter().collect::<Vec<_>>().join(", ")).into(),
                },
            ),
            None if first.len() > 1 => self.refuse(
                Some(line),
                TimesProblem::NamelessColumns {
                    columns: first.len(),
                },
            ),
            None => Ok((0, 1.0)),
        }
    }

    fn array(&self, text: &str) -> Result<Vec<Entry>> {
        if text.trim().is_empty() {
            return Ok(Vec::new());
        }
        match serde_json::from_str::<Vec<f64>>(text) {
            Ok(times) => Ok(times.into_iter().map(|time_s| (None, time_s)).collect()),
            Err(fault) => {
                let line = Some(fault.line()).filter(|line| *line > 0);
                self.refuse(
                    line,
                    TimesProblem::NotArray {
                        detail: fault.to_string(),
                    },
                )
            }
        }
    }

    fn number(&self, cell: &str, line: usize, point: char, unit_s: f64) -> Result<Entry> {
        match to_number(cell, point) {
            Some(time) if time.is_finite() => Ok((Some(line), time * unit_s)),
            _ => self.refuse(
                Some(line),
                TimesProblem::NotNumber {
                    text: cell.to_owned(),
                },
            ),
        }
    }

    fn check(&self, entries: &[Entry]) -> Result<()> {
        if entries.is_empty() {
            return Err(Error::Empty {
                name: self.name.to_owned(),
                what: MissingContent::Time,
            });
        }
        if let Some(&(line, time_s)) = entries.iter().find(|entry| entry.1.abs() > MAX_TIME_S) {
            let text = format!("{time_s:e}");
            return self.refuse(line, TimesProblem::NotNumber { text });
        }
        match entries.windows(2).find(|pair| pair[1].1 <= pair[0].1) {
            Some(&[(_, before_s), (line, time_s)]) => {
                self.refuse(line, TimesProblem::NotLater { time_s, before_s })
            }
            _ => Ok(()),
        }
    }
}

/// The separator of a table: a tab if its first line has one, else a semicolon or a comma, of which that line has more;
/// `None` without any.
fn separator(text: &str) -> Option<u8> {
    let first = first_line(text);
    let count = |separator| first.matches(separator).count();
    if count('\t') > 0 {
        Some(b'\t')
    } else if count(';') > 0 && count(';') >= count(',') {
        Some(b';')
    } else {
        Some(b',').filter(|_| count(',') > 0)
    }
}

fn to_number(cell: &str, point: char) -> Option<f64> {
    if point == '.' {
        cell.parse().ok()
    } else {
        cell.replace(point, ".").parse().ok()
    }
}
