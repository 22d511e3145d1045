//! Every figure once, with data as they come, and some with less usual data.

use std::f64::consts::TAU;

use bouncelab::Estimate;
use bouncelab::analysis::{self, Drop, Options};
use bouncelab::demo;
use bouncelab::detection::Envelope;
use bouncelab::groups::CurvePoint;
use bouncelab_report::Chart;
use bouncelab_report::figure::{
    self, Curve, Detection, DragAxes, EvaluatedValue, FigureInput, GroupCurve, GroupInterval, Line,
    Mark, RankHistogram, RunPoint, TimedFlight,
};
use bouncelab_report::messages::Translator;
use bouncelab_report::theme::Meaning;

/// Flight times like those of the paper: first 0.433 s, each 0.94 of the one before.
const RATIO: f64 = 0.94;
const FIRST_S: f64 = 0.4605;

pub(crate) const LINE: Line = Line {
    slope: -0.026_872,
    intercept: -0.336_770,
};

/// A chart with its name and texts that it must show.
pub(crate) type Named = (String, Chart, &'static [&'static str]);

/// All of them.
pub(crate) fn all(translator: &Translator) -> Vec<Named> {
    let mut all = of_drops(translator);
    let others: Vec<(&str, Chart, &'static [&'static str])> = [
        of_sounds(translator),
        of_curves(translator),
        of_many_drops(translator),
    ]
    .concat();
    let named = |(name, chart, texts): (&str, _, _)| (name.to_owned(), chart, texts);
    all.extend(others.into_iter().map(named));
    all
}

/// A drop of the demo, as it is found from impact times with an error of a few microseconds; one of
/// them is wrong.
fn drop_of(settings: &Options) -> Drop {
    let history = demo::history().unwrap();
    let times = history.bounces().iter().enumerate().map(|(n, bounce)| {
        let wrong_s = if n == 20 { 4e-4 } else { 0.0 };
        bounce.time_s + 5e-6 * (2.7 * n as f64).sin() + wrong_s
    });
    let times: Vec<f64> = times.take(45).collect();
    analysis::analyze_impacts(analysis::impacts_of_times(&times), settings)
}

/// The figures of a drop with and without inference, and those of the air.
fn of_drops(translator: &Translator) -> Vec<Named> {
    let texts = |name: &str| -> &'static [&'static str] {
        match name {
            "restitution" => &[
                "restitution: speed after / before",
                "speed at the impact (m/s)",
            ],
            "flight-times" => &[
                "flight time (s)",
                "number of the flight",
                "residual of the fit (%)",
            ],
            "height" => &["time (s)", "height (cm)", "measured apexes"],
            "bounce-heights" => &["bounce", "height (cm)"],
            "bounce-energies" => &["bounce", "energy lost (µJ)", "the bounce"],
            "comparison" => &["time (s)", "height (cm)", "measured"],
            "posterior" => &["restitution", "height (cm)", "before the data"],
            "residuals" => &[
                "impact",
                "residual (standard deviations)",
                "outlier, less weight",
            ],
            "budget" => &["scatter of restitution"],
            "models" => &["probability", "drop height (cm)"],
            "truncation" => &["flights used", "drop height (cm)", "log-linear fit"],
            _ => &["speed (m/s)", "drag / weight"],
        }
    };
    let full = Options::default();
    let quick = Options {
        inference: None,
        ..full.clone()
    };
    let mut all = Vec::new();
    for (settings, suffix) in [(&full, ""), (&quick, "-quick")] {
        let drop = drop_of(settings);
        let input = FigureInput::new(&drop, settings);
        let charts = figure::of_drop(&input).map(|f| (f.name, f.chart(&input, translator)));
        let air = figure::of_air(std::slice::from_ref(&drop), settings, translator);
        for (name, chart) in charts.chain(air) {
            all.push((format!("{name}{suffix}"), chart, texts(name)));
        }
    }
    all
}

