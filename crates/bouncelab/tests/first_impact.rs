//! What was stated of the fall, and the first impact, held against the sound.

use bouncelab::analysis::{Options, analyze};
use bouncelab::demo;
use bouncelab::diagnostic::{Code, Diagnostic};
use bouncelab::drop::{self, Start, Stop};
use bouncelab::impact::ImpactEvent;
use bouncelab::inference::{Measured, Posterior, SamplerConfig};
use bouncelab::restitution::{Contact, Restitution};
use bouncelab::synth::{self, Noise, Rendered, Scene};

/// The ball of the demonstration, and few draws.
fn options() -> Options {
    let options = demo::settings().resolve().unwrap().options;
    options.with_sampler(SamplerConfig {
        draws: 300,
        seed: 1,
    })
}

fn stated(height_m: f64) -> Options {
    let mut options = options();
    options.priors.drop_height_m = Some(Measured {
        value: height_m,
        sd: 0.002,
    });
    options
}

/// The impacts of a drop from a height; times from the release on.
fn impacts(height_m: f64) -> Vec<ImpactEvent> {
    let options = options();
    let law = Restitution::constant(0.93).unwrap();
    let contact = Contact::new(law, options.contact_time_s).unwrap();
    let (start, stop) = (Start::Height(height_m), Stop::below(5e-4));
    let history = drop::simulate(&options.model().unwrap(), &contact, start, stop).unwrap();
    history.impact_events().collect()
}

/// They begin this long after the beginning of the recording, less the fall.
fn recorded(impacts: &[ImpactEvent], lead_in_s: f64) -> Rendered {
    let scene = Scene {
        noise: Some(Noise::pink(40.0)),
        lead_in_s,
        ..Scene::default()
    };
    synth::render(impacts, &scene, 1).unwrap()
}

fn posterior(samples: &[f32], sample_rate_hz: u32, options: &Options) -> Posterior {
    let recording = analyze(samples, sample_rate_hz, options).unwrap();
    recording.drops[0].posterior.clone().unwrap()
}

fn named(found: &Posterior, code: Code) -> Option<&Diagnostic> {
    found.diagnostics.iter().find(|it| it.code == code)
}

/// The first impact heard would be the second of a drop from 70 cm, but nothing is heard where the first would be.
#[test]
fn a_height_that_needs_unheard_impacts_is_contradicted() {
    let sound = recorded(&impacts(0.47), 2.2);
    let found = posterior(&sound.samples, sound.sample_rate_hz, &stated(0.70));
    let height = found.drop_height_m;
    assert!((height.value - 0.47).abs() < 3.0 * height.sd, "{height:?}");
    assert!(height.sd < 0.03, "{height:?}");
    assert_eq!(found.missed_first_impacts, None);
    let contradiction = named(&found, Code::HeightContradictsTimes).unwrap();
    assert_eq!(contradiction.number("measured_m"), Some(0.70));
    let detected_m = contradiction.number("detected_m").unwrap();
    assert!((detected_m - 0.47).abs() < 3.0 * height.sd, "{detected_m}");
}

/// So is a release too long before the first impact.
#[test]
fn a_release_that_needs_unheard_impacts_is_contradicted() {
    let sound = recorded(&impacts(0.47), 2.2);
    let first_s = sound.impacts[0].time_s;
    let mut options = options();
    let release = |before_s: f64| {
        Some(Measured {
            value: first_s - before_s,
            sd: 0.005,
        })
    };
    // The fall from 70 cm, and the flight after it.
    options.priors.release_s = release(1.06);
    let found = posterior(&sound.samples, sound.sample_rate_hz, &options);
    let contradiction = named(&found, Code::ReleaseContradictsTimes).unwrap();
    let detected_s = contradiction.number("detected_s").unwrap();
    assert!((detected_s - 0.31).abs() < 0.01, "{detected_s}");
    let height = found.drop_height_m;
    assert!((height.value - 0.47).abs() < 3.0 * height.sd, "{height:?}");
    // The true one agrees.
    options.priors.release_s = release(0.3105);
    let found = posterior(&sound.samples, sound.sample_rate_hz, &options);
    assert!(named(&found, Code::ReleaseContradictsTimes).is_none());
}

/// Where the recording began later, or another sound may be the impact, it may have been missed.
#[test]
fn a_height_that_needs_impacts_before_the_recording_is_believed() {
    let sound = recorded(&impacts(0.70), 0.2);
    let later = (sound.impacts[0].time_s + 0.1) * f64::from(sound.sample_rate_hz);
    let heard = &sound.samples[later as usize..];
    let found = posterior(heard, sound.sample_rate_hz, &stated(0.70));
    assert!(found.missed_first_impacts.as_ref().unwrap()[1] > 0.9);
    assert!(named(&found, Code::HeightContradictsTimes).is_none());
    assert!(named(&found, Code::FirstImpactsMissed).is_some());
}

#[test]
fn a_height_that_needs_an_impact_where_it_was_loud_is_believed() {
    let drop = impacts(0.70);
    let sound = recorded(&drop[1..], 0.0);
    let mut samples = sound.samples;
    // A machine, which is switched off after the impact that is drowned in it.
    let off_s = drop[0].time_s + 0.3;
    for (number, sample) in (0_u32..).zip(&mut samples) {
        let time_s = f64::from(number) / f64::from(sound.sample_rate_hz);
        let level = 0.6 * ((off_s - time_s) / 0.2).clamp(0.0, 1.0);
        *sample += (level * (std::f64::consts::TAU * 60.0 * time_s).sin()) as f32;
    }
    let found = posterior(&samples, sound.sample_rate_hz, &stated(0.70));
    assert!(found.missed_first_impacts.as_ref().unwrap()[1] > 0.9);
    assert!(named(&found, Code::HeightContradictsTimes).is_none());
}
