//! Results as data for other programs.
//!
//! The schema `bouncelab.analysis/3` is the result types of the science themselves
//! ([`bouncelab::Recording`]) with the name of the recording, the settings and the version. Every quantity is
//! in SI and carries its unit in its name. An unknown value is `null`. Within a version fields are
//! only ever added, so that a program may ignore what it does not know.
//!
//! ```
//! use bouncelab::{Options, analyze_times};
//! use bouncelab_report::document::Document;
//! use bouncelab_report::messages::Translator;
//!
//! let options = Options::default();
//! let mut result = analyze_times(&[0.0, 0.4605, 0.8877, 1.2854, 1.6568], &options);
//! Translator::english().complete(&mut result);
//! let document = Document::new("drop.txt", &result, &options, &[]);
//! let json = serde_json::to_value(&document)?;
//! assert_eq!(json["schema"], "bouncelab.analysis/3");
//! assert_eq!(json["drops"][0]["impacts"][1]["time_s"], 0.4605);
//! # Ok::<(), serde_json::Error>(())
//! ```

pub mod labels;
pub mod simulation;
mod tracker;
pub mod verdict;

use bouncelab::{Diagnostic, Options, Recording};
use serde::Serialize;

pub use tracker::tracker;

/// Name and version of the schema.
pub const SCHEMA: &str = "bouncelab.analysis/3";

/// The result of one file.
#[derive(Clone, Debug, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(rename = "AnalysisDocument"))]
pub struct Document<'a> {
    schema: &'static str,
    /// Version of the program that made it.
    bouncelab: &'static str,
    recording: &'a str,
    settings: SettingsUsed,
    #[serde(flatten)]
    result: &'a Recording,
}

/// The document of a file that could not be read: no drop, and the reason.
#[derive(Clone, Debug, Serialize)]
pub struct FailedDocument<'a> {
    schema: &'static str,
    bouncelab: &'static str,
    recording: &'a str,
    settings: (),
    source: (),
    drops: [(); 0],
    no_drop: &'a Diagnostic,
    diagnostics: [(); 0],
}

/// The settings, given or assumed.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub(crate) struct SettingsUsed {
    ball_mass_kg: f64,
    ball_diameter_m: f64,
    contact_time_s: f64,
    air_density_kg_m3: f64,
    air_viscosity_pa_s: f64,
    drag: String,
    buoyancy: bool,
    added_mass: bool,
    gravity_m_s2: f64,
    /// Which of the settings were assumed.
    assumptions: Vec<Diagnostic>,
}

impl<'a> Document<'a> {
    /// The document of a recording of this name.
    pub fn new(
        recording: &'a str,
        result: &'a Recording,
        options: &Options,
        assumptions: &[Diagnostic],
    ) -> Self {
        Self {
            schema: SCHEMA,
            bouncelab: env!("CARGO_PKG_VERSION"),
            recording,
            settings: SettingsUsed::new(options, assumptions),
            result,
        }
    }
}

impl<'a> FailedDocument<'a> {
    /// The document of a file that could not be read, for this reason.
    pub const fn new(recording: &'a str, reason: &'a Diagnostic) -> Self {
        Self {
            schema: SCHEMA,
            bouncelab: env!("CARGO_PKG_VERSION"),
            recording,
            settings: (),
            source: (),
            drops: [],
            no_drop: reason,
            diagnostics: [],
        }
    }
}

impl SettingsUsed {
    pub(crate) fn new(options: &Options, assumptions: &[Diagnostic]) -> Self {
        let environment = &options.environment;
        Self {
            ball_mass_kg: options.ball.mass_kg(),
            ball_diameter_m: options.ball.diameter_m(),
            contact_time_s: options.contact_time_s,
            air_density_kg_m3: environment.air.density_kg_m3(),
            air_viscosity_pa_s: environment.air.viscosity_pa_s(),
            drag: environment.drag.to_string(),
            buoyancy: environment.buoyancy,
            added_mass: environment.added_mass,
            gravity_m_s2: environment.gravity_m_s2,
            assumptions: assumptions.to_vec(),
        }
    }
}
