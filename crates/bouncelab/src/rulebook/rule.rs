//! A rule: drop height, and limits of the rebound.

use std::fmt;

use std::ops::Bound::Excluded;

use crate::analysis::Options;
use crate::error::{Error, Quantity, Result, positive, within};

/// What was read of a rule or of a formula.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
pub enum Reading {
    /// The text of its publisher: only such a rule is verified.
    Primary,
    /// A text that cites it, or a copy of it.
    Secondary,
    /// None: it was written from memory, and nothing should rest on it.
    Memory,
}

impl fmt::Display for Reading {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Primary => "primary",
            Self::Secondary => "secondary",
            Self::Memory => "memory",
        })
    }
}

/// Where a rule stands, and what was read of it.
#[derive(Debug, Clone, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(deny_unknown_fields))]
pub struct Source {
    /// Who publishes it.
    pub publisher: String,
    /// The document.
    pub document: Option<String>,
    /// Its edition.
    pub edition: Option<String>,
    /// The clause in it.
    pub clause: Option<String>,
    /// Address of the text that was read.
    pub address: Option<String>,
    /// Date on which it was read, as in 2026-11-27.
    pub checked: Option<String>,
    /// What was read.
    pub read: Reading,
}

impl Source {
    /// A source of which only the publisher is known.
    pub fn new(publisher: &str, read: Reading) -> Self {
        Self {
            publisher: publisher.to_owned(),
            document: None,
            edition: None,
            clause: None,
            address: None,
            checked: None,
            read,
        }
    }

    /// Publisher, document, edition and clause.
    pub fn citation(&self) -> String {
        let parts = [&self.document, &self.edition, &self.clause];
        let parts = parts.into_iter().flatten();
        let parts: Vec<&str> = std::iter::once(&self.publisher)
            .chain(parts)
            .map(String::as_str)
            .collect();
        parts.join(", ")
    }
}

/// The point of the ball at which heights are measured.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "lowercase"))]
pub enum Point {
    /// The lowest point.
    Bottom,
    /// The middle.
    Centre,
    /// The highest point.
    Top,
}

impl Point {
    /// How far it lies above the lowest point of a ball, m.
    ///
    /// ```
    /// use bouncelab::rulebook::Point;
    ///
    /// assert_eq!(Point::Top.above_bottom_m(0.04), 0.04);
    /// ```
    pub fn above_bottom_m(self, diameter_m: f64) -> f64 {
        match self {
            Self::Bottom => 0.0,
            Self::Centre => diameter_m / 2.0,
            Self::Top => diameter_m,
        }
    }
}

impl fmt::Display for Point {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Bottom => "bottom",
            Self::Centre => "centre",
            Self::Top => "top",
        })
    }
}

/// The least and the greatest value that a rule allows; an end that is open allows anything.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Limits {
    /// The least.
    pub least: Option<f64>,
    /// The greatest.
    pub greatest: Option<f64>,
}

impl Limits {
    /// Both ends closed.
    ///
    /// ```
    /// let limits = bouncelab::rulebook::Limits::between(0.24, 0.26);
    /// assert!(limits.contain(0.25) && !limits.contain(0.27));
    /// ```
    pub const fn between(least: f64, greatest: f64) -> Self {
        Self {
            least: Some(least),
            greatest: Some(greatest),
        }
    }

    /// Only a least value.
    ///
    /// ```
    /// let limits = bouncelab::rulebook::Limits::at_least(0.9);
    /// assert!(limits.contain(2.0) && !limits.contain(0.89));
    /// ```
    pub const fn at_least(least: f64) -> Self {
        Self {
            least: Some(least),
            greatest: None,
        }
    }

    /// Whether a value is allowed.
    pub fn contain(&self, value: f64) -> bool {
        self.least.is_none_or(|least| value >= least)
            && self.greatest.is_none_or(|greatest| value <= greatest)
    }

    /// Whether anything is forbidden.
    pub const fn is_open(&self) -> bool {
        self.least.is_none() && self.greatest.is_none()
    }

    /// The limits of a value before it is rounded to a multiple of `step`: values that round to a limit are allowed.
    #[must_use]
    pub fn before_rounding(&self, step: f64) -> Self {
        Self {
            least: self.least.map(|end| end - step / 2.0),
            greatest: self.greatest.map(|end| end + step / 2.0),
        }
    }

