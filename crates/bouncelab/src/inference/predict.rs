//! Predictions: the rest of the drop, and other drops of the same ball.

use std::array;
use std::ops::ControlFlow;

use rand::SeedableRng;
use rand::rngs::Xoshiro256PlusPlus;

use super::parameters::{MAX_BOUNCES, MAX_LOSS_EXPONENT, REST_M_S};
use super::priors::Priors;
use super::sample;
use super::smoothing::DropState;
use super::tail;
use super::unknowns::{Model, Point};
use crate::flight::table::BlendedTable;
use crate::restitution::Restitutions;
use crate::simd::{LANES, Lanes, dispatch};

/// One possibility for the impacts after the last one detected, about which the times contain no information.
pub(super) struct Future {
    /// The ratio of speed lost to speed kept grows as the speed to minus this power, besides the change by the law.
    loss_exponent: f64,
    /// Whether the law holds until rest, whatever its losses.
    law_goes_on: bool,
    pub(super) rng: Xoshiro256PlusPlus,
}

impl Future {
    /// One of many futures of equal probability, by its number.
    pub(super) fn new(priors: &Priors, number: u32) -> Self {
        let exponent = priors.slow_loss_exponent * sample::standard_normal(number);
        Self {
            loss_exponent: exponent.max(0.0),
            law_goes_on: priors.slow_loss_exponent == 0.0,
            rng: Xoshiro256PlusPlus::seed_from_u64(number.into()),
        }
    }
}

/// Time and path from release to rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rest {
    pub(super) time_s: f64,
    pub(super) path_m: f64,
}

/// A drop after its last impact detected, before it comes to rest.
struct Bouncing<'a> {
    /// Its index among the drops.
    number: usize,
    point: Point,
    table: BlendedTable<'a>,
    future: Future,
    /// Logarithm of the speed at the slowest impact detected, and the speed at the one that comes, m/s.
    ln_slowest: f64,
    impact: f64,
    /// The least ratio of speed lost to speed kept at the slowest impact detected.
    least_loss: f64,
    bounces: usize,
    /// Time and path from release to the impact that comes.
    rest: Rest,
}

/// Time and path until rest of each drop: as detected, and after the last impact by its future. `None` for one that does
/// not come to rest.
///
/// One drop is followed in each lane; when it has come to rest, the lane takes the next.
pub(super) fn until_rest<'s>(
    model: &Model,
    drops: impl IntoIterator<Item = (Point, &'s DropState, Future)>,
) -> Vec<Option<Rest>> {
    let mut rests = Vec::new();
    let mut waiting = drops.into_iter();
    let mut lanes: [Option<Bouncing>; LANES] = array::from_fn(|_| None);
    loop {
        for lane in lanes.iter_mut().filter(|lane| lane.is_none()) {
            *lane = waiting.find_map(|(point, state, future)| {
                rests.push(None);
                Bouncing::new(model, point, state, future, rests.len() - 1)
            });
        }
        let Some([expected, launch]) = next_impacts(&mut lanes) else {
            return rests;
        };
        for (index, lane) in lanes.iter_mut().enumerate() {
            let Some(drop) = lane else { continue };
            let after = drop.after_impact(expected.0[index], launch.0[index]);
            if let ControlFlow::Break(rest) = after {
                rests[drop.number] = rest;
                *lane = None;
            }
        }
    }
}

