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
use super::likelihood::Told;
use super::model::{Model, Point};
use super::residual::Noise;

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

/// What a residual depends on: the law keeps this part of a change of ln(impact speed) before it.
struct Row {
    keeps: f64,
    /// Standard deviation of the noise that is its alone.
    own_sd: f64,
}

impl Model<'_> {
    /// A drop that the times may tell, if the unknowns have these values; one of many.
    pub(super) fn drawn_state(&self, point: &Point, rng: &mut ChaCha8Rng) -> Option<DropState> {
        let Told {
            fall,
            table,
            ends,
            details,
        } = self.told(point)?;
        let observed = self.observed;
        let residuals = &details.residuals;
        let noise = Noise::new(&observed.sigma_s, &[*point]);
        let scatter = noise.scatter.0[0];
        // The end after the impact of each residual; that of a release has none before.
        let after = |row: usize| row + ends.len() - residuals.len();
        let [by_time, by_scatter, by_release] = noise.covariances(&details);
        let rows: Vec<Row> = (0..residuals.len())
            .map(|row| {
                let gaps = ends[after(row)].gap();
                let mut shared = gaps[0];
                let mut keeps = 0.0;
                if let Some(before) = after(row).checked_sub(1) {
                    keeps = 1.0 + point.law.log_slope(ends[before].log_impact.0[0].exp());
                    shared += keeps * keeps * ends[before].gap()[1];
                }
                let own = by_scatter.diagonal(row) - scatter * shared;
                Row {
                    keeps,
                    own_sd: (own.max(0.0) + by_release.diagonal(row)).sqrt(),
                }
            })
            .collect();

        let mut normal = || -> f64 { StandardNormal.sample(rng) };
        let sd_s = |impact: usize| point.timing * observed.sigma_s[impact];
        let mut errors_s: Vec<f64> = (0..observed.sigma_s.len())
            .map(|impact| sd_s(impact) * normal())
            .collect();
        let mut off: Vec<[f64; 2]> = ends
            .iter()
            .map(|end| match end.gap() {
                [0.0, 0.0, _] => [0.0; 2],
                [launch, impact, shared] => {
                    let slope = if launch > 0.0 { shared / launch } else { 0.0 };
                    let own = (impact - shared * slope).max(0.0);
                    let off_launch = launch.sqrt() * normal();
                    [off_launch, slope * off_launch + own.sqrt() * normal()]
                        .map(|off| point.scatter * off)
                }
            })
            .collect();
        // What the residuals are beyond those that this noise makes.
        let beyond = rows.iter().zip(residuals).enumerate();
        let beyond = beyond.map(|(row, (Row { keeps, own_sd }, residual))| {
            let mut made = own_sd * normal() - off[after(row)][0];
            if let Some(before) = after(row).checked_sub(1) {
                made += keeps * off[before][1];
            }
            for (impact, by_s) in residual.by_times() {
                made += by_s * errors_s.get(impact).copied().unwrap_or(0.0);
            }
            residual.value.0[0] - made
        });
        let beyond = DMatrix::from_iterator(rows.len(), 1, beyond);
        let pull = Banded::sum([&by_time, &by_scatter, &by_release]).solve(beyond)?;
        for (row, (Row { keeps, .. }, residual)) in rows.iter().zip(residuals).enumerate() {
            let pull = pull[row];
            for (impact, by_s) in residual.by_times() {
                if let Some(error_s) = errors_s.get_mut(impact) {
                    *error_s += sd_s(impact).powi(2) * by_s * pull;
                }
            }
            let mut correct = |end: usize, by: [f64; 2]| {
                let [launch, impact, shared] = ends[end].gap();
                off[end][0] += scatter * (launch * by[0] + shared * by[1]) * pull;
                off[end][1] += scatter * (shared * by[0] + impact * by[1]) * pull;
            };
            correct(after(row), [-1.0, 0.0]);
            if let Some(before) = after(row).checked_sub(1) {
                correct(before, [0.0, *keeps]);
            }
        }

        let impacts = &observed.impacts;
        let time_s = |impact: usize| impacts[impact].time_s - errors_s[impact];
        let mut state = DropState {
            drop_height_m: fall.gravity_height / point.gravity_m_s2,
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
                state.apexes_m.push(gravity_height / point.gravity_m_s2);
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
