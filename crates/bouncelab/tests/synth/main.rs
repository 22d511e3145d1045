//! A rendered recording is what its scene says, and its truth is true.

#![expect(
    clippy::float_cmp,
    reason = "silence, clipping levels and quantiser levels are exact numbers"
)]

mod refusals;

use std::f64::consts::{FRAC_PI_2, TAU};

use bouncelab::impact::ImpactEvent;
use bouncelab::synth::{
    BitDepth, Clicks, Colour, Hum, Lost, Mode, Noise, Rendered, Reverb, Scene, Voice, render,
};
use rustfft::FftPlanner;
use rustfft::num_complex::Complex32;

/// Four impacts at times that lie on no sample of any usual rate.
const EVENTS: [ImpactEvent; 4] = [
    event(0.012_345_678, 2.4),
    event(0.472_135_955, 2.2),
    event(0.899_331_245, 2.0),
    event(1.297_012_345, 1.9),
];

const fn event(time_s: f64, speed_m_s: f64) -> ImpactEvent {
    ImpactEvent { time_s, speed_m_s }
}

/// Nothing but the impacts, without chance and without rounding.
fn bare() -> Scene {
    Scene {
        level_scatter: 0.0,
        phase_scatter_rad: 0.0,
        noise: None,
        bit_depth: BitDepth::Float,
        ..Scene::default()
    }
}

fn rendered(scene: &Scene) -> Rendered {
    render(&EVENTS, scene, 7).expect("the scene is valid")
}

fn rms(samples: &[f32]) -> f64 {
    let energy: f64 = samples.iter().map(|&x| f64::from(x).powi(2)).sum();
    (energy / samples.len() as f64).sqrt()
}

fn db(ratio: f64) -> f64 {
    20.0 * ratio.log10()
}

/// The samples of the first 5 ms from a time on.
fn first_5_ms(recording: &Rendered, time_s: f64) -> &[f32] {
    let rate = f64::from(recording.sample_rate_hz);
    let first = (time_s * rate).ceil() as usize;
    &recording.samples[first..first + (0.005 * rate).round() as usize]
}

/// `a - b`: what `a` has that `b` lacks.
fn difference(a: &Rendered, b: &Rendered) -> Vec<f32> {
    assert_eq!(a.samples.len(), b.samples.len());
    std::iter::zip(&a.samples, &b.samples)
        .map(|(a, b)| a - b)
        .collect()
}

#[test]
fn the_same_seed_gives_the_same_samples_and_another_seed_others() {
    let scene = Scene {
        hum: Some(Hum {
            frequency_hz: 50.0,
            harmonics: 3,
            level_db: -30.0,
        }),
        reverb: Some(Reverb {
            rt60_s: 0.3,
            direct_to_reverberant_db: 10.0,
        }),
        clicks: Some(Clicks {
            rate_per_s: 5.0,
            level_db: -10.0,
        }),
        lost: Lost::Chance(0.3),
        ..Scene::default()
    };
    let first = render(&EVENTS, &scene, 1).unwrap();
    assert_eq!(first, render(&EVENTS, &scene, 1).unwrap());
    let other = render(&EVENTS, &scene, 2).unwrap();
    assert_ne!(first.samples, other.samples);
    assert_ne!(first.clicks_s, other.clicks_s);
}

#[test]
fn the_measured_snr_is_the_stated_one() {
    for colour in [Colour::White, Colour::Pink] {
        for snr_db in [0.0, 20.0, 40.0, 60.0] {
            let noise = Some(Noise { colour, snr_db });
            let clean = rendered(&bare());
            let noisy = rendered(&Scene { noise, ..bare() });
            let background = rms(&difference(&noisy, &clean));
            let loudest = noisy
                .impacts
                .iter()
                .map(|impact| rms(first_5_ms(&clean, impact.time_s)))
                .fold(0.0, f64::max);
            let measured = db(loudest / background);
            assert!(
                (measured - snr_db).abs() < 0.05,
                "{colour:?}: {measured} dB, stated {snr_db}"
            );
        }
    }
}

