//! The result types of a recording and its drops, which are the JSON schema
//! `bouncelab.analysis/3`.

use super::{BallComparison, DropCandidate, ListOrigin, Options};
#[cfg(feature = "serde")]
use crate::Error;
use crate::Result;
use crate::detection::Envelope;
use crate::diagnostic::Diagnostic;
use crate::estimate::Estimate;
use crate::impact::Impact;
use crate::inference::Posterior;
use crate::regression::LogLinearFit;
use crate::restitution::{ImpactRestitution, PerImpact, TimedFlight};

/// The result of a recording, or of a list of times.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[cfg_attr(feature = "typescript", ts(rename = "RecordingResult"))]
#[non_exhaustive]
pub struct Recording {
    /// Where the impact times come from.
    pub source: Source,
    /// The band in which the impacts stand out most, if it is sound with a drop.
    pub strongest_band: Option<StrongestBand>,
    /// The drops, in order of time.
    pub drops: Vec<Drop>,
    /// Why the recording has no drop, if it has none.
    pub no_drop: Option<Diagnostic>,
    /// What may be a drop, but is less likely one than other sounds: the most likely first, a few at most.
    pub candidates: Vec<DropCandidate>,
    /// Diagnostics of the recording as a whole.
    pub diagnostics: Vec<Diagnostic>,
    /// Loudness over time, if it is sound.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub envelope: Option<Envelope>,
}

impl Recording {
    /// A recording without drops.
    pub(super) const fn of(source: Source) -> Self {
        Self {
            source,
            strongest_band: None,
            drops: Vec::new(),
            no_drop: None,
            candidates: Vec::new(),
            diagnostics: Vec::new(),
            envelope: None,
        }
    }
}

/// Where impact times come from.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(tag = "kind", rename_all = "lowercase"))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
pub enum Source {
    /// A list of times.
    Times(ListOrigin),
    /// Sound.
    Sound {
        /// Format of the file, if it is one.
        format: Option<String>,
        /// Samples a second.
        sample_rate_hz: u32,
        /// How many channels there are.
        channels: usize,
        /// The channel with the drops, the first being 1.
        channel: usize,
        /// Length in seconds.
        duration_s: f64,
        /// How many sounds stand out from the background.
        onsets: usize,
    },
}

impl Source {
    /// The same with the format of the file; a list of times has none.
    #[must_use]
    pub fn with_format(mut self, name: &str) -> Self {
        if let Self::Sound { format, .. } = &mut self {
            *format = Some(name.to_owned());
        }
        self
    }
}

/// A band in which impacts stand out from the background.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[non_exhaustive]
pub struct StrongestBand {
    /// Lower end in Hz.
    pub low_hz: f64,
    /// Upper end in Hz.
    pub high_hz: f64,
    /// Median level of the impacts above the background, in dB.
    pub above_background_db: f64,
}

/// The results of one drop.
///
/// A result that cannot be computed is an error in its own field (`null` in JSON), and the others remain: two
/// impacts have a flight and a height, but no log-linear fit.
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[non_exhaustive]
pub struct Drop {
    /// Probability that this is a drop; 1 for a list of times.
    pub probability: f64,
    /// The impacts, in order of time.
    pub impacts: Vec<Impact>,
    /// The flights between successive impacts.
    pub flights: Vec<MeasuredFlight>,
    /// The paper's log-linear fit of the flight times.
    #[cfg_attr(feature = "serde", serde(serialize_with = "ok_or_null"))]
    #[cfg_attr(feature = "typescript", ts(as = "Option<LogLinearFit>"))]
    pub log_linear_fit: Result<LogLinearFit>,
    /// Restitution of each impact, corrected for drag.
    #[cfg_attr(feature = "serde", serde(serialize_with = "ok_or_null"))]
    #[cfg_attr(feature = "typescript", ts(as = "Option<PerImpact>"))]
    pub per_impact: Result<PerImpact>,
    /// The posterior of the inference.
    #[cfg_attr(feature = "serde", serde(serialize_with = "ok_or_null"))]
    #[cfg_attr(feature = "typescript", ts(as = "Option<Posterior>"))]
    pub posterior: Result<Posterior>,
    /// The results for each preset ball, the best first; empty unless
    /// [requested](super::Options::compares_balls).
    pub balls: Vec<BallComparison>,
    /// Diagnostics of the drop.
    pub diagnostics: Vec<Diagnostic>,
}

