//! The intervals of the analysis hold the truth of drops that another program simulated.

use bouncelab_bench::misfit::{Row, fared};
use bouncelab_bench::scenario::{MAX_IMPACTS, Scenario};
use bouncelab_bench::stated::Stated;

const DROPS: usize = 30;
/// Of so many drops more than this lie outside intervals that hold 93 % only once in two hundred times (binomial).
const MAX_OUTSIDE: usize = 6;

/// The numbers of the restitution, of that of the first impact, and of the drop height among the quantities.
const ALL: [usize; 3] = [0, 1, 2];

/// How many intervals of 95 % miss these quantities, of those that are stated; more than half of the drops have an answer.
fn holds(row: Row, quantities: &[usize]) {
    let all = fared(row, &[], DROPS, MAX_IMPACTS);
    for &quantity in quantities {
        let held: Vec<bool> = all
            .iter()
            .filter_map(|it| Some(it.of[quantity]?.in95))
            .collect();
        let outside = held.iter().filter(|held| !**held).count();
        assert!(
            held.len() > DROPS / 2,
            "{}: {} answers",
            row.name(),
            held.len()
        );
        assert!(
            outside <= MAX_OUTSIDE,
            "{} {quantity}: {outside} outside",
            row.name()
        );
    }
}

#[test]
fn intervals_hold_where_all_that_is_stated_is_true() {
    holds(Row::Stated(Stated::RightBall), &ALL);
    holds(Row::Stated(Stated::LateStart), &ALL);
    holds(Row::Misfit(Scenario::True), &ALL);
}

#[test]
fn intervals_hold_for_laws_that_are_none_of_the_inference() {
    holds(Row::Stated(Stated::FifthPower), &ALL);
    holds(Row::Misfit(Scenario::NoLaw), &ALL);
    // Restitution that changes so fast misses more.
    holds(Row::Stated(Stated::WorseWhenSlow), &[1, 2]);
}

#[test]
fn a_sound_before_the_drop_is_not_its_first_impact() {
    holds(Row::Stated(Stated::Click), &ALL);
}
