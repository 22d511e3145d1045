//! The residual of each impact, and its derivatives by the two noises.
//!
//! A residual compares the launch after an impact with what the law makes of the speed before it.
//! Neighbours share times, and the scatter of the impacts that were missed between them; here is
//! what each depends on, and how strongly.

use super::model::Point;
use super::priors::Measured;
use crate::flight::table::{FlightTable, Row};

/// A interval as its ends see it.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct End {
    /// Launch speed at its start and impact speed at its end.
    pub(super) launch: f64,
    pub(super) impact: f64,
    /// Derivatives of their logarithms by its duration, 1/s.
    pub(super) launch_per_s: f64,
    impact_per_s: f64,
    /// What the scatter of missed impacts does to the logarithms: squares and product.
    launch_scatter: f64,
    impact_scatter: f64,
    shared_scatter: f64,
}

/// A residual with its noise.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Residual {
    pub(super) value: f64,
    /// Derivatives by the time of the impact before, its own and the one after.
    pub(super) timing: [f64; 3],
    /// Variance by the scatter, for a scatter of one, and its covariance with the one before.
    pub(super) scatter: f64,
    pub(super) scatter_before: f64,
    /// The impact in the middle of `timing`.
    pub(super) impact: usize,
    /// Variance of its own, such as that of a release time.
    pub(super) own_variance: f64,
}

/// The fall from the drop height, and the impacts before the first one heard.
pub(super) struct InitialFall {
    pub(super) gravity_height: f64,
    pub(super) height_slope: f64,
    pub(super) impact: f64,
    /// Time from the release to the first impact heard.
    pub(super) time_s: f64,
    /// Scatter of missed impacts in ln(impact speed) and in the time.
    impact_scatter: f64,
    time_scatter: f64,
    shared_scatter: f64,
}

impl End {
    /// One flight.
    pub(super) fn of_flight(row: &Row, gravity: f64) -> Self {
        let launch_per_s = gravity / (row.time_slope * row.time);
        Self {
            launch: row.launch,
            impact: row.impact,
            launch_per_s,
            impact_per_s: row.impact_slope * launch_per_s,
            ..Self::default()
        }
    }

    /// A interval with missed impacts, which are taken to obey the law; how far they may not is
    /// scatter.
    pub(super) fn of_gap(
        table: &FlightTable,
        gravity_time: f64,
        flights: usize,
        point: &Point,
    ) -> Option<Self> {
        const STEPS: usize = 40;
        // As if each flight were as long as the others.
        let mut log_launch = (0.5 * gravity_time / flights as f64).ln();
        for _ in 0..STEPS {
            let rows = rows(table, log_launch.exp(), flights, point)?;
            let total: f64 = rows.iter().map(|row| row.time).sum();
            let (slope, _) = response(&rows, point);
            let step = (gravity_time - total) / slope;
            log_launch += step;
            if step.abs() < 1e-9 {
                break;
            }
        }
        let rows = rows(table, log_launch.exp(), flights, point)?;
        let (slope, impact) = response(&rows, point);
        let launch_per_s = point.gravity_m_s2 / slope;
        let mut end = Self {
            launch: rows[0].launch,
            impact: rows[rows.len() - 1].impact,
            launch_per_s,
            impact_per_s: impact * launch_per_s,
            ..Self::default()
        };
        for missed in 1..rows.len() {
            // The duration is given: what a missed impact adds later must come off the launch.
            let (later, on_impact) = response(&rows[missed..], point);
            let on_launch = -later / slope;
            let on_impact = on_impact + impact * on_launch;
            end.launch_scatter += on_launch * on_launch;
            end.impact_scatter += on_impact * on_impact;
            end.shared_scatter += on_launch * on_impact;
        }
        Some(end)
    }
}

impl InitialFall {
    /// What the unknowns say of it, if so many impacts were missed.
    pub(super) fn new(table: &FlightTable, point: &Point, missed_first: usize) -> Option<Self> {
        let (gravity_height, height_slope) = table.apex(point.fall_launch_m_s)?;
        let gravity_fall = table.fall_time(point.fall_launch_m_s)?;
        let fall = table.launch(point.fall_launch_m_s)?;
        let flights = chain(table, point, fall.impact, missed_first)?;
        let gravity = point.gravity_m_s2;
        let mut opening = Self {
            gravity_height,
            height_slope,
            impact: flights.last().map_or(fall.impact, |row| row.impact),
            time_s: gravity_fall / gravity + flights.len() as f64 * point.contact_time_s,
            impact_scatter: 0.0,
            time_scatter: 0.0,
            shared_scatter: 0.0,
        };
        for missed in 0..flights.len() {
            opening.time_s += flights[missed].time / gravity;
            let (time, impact) = response(&flights[missed..], point);
            let time = time / gravity;
            opening.impact_scatter += impact * impact;
            opening.time_scatter += time * time;
            opening.shared_scatter += impact * time;
        }
        Some(opening)
    }

