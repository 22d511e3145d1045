//! The sound in every fixture: five decaying clicks at times that fall between samples.

#![allow(dead_code, unreachable_pub)] // Each user takes what it needs.

use std::f64::consts::TAU;

/// When the clicks start, in seconds.
pub const TIMES_S: [f64; 5] = [0.080_33, 0.230_41, 0.350_07, 0.445_72, 0.522_19];

/// How long the sound lasts, in seconds.
pub const DURATION_S: f64 = 0.6;

/// The peak of the first click, nearly.
const LEVEL: f64 = 0.6;

/// Low enough to survive 4 kHz sampling.
const PITCH_HZ: f64 = 1_500.0;

const DECAY_S: f64 = 0.004;

/// One click of unit level, `time_s` after its start.
pub fn click(time_s: f64) -> f64 {
    if time_s < 0.0 {
        0.0
    } else {
        (-time_s / DECAY_S).exp() * (TAU * PITCH_HZ * time_s).sin()
    }
}

/// The sound, sampled.
pub fn signal(sample_rate_hz: u32) -> Vec<f32> {
    let rate = f64::from(sample_rate_hz);
    let level = |number: usize| LEVEL * 0.9_f64.powf(number as f64);
    (0..(DURATION_S * rate) as usize)
        .map(|frame| {
            let clicks = TIMES_S.iter().enumerate();
            let sum: f64 = clicks
                .map(|(n, start)| level(n) * click(frame as f64 / rate - start))
                .sum();
            sum as f32
        })
        .collect()
}
