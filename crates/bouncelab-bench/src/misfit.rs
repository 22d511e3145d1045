//! Calibration of the whole analysis where its model, or what is stated of a drop, is not exactly true.
//!
//! Drops of every [`Scenario`] and of every [`Stated`] are analysed as a front end does: do the intervals still hold the
//! truth, and where they do not, does a warning say so?
//!
//! ```text
//! cargo xtask calibrate scenarios 300
//! ```
//!
//! prints `docs/tables/scenarios.txt`; the argument is the number of drops for each scenario,
//! and names of scenarios after it leave out all others. Names of restitution laws leave out the others of those.
//! With `impacts=4` no drop has more impacts than that.

use bouncelab::analysis::{Drop, Recording};
use bouncelab::diagnostic::Severity;
use bouncelab::inference::Posterior;
use bouncelab::restitution::LawKind;
use bouncelab::settings::Settings;
use bouncelab::{Diagnostic, Options, analyze, analyze_times};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;

use crate::held::{Held, mean, median, percent};
use crate::independent::SAMPLE_RATE_HZ;
use crate::scenario::{self, MAX_IMPACTS, Scenario};
use crate::stated::Stated;
use crate::{Result, of_seeds, seeded};

/// What is asked: the restitution at the first impact, which no flight shows, and in the middle of the speeds detected, the
/// drop height, and the time until rest.
const QUANTITIES: [&str; 4] = ["e", "e in the middle", "h0", "time until rest"];

/// A drop to be analysed, and the truth.
pub(crate) struct Case {
    pub(crate) observed: Observed,
    pub(crate) options: Options,
    pub(crate) truth: Truth,
}

/// What is known of its impacts.
pub(crate) enum Observed {
    /// Their times, s.
    Times(Vec<f64>),
    /// Their sound.
    Sound(Vec<f32>),
}

/// What is to be found.
pub(crate) struct Truth {
    /// Restitution at an impact speed, m/s.
    pub(crate) restitution: Box<dyn Fn(f64) -> f64>,
    /// The geometric mean of the fastest and the slowest impact detected, m/s.
    pub(crate) middle_m_s: f64,
    /// Drop height, m.
    pub(crate) height_m: f64,
    /// From the release until rest, s, if it comes to rest and is asked.
    pub(crate) rest_s: Option<f64>,
    /// Numbers of the impacts detected, 1 for the first, if they are asked.
    pub(crate) numbers: Option<Vec<usize>>,
}

/// A scenario of either kind, by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Row {
    /// The model is not exactly true.
    Misfit(Scenario),
    /// What is stated is not.
    Stated(Stated),
}

impl Row {
    /// Every one.
    pub fn all() -> Vec<Self> {
        let misfits = Scenario::ALL.map(Self::Misfit);
        misfits
            .into_iter()
            .chain(Stated::ALL.map(Self::Stated))
            .collect()
    }

    /// Its name, as in arguments and tables.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Misfit(scenario) => scenario.name(),
            Self::Stated(stated) => stated.name(),
        }
    }

    fn drawn(self, max_impacts: usize, rng: &mut ChaCha8Rng) -> Option<Case> {
        match self {
            Self::Misfit(scenario) => {
                let options = Settings::of_ball("table-tennis-40").resolve().ok()?.options;
                let drop = scenario::Drop::drawn(scenario, max_impacts, &options, rng)?;
                Some(drop.case(scenario.stated(options)))
            }
            Self::Stated(stated) => stated.drawn(rng),
        }
    }
}

/// How one drop fared.
#[derive(Clone, Debug, Default)]
pub struct Fared {
    /// Of e at the first impact and in the middle, drop height, and time until rest; `None` where nothing is stated, or asked.
    pub of: [Option<Held>; QUANTITIES.len()],
    /// Whether the impacts have their numbers.
    pub numbered: bool,
    /// The codes of the warnings.
    pub warnings: Vec<&'static str>,
}

impl Fared {
    fn of(case: &Case) -> Self {
        let result = match &case.observed {
            Observed::Times(times_s) => Ok(analyze_times(times_s, &case.options)),
            Observed::Sound(samples) => analyze(samples, SAMPLE_RATE_HZ, &case.options),
        };
        let Ok(Recording {
            drops, diagnostics, ..
        }) = result
        else {
            return Self::default();
        };
        // That of the most impacts is the one that was simulated.
        let Some(drop) = drops.iter().max_by_key(|drop| drop.impacts.len()) else {
            return Self::default();
        };
        let said = diagnostics.iter().chain(&drop.diagnostics);
        let is_warning = |said: &&Diagnostic| said.severity == Severity::Warning;
        Self {
            of: drop
                .posterior
                .as_ref()
                .map_or_else(|_| Default::default(), |it| holds(&case.truth, it)),
            numbered: is_numbered(drop, &case.truth),
            warnings: said.filter(is_warning).map(|it| it.code.name()).collect(),
        }
    }
}

