//! The restitution of each impact, corrected for drag.
//!
//! With ball and air, a flight time determines the launch speed and the impact speed of its flight. So every impact
//! between two detected flights has its own coefficient of restitution, at its own speed: launch speed of the
//! flight after it over impact speed of the flight before it. The ratio of the flight times, which the log-linear
//! fit uses, is smaller, because the air slows the ball too.
//!
//! ```
//! use bouncelab::flight::FlightModel;
//! use bouncelab::{Impact, restitution};
//!
//! let model = FlightModel::with_terminal_speed(9.81, 9.385)?;
//! let impacts: Vec<_> = [0.0, 0.4605, 0.8877, 1.2854]
//!     .iter()
//!     .zip(1..)
//!     .map(|(&time_s, number)| Impact::new(number, time_s).with_time_sd_s(5e-5))
//!     .collect();
//! let per_impact = restitution::of_impacts(&impacts, 0.0, &model)?;
//! let second = &per_impact.impacts[0];
//! assert_eq!(format!("{:.3}", second.flight_time_ratio), "0.928");
//! assert_eq!(format!("{:.3}", second.restitution.value), "0.953");
//! # Ok::<(), bouncelab::Error>(())
//! ```

use crate::error::{Error, InferenceFailure, Quantity, Result, in_order, positive, within};
use crate::estimate::Estimate;
use crate::flight::{Flight, FlightModel};
use crate::impact::Impact;
use crate::stats::{median, robust_sd};

/// A flight between two impacts that follow each other, found from its time.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct TimedFlight {
    /// Number of the impact before it.
    pub number: usize,
    /// The flight: its time is the time between the impacts less the contact time.
    pub flight: Flight,
    /// Standard error of the apex, m, if both times have one.
    pub apex_sd_m: Option<f64>,
}

/// The restitution of an impact between two timed flights.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[non_exhaustive]
pub struct ImpactRestitution {
    /// Number of the impact.
    pub number: usize,
    /// Speed just before the impact, m/s.
    pub impact_speed_m_s: f64,
    /// Coefficient of restitution, with the standard error that the three times leave it.
    pub restitution: Estimate,
    /// Ratio of the flight time after the impact to the one before it: the restitution if there
    /// were no air.
    pub flight_time_ratio: f64,
    /// Derivatives of ln e by the times of the impact before, this one and the one after, 1/s.
    ///
    /// Neighbouring impacts share times, so their errors are correlated; with these rows the whole
    /// covariance can be put together.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub log_gradient_per_s: [f64; 3],
}

/// Every flight and restitution that a list of impact times contains.
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "typescript", derive(ts_rs::TS))]
#[non_exhaustive]
pub struct PerImpact {
    /// The median over the impacts, with its standard error from their scatter: the restitution at the
    /// typical speed of the drop. `None` with fewer than three impacts.
    pub restitution: Option<Estimate>,
    /// The slowest impact with a restitution, m/s.
    pub slowest_m_s: Option<f64>,
    /// The fastest impact with a restitution, m/s.
    pub fastest_m_s: Option<f64>,
    /// Restitutions of impacts with a flight on both sides.
    pub impacts: Vec<ImpactRestitution>,
    /// Flights between impacts that follow each other.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub flights: Vec<TimedFlight>,
}

/// The restitution of every impact whose neighbours on both sides were detected too.
///
/// The contact time is taken off every interval: a ball that touches the surface does not fly. A
/// list too short for any flight gives an empty answer.
///
/// # Errors
/// [`Error::NotInOrder`] if a number does not exceed the one before, [`Error::CannotInfer`] if two impacts are no farther
/// apart than the contact time, [`Error::OutOfRange`] if a standard error is negative, and the errors of
/// [`FlightModel::from_flight_time`].
///
/// ```
/// use bouncelab::Impact;
/// use bouncelab::flight::FlightModel;
/// use bouncelab::restitution::of_impacts;
///
/// // Impact 3 was missed, so its flights and the restitutions next to it are unknown.
/// let impacts = [(1, 0.0), (2, 0.5), (4, 1.4), (5, 1.8)]
///     .map(|(number, time_s)| Impact::new(number, time_s));
/// let per_impact = of_impacts(&impacts, 0.0, &FlightModel::drag_free(9.81)?)?;
/// assert_eq!((per_impact.flights.len(), per_impact.impacts.len()), (2, 0));
/// # Ok::<(), bouncelab::Error>(())
/// ```
pub fn of_impacts(
    impacts: &[Impact],
    contact_time_s: f64,
    model: &FlightModel,
) -> Result<PerImpact> {
    within(Quantity::ContactTime, contact_time_s, 0.0..)?;
    check(impacts)?;
    let mut per_impact = PerImpact::default();
    let mut before = None;
    for pair in impacts.windows(2) {
        let next = Interval::between(&pair[0], &pair[1], contact_time_s, model)?;
        if let Some(interval) = &next {
            per_impact.flights.push(interval.timed_flight());
            if let Some(before) = &before {
                per_impact
                    .impacts
                    .push(restitution_between(before, interval));
            }
        }
        before = next;
    }
    let speeds = || {
        per_impact
            .impacts
            .iter()
            .map(|impact| impact.impact_speed_m_s)
    };
    per_impact.slowest_m_s = speeds().reduce(f64::min);
    per_impact.fastest_m_s = speeds().reduce(f64::max);
    per_impact.restitution = median_restitution(&per_impact.impacts);
    Ok(per_impact)
}

