//! Why a verdict cannot be given, and what to know of one that can.

use std::fmt;

use super::rule::{Limits, Rule, Status};

/// Why nothing can be decided.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum InconclusiveReason {
    /// The rule takes more drops than there are.
    TooFewDrops {
        /// How many it takes.
        needed: usize,
        /// How many there are.
        given: usize,
        /// Whether those of the reference are meant.
        of_reference: bool,
    },
    /// The rule compares with a reference surface, and there is no recording of it.
    NoReference,
    /// The rule is about places being alike, and there is one only.
    OnePlace,
    /// The rule names no limits.
    NoLimits,
    /// Neither the rule nor the person names a height.
    NoHeight,
    /// The temperature (K) is outside the rule's.
    Temperature(f64),
    /// The height above the sea (m) is outside the rule's.
    Altitude(f64),
    /// The flight times contradict the height from which the ball is said to have fallen; in words.
    Height(String),
    /// Drop so and so does not tell its rebound: why.
    Untold(usize, String),
    /// The limits lie within the uncertainty.
    TooUncertain,
}

impl fmt::Display for InconclusiveReason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFewDrops {
                needed,
                given,
                of_reference,
            } => write!(
                f,
                "the rule takes {needed} drops{}, and there {} {given}",
                if *of_reference {
                    " on the reference"
                } else {
                    ""
                },
                if *given == 1 { "is" } else { "are" },
            ),
            Self::NoReference => write!(
                f,
                "the rule compares with a reference surface: give recordings of the same ball on it \
                 (--reference)"
            ),
            Self::OnePlace => write!(
                f,
                "the rule wants places to be alike, and there is one: give one recording for each \
                 place"
            ),
            Self::NoLimits => write!(f, "the rule names no limits"),
            Self::NoHeight => write!(
                f,
                "the rule names no height: say from which the ball fell (--height)"
            ),
            Self::Temperature(kelvin) => write!(
                f,
                "{:.1} C is not a temperature at which the rule holds",
                kelvin - 273.15
            ),
            Self::Altitude(metres) => {
                write!(f, "{metres} m above the sea is not where the rule holds")
            }
            Self::Height(reason) => f.write_str(reason),
            Self::Untold(drop, reason) => write!(f, "drop {drop} does not tell: {reason}"),
            Self::TooUncertain => write!(
                f,
                "a limit lies within the uncertainty; more or better drops would help"
            ),
        }
    }
}

/// What to know of a verdict.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Remark {
    /// The rule was not read in its source.
    Unverified,
    /// The formula of the rule was not read in its source.
    UnverifiedFormula,
    /// The rule does not say where heights are measured; the lowest point was taken.
    PointNotStated,
    /// The rule holds at these temperatures (K), and nobody stated one.
    TemperatureNotStated(Limits),
    /// The rule holds at these heights above the sea (m), and nobody stated one.
    AltitudeNotStated(Limits),
    /// The ball is far heavier, lighter, larger or smaller than this one, which the rule is for.
    OtherBall(&'static str),
    /// The ball was dropped from so high (m, lowest point) instead of the rule's fall: the rebound is
    /// predicted for the rule's height.
    OtherHeight {
        /// As measured.
        dropped_m: f64,
        /// As the rule has it.
        rule_m: f64,
    },
    /// The rule's impact is faster than any heard, by this factor: the rebound rests on how
    /// restitution depends on speed.
    Extrapolated(f64),
    /// So few drops, one or two, hardly show how drops differ.
    FewDrops(usize),
}

impl fmt::Display for Remark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unverified => write!(
                f,
                "this rule is unverified: nobody has read it in its source; do not rely on it"
            ),
            Self::UnverifiedFormula => write!(
                f,
                "the formula of this rule is unverified: nobody has read it in its source"
            ),
            Self::OtherBall(label) => write!(
                f,
                "the rule is for a ball of the kind {label}, and that stated is another by mass or \
                 diameter: is it the right rule?"
            ),
            Self::PointNotStated => write!(
                f,
                "it is not noted where on the ball this rule measures; the lowest point is taken"
            ),
            Self::TemperatureNotStated(limits) => {
                let celsius = limits.raised(-273.15);
                write!(
                    f,
                    "the rule holds at {} C, and nobody stated the temperature (--temperature)",
                    span(&celsius, 1)
                )
            }
            Self::AltitudeNotStated(limits) => write!(
                f,
                "the rule holds at {} m above the sea, and nobody stated the altitude (--altitude)",
                span(limits, 0)
            ),
            Self::OtherHeight { dropped_m, rule_m } => write!(
                f,
                "the ball fell {:.1} cm, the rule drops it {:.1} cm: the rebound is predicted for \
                 the rule's",
                dropped_m * 100.0,
                rule_m * 100.0
            ),
            Self::Extrapolated(factor) => write!(
                f,
                "the rule's impact is {:.0} % faster than any that was heard: its rebound rests on \
                 how restitution depends on speed",
                (factor - 1.0) * 100.0
            ),
            Self::FewDrops(1) => write!(
                f,
                "the verdict is of this one drop: how much drops differ it does not show; three or \
                 more would"
            ),
            Self::FewDrops(_) => write!(
                f,
                "two drops hardly show how much drops differ, which makes their mean uncertain; a \
                 third would help much"
            ),
        }
    }
}

fn span(limits: &Limits, digits: usize) -> String {
    match (limits.least, limits.greatest) {
        (Some(least), Some(greatest)) => format!("{least:.digits$} to {greatest:.digits$}"),
        (Some(least), None) => format!("{least:.digits$} and more"),
        (None, Some(greatest)) => format!("{greatest:.digits$} and less"),
        (None, None) => "any".to_owned(),
    }
}

/// What to know of a rule by itself.
pub(super) fn of_rule(rule: &Rule) -> Vec<Remark> {
    let mut remarks = Vec::new();
    if rule.status == Status::Unverified {
        remarks.push(Remark::Unverified);
    }
    let formula = rule.formula.as_ref();
    if formula.is_some_and(|formula| formula.status == Status::Unverified) {
        remarks.push(Remark::UnverifiedFormula);
    }
    if rule.measured_at.is_none() {
        remarks.push(Remark::PointNotStated);
    }
    remarks
}
