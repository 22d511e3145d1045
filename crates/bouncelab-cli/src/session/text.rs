//! A session for people: what matters at a glance.

use std::fmt::Write;

use bouncelab::groups::{Difference, Study};
use bouncelab_report::report::ended;
use bouncelab_report::{CANNOT_TELL, Table};
use bouncelab_session::{AboutSession, Outcome, Reason};

use super::tables;

/// Lines of a list that may go on for long.
const SHOWN: usize = 8;

/// The whole report.
pub(super) fn report(outcome: &Outcome<'_>, details: bool, wanted: Option<f64>) -> String {
    let mut page = Page::default();
    page.line(&headline(&outcome.about));
    match &outcome.study {
        Ok(study) => page.study(outcome, study, details, wanted),
        Err(reason) => page.line(&format!("\nRestitution: {CANNOT_TELL}: {}", ended(reason))),
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
        self.table(&tables::group_table(outcome, study, wanted));
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
            self.table(&tables::interval_table(outcome, study));
        }
        if study.varies.len() > 1 {
            self.line("\nWho varies (standard deviation of restitution):\n");
            self.table(&tables::varies_table(outcome, study));
        }
        for (factor, differences) in &study.differences {
            let grouped = outcome.by.contains(factor);
            if (grouped || details) && !differences.is_empty() {
                self.differences(outcome, *factor, differences, details);
            }
        }
        if !study.trends.is_empty() {
            self.line("\nHow restitution changes, all else equal:\n");
            self.table(&tables::trend_table(outcome, study));
        }
        if details {
            self.line("\nRestitution against impact speed, pooled over the drops that know it:\n");
            self.table(&tables::law_table(outcome, study));
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
            self.table(&tables::without_table(outcome, study));
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
        self.table(&tables::difference_table(
            outcome,
            place,
            &differences[..most],
        ));
        if differences.len() > most {
            let more = differences.len() - most;
            self.line(&format!("  and {more} more (--details)"));
        }
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
            self.line(&format!("  Note: {}", ended(remark)));
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
            self.line(&format!("    {name}: {reason}"));
        }
        if reasons.len() > shown {
            self.line(&format!(
                "    and {} more (--details)",
                reasons.len() - shown
            ));
        }
    }
}