impl PerImpact {
    /// Covariance of the restitutions of [`Self::impacts`] by the errors of the times, row after row: impacts whose numbers
    /// differ by one or two share times. Not a number where an error is unknown.
    ///
    /// `impacts` are those that it was made of, [`of_impacts`].
    pub fn covariance(&self, impacts: &[Impact]) -> Vec<f64> {
        let variance = |number: usize| {
            let impact = impacts.iter().find(|impact| impact.number == number);
            let sd_s = impact.and_then(|impact| impact.time_sd_s);
            sd_s.map_or(f64::NAN, |sd_s| sd_s * sd_s)
        };
        // The derivative by the time of the impact of a number.
        let by_time = |one: &ImpactRestitution, number: usize| {
            let place = (number + 1).checked_sub(one.number);
            let gradient = place.and_then(|place| one.log_gradient_per_s.get(place));
            gradient.copied().unwrap_or(0.0)
        };
        let covariance = |one: &ImpactRestitution, other: &ImpactRestitution| {
            let shared =
                (one.number - 1..=one.number + 1).filter(|&number| by_time(other, number) != 0.0);
            let of_logs = shared
                .map(|number| by_time(one, number) * by_time(other, number) * variance(number));
            one.restitution.value * other.restitution.value * of_logs.sum::<f64>()
        };
        let rows = self.impacts.iter();
        rows.flat_map(|one| self.impacts.iter().map(move |other| covariance(one, other)))
            .collect()
    }
}

/// The median over the impacts, with its standard error from their scatter.
fn median_restitution(impacts: &[ImpactRestitution]) -> Option<Estimate> {
    if impacts.len() < 3 {
        return None;
    }
    let values = || impacts.iter().map(|impact| impact.restitution.value);
    let centre = median(values())?;
    let sd = robust_sd(values().map(|value| value - centre))?;
    // The standard error of a median of normal values is (π/2)^1/2 times that of their mean.
    let error = sd * (std::f64::consts::FRAC_PI_2 / impacts.len() as f64).sqrt();
    Some(Estimate::normal(centre, error))
}

fn check(impacts: &[Impact]) -> Result<()> {
    in_order("impact", impacts.iter().map(|impact| impact.number))?;
    for impact in impacts {
        within(Quantity::ImpactTime, impact.time_s, ..)?;
        if let Some(error) = impact.time_sd_s {
            within(Quantity::ImpactTimeSd, error, 0.0..)?;
        }
    }
    Ok(())
}

/// A flight with the impacts at its ends, and its derivatives by its time.
struct Interval {
    start: Impact,
    end: Impact,
    flight: Flight,
    /// d ln(launch speed)/dT and d ln(impact speed)/dT, 1/s.
    log_launch_per_s: f64,
    log_impact_per_s: f64,
    /// d(apex)/dT, m/s.
    apex_per_s: f64,
}

impl Interval {
    /// `None` if impacts are missing in between.
    fn between(
        start: &Impact,
        end: &Impact,
        contact_time_s: f64,
        model: &FlightModel,
    ) -> Result<Option<Self>> {
        if end.number != start.number + 1 {
            return Ok(None);
        }
        let time_s = end.time_s - start.time_s - contact_time_s;
        positive(Quantity::Interval, end.time_s - start.time_s)?;
        if time_s <= 0.0 {
            let overlap = InferenceFailure::of_contact(start, end, contact_time_s);
            return Err(Error::CannotInfer(overlap));
        }
        let flight = model.from_flight_time(time_s)?;
        let slopes = model.launch_derivatives(&flight)?;
        Ok(Some(Self {
            start: *start,
            end: *end,
            flight,
            log_launch_per_s: 1.0 / (slopes.time * flight.launch_speed_m_s),
            log_impact_per_s: slopes.impact_speed / (slopes.time * flight.impact_speed_m_s),
            apex_per_s: slopes.apex / slopes.time,
        }))
    }

    fn timed_flight(&self) -> TimedFlight {
        let apex_sd_m = standard_error(
            [&self.start, &self.end],
            [-self.apex_per_s, self.apex_per_s],
        );
        TimedFlight {
            number: self.start.number,
            flight: self.flight,
            apex_sd_m,
        }
    }
}

fn restitution_between(before: &Interval, after: &Interval) -> ImpactRestitution {
    let value = after.flight.launch_speed_m_s / before.flight.impact_speed_m_s;
    // ln e = ln v(T after) - ln v'(T before), and each T is a difference of two times.
    let (launch, impact) = (after.log_launch_per_s, before.log_impact_per_s);
    let log_gradient_per_s = [impact, -launch - impact, launch];
    let of_log = standard_error(
        [&before.start, &after.start, &after.end],
        log_gradient_per_s,
    );
    ImpactRestitution {
        number: after.start.number,
        impact_speed_m_s: before.flight.impact_speed_m_s,
        restitution: of_log.map_or(Estimate::unbounded(value), |error| {
            Estimate::normal(value, error * value)
        }),
        flight_time_ratio: after.flight.time_s() / before.flight.time_s(),
        log_gradient_per_s,
    }
}

/// Standard error of a quantity with these derivatives by independent times; `None` if the error
/// of any of them is unknown.
fn standard_error<const N: usize>(impacts: [&Impact; N], derivatives: [f64; N]) -> Option<f64> {
    let mut variance = 0.0;
    for (impact, derivative) in impacts.iter().zip(derivatives) {
        variance += (derivative * impact.time_sd_s?).powi(2);
    }
    Some(variance.sqrt())
}
