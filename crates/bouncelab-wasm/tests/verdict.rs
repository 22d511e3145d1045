//! Drops that the page judges by a rule.

mod drops;

use bouncelab::settings::Settings;
use bouncelab_report::messages::Translator;
use bouncelab_report::report::Block;
use bouncelab_wasm::analyst::Analyst;
use bouncelab_wasm::verdict::{choices, judge, report};
use bouncelab_wasm::wire::{Judged, RuleChoice, VerdictRequest};
use drops::place;

/// The height of release of the rule of table tennis.
const FALL_M: f64 = 0.305;

fn rule(name: &str) -> RuleChoice {
    let mut choices = choices(&Translator::english()).unwrap().into_iter();
    choices.find(|choice| choice.name == name).unwrap()
}

fn request(rebound_m: f64, kept: &[&str]) -> VerdictRequest {
    let mut settings = Settings::default();
    settings.drop.height_m = Some(FALL_M);
    settings.drop.height_sd_m = Some(0.001);
    VerdictRequest {
        rule: rule("ittf-ball").rule,
        kept: kept.iter().map(|&part| part.to_owned()).collect(),
        settings,
        surface: (0..4)
            .map(|_| place("drop", rebound_m, (rebound_m / FALL_M).sqrt()))
            .collect(),
        reference: Vec::new(),
        made: None,
    }
}

fn judged(rebound_m: f64, kept: &[&str]) -> Judged {
    let request = request(rebound_m, kept);
    judge(&mut Analyst::default(), &request, &Translator::english()).unwrap()
}

fn lead(judged: &Judged) -> &str {
    match &judged.lead[0] {
        Block::Lead(words) => words,
        other => panic!("{other:?}"),
    }
}

/// The rule of table tennis wants 24 to 26 cm of 30.5 cm.
#[test]
fn a_rebound_within_the_limits_conforms_and_one_beyond_them_does_not() {
    let within = judged(0.25, &["surface"]);
    assert!(lead(&within).starts_with("CONFORMS."), "{}", lead(&within));
    let is_figure = |block: &Block| matches!(block, Block::Figure { .. });
    assert!(within.lead.iter().any(is_figure));
    let beyond = judged(0.28, &["surface"]);
    let outcome = lead(&beyond);
    assert!(outcome.starts_with("DOES NOT CONFORM."), "{outcome}");
}

#[test]
fn what_nothing_shows_is_asked() {
    let open = judged(0.25, &[]);
    let [surface] = &open.stated[..] else {
        panic!("{:?}", open.stated);
    };
    assert_eq!(surface.name, "surface");
    assert!(lead(&open).starts_with("CONFORMS AS FAR AS SHOWN."));
}

#[test]
fn the_report_is_one_file_with_the_figure() {
    let mut analyst = Analyst::default();
    let html = report(&mut analyst, &request(0.25, &[]), &Translator::english()).unwrap();
    assert!(html.contains("<svg") && html.contains("ittf-ball"));
}

#[test]
fn a_rule_without_a_ball_needs_one_of_the_settings() {
    let floor = rule("indoor-floor-basketball");
    let asked = VerdictRequest {
        rule: floor.rule,
        ..request(0.25, &[])
    };
    let judged = judge(&mut Analyst::default(), &asked, &Translator::english());
    assert_eq!(judged.is_ok(), floor.has_ball);
}