fn is_numbered(drop: &Drop, truth: &Truth) -> bool {
    let numbers = drop.impacts.iter().map(|impact| impact.number);
    truth
        .numbers
        .as_ref()
        .is_none_or(|expected| numbers.eq(expected.iter().copied()))
}

fn holds(truth: &Truth, posterior: &Posterior) -> [Option<Held>; QUANTITIES.len()] {
    let middle = posterior.restitution_at(truth.middle_m_s);
    let rest = posterior.total_time_s.zip(truth.rest_s);
    [
        Some(Held::of(
            &posterior.restitution,
            (truth.restitution)(posterior.at_speed_m_s),
        )),
        middle.map(|middle| Held::of(&middle, (truth.restitution)(truth.middle_m_s))),
        Some(Held::of(&posterior.drop_height_m, truth.height_m)),
        rest.map(|(estimate, rest_s)| Held::of(&estimate, rest_s)),
    ]
}

/// Drops of a scenario, on all cores.
pub fn fared(row: Row, laws: &[LawKind], drops: usize, max_impacts: usize) -> Vec<Fared> {
    of_seeds(drops, |seed| {
        let mut rng = ChaCha8Rng::seed_from_u64(seed);
        let mut case = row.drawn(max_impacts, &mut rng)?;
        case.options.priors.restitution_laws = laws.to_vec();
        case.options.inference = Some(seeded(seed));
        Some(Fared::of(&case))
    })
}

/// A row for each quantity that is asked.
fn report(name: &str, all: &[Fared]) {
    for (place, quantity) in QUANTITIES.iter().enumerate() {
        let held: Vec<Held> = all.iter().filter_map(|fared| fared.of[place]).collect();
        if held.is_empty() && *quantity == "time until rest" {
            continue;
        }
        let share = |count: usize, of: usize| 100.0 * count as f64 / of as f64;
        let sd = median(held.iter().map(|held| held.relative_sd));
        let mean_z = mean(held.iter().map(|held| held.z));
        let is_silent = |fared: &&Fared| {
            fared.warnings.is_empty() && fared.of[place].is_some_and(|held| !held.in95)
        };
        println!(
            "| {name} | {} | {quantity} | {:.1} | {:.1} | {mean_z:.2} | {:.2} | {} | {} | {:.1} | {:.1} |",
            all.len(),
            percent(&held, |held| held.in68),
            percent(&held, |held| held.in95),
            100.0 * sd.unwrap_or(f64::NAN),
            all.len() - held.len(),
            all.iter().filter(|fared| !fared.numbered).count(),
            share(
                all.iter()
                    .filter(|fared| !fared.warnings.is_empty())
                    .count(),
                all.len()
            ),
            share(all.iter().filter(is_silent).count(), all.len()),
        );
    }
}

/// Prints how often each warning was given.
fn report_warnings(name: &str, all: &[Fared]) {
    let mut codes: Vec<&str> = all
        .iter()
        .flat_map(|fared| fared.warnings.iter().copied())
        .collect();
    codes.sort_unstable();
    codes.dedup();
    let said = codes.iter().map(|code| {
        let count = all
            .iter()
            .filter(|fared| fared.warnings.contains(code))
            .count();
        format!("{code} {count}")
    });
    eprintln!("{name}: {}", said.collect::<Vec<_>>().join(", "));
}

/// Prints the table, and which warnings were given to the standard error.
///
/// # Errors
///
/// If a word is neither a number nor the name of a scenario or a law.
pub(crate) fn run(arguments: &[String]) -> Result {
    let drops = arguments.iter().find_map(|word| word.parse().ok());
    let max_impacts = arguments
        .iter()
        .find_map(|word| word.strip_prefix("impacts=")?.parse().ok())
        .unwrap_or(MAX_IMPACTS);
    let laws: Vec<LawKind> = arguments.iter().filter_map(|w| w.parse().ok()).collect();
    let mut rows = Row::all();
    let is_known = |word: &String| {
        let is_law = word.parse::<LawKind>().is_ok();
        let is_count = word.starts_with("impacts=") || word.parse::<usize>().is_ok();
        is_law || is_count || rows.iter().any(|row| word == row.name())
    };
    if let Some(word) = arguments.iter().find(|word| !is_known(word)) {
        return Err(format!("'{word}' is neither a number nor a scenario nor a law").into());
    }
    let is_named = |row: &Row| arguments.iter().any(|word| word == row.name());
    if rows.iter().any(is_named) {
        rows.retain(is_named);
    }
    println!(
        "| scenario | drops | quantity | % in 68 | % in 95 | mean deviation, sd | median sd, % | no answer | \
         misnumbered | % warned | % outside 95 without a warning |"
    );
    println!("|---|---|---|---|---|---|---|---|---|---|---|");
    for row in rows {
        let all = fared(row, &laws, drops.unwrap_or(300), max_impacts);
        report(row.name(), &all);
        report_warnings(row.name(), &all);
    }
    Ok(())
}
