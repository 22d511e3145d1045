//! The statistics of the drops, as tables for the terminal and for reports.

use bouncelab::groups::{Difference, Group, Mean, MeanAtSpeed, Study};
use bouncelab_report::messages::Value;
use bouncelab_report::{Align, Quantity, Table, Unit};
use bouncelab_session::Outcome;

use crate::language::{text, text_with, translator};

/// Differences of the levels of a factor.
pub(super) fn difference_table(
    outcome: &Outcome<'_>,
    factor: usize,
    differences: &[Difference],
) -> Table {
    let factor = &outcome.factors[factor];
    let mut table = Table::with_headings(
        translator(),
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
            shown.text(translator()),
            shown.interval_text(difference.interval95, translator()),
            probability(difference.p_value),
        ]);
    }
    table
}

/// The groups, and all of them together.
pub(super) fn group_table(outcome: &Outcome<'_>, study: &Study, wanted: Option<f64>) -> Table {
    let mut table = Table::with_headings(
        translator(),
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
    for (name, group) in named_groups(outcome, study) {
        let mean = &group.mean;
        table.row([
            name,
            mean.drops.to_string(),
            shown(group).text(translator()),
            format!(
                "\u{b1} {}",
                Quantity::rounded(group.shared_sd, 1, Unit::Number).text(translator())
            ),
            mean.between
                .map_or_else(String::new, |between| translator().fixed(between, 4)),
            group.between_impacts.map_or_else(String::new, |scatter| {
                format!("{} %", translator().fixed(100.0 * scatter, 2))
            }),
            needed(group, wanted),
        ]);
    }
    table
}

/// The groups with outliers, with and without them.
pub(super) fn without_table(outcome: &Outcome<'_>, study: &Study) -> Table {
    let mut table = Table::with_headings(
        translator(),
        [
            ("session-column-group", Align::Left),
            ("session-column-with", Align::Right),
            ("session-column-drops", Align::Right),
            ("session-column-without", Align::Right),
            ("session-column-drops", Align::Right),
        ],
    );
    for (name, group) in named_groups(outcome, study) {
        if let Some(without) = &group.without_outliers {
            table.row([
                name,
                restitution(&group.mean).text(translator()),
                group.mean.drops.to_string(),
                restitution(without).text(translator()),
                without.drops.to_string(),
            ]);
        }
    }
    table
}

/// Slopes against what is noted in numbers.
pub(super) fn trend_table(outcome: &Outcome<'_>, study: &Study) -> Table {
    let mut table = Table::with_headings(
        translator(),
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
        let name = outcome.factors[trend.factor].name.as_str();
        let unit = match name {
            "height" => text("session-per-metre"),
            "temperature" => text("session-per-kelvin"),
            _ => String::new(),
        };
        let shown = Quantity::measured(trend.slope.value, trend.slope.sd, Unit::Number);
        table.row([
            name.to_owned(),
            trend.levels.to_string(),
            shown.text(translator()),
            unit,
            shown.interval_text(trend.interval95, translator()),
            probability(trend.p_value),
        ]);
    }
    table
}

/// Restitution of each group at several speeds.
pub(super) fn law_table(outcome: &Outcome<'_>, study: &Study) -> Table {
    let mut table = Table::with_headings(
        translator(),
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
            let interval = |ends| shown.interval_text(ends, translator());
            table.row([
                outcome.group_name(&group.levels),
                translator().fixed(*speed_m_s, 3),
                mean.drops.to_string(),
                shown.text(translator()),
                mean.interval95.map_or_else(String::new, interval),
            ]);
        }
    }
    table
}

/// 95 % intervals of the groups.
pub(super) fn interval_table(outcome: &Outcome<'_>, study: &Study) -> Table {
    let mut table = Table::with_headings(
        translator(),
        [
            ("session-column-group", Align::Left),
            ("session-column-mean", Align::Right),
            ("session-column-next", Align::Right),
            ("session-column-between-drops", Align::Right),
        ],
    );
    for (name, group) in named_groups(outcome, study) {
        let interval = |ends: Option<[f64; 2]>| {
            ends.map_or_else(String::new, |ends| {
                shown(group).interval_text(ends, translator())
            })
        };
        let mean = &group.mean;
        table.row([
            name,
            interval(mean.interval95),
            interval(mean.next95),
            mean.between95.map_or_else(String::new, ends),
        ]);
    }
    table
}

/// The groups with their names, and all drops as one where there are several.
fn named_groups<'a>(outcome: &Outcome<'_>, study: &'a Study) -> Vec<(String, &'a Group)> {
    let named = |group: &'a Group| (outcome.group_name(&group.levels), group);
    let mut groups: Vec<_> = study.groups.iter().map(named).collect();
    if groups.len() > 1 {
        groups.push((text("session-all"), &study.all));
    }
    groups
}

fn shown(group: &Group) -> Quantity {
    restitution(&group.mean)
}

fn restitution(mean: &Mean) -> Quantity {
    Quantity::measured(mean.value, mean.standard_error, Unit::Number)
}

fn needed(group: &Group, wanted: Option<f64>) -> String {
    match (group.drops_needed, wanted) {
        (Some(needed), _) => needed.to_string(),
        (None, Some(_)) if group.mean.between.is_some() => text("session-too-many"),
        (None, _) => String::new(),
    }
}

/// Who varies.
pub(super) fn varies_table(outcome: &Outcome<'_>, study: &Study) -> Table {
    let mut table = Table::with_headings(
        translator(),
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
            .map(|&factor| outcome.factors[factor].name.as_str())
            .collect();
        let name = match names.as_slice() {
            [] => text("session-drop"),
            [name] => (*name).to_owned(),
            [first @ .., last] => {
                let (first, last) = (first.join(", "), *last);
                let names = [("first", first.into()), ("last", last.into())];
                let names = [("names", text_with("list-and", &names).into())];
                text_with("session-together", &names)
            }
        };
        table.row([
            name,
            varies.levels.to_string(),
            translator().fixed(varies.component.sd, 4),
            match varies.component.sd95 {
                Some(interval) => ends(interval),
                None => text("session-too-few"),
            },
        ]);
    }
    table
}

fn probability(p: f64) -> String {
    if p < 1e-4 {
        format!("< {}", translator().fixed(1e-4, 4))
    } else {
        translator().fixed(p, 4)
    }
}

fn ends([low, high]: [f64; 2]) -> String {
    let ends = [
        ("low", Value::fixed(low, 4)),
        ("high", Value::fixed(high, 4)),
    ];
    text_with("interval-ends", &ends)
}
