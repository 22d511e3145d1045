//! Vectors that are evaluated at once, one in each lane, with their points, flights and falls.

use std::array;

use super::parameters::MIN_KEPT;
use super::priors::Measured;
use super::residual::InitialFall;
use super::timed_flights::FlightsAtStrengths;
use super::unknowns::{Height, Model, Point, Slot};
use crate::flight::table::{FlightTable, MIN_SLOPE, Row};
use crate::restitution::Restitutions;
use crate::simd::{Lanes, dispatch};

/// Points that are evaluated at once, one in each lane, with their flights and falls.
#[derive(Debug, Clone)]
pub(super) struct Trials<'a, const L: usize> {
    pub(super) points: [Point; L],
    pub(super) tables: [FlightTable<'a>; L],
    pub(super) flights: FlightsAtStrengths<'a, L>,
    pub(super) falls: [InitialFall; L],
    /// Whether the point is valid; the results of other lanes are ignored.
    pub(super) valid: [bool; L],
}

impl<'a> Model<'a> {
    /// The values of the unknowns at a vector; `None` if it is not valid.
    pub(super) fn point(&self, vector: &[f64]) -> Option<Point> {
        let [point] = self.points(&[vector]);
        point
    }

    /// The values of the unknowns at each vector.
    pub(super) fn points<const L: usize>(&self, vectors: &[&[f64]; L]) -> [Option<Point>; L] {
        let found = dispatch(
            #[inline(always)]
            || self.points_in_tables(vectors),
        );
        let Some((points, _, valid)) = found else {
            return [None; L];
        };
        array::from_fn(|lane| {
            let valid = valid[lane] && points[lane].fall_launch_m_s.is_finite();
            valid.then_some(points[lane])
        })
    }

    /// Vectors with their points, flights and falls; `None` if none of them is valid.
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    pub(super) fn trials<const L: usize>(&self, vectors: &[&[f64]; L]) -> Option<Trials<'a, L>> {
        let (points, tables, valid) = self.points_in_tables(vectors)?;
        self.trials_of(points, tables, valid)
    }

    /// The points of vectors, their flights, and which of them are valid so far.
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    fn points_in_tables<const L: usize>(
        &self,
        vectors: &[&[f64]; L],
    ) -> Option<([Point; L], [FlightTable<'a>; L], [bool; L])> {
        let mut valid = [true; L];
        let mut points = filled(self.values(vectors), &mut valid)?;
        let tables = points.each_ref().map(|point| self.table(point));
        let tables = filled(tables, &mut valid)?;
        let index = self.index(Slot::Height)?;
        let coordinate = Lanes::of(|lane| vectors[lane][index]);
        let launches = match self.height() {
            Height::Speed => coordinate.exp(),
            Height::Measured(Measured { value, sd }) => Lanes::of(|lane| {
                let gravity_height = points[lane].gravity_m_s2 * (value + sd * coordinate.0[lane]);
                tables[lane].rising_to(gravity_height).unwrap_or(f64::NAN)
            }),
            Height::FromFirstFlight => {
                let of = |number: fn(&Point) -> f64| Lanes::of(|lane| number(&points[lane]));
                let noise = self.noise(0, of(|point| point.scatter), of(|point| point.timing));
                for (point, unit) in points.iter_mut().zip(noise.ln().0) {
                    point.log_density += unit;
                }
                (self.suggested_ln_launch(&points, &tables) + noise * coordinate).exp()
            }
        };
        for (point, launch) in points.iter_mut().zip(launches.0) {
            point.fall_launch_m_s = launch;
        }
        Some((points, tables, valid))
    }

    /// Points with their flights and falls; `None` if none of them is valid.
    pub(super) fn trials_at<const L: usize>(&self, points: &[Point; L]) -> Option<Trials<'a, L>> {
        let mut valid = [true; L];
        let tables = points.each_ref().map(|point| self.table(point));
        let tables = filled(tables, &mut valid)?;
        self.trials_of(*points, tables, valid)
    }

    /// Points and tables with their flights and falls; `None` if none of them is valid.
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    fn trials_of<const L: usize>(
        &self,
        points: [Point; L],
        tables: [FlightTable<'a>; L],
        mut valid: [bool; L],
    ) -> Option<Trials<'a, L>> {
        let fall = |lane: usize| InitialFall::new(&tables[lane], &points[lane], self.missed_first);
        let falls = filled(array::from_fn(fall), &mut valid)?;
        Some(Trials {
            flights: self.timed_flights.at(&self.medium.flights, &tables),
            points,
            tables,
            falls,
            valid,
        })
    }

    /// Approximate logarithms of the launch speeds with which the ball would rise to the drop heights, by the first flight and
    /// the law. Since it is only the origin of a coordinate, any smooth function of the unknowns serves: from the launch
    /// after the first impact one Newton step to the impact speed before it (ln v + ln e(v) = ln(launch)), and one to the
    /// launch of the flight that ends with it.
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    fn suggested_ln_launch<const L: usize>(
        &self,
        points: &[Point; L],
        tables: &[FlightTable; L],
    ) -> Lanes<L> {
        let first = self.observed.intervals[0];
        let laws = Restitutions::of(&points.map(|point| point.law));
        let ln_launch = Lanes::of(|lane| {
            let point = &points[lane];
            let flight_s = first.duration_s / first.flights as f64 - point.contact_time_s;
            let row = tables[lane].lasting(point.gravity_m_s2 * flight_s);
            row.map_or(f64::NAN, |row| row.launch)
        })
        .ln();
        let mut ln_impact = ln_launch - laws.ln_at_with_log_slope(ln_launch).0;
        let (ln_restitution, log_slope) = laws.ln_at_with_log_slope(ln_impact);
        let off = ln_launch - ln_impact - ln_restitution;
        ln_impact = ln_impact + off / (log_slope + 1.0).max(MIN_KEPT);
        let impact = ln_impact.exp();
        let rows: [Option<Row>; L] = array::from_fn(|lane| tables[lane].launch(impact.0[lane]));
        let of = |number: fn(&Row) -> f64| {
            Lanes::of(|lane| rows[lane].as_ref().map_or(f64::NAN, number))
        };
        let off = ln_impact - of(|row| row.impact).ln();
        ln_impact + off / of(|row| row.impact_slope).max(MIN_SLOPE)
    }

    /// The drop height of a point, m.
    pub(super) fn drop_height_m(&self, point: &Point) -> Option<f64> {
        let (gravity_height, _) = self.table(point)?.apex(point.fall_launch_m_s)?;
        Some(gravity_height / point.gravity_m_s2)
    }

    /// The flights under the drag of a point; `None` if that is beyond the tables.
    pub(super) fn table(&self, point: &Point) -> Option<FlightTable<'a>> {
        self.medium.flights.at(point.drag_strength)
    }
}

/// The value of each lane; a lane without a value gets that of another and is marked as not valid. `None` if no lane has a
/// value.
#[inline(always)]
fn filled<T: Copy, const L: usize>(
    values: [Option<T>; L],
    valid: &mut [bool; L],
) -> Option<[T; L]> {
    let other = values.iter().flatten().next().copied()?;
    for (valid, value) in valid.iter_mut().zip(&values) {
        *valid &= value.is_some();
    }
    Some(values.map(|value| value.unwrap_or(other)))
}
