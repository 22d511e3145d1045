//! Reasons for an inconclusive verdict, and remarks.

use crate::diagnostic::{Code, Diagnostic};

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
    /// The flight times contradict the height from which the ball is said to have fallen.
    Height(Diagnostic),
    /// The rebound of the drop of this number is unknown: why.
    Unknown(usize, Diagnostic),
    /// The limits lie within the uncertainty.
    TooUncertain,
}

impl InconclusiveReason {
    /// The same as data.
    pub fn diagnostic(&self) -> Diagnostic {
        let new = Diagnostic::new;
        match self {
            Self::TooFewDrops {
                needed,
                given,
                of_reference,
            } => new(if *of_reference {
                Code::RuleNeedsReferenceDrops
            } else {
                Code::RuleNeedsDrops
            })
            .with("needed", *needed)
            .with("given", *given),
            Self::NoReference => new(Code::RuleNeedsReference),
            Self::OnePlace => new(Code::RuleNeedsPlaces),
            Self::NoLimits => new(Code::RuleWithoutLimits),
            Self::NoHeight => new(Code::RuleNeedsHeight),
            Self::Temperature(kelvin) => new(Code::RuleTemperature).with("temperature_k", *kelvin),
            Self::Altitude(metres) => new(Code::RuleAltitude).with("altitude_m", *metres),
            Self::Height(reason) => reason.clone(),
            Self::Unknown(drop, reason) => {
                let mut diagnostic = reason.clone();
                diagnostic
                    .arguments
                    .insert("drop".to_owned(), (*drop).into());
                diagnostic
            }
            Self::TooUncertain => new(Code::LimitWithinUncertainty),
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
    /// One or two drops hardly show how drops differ.
    FewDrops(usize),
}

impl Remark {
    /// The same as data.
    pub fn diagnostic(&self) -> Diagnostic {
        let new = Diagnostic::new;
        match self {
            Self::Unverified => new(Code::RuleUnverified),
            Self::UnverifiedFormula => new(Code::FormulaUnverified),
            Self::OtherBall(ball) => new(Code::RuleOtherBall).with("ball", *ball),
            Self::PointNotStated => new(Code::RuleWithoutPoint),
            Self::TemperatureNotStated(limits) => of_limits(
                new(Code::TemperatureNotStated),
                limits,
                ["least_k", "greatest_k"],
            ),
            Self::AltitudeNotStated(limits) => of_limits(
                new(Code::AltitudeNotStated),
                limits,
                ["least_m", "greatest_m"],
            ),
            Self::OtherHeight { dropped_m, rule_m } => new(Code::RuleOtherHeight)
                .with("dropped_m", *dropped_m)
                .with("rule_m", *rule_m),
            Self::Extrapolated(factor) => new(Code::RuleExtrapolated).with("factor", *factor),
            Self::FewDrops(drops) => new(Code::VerdictOfFewDrops).with("drops", *drops),
        }
    }
}

fn of_limits(mut diagnostic: Diagnostic, limits: &Limits, names: [&str; 2]) -> Diagnostic {
    for (name, end) in names.into_iter().zip([limits.least, limits.greatest]) {
        if let Some(end) = end {
            diagnostic = diagnostic.with(name, end);
        }
    }
    diagnostic
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
