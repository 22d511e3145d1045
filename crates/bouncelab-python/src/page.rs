//! What does a report say?

use bouncelab_report::report::Page as Data;
use pyo3::prelude::*;

use crate::failure::Result;

/// A report, which can be written in several forms.
#[pyclass(frozen, module = "bouncelab._core")]
pub(crate) struct Page(pub(crate) Data);

#[pymethods]
impl Page {
    /// A report from what `json` gives.
    #[new]
    fn from_json(json: &str) -> Result<Self> {
        Ok(Self(serde_json::from_str(json)?))
    }

    fn __getnewargs__(&self) -> Result<(String,)> {
        Ok((self.json()?,))
    }

    /// What it says, as data.
    fn json(&self) -> Result<String> {
        Ok(serde_json::to_string(&self.0)?)
    }

    /// As one file of HTML.
    fn html(&self, py: Python<'_>) -> String {
        py.detach(|| self.0.html())
    }

    /// As Markdown, without its figures.
    fn markdown(&self, py: Python<'_>) -> String {
        py.detach(|| self.0.markdown("figures").text)
    }
}