    /// It as the impact at its end sees it.
    pub(super) fn end(&self) -> End {
        End {
            impact: self.impact,
            impact_scatter: self.impact_scatter,
            shared_scatter: -self.shared_scatter,
            ..End::default()
        }
    }
}

impl Residual {
    /// How far the first impact heard is from where a measured release puts it, s.
    pub(super) fn of_release(
        first_impact_s: f64,
        release_s: Measured,
        opening: &InitialFall,
    ) -> Self {
        Self {
            value: first_impact_s - release_s.value - opening.time_s,
            timing: [0.0, 1.0, 0.0],
            scatter: opening.time_scatter,
            own_variance: release_s.sd * release_s.sd,
            ..Self::default()
        }
    }

    /// The residual of the impact between two intervals.
    pub(super) fn between(before: &End, after: &End, impact: usize, point: &Point) -> Self {
        let (restitution, log_slope) = point.law.at_with_log_slope(before.impact);
        let keeps = 1.0 + log_slope;
        let by_before = -keeps * before.impact_per_s;
        let by_after = after.launch_per_s;
        Self {
            value: (after.launch / (before.impact * restitution)).ln(),
            timing: [-by_before, by_before - by_after, by_after],
            scatter: 1.0 + after.launch_scatter + keeps * keeps * before.impact_scatter,
            scatter_before: -keeps * before.shared_scatter,
            impact,
            own_variance: 0.0,
        }
    }
}

/// Variance of a residual through its times, of which `variance` tells that of each.
#[inline]
pub(super) fn variance_by_time(residual: &Residual, variance: impl Fn(usize) -> f64) -> f64 {
    let ([before, own, after], impact) = (residual.timing, residual.impact);
    let mut sum = own * own * variance(impact) + after * after * variance(impact + 1);
    if impact > 0 {
        sum += before * before * variance(impact - 1);
    }
    sum
}

/// Covariance of two residuals through the times they share.
#[inline]
pub(super) fn covariance_by_time(
    earlier: &Residual,
    later: &Residual,
    variance: impl Fn(usize) -> f64,
) -> f64 {
    let (a, b, own) = (earlier.timing, later.timing, later.impact);
    match own - earlier.impact {
        // The release and the first impact heard have the same one in the middle.
        0 => a[1] * b[1] * variance(own),
        1 => a[1] * b[0] * variance(own - 1) + a[2] * b[1] * variance(own),
        2 => a[2] * b[0] * variance(own - 1),
        _ => 0.0,
    }
}

/// The flights from a launch on, through impacts that obey the law.
fn rows(table: &FlightTable, launch: f64, flights: usize, point: &Point) -> Option<Vec<Row>> {
    let first = table.launch(launch)?;
    let mut rows = vec![first];
    rows.extend(chain(table, point, first.impact, flights - 1)?);
    Some(rows)
}

/// The flights after impacts that obey the law, from the speed at the first of them.
fn chain(table: &FlightTable, point: &Point, impact: f64, flights: usize) -> Option<Vec<Row>> {
    let mut rows = Vec::with_capacity(flights);
    let mut impact = impact;
    for _ in 0..flights {
        let row = table.launch(impact * point.law.at(impact))?;
        impact = row.impact;
        rows.push(row);
    }
    Some(rows)
}

/// What a change of ln(launch speed) of the first flight does to the time of all (times gravity)
/// and to ln(impact speed) at their end.
fn response(rows: &[Row], point: &Point) -> (f64, f64) {
    let (mut time, mut log_impact) = (0.0, 0.0);
    let mut log_launch = 1.0;
    for (flight, row) in rows.iter().enumerate() {
        if flight > 0 {
            log_launch = log_impact * (1.0 + point.law.log_slope(rows[flight - 1].impact));
        }
        time += log_launch * row.time_slope * row.time;
        log_impact = log_launch * row.impact_slope;
    }
    (time, log_impact)
}
