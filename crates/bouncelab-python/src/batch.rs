//! How does an engine analyse recordings, and what do its results say?

use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

use arrow_array::builder::{MapBuilder, MapFieldNames, StringBuilder};
use arrow_array::{Array, ArrayRef, ListArray, RecordBatch, StringArray, StructArray};
use arrow_buffer::{NullBuffer, OffsetBuffer};
use arrow_schema::{DataType, Field, Fields, Schema};
use bouncelab::settings::Settings;
use bouncelab_audio::SoundFormat;
use bouncelab_report::data_table::DataTable;
use bouncelab_report::groups::{About, Question, StudyParts};
use bouncelab_session::batch::{
    Batch, Failure as RowFailure, FailureCode, Given, Kernel as OneByOne, KernelOptions, Row,
    RowTables,
};
use bouncelab_session::table::Form;
use bouncelab_session::{
    Error, Outcome, SessionDocument, StudyOptions, compared_drops, write_tables,
};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use serde::Deserialize;

use crate::failure::{Failure, Result};
use crate::output::{outputs, unwritable};
use crate::physics::translator;
use crate::table::{Arrow, arrow};
use crate::watch::interruptible;

/// A recording: what it is called, where it is, its content if that was read, and what was noted of it.
type Recording = (
    String,
    PathBuf,
    Option<PyBackedBytes>,
    BTreeMap<String, String>,
);

/// Analyses recordings one by one.
#[pyclass(frozen, module = "bouncelab._core")]
pub(crate) struct Kernel(OneByOne);

fn given((name, path, content, notes): Recording) -> Given {
    Given {
        name,
        path,
        content: content.map(|content| Arc::from(&*content)),
        notes,
    }
}

#[pymethods]
impl Kernel {
    #[new]
    fn new(settings: &str, options: &str) -> Result<Self> {
        let settings: Settings = serde_json::from_str(settings)?;
        let options: KernelOptions = serde_json::from_str(options)?;
        settings.resolve()?;
        Ok(Self(OneByOne::new(settings, options)?))
    }

    /// Hash of what holds for all recordings: the column `kernel_sha256` of the rows.
    fn sha256(&self) -> String {
        self.0.hash().to_string()
    }

    /// Analyses a recording; gives its row as JSON.
    fn row(&self, py: Python<'_>, recording: Recording) -> Result<Vec<u8>> {
        let given = given(recording);
        py.detach(|| Ok(serde_json::to_vec(&self.0.row(given))?))
    }

    /// The row of a recording whose analysis ended its process, or was ended.
    fn failed(
        &self,
        py: Python<'_>,
        recording: Recording,
        code: &str,
        message: String,
    ) -> Result<Vec<u8>> {
        let code = FailureCode::ALL.into_iter().find(|it| it.name() == code);
        let code = code.ok_or_else(|| Failure::Input("unknown kind of failure".to_owned()))?;
        let (given, failure) = (given(recording), RowFailure { code, message });
        py.detach(|| Ok(serde_json::to_vec(&self.0.failed(given, failure))?))
    }
}

