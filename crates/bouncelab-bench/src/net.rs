//! The net: every number of many results, to prove that a change only moves code.
//!
//! The results are those of simulated drops, of which only the times are given, and of sound files. Each
//! number is one line, its name and all of its digits; the order and the names are the same in each run,
//! on any number of cores.

use std::collections::BTreeMap;
use std::error::Error;
use std::fmt::Write as _;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use bouncelab::Impact;
use bouncelab::analysis::{
    self, Drop, DropTask, Options, Recording, analyze_impacts, impacts_of_times,
};
use bouncelab::ball;
use bouncelab::drag::{DragLaw, DragTable};
use bouncelab::inference::{ApexTarget, Measured, UNKNOWN};
use bouncelab::restitution::LawKind;
use bouncelab_audio::Input;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;
use serde::Serialize;
use serde_json::Value;

use crate::scenario::{self, MAX_IMPACTS, Scenario};
use crate::{Result, seeded};

/// How many drops the tests compare with the stored copy.
const STORED_DROPS: usize = 200;

/// `net [drops=1000] [sounds=FOLDER]... [out=FILE] [compare=FILE] [store=FILE]`
///
/// Every number of simulated drops and of the sounds in these folders, and in that of `BOUNCELAB_RECORDINGS`; or how they
/// differ from those that `out` wrote earlier. `store` writes the copy that the tests compare with.
///
/// # Errors
///
/// If an argument is unknown, a file cannot be read or written, or a number differs.
pub fn run(arguments: &[String]) -> Result {
    let mut drops = 1000;
    let (mut out, mut compare, mut store) = (None, None, None);
    let recordings = std::env::var("BOUNCELAB_RECORDINGS");
    let mut folders: Vec<String> = recordings.into_iter().collect();
    for argument in arguments {
        match argument.split_once('=') {
            Some(("drops", count)) => drops = count.parse()?,
            Some(("sounds", folder)) => folders.push(folder.to_owned()),
            Some(("out", file)) => out = Some(file),
            Some(("compare", file)) => compare = Some(file),
            Some(("store", file)) => store = Some(file),
            _ => {
                return Err(format!(
                    "unknown argument '{argument}'; known are drops=N, sounds=FOLDER, out=FILE, compare=FILE, store=FILE"
                )
                .into());
            }
        }
    }
    if let Some(file) = store {
        let table = stored_table(&numbers_of_drops(STORED_DROPS));
        return Ok(fs::write(file, table)?);
    }
    let mut numbers = numbers_of_drops(drops);
    for folder in folders {
        numbers.extend(numbers_of_folder(Path::new(&folder))?);
    }
    let numbers: Vec<Number> = numbers.concat();
    let text = text(&numbers);
    if let Some(file) = out {
        fs::write(file, &text)?;
    }
    match compare {
        Some(file) => match difference(&fs::read_to_string(file)?, &text) {
            None => println!("net: same"),
            Some(difference) => return Err(difference.into()),
        },
        None if out.is_none() => print!("{text}"),
        None => {}
    }
    Ok(())
}

/// A number of a result.
#[derive(Clone, Debug, PartialEq)]
pub struct Number {
    /// Which number of which result.
    pub name: String,
    /// The number, in SI units.
    pub value: f64,
}

/// The numbers of one result, which are collected.
struct Numbers {
    result: String,
    list: Vec<Number>,
}

impl Numbers {
    fn of(result: String) -> Self {
        let list = Vec::new();
        Self { result, list }
    }

    fn add(&mut self, name: impl AsRef<str>, value: impl Into<Option<f64>>) {
        if let Some(value) = value.into() {
            let name = format!("{} {}", self.result, name.as_ref());
            self.list.push(Number { name, value });
        }
    }

    fn count(&mut self, name: impl AsRef<str>, count: usize) {
        self.add(name, count as f64);
    }

    /// All numbers in the JSON of a result, each named by its path; a text, as the code of a diagnostic or the name of a
    /// law, stands in the name of a 1.
    fn json(&mut self, path: &str, value: &Value) {
        match value {
            Value::Null => {}
            Value::Bool(is_so) => self.count(path, usize::from(*is_so)),
            Value::Number(number) => self.add(path, number.as_f64()),
            Value::String(text) => self.count(format!("{path} {text}"), 1),
            Value::Array(values) => {
                for (place, value) in values.iter().enumerate() {
                    self.json(&format!("{path} {place}"), value);
                }
            }
            Value::Object(fields) => {
                for (field, value) in fields {
                    self.json(format!("{path} {field}").trim_start(), value);
                }
            }
        }
    }

    /// The sum of many numbers, each with a factor of its own, so that none can change unnoticed.
    fn sum(&mut self, name: &str, values: &[f64]) {
        let weighted = (1..)
            .zip(values)
            .map(|(place, value)| f64::from(place) * value);
        self.count(format!("{name} count"), values.len());
        self.add(format!("{name} sum"), weighted.sum::<f64>());
    }

