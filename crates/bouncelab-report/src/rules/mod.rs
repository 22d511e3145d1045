//! Rules as files: those built in and those of users.
//!
//! The format is TOML, `bouncelab.rules/2`; docs/rulebooks.md describes it.
//!
//! ```
//! use bouncelab_report::rules;
//!
//! let own = r#"
//!     schema = "bouncelab.rules/2"
//!     [[rule]]
//!     name = "our-hall"
//!     title = "Basketball in our hall"
//!     source = { publisher = "the school", read = "primary" }
//!     drop = { height = "1.8m" }
//!     rebound = { least = "1m", most = "1.1m" }
//! "#;
//! let rules = rules::read(own, "own.toml")?;
//! assert_eq!(rules[0].drop_height_m, Some(1.8));
//! assert!(rules::built_in()?.iter().any(|rule| rule.name == "fiba-basketball"));
//! # Ok::<(), bouncelab_report::Error>(())
//! ```

pub mod words;

use std::collections::BTreeSet;
use std::ops::Range;
#[cfg(not(target_family = "wasm"))]
use std::path::PathBuf;

use bouncelab::Plain;
use bouncelab::rulebook::{
    Averaging, Evenness, Formula, Limits, Point, Reading, Requirement, Rule, Source,
};
use serde::Deserialize;
use serde::de::{Deserializer, Error as _};
use toml::Spanned;

use crate::error::{Error, Result};
use crate::units;

/// Name and version of the format.
pub const SCHEMA: &str = "bouncelab.rules/2";

/// No file of TOML is longer: in memory it takes many times as much.
pub const MAX_MB: u64 = 2;

/// The built-in files.
const BUILT_IN: [(&str, &str); 5] = [
    (
        "table-tennis.toml",
        include_str!("../../rules/table-tennis.toml"),
    ),
    ("tennis.toml", include_str!("../../rules/tennis.toml")),
    ("football.toml", include_str!("../../rules/football.toml")),
    ("courts.toml", include_str!("../../rules/courts.toml")),
    ("floors.toml", include_str!("../../rules/floors.toml")),
];

/// A file with one rule to fill in.
pub const TEMPLATE: &str = include_str!("../../rules/template.toml");

/// The rules that come with bouncelab.
///
/// # Errors
///
/// None; the tests read them all.
pub fn built_in() -> Result<Vec<Rule>> {
    let mut rules = Vec::new();
    for (file, text) in BUILT_IN {
        rules.extend(read(text, file)?);
    }
    Ok(rules)
}

/// The rules that are built in, and those of files; a rule of a file replaces one of the same name.
///
/// # Errors
///
/// [`Error::Unreadable`] for a file that cannot be read, and those of [`read`].
#[cfg(not(target_family = "wasm"))]
pub fn all(files: &[PathBuf]) -> Result<Vec<Rule>> {
    let mut all = built_in()?;
    for path in files {
        let file = String::from(bouncelab::Plain::path(path));
        let bytes = crate::file::read_noted(path, MAX_MB);
        let text = bytes.and_then(|bytes| String::from_utf8(bytes).map_err(std::io::Error::other));
        let text = text.map_err(|source| Error::Unreadable {
            file: file.clone(),
            source,
        })?;
        let rules = read(&text, &file)?;
        let names: BTreeSet<&str> = rules.iter().map(|rule| rule.name.as_str()).collect();
        all.retain(|other| !names.contains(other.name.as_str()));
        all.extend(rules);
    }
    Ok(all)
}

/// The rules of a file.
///
/// # Errors
///
/// [`Error::Rules`] with line and column for what is no TOML, no rule, or no sense.
pub fn read(text: &str, file: &str) -> Result<Vec<Rule>> {
    let wrong = |span: Option<Range<usize>>, problem: String| {
        let (line, column) = line_and_column(text, span.map_or(0, |span| span.start));
        Error::Rules {
            file: file.to_owned(),
            line,
            column,
            problem,
        }
    };
    let book: Book = toml::from_str(text)
        .map_err(|error| wrong(error.span(), error.message().trim().to_owned()))?;
    if book.schema.get_ref() != SCHEMA {
        let problem = format!("the schema must be \"{SCHEMA}\"");
        return Err(wrong(Some(book.schema.span()), problem));
    }
    let mut rules = Vec::with_capacity(book.rule.len());
    let mut names = BTreeSet::new();
    for entry in book.rule {
        let span = entry.span();
        let rule = entry
            .into_inner()
            .rule()
            .and_then(|rule| match rule.check() {
                Ok(()) => Ok(rule),
                Err(refusal) => Err(format!("rule \"{}\": {refusal}", rule.name)),
            })
            .map_err(|problem| wrong(Some(span.clone()), problem))?;
        if !names.insert(rule.name.clone()) {
            let problem = format!("the name \"{}\" is there twice", rule.name);
            return Err(wrong(Some(span), problem));
        }
        rules.push(rule);
    }
    Ok(rules)
}