/// Rows as a table of Arrow.
#[pyfunction]
pub(crate) fn batch_of_rows(rows: Vec<PyBackedBytes>) -> Result<Arrow> {
    let rows = rows.iter().map(|row| serde_json::from_slice(row));
    let rows: Vec<Row> = rows.collect::<std::result::Result<_, _>>()?;
    let mut tables = RowTables::default();
    let tables = rows.iter().map(|row| tables.of(row));
    let tables: Vec<[DataTable; 2]> = tables
        .collect::<std::result::Result<_, _>>()
        .map_err(Failure::Input)?;
    let (drops, impacts) = tables
        .into_iter()
        .map(|[drops, impacts]| (drops, impacts))
        .unzip();
    let [no_drops, no_impacts] = RowTables::empty();
    let texts = |of: &dyn Fn(&Row) -> Option<String>| -> ArrayRef {
        Arc::new(rows.iter().map(of).collect::<StringArray>())
    };
    let json = |value: std::result::Result<String, _>| value.ok();
    let columns: Vec<(&str, ArrayRef)> = vec![
        ("recording", texts(&|row| Some(row.recording.clone()))),
        ("kernel_sha256", texts(&|row| Some(row.kernel.to_string()))),
        (
            "content_sha256",
            texts(&|row| Some(row.content?.to_string())),
        ),
        (
            "settings_sha256",
            texts(&|row| Some(row.settings?.to_string())),
        ),
        ("failure", failures(&rows)),
        ("noted", noted(&rows)?),
        ("drops", lists(no_drops, drops)?),
        ("impacts", lists(no_impacts, impacts)?),
        (
            "metadata",
            texts(&|row| json(serde_json::to_string(&row.known))),
        ),
        (
            "record",
            texts(&|row| json(serde_json::to_string(row.record.as_ref()?))),
        ),
    ];
    let fields = columns.iter();
    let fields: Vec<Field> = fields
        .map(|(name, array)| Field::new(*name, array.data_type().clone(), true))
        .collect();
    let arrays = columns.into_iter().map(|(_, array)| array).collect();
    RecordBatch::try_new(Arc::new(Schema::new(fields)), arrays)
        .map(Arrow)
        .map_err(|fault| Failure::Input(fault.to_string()))
}

/// The failures, as a code and a message.
fn failures(rows: &[Row]) -> ArrayRef {
    let texts = |of: &dyn Fn(&RowFailure) -> String| -> ArrayRef {
        let texts = rows.iter().map(|row| row.failure.as_ref().map(of));
        Arc::new(texts.collect::<StringArray>())
    };
    let columns = vec![
        texts(&|failure| failure.code.name().to_owned()),
        texts(&|failure| failure.message.clone()),
    ];
    let fields = ["code", "message"].map(|name| Field::new(name, DataType::Utf8, true));
    let known: NullBuffer = rows.iter().map(|row| row.failure.is_some()).collect();
    Arc::new(StructArray::new(
        Fields::from(fields.to_vec()),
        columns,
        Some(known),
    ))
}

/// What drops are compared by, by field.
fn noted(rows: &[Row]) -> Result<ArrayRef> {
    let names = MapFieldNames {
        entry: "entries".to_owned(),
        key: "key".to_owned(),
        value: "value".to_owned(),
    };
    let mut map = MapBuilder::new(Some(names), StringBuilder::new(), StringBuilder::new());
    for row in rows {
        for (field, level) in &row.known.factors {
            map.keys().append_value(field);
            map.values().append_value(level);
        }
        map.append(true)
            .map_err(|fault| Failure::Input(fault.to_string()))?;
    }
    Ok(Arc::new(map.finish()))
}

/// A table for each row, as a list of structs; `all` is one without rows.
fn lists(mut all: DataTable, tables: Vec<DataTable>) -> Result<ArrayRef> {
    let lengths = tables.iter().map(|table| table.rows.len());
    let offsets = OffsetBuffer::from_lengths(lengths);
    all.rows = tables.into_iter().flat_map(|table| table.rows).collect();
    let structs = StructArray::from(arrow(&all)?);
    let field = Field::new("item", structs.data_type().clone(), true);
    Ok(Arc::new(ListArray::new(
        Arc::new(field),
        offsets,
        Arc::new(structs),
        None,
    )))
}

/// Endings of the names of recordings.
#[pyfunction]
pub(crate) fn endings() -> Vec<&'static str> {
    SoundFormat::endings_of_all().collect()
}

/// What is asked of results.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Request {
    by: Option<Vec<String>>,
    compare_at_m_s: Option<f64>,
    wanted: Option<f64>,
    exclude: Vec<String>,
}

/// What drops of a study, read in parts, add to it.
#[pyclass(module = "bouncelab._core")]
pub(crate) struct StudySums(StudyParts);