    /// The limits moved up.
    #[must_use]
    pub fn raised(&self, by: f64) -> Self {
        Self {
            least: self.least.map(|end| end + by),
            greatest: self.greatest.map(|end| end + by),
        }
    }

    fn check(&self, quantity: Quantity) -> Result<()> {
        for end in [self.least, self.greatest].into_iter().flatten() {
            positive(quantity, end)?;
        }
        if let (Some(least), Some(greatest)) = (self.least, self.greatest) {
            within(quantity, least, ..greatest)?;
        }
        Ok(())
    }
}

/// What a rule wants of the rebound.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Requirement {
    /// A height, m, of the point at which the rule measures.
    Height(Limits),
    /// About a height, m, without saying how near: nobody can decide that.
    About(f64),
    /// A share of the rebound on a reference surface, 1 being the same height.
    Share {
        /// What is allowed; open if the rule only says how to measure.
        limits: Limits,
        /// The reference surface, in words.
        of: String,
    },
}

/// How alike places must be. A place is one recording.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Evenness {
    /// Each place within this share of the mean of all.
    WithinOfMean(f64),
    /// The highest share of the reference exceeds the lowest by at most so much.
    Range(f64),
}

impl Evenness {
    /// The greatest unevenness.
    pub const fn most(self) -> f64 {
        match self {
            Self::WithinOfMean(most) | Self::Range(most) => most,
        }
    }
}

/// Over what a rule averages.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Averaging {
    /// The mean over the drops must lie within the limits.
    #[default]
    Mean,
    /// Every drop must.
    Each,
}

/// A rule's own formula from the time T between first and second impact: factor (T - offset)².
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Formula {
    /// In m/s².
    pub factor_m_s2: f64,
    /// In seconds.
    pub offset_s: f64,
    /// What was read of it.
    pub read: Reading,
}

impl Formula {
    /// The rebound that it gives, m.
    ///
    /// ```
    /// use bouncelab::rulebook::{Formula, Reading};
    ///
    /// let formula = Formula { factor_m_s2: 1.23, offset_s: 0.025, read: Reading::Memory };
    /// assert_eq!(format!("{:.2} m", formula.rebound_m(1.0)), "1.17 m");
    /// ```
    pub fn rebound_m(&self, time_s: f64) -> f64 {
        self.factor_m_s2 * (time_s - self.offset_s).powi(2)
    }
}

/// A rule.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Rule {
    /// The name by which it is called: lower-case letters, digits and hyphens.
    pub name: String,
    /// What it is about, in a few words.
    pub title: String,
    /// Where it stands.
    pub source: Source,
    /// What else to know.
    pub note: Option<String>,
    /// The preset of its ball ([`crate::ball::preset`]), if there is one.
    pub ball: Option<String>,
    /// What the ball falls on, in words.
    pub surface: Option<String>,
    /// Height of release, m, of the point at which the rule measures; `None` if any will do.
    pub drop_height_m: Option<f64>,
    /// How far the release may be off, m, either way.
    pub drop_tolerance_m: Option<f64>,
    /// Whether the ball may be dropped from higher too.
    pub or_higher: bool,
    /// Where heights are measured; if the rule does not say, the lowest point is taken.
    pub measured_at: Option<Point>,
    /// What it wants.
    pub requirement: Requirement,
    /// How alike places must be.
    pub evenness: Option<Evenness>,
    /// How many drops it takes: in each place, if it compares places, and on the reference.
    pub fewest_drops: usize,
    /// How many places it takes.
    pub fewest_places: usize,
    /// Over what it averages.
    pub averaging: Averaging,
    /// Air temperatures at which it holds, K.
    pub temperature_k: Limits,
    /// Relative humidity of the air at which it holds, 0 to 1.
    pub humidity: Limits,
    /// Heights above the sea at which it holds, m.
    pub altitude_m: Limits,
    /// How ball and surface are prepared, in words.
    pub conditioning: Option<String>,
    /// Its own formula for the rebound from a time. Without one the rule measures the height itself, and it
    /// follows from the time by the physics of the flight.
    pub formula: Option<Formula>,
    /// The result is rounded to a multiple of this before it is compared with the limits: m, or a share.
    pub rounding: Option<f64>,
}

