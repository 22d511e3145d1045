//! Verdicts on balls and floors whose rebound is known are wrong no more often than the decision rule says.

use bouncelab::rulebook::Outcome;
use bouncelab_bench::verdicts::{RuleKind, Trial};

/// The numbers of balls that conform and that do not.
fn outcomes(kind: RuleKind, truth: f64, drops: usize, balls: u64) -> [usize; 2] {
    let trial = Trial {
        kind,
        truth,
        drops,
        between: 0.003,
    };
    let found: Vec<Outcome> = (0..balls).map(|seed| trial.verdict(1000 + seed)).collect();
    let count = |counts: &[Outcome]| found.iter().filter(|found| counts.contains(found)).count();
    [
        count(&[Outcome::Conforms, Outcome::ConformsAsFarAsShown]),
        count(&[Outcome::DoesNotConform]),
    ]
}

/// On a limit to accept is wrong, and the default decision rule allows that in 5 % of the balls; 27 of 300
/// would come by chance with a probability of 0.3 % (binomial).
#[test]
fn a_ball_on_the_limit_conforms_as_rarely_as_stated() {
    for (kind, limit) in [
        (RuleKind::Height, 0.24),
        (RuleKind::Formula, 0.6),
        (RuleKind::Share, 0.8),
    ] {
        for drops in [1, 3, 5] {
            let [conform, fail] = outcomes(kind, limit, drops, 300);
            assert!(
                conform < 27 && fail < 27,
                "{kind:?}, {drops} drops: {conform} and {fail} of 300"
            );
        }
    }
}

/// 3 % below the limit fails and 3 % above conforms, mostly, with ten drops.
#[test]
fn a_ball_outside_fails_and_one_inside_conforms() {
    for (kind, limit) in [
        (RuleKind::Height, 0.24),
        (RuleKind::Formula, 0.6),
        (RuleKind::Share, 0.8),
    ] {
        let [conform, fail] = outcomes(kind, 0.97 * limit, 10, 30);
        assert!(conform == 0 && fail >= 25, "{kind:?}: {conform} {fail}");
        let [conform, fail] = outcomes(kind, 1.03 * limit, 10, 30);
        assert!(conform >= 25 && fail == 0, "{kind:?}: {conform} {fail}");
    }
}
