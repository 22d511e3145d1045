//! Lists of impact times: exports of stopwatch apps, tables, sheets, annotations of other programs.
//!
//! | ending | content |
//! |---|---|
//! | `.csv`, `.tsv`, `.txt` | a number a line, or a table with headings; lines that start with `#` are skipped; or a label track of Audacity |
//! | `.xls`, `.xlsx`, `.ods` | tables as in `.csv`; of several the one with the most impacts |
//! | `.zip` | tables as in `.csv`, as phyphox exports them |
//! | `.json` | an array of numbers |
//! | `.TextGrid` | a point tier of Praat: the only one, or the one named `impacts` |
//! | `.svl` | a layer of Sonic Visualiser |
//!
//! The kind of a table follows from its content. Headings have a word for time, impact or interval, and perhaps a unit,
//! in four languages: a column of times, a column of intervals, or one row of stops. Without a heading, numbers that
//! increase are times, and numbers that decrease are intervals. Times at equal steps are a sampled waveform, and so is one column of many numbers that rise and fall, whose rate the caller states.
//!
//! Commas, semicolons or tabs separate; decimals follow a point, or a comma where commas do not separate. Texts are in
//! UTF-8, UTF-16 or Latin-1. Of a label with two ends the first counts.
//!
//! Times are in **seconds**, or in the unit that a heading states, on any clock: they may start anywhere, but must
//! increase. Other units are not guessed at.

mod audacity;
mod book;
mod events;
pub(crate) mod heading;
mod layer;
mod sheet;
pub(crate) mod table;
mod text_grid;

use std::borrow::Cow;
use std::fs::{self, File};
use std::io::{self, Read, Seek, SeekFrom};
use std::path::Path;

use bouncelab::Plain;
use bouncelab::analysis::ListOrigin;

use self::table::Table;
use crate::error::{self, Error};
use crate::problem::{MissingContent, TimesProblem};
use crate::waveform::{Samples, Waveform};

/// A time, and its line in formats that have lines.
type Entry = (Option<usize>, f64);

/// A result, or a problem and its line.
type Result<T> = std::result::Result<T, (Option<usize>, TimesProblem)>;

/// The impacts of one drop, as something else measured them.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct TimeList {
    /// Impact times in seconds, strictly increasing.
    pub times_s: Vec<f64>,
    /// Where they come from.
    pub origin: ListOrigin,
}

/// Events of a list, in the order of the file.
struct Events {
    entries: Vec<Entry>,
    of_intervals: bool,
    /// The program that exported them; its stopwatch marks an event where the sound exceeds a threshold.
    program: Option<&'static str>,
}

/// What a file of the kinds of lists holds.
pub(crate) enum Listed {
    Times(TimeList),
    Waveform(Waveform),
    Samples(Samples),
}

/// Whether a file of this name is read as a list of times.
pub fn is_list(name: &str) -> bool {
    ListFormat::of(name).is_some()
}

/// Reads the times in a file.
///
/// # Errors
///
/// [`Error::Times`] with the line of the problem if the name has none of the [`endings`], a cell is
/// not a number, the times do not increase, or it is a sampled waveform; [`Error::Empty`] without times;
/// [`Error::NotFound`], [`Error::Directory`] or [`Error::Io`] if the file cannot be read.
pub fn read(path: impl AsRef<Path>) -> error::Result<TimeList> {
    let path = path.as_ref();
    parse(&bytes(path)?, &String::from(Plain::path(path)))
}

/// The content of a list or waveform, if the path is that of a file and the content is not too long.
pub(crate) fn bytes(path: &Path) -> error::Result<Vec<u8>> {
    let name = String::from(Plain::path(path));
    let failed = |reason| Error::io(&name, reason);
    let about = fs::metadata(path).map_err(failed)?;
    if about.is_dir() {
        return Err(Error::Directory { name });
    }
    if !about.is_file() {
        return Err(Error::times(&name, None, TimesProblem::NotFile));
    }
    bytes_of(File::open(path).map_err(failed)?, &name)
}

/// The content of a list or waveform from a reader, if it is not too long.
pub(crate) fn bytes_of(mut reader: impl Read + Seek, name: &str) -> error::Result<Vec<u8>> {
    let read = || -> io::Result<Vec<u8>> {
        let len = reader.seek(SeekFrom::End(0))?.min(MAX_WAVEFORM_LEN + 1);
        reader.rewind()?;
        // A vector that grows would take twice as much memory.
        let mut content = Vec::with_capacity(len as usize);
        reader.take(len).read_to_end(&mut content)?;
        Ok(content)
    };
    let content = read().map_err(|reason| Error::io(name, reason))?;
    check_len(content.len(), MAX_WAVEFORM_LEN)
        .map_err(|problem| Error::times(name, None, problem))?;
    Ok(content)
}

