//! Calibration of sessions: simulated studies of 30 drops of one ball on two floors, by two operators.
//!
//! Flights are those of the bench. The floors obey e = a - c v^(1/4), no law of the inference; drops scatter in level, and so
//! do operators; heights differ, one impact in ten is missing, drag, gravity, air, ball and contact time are off by what
//! their priors say, and half of the heights are stated with a ruler whose zero is off. In half of the studies one drop is
//! of another ball: whether it is named is asked of all drops, everything else without it.
//!
//! ```text
//! cargo xtask sessions 200
//! ```
//!
//! prints a table; the argument is the number of studies.

use bouncelab::Estimate;
use bouncelab::analysis::{Options, impacts_of_times};
use bouncelab::groups::{Asked, Study, StudyDrop};
use bouncelab::inference::{Measured, Posterior, Priors, infer};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;

use crate::held::{Held, mean, median, percent, rms};
use crate::independent::{GRAVITY_M_S2, Sphere, normal};
use crate::scenario::SHORTEST_FLIGHT_S;
use crate::{Result, of_seeds, seeded};

const DROPS: usize = 30;
const MAX_IMPACTS: usize = 30;
const MIN_IMPACTS: usize = 6;
const STATED_SD_M: f64 = 0.003;
const ANOTHER_BALL: f64 = -0.03;

/// The speeds at which studies are asked, with the names of the answers.
const ASKED: [(f64, &str, &str); 3] = [
    (0.7, "e at 0.7 m/s", "difference at 0.7 m/s"),
    (1.5, "e at 1.5 m/s", "difference at 1.5 m/s"),
    (2.5, "e at 2.5 m/s", "difference at 2.5 m/s"),
];

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
struct TrueStudy {
    floors: [Floor; 2],
    between_drops: f64,
    operators: [f64; 2],
    sphere: Sphere,
    contact_s: f64,
    zero_m: f64,
}

impl TrueStudy {
    fn drawn(options: &Options, rng: &mut ChaCha8Rng) -> Self {
        let mut floor = || Floor {
            at_rest: 0.80 + 0.18 * rng.random::<f64>(),
            softening: 0.06 * rng.random::<f64>(),
        };
        let floors = [floor(), floor()];
        let mut off = |sd: f64| (sd * normal(rng)).exp();
        let (ball, priors) = (&options.ball, &options.priors);
        let sphere = Sphere {
            mass_kg: ball.mass_kg() * off(priors.mass_rel_sd),
            diameter_m: ball.diameter_m() * off(priors.diameter_rel_sd),
            // Of a sphere in air of another density the drag is in proportion.
            drag: off(priors.drag_rel_sd) * off(priors.air_density_rel_sd),
            gravity_m_s2: GRAVITY_M_S2 * off(priors.gravity_rel_sd),
        };
        let contact_s = options.contact_time_s * off(priors.contact_time_rel_sd);
        let between_drops = 0.002 * off(0.5);
        // Two operators hardly tell it: intervals hold where operators differ as the study expects.
        let between_operators = -0.002 * (1.0 - rng.random::<f64>()).ln();
        Self {
            floors,
            between_drops,
            operators: [0, 1].map(|_| between_operators * normal(rng)),
            sphere,
            contact_s,
            zero_m: STATED_SD_M / 2_f64.sqrt() * normal(rng),
        }
    }

    /// The times of the impacts of a drop from a height.
    fn times_s(&self, floor: &Floor, level: f64, height_m: f64, rng: &mut ChaCha8Rng) -> Vec<f64> {
        let scatter = 0.003 * (0.3 * normal(rng)).exp();
        let (_, mut speed_m_s) = self.sphere.fall(height_m);
        let (mut time_s, mut times_s) = (0.0, Vec::new());
        for number in 0..MAX_IMPACTS {
            let time = time_s + 5e-5 * normal(rng);
            if number == 0 || rng.random::<f64>() > 0.1 {
                times_s.push(time);
            }
            let kept = floor.at(speed_m_s) * (level + scatter * normal(rng)).exp();
            let (flight_s, next_m_s) = self.sphere.flight(speed_m_s * kept.min(1.0));
            if flight_s < SHORTEST_FLIGHT_S {
                break;
            }
            time_s += self.contact_s + flight_s;
            speed_m_s = next_m_s;
        }
        times_s
    }
}

/// Whether intervals hold the truth, and the standard uncertainty.
type Answer = (Held, f64);

fn answer(estimate: &Estimate, truth: f64) -> Answer {
    (Held::of(estimate, truth), estimate.sd)
}

/// A drop of a study.
struct SimulatedDrop {
    added: StudyDrop,
    height_m: f64,
    /// How the inference of this drop alone holds the height.
    alone: Answer,
    is_stated: bool,
    is_odd: bool,
}

/// The drops of a study, and what holds for it.
struct Simulated {
    truth: TrueStudy,
    drops: Vec<SimulatedDrop>,
}

