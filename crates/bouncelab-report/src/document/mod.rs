//! An analysis as data for other programs: the schema `bouncelab.analysis/1`.
//!
//! Every quantity is in SI and carries its unit in its name. What cannot be told is `null`. Within
//! version 1 fields are only ever added, so that a program may ignore what it does not know.
//!
//! ```
//! use bouncelab::analysis::{self, Options};
//! use bouncelab_report::document::{Document, Origin};
//!
//! let settings = Options::default();
//! let impacts = analysis::impacts_of_times(&[0.0, 0.4605, 0.8877, 1.2854, 1.6568]);
//! let drop = analysis::analyze(impacts, &settings);
//! let document = Document::new("drop.txt", Origin::Times, &settings, vec![], &[drop], vec![]);
//! let json = serde_json::to_value(&document).unwrap();
//! assert_eq!(json["schema"], "bouncelab.analysis/1");
//! assert_eq!(json["drops"][0]["impacts"][1]["time_s"], 0.4605);
//! ```

mod estimate;
pub mod rows;
mod session;
pub mod simulation;
pub mod verdict;

use bouncelab::analysis::{Drop as Analysis, Options};
use bouncelab::regression::{Estimate, Regression};
use serde::{Deserialize, Serialize};

use estimate::Estimate as Estimated;
pub use session::{AboutSession, Reason, SessionDocument};

/// Name and version of the schema.
pub const SCHEMA: &str = "bouncelab.analysis/1";

/// What one file says.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(rename = "AnalysisDocument"))]
pub struct Document {
    schema: &'static str,
    /// Version of the program that made it.
    bouncelab: &'static str,
    file: String,
    source: Option<Origin>,
    settings: Option<SettingsUsed>,
    drops: Vec<Drop>,
    /// Why there is no drop, in words.
    no_drop: Option<String>,
    warnings: Vec<String>,
}

/// Where the impact times come from.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum Origin {
    /// A list of times.
    Times,
    /// A recording.
    Sound {
        /// Format in words.
        format: String,
        /// Samples a second.
        sample_rate_hz: u32,
        /// How many channels the file has.
        channels: usize,
        /// The channel that was believed, the first being 1.
        channel: usize,
        /// Length in seconds.
        duration_s: f64,
        /// How many sounds stand out of the background.
        onsets: usize,
    },
}

/// What was known or assumed.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
struct SettingsUsed {
    ball_mass_kg: f64,
    ball_diameter_m: f64,
    contact_time_s: f64,
    air_density_kg_m3: f64,
    air_viscosity_pa_s: f64,
    drag: String,
    buoyancy: bool,
    added_mass: bool,
    gravity_m_s2: f64,
    /// What of this nobody stated, in words.
    assumptions: Vec<String>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(rename = "DocumentDrop"))]
struct Drop {
    impacts: Vec<Impact>,
    flights: Vec<Flight>,
    regression: Option<Line>,
    corrected: Option<CorrectedSummary>,
    estimate: Option<Estimated>,
    /// Why there is no estimate.
    no_estimate: Option<String>,
    warnings: Vec<String>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(rename = "DocumentImpact"))]
#[expect(
    clippy::struct_field_names,
    reason = "the names are those of the schema"
)]
struct Impact {
    number: usize,
    time_s: f64,
    sigma_s: Option<f64>,
    probability: f64,
    level_db: Option<f64>,
    /// Speed before the impact, drag-corrected; unknown for the first and last.
    impact_speed_m_s: Option<f64>,
    restitution: Option<f64>,
    restitution_sd: Option<f64>,
    /// The ratio of the flights after and before: restitution if there were no air.
    plain_restitution: Option<f64>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(rename = "DocumentFlight"))]
struct Flight {
    number: usize,
    time_s: f64,
    in_regression: bool,
    /// g T^2/8, without drag (paper, Eq. 5).
    plain_height_m: f64,
    /// Apex and launch speed by the flight model.
    apex_m: Option<f64>,
    apex_sd_m: Option<f64>,
    launch_speed_m_s: Option<f64>,
}

/// The paper's straight line (Eqs. 4 to 8).
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(rename = "StraightLine"))]
struct Line {
    flights: usize,
    slope: f64,
    slope_sd: Option<f64>,
    intercept: f64,
    intercept_sd: Option<f64>,
    r_squared: Option<f64>,
    restitution: f64,
    restitution_sd: Option<f64>,
    drop_height_m: f64,
    drop_height_sd_m: Option<f64>,
    energy_kept: f64,
    energy_kept_sd: Option<f64>,
    total_time_s: Option<f64>,
    total_path_m: Option<f64>,
    /// log10 residuals of the flights that went into it, in order.
    residuals: Vec<f64>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
struct CorrectedSummary {
    /// Median over the impacts.
    restitution: f64,
    restitution_sd: Option<f64>,
    impacts: usize,
    slowest_m_s: f64,
    fastest_m_s: f64,
}

impl Document {
    /// The document of a file with these drops; see [`Self::without_drop`] if there are none.
    pub fn new(
        file: &str,
        source: Origin,
        settings: &Options,
        assumptions: Vec<String>,
        drops: &[Analysis],
        warnings: Vec<String>,
    ) -> Self {
        Self {
            source: Some(source),
            settings: Some(SettingsUsed::new(settings, assumptions)),
            drops: drops.iter().map(Drop::new).collect(),
            ..Self::empty(file, None, warnings)
        }
    }

