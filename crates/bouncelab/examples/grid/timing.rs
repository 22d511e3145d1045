//! Errors of the times: against the Cramer-Rao bound, against their stated standard errors, and
//! against loudness.

use crate::cells::median;
use crate::drops::{hear, strikes, usual};
use bouncelab::synth::{self, BitDepth, Scene, Voice};
use std::f64::consts::PI;

/// Impacts this far above the noise count, in dB.
const LEAST_SNR_DB: f64 = 10.0;
/// What the bound makes use of: this time of each impact, in seconds.
const USED_S: f64 = 0.008;
/// Median of the size of a normal error, in standard deviations.
const MEDIAN_OF_NORMAL: f64 = 0.6745;

/// One impact that was heard.
struct Timed {
    number: usize,
    error_s: f64,
    sigma_s: f64,
    bound_s: f64,
    level_db: f64,
}

/// The error of a flight time: of a difference, so that a constant offset does not matter.
/// All in seconds.
struct Flight {
    error: f64,
    sigma: f64,
    bound: f64,
}

pub(crate) fn print(drops: u64) {
    println!(
        "\n| ball | noise | flights | median error | over the bound | within one sigma | drift for 10 dB |"
    );
    println!("|---|---|---|---|---|---|---|");
    for voice in Voice::NAMES {
        for snr_db in [20.0, 30.0, 40.0, 50.0] {
            let heard: Vec<Vec<Timed>> = (0..drops).map(|seed| time(voice, snr_db, seed)).collect();
            println!("| {voice} | {snr_db} dB | {}", summary(&heard));
        }
    }
}

/// Impacts of one drop that are all alike, in white noise.
fn time(voice: &str, snr_db: f64, seed: u64) -> Vec<Timed> {
    let scene = Scene {
        voice: Voice::named(voice).unwrap_or_default(),
        phase_scatter_rad: 0.0,
        bit_depth: BitDepth::Float,
        ..usual(snr_db)
    };
    let strikes = strikes(seed, &scene.voice);
    let render = |scene: &Scene| {
        synth::render(&strikes, scene, seed).unwrap_or_else(|error| panic!("{voice}: {error}"))
    };
    let noisy = render(&scene);
    let clean = render(&Scene {
        noise: None,
        ..scene.clone()
    });
    let noise: Vec<f64> = std::iter::zip(&noisy.samples, &clean.samples)
        .map(|(a, b)| f64::from(a - b))
        .collect();
    let noise_rms = (noise.iter().map(|x| x * x).sum::<f64>() / noise.len() as f64).sqrt();
    let rate = f64::from(noisy.sample_rate_hz);
    let heard = hear(&noisy.samples, noisy.sample_rate_hz);
    let Some(train) = heard.found.trains.iter().max_by_key(|t| t.impacts().len()) else {
        return Vec::new();
    };
    let mut timed: Vec<Timed> = Vec::new();
    for (index, truth) in noisy.impacts.iter().enumerate() {
        if truth.snr_db < LEAST_SNR_DB {
            continue;
        }
        let errors = train
            .impacts()
            .iter()
            .map(|i| (i, i.onset.time_s - truth.time_s));
        let nearest = errors.min_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
        let Some((impact, error_s)) = nearest.filter(|(_, e)| e.abs() < 0.004) else {
            continue;
        };
        let next_s = noisy
            .impacts
            .get(index + 1)
            .map_or(f64::INFINITY, |i| i.time_s);
        let first = (truth.time_s * rate) as usize;
        let end = ((truth.time_s + USED_S).min(next_s) * rate) as usize;
        timed.push(Timed {
            number: index,
            error_s,
            sigma_s: impact.onset.sigma_s,
            bound_s: noise_rms / slope(&clean.samples, first, end).sqrt() / rate,
            level_db: truth.snr_db,
        });
    }
    timed
}

/// Sum of the squared derivative of a band-limited signal, per sample.
fn slope(samples: &[f32], first: usize, end: usize) -> f64 {
    const REACH: usize = 40;
    (first..end)
        .map(|n| {
            let derivative: f64 = (1..=REACH)
                .map(|k| {
                    let at = |i: usize| f64::from(samples.get(i).copied().unwrap_or(0.0));
                    let before = n.checked_sub(k).map_or(0.0, at);
                    let window = 0.5 + 0.5 * (PI * k as f64 / (REACH + 1) as f64).cos();
                    let sign = if k % 2 == 1 { 1.0 } else { -1.0 };
                    window * sign * (at(n + k) - before) / k as f64
                })
                .sum();
            derivative * derivative
        })
        .sum()
}

fn summary(heard: &[Vec<Timed>]) -> String {
    let flights: Vec<Flight> = heard.iter().flat_map(|drop| flights(drop)).collect();
    let mut errors: Vec<f64> = flights.iter().map(|t| t.error.abs()).collect();
    let mut over: Vec<f64> = flights.iter().map(|t| t.error.abs() / t.bound).collect();
    let within = flights.iter().filter(|t| t.error.abs() < t.sigma).count();
    let (Some(error_s), Some(over)) = (median(&mut errors), median(&mut over)) else {
        return "0 | - | - | - | - |".into();
    };
    format!(
        "{} | {:.2} us | {:.2} | {:.0} % | {} |",
        flights.len(),
        1e6 * error_s,
        over / MEDIAN_OF_NORMAL,
        100.0 * within as f64 / flights.len() as f64,
        drift(heard)
    )
}

fn flights(drop: &[Timed]) -> impl Iterator<Item = Flight> {
    let pairs = drop.windows(2).filter(|p| p[1].number == p[0].number + 1);
    pairs.map(|pair| Flight {
        error: pair[1].error_s - pair[0].error_s,
        sigma: pair[0].sigma_s.hypot(pair[1].sigma_s),
        bound: pair[0].bound_s.hypot(pair[1].bound_s),
    })
}

/// Microseconds later for each 10 dB louder, and the standard error of that: the mean over the
/// drops of a straight line through the errors, each weighted by its bound.
fn drift(heard: &[Vec<Timed>]) -> String {
    let (mut weights, mut sum) = (0.0, 0.0);
    for drop in heard.iter().filter(|drop| drop.len() > 2) {
        let weighted = |value: fn(&Timed) -> f64| {
            let weight: f64 = drop.iter().map(|t| t.bound_s.powi(-2)).sum();
            drop.iter()
                .map(|t| value(t) * t.bound_s.powi(-2))
                .sum::<f64>()
                / weight
        };
        let (level_db, error_s) = (weighted(|t| t.level_db), weighted(|t| t.error_s));
        for t in drop {
            let weight = t.bound_s.powi(-2) * (t.level_db - level_db);
            weights += weight * (t.level_db - level_db);
            sum += weight * (t.error_s - error_s);
        }
    }
    let scale = 1e6 * 10.0;
    format!(
        "{:+.2} +- {:.2} us",
        scale * sum / weights,
        scale / weights.sqrt()
    )
}
