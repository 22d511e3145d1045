//! Draws every figure with realistic data, into the folder given as argument: once as saved,
//! and once 480 pixels wide as on a phone.
//!
//! ```sh
//! cargo run -p bouncelab-report --example gallery -- FOLDER
//! ```

use std::f64::consts::TAU;
use std::path::PathBuf;

use bouncelab_report::figure::{
    self, Curve, DragAxes, Envelope, Figure, Line, Mark, Restitution, TimedFlight,
};
use bouncelab_report::save;
use bouncelab_report::theme::Meaning;

/// Flight times like those of the paper: first 0.433 s, each 0.94 of the one before.
const RATIO: f64 = 0.94;
const FIRST_S: f64 = 0.4605;
const GRAVITY_M_S2: f64 = 9.806_65;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = std::env::args_os().nth(1).map(PathBuf::from);
    let folder = folder.ok_or("give a folder: cargo run --example gallery -- FOLDER")?;
    for (name, figure) in gallery()? {
        let saved = save(&figure, &folder, name)?;
        std::fs::write(folder.join(format!("{name}-480.png")), figure.png(480)?)?;
        println!("{}\n    {}", saved.svg.display(), figure.caption());
    }
    Ok(())
}

fn gallery() -> bouncelab_report::Result<Vec<(&'static str, Figure)>> {
    Ok(vec![
        ("waveform", waveform(38, FIRST_S)?),
        ("waveform-60", waveform(60, FIRST_S)?),
        ("waveform-2", waveform(2, FIRST_S)?),
        ("waveform-short", waveform(12, 0.012)?),
        ("waveform-drops", several_drops()?),
        ("waveform-long", twenty_minutes()?),
        (
            "waveform-empty",
            figure::waveform(&Envelope::from_samples(&[], 44_100.0, 10)?, &[]),
        ),
        ("flight-times", flight_times(38, 10)),
        ("flight-times-60", flight_times(60, 30)),
        ("flight-times-1", flight_times(1, 1)),
        (
            "flight-times-no-line",
            figure::flight_times(&flights(10, 10), None),
        ),
        ("drag-linear", drag(DragAxes::Linear, 10.0, Some(2.4))),
        ("drag-log", drag(DragAxes::Logarithmic, 20.0, Some(2.4))),
        ("height-no-drag", height_without_drag()),
        ("height", height()),
        (
            "height-small",
            figure::height(&[hops("model", Meaning::Drag, 0.002, 0.9)], &[]),
        ),
        ("restitution", restitution()),
        (
            "restitution-line",
            figure::restitution(&raw(10), &[], &[], Some(0.9375)),
        ),
        (
            "restitution-empty",
            figure::restitution(&[], &[], &[], None),
        ),
    ])
}

fn impact_times(impacts: usize, first_s: f64) -> Vec<f64> {
    let mut time_s = 0.3 * first_s;
    (1..=impacts)
        .map(|n| {
            let now = time_s;
            time_s += first_s * RATIO.powf(n as f64);
            now
        })
        .collect()
}

/// Decaying clicks over a little noise.
fn sound(impacts: &[f64], duration_s: f64, rate_hz: f64) -> Vec<f32> {
    let mut noise = 12_345_u32;
    let mut samples: Vec<f64> = (0..(duration_s * rate_hz) as usize)
        .map(|_| {
            noise = noise.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            0.012 * (f64::from(noise) / f64::from(u32::MAX) - 0.5)
        })
        .collect();
    for (n, impact) in impacts.iter().enumerate() {
        let first = (impact * rate_hz) as usize;
        for (i, sample) in samples.iter_mut().skip(first).take(2000).enumerate() {
            let time_s = i as f64 / rate_hz;
            let level = 0.8 * RATIO.powf(n as f64) * (-time_s / 0.004).exp();
            *sample += level * (TAU * 4200.0 * time_s).sin();
        }
    }
    samples.into_iter().map(|sample| sample as f32).collect()
}

fn waveform(impacts: usize, first_s: f64) -> bouncelab_report::Result<Figure> {
    let times = impact_times(impacts, first_s);
    let end_s = times.last().map_or(1.0, |last| last + 0.7 * first_s);
    let rate_hz = 44_100.0;
    let envelope = Envelope::from_samples(&sound(&times, end_s, rate_hz), rate_hz, 2000)?;
    let marks: Vec<Mark> = times
        .iter()
        .enumerate()
        .map(|(n, &time_s)| Mark {
            time_s,
            sure: n != 13 && n <= 35,
            drop: 1,
        })
        .collect();
    Ok(figure::waveform(&envelope, &marks))
}

fn several_drops() -> bouncelab_report::Result<Figure> {
    let mut marks = Vec::new();
    for drop in 1..=3 {
        let start_s = 5.0 * (drop - 1) as f64;
        marks.extend(impact_times(16, 0.42).iter().map(|time_s| Mark {
            time_s: start_s + time_s,
            sure: drop != 2,
            drop,
        }));
    }
    let times: Vec<f64> = marks.iter().map(|mark| mark.time_s).collect();
    let rate_hz = 44_100.0;
    let envelope = Envelope::from_samples(&sound(&times, 16.0, rate_hz), rate_hz, 2000)?;
    Ok(figure::waveform(&envelope, &marks))
}

