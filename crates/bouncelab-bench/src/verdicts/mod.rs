//! The rate of wrong verdicts on simulated drops of balls with known rebound.
//!
//! ```text
//! cargo xtask verdicts 1000
//! cargo xtask verdicts 100 3
//! ```
//!
//! prints the tables of `docs/validation.md` and `docs/tables/verdicts.txt`. The first number is the balls of each line; the
//! second chooses the lines of this number of drops.

mod ball;

use ball::LIMITS;
pub use ball::Trial;
use bouncelab::rulebook::Outcome;
use rayon::prelude::*;

use crate::Result;

/// `verdicts [BALLS [DROPS]]`: prints the table.
///
/// # Errors
///
/// None.
pub fn run(arguments: &[String]) -> Result {
    let number = |index: usize| arguments.get(index)?.parse::<usize>().ok();
    let balls = number(0).unwrap_or(1000) as u64;
    let only = number(1);
    println!("| rebound | drops | between drops | pass % | cannot decide % | fail % | wrong % |");
    println!("|---|---|---|---|---|---|---|");
    let lines = [(1, 0.0), (3, 0.0), (3, 0.005)].into_iter();
    for (drops, between) in lines.filter(|(drops, _)| only.is_none_or(|only| only == *drops)) {
        for rebound_m in [0.237, 0.24, 0.243, 0.25, 0.262] {
            let trial = Trial {
                rebound_m,
                drops,
                between,
                draws: 1000,
            };
            let seeds = (0..balls).into_par_iter();
            let outcomes: Vec<Outcome> = seeds.map(|seed| trial.verdict(seed)).collect();
            let share = |outcome: Outcome| {
                let count = outcomes.iter().filter(|&&found| found == outcome).count();
                100.0 * count as f64 / balls as f64
            };
            let wrong = if on_or_outside(rebound_m) {
                share(Outcome::Pass)
            } else {
                share(Outcome::Fail)
            };
            println!(
                "| {:.1} cm | {drops} | {:.1} % | {:.1} | {:.1} | {:.1} | {wrong:.1} |",
                100.0 * rebound_m,
                100.0 * between,
                share(Outcome::Pass),
                share(Outcome::CannotDecide),
                share(Outcome::Fail),
            );
        }
    }
    Ok(())
}

/// A ball on a limit counts as outside: a pass of it is what the rule guards against.
fn on_or_outside(rebound_m: f64) -> bool {
    let ends = [LIMITS.least, LIMITS.greatest].into_iter().flatten();
    !LIMITS.contain(rebound_m) || ends.into_iter().any(|end| (end - rebound_m).abs() < 1e-9)
}
