//! Errors of the times: against the Cramer-Rao bound, against their stated standard errors, and
//! against loudness.

use super::drops::{detect, impact_events, usual};
use super::recorder::record;
use crate::held::median;
use bouncelab::synth::{BitDepth, Scene, Voice};
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// Impacts this far above the noise count, in dB.
const MIN_SNR_DB: f64 = 10.0;
/// What the bound makes use of: this time of each impact, in seconds.
const USED_S: f64 = 0.008;
/// The fixed level that the whole sound is compared with, as a multiple of the noise, which exceeds
/// it once in a while.
const THRESHOLD: f64 = 5.0;
/// Median of the size of a normal error, in standard deviations.
const MEDIAN_OF_NORMAL: f64 = 0.6745;

/// One impact that was detected.
struct Timed {
    number: usize,
    error_s: f64,
    sigma_s: f64,
    bound_s: f64,
    level_db: f64,
    /// When the first sample exceeds a fixed level, in seconds after the truth.
    crossed_s: Option<f64>,
}

/// The error of a flight time: of a difference, so that a constant offset does not matter.
/// All in seconds.
struct Flight {
    error: f64,
    sigma: f64,
    bound: f64,
}

/// By how much impacts differ, as standard deviation of the phase of each of their modes.
const PHASES_RAD: [f64; 3] = [0.02, 0.1, 0.3];
/// The noise under impacts that differ.
const DIFFERING_DB: f64 = 40.0;

/// How far the noise lies below the loudest impact, in dB.
const NOISES_DB: [f64; 4] = [20.0, 30.0, 40.0, 50.0];

pub(crate) fn print(drops: u64) {
    println!(
        "\n| ball | noise | flights | median error | over the bound | within one sigma | drift for 10 dB |"
    );
    println!("|---|---|---|---|---|---|---|");
    let mut quietest = Vec::new();
    for voice in Voice::NAMES {
        for snr_db in NOISES_DB {
            let timed: Vec<Vec<Timed>> = (0..drops)
                .map(|seed| time(voice, snr_db, 0.0, seed))
                .collect();
            println!("| {voice} | {snr_db} dB | {}", summary(&timed));
            if snr_db == NOISES_DB[3] {
                quietest.push((voice, timed));
            }
        }
    }
    println!("\n| ball | level | late | late by a fixed level |");
    println!("|---|---|---|---|");
    for (voice, timed) in quietest {
        print_lateness(voice, &timed);
    }
    println!("\n| ball | phases differ by | median error | within one sigma | beyond three |");
    println!("|---|---|---|---|---|");
    for voice in Voice::NAMES {
        for phase_scatter_rad in PHASES_RAD {
            let timed = (0..drops).map(|seed| time(voice, DIFFERING_DB, phase_scatter_rad, seed));
            let halves = halves(&timed.collect::<Vec<_>>());
            println!("| {voice} | {phase_scatter_rad} rad | {halves} |");
        }
    }
}

