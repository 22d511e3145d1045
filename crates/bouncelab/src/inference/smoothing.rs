//! Draws of the whole drop, given its unknowns: the errors of the times and the scatter of missed impacts.
//!
//! The unknowns alone do not determine the speed at an impact: the times that show it have errors. Given the unknowns,
//! the noise x (errors and scatter) and the residuals r = A x + own noise are jointly normal. To draw x given r, a simulation
//! smoother draws noise x0 from its prior, computes the residuals r0 that it would make, and corrects it by the
//! regression on the difference: x = x0 + S A' C⁻¹ (r - r0), with the covariances S of x and C of r (J. Durbin and S. J.
//! Koopman, Biometrika 89, 603, 2002).

use rand::rngs::Xoshiro256PlusPlus;
use rand_distr::{Distribution, StandardNormal};

use super::banded::Banded;
use super::likelihood::Evaluation;
use super::observed::Observed;
use super::residual::{Gap, Noise, Residual};
use super::unknowns::{Model, Point};
use crate::simd::{Lanes, dispatch};

/// A drop that is compatible with the times.
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

/// The random number generator of each lane that is in use.
type Random<'r, const L: usize> = [Option<&'r mut Xoshiro256PlusPlus>; L];

/// The noise: deviations from what the unknowns determine.
struct Deviations<const L: usize> {
    /// Errors of the times, s.
    errors_s: Vec<Lanes<L>>,
    /// For each end the deviations of ln(launch speed) and ln(impact speed) from the law by missed impacts; for the fall the
    /// first is minus the deviation of its time, s.
    off: Vec<[Lanes<L>; 2]>,
}

impl Model<'_> {
    /// One draw of the drop for each point, given its values of the unknowns. `None` if one of the points is not valid.
    pub(super) fn drawn_states<const L: usize>(
        &self,
        points: &[Point; L],
        random: &mut Random<L>,
    ) -> Option<[DropState; L]> {
        let evaluation = self.evaluate(points)?;
        let (deviations, speeds) = dispatch(
            #[inline(always)]
            || {
                let smoother = Smoother::new(self.observed, points, &evaluation);
                let mut deviations = smoother.draw(random);
                smoother.correct(&mut deviations, random);
                let speeds = smoother.speeds(&deviations);
                (deviations, speeds)
            },
        );
        let impacts = &self.observed.impacts;
        let state = |lane: usize| {
            let Deviations { errors_s, off } = &deviations;
            let time_s = |impact: usize| impacts[impact].time_s - errors_s[impact].0[lane];
            let gravity_m_s2 = points[lane].gravity_m_s2;
            let fall = &evaluation.falls[lane];
            let launches = speeds[1..].iter().map(|[launch, _]| launch.0[lane]);
            let apexes = launches.clone().map(|launch| {
                let (gravity_height, _) = evaluation.tables[lane].apex(launch)?;
                Some(gravity_height / gravity_m_s2)
            });
            Some(DropState {
                drop_height_m: fall.gravity_height / gravity_m_s2,
                release_to_first_s: fall.time_s - off[0][0].0[lane],
                first_to_last_s: time_s(impacts.len() - 1) - time_s(0),
                impact_speeds: speeds.iter().map(|[_, impact]| impact.0[lane]).collect(),
                apexes_m: apexes.collect::<Option<_>>()?,
                launch_speeds: launches.collect(),
            })
        };
        let states: Vec<DropState> = (0..L).map(state).collect::<Option<_>>()?;
        states.try_into().ok()
    }
}

struct Smoother<'a, const L: usize> {
    evaluation: &'a Evaluation<'a, L>,
    /// Standard deviation of the scatter and of each time, s.
    scatter: Lanes<L>,
    times_s: Vec<Lanes<L>>,
    /// Standard deviation of the noise that a residual does not share with others: its own scatter and that of a release.
    own_sds: Vec<Lanes<L>>,
    covariance: Banded<L>,
}