/// With scatter each impact has its own level, which its own SNR must follow.
#[test]
fn each_impact_carries_its_own_snr() {
    let scattered = Scene {
        level_scatter: 0.5,
        phase_scatter_rad: 0.5,
        ..bare()
    };
    let clean = rendered(&scattered);
    let noisy = rendered(&Scene {
        noise: Some(Noise::white(30.0)),
        ..scattered
    });
    let background = rms(&difference(&noisy, &clean));
    for impact in &noisy.impacts {
        let measured = db(rms(first_5_ms(&clean, impact.time_s)) / background);
        assert!(
            (measured - impact.snr_db).abs() < 0.05,
            "{impact:?}: {measured} dB"
        );
    }
    let loudest = noisy
        .impacts
        .iter()
        .map(|i| i.snr_db)
        .fold(f64::MIN, f64::max);
    assert!((loudest - 30.0).abs() < 1e-9);
    assert!(clean.impacts.iter().all(|i| i.snr_db == f64::INFINITY));
}

/// A single sine of known frequency and decay tells its onset by its phase: a fit to the samples
/// after the rise must return the true time, at any rate, far below a sample.
#[test]
fn the_true_times_are_those_of_the_sound() {
    let mode = Mode::new(900.0, 0.02, 1.0);
    for sample_rate_hz in [4_000, 8_000, 44_100, 96_000, 192_000] {
        let recording = rendered(&Scene {
            sample_rate_hz,
            voice: Voice {
                modes: vec![mode],
                ..Voice::table_tennis()
            },
            ..bare()
        });
        for (impact, event) in recording.impacts.iter().zip(EVENTS) {
            assert!((impact.time_s - 0.5 - event.time_s).abs() < 1e-15);
            let error_s = onset_error(&recording, impact.time_s, mode);
            assert!(error_s.abs() < 1e-9, "{sample_rate_hz} Hz: {error_s} s");
        }
    }
}

/// By how much the fitted onset of a single-mode impact is later than `time_s`.
fn onset_error(recording: &Rendered, time_s: f64, mode: Mode) -> f64 {
    let rate = f64::from(recording.sample_rate_hz);
    let first = ((time_s + 0.002) * rate).ceil() as usize;
    // Least squares on p sin + q cos of the undamped samples.
    let [mut ss, mut sc, mut cc, mut sx, mut cx] = [0.0; 5];
    for n in first..first + (0.02 * rate) as usize {
        let t = n as f64 / rate - time_s;
        let x = f64::from(recording.samples[n]) * (t / mode.decay_s).exp();
        let (s, c) = (TAU * mode.frequency_hz * t).sin_cos();
        (ss, sc, cc) = (ss + s * s, sc + s * c, cc + c * c);
        (sx, cx) = (sx + s * x, cx + c * x);
    }
    let determinant = ss * cc - sc * sc;
    let p = (sx * cc - cx * sc) / determinant;
    let q = (cx * ss - sx * sc) / determinant;
    -q.atan2(p) / (TAU * mode.frequency_hz)
}

#[test]
fn nothing_sounds_before_the_onset_and_the_sound_rises_smoothly() {
    let scene = Scene {
        voice: Voice {
            modes: vec![Mode::new(50.0, 1.0, 1.0)],
            contact_time_s: 2e-3,
            attack: 0.5,
            level_exponent: 1.0,
        },
        sample_rate_hz: 96_000,
        phase_scatter_rad: 0.0,
        ..bare()
    };
    let recording = render(&EVENTS[..1], &scene, 7).unwrap();
    let time_s = recording.impacts[0].time_s;
    let (mut before, mut ratios) = (0.0_f32, Vec::new());
    for (n, &x) in recording.samples.iter().enumerate() {
        let t = n as f64 / 96e3 - time_s;
        if t < 0.0 {
            before = before.max(x.abs());
        } else if t < 1e-3 {
            // The rise takes half of 2 ms; what it multiplies is an (almost) undamped sine.
            let rise = (FRAC_PI_2 * t / 1e-3).sin().powi(2);
            ratios.push(f64::from(x) / (rise * (TAU * 50.0 * t).sin() * (-t).exp()));
        }
    }
    assert_eq!(before, 0.0);
    let (low, high) = ratios.iter().fold((f64::MAX, f64::MIN), |(low, high), &r| {
        (low.min(r), high.max(r))
    });
    assert!(high / low - 1.0 < 1e-4, "{low} to {high}");
}