    /// The document of a file that could not be read.
    pub fn failed(file: &str, reason: &str) -> Self {
        Self::empty(file, Some(reason.to_owned()), Vec::new())
    }

    /// The same, with the reason why it holds no drop.
    #[must_use]
    pub fn without_drop(self, reason: &str) -> Self {
        Self {
            no_drop: Some(reason.to_owned()),
            ..self
        }
    }

    fn empty(file: &str, no_drop: Option<String>, warnings: Vec<String>) -> Self {
        Self {
            schema: SCHEMA,
            bouncelab: env!("CARGO_PKG_VERSION"),
            file: file.to_owned(),
            source: None,
            settings: None,
            drops: Vec::new(),
            no_drop,
            warnings,
        }
    }
}

impl SettingsUsed {
    fn new(settings: &Options, assumptions: Vec<String>) -> Self {
        let environment = &settings.environment;
        Self {
            ball_mass_kg: settings.ball.mass_kg(),
            ball_diameter_m: settings.ball.diameter_m(),
            contact_time_s: settings.contact_time_s,
            air_density_kg_m3: environment.air.density_kg_m3(),
            air_viscosity_pa_s: environment.air.viscosity_pa_s(),
            drag: environment.drag.to_string(),
            buoyancy: environment.buoyancy,
            added_mass: environment.added_mass,
            gravity_m_s2: environment.gravity_m_s2,
            assumptions,
        }
    }
}

impl Drop {
    fn new(analysis: &Analysis) -> Self {
        let in_line = analysis
            .flights
            .iter()
            .filter(|flight| flight.in_line)
            .count();
        Self {
            impacts: impacts(analysis),
            flights: flights(analysis),
            regression: analysis
                .line
                .as_ref()
                .ok()
                .map(|line| Line::new(line, in_line)),
            corrected: CorrectedSummary::new(analysis),
            estimate: analysis.estimate.as_ref().ok().map(Estimated::from),
            no_estimate: analysis.estimate.as_ref().err().map(ToString::to_string),
            warnings: analysis.warnings.iter().map(ToString::to_string).collect(),
        }
    }
}

fn impacts(analysis: &Analysis) -> Vec<Impact> {
    analysis
        .impacts
        .iter()
        .map(|impact| {
            let corrected = analysis.corrected_impact(impact.number);
            Impact {
                number: impact.number,
                time_s: impact.time_s,
                sigma_s: impact.sigma_s,
                probability: impact.probability,
                level_db: impact.level_db,
                impact_speed_m_s: corrected.map(|c| c.impact_speed_m_s),
                restitution: corrected.map(|c| c.restitution.value),
                restitution_sd: corrected.and_then(|c| c.restitution.standard_error),
                plain_restitution: corrected.map(|c| c.raw_ratio),
            }
        })
        .collect()
}

fn flights(analysis: &Analysis) -> Vec<Flight> {
    analysis
        .flights
        .iter()
        .map(|flight| {
            let modelled = analysis.modelled_flight(flight.number);
            Flight {
                number: flight.number,
                time_s: flight.time_s,
                in_regression: flight.in_line,
                plain_height_m: flight.plain_height_m,
                apex_m: modelled.map(|m| m.flight.apex_m),
                apex_sd_m: modelled.and_then(|m| m.apex_standard_error_m),
                launch_speed_m_s: modelled.map(|m| m.flight.launch_speed_m_s),
            }
        })
        .collect()
}

impl Line {
    fn new(line: &Regression, flights: usize) -> Self {
        let value = |estimate: Option<Estimate>| estimate.map(|estimate| estimate.value);
        Self {
            flights,
            slope: line.slope().value,
            slope_sd: line.slope().standard_error,
            intercept: line.intercept().value,
            intercept_sd: line.intercept().standard_error,
            r_squared: line.r_squared(),
            restitution: line.restitution().value,
            restitution_sd: line.restitution().standard_error,
            drop_height_m: line.drop_height_m().value,
            drop_height_sd_m: line.drop_height_m().standard_error,
            energy_kept: line.energy_kept().value,
            energy_kept_sd: line.energy_kept().standard_error,
            total_time_s: value(line.total_time_s()),
            total_path_m: value(line.total_path_m()),
            residuals: line.residuals().to_vec(),
        }
    }
}

impl CorrectedSummary {
    fn new(analysis: &Analysis) -> Option<Self> {
        let restitution = analysis.corrected_restitution()?;
        let (slowest_m_s, fastest_m_s) = analysis.speed_range_m_s()?;
        Some(Self {
            restitution: restitution.value,
            restitution_sd: restitution.standard_error,
            impacts: analysis.corrected.as_ref().ok()?.impacts.len(),
            slowest_m_s,
            fastest_m_s,
        })
    }
}
