//! What was stated of the fall, and the first impact, held against the sound.

use bouncelab::analysis::{Options, analyze, analyze_impacts, analyze_times, impacts_of_times};
use bouncelab::demo;
use bouncelab::diagnostic::{Code, Diagnostic};
use bouncelab::drop::{self, Start, Stop};
use bouncelab::impact::ImpactEvent;
use bouncelab::inference::{Measured, Posterior};
use bouncelab::restitution::{Contact, Restitution};
use bouncelab::synth::{self, Noise, Rendered, Scene};

/// The ball of the demonstration.
fn options() -> Options {
    let mut options = demo::settings().resolve().unwrap().options;
    options.flights = None;
    options
}

fn stated(height_m: f64) -> Options {
    let mut options = options();
    options.priors.drop_height_m = Some(Measured {
        value: height_m,
        sd: 0.002,
    });
    options
}

/// The impacts of a drop from a height on a slightly uneven surface, which shifts them by some 0.1 ms; times from the release
/// on.
fn impacts(height_m: f64) -> Vec<ImpactEvent> {
    let options = options();
    let law = Restitution::constant(0.93).unwrap();
    let contact = Contact::new(law, options.contact_time_s).unwrap();
    let (start, stop) = (Start::Height(height_m), Stop::below(5e-4));
    let history = drop::simulate(&options.model().unwrap(), &contact, start, stop).unwrap();
    let shifted = (0_u32..).zip(history.impact_events());
    let shifted = shifted.map(|(number, impact)| ImpactEvent {
        time_s: impact.time_s + 1e-4 * (1.7 * f64::from(number).powi(2)).sin(),
        ..impact
    });
    shifted.collect()
}

