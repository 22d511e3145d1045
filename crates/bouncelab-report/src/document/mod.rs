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

use bouncelab::flight::Environment;
use bouncelab::settings::{AirSettings, BallSettings, GravitySettings, Settings};
use bouncelab::{Diagnostic, Options, Recording};
use serde::Serialize;

use crate::link::as_stated;

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
    candidates: [(); 0],
    diagnostics: [(); 0],
}

/// The settings, given or assumed: those of ball, air and gravity, in the groups of [`Settings`].
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub(crate) struct SettingsUsed {
    #[serde(flatten, serialize_with = "as_stated")]
    settings: Settings,
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
            candidates: [],
            diagnostics: [],
        }
    }
}

impl SettingsUsed {
    pub(crate) fn new(options: &Options, assumptions: &[Diagnostic]) -> Self {
        let Environment {
            gravity_m_s2,
            air,
            ref drag,
            buoyancy,
            added_mass,
        } = options.environment;
        let settings = Settings {
            ball: BallSettings {
                kind: None,
                mass_kg: Some(options.ball.mass_kg()),
                diameter_m: Some(options.ball.diameter_m()),
                contact_time_s: Some(options.contact_time_s),
            },
            air: AirSettings {
                density_kg_m3: Some(air.density_kg_m3()),
                viscosity_pa_s: Some(air.viscosity_pa_s()),
                drag: Some(drag.to_string()),
                buoyancy: Some(buoyancy),
                added_mass: Some(added_mass),
                ..AirSettings::default()
            },
            gravity: GravitySettings {
                gravity_m_s2: Some(gravity_m_s2),
                ..GravitySettings::default()
            },
            ..Settings::default()
        };
        Self {
            settings,
            assumptions: assumptions.to_vec(),
        }
    }
}
