//! Calibration of the inference by simulation.
//!
//! Thousands of drops are drawn from the priors, observed with noise, and inferred. If the inference is
//! honest, the truth lies within its 68 and 95 % intervals that often, and its rank among the draws
//! of the posterior is uniform (S. Talts et al., arXiv 1804.06788).
//!
//! ```text
//! cargo xtask calibrate 4000
//! ```
//!
//! prints `docs/tables/calibration.txt` and writes `calibration.csv`, of which `cargo xtask book` draws its
//! figure, into the folder that the second argument names. The first is the number of drops for each scenario.

use std::path::PathBuf;

use bouncelab::Impact;
use bouncelab::air::Air;
use bouncelab::analysis::Options;
use bouncelab::ball::Ball;
use bouncelab::drag::DragLaw;
use bouncelab::flight::{Environment, FlightModel};
use bouncelab::inference::{Measured, Priors, infer};
use bouncelab::restitution::LawKind;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::StandardNormal;

use crate::scenario::{MAX_IMPACTS, MIN_IMPACTS, REST_M_S, SHORTEST_FLIGHT_S};
use crate::{Result, misfit, of_seeds, recordings, seeded, tape};

/// What is simulated.
#[derive(Clone, Copy, PartialEq)]
enum Scenario {
    /// Times good to 50 µs, scatter as the inference has it.
    Clean,
    /// Times good to 1 ms, one impact in ten missed.
    NoisyWithGaps,
    /// Scatter with two exponential tails.
    HeavyTails,
    /// Normal scatter.
    LightTails,
    /// As clean, with the height measured to 2 mm.
    HeightMeasured,
}

impl Scenario {
    const ALL: [Self; 5] = [
        Self::Clean,
        Self::NoisyWithGaps,
        Self::HeavyTails,
        Self::LightTails,
        Self::HeightMeasured,
    ];

    const fn name(self) -> &'static str {
        match self {
            Self::Clean => "clean",
            Self::NoisyWithGaps => "noisy with gaps",
            Self::HeavyTails => "heavy tails",
            Self::LightTails => "light tails",
            Self::HeightMeasured => "height measured",
        }
    }

    const fn sigma_s(self) -> f64 {
        match self {
            Self::NoisyWithGaps => 1e-3,
            _ => 5e-5,
        }
    }
}

/// Of the few drops that keep nearly all of their speed, some never rest.
const MAX_BOUNCES: usize = 100_000;

const DRAG: f64 = 0.4;
const HEIGHT_SD_M: f64 = 0.002;

/// A simulated drop and what was to be found.
struct Drop {
    impacts: Vec<Impact>,
    restitution: f64,
    height_m: f64,
    drag: f64,
    until_rest_s: f64,
    measured_m: f64,
}

/// What is known of a table-tennis ball and of the ambient conditions, with one restitution law.
fn priors() -> Priors {
    Priors {
        restitution_laws: vec![LawKind::Constant],
        // The simulation has no ball with half its added mass.
        added_mass_rel_sd: 0.0,
        ..Options::default().priors
    }
}

fn environment() -> Environment {
    Environment {
        drag: DragLaw::Constant(DRAG),
        ..Options::default().environment
    }
}

