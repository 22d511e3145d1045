//! Tables in three formats: Parquet, CSV and JSON lines.
//!
//! A table has columns with a type, a unit and a sentence of meaning; rows are written as they come,
//! so that a table of any length takes little memory. Each file is written under another name and
//! given its own when it is whole.

mod parquet;
mod text;

use std::fmt;
use std::path::{Path, PathBuf};

use bouncelab_report::data_table::{Cell, Column, Formulas};
use bouncelab_report::file::{Draft, Outputs};
use bouncelab_report::mark::Mark;

use crate::error::{Error, Result};
use parquet::ParquetTable;
use text::{CsvTable, JsonTable};

/// What a table is: its name, schema and columns.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Schema {
    /// The name of its files, without ending.
    pub name: &'static str,
    /// Name and version of the schema, as in "bouncelab.drops/2".
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
    Csv(Formulas),
    /// One JSON object a line.
    JsonLines,
}

impl Form {
    /// Every form; formulas in CSV are guarded.
    pub const ALL: [Self; 3] = [Self::Parquet, Self::Csv(Formulas::Guarded), Self::JsonLines];

    /// How names of its files end.
    pub const fn ending(self) -> &'static str {
        match self {
            Self::Parquet => "parquet",
            Self::Csv(_) => "csv",
            Self::JsonLines => "jsonl",
        }
    }

    /// The file of a table in a folder.
    pub fn path(self, folder: &Path, table: &str) -> PathBuf {
        folder.join(format!("{table}.{}", self.ending()))
    }

    /// The mark of every table of a session, by which it is known to be one.
    pub const fn mark(self) -> Mark {
        match self {
            Self::Parquet => Mark::first("PAR1").and_near_an_end("bouncelab.schema"),
            Self::Csv(_) => {
                Mark::first("recording,drop,").and_near_an_end(",restitution,restitution_sd,")
            }
            Self::JsonLines => {
                Mark::first("{\"recording\":").and_near_an_end(",\"restitution_sd\":")
            }
        }
    }
}

/// A form of table as it is written.
trait Rows {
    fn row(&mut self, row: &[Cell]) -> std::result::Result<(), String>;
    /// Writes what is left.
    fn finish(self: Box<Self>) -> std::result::Result<(), String>;
}

/// A table being written, in one form or several at once.
#[expect(missing_debug_implementations, reason = "open files show nothing")]
pub struct TableWriter {
    columns: usize,
    files: Vec<InForm>,
}

/// A table in one form.
struct InForm {
    path: PathBuf,
    draft: Draft,
    rows: Box<dyn Rows>,
}

impl fmt::Debug for InForm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("InForm")
            .field("path", &self.path)
            .finish_non_exhaustive()
    }
}

impl TableWriter {
    /// Begins a table in a folder.
    ///
    /// # Errors
    /// [`Error::Output`] if the folder cannot be written into, or a file there may not be replaced.
    pub fn new(folder: &Path, schema: &Schema, forms: &[Form], outputs: &Outputs) -> Result<Self> {
        let in_form = |&form: &Form| -> Result<InForm> {
            let path = form.path(folder, schema.name);
            let draft = outputs
                .draft(&path, form.mark())
                .map_err(Error::output(&path))?;
            let file = draft.file().try_clone().map_err(Error::output(&path))?;
            let rows: Box<dyn Rows> = match form {
                Form::Parquet => Box::new(ParquetTable::new(file, schema).map_err(failed(&path))?),
                Form::Csv(formulas) => {
                    Box::new(CsvTable::new(file, schema, formulas).map_err(failed(&path))?)
                }
                Form::JsonLines => Box::new(JsonTable::new(file, schema)),
            };
            Ok(InForm { path, draft, rows })
        };
        Ok(Self {
            columns: schema.columns.len(),
            files: forms.iter().map(in_form).collect::<Result<_>>()?,
        })
    }

    /// Writes a row, one cell for each column.
    ///
    /// # Errors
    /// [`Error::Table`] if it does not fit the columns or the disk.
    pub fn row(&mut self, row: &[Cell]) -> Result<()> {
        for table in &mut self.files {
            let problem = if row.len() == self.columns {
                table.rows.row(row)
            } else {
                Err(format!("{} cells for {} columns", row.len(), self.columns))
            };
            problem.map_err(failed(&table.path))?;
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
        for InForm { path, draft, rows } in self.files {
            rows.finish().map_err(failed(&path))?;
            whole.push((path, draft));
        }
        whole
            .into_iter()
            .map(|(path, draft)| {
                draft.finish().map_err(Error::output(&path))?;
                Ok(path)
            })
            .collect()
    }
}

fn failed(path: &Path) -> impl FnOnce(String) -> Error {
    let path = path.to_owned();
    |problem| Error::Table { path, problem }
}
