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

use bouncelab::analysis::{
    self, Drop, DropTask, Options, Recording, analyze_impacts, impacts_of_times,
};
use bouncelab::ball;
use bouncelab::drag::{DragLaw, DragTable};
use bouncelab::inference::{ApexTarget, Measured, Posterior, UNKNOWN};
use bouncelab::restitution::LawKind;
use bouncelab::{Diagnostic, Estimate, Impact};
use bouncelab_audio::Input;
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

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

    fn estimate(&mut self, name: &str, estimate: impl Into<Option<Estimate>>) {
        let Some(estimate) = estimate.into() else {
            return;
        };
        self.add(format!("{name} value"), estimate.value);
        self.add(format!("{name} sd"), estimate.sd);
        for (interval, [low, high]) in [("68", estimate.interval68), ("95", estimate.interval95)] {
            self.add(format!("{name} {interval} low"), low);
            self.add(format!("{name} {interval} high"), high);
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

    /// Which diagnostics there are, in their order.
    fn diagnostics<'a>(
        &mut self,
        name: &str,
        diagnostics: impl IntoIterator<Item = &'a Diagnostic>,
    ) {
        for (place, diagnostic) in diagnostics.into_iter().enumerate() {
            self.count(format!("{name} {place} {}", diagnostic.code), 1);
        }
    }

    fn drop(&mut self, drop: &Drop) {
        self.add("probability", drop.probability);
        for (place, impact) in drop.impacts.iter().enumerate() {
            self.count(format!("impact {place} number"), impact.number);
            self.add(format!("impact {place} time"), impact.time_s);
            self.add(format!("impact {place} time sd"), impact.time_sd_s);
            self.add(format!("impact {place} probability"), impact.probability);
            self.add(format!("impact {place} level"), impact.level_db);
        }
        for flight in &drop.flights {
            let name = format!("flight {}", flight.number);
            self.add(format!("{name} time"), flight.flight_time_s);
            self.count(format!("{name} in fit"), usize::from(flight.in_fit));
            self.add(
                format!("{name} drag-free height"),
                flight.drag_free_height_m,
            );
            self.add(format!("{name} apex"), flight.apex_m);
            self.add(format!("{name} apex sd"), flight.apex_sd_m);
            self.add(format!("{name} launch speed"), flight.launch_speed_m_s);
        }
        if let Ok(fit) = &drop.log_linear_fit {
            self.count("fit flights", fit.flights);
            self.estimate("fit slope", fit.slope);
            self.estimate("fit intercept", fit.intercept);
            self.add("fit r squared", fit.r_squared);
            self.estimate("fit restitution", fit.restitution);
            self.estimate("fit drop height", fit.drop_height_m);
            self.estimate("fit energy kept", fit.energy_kept);
            self.estimate("fit total time", fit.total_time_s);
            self.estimate("fit total path", fit.total_path_m);
            self.sum("fit residuals", &fit.residuals);
        }
        if let Ok(per_impact) = &drop.per_impact {
            self.estimate("per impact restitution", per_impact.restitution);
            for impact in &per_impact.impacts {
                let name = format!("per impact {}", impact.number);
                self.add(format!("{name} speed"), impact.impact_speed_m_s);
                self.estimate(&format!("{name} restitution"), impact.restitution);
                self.add(
                    format!("{name} flight time ratio"),
                    impact.flight_time_ratio,
                );
                self.sum(&format!("{name} gradient"), &impact.log_gradient_per_s);
            }
        }
        match &drop.posterior {
            Ok(posterior) => self.posterior(posterior),
            Err(_) => self.count("no posterior", 1),
        }
        for ball in &drop.balls {
            let name = format!("ball {}", ball.ball);
            self.add(format!("{name} log bayes factor"), ball.log_bayes_factor);
            self.estimate(&format!("{name} restitution"), ball.restitution);
            self.estimate(&format!("{name} drop height"), ball.drop_height_m);
        }
        self.diagnostics("diagnostic", &drop.diagnostics);
    }

    fn posterior(&mut self, posterior: &Posterior) {
        self.add("at speed", posterior.at_speed_m_s);
        self.estimate("restitution", posterior.restitution);
        self.add("first speed", posterior.first_speed_m_s);
        self.estimate("energy kept", posterior.energy_kept);
        self.add("round speed", posterior.round_speed_m_s);
        self.estimate("round speed restitution", posterior.round_speed_restitution);
        self.estimate("restitution slope", posterior.restitution_slope);
        self.estimate("drop height", posterior.drop_height_m);
        self.estimate("drag coefficient", posterior.drag_coefficient);
        self.add("drag reynolds", posterior.drag_reynolds);
        if let Some(prior) = posterior.drag_coefficient_prior {
            self.add("drag coefficient prior value", prior.value);
            self.add("drag coefficient prior sd", prior.sd);
        }
        self.estimate("terminal speed", posterior.terminal_speed_m_s);
        self.estimate("gravity", posterior.gravity_m_s2);
        self.estimate("restitution scatter", posterior.restitution_scatter);
        self.estimate("timing", posterior.timing_s);
        self.estimate("contact time", posterior.contact_time_s);
        self.estimate("total time", posterior.total_time_s);
        self.estimate("total path", posterior.total_path_m);
        for (count, share) in posterior.missed_first_impacts.iter().flatten().enumerate() {
            self.add(format!("missed first impacts {count}"), *share);
        }
        for prediction in &posterior.predictions {
            let name = format!("prediction {}", prediction.target.bounce);
            self.estimate(&name, prediction.drop_height_m);
        }
        for impact in &posterior.impacts {
            let name = format!("posterior impact {}", impact.number);
            self.estimate(&format!("{name} speed"), impact.impact_speed_m_s);
            self.estimate(&format!("{name} restitution"), impact.restitution);
            self.estimate(&format!("{name} apex"), impact.apex_m);
            self.estimate(&format!("{name} to surface"), impact.lost_to_surface_j);
            self.estimate(&format!("{name} to air"), impact.lost_to_air_j);
            self.add(format!("{name} residual"), impact.standardised_residual);
            self.add(format!("{name} weight"), impact.weight);
        }
        for model in &posterior.models {
            let name = format!(
                "model {} {}",
                model.restitution_law,
                model.ball.unwrap_or_default()
            );
            self.add(format!("{name} probability"), model.probability);
            self.add(format!("{name} log evidence"), model.log_odds);
            self.estimate(&format!("{name} restitution"), model.restitution);
            self.estimate(&format!("{name} drop height"), model.drop_height_m);
        }
        self.add("log evidence", posterior.log_evidence);
        for contraction in &posterior.prior_contraction {
            let name = format!("remaining {}", contraction.unknown.name());
            self.add(name, contraction.remaining);
        }
        let correlations = &posterior.correlations;
        for (quantity, row) in correlations.quantities.iter().zip(&correlations.matrix) {
            for (other, value) in correlations.quantities.iter().zip(row) {
                self.add(format!("correlation {quantity} {other}"), *value);
            }
        }
        let budgets = [
            ("restitution", &posterior.budget.restitution),
            ("drop height", &posterior.budget.drop_height_m),
        ];
        for (quantity, budget) in budgets {
            for share in budget {
                let name = format!("budget {quantity} {}", share.source);
                self.add(format!("{name} sd"), share.sd);
                self.add(format!("{name} share"), share.share);
            }
        }
        self.sum("draws restitution", &posterior.draws.restitution);
        self.sum("draws drag coefficient", &posterior.draws.drag_coefficient);
        self.sum("draws drop height", &posterior.draws.drop_height_m);
        self.sum("draws total time", &posterior.draws.total_time_s);
        self.add("effective draws", posterior.sampling.effective_draws);
        self.add("pareto shape", posterior.sampling.pareto_shape);
        for (place, point) in posterior.band.iter().enumerate() {
            self.add(format!("band {place} speed"), point.speed_m_s);
            self.estimate(&format!("band {place} restitution"), point.restitution);
        }
        let [slowest, fastest] = posterior.fitted_speeds_m_s;
        self.add("slowest fitted speed", slowest);
        self.add("fastest fitted speed", fastest);
        let readings = posterior
            .evidence()
            .map_or_else(Vec::new, |evidence| evidence.readings);
        let values: Vec<f64> = readings.iter().map(|reading| reading.value).collect();
        self.sum("readings of the curve", &values);
        self.sum("rebounds", &posterior.rebounds_m(0.305));
        self.diagnostics("posterior diagnostic", &posterior.diagnostics);
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
    numbers.drop(&analyze_impacts(impacts, &options));
    numbers.list
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
    numbers.count("drops", recording.drops.len());
    if let Some(band) = recording.strongest_band {
        numbers.add("strongest band low", band.low_hz);
        numbers.add("strongest band high", band.high_hz);
        numbers.add("strongest band level", band.above_background_db);
    }
    numbers.diagnostics("no drop", recording.no_drop.iter());
    numbers.diagnostics("diagnostic", &recording.diagnostics);
    for (place, drop) in recording.drops.iter().enumerate() {
        let mut of_drop = Numbers::of(format!("{name} drop {place}"));
        of_drop.drop(drop);
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
    "restitution value",
    "restitution sd",
    "restitution 95 low",
    "restitution 95 high",
    "drop height value",
    "drop height sd",
    "drop height 95 low",
    "drop height 95 high",
    "drag coefficient value",
    "drag coefficient sd",
    "restitution scatter value",
    "timing value",
    "total time value",
    "log evidence",
    "per impact restitution value",
    "fit restitution value",
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
