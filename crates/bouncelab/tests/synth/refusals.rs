//! Absurd wishes are refused, each with the name of what was wrong.

use bouncelab::impact::ImpactEvent;
use bouncelab::synth::{BitDepth, Clicks, Hum, Lost, Mode, Noise, Reverb, Scene, Voice, render};
use bouncelab::{Error, Quantity};
use proptest::prelude::*;

use crate::{EVENTS, bare, event};

fn refused(scene: &Scene) -> Quantity {
    refused_events(&EVENTS, scene)
}

fn refused_events(events: &[ImpactEvent], scene: &Scene) -> Quantity {
    match render(events, scene, 1) {
        Err(Error::OutOfRange { quantity, .. }) => quantity,
        other => panic!(
            "accepted, or refused otherwise: {:?}",
            other.map(|r| r.impacts)
        ),
    }
}

#[test]
fn absurd_scenes_are_refused_by_name() {
    let quantity = |change: fn(&mut Scene)| {
        let mut scene = Scene::default();
        change(&mut scene);
        refused(&scene)
    };
    assert_eq!(quantity(|s| s.sample_rate_hz = 0), Quantity::SampleRate);
    assert_eq!(quantity(|s| s.sample_rate_hz = 3_999), Quantity::SampleRate);
    assert_eq!(
        quantity(|s| s.sample_rate_hz = u32::MAX),
        Quantity::SampleRate
    );
    assert_eq!(quantity(|s| s.lead_in_s = -1.0), Quantity::LeadIn);
    assert_eq!(quantity(|s| s.lead_in_s = f64::NAN), Quantity::LeadIn);
    assert_eq!(quantity(|s| s.tail_s = 0.0), Quantity::Tail);
    assert_eq!(quantity(|s| s.tail_s = f64::INFINITY), Quantity::Tail);
    assert_eq!(quantity(|s| s.voice.modes.clear()), Quantity::Modes);
    assert_eq!(
        quantity(|s| s.voice.modes[0].frequency_hz = 0.0),
        Quantity::ModeFrequency
    );
    assert_eq!(
        quantity(|s| s.voice.modes[0].decay_s = -1.0),
        Quantity::DecayTime
    );
    assert_eq!(
        quantity(|s| s.voice.modes[0].decay_s = 11.0),
        Quantity::DecayTime
    );
    assert_eq!(
        quantity(|s| s.voice.modes[0].level = f64::NAN),
        Quantity::ModeLevel
    );
    assert_eq!(
        quantity(|s| s.voice.contact_time_s = 0.0),
        Quantity::ContactTime
    );
    assert_eq!(quantity(|s| s.voice.attack = 1.1), Quantity::Attack);
    assert_eq!(
        quantity(|s| s.voice.level_exponent = -1.0),
        Quantity::LevelExponent
    );
    assert_eq!(quantity(|s| s.level_scatter = 2.0), Quantity::LevelScatter);
    assert_eq!(
        quantity(|s| s.phase_scatter_rad = -0.1),
        Quantity::PhaseScatter
    );
    assert_eq!(quantity(|s| s.peak = 0.0), Quantity::Peak);
    assert_eq!(quantity(|s| s.dc_offset = 2.0), Quantity::DcOffset);
    assert_eq!(quantity(|s| s.clip_at = Some(0.0)), Quantity::ClippingLevel);
    assert_eq!(
        quantity(|s| s.noise = Some(Noise::white(f64::NAN))),
        Quantity::Snr
    );
    assert_eq!(
        quantity(|s| s.lost = Lost::Chance(1.5)),
        Quantity::LossProbability
    );
    assert_eq!(
        quantity(|s| s.lost = Lost::At(vec![4])),
        Quantity::LostImpact
    );
}

#[test]
fn absurd_disturbances_are_refused_by_name() {
    let hum = |frequency_hz, harmonics, level_db| {
        refused(&Scene {
            hum: Some(Hum {
                frequency_hz,
                harmonics,
                level_db,
            }),
            ..Scene::default()
        })
    };
    assert_eq!(hum(22_050.0, 1, -20.0), Quantity::HumFrequency);
    assert_eq!(hum(50.0, 0, -20.0), Quantity::HumHarmonics);
    assert_eq!(hum(50.0, 1, f64::INFINITY), Quantity::HumLevel);
    let reverb = |rt60_s, direct_to_reverberant_db| {
        refused(&Scene {
            reverb: Some(Reverb {
                rt60_s,
                direct_to_reverberant_db,
            }),
            ..Scene::default()
        })
    };
    assert_eq!(reverb(0.0, 10.0), Quantity::ReverberationTime);
    assert_eq!(reverb(1.0, f64::NAN), Quantity::DirectToReverberant);
    let clicks = |rate_per_s, level_db| {
        refused(&Scene {
            clicks: Some(Clicks {
                rate_per_s,
                level_db,
            }),
            ..Scene::default()
        })
    };
    assert_eq!(clicks(0.0, 0.0), Quantity::ClickRate);
    assert_eq!(clicks(1e9, 0.0), Quantity::ClickRate);
    assert_eq!(clicks(1.0, 100.0), Quantity::ClickLevel);
}

