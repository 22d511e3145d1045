//! A session for people: what matters at a glance.

use std::fmt::Write;

use bouncelab::groups::{Difference, Group, Mean, Study};
use bouncelab_report::document::{AboutSession, Reason};
use bouncelab_report::{Align, CANNOT_TELL, Quantity, Table, Unit};

use super::outcome::Outcome;

/// Lines of a list that may go on for long.
const SHOWN: usize = 8;

/// The whole report.
pub(super) fn report(outcome: &Outcome<'_>, details: bool, wanted: Option<f64>) -> String {
    let mut page = Page::default();
    page.line(&headline(&outcome.about));
    match &outcome.study {
        Ok(study) => page.study(outcome, study, details, wanted),
        Err(reason) => page.line(&format!("\nRestitution: {CANNOT_TELL}: {reason}.")),
    }
    page.troubles(outcome, details);
    page.0
}

fn headline(about: &AboutSession) -> String {
    let title = about.title.as_deref().unwrap_or("Session");
    format!("{title}: {}", counts(about))
}

/// How many there are of what.
pub(super) fn counts(about: &AboutSession) -> String {
    let count = |count: usize, one: &str, more: &str| match count {
        1 => format!("1 {one}"),
        _ => format!("{count} {more}"),
    };
    let mut parts = vec![format!(
        "{} in {}",
        count(about.drops, "drop", "drops"),
        count(about.recordings, "recording", "recordings")
    )];
    let troubles = [
        (about.without_drop.len(), "without a drop"),
        (about.failed.len(), "not readable"),
        (about.duplicates.len(), "the same as another"),
    ];
    parts.extend(
        troubles
            .into_iter()
            .filter(|(count, _)| *count > 0)
            .map(|(count, what)| format!("{count} {what}")),
    );
    parts.join(", ")
}

#[derive(Default)]
struct Page(String);

impl Page {
    fn line(&mut self, words: &str) {
        // Writing to a String cannot fail.
        let _ = writeln!(self.0, "{}", words.trim_end());
    }

    fn table(&mut self, table: &Table) {
        for row in table.to_string().lines() {
            self.line(&format!("  {row}"));
        }
    }

    fn study(&mut self, outcome: &Outcome<'_>, study: &Study, details: bool, wanted: Option<f64>) {
        self.line(&format!(
            "\nRestitution at an impact speed of {:.2} m/s:\n",
            study.at_speed_m_s
        ));
        self.table(&group_table(outcome, study, wanted));
        self.line(&format!(
            "\n  \u{b1}: standard error of the mean; shared: what all drops have in common (drag law, air, \
             ball), which\n  no number of drops makes smaller; {}",
            match wanted {
                Some(wanted) => format!("needed: drops in all for a mean known to \u{b1} {wanted} (95 %)"),
                None => "needed: drops in all that would halve the interval".to_owned(),
            }
        ));
        if details {
            self.line("\n95 % intervals of restitution:\n");
            self.table(&interval_table(outcome, study));
        }
        if study.varies.len() > 1 {
            self.line("\nWho varies (standard deviation of restitution):\n");
            self.table(&varies_table(outcome, study));
        }
        for (factor, differences) in &study.differences {
            let grouped = outcome.by.contains(factor);
            if (grouped || details) && !differences.is_empty() {
                self.differences(outcome, *factor, differences, details);
            }
        }
        if !study.trends.is_empty() {
            self.line("\nHow restitution changes, all else equal:\n");
            self.table(&trend_table(outcome, study));
        }
        if details {
            self.law(outcome, study);
        }
        if !study.outliers.is_empty() {
            self.line("\nThese do not belong to their group; is what was noted of them right?\n");
            for outlier in &study.outliers {
                let group = study
                    .groups
                    .iter()
                    .find(|g| g.drops.contains(&outlier.drop));
                let group = group.map_or_else(String::new, |g| outcome.group_name(&g.levels));
                let side = if outlier.off > 0.0 { "above" } else { "below" };
                self.line(&format!(
                    "  {}: {:.4} {side} the others of {group}, {:.0} standard deviations",
                    outcome.name_of(outlier.drop),
                    outlier.off.abs(),
                    outlier.score.abs()
                ));
            }
            self.line("\n  They count in all of the above. With and without them:\n");
            self.table(&without_table(outcome, study));
            self.line("\n  --exclude NAME leaves one out of everything.");
        }
    }

    fn differences(
        &mut self,
        outcome: &Outcome<'_>,
        place: usize,
        differences: &[Difference],
        details: bool,
    ) {
        const MOST: usize = 10;
        let factor = &outcome.factors[place];
        let others = outcome
            .factors
            .iter()
            .filter(|f| f.levels.len() > 1)
            .count()
            > 1;
        self.line(&format!(
            "\nDifferences by {}{}:\n",
            factor.name,
            if others { ", all else equal" } else { "" }
        ));
        let most = if details {
            differences.len()
        } else {
            MOST.min(differences.len())
        };
        self.table(&difference_table(outcome, place, &differences[..most]));
        if differences.len() > most {
            let more = differences.len() - most;
            self.line(&format!("  and {more} more (--details)"));
        }
    }

    fn law(&mut self, outcome: &Outcome<'_>, study: &Study) {
        self.line("\nRestitution against impact speed, pooled over the drops that know it:\n");
        let mut table = Table::new([
            ("group", Align::Left),
            ("speed m/s", Align::Right),
            ("drops", Align::Right),
            ("restitution", Align::Right),
            ("95 % interval", Align::Right),
        ]);
        for group in &study.groups {
            for (speed_m_s, mean) in &group.law {
                let shown = Quantity::measured(mean.value, mean.standard_error, Unit::Number);
                table.row([
                    outcome.group_name(&group.levels),
                    format!("{speed_m_s:.3}"),
                    mean.drops.to_string(),
                    shown.to_string(),
                    mean.interval95
                        .map_or_else(String::new, |ends| shown.interval(ends)),
                ]);
            }
        }
        self.table(&table);
    }

    fn troubles(&mut self, outcome: &Outcome<'_>, details: bool) {
        let about = &outcome.about;
        self.line("");
        self.list("Without a drop:", &about.without_drop, details);
        self.list("Not readable:", &about.failed, details);
        self.list(
            "The same sound as another, which counts:",
            &about.duplicates,
            details,
        );
        self.list("Not compared:", &about.left_out, details);
        let doubtful: Vec<Reason> = if details {
            about.odd.clone()
        } else {
            let doubtful = outcome.doubtful.iter();
            doubtful.map(|&place| about.odd[place].clone()).collect()
        };
        self.list("To be looked at:", &doubtful, details);
        for remark in &about.remarks {
            self.line(&format!("  Note: {remark}."));
        }
        if !about.assumptions.is_empty() {
            self.line(&format!("  Assumed: {}.", about.assumptions.join("; ")));
        }
    }

    fn list(&mut self, heading: &str, reasons: &[Reason], details: bool) {
        if reasons.is_empty() {
            return;
        }
        self.line(&format!("  {heading}"));
        let shown = if details { reasons.len() } else { SHOWN };
        for Reason { name, reason } in reasons.iter().take(shown) {
            // A reason may begin with the path of the recording.
            let words = match reason.split_once(": ") {
                Some((path, rest)) if path.ends_with(name.as_str()) => rest,
                _ => reason,
            };
            self.line(&format!("    {name}: {words}"));
        }
        if reasons.len() > shown {
            self.line(&format!(
                "    and {} more (--details)",
                reasons.len() - shown
            ));
        }
    }
}

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