/// Times of the impacts of a drop from 40 cm, and of a sound this long before them.
fn times_after_another(before_s: f64) -> Vec<f64> {
    let drop = impacts(0.40).into_iter().take(20);
    let times_s: Vec<f64> = drop.map(|impact| impact.time_s).collect();
    let other_s = times_s[0] - before_s;
    [other_s].into_iter().chain(times_s).collect()
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

/// The first impact detected would be the second of a drop from 70 cm, but nothing sounds where the first would be.
#[test]
fn a_height_that_needs_undetected_impacts_is_contradicted() {
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
fn a_release_that_needs_undetected_impacts_is_contradicted() {
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
    let rest = &sound.samples[later as usize..];
    let found = posterior(rest, sound.sample_rate_hz, &stated(0.70));
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

/// A sound where the first impact of a slightly odd drop might be: both are possible, and the interval contains both.
#[test]
fn a_first_flight_that_fits_badly_is_doubted() {
    for before_s in [0.52, 0.60, 0.68] {
        let result = analyze_times(&times_after_another(before_s), &options());
        let found = result.drops[0].posterior.as_ref().unwrap();
        let doubt = named(found, Code::FirstImpactDoubtful).unwrap();
        let probability = found.first_is_other_sound;
        assert!(
            (0.3..0.99).contains(&probability),
            "{before_s}: {probability}"
        );
        assert_eq!(doubt.number("probability"), Some(probability));
        let without_m = doubt.number("height_m").unwrap();
        assert!((without_m - 0.40).abs() < 0.02, "{before_s}: {without_m}");
        let [low, high] = found.drop_height_m.interval95;
        assert!(low < 0.40 && 0.40 < high, "{before_s}: {low} {high}");
    }
}

/// A sound where no first impact could be is left out, with the flight from it.
#[test]
fn a_first_flight_that_cannot_be_is_left_out() {
    let result = analyze_times(&times_after_another(0.9), &options());
    let drop = &result.drops[0];
    let found = drop.posterior.as_ref().unwrap();
    assert!(found.first_is_other_sound > 0.99);
    assert!(named(found, Code::FirstImpactDoubtful).is_some());
    let height = found.drop_height_m;
    assert!((height.value - 0.40).abs() < 3.0 * height.sd, "{height:?}");
    assert!(height.sd < 0.02, "{height:?}");
    let first = drop.impacts[1].number;
    assert_eq!(found.first_impact(), first);
    assert!(found.impact(drop.impacts[0].number).is_none());
    assert!(found.impact(first).unwrap().restitution.is_some());
    let in_fit = drop.flights.iter().filter(|flight| flight.in_fit);
    assert!(in_fit.map(|flight| flight.number).min() >= Some(first));
}

#[test]
fn a_first_flight_that_fits_is_not_doubted() {
    let times_s = times_after_another(0.6);
    let result = analyze_times(&times_s[1..], &options());
    let found = result.drops[0].posterior.as_ref().unwrap();
    assert!(found.first_is_other_sound < 1e-3);
    assert!(named(found, Code::FirstImpactDoubtful).is_none());
    // Nor is another where the reader knows.
    let mut options = options();
    options.priors.first_was_detected = true;
    let result = analyze_times(&times_s, &options);
    let found = result.drops[0].posterior.as_ref().unwrap();
    assert!(named(found, Code::FirstImpactDoubtful).is_none());
}

/// Whether a flight that fits is doubted depends on how unlike the others its first impact sounds.
#[test]
fn a_first_impact_that_sounds_unlike_the_others_is_doubted_sooner() {
    let is_doubted = |before_s: f64, ln_alike: f64| {
        let mut impacts = impacts_of_times(&times_after_another(before_s));
        impacts[0].ln_alike = Some(ln_alike);
        let found = analyze_impacts(impacts, &options()).posterior.unwrap();
        named(&found, Code::FirstImpactDoubtful).is_some()
    };
    // By a per cent or so.
    let off_s = [0.578, 0.580, 0.582, 0.584, 0.586, 0.588];
    let doubted = |ln_alike: f64| off_s.map(|before_s| is_doubted(before_s, ln_alike));
    let count = |doubted: [bool; 6]| doubted.into_iter().filter(|it| *it).count();
    let [alike, unlike] = [2.9, -4.0].map(|ln_alike| count(doubted(ln_alike)));
    assert!(alike < unlike, "{alike} {unlike}");
}

/// The recording of a drop from 40 cm whose first impact comes 1.59 s after its beginning, and a sound after 1 s.
fn recorded_after(other: Option<ImpactEvent>) -> Rendered {
    let drop = impacts(0.40);
    let after = drop.iter().map(|impact| ImpactEvent {
        time_s: impact.time_s - drop[0].time_s + 0.59,
        ..*impact
    });
    let all: Vec<ImpactEvent> = other.into_iter().chain(after).collect();
    recorded(&all, 1.0)
}

/// The last impact of an earlier drop comes where the first of this one might be, and sounds like it.
#[test]
fn the_last_impact_of_an_earlier_drop_is_doubted() {
    let sound = recorded_after(Some(ImpactEvent {
        time_s: 0.0,
        speed_m_s: 2.0,
    }));
    let found = posterior(&sound.samples, sound.sample_rate_hz, &options());
    assert_eq!(
        found.impacts.first().map(|impact| impact.number),
        Some(found.first_impact())
    );
    assert!(named(&found, Code::FirstImpactDoubtful).is_some());
    assert!(found.first_is_other_sound > 0.3);
    let [low, high] = found.drop_height_m.interval95;
    assert!(low < 0.40 && 0.40 < high, "{low} {high}");
}

/// A click at the time at which the ball would have bounced before, but with another sound than the impacts, is not taken
/// for an impact.
#[test]
fn a_click_before_the_drop_does_not_change_its_height() {
    let mut sound = recorded_after(None);
    let rate_hz = f64::from(sound.sample_rate_hz);
    for (number, sample) in (0_u32..2000).zip(&mut sound.samples[rate_hz as usize..]) {
        let time_s = f64::from(number) / rate_hz;
        let wave = (std::f64::consts::TAU * 700.0 * time_s).sin();
        *sample += (0.5 * (-time_s / 0.004).exp() * wave) as f32;
    }
    let found = posterior(&sound.samples, sound.sample_rate_hz, &options());
    let height = found.drop_height_m;
    assert!((height.value - 0.40).abs() < 3.0 * height.sd, "{height:?}");
    assert!(height.sd < 0.02, "{height:?}");
}
