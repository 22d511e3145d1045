//! Verdicts on balls, and "cannot decide" wherever the input is not what the rule wants. How often verdicts are wrong is
//! tested in `bouncelab-bench`.

use bouncelab::analysis::{self, Drop, Options};
use bouncelab::diagnostic::Code;
use bouncelab::drop::{self, Start, Stop};
use bouncelab::inference::{InferenceOptions, Measured, SamplerConfig};
use bouncelab::restitution::{Contact, Restitution};
use bouncelab::rulebook::{
    self, Averaging, Conditions, Decision, Evenness, Formula, InconclusiveReason, Limits, Outcome,
    Point, Remark, Requirement, Rule, Status, Verdict,
};

const FEW_DRAWS: usize = 400;

fn settings(height_m: f64) -> Options {
    let mut settings = Options::default();
    settings.priors.drop_height_m = Some(Measured {
        value: height_m,
        sd: 0.001,
    });
    settings.inference = Some(InferenceOptions {
        sampler: SamplerConfig {
            draws: FEW_DRAWS,
            seed: 1,
        },
        ..InferenceOptions::default()
    });
    settings
}

/// Eleven impacts of a drop with constant restitution from a height, in ambient conditions as they are assumed.
fn drop(restitution: f64, height_m: f64, settings: &Options) -> Drop {
    let law = Restitution::constant(restitution).unwrap();
    let contact = Contact::new(law, settings.contact_time_s).unwrap();
    let model = settings.model().unwrap();
    let history =
        drop::simulate(&model, &contact, Start::Height(height_m), Stop::after(11)).unwrap();
    let times_s: Vec<f64> = history
        .impact_events()
        .map(|strike| strike.time_s)
        .collect();
    analysis::analyze_impacts(analysis::impacts_of_times(&times_s), settings)
}

/// With this restitution the ball rebounds 25 cm from 30.5 cm.
const LIVELY: f64 = 0.935;

fn rule() -> Rule {
    Rule {
        requirement: Requirement::Height(Limits::between(0.24, 0.26)),
        measured_at: Some(Point::Bottom),
        status: Status::Verified,
        ..Rule::new("ittf-ball", "Table-tennis ball", 0.305)
    }
}

/// Each drop in a place of its own.
fn places<'a>(drops: &[&'a Drop]) -> Vec<Vec<&'a Drop>> {
    drops.iter().map(|&drop| vec![drop]).collect()
}

fn judged(rule: &Rule, surface: &[&Drop], reference: &[&Drop]) -> Verdict {
    let settings = settings(0.305);
    let conditions = Conditions::default();
    let (surface, reference) = (places(surface), places(reference));
    rulebook::judge(
        rule,
        &settings,
        &conditions,
        &surface,
        &reference,
        Decision::default(),
    )
    .unwrap()
}

#[test]
fn the_steps_from_the_plain_height_add_up() {
    let settings = settings(0.305);
    let drop = drop(LIVELY, 0.305, &settings);
    let rule = Rule {
        formula: Some(Formula {
            factor_m_s2: 1.23,
            offset_s: 0.025,
            status: Status::Unverified,
        }),
        ..rule()
    };
    let verdict = judged(&rule, &[&drop], &[]);
    let rebound = &verdict.drops[0];
    let plain = rebound.drag_free_m.unwrap();
    let time_s = rebound.first_flight_s.unwrap();
    assert!((plain - 9.806_65 * time_s * time_s / 8.0).abs() < 1e-9);
    let steps: f64 = rebound.steps.iter().map(|step| step.height_m).sum();
    let predicted = rebound.predicted_m.unwrap().value;
    assert!((plain + steps - predicted).abs() < 1e-9);
    // Contact, buoyancy and added mass make the plain height too high.
    assert!(rebound.steps[0].height_m < 0.0 && rebound.steps[1].height_m < 0.0);
    assert!((verdict.formula_m().unwrap() - 1.23 * (time_s - 0.025).powi(2)).abs() < 1e-12);
    assert!(verdict.remarks.contains(&Remark::UnverifiedFormula));
}

/// A rebound measured at the top is a diameter higher, and so is the release.
#[test]
fn the_point_of_measurement_moves_both_heights() {
    let settings = settings(0.305);
    let drop = drop(LIVELY, 0.305, &settings);
    let bottom = judged(&rule(), &[&drop], &[]);
    let at_top = Rule {
        measured_at: Some(Point::Top),
        drop_height_m: Some(0.345),
        requirement: Requirement::Height(Limits::between(0.28, 0.30)),
        ..rule()
    };
    let top = judged(&at_top, &[&drop], &[]);
    let higher = top.rebound.unwrap().value - bottom.rebound.unwrap().value;
    assert!((higher - 0.04).abs() < 1e-9);
    assert_eq!(
        (bottom.outcome, top.outcome),
        (Outcome::Pass, Outcome::Pass)
    );
    assert!((top.within.unwrap() - bottom.within.unwrap()).abs() < 1e-9);
}

/// Rebounds go as the square of restitution: here to 85 %.
#[test]
fn a_floor_is_compared_with_a_reference() {
    let settings = settings(0.305);
    let good = drop(LIVELY, 0.305, &settings);
    let dull = drop(LIVELY * 0.85_f64.sqrt(), 0.305, &settings);
    let floor = |least: f64| Rule {
        requirement: Requirement::Share {
            limits: Limits::at_least(least),
            of: "concrete".to_owned(),
        },
        ..rule()
    };
    let same = judged(&floor(0.9), &[&good], &[&good]);
    assert!((same.share.unwrap().value - 1.0).abs() < 0.002);
    assert_eq!(same.outcome, Outcome::Pass);
    let missing = judged(&floor(0.9), &[&good], &[]);
    assert_eq!(missing.doubts, [InconclusiveReason::NoReference]);
    assert_eq!(missing.outcome, Outcome::CannotDecide);
    let lower = judged(&floor(0.9), &[&dull], &[&good]);
    assert!((lower.share.unwrap().value - 0.85).abs() < 0.01);
    assert_eq!(lower.outcome, Outcome::Fail);
}

