//! Verdicts by the procedure of a rule, and "cannot decide" wherever the input is not what the rule wants. Procedures worked
//! by hand are in `bouncelab-report`; how often verdicts are wrong is tested in `bouncelab-bench`.

use bouncelab::analysis::{self, Drop, Options};
use bouncelab::diagnostic::Code;
use bouncelab::drop::{self, Start, Stop};
use bouncelab::inference::{InferenceOptions, Measured, SamplerConfig};
use bouncelab::restitution::{Contact, Restitution};
use bouncelab::rulebook::{
    self, Averaging, Cause, Conditions, Decision, Evenness, Formula, InconclusiveReason, Item,
    Kept, Limits, Outcome, Point, Precision, Reading, Remark, Requirement, Rule, Verdict,
};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::StandardNormal;

const HEIGHT: Measured = Measured {
    value: 0.305,
    sd: 0.001,
};

fn settings() -> Options {
    let mut settings = Options::default();
    settings.priors.drop_height_m = Some(HEIGHT);
    settings.inference = None;
    settings
}

/// Eleven impacts of a drop with constant restitution from a height, in ambient conditions as they are assumed.
fn drop(restitution: f64, height_m: f64, settings: &Options) -> Drop {
    let law = Restitution::constant(restitution).unwrap();
    let contact = Contact::new(law, settings.contact_time_s).unwrap();
    let model = settings.model().unwrap();
    let history =
        drop::simulate(&model, &contact, Start::Height(height_m), Stop::after(11)).unwrap();
    let times_s: Vec<f64> = history.impact_events().map(|event| event.time_s).collect();
    analysis::analyze_impacts(analysis::impacts_of_times(&times_s), settings)
}

/// With this restitution the ball rebounds 25 cm from 30.5 cm.
const LIVELY: f64 = 0.935;

fn rule() -> Rule {
    Rule {
        requirement: Requirement::Height(Limits::between(0.24, 0.26)),
        measured_at: Some(Point::Bottom),
        ..Rule::new("ittf-ball", "Table-tennis ball", 0.305)
    }
}

fn shown() -> Conditions {
    Conditions {
        drop_height_m: Some(HEIGHT),
        ..Conditions::default()
    }
}

