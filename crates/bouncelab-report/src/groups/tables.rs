//! The study of many drops as tables.

use bouncelab::Estimate;
use bouncelab::groups::{Compared, Group, Study};

use super::study::{About, GroupStudy};
use crate::messages::Translator;
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

/// The answer in sentences: the restitution of each group, and the difference of two.
pub fn sentences(groups: &GroupStudy, study: &Study, translator: &Translator) -> Vec<String> {
    let of_group = |group: &Group| {
        let restitution = group.restitution?;
        let shown = Quantity::of(&restitution, Unit::Number);
        let arguments = [
            ("group", name(groups, group, translator).into()),
            ("drops", group.count.into()),
            ("value", shown.text(translator).into()),
            (
                "interval",
                shown
                    .interval_text(restitution.interval95, translator)
                    .into(),
            ),
            (
                "speed",
                Quantity::rounded(study.at_speed_m_s, 2, Unit::Speed)
                    .text(translator)
                    .into(),
            ),
            ("scatter", percent(&group.between_drops, translator).into()),
        ];
        Some(translator.text_with("session-in-words", &arguments))
    };
    let mut sentences: Vec<String> = study.groups.iter().filter_map(of_group).collect();
    if let [difference] = study.differences.as_slice()
        && let Some(compared) = difference.at_speed
    {
        let shown = Quantity::of(&compared.difference, Unit::Number);
        let [of, less] = [difference.of, difference.less]
            .map(|group| name(groups, &study.groups[group], translator));
        let arguments = [
            ("of", of.into()),
            ("less", less.into()),
            ("value", shown.text(translator).into()),
            (
                "interval",
                shown
                    .interval_text(compared.difference.interval95, translator)
                    .into(),
            ),
            (
                "probability",
                probability(compared.above_zero, translator).into(),
            ),
        ];
        sentences.push(translator.text_with("session-difference-in-words", &arguments));
    }
    sentences
}

/// The groups.
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
    for group in &study.groups {
        let number = |number: f64, unit: Unit| Quantity::rounded(number, 2, unit).text(translator);
        table.row([
            name(groups, group, translator),
            group.count.to_string(),
            shown(group).map_or_else(String::new, |shown| shown.text(translator)),
            group.shared_sd.map_or_else(String::new, |sd| {
                format!(
                    "\u{b1} {}",
                    Quantity::rounded(sd, 1, Unit::Number).text(translator)
                )
            }),
            percent(&group.between_drops, translator),
            group
                .between_impacts
                .map_or_else(String::new, |scatter| number(scatter, Unit::Percent)),
            match group.drops_needed {
                Some(needed) => needed.to_string(),
                None if wanted.is_some() && group.restitution.is_some() => {
                    translator.text("session-too-many")
                }
                None => String::new(),
            },
        ]);
    }
    table
}

/// 95 % intervals of the groups, and the numbers of ISO 5725.
pub fn interval_table(groups: &GroupStudy, study: &Study, translator: &Translator) -> Table {
    let mut table = Table::with_headings(
        translator,
        [
            ("session-column-group", Align::Left),
            ("session-column-mean", Align::Right),
            ("session-column-next", Align::Right),
            ("session-column-between-drops", Align::Right),
            ("session-column-repeatability", Align::Right),
            ("session-column-reproducibility", Align::Right),
        ],
    );
    for group in &study.groups {
        let interval = |ends: Option<[f64; 2]>| {
            shown(group)
                .zip(ends)
                .map_or_else(String::new, |(shown, ends)| {
                    shown.interval_text(ends, translator)
                })
        };
        let sd = |sd: Option<f64>| {
            sd.map_or_else(String::new, |sd| {
                Quantity::rounded(sd, 2, Unit::Number).text(translator)
            })
        };
        table.row([
            name(groups, group, translator),
            interval(group.restitution.map(|it| it.interval95)),
            interval(group.next95),
            percent_interval(&group.between_drops, translator),
            sd(group.repeatability_sd.map(|it| it.value)),
            sd(group.reproducibility_sd),
        ]);
    }
    table
}