/// What is asked of drops that are read in parts, with every level of each field that was noted.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct PartsRequest {
    noted: Vec<(String, String)>,
    drops: usize,
    by: Option<Vec<String>>,
    compare_at_m_s: Option<f64>,
    wanted: Option<f64>,
}

#[pymethods]
impl StudySums {
    #[new]
    fn new(request: &str) -> Result<Self> {
        let request: PartsRequest = serde_json::from_str(request)?;
        let question = Question {
            by: request.by,
            at_speed_m_s: request.compare_at_m_s,
            wanted: request.wanted,
        };
        let noted = request.noted.iter().map(|(field, level)| (field, level));
        let parts = StudyParts::new(noted, request.drops, &question).map_err(Error::from)?;
        Ok(Self(parts))
    }

    /// Adds the drops of a recording, by the columns `record` and `noted` of its row.
    fn add(&mut self, record: &str, noted: BTreeMap<String, String>) -> Result<()> {
        let english = translator("en")?;
        for drop in compared_drops(serde_json::from_str(record)?, &noted, &english) {
            self.0.add(drop);
        }
        Ok(())
    }

    /// Adds the sums of another part.
    fn merge(&mut self, sums: &[u8]) -> Result<()> {
        self.0.merge(&serde_json::from_slice(sums)?);
        Ok(())
    }

    /// The sums so far.
    fn sums(&self) -> Result<Vec<u8>> {
        Ok(serde_json::to_vec(self.0.parts())?)
    }

    /// The document of the schema `bouncelab.session/3`, without what needs each drop.
    fn document(&self, recordings: usize, language: &str) -> Result<String> {
        let about = About {
            recordings,
            ..About::default()
        };
        let groups = self.0.study(about, &translator(language)?);
        Ok(serde_json::to_string(&SessionDocument::new(&groups))?)
    }
}

/// The results that an engine wrote.
#[pyclass(frozen, module = "bouncelab._core")]
pub(crate) struct Results {
    batch: Arc<Batch>,
    options: StudyOptions,
}

#[pymethods]
impl Results {
    #[new]
    fn new(py: Python<'_>, path: PathBuf, request: &str) -> Result<Self> {
        let request: Request = serde_json::from_str(request)?;
        Ok(Self {
            batch: Arc::new(py.detach(|| interruptible(move || Batch::open(&path)))??),
            options: StudyOptions {
                question: Question {
                    by: request.by,
                    at_speed_m_s: request.compare_at_m_s,
                    wanted: request.wanted,
                },
                exclude: request.exclude,
            },
        })
    }

    /// The document of the schema `bouncelab.session/3`.
    fn document(&self, py: Python<'_>, language: &str) -> Result<String> {
        let words = translator(language)?;
        let (batch, options) = (Arc::clone(&self.batch), self.options.clone());
        py.detach(|| {
            interruptible(move || -> Result<String> {
                let outcome = Outcome::of(&batch.results(), &options, &words)?;
                Ok(serde_json::to_string(&outcome.document())?)
            })
        })?
    }

    /// Writes the tables of drops and impacts into a folder, in the place of others only as the gate of outputs
    /// has it; returns the files.
    fn write_tables(
        &self,
        py: Python<'_>,
        folder: PathBuf,
        forms: Vec<String>,
        force: bool,
    ) -> Result<Vec<PathBuf>> {
        let is_wanted = |form: &Form| forms.iter().any(|ending| ending == form.ending());
        let forms: Vec<Form> = Form::ALL.into_iter().filter(is_wanted).collect();
        py.detach(|| {
            let results = self.batch.results();
            let english = translator("en")?;
            let outcome = Outcome::of(&results, &self.options, &english)?;
            let outputs = outputs(self.batch.files(), force);
            let written = write_tables(&outcome, &results, &folder, &forms, &outputs);
            written.map_err(|error| match error {
                Error::Output { path, source } => unwritable(&path, &source),
                error => error.into(),
            })
        })
    }
}
