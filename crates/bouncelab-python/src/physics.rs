//! What do the formulas give?

use bouncelab::air::{Air, Conditions};
use bouncelab::ball;
use bouncelab::diagnostic::{Code, Diagnostic};
use bouncelab::drag::DragLaw;
use bouncelab::gravity;
use bouncelab_report::messages::{self, Translator};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::failure::{Failure, Result};
use crate::recording::bytes;

/// The messages of a language.
pub(crate) fn translator(language: &str) -> Result<Translator> {
    Translator::new(language).ok_or_else(|| {
        let known: Vec<&str> = messages::languages().collect();
        Failure::from(bouncelab::Error::unknown_name("language", language, &known))
    })
}

/// Refuses a name that is not among those that are known.
#[pyfunction]
pub(crate) fn require_known(kind: &str, name: &str, known: Vec<String>) -> Result<()> {
    let kind = if kind == "language" {
        "language"
    } else {
        "figure"
    };
    let known: Vec<&str> = known.iter().map(String::as_str).collect();
    if known.contains(&name) {
        return Ok(());
    }
    Err(bouncelab::Error::unknown_name(kind, name, &known).into())
}

/// The languages of messages.
#[pyfunction]
pub(crate) fn languages() -> Vec<&'static str> {
    messages::languages().collect()
}

/// The codes of diagnostics.
#[pyfunction]
pub(crate) fn code_names() -> Vec<&'static str> {
    Code::ALL.iter().map(|code| code.name()).collect()
}

/// The sentence of a diagnostic.
#[pyfunction]
pub(crate) fn message(diagnostic: &str, language: &str) -> Result<String> {
    let diagnostic: Diagnostic = serde_json::from_str(diagnostic)?;
    Ok(translator(language)?.diagnostic(&diagnostic))
}

/// The known balls: name, label, mass, diameter, contact time, source.
#[pyfunction]
pub(crate) fn balls() -> Vec<(&'static str, &'static str, f64, f64, f64, &'static str)> {
    let presets = ball::presets().iter();
    presets
        .map(|it| {
            let (mass_kg, diameter_m) = (it.ball.mass_kg(), it.ball.diameter_m());
            (
                it.name,
                it.label,
                mass_kg,
                diameter_m,
                it.contact_time_s,
                it.source,
            )
        })
        .collect()
}

/// The drag laws with the greatest Reynolds number of each.
#[pyfunction]
pub(crate) fn drag_laws() -> Vec<(&'static str, f64)> {
    let laws = DragLaw::NAMED.iter();
    laws.map(|law| (law.name(), law.max_reynolds())).collect()
}

/// The drag coefficient at each Reynolds number.
#[pyfunction]
pub(crate) fn drag_coefficient<'py>(
    py: Python<'py>,
    reynolds: Vec<f64>,
    law: &str,
) -> Result<Bound<'py, PyBytes>> {
    let law: DragLaw = law.parse()?;
    let values = reynolds
        .into_iter()
        .map(|reynolds| law.coefficient(reynolds));
    Ok(bytes(py, &values.collect::<bouncelab::Result<Vec<f64>>>()?))
}

/// Density and viscosity of moist air.
#[pyfunction]
pub(crate) fn air(
    temperature_k: f64,
    pressure_pa: f64,
    relative_humidity: f64,
) -> Result<(f64, f64)> {
    let air = Air::moist(&Conditions {
        temperature_k,
        pressure_pa,
        relative_humidity,
    })?;
    Ok((air.density_kg_m3(), air.viscosity_pa_s()))
}

/// Gravity at a place.
#[pyfunction]
pub(crate) fn gravity_m_s2(latitude_deg: f64, altitude_m: f64) -> Result<f64> {
    Ok(gravity::at(latitude_deg, altitude_m)?)
}