fn impact_times(impacts: usize, first_s: f64) -> Vec<f64> {
    let mut time_s = 0.3 * first_s;
    let times = (1..=impacts).map(|n| {
        let now = time_s;
        time_s += first_s * RATIO.powf(n as f64);
        now
    });
    times.collect()
}

/// Decaying clicks over a little noise.
pub(crate) fn sound(impacts: &[f64], duration_s: f64) -> Envelope {
    const RATE_HZ: f64 = 44_100.0;
    const STEP: usize = 32;
    let mut noise = 12_345_u32;
    let mut samples: Vec<f64> = (0..(duration_s * RATE_HZ) as usize)
        .map(|_| {
            noise = noise.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            0.012 * (f64::from(noise) / f64::from(u32::MAX) - 0.5)
        })
        .collect();
    for (n, impact) in impacts.iter().enumerate() {
        let first = (impact * RATE_HZ) as usize;
        for (i, sample) in samples.iter_mut().skip(first).take(2000).enumerate() {
            let time_s = i as f64 / RATE_HZ;
            let level = 0.8 * RATIO.powf(n as f64) * (-time_s / 0.004).exp();
            *sample += level * (TAU * 4200.0 * time_s).sin();
        }
    }
    let ends = samples.chunks(STEP).map(|step| {
        let low = step.iter().copied().fold(f64::INFINITY, f64::min);
        let high = step.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        (low as f32, high as f32)
    });
    let (least, greatest) = ends.unzip();
    Envelope::of_steps(STEP as f64 / RATE_HZ, least, greatest)
}

fn waveform(impacts: usize, first_s: f64, translator: &Translator) -> Chart {
    let times = impact_times(impacts, first_s);
    let end_s = times.last().map_or(1.0, |last| last + 0.7 * first_s);
    let marks = times.iter().enumerate().map(|(n, &time_s)| Mark {
        time_s,
        sure: n != 13 && n <= 35,
        drop: 1,
    });
    let marks: Vec<Mark> = marks.collect();
    figure::waveform(&sound(&times, end_s), &marks, translator)
}

fn several_drops(translator: &Translator) -> Chart {
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
    figure::waveform(&sound(&times, 16.0), &marks, translator)
}

/// A long and quiet recording with a drop in the middle of it.
fn twenty_minutes(translator: &Translator) -> Chart {
    let greatest: Vec<f32> = (0..2400_u16)
        .map(|i| 2e-4 + 1e-4 * f32::from(i % 7))
        .collect();
    let least = greatest.iter().map(|level| -level).collect();
    let marks = impact_times(20, FIRST_S).into_iter().map(|time_s| Mark {
        time_s: 700.0 + time_s,
        sure: true,
        drop: 1,
    });
    let marks: Vec<Mark> = marks.collect();
    figure::waveform(
        &Envelope::of_steps(0.5, least, greatest),
        &marks,
        translator,
    )
}

