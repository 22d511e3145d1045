//! Tables as text.

use std::fs::File;
use std::io::{BufWriter, Write};

use bouncelab_report::data_table::{Cell, Formulas};
use serde::Serializer;
use serde_json::Value;

use super::{Rows, Schema};

/// Comma-separated values.
pub(super) struct CsvTable {
    writer: BufWriter<File>,
    formulas: Formulas,
}

impl CsvTable {
    pub(super) fn new(file: File, schema: &Schema, formulas: Formulas) -> Result<Self, String> {
        let mut table = Self {
            writer: BufWriter::new(file),
            formulas,
        };
        table.write(&formulas.header(&schema.columns))?;
        Ok(table)
    }

    fn write(&mut self, line: &str) -> Result<(), String> {
        let written = self.writer.write_all(line.as_bytes());
        written.map_err(|fault| fault.to_string())
    }
}

impl Rows for CsvTable {
    fn row(&mut self, row: &[Cell]) -> Result<(), String> {
        self.write(&self.formulas.line(row))
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
            names: schema.columns.iter().map(|c| c.name.to_string()).collect(),
            writer: BufWriter::new(file),
        }
    }
}

impl Rows for JsonTable {
    fn row(&mut self, row: &[Cell]) -> Result<(), String> {
        let cells = std::iter::zip(&self.names, row).map(|(name, cell)| {
            let value = match cell {
                Cell::Text(_) => Value::from(cell.text()),
                Cell::Number(_) => Value::from(cell.number()),
                Cell::Count(_) => Value::from(cell.count()),
                Cell::Flag(_) => Value::from(cell.flag()),
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