impl Simulated {
    fn new(seed: u64) -> Self {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let options = Options::default();
        let truth = TrueStudy::drawn(&options, &mut rng);
        // In every other study.
        let odd = (seed % 2 == 1).then(|| rng.random_range(0..DROPS));
        let mut drops = Vec::new();
        for number in 0..DROPS {
            let is_odd = odd == Some(number);
            let (on, operator) = (number % 2, number / 2 % 2);
            let of_ball = if is_odd { ANOTHER_BALL } else { 0.0 };
            let level =
                truth.between_drops * normal(&mut rng) + truth.operators[operator] + of_ball;
            // A drop of few impacts is made again.
            let (height_m, times_s) = loop {
                let height_m = 0.15 * (1.0_f64 / 0.15).powf(rng.random());
                let times_s = truth.times_s(&truth.floors[on], level, height_m, &mut rng);
                if times_s.len() >= MIN_IMPACTS {
                    break (height_m, times_s);
                }
            };
            let reading_m = height_m + truth.zero_m + STATED_SD_M / 2_f64.sqrt() * normal(&mut rng);
            let is_stated = number % 4 < 2;
            let priors = Priors {
                drop_height_m: is_stated.then_some(Measured {
                    value: reading_m,
                    sd: STATED_SD_M,
                }),
                ..options.priors.clone()
            };
            let found = infer(
                &impacts_of_times(&times_s),
                &options.ball,
                &options.environment,
                options.contact_time_s,
                &priors,
                &seeded(seed * 1000 + number as u64),
            );
            let evidence = found.as_ref().ok().and_then(Posterior::evidence);
            if let (Ok(found), Some(evidence)) = (found, evidence) {
                drops.push(SimulatedDrop {
                    added: StudyDrop {
                        evidence,
                        scatter: None,
                        levels: vec![Some(on), Some(operator)],
                    },
                    height_m,
                    alone: answer(&found.drop_height_m, height_m),
                    is_stated,
                    is_odd,
                });
            }
        }
        Self { truth, drops }
    }

    fn study(&self, speed_m_s: f64) -> Option<Study> {
        let asked = Asked {
            by: vec![0],
            random: vec![1],
            at_speed_m_s: Some(speed_m_s),
            ..Asked::default()
        };
        let drops = self.drops.iter().map(|drop| drop.added.clone());
        Study::of(&drops.collect::<Vec<_>>(), &asked).ok()
    }

    /// What is asked of the studies, by name.
    fn answers(&self) -> Option<Vec<(&'static str, Answer)>> {
        let mut answers = Vec::new();
        for (speed_m_s, of_group, of_difference) in ASKED {
            let study = self.study(speed_m_s)?;
            let truths = [0, 1].map(|floor| self.truth.floors[floor].at(speed_m_s));
            for (group, truth) in study.groups.iter().zip(truths) {
                answers.push((of_group, answer(&group.restitution?, truth)));
            }
            let difference = study.differences[0].at_speed?.difference;
            answers.push((of_difference, answer(&difference, truths[1] - truths[0])));
        }
        let study = self.study(ASKED[0].0)?;
        for group in &study.groups {
            let held = answer(&group.between_drops, self.truth.between_drops);
            answers.push(("scatter between drops", held));
        }
        let zero = answer(&study.ruler_zero_m?, self.truth.zero_m);
        answers.push(("zero of the ruler", zero));
        for (fitted, drop) in study.drops.iter().zip(&self.drops) {
            let names = if drop.is_stated {
                ["stated height", "stated height, alone"]
            } else {
                ["height", "height, alone"]
            };
            let together = answer(&fitted.as_ref()?.height_m?, drop.height_m);
            answers.extend([(names[0], together), (names[1], drop.alone)]);
        }
        Some(answers)
    }
}

/// What a study says, and which drops it names.
struct Outcome {
    answers: Vec<(&'static str, Answer)>,
    drops: usize,
    /// Whether the drop of another ball is named, if there is one.
    is_odd_named: Option<bool>,
    good_named: usize,
}

fn studied(seed: u64) -> Option<Outcome> {
    let mut simulated = Simulated::new(seed);
    let drops = simulated.drops.len();
    let study = simulated.study(ASKED[0].0)?;
    let named = study
        .outliers
        .iter()
        .map(|it| simulated.drops[it.drop].is_odd);
    let named: Vec<bool> = named.collect();
    let has_odd = simulated.drops.iter().any(|drop| drop.is_odd);
    // The answers are those without it.
    simulated.drops.retain(|drop| !drop.is_odd);
    Some(Outcome {
        answers: simulated.answers()?,
        drops,
        is_odd_named: has_odd.then(|| named.contains(&true)),
        good_named: named.iter().filter(|is_odd| !**is_odd).count(),
    })
}

/// `sessions [STUDIES]`: prints the table.
///
/// # Errors
///
/// None.
pub fn run(arguments: &[String]) -> Result {
    let studies = arguments.first().and_then(|argument| argument.parse().ok());
    let outcomes = of_seeds(studies.unwrap_or(200), studied);
    let all: Vec<&(&str, Answer)> = outcomes.iter().flat_map(|it| &it.answers).collect();
    let mut names: Vec<&str> = Vec::new();
    for (name, _) in &all {
        if !names.contains(name) {
            names.push(name);
        }
    }
    println!("| quantity | count | % in 68 | % in 95 | rms z | mean z | median sd |");
    println!("|---|--:|--:|--:|--:|--:|--:|");
    for name in names {
        let of_name = all.iter().filter(|(it, _)| *it == name);
        let (held, sds): (Vec<Held>, Vec<f64>) = of_name.map(|(_, answer)| *answer).unzip();
        let z = held.iter().map(|held| held.z);
        println!(
            "| {name} | {} | {:.1} | {:.1} | {:.2} | {:.2} | {:.2e} |",
            held.len(),
            percent(&held, |held| held.in68),
            percent(&held, |held| held.in95),
            rms(z.clone()),
            mean(z),
            median(sds).unwrap_or(f64::NAN)
        );
    }
    let odd: Vec<bool> = outcomes.iter().filter_map(|it| it.is_odd_named).collect();
    let named = odd.iter().filter(|named| **named).count();
    println!(
        "\nA drop of another ball: named in {named} of {} studies.",
        odd.len()
    );
    let good: usize = outcomes.iter().map(|it| it.good_named).sum();
    println!(
        "Good drops: {good} of {} named.",
        outcomes.iter().map(|it| it.drops).sum::<usize>() - odd.len()
    );
    Ok(())
}
