//! Worlds in which the model of the inference is not exactly true.
//!
//! Drops of balls that obey no law of the inference, of which impacts are missing or wild, whose times
//! are rounded, and so on, are inferred from their times alone, with every default of `analyze`. What is
//! asked is whether the intervals still hold the truth.
//!
//! ```text
//! cargo xtask calibrate worlds 300
//! ```
//!
//! prints the second table of `docs/validation.md`; the argument is the number of drops for each world,
//! and names after it leave out all others. Names of restitution laws leave out the others of those. With
//! `impacts=4` no drop has more impacts than that.

#![expect(clippy::print_stdout, reason = "it prints for contributors")]

use std::thread;

use bouncelab::analysis::{Options, impacts_of_times};
use bouncelab::drag::DragLaw;
use bouncelab::flight::{Environment, FlightModel};
use bouncelab::impact::Restitution;
use bouncelab::inference::{InferenceOptions, LawKind, Posterior, Priors, SamplerConfig, infer};
use bouncelab::{Estimate, Impact};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::StandardNormal;

/// What differs from the model.
#[derive(Clone, Copy, PartialEq)]
enum World {
    /// Nothing: one of the five laws, each as likely.
    True,
    /// e0 - 0.03 v^(1/4), none of the five.
    NoLaw,
    /// One impact in ten is unheard, each by itself.
    Missing,
    /// As many, in runs of two on average.
    MissingRuns,
    /// 3 % of the impacts scatter ten times as much.
    Wild,
    /// Times rounded to a millisecond.
    Rounded,
    /// Times with errors of 2 ms or so, as those noted by hand have, which nobody stated.
    Noted,
    /// The ball drifts away from the microphone, or to it, at 10 cm/s or so.
    Drifting,
    /// From some impact on, the surface is another, 1 % better or worse or so.
    TwoSurfaces,
    /// The contact lasts twice as long as stated.
    WrongContact,
    /// Restitution scatters by 2 % or so, three times as much as is assumed.
    Rough,
    /// The same, and that is stated.
    RoughStated,
}

impl World {
    const ALL: [(Self, &str); 12] = [
        (Self::True, "true"),
        (Self::NoLaw, "no-law"),
        (Self::Missing, "missing"),
        (Self::MissingRuns, "missing-runs"),
        (Self::Wild, "wild"),
        (Self::Rounded, "rounded"),
        (Self::Noted, "noted"),
        (Self::Drifting, "drifting"),
        (Self::TwoSurfaces, "two-surfaces"),
        (Self::WrongContact, "wrong-contact"),
        (Self::Rough, "rough"),
        (Self::RoughStated, "rough-stated"),
    ];
}

/// Drops end at this many impacts unless asked otherwise, or when flights get as short as this, as they do in
/// recordings.
const MOST_IMPACTS: usize = 40;
const SHORTEST_FLIGHT_S: f64 = 0.05;
/// A drop that goes on for so many impacts never rests.
const MOST_BOUNCES: usize = 2000;
/// What follows a launch as slow as this, in m/s, is a geometric series.
const REST_M_S: f64 = 0.01;
/// Scatter of the restitution on a rough surface.
const ROUGH: f64 = 0.02;
/// Fewer impacts make no drop for the listener; only a list of times may have so few.
const FEWEST_IMPACTS: usize = 5;

/// A drop as heard, and its truth.
struct Drop {
    times_s: Vec<f64>,
    law: Law,
    /// Restitution of the second surface over that of the first, and the speed of the first impact on it, m/s.
    second: (f64, f64),
    height_m: f64,
    first_impact_m_s: f64,
    /// From the release until rest; `None` if it never rests.
    rest_s: Option<f64>,
    /// Numbers of the impacts heard, the first 1.
    numbers: Vec<usize>,
}

enum Law {
    Known(Restitution),
    QuarterPower(f64),
}

impl Law {
    fn drawn(world: World, rng: &mut ChaCha8Rng) -> Option<Self> {
        let e = 0.6 + 0.37 * rng.random::<f64>();
        let slope = 0.1 * rng.sample::<f64, _>(StandardNormal);
        if world == World::NoLaw {
            return Some(Self::QuarterPower(e + 0.03));
        }
        let middle = 1.5;
        let law = match rng.random_range(0..5) {
            0 => Restitution::constant(e),
            1 => Restitution::linear(e * (1.0 + slope * middle / 4.0), e * slope / 4.0),
            2 => Restitution::power(e, middle, slope),
            3 => Restitution::viscoelastic_through(e, middle),
            _ => Restitution::knee(e, middle, 0.05 * e / middle),
        };
        law.ok().map(Self::Known)
    }

    fn at(&self, speed_m_s: f64) -> f64 {
        match self {
            Self::Known(law) => law.at(speed_m_s),
            Self::QuarterPower(at_rest) => at_rest - 0.03 * speed_m_s.powf(0.25),
        }
    }
}

