//! Calibration of sessions: simulated studies of 30 drops of one ball on two floors, by two operators.
//!
//! The floors obey e = a - c v^(1/4), no law of the inference; drops scatter in level, and so do operators; heights differ,
//! one impact in ten is missing, drag and contact time are off by what their priors say, and half of the heights are stated
//! with a ruler whose zero is off. In half of the studies one drop is of another ball.
//!
//! ```text
//! cargo xtask sessions 200
//! ```
//!
//! prints `docs/tables/sessions.txt`; the argument is the number of studies.

use bouncelab::Estimate;
use bouncelab::analysis::{Options, impacts_of_times};
use bouncelab::drag::DragLaw;
use bouncelab::flight::{Environment, FlightModel};
use bouncelab::groups::{Asked, Study, StudyDrop};
use bouncelab::inference::{Measured, Priors, infer};
use bouncelab::restitution::LawKind;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::StandardNormal;

use crate::scenario::SHORTEST_FLIGHT_S;
use crate::{Result, of_seeds, seeded};

const DROPS: usize = 30;
const MAX_IMPACTS: usize = 30;
const SPEEDS_M_S: [f64; 3] = [0.7, 1.5, 2.5];
const STATED_SD_M: f64 = 0.003;
const ANOTHER_BALL: f64 = -0.03;

/// A floor: ln e = ln(a - c v^(1/4)).
struct Floor {
    at_rest: f64,
    softening: f64,
}

impl Floor {
    fn at(&self, speed_m_s: f64) -> f64 {
        self.at_rest - self.softening * speed_m_s.powf(0.25)
    }
}

/// What holds for a study.
struct World {
    floors: [Floor; 2],
    between_drops: f64,
    operators: [f64; 2],
    model: FlightModel,
    contact_s: f64,
    zero_m: f64,
    odd: Option<usize>,
}

fn normal(rng: &mut ChaCha8Rng) -> f64 {
    rng.sample(StandardNormal)
}

impl World {
    fn drawn(options: &Options, seed: u64, rng: &mut ChaCha8Rng) -> Option<Self> {
        let mut floor = || Floor {
            at_rest: 0.80 + 0.18 * rng.random::<f64>(),
            softening: 0.06 * rng.random::<f64>(),
        };
        let floors = [floor(), floor()];
        let off = |sd: f64, rng: &mut ChaCha8Rng| (sd * normal(rng)).exp();
        let environment = Environment {
            gravity_m_s2: options.environment.gravity_m_s2
                * off(options.priors.gravity_rel_sd, rng),
            // The law, or a constant coefficient.
            drag: if rng.random() {
                options.environment.drag.clone()
            } else {
                DragLaw::Constant(0.4 * off(options.priors.drag_rel_sd, rng))
            },
            ..options.environment
        };
        let between_operators = 0.0015 * off(0.5, rng);
        Some(Self {
            floors,
            between_drops: 0.002 * off(0.5, rng),
            operators: [0, 1].map(|_| between_operators * normal(rng)),
            model: FlightModel::new(&options.ball, &environment).ok()?,
            contact_s: options.contact_time_s * off(0.3, rng),
            zero_m: STATED_SD_M / 2_f64.sqrt() * normal(rng),
            odd: (seed % 2 == 1).then(|| rng.random_range(0..DROPS)),
        })
    }

    /// The times of the impacts of a drop from a height.
    fn times_s(
        &self,
        floor: &Floor,
        level: f64,
        height_m: f64,
        rng: &mut ChaCha8Rng,
    ) -> Option<Vec<f64>> {
        let scatter = 0.003 * (0.3 * normal(rng)).exp();
        let mut speed = self.model.fall(height_m).ok()?.impact_speed_m_s;
        let (mut time_s, mut times_s) = (0.0, Vec::new());
        for number in 0..MAX_IMPACTS {
            let time = time_s + 5e-5 * normal(rng);
            if number == 0 || rng.random::<f64>() > 0.1 {
                times_s.push(time);
            }
            let kept = floor.at(speed) * (level + scatter * normal(rng)).exp();
            let flight = self.model.launch(speed * kept.min(1.0)).ok()?;
            if flight.time_s() < SHORTEST_FLIGHT_S {
                break;
            }
            time_s += self.contact_s + flight.time_s();
            speed = flight.impact_speed_m_s;
        }
        (times_s.len() > 5).then_some(times_s)
    }
}

/// Whether intervals of 68 and 95 % hold the truth, and z.
#[derive(Clone, Copy)]
struct Held([bool; 2], f64, f64);

fn held(estimate: &Estimate, truth: f64) -> Held {
    let holds = |[low, high]: [f64; 2]| (low..=high).contains(&truth);
    let intervals = [estimate.interval68, estimate.interval95];
    Held(
        intervals.map(holds),
        (estimate.value - truth) / estimate.sd,
        estimate.sd,
    )
}

