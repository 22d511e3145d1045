//! How does a table cross over?

use std::collections::HashMap;
use std::sync::Arc;

use arrow_array::ffi_stream::FFI_ArrowArrayStream;
use arrow_array::{
    Array, ArrayRef, BooleanArray, Float64Array, Int64Array, RecordBatch, RecordBatchIterator,
    StringArray,
};
use arrow_schema::{DataType, Field, Schema};
use bouncelab::flight::{Fall, Flight};
use bouncelab::synth::{Rendered, SynthImpact};
use bouncelab_report::chart::Row;
use bouncelab_report::document::simulation::{Bounce, Run};
use bouncelab_session::table::{Cell, Kind, Table as Rows};
use pyo3::exceptions::PyKeyError;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyCapsule, PyList};
use serde::{Deserialize, Serialize};

use crate::failure::{Failure, Result};

/// A table of Arrow.
#[pyclass(frozen, module = "bouncelab._core")]
pub(crate) struct Table(pub(crate) RecordBatch);

/// A column as data: what a pickle holds.
#[derive(Serialize, Deserialize)]
struct Column {
    name: String,
    unit: String,
    about: String,
    values: Values,
}

#[derive(Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
enum Values {
    Numbers(Vec<Option<f64>>),
    Counts(Vec<Option<i64>>),
    Flags(Vec<Option<bool>>),
    Texts(Vec<Option<String>>),
}

impl Values {
    /// Keeps the values at some places.
    fn keep(&mut self, is_kept: impl Fn(usize) -> bool) {
        fn keep<T>(values: &mut Vec<T>, is_kept: impl Fn(usize) -> bool) {
            let mut places = 0..;
            values.retain(|_| places.next().is_some_and(&is_kept));
        }
        match self {
            Self::Numbers(values) => keep(values, is_kept),
            Self::Counts(values) => keep(values, is_kept),
            Self::Flags(values) => keep(values, is_kept),
            Self::Texts(values) => keep(values, is_kept),
        }
    }
}

impl Column {
    fn field(&self) -> Field {
        let kind = match &self.values {
            Values::Numbers(_) => DataType::Float64,
            Values::Counts(_) => DataType::Int64,
            Values::Flags(_) => DataType::Boolean,
            Values::Texts(_) => DataType::Utf8,
        };
        let about = [("unit", &self.unit), ("about", &self.about)];
        let about = about.map(|(key, value)| (key.to_owned(), value.clone()));
        Field::new(&self.name, kind, true).with_metadata(HashMap::from(about))
    }

    fn array(self) -> ArrayRef {
        match self.values {
            Values::Numbers(values) => Arc::new(Float64Array::from(values)),
            Values::Counts(values) => Arc::new(Int64Array::from(values)),
            Values::Flags(values) => Arc::new(BooleanArray::from(values)),
            Values::Texts(values) => Arc::new(StringArray::from(values)),
        }
    }

    fn of(field: &Field, array: &ArrayRef) -> Self {
        let about = |key: &str| field.metadata().get(key).cloned().unwrap_or_default();
        let any = array.as_any();
        let values = if let Some(numbers) = any.downcast_ref::<Float64Array>() {
            Values::Numbers(numbers.iter().collect())
        } else if let Some(counts) = any.downcast_ref::<Int64Array>() {
            Values::Counts(counts.iter().collect())
        } else if let Some(flags) = any.downcast_ref::<BooleanArray>() {
            Values::Flags(flags.iter().collect())
        } else {
            let texts = any.downcast_ref::<StringArray>();
            let owned = |text: Option<&str>| text.map(str::to_owned);
            Values::Texts(texts.map_or_else(Vec::new, |texts| texts.iter().map(owned).collect()))
        };
        Self {
            name: field.name().clone(),
            unit: about("unit"),
            about: about("about"),
            values,
        }
    }
}

impl Table {
    fn of_columns(columns: Vec<Column>) -> Result<Self> {
        let fields: Vec<Field> = columns.iter().map(Column::field).collect();
        let arrays = columns.into_iter().map(Column::array).collect();
        RecordBatch::try_new(Arc::new(Schema::new(fields)), arrays)
            .map(Self)
            .map_err(|fault| Failure::Input(fault.to_string()))
    }

    pub(crate) fn of(table: &Rows) -> Result<Self> {
        let columns = table.schema.columns.iter().enumerate();
        let columns = columns.map(|(place, column)| {
            let cells = table.rows.iter().map(|row| &row[place]);
            Column {
                name: column.name.clone(),
                unit: column.unit.to_owned(),
                about: column.about.clone(),
                values: values(column.kind, cells),
            }
        });
        Self::of_columns(columns.collect())
    }