/// A drop from the priors; `None` if it is too short to be detected as one.
fn drawn(scenario: Scenario, rng: &mut ChaCha8Rng) -> Option<Drop> {
    let settings = Options::default();
    let (known, nominal) = (priors(), environment());
    let normal = |rng: &mut ChaCha8Rng| rng.sample::<f64, _>(StandardNormal);
    let spread = |sd: f64, rng: &mut ChaCha8Rng| (sd * normal(rng)).exp();
    let drag = DRAG * spread(known.drag_rel_sd, rng);
    let gravity_m_s2 = nominal.gravity_m_s2 * spread(known.gravity_rel_sd, rng);
    let density = nominal.air.density_kg_m3() * spread(known.air_density_rel_sd, rng);
    let mass_kg = settings.ball.mass_kg() * spread(known.mass_rel_sd, rng);
    let diameter_m = settings.ball.diameter_m() * spread(known.diameter_rel_sd, rng);
    let contact_s = settings.contact_time_s * spread(known.contact_time_rel_sd, rng);
    let scatter = known.scatter_at(normal(rng));
    let sigma_s = scenario.sigma_s() * spread(known.timing_rel_sd, rng);
    let restitution = 0.5 + 0.5 * rng.random::<f64>();
    let height_m = 0.15 * 10_f64.powf(rng.random());
    let measured_m = height_m + HEIGHT_SD_M * normal(rng);
    let model = FlightModel::new(
        &Ball::new(mass_kg, diameter_m).ok()?,
        &Environment {
            gravity_m_s2,
            air: Air::new(density, nominal.air.viscosity_pa_s()).ok()?,
            drag: DragLaw::Constant(drag),
            ..nominal
        },
    )
    .ok()?;
    let deviation = |rng: &mut ChaCha8Rng| match scenario {
        Scenario::HeavyTails => two_exponentials(rng),
        Scenario::LightTails => normal(rng),
        _ => student(rng),
    };
    let fall = model.fall(height_m).ok()?;
    let mut speed = fall.impact_speed_m_s;
    let mut time_s = 0.0;
    let mut last = (speed, time_s);
    let mut impacts = Vec::new();
    for number in 1..=MAX_IMPACTS {
        let missed = scenario == Scenario::NoisyWithGaps && rng.random::<f64>() < 0.1;
        let off = normal(rng);
        if number == 1 || !missed {
            last = (speed, time_s);
            impacts.push(
                Impact::new(number, time_s + sigma_s * off).with_time_sd_s(scenario.sigma_s()),
            );
        }
        let kept = restitution * (scatter * deviation(rng)).exp();
        let flight = model.launch(speed * kept).ok()?;
        if flight.time_s() < SHORTEST_FLIGHT_S || number == MAX_IMPACTS {
            break;
        }
        time_s += flight.time_s() + contact_s;
        speed = flight.impact_speed_m_s;
    }
    // What comes after the last impact detected is drawn anew, as the inference has it.
    let (slowest, last_s) = last;
    let loss_exponent = (known.slow_loss_exponent * normal(rng)).max(0.0);
    let bounces_s = until_rest_s(&model, slowest, contact_s, |speed| {
        let losses = (1.0 / restitution - 1.0) * (speed / slowest).powf(-loss_exponent);
        [1.0 / (1.0 + losses), (scatter * deviation(rng)).exp()]
    })?;
    (impacts.len() >= MIN_IMPACTS).then_some(Drop {
        impacts,
        restitution,
        height_m,
        drag,
        until_rest_s: fall.time_s + last_s + bounces_s,
        measured_m,
    })
}

/// The time from an impact at this speed until the ball rests, with what each impact is expected to keep of its speed, and
/// by which factor it keeps more.
fn until_rest_s(
    model: &FlightModel,
    mut speed: f64,
    contact_s: f64,
    mut kept: impl FnMut(f64) -> [f64; 2],
) -> Option<f64> {
    let resting = REST_M_S.max(0.5 * model.gravity_m_s2() * contact_s);
    let mut time_s = 0.0;
    for _ in 0..MAX_BOUNCES {
        let [expected, factor] = kept(speed);
        let launch = speed * expected * factor;
        let flight = model.launch(launch).ok()?;
        time_s += contact_s;
        if launch < resting {
            return Some(time_s + flight.time_s() / (1.0 - expected));
        }
        time_s += flight.time_s();
        speed = flight.impact_speed_m_s;
    }
    Some(f64::INFINITY)
}

/// The tails of the inference: Student's t of 6 degrees, with variance one.
fn student(rng: &mut ChaCha8Rng) -> f64 {
    const FREEDOM: f64 = 6.0;
    let squares = (0..6).map(|_| rng.sample::<f64, _>(StandardNormal).powi(2));
    let chi_squared: f64 = squares.sum();
    rng.sample::<f64, _>(StandardNormal) * ((FREEDOM - 2.0) / chi_squared).sqrt()
}

/// The distribution that Montaine et al. found, in its symmetric form, with variance one.
fn two_exponentials(rng: &mut ChaCha8Rng) -> f64 {
    let size = -(1.0 - rng.random::<f64>()).ln() / std::f64::consts::SQRT_2;
    if rng.random::<bool>() { size } else { -size }
}

/// Shares of the draws below the truth: of e, drop height, drag coefficient, and time until rest, if it comes to rest;
/// none if the inference is refused.
struct Ranks([Option<f64>; 4]);

