//! The model of many drops, by simulation and by closed forms.

use bouncelab::groups::{
    Asked, CurveEvidence, GroupSums, Study, StudyDrop, drops_needed, outliers,
};
use bouncelab::inference::Measured;
use bouncelab::restitution::LawKind;
use bouncelab::{Options, analyze_times, ball};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::StandardNormal;

struct Simulator(ChaCha8Rng);

impl Simulator {
    fn new(seed: u64) -> Self {
        Self(ChaCha8Rng::seed_from_u64(seed))
    }

    fn normal(&mut self, sd: f64) -> f64 {
        let z: f64 = self.0.sample(StandardNormal);
        sd * z
    }

    /// A drop whose restitution was measured at some speeds, each with a relative error of `own`.
    fn drop(
        &mut self,
        speeds_m_s: &[f64],
        curve: impl Fn(f64) -> f64,
        level: f64,
        own: f64,
    ) -> CurveEvidence {
        let points = speeds_m_s.iter().map(|&speed_m_s| {
            let truth = curve(speed_m_s);
            let value = truth * (level + self.normal(own)).exp();
            (
                speed_m_s,
                Measured {
                    value,
                    sd: own * truth,
                },
            )
        });
        CurveEvidence::measured(&points.collect::<Vec<_>>())
    }
}

fn studied(
    evidence: Vec<CurveEvidence>,
    levels: impl Fn(usize) -> Vec<Option<usize>>,
    asked: &Asked,
) -> Study {
    let drops = evidence
        .into_iter()
        .enumerate()
        .map(|(place, evidence)| StudyDrop {
            evidence,
            scatter: Some(0.003),
            levels: levels(place),
        });
    Study::of(&drops.collect::<Vec<_>>(), asked).unwrap()
}

fn holds([low, high]: [f64; 2], truth: f64) -> bool {
    (low..=high).contains(&truth)
}

fn falling(speed_m_s: f64) -> f64 {
    0.95 - 0.02 * speed_m_s
}

/// Drops from unlike heights tell unlike parts of one curve: each is used, and the curve holds over all of them.
#[test]
fn drops_from_unlike_heights_tell_one_curve() {
    let mut simulator = Simulator::new(1);
    let ranges = [[0.4, 0.7, 1.0], [0.9, 1.3, 1.8], [1.6, 2.4, 3.5]];
    let drops = (0..30).map(|place| {
        let level = simulator.normal(0.002);
        simulator.drop(&ranges[place % 3], falling, level, 0.001)
    });
    let study = studied(drops.collect(), |_| Vec::new(), &Asked::default());
    let [group] = study.groups.as_slice() else {
        panic!("{} groups", study.groups.len())
    };
    assert_eq!((group.count, group.range_m_s), (30, [0.4, 3.5]));
    assert!(study.drops.iter().all(Option::is_some));
    for point in &group.curve {
        let off = (point.restitution.value - falling(point.speed_m_s)) / point.restitution.sd;
        assert!(off.abs() < 3.5, "{off} at {} m/s", point.speed_m_s);
        assert!(point.restitution.sd < 0.003, "{point:?}");
    }
}

/// With equal errors at one speed the model is the textbook's: mean, s over root n.
#[test]
fn equal_drops_have_the_textbook_mean() {
    let values = [
        0.9205, 0.9235, 0.9190, 0.9262, 0.9221, 0.9248, 0.9214, 0.9225, 0.9242, 0.9208,
    ];
    let drops = values.map(|value| CurveEvidence::measured(&[(1.0, Measured { value, sd: 1e-5 })]));
    let study = studied(drops.into(), |_| Vec::new(), &Asked::default());
    let mean = values.iter().sum::<f64>() / 10.0;
    let sd = (values
        .iter()
        .map(|value| (value - mean).powi(2))
        .sum::<f64>()
        / 9.0)
        .sqrt();
    let found = study.groups[0].restitution.unwrap();
    assert!((found.value - mean).abs() < 1e-5, "{found:?}");
    // Student's t with nine degrees of freedom; the prior of the scatter is a little wider than none.
    let half = 0.5 * (found.interval95[1] - found.interval95[0]);
    let textbook = 2.262 * sd / 10_f64.sqrt();
    assert!(
        (0.95..1.2).contains(&(half / textbook)),
        "{}",
        half / textbook
    );
    assert!((0.9..1.2).contains(&(study.groups[0].between_drops.value * mean / sd)));
}

