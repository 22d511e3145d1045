//! `bouncelab rules`: the known rules, and the contents of each.

use std::path::PathBuf;

use bouncelab::Plain;
use bouncelab::rulebook::{self, Averaging, Evenness, Limits, Point, Requirement, Rule, Status};
use bouncelab_report::{Align, Table, rules};
use clap::{Args, Subcommand};
use unicode_width::UnicodeWidthStr;

use crate::failure::Failure;
use crate::language::{text, text_with, translator};
use crate::terminal::print;

/// List the rules for verdicts, or show one
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
    /// List the rules, one per line
    List {
        #[command(flatten)]
        files: Files,
    },
    /// Show all of a rule
    Show {
        /// Name of the rule
        #[arg(value_name = "RULE")]
        name: String,
        #[command(flatten)]
        files: Files,
    },
}

/// Rules of one's own.
#[derive(Args, Clone, Debug)]
pub(crate) struct Files {
    /// A file with rules of your own, used besides those built in; see docs/rulebooks.md
    #[arg(long, value_name = "FILE.toml")]
    rules: Vec<PathBuf>,
}

impl Files {
    /// The files.
    pub(crate) fn paths(&self) -> &[PathBuf] {
        &self.rules
    }

    /// The rules that are built in, and those of the files; a rule of a file replaces one of the same
    /// name.
    pub(crate) fn read(&self) -> Result<Vec<Rule>, Failure> {
        Ok(rules::all(&self.rules)?)
    }
}

pub(crate) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let page = match &arguments.what {
        What::List { files } => list(&files.read()?).to_string(),
        What::Show { name, files } => {
            let name = String::from(Plain::of(name));
            show(rulebook::find(&files.read()?, &name)?)
        }
    };
    print(page)
}

fn list(rules: &[Rule]) -> Table {
    let mut table = Table::with_headings(
        translator(),
        [
            ("rule-title", Align::Left),
            ("rule-sport", Align::Left),
            ("rule-drop", Align::Right),
            ("rule-wants", Align::Left),
            ("rule-status", Align::Left),
        ],
    );
    for rule in rules {
        table.row([
            rule.name.clone(),
            rule.title.clone(),
            drop(rule),
            wanted_in_short(rule),
            status(rule.status),
        ]);
    }
    table
}

/// The rule in full, one fact a line.
fn show(rule: &Rule) -> String {
    let facts = facts(rule);
    let width = facts.iter().map(|(name, _)| name.width());
    let width = width.fold(12, usize::max);
    let mut lines = vec![format!("{}: {}", rule.name, rule.title)];
    lines.extend(facts.into_iter().map(|(name, value)| {
        let space = " ".repeat(width - name.width());
        format!("  {name}{space} {value}")
    }));
    if rule.status == Status::Unverified {
        lines.push(format!("  {}", text("rule-nobody-read")));
    }
    lines.join("\n") + "\n"
}

/// Everything that a rule says, in words.
pub(crate) fn facts(rule: &Rule) -> Vec<(String, String)> {
    let edition = rule.edition.clone();
    let mut facts = vec![
        ("rule-source", rule.source.clone()),
        (
            "rule-edition",
            edition.unwrap_or_else(|| text("rule-not-noted")),
        ),
        ("rule-status", status(rule.status)),
    ];
    facts.extend(rule.ball.clone().map(|ball| ("rule-ball", ball)));
    facts.extend(
        rule.surface
            .clone()
            .map(|surface| ("rule-surface", surface)),
    );
    facts.push(("rule-drop", drop(rule)));
    facts.push(("rule-wants", wanted(rule)));
    let measured_at = match rule.measured_at {
        Some(at) => text_with("rule-point", &[("point", point(at).into())]),
        None => text("rule-point-not-noted"),
    };
    facts.push(("rule-measured-at", measured_at));
    let averaged = match rule.averaging {
        Averaging::Mean => "rule-drops-mean",
        Averaging::Each => "rule-drops-each",
    };
    let count = [("count", rule.fewest_drops.into())];
    facts.push(("rule-drops", text_with(averaged, &count)));
    facts.extend(even(rule).map(|even| ("rule-places", even)));
    if !rule.temperature_k.is_open() {
        let celsius = rule.temperature_k.raised(-273.15);
        let shown = |end: f64| format!("{} °C", translator().fixed(end, 1));
        facts.push(("rule-temperature", ends(&celsius, shown)));
    }
    if !rule.altitude_m.is_open() {
        facts.push((
            "rule-altitude",
            ends(&rule.altitude_m, |end| format!("{end} m")),
        ));
    }
    if let Some(formula) = &rule.formula {
        let formula = [
            ("factor", formula.factor_m_s2.into()),
            ("offset", formula.offset_s.into()),
            ("status", status(formula.status).into()),
        ];
        facts.push(("rule-formula", text_with("rule-formula-text", &formula)));
    }
    facts.extend(rule.note.clone().map(|note| ("rule-note", note)));
    facts
        .into_iter()
        .map(|(id, fact)| (text(id), fact))
        .collect()
}

