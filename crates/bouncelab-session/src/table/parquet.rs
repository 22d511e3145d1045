//! Tables as Parquet: the only module that uses the Parquet library.
//!
//! Its plain column writers are enough, so that Arrow stays out.

use std::fs::File;
use std::sync::Arc;

use parquet::basic::{Compression, ConvertedType, LogicalType, Repetition, Type as Physical};
use parquet::data_type::{BoolType, ByteArray, ByteArrayType, DoubleType, Int64Type};
use parquet::errors::ParquetError;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedFileWriter, SerializedRowGroupWriter};
use parquet::schema::types::{Type, TypePtr};

use super::{Cell, Column, Kind, Rows, Schema};

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
            (!text.is_empty()).then(|| (column.name.clone(), serde_json::Value::from(text)))
        });
        serde_json::Value::Object(entries.collect()).to_string()
    };
    [
        ("bouncelab.schema", schema.schema.to_owned()),
        ("bouncelab.version", schema.version.to_owned()),
        (
            "bouncelab.units",
            of_columns(&|column| column.unit.to_owned()),
        ),
        (
            "bouncelab.about",
            of_columns(&|column| column.about.clone()),
        ),
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
    let mut writer = group
        .next_column()?
        .ok_or_else(|| ParquetError::General("too many columns".to_owned()))?;
    match kind {
        Kind::Text => {
            let (values, known) = split(cells, |cell| match cell {
                Cell::Text(text) => text.as_deref().map(ByteArray::from),
                _ => None,
            });
            let column = writer.typed::<ByteArrayType>();
            column.write_batch(&values, Some(&known), None)?;
        }
        Kind::Number => {
            let (values, known) = split(cells, |cell| match cell {
                Cell::Number(number) => number.filter(|number| number.is_finite()),
                _ => None,
            });
            let column = writer.typed::<DoubleType>();
            column.write_batch(&values, Some(&known), None)?;
        }
        Kind::Count => {
            let (values, known) = split(cells, |cell| match cell {
                Cell::Count(count) => count.and_then(|count| i64::try_from(count).ok()),
                _ => None,
            });
            let column = writer.typed::<Int64Type>();
            column.write_batch(&values, Some(&known), None)?;
        }
        Kind::Flag => {
            let (values, known) = split(cells, |cell| match cell {
                Cell::Flag(flag) => *flag,
                _ => None,
            });
            let column = writer.typed::<BoolType>();
            column.write_batch(&values, Some(&known), None)?;
        }
    }
    writer.close()
}

/// The values that are known, and for each cell whether it is one (its definition level).
fn split<T>(cells: &[Cell], value: impl Fn(&Cell) -> Option<T>) -> (Vec<T>, Vec<i16>) {
    let all: Vec<Option<T>> = cells.iter().map(value).collect();
    let known = all.iter().map(|value| i16::from(value.is_some())).collect();
    (all.into_iter().flatten().collect(), known)
}
