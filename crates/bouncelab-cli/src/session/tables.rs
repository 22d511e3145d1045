//! What the drops say together, as tables for the screen and for reports.

use bouncelab::groups::{Difference, Group, Mean, MeanAtSpeed, Study};
use bouncelab_report::{Align, Quantity, Table, Unit};
use bouncelab_session::Outcome;

/// Differences of the levels of a factor.
pub(super) fn difference_table(
    outcome: &Outcome<'_>,
    factor: usize,
    differences: &[Difference],
) -> Table {
    let factor = &outcome.factors[factor];
    let mut table = Table::new([
        ("", Align::Left),
        ("difference", Align::Right),
        ("95 % interval", Align::Right),
        ("p (Holm)", Align::Right),
    ]);
    for difference in differences {
        let shown = Quantity::measured(difference.value.value, difference.value.sd, Unit::Number);
        table.row([
            format!(
                "{} \u{2212} {}",
                factor.levels[difference.of], factor.levels[difference.less]
            ),
            shown.to_string(),
            shown.interval(difference.interval95),
            probability(difference.p_value),
        ]);
    }
    table
}

/// The groups, and all of them together.
pub(super) fn group_table(outcome: &Outcome<'_>, study: &Study, wanted: Option<f64>) -> Table {
    let mut table = Table::new([
        ("group", Align::Left),
        ("drops", Align::Right),
        ("restitution", Align::Right),
        ("shared", Align::Right),
        ("between drops", Align::Right),
        ("between impacts", Align::Right),
        ("needed", Align::Right),
    ]);
    for (name, group) in named_groups(outcome, study) {
        let mean = &group.mean;
        table.row([
            name,
            mean.drops.to_string(),
            shown(group).to_string(),
            format!(
                "\u{b1} {}",
                Quantity::rounded(group.shared_sd, 1, Unit::Number)
            ),
            mean.between
                .map_or_else(String::new, |between| format!("{between:.4}")),
            group
                .between_impacts
                .map_or_else(String::new, |scatter| format!("{:.2} %", 100.0 * scatter)),
            needed(group, wanted),
        ]);
    }
    table
}

/// The groups with outliers, with and without them.
pub(super) fn without_table(outcome: &Outcome<'_>, study: &Study) -> Table {
    let mut table = Table::new([
        ("group", Align::Left),
        ("with", Align::Right),
        ("drops", Align::Right),
        ("without", Align::Right),
        ("drops", Align::Right),
    ]);
    for (name, group) in named_groups(outcome, study) {
        if let Some(without) = &group.without_outliers {
            table.row([
                name,
                restitution(&group.mean).to_string(),
                group.mean.drops.to_string(),
                restitution(without).to_string(),
                without.drops.to_string(),
            ]);
        }
    }
    table
}

/// Slopes against what is noted in numbers.
pub(super) fn trend_table(outcome: &Outcome<'_>, study: &Study) -> Table {
    let mut table = Table::new([
        ("with", Align::Left),
        ("levels", Align::Right),
        ("slope", Align::Right),
        ("", Align::Left),
        ("95 % interval", Align::Right),
        ("p", Align::Right),
    ]);
    for trend in &study.trends {
        let name = outcome.factors[trend.factor].name.as_str();
        let unit = match name {
            "height" => "per m",
            "temperature" => "per K",
            _ => "",
        };
        let shown = Quantity::measured(trend.slope.value, trend.slope.sd, Unit::Number);
        table.row([
            name.to_owned(),
            trend.levels.to_string(),
            shown.to_string(),
            unit.to_owned(),
            shown.interval(trend.interval95),
            probability(trend.p_value),
        ]);
    }
    table
}

/// Restitution of each group at several speeds.
pub(super) fn law_table(outcome: &Outcome<'_>, study: &Study) -> Table {
    let mut table = Table::new([
        ("group", Align::Left),
        ("speed m/s", Align::Right),
        ("drops", Align::Right),
        ("restitution", Align::Right),
        ("95 % interval", Align::Right),
    ]);
    for group in &study.groups {
        for MeanAtSpeed { speed_m_s, mean } in &group.curve {
            let shown = restitution(mean);
            let interval = |ends| shown.interval(ends);
            table.row([
                outcome.group_name(&group.levels),
                format!("{speed_m_s:.3}"),
                mean.drops.to_string(),
                shown.to_string(),
                mean.interval95.map_or_else(String::new, interval),
            ]);
        }
    }
    table
}

/// 95 % intervals of the groups.
pub(super) fn interval_table(outcome: &Outcome<'_>, study: &Study) -> Table {
    let mut table = Table::new([
        ("group", Align::Left),
        ("mean", Align::Right),
        ("next drop", Align::Right),
        ("between drops", Align::Right),
    ]);
    for (name, group) in named_groups(outcome, study) {
        let interval = |ends: Option<[f64; 2]>| {
            ends.map_or_else(String::new, |ends| shown(group).interval(ends))
        };
        let mean = &group.mean;
        table.row([
            name,
            interval(mean.interval95),
            interval(mean.next95),
            mean.between95
                .map_or_else(String::new, |[low, high]| format!("{low:.4} to {high:.4}")),
        ]);
    }
    table
}

/// The groups with their names, and all drops as one where there are several.
fn named_groups<'a>(outcome: &Outcome<'_>, study: &'a Study) -> Vec<(String, &'a Group)> {
    let named = |group: &'a Group| (outcome.group_name(&group.levels), group);
    let mut groups: Vec<_> = study.groups.iter().map(named).collect();
    if groups.len() > 1 {
        groups.push(("all".to_owned(), &study.all));
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
        (None, Some(_)) if group.mean.between.is_some() => "too many".to_owned(),
        (None, _) => String::new(),
    }
}

/// Who varies.
pub(super) fn varies_table(outcome: &Outcome<'_>, study: &Study) -> Table {
    let mut table = Table::new([
        ("", Align::Left),
        ("how many", Align::Right),
        ("varies by", Align::Right),
        ("95 % interval", Align::Right),
    ]);
    for varies in &study.varies {
        let names: Vec<&str> = varies
            .factors
            .iter()
            .map(|&factor| outcome.factors[factor].name.as_str())
            .collect();
        let name = match names.as_slice() {
            [] => "drop".to_owned(),
            [name] => (*name).to_owned(),
            _ => format!("{} (always together)", names.join(" and ")),
        };
        table.row([
            name,
            varies.levels.to_string(),
            format!("{:.4}", varies.component.sd),
            match varies.component.sd95 {
                Some([low, high]) => format!("{low:.4} to {high:.4}"),
                None => "too few to tell".to_owned(),
            },
        ]);
    }
    table
}

fn probability(p: f64) -> String {
    if p < 1e-4 {
        "< 0.0001".to_owned()
    } else {
        format!("{p:.4}")
    }
}