fn ranks(scenario: Scenario, seed: u64) -> Option<Ranks> {
    let drop = drawn(scenario, &mut ChaCha8Rng::seed_from_u64(seed))?;
    let mut known = priors();
    if scenario == Scenario::HeightMeasured {
        known.drop_height_m = Some(Measured {
            value: drop.measured_m,
            sd: HEIGHT_SD_M,
        });
    }
    let settings = Options::default();
    let found = infer(
        &drop.impacts,
        &settings.ball,
        &environment(),
        settings.contact_time_s,
        &known,
        &seeded(seed),
    );
    let Ok(found) = found else {
        return Some(Ranks([None; 4]));
    };
    let below = |draws: &[f64], truth: f64| {
        let below = draws.iter().filter(|draw| **draw < truth).count();
        (!draws.is_empty()).then(|| below as f64 / draws.len() as f64)
    };
    Some(Ranks([
        below(&found.draws.restitution, drop.restitution),
        below(&found.draws.drop_height_m, drop.height_m),
        below(&found.draws.drag_coefficient, drop.drag),
        below(&found.draws.total_time_s, drop.until_rest_s),
    ]))
}

/// The chi-square statistic of 20 bins exceeds this once in a hundred times by chance.
const CHI_SQUARE_LIMIT: f64 = 36.19;
const BINS: usize = 20;

/// Prints the rows of a scenario and gives its histograms, a line of CSV each.
fn report(scenario: Scenario, all: &[Ranks]) -> Vec<String> {
    let refused = all.iter().filter(|ranks| ranks.0[0].is_none()).count();
    let mut histograms = Vec::new();
    for (place, quantity) in ["e", "h0", "C_D", "time until rest"].iter().enumerate() {
        let shares: Vec<f64> = all.iter().filter_map(|ranks| ranks.0[place]).collect();
        let count = shares.len() as f64;
        let covered = |tail: f64| {
            let inside = shares
                .iter()
                .filter(|share| (tail..1.0 - tail).contains(*share));
            let inside = inside.count();
            100.0 * inside as f64 / count
        };
        let mut bins = [0_u32; BINS];
        for share in &shares {
            bins[((share * BINS as f64) as usize).min(BINS - 1)] += 1;
        }
        let expected = count / BINS as f64;
        let chi_square: f64 = bins
            .iter()
            .map(|&bin| (f64::from(bin) - expected).powi(2) / expected)
            .sum();
        let uniform = if chi_square < CHI_SQUARE_LIMIT {
            "yes"
        } else {
            "no"
        };
        println!(
            "| {} | {} | {quantity} | {:.1} | {:.1} | {chi_square:.1} | {uniform} | {refused} |",
            scenario.name(),
            shares.len(),
            covered(0.158_655),
            covered(0.025),
        );
        let bins = bins.map(|bin| bin.to_string()).join(",");
        histograms.push(format!("{},{quantity},{bins}", scenario.name()));
    }
    histograms
}

/// `calibrate [DROPS [FOLDER]]`: prints the table; or `calibrate PART ...` of `scenarios`, `tape` or `recordings`.
///
/// # Errors
///
/// If the ranks cannot be written into the folder, and those of the parts.
pub fn run(arguments: &[String]) -> Result {
    if let [part, others @ ..] = arguments {
        match part.as_str() {
            "scenarios" => return misfit::run(others),
            "tape" => return tape::run(others),
            "recordings" => return recordings::run(others),
            _ => {}
        }
    }
    let drops = arguments.first().and_then(|argument| argument.parse().ok());
    println!(
        "| scenario | drops | quantity | % in 68 | % in 95 | chi-square of ranks | uniform (p > 0.01) | refused |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    let bins: Vec<String> = (1..=BINS).map(|bin| bin.to_string()).collect();
    let mut table = vec![format!("scenario,quantity,{}", bins.join(","))];
    for scenario in Scenario::ALL {
        // More seeds than drops, since some drops are too short.
        let all = of_seeds(drops.unwrap_or(400), |seed| ranks(scenario, seed));
        table.extend(report(scenario, &all));
    }
    let Some(folder) = arguments.get(1).map(PathBuf::from) else {
        return Ok(());
    };
    std::fs::create_dir_all(&folder)?;
    std::fs::write(folder.join("calibration.csv"), table.join("\n") + "\n")?;
    Ok(())
}