/// Line and column of a byte, both from 1.
fn line_and_column(text: &str, byte: usize) -> (usize, usize) {
    let before = text.get(..byte).unwrap_or(text);
    let line_start = before.rfind('\n').map_or(0, |end| end + 1);
    let line = before.matches('\n').count() + 1;
    (line, before[line_start..].chars().count() + 1)
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Book {
    schema: Spanned<String>,
    #[serde(default)]
    rule: Vec<Spanned<Entry>>,
}

/// A rule as it is written.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Entry {
    name: String,
    title: String,
    source: Source,
    note: Option<String>,
    ball: Option<String>,
    surface: Option<String>,
    drop: DropWritten,
    measured_at: Option<Point>,
    rebound: Option<ReboundWritten>,
    share: Option<ShareWritten>,
    even: Option<EvenWritten>,
    drops: Option<usize>,
    places: Option<usize>,
    averaged: Option<AveragedWritten>,
    conditioning: Option<String>,
    temperature: Option<Between<Temperature>>,
    humidity: Option<Between<Share>>,
    altitude: Option<Between<Length>>,
    formula: Option<FormulaWritten>,
    rounded: Option<RoundedWritten>,
}

/// A length of a rule of heights, a share of one that compares.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RoundedWritten {
    height: Option<Length>,
    share: Option<Share>,
}