    /// What the JSON of a drop leaves out.
    fn not_in_json(&mut self, drop: &Drop) {
        if let Ok(fit) = &drop.log_linear_fit {
            self.sum("fit residuals", &fit.residuals);
        }
        if let Ok(per_impact) = &drop.per_impact {
            let gradients = per_impact.impacts.iter().map(|it| it.log_gradient_per_s);
            let gradients: Vec<f64> = gradients.flatten().collect();
            self.sum("gradients of each impact", &gradients);
        }
        let Ok(posterior) = &drop.posterior else {
            return;
        };
        self.add("log evidence", posterior.log_evidence);
        self.sum("draws restitution", &posterior.draws.restitution);
        self.sum("draws drag coefficient", &posterior.draws.drag_coefficient);
        self.sum("draws drop height", &posterior.draws.drop_height_m);
        self.sum("draws total time", &posterior.draws.total_time_s);
        self.sum("fitted speeds", &posterior.fitted_speeds_m_s);
        let readings = posterior
            .evidence()
            .map_or_else(Vec::new, |evidence| evidence.readings);
        let values: Vec<f64> = readings.iter().map(|reading| reading.value).collect();
        self.sum("readings of the curve", &values);
        self.sum("rebounds", &posterior.rebounds_m(0.305));
    }
}

/// Of the drops without a setting, every drop with such an index is compared with all preset balls, which takes
/// ten inferences.
const BALL_COMPARISON: usize = 5;

/// The impacts of a simulated drop and the settings with which they are analysed, by the index of the
/// drop: scenarios, balls, numbers of impacts and settings change from drop to drop.
fn simulated(index: usize) -> (String, Vec<Impact>, Options) {
    let count = Scenario::ALL.len();
    let (scenario, round) = (Scenario::ALL[index % count], index / count);
    let balls = ball::presets();
    let ball = if round.is_multiple_of(2) {
        &balls[0]
    } else {
        &balls[index % balls.len()]
    };
    let max_impacts = [MAX_IMPACTS, 12, MAX_IMPACTS, 6, 25, 4, 16, 3][(round / 2) % 8];
    let mut options = scenario.stated(Options::new(ball));
    let seeds = (0..).map(|attempt| (index + attempt * 1_000_000) as u64);
    let drop = seeds
        .map(ChaCha8Rng::seed_from_u64)
        .find_map(|mut rng| scenario::Drop::drawn(scenario, max_impacts, &options, &mut rng));
    let drop = drop.expect("seeds do not end");
    let mut inference = seeded(index as u64);
    let mut impacts = impacts_of_times(&drop.times_s);
    match round % 9 {
        1 => {
            // As the detector gives them.
            let detected = drop.times_s.iter().zip(&drop.numbers);
            impacts = detected
                .map(|(&time_s, &number)| Impact::new(number, time_s).with_time_sd_s(5e-5))
                .collect();
        }
        2 => {
            options.priors.drop_height_m = Some(Measured {
                value: drop.height_m,
                sd: 0.002,
            });
            inference.at_speed_m_s = Some(1.0);
        }
        3 => {
            // The release is given, and the first impact is missing where there are enough others.
            options.priors.release_s = Some(Measured {
                value: -drop.fall_s,
                sd: 0.005,
            });
            if impacts.len() > 5 {
                impacts = analysis::renumbered(impacts.split_off(1));
            }
        }
        4 => options.priors.restitution_laws = vec![LawKind::ALL[round % LawKind::ALL.len()]],
        5 => {
            let felt = [(1e3, 0.5), (1e4, 0.45), (1e5, 0.5)];
            options.environment.drag = DragLaw::Table(DragTable::new(&felt).expect("three points"));
            options.flights = Some(1..=4);
            let (bounce, apex_m) = (1, 0.3);
            inference.reach = vec![ApexTarget { bounce, apex_m }];
        }
        6 => {
            options.priors.gravity_rel_sd = UNKNOWN;
            options.priors.first_was_detected = true;
        }
        7 => options.environment.drag = DragLaw::None,
        8 => inference.each_impact = false,
        _ => options.compares_balls = index.is_multiple_of(BALL_COMPARISON),
    }
    options.inference = Some(inference);
    (scenario.name().to_owned(), impacts, options)
}

/// The numbers of a simulated drop, by its index.
fn numbers_of_drop(index: usize) -> Vec<Number> {
    let (scenario, impacts, options) = simulated(index);
    let mut numbers = Numbers::of(format!("drop {index:04} {scenario}"));
    let drop = analyze_impacts(impacts, &options);
    numbers.json("", &json(&drop));
    numbers.not_in_json(&drop);
    numbers.list
}

fn json(result: &impl Serialize) -> Value {
    serde_json::to_value(result).expect("results are plain data")
}

/// The numbers of the first simulated drops, each drop with its own.
pub fn numbers_of_drops(count: usize) -> Vec<Vec<Number>> {
    (0..count).into_par_iter().map(numbers_of_drop).collect()
}

