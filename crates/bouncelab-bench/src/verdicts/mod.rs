//! The rate of wrong verdicts on simulated drops of balls and floors of known rebound, and how many are decided.
//!
//! ```text
//! cargo xtask verdicts 1000
//! ```
//!
//! prints `docs/tables/verdicts.txt`. The number is the balls of each line.

mod ball;

use ball::Kind;
pub use ball::{Kind as RuleKind, Trial};
use bouncelab::rulebook::Outcome;
use rayon::prelude::*;

use crate::Result;

/// Numbers of drops, and by how much the restitution differs from drop to drop, as a share.
const DROPS: &[(usize, f64)] = &[(1, 0.0), (3, 0.005), (5, 0.005), (10, 0.005), (30, 0.005)];
/// How far inside the limit the truth is, as a share of it: outside, on it, inside.
const STEPS: [f64; 5] = [-0.02, -0.01, 0.0, 0.01, 0.03];
/// The same of differences of places.
const STEPS_OF_PLACES: [f64; 5] = [-0.6, -0.3, 0.0, 0.3, 0.6];

/// `verdicts [BALLS]`: prints the table.
///
/// # Errors
///
/// None.
pub fn run(arguments: &[String]) -> Result {
    let balls = arguments
        .first()
        .and_then(|number| number.parse().ok())
        .unwrap_or(1000_u64);
    println!(
        "| rule | truth | drops | between drops | conforms % | cannot decide % | does not conform % | wrong % |"
    );
    println!("|---|---|---|---|---|---|---|---|");
    for kind in Kind::ALL {
        for &(drops, between) in DROPS {
            // Nobody drops a ball 150 times for one floor.
            if kind.compares_places() && drops > 10 {
                continue;
            }
            // Where each drop counts, what differs between drops is no error.
            let between = if kind == Kind::EachDrop { 0.0 } else { between };
            let steps = if kind.compares_places() {
                STEPS_OF_PLACES
            } else {
                STEPS
            };
            for inside in steps {
                let trial = Trial {
                    kind,
                    inside,
                    drops,
                    between,
                };
                line(trial, balls);
            }
        }
    }
    Ok(())
}

fn line(trial: Trial, balls: u64) {
    let outcomes: Vec<Outcome> = (0..balls)
        .into_par_iter()
        .map(|seed| trial.verdict(seed))
        .collect();
    let share = |counts: &[Outcome]| {
        let count = outcomes
            .iter()
            .filter(|found| counts.contains(found))
            .count();
        100.0 * count as f64 / balls as f64
    };
    let conforms = share(&[Outcome::Conforms, Outcome::ConformsAsFarAsShown]);
    let fails = share(&[Outcome::DoesNotConform]);
    // A ball on a limit counts as outside: to accept it is what the rule guards against.
    let wrong = if trial.inside > 0.0 { fails } else { conforms };
    let truth = match trial.kind {
        Kind::Height | Kind::EachDrop | Kind::Formula => format!("{:.2} cm", 100.0 * trial.truth()),
        Kind::Share | Kind::WithinOfMean | Kind::Range => format!("{:.1} %", 100.0 * trial.truth()),
    };
    println!(
        "| {} | {truth} | {} | {:.1} % | {conforms:.1} | {:.1} | {fails:.1} | {wrong:.1} |",
        trial.kind.name(),
        trial.drops,
        100.0 * trial.between,
        share(&[Outcome::CannotDecide]),
    );
}