/// A long and quiet recording with a drop in the middle of it.
fn twenty_minutes() -> bouncelab_report::Result<Figure> {
    let max: Vec<f32> = (0..2400_u16)
        .map(|i| 2e-4 + 1e-4 * f32::from(i % 7))
        .collect();
    let min = max.iter().map(|level| -level).collect();
    let marks: Vec<Mark> = impact_times(20, FIRST_S)
        .iter()
        .map(|time_s| Mark {
            time_s: 700.0 + time_s,
            sure: true,
            drop: 1,
        })
        .collect();
    let envelope = Envelope::new(0.0, 0.5, min, max)?;
    Ok(figure::waveform(&envelope, &marks))
}

/// Flights a little shorter than the straight line at first, as air makes them, with a
/// scatter that grows as they get short.
fn flights(count: u32, used: u32) -> Vec<TimedFlight> {
    (1..=count)
        .map(|number| {
            let n = f64::from(number);
            let wobble = 0.004 * (2.7 * n).sin() * (1.0 + n / 15.0);
            let air = -0.012 * (-n / 4.0).exp();
            TimedFlight {
                number,
                time_s: FIRST_S * RATIO.powf(n) * (1.0 + wobble + air),
                standard_error_s: Some(0.0002 + 0.001 * n / 60.0),
                used: number <= used,
            }
        })
        .collect()
}

fn flight_times(count: u32, used: u32) -> Figure {
    let line = Line {
        slope: RATIO.log10(),
        intercept: FIRST_S.log10(),
    };
    figure::flight_times(&flights(count, used), Some(line))
}

/// Drag over weight of the paper's ball: terminal speed 9.38 m/s with a constant coefficient.
fn drag(axes: DragAxes, fastest_drawn: f64, fastest_m_s: Option<f64>) -> Figure {
    let curve = |name: &str, drag: fn(f64) -> f64| Curve {
        name: name.to_owned(),
        meaning: Meaning::Drag,
        points: (0..=300)
            .map(|i| {
                let share = f64::from(i) / 300.0;
                let speed = match axes {
                    DragAxes::Linear => fastest_drawn * share,
                    DragAxes::Logarithmic => 0.01 * (fastest_drawn / 0.01).powf(share),
                };
                (speed, drag(speed))
            })
            .collect(),
    };
    // Clift and Gauvin's coefficient, as a share of 0.4, at the ball's Reynolds number.
    let varying = |speed: f64| {
        let re = (2530.0 * speed).max(1e-9);
        let coefficient =
            24.0 / re * (1.0 + 0.15 * re.powf(0.687)) + 0.42 / (1.0 + 42_500.0 * re.powf(-1.16));
        (speed / 9.38).powi(2) * coefficient / 0.4
    };
    let curves = [
        curve("Clift and Gauvin", varying),
        curve("constant 0.4", |speed| (speed / 9.38).powi(2)),
    ];
    figure::drag(&curves, axes, fastest_m_s)
}

/// Hops without air, from a first height.
fn hops(name: &str, meaning: Meaning, first_m: f64, ratio: f64) -> Curve {
    let mut points = Vec::new();
    let mut time_s = -(2.0 * first_m / GRAVITY_M_S2).sqrt();
    let mut height_m = first_m;
    while height_m > first_m / 400.0 {
        let half_s = (2.0 * height_m / GRAVITY_M_S2).sqrt();
        for i in 0..=24 {
            let t = half_s * (f64::from(i) / 12.0 - 1.0);
            if time_s + half_s + t >= 0.0 {
                let fallen_m = 0.5 * GRAVITY_M_S2 * t * t;
                points.push((time_s + half_s + t, height_m - fallen_m));
            }
        }
        time_s += 2.0 * half_s;
        height_m *= ratio * ratio;
    }
    Curve {
        name: name.to_owned(),
        meaning,
        points,
    }
}

fn height_without_drag() -> Figure {
    let mut curve = hops("no air", Meaning::NoDrag, 0.305, 0.9);
    curve.points.truncate(120);
    figure::height(&[curve], &[])
}

fn height() -> Figure {
    let curves = [
        hops("no air, e = 0.9375", Meaning::NoDrag, 0.305, 0.9375),
        hops("constant drag, e = 0.935", Meaning::Drag, 0.305, 0.925),
        hops("Clift and Gauvin, e = 0.935", Meaning::Drag, 0.305, 0.924),
    ];
    let mut apexes = Vec::new();
    let (mut height_m, mut time_s) = (0.305 * 0.925_f64.powi(2), (0.61 / GRAVITY_M_S2).sqrt());
    for _ in 0..20 {
        let half_s = (2.0 * height_m / GRAVITY_M_S2).sqrt();
        apexes.push((time_s + half_s, height_m));
        time_s += 2.0 * half_s;
        height_m *= 0.925_f64.powi(2);
    }
    figure::height(&curves, &apexes)
}

fn raw(count: usize) -> Vec<Restitution> {
    (1..=count)
        .map(|n| {
            let speed_m_s = 2.3 * RATIO.powf(n as f64);
            let wobble = 0.003 * (1.9 * n as f64).sin() * (1.0 + n as f64 / 10.0);
            Restitution {
                speed_m_s,
                value: 0.945 - 0.007 * speed_m_s + wobble,
                standard_error: None,
                odd: false,
            }
        })
        .collect()
}

fn restitution() -> Figure {
    let mut raw = raw(36);
    raw[33].value = 1.4;
    let corrected: Vec<_> = raw
        .iter()
        .enumerate()
        .map(|(n, impact)| Restitution {
            speed_m_s: impact.speed_m_s,
            value: impact.value + 0.008 * impact.speed_m_s,
            standard_error: Some(0.001 + 0.0002 * n as f64),
            odd: false,
        })
        .collect();
    figure::restitution(&raw, &corrected, &[], Some(0.9375))
}
