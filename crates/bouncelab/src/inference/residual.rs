//! The residual of each impact, and its derivatives by the two noises.
//!
//! A residual compares the launch after an impact with the one that the law predicts from the speed before it.
//! Neighbours share times, and the scatter of the impacts that were missed between them; this module has the
//! derivatives of each residual by both.

use super::banded::Banded;
use super::parameters::{MAX_GAP_STEPS, MIN_WEIGHT, NEWTON_TOLERANCE};
use super::priors::Measured;
use super::unknowns::Point;
use crate::flight::table::{FlightTable, Row};
use crate::restitution::Restitutions;
use crate::simd::Lanes;

/// The speeds at the ends of an interval, for one point in each lane.
#[derive(Debug, Clone, Copy)]
pub(super) struct End<const L: usize> {
    /// Logarithms of the launch speed at its start and of the impact speed at its end, in m/s.
    pub(super) log_launch: Lanes<L>,
    pub(super) log_impact: Lanes<L>,
    /// Their derivatives by its duration, 1/s.
    pub(super) launch_per_s: Lanes<L>,
    impact_per_s: Lanes<L>,
    /// Variances and covariance of the logarithms by the scatter of missed impacts, for a scatter of one.
    launch_scatter: Lanes<L>,
    impact_scatter: Lanes<L>,
    shared_scatter: Lanes<L>,
}

/// Variances and covariance of the logarithms of the speeds at both ends of an interval by the scatter of the impacts
/// missed in it, for a scatter of one.
#[derive(Debug, Clone, Copy)]
pub(super) struct Gap<const L: usize> {
    pub(super) launch: Lanes<L>,
    pub(super) impact: Lanes<L>,
    pub(super) shared: Lanes<L>,
}

/// A residual with its noise, for one point in each lane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Residual<const L: usize> {
    pub(super) value: Lanes<L>,
    /// Derivatives by the time of the impact before, its own and the one after.
    pub(super) timing: [Lanes<L>; 3],
    /// Variance by the scatter, for a scatter of one, and its covariance with the one before.
    pub(super) scatter: Lanes<L>,
    pub(super) scatter_before: Lanes<L>,
    /// Derivative 1 + d ln e/d ln v of ln(launch speed) by ln(impact speed) under the law.
    pub(super) keeps: Lanes<L>,
    /// Index of the impact of the second derivative of `timing`.
    pub(super) impact: usize,
    /// Further variance, such as that of a release time.
    pub(super) own_variance: f64,
}

/// The fall from the drop height, and the missed impacts before the first one detected.
#[derive(Debug, Clone, Copy)]
pub(super) struct InitialFall {
    pub(super) gravity_height: f64,
    pub(super) height_slope: f64,
    pub(super) impact: f64,
    /// Time from the release to the first impact detected.
    pub(super) time_s: f64,
    /// Scatter of missed impacts in ln(impact speed) and in the time.
    impact_scatter: f64,
    time_scatter: f64,
    shared_scatter: f64,
}

impl<const L: usize> End<L> {
    const NO_SCATTER: Self = Self {
        log_launch: Lanes::all(0.0),
        log_impact: Lanes::all(0.0),
        launch_per_s: Lanes::all(0.0),
        impact_per_s: Lanes::all(0.0),
        launch_scatter: Lanes::all(0.0),
        impact_scatter: Lanes::all(0.0),
        shared_scatter: Lanes::all(0.0),
    };

    /// One flight, from its curves ([`Curves`](super::timed_flights::Curves)), g and g T. With x = T/T0 - 1,
    /// ln v = ln(g T/2) + a + x (b + x c), so T d ln v/dT = 1 + (1 + x)(b + 2 c x).
    #[inline(always)]
    pub(super) fn of_flight(
        curves: &[Lanes<L>; 6],
        gravity: Lanes<L>,
        gravity_time: Lanes<L>,
        per_nominal: f64,
    ) -> Self {
        let [a, b, c, d, e, f] = *curves;
        let nominals = gravity_time * per_nominal;
        let x = nominals - 1.0;
        let log_free = (gravity_time * 0.5).ln();
        let per_s = gravity / gravity_time;
        let slope = |b: Lanes<L>, c: Lanes<L>| (nominals * (b + x * c * 2.0) + 1.0) * per_s;
        Self {
            log_launch: log_free + a + x * (b + x * c),
            log_impact: log_free + d + x * (e + x * f),
            launch_per_s: slope(b, c),
            impact_per_s: slope(e, f),
            ..Self::NO_SCATTER
        }
    }

