//! What do the formulas give?

use std::collections::BTreeMap;

use bouncelab::air::{Air, Conditions};
use bouncelab::ball;
use bouncelab::diagnostic::{Code, Diagnostic};
use bouncelab::drag::DragLaw;
use bouncelab::flight::{Fall, Flight};
use bouncelab::gravity;
use bouncelab::restitution::LawKind;
use bouncelab::settings::Settings;
use bouncelab_report::data_table::{CellOf, DataTable, Definition};
use bouncelab_report::define_columns;
use bouncelab_report::messages::{self, Translator};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use serde_json::Value;

use crate::analyzer::Analyzer;
use crate::failure::{Failure, Result};
use crate::recording::bytes;
use crate::table::Table;

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
            let (mass_kg, diameter_m) = (it.known.ball.mass_kg(), it.known.ball.diameter_m());
            (
                it.name,
                it.label,
                mass_kg,
                diameter_m,
                it.known.contact_time_s,
                it.source,
            )
        })
        .collect()
}

/// The names of all settings, by group.
#[pyfunction]
pub(crate) fn setting_names() -> Result<BTreeMap<String, Vec<String>>> {
    let groups = serde_json::to_value(Settings::default())?;
    let groups: BTreeMap<String, BTreeMap<String, Value>> = serde_json::from_value(groups)?;
    let names = groups.into_iter();
    Ok(names
        .map(|(group, settings)| (group, settings.into_keys().collect()))
        .collect())
}

/// How each drag law is written.
#[pyfunction]
pub(crate) fn drag_laws() -> Vec<&'static str> {
    DragLaw::EXAMPLES.into()
}

/// The restitution laws: name, example and its formula.
#[pyfunction]
pub(crate) fn restitution_laws() -> Vec<(&'static str, &'static str, &'static str)> {
    LawKind::ALL
        .map(|law| (law.name(), law.example(), law.meaning()))
        .into()
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

/// Densities and viscosities of moist air, each of temperature, pressure and humidity.
#[pyfunction]
pub(crate) fn air(
    py: Python<'_>,
    conditions: Vec<(f64, f64, f64)>,
) -> Result<(Bound<'_, PyBytes>, Bound<'_, PyBytes>)> {
    let air = |(temperature_k, pressure_pa, relative_humidity)| {
        let air = Air::moist(&Conditions {
            temperature_k,
            pressure_pa,
            relative_humidity,
        })?;
        Ok((air.density_kg_m3(), air.viscosity_pa_s()))
    };
    let air = conditions.into_iter().map(air);
    let (densities, viscosities): (Vec<f64>, Vec<f64>) = air.collect::<bouncelab::Result<_>>()?;
    Ok((bytes(py, &densities), bytes(py, &viscosities)))
}

/// Gravity at each place, of latitude and altitude.
#[pyfunction]
pub(crate) fn gravity_m_s2(py: Python<'_>, places: Vec<(f64, f64)>) -> Result<Bound<'_, PyBytes>> {
    let gravity = places
        .into_iter()
        .map(|(latitude_deg, altitude_m)| gravity::at(latitude_deg, altitude_m));
    Ok(bytes(
        py,
        &gravity.collect::<bouncelab::Result<Vec<f64>>>()?,
    ))
}

/// The columns of [`flights`].
const FLIGHTS: &[Definition<CellOf<Flight>>] = define_columns! { |row: Flight|
    launch_speed_m_s: Number ["m/s"] "speed after the impact before it" = Some(row.launch_speed_m_s);
    impact_speed_m_s: Number ["m/s"] "speed before the impact after it" = Some(row.impact_speed_m_s);
    apex_m: Number ["m"] "greatest height" = Some(row.apex_m);
    rise_time_s: Number ["s"] "time up to the apex" = Some(row.rise_time_s);
    fall_time_s: Number ["s"] "time down from the apex" = Some(row.fall_time_s);
    flight_time_s: Number ["s"] "time between the impacts" = Some(row.time_s());
};

/// The columns of [`falls`].
const FALLS: &[Definition<CellOf<Fall>>] = define_columns! { |row: Fall|
    height_m: Number ["m"] "height of the release" = Some(row.height_m);
    fall_time_s: Number ["s"] "time from the release to the impact" = Some(row.time_s);
    impact_speed_m_s: Number ["m/s"] "speed before the impact" = Some(row.impact_speed_m_s);
};

/// The flights of a ball, by their launch speeds, flight times or apexes.
#[pyfunction]
pub(crate) fn flights(analyzer: &Analyzer, by: &str, values: Vec<f64>) -> Result<Table> {
    let model = analyzer.setup.options.model()?;
    let flight = |value| match by {
        "launch_speed_m_s" => model.launch(value),
        "flight_time_s" => model.from_flight_time(value),
        _ => model.from_apex(value),
    };
    let flights = values.into_iter().map(flight);
    let flights = flights.collect::<bouncelab::Result<Vec<_>>>()?;
    Ok(Table(DataTable::of(FLIGHTS, &flights)))
}

/// The falls of a ball from rest.
#[pyfunction]
pub(crate) fn falls(analyzer: &Analyzer, heights_m: Vec<f64>) -> Result<Table> {
    let model = analyzer.setup.options.model()?;
    let falls = heights_m.into_iter().map(|height_m| model.fall(height_m));
    let falls = falls.collect::<bouncelab::Result<Vec<_>>>()?;
    Ok(Table(DataTable::of(FALLS, &falls)))
}

/// The terminal speed of a ball, if there is drag.
#[pyfunction]
pub(crate) fn terminal_speed_m_s(analyzer: &Analyzer) -> Result<Option<f64>> {
    Ok(analyzer.setup.options.model()?.terminal_speed_m_s())
}