impl<'a, const L: usize> Smoother<'a, L> {
    #[inline(always)]
    fn new(observed: &Observed, points: &[Point; L], evaluation: &'a Evaluation<'a, L>) -> Self {
        let noise = Noise::new(&observed.sigma_s, points);
        let weights = evaluation.weights.iter().copied();
        let [by_time, by_scatter, by_release] = noise.covariances(&evaluation.residuals, weights);
        let timing = Lanes::of(|lane| points[lane].timing);
        let mut smoother = Self {
            scatter: Lanes::of(|lane| points[lane].scatter),
            times_s: observed
                .sigma_s
                .iter()
                .map(|&sigma_s| timing * sigma_s)
                .collect(),
            own_sds: Vec::new(),
            covariance: Banded::sum([&by_time, &by_scatter, &by_release]),
            evaluation,
        };
        let own = smoother.rows().map(|(row, residual)| {
            let shared = smoother.shared_scatter(row, residual);
            let own = by_scatter.diagonal(row) - noise.scatter * shared;
            (own.max(0.0) + by_release.diagonal(row)).sqrt()
        });
        smoother.own_sds = own.collect();
        smoother
    }

    /// Variance of a residual by the scatter of the missed impacts on both sides, for a scatter of one.
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    fn shared_scatter(&self, row: usize, residual: &Residual<L>) -> Lanes<L> {
        let [before, after] = self.gaps(row);
        let mut shared = Lanes::all(0.0);
        if let Some(before) = before {
            shared = shared + residual.keeps * residual.keeps * before.impact;
        }
        if let Some(after) = after {
            shared = shared + after.launch;
        }
        shared
    }

    /// The gaps before and after the impact of a residual.
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    fn gaps(&self, row: usize) -> [Option<Gap<L>>; 2] {
        let after = self.end_of(row);
        let gap = |end: usize| self.evaluation.ends[end].gap();
        [after.checked_sub(1).and_then(gap), gap(after)]
    }

    /// Index of the end after the impact of a residual; the residual of a release has no end before it.
    #[inline(always)]
    fn end_of(&self, row: usize) -> usize {
        row + self.evaluation.ends.len() - self.evaluation.residuals.len()
    }

    /// The residuals, each with its row.
    #[inline(always)]
    fn rows(&self) -> impl Iterator<Item = (usize, &Residual<L>)> {
        self.evaluation.residuals.iter().enumerate()
    }

    /// x0: deviations drawn from their prior. Those of both ends of a gap are correlated, so the second is its regression on
    /// the first plus an independent part.
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    fn draw(&self, random: &mut Random<L>) -> Deviations<L> {
        let errors_s = self.times_s.iter().map(|&sd_s| sd_s * normal(random));
        let errors_s = errors_s.collect();
        let off = self.evaluation.ends.iter().map(|end| match end.gap() {
            None => [Lanes::all(0.0); 2],
            Some(Gap {
                launch,
                impact,
                shared,
            }) => {
                let slope = launch.if_positive(shared / launch, Lanes::all(0.0));
                let own = (impact - shared * slope).max(0.0);
                let off_launch = launch.sqrt() * normal(random);
                [off_launch, slope * off_launch + own.sqrt() * normal(random)]
                    .map(|off| self.scatter * off)
            }
        });
        let off = off.collect();
        Deviations { errors_s, off }
    }

