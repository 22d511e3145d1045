//! The drop that the times may stand for: their errors, and the scatter of missed impacts, as the data leave them open.
//!
//! The unknowns alone do not tell the speed at an impact: the times that show it have errors. With given unknowns the
//! errors, the scatter and the residuals are normal together. So noise is drawn as it is before the data, and corrected
//! by what the real residuals say of it (a simulation smoother by mean corrections, J. Durbin and S. J. Koopman,
//! Biometrika 89, 603, 2002).

use nalgebra::DMatrix;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};

use super::banded::Banded;
use super::likelihood::Evaluation;
use super::model::{Model, Point};
use super::observed::Observed;
use super::residual::{Noise, Residual};

/// A drop as the times may tell it.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct DropState {
    pub(super) drop_height_m: f64,
    /// From the release to the first impact detected, and from there to the last one, s.
    pub(super) release_to_first_s: f64,
    pub(super) first_to_last_s: f64,
    /// Speed at each impact detected, m/s.
    pub(super) impact_speeds: Vec<f64>,
    /// Launch speed after each impact detected but the last, m/s, and the height to which it rises, m.
    pub(super) launch_speeds: Vec<f64>,
    pub(super) apexes_m: Vec<f64>,
}

/// What may be beside what the unknowns say.
struct Deviations {
    /// Errors of the times, s.
    errors_s: Vec<f64>,
    /// By how much missed impacts make the logarithms of launch and impact speed larger than the law says, for each end;
    /// of the fall its time shorter, s, in place of the first.
    off: Vec<[f64; 2]>,
}

impl Model<'_> {
    /// A drop that the times may tell, if the unknowns have these values; one of many.
    pub(super) fn drawn_state(&self, point: &Point, rng: &mut ChaCha8Rng) -> Option<DropState> {
        let smoother = Smoother::new(self.observed, point, self.evaluate(point)?);
        let mut deviations = smoother.draw(rng);
        smoother.correct(&mut deviations, rng)?;
        smoother.state(&deviations)
    }
}

struct Smoother<'a> {
    observed: &'a Observed,
    point: &'a Point,
    evaluation: Evaluation<'a>,
    scatter: f64,
    /// Of each residual the standard deviation of the noise that is its alone.
    own_sds: Vec<f64>,
    covariance: Banded,
}

impl<'a> Smoother<'a> {
    fn new(observed: &'a Observed, point: &'a Point, evaluation: Evaluation<'a>) -> Self {
        let noise = Noise::new(&observed.sigma_s, &[*point]);
        let [by_time, by_scatter, by_release] = noise.covariances(&evaluation.details);
        let mut smoother = Self {
            observed,
            point,
            scatter: noise.scatter.0[0],
            own_sds: Vec::new(),
            covariance: Banded::sum([&by_time, &by_scatter, &by_release]),
            evaluation,
        };
        smoother.own_sds = smoother
            .rows()
            .map(|(row, residual)| {
                let shared = smoother.shared_scatter(row, residual);
                let own = by_scatter.diagonal(row) - smoother.scatter * shared;
                (own.max(0.0) + by_release.diagonal(row)).sqrt()
            })
            .collect();
        smoother
    }

    /// Variance of a residual by the scatter of the missed impacts on both sides, for a scatter of one.
    fn shared_scatter(&self, row: usize, residual: &Residual<1>) -> f64 {
        let ends = &self.evaluation.ends;
        let after = self.end_of(row);
        let [launch, ..] = ends[after].gap();
        after.checked_sub(1).map_or(launch, |before| {
            let [_, impact, _] = ends[before].gap();
            launch + residual.keeps.0[0].powi(2) * impact
        })
    }

    /// The number of the end after the impact of a residual; that of a release has none before.
    fn end_of(&self, row: usize) -> usize {
        row + self.evaluation.ends.len() - self.evaluation.details.residuals.len()
    }

    fn sd_s(&self, impact: usize) -> f64 {
        self.point.timing * self.observed.sigma_s[impact]
    }

