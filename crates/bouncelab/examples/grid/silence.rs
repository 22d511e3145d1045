//! False drops in sound without a drop.

use crate::backgrounds::Kind;
use crate::drops::{hear, usual};
use bouncelab::synth::{self, Clicks, Hum, Noise, Scene};

/// Seconds rendered at a time.
const PIECE_S: f64 = 600.0;

pub(crate) fn print(hours: f64) {
    println!("\n| without a drop | hours | false drops | an hour |");
    println!("|---|---|---|---|");
    let noise = |noise| Scene {
        noise: Some(noise),
        ..usual(0.0)
    };
    let clicks = |rate_per_s| Scene {
        clicks: Some(Clicks {
            rate_per_s,
            level_db: 0.0,
        }),
        ..usual(30.0)
    };
    let hum = Some(Hum {
        frequency_hz: 50.0,
        harmonics: 8,
        level_db: 0.0,
    });
    row("white noise", &noise(Noise::white(0.0)), None, hours);
    row("pink noise", &noise(Noise::pink(0.0)), None, hours);
    row(
        "hum in white noise",
        &Scene { hum, ..usual(20.0) },
        None,
        hours,
    );
    row("speech-like", &usual(20.0), Some(Kind::Speech), hours);
    row("music-like", &usual(20.0), Some(Kind::Music), hours);
    for rate_per_s in [0.3, 1.0, 3.0, 7.0] {
        let name = format!("equal clicks at random, {rate_per_s} a second");
        row(&name, &clicks(rate_per_s), None, hours);
    }
}

fn row(name: &str, scene: &Scene, background: Option<Kind>, hours: f64) {
    let pieces = (hours * 3600.0 / PIECE_S).ceil() as u64;
    let scene = Scene {
        tail_s: PIECE_S,
        ..scene.clone()
    };
    let mut false_drops = 0;
    for seed in 0..pieces {
        let mut sound =
            synth::render(&[], &scene, seed).unwrap_or_else(|error| panic!("{name}: {error}"));
        if let Some(kind) = background {
            kind.add(&mut sound, 0.1, seed);
        }
        false_drops += hear(&sound.samples, sound.sample_rate_hz)
            .found
            .trains
            .len();
    }
    let hours = pieces as f64 * PIECE_S / 3600.0;
    println!(
        "| {name} | {hours:.1} | {false_drops} | {:.2} |",
        f64::from(u32::try_from(false_drops).unwrap_or(u32::MAX)) / hours
    );
}