    /// A table of columns of numbers, each with its name, unit and meaning.
    pub(crate) fn of_numbers<'a>(
        columns: impl IntoIterator<Item = ([&'a str; 3], Vec<Option<f64>>)>,
    ) -> Result<Self> {
        let columns = columns
            .into_iter()
            .map(|([name, unit, about], values)| Column {
                name: name.to_owned(),
                unit: unit.to_owned(),
                about: about.to_owned(),
                values: Values::Numbers(values),
            });
        Self::of_columns(columns.collect())
    }

    /// Flights.
    pub(crate) fn of_flights(flights: &[Flight]) -> Result<Self> {
        let column = |of: fn(&Flight) -> f64| flights.iter().map(of).map(Some).collect();
        Self::of_numbers([
            (
                [
                    "launch_speed_m_s",
                    "m/s",
                    "speed after the impact before it",
                ],
                column(|it| it.launch_speed_m_s),
            ),
            (
                [
                    "impact_speed_m_s",
                    "m/s",
                    "speed before the impact after it",
                ],
                column(|it| it.impact_speed_m_s),
            ),
            (["apex_m", "m", "greatest height"], column(|it| it.apex_m)),
            (
                ["rise_time_s", "s", "time up to the apex"],
                column(|it| it.rise_time_s),
            ),
            (
                ["fall_time_s", "s", "time down from the apex"],
                column(|it| it.fall_time_s),
            ),
            (
                ["flight_time_s", "s", "time between the impacts"],
                column(Flight::time_s),
            ),
        ])
    }

    /// Falls from rest.
    pub(crate) fn of_falls(falls: &[Fall]) -> Result<Self> {
        let column = |of: fn(&Fall) -> f64| falls.iter().map(of).map(Some).collect();
        Self::of_numbers([
            (
                ["height_m", "m", "height of the release"],
                column(|it| it.height_m),
            ),
            (
                ["fall_time_s", "s", "time from the release to the impact"],
                column(|it| it.time_s),
            ),
            (
                ["impact_speed_m_s", "m/s", "speed before the impact"],
                column(|it| it.impact_speed_m_s),
            ),
        ])
    }

    /// The bounces of a simulated drop.
    pub(crate) fn of_bounces(run: &Run) -> Result<Self> {
        let bounces: Vec<Bounce> = run.bounces().collect();
        let column = |of: fn(&Bounce) -> f64| bounces.iter().map(of).map(Some).collect();
        Self::of_numbers([
            (
                ["time_s", "s", "time of the impact"],
                column(|it| it.time_s),
            ),
            (
                ["impact_speed_m_s", "m/s", "speed before it"],
                column(|it| it.impact_speed_m_s),
            ),
            (
                ["restitution", "", "speed after over speed before"],
                column(|it| it.restitution),
            ),
            (
                ["launch_speed_m_s", "m/s", "speed after it"],
                column(|it| it.launch_speed_m_s),
            ),
            (
                ["flight_time_s", "s", "time until the next impact"],
                column(|it| it.flight_time_s),
            ),
            (
                ["apex_m", "m", "apex of the flight after it"],
                column(|it| it.apex_m),
            ),
            (
                ["lost_to_surface_j", "J", "energy that the surface took"],
                column(|it| it.lost_to_surface_j),
            ),
            (
                ["lost_to_air_j", "J", "energy that the air took after it"],
                column(|it| it.lost_to_air_j),
            ),
        ])
    }

    /// The true impacts of a synthesised recording.
    pub(crate) fn of_truth(sound: &Rendered) -> Result<Self> {
        let column = |of: fn(&SynthImpact) -> f64| sound.impacts.iter().map(of).map(Some).collect();
        Self::of_numbers([
            (
                ["time_s", "s", "time of the impact in the recording"],
                column(|it| it.time_s),
            ),
            (
                ["impact_speed_m_s", "m/s", "speed before it"],
                column(|it| it.speed_m_s),
            ),
            (
                ["snr_db", "dB", "level above the noise"],
                column(|it| it.snr_db),
            ),
            (
                ["lost", "", "1 if it was left out of the sound"],
                column(|it| f64::from(it.lost)),
            ),
        ])
    }

    /// The data of a chart.
    pub(crate) fn of_rows(rows: &[Row]) -> Result<Self> {
        let column = |name: &str, about: &str, values| Column {
            name: name.to_owned(),
            unit: String::new(),
            about: about.to_owned(),
            values,
        };
        let numbers = |of: fn(&Row) -> Option<f64>| Values::Numbers(rows.iter().map(of).collect());
        let texts = |of: fn(&Row) -> Option<String>| Values::Texts(rows.iter().map(of).collect());
        let panels = rows.iter().map(|row| i64::try_from(row.panel).ok());
        Self::of_columns(vec![
            column("panel", "panel, from 0", Values::Counts(panels.collect())),
            column(
                "layer",
                "name in the legend",
                texts(|row| Some(row.layer.clone())),
            ),
            column("kind", "what it is", texts(|row| Some(row.kind.to_owned()))),
            column("x", "horizontal value, or left end", numbers(|row| row.x)),
            column("x_high", "right end of a box", numbers(|row| row.x_high)),
            column("y", "vertical value, or lower end", numbers(|row| row.y)),
            column(
                "y_high",
                "upper end of a band or a box",
                numbers(|row| row.y_high),
            ),
            column(
                "y_sd",
                "standard error of the vertical value",
                numbers(|row| row.y_sd),
            ),
            column("text", "text at a point", texts(|row| row.text.clone())),
        ])
    }

    fn columns(&self) -> Vec<Column> {
        let schema = self.0.schema();
        let fields = schema.fields().iter().zip(self.0.columns());
        fields
            .map(|(field, array)| Column::of(field, array))
            .collect()
    }
}

/// The cells of a column; one of another kind is empty, as is a number that is not finite.
fn values<'a>(kind: Kind, cells: impl Iterator<Item = &'a Cell>) -> Values {
    macro_rules! of {
        ($kind:ident, $known:expr) => {
            cells
                .map(|cell| match cell {
                    Cell::$kind(value) => value.clone().and_then($known),
                    _ => None,
                })
                .collect()
        };
    }
    match kind {
        Kind::Number => Values::Numbers(of!(Number, |value| Some(value).filter(|v| v.is_finite()))),
        Kind::Count => Values::Counts(of!(Count, |value| i64::try_from(value).ok())),
        Kind::Flag => Values::Flags(of!(Flag, Some)),
        Kind::Text => Values::Texts(of!(Text, Some)),
    }
}