/// What is asked of a study, by name.
type Answers = Vec<(&'static str, Held)>;

#[expect(clippy::too_many_lines, reason = "one question after the other")]
fn studied(seed: u64) -> Option<Answers> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let options = Options::default();
    let world = World::drawn(&options, seed, &mut rng)?;
    let (mut drops, mut heights) = (Vec::new(), Vec::new());
    for number in 0..DROPS {
        let (on, operator) = (number % 2, number / 2 % 2);
        let height_m = 0.15 * (1.0_f64 / 0.15).powf(rng.random());
        let odd = if world.odd == Some(number) {
            ANOTHER_BALL
        } else {
            0.0
        };
        let level = world.between_drops * normal(&mut rng) + world.operators[operator] + odd;
        let times_s = world.times_s(&world.floors[on], level, height_m, &mut rng)?;
        let reading_m = height_m + world.zero_m + STATED_SD_M / 2_f64.sqrt() * normal(&mut rng);
        let stated = (number % 4 < 2).then_some(Measured {
            value: reading_m,
            sd: STATED_SD_M,
        });
        let priors = Priors {
            restitution_laws: vec![LawKind::Smooth],
            drop_height_m: stated,
            ..options.priors.clone()
        };
        let impacts = impacts_of_times(&times_s);
        let inference = seeded(seed * 1000 + number as u64);
        let found = infer(
            &impacts,
            &options.ball,
            &options.environment,
            options.contact_time_s,
            &priors,
            &inference,
        )
        .ok()?;
        heights.push((
            height_m,
            held(&found.drop_height_m, height_m),
            stated.is_some(),
        ));
        drops.push(StudyDrop {
            evidence: found.evidence()?,
            scatter: None,
            levels: vec![Some(on), Some(operator)],
        });
    }
    let asked = Asked {
        by: vec![0],
        random: vec![1],
        ..Asked::default()
    };
    let mut answers = Answers::new();
    let of_speeds = ["e at 0.7 m/s", "e at 1.5 m/s", "e at 2.5 m/s"];
    let of_differences = [
        "difference at 0.7 m/s",
        "difference at 1.5 m/s",
        "difference at 2.5 m/s",
    ];
    for (number, speed_m_s) in SPEEDS_M_S.into_iter().enumerate() {
        let asked = Asked {
            at_speed_m_s: Some(speed_m_s),
            ..asked.clone()
        };
        let study = Study::of(&drops, &asked).ok()?;
        // The odd drop is in it: where there is one, nothing else is asked but whether it is named.
        if let Some(odd) = world.odd {
            let is_named = study.outliers.iter().any(|outlier| outlier.drop == odd);
            answers.push(("another ball named", Held([is_named; 2], 0.0, 0.0)));
            return Some(answers);
        }
        let truths = [0, 1].map(|floor| world.floors[floor].at(speed_m_s));
        for (group, truth) in study.groups.iter().zip(truths) {
            answers.push((of_speeds[number], held(&group.restitution?, truth)));
        }
        let difference = study.differences[0].at_speed?.difference;
        answers.push((
            of_differences[number],
            held(&difference, truths[1] - truths[0]),
        ));
        if number > 0 {
            continue;
        }
        for group in &study.groups {
            answers.push((
                "scatter between drops",
                held(&group.between_drops, world.between_drops),
            ));
        }
        answers.push((
            "zero of the ruler",
            held(&study.ruler_zero_m?, world.zero_m),
        ));
        for (drop, &(truth, alone, is_stated)) in study.drops.iter().zip(&heights) {
            let names = if is_stated {
                ["stated height", "stated height, alone"]
            } else {
                ["height", "height, alone"]
            };
            answers.push((names[0], held(&drop.as_ref()?.height_m?, truth)));
            answers.push((names[1], alone));
        }
        let falsely = study.outliers.len() as f64 / DROPS as f64;
        answers.push(("good drops named", Held([falsely == 0.0; 2], falsely, 0.0)));
    }
    Some(answers)
}

/// `sessions [STUDIES]`: prints the table.
///
/// # Errors
///
/// None.
pub fn run(arguments: &[String]) -> Result {
    let studies = arguments.first().and_then(|argument| argument.parse().ok());
    let all: Vec<(&'static str, Held)> = of_seeds(studies.unwrap_or(200), studied).concat();
    let mut names: Vec<&'static str> = Vec::new();
    for (name, _) in &all {
        if !names.contains(name) {
            names.push(name);
        }
    }
    println!("| quantity | count | % in 68 | % in 95 | rms z | mean z | median sd |");
    println!("|---|---|---|---|---|---|---|");
    for name in names {
        let of: Vec<Held> = all
            .iter()
            .filter(|(it, _)| *it == name)
            .map(|(_, held)| *held)
            .collect();
        let count = of.len() as f64;
        let share =
            |index: usize| 100.0 * of.iter().filter(|held| held.0[index]).count() as f64 / count;
        let mean = of.iter().map(|held| held.1).sum::<f64>() / count;
        let square = of.iter().map(|held| held.1 * held.1).sum::<f64>() / count;
        let mut sds: Vec<f64> = of.iter().map(|held| held.2).collect();
        sds.sort_by(f64::total_cmp);
        println!(
            "| {name} | {} | {:.1} | {:.1} | {:.2} | {mean:.2} | {:.2e} |",
            of.len(),
            share(0),
            share(1),
            square.sqrt(),
            sds[sds.len() / 2]
        );
    }
    Ok(())
}