/// Whether somebody has read a rule in its source, in words.
pub(crate) fn status(status: Status) -> String {
    text(match status {
        Status::Verified => "rule-verified",
        Status::Unverified => "rule-unverified",
    })
}

/// A point of the ball, in words.
pub(crate) fn point(point: Point) -> String {
    text(match point {
        Point::Bottom => "rule-point-bottom",
        Point::Centre => "rule-point-centre",
        Point::Top => "rule-point-top",
    })
}

/// From where the ball is dropped, in words.
pub(crate) fn drop(rule: &Rule) -> String {
    let Some(height_m) = rule.drop_height_m else {
        return text("rule-any-height");
    };
    let tolerance = rule.drop_tolerance_m;
    let tolerance = tolerance.map_or_else(String::new, |end| format!(" ± {}", length(end)));
    let height = length(height_m) + &tolerance;
    if rule.or_higher {
        text_with("rule-or-more", &[("height", height.into())])
    } else {
        height
    }
}

/// What the rule wants of the rebound, in words.
pub(crate) fn wanted(rule: &Rule) -> String {
    let wanted = match &rule.requirement {
        Requirement::Height(limits) => heights(limits),
        Requirement::About(height_m) => {
            text_with("rule-about", &[("height", length(*height_m).into())])
        }
        Requirement::Share { limits, of } if limits.is_open() => {
            text_with("rule-share-of", &[("surface", of.as_str().into())])
        }
        Requirement::Share { limits, of } => text_with(
            "rule-limits-of",
            &[
                ("limits", ends(limits, percent).into()),
                ("surface", of.as_str().into()),
            ],
        ),
    };
    match even(rule) {
        Some(even) => format!("{wanted}; {even}"),
        None => wanted,
    }
}

fn wanted_in_short(rule: &Rule) -> String {
    match &rule.requirement {
        Requirement::Share { limits, .. } if limits.is_open() => text("rule-share-of-reference"),
        Requirement::Share { limits, .. } => {
            let limits = [("limits", ends(limits, percent).into())];
            text_with("rule-limits-of-reference", &limits)
        }
        _ => wanted(rule),
    }
}

fn even(rule: &Rule) -> Option<String> {
    let (id, share) = match rule.evenness? {
        Evenness::WithinOfMean(share) => ("rule-within-of-mean", share),
        Evenness::Range(share) => ("rule-places-apart", share),
    };
    Some(text_with(id, &[("share", hundredths(share).into())]))
}

/// Limits with the unit once.
fn heights(limits: &Limits) -> String {
    let words = ends(limits, |end| shown(hundredths(end)));
    if limits.is_open() {
        words
    } else {
        format!("{words} cm")
    }
}

fn ends(limits: &Limits, shown: impl Fn(f64) -> String) -> String {
    match (limits.least, limits.greatest) {
        (Some(least), Some(greatest)) => text_with(
            "interval-ends",
            &[
                ("low", shown(least).into()),
                ("high", shown(greatest).into()),
            ],
        ),
        (Some(least), None) => text_with("rule-at-least", &[("least", shown(least).into())]),
        (None, Some(greatest)) => {
            text_with("rule-at-most", &[("greatest", shown(greatest).into())])
        }
        (None, None) => text("verdict-anything"),
    }
}

fn percent(share: f64) -> String {
    format!("{} %", shown(hundredths(share)))
}

/// A height of a rule, always in centimetres.
fn length(metres: f64) -> String {
    format!("{} cm", shown(hundredths(metres)))
}

fn shown(value: f64) -> String {
    translator().number(&value.to_string())
}

/// A share in per cent, or metres in centimetres.
fn hundredths(value: f64) -> f64 {
    (value * 1e4).round() / 100.0
}