#[pymethods]
impl Table {
    /// A table from what `json` gives.
    #[new]
    fn from_json(json: &str) -> Result<Self> {
        Self::of_columns(serde_json::from_str(json)?)
    }

    fn __getnewargs__(&self) -> Result<(String,)> {
        Ok((self.json()?,))
    }

    /// The rows of one drop, without the column that names it.
    fn of_drop(&self, number: i64) -> Result<Self> {
        let mut columns = self.columns();
        let Values::Counts(drops) = columns.remove(0).values else {
            return Err(Failure::Input("the table names no drop".to_owned()));
        };
        let is_own = |place: usize| drops[place] == Some(number);
        for column in &mut columns {
            column.values.keep(is_own);
        }
        Self::of_columns(columns)
    }

    /// The columns as data.
    fn json(&self) -> Result<String> {
        Ok(serde_json::to_string(&self.columns())?)
    }

    /// How many rows there are.
    fn rows(&self) -> usize {
        self.0.num_rows()
    }

    /// Name, unit and meaning of each column.
    fn about(&self) -> Vec<(String, String, String)> {
        let columns = self.columns().into_iter();
        columns.map(|it| (it.name, it.unit, it.about)).collect()
    }

    /// The values of a column: of numbers as the bytes of 64-bit floats, NaN where there is none; of all
    /// else as a list.
    fn column<'py>(&self, py: Python<'py>, name: &str) -> PyResult<Bound<'py, PyAny>> {
        let (place, field) = self
            .0
            .schema_ref()
            .column_with_name(name)
            .ok_or_else(|| PyKeyError::new_err(name.to_owned()))?;
        match Column::of(field, self.0.column(place)).values {
            Values::Numbers(values) => {
                let bytes = values.iter().map(|value| value.unwrap_or(f64::NAN));
                let bytes: Vec<u8> = bytes.flat_map(f64::to_ne_bytes).collect();
                Ok(PyBytes::new(py, &bytes).into_any())
            }
            Values::Counts(values) => Ok(PyList::new(py, values)?.into_any()),
            Values::Flags(values) => Ok(PyList::new(py, values)?.into_any()),
            Values::Texts(values) => Ok(PyList::new(py, values)?.into_any()),
        }
    }

    /// The stream of Arrow, for whoever reads it.
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
