//! The study of many drops as tables.

use bouncelab::groups::{Difference, Group, Mean, MeanAtSpeed, Study};

use super::study::{About, GroupStudy};
use crate::messages::{Translator, Value};
use crate::quantity::{Quantity, Unit};
use crate::table::{Align, Table};

/// How many there are of what, in a sentence without its full stop.
pub fn counts(about: &About, translator: &Translator) -> String {
    let counts = [
        ("drops", about.drops.into()),
        ("recordings", about.recordings.into()),
        ("without", about.without_drop.len().into()),
        ("failed", about.failed.len().into()),
        ("duplicates", about.duplicates.len().into()),
    ];
    translator.text_with("session-counts", &counts)
}

/// Differences of the levels of a factor.
pub fn difference_table(
    groups: &GroupStudy,
    factor: usize,
    differences: &[Difference],
    translator: &Translator,
) -> Table {
    let factor = &groups.factors[factor];
    let mut table = Table::with_headings(
        translator,
        [
            ("", Align::Left),
            ("session-column-difference", Align::Right),
            ("session-column-interval", Align::Right),
            ("session-column-p-holm", Align::Right),
        ],
    );
    for difference in differences {
        let shown = Quantity::measured(difference.value.value, difference.value.sd, Unit::Number);
        table.row([
            format!(
                "{} \u{2212} {}",
                factor.levels[difference.of], factor.levels[difference.less]
            ),
            shown.text(translator),
            shown.interval_text(difference.interval95, translator),
            probability(difference.p_value, translator),
        ]);
    }
    table
}

/// The groups, and all of them together.
pub fn group_table(
    groups: &GroupStudy,
    study: &Study,
    wanted: Option<f64>,
    translator: &Translator,
) -> Table {
    let mut table = Table::with_headings(
        translator,
        [
            ("session-column-group", Align::Left),
            ("session-column-drops", Align::Right),
            ("quantity-restitution", Align::Right),
            ("session-column-shared", Align::Right),
            ("session-column-between-drops", Align::Right),
            ("session-column-between-impacts", Align::Right),
            ("session-column-needed", Align::Right),
        ],
    );
    for (name, group) in named_groups(groups, study, translator) {
        let mean = &group.mean;
        table.row([
            name,
            mean.drops.to_string(),
            shown(group).text(translator),
            format!(
                "\u{b1} {}",
                Quantity::rounded(group.shared_sd, 1, Unit::Number).text(translator)
            ),
            mean.between
                .map_or_else(String::new, |between| translator.fixed(between, 4)),
            group.between_impacts.map_or_else(String::new, |scatter| {
                format!("{} %", translator.fixed(100.0 * scatter, 2))
            }),
            needed(group, wanted, translator),
        ]);
    }
    table
}

/// The groups with outliers, with and without them.
pub fn without_table(groups: &GroupStudy, study: &Study, translator: &Translator) -> Table {
    let mut table = Table::with_headings(
        translator,
        [
            ("session-column-group", Align::Left),
            ("session-column-with", Align::Right),
            ("session-column-drops", Align::Right),
            ("session-column-without", Align::Right),
            ("session-column-drops", Align::Right),
        ],
    );
    for (name, group) in named_groups(groups, study, translator) {
        if let Some(without) = &group.without_outliers {
            table.row([
                name,
                restitution(&group.mean).text(translator),
                group.mean.drops.to_string(),
                restitution(without).text(translator),
                without.drops.to_string(),
            ]);
        }
    }
    table
}

/// Slopes against what is noted in numbers.
pub fn trend_table(groups: &GroupStudy, study: &Study, translator: &Translator) -> Table {
    let mut table = Table::with_headings(
        translator,
        [
            ("session-column-factor", Align::Left),
            ("session-column-levels", Align::Right),
            ("session-column-slope", Align::Right),
            ("", Align::Left),
            ("session-column-interval", Align::Right),
            ("session-column-p", Align::Right),
        ],
    );
    for trend in &study.trends {
        let name = groups.factors[trend.factor].name.as_str();
        let unit = match name {
            "height" => translator.text("session-per-metre"),
            "temperature" => translator.text("session-per-kelvin"),
            _ => String::new(),
        };
        let shown = Quantity::measured(trend.slope.value, trend.slope.sd, Unit::Number);
        table.row([
            name.to_owned(),
            trend.levels.to_string(),
            shown.text(translator),
            unit,
            shown.interval_text(trend.interval95, translator),
            probability(trend.p_value, translator),
        ]);
    }
    table
}