/// The restitution that is expected at the next impact of each drop, and the launch speed after it, m/s; `None` if no lane
/// has a drop.
///
/// With the ratio q = (1 - e)/e of speed lost to speed kept, the law gives q(v) = 1/e(v) - 1. Below the slowest impact
/// detected, v0, it is at least q(v0) (v/v0)^0.6, and grows as (v0/v)^k besides; e = 1/(1 + q).
fn next_impacts(lanes: &mut [Option<Bouncing>; LANES]) -> Option<[Lanes<LANES>; 2]> {
    let any = lanes.iter().flatten().next()?.point.law;
    let random = lanes.each_mut();
    let deviations = tail::draw(random.map(|lane| Some(&mut lane.as_mut()?.future.rng)));
    let law = |lane: &Option<Bouncing>| lane.as_ref().map_or(any, |drop| drop.point.law);
    let laws = Restitutions::of(&array::from_fn(|lane| law(&lanes[lane])));
    let of =
        |number: fn(&Bouncing) -> f64| Lanes::of(|lane| lanes[lane].as_ref().map_or(0.0, number));
    let [impact, ln_slowest] = [of(|it| it.impact), of(|it| it.ln_slowest)];
    let [scatter, exponent] = [of(|it| it.point.scatter), of(|it| it.future.loss_exponent)];
    let least_loss = of(|it| it.least_loss);
    Some(dispatch(
        #[inline(always)]
        || {
            let ln_impact = impact.ln();
            let (ln_e, _) = laws.ln_at_with_log_slope(ln_impact);
            let ln_slower = ln_slowest - ln_impact;
            let by_law = (-ln_e).exp() - 1.0;
            let least = least_loss * (ln_slower.max(0.0) * -MAX_LOSS_EXPONENT).exp();
            let lost_to_kept = (by_law + (least - by_law).max(0.0)) * (ln_slower * exponent).exp();
            let expected = Lanes::all(1.0) / (lost_to_kept + 1.0);
            [expected, impact * expected * (scatter * deviations).exp()]
        },
    ))
}

impl<'a> Bouncing<'a> {
    /// A drop at its last impact detected; `None` if it is beyond the tables.
    fn new(
        model: &Model<'a>,
        point: Point,
        state: &DropState,
        future: Future,
        number: usize,
    ) -> Option<Self> {
        let table = model.table(&point)?;
        let gravity = point.gravity_m_s2;
        let mut path_m = state.drop_height_m;
        // The flights before the first impact detected obey the law too.
        let mut impact = table.launch(point.fall_launch_m_s)?.impact;
        for _ in 0..model.missed_first {
            let launch = impact * point.law.at(impact);
            path_m += 2.0 * table.apex(launch)?.0 / gravity;
            impact = table.launch(launch)?.impact;
        }
        path_m += 2.0 * state.apexes_m.iter().sum::<f64>();
        for (launch, interval) in state.launch_speeds.iter().zip(&model.observed.intervals) {
            let mut launch = *launch;
            for _ in 1..interval.flights {
                let impact = table.launch(launch)?.impact;
                launch = impact * point.law.at(impact);
                path_m += 2.0 * table.apex(launch)?.0 / gravity;
            }
        }
        let slowest = *state.impact_speeds.last()?;
        let least_loss = if future.law_goes_on {
            0.0
        } else {
            1.0 / point.law.at(slowest) - 1.0
        };
        Some(Self {
            number,
            point,
            table: table.for_many(),
            future,
            ln_slowest: Lanes([slowest]).ln().0[0],
            impact: slowest,
            least_loss,
            bounces: 0,
            rest: Rest {
                time_s: state.release_to_first_s + state.first_to_last_s,
                path_m,
            },
        })
    }

    /// Adds an impact with this expected restitution, and the flight after it with this launch speed. Breaks at the end of
    /// the drop, without a result if it does not come to rest.
    fn after_impact(&mut self, expected: f64, launch: f64) -> ControlFlow<Option<Rest>> {
        let gravity = self.point.gravity_m_s2;
        self.rest.time_s += self.point.contact_time_s;
        if launch < (0.5 * gravity * self.point.contact_time_s).max(REST_M_S) {
            // The restitution expected, without scatter, since many impacts follow: that of one may exceed 1.
            let last = last_bounces(launch, expected, gravity);
            self.rest.time_s += last.time_s;
            self.rest.path_m += last.path_m;
            let rest = self.rest.time_s.is_finite().then_some(self.rest);
            return ControlFlow::Break(rest);
        }
        self.bounces += 1;
        let flight = self.table.rise_and_fall(launch);
        let Some(flight) = flight.filter(|_| self.bounces < MAX_BOUNCES) else {
            return ControlFlow::Break(None);
        };
        self.rest.time_s += flight.row.time / gravity;
        self.rest.path_m += 2.0 * flight.gravity_height / gravity;
        self.impact = flight.row.impact;
        ControlFlow::Continue(())
    }
}

/// The flights from a launch until rest, all without air and with the same restitution: geometric
/// series, as in Eqs. 7 and 8 of the paper.
fn last_bounces(launch: f64, restitution: f64, gravity: f64) -> Rest {
    Rest {
        time_s: 2.0 * launch / gravity / (1.0 - restitution),
        path_m: launch * launch / gravity / (1.0 - restitution * restitution),
    }
}

