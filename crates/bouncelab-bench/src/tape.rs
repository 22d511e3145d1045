//! Heights of real drops against a tape measure.
//!
//! ```text
//! cargo xtask calibrate tape FILE [without=DROP]... [later=MS] [each]
//! ```
//!
//! The file is a table of CSV with a row for each drop and these columns:
//!
//! | column | content |
//! |---|---|
//! | `drop` | name of the drop |
//! | `ball` | name of the ball, as it is stated to the program |
//! | `tape_height_cm` | drop height by the tape |
//! | `flight_1_s`, `flight_2_s`, ... | time from each impact to the next; those that were not measured are empty |
//!
//! The drops are those of people who measured them; the project has no copy. A drop is left out only by its name, with
//! `without=`, and the table says so. With `later=3` each impact is taken to be timed 3 ms later than the one before it was,
//! as a threshold does that fainter sounds reach later; a contact that lasts as much longer is the same. `each` prints a
//! line for each drop besides.

use bouncelab::analysis::Drop;
use bouncelab::groups::{Asked, CurveEvidence, Study, StudyDrop};
use bouncelab::inference::Measured as Stated;
use bouncelab::regression::height_of_flight_m;
use bouncelab::settings::{AirSettings, Settings};
use bouncelab::{Estimate, Options, analyze_times};
use rayon::prelude::*;

use crate::Result;
use crate::held::{Held, cells, mean, median, rms};
use crate::recordings::of_cut;

/// Standard uncertainty of a height by a ruler that the program assumes, m.
const RULER_SD_M: f64 = 0.002;

/// A drop as it was measured.
struct Measured {
    name: String,
    ball: String,
    tape_m: f64,
    flights_s: Vec<f64>,
}

/// The heights that follow from the times alone, m; `None` where the inference has no answer.
struct Found {
    with_air: Option<Estimate>,
    without_air: Option<Estimate>,
    /// g T1⁴/(8 T2²), which takes the first two impacts to keep the same share.
    of_two_flights_m: f64,
    /// What the drop adds to a study if the tape is not stated, and if it is.
    evidence: [Option<(Estimate, CurveEvidence)>; 2],
    /// Whether the drop without its first impact fell from the apex of its first flight, which needs no tape.
    without_first: Option<Held>,
}

/// `calibrate tape FILE [without=DROP]... [later=MS] [each]`: prints the tables.
///
/// # Errors
///
/// If the file cannot be read, no drop has a name that is to be left out, or a drop cannot be analysed.
pub(crate) fn run(arguments: &[String]) -> Result {
    let [file, options @ ..] = arguments else {
        return Err("usage: calibrate tape FILE [without=DROP]... [later=MS] [each]".into());
    };
    let table = std::fs::read_to_string(file)?;
    let mut drops = read(&table).map_err(|reason| format!("{file}: {reason}"))?;
    for option in options {
        match option.split_once('=') {
            Some(("without", name)) => {
                let place = drops.iter().position(|drop| drop.name == name);
                drops.remove(place.ok_or_else(|| format!("no drop has the name {name}"))?);
                println!("Without {name}.");
            }
            Some(("later", later_ms)) => {
                let later_s = later_ms.parse::<f64>()? / 1000.0;
                let flights = drops.iter_mut().flat_map(|drop| &mut drop.flights_s);
                flights.for_each(|flight_s| *flight_s -= later_s);
                println!("Each impact is timed {later_ms} ms later than the one before it.");
            }
            None if option == "each" => {}
            _ => {
                return Err(format!(
                    "'{option}' is no option; the options are without=DROP, later=MS and each"
                )
                .into());
            }
        }
    }
    drops.iter().for_each(warn_of_copies);
    let found: Result<Vec<Found>> = drops.par_iter().map(found).collect();
    let all: Vec<(&Measured, Found)> = drops.iter().zip(found?).collect();
    if options.iter().any(|option| option == "each") {
        for (drop, found) in &all {
            let Some(Estimate { value, sd, .. }) = found.with_air else {
                println!("{}: no answer", drop.name);
                continue;
            };
            let z = (value - drop.tape_m) / sd;
            println!("{}: {value:.4} m ± {sd:.4} m, {z:+.2} sd", drop.name);
        }
    }
    report_coverage(&all);
    report_offsets(&all);
    report_studies(&all);
    Ok(())
}