/// Restitution of each group at several speeds.
pub fn law_table(groups: &GroupStudy, study: &Study, translator: &Translator) -> Table {
    let mut table = Table::with_headings(
        translator,
        [
            ("session-column-group", Align::Left),
            ("column-speed", Align::Right),
            ("session-column-drops", Align::Right),
            ("quantity-restitution", Align::Right),
            ("session-column-interval", Align::Right),
        ],
    );
    for group in &study.groups {
        for MeanAtSpeed { speed_m_s, mean } in &group.curve {
            let shown = restitution(mean);
            let interval = |ends| shown.interval_text(ends, translator);
            table.row([
                groups.group_name(&group.levels, translator),
                translator.fixed(*speed_m_s, 3),
                mean.drops.to_string(),
                shown.text(translator),
                mean.interval95.map_or_else(String::new, interval),
            ]);
        }
    }
    table
}

/// 95 % intervals of the groups.
pub fn interval_table(groups: &GroupStudy, study: &Study, translator: &Translator) -> Table {
    let mut table = Table::with_headings(
        translator,
        [
            ("session-column-group", Align::Left),
            ("session-column-mean", Align::Right),
            ("session-column-next", Align::Right),
            ("session-column-between-drops", Align::Right),
        ],
    );
    for (name, group) in named_groups(groups, study, translator) {
        let interval = |ends: Option<[f64; 2]>| {
            ends.map_or_else(String::new, |ends| {
                shown(group).interval_text(ends, translator)
            })
        };
        let mean = &group.mean;
        table.row([
            name,
            interval(mean.interval95),
            interval(mean.next95),
            mean.between95
                .map_or_else(String::new, |interval| ends(interval, translator)),
        ]);
    }
    table
}

/// The groups with their names, and all drops as one where there are several.
fn named_groups<'a>(
    groups: &GroupStudy,
    study: &'a Study,
    translator: &Translator,
) -> Vec<(String, &'a Group)> {
    let named = |group: &'a Group| (groups.group_name(&group.levels, translator), group);
    let mut all: Vec<_> = study.groups.iter().map(named).collect();
    if all.len() > 1 {
        all.push((translator.text("session-all"), &study.all));
    }
    all
}

fn shown(group: &Group) -> Quantity {
    restitution(&group.mean)
}

fn restitution(mean: &Mean) -> Quantity {
    Quantity::measured(mean.value, mean.standard_error, Unit::Number)
}

fn needed(group: &Group, wanted: Option<f64>, translator: &Translator) -> String {
    match (group.drops_needed, wanted) {
        (Some(needed), _) => needed.to_string(),
        (None, Some(_)) if group.mean.between.is_some() => translator.text("session-too-many"),
        (None, _) => String::new(),
    }
}

/// Who varies.
pub fn varies_table(groups: &GroupStudy, study: &Study, translator: &Translator) -> Table {
    let mut table = Table::with_headings(
        translator,
        [
            ("", Align::Left),
            ("session-column-count", Align::Right),
            ("session-column-varies", Align::Right),
            ("session-column-interval", Align::Right),
        ],
    );
    for varies in &study.varies {
        let names: Vec<&str> = varies
            .factors
            .iter()
            .map(|&factor| groups.factors[factor].name.as_str())
            .collect();
        let name = match names.as_slice() {
            [] => translator.text("session-drop"),
            [name] => (*name).to_owned(),
            [first @ .., last] => {
                let (first, last) = (first.join(", "), *last);
                let names = [("first", first.into()), ("last", last.into())];
                let names = [("names", translator.text_with("list-and", &names).into())];
                translator.text_with("session-together", &names)
            }
        };
        table.row([
            name,
            varies.levels.to_string(),
            translator.fixed(varies.component.sd, 4),
            match varies.component.sd95 {
                Some(interval) => ends(interval, translator),
                None => translator.text("session-too-few"),
            },
        ]);
    }
    table
}

fn probability(p: f64, translator: &Translator) -> String {
    if p < 1e-4 {
        format!("< {}", translator.fixed(1e-4, 4))
    } else {
        translator.fixed(p, 4)
    }
}

fn ends([low, high]: [f64; 2], translator: &Translator) -> String {
    let ends = [
        ("low", Value::fixed(low, 4)),
        ("high", Value::fixed(high, 4)),
    ];
    translator.text_with("interval-ends", &ends)
}