impl Rule {
    /// A rule that wants nothing yet, of a single drop.
    ///
    /// ```
    /// use bouncelab::rulebook::{Limits, Requirement, Rule};
    ///
    /// let rule = Rule {
    ///     requirement: Requirement::Height(Limits::between(0.24, 0.26)),
    ///     ..Rule::new("ittf-ball", "Table-tennis ball", 0.305)
    /// };
    /// assert!(rule.check().is_ok() && !rule.needs_reference());
    /// ```
    pub fn new(name: &str, title: &str, drop_height_m: f64) -> Self {
        Self {
            name: name.to_owned(),
            title: title.to_owned(),
            source: Source::new("one's own", Reading::Memory),
            note: None,
            ball: None,
            surface: None,
            drop_height_m: Some(drop_height_m),
            drop_tolerance_m: None,
            or_higher: false,
            measured_at: None,
            requirement: Requirement::Height(Limits::default()),
            evenness: None,
            fewest_drops: 1,
            fewest_places: 1,
            averaging: Averaging::Mean,
            temperature_k: Limits::default(),
            humidity: Limits::default(),
            altitude_m: Limits::default(),
            conditioning: None,
            formula: None,
            rounding: None,
        }
    }

    /// Where it measures.
    pub fn point(&self) -> Point {
        self.measured_at.unwrap_or(Point::Bottom)
    }

    /// The fall of the lowest point of a ball, m, after which its rebound counts; `dropped_m` is that
    /// from which it was dropped, if it was measured. `None` if neither says.
    ///
    /// ```
    /// use bouncelab::rulebook::{Point, Rule};
    ///
    /// // Released with its top at 2.54 m, a tennis ball of 6.6 cm falls 2.474 m.
    /// let rule = Rule { measured_at: Some(Point::Top), ..Rule::new("a", "A rule", 2.54) };
    /// assert_eq!(rule.fall_m(0.066, None), Some(2.54 - 0.066));
    /// ```
    pub fn fall_m(&self, diameter_m: f64, dropped_m: Option<f64>) -> Option<f64> {
        let Some(height_m) = self.drop_height_m else {
            return dropped_m;
        };
        let fall_m = height_m - self.point().above_bottom_m(diameter_m);
        match dropped_m {
            Some(dropped_m) if self.or_higher => Some(fall_m.max(dropped_m)),
            _ => Some(fall_m),
        }
    }

    /// The same, by settings.
    pub(super) fn fall_of(&self, settings: &Options) -> Option<f64> {
        let dropped_m = settings.priors.drop_height_m.map(|height| height.value);
        self.fall_m(settings.ball.diameter_m(), dropped_m)
    }

    /// Whether it compares two surfaces.
    pub const fn needs_reference(&self) -> bool {
        matches!(self.requirement, Requirement::Share { .. })
    }

    /// The limits that it sets, of heights (m) or of shares, before rounding; open without any.
    pub fn limits(&self) -> Limits {
        match &self.requirement {
            Requirement::Height(limits) | Requirement::Share { limits, .. } => {
                limits.before_rounding(self.rounding.unwrap_or(0.0))
            }
            Requirement::About(_) => Limits::default(),
        }
    }

    /// Whether it makes sense.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a height, limit or share that no ball game has; mostly a unit is
    /// wrong.
    pub fn check(&self) -> Result<()> {
        let drop_height_m = self.drop_height_m.unwrap_or(1.0);
        within(Quantity::Height, drop_height_m, 0.01..=20.0)?;
        if let Some(tolerance) = self.drop_tolerance_m {
            let below = Excluded(drop_height_m / 2.0);
            within(Quantity::HeightTolerance, tolerance, (Excluded(0.0), below))?;
        }
        self.check_requirement()?;
        if self.averaging == Averaging::Each && self.needs_reference() {
            return Err(Error::EachOfReference);
        }
        self.temperature_k.check(Quantity::AirTemperature)?;
        self.humidity.check(Quantity::Humidity)?;
        self.altitude_m.check(Quantity::Altitude)?;
        if let Some(Evenness::WithinOfMean(share) | Evenness::Range(share)) = self.evenness {
            within(Quantity::Evenness, share, (Excluded(0.0), Excluded(1.0)))?;
        }
        if let Some(formula) = self.formula {
            positive(Quantity::FormulaFactor, formula.factor_m_s2)?;
            within(Quantity::FormulaOffset, formula.offset_s, 0.0..1.0)?;
        }
        if let Some(step) = self.rounding {
            within(Quantity::Rounding, step, (Excluded(0.0), Excluded(0.1)))?;
        }
        within(Quantity::Places, self.fewest_places as f64, 1.0..=1000.0)?;
        within(Quantity::Drops, self.fewest_drops as f64, 1.0..=1000.0).map(drop)
    }