    /// The effect of the scatter of missed impacts; `None` where none was missed. The fall has its time in place of a
    /// launch, with the opposite sign, in s.
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    pub(super) fn gap(&self) -> Option<Gap<L>> {
        let missed = |scatter: Lanes<L>| scatter.0.iter().any(|scatter| *scatter > 0.0);
        (missed(self.launch_scatter) || missed(self.impact_scatter)).then_some(Gap {
            launch: self.launch_scatter,
            impact: self.impact_scatter,
            shared: self.shared_scatter,
        })
    }

    /// Launch and impact speed if the interval is longer than measured by this time and their logarithms deviate by `off`.
    #[inline(always)]
    pub(super) fn speeds_after(&self, longer_s: Lanes<L>, off: [Lanes<L>; 2]) -> [Lanes<L>; 2] {
        [
            (self.log_launch + self.launch_per_s * longer_s + off[0]).exp(),
            (self.log_impact + self.impact_per_s * longer_s + off[1]).exp(),
        ]
    }

    /// The ends of one interval for each of the points; one that is not valid is not a number.
    pub(super) fn gather(ends: [Option<End<1>>; L]) -> Self {
        let lanes = |number: fn(&End<1>) -> Lanes<1>| {
            Lanes::of(|lane| ends[lane].as_ref().map_or(f64::NAN, |end| number(end).0[0]))
        };
        Self {
            log_launch: lanes(|end| end.log_launch),
            log_impact: lanes(|end| end.log_impact),
            launch_per_s: lanes(|end| end.launch_per_s),
            impact_per_s: lanes(|end| end.impact_per_s),
            launch_scatter: lanes(|end| end.launch_scatter),
            impact_scatter: lanes(|end| end.impact_scatter),
            shared_scatter: lanes(|end| end.shared_scatter),
        }
    }
}

impl End<1> {
    /// An interval with missed impacts, which obey the law but for their scatter: the launch from which all its flights
    /// together last as long, by Newton's method in ln(launch speed).
    pub(super) fn of_gap(
        table: &FlightTable,
        gravity_time: f64,
        flights: usize,
        point: &Point,
    ) -> Option<Self> {
        // Start: flights of equal length, without air.
        let mut log_launch = (0.5 * gravity_time / flights as f64).ln();
        for _ in 0..MAX_GAP_STEPS {
            let rows = rows(table, log_launch.exp(), flights, point)?;
            let total: f64 = rows.iter().map(|row| row.time).sum();
            let (slope, _) = response(&rows, point);
            let step = (gravity_time - total) / slope;
            log_launch += step;
            if step.abs() < NEWTON_TOLERANCE {
                break;
            }
        }
        let rows = rows(table, log_launch.exp(), flights, point)?;
        let (slope, impact) = response(&rows, point);
        let launch_per_s = point.gravity_m_s2 / slope;
        let mut scatter = [0.0; 3];
        for missed in 1..rows.len() {
            // The duration is given, so a launch changes by the negative of what a missed impact adds to the time.
            let (later, on_impact) = response(&rows[missed..], point);
            let on_launch = -later / slope;
            let on_impact = on_impact + impact * on_launch;
            scatter[0] += on_launch * on_launch;
            scatter[1] += on_impact * on_impact;
            scatter[2] += on_launch * on_impact;
        }
        let [launch_scatter, impact_scatter, shared_scatter] = scatter.map(Lanes::all);
        Some(Self {
            log_launch: Lanes([rows[0].launch.ln()]),
            log_impact: Lanes([rows[rows.len() - 1].impact.ln()]),
            launch_per_s: Lanes([launch_per_s]),
            impact_per_s: Lanes([impact * launch_per_s]),
            launch_scatter,
            impact_scatter,
            shared_scatter,
        })
    }
}

