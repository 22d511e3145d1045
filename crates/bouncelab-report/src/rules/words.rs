//! Rules in sentences.

use bouncelab::rulebook::{Averaging, Evenness, Item, Limits, Point, Reading, Requirement, Rule};

use crate::messages::Translator;

/// The title of a rule. Those that are built in have one in every language, as their surfaces and notes have; the
/// words of other rules stay as they are.
pub fn title(rule: &Rule, translator: &Translator) -> String {
    translator.named("title", &rule.title)
}

/// A surface that a rule names.
pub fn surface(surface: &str, translator: &Translator) -> String {
    translator.named("surface", surface)
}

/// What a rule notes of itself.
pub fn note(rule: &Rule, translator: &Translator) -> Option<String> {
    let note = rule.note.as_deref()?;
    Some(translator.named("note", note))
}

/// Everything that a rule states.
pub fn facts(rule: &Rule, translator: &Translator) -> Vec<(String, String)> {
    let mut facts = vec![
        ("rule-source", rule.source.citation()),
        ("rule-status", read(rule.source.read, translator)),
    ];
    let noted = [
        ("rule-address", &rule.source.address),
        ("rule-checked", &rule.source.checked),
    ];
    facts.extend(
        noted
            .into_iter()
            .filter_map(|(id, noted)| Some((id, noted.clone()?))),
    );
    facts.extend(rule.ball.clone().map(|ball| ("rule-ball", ball)));
    let surface = rule
        .surface
        .as_deref()
        .map(|name| surface(name, translator));
    facts.extend(surface.map(|surface| ("rule-surface", surface)));
    facts.push(("rule-drop", drop(rule, translator)));
    facts.push(("rule-wants", wanted(rule, translator)));
    let measured_at = match rule.measured_at {
        Some(at) => translator.text_with("rule-point", &[("point", point(at, translator).into())]),
        None => translator.text("rule-point-not-noted"),
    };
    facts.push(("rule-measured-at", measured_at));
    let averaged = match rule.averaging {
        Averaging::Mean => "rule-drops-mean",
        Averaging::Each => "rule-drops-each",
    };
    let count = [("count", rule.fewest_drops.into())];
    facts.push(("rule-drops", translator.text_with(averaged, &count)));
    if rule.compares_places() {
        let least = at_least(rule.places(), translator);
        let places = [Some(least), even(rule, translator)].into_iter().flatten();
        facts.push(("rule-places", translator.in_one_line(places)));
    }
    let circumstances = [
        ("rule-conditioning", Item::Conditioning),
        ("rule-temperature", Item::Temperature),
        ("rule-humidity", Item::Humidity),
        ("rule-altitude", Item::Altitude),
    ];
    let circumstances = circumstances
        .into_iter()
        .map(|(id, item)| (id, asked(rule, item, translator)));
    facts.extend(circumstances.filter(|(_, asked)| !asked.is_empty()));
    if let Some(step) = rule.rounding {
        let share = rule.needs_reference();
        let step = if share {
            percent(step, translator)
        } else {
            length(step, translator)
        };
        facts.push(("rule-rounded", step));
    }
    if let Some(formula) = &rule.formula {
        let formula = [
            ("factor", formula.factor_m_s2.into()),
            ("offset", formula.offset_s.into()),
            ("read", read(formula.read, translator).into()),
        ];
        facts.push((
            "rule-formula",
            translator.text_with("rule-formula-text", &formula),
        ));
    }
    facts.extend(note(rule, translator).map(|note| ("rule-note", note)));
    facts
        .into_iter()
        .map(|(id, fact)| (translator.text(id), fact))
        .collect()
}

/// What was read of a rule.
pub fn read(read: Reading, translator: &Translator) -> String {
    translator.named("read", &read.to_string())
}

/// What a rule asks for in a part of its procedure; empty if it does not.
pub fn asked(rule: &Rule, item: Item, translator: &Translator) -> String {
    let celsius = |end: f64| format!("{} °C", translator.fixed(end - 273.15, 1));
    let within = |limits: &Limits, shown: &dyn Fn(f64) -> String| {
        if limits.is_open() {
            String::new()
        } else {
            ends(limits, shown, translator)
        }
    };
    match item {
        Item::Release => drop(rule, translator),
        Item::Surface => rule
            .surface
            .as_deref()
            .map_or_else(String::new, |name| surface(name, translator)),
        Item::Reference => match &rule.requirement {
            Requirement::Share { of, .. } => surface(of, translator),
            _ => String::new(),
        },
        Item::Temperature => within(&rule.temperature_k, &celsius),
        Item::Humidity => within(&rule.humidity, &|end| percent(end, translator)),
        Item::Altitude => within(&rule.altitude_m, &|end| format!("{end} m")),
        Item::Conditioning => {
            let conditioning = rule.conditioning.as_deref();
            conditioning.map_or_else(String::new, |words| translator.named("conditioning", words))
        }
        Item::Places => at_least(rule.places(), translator),
        _ => at_least(rule.fewest_drops, translator),
    }
}