/// The numbers of every file of a folder, in the order of their names; one that cannot be read has one that
/// says so.
fn numbers_of_folder(folder: &Path) -> io::Result<Vec<Vec<Number>>> {
    let entries: io::Result<Vec<_>> = fs::read_dir(folder)?.collect();
    let mut paths: Vec<PathBuf> = entries?.into_iter().map(|entry| entry.path()).collect();
    paths.retain(|path| path.is_file());
    paths.sort();
    Ok(paths.par_iter().map(|path| numbers_of_file(path)).collect())
}

fn numbers_of_file(path: &Path) -> Vec<Number> {
    let [file, folder] = [path, path.parent().unwrap_or(path)]
        .map(|path| path.file_name().unwrap_or_default().to_string_lossy());
    let name = format!("file {folder}/{file}");
    let mut numbers = Numbers::of(name.clone());
    let Ok(recording) = analyzed(path) else {
        numbers.count("not read", 1);
        return numbers.list;
    };
    numbers.json("", &json(&recording));
    for (place, drop) in recording.drops.iter().enumerate() {
        let mut of_drop = Numbers::of(format!("{name} drop {place}"));
        of_drop.not_in_json(drop);
        numbers.list.append(&mut of_drop.list);
    }
    numbers.list
}

fn analyzed(path: &Path) -> Result<Recording> {
    let input = Input::open(path)?;
    let plan = input.plan::<Box<dyn Error + Send + Sync>>(&Options::default(), |_| Ok(()))?;
    let drops = plan.tasks().par_iter().map(DropTask::run).collect();
    Ok(plan.finish(drops))
}

/// The numbers of the stored copy.
const STORED: [&str; 16] = [
    "posterior restitution value",
    "posterior restitution sd",
    "posterior restitution interval95 0",
    "posterior restitution interval95 1",
    "posterior drop_height_m value",
    "posterior drop_height_m sd",
    "posterior drop_height_m interval95 0",
    "posterior drop_height_m interval95 1",
    "posterior drag_coefficient value",
    "posterior drag_coefficient sd",
    "posterior restitution_scatter value",
    "posterior timing_s value",
    "posterior total_time_s value",
    "log evidence",
    "per_impact restitution value",
    "log_linear_fit restitution value",
];

/// A table of a few numbers of each drop, as CSV, which the tests compare with another run; a number that a drop does
/// not have is empty.
pub fn stored_table(drops: &[Vec<Number>]) -> String {
    let rows = drops.iter().enumerate().map(|(index, numbers)| {
        let cells = STORED.map(|wanted| {
            let mut numbers = numbers.iter();
            let number = numbers.find(|number| {
                // The number follows the name of the result: "drop", its index and its scenario.
                number.name.splitn(4, ' ').nth(3) == Some(wanted)
            });
            number.map_or(String::new(), |number| format!("{:?}", number.value))
        });
        format!("{index},{}\n", cells.join(","))
    });
    let rows: String = rows.collect();
    format!("drop,{}\n{rows}", STORED.join(","))
}

/// A line for each number: its name, a tab, and the shortest digits that mean this number alone.
fn text<'a>(numbers: impl IntoIterator<Item = &'a Number>) -> String {
    let mut text = String::new();
    for Number { name, value } in numbers {
        let _ = writeln!(text, "{name}\t{value:?}");
    }
    text
}

/// What differs between the texts of two runs: how many lines, the first of them, and the largest relative
/// difference of a number; `None` if the texts are the same byte for byte.
fn difference(before: &str, after: &str) -> Option<String> {
    const MAX_SHOWN: usize = 10;
    if before == after {
        return None;
    }
    let by_name = |text| -> BTreeMap<&str, &str> {
        let lines = str::lines(text);
        lines.filter_map(|line| line.rsplit_once('\t')).collect()
    };
    let [old, new] = [before, after].map(by_name);
    let changed = old.iter().filter_map(|(name, value)| {
        let now = new.get(name).copied().unwrap_or("none");
        (now != *value).then_some((*name, *value, now))
    });
    let added = new.iter().filter(|(name, _)| !old.contains_key(*name));
    let mut differences: Vec<(&str, &str, &str)> = changed.collect();
    differences.extend(added.map(|(name, value)| (*name, "none", *value)));
    let largest = differences.iter().filter_map(|(_, before, after)| {
        let (before, after) = (before.parse().ok()?, after.parse().ok()?);
        Some(relative_difference(before, after))
    });
    let largest = largest.fold(0.0, f64::max);
    let mut text = format!(
        "{} of {} numbers differ, at most by {largest:.1e} of their value:",
        differences.len(),
        new.len()
    );
    for (name, before, after) in differences.iter().take(MAX_SHOWN) {
        let _ = write!(text, "\n  {name}: {before} -> {after}");
    }
    Some(text)
}

/// The difference of two numbers as a share of the larger one; infinite if only one is finite.
pub fn relative_difference(a: f64, b: f64) -> f64 {
    if a.total_cmp(&b).is_eq() || a.is_nan() && b.is_nan() {
        return 0.0;
    }
    let share = (a - b).abs() / a.abs().max(b.abs()).max(f64::MIN_POSITIVE);
    if share.is_finite() {
        share
    } else {
        f64::INFINITY
    }
}