    /// x = x0 + S A' C⁻¹ (r - r0).
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    fn correct(&self, deviations: &mut Deviations<L>, random: &mut Random<L>) {
        let Deviations { errors_s, off } = deviations;
        // r - r0, with the derivatives of each residual by its times and by the gaps on both sides.
        let difference = self.rows().map(|(row, residual)| {
            let after = self.end_of(row);
            let mut simulated = self.own_sds[row] * normal(random) - off[after][0];
            if let Some(before) = after.checked_sub(1) {
                simulated = simulated + residual.keeps * off[before][1];
            }
            for (impact, by_s) in residual.by_times() {
                if let Some(error_s) = errors_s.get(impact) {
                    simulated = simulated + by_s * *error_s;
                }
            }
            residual.value - simulated
        });
        let mut pull: Vec<Lanes<L>> = difference.collect();
        self.covariance.solve(&mut pull);
        // S A' times the solution: each deviation by its covariance with the residual.
        let scatter = self.scatter * self.scatter;
        for ((row, residual), pull) in self.rows().zip(pull) {
            for (impact, by_s) in residual.by_times() {
                if let Some(error_s) = errors_s.get_mut(impact) {
                    let sd_s = self.times_s[impact];
                    *error_s = *error_s + sd_s * sd_s * by_s * pull;
                }
            }
            let after = self.end_of(row);
            let [gap_before, gap_after] = self.gaps(row);
            if let Some(gap) = gap_after {
                off[after][0] = off[after][0] - scatter * gap.launch * pull;
                off[after][1] = off[after][1] - scatter * gap.shared * pull;
            }
            if let Some(gap) = gap_before {
                let before = &mut off[after - 1];
                let by = scatter * residual.keeps * pull;
                before[0] = before[0] + gap.shared * by;
                before[1] = before[1] + gap.impact * by;
            }
        }
    }

    /// Launch speed of the flight and speed of the impact after it at each end, m/s, with these deviations.
    #[cfg_attr(not(target_family = "wasm"), inline(always))]
    fn speeds(&self, Deviations { errors_s, off }: &Deviations<L>) -> Vec<[Lanes<L>; 2]> {
        let ends = self.evaluation.ends.iter().zip(off).enumerate();
        ends.map(|(index, (end, off))| {
            // The interval was longer than measured by the difference of its errors. The fall has no launch.
            match index.checked_sub(1) {
                None => end.speeds_after(Lanes::all(0.0), *off),
                Some(before) => end.speeds_after(errors_s[before] - errors_s[index], *off),
            }
        })
        .collect()
    }
}

/// A standard normal in each lane.
#[cfg_attr(not(target_family = "wasm"), inline(always))]
fn normal<const L: usize>(random: &mut Random<L>) -> Lanes<L> {
    let mut normals = Lanes::all(0.0);
    for (normal, rng) in normals.0.iter_mut().zip(random) {
        if let Some(rng) = rng {
            *normal = StandardNormal.sample(rng);
        }
    }
    normals
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

    /// A drop with given unknowns, released at the time of the model but for its error: the impacts detected, and its state.
    fn simulated(
        model: &Model,
        point: &Point,
        rng: &mut Xoshiro256PlusPlus,
    ) -> (Vec<Impact>, [f64; 3]) {
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

    /// Draws for several points at once are those for each point alone with the same random numbers.
    #[test]
    fn states_drawn_side_by_side_are_those_drawn_alone() {
        with_model(&impacts(), |model, vector| {
            let points = [0.0, 0.3, -0.2].map(|off| {
                let vector: Vec<f64> = vector.iter().map(|value| value + off).collect();
                model.point(&vector).unwrap()
            });
            let rng = |lane: u64| Xoshiro256PlusPlus::seed_from_u64(lane);
            let [mut a, mut b] = [rng(0), rng(1)];
            let together = model.drawn_states(&points, &mut [Some(&mut a), Some(&mut b), None]);
            for (lane, together) in (0..2).zip(together.unwrap()) {
                let point = points[lane as usize];
                let alone = model.drawn_states(&[point], &mut [Some(&mut rng(lane))]);
                assert_eq!(alone, Some([together]));
            }
        });
    }

    /// Errors of the times, scatter of detected and of missed impacts, and an uncertain release: intervals of the draws
    /// contain the truth with their probability.
    #[test]
    fn intervals_of_drawn_states_hold_the_truth() {
        const DROPS: usize = 200;
        const DRAWS: usize = 100;
        let mut rng = Xoshiro256PlusPlus::seed_from_u64(1);
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
                let mut drawn = || model.drawn_states(&[point], &mut [Some(&mut rng)]);
                let states = (0..DRAWS).map(|_| drawn().unwrap());
                let quantities = states.map(|[state]| {
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
