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

/// Distances of the truth from the lower limit, as a share of the limit: outside, on it, inside.
const STEPS: [f64; 5] = [-0.02, -0.01, 0.0, 0.01, 0.03];

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
        for (drops, between) in [
            (1, 0.0),
            (3, 0.0),
            (3, 0.005),
            (5, 0.005),
            (10, 0.005),
            (30, 0.005),
        ] {
            for step in STEPS {
                line(
                    Trial {
                        kind,
                        truth: least(kind) * (1.0 + step),
                        drops,
                        between,
                    },
                    balls,
                );
            }
        }
    }
    Ok(())
}

fn least(kind: Kind) -> f64 {
    kind.limits().least.unwrap_or_default()
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
    let wrong = if trial.truth > least(trial.kind) {
        fails
    } else {
        conforms
    };
    let truth = match trial.kind {
        Kind::Share => format!("{:.1} %", 100.0 * trial.truth),
        Kind::Height | Kind::Formula => format!("{:.2} cm", 100.0 * trial.truth),
    };
    println!(
        "| {} | {truth} | {} | {:.1} % | {conforms:.1} | {:.1} | {fails:.1} | {wrong:.1} |",
        trial.kind.name(),
        trial.drops,
        100.0 * trial.between,
        share(&[Outcome::CannotDecide]),
    );
}