/// The height from which the flight after a bounce (1 for the first) rises to an apex, with the
/// restitution that the law expects.
pub(super) fn drop_height_for(
    model: &Model,
    point: &Point,
    bounce: usize,
    apex_m: f64,
) -> Option<f64> {
    let gravity = point.gravity_m_s2;
    let table = model.table(point)?;
    let mut launch = table.rising_to(gravity * apex_m)?;
    for _ in 0..bounce {
        let impact = point.impact_before(launch)?;
        launch = table.launch_leading_to(impact)?;
    }
    Some(table.apex(launch)?.0 / gravity)
}

/// The apex after the first impact of a drop from a height, with the restitution that the law
/// expects.
pub(super) fn rebound_m(model: &Model, point: &Point, drop_height_m: f64) -> Option<f64> {
    let gravity = point.gravity_m_s2;
    let table = model.table(point)?;
    // A fall is the second half of the flight that rises as high.
    let impact = table
        .launch(table.rising_to(gravity * drop_height_m)?)?
        .impact;
    let apex_m = table.apex(impact * point.law.at(impact))?.0 / gravity;
    apex_m.is_finite().then_some(apex_m)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::inference::likelihood::tests::{impacts, with_model};
    use crate::restitution::Restitution;

    /// Drops of unlike futures, more than there are lanes, come to rest as each does alone; one of them never does.
    #[test]
    fn drops_side_by_side_rest_as_alone() {
        with_model(&impacts(), |model, vector| {
            let point = model.point(vector).unwrap();
            let mut rng = Xoshiro256PlusPlus::seed_from_u64(1);
            let drawn = model.drawn_states(&[point], &mut [Some(&mut rng)]);
            let [state] = drawn.unwrap();
            let drop = |number: u32| {
                let mut point = point;
                point.scatter = 1e-3 * f64::from(number);
                let at_rest = if number == 7 { 1.0 } else { 0.9 };
                point.law = Restitution::linear(at_rest, 0.0).unwrap();
                (point, &state, Future::new(&Priors::default(), number))
            };
            let together = until_rest(model, (0..20).map(drop));
            let alone = (0..20).flat_map(|number| until_rest(model, [drop(number)]));
            assert_eq!(together, alone.collect::<Vec<_>>());
            assert_eq!(together.iter().position(Option::is_none), Some(7));
            assert_eq!(together.iter().flatten().count(), 19);
        });
    }

    /// A law that loses nothing at rest, and so little at low speeds that the ball would bounce for ever, goes on losing as
    /// sound waves do, but where it is to go on until rest.
    #[test]
    fn a_law_that_falls_to_nothing_does_not_bounce_for_ever() {
        with_model(&impacts(), |model, vector| {
            let mut point = model.point(vector).unwrap();
            let mut rng = Xoshiro256PlusPlus::seed_from_u64(1);
            let [state] = model.drawn_states(&[point], &mut [Some(&mut rng)]).unwrap();
            point.law = Restitution::linear(1.0, 0.03).unwrap();
            let rests = |slow_loss_exponent: f64| {
                let priors = Priors {
                    slow_loss_exponent,
                    ..Priors::default()
                };
                let futures = (0..50).map(|number| (point, &state, Future::new(&priors, number)));
                until_rest(model, futures).iter().flatten().count()
            };
            assert_eq!(rests(0.5), 50);
            assert_eq!(rests(0.0), 0);
        });
    }

    /// Added up bounce by bounce: a launch at v lasts 2 v/g and goes v²/g up and down.
    #[test]
    fn the_last_bounces_add_up() {
        let (launch, restitution, gravity) = (0.03, 0.9, 9.81);
        let (mut time_s, mut path_m) = (0.0, 0.0);
        let mut speed: f64 = launch;
        for _ in 0..1000 {
            time_s += 2.0 * speed / gravity;
            path_m += speed * speed / gravity;
            speed *= restitution;
        }
        let rest = last_bounces(launch, restitution, gravity);
        assert!((rest.time_s / time_s - 1.0).abs() < 1e-12);
        assert!((rest.path_m / path_m - 1.0).abs() < 1e-12);
    }
}