/// Differences of groups.
pub fn difference_table(groups: &GroupStudy, study: &Study, translator: &Translator) -> Table {
    let mut table = Table::with_headings(
        translator,
        [
            ("session-column-group", Align::Left),
            ("session-column-difference", Align::Right),
            ("session-column-interval", Align::Right),
            ("session-column-above", Align::Right),
            ("session-column-over", Align::Right),
            ("session-column-interval", Align::Right),
        ],
    );
    for difference in &study.differences {
        let pair = [difference.of, difference.less]
            .map(|group| name(groups, &study.groups[group], translator));
        let shown = |compared: Option<Compared>| {
            let difference = compared.map(|compared| compared.difference);
            difference.map_or_else(Default::default, |difference| {
                let shown = Quantity::of(&difference, Unit::Number);
                [
                    shown.text(translator),
                    shown.interval_text(difference.interval95, translator),
                ]
            })
        };
        let ([value, interval], [over, over_interval]) =
            (shown(difference.at_speed), shown(difference.over_range));
        let above = difference.at_speed.or(difference.over_range);
        table.row([
            pair.join(" \u{2212} "),
            value,
            interval,
            above.map_or_else(String::new, |compared| {
                probability(compared.above_zero, translator)
            }),
            over,
            over_interval,
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
            ("session-column-without", Align::Right),
        ],
    );
    for group in &study.groups {
        if let (Some(with), Some(without)) = (shown(group), group.without_outliers) {
            table.row([
                name(groups, group, translator),
                with.text(translator),
                Quantity::of(&without, Unit::Number).text(translator),
            ]);
        }
    }
    table
}

/// Restitution of each group at several speeds.
pub fn curve_table(groups: &GroupStudy, study: &Study, translator: &Translator) -> Table {
    let mut table = Table::with_headings(
        translator,
        [
            ("session-column-group", Align::Left),
            ("column-speed", Align::Right),
            ("quantity-restitution", Align::Right),
            ("session-column-interval", Align::Right),
        ],
    );
    for group in &study.groups {
        for point in &group.curve {
            let shown = Quantity::of(&point.restitution, Unit::Number);
            table.row([
                name(groups, group, translator),
                translator.fixed(point.speed_m_s, 3),
                shown.text(translator),
                shown.interval_text(point.restitution.interval95, translator),
            ]);
        }
    }
    table
}

/// The scatter of the levels of each factor that makes no groups.
pub fn scatter_table(groups: &GroupStudy, study: &Study, translator: &Translator) -> Table {
    let mut table = Table::with_headings(
        translator,
        [
            ("", Align::Left),
            ("session-column-count", Align::Right),
            ("session-column-varies", Align::Right),
            ("session-column-interval", Align::Right),
        ],
    );
    for (factor, scatter) in &study.scatters {
        table.row([
            groups.factor_name(*factor, translator),
            groups.factors[*factor].levels.len().to_string(),
            percent(scatter, translator),
            percent_interval(scatter, translator),
        ]);
    }
    table
}

/// The drop heights.
pub fn height_table(groups: &GroupStudy, study: &Study, translator: &Translator) -> Table {
    let mut table = Table::with_headings(
        translator,
        [
            ("session-column-drop", Align::Left),
            ("quantity-drop-height", Align::Right),
            ("session-column-interval", Align::Right),
        ],
    );
    for (drop, fitted) in study.drops.iter().enumerate() {
        if let Some(height_m) = fitted.and_then(|fitted| fitted.height_m) {
            let shown = Quantity::of(&height_m, Unit::Length);
            table.row([
                groups.name_of(drop).to_owned(),
                shown.text(translator),
                shown.interval_text(height_m.interval95, translator),
            ]);
        }
    }
    table
}

/// The zero of the ruler, as a sentence.
pub fn ruler_zero(study: &Study, translator: &Translator) -> Option<String> {
    let zero = study.ruler_zero_m?;
    let shown = Quantity::of(&zero, Unit::Length);
    let arguments = [
        ("value", shown.text(translator).into()),
        (
            "interval",
            shown.interval_text(zero.interval95, translator).into(),
        ),
    ];
    Some(translator.text_with("session-ruler", &arguments))
}

fn name(groups: &GroupStudy, group: &Group, translator: &Translator) -> String {
    groups.group_name(&group.levels, translator)
}

fn shown(group: &Group) -> Option<Quantity> {
    group
        .restitution
        .map(|restitution| Quantity::of(&restitution, Unit::Number))
}

fn percent(scatter: &Estimate, translator: &Translator) -> String {
    Quantity::rounded(scatter.value, 2, Unit::Percent).text(translator)
}

fn percent_interval(scatter: &Estimate, translator: &Translator) -> String {
    let shown = Quantity::measured(scatter.value, scatter.sd, Unit::Percent);
    shown.interval_text(scatter.interval95, translator)
}

fn probability(probability: f64, translator: &Translator) -> String {
    const MIN_SHOWN: f64 = 1e-4;
    if probability < MIN_SHOWN {
        format!("< {}", translator.fixed(MIN_SHOWN, 4))
    } else if probability > 1.0 - MIN_SHOWN {
        format!("> {}", translator.fixed(1.0 - MIN_SHOWN, 4))
    } else {
        translator.fixed(probability, 4)
    }
}
