//! Calibration of the inference where its model is not exactly true.
//!
//! Drops of every [`Scenario`] are inferred from their times alone, with every default of `analyze`: do the intervals
//! still hold the truth?
//!
//! ```text
//! cargo xtask calibrate scenarios 300
//! ```
//!
//! prints `docs/tables/scenarios.txt`; the argument is the number of drops for each scenario,
//! and names of scenarios after it leave out all others. Names of restitution laws leave out the others of those.
//! With `impacts=4` no drop has more impacts than that.

use bouncelab::analysis::{Options, impacts_of_times};
use bouncelab::inference::{Posterior, Priors, infer};
use bouncelab::restitution::LawKind;
use bouncelab::{Estimate, Impact};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use crate::scenario::{Drop, MAX_IMPACTS, Scenario};
use crate::{of_seeds, seeded};

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

fn fared(scenario: Scenario, drop: &Drop, laws: &[LawKind], seed: u64) -> Fared {
    let settings = scenario.stated(Options::default());
    let impacts: Vec<Impact> = impacts_of_times(&drop.times_s);
    let priors = Priors {
        restitution_laws: laws.to_vec(),
        ..settings.priors
    };
    let posterior = infer(
        &impacts,
        &settings.ball,
        &settings.environment,
        settings.contact_time_s,
        &priors,
        &seeded(seed),
    );
    let numbers = impacts.iter().map(|impact| impact.number);
    Fared {
        converged: posterior.as_ref().is_ok_and(|it| it.sampling.converged),
        of: posterior.map_or_else(|_| Default::default(), |it| holds(drop, &it)),
        numbered: numbers.eq(drop.numbers.iter().copied()),
    }
}

fn holds(drop: &Drop, posterior: &Posterior) -> [Option<Held>; QUANTITIES.len()] {
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
    let restitution = drop.restitution(posterior.at_speed_m_s);
    [
        held(Some(posterior.restitution), Some(restitution)),
        held(
            posterior.restitution_at(fastest),
            Some(drop.first_restitution()),
        ),
        held(Some(posterior.drop_height_m), Some(drop.height_m)),
        held(posterior.total_time_s, drop.rest_s),
    ]
}

/// All drops of a scenario, on all cores.
fn inferred(scenario: Scenario, laws: &[LawKind], drops: usize, max_impacts: usize) -> Vec<Fared> {
    let options = Options::default();
    of_seeds(drops, |seed| {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let drop = Drop::drawn(scenario, max_impacts, &options, &mut rng)?;
        Some(fared(scenario, &drop, laws, seed))
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

/// Prints the table.
pub(crate) fn run(arguments: &[String]) {
    let drops = arguments.iter().find_map(|word| word.parse().ok());
    let max_impacts = arguments
        .iter()
        .find_map(|word| word.strip_prefix("impacts=")?.parse().ok())
        .unwrap_or(MAX_IMPACTS);
    let laws: Vec<LawKind> = arguments.iter().filter_map(|w| w.parse().ok()).collect();
    let is_named = |scenario: &Scenario| arguments.iter().any(|word| word == scenario.name());
    let all = !Scenario::ALL.iter().any(is_named);
    println!(
        "| scenario | drops | quantity | % in 68 | % in 95 | median sd, % | no answer | not converged | misnumbered |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    for scenario in Scenario::ALL {
        if all || is_named(&scenario) {
            let fared = inferred(scenario, &laws, drops.unwrap_or(300), max_impacts);
            report(scenario.name(), &fared);
        }
    }
}