#[test]
fn level_follows_speed_to_the_stated_power() {
    for level_exponent in [0.0, 1.0, 1.2, 2.0] {
        let recording = rendered(&Scene {
            voice: Voice {
                level_exponent,
                ..Voice::default()
            },
            sample_rate_hz: 192_000,
            ..bare()
        });
        let level = |n: usize| rms(first_5_ms(&recording, recording.impacts[n].time_s));
        let expected = (EVENTS[3].speed_m_s / EVENTS[0].speed_m_s).powf(level_exponent);
        assert!((level(3) / level(0) / expected - 1.0).abs() < 1e-3);
    }
}

#[test]
fn the_loudest_impact_peaks_where_the_scene_says() {
    for peak in [0.01, 0.5, 3.0] {
        let recording = rendered(&Scene { peak, ..bare() });
        let measured = recording
            .samples
            .iter()
            .fold(0.0, |p: f32, x| x.abs().max(p));
        assert!((f64::from(measured) / peak - 1.0).abs() < 1e-6);
    }
}

#[test]
fn hum_has_the_stated_level_and_frequencies() {
    let hum = Hum {
        frequency_hz: 50.0,
        harmonics: 3,
        level_db: -20.0,
    };
    let clean = rendered(&bare());
    let humming = rendered(&Scene {
        hum: Some(hum),
        tail_s: 1.0,
        ..bare()
    });
    let loudest = rms(first_5_ms(&clean, clean.impacts[0].time_s));
    // The last half second of the tail holds 25 whole periods and no impact.
    let alone = &humming.samples[humming.samples.len() - 22_050..];
    assert!((db(rms(alone) / loudest) + 20.0).abs() < 0.01);
    let amplitude = |frequency_hz: f64| {
        let [mut re, mut im] = [0.0; 2];
        for (n, &x) in alone.iter().enumerate() {
            let (s, c) = (TAU * frequency_hz * n as f64 / 44_100.0).sin_cos();
            (re, im) = (re + f64::from(x) * c, im + f64::from(x) * s);
        }
        re.hypot(im)
    };
    let fundamental = amplitude(50.0);
    assert!((amplitude(100.0) / fundamental - 0.5).abs() < 1e-3);
    assert!((amplitude(150.0) / fundamental - 1.0 / 3.0).abs() < 1e-3);
    assert!(amplitude(200.0) / fundamental < 1e-3);
}

/// Pink noise has the same power in every octave, white noise 3 dB more in each.
#[test]
fn noise_has_its_colour() {
    for (colour, expected_db_per_octave) in [(Colour::White, 3.01), (Colour::Pink, 0.0)] {
        let scene = Scene {
            noise: Some(Noise {
                colour,
                snr_db: 0.0,
            }),
            tail_s: 20.0,
            ..bare()
        };
        let samples = render(&[], &scene, 3).unwrap().samples;
        let mut spectrum: Vec<Complex32> = samples.iter().map(Complex32::from).collect();
        let length = spectrum.len() as f64;
        FftPlanner::new()
            .plan_fft_forward(spectrum.len())
            .process(&mut spectrum);
        let power_from = |hz: f64| -> f64 {
            let bin = |hz: f64| (hz / 44_100.0 * length) as usize;
            let octave = &spectrum[bin(hz)..bin(2.0 * hz)];
            octave.iter().map(|x| f64::from(x.norm_sqr())).sum()
        };
        let octaves_db = 10.0 * (power_from(6400.0) / power_from(100.0)).log10();
        let slope = octaves_db / 6.0;
        assert!(
            (slope - expected_db_per_octave).abs() < 0.15,
            "{colour:?}: {slope} dB for each octave"
        );
    }
}

#[test]
fn lost_impacts_are_absent_and_the_others_are_there() {
    let recording = rendered(&Scene {
        lost: Lost::At(vec![1, 3]),
        ..bare()
    });
    let lost: Vec<bool> = recording.impacts.iter().map(|i| i.lost).collect();
    assert_eq!(lost, [false, true, false, true]);
    for impact in &recording.impacts {
        let silent = rms(first_5_ms(&recording, impact.time_s)) == 0.0;
        assert_eq!(silent, impact.lost, "{impact:?}");
    }
}