/// What was found of it, in the unit in which a rule asks.
pub fn found(item: Item, found: f64, translator: &Translator) -> String {
    match item {
        Item::Release => length(found, translator),
        Item::Temperature => format!("{} °C", translator.fixed(found - 273.15, 1)),
        Item::Humidity => percent(found, translator),
        Item::Altitude => format!("{found} m"),
        _ => shown(found, translator),
    }
}

fn at_least(count: usize, translator: &Translator) -> String {
    translator.text_with("rule-places-least", &[("count", count.into())])
}

/// A point of the ball.
pub fn point(point: Point, translator: &Translator) -> String {
    translator.text(match point {
        Point::Bottom => "rule-point-bottom",
        Point::Centre => "rule-point-centre",
        Point::Top => "rule-point-top",
    })
}

/// From where the ball is dropped.
pub fn drop(rule: &Rule, translator: &Translator) -> String {
    let Some(height_m) = rule.drop_height_m else {
        return translator.text("rule-any-height");
    };
    let tolerance = rule.drop_tolerance_m;
    let tolerance =
        tolerance.map_or_else(String::new, |end| format!(" ± {}", length(end, translator)));
    let height = length(height_m, translator) + &tolerance;
    if rule.or_higher {
        translator.text_with("rule-or-more", &[("height", height.into())])
    } else {
        height
    }
}

/// What the rule requires of the rebound.
pub fn wanted(rule: &Rule, translator: &Translator) -> String {
    let wanted = match &rule.requirement {
        Requirement::Height(limits) => heights(limits, translator),
        Requirement::About(height_m) => translator.text_with(
            "rule-about",
            &[("height", length(*height_m, translator).into())],
        ),
        Requirement::Share { limits, of } if limits.is_open() => translator.text_with(
            "rule-share-of",
            &[("surface", surface(of, translator).into())],
        ),
        Requirement::Share { limits, of } => translator.text_with(
            "rule-limits-of",
            &[
                (
                    "limits",
                    ends(limits, |share| percent(share, translator), translator).into(),
                ),
                ("surface", surface(of, translator).into()),
            ],
        ),
    };
    translator.in_one_line([Some(wanted), even(rule, translator)].into_iter().flatten())
}

/// The same, shorter, where the reference surface need not be named.
pub fn wanted_in_short(rule: &Rule, translator: &Translator) -> String {
    match &rule.requirement {
        Requirement::Share { limits, .. } if limits.is_open() => {
            translator.text("rule-share-of-reference")
        }
        Requirement::Share { limits, .. } => {
            let limits = [(
                "limits",
                ends(limits, |share| percent(share, translator), translator).into(),
            )];
            translator.text_with("rule-limits-of-reference", &limits)
        }
        _ => wanted(rule, translator),
    }
}

fn even(rule: &Rule, translator: &Translator) -> Option<String> {
    let (id, share) = match rule.evenness? {
        Evenness::WithinOfMean(share) => ("rule-within-of-mean", share),
        Evenness::Range(share) => ("rule-places-apart", share),
    };
    Some(translator.text_with(id, &[("share", hundredths(share).into())]))
}

/// Limits with the unit once.
fn heights(limits: &Limits, translator: &Translator) -> String {
    let ends = ends(limits, |end| shown(hundredths(end), translator), translator);
    if limits.is_open() {
        ends
    } else {
        format!("{ends} cm")
    }
}

fn ends(limits: &Limits, shown: impl Fn(f64) -> String, translator: &Translator) -> String {
    match (limits.least, limits.greatest) {
        (Some(least), Some(greatest)) => translator.text_with(
            "interval-ends",
            &[
                ("low", shown(least).into()),
                ("high", shown(greatest).into()),
            ],
        ),
        (Some(least), None) => {
            translator.text_with("rule-at-least", &[("least", shown(least).into())])
        }
        (None, Some(greatest)) => {
            translator.text_with("rule-at-most", &[("greatest", shown(greatest).into())])
        }
        (None, None) => translator.text("verdict-anything"),
    }
}

fn percent(share: f64, translator: &Translator) -> String {
    format!("{} %", shown(hundredths(share), translator))
}

/// A height of a rule, always in centimetres.
fn length(metres: f64, translator: &Translator) -> String {
    format!("{} cm", shown(hundredths(metres), translator))
}

fn shown(value: f64, translator: &Translator) -> String {
    translator.number(&value.to_string())
}

/// A share in per cent, or metres in centimetres.
fn hundredths(value: f64) -> f64 {
    (value * 1e4).round() / 100.0
}