impl InitialFall {
    /// The fall of a point if this number of impacts was missed.
    pub(super) fn new(table: &FlightTable, point: &Point, missed_first: usize) -> Option<Self> {
        let fall = table.rise_and_fall(point.fall_launch_m_s)?;
        let flights = chain(table, point, fall.row.impact, missed_first)?;
        let gravity = point.gravity_m_s2;
        let mut opening = Self {
            gravity_height: fall.gravity_height,
            height_slope: fall.height_slope,
            impact: flights.last().map_or(fall.row.impact, |row| row.impact),
            time_s: fall.fall_time / gravity + flights.len() as f64 * point.contact_time_s,
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

    /// The end of the fall, at the first impact detected.
    pub(super) fn end<const L: usize>(falls: &[Self; L]) -> End<L> {
        let lanes = |number: fn(&Self) -> f64| Lanes::of(|lane| number(&falls[lane]));
        End {
            log_impact: lanes(|fall| fall.impact).ln(),
            launch_scatter: lanes(|fall| fall.time_scatter),
            impact_scatter: lanes(|fall| fall.impact_scatter),
            shared_scatter: lanes(|fall| -fall.shared_scatter),
            ..End::NO_SCATTER
        }
    }
}

impl<const L: usize> Residual<L> {
    /// Time of the first impact detected minus that predicted by a measured release, s.
    pub(super) fn of_release(
        first_impact_s: f64,
        release_s: Measured,
        falls: &[InitialFall; L],
    ) -> Self {
        let none = Lanes::all(0.0);
        let due_s = |fall: &InitialFall| release_s.value + fall.time_s;
        Self {
            value: Lanes::of(|lane| first_impact_s - due_s(&falls[lane])),
            timing: [none, Lanes::all(1.0), none],
            scatter: Lanes::of(|lane| falls[lane].time_scatter),
            scatter_before: none,
            keeps: none,
            impact: 0,
            own_variance: release_s.sd * release_s.sd,
        }
    }

    /// Its derivatives by times, 1/s, each with the index of the impact; the last index may be beyond the impacts.
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    pub(super) fn by_times(&self) -> impl Iterator<Item = (usize, Lanes<L>)> {
        let derivatives = (0..).zip(self.timing);
        derivatives
            .filter_map(|(number, by_s)| Some(((self.impact + number).checked_sub(1)?, by_s)))
    }

    /// The residual of one point.
    pub(super) fn in_lane(&self, lane: usize) -> Residual<1> {
        let of = |lanes: Lanes<L>| Lanes([lanes.0[lane]]);
        Residual {
            value: of(self.value),
            timing: self.timing.map(of),
            scatter: of(self.scatter),
            scatter_before: of(self.scatter_before),
            keeps: of(self.keeps),
            impact: self.impact,
            own_variance: self.own_variance,
        }
    }

    /// The residual of the impact between two intervals, r = ln v(after) - ln v'(before) - ln e(v'). A time shared by both
    /// lengthens one and shortens the other.
    #[inline(always)]
    pub(super) fn between(
        before: &End<L>,
        after: &End<L>,
        impact: usize,
        laws: &Restitutions<L>,
    ) -> Self {
        let (log_restitution, log_slope) = laws.ln_at_with_log_slope(before.log_impact);
        let keeps = log_slope + 1.0;
        let by_before = -(keeps * before.impact_per_s);
        let by_after = after.launch_per_s;
        Self {
            value: after.log_launch - before.log_impact - log_restitution,
            timing: [-by_before, by_before - by_after, by_after],
            scatter: after.launch_scatter + keeps * keeps * before.impact_scatter + 1.0,
            scatter_before: -(keeps * before.shared_scatter),
            keeps,
            impact,
            own_variance: 0.0,
        }
    }
}

/// The noise of the data, for one point in each lane.
#[derive(Debug, Clone, Copy)]
pub(super) struct Noise<'o, const L: usize> {
    /// Standard errors of the times, s, and the square of the factor on them.
    sigma_s: &'o [f64],
    timing: Lanes<L>,
    /// Variance of the scatter of ln e.
    pub(super) scatter: Lanes<L>,
}

impl<'o, const L: usize> Noise<'o, L> {
    #[inline(always)]
    pub(super) fn new(sigma_s: &'o [f64], points: &[Point; L]) -> Self {
        let square = |x: f64| x * x;
        Self {
            sigma_s,
            timing: Lanes::of(|lane| square(points[lane].timing)),
            scatter: Lanes::of(|lane| square(points[lane].scatter)),
        }
    }