/// Maximum length of a waveform in bytes, which is kept in memory.
const MAX_WAVEFORM_LEN: u64 = 1 << 26;
/// Maximum length of a list in bytes.
const MAX_LIST_LEN: u64 = 1 << 22;

fn check_len(len: usize, max_len: u64) -> std::result::Result<(), TimesProblem> {
    let max_mb = max_len >> 20;
    if len as u64 > max_len {
        return Err(TimesProblem::TooLong { max_mb });
    }
    Ok(())
}

/// Reads the times in the content of a file; the ending of its name determines the format.
///
/// ```
/// let list = bouncelab_audio::times::parse(b"# seconds\n0.10\n0.45\n0.72\n", "drop.txt")?;
/// assert_eq!(list.times_s, [0.10, 0.45, 0.72]);
/// # Ok::<(), bouncelab_audio::Error>(())
/// ```
///
/// # Errors
///
/// As for [`read`], but those of the file system.
pub fn parse(content: &[u8], name: &str) -> error::Result<TimeList> {
    match listed(content, name)? {
        Listed::Times(list) => Ok(list),
        Listed::Waveform(waveform) => Err(Error::times(name, None, waveform.sampled())),
        Listed::Samples(samples) => Err(samples.without_rate()),
    }
}

/// The times or the waveform in the content of a file.
pub(crate) fn listed(content: &[u8], name: &str) -> error::Result<Listed> {
    let refused = |(line, problem)| Error::times(name, line, problem);
    let Some(format) = ListFormat::of(name) else {
        return Err(refused((None, TimesProblem::Ending)));
    };
    // By their first bytes, whatever the ending is.
    let tables = if content.starts_with(b"PK") {
        match sheet::of_archive(content) {
            Ok(None) => book::of_zip(content),
            sheets => sheets.map(Option::unwrap_or_default),
        }
    } else if content.starts_with(&[0xd0, 0xcf, 0x11, 0xe0]) {
        sheet::xls(content)
    } else {
        let text = decoded(content).ok_or_else(|| refused((None, TimesProblem::NotText)))?;
        return of_text(&text, format, name);
    };
    book::of_tables(tables.map_err(|problem| refused((None, problem)))?, name)
}

/// What a text holds, by its format.
fn of_text(text: &str, format: ListFormat, name: &str) -> error::Result<Listed> {
    let refused = |(line, problem)| Error::times(name, line, problem);
    if format.is_table()
        && let Some(waveform) =
            Waveform::find(text, matches!(format, ListFormat::Csv)).map_err(refused)?
    {
        return Ok(Listed::Waveform(waveform));
    }
    if format.is_table()
        && let Some(samples) = Samples::find(text, name)
    {
        return Ok(Listed::Samples(samples));
    }
    check_len(text.len(), MAX_LIST_LEN).map_err(|problem| refused((None, problem)))?;
    let events = match format {
        ListFormat::TextGrid => text_grid::points(text).map(Events::at),
        ListFormat::Layer => layer::points(text).map(Events::at),
        ListFormat::Json => array(text).and_then(Events::of_numbers),
        ListFormat::Text if text.trim_start().starts_with('[') => {
            array(text).and_then(Events::of_numbers)
        }
        ListFormat::Text | ListFormat::Csv | ListFormat::Book => of_table(text, format),
    };
    events.map_err(refused)?.list(name).map(Listed::Times)
}

fn of_table(text: &str, format: ListFormat) -> Result<Events> {
    if let Some(labels) = audacity::starts(text) {
        return Ok(Events::at(labels));
    }
    let is_csv = matches!(format, ListFormat::Csv);
    let table = Table::of(text, is_csv).map_err(|problem| (None, problem))?;
    Events::of_table(&table)
}

fn array(text: &str) -> Result<Vec<Entry>> {
    if text.trim().is_empty() {
        return Ok(Vec::new());
    }
    match serde_json::from_str::<Vec<f64>>(text) {
        Ok(times) => Ok(times.into_iter().map(|time_s| (None, time_s)).collect()),
        Err(fault) => {
            let line = Some(fault.line()).filter(|line| *line > 0);
            let detail = fault.to_string();
            Err((line, TimesProblem::NotArray { detail }))
        }
    }
}