impl Drop {
    /// `None` if it is too short to be heard as a drop.
    fn drawn(world: World, most_impacts: usize, rng: &mut ChaCha8Rng) -> Option<Self> {
        let Options {
            ball,
            environment,
            contact_time_s,
            priors,
            ..
        } = Options::default();
        let normal = |rng: &mut ChaCha8Rng| rng.sample::<f64, _>(StandardNormal);
        let law = Law::drawn(world, rng)?;
        let height_m = 0.15 * 10_f64.powf(rng.random());
        let environment = Environment {
            gravity_m_s2: environment.gravity_m_s2 * (priors.gravity_rel_sd * normal(rng)).exp(),
            // Half of the balls have the drag of the law, half a constant coefficient.
            drag: if rng.random::<bool>() {
                environment.drag
            } else {
                DragLaw::Constant(0.4 * (priors.drag_rel_sd * normal(rng)).exp())
            },
            ..environment
        };
        let model = FlightModel::new(&ball, &environment).ok()?;
        let usual = match world {
            World::Rough | World::RoughStated => ROUGH,
            _ => 0.003,
        };
        let scatter = usual * (0.7 * normal(rng)).exp();
        let usual_s = if world == World::Noted { 2e-3 } else { 5e-5 };
        let sigma_s = usual_s * (0.7 * normal(rng)).exp();
        let contact_s = match world {
            World::WrongContact => 2.0 * contact_time_s,
            _ => contact_time_s * (0.3 * normal(rng)).exp(),
        };
        // Sound takes 2.9 ms for each metre.
        let delay_per_s = match world {
            World::Drifting => 0.1 * normal(rng) / 343.0,
            _ => 0.0,
        };
        let (second_per_first, second_from) = match world {
            World::TwoSurfaces => ((0.01 * normal(rng)).exp(), rng.random_range(2..12)),
            _ => (1.0, usize::MAX),
        };
        let mut second = (1.0, 0.0);
        let fall = model.fall(height_m).ok()?;
        let first_impact_m_s = fall.impact_speed_m_s;
        let mut speed = first_impact_m_s;
        let (mut time_s, mut missing, mut heard, mut rest_s) = (0.0, false, true, None);
        let (mut times_s, mut numbers) = (Vec::new(), Vec::new());
        for number in 1..=MOST_BOUNCES {
            missing = match world {
                World::Missing => rng.random::<f64>() < 0.1,
                // In a run it goes on every other time: 10 % of all.
                World::MissingRuns => rng.random::<f64>() < if missing { 0.5 } else { 0.055 },
                _ => false,
            };
            let off = sigma_s * normal(rng);
            if number == 1 || heard && !missing {
                let heard_s = time_s * (1.0 + delay_per_s) + off;
                // So fine a grid is none.
                let grid_s = if world == World::Rounded { 1e-3 } else { 1e-6 };
                times_s.push((heard_s / grid_s).round() * grid_s);
                numbers.push(number);
            }
            let wild = world == World::Wild && rng.random::<f64>() < 0.03;
            let spread = if wild { 10.0 * scatter } else { scatter };
            if number == second_from {
                second = (second_per_first, speed);
            }
            let expected = second.0 * law.at(speed);
            let kept = expected * (spread * normal(rng)).exp();
            let launch = speed * kept.min(1.0);
            time_s += contact_s;
            if launch < (0.5 * environment.gravity_m_s2 * contact_s).max(REST_M_S) {
                let last_s = 2.0 * launch / environment.gravity_m_s2 / (1.0 - expected);
                rest_s = (expected < 1.0).then_some(fall.time_s + time_s + last_s);
                break;
            }
            let flight = model.launch(launch).ok()?;
            heard &= number < most_impacts && flight.time_s() >= SHORTEST_FLIGHT_S;
            time_s += flight.time_s();
            speed = flight.impact_speed_m_s;
        }
        (times_s.len() >= FEWEST_IMPACTS.min(most_impacts)).then_some(Self {
            times_s,
            law,
            second,
            height_m,
            first_impact_m_s,
            rest_s,
            numbers,
        })
    }

    /// The truth of the restitution at a speed: on the surface that impacts of such a speed are on.
    fn restitution(&self, speed_m_s: f64) -> f64 {
        let (factor, fastest_m_s) = self.second;
        let on_second = speed_m_s <= fastest_m_s;
        self.law.at(speed_m_s) * if on_second { factor } else { 1.0 }
    }
}

/// What is asked: the restitution at the speed that the inference chooses and at that of the first
/// impact, which no flight shows, the drop height, and the time until rest.
const QUANTITIES: [&str; 4] = ["e", "e of the first", "h0", "time until rest"];

/// Whether the intervals of 68 and 95 % hold the truth, and the relative standard uncertainty.
type Held = (bool, bool, f64);