    /// The residuals, each with its row.
    fn rows(&self) -> impl Iterator<Item = (usize, &Residual<1>)> {
        self.evaluation.details.residuals.iter().enumerate()
    }

    /// Deviations as they are before the data.
    fn draw(&self, rng: &mut ChaCha8Rng) -> Deviations {
        let mut normal = || -> f64 { StandardNormal.sample(rng) };
        let impacts = 0..self.observed.sigma_s.len();
        let errors_s = impacts.map(|impact| self.sd_s(impact) * normal()).collect();
        let off = self.evaluation.ends.iter().map(|end| match end.gap() {
            [0.0, 0.0, _] => [0.0; 2],
            [launch, impact, shared] => {
                let slope = if launch > 0.0 { shared / launch } else { 0.0 };
                let own = (impact - shared * slope).max(0.0);
                let off_launch = launch.sqrt() * normal();
                [off_launch, slope * off_launch + own.sqrt() * normal()]
                    .map(|off| self.point.scatter * off)
            }
        });
        let off = off.collect();
        Deviations { errors_s, off }
    }

    /// Corrects deviations by what the residuals are beyond those that they make.
    fn correct(&self, deviations: &mut Deviations, rng: &mut ChaCha8Rng) -> Option<()> {
        let mut normal = || -> f64 { StandardNormal.sample(rng) };
        let beyond = self.rows().map(|(row, residual)| {
            let mut made = self.own_sds[row] * normal() - deviations.off[self.end_of(row)][0];
            if let Some(before) = self.end_of(row).checked_sub(1) {
                made += residual.keeps.0[0] * deviations.off[before][1];
            }
            for (impact, by_s) in residual.by_times() {
                made += by_s * deviations.errors_s.get(impact).copied().unwrap_or(0.0);
            }
            residual.value.0[0] - made
        });
        let beyond = DMatrix::from_iterator(self.own_sds.len(), 1, beyond);
        let pull = self.covariance.solve(beyond)?;
        let Deviations { errors_s, off } = deviations;
        for (row, residual) in self.rows() {
            let pull = pull[row];
            for (impact, by_s) in residual.by_times() {
                if let Some(error_s) = errors_s.get_mut(impact) {
                    *error_s += self.sd_s(impact).powi(2) * by_s * pull;
                }
            }
            let mut correct = |end: usize, by: [f64; 2]| {
                let [launch, impact, shared] = self.evaluation.ends[end].gap();
                off[end][0] += self.scatter * (launch * by[0] + shared * by[1]) * pull;
                off[end][1] += self.scatter * (shared * by[0] + impact * by[1]) * pull;
            };
            correct(self.end_of(row), [-1.0, 0.0]);
            if let Some(before) = self.end_of(row).checked_sub(1) {
                correct(before, [0.0, residual.keeps.0[0]]);
            }
        }
        Some(())
    }

    /// The drop with these deviations.
    fn state(&self, Deviations { errors_s, off }: &Deviations) -> Option<DropState> {
        let Evaluation {
            fall, table, ends, ..
        } = &self.evaluation;
        let impacts = &self.observed.impacts;
        let time_s = |impact: usize| impacts[impact].time_s - errors_s[impact];
        let mut state = DropState {
            drop_height_m: fall.gravity_height / self.point.gravity_m_s2,
            release_to_first_s: fall.time_s - off[0][0],
            first_to_last_s: time_s(impacts.len() - 1) - time_s(0),
            impact_speeds: Vec::with_capacity(ends.len()),
            launch_speeds: Vec::with_capacity(ends.len() - 1),
            apexes_m: Vec::with_capacity(ends.len() - 1),
        };
        for (place, (end, [off_launch, off_impact])) in ends.iter().zip(off).enumerate() {
            // How much longer the interval was than it seems.
            let longer_s = place
                .checked_sub(1)
                .map_or(0.0, |before| errors_s[before] - errors_s[place]);
            let [launch, impact] = end.speeds_after(longer_s);
            state.impact_speeds.push(impact * off_impact.exp());
            if place > 0 {
                let launch = launch * off_launch.exp();
                let (gravity_height, _) = table.apex(launch)?;
                state.launch_speeds.push(launch);
                state
                    .apexes_m
                    .push(gravity_height / self.point.gravity_m_s2);
            }
        }
        Some(state)
    }
}