fn read(table: &str) -> Result<Vec<Measured>> {
    let mut table = csv::Reader::from_reader(table.as_bytes());
    let headers = table.headers()?.clone();
    let column = |name: &str| {
        let place = headers.iter().position(|header| header == name);
        place.ok_or_else(|| format!("there is no column {name}"))
    };
    let (name, ball, tape) = (column("drop")?, column("ball")?, column("tape_height_cm")?);
    let flights = headers.iter().enumerate();
    let flights: Vec<usize> = flights
        .filter(|(_, header)| header.starts_with("flight_"))
        .map(|(place, _)| place)
        .collect();
    let rows = table.records().map(|row| {
        let row = row?;
        let cells = flights.iter().map(|&place| &row[place]);
        let measured = cells.take_while(|cell| !cell.is_empty());
        Ok(Measured {
            name: row[name].to_owned(),
            ball: row[ball].to_owned(),
            tape_m: row[tape].parse::<f64>()? / 100.0,
            flights_s: measured
                .map(str::parse)
                .collect::<std::result::Result<_, _>>()?,
        })
    });
    rows.collect()
}

/// No two flights of a ball last equally long to a microsecond.
fn warn_of_copies(drop: &Measured) {
    for (place, pair) in drop.flights_s.windows(2).enumerate() {
        if (pair[0] - pair[1]).abs() < 1e-6 {
            let (name, number) = (&drop.name, place + 1);
            println!(
                "{name}: flights {number} and {} both last {} s.",
                number + 1,
                pair[0]
            );
        }
    }
}

fn found(drop: &Measured) -> Result<Found> {
    let mut times_s = vec![0.0];
    for flight_s in &drop.flights_s {
        times_s.push(times_s[times_s.len() - 1] + flight_s);
    }
    let analysed = |settings: &Settings| -> Result<(Drop, Options)> {
        let options = settings.resolve()?.options;
        let analysed = analyze_times(&times_s, &options).drops.pop();
        let analysed = analysed.ok_or_else(|| format!("{} is no drop", drop.name))?;
        Ok((analysed, options))
    };
    let settings = Settings::of_ball(&drop.ball);
    let air = AirSettings {
        drag: Some("none".to_owned()),
        ..AirSettings::default()
    };
    let height_m = |drop: &Drop| Some(drop.posterior.as_ref().ok()?.drop_height_m);
    let evidence = |drop: &Drop| Some((height_m(drop)?, drop.posterior.as_ref().ok()?.evidence()?));
    let (in_air, options) = analysed(&settings)?;
    let mut with_tape = options.clone();
    with_tape.priors.drop_height_m = Some(Stated {
        value: drop.tape_m,
        sd: RULER_SD_M,
    });
    let with_tape = analyze_times(&times_s, &with_tape).drops.pop();
    let (in_vacuum, _) = analysed(&Settings { air, ..settings })?;
    let [first_s, second_s] = [drop.flights_s[0], drop.flights_s[1]];
    Ok(Found {
        with_air: height_m(&in_air),
        without_air: height_m(&in_vacuum),
        of_two_flights_m: height_of_flight_m(first_s, options.environment.gravity_m_s2)
            * (first_s / second_s).powi(2),
        evidence: [evidence(&in_air), with_tape.as_ref().and_then(evidence)],
        without_first: of_cut(&in_air, 1, &options),
    })
}

/// The names of the balls in the order of the file, each with its drops, and all.
fn by_ball<'a>(all: &'a [(&'a Measured, Found)]) -> Vec<(&'a str, Vec<&'a (&'a Measured, Found)>)> {
    let mut balls: Vec<&str> = all.iter().map(|(drop, _)| drop.ball.as_str()).collect();
    balls.dedup();
    let mut groups: Vec<_> = balls
        .into_iter()
        .map(|ball| {
            (
                ball,
                all.iter().filter(|(drop, _)| drop.ball == ball).collect(),
            )
        })
        .collect();
    groups.push(("all", all.iter().collect()));
    groups
}