/// Each drop in a place of its own.
fn judged<'a>(
    rule: &Rule,
    surface: &[&'a Drop],
    reference: &[&'a Drop],
    conditions: &Conditions,
) -> Verdict {
    let place = |drops: &[&'a Drop]| drops.iter().map(|&drop| vec![drop]).collect::<Vec<_>>();
    let (surface, reference) = (place(surface), place(reference));
    rulebook::judge(
        rule,
        &settings(),
        conditions,
        &surface,
        &reference,
        Decision::default(),
    )
    .unwrap()
}

/// The height of the flight, exactly that of the simulation: the corrections of g T²/8 add up to it.
#[test]
fn the_height_is_that_of_the_flight() {
    let drop = drop(LIVELY, 0.305, &settings());
    let verdict = judged(&rule(), &[&drop], &[], &shown());
    let rebound = &verdict.drops[0];
    let simulated = drop.flight(1).unwrap().apex_m.unwrap();
    assert!((rebound.height_m.unwrap() - simulated).abs() < 1e-9);
    let mean = verdict.rebound.as_ref().unwrap();
    let corrections: f64 = mean.budget.iter().map(|part| part.correction_m).sum();
    assert!((verdict.drag_free_m().unwrap() + corrections - simulated).abs() < 1e-9);
    let squares: f64 = mean.budget.iter().map(|part| part.sd_m.powi(2)).sum();
    assert!((squares.sqrt() - mean.height_m.sd).abs() < 1e-12);
    assert_eq!(verdict.outcome, Outcome::Conforms);
    assert_eq!(verdict.model, None);
}

/// A formula is the measurand: nothing is corrected, and neither contact nor drag makes it uncertain.
#[test]
fn a_formula_of_the_rule_decides() {
    let drop = drop(LIVELY, 0.305, &settings());
    let rule = Rule {
        formula: Some(Formula {
            factor_m_s2: 1.23,
            offset_s: 0.025,
            read: Reading::Memory,
        }),
        ..rule()
    };
    let verdict = judged(&rule, &[&drop], &[], &shown());
    let time_s = verdict.drops[0].first_flight_s.unwrap();
    let by_hand = 1.23 * (time_s - 0.025).powi(2);
    let mean = verdict.rebound.as_ref().unwrap();
    assert!((mean.height_m.value - by_hand).abs() < 1e-12);
    let causes: Vec<Cause> = mean.budget.iter().map(|part| part.cause).collect();
    assert_eq!(
        causes,
        [Cause::Release, Cause::Times, Cause::AssumedScatter]
    );
    assert!(
        verdict
            .remarks
            .contains(&Remark::FormulaNotPrimary(Reading::Memory))
    );
    assert_eq!(verdict.outcome, Outcome::DoesNotConform);
}

/// A formula that is 2 cm off is named, and it decides all the same.
#[test]
fn a_difference_to_the_model_is_named() {
    let mut settings = settings();
    settings.inference = Some(InferenceOptions {
        sampler: SamplerConfig {
            draws: 400,
            seed: 1,
        },
        ..InferenceOptions::default()
    });
    let drop = drop(LIVELY, 0.305, &settings);
    let differing = Rule {
        formula: Some(Formula {
            factor_m_s2: 1.13,
            offset_s: 0.0,
            read: Reading::Primary,
        }),
        ..rule()
    };
    let remarks = |rule: &Rule| {
        let places = [vec![&drop, &drop]];
        let verdict =
            rulebook::judge(rule, &settings, &shown(), &places, &[], Decision::default()).unwrap();
        let model = verdict.model.unwrap().value;
        assert!((0.24..0.26).contains(&model), "{model}");
        verdict.remarks
    };
    assert!(!remarks(&rule()).contains(&Remark::ModelDiffers));
    assert!(remarks(&differing).contains(&Remark::ModelDiffers));
}

/// A rebound measured at the top is a diameter higher, and so is the release.
#[test]
fn the_point_of_measurement_moves_both_heights() {
    let drop = drop(LIVELY, 0.305, &settings());
    let bottom = judged(&rule(), &[&drop], &[], &shown());
    let at_top = Rule {
        measured_at: Some(Point::Top),
        drop_height_m: Some(0.345),
        requirement: Requirement::Height(Limits::between(0.28, 0.30)),
        ..rule()
    };
    let top = judged(&at_top, &[&drop], &[], &shown());
    let higher = top.value().unwrap().value - bottom.value().unwrap().value;
    assert!((higher - 0.04).abs() < 1e-9);
    assert_eq!(
        (bottom.outcome, top.outcome),
        (Outcome::Conforms, Outcome::Conforms)
    );
}

/// Rebounds go as the square of restitution: here to 85 %.
#[test]
fn a_floor_is_compared_with_a_reference() {
    let good = drop(LIVELY, 0.305, &settings());
    let dull = drop(LIVELY * 0.85_f64.sqrt(), 0.305, &settings());
    let floor = Rule {
        requirement: Requirement::Share {
            limits: Limits::at_least(0.9),
            of: "concrete".to_owned(),
        },
        ..rule()
    };
    let same = judged(&floor, &[&good], &[&good], &shown());
    assert!((same.share.unwrap().value - 1.0).abs() < 1e-9);
    assert_eq!(same.outcome, Outcome::ConformsAsFarAsShown);
    let kept = Conditions {
        kept: vec![Item::Reference],
        ..shown()
    };
    assert_eq!(
        judged(&floor, &[&good], &[&good], &kept).outcome,
        Outcome::Conforms
    );
    let missing = judged(&floor, &[&good], &[], &kept);
    assert_eq!(
        missing.doubts,
        [InconclusiveReason::NotKept(Item::ReferenceDrops)]
    );
    assert_eq!(missing.outcome, Outcome::CannotDecide);
    let lower = judged(&floor, &[&dull, &dull], &[&good, &good], &kept);
    assert!((lower.share.unwrap().value - 0.85).abs() < 0.01);
    assert_eq!(lower.outcome, Outcome::DoesNotConform);
}

#[test]
fn places_must_be_alike_where_a_rule_says_so() {
    let good = drop(LIVELY, 0.305, &settings());
    let lower = drop(0.98 * LIVELY, 0.305, &settings());
    let even = |most: f64| Rule {
        evenness: Some(Evenness::WithinOfMean(most)),
        requirement: Requirement::Height(Limits::between(0.2, 0.28)),
        ..rule()
    };
    let alone = judged(&even(0.03), &[&good], &[], &shown());
    assert_eq!(alone.doubts, [InconclusiveReason::NotKept(Item::Places)]);
    let judge_places = |even: &Rule, drops: &[Vec<&Drop>]| {
        rulebook::judge(even, &settings(), &shown(), drops, &[], Decision::default()).unwrap()
    };
    let alike = judge_places(&even(0.03), &[vec![&good; 3], vec![&good; 3]]);
    assert_eq!(alike.outcome, Outcome::Conforms, "{:?}", alike.doubts);
    // 4 % lower, so each is 2 % from the mean.
    let unlike = judge_places(&even(0.005), &[vec![&good; 3], vec![&lower; 3]]);
    assert!(unlike.unevenness.unwrap().value > 0.01);
    assert_eq!(unlike.outcome, Outcome::DoesNotConform);
}

#[test]
fn every_part_of_the_procedure_is_checked() {
    let drop = drop(LIVELY, 0.305, &settings());
    let strict = Rule {
        fewest_drops: 2,
        temperature_k: Limits::between(294.0, 297.0),
        humidity: Limits::between(0.4, 0.6),
        altitude_m: Limits {
            least: None,
            greatest: Some(1219.0),
        },
        surface: Some("steel block".to_owned()),
        conditioning: Some("24 hours".to_owned()),
        ..rule()
    };
    let state = |conditions: &Conditions, count: usize| {
        let verdict = judged(&strict, &vec![&drop; count], &[], conditions);
        let states: Vec<(Item, Kept)> = verdict
            .procedure
            .iter()
            .map(|check| (check.item, check.kept))
            .collect();
        (verdict.outcome, states, verdict.doubts)
    };
    let items = [
        Item::Release,
        Item::Surface,
        Item::Conditioning,
        Item::Temperature,
        Item::Humidity,
        Item::Altitude,
        Item::Drops,
    ];
    let (outcome, states, _) = state(&Conditions::default(), 2);
    assert_eq!(outcome, Outcome::ConformsAsFarAsShown);
    let unknown = items.map(|item| {
        (
            item,
            if item == Item::Drops {
                Kept::Yes
            } else {
                Kept::NotShown
            },
        )
    });
    assert_eq!(states, unknown);
    let all = Conditions {
        temperature_k: Some(295.0),
        relative_humidity: Some(0.5),
        altitude_m: Some(100.0),
        kept: vec![Item::Surface, Item::Conditioning],
        ..shown()
    };
    let (outcome, states, _) = state(&all, 2);
    assert_eq!(
        (outcome, states),
        (
            Outcome::Conforms,
            items.map(|item| (item, Kept::Yes)).to_vec()
        )
    );
    let wrong = Conditions {
        temperature_k: Some(283.15),
        relative_humidity: Some(0.9),
        altitude_m: Some(2000.0),
        drop_height_m: Some(Measured {
            value: 0.4,
            sd: 0.001,
        }),
        ..all
    };
    let (outcome, _, doubts) = state(&wrong, 1);
    assert_eq!(outcome, Outcome::CannotDecide);
    let broken = [
        Item::Release,
        Item::Temperature,
        Item::Humidity,
        Item::Altitude,
        Item::Drops,
    ];
    assert_eq!(doubts, broken.map(InconclusiveReason::NotKept));
    let about = Rule {
        requirement: Requirement::About(0.23),
        ..rule()
    };
    assert_eq!(
        judged(&about, &[&drop], &[], &shown()).doubts,
        [InconclusiveReason::NoLimits]
    );
}

/// A list that begins with the second impact has no first flight.
#[test]
fn without_the_first_flight_nothing_is_decided() {
    let whole = drop(LIVELY, 0.305, &settings());
    let mut later = whole.clone();
    later.flights.retain(|flight| flight.number > 1);
    let verdict = judged(&rule(), &[&whole, &later], &[], &shown());
    assert_eq!(verdict.doubts, [InconclusiveReason::NoFirstFlight(2)]);
    assert_eq!(
        verdict.doubts[0].diagnostic().code,
        Code::DropWithoutFirstFlight
    );
    assert_eq!(
        (verdict.outcome, verdict.within),
        (Outcome::CannotDecide, None)
    );
}

/// The chances of two drops to be outside add up. The rounding of the result widens the limits by half a step.
#[test]
fn each_drop_and_the_rounding_count() {
    let drop = drop(LIVELY, 0.305, &settings());
    let middle = judged(&rule(), &[&drop, &drop], &[], &shown())
        .value()
        .unwrap();
    let [low, high] = [-1.5, 1.5].map(|steps| middle.value + steps * middle.sd);
    let tight = Rule {
        requirement: Requirement::Height(Limits::between(low, high)),
        ..rule()
    };
    let within = |rule: &Rule| judged(rule, &[&drop, &drop], &[], &shown()).within.unwrap();
    let each = Rule {
        averaging: Averaging::Each,
        ..tight.clone()
    };
    // All of the uncertainty is shared here: 1 - 2 p of two drops against 1 - p of their mean.
    assert!((1.0 - within(&each) - 2.0 * (1.0 - within(&tight))).abs() < 1e-9);
    let rounded = Rule {
        rounding: Some(middle.sd),
        ..tight.clone()
    };
    let wider = Rule {
        requirement: Requirement::Height(Limits::between(
            low - middle.sd / 2.0,
            high + middle.sd / 2.0,
        )),
        ..tight.clone()
    };
    assert!((within(&rounded) - within(&wider)).abs() < 1e-12);
    assert!(within(&rounded) > within(&tight));
}

#[test]
fn a_wider_risk_decides_more_and_more_drops_are_told() {
    let [low, high] =
        [LIVELY - 0.004, LIVELY + 0.004].map(|restitution| drop(restitution, 0.305, &settings()));
    let drops = [&low, &high, &low, &high];
    let middle = judged(&rule(), &drops, &[], &shown()).value().unwrap();
    let near = |steps: f64| Rule {
        requirement: Requirement::Height(Limits::at_least(middle.value - steps * middle.sd)),
        ..rule()
    };
    let verdict = |rule: &Rule, decision| {
        let place = [drops.to_vec()];
        rulebook::judge(rule, &settings(), &shown(), &place, &[], decision).unwrap()
    };
    let undecided = verdict(&near(1.5), Decision::default());
    assert_eq!(undecided.outcome, Outcome::CannotDecide);
    assert_eq!(undecided.doubts, [InconclusiveReason::TooUncertain]);
    let told = undecided.remarks.iter().find_map(|remark| match remark {
        Remark::DecidingDrops(count) => Some(*count),
        _ => None,
    });
    assert!((5..20).contains(&told.unwrap()), "{told:?}");
    assert!(
        verdict(&near(0.01), Decision::default())
            .remarks
            .contains(&Remark::NoDropsDecide)
    );
    assert_eq!(
        verdict(&near(0.5), Decision::Guarded { risk: 0.45 }).outcome,
        Outcome::Conforms
    );
    assert_eq!(
        verdict(&near(0.5), Decision::Simple).outcome,
        Outcome::Conforms
    );
}

/// Of levels and drops that are drawn with known standard deviations, the 95 % intervals hold these in at least 93 %.
#[test]
fn intervals_of_repeatability_and_reproducibility_hold_the_truth() {
    const RUNS: usize = 1500;
    const REPEATABILITY_M: f64 = 0.004;
    let mut chance = ChaCha8Rng::seed_from_u64(5725);
    let mut drawn = |sd: f64| -> f64 {
        let error: f64 = chance.sample(StandardNormal);
        sd * error
    };
    for between_m in [0.0, 0.002, 0.008] {
        let truth_m = [REPEATABILITY_M, REPEATABILITY_M.hypot(between_m)];
        let mut held = [0; 2];
        for _ in 0..RUNS {
            let levels: Vec<Vec<f64>> = (0..5)
                .map(|_| {
                    let level_m = 0.8 + drawn(between_m);
                    (0..5).map(|_| level_m + drawn(REPEATABILITY_M)).collect()
                })
                .collect();
            let precision = Precision::of(&levels).unwrap();
            let found = [precision.repeatability_m, precision.reproducibility_m];
            for (number, found) in found.iter().enumerate() {
                let [low, high] = found.interval95;
                held[number] += usize::from((low..=high).contains(&truth_m[number]));
            }
        }
        for count in held {
            assert!(count as f64 > 0.93 * RUNS as f64, "{between_m}: {held:?}");
        }
    }
}