/// The time between two impacts that follow each other.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[non_exhaustive]
pub struct MeasuredFlight {
    /// Number of the impact with which it begins.
    pub number: usize,
    /// Time between the two impacts in seconds, contact included.
    pub flight_time_s: f64,
    /// Whether it goes into the log-linear fit.
    pub in_fit: bool,
    /// Apex height in metres by g T²/8, without drag (paper Eq. 5).
    pub drag_free_height_m: f64,
    /// Apex height in metres by the flight model.
    pub apex_m: Option<f64>,
    /// Standard uncertainty of the apex from the times, in metres.
    pub apex_sd_m: Option<f64>,
    /// Launch speed by the flight model, m/s.
    pub launch_speed_m_s: Option<f64>,
}

/// The energy lost at an impact and in the flight after it, in joules.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct BounceEnergy {
    /// Number of the impact.
    pub number: usize,
    /// Kinetic energy just before it.
    pub before_j: f64,
    /// Energy lost to the surface.
    pub lost_to_surface_j: f64,
    /// Energy lost to the air in the flight after it.
    pub lost_to_air_j: f64,
}

impl Drop {
    /// The flight after the impact of this number, if it and the next were detected.
    pub fn flight(&self, number: usize) -> Option<&MeasuredFlight> {
        self.flights.iter().find(|flight| flight.number == number)
    }

    /// The restitution of the impact of this number, corrected for drag, if there is one.
    pub fn impact_restitution(&self, number: usize) -> Option<&ImpactRestitution> {
        let impacts = &self.per_impact.as_ref().ok()?.impacts;
        impacts.iter().find(|impact| impact.number == number)
    }

    /// The flight after the impact of this number by the flight model, if there is one.
    pub fn modelled_flight(&self, number: usize) -> Option<&TimedFlight> {
        let flights = &self.per_impact.as_ref().ok()?.flights;
        flights.iter().find(|flight| flight.number == number)
    }

    /// The restitution corrected for drag: the median over the impacts, and its standard error from
    /// their scatter. `None` with fewer than three impacts that have one.
    pub fn per_impact_restitution(&self) -> Option<Estimate> {
        self.per_impact.as_ref().ok()?.restitution
    }

    /// The range of impact speeds at which the corrected restitution was measured, in m/s.
    pub fn speed_range_m_s(&self) -> Option<(f64, f64)> {
        let per_impact = self.per_impact.as_ref().ok()?;
        Some((per_impact.slowest_m_s?, per_impact.fastest_m_s?))
    }

    /// The energies of each impact with a flight on both sides; empty if they cannot be computed.
    pub fn energies(&self, options: &Options) -> Vec<BounceEnergy> {
        let (Ok(found), Ok(model)) = (&self.per_impact, options.model()) else {
            return Vec::new();
        };
        let mass_kg = model.moving_mass_kg().unwrap_or(options.ball.mass_kg());
        let kinetic_j = |speed_m_s: f64| 0.5 * mass_kg * speed_m_s * speed_m_s;
        let impacts = found.impacts.iter();
        let energies = impacts.filter_map(|impact| {
            let after = self.modelled_flight(impact.number)?.flight;
            let before_j = kinetic_j(impact.impact_speed_m_s);
            let launched_j = kinetic_j(after.launch_speed_m_s);
            Some(BounceEnergy {
                number: impact.number,
                before_j,
                lost_to_surface_j: before_j - launched_j,
                lost_to_air_j: launched_j - kinetic_j(after.impact_speed_m_s),
            })
        });
        energies.collect()
    }
}

#[cfg(feature = "serde")]
fn ok_or_null<T: serde::Serialize, S: serde::Serializer>(
    result: &std::result::Result<T, Error>,
    serializer: S,
) -> std::result::Result<S::Ok, S::Error> {
    serde::Serialize::serialize(&result.as_ref().ok(), serializer)
}