#[cfg(test)]
mod tests {
    use rand::SeedableRng;

    use super::*;
    use crate::impact::Impact;
    use crate::inference::likelihood::tests::{impacts, with_model};

    /// Standard error of the times of simulated drops, s, and that of the release of the model.
    const TIME_SD_S: f64 = 1e-3;
    const RELEASE_SD_S: f64 = 3e-3;

    /// A drop of known unknowns, released when the model says or so: the impacts detected, and its state.
    fn simulated(model: &Model, point: &Point, rng: &mut ChaCha8Rng) -> (Vec<Impact>, [f64; 3]) {
        let mut normal = || -> f64 { StandardNormal.sample(rng) };
        let table = model.table(point).unwrap();
        let fall = table.rise_and_fall(point.fall_launch_m_s).unwrap();
        let released_s = model.release_s.unwrap().value - RELEASE_SD_S * normal();
        let mut time_s = released_s + fall.fall_time / point.gravity_m_s2;
        let mut speed = fall.row.impact;
        let mut detected = Vec::new();
        let (mut first_s, mut last_s) = (f64::NAN, f64::NAN);
        // The numbers count from the first one detected, before which one was missed.
        for number in 0..=10 {
            if impacts().iter().any(|impact| impact.number == number) {
                let measured_s = time_s + TIME_SD_S * normal();
                detected.push(Impact::new(number, measured_s).with_time_sd_s(TIME_SD_S));
                if number == 1 {
                    first_s = time_s;
                }
                last_s = time_s;
            }
            if number < 10 {
                let kept = point.law.at(speed) * (point.scatter * normal()).exp();
                let flight = table.launch(speed * kept).unwrap();
                time_s += flight.time / point.gravity_m_s2 + point.contact_time_s;
                speed = flight.impact;
            }
        }
        (detected, [speed, last_s - first_s, first_s - released_s])
    }

    /// Errors of the times, scatter of detected and of missed impacts, and an uncertain release: what is drawn holds the
    /// truth as often as it says.
    #[test]
    fn intervals_of_drawn_states_hold_the_truth() {
        const DROPS: usize = 200;
        const DRAWS: usize = 100;
        let mut rng = ChaCha8Rng::seed_from_u64(1);
        let point = with_model(&impacts(), |model, vector| Point {
            scatter: 0.01,
            timing: 1.0,
            ..model.point(vector).unwrap()
        });
        let mut held = [[0; 2]; 3];
        for _ in 0..DROPS {
            let (detected, truth) =
                with_model(&impacts(), |model, _| simulated(model, &point, &mut rng));
            let drawn: Vec<[f64; 3]> = with_model(&detected, |model, _| {
                let states = (0..DRAWS).map(|_| model.drawn_state(&point, &mut rng).unwrap());
                let quantities = states.map(|state| {
                    let last = state.impact_speeds[state.impact_speeds.len() - 1];
                    [last, state.first_to_last_s, state.release_to_first_s]
                });
                quantities.collect()
            });
            for (quantity, held) in held.iter_mut().enumerate() {
                let below = drawn.iter().filter(|d| d[quantity] < truth[quantity]);
                let share = below.count() as f64 / DRAWS as f64;
                held[0] += usize::from((0.16..0.84).contains(&share));
                held[1] += usize::from((0.025..0.975).contains(&share));
            }
        }
        // Four standard deviations of the counts.
        for [in_68, in_95] in held.map(|held| held.map(|held| held as f64 / DROPS as f64)) {
            assert!((in_68 - 0.68).abs() < 0.13, "{held:?}");
            assert!((in_95 - 0.95).abs() < 0.06, "{held:?}");
        }
    }
}
