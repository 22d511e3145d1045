//! Predictions: the rest of the drop, and other drops of the same ball.

use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use super::model::{Model, Point};
use super::priors::Priors;
use super::sample;
use super::smoothing::DropState;
use super::tail;
use crate::flight::table::MAX_STEPS;
use crate::impact::Restitutions;
use crate::simd::Lanes;

/// A drop that has not come to rest after so many bounces never will: from a height of a metre it would keep 99.75 % of
/// its speed each time.
const MOST_BOUNCES: usize = 2000;

/// At this launch speed a ball rises five micrometres: what follows is a geometric series, as it is when flights get
/// shorter than the contact.
const REST_M_S: f64 = 0.01;

/// One way in which the impacts after the last one detected may go, of which the times say nothing.
pub(super) struct Future {
    /// The ratio of speed lost to speed kept grows as the speed to minus this power, besides what the law says.
    loss_exponent: f64,
    pub(super) rng: ChaCha8Rng,
}

impl Future {
    /// One of many futures of equal probability, by its number.
    pub(super) fn new(priors: &Priors, number: u32) -> Self {
        let exponent = priors.slow_loss_exponent * sample::standard_normal(number);
        Self {
            loss_exponent: exponent.max(0.0),
            rng: ChaCha8Rng::seed_from_u64(number.into()),
        }
    }

    /// What one expects an impact to keep of the speed, slower than the slowest one detected, by the logarithms of both
    /// speeds; its logarithm too.
    fn ln_expected(&self, laws: &Restitutions<1>, ln_speed: f64, ln_slowest: f64) -> f64 {
        let (Lanes([ln_e]), _) = laws.ln_at_with_log_slope(Lanes([ln_speed]));
        if self.loss_exponent == 0.0 {
            return ln_e;
        }
        let more = (self.loss_exponent * (ln_slowest - ln_speed)).exp();
        -((-ln_e).exp_m1() * more).ln_1p()
    }
}

/// Time and path from release to rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Rest {
    pub(super) time_s: f64,
    pub(super) path_m: f64,
}

/// The drop to its end: as detected, and after the last impact as a future has it.
///
/// `None` if it does not come to rest.
pub(super) fn until_rest(
    model: &Model,
    point: &Point,
    state: &DropState,
    mut future: Future,
) -> Option<Rest> {
    let observed = model.observed;
    let missed_first = model.missed_first;
    let gravity = point.gravity_m_s2;
    let table = model.table(point)?;
    let mut rest = Rest {
        time_s: state.release_to_first_s + state.first_to_last_s,
        path_m: state.drop_height_m,
    };
    // The flights before the first impact detected obey the law too.
    let mut impact = table.launch(point.fall_launch_m_s)?.impact;
    for _ in 0..missed_first {
        let launch = impact * point.law.at(impact);
        rest.path_m += 2.0 * table.apex(launch)?.0 / gravity;
        impact = table.launch(launch)?.impact;
    }
    rest.path_m += 2.0 * state.apexes_m.iter().sum::<f64>();
    for (launch, interval) in state.launch_speeds.iter().zip(&observed.intervals) {
        let mut launch = *launch;
        for _ in 1..interval.flights {
            let impact = table.launch(launch)?.impact;
            launch = impact * point.law.at(impact);
            rest.path_m += 2.0 * table.apex(launch)?.0 / gravity;
        }
    }
    let resting = (0.5 * gravity * point.contact_time_s).max(REST_M_S);
    let laws = Restitutions::of(&[point.law]);
    let mut table = table.for_many();
    let ln_slowest = state.impact_speeds[state.impact_speeds.len() - 1].ln();
    let mut ln_impact = ln_slowest;
    for _ in 0..MOST_BOUNCES {
        let ln_expected = future.ln_expected(&laws, ln_impact, ln_slowest);
        let deviation = tail::draw(&mut future.rng);
        let launch = (ln_impact + ln_expected + point.scatter * deviation).exp();
        rest.time_s += point.contact_time_s;
        if launch < resting {
            // What a single impact keeps may be more than all, and many follow.
            let last = last_bounces(launch, ln_expected.exp(), gravity);
            rest.time_s += last.time_s;
            rest.path_m += last.path_m;
            return rest.time_s.is_finite().then_some(rest);
        }
        let flight = table.rise_and_fall(launch)?;
        rest.time_s += flight.row.time / gravity;
        rest.path_m += 2.0 * flight.gravity_height / gravity;
        ln_impact = flight.row.impact.ln();
    }
    None
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
        let impact = point.impact_before(launch, MAX_STEPS)?;
        launch = table.launch_leading_to(impact, MAX_STEPS)?;
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