/// 95 % intervals of e, of the difference of two groups and of the scatter, over 300 studies of 20 drops: 95 % to 1.3 points,
/// 2.5 of which are allowed.
#[test]
fn intervals_hold_the_truth() {
    const REPEATS: usize = 300;
    let mut simulator = Simulator::new(2);
    let (mut of_mean, mut of_difference, mut of_scatter) = (0, 0, 0);
    for _ in 0..REPEATS {
        let drops = (0..20).map(|place| {
            let level = simulator.normal(0.002) - 0.01 * (place % 2) as f64;
            let fastest = [1.5, 3.0][place / 2 % 2];
            simulator.drop(&[0.7, 1.0, fastest], falling, level, 0.001)
        });
        let asked = Asked {
            by: vec![0],
            at_speed_m_s: Some(1.0),
            ..Asked::default()
        };
        let study = studied(drops.collect(), |place| vec![Some(place % 2)], &asked);
        let [one, other] = [falling(1.0), falling(1.0) * (-0.01_f64).exp()];
        of_mean += usize::from(holds(study.groups[0].restitution.unwrap().interval95, one));
        of_difference += usize::from(holds(
            study.differences[0].at_speed.unwrap().difference.interval95,
            other - one,
        ));
        of_scatter += usize::from(holds(study.groups[0].between_drops.interval95, 0.002));
    }
    for (name, held) in [
        ("mean", of_mean),
        ("difference", of_difference),
        ("scatter", of_scatter),
    ] {
        let share = held as f64 / REPEATS as f64;
        assert!((0.925..=0.985).contains(&share), "{name}: {share}");
    }
}

/// What drops share does not average out, but cancels in the difference of two groups of one ball.
#[test]
fn what_drops_share_does_not_average_out() {
    let mut simulator = Simulator::new(3);
    let drops: Vec<CurveEvidence> = (0..200)
        .map(|place| {
            let level = simulator.normal(0.001) - 0.01 * f64::from(place % 2);
            let mut drop = simulator.drop(&[0.7, 1.4], falling, level, 0.001);
            for reading in &mut drop.readings {
                // One standard deviation of the contact time is 0.5 % of e.
                reading.shared[3] = 5.0;
            }
            drop.inputs_covariance[3][3] = 1.0;
            drop
        })
        .collect();
    let asked = Asked {
        by: vec![0],
        at_speed_m_s: Some(0.7),
        ..Asked::default()
    };
    let study = studied(drops.clone(), |place| vec![Some(place % 2)], &asked);
    let group = study.groups[0].restitution.unwrap();
    assert!((group.sd / group.value - 0.005).abs() < 3e-4, "{group:?}");
    assert!(study.differences[0].at_speed.unwrap().difference.sd < 3e-4);
    // Of two balls it does not cancel.
    let asked = Asked {
        ball: Some(0),
        ..asked
    };
    let unlike = studied(drops, |place| vec![Some(place % 2)], &asked);
    assert!(unlike.differences[0].at_speed.unwrap().difference.sd > 0.005);
}

/// Three operators that differ by a per cent: results of one agree better than results of all.
#[test]
fn operators_scatter_beside_the_drops() {
    let mut simulator = Simulator::new(4);
    let of_operator = [0.01, -0.008, -0.002];
    let drops = (0..45).map(|place| {
        let level = simulator.normal(0.001) + of_operator[place % 3];
        simulator.drop(&[0.7, 1.4], falling, level, 0.0005)
    });
    let asked = Asked {
        random: vec![0],
        ..Asked::default()
    };
    let study = studied(drops.collect(), |place| vec![Some(place % 3)], &asked);
    let group = &study.groups[0];
    assert!(
        (0.0007..0.0014).contains(&group.between_drops.value),
        "{:?}",
        group.between_drops
    );
    let (_, scatter) = study.scatters[0];
    assert!(holds(scatter.interval95, 0.0093), "{scatter:?}");
    let repeatability = group.repeatability_sd.unwrap().value;
    assert!(group.reproducibility_sd.unwrap() > 3.0 * repeatability);
    // A table of the drops has what its operator adds: 1.8 % between the first two, to 0.1 % between 15 drops of each.
    let of_operator = |operator: usize| {
        let drops = (operator..45).step_by(3);
        let levels = drops.map(|drop| study.restitution_of(drop).unwrap().value.ln());
        levels.sum::<f64>() / 15.0
    };
    let difference = of_operator(0) - of_operator(1);
    assert!((difference - 0.018).abs() < 0.0015, "{difference}");
}

