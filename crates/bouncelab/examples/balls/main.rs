//! How often another ball is named: rightly, when the wrong one was stated, and wrongly, when the right
//! one was.
//!
//! ```text
//! cargo run --release -p bouncelab --example balls 100
//! ```
//!
//! simulates so many drops of each preset ball (restitution 0.6 to 0.9 at 1 m/s, falling with the speed
//! or not; scatter 0.3 %, times good to 50 µs, heights of 0.3 to 1.5 m) and prints the table of
//! `docs/validation.md`.

use bouncelab::Impact;
use bouncelab::analysis::{Drop, analyze_impacts};
use bouncelab::ball::{self, Preset};
use bouncelab::diagnostic::{Argument, Code};
use bouncelab::{Options, Result};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::StandardNormal;

const TIME_SD_S: f64 = 5e-5;
const SCATTER: f64 = 0.003;
const MOST_IMPACTS: usize = 30;
const SHORTEST_FLIGHT_S: f64 = 0.06;

fn main() -> Result<()> {
    let count = std::env::args().nth(1).and_then(|count| count.parse().ok());
    let count = count.unwrap_or(20);
    println!(
        "| the ball | stated rightly: doubted | as table tennis 40+: doubted | compared: it is named | not named | nothing said |"
    );
    println!("|---|--:|--:|--:|--:|--:|");
    let assumed = &ball::presets()[0];
    for truth in ball::presets() {
        let (mut doubted, mut rises, mut named, mut missed, mut silent) = (0, 0, 0, 0, 0);
        for seed in 0..count {
            let impacts = drop(truth, &mut ChaCha8Rng::seed_from_u64(seed))?;
            let right = analyze_impacts(impacts.clone(), &Options::new(truth));
            let wrong = Options::new(assumed).with_ball_comparison();
            let wrong = analyze_impacts(impacts, &wrong);
            doubted += usize::from(said(&right, Code::RestitutionRises).is_some());
            rises += usize::from(said(&wrong, Code::RestitutionRises).is_some());
            match said(&wrong, Code::OtherBallFitsBetter) {
                Some(better) if better.contains(truth.name) => named += 1,
                Some(_) => missed += 1,
                None => silent += 1,
            }
        }
        println!(
            "| {} | {doubted} | {rises} | {named} | {missed} | {silent} |",
            truth.label
        );
    }
    Ok(())
}

/// The balls that a diagnostic names, if it was given.
fn said(drop: &Drop, code: Code) -> Option<String> {
    let known = drop.diagnostics.iter().find(|known| known.code == code)?;
    match known.arguments.get("balls") {
        Some(Argument::Text(balls)) => Some(balls.clone()),
        _ => Some(String::new()),
    }
}

/// A drop of a ball whose mass, size and drag differ from the nominal as the preset says.
fn drop(preset: &Preset, rng: &mut ChaCha8Rng) -> Result<Vec<Impact>> {
    let spread = |sd: f64, rng: &mut ChaCha8Rng| {
        let normal: f64 = rng.sample(StandardNormal);
        (sd * normal).exp()
    };
    let options = Options::new(preset);
    // Drag goes with the density of the air, and weight with the mass.
    let drag = spread(preset.drag_sd.hypot(preset.mass_sd), rng);
    let air = options.environment.air;
    let air = bouncelab::air::Air::new(air.density_kg_m3() * drag, air.viscosity_pa_s())?;
    let model = options.clone().with_air(air).model()?;
    let restitution = 0.6 + 0.3 * rng.random::<f64>();
    let slope = 0.1 * rng.random::<f64>() * f64::from(rng.random::<bool>());
    let height_m = 0.3 * 5_f64.powf(rng.random());
    let mut speed_m_s = model.fall(height_m)?.impact_speed_m_s;
    let mut time_s = 0.0;
    let mut impacts = Vec::new();
    for number in 1..=MOST_IMPACTS {
        let off: f64 = rng.sample(StandardNormal);
        let impact = Impact::new(number, time_s + TIME_SD_S * off);
        impacts.push(impact.with_time_sd_s(TIME_SD_S));
        let kept = restitution * speed_m_s.powf(-slope) * spread(SCATTER, rng);
        let flight = model.launch(speed_m_s * kept.min(0.98))?;
        if flight.time_s() < SHORTEST_FLIGHT_S {
            break;
        }
        time_s += flight.time_s() + options.contact_time_s;
        speed_m_s = flight.impact_speed_m_s;
    }
    Ok(impacts)
}
