//! Sounds that keep a steady rate, as of a machine: no drop, however long they go on, and wherever the past is cut that
//! the detector remembers. A drop among them is found wherever that is.

use super::drops::{detect, usual};
use bouncelab::detection::Detection;
use bouncelab::impact::ImpactEvent;
use bouncelab::synth::{self, Rendered, Scene};
use bouncelab::train::Train;
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

const RATES_HZ: [f64; 9] = [20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 80.0, 90.0, 100.0];
const LENGTHS_S: [f64; 4] = [60.0, 240.0, 300.0, 400.0];
/// Scatter of the intervals, as a share of them, and by which factor the speeds of impacts differ at most.
const SCATTERS: [(f64, f64); 4] = [(0.0, 1.0), (0.02, 1.0), (0.0, 2.0), (0.02, 2.0)];
/// The past is judged when this is remembered: sounds, or seconds.
const REMEMBERED: (f64, f64) = (4000.0, 180.0);
/// Where the drop begins, in seconds after that; it lasts eight.
const BEGINS_S: [f64; 6] = [-9.0, -7.0, -5.0, -3.0, -1.0, 0.1];

/// Prints the table.
pub(crate) fn print() {
    println!(
        "\n| a second | times | speeds | false drops in 60, 240, 300, 400 s | cut elsewhere | drops found |"
    );
    println!("|--:|---|---|---|---|---|");
    let rows: Vec<(f64, f64, f64)> = RATES_HZ
        .iter()
        .flat_map(|&rate| SCATTERS.map(|(times, speeds)| (rate, times, speeds)))
        .collect();
    let rows: Vec<String> = rows.into_par_iter().map(row).collect();
    for row in rows {
        println!("{row}");
    }
}

fn row((rate_hz, times, speeds): (f64, f64, f64)) -> String {
    let longest_s = LENGTHS_S[LENGTHS_S.len() - 1];
    let clicks = clicks(rate_hz, times, speeds, longest_s);
    let sound = render(&clicks);
    let samples = |seconds: f64| (seconds * f64::from(sound.sample_rate_hz)) as usize;
    let found = |from_s: f64, to_s: f64| {
        let part = &sound.samples[samples(from_s)..samples(to_s)];
        Verdict::of(&detect(part, sound.sample_rate_hz))
    };
    let by_length = LENGTHS_S.map(|length_s| found(0.0, length_s));
    // Other sounds are the last ones that are remembered.
    let shifts = [0.23, 0.51, 0.77].map(|share| share * REMEMBERED.0 / rate_hz);
    let shifted = shifts.map(|from_s| found(from_s, longest_s));
    let cut_s = REMEMBERED.1.min(REMEMBERED.0 / rate_hz);
    let drops_found = BEGINS_S
        .iter()
        .filter(|&&begins_s| is_found(&clicks, cut_s, cut_s + begins_s))
        .count();
    let words = |verdicts: &[Verdict]| {
        let words = verdicts.iter().map(Verdict::words);
        words.collect::<Vec<_>>().join(", ")
    };
    format!(
        "| {rate_hz} | ± {:.0} % | up to {speeds:.0} : 1 | {} | {} | {drops_found} of {} |",
        100.0 * times,
        words(&by_length),
        words(&shifted),
        BEGINS_S.len()
    )
}

/// Drops in a sound without any.
struct Verdict {
    drops: usize,
    most_probable: f64,
}

impl Verdict {
    fn of(detection: &Detection) -> Self {
        let probabilities = detection.found.trains.iter().map(Train::probability);
        Self {
            drops: detection.found.trains.len(),
            most_probable: probabilities.fold(0.0, f64::max),
        }
    }

    fn words(&self) -> String {
        match self.drops {
            0 => "0".to_owned(),
            drops => format!("{drops} (to {:.2})", self.most_probable),
        }
    }
}

/// Equal impacts but for their scatter, from the same seed in every length.
fn clicks(rate_hz: f64, times: f64, speeds: f64, length_s: f64) -> Vec<ImpactEvent> {
    let mut rng = ChaCha8Rng::seed_from_u64(rate_hz as u64);
    let events = (0..(rate_hz * length_s) as u32).map(|n| {
        let late = times * (2.0 * rng.random::<f64>() - 1.0);
        ImpactEvent {
            time_s: (f64::from(n) + late.max(0.0)) / rate_hz,
            speed_m_s: 0.3 * speeds.powf(rng.random()),
        }
    });
    events.collect()
}

fn render(events: &[ImpactEvent]) -> Rendered {
    let scene = Scene {
        lead_in_s: 0.0,
        tail_s: 0.1,
        ..usual(40.0)
    };
    synth::render(events, &scene, 1).unwrap_or_else(|error| panic!("clicks: {error}"))
}

/// Whether a drop that begins at this time among the clicks is found, so that most of its impacts are in one train, and
/// no other.
fn is_found(clicks: &[ImpactEvent], cut_s: f64, begins_s: f64) -> bool {
    let drop: Vec<ImpactEvent> = bouncing(begins_s).collect();
    let until_s = cut_s + 12.0;
    let around = clicks.iter().filter(|it| it.time_s < until_s).copied();
    let mut events: Vec<ImpactEvent> = around.chain(drop.iter().copied()).collect();
    events.sort_by(|a, b| a.time_s.total_cmp(&b.time_s));
    let sound = render(&events);
    let detection = detect(&sound.samples, sound.sample_rate_hz);
    let [train] = &detection.found.trains[..] else {
        return false;
    };
    let is_detected = |event: &&ImpactEvent| {
        let mut impacts = train.impacts().iter();
        impacts.any(|impact| (impact.onset.time_s - event.time_s).abs() < 2e-3)
    };
    let detected = drop.iter().filter(is_detected).count();
    2 * detected > drop.len() && 2 * detected > train.impacts().len()
}

/// Fifteen impacts of a ball, ten times as fast as the clicks at first.
fn bouncing(begins_s: f64) -> impl Iterator<Item = ImpactEvent> {
    let mut time_s = begins_s;
    (0..15).map(move |n| {
        let event = ImpactEvent {
            time_s,
            speed_m_s: 3.0 * 0.92_f64.powi(n),
        };
        time_s += 2.0 * 0.92 * event.speed_m_s / 9.81;
        event
    })
}
