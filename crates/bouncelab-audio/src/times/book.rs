//! Sheets and archives: several tables, of which one is read.
//!
//! phyphox exports its stopwatch as sheets `Simple`, `Multiple` and `All`, or as files of these names in an archive. They
//! hold the same run, and the one with the most impacts is read. `Metadata Device` and `Metadata Time`, or files in the
//! folder `meta`, state the phone and the time.

use std::collections::BTreeMap;
use std::io::{Cursor, Read};

use bouncelab::Plain;
use zip::ZipArchive;

use super::table::{Row, Table};
use super::{ListFormat, Listed, TimeList, decoded};
use crate::error::{Error, Result};
use crate::problem::TimesProblem;

/// Maximum number of files in an archive.
const MAX_FILES: usize = 1_000;
/// Maximum size of all tables of an archive together, unpacked, in bytes.
const MAX_LEN: u64 = 1 << 26;
/// Maximum distance of the same time in two tables, in seconds: they are written with different digits.
const MAX_DIFFERENCE_S: f64 = 1e-3;

/// A table as text.
pub(super) struct NamedTable {
    pub(super) name: String,
    pub(super) text: String,
    pub(super) format: ListFormat,
}

/// What one table holds, by its name.
type Found = (String, Listed);

/// Reads the table with the most impacts. Those that are no text are only named.
pub(super) fn of_tables(tables: Vec<NamedTable>, name: &str) -> Result<Listed> {
    let names: Vec<&str> = tables.iter().map(|table| table.name.as_str()).collect();
    let none = TimesProblem::NoList {
        found: Plain::of(&names.join(", ")).into(),
    };
    let tables = tables.into_iter().filter(|table| !table.text.is_empty());
    let (about, tables): (Vec<_>, Vec<_>) = tables.partition(NamedTable::is_metadata);
    let sole = tables.len() == 1;
    let mut found: Vec<Found> = Vec::new();
    for table in tables {
        let whole = format!("{name} ({})", table.name);
        match super::of_text(&table.text, table.format, &whole) {
            Ok(listed) => found.push((table.name, listed)),
            // A table beside the times may be of anything else.
            Err(
                Error::Empty { .. }
                | Error::Times {
                    problem:
                        TimesProblem::NoTimeColumn { .. } | TimesProblem::NamelessColumns { .. },
                    ..
                },
            ) if !sole => {}
            Err(refusal) => return Err(refusal),
        }
    }
    let chosen = fullest(found, none).map_err(|problem| Error::times(name, None, problem))?;
    Ok(match chosen {
        Listed::Times(mut list) => {
            list.origin.notes = about.iter().flat_map(NamedTable::notes).collect();
            Listed::Times(list)
        }
        sound @ (Listed::Waveform(_) | Listed::Samples(_)) => sound,
    })
}

/// The list with the most times, if it has those of all others; or the only waveform.
fn fullest(mut found: Vec<Found>, none: TimesProblem) -> std::result::Result<Listed, TimesProblem> {
    let times = |listed: &Listed| match listed {
        Listed::Times(list) => list.times_s.len(),
        Listed::Waveform(_) | Listed::Samples(_) => 0,
    };
    found.sort_by_key(|(_, listed)| std::cmp::Reverse(times(listed)));
    let mut found = found.into_iter();
    let (first, fullest) = found.next().ok_or(none)?;
    let differs = |(_, other): &Found| match (&fullest, other) {
        (Listed::Times(fullest), Listed::Times(other)) => !fullest.has_all(other),
        _ => true,
    };
    match found.find(differs) {
        Some((second, _)) => Err(TimesProblem::TablesDisagree { first, second }),
        None => Ok(fullest),
    }
}

impl TimeList {
    /// Whether it has all times of another list.
    fn has_all(&self, other: &Self) -> bool {
        let has = |time_s: &f64| {
            let later = self
                .times_s
                .partition_point(|own_s| *own_s < time_s - MAX_DIFFERENCE_S);
            self.times_s
                .get(later)
                .is_some_and(|own_s| *own_s <= time_s + MAX_DIFFERENCE_S)
        };
        other.times_s.iter().all(has)
    }
}

impl NamedTable {
    fn is_metadata(&self) -> bool {
        let name = self.name.to_lowercase();
        name.starts_with("metadata") || name.split('/').any(|folder| folder == "meta")
    }

    /// The phone, and the time at which the measurement began.
    fn notes(&self) -> BTreeMap<String, String> {
        let Ok(table) = Table::of(&self.text, true) else {
            return BTreeMap::new();
        };
        let value = |property: &str| {
            let row = table.rows.iter().find(|row| row.is(property))?;
            row.cells.last().filter(|_| row.cells.len() > 1)
        };
        let device = ["deviceBrand", "deviceModel"].into_iter().filter_map(value);
        let device = device.map(String::as_str).collect::<Vec<_>>().join(" ");
        let time = value("START").cloned().unwrap_or_default();
        let notes = [("device", device), ("time", time)].into_iter();
        let stated = notes.filter(|(_, text)| !text.is_empty());
        stated
            .map(|(field, text)| (field.to_owned(), Plain::of(&text).into()))
            .collect()
    }
}

impl Row {
    fn is(&self, property: &str) -> bool {
        self.cells.first().is_some_and(|cell| cell == property)
    }
}

/// The texts in an archive, and the names of its other files.
pub(super) fn of_zip(content: &[u8]) -> std::result::Result<Vec<NamedTable>, TimesProblem> {
    let mut archive = ZipArchive::new(Cursor::new(content)).map_err(damaged)?;
    // The library has only the last of them.
    if archive.has_duplicate_names() {
        return Err(damaged("it holds two files of one name; unpack it"));
    }
    let mut budget = Budget::new(MAX_LEN);
    let mut tables = Vec::new();
    for index in 0..archive.len().min(MAX_FILES) {
        let mut file = archive.by_index(index).map_err(damaged)?;
        let name = file.name().map_err(damaged)?.into_owned();
        let is_hidden = name
            .split('/')
            .any(|part| part.starts_with('.') || part == "__MACOSX");
        if !file.is_file() || is_hidden {
            continue;
        }
        let format = ListFormat::of(&name).filter(|format| format.is_table());
        let text = match format {
            Some(_) => budget.unpack(&mut file)?,
            None => Vec::new(),
        };
        let Some(text) = decoded(&text) else {
            return Err(TimesProblem::NotText);
        };
        tables.push(NamedTable {
            name,
            text: text.into_owned(),
            format: format.unwrap_or(ListFormat::Text),
        });
    }
    Ok(tables)
}

/// What may be unpacked, whatever sizes an archive announces.
pub(super) struct Budget {
    max_len: u64,
    left: u64,
}

impl Budget {
    pub(super) const fn new(max_len: u64) -> Self {
        let left = max_len;
        Self { max_len, left }
    }

    /// The content of a file.
    pub(super) fn unpack(&mut self, file: impl Read) -> std::result::Result<Vec<u8>, TimesProblem> {
        let mut content = Vec::new();
        let mut limited = file.take(self.left + 1);
        let read = limited.read_to_end(&mut content).map_err(damaged)?;
        let max_mb = self.max_len >> 20;
        let left = self.left.checked_sub(read as u64);
        self.left = left.ok_or(TimesProblem::TooLong { max_mb })?;
        Ok(content)
    }
}

/// The problem of a file that a library cannot read.
pub(super) fn damaged(reason: impl std::fmt::Display) -> TimesProblem {
    let detail = Plain::of(&reason.to_string()).into();
    TimesProblem::NotTable { detail }
}
