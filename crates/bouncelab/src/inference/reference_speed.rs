//! A first look at the impacts: the speed at which laws are given, and where a search starts.

use super::medium::Medium;
use super::observed::Observed;
use super::parameters::{
    MAX_LOG_RESTITUTION, MIN_FIRST_RESTITUTION, MIN_SPEED_RATIO, MIN_START_SCATTER,
    START_RESTITUTION,
};
use crate::error::{Error, InferenceFailure, Result};
use crate::flight::table::Row;
use crate::restitution::SpeedRange;
use crate::stats::{median, robust_sd};

/// The speeds of the impacts detected, and rough estimates that a search starts from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ReferenceSpeed {
    /// The speeds of the impacts; v* is their geometric mean.
    pub(super) speeds: SpeedRange,
    /// Median of the restitutions, or a guess.
    pub(super) restitution: f64,
    /// Launch speed after the first impact detected, m/s.
    pub(super) first_launch_m_s: f64,
    /// Robust standard deviation of ln e, if any impact shows one.
    pub(super) scatter: Option<f64>,
    /// Factor on the standard errors of the times with which they explain all differences of ln e.
    pub(super) timing: Option<f64>,
}

impl ReferenceSpeed {
    /// By the restitution of each impact at the nominal drag; a guess where no impact shows one.
    ///
    /// # Errors
    /// [`Error::CannotInfer`] if the ball gains speed in most impacts, or a flight is too long for
    /// a ball with so much drag.
    pub(super) fn new(observed: &Observed, medium: &Medium) -> Result<Self> {
        let nominal = medium.flights.at(1.0);
        let rows = observed
            .intervals
            .iter()
            .zip(&observed.impacts)
            .map(|(interval, impact)| {
                let duration_s = interval.duration_s / interval.flights as f64;
                let time_s = duration_s - medium.contact_time_s;
                let row = nominal.and_then(|it| it.lasting(medium.gravity_m_s2 * time_s));
                row.ok_or(Error::CannotInfer(InferenceFailure::FlightTooLong {
                    after: impact.number,
                    duration_s,
                }))
            })
            .collect::<Result<Vec<Row>>>()?;
        let single = |interval: usize| observed.intervals[interval].flights == 1;
        let impacts = (1..rows.len()).filter(|&impact| single(impact) && single(impact - 1));
        let logs: Vec<(usize, f64)> = impacts
            .map(|impact| (impact, (rows[impact].launch / rows[impact - 1].impact).ln()))
            .collect();
        let log_restitution = median(logs.iter().map(|&(_, log)| log));
        let off = |log: f64| log - log_restitution.unwrap_or(0.0);
        let scatter = robust_sd(logs.iter().map(|&(_, log)| off(log)));
        let by_time = |impact: usize| {
            let [before, after] =
                [impact - 1, impact].map(|it| 1.0 / observed.intervals[it].duration_s);
            let slopes = [before, before + after, after].into_iter();
            let by = slopes
                .zip(&observed.sigma_s[impact - 1..])
                .map(|(slope, sigma)| slope * sigma);
            by.map(|by| by * by).sum::<f64>().sqrt()
        };
        let timing = robust_sd(logs.iter().map(|&(impact, log)| off(log) / by_time(impact)));
        if log_restitution.is_some_and(|log_e| log_e > MAX_LOG_RESTITUTION) {
            return Err(Error::CannotInfer(InferenceFailure::GainsSpeed));
        }
        let speeds = rows.iter().map(|row| row.impact).chain([rows[0].launch]);
        let slowest_m_s = speeds.clone().fold(f64::INFINITY, f64::min);
        // No flight before it shows the speed of the first impact: it follows from the flight after it.
        let restitution = log_restitution.map_or(START_RESTITUTION, f64::exp);
        let first_m_s = rows[0].launch / restitution.clamp(MIN_FIRST_RESTITUTION, 1.0);
        let fastest_m_s = speeds.clone().fold(first_m_s, f64::max);
        let mean_log = speeds.map(f64::ln).sum::<f64>() / (rows.len() + 1) as f64;
        Ok(Self {
            speeds: SpeedRange {
                reference_m_s: mean_log.exp(),
                slowest_m_s,
                // A knee needs a range even where all impacts are alike.
                fastest_m_s: fastest_m_s.max(MIN_SPEED_RATIO * slowest_m_s),
            },
            restitution,
            first_launch_m_s: rows[0].launch,
            scatter: scatter.map(|scatter| scatter.max(MIN_START_SCATTER)),
            timing,
        })
    }
}