#[test]
fn places_must_be_alike_where_a_rule_says_so() {
    let settings = settings(0.305);
    let good = drop(LIVELY, 0.305, &settings);
    let lower = drop(0.98 * LIVELY, 0.305, &settings);
    let even = |most: f64| Rule {
        evenness: Some(Evenness::WithinOfMean(most)),
        requirement: Requirement::Height(Limits::between(0.2, 0.28)),
        ..rule()
    };
    let alone = judged(&even(0.03), &[&good], &[]);
    assert_eq!(alone.doubts, [InconclusiveReason::OnePlace]);
    let alike = judged(&even(0.03), &[&good, &good], &[]);
    assert_eq!(alike.outcome, Outcome::Pass, "{:?}", alike.doubts);
    // 4 % lower, so each is 2 % from the mean.
    let unlike = judged(&even(0.005), &[&good, &lower], &[]);
    assert!(unlike.unevenness.unwrap().value > 0.01);
    assert_ne!(unlike.outcome, Outcome::Pass);
}

#[test]
fn what_a_rule_wants_of_the_input_is_checked() {
    let settings = settings(0.305);
    let drop = drop(LIVELY, 0.305, &settings);
    let five = Rule {
        fewest_drops: 5,
        ..rule()
    };
    let too_few = judged(&five, &[&drop], &[]);
    assert_eq!(too_few.outcome, Outcome::CannotDecide);
    let reason = too_few.doubts[0].diagnostic();
    assert_eq!(reason.code, Code::RuleNeedsDrops);
    assert_eq!(
        (reason.number("needed"), reason.number("given")),
        (Some(5.0), Some(1.0))
    );
    let about = Rule {
        requirement: Requirement::About(0.23),
        ..rule()
    };
    assert_eq!(
        judged(&about, &[&drop], &[]).doubts,
        [InconclusiveReason::NoLimits]
    );
    let warm = Rule {
        temperature_k: Limits::between(294.0, 297.0),
        ..rule()
    };
    let unstated = judged(&warm, &[&drop], &[]);
    assert!(matches!(
        unstated.remarks[..],
        [Remark::TemperatureNotStated(_), Remark::FewDrops(1)]
    ));
    let cold = Conditions {
        temperature_k: Some(283.15),
        altitude_m: None,
    };
    let verdict = rulebook::judge(
        &warm,
        &settings,
        &cold,
        &[vec![&drop]],
        &[],
        Decision::default(),
    );
    assert_eq!(
        verdict.unwrap().doubts,
        [InconclusiveReason::Temperature(283.15)]
    );
}

/// A drop from far higher than stated is no test by the rule: no missed impact explains it.
#[test]
fn another_height_than_stated_is_noticed() {
    let settings = settings(0.305);
    let verdict = judged(&rule(), &[&drop(LIVELY, 0.5, &settings)], &[]);
    assert_eq!(verdict.outcome, Outcome::CannotDecide);
    assert!(
        matches!(verdict.doubts[0], InconclusiveReason::Height(_)),
        "{:?}",
        verdict.doubts
    );
}

/// The chances of two drops to be outside add up.
#[test]
fn each_drop_is_stricter_than_their_mean() {
    let settings = settings(0.305);
    let drop = drop(LIVELY, 0.305, &settings);
    let middle = judged(&rule(), &[&drop], &[]).rebound.unwrap();
    let [low, high] = [-1.5, 1.5].map(|steps| middle.value + steps * middle.sd);
    let tight = Rule {
        requirement: Requirement::Height(Limits::between(low, high)),
        ..rule()
    };
    let mean = judged(&tight, &[&drop, &drop], &[]).within.unwrap();
    let each = Rule {
        averaging: Averaging::Each,
        ..tight
    };
    let alone = judged(&each, &[&drop, &drop], &[]).within.unwrap();
    assert!(alone < mean, "{alone} {mean}");
    let even = Rule {
        evenness: Some(Evenness::WithinOfMean(0.5 * middle.sd / middle.value)),
        ..each
    };
    let even = judged(&even, &[&drop, &drop], &[]).within.unwrap();
    assert!(even < alone, "{even} {alone}");
}

#[test]
fn a_wider_risk_decides_more() {
    let settings = settings(0.305);
    let drop = drop(LIVELY, 0.305, &settings);
    let middle = judged(&rule(), &[&drop], &[]).rebound.unwrap();
    let near = Rule {
        requirement: Requirement::Height(Limits::at_least(middle.value - 0.5 * middle.sd)),
        ..rule()
    };
    let outcome = |decision| {
        let place = [vec![&drop]];
        let conditions = Conditions::default();
        let verdict = rulebook::judge(&near, &settings, &conditions, &place, &[], decision);
        verdict.unwrap().outcome
    };
    assert_eq!(outcome(Decision::default()), Outcome::CannotDecide);
    assert_eq!(outcome(Decision::Guarded { risk: 0.45 }), Outcome::Pass);
    assert_eq!(outcome(Decision::Simple), Outcome::Pass);
}