fn report_coverage(all: &[(&Measured, Found)]) {
    println!(
        "\n| ball | height by | drops | % in 68 | % in 95 | rms z | mean error, % | rms error, % |"
    );
    println!("|---|---|--:|--:|--:|--:|--:|--:|");
    let groups = by_ball(all);
    let report = |by: &str, held: &dyn Fn(&Measured, &Found) -> Option<Held>| {
        for (ball, drops) in &groups {
            let held = drops.iter().filter_map(|(drop, found)| held(drop, found));
            println!("| {ball} | {by} | {} |", cells(&held.collect::<Vec<_>>()));
        }
    };
    report("the inference", &|drop, found| {
        Some(Held::of(found.with_air.as_ref()?, drop.tape_m))
    });
    report("the same, tape ± 2 mm", &|drop, found| {
        let with_air = found.with_air.as_ref()?;
        Some(Held::within(with_air, drop.tape_m, RULER_SD_M))
    });
    report("the inference, without air", &|drop, found| {
        Some(Held::of(found.without_air.as_ref()?, drop.tape_m))
    });
    for (ball, drops) in &groups {
        let errors = drops
            .iter()
            .map(|(drop, found)| 100.0 * (found.of_two_flights_m / drop.tape_m - 1.0));
        println!(
            "| {ball} | g T1⁴/(8 T2²) | {} | | | | {:+.1} | {:.1} |",
            drops.len(),
            mean(errors.clone()),
            rms(errors)
        );
    }
    report("without the first impact, against flight 1", &|_, found| {
        found.without_first
    });
}

/// How far the heights lie above the tape, for each setting of the tape and each ball.
fn report_offsets(all: &[(&Measured, Found)]) {
    println!(
        "\n| ball | tape, cm | drops | above the tape, mm | standard error, mm | stated sd, mm |"
    );
    println!("|---|--:|--:|--:|--:|--:|");
    for (ball, drops) in by_ball(all) {
        if ball == "all" {
            break;
        }
        let mut tapes_m: Vec<f64> = drops.iter().map(|(drop, _)| drop.tape_m).collect();
        tapes_m.dedup();
        let settings: Vec<f64> = tapes_m
            .iter()
            .map(|&tape_m| {
                let of = drops
                    .iter()
                    .filter(|(drop, _)| drop.tape_m.total_cmp(&tape_m).is_eq());
                let of = of.filter_map(|(_, found)| found.with_air.as_ref());
                let above = of.clone().map(|height| 1e3 * (height.value - tape_m));
                let sds = of.map(|height| 1e3 * height.sd);
                let [offset, error] = mean_and_error(&above.clone().collect::<Vec<_>>());
                let (count, tape_cm, sd) = (above.count(), 100.0 * tape_m, rms(sds));
                println!(
                    "| {ball} | {tape_cm:.0} | {count} | {offset:+.1} | {error:.1} | {sd:.1} |"
                );
                offset
            })
            .collect();
        // The settings differ by more than their drops: each counts once.
        let [offset, error] = mean_and_error(&settings);
        println!(
            "| {ball} | all | {} | {offset:+.1} | {error:.1} | |",
            drops.len()
        );
    }
}

/// All drops of a ball as one study, the tape stated or not.
fn report_studies(all: &[(&Measured, Found)]) {
    println!(
        "\n| ball | tape | drops | named | restitution | between drops, % | zero of the tape, mm | in 95 % alone | in the study | \
         tape ± 2 mm | median sd alone, mm | in the study |"
    );
    println!("|---|---|--:|--:|---|---|---|--:|--:|--:|--:|--:|");
    for (ball, drops) in by_ball(all) {
        for (number, tape) in ["not stated", "stated"].into_iter().enumerate() {
            let of_tape = drops.iter().filter_map(|(drop, found)| {
                let (alone, evidence) = found.evidence[number].clone()?;
                Some((drop.tape_m, alone, evidence))
            });
            let of_tape: Vec<(f64, Estimate, CurveEvidence)> = of_tape.collect();
            let studied = of_tape.iter().map(|(_, _, evidence)| StudyDrop {
                evidence: evidence.clone(),
                scatter: None,
                levels: Vec::new(),
            });
            if ball != "all"
                && let Ok(study) = Study::of(&studied.collect::<Vec<_>>(), &Asked::default())
            {
                println!("| {ball} | {tape} | {} |", of_study(&study, &of_tape));
            }
        }
    }
}

