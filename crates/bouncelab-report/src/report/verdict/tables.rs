//! The rebound of the drops, as tables.

use bouncelab::rulebook::{Correction, Rebound, Step, Verdict};

use crate::messages::Translator;
use crate::quantity::{Quantity, Unit};
use crate::table::{Align, Table};

/// The rebound by each method.
pub fn ways(verdict: &Verdict, translator: &Translator) -> Table {
    let mut table = Table::with_headings(
        translator,
        [
            ("verdict-rebound", Align::Left),
            ("verdict-value", Align::Right),
            ("column-95", Align::Right),
        ],
    );
    let estimated = [
        ("verdict-predicted-air", &verdict.rebound, Unit::Length),
        ("verdict-reference", &verdict.reference, Unit::Length),
        ("verdict-share", &verdict.share, Unit::Percent),
        ("verdict-unevenness", &verdict.unevenness, Unit::Percent),
    ];
    for (id, estimate, unit) in estimated {
        if let Some(estimate) = estimate {
            let value = Quantity::of(estimate, unit);
            let interval = value.interval_text(estimate.interval95, translator);
            table.row([translator.text(id), value.text(translator), interval]);
        }
    }
    let plain = [
        ("verdict-plain", verdict.drag_free_m()),
        ("verdict-formula", verdict.formula_m()),
    ];
    for (id, height_m) in plain {
        if let Some(height_m) = height_m {
            table.row([translator.text(id), length(height_m, translator)]);
        }
    }
    if table.is_empty() {
        table.row([String::new(), translator.text("unit-cannot-tell")]);
    }
    table
}

/// What lies between the plain height and the predicted one, if every drop says so.
pub fn differences(verdict: &Verdict, translator: &Translator) -> Option<Table> {
    let drops = &verdict.drops;
    let first = drops.first()?;
    if drops.iter().any(|drop| drop.steps.is_empty()) {
        return None;
    }
    let mut table = Table::with_headings(
        translator,
        [
            ("verdict-reason", Align::Left),
            ("verdict-centimetres", Align::Right),
        ],
    );
    let count = drops.len() as f64;
    for (index, step) in first.steps.iter().enumerate() {
        let of_drop = |drop: &Rebound| drop.steps.get(index).map_or(0.0, |s: &Step| s.height_m);
        let mean_m = drops.iter().map(of_drop).sum::<f64>() / count;
        let why = match step.why {
            Correction::Contact => "verdict-step-contact",
            Correction::Buoyancy => "verdict-step-buoyancy",
            Correction::Drag => "verdict-step-drag",
            _ => "verdict-step-this-drop",
        };
        table.row([translator.text(why), signed(mean_m * 100.0, translator)]);
    }
    Some(table)
}

/// With its sign, but for zero.
fn signed(value: f64, translator: &Translator) -> String {
    match format!("{value:+.2}").as_str() {
        "-0.00" | "+0.00" => translator.fixed(0.0, 2),
        number => translator.number(&number.replace('-', "\u{2212}")),
    }
}

/// The result of each drop.
pub fn drops(drops: &[Rebound], files: &[String], translator: &Translator) -> Table {
    let with_formula = drops.iter().any(|drop| drop.formula_m.is_some());
    let mut columns = vec![
        ("verdict-file", Align::Left),
        ("verdict-first-flight", Align::Right),
        ("column-plain", Align::Right),
    ];
    if with_formula {
        columns.push(("verdict-formula-short", Align::Right));
    }
    columns.push(("verdict-predicted", Align::Right));
    let mut table = Table::with_headings(translator, columns);
    for drop in drops {
        let shown = |height: Option<f64>| {
            height.map_or_else(String::new, |height_m| length(height_m, translator))
        };
        let mut row = vec![
            files.get(drop.place).cloned().unwrap_or_default(),
            drop.first_flight_s
                .map_or_else(String::new, |time_s| translator.fixed(time_s, 4)),
            shown(drop.drag_free_m),
        ];
        if with_formula {
            row.push(shown(drop.formula_m));
        }
        row.push(drop.predicted_m.map_or_else(
            || translator.text("unit-cannot-tell"),
            |height| Quantity::of(&height, Unit::Length).text(translator),
        ));
        table.row(row);
    }
    table
}

fn length(metres: f64, translator: &Translator) -> String {
    Quantity::rounded(metres, 4, Unit::Length).text(translator)
}
