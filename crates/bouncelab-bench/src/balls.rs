//! How often another ball is named: rightly, when the wrong one was stated, and wrongly, when the right
//! one was.
//!
//! ```text
//! cargo xtask balls 100
//! ```
//!
//! simulates this number of drops of each preset ball (restitution 0.6 to 0.9 at 1 m/s, falling with the speed
//! or not; scatter 0.3 %, times good to 50 µs) from 0.3 to 1.5 m and as many from 2.5 m, and prints
//! `docs/tables/balls.txt`.

use bouncelab::Impact;
use bouncelab::analysis::{Drop, analyze_impacts};
use bouncelab::ball::{self, Preset};
use bouncelab::diagnostic::{Argument, Code};
use bouncelab::inference::PossibleBall;
use bouncelab::{Options, Result};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rand_distr::StandardNormal;

const TIME_SD_S: f64 = 5e-5;
const SCATTER: f64 = 0.003;
const MAX_IMPACTS: usize = 30;
const SHORTEST_FLIGHT_S: f64 = 0.06;

/// From which heights the balls are dropped: in words, and the lowest and the highest in metres.
const HEIGHTS: [(&str, f64, f64); 2] = [("0.3 to 1.5 m", 0.3, 1.5), ("2.5 m", 2.5, 2.5)];

/// `balls [DROPS]`: prints the table.
///
/// # Errors
///
/// If a drop cannot be simulated.
pub fn run(arguments: &[String]) -> crate::Result {
    let count = arguments.first().and_then(|count| count.parse().ok());
    let count = count.unwrap_or(20);
    println!(
        "| dropped from | the ball | stated rightly: doubted | another is named \
         | as table tennis 40+: doubted | it is named | another is named | nothing said |"
    );
    println!("|---|---|--:|--:|--:|--:|--:|--:|");
    let assumed = &ball::presets()[0];
    for (from, lowest_m, highest_m) in HEIGHTS {
        for truth in ball::presets() {
            let (mut right, mut wrong) = (Count::default(), Count::default());
            for seed in 0..count {
                let impacts = drop(
                    truth,
                    (lowest_m, highest_m),
                    &mut ChaCha8Rng::seed_from_u64(seed),
                )?;
                right.add(impacts.clone(), truth, truth);
                wrong.add(impacts, assumed, truth);
            }
            println!(
                "| {from} | {} | {} | {} | {} | {} | {} | {} |",
                truth.label,
                right.doubted,
                right.other,
                wrong.doubted,
                wrong.right,
                wrong.other,
                wrong.nothing
            );
        }
    }
    Ok(())
}

/// What was said of drops.
#[derive(Default)]
struct Count {
    /// That the restitution rises with the speed.
    doubted: u32,
    /// That balls fit better, among which is the one that fell.
    right: u32,
    /// That balls fit better, all of which are wrong.
    other: u32,
    /// Neither.
    nothing: u32,
}

impl Count {
    /// Analyses a drop of one ball as one of another, or the same.
    fn add(&mut self, impacts: Vec<Impact>, stated: &Preset, truth: &Preset) {
        let drop = analyze_impacts(impacts, &Options::new(stated));
        let fallen = PossibleBall::kind_of(&truth.known);
        let doubted = said(&drop, Code::RestitutionRises).is_some();
        self.doubted += u32::from(doubted);
        match said(&drop, Code::OtherBallFitsBetter) {
            Some(kinds) if kinds.split(", ").any(|kind| kind == fallen) => self.right += 1,
            Some(_) => self.other += 1,
            None => self.nothing += u32::from(!doubted),
        }
    }
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
fn drop(
    preset: &Preset,
    (lowest_m, highest_m): (f64, f64),
    rng: &mut ChaCha8Rng,
) -> Result<Vec<Impact>> {
    let spread = |sd: f64, rng: &mut ChaCha8Rng| {
        let normal: f64 = rng.sample(StandardNormal);
        (sd * normal).exp()
    };
    let options = Options::new(preset);
    // Drag goes with the density of the air, and weight with the mass.
    let drag = spread(
        preset.known.drag_rel_sd.hypot(preset.known.mass_rel_sd),
        rng,
    );
    let air = options.environment.air;
    let air = bouncelab::air::Air::new(air.density_kg_m3() * drag, air.viscosity_pa_s())?;
    let model = options.clone().with_air(air).model()?;
    let restitution = 0.6 + 0.3 * rng.random::<f64>();
    let slope = 0.1 * rng.random::<f64>() * f64::from(rng.random::<bool>());
    let height_m = lowest_m * (highest_m / lowest_m).powf(rng.random());
    let mut speed_m_s = model.fall(height_m)?.impact_speed_m_s;
    let mut time_s = 0.0;
    let mut impacts = Vec::new();
    for number in 1..=MAX_IMPACTS {
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
