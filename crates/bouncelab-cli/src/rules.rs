//! `bouncelab rules`: which rules there are, and what each says.

use std::io::{self, Write};
use std::path::PathBuf;

use bouncelab::rulebook::{self, Averaging, Evenness, Limits, Requirement, Rule, Status};
use bouncelab_report::{Align, Table, rules};
use clap::{Args, Subcommand};

use crate::failure::Failure;

/// List the rules that verdicts know, or show one
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Arguments {
    #[command(subcommand)]
    what: What,
}

const EXAMPLES: &str = "\
Examples:
  bouncelab rules list
  bouncelab rules show itf-court
  bouncelab rules list --rules own.toml                 the format is in docs/rulebooks.md";

#[derive(Subcommand)]
enum What {
    /// One line for each rule
    List {
        #[command(flatten)]
        files: Files,
    },
    /// Everything about a rule
    Show {
        /// Its name
        #[arg(value_name = "RULE")]
        name: String,
        #[command(flatten)]
        files: Files,
    },
}

/// Rules of one's own.
#[derive(Args, Clone, Debug)]
pub(crate) struct Files {
    /// Rules of your own, beside those built in; the format is in docs/rulebooks.md
    #[arg(long, value_name = "FILE.toml")]
    rules: Vec<PathBuf>,
}

impl Files {
    /// The rules that are built in, and those of the files; a rule of a file replaces one of the same
    /// name.
    pub(crate) fn read(&self) -> Result<Vec<Rule>, Failure> {
        let mut all = rules::built_in()?;
        for path in &self.rules {
            let name = path.display().to_string();
            let text = std::fs::read_to_string(path).map_err(|reason| {
                Failure::Input(format!("cannot read the rules {name}: {reason}"))
            })?;
            for rule in rules::read(&text, &name)? {
                all.retain(|other| other.name != rule.name);
                all.push(rule);
            }
        }
        Ok(all)
    }
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let text = match &arguments.what {
        What::List { files } => list(&files.read()?).to_string(),
        What::Show { name, files } => show(rulebook::find(&files.read()?, name)?),
    };
    Ok(io::stdout().lock().write_all(text.as_bytes())?)
}

fn list(rules: &[Rule]) -> Table {
    let mut table = Table::new([
        ("rule", Align::Left),
        ("of", Align::Left),
        ("drop", Align::Right),
        ("wants", Align::Left),
        ("status", Align::Left),
    ]);
    for rule in rules {
        table.row([
            rule.name.clone(),
            rule.title.clone(),
            drop(rule),
            wanted_in_short(rule),
            rule.status.to_string(),
        ]);
    }
    table
}

/// The rule in full, one fact a line.
fn show(rule: &Rule) -> String {
    let mut text = format!("{}: {}\n", rule.name, rule.title);
    for (name, value) in facts(rule) {
        text.push_str("  ");
        text.push_str(&format_fact(name, &value));
        text.push('\n');
    }
    if rule.status == Status::Unverified {
        text.push_str("  This rule is unverified: nobody has read it in its source.\n");
    }
    text
}