    /// Variance of the time of an impact, s².
    #[inline(always)]
    fn of_time(&self, impact: usize) -> Lanes<L> {
        self.timing * (self.sigma_s[impact] * self.sigma_s[impact])
    }

    /// Variance of a residual through its times.
    #[inline(always)]
    pub(super) fn by_time(&self, residual: &Residual<L>) -> Lanes<L> {
        let ([before, own, after], impact) = (residual.timing, residual.impact);
        let sum = own * own * self.of_time(impact) + after * after * self.of_time(impact + 1);
        match impact {
            0 => sum,
            _ => sum + before * before * self.of_time(impact - 1),
        }
    }

    /// Covariance of two residuals through the times they share.
    #[inline(always)]
    pub(super) fn shared_by_time(&self, earlier: &Residual<L>, later: &Residual<L>) -> Lanes<L> {
        let (a, b, own) = (earlier.timing, later.timing, later.impact);
        match own - earlier.impact {
            // The residuals of the release and of the first impact have the same impact.
            0 => a[1] * b[1] * self.of_time(own),
            1 => a[1] * b[0] * self.of_time(own - 1) + a[2] * b[1] * self.of_time(own),
            2 => a[2] * b[0] * self.of_time(own - 1),
            _ => Lanes::all(0.0),
        }
    }

    /// Covariances of the residuals, each with its weight, by the times, by the scatter and by a release.
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    pub(super) fn covariances(
        &self,
        residuals: &[Residual<L>],
        weights: impl IntoIterator<Item = Lanes<L>>,
    ) -> [Banded<L>; 3] {
        let zero = Lanes::all(0.0);
        let mut covariances = <[Banded<L>; 3]>::default();
        let [by_time, by_scatter, by_release] = &mut covariances;
        for (row, (residual, weight)) in residuals.iter().zip(weights).enumerate() {
            let shared = |before: usize| {
                let earlier = row.checked_sub(before).map(|earlier| &residuals[earlier]);
                earlier.map_or(zero, |earlier| self.shared_by_time(earlier, residual))
            };
            by_time.push([shared(2), shared(1), self.by_time(residual)]);
            // An outlier has less weight, as if its scatter were larger.
            let own = self.scatter * residual.scatter / weight.max(MIN_WEIGHT);
            by_scatter.push([zero, self.scatter * residual.scatter_before, own]);
            by_release.push([zero, zero, Lanes::all(residual.own_variance)]);
        }
        covariances
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

/// How long before the first impact detected each of this number of missed ones was, s.
pub(super) fn missed_before_s(
    table: &FlightTable,
    point: &Point,
    missed_first: usize,
) -> Option<impl Iterator<Item = f64>> {
    let fall = table.launch(point.fall_launch_m_s)?;
    let flights = chain(table, point, fall.impact, missed_first)?;
    let (gravity, contact_s) = (point.gravity_m_s2, point.contact_time_s);
    let backwards = flights.into_iter().rev();
    Some(backwards.scan(0.0, move |before_s, flight| {
        *before_s += flight.time / gravity + contact_s;
        Some(*before_s)
    }))
}

/// Derivatives of the time of all flights (times gravity) and of ln(impact speed) at their end by ln(launch speed) of the
/// first: the chain rule through each flight and each impact between them.
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
