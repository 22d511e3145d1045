//! The intervals of the analysis hold the truth of drops that another program simulated.

use bouncelab_bench::misfit::{Row, fared};
use bouncelab_bench::scenario::{MAX_IMPACTS, Scenario};
use bouncelab_bench::stated::Stated;

/// A number of drops, and how many of them lie outside intervals that hold 93 % at most once in a hundred times (binomial).
const MANY: (usize, usize) = (30, 6);
/// The same where a ball that was not stated makes each drop several inferences.
const FEW: (usize, usize) = (12, 3);

/// The numbers of the restitution at the first impact, of that in the middle, and of the drop height among the quantities.
const ALL: [usize; 3] = [0, 1, 2];
const OF_FIRST: [usize; 2] = [0, 2];

/// The intervals of 95 % hold these quantities, and more than half of the drops have an answer.
fn holds(row: Row, quantities: &[usize], (drops, most_outside): (usize, usize)) {
    let all = fared(row, &[], drops, MAX_IMPACTS);
    for &quantity in quantities {
        let held = all.iter().filter_map(|it| Some(it.of[quantity]?.in95));
        let held: Vec<bool> = held.collect();
        let outside = held.iter().filter(|held| !**held).count();
        let name = row.name();
        assert!(held.len() > drops / 2, "{name}: {} answers", held.len());
        assert!(
            outside <= most_outside,
            "{name} {quantity}: {outside} outside"
        );
    }
}

#[test]
fn intervals_hold_where_all_that_is_stated_is_true() {
    holds(Row::Stated(Stated::RightBall), &ALL, MANY);
    holds(Row::Stated(Stated::LateStart), &ALL, MANY);
    holds(Row::Stated(Stated::MassAndDiameter), &ALL, MANY);
    holds(Row::Misfit(Scenario::True), &ALL, MANY);
}

#[test]
fn intervals_hold_for_laws_that_are_none_of_the_inference() {
    holds(Row::Stated(Stated::FifthPower), &ALL, MANY);
    holds(Row::Misfit(Scenario::NoLaw), &ALL, MANY);
    // In the middle, where restitution changes so fast, more are missed.
    holds(Row::Stated(Stated::WorseWhenSlow), &OF_FIRST, MANY);
}

#[test]
fn a_sound_before_the_drop_is_not_its_first_impact() {
    holds(Row::Stated(Stated::Click), &ALL, MANY);
}

#[test]
fn intervals_hold_where_no_ball_is_stated() {
    for kind in 0..6 {
        holds(Row::Stated(Stated::NoBall(kind)), &ALL, FEW);
    }
}

#[test]
fn a_height_that_silence_contradicts_is_not_the_answer() {
    holds(Row::Stated(Stated::WrongHeight), &ALL, MANY);
}
