//! Tables as text.

use std::fs::File;
use std::io::{BufWriter, Write};

use bouncelab_report::csv::guarded;
use serde::Serializer;
use serde_json::Value;

use super::{Cell, Rows, Schema};

/// Comma-separated values.
pub(super) struct CsvTable {
    writer: csv::Writer<File>,
    is_raw: bool,
}

impl CsvTable {
    /// A raw table has texts as they are, even those that a spreadsheet would run.
    pub(super) fn new(file: File, schema: &Schema, is_raw: bool) -> Result<Self, String> {
        let mut writer = csv::Writer::from_writer(file);
        let names = schema.columns.iter().map(|column| column.name.clone());
        let header = names.map(|name| if is_raw { name } else { guarded(name) });
        writer
            .write_record(header)
            .map_err(|fault| fault.to_string())?;
        Ok(Self { writer, is_raw })
    }
}

impl Rows for CsvTable {
    fn row(&mut self, row: &[Cell]) -> Result<(), String> {
        let known = |cell: &Cell| match cell {
            Cell::Text(text) if self.is_raw => text.clone(),
            Cell::Text(text) => text.clone().map(guarded),
            Cell::Number(number) => number
                .filter(|number| number.is_finite())
                .map(|number| number.to_string()),
            Cell::Count(count) => count.map(|count| count.to_string()),
            Cell::Flag(flag) => flag.map(|flag| flag.to_string()),
        };
        let cells = row.iter().map(|cell| known(cell).unwrap_or_default());
        self.writer
            .write_record(cells)
            .map_err(|fault| fault.to_string())
    }

    fn finish(mut self: Box<Self>) -> Result<(), String> {
        self.writer.flush().map_err(|fault| fault.to_string())
    }
}

/// One JSON object a line.
pub(super) struct JsonTable {
    names: Vec<String>,
    writer: BufWriter<File>,
}

impl JsonTable {
    pub(super) fn new(file: File, schema: &Schema) -> Self {
        Self {
            names: schema.columns.iter().map(|c| c.name.clone()).collect(),
            writer: BufWriter::new(file),
        }
    }
}

impl Rows for JsonTable {
    fn row(&mut self, row: &[Cell]) -> Result<(), String> {
        let cells = std::iter::zip(&self.names, row).map(|(name, cell)| {
            let value = match cell {
                Cell::Text(text) => Value::from(text.as_deref()),
                // What is not finite becomes null.
                Cell::Number(number) => Value::from(*number),
                Cell::Count(count) => Value::from(*count),
                Cell::Flag(flag) => Value::from(*flag),
            };
            (name, value)
        });
        // As a map of its own the object would be sorted by name.
        let mut object = serde_json::Serializer::new(&mut self.writer);
        object
            .collect_map(cells)
            .map_err(|fault| fault.to_string())?;
        writeln!(self.writer).map_err(|fault| fault.to_string())
    }

    fn finish(mut self: Box<Self>) -> Result<(), String> {
        self.writer.flush().map_err(|fault| fault.to_string())
    }
}
