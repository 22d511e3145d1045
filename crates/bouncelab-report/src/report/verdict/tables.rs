//! The verdict, as tables.

use bouncelab::Estimate;
use bouncelab::rulebook::{Check, Kept, MeanRebound, Precision, Rebound, Rule, Verdict};

use super::words::unit;
use crate::messages::Translator;
use crate::quantity::{Quantity, Unit};
use crate::rules::words;
use crate::table::{Align, Table};

/// The parts of the procedure: what the rule asks for, what was found, and whether it was kept.
pub fn procedure(rule: &Rule, checks: &[Check], translator: &Translator) -> Table {
    let columns = ["verdict-item", "verdict-asked", "verdict-here"];
    let mut table = Table::with_headings(translator, columns.map(|id| (id, Align::Left)));
    for check in checks {
        let kept = translator.text(match check.kept {
            Kept::Yes => "verdict-kept",
            Kept::No => "verdict-not-kept",
            Kept::NotShown => "verdict-not-shown",
        });
        let found = check
            .found
            .map(|found| words::found(check.item, found, translator));
        table.row([
            translator.named("item", check.item.name()),
            words::asked(rule, check.item, translator),
            translator.in_one_line(found.into_iter().chain([kept])),
        ]);
    }
    table
}

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
    let height = |mean: &Option<MeanRebound>| mean.as_ref().map(|mean| mean.height_m);
    let unit = unit(verdict);
    let estimated = [
        (
            "verdict-by-procedure",
            height(&verdict.rebound),
            Unit::Length,
        ),
        (
            "verdict-reference",
            height(&verdict.reference),
            Unit::Length,
        ),
        ("verdict-share", verdict.share, Unit::Percent),
        ("verdict-unevenness", verdict.unevenness, Unit::Percent),
        ("verdict-by-model", verdict.model, unit),
    ];
    for (id, estimate, unit) in estimated {
        if let Some(estimate) = estimate {
            let value = Quantity::of(&estimate, unit);
            let interval = value.interval_text(estimate.interval95, translator);
            table.row([translator.text(id), value.text(translator), interval]);
        }
    }
    if let Some(height_m) = verdict.drag_free_m() {
        table.row([
            translator.text("verdict-plain"),
            length(height_m, translator),
        ]);
    }
    if table.is_empty() {
        table.row([String::new(), translator.text("unit-cannot-tell")]);
    }
    table
}

/// The budget of the uncertainty of a mean.
pub fn budget(mean: &MeanRebound, translator: &Translator) -> Table {
    let mut table = Table::with_headings(
        translator,
        [
            ("verdict-reason", Align::Left),
            ("verdict-correction", Align::Right),
            ("verdict-standard-uncertainty", Align::Right),
            ("verdict-degrees", Align::Right),
        ],
    );
    let centimetres = |metres: f64| translator.fixed(metres * 100.0, 3);
    for part in &mean.budget {
        let correction = part.correction_m;
        table.row([
            translator.text(&format!("verdict-cause-{}", part.cause.name())),
            if correction == 0.0 {
                String::new()
            } else {
                signed(correction * 100.0, translator)
            },
            centimetres(part.sd_m),
            if part.degrees_of_freedom.is_finite() {
                translator.fixed(part.degrees_of_freedom, 0)
            } else {
                String::new()
            },
        ]);
    }
    table.row([
        translator.text("verdict-combined"),
        String::new(),
        centimetres(mean.height_m.sd),
        String::new(),
    ]);
    table
}

/// Repeatability and reproducibility, by what differs.
pub fn precision(factors: &[(&str, &Precision)], translator: &Translator) -> Table {
    let columns = [
        ("verdict-precision-of", Align::Left),
        ("verdict-value", Align::Right),
        ("column-95", Align::Right),
        ("verdict-precision-limit", Align::Right),
    ];
    let mut table = Table::with_headings(translator, columns);
    let mut row = |name: String, sd_m: Estimate| {
        let value = Quantity::of(&sd_m, Unit::Length);
        let limit = Quantity::rounded(Precision::limit_m(sd_m.value), 2, Unit::Length);
        table.row([
            name,
            value.text(translator),
            value.interval_text(sd_m.interval95, translator),
            limit.text(translator),
        ]);
    };
    for (factor, precision) in factors {
        let words = [
            ("factor", (*factor).into()),
            ("levels", precision.levels.into()),
            ("drops", precision.drops.into()),
        ];
        let name = |id: &str| translator.text_with(id, &words);
        row(name("verdict-repeatability"), precision.repeatability_m);
        row(name("verdict-reproducibility"), precision.reproducibility_m);
    }
    table
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
    let columns = [
        ("verdict-file", Align::Left),
        ("verdict-first-flight", Align::Right),
        ("column-plain", Align::Right),
        ("verdict-height", Align::Right),
        ("verdict-model", Align::Right),
    ];
    let mut table = Table::with_headings(translator, columns);
    for drop in drops {
        let shown = |height: Option<f64>| {
            height.map_or_else(
                || translator.text("unit-cannot-tell"),
                |height_m| length(height_m, translator),
            )
        };
        table.row([
            files.get(drop.place).cloned().unwrap_or_default(),
            drop.first_flight_s
                .map_or_else(String::new, |time_s| translator.fixed(time_s, 4)),
            shown(drop.drag_free_m),
            shown(drop.height_m),
            drop.predicted_m.map_or_else(
                || translator.text("unit-cannot-tell"),
                |height| Quantity::of(&height, Unit::Length).text(translator),
            ),
        ]);
    }
    table
}

fn length(metres: f64, translator: &Translator) -> String {
    Quantity::rounded(metres, 4, Unit::Length).text(translator)
}
