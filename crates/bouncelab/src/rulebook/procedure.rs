//! What the procedure of a rule asks for besides a height, and whether it is shown to be kept.

use std::fmt;

use super::rule::{Evenness, Limits, Requirement, Rule};
use crate::error::{Error, Result};
use crate::inference::Measured;

/// A part of a procedure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Item {
    /// The height of release.
    Release,
    /// The surface on which a ball is tested.
    Surface,
    /// The surface with which another is compared.
    Reference,
    /// Temperature of the air.
    Temperature,
    /// Relative humidity.
    Humidity,
    /// Height above the sea.
    Altitude,
    /// How ball and surface are prepared.
    Conditioning,
    /// Number of drops.
    Drops,
    /// Number of drops on the reference.
    ReferenceDrops,
    /// Number of places.
    Places,
}

impl Item {
    /// Those that neither a recording nor a setting shows: a person states that they were kept.
    pub const STATED: [Self; 3] = [Self::Surface, Self::Reference, Self::Conditioning];

    /// Its name in data.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Release => "release",
            Self::Surface => "surface",
            Self::Reference => "reference",
            Self::Temperature => "temperature",
            Self::Humidity => "humidity",
            Self::Altitude => "altitude",
            Self::Conditioning => "conditioning",
            Self::Drops => "drops",
            Self::ReferenceDrops => "reference-drops",
            Self::Places => "places",
        }
    }

    /// The one of [`STATED`](Self::STATED) with this name.
    ///
    /// # Errors
    /// [`Error::UnknownName`] with the names that there are.
    pub fn stated(name: &str) -> Result<Self> {
        let found = Self::STATED.into_iter().find(|item| item.name() == name);
        found.ok_or_else(|| Error::unknown_name("item", name, &Self::STATED.map(Self::name)))
    }
}

impl fmt::Display for Item {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// Whether a part of a procedure was kept.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Kept {
    /// Yes.
    Yes,
    /// No.
    No,
    /// Neither recording nor notes show it.
    NotShown,
}

impl Kept {
    /// Its name in data.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Yes => "kept",
            Self::No => "not-kept",
            Self::NotShown => "not-shown",
        }
    }
}

/// A part of a procedure, and whether it was kept.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Check {
    /// The part.
    pub item: Item,
    /// Whether it was kept.
    pub kept: Kept,
    /// What was found, in SI units, where it is a number.
    pub found: Option<f64>,
}

/// What is known of the circumstances of the drops, as far as rules ask; nothing is assumed.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Conditions {
    /// Height of the lowest point of the ball at release, m.
    pub drop_height_m: Option<Measured>,
    /// Temperature of the air, K.
    pub temperature_k: Option<f64>,
    /// Relative humidity, 0 to 1.
    pub relative_humidity: Option<f64>,
    /// Height above the sea, m.
    pub altitude_m: Option<f64>,
    /// What a person states to have been kept.
    pub kept: Vec<Item>,
}

/// The parts of the procedure of a rule; of surface and reference the number of drops in each place.
pub(super) fn checks(
    rule: &Rule,
    diameter_m: f64,
    conditions: &Conditions,
    drops: &[Vec<usize>; 2],
) -> Vec<Check> {
    let mut checks = vec![release(rule, diameter_m, conditions.drop_height_m)];
    let stated = |item: Item, asked: bool| {
        let kept = if conditions.kept.contains(&item) {
            Kept::Yes
        } else {
            Kept::NotShown
        };
        asked.then_some(Check {
            item,
            kept,
            found: None,
        })
    };
    let compares = matches!(rule.requirement, Requirement::Share { .. });
    checks.extend(stated(Item::Surface, !compares && rule.surface.is_some()));
    checks.extend(stated(Item::Reference, compares));
    checks.extend(stated(Item::Conditioning, rule.conditioning.is_some()));
    let ranges = [
        (
            Item::Temperature,
            rule.temperature_k,
            conditions.temperature_k,
        ),
        (Item::Humidity, rule.humidity, conditions.relative_humidity),
        (Item::Altitude, rule.altitude_m, conditions.altitude_m),
    ];
    let ranges = ranges
        .into_iter()
        .filter(|(_, limits, _)| !limits.is_open());
    checks.extend(ranges.map(|(item, limits, found)| range(item, &limits, found)));
    checks.extend(counts(rule, drops));
    checks
}

/// A height within the tolerance of the rule, or within the uncertainty with which it was measured.
fn release(rule: &Rule, diameter_m: f64, stated: Option<Measured>) -> Check {
    let kept = match (stated, rule.fall_m(diameter_m, None)) {
        (None, _) => Kept::NotShown,
        (Some(_), None) => Kept::Yes,
        (Some(stated), Some(fall_m)) => {
            let tolerance_m = rule.drop_tolerance_m.unwrap_or(0.0).max(2.0 * stated.sd);
            let above_m = stated.value - fall_m;
            yes(above_m >= -tolerance_m && (rule.or_higher || above_m <= tolerance_m))
        }
    };
    let found = stated.map(|height| height.value);
    Check {
        item: Item::Release,
        kept,
        found,
    }
}

fn range(item: Item, limits: &Limits, found: Option<f64>) -> Check {
    let kept = found.map_or(Kept::NotShown, |value| yes(limits.contain(value)));
    Check { item, kept, found }
}

fn counts(rule: &Rule, [surface, reference]: &[Vec<usize>; 2]) -> Vec<Check> {
    let by_place = rule.compares_places();
    let drops = if by_place {
        surface.iter().copied().min().unwrap_or(0)
    } else {
        surface.iter().sum()
    };
    let check = |item, found: usize, needed: usize| Check {
        item,
        kept: yes(found >= needed),
        found: Some(found as f64),
    };
    let mut checks = vec![check(Item::Drops, drops, rule.fewest_drops)];
    if rule.needs_reference() {
        checks.push(check(
            Item::ReferenceDrops,
            reference.iter().sum(),
            rule.fewest_drops,
        ));
    }
    if by_place {
        checks.push(check(Item::Places, surface.len(), rule.places()));
    }
    checks
}

const fn yes(kept: bool) -> Kept {
    if kept { Kept::Yes } else { Kept::No }
}

impl Rule {
    /// Whether it compares places, or wants several.
    pub const fn compares_places(&self) -> bool {
        self.evenness.is_some() || self.fewest_places > 1
    }

    /// How many places it needs: two to compare any.
    pub fn places(&self) -> usize {
        let compared = matches!(
            self.evenness,
            Some(Evenness::WithinOfMean(_) | Evenness::Range(_))
        );
        self.fewest_places.max(if compared { 2 } else { 1 })
    }
}
