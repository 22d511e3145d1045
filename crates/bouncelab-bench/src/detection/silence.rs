//! False drops in sound without a drop.

use super::backgrounds::Kind;
use super::drops::{detect, usual};
use super::reliability::Reliability;
use bouncelab::synth::{self, Clicks, Hum, Noise, Scene};

/// Seconds rendered at a time.
const PIECE_S: f64 = 600.0;

pub(crate) fn print(hours: f64, only: &str) {
    println!("\n| without a drop | hours | false drops | an hour | 95 % of |");
    println!("|---|---|---|---|---|");
    let mut reliability = Reliability::default();
    for (name, scene, background) in rows() {
        if name.contains(only) {
            row(&name, &scene, background, hours, &mut reliability);
        }
    }
    reliability.print("false drops");
}

/// What sounds, under which name.
fn rows() -> Vec<(String, Scene, Option<Kind>)> {
    let noise = |noise| Scene {
        noise: Some(noise),
        ..usual(0.0)
    };
    let hum = Scene {
        hum: Some(Hum {
            frequency_hz: 50.0,
            harmonics: 8,
            level_db: 0.0,
        }),
        ..usual(20.0)
    };
    let mut rows = vec![
        ("white noise".into(), noise(Noise::white(0.0)), None),
        ("pink noise".into(), noise(Noise::pink(0.0)), None),
        ("hum in white noise".into(), hum, None),
        ("speech-like".into(), usual(20.0), Some(Kind::Speech)),
        ("music-like".into(), usual(20.0), Some(Kind::Music)),
    ];
    for rate_per_s in [0.3, 1.0, 3.0, 7.0] {
        let clicks = Some(Clicks {
            rate_per_s,
            level_db: 0.0,
        });
        let scene = Scene {
            clicks,
            ..usual(30.0)
        };
        let name = format!("equal clicks at random, {rate_per_s} a second");
        rows.push((name, scene, None));
    }
    rows
}

fn row(
    name: &str,
    scene: &Scene,
    background: Option<Kind>,
    hours: f64,
    reliability: &mut Reliability,
) {
    let pieces = (hours * 3600.0 / PIECE_S).ceil() as u64;
    let scene = Scene {
        tail_s: PIECE_S,
        ..scene.clone()
    };
    let mut false_drops = 0_u32;
    for seed in 0..pieces {
        let mut sound =
            synth::render(&[], &scene, seed).unwrap_or_else(|error| panic!("{name}: {error}"));
        if let Some(kind) = background {
            kind.add(&mut sound, 0.1, seed);
        }
        let detection = detect(&sound.samples, sound.sample_rate_hz);
        for train in &detection.found.trains {
            false_drops += 1;
            reliability.add(train, 0);
        }
    }
    let hours = pieces as f64 * PIECE_S / 3600.0;
    let (least, most) = poisson_interval(false_drops);
    println!(
        "| {name} | {hours:.1} | {false_drops} | {:.2} | {:.2} to {:.2} |",
        f64::from(false_drops) / hours,
        least / hours,
        most / hours
    );
}

/// The 95 % confidence interval of the expectation of a Poisson distribution, by a count of events (Garwood 1936).
fn poisson_interval(count: u32) -> (f64, f64) {
    /// One side of the rest.
    const TAIL: f64 = 0.025;
    // At most `n` events where `mean` are expected.
    let at_most = |n: u32, mean: f64| {
        let terms = (1..=n).scan(1.0, |term, k| {
            *term *= mean / f64::from(k);
            Some(*term)
        });
        (-mean).exp() * (1.0 + terms.sum::<f64>())
    };
    let mean_with = |n: u32, share: f64| {
        let (mut low, mut high) = (0.0, 20.0 + 3.0 * f64::from(n));
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            if at_most(n, middle) > share {
                low = middle;
            } else {
                high = middle;
            }
        }
        low
    };
    let least = count
        .checked_sub(1)
        .map_or(0.0, |n| mean_with(n, 1.0 - TAIL));
    (least, mean_with(count, TAIL))
}