/// The cells of a study of drops with their tapes and their heights by themselves.
fn of_study(study: &Study, drops: &[(f64, Estimate, CurveEvidence)]) -> String {
    let group = &study.groups[0];
    let heights = drops.iter().zip(&study.drops);
    let heights: Vec<(f64, Estimate, Estimate)> = heights
        .filter_map(|((tape_m, alone, _), drop)| Some((*tape_m, *alone, drop.as_ref()?.height_m?)))
        .collect();
    let percent = |is_in: &dyn Fn(&(f64, Estimate, Estimate)) -> bool| {
        100 * heights.iter().filter(|it| is_in(it)).count() / heights.len().max(1)
    };
    let median_mm = |sd: fn(&(f64, Estimate, Estimate)) -> f64| {
        1e3 * median(heights.iter().map(sd)).unwrap_or(f64::NAN)
    };
    let zero = study.ruler_zero_m.map_or(String::new(), |zero| {
        let [low, high] = zero.interval95.map(|end| 1e3 * end);
        format!("{:+.1} ({low:+.1} to {high:+.1})", 1e3 * zero.value)
    });
    let restitution = group.restitution.map_or(String::new(), |restitution| {
        let at = study.at_speed_m_s;
        format!(
            "{:.4} ± {:.4} at {at} m/s",
            restitution.value, restitution.sd
        )
    });
    let [low, high] = group.between_drops.interval95.map(|end| 100.0 * end);
    format!(
        "{} | {} | {restitution} | {:.2} ({low:.2} to {high:.2}) | {zero} | {} | {} | {} | {:.1} | {:.1}",
        group.count,
        study.outliers.len(),
        100.0 * group.between_drops.value,
        percent(&|(tape_m, alone, _)| Held::of(alone, *tape_m).in95),
        percent(&|(tape_m, _, studied)| Held::of(studied, *tape_m).in95),
        percent(&|(tape_m, _, studied)| Held::within(studied, *tape_m, RULER_SD_M).in95),
        median_mm(|(_, alone, _)| alone.sd),
        median_mm(|(_, _, studied)| studied.sd),
    )
}

/// The mean and its standard error by the scatter of the values.
fn mean_and_error(values: &[f64]) -> [f64; 2] {
    let (count, middle) = (values.len() as f64, mean(values.iter().copied()));
    let squares: f64 = values.iter().map(|value| (value - middle).powi(2)).sum();
    [middle, (squares / (count - 1.0) / count).sqrt()]
}

#[cfg(test)]
mod tests {
    use std::fmt::Write;

    use rand::SeedableRng;
    use rand_chacha::ChaCha8Rng;

    use super::*;
    use crate::independent::{BallOnSurface, KINDS};

    /// Simulated drops of table-tennis balls against a tape whose zero is 8 mm too high.
    #[test]
    fn a_tape_with_another_zero_is_told_from_wrong_times() {
        let mut rng = ChaCha8Rng::seed_from_u64(1);
        let mut table =
            "drop,ball,tape_height_cm,flight_1_s,flight_2_s,flight_3_s,flight_4_s,flight_5_s,\
                         flight_6_s,flight_7_s,flight_8_s"
                .to_owned();
        for number in 0..12 {
            let simulated = BallOnSurface::of(&KINDS[0], &mut rng);
            let events = simulated.impact_events(0.2, (9, 0.0), &mut rng);
            write!(table, "\n{number},table-tennis,19.2").unwrap();
            for pair in events.windows(2) {
                write!(table, ",{:.6}", pair[1].time_s - pair[0].time_s).unwrap();
            }
        }
        let drops = read(&table).unwrap();
        let all: Vec<Found> = drops.iter().map(|drop| found(drop).unwrap()).collect();
        let above_m = all
            .iter()
            .map(|it| it.with_air.unwrap().value - drops[0].tape_m);
        let above_m = mean(above_m);
        assert!((above_m - 0.008).abs() < 0.004, "{above_m}");
        let without_first = all.iter().map(|it| it.without_first.unwrap().z);
        assert!(
            rms(without_first.clone()) < 1.7,
            "{:?}",
            without_first.collect::<Vec<_>>()
        );
    }
}