type Unnamed = Vec<(&'static str, Chart, &'static [&'static str])>;

fn of_sounds(translator: &Translator) -> Unnamed {
    let axes: &[&str] = &["time (s)", "amplitude, relative to full scale"];
    vec![
        ("waveform", waveform(38, FIRST_S, translator), axes),
        ("waveform-60", waveform(60, FIRST_S, translator), axes),
        ("waveform-2", waveform(2, FIRST_S, translator), axes),
        (
            "waveform-short",
            waveform(12, 0.012, translator),
            &["time (ms)"],
        ),
        ("waveform-drops", several_drops(translator), &["drop 2"]),
        ("waveform-long", twenty_minutes(translator), &["time (min)"]),
    ]
}

/// Flights a little shorter than the log-linear fit at first, as air makes them.
pub(crate) fn flights(count: usize, used: usize) -> Vec<TimedFlight> {
    let flights = (1..=count).map(|number| {
        let n = number as f64;
        let wobble = 0.004 * (2.7 * n).sin() * (1.0 + n / 15.0);
        let air = -0.012 * (-n / 4.0).exp();
        TimedFlight {
            number,
            time_s: FIRST_S * RATIO.powf(n) * (1.0 + wobble + air),
            used: number <= used,
        }
    });
    flights.collect()
}

/// Drag over weight of the paper's ball: terminal speed 9.38 m/s with a constant coefficient.
pub(crate) fn drag_curves(fastest_m_s: f64) -> Vec<Curve> {
    let curve = |name: &str, exponent: f64| Curve {
        name: name.to_owned(),
        meaning: Meaning::Drag,
        points: (0..=300)
            .map(|i| 0.01 * (fastest_m_s / 0.01).powf(f64::from(i) / 300.0))
            .map(|speed| [speed, (speed / 9.38).powf(exponent)])
            .collect(),
    };
    vec![curve("a law", 1.95), curve("constant:0.4", 2.0)]
}

/// Hops without air, from a first height.
pub(crate) fn hops(name: &str, meaning: Meaning, first_m: f64, ratio: f64) -> Curve {
    const GRAVITY_M_S2: f64 = 9.806_65;
    let mut points = Vec::new();
    let mut time_s = -(2.0 * first_m / GRAVITY_M_S2).sqrt();
    let mut height_m = first_m;
    while height_m > first_m / 400.0 {
        let half_s = (2.0 * height_m / GRAVITY_M_S2).sqrt();
        for i in 0..=24 {
            let t = half_s * (f64::from(i) / 12.0 - 1.0);
            if time_s + half_s + t >= 0.0 {
                let fallen_m = 0.5 * GRAVITY_M_S2 * t * t;
                points.push([time_s + half_s + t, height_m - fallen_m]);
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

fn of_curves(translator: &Translator) -> Unnamed {
    let heights = [
        hops("no air, e = 0.9375", Meaning::Plain, 0.305, 0.9375),
        hops("constant drag, e = 0.935", Meaning::Drag, 0.305, 0.925),
        hops("Clift and Gauvin, e = 0.935", Meaning::Drag, 0.305, 0.924),
    ];
    let small = [hops("model", Meaning::Drag, 0.002, 0.9)];
    let drag = |axes, fastest| figure::drag(&drag_curves(fastest), axes, Some(2.4), translator);
    let detection = |what| {
        let curve = |name: &str, meaning, scale: f64| Curve {
            name: name.to_owned(),
            meaning,
            points: (0..10_u8)
                .map(|i| {
                    [
                        4.0 * f64::from(i),
                        scale * (1.0 - (-0.3 * f64::from(i)).exp()),
                    ]
                })
                .collect(),
        };
        let curves = [
            curve("bouncelab", Meaning::Measured, 1.0),
            curve("another one", Meaning::Plain, 0.6),
            curve("a third one", Meaning::Plain, 0.4),
        ];
        figure::detection(what, &curves, translator)
    };
    let times = |count, used, line| figure::flight_times(&flights(count, used), line, translator);
    vec![
        (
            "height-models",
            figure::height("height", &heights, &[], translator),
            &["height (cm)"],
        ),
        (
            "height-small",
            figure::height("height", &small, &[], translator),
            &["height (mm)"],
        ),
        (
            "drag-linear",
            drag(DragAxes::Linear, 10.0),
            &["drag / weight"],
        ),
        (
            "drag-log-20",
            drag(DragAxes::Logarithmic, 20.0),
            &["this drop: up to 2.4 m/s"],
        ),
        ("flight-times-60", times(60, 30, Some(LINE)), &["not used"]),
        (
            "flight-times-1",
            times(1, 1, Some(LINE)),
            &["measured flights"],
        ),
        (
            "flight-times-no-line",
            times(10, 10, None),
            &["flight time (s)"],
        ),
        ("detection-found", detection(Detection::Found), &["F1"]),
        (
            "detection-late",
            detection(Detection::Late),
            &["later than the loudest (µs)"],
        ),
    ]
}

fn of_many_drops(translator: &Translator) -> Unnamed {
    let intervals = figure::intervals(&group_intervals(12), 1.41, translator);
    let run = figure::run_chart(&run_points(60), &names(3), Some(0.004), translator);
    vec![
        (
            "groups",
            figure::groups(&group_curves(14), translator),
            &["speed at the impact (m/s)", "ball 3, steel"],
        ),
        (
            "intervals",
            intervals,
            &["restitution at 1.41 m/s", "12 drops"],
        ),
        ("limits", limits(5, translator), &["rebound (cm)", "drop 1"]),
        (
            "run",
            run,
            &["drop, in order", "ln e less the median of the group"],
        ),
        (
            "calibration",
            figure::calibration(&histograms(), translator),
            &["clean", "e", "rank of the truth"],
        ),
    ]
}

pub(crate) fn histograms() -> Vec<RankHistogram> {
    ["clean", "noisy"]
        .into_iter()
        .flat_map(|scenario| ["e", "h0", "C_D"].map(|quantity| (scenario, quantity)))
        .map(|(scenario, quantity)| RankHistogram {
            scenario: scenario.to_owned(),
            quantity: quantity.to_owned(),
            bins: (0..20).map(|bin| 200 + bin % 7).collect(),
        })
        .collect()
}

pub(crate) fn names(groups: u32) -> Vec<String> {
    (0..groups)
        .map(|group| format!("ball {group}, steel"))
        .collect()
}

fn group_curves(groups: u32) -> Vec<GroupCurve> {
    let law = |group: u32| {
        let value = 0.94 - 0.01 * f64::from(group);
        let speed = |place: u32| 0.5 + 0.2 * f64::from(place);
        GroupCurve {
            name: format!("ball {group}, steel"),
            impacts: (0..30)
                .map(|i| [speed(i % 9), value + 1e-4 * f64::from(i)])
                .collect(),
            curve: (0..9)
                .map(|place| CurvePoint {
                    speed_m_s: speed(place),
                    restitution: Estimate::normal(value, 0.001),
                })
                .collect(),
        }
    };
    (0..groups).map(law).collect()
}

fn limits(drops: u32, translator: &Translator) -> Chart {
    let evaluated = |drop: u32| {
        let value = 24.5 + 0.3 * f64::from(drop);
        EvaluatedValue {
            name: format!("drop {drop}"),
            value,
            interval95: Some([value - 0.4, value + 0.4]),
            decides: drop == 0,
        }
    };
    let evaluated: Vec<EvaluatedValue> = (0..drops).map(evaluated).collect();
    let ends = [Some(24.0), Some(26.0)];
    let accepted = [Some(24.2), Some(25.8)];
    figure::limits(
        &evaluated,
        ends,
        accepted,
        ("rebound".to_owned(), "cm"),
        translator,
    )
}

fn group_intervals(groups: u32) -> Vec<GroupInterval> {
    let interval = |group: u32| {
        let mean = 0.94 - 0.005 * f64::from(group);
        GroupInterval {
            name: format!("a ball with a rather long name, number {group}"),
            restitution: Estimate::normal(mean, 0.001),
            next95: (group > 1).then_some([mean - 0.006, mean + 0.006]),
            drops: (0..=group)
                .map(|i| (mean + 1e-3 * f64::from(i % 5), i == 3))
                .collect(),
        }
    };
    (0..groups).map(interval).collect()
}

pub(crate) fn run_points(drops: u32) -> Vec<RunPoint> {
    let point = |drop: u32| RunPoint {
        off: if drop == 17 {
            0.1
        } else {
            1e-3 * (f64::from(drop % 7) - 3.0)
        },
        standard_error: Some(5e-4),
        group: drop as usize % 3,
        outlier: drop == 17,
    };
    (0..drops).map(point).collect()
}