#[test]
fn impacts_are_lost_as_often_as_stated() {
    let events: Vec<_> = (0..1000).map(|n| event(0.01 * f64::from(n), 1.0)).collect();
    let share = |chance| {
        let scene = Scene {
            lost: Lost::Chance(chance),
            ..bare()
        };
        let recording = render(&events, &scene, 5).unwrap();
        recording.impacts.iter().filter(|i| i.lost).count() as f64 / 1000.0
    };
    assert_eq!(share(0.0), 0.0);
    assert_eq!(share(1.0), 1.0);
    // Four standard deviations of a binomial.
    assert!((share(0.2) - 0.2).abs() < 0.05);
}

#[test]
fn clicks_have_the_stated_rate_level_and_times() {
    let clicks = Clicks {
        rate_per_s: 4.0,
        level_db: -6.0,
    };
    let scene = Scene {
        clicks: Some(clicks),
        tail_s: 100.0,
        ..bare()
    };
    let clicking = rendered(&scene);
    let clean = rendered(&Scene {
        clicks: None,
        ..scene
    });
    // 102 s at 4 a second; four standard deviations of a Poisson count.
    assert!((clicking.clicks_s.len() as f64 - 408.0).abs() < 81.0);
    let loudest = rms(first_5_ms(&clean, clean.impacts[0].time_s));
    let added = Rendered {
        samples: difference(&clicking, &clean),
        ..clicking.clone()
    };
    let alone = clicking
        .clicks_s
        .windows(3)
        .filter(|t| t[1] - t[0] > 0.03 && t[2] - t[1] > 0.03);
    let mut tried = 0;
    for times in alone {
        let level_db = db(rms(first_5_ms(&added, times[1])) / loudest);
        assert!(
            (level_db + 6.0).abs() < 0.05,
            "{level_db} dB at {} s",
            times[1]
        );
        tried += 1;
    }
    assert!(tried > 100);
}

#[test]
fn the_tail_has_the_stated_energy_and_decay() {
    let reverb = Reverb {
        rt60_s: 0.8,
        direct_to_reverberant_db: 6.0,
    };
    let scene = Scene {
        tail_s: 1.5,
        ..bare()
    };
    let dry = render(&EVENTS[..1], &scene, 7).unwrap();
    let wet = render(
        &EVENTS[..1],
        &Scene {
            reverb: Some(reverb),
            ..scene
        },
        7,
    )
    .unwrap();
    let tail = difference(&wet, &dry);
    let energy = |samples: &[f32]| samples.iter().map(|&x| f64::from(x).powi(2)).sum::<f64>();
    // The tail is a random filter: its energy at the few frequencies of a voice scatters.
    let ratio_db = 10.0 * (energy(&dry.samples) / energy(&tail)).log10();
    assert!((ratio_db - 6.0).abs() < 2.0, "{ratio_db} dB");
    // Two stretches of 0.2 s, 0.4 s apart: half of 60 dB.
    let from = |t: f64| (((0.5 + EVENTS[0].time_s + t) * 44_100.0) as usize).min(tail.len());
    let fall_db =
        10.0 * (energy(&tail[from(0.1)..from(0.3)]) / energy(&tail[from(0.5)..from(0.7)])).log10();
    assert!((fall_db - 30.0).abs() < 2.0, "{fall_db} dB");
}

#[test]
fn clipping_holds_at_the_stated_level() {
    let recording = rendered(&Scene {
        peak: 0.9,
        clip_at: Some(0.25),
        ..bare()
    });
    let highest = recording
        .samples
        .iter()
        .fold(0.0, |p: f32, x| x.abs().max(p));
    assert_eq!(highest, 0.25);
    let clipped = recording.samples.iter().filter(|x| x.abs() == 0.25).count();
    assert!(clipped > 10);
}

#[test]
fn an_integer_recorder_clips_at_full_scale_and_a_float_one_does_not() {
    let hot = |bit_depth| {
        rendered(&Scene {
            peak: 2.0,
            bit_depth,
            ..bare()
        })
    };
    let range = |samples: &[f32]| {
        samples.iter().fold((0.0_f32, 0.0_f32), |(low, high), &x| {
            (low.min(x), high.max(x))
        })
    };
    let (low, high) = range(&hot(BitDepth::Sixteen).samples);
    assert!(low >= -1.0 && high == 1.0 - 1.0 / 32_768.0);
    let (low, high) = range(&hot(BitDepth::Float).samples);
    assert!(high.max(-low) > 1.9);
}