    fn check_requirement(&self) -> Result<()> {
        let below_drop = |end| match self.drop_height_m {
            Some(height_m) => within(Quantity::Rebound, end, ..height_m).map(drop),
            None => Ok(()),
        };
        match &self.requirement {
            Requirement::Height(limits) => {
                limits.check(Quantity::Rebound)?;
                let ends = [limits.least, limits.greatest];
                ends.into_iter().flatten().try_for_each(below_drop)
            }
            Requirement::About(height_m) => below_drop(positive(Quantity::Rebound, *height_m)?),
            Requirement::Share { limits, .. } => {
                limits.check(Quantity::ReferenceShare)?;
                for end in [limits.least, limits.greatest].into_iter().flatten() {
                    within(Quantity::ReferenceShare, end, ..=2.0)?;
                }
                Ok(())
            }
        }
    }
}

/// The rule with a name.
///
/// # Errors
/// [`Error::UnknownName`] if no rule has this name; it states the nearest name among those of the rules.
///
/// ```
/// use bouncelab::rulebook::{self, Rule};
///
/// let rules = [Rule::new("ittf-ball", "Table-tennis ball", 0.305)];
/// assert_eq!(rulebook::find(&rules, "ittf-ball")?.title, "Table-tennis ball");
/// assert!(rulebook::find(&rules, "itf-ball").is_err());
/// # Ok::<(), bouncelab::Error>(())
/// ```
pub fn find<'a>(rules: &'a [Rule], name: &str) -> Result<&'a Rule> {
    rules.iter().find(|rule| rule.name == name).ok_or_else(|| {
        let known: Vec<&str> = rules.iter().map(|rule| rule.name.as_str()).collect();
        Error::unknown_name("rule", name, &known)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn heights_are_converted_to_the_lowest_point() {
        let rule = Rule {
            measured_at: Some(Point::Top),
            ..Rule::new("pickleball", "", 1.98)
        };
        assert!((rule.fall_m(0.074, Some(1.0)).unwrap() - 1.906).abs() < 1e-12);
        assert!((Point::Centre.above_bottom_m(0.04) - 0.02).abs() < 1e-15);
    }

    #[test]
    fn where_a_rule_leaves_it_open_the_own_height_counts() {
        let or_higher = Rule {
            or_higher: true,
            ..Rule::new("itf-court", "", 1.27)
        };
        assert_eq!(or_higher.fall_m(0.066, Some(1.5)), Some(1.5));
        assert_eq!(or_higher.fall_m(0.066, Some(1.0)), Some(1.27));
        assert_eq!(or_higher.fall_m(0.066, None), Some(1.27));
        let any = Rule {
            drop_height_m: None,
            ..or_higher
        };
        assert_eq!(any.fall_m(0.066, Some(1.0)), Some(1.0));
        assert_eq!(any.fall_m(0.066, None), None);
    }

    #[test]
    fn a_wrong_unit_is_questioned() {
        let message = Rule::new("a", "", 30.5).check().unwrap_err().to_string();
        assert_eq!(
            message,
            "height is 30.5 m; it must be at least 0.01 and at most 20"
        );
        let rule = Rule {
            requirement: Requirement::Height(Limits::between(24.0, 26.0)),
            ..Rule::new("a", "", 0.305)
        };
        assert!(rule.check().is_err());
        let rule = Rule {
            requirement: Requirement::Share {
                limits: Limits::at_least(80.0),
                of: "concrete".to_owned(),
            },
            ..Rule::new("a", "", 0.305)
        };
        let message = rule.check().unwrap_err().to_string();
        assert!(
            message.starts_with("reference share is 80; it must be"),
            "{message}"
        );
    }

    #[test]
    fn an_unknown_rule_offers_the_nearest() {
        let rules = [
            Rule::new("itf-tennis", "", 2.54),
            Rule::new("fiba", "", 1.8),
        ];
        assert_eq!(find(&rules, "fiba").unwrap().name, "fiba");
        let message = find(&rules, "itf-tenis").unwrap_err().to_string();
        assert!(message.contains("nearest is \"itf-tennis\""), "{message}");
    }
}