/// Everything that a rule says, in words.
pub(crate) fn facts(rule: &Rule) -> Vec<(&'static str, String)> {
    let mut facts = vec![
        ("source", rule.source.clone()),
        (
            "edition",
            rule.edition
                .clone()
                .unwrap_or_else(|| "not noted".to_owned()),
        ),
        ("status", rule.status.to_string()),
    ];
    facts.extend(rule.ball.clone().map(|ball| ("ball", ball)));
    facts.extend(rule.surface.clone().map(|surface| ("surface", surface)));
    facts.push(("drop", drop(rule)));
    facts.push(("wants", wanted(rule)));
    let point = match rule.measured_at {
        Some(point) => format!("the {point} of the ball"),
        None => "not noted; the bottom of the ball is taken".to_owned(),
    };
    facts.push(("measured at", point));
    let averaged = match rule.averaging {
        Averaging::Mean => "their mean counts",
        Averaging::Each => "each must obey",
    };
    facts.push((
        "drops",
        format!("{} or more; {averaged}", rule.fewest_drops),
    ));
    facts.extend(even(rule).map(|even| ("places", even)));
    if !rule.temperature_k.is_open() {
        let celsius = rule.temperature_k.raised(-273.15);
        facts.push(("temperature", ends(&celsius, |end| format!("{end:.1} C"))));
    }
    if !rule.altitude_m.is_open() {
        facts.push(("altitude", ends(&rule.altitude_m, |end| format!("{end} m"))));
    }
    if let Some(formula) = &rule.formula {
        facts.push((
            "formula",
            format!(
                "H = {} (T - {})² in m and s, T from the first impact to the second ({})",
                formula.factor_m_s2, formula.offset_s, formula.status
            ),
        ));
    }
    facts.extend(rule.note.clone().map(|note| ("note", note)));
    facts
}

fn format_fact(name: &str, value: &str) -> String {
    format!("{name:<12} {value}")
}

/// From where the ball is dropped, in words.
pub(crate) fn drop(rule: &Rule) -> String {
    let Some(height_m) = rule.drop_height_m else {
        return "any height".to_owned();
    };
    let tolerance = rule
        .drop_tolerance_m
        .map_or_else(String::new, |tolerance| format!(" ± {}", length(tolerance)));
    let higher = if rule.or_higher { " or more" } else { "" };
    format!("{}{tolerance}{higher}", length(height_m))
}

/// What the rule wants of the rebound, in words.
pub(crate) fn wanted(rule: &Rule) -> String {
    let percent = |share: f64| format!("{} %", (share * 1e4).round() / 100.0);
    let wanted = match &rule.requirement {
        Requirement::Height(limits) => heights(limits),
        Requirement::About(height_m) => format!("about {}", length(*height_m)),
        Requirement::Share { limits, of } if limits.is_open() => format!("share of that on {of}"),
        Requirement::Share { limits, of } => format!("{} of that on {of}", ends(limits, percent)),
    };
    match even(rule) {
        Some(even) => format!("{wanted}; {even}"),
        None => wanted,
    }
}

fn wanted_in_short(rule: &Rule) -> String {
    match &rule.requirement {
        Requirement::Share { limits, .. } if limits.is_open() => "share of a reference".to_owned(),
        Requirement::Share { limits, .. } => {
            let percent = |share: f64| format!("{} %", (share * 1e4).round() / 100.0);
            format!("{} of a reference", ends(limits, percent))
        }
        _ => wanted(rule),
    }
}

fn even(rule: &Rule) -> Option<String> {
    let percent = |share: f64| (share * 1e4).round() / 100.0;
    Some(match rule.evenness? {
        Evenness::WithinOfMean(share) => {
            format!("each place within {} % of the mean", percent(share))
        }
        Evenness::Range(share) => format!("places at most {} points apart", percent(share)),
    })
}

/// Limits with the unit once.
fn heights(limits: &Limits) -> String {
    let words = ends(limits, |end| centimetres(end).to_string());
    if limits.is_open() {
        words
    } else {
        format!("{words} cm")
    }
}

fn ends(limits: &Limits, shown: impl Fn(f64) -> String) -> String {
    match (limits.least, limits.greatest) {
        (Some(least), Some(greatest)) => format!("{} to {}", shown(least), shown(greatest)),
        (Some(least), None) => format!("at least {}", shown(least)),
        (None, Some(greatest)) => format!("at most {}", shown(greatest)),
        (None, None) => "anything".to_owned(),
    }
}

/// A height of a rule, always in centimetres.
fn length(metres: f64) -> String {
    format!("{} cm", centimetres(metres))
}

fn centimetres(metres: f64) -> f64 {
    (metres * 1e4).round() / 100.0
}