/// Sums of parts of unlike speeds, read apart and merged in any order, give the groups that all drops give.
#[test]
fn sums_of_parts_are_merged() {
    let mut simulator = Simulator::new(11);
    let ranges = [[0.4, 0.7, 1.0], [0.9, 1.3, 1.8], [3.1, 4.4, 7.5]];
    let asked = Asked {
        by: vec![0],
        random: vec![1],
        at_speed_m_s: Some(0.95),
        ..Asked::default()
    };
    let drops: Vec<StudyDrop> = (0..60)
        .map(|place| {
            let level = simulator.normal(0.002);
            StudyDrop {
                evidence: simulator.drop(&ranges[place % 3], falling, level, 0.001),
                scatter: Some(0.003),
                levels: vec![Some(place / 3 % 2), (place % 5 > 0).then_some(place % 5)],
            }
        })
        .collect();
    let whole = Study::of(&drops, &asked).unwrap();
    let of_group = |group: usize| {
        let of_part = |part: usize| {
            let mut sums = GroupSums::default();
            for drop in drops.iter().skip(part).step_by(3) {
                if drop.levels[0] == Some(group) {
                    sums.add(drop, &asked);
                }
            }
            let written = serde_json::to_string(&sums).unwrap();
            serde_json::from_str::<GroupSums>(&written).unwrap()
        };
        let mut sums = of_part(2);
        sums.merge(&of_part(0));
        sums.merge(&of_part(1));
        (vec![Some(group)], sums)
    };
    let merged = Study::of_sums(&[of_group(0), of_group(1)], &asked).unwrap();
    for (one, other) in whole.groups.iter().zip(&merged.groups) {
        assert_eq!((one.count, one.range_m_s), (other.count, other.range_m_s));
        let pairs = one.curve.iter().zip(&other.curve);
        let pairs = pairs.map(|(one, other)| (one.restitution, other.restitution));
        let scatters = (one.between_drops, other.between_drops);
        for (one, other) in pairs.chain([scatters]) {
            let close = |one: f64, other: f64| (one - other).abs() < 1e-9;
            assert!(
                close(one.value, other.value) && close(one.sd, other.sd),
                "{one:?} {other:?}"
            );
        }
    }
    let of_operators = |study: &Study| study.scatters[0].1.value;
    assert!((of_operators(&whole) - of_operators(&merged)).abs() < 1e-9);
}

/// One of 20 drops is of another ball, whose restitution is 3 % lower.
#[test]
fn a_drop_of_another_ball_is_named() {
    for seed in 0..20 {
        let mut simulator = Simulator::new(100 + seed);
        let drops = (0..20).map(|place| {
            let level = simulator.normal(0.002) - if place == 7 { 0.03 } else { 0.0 };
            simulator.drop(&[0.7, 1.4], falling, level, 0.001)
        });
        let study = studied(drops.collect(), |_| Vec::new(), &Asked::default());
        assert_eq!(study.outliers.first().map(|outlier| outlier.drop), Some(7));
        let without = study.groups[0].without_outliers.unwrap();
        assert!(without.value > study.groups[0].restitution.unwrap().value);
    }
}

/// With as many drops as planned the interval is about as narrow as was wanted.
#[test]
fn the_planned_number_of_drops_suffices() {
    let mut simulator = Simulator::new(5);
    let mut group = |count: usize| {
        let drops = (0..count).map(|_| {
            let level = simulator.normal(0.003);
            simulator.drop(&[0.7, 1.4], falling, level, 0.001)
        });
        let asked = Asked {
            wanted: Some(0.001),
            at_speed_m_s: Some(0.7),
            ..Asked::default()
        };
        studied(drops.collect(), |_| Vec::new(), &asked)
            .groups
            .remove(0)
    };
    let needed = group(2000).drops_needed.unwrap();
    let widths = (0..20).map(|_| group(needed).restitution.unwrap().interval95);
    let half = widths
        .map(|[low, high]| 0.5 * (high - low) / 20.0)
        .sum::<f64>();
    assert!((0.9..1.15).contains(&(half / 0.001)), "{half}");
    assert_eq!(drops_needed(0.0, 0.0, 0.001), Some(2));
}