#[test]
fn impacts_out_of_range_are_refused_by_name() {
    let scene = Scene::default();
    let one = |time_s, speed_m_s| refused_events(&[event(time_s, speed_m_s)], &scene);
    assert_eq!(one(-0.1, 1.0), Quantity::ImpactTime);
    assert_eq!(one(f64::NAN, 1.0), Quantity::ImpactTime);
    assert_eq!(one(0.0, 0.0), Quantity::ImpactSpeed);
    assert_eq!(one(0.0, f64::INFINITY), Quantity::ImpactSpeed);
    let backwards = [event(1.0, 1.0), event(0.5, 1.0)];
    assert_eq!(refused_events(&backwards, &scene), Quantity::ImpactTime);
}

#[test]
fn recordings_that_would_fill_the_memory_are_refused() {
    let last = |time_s| refused_events(&[event(time_s, 1.0)], &Scene::default());
    assert_eq!(last(4000.0), Quantity::Samples);
    assert_eq!(last(f64::MAX), Quantity::Samples);
    let error = render(&[event(4000.0, 1.0)], &Scene::default(), 1).unwrap_err();
    assert!(error.to_string().contains("at most 172800000"), "{error}");
}

#[test]
fn a_voice_that_no_sample_catches_is_refused() {
    let with = |mode| {
        let mut scene = bare();
        scene.voice.modes = vec![mode];
        refused(&scene)
    };
    assert_eq!(with(Mode::new(30e3, 0.01, 1.0)), Quantity::SampleRate);
    assert_eq!(with(Mode::new(1e3, 1e-12, 1.0)), Quantity::LoudestImpact);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    /// Whatever a scene asks for, there is a clear refusal or a sound recording.
    #[test]
    fn any_scene_is_refused_or_gives_finite_samples_and_ordered_truth(
        sample_rate_hz in prop_oneof![4_000_u32..=192_000, 0..4_000_u32],
        name in prop::sample::select(&Voice::NAMES[..]),
        decay_s in prop_oneof![Just(0.01), 1e-9..1.0],
        speeds in prop::collection::vec(prop_oneof![0.1..5.0, 1e-12..1e12], 0..8),
        (peak, level_scatter) in (1e-6..100.0, 0.0..1.0),
        (snr_db, hum_hz, rt60_s) in (-60.0..200.0, 1.0..3_000.0, 0.01..2.0),
        rate_per_s in 0.01..1000.0,
        chance in 0.0..1.0,
        bit_depth in prop::sample::select(vec![BitDepth::Eight, BitDepth::Float]),
        seed: u64,
    ) {
        let events: Vec<_> = (0..).map(|n| 0.05 * f64::from(n)).zip(speeds)
            .map(|(time_s, speed_m_s)| event(time_s, speed_m_s))
            .collect();
        let mut voice = Voice::named(name).expect("the name is in the list");
        voice.modes[0].decay_s = decay_s;
        let scene = Scene {
            sample_rate_hz,
            voice,
            peak,
            level_scatter,
            noise: Some(Noise::white(snr_db)),
            hum: Some(Hum { frequency_hz: hum_hz, harmonics: 3, level_db: -20.0 }),
            reverb: Some(Reverb { rt60_s, direct_to_reverberant_db: 3.0 }),
            clicks: Some(Clicks { rate_per_s, level_db: 0.0 }),
            lost: Lost::Chance(chance),
            bit_depth,
            ..Scene::default()
        };
        if let Ok(recording) = render(&events, &scene, seed) {
            prop_assert!(recording.samples.iter().all(|x| x.is_finite()));
            prop_assert!(recording.impacts.iter().all(|impact| !impact.snr_db.is_nan()));
            prop_assert_eq!(recording.impacts.len(), events.len());
            prop_assert!(recording.clicks_s.is_sorted());
        }
    }
}
