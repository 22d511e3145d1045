//! The stated ball against the drop: the analysis says nothing of the right ball, and notices a wrong one from high
//! drops.
//!
//! How often over many drops is a table of `docs/validation.md`; here is one drop of each preset, with errors from
//! a seed.

use bouncelab::analysis::{Drop, analyze_impacts};
use bouncelab::ball::{self, Preset};
use bouncelab::diagnostic::{Argument, Code};
use bouncelab::inference::{PossibleBall, SamplerConfig};
use bouncelab::{Impact, Options, Result};
use bouncelab_testkit::bouncing;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::StandardNormal;

const TIME_SD_S: f64 = 5e-5;
const SCATTER: f64 = 0.003;

/// A drop of one ball, of which another, or the same, is stated, with all presets compared.
fn compared(fell: &Preset, height_m: f64, restitution: f64, stated: &Preset) -> Result<Drop> {
    let mut rng = ChaCha8Rng::seed_from_u64(1);
    let mut normal = || rng.sample::<f64, _>(StandardNormal);
    let truth = Options::new(fell);
    let model = truth.model()?;
    let fall = model.fall(height_m)?;
    let scattered = |_| restitution * (SCATTER * normal()).exp();
    let events = bouncing(
        model,
        truth.contact_time_s,
        fall.impact_speed_m_s,
        scattered,
    );
    let events: Vec<_> = events.take(14).collect();
    let impacts = events.iter().zip(1..).map(|(event, number)| {
        let time_s = event.time_s + TIME_SD_S * normal();
        Impact::new(number, time_s).with_time_sd_s(TIME_SD_S)
    });
    // Enough for evidence in the powers of ten.
    let sampler = SamplerConfig {
        draws: 500,
        ..SamplerConfig::default()
    };
    let options = Options {
        compares_balls: true,
        ..Options::new(stated).with_sampler(sampler)
    };
    Ok(analyze_impacts(impacts.collect(), &options))
}

/// The argument of a diagnostic, if it was given.
fn said(drop: &Drop, code: Code, argument: &str) -> Option<Argument> {
    let known = drop.diagnostics.iter().find(|known| known.code == code)?;
    known.arguments.get(argument).cloned()
}

/// The kind of a preset.
fn kind_of(preset: &Preset) -> &'static str {
    match preset.name {
        "table-tennis-40" | "table-tennis-38" => "table-tennis",
        "pickleball" => "light-plastic",
        "golf" | "marble" | "steel" => "hard",
        "tennis" | "padel" | "squash" | "racquetball" | "rubber" => "soft-rubber",
        _ => "inflated",
    }
}

#[test]
fn every_preset_belongs_to_a_kind() {
    for preset in ball::presets() {
        assert_eq!(
            PossibleBall::kind_of(&preset.known),
            kind_of(preset),
            "{}",
            preset.name
        );
    }
}

#[test]
fn of_the_right_ball_nothing_is_said() -> Result<()> {
    for preset in ball::presets() {
        let drop = compared(preset, 1.0, 0.75, preset)?;
        assert_eq!(drop.balls.len(), ball::presets().len(), "{}", preset.name);
        for code in [Code::OtherBallFitsBetter, Code::RestitutionRises] {
            let given = drop.diagnostics.iter().any(|known| known.code == code);
            assert!(!given, "{}: {code:?}", preset.name);
        }
    }
    Ok(())
}

/// As a table-tennis ball such a drop would seem to be from 2.90 m.
#[test]
fn a_tennis_ball_from_high_up_is_not_taken_for_a_table_tennis_ball() -> Result<()> {
    let [tennis, assumed] = ["tennis", "table-tennis-40"].map(ball::preset);
    let drop = compared(tennis?, 2.5, 0.73, assumed?)?;
    let Some(Argument::Text(balls)) = said(&drop, Code::OtherBallFitsBetter, "balls") else {
        panic!("{:?}", drop.diagnostics);
    };
    assert!(
        balls.split(", ").any(|ball| ball == "soft-rubber"),
        "{balls}"
    );
    Ok(())
}

/// Of any ball, whatever else is stated, the one that fell is named or none: never only others.
#[test]
fn a_wrong_ball_is_never_named_without_the_right_one() -> Result<()> {
    let assumed = ball::preset("table-tennis-40")?;
    for preset in ball::presets().iter().filter(|it| it.name != assumed.name) {
        let drop = compared(preset, 2.5, 0.73, assumed)?;
        if let Some(Argument::Text(balls)) = said(&drop, Code::OtherBallFitsBetter, "balls") {
            let named = balls.split(", ").any(|ball| ball == kind_of(preset));
            assert!(named, "{}: {balls}", preset.name);
        }
    }
    Ok(())
}