/// How one drop fared.
struct Fared {
    /// Of each quantity; `None` where no model explains the times, or nothing is stated.
    of: [Option<Held>; QUANTITIES.len()],
    converged: bool,
    numbered: bool,
}

fn fared(world: World, drop: &Drop, laws: &[LawKind], seed: u64) -> Fared {
    let settings = Options::default();
    let impacts: Vec<Impact> = impacts_of_times(&drop.times_s);
    let inference = InferenceOptions {
        sampler: SamplerConfig {
            seed,
            ..SamplerConfig::default()
        },
        ..InferenceOptions::default()
    };
    let restitution_scatter = match world {
        World::RoughStated => ROUGH,
        _ => settings.priors.restitution_scatter,
    };
    let priors = Priors {
        restitution_laws: laws.to_vec(),
        restitution_scatter,
        ..settings.priors
    };
    let found = infer(
        &impacts,
        &settings.ball,
        &settings.environment,
        settings.contact_time_s,
        &priors,
        &inference,
    );
    let numbers = impacts.iter().map(|impact| impact.number);
    Fared {
        converged: found.as_ref().is_ok_and(|found| found.sampling.converged),
        of: found.map_or_else(|_| Default::default(), |found| holds(drop, &found)),
        numbered: numbers.eq(drop.numbers.iter().copied()),
    }
}

fn holds(drop: &Drop, found: &Posterior) -> [Option<Held>; QUANTITIES.len()] {
    let fastest = drop.first_impact_m_s;
    let held = |estimate: Option<Estimate>, truth: Option<f64>| {
        let (estimate, truth) = estimate.zip(truth)?;
        let within = |[low, high]: [f64; 2]| low <= truth && truth <= high;
        Some((
            within(estimate.interval68),
            within(estimate.interval95),
            estimate.sd / truth,
        ))
    };
    let restitution = drop.restitution(found.at_speed_m_s);
    [
        held(Some(found.restitution), Some(restitution)),
        held(found.restitution_at(fastest), Some(drop.law.at(fastest))),
        held(Some(found.drop_height_m), Some(drop.height_m)),
        held(found.total_time_s, drop.rest_s),
    ]
}

/// All drops of a world, on all cores.
fn run(world: World, laws: &[LawKind], drops: usize, most_impacts: usize) -> Vec<Fared> {
    let threads = thread::available_parallelism().map_or(1, usize::from);
    thread::scope(|scope| {
        let workers: Vec<_> = (0..threads)
            .map(|worker| {
                scope.spawn(move || {
                    (0..)
                        .skip(worker)
                        .step_by(threads)
                        .filter_map(|seed| {
                            let mut rng = ChaCha8Rng::seed_from_u64(seed);
                            let drop = Drop::drawn(world, most_impacts, &mut rng)?;
                            Some(fared(world, &drop, laws, seed))
                        })
                        .take(drops.div_ceil(threads))
                        .collect::<Vec<_>>()
                })
            })
            .collect();
        let joined = workers.into_iter().map(thread::ScopedJoinHandle::join);
        joined.flat_map(Result::unwrap_or_default).collect()
    })
}

fn report(name: &str, all: &[Fared]) {
    for (place, quantity) in QUANTITIES.iter().enumerate() {
        let of = all.iter().filter_map(|fared| fared.of[place]);
        let mut sds: Vec<f64> = of.clone().map(|(.., sd)| sd).collect();
        sds.sort_by(f64::total_cmp);
        let percent = |held: usize| 100.0 * held as f64 / sds.len() as f64;
        println!(
            "| {name} | {} | {quantity} | {:.1} | {:.1} | {:.2} | {} | {} | {} |",
            all.len(),
            percent(of.clone().filter(|held| held.0).count()),
            percent(of.filter(|held| held.1).count()),
            100.0 * sds.get(sds.len() / 2).copied().unwrap_or(f64::NAN),
            all.len() - sds.len(),
            all.iter()
                .filter(|fared| fared.of[place].is_some() && !fared.converged)
                .count(),
            all.iter().filter(|fared| !fared.numbered).count(),
        );
    }
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let drops = arguments.iter().find_map(|word| word.parse().ok());
    let most_impacts = arguments
        .iter()
        .find_map(|word| word.strip_prefix("impacts=")?.parse().ok())
        .unwrap_or(MOST_IMPACTS);
    let laws: Vec<LawKind> = arguments.iter().filter_map(|w| w.parse().ok()).collect();
    let named = |name: &str| arguments.iter().any(|word| word == name);
    let all = !World::ALL.iter().any(|(_, name)| named(name));
    println!(
        "| world | drops | quantity | % in 68 | % in 95 | median sd, % | no answer | not converged | misnumbered |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    for (world, name) in World::ALL {
        if all || named(name) {
            report(name, &run(world, &laws, drops.unwrap_or(300), most_impacts));
        }
    }
}
