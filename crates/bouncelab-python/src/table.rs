//! How does a table cross over?

use std::collections::HashMap;
use std::sync::Arc;

use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::{
    ArrayRef, BooleanArray, Float64Array, Int64Array, RecordBatch, RecordBatchIterator,
    RecordBatchOptions, StringArray,
};
use arrow_schema::{DataType, Field, Schema};
use bouncelab_report::data_table::{Cell, Column, DataTable, Kind};
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyCapsule, PyList};

use crate::failure::{Failure, Result};

/// A table, which Python reads by columns, and other programs as Arrow.
#[pyclass(frozen, module = "bouncelab._core")]
pub(crate) struct Table(pub(crate) DataTable);

#[pymethods]
impl Table {
    /// A table from what `packed` gives.
    #[new]
    fn from_packed(packed: &[u8]) -> Result<Self> {
        let table = postcard::from_bytes(packed);
        table
            .map(Self)
            .map_err(|fault| Failure::Input(fault.to_string()))
    }

    fn __getnewargs__<'py>(&self, py: Python<'py>) -> Result<(Bound<'py, PyBytes>,)> {
        Ok((self.packed(py)?,))
    }

    /// The table as bytes: those of equal tables are equal.
    fn packed<'py>(&self, py: Python<'py>) -> Result<Bound<'py, PyBytes>> {
        let bytes = postcard::to_allocvec(&self.0);
        let bytes = bytes.map_err(|fault| Failure::Input(fault.to_string()))?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// The number of rows.
    fn rows(&self) -> usize {
        self.0.rows.len()
    }

    /// Name, unit and meaning of each column.
    fn about(&self) -> Vec<[&str; 3]> {
        let columns = self.0.columns.iter();
        columns
            .map(|it| [&*it.name, &*it.unit, &*it.about])
            .collect()
    }

    /// A column: the type of an array of `NumPy` that holds it, and its values, with `None` for what is not known.
    fn column<'py>(
        &self,
        py: Python<'py>,
        name: &str,
    ) -> PyResult<(&'static str, Bound<'py, PyList>)> {
        let mut columns = self.0.columns.iter();
        let index = columns
            .position(|it| it.name == name)
            .ok_or_else(|| PyKeyError::new_err(name.to_owned()))?;
        let cells = self.0.rows.iter().map(|row| &row[index]);
        let is_whole = cells.clone().all(|cell| !cell.is_empty());
        let values =
            |dtype, list: PyResult<_>| Ok((if is_whole { dtype } else { "object" }, list?));
        match self.0.columns[index].kind {
            // An array of numbers has NaN for what is not known.
            Kind::Number => Ok(("float64", PyList::new(py, collect(cells, Cell::number))?)),
            Kind::Count => values("int64", PyList::new(py, collect(cells, Cell::count))),
            Kind::Flag => values("bool", PyList::new(py, collect(cells, Cell::flag))),
            Kind::Text => values("object", PyList::new(py, collect(cells, Cell::text))),
        }
    }

    /// The stream of Arrow, for whoever reads it.
    #[pyo3(signature = (requested_schema = None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        Arrow(arrow(&self.0)?).__arrow_c_stream__(py, requested_schema)
    }
}

/// A table of Arrow, which other programs read.
#[pyclass(frozen, module = "bouncelab._core")]
pub(crate) struct Arrow(pub(crate) RecordBatch);

#[pymethods]
impl Arrow {
    /// The stream of Arrow.
    #[pyo3(signature = (requested_schema = None))]
    fn __arrow_c_stream__<'py>(
        &self,
        py: Python<'py>,
        requested_schema: Option<Py<PyAny>>,
    ) -> PyResult<Bound<'py, PyCapsule>> {
        // A producer may leave a request aside, as the interface says.
        drop(requested_schema);
        let batches = std::iter::once(Ok(self.0.clone()));
        let reader = RecordBatchIterator::new(batches, self.0.schema());
        let stream = FFI_ArrowArrayStream::new(Box::new(reader));
        PyCapsule::new_with_value(py, stream, c"arrow_array_stream")
    }
}

/// A table as Arrow; unit and meaning are metadata of its fields.
pub(crate) fn arrow(table: &DataTable) -> Result<RecordBatch> {
    let fields: Vec<Field> = table.columns.iter().map(field).collect();
    let arrays = table.columns.iter().enumerate();
    let arrays = arrays.map(|(index, column)| {
        let cells = table.rows.iter().map(|row| &row[index]);
        array(column.kind, cells)
    });
    let options = RecordBatchOptions::new().with_row_count(Some(table.rows.len()));
    let schema = Arc::new(Schema::new(fields));
    RecordBatch::try_new_with_options(schema, arrays.collect(), &options)
        .map_err(|fault| Failure::Input(fault.to_string()))
}

fn field(column: &Column) -> Field {
    let kind = match column.kind {
        Kind::Number => DataType::Float64,
        Kind::Count => DataType::Int64,
        Kind::Flag => DataType::Boolean,
        Kind::Text => DataType::Utf8,
    };
    let about = [("unit", &column.unit), ("about", &column.about)];
    let about = about.map(|(key, value)| (key.to_owned(), value.to_string()));
    Field::new(&*column.name, kind, true).with_metadata(HashMap::from(about))
}

fn array<'a>(kind: Kind, cells: impl Iterator<Item = &'a Cell>) -> ArrayRef {
    match kind {
        Kind::Number => Arc::new(Float64Array::from(collect(cells, Cell::number))),
        Kind::Count => Arc::new(Int64Array::from(collect(cells, Cell::count))),
        Kind::Flag => Arc::new(BooleanArray::from(collect(cells, Cell::flag))),
        Kind::Text => Arc::new(StringArray::from(collect(cells, Cell::text))),
    }
}

fn collect<'a, T>(
    cells: impl Iterator<Item = &'a Cell>,
    value: fn(&'a Cell) -> Option<T>,
) -> Vec<Option<T>> {
    cells.map(value).collect()
}