/// Maximum distance of a time from zero, in seconds: three centuries. Numbers beyond it do not resolve a microsecond.
const MAX_TIME_S: f64 = 1e10;

impl Events {
    /// The list of these events, if they are in order.
    fn list(self, name: &str) -> error::Result<TimeList> {
        let refuse = |line, problem| Err(Error::times(name, line, problem));
        if self.entries.is_empty() {
            return Err(Error::Empty {
                name: name.to_owned(),
                what: MissingContent::Time,
            });
        }
        if let Some(&(line, time_s)) = self.entries.iter().find(|entry| entry.1.abs() > MAX_TIME_S)
        {
            let text = format!("{time_s:e}");
            return refuse(line, TimesProblem::NotNumber { text });
        }
        if let Some(pair) = self.entries.windows(2).find(|pair| pair[1].1 <= pair[0].1) {
            let ((_, before_s), (line, time_s)) = (pair[0], pair[1]);
            return refuse(line, TimesProblem::NotLater { time_s, before_s });
        }
        Ok(TimeList {
            times_s: self.entries.into_iter().map(|(_, time_s)| time_s).collect(),
            origin: ListOrigin {
                program: self.program.map(str::to_owned),
                by_threshold: self.program.is_some(),
                of_intervals: self.of_intervals,
                ..ListOrigin::default()
            },
        })
    }
}

/// The text of a file in UTF-8, in UTF-16 with a byte order mark, or in Latin-1.
fn decoded(content: &[u8]) -> Option<Cow<'_, str>> {
    let wide = |bytes: &[u8], unit: fn([u8; 2]) -> u16| {
        let (pairs, rest) = bytes.as_chunks::<2>();
        let units: Vec<u16> = pairs.iter().map(|&pair| unit(pair)).collect();
        let text = String::from_utf16(&units).ok()?;
        rest.is_empty().then_some(Cow::Owned(text))
    };
    // The characters of Latin-1 are the first of Unicode; control characters show that it is no text.
    let is_printed = |byte: &u8| !byte.is_ascii_control() || byte.is_ascii_whitespace();
    let latin = |bytes: &[u8]| bytes.iter().map(|&byte| char::from(byte)).collect();
    let text = match content {
        [0xfe, 0xff, rest @ ..] => wide(rest, u16::from_be_bytes),
        [0xff, 0xfe, rest @ ..] => wide(rest, u16::from_le_bytes),
        [0xef, 0xbb, 0xbf, rest @ ..] | rest => match str::from_utf8(rest) {
            Ok(text) => Some(Cow::Borrowed(text)),
            Err(_) => rest.iter().all(is_printed).then(|| Cow::Owned(latin(rest))),
        },
    }?;
    // Excel ends lines so in its "CSV (Macintosh)".
    let has_old_ends = text.contains('\r') && !text.contains('\n');
    Some(if has_old_ends {
        Cow::Owned(text.replace('\r', "\n"))
    } else {
        text
    })
}

#[derive(Clone, Copy)]
enum ListFormat {
    /// A number a line, or columns separated by tabs or semicolons.
    Text,
    /// The same, or columns separated by commas.
    Csv,
    /// Sheets or an archive.
    Book,
    Json,
    TextGrid,
    Layer,
}

/// The formats, by the endings of file names.
const FORMATS: [(&str, ListFormat); 10] = [
    ("txt", ListFormat::Text),
    ("csv", ListFormat::Csv),
    ("tsv", ListFormat::Text),
    ("xls", ListFormat::Book),
    ("xlsx", ListFormat::Book),
    ("ods", ListFormat::Book),
    ("zip", ListFormat::Book),
    ("json", ListFormat::Json),
    ("TextGrid", ListFormat::TextGrid),
    ("svl", ListFormat::Layer),
];

/// Endings of the names of lists, without the dot; capital letters in a name count as small ones.
pub fn endings() -> impl Iterator<Item = &'static str> {
    FORMATS.iter().map(|(ending, _)| *ending)
}

impl ListFormat {
    /// Whether a text of it may be a table. A sheet that is a text was renamed.
    fn is_table(self) -> bool {
        matches!(self, Self::Text | Self::Csv | Self::Book)
    }

    fn of(name: &str) -> Option<Self> {
        let extension = Path::new(name).extension()?.to_str()?;
        let is_same = |(ending, _): &&(&str, Self)| ending.eq_ignore_ascii_case(extension);
        FORMATS.iter().find(is_same).map(|(_, format)| *format)
    }
}
