//! A note on a drop says something about this drop: drops as usual have none, and each fault has its own.

use std::collections::BTreeMap;

use bouncelab::analysis::{Drop, analyze_impacts, impacts_of_times};
use bouncelab::diagnostic::Code;
use bouncelab::{Options, ball};
use bouncelab_bench::of_seeds;
use bouncelab_bench::scenario::{self, MAX_IMPACTS, Scenario};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

/// A simulated drop of the ball of these options.
fn times_s(options: &Options, seed: u64) -> Option<Vec<f64>> {
    let mut rng = ChaCha8Rng::seed_from_u64(seed);
    let drop = scenario::Drop::drawn(Scenario::True, MAX_IMPACTS, options, &mut rng)?;
    Some(drop.times_s)
}

fn analysed(times_s: &[f64], options: &Options) -> Drop {
    analyze_impacts(impacts_of_times(times_s), options)
}

fn codes(drop: &Drop) -> Vec<Code> {
    drop.diagnostics.iter().map(|it| it.code).collect()
}

/// Of drops whose ball is the stated one at most 5 % carry a note, but for those of so few impacts that one between each two may
/// have been missed.
#[test]
fn a_usual_drop_has_no_note() {
    const DROPS: usize = 100;
    const FEW: usize = 6;
    let options = Options::default();
    let of_drops = of_seeds(DROPS, |seed| {
        let times_s = times_s(&options, seed).filter(|times_s| times_s.len() > FEW)?;
        Some(codes(&analysed(&times_s, &options)))
    });
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for code in of_drops.iter().flatten() {
        *counts.entry(code.name()).or_default() += 1;
    }
    let noted = of_drops.iter().filter(|codes| !codes.is_empty()).count();
    assert!(noted <= DROPS / 20, "{noted} of {DROPS}: {counts:?}");
}

/// The code of the only reason why there is no posterior.
fn refusal(times_s: &[f64], options: &Options) -> Code {
    let drop = analysed(times_s, options);
    let reason = drop.posterior.expect_err("it has a posterior").diagnostic();
    assert!(drop.diagnostics.contains(&reason));
    reason.code
}

#[test]
fn each_fault_of_a_list_is_named() {
    let table_tennis = Options::default();
    let times_s = times_s(&table_tennis, 3).expect("it is no short drop");
    assert_eq!(codes(&analysed(&times_s, &table_tennis)), []);
    let two = refusal(&times_s[..2], &table_tennis);
    assert_eq!(two, Code::RestitutionUndetermined);
    // An impact detected twice.
    let mut twice = times_s.clone();
    twice.insert(3, times_s[2] + 5e-4);
    assert_eq!(refusal(&twice, &table_tennis), Code::ContactOverlaps);
    // A ball that touches the surface for longer than the last flights last.
    let basketball = Options::new(ball::preset("basketball").expect("it is a preset"));
    let late = basketball.contact_time_s * 0.9;
    let mut short = times_s.clone();
    short.extend((1..4).map(|flight| times_s[times_s.len() - 1] + late * f64::from(flight)));
    let drop = analysed(&short, &basketball);
    assert!(
        codes(&drop).contains(&Code::ImpactsTooClose),
        "{:?}",
        codes(&drop)
    );
}