#[derive(Deserialize, Clone, Copy)]
#[serde(rename_all = "lowercase")]
enum AveragedWritten {
    Mean,
    Each,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct DropWritten {
    height: Option<Length>,
    tolerance: Option<Length>,
    #[serde(default)]
    or_higher: bool,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ReboundWritten {
    least: Option<Length>,
    most: Option<Length>,
    about: Option<Length>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ShareWritten {
    of: String,
    least: Option<Share>,
    most: Option<Share>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct EvenWritten {
    within: Option<Share>,
    range: Option<Share>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Between<T> {
    least: Option<T>,
    most: Option<T>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct FormulaWritten {
    factor: f64,
    offset: Time,
    read: Reading,
}

/// A quantity written with its unit.
macro_rules! written {
    ($($name:ident by $reader:path),+ $(,)?) => {$(
        #[derive(Clone, Copy)]
        struct $name(f64);

        impl<'de> Deserialize<'de> for $name {
            fn deserialize<D: Deserializer<'de>>(from: D) -> std::result::Result<Self, D::Error> {
                let text = String::deserialize(from)?;
                $reader(&text).map(Self).map_err(D::Error::custom)
            }
        }
    )+};
}

written! {
    Length by units::length,
    Time by units::time,
    Share by units::share,
    Temperature by units::temperature,
}

impl Entry {
    fn rule(self) -> std::result::Result<Rule, String> {
        let named = self
            .name
            .chars()
            .all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-');
        if self.name.is_empty() || !named {
            return Err(format!(
                "\"{}\" is no name of a rule: use lower-case letters, digits and hyphens",
                self.name
            ));
        }
        // A break of a line in a text is a space in it.
        let plain = |text: String| String::from(Plain::of(&text.replace('\n', " ")));
        Ok(Rule {
            requirement: self.requirement(plain)?,
            evenness: self.evenness()?,
            rounding: self.rounding()?,
            source: Source {
                publisher: plain(self.source.publisher),
                document: self.source.document.map(plain),
                edition: self.source.edition.map(plain),
                clause: self.source.clause.map(plain),
                address: self.source.address.map(plain),
                checked: self.source.checked.map(plain),
                read: self.source.read,
            },
            note: self.note.map(plain),
            ball: self.ball.map(plain),
            surface: self.surface.map(plain),
            drop_tolerance_m: self.drop.tolerance.map(|length| length.0),
            or_higher: self.drop.or_higher,
            measured_at: self.measured_at,
            fewest_drops: self.drops.unwrap_or(1),
            fewest_places: self.places.unwrap_or(1),
            conditioning: self.conditioning.map(plain),
            humidity: limits(self.humidity, |share| share.0),
            averaging: match self.averaged {
                Some(AveragedWritten::Each) => Averaging::Each,
                _ => Averaging::Mean,
            },
            temperature_k: limits(self.temperature, |temperature| temperature.0),
            altitude_m: limits(self.altitude, |length| length.0),
            formula: self.formula.map(|formula| Formula {
                factor_m_s2: formula.factor,
                offset_s: formula.offset.0,
                read: formula.read,
            }),
            drop_height_m: self.drop.height.map(|length| length.0),
            name: self.name,
            title: plain(self.title),
        })
    }

    fn requirement(
        &self,
        plain: impl Fn(String) -> String,
    ) -> std::result::Result<Requirement, String> {
        const EITHER: &str =
            "a rule wants a rebound or a share of a reference: write one of the two";
        match (&self.rebound, &self.share) {
            (Some(rebound), None) => match (rebound.about, rebound.least, rebound.most) {
                (Some(height), None, None) => Ok(Requirement::About(height.0)),
                (None, least, most) => Ok(Requirement::Height(Limits {
                    least: least.map(|length| length.0),
                    greatest: most.map(|length| length.0),
                })),
                _ => Err("a rebound is about a height or within limits, not both".to_owned()),
            },
            (None, Some(share)) => Ok(Requirement::Share {
                limits: Limits {
                    least: share.least.map(|share| share.0),
                    greatest: share.most.map(|share| share.0),
                },
                of: plain(share.of.clone()),
            }),
            _ => Err(EITHER.to_owned()),
        }
    }

    fn rounding(&self) -> std::result::Result<Option<f64>, String> {
        match (&self.rounded, &self.share) {
            (None, _) => Ok(None),
            (
                Some(RoundedWritten {
                    height: Some(step),
                    share: None,
                }),
                None,
            ) => Ok(Some(step.0)),
            (
                Some(RoundedWritten {
                    height: None,
                    share: Some(step),
                }),
                Some(_),
            ) => Ok(Some(step.0)),
            _ => Err(
                "a rule of heights rounds a height, one that compares rounds a share".to_owned(),
            ),
        }
    }

    fn evenness(&self) -> std::result::Result<Option<Evenness>, String> {
        let Some(even) = &self.even else {
            return Ok(None);
        };
        match (even.within, even.range, &self.share) {
            (Some(share), None, _) => Ok(Some(Evenness::WithinOfMean(share.0))),
            (None, Some(share), Some(_)) => Ok(Some(Evenness::Range(share.0))),
            (None, Some(_), None) => {
                Err("a range is one of shares, and this rule has no reference".to_owned())
            }
            _ => Err("places are even within a share of their mean or by a range".to_owned()),
        }
    }
}

fn limits<T>(between: Option<Between<T>>, value: impl Fn(T) -> f64) -> Limits {
    between.map_or_else(Limits::default, |between| Limits {
        least: between.least.map(&value),
        greatest: between.most.map(&value),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refused(text: &str) -> String {
        read(text, "own.toml").unwrap_err().to_string()
    }

    fn book(rule: &str) -> String {
        format!("schema = \"{SCHEMA}\"\n[[rule]]\n{rule}")
    }

    const COMMON: &str = "name = \"a\"\ntitle = \"A\"\n\n\
        source = { publisher = \"us\", read = \"primary\" }\n";

    #[test]
    fn the_built_in_rules_are_read_and_their_balls_exist() {
        let rules = built_in().unwrap();
        for rule in &rules {
            rule.check().unwrap();
            let same = rules.iter().filter(|other| other.name == rule.name);
            assert_eq!(same.count(), 1, "{}", rule.name);
            if let Some(ball) = &rule.ball {
                bouncelab::ball::preset(ball).unwrap();
            }
        }
    }

    /// The numbers of the rules for a racquetball: 100 in to 68 to 72 in, at 70 to 74 F.
    #[test]
    fn the_template_is_a_rule() {
        let rules = read(TEMPLATE, "template.toml").unwrap();
        assert_eq!(rules.len(), 1);
        assert!(rules[0].conditioning.is_some() && rules[0].rounding == Some(0.001));
    }

    #[test]
    fn units_become_si() {
        let rules = built_in().unwrap();
        let rule = bouncelab::rulebook::find(&rules, "racquetball").unwrap();
        assert_eq!(rule.drop_height_m, Some(2.54));
        let Requirement::Height(limits) = &rule.requirement else {
            panic!("a height is wanted");
        };
        assert!((limits.least.unwrap() - 1.7272).abs() < 1e-12);
        assert!((rule.temperature_k.greatest.unwrap() - 296.483_333).abs() < 1e-5);
    }

    #[test]
    fn what_is_wrong_is_said_with_line_and_column() {
        let no_toml = refused("schema = \"bouncelab.rules/2\"\n[[rule]\n");
        assert!(
            no_toml.starts_with("own.toml, line 2, column "),
            "{no_toml}"
        );
        let unit = refused(&book(&format!(
            "{COMMON}drop = {{ height = \"3kg\" }}\nrebound = {{ least = \"1m\" }}"
        )));
        assert!(unit.starts_with("own.toml, line 7, column "), "{unit}");
        assert!(unit.contains("\"kg\" is not a unit for this"), "{unit}");
        let word = refused(&book(&format!("{COMMON}hight = \"1m\"\n")));
        assert!(word.starts_with("own.toml, line 7, column 1"), "{word}");
        assert!(word.contains("hight"), "{word}");
        let schema = refused("schema = \"other\"");
        assert!(schema.contains("line 1, column 10"), "{schema}");
    }

    #[test]
    fn what_makes_no_sense_is_refused() {
        let of = |rest: &str| refused(&book(&format!("{COMMON}{rest}")));
        let wrong_unit = of("drop = { height = \"30.5m\" }\nrebound = { least = \"24cm\" }");
        assert!(
            wrong_unit.contains("height is 30.5 m; it must be"),
            "{wrong_unit}"
        );
        assert!(of("drop = { height = \"30cm\" }").contains("rebound or a share"));
        assert!(
            of("drop = {}\nrebound = { least = \"1m\" }\neven = { range = \"10%\" }")
                .contains("no reference")
        );
        let twice = book(&format!(
            "{COMMON}drop = {{}}\nrebound = {{}}\n[[rule]]\n{COMMON}drop = {{}}\nrebound = {{}}"
        ));
        assert!(refused(&twice).contains("twice"));
    }
}
