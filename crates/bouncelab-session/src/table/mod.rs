//! Tables in three forms: Parquet, CSV and JSON lines.
//!
//! A table has columns with a type, a unit and a sentence of meaning; rows are written as they come,
//! so that a table of any length takes little memory. Each file is written under another name and
//! given its own when it is whole.

mod parquet;
mod text;

use std::fs::File;
use std::path::{Path, PathBuf};

use tempfile::NamedTempFile;

use crate::error::{Error, Result};
use parquet::ParquetTable;
use text::{CsvTable, JsonTable};

/// What the cells of a column hold; any cell may be empty.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// Text.
    Text,
    /// A number.
    Number,
    /// A whole number.
    Count,
    /// Yes or no.
    Flag,
}

/// A column of a table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Column {
    /// Its name, with the unit at its end if there is one: `height_m`.
    pub name: String,
    /// What its cells hold.
    pub kind: Kind,
    /// Its unit, as in "m/s"; empty for text and plain numbers.
    pub unit: &'static str,
    /// What it means, in one sentence.
    pub about: String,
}

/// A cell.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// Not known.
    Empty,
    /// Text.
    Text(String),
    /// A number; one that is not finite counts as not known.
    Number(f64),
    /// A whole number.
    Count(i64),
    /// Yes or no.
    Flag(bool),
}

impl Cell {
    /// A number, or nothing.
    pub fn number(value: Option<f64>) -> Self {
        value.map_or(Self::Empty, Self::Number)
    }

    /// Text, or nothing.
    pub fn text(value: Option<&str>) -> Self {
        value.map_or(Self::Empty, |text| Self::Text(text.to_owned()))
    }
}

/// What a table is: its name, schema and columns.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Schema {
    /// The name of its files, without ending.
    pub name: &'static str,
    /// Name and version of the schema, as in "bouncelab.drops/1".
    pub schema: &'static str,
    /// Version of the program that writes it.
    pub version: &'static str,
    /// Its columns.
    pub columns: Vec<Column>,
}

/// The form of a table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Form {
    /// Apache Parquet, compressed by Snappy.
    Parquet,
    /// Comma-separated values with a header.
    Csv,
    /// One JSON object a line.
    JsonLines,
}

impl Form {
    /// Every form.
    pub const ALL: [Self; 3] = [Self::Parquet, Self::Csv, Self::JsonLines];

    /// How names of its files end.
    pub const fn ending(self) -> &'static str {
        match self {
            Self::Parquet => "parquet",
            Self::Csv => "csv",
            Self::JsonLines => "jsonl",
        }
    }
}

/// A form of table as it is written.
trait Rows {
    fn row(&mut self, row: &[Cell]) -> std::result::Result<(), String>;
    /// Writes what is left and returns the file.
    fn finish(self: Box<Self>) -> std::result::Result<File, String>;
}

/// A table being written, in one form or several at once.
pub struct TableWriter {
    columns: usize,
    files: Vec<Draft>,
}

/// A file that does not have its name yet.
struct Draft {
    path: PathBuf,
    named: NamedTempFile,
    rows: Box<dyn Rows>,
}

impl TableWriter {
    /// Begins a table in a folder.
    ///
    /// # Errors
    /// [`Error::Output`] if the folder cannot be written into.
    pub fn new(folder: &Path, schema: &Schema, forms: &[Form]) -> Result<Self> {
        let draft = |&form: &Form| -> Result<Draft> {
            let path = folder.join(format!("{}.{}", schema.name, form.ending()));
            let named = tempfile::Builder::new()
                .prefix(&format!(".{}-", schema.name))
                .suffix(".part")
                .tempfile_in(folder)
                .map_err(Error::output(folder))?;
            let file = named.reopen().map_err(Error::output(folder))?;
            let rows: Box<dyn Rows> = match form {
                Form::Parquet => Box::new(ParquetTable::new(file, schema).map_err(failed(&path))?),
                Form::Csv => Box::new(CsvTable::new(file, schema).map_err(failed(&path))?),
                Form::JsonLines => Box::new(JsonTable::new(file, schema)),
            };
            Ok(Draft { path, named, rows })
        };
        Ok(Self {
            columns: schema.columns.len(),
            files: forms.iter().map(draft).collect::<Result<_>>()?,
        })
    }

    /// Writes a row, one cell for each column.
    ///
    /// # Errors
    /// [`Error::Table`] if it does not fit the columns or the disk.
    pub fn row(&mut self, row: &[Cell]) -> Result<()> {
        for draft in &mut self.files {
            let problem = if row.len() == self.columns {
                draft.rows.row(row)
            } else {
                Err(format!("{} cells for {} columns", row.len(), self.columns))
            };
            problem.map_err(failed(&draft.path))?;
        }
        Ok(())
    }

    /// Completes the table and gives its files their names; returns them.
    ///
    /// # Errors
    /// [`Error::Table`] or [`Error::Output`] if the disk is full; no file has its name then that is
    /// not whole.
    pub fn finish(self) -> Result<Vec<PathBuf>> {
        let mut whole = Vec::new();
        for Draft { path, named, rows } in self.files {
            let file = rows.finish().map_err(failed(&path))?;
            file.sync_all().map_err(Error::output(&path))?;
            whole.push((path, named));
        }
        whole
            .into_iter()
            .map(|(path, named)| {
                readable(&named).map_err(Error::output(&path))?;
                named
                    .persist(&path)
                    .map_err(|fault| Error::output(&path)(fault.error))?;
                Ok(path)
            })
            .collect()
    }
}

/// Temporary files are for their owner alone, tables are as any other file.
#[cfg(unix)]
pub(crate) fn readable(named: &NamedTempFile) -> std::io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    named
        .as_file()
        .set_permissions(std::fs::Permissions::from_mode(0o644))
}

#[cfg(not(unix))]
pub(crate) fn readable(_named: &NamedTempFile) -> std::io::Result<()> {
    Ok(())
}

/// Writes a file whole: under another name, then under its own.
///
/// # Errors
/// [`Error::Output`] if that fails; a file of that name is then as it was before.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<()> {
    use std::io::Write as _;
    let folder = path
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty());
    let write = || -> std::io::Result<()> {
        let mut named = tempfile::Builder::new()
            .prefix(".")
            .suffix(".part")
            .tempfile_in(folder.unwrap_or(Path::new(".")))?;
        named.write_all(bytes)?;
        named.as_file().sync_all()?;
        readable(&named)?;
        named.persist(path)?;
        Ok(())
    };
    write().map_err(Error::output(path))
}

/// Removes the drafts that a killed run left in a folder. Nobody else may be writing there.
///
/// # Errors
/// [`Error::Output`] if the folder cannot be read or a draft not be removed.
pub fn remove_drafts(folder: &Path) -> Result<()> {
    let entries = std::fs::read_dir(folder).map_err(Error::output(folder))?;
    for entry in entries {
        let entry = entry.map_err(Error::output(folder))?;
        let name = entry.file_name();
        let name = name.as_encoded_bytes();
        if name.starts_with(b".") && name.ends_with(b".part") {
            std::fs::remove_file(entry.path()).map_err(Error::output(folder))?;
        }
    }
    Ok(())
}

fn failed(path: &Path) -> impl FnOnce(String) -> Error {
    let path = path.to_owned();
    |problem| Error::Table { path, problem }
}
