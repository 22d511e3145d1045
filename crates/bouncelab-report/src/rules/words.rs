//! Rules in words.

use bouncelab::rulebook::{Averaging, Evenness, Limits, Point, Requirement, Rule, Status};

use crate::messages::Translator;

/// The title of a rule. Those that are built in have one in every language, as their surfaces and notes have; the
/// words of other rules stay as they are.
pub fn title(rule: &Rule, words: &Translator) -> String {
    words.named("title", &rule.title)
}

/// A surface that a rule names.
pub fn surface(surface: &str, words: &Translator) -> String {
    words.named("surface", surface)
}

/// What a rule notes of itself.
pub fn note(rule: &Rule, words: &Translator) -> Option<String> {
    let note = rule.note.as_deref()?;
    Some(words.named("note", note))
}

/// Everything that a rule says, in words.
pub fn facts(rule: &Rule, words: &Translator) -> Vec<(String, String)> {
    let edition = rule.edition.clone();
    let mut facts = vec![
        ("rule-source", rule.source.clone()),
        (
            "rule-edition",
            edition.unwrap_or_else(|| words.text("rule-not-noted")),
        ),
        ("rule-status", status(rule.status, words)),
    ];
    facts.extend(rule.ball.clone().map(|ball| ("rule-ball", ball)));
    let surface = rule.surface.as_deref().map(|name| surface(name, words));
    facts.extend(surface.map(|surface| ("rule-surface", surface)));
    facts.push(("rule-drop", drop(rule, words)));
    facts.push(("rule-wants", wanted(rule, words)));
    let measured_at = match rule.measured_at {
        Some(at) => words.text_with("rule-point", &[("point", point(at, words).into())]),
        None => words.text("rule-point-not-noted"),
    };
    facts.push(("rule-measured-at", measured_at));
    let averaged = match rule.averaging {
        Averaging::Mean => "rule-drops-mean",
        Averaging::Each => "rule-drops-each",
    };
    let count = [("count", rule.fewest_drops.into())];
    facts.push(("rule-drops", words.text_with(averaged, &count)));
    facts.extend(even(rule, words).map(|even| ("rule-places", even)));
    if !rule.temperature_k.is_open() {
        let celsius = rule.temperature_k.raised(-273.15);
        let shown = |end: f64| format!("{} °C", words.fixed(end, 1));
        facts.push(("rule-temperature", ends(&celsius, shown, words)));
    }
    if !rule.altitude_m.is_open() {
        facts.push((
            "rule-altitude",
            ends(&rule.altitude_m, |end| format!("{end} m"), words),
        ));
    }
    if let Some(formula) = &rule.formula {
        let formula = [
            ("factor", formula.factor_m_s2.into()),
            ("offset", formula.offset_s.into()),
            ("status", status(formula.status, words).into()),
        ];
        facts.push((
            "rule-formula",
            words.text_with("rule-formula-text", &formula),
        ));
    }
    facts.extend(note(rule, words).map(|note| ("rule-note", note)));
    facts
        .into_iter()
        .map(|(id, fact)| (words.text(id), fact))
        .collect()
}

/// Whether somebody has read a rule in its source, in words.
pub fn status(status: Status, words: &Translator) -> String {
    words.text(match status {
        Status::Verified => "rule-verified",
        Status::Unverified => "rule-unverified",
    })
}

/// A point of the ball, in words.
pub fn point(point: Point, words: &Translator) -> String {
    words.text(match point {
        Point::Bottom => "rule-point-bottom",
        Point::Centre => "rule-point-centre",
        Point::Top => "rule-point-top",
    })
}

/// From where the ball is dropped, in words.
pub fn drop(rule: &Rule, words: &Translator) -> String {
    let Some(height_m) = rule.drop_height_m else {
        return words.text("rule-any-height");
    };
    let tolerance = rule.drop_tolerance_m;
    let tolerance = tolerance.map_or_else(String::new, |end| format!(" ± {}", length(end, words)));
    let height = length(height_m, words) + &tolerance;
    if rule.or_higher {
        words.text_with("rule-or-more", &[("height", height.into())])
    } else {
        height
    }
}

/// What the rule wants of the rebound, in words.
pub fn wanted(rule: &Rule, words: &Translator) -> String {
    let wanted = match &rule.requirement {
        Requirement::Height(limits) => heights(limits, words),
        Requirement::About(height_m) => {
            words.text_with("rule-about", &[("height", length(*height_m, words).into())])
        }
        Requirement::Share { limits, of } if limits.is_open() => {
            words.text_with("rule-share-of", &[("surface", surface(of, words).into())])
        }
        Requirement::Share { limits, of } => words.text_with(
            "rule-limits-of",
            &[
                (
                    "limits",
                    ends(limits, |share| percent(share, words), words).into(),
                ),
                ("surface", surface(of, words).into()),
            ],
        ),
    };
    words.in_one_line([Some(wanted), even(rule, words)].into_iter().flatten())
}

/// The same in a few words, where the reference surface need not be named.
pub fn wanted_in_short(rule: &Rule, words: &Translator) -> String {
    match &rule.requirement {
        Requirement::Share { limits, .. } if limits.is_open() => {
            words.text("rule-share-of-reference")
        }
        Requirement::Share { limits, .. } => {
            let limits = [(
                "limits",
                ends(limits, |share| percent(share, words), words).into(),
            )];
            words.text_with("rule-limits-of-reference", &limits)
        }
        _ => wanted(rule, words),
    }
}

fn even(rule: &Rule, words: &Translator) -> Option<String> {
    let (id, share) = match rule.evenness? {
        Evenness::WithinOfMean(share) => ("rule-within-of-mean", share),
        Evenness::Range(share) => ("rule-places-apart", share),
    };
    Some(words.text_with(id, &[("share", hundredths(share).into())]))
}

/// Limits with the unit once.
fn heights(limits: &Limits, words: &Translator) -> String {
    let ends = ends(limits, |end| shown(hundredths(end), words), words);
    if limits.is_open() {
        ends
    } else {
        format!("{ends} cm")
    }
}

fn ends(limits: &Limits, shown: impl Fn(f64) -> String, words: &Translator) -> String {
    match (limits.least, limits.greatest) {
        (Some(least), Some(greatest)) => words.text_with(
            "interval-ends",
            &[
                ("low", shown(least).into()),
                ("high", shown(greatest).into()),
            ],
        ),
        (Some(least), None) => words.text_with("rule-at-least", &[("least", shown(least).into())]),
        (None, Some(greatest)) => {
            words.text_with("rule-at-most", &[("greatest", shown(greatest).into())])
        }
        (None, None) => words.text("verdict-anything"),
    }
}

fn percent(share: f64, words: &Translator) -> String {
    format!("{} %", shown(hundredths(share), words))
}

/// A height of a rule, always in centimetres.
fn length(metres: f64, words: &Translator) -> String {
    format!("{} cm", shown(hundredths(metres), words))
}

fn shown(value: f64, words: &Translator) -> String {
    words.number(&value.to_string())
}

/// A share in per cent, or metres in centimetres.
fn hundredths(value: f64) -> f64 {
    (value * 1e4).round() / 100.0
}
