//! Real recordings without their first impacts fell from the apex of the flight before.

use bouncelab_bench::recordings::of_folder;
use bouncelab_testkit::recordings;

/// Shares that intervals of 68 and 95 % must hold at least, as the project claims.
const CLAIMED: [f64; 2] = [0.60, 0.93];
/// Standard deviations of a binomial count by which a share may fall short of its claim by chance: once in a hundred times.
const CHANCE: f64 = 2.33;

#[test]
#[ignore = "reads the recordings in BOUNCELAB_RECORDINGS"]
fn rests_of_recordings_fell_from_the_apex_before() {
    let all = of_folder(&recordings()).unwrap();
    let held: Vec<_> = all.iter().flat_map(|cuts| &cuts.held).collect();
    let count = held.len() as f64;
    assert!(count >= 60.0, "{count} cuts");
    let shares = [
        held.iter().filter(|held| held.in68).count() as f64 / count,
        held.iter().filter(|held| held.in95).count() as f64 / count,
    ];
    for (share, claimed) in shares.into_iter().zip(CLAIMED) {
        let sd = (claimed * (1.0 - claimed) / count).sqrt();
        assert!(share >= claimed - CHANCE * sd, "{shares:?} of {count} cuts");
    }
}
