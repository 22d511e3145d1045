//! How long it takes to render a minute of sound at 44.1 kHz.

use std::hint::black_box;

use bouncelab::impact::ImpactEvent;
use bouncelab::synth::{self, Clicks, Colour, Hum, Noise, Reverb, Scene};
use bouncelab_testkit::impact_events;
use divan::Bencher;
use divan::counter::ItemsCount;

fn main() {
    divan::main();
}

/// Sixty impacts, spread over a minute.
fn minute() -> Vec<ImpactEvent> {
    impact_events(8.5, 0.98).take(60).collect()
}

fn bench_scene(bencher: Bencher, scene: &Scene) {
    let events = minute();
    let samples = synth::render(&events, scene, 1)
        .expect("the scene is valid")
        .samples
        .len();
    bencher
        .counter(ItemsCount::new(samples))
        .bench(|| synth::render(black_box(&events), black_box(scene), 1));
}

#[divan::bench]
fn silence(bencher: Bencher) {
    bench_scene(
        bencher,
        &Scene {
            noise: None,
            ..Scene::default()
        },
    );
}

#[divan::bench(args = [Colour::White, Colour::Pink])]
fn noise(bencher: Bencher, colour: Colour) {
    let noise = Some(Noise {
        colour,
        snr_db: 40.0,
    });
    bench_scene(
        bencher,
        &Scene {
            noise,
            ..Scene::default()
        },
    );
}

#[divan::bench]
fn everything(bencher: Bencher) {
    let scene = Scene {
        noise: Some(Noise::pink(30.0)),
        hum: Some(Hum {
            frequency_hz: 50.0,
            harmonics: 5,
            level_db: -30.0,
        }),
        reverb: Some(Reverb {
            rt60_s: 0.5,
            direct_to_reverberant_db: 10.0,
        }),
        clicks: Some(Clicks {
            rate_per_s: 5.0,
            level_db: -10.0,
        }),
        ..Scene::default()
    };
    bench_scene(bencher, &scene);
}
