//! What the drops say of the rebound, as tables for the screen and for reports.

use bouncelab::rulebook::{Rebound, Step, Verdict};
use bouncelab_report::{Align, CANNOT_TELL, Quantity, Table, Unit};

/// The rebound by each way to work it out.
pub(super) fn ways(verdict: &Verdict) -> Table {
    let mut table = Table::new([
        ("rebound", Align::Left),
        ("value", Align::Right),
        ("95 %", Align::Right),
    ]);
    let mut row = |name: &str, summary: &Option<Estimate>, unit: Unit| {
        if let Some(summary) = summary {
            let value = Quantity::measured(summary.value, summary.sd, unit);
            table.row([
                name.to_owned(),
                value.to_string(),
                value.interval(summary.interval95),
            ]);
        }
    };
    row("predicted, with air", &verdict.rebound, Unit::Length);
    row("on the reference", &verdict.reference, Unit::Length);
    row("share of the reference", &verdict.share, Unit::Percent);
    row(
        "unevenness of the places",
        &verdict.unevenness,
        Unit::Percent,
    );
    let plain = [
        ("g T²/8 of the first flight", verdict.plain_m()),
        ("the rule's formula from T", verdict.formula_m()),
    ];
    for (name, height_m) in plain {
        if let Some(height_m) = height_m {
            table.row([name.to_owned(), length(height_m)]);
        }
    }
    if table.is_empty() {
        table.row(["", CANNOT_TELL]);
    }
    table
}

/// What lies between the plain height and the predicted one, if every drop says so.
pub(super) fn differences(verdict: &Verdict) -> Option<Table> {
    let drops = &verdict.drops;
    let first = drops.first()?;
    if drops.iter().any(|drop| drop.steps.is_empty()) {
        return None;
    }
    let mut table = Table::new([("because of", Align::Left), ("cm", Align::Right)]);
    let count = drops.len() as f64;
    for (place, step) in first.steps.iter().enumerate() {
        let of_drop = |drop: &Rebound| drop.steps.get(place).map_or(0.0, |s: &Step| s.height_m);
        let mean_m = drops.iter().map(of_drop).sum::<f64>() / count;
        table.row([step.why.to_string(), signed(mean_m * 100.0)]);
    }
    Some(table)
}

/// With its sign, but for zero.
fn signed(value: f64) -> String {
    match format!("{value:+.2}").as_str() {
        "-0.00" | "+0.00" => "0.00".to_owned(),
        number => number.replace('-', "\u{2212}"),
    }
}

pub(super) fn drops(drops: &[Rebound], files: &[String]) -> Table {
    let with_formula = drops.iter().any(|drop| drop.formula_m.is_some());
    let mut columns = vec![
        ("file", Align::Left),
        ("first flight s", Align::Right),
        ("g T²/8", Align::Right),
    ];
    if with_formula {
        columns.push(("formula", Align::Right));
    }
    columns.push(("predicted", Align::Right));
    let mut table = Table::new(columns);
    for drop in drops {
        let shown = |height: Option<f64>| height.map_or_else(String::new, length);
        let mut row = vec![
            files.get(drop.place).cloned().unwrap_or_default(),
            drop.first_flight_s
                .map_or_else(String::new, |time_s| format!("{time_s:.4}")),
            shown(drop.plain_m),
        ];
        if with_formula {
            row.push(shown(drop.formula_m));
        }
        row.push(drop.predicted_m.map_or_else(
            || CANNOT_TELL.to_owned(),
            |found| Quantity::measured(found.value, found.sd, Unit::Length).to_string(),
        ));
        table.row(row);
    }
    table
}

fn length(metres: f64) -> String {
    Quantity::rounded(metres, 4, Unit::Length).to_string()
}