/// The evidence of a drop is what its posterior knows, the prior of the law aside: the curve of one drop is that of its own
/// posterior, but for the scatter that one drop does not know.
#[test]
fn one_drop_tells_its_own_curve() {
    let times_s = [
        0.0, 0.4605, 0.8877, 1.2854, 1.6568, 2.0045, 2.3308, 2.6375, 2.9262, 3.1984, 3.4553, 3.698,
        3.9275, 4.1445,
    ];
    let mut options = Options::default();
    options.priors.restitution_laws = vec![LawKind::Smooth];
    let posterior = analyze_times(&times_s, &options)
        .drops
        .remove(0)
        .posterior
        .unwrap();
    let evidence = posterior.evidence().unwrap();
    assert!(evidence.is_usable());
    assert!((evidence.height.as_ref().unwrap().rel_sd) < 0.2);
    let study = studied(vec![evidence], |_| Vec::new(), &Asked::default());
    for point in &study.groups[0].curve {
        let own = posterior.restitution_at(point.speed_m_s).unwrap();
        let found = point.restitution;
        assert!(
            (found.value - own.value).abs() < 0.5 * own.sd.max(0.002),
            "{own:?} {found:?}"
        );
        assert!(found.sd > 0.9 * own.sd, "{own:?} {found:?}");
    }
    let height_m = study.drops[0].unwrap().height_m.unwrap();
    let own = posterior.drop_height_m;
    assert!(
        (height_m.value - own.value).abs() < 0.5 * own.sd,
        "{own:?} {height_m:?}"
    );
}

/// Drops of five impacts, whose law has coordinates that do not move the curve, tell it too.
#[test]
fn few_impacts_tell_a_curve() {
    let options = Options::new(ball::preset("tennis").unwrap().known);
    for times_s in [
        [0.0, 0.546, 0.957, 1.265, 1.496],
        [0.0, 0.548, 0.955, 1.266, 1.498],
        [0.0, 0.402, 0.701, 0.929, 1.097],
    ] {
        let posterior = analyze_times(&times_s, &options).drops.remove(0).posterior;
        let evidence = posterior.unwrap().evidence().expect("evidence");
        assert!(evidence.is_usable() && evidence.height.is_some());
        // The restitution of the middle flights is about 0.75.
        let study = studied(vec![evidence], |_| Vec::new(), &Asked::default());
        let found = study.groups[0].restitution.unwrap();
        assert!(holds(found.interval95, 0.75) && found.sd < 0.1, "{found:?}");
    }
}

/// One drop says little of the next one of its kind, and nothing says nothing.
#[test]
fn few_drops_are_uncertain() {
    let one = CurveEvidence::measured(&[(
        1.0,
        Measured {
            value: 0.9,
            sd: 1e-4,
        },
    )]);
    let study = studied(vec![one.clone()], |_| Vec::new(), &Asked::default());
    let [low, high] = study.groups[0].restitution.unwrap().interval95;
    assert!((0.02..0.2).contains(&(high - low)), "{low} {high}");
    let unusable = CurveEvidence::measured(&[(
        1.0,
        Measured {
            value: 0.9,
            sd: 0.0,
        },
    )]);
    let drops = [StudyDrop {
        evidence: unusable,
        scatter: None,
        levels: Vec::new(),
    }];
    assert!(Study::of(&drops, &Asked::default()).is_err());
    let asked = Asked {
        at_speed_m_s: Some(30.0),
        ..Asked::default()
    };
    let drops = [StudyDrop {
        evidence: one,
        scatter: None,
        levels: Vec::new(),
    }];
    assert!(Study::of(&drops, &asked).is_err());
}

/// Twenty good drops: one in a few hundred is named. With one wrong ball among them, it is.
#[test]
fn outliers_are_named_and_good_drops_seldom() {
    const REPEATS: usize = 500;
    let mut simulator = Simulator::new(6);
    let (mut falsely, mut found) = (0, 0);
    for _ in 0..REPEATS {
        let mut drops: Vec<Measured> = (0..20)
            .map(|_| Measured {
                value: 0.93 + simulator.normal(0.0022),
                sd: 0.001,
            })
            .collect();
        falsely += outliers(&drops, &[0; 20]).len();
        drops[7].value = 0.90;
        let named = outliers(&drops, &[0; 20]);
        found += usize::from(named.first().is_some_and(|outlier| outlier.drop == 7));
    }
    assert!(falsely < 20 * REPEATS / 100, "{falsely}");
    assert_eq!(found, REPEATS);
}
