//! A verdict in sentences.

use bouncelab::rulebook::{Decision, Limits, Outcome, Verdict};

use crate::messages::{Translator, Value};
use crate::quantity::{Quantity, Unit};
use crate::report::ended;

/// Why nothing can be decided.
pub fn because(verdict: &Verdict, translator: &Translator) -> impl Iterator<Item = String> {
    verdict.doubts.iter().map(|doubt| {
        let reason = ended(translator.diagnostic(&doubt.diagnostic()));
        translator.text_with("verdict-because", &[("reason", reason.into())])
    })
}

/// The decision in a few words.
pub fn outcome_name(outcome: Outcome, translator: &Translator) -> String {
    translator.text(&format!("verdict-{}", outcome.name()))
}

/// The decision, and how sure it is.
pub fn outcome(verdict: &Verdict, translator: &Translator) -> String {
    let outcome = outcome_name(verdict.outcome, translator).to_uppercase();
    match verdict.within {
        Some(within) => translator.text_with(
            "verdict-sure",
            &[
                ("outcome", outcome.into()),
                ("within", percent(within, translator).into()),
                ("outside", percent(1.0 - within, translator).into()),
            ],
        ),
        None => format!("{outcome}."),
    }
}

/// The value that the rule limits, with its uncertainty, and the decision.
pub fn so_far(verdict: &Verdict, translator: &Translator) -> String {
    let unit = unit(verdict);
    let value = verdict.value().map_or_else(
        || translator.text("unit-cannot-tell"),
        |value| {
            let shown = Quantity::of(&value, unit);
            let interval = shown.interval_text(value.interval95, translator);
            format!("{} ({interval})", shown.text(translator))
        },
    );
    let words = [
        ("value", value.into()),
        ("outcome", outcome(verdict, translator).into()),
    ];
    translator.text_with("job-so-far", &words)
}

/// The unit of the value that the rule limits.
pub(super) fn unit(verdict: &Verdict) -> Unit {
    if verdict.share.is_some() {
        Unit::Percent
    } else {
        Unit::Length
    }
}

/// The decision rule, and what it accepts.
pub fn by_rule(verdict: &Verdict, decision: Decision, translator: &Translator) -> Vec<String> {
    let mut lines = vec![match decision {
        Decision::Guarded { risk } => translator.text_with(
            "verdict-guarded",
            &[("risk", percent(risk, translator).into())],
        ),
        Decision::Simple => translator.text("verdict-simple"),
    }];
    if let (Some(accepted), Decision::Guarded { .. }) = (&verdict.accepted, decision) {
        let accepted = ends(accepted, unit(verdict), translator);
        let accepted = [("accepted", accepted.into())];
        lines.push(translator.text_with("verdict-accepted", &accepted));
    }
    lines
}

/// A probability, without a claim to be certain.
fn percent(share: f64, translator: &Translator) -> String {
    const CERTAIN: f64 = 0.9995;
    let percent = |share: f64| format!("{} %", translator.fixed(share * 100.0, 1));
    if share > CERTAIN {
        translator.text_with("verdict-more-than", &[("share", percent(0.999).into())])
    } else if share < 1.0 - CERTAIN {
        translator.text_with("verdict-less-than", &[("share", percent(0.001).into())])
    } else {
        percent(share)
    }
}

fn ends(limits: &Limits, unit: Unit, translator: &Translator) -> String {
    let shown = |end: f64| Value::from(Quantity::rounded(end, 4, unit));
    match (limits.least, limits.greatest) {
        (Some(least), Some(greatest)) => translator.text_with(
            "interval-ends",
            &[("low", shown(least)), ("high", shown(greatest))],
        ),
        (Some(least), None) => translator.text_with("verdict-from", &[("least", shown(least))]),
        (None, Some(greatest)) => {
            translator.text_with("verdict-up-to", &[("greatest", shown(greatest))])
        }
        (None, None) => translator.text("verdict-anything"),
    }
}
