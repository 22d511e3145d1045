//! A verdict in words.

use bouncelab::rulebook::{Decision, Limits, Outcome, Verdict};

use crate::messages::{Translator, Value};
use crate::quantity::{Quantity, Unit};
use crate::report::ended;

/// Why nothing can be decided.
pub fn because(verdict: &Verdict, words: &Translator) -> impl Iterator<Item = String> {
    verdict.doubts.iter().map(|doubt| {
        let reason = ended(words.diagnostic(&doubt.diagnostic()));
        words.text_with("verdict-because", &[("reason", reason.into())])
    })
}

/// The decision in a few words.
pub fn outcome_name(outcome: Outcome, words: &Translator) -> String {
    words.text(match outcome {
        Outcome::Pass => "verdict-pass",
        Outcome::Fail => "verdict-fail",
        Outcome::CannotDecide => "verdict-cannot-decide",
    })
}

/// The decision, and how sure it is.
pub fn outcome(verdict: &Verdict, words: &Translator) -> String {
    let outcome = outcome_name(verdict.outcome, words).to_uppercase();
    match verdict.within {
        Some(within) => words.text_with(
            "verdict-sure",
            &[
                ("outcome", outcome.into()),
                ("within", percent(within, words).into()),
                ("outside", percent(1.0 - within, words).into()),
            ],
        ),
        None => format!("{outcome}."),
    }
}

/// The decision rule, and what it accepts.
pub fn by_rule(verdict: &Verdict, decision: Decision, words: &Translator) -> Vec<String> {
    let mut lines = vec![match decision {
        Decision::Guarded { risk } => {
            words.text_with("verdict-guarded", &[("risk", percent(risk, words).into())])
        }
        Decision::Simple => words.text("verdict-simple"),
    }];
    if let (Some(accepted), Decision::Guarded { .. }) = (&verdict.accepted, decision) {
        let unit = if verdict.share.is_some() {
            Unit::Percent
        } else {
            Unit::Length
        };
        let accepted = [("accepted", ends(accepted, unit, words).into())];
        lines.push(words.text_with("verdict-accepted", &accepted));
    }
    lines
}

/// A probability, without a claim to be certain.
fn percent(share: f64, words: &Translator) -> String {
    const CERTAIN: f64 = 0.9995;
    let percent = |share: f64| format!("{} %", words.fixed(share * 100.0, 1));
    if share > CERTAIN {
        words.text_with("verdict-more-than", &[("share", percent(0.999).into())])
    } else if share < 1.0 - CERTAIN {
        words.text_with("verdict-less-than", &[("share", percent(0.001).into())])
    } else {
        percent(share)
    }
}

fn ends(limits: &Limits, unit: Unit, words: &Translator) -> String {
    let shown = |end: f64| Value::from(Quantity::rounded(end, 4, unit));
    match (limits.least, limits.greatest) {
        (Some(least), Some(greatest)) => words.text_with(
            "interval-ends",
            &[("low", shown(least)), ("high", shown(greatest))],
        ),
        (Some(least), None) => words.text_with("verdict-from", &[("least", shown(least))]),
        (None, Some(greatest)) => {
            words.text_with("verdict-up-to", &[("greatest", shown(greatest))])
        }
        (None, None) => words.text("verdict-anything"),
    }
}
