//! Reasons for an inconclusive verdict, and remarks.

use super::procedure::Item;
use super::rule::{Reading, Rule};
use crate::diagnostic::{Code, Diagnostic};

/// Why nothing can be decided.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum InconclusiveReason {
    /// This part of the procedure was not kept.
    NotKept(Item),
    /// The rule names no limits.
    NoLimits,
    /// Neither the rule nor the person names a height.
    NoHeight,
    /// The flight times contradict the height from which the ball is said to have fallen, or the first impact is
    /// doubtful.
    Doubtful(Diagnostic),
    /// The first flight of the drop of this number was not detected.
    NoFirstFlight(usize),
    /// The limits lie within the uncertainty.
    TooUncertain,
}

impl InconclusiveReason {
    /// The same as data.
    pub fn diagnostic(&self) -> Diagnostic {
        let new = Diagnostic::new;
        match self {
            Self::NotKept(item) => new(Code::ProcedureNotKept).with("item", item.name()),
            Self::NoLimits => new(Code::RuleWithoutLimits),
            Self::NoHeight => new(Code::RuleNeedsHeight),
            Self::Doubtful(reason) => reason.clone(),
            Self::NoFirstFlight(drop) => new(Code::DropWithoutFirstFlight).with("drop", *drop),
            Self::TooUncertain => new(Code::LimitWithinUncertainty),
        }
    }
}

/// What to know of a verdict.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Remark {
    /// The text of the rule was not read.
    NotPrimary(Reading),
    /// The text of its formula was not read.
    FormulaNotPrimary(Reading),
    /// The rule does not say where heights are measured; the lowest point was taken.
    PointNotStated,
    /// The ball is far heavier, lighter, larger or smaller than this one, which the rule is for.
    OtherBall(&'static str),
    /// The model answers with another value, beyond the uncertainties of both.
    ModelDiffers,
    /// One or two drops hardly show how drops differ.
    FewDrops(usize),
    /// As many drops with the same mean and scatter would decide.
    DecidingDrops(usize),
    /// No number of drops would decide: what they share is too uncertain.
    NoDropsDecide,
}

impl Remark {
    /// The same as data.
    pub fn diagnostic(&self) -> Diagnostic {
        let new = Diagnostic::new;
        match self {
            Self::NotPrimary(Reading::Memory) => new(Code::RuleUnverified),
            Self::NotPrimary(_) => new(Code::RuleSecondary),
            Self::FormulaNotPrimary(read) => {
                new(Code::FormulaUnverified).with("read", read.to_string())
            }
            Self::OtherBall(ball) => new(Code::RuleOtherBall).with("ball", *ball),
            Self::PointNotStated => new(Code::RuleWithoutPoint),
            Self::ModelDiffers => new(Code::ModelDiffers),
            Self::FewDrops(drops) => new(Code::VerdictOfFewDrops).with("drops", *drops),
            Self::DecidingDrops(drops) => new(Code::DropsThatDecide).with("drops", *drops),
            Self::NoDropsDecide => new(Code::NoDropsDecide),
        }
    }
}

/// What to know of a rule by itself.
pub(super) fn of_rule(rule: &Rule) -> Vec<Remark> {
    let mut remarks = Vec::new();
    if rule.source.read != Reading::Primary {
        remarks.push(Remark::NotPrimary(rule.source.read));
    }
    let formula = rule.formula.as_ref();
    remarks.extend(
        formula
            .filter(|formula| formula.read != Reading::Primary)
            .map(|formula| Remark::FormulaNotPrimary(formula.read)),
    );
    if rule.measured_at.is_none() && !rule.needs_reference() {
        remarks.push(Remark::PointNotStated);
    }
    remarks
}
