//! Tables as Parquet: the only module that uses the Parquet library.
//!
//! Its plain column writers are enough, so that Arrow stays out.

use std::fs::File;
use std::sync::Arc;

use bouncelab_report::data_table::{Cell, Column, Kind};
use parquet::basic::{Compression, ConvertedType, LogicalType, Repetition, Type as Physical};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{
    SerializedColumnWriter, SerializedFileWriter, SerializedRowGroupWriter,
};
use parquet::schema::types::{Type, TypePtr};

use super::{Rows, Schema};

/// Rows that are held back and written together: a few megabytes.
const GROUP: usize = 4096;

pub(super) struct ParquetTable {
    columns: Vec<Column>,
    writer: SerializedFileWriter<File>,
    /// Cells by column.
    held: Vec<Vec<Cell>>,
}

impl ParquetTable {
    pub(super) fn new(file: File, schema: &Schema) -> Result<Self, String> {
        let properties = WriterProperties::builder()
            .set_compression(Compression::SNAPPY)
            .set_created_by(format!("bouncelab {}", schema.version))
            .set_key_value_metadata(Some(metadata(schema)))
            .build();
        let columns = message(schema).map_err(|fault| said(&fault))?;
        let writer = SerializedFileWriter::new(file, columns, Arc::new(properties))
            .map_err(|fault| said(&fault))?;
        Ok(Self {
            held: vec![Vec::new(); schema.columns.len()],
            columns: schema.columns.clone(),
            writer,
        })
    }

    /// Writes the rows that were held back.
    fn flush(&mut self) -> Result<(), ParquetError> {
        let mut group = self.writer.next_row_group()?;
        for (column, cells) in self.columns.iter().zip(&mut self.held) {
            write_column(&mut group, column.kind, cells)?;
            cells.clear();
        }
        group.close()?;
        Ok(())
    }

    fn rows_held(&self) -> usize {
        self.held.first().map_or(0, Vec::len)
    }
}

impl Rows for ParquetTable {
    fn row(&mut self, row: &[Cell]) -> Result<(), String> {
        for (held, cell) in self.held.iter_mut().zip(row) {
            held.push(cell.clone());
        }
        if self.rows_held() >= GROUP {
            self.flush().map_err(|fault| said(&fault))?;
        }
        Ok(())
    }

    fn finish(mut self: Box<Self>) -> Result<(), String> {
        if self.rows_held() > 0 {
            self.flush().map_err(|fault| said(&fault))?;
        }
        self.writer.finish().map_err(|fault| said(&fault))?;
        Ok(())
    }
}

fn said(fault: &ParquetError) -> String {
    fault.to_string()
}

/// Schema, program, and the unit and meaning of every column.
fn metadata(schema: &Schema) -> Vec<KeyValue> {
    let of_columns = |text: &dyn Fn(&Column) -> String| {
        let entries = schema.columns.iter().filter_map(|column| {
            let text = text(column);
            (!text.is_empty()).then(|| (column.name.to_string(), serde_json::Value::from(text)))
        });
        serde_json::Value::Object(entries.collect()).to_string()
    };
    [
        (
            "bouncelab.units",
            of_columns(&|column| column.unit.to_string()),
        ),
        (
            "bouncelab.about",
            of_columns(&|column| column.about.to_string()),
        ),
        // Last, so that it stands near the end: it marks a file as ours.
        ("bouncelab.schema", schema.schema.to_owned()),
        ("bouncelab.version", schema.version.to_owned()),
    ]
    .map(|(key, value)| KeyValue::new(key.to_owned(), Some(value)))
    .into()
}

fn message(schema: &Schema) -> Result<TypePtr, ParquetError> {
    let fields = schema.columns.iter().map(|column| {
        let physical = match column.kind {
            Kind::Text => Physical::BYTE_ARRAY,
            Kind::Number => Physical::DOUBLE,
            Kind::Count => Physical::INT64,
            Kind::Flag => Physical::BOOLEAN,
        };
        let field = Type::primitive_type_builder(&column.name, physical)
            .with_repetition(Repetition::OPTIONAL);
        let field = match column.kind {
            Kind::Text => field
                .with_logical_type(Some(LogicalType::String))
                .with_converted_type(ConvertedType::UTF8),
            Kind::Number | Kind::Count | Kind::Flag => field,
        };
        field.build().map(Arc::new)
    });
    let fields = fields.collect::<Result<Vec<_>, _>>()?;
    Type::group_type_builder(schema.name)
        .with_fields(fields)
        .build()
        .map(Arc::new)
}

fn write_column(
    group: &mut SerializedRowGroupWriter<'_, File>,
    kind: Kind,
    cells: &[Cell],
) -> Result<(), ParquetError> {
    let mut column = group
        .next_column()?
        .ok_or_else(|| ParquetError::General("too many columns".to_owned()))?;
    let writer = &mut column;
    match kind {
        Kind::Text => {
            write::<ByteArrayType>(writer, cells, |cell| cell.text().map(ByteArray::from))
        }
        Kind::Number => write::<DoubleType>(writer, cells, Cell::number),
        Kind::Count => write::<Int64Type>(writer, cells, Cell::count),
        Kind::Flag => write::<BoolType>(writer, cells, Cell::flag),
    }?;
    column.close()
}

/// Writes the values that are known, and for each cell whether it is one (its definition level).
fn write<T: DataType>(
    column: &mut SerializedColumnWriter<'_>,
    cells: &[Cell],
    value: fn(&Cell) -> Option<T::T>,
) -> Result<usize, ParquetError> {
    let all: Vec<Option<T::T>> = cells.iter().map(value).collect();
    let known: Vec<i16> = all.iter().map(|value| i16::from(value.is_some())).collect();
    let values: Vec<T::T> = all.into_iter().flatten().collect();
    column.typed::<T>().write_batch(&values, Some(&known), None)
}
