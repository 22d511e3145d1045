//! How is a figure drawn?

use bouncelab_report::chart::Chart as Data;
use bouncelab_report::theme::Meaning;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::failure::Result;
use crate::table::Table;

/// A chart, which can be drawn.
#[pyclass(frozen, module = "bouncelab._core")]
pub(crate) struct Chart(pub(crate) Data);

/// The colour of a meaning, as `#0072b2`.
#[pyfunction]
pub(crate) fn colour(meaning: &str) -> Result<String> {
    Ok(meaning.parse::<Meaning>()?.colour().to_string())
}

#[pymethods]
impl Chart {
    /// A chart from what `json` gives.
    #[new]
    fn from_json(json: &str) -> Result<Self> {
        Ok(Self(serde_json::from_str(json)?))
    }

    fn __getnewargs__(&self) -> Result<(String,)> {
        Ok((self.json()?,))
    }

    /// What it shows, as data.
    fn json(&self) -> Result<String> {
        Ok(serde_json::to_string(&self.0)?)
    }

    /// What it shows, as one table.
    fn table(&self) -> Table {
        Table(self.0.data())
    }

    /// As SVG.
    fn svg(&self) -> String {
        self.0.svg()
    }

    /// As PNG.
    fn png<'py>(&self, py: Python<'py>, width_px: u32) -> Result<Bound<'py, PyBytes>> {
        let picture = py.detach(|| self.0.png(width_px))?;
        Ok(PyBytes::new(py, &picture))
    }

    /// As PDF.
    fn pdf<'py>(&self, py: Python<'py>) -> Result<Bound<'py, PyBytes>> {
        let page = py.detach(|| self.0.pdf())?;
        Ok(PyBytes::new(py, &page))
    }
}
