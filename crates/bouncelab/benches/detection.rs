//! What detection costs: `cargo bench -p bouncelab --bench detection`.
//!
//! Items are samples: 44.1 million a second are 1000 times real time.

use bouncelab::detection::Detector;
use bouncelab::impact::ImpactEvent;
use bouncelab::onset::{Onset, OnsetDetector};
use bouncelab::synth::{self, Noise, Scene};
use bouncelab::train;
use bouncelab_testkit::impact_events;
use divan::counter::ItemsCount;
use divan::{Bencher, black_box};

const RATE_HZ: u32 = 44_100;

fn main() {
    divan::main();
}

/// A drop of seventy-odd impacts in this much background.
fn drop_in(duration_s: f64, noise: Noise) -> Vec<f32> {
    let events: Vec<ImpactEvent> = impact_events(2.4, 0.955)
        .take_while(|event| event.speed_m_s > 0.1)
        .collect();
    let lead_in_s = 5.0;
    let scene = Scene {
        noise: Some(noise),
        lead_in_s,
        tail_s: duration_s - lead_in_s - events[events.len() - 1].time_s,
        ..Scene::default()
    };
    synth::render(&events, &scene, 1).unwrap().samples
}

fn onsets(samples: &[f32]) -> Vec<Onset> {
    let mut onsets = Vec::new();
    let mut detector = OnsetDetector::new(RATE_HZ);
    detector.push(samples, &mut onsets);
    detector.finish(&mut onsets);
    onsets
}

fn minute(noise: Noise) -> Vec<f32> {
    drop_in(60.0, noise)
}

/// Onset candidates of a minute with a drop.
#[divan::bench]
fn onset_detector(bencher: Bencher) {
    let samples = minute(Noise::pink(40.0));
    bencher
        .counter(ItemsCount::new(samples.len()))
        .bench_local(|| onsets(black_box(&samples)));
}

/// The whole way from samples to aligned trains.
#[divan::bench(args = [40.0, 10.0])]
fn detector(bencher: Bencher, snr_db: f64) {
    detect(bencher, &minute(Noise::pink(snr_db)));
}

/// The same where ten balls are dropped in an hour: one in six minutes.
#[divan::bench]
fn detector_ten_drops_an_hour(bencher: Bencher) {
    detect(bencher, &drop_in(360.0, Noise::pink(40.0)));
}

/// The same without a drop.
#[divan::bench]
fn detector_without_a_drop(bencher: Bencher) {
    let scene = Scene {
        noise: Some(Noise::pink(40.0)),
        tail_s: 60.0,
        ..Scene::default()
    };
    detect(bencher, &synth::render(&[], &scene, 1).unwrap().samples);
}

fn detect(bencher: Bencher, samples: &[f32]) {
    bencher
        .counter(ItemsCount::new(samples.len()))
        .bench_local(|| {
            let mut detector = Detector::new(RATE_HZ, 1);
            for block in black_box(samples).chunks(4096) {
                detector.push(&[block]);
            }
            detector.finish()
        });
}

/// Onsets to trains; items are onsets.
#[divan::bench]
fn trains(bencher: Bencher) {
    let onsets = onsets(&minute(Noise::pink(40.0)));
    bencher
        .counter(ItemsCount::new(onsets.len()))
        .bench_local(|| train::find(black_box(&onsets)));
}

/// A worst case: thirty clicks a second at random; items are onsets.
#[divan::bench]
fn trains_in_a_crowd(bencher: Bencher) {
    let mut state = 1_u32;
    let mut time_s = 0.0;
    let onsets: Vec<Onset> = (0..1800)
        .map(|_| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            let chance = (f64::from(state >> 8) + 1.0) / f64::from(1 << 24);
            time_s -= chance.ln() / 30.0;
            Onset {
                strength: 40.0 * chance,
                level_db: -60.0 * chance,
                ..Onset::click(time_s)
            }
        })
        .collect();
    bencher
        .counter(ItemsCount::new(onsets.len()))
        .bench_local(|| train::find(black_box(&onsets)));
}