#[test]
fn samples_lie_on_the_levels_of_their_bit_depth() {
    for (bit_depth, bits) in [
        (BitDepth::Eight, 8),
        (BitDepth::Sixteen, 16),
        (BitDepth::TwentyFour, 24),
    ] {
        assert_eq!(bit_depth.bits(), Some(bits));
        let recording = rendered(&Scene {
            bit_depth,
            noise: Some(Noise::white(20.0)),
            ..bare()
        });
        let half = f64::from(1_u32 << (bits - 1));
        assert!(
            recording
                .samples
                .iter()
                .all(|&x| (f64::from(x) * half).fract() == 0.0),
            "{bit_depth:?}"
        );
    }
    assert_eq!(BitDepth::Float.bits(), None);
}

#[test]
fn the_offset_is_there() {
    let recording = rendered(&Scene {
        dc_offset: -0.125,
        ..bare()
    });
    assert_eq!(recording.samples[0], -0.125);
}

#[test]
fn adding_one_disturbance_leaves_the_others_as_they_were() {
    let noise_alone = rendered(&Scene {
        noise: Some(Noise::white(20.0)),
        ..bare()
    });
    let both = rendered(&Scene {
        noise: Some(Noise::white(20.0)),
        hum: Some(Hum {
            frequency_hz: 60.0,
            harmonics: 1,
            level_db: -40.0,
        }),
        ..bare()
    });
    let clean = rendered(&bare());
    let loudest = rms(first_5_ms(&clean, clean.impacts[0].time_s));
    let hum_db = db(rms(&difference(&both, &noise_alone)) / loudest);
    assert!((hum_db + 40.0).abs() < 0.1, "{hum_db} dB");
}

#[test]
fn every_voice_sounds_at_every_rate_and_nothing_is_nan() {
    for name in Voice::NAMES {
        let voice = Voice::named(name).expect("the name is in the list");
        for sample_rate_hz in [
            4_000, 8_000, 11_025, 22_050, 44_100, 48_000, 96_000, 192_000,
        ] {
            let scene = Scene {
                sample_rate_hz,
                voice: voice.clone(),
                noise: Some(Noise::pink(30.0)),
                hum: Some(Hum {
                    frequency_hz: 60.0,
                    harmonics: 50,
                    level_db: -30.0,
                }),
                reverb: Some(Reverb {
                    rt60_s: 0.2,
                    direct_to_reverberant_db: 12.0,
                }),
                clicks: Some(Clicks {
                    rate_per_s: 10.0,
                    level_db: -10.0,
                }),
                ..Scene::default()
            };
            let recording = rendered(&scene);
            let expected = (0.5 + EVENTS[3].time_s + 0.5) * f64::from(sample_rate_hz);
            assert_eq!(recording.samples.len(), expected.ceil() as usize);
            assert!(recording.samples.iter().all(|x| x.is_finite()));
            assert!(rms(&recording.samples) > 1e-4);
        }
    }
    assert_eq!(Voice::named("cannon"), None);
}

#[test]
fn without_impacts_the_sound_is_the_background() {
    let empty = render(&[], &bare(), 1).unwrap();
    assert!(empty.impacts.is_empty());
    assert_eq!(empty.samples, vec![0.0; 44_100]);
    let noisy = Scene {
        noise: Some(Noise::white(20.0)),
        ..bare()
    };
    assert!(rms(&render(&[], &noisy, 1).unwrap().samples) > 1e-3);
}

#[test]
fn an_impact_too_faint_to_render_has_no_level_and_is_not_nan() {
    let events = [event(0.0, 1.0), event(0.1, 1e-9)];
    let recording = render(&events, &bare(), 1).unwrap();
    assert_eq!(recording.impacts[1].snr_db, f64::INFINITY);
    let noise = Some(Noise::white(20.0));
    let recording = render(&events, &Scene { noise, ..bare() }, 1).unwrap();
    assert_eq!(recording.impacts[1].snr_db, f64::NEG_INFINITY);
}