/// The impacts of one drop in white noise; without scatter of their phases they are all alike.
fn time(voice: &str, snr_db: f64, phase_scatter_rad: f64, seed: u64) -> Vec<Timed> {
    let scene = Scene {
        voice: Voice::named(voice).unwrap_or_default(),
        phase_scatter_rad,
        bit_depth: BitDepth::Float,
        ..usual(snr_db)
    };
    let recorded = record(&impact_events(seed, &scene.voice), &scene, seed);
    let sound = &recorded.noisy;
    let rate = f64::from(sound.sample_rate_hz);
    let detection = detect(&sound.samples, sound.sample_rate_hz);
    let Some(train) = detection
        .found
        .trains
        .iter()
        .max_by_key(|t| t.impacts().len())
    else {
        return Vec::new();
    };
    let mut timed: Vec<Timed> = Vec::new();
    for (index, truth) in sound.impacts.iter().enumerate() {
        if truth.snr_db < MIN_SNR_DB {
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
        let next_s = sound
            .impacts
            .get(index + 1)
            .map_or(f64::INFINITY, |i| i.time_s);
        let first = (truth.time_s * rate) as usize;
        let end = ((truth.time_s + USED_S).min(next_s) * rate) as usize;
        let threshold = THRESHOLD * recorded.noise_rms;
        let above = |sample: &f32| f64::from(sample.abs()) > threshold;
        let crossed = sound.samples[first + 1..end].iter().position(above);
        timed.push(Timed {
            number: index,
            error_s,
            sigma_s: impact.onset.sigma_s,
            bound_s: recorded.noise_rms / slope(&recorded.clean, first, end).sqrt() / rate,
            level_db: truth.snr_db,
            crossed_s: crossed.map(|n| (first + 1 + n) as f64 / rate - truth.time_s),
        });
    }
    timed
}

/// How late impacts are found, against the loudest of the same drop, by how loud they are: with
/// the whole sound, and by the first sample above a fixed level.
fn print_lateness(voice: &str, timed: &[Vec<Timed>]) {
    const STEP_DB: f64 = 5.0;
    /// A median of fewer impacts says little.
    const FEWEST: usize = 20;
    let mut later: BTreeMap<i32, (Vec<f64>, Vec<f64>)> = BTreeMap::new();
    for drop in timed {
        let Some(loudest) = drop.iter().max_by(|a, b| a.level_db.total_cmp(&b.level_db)) else {
            continue;
        };
        for impact in drop.iter().filter(|impact| impact.number != loudest.number) {
            let step = (impact.level_db / STEP_DB).round() as i32;
            let (errors, crossings) = later.entry(step).or_default();
            errors.push(impact.error_s - loudest.error_s);
            crossings.extend(impact.crossed_s.zip(loudest.crossed_s).map(|(a, b)| a - b));
        }
    }
    for (step, (errors, crossings)) in later {
        if errors.len() < FEWEST {
            continue;
        }
        if let (Some(late_s), Some(crossed_s)) = (median(errors), median(crossings)) {
            println!(
                "| {voice} | {:.0} dB | {:+.1} us | {:+.1} us |",
                f64::from(step) * STEP_DB,
                1e6 * late_s,
                1e6 * crossed_s
            );
        }
    }
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

fn summary(timed: &[Vec<Timed>]) -> String {
    let flights: Vec<Flight> = timed.iter().flat_map(|drop| flights(drop)).collect();
    let error_s = median(flights.iter().map(|t| t.error.abs()));
    let over = median(flights.iter().map(|t| t.error.abs() / t.bound));
    let within = flights.iter().filter(|t| t.error.abs() < t.sigma).count();
    let (Some(error_s), Some(over)) = (error_s, over) else {
        return "0 | - | - | - | - |".into();
    };
    format!(
        "{} | {:.2} us | {:.2} | {:.0} % | {} |",
        flights.len(),
        1e6 * error_s,
        over / MEDIAN_OF_NORMAL,
        100.0 * within as f64 / flights.len() as f64,
        drift(timed)
    )
}

/// The median error of flight times, and how many are within one and beyond three standard errors,
/// of the first and of the second half of each drop.
fn halves(timed: &[Vec<Timed>]) -> String {
    let (mut first, mut second): (Vec<Flight>, Vec<Flight>) = Default::default();
    for drop in timed {
        let (early, late) = drop.split_at(drop.len() / 2);
        first.extend(flights(early));
        second.extend(flights(late));
    }
    let halves = [first, second];
    let each = |cell: &dyn Fn(&[Flight]) -> String| {
        let [first, second] = halves.each_ref().map(|half| cell(half));
        format!("{first}, {second}")
    };
    let percent = |half: &[Flight], is_meant: &dyn Fn(f64) -> bool| {
        let meant = half.iter().filter(|f| is_meant(f.error.abs() / f.sigma));
        100.0 * meant.count() as f64 / half.len().max(1) as f64
    };
    let error = each(&|half| {
        let error_s = median(half.iter().map(|flight| flight.error.abs()));
        error_s.map_or("-".into(), |error_s| format!("{:.2} us", 1e6 * error_s))
    });
    let within = each(&|half| format!("{:.0} %", percent(half, &|score| score < 1.0)));
    let beyond = each(&|half| format!("{:.1} %", percent(half, &|score| score > 3.0)));
    format!("{error} | {within} | {beyond}")
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
fn drift(timed: &[Vec<Timed>]) -> String {
    let (mut weights, mut sum) = (0.0, 0.0);
    for drop in timed.iter().filter(|drop| drop.len() > 2) {
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
