//! The impact times as the inference sees them: intervals between impacts that were detected.

use super::parameters::{MAX_MISSED, MIN_TIME_SD_S, READ_OFF_S, ROUNDED_TO_S, ROUNDING_TOLERANCE};
use crate::error::{Error, InferenceFailure, Quantity, Result, in_order, positive, within};
use crate::impact::Impact;

/// The time from one detected impact to the next; more than one flight if impacts were missed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Interval {
    /// Time between the two, contact included, s.
    pub(super) duration_s: f64,
    /// Flights in it.
    pub(super) flights: usize,
}

/// The impacts of one drop, checked.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Observed {
    pub(super) impacts: Vec<Impact>,
    pub(super) intervals: Vec<Interval>,
    /// Standard errors of the times, s.
    pub(super) sigma_s: Vec<f64>,
    /// Whether the standard errors were given.
    pub(super) sigma_stated: bool,
    /// The first impact detected, if it is left out as another sound.
    pub(super) other_sound: Option<Impact>,
}

impl Observed {
    /// Checks the impacts and cuts the drop into intervals.
    ///
    /// # Errors
    /// [`Error::CannotInfer`] with fewer than two impacts or if two are closer than a contact,
    /// [`Error::NotInOrder`] and [`Error::OutOfRange`] if they are not in order.
    pub(super) fn new(impacts: &[Impact]) -> Result<Self> {
        if impacts.len() < 2 {
            return Err(Error::CannotInfer(InferenceFailure::TooFewImpacts {
                impacts: impacts.len(),
            }));
        }
        in_order("impact", impacts.iter().map(|impact| impact.number))?;
        let mut intervals = Vec::with_capacity(impacts.len() - 1);
        for pair in impacts.windows(2) {
            intervals.push(interval(&pair[0], &pair[1])?);
        }
        let stated: Option<Vec<f64>> = impacts.iter().map(|i| i.time_sd_s).collect();
        for &sigma_s in stated.iter().flatten() {
            within(Quantity::ImpactTimeSd, sigma_s, 0.0..)?;
        }
        let sigma_stated = stated.is_some();
        let sigma_s = stated.unwrap_or_else(|| vec![read_off_s(impacts); impacts.len()]);
        Ok(Self {
            impacts: impacts.to_vec(),
            intervals,
            sigma_s: sigma_s.into_iter().map(|s| s.max(MIN_TIME_SD_S)).collect(),
            sigma_stated,
            other_sound: None,
        })
    }

    /// Whether the contact of a ball ends before its next one begins.
    ///
    /// # Errors
    /// [`Error::CannotInfer`] with the first interval that is no longer than the contacts in it.
    pub(super) fn check_contact_time(&self, contact_time_s: f64) -> Result<()> {
        let pairs = self.impacts.windows(2).zip(&self.intervals);
        for (pair, interval) in pairs {
            if interval.duration_s <= contact_time_s * interval.flights as f64 {
                let overlap = InferenceFailure::of_contact(&pair[0], &pair[1], contact_time_s);
                return Err(Error::CannotInfer(overlap));
            }
        }
        Ok(())
    }

    /// The same impacts with other numbers of flights between them.
    pub(super) fn renumbered(&self, flights: &[usize]) -> Self {
        let mut other = self.clone();
        for (interval, &flights) in other.intervals.iter_mut().zip(flights) {
            interval.flights = flights;
        }
        other
    }

    /// Number of impacts missed between the first and the last one detected.
    pub(super) fn missed(&self) -> usize {
        let missed = |interval: &Interval| interval.flights - 1;
        self.intervals.iter().map(missed).sum()
    }

    /// Ratio of the second flight to the first, a rough estimate of the restitution; 0 if there is only
    /// one.
    pub(super) fn first_ratio(&self) -> f64 {
        let flight_s = |interval: &Interval| interval.duration_s / interval.flights as f64;
        match self.intervals.as_slice() {
            [first, second, ..] => flight_s(second) / flight_s(first),
            _ => 0.0,
        }
    }

    /// Number of impacts between two single flights, which show their restitution.
    pub(super) fn restitutions(&self) -> usize {
        let pairs = self.intervals.windows(2);
        pairs
            .filter(|pair| pair.iter().all(|interval| interval.flights == 1))
            .count()
    }

    /// Upper limit of the time of a single flight, s.
    pub(super) fn longest_flight_s(&self) -> f64 {
        let longest = |interval: &Interval| interval.duration_s;
        self.intervals.iter().map(longest).fold(0.0, f64::max)
    }
}

fn interval(from: &Impact, to: &Impact) -> Result<Interval> {
    let (duration_s, flights) = (to.time_s - from.time_s, to.number - from.number);
    positive(Quantity::Interval, duration_s)?;
    if flights > MAX_MISSED + 1 {
        return Err(Error::CannotInfer(InferenceFailure::MissedInARow {
            missed: flights - 1,
            after: from.number,
        }));
    }
    Ok(Interval {
        duration_s,
        flights,
    })
}

/// Standard error of times without one: that of rounding if they are rounded, else that of reading them off.
fn read_off_s(impacts: &[Impact]) -> f64 {
    let on_grid = |step: f64| {
        impacts.iter().all(|impact| {
            let steps = impact.time_s / step;
            (steps - steps.round()).abs() < ROUNDING_TOLERANCE * steps.abs().max(1.0)
        })
    };
    // A rectangle of one step has a standard deviation of 1/12^1/2.
    ROUNDED_TO_S
        .into_iter()
        .find(|&step| on_grid(step))
        .map_or(READ_OFF_S, |step| step / 12.0_f64.sqrt())
}
