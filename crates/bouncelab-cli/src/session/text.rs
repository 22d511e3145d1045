//! The result of a session as text.

use std::fmt::Write;

use bouncelab::diagnostic::Code;
use bouncelab::groups::Study;
use bouncelab_report::Table;
use bouncelab_report::groups::{About, GroupStudy, Reason, tables};
use bouncelab_report::messages::Value;
use bouncelab_session::Outcome;

use crate::analyze::note;
use crate::language::{cannot_tell, text, text_with, translator};

/// Maximum number of lines of a list.
const SHOWN: usize = 8;

/// The whole report.
pub(super) fn report(outcome: &Outcome<'_>, details: bool, wanted: Option<f64>) -> String {
    let mut page = Page::default();
    page.line(&headline(&outcome.groups.about));
    match &outcome.groups.study {
        Ok(study) => page.study(&outcome.groups, study, details, wanted),
        Err(reason) => page.line(&format!(
            "\n{}",
            cannot_tell("session-restitution", reason.as_str())
        )),
    }
    page.troubles(outcome, details);
    page.0
}

fn headline(about: &About) -> String {
    let title = about.title.clone().unwrap_or_else(|| text("session-title"));
    format!(
        "{} {}",
        translator().with_colon(&title),
        tables::counts(about, translator())
    )
}

#[derive(Default)]
struct Page(String);

impl Page {
    fn line(&mut self, content: &str) {
        // Writing to a String cannot fail.
        let _ = writeln!(self.0, "{}", content.trim_end());
    }

    /// A line between empty ones.
    fn heading(&mut self, content: &str) {
        self.line("");
        self.line(content);
        self.line("");
    }

    fn table(&mut self, table: &Table) {
        for row in table.to_string().lines() {
            self.line(&format!("  {row}"));
        }
    }

    fn study(&mut self, groups: &GroupStudy, study: &Study, details: bool, wanted: Option<f64>) {
        let speed = [("speed", Value::fixed(study.at_speed_m_s, 2))];
        self.heading(&text_with("session-speed", &speed));
        self.table(&tables::group_table(groups, study, wanted, translator()));
        self.line("");
        let wanted = wanted.map_or("none".into(), Value::from);
        for row in text_with("session-legend", &[("wanted", wanted)]).lines() {
            self.line(&format!("  {row}"));
        }
        let tables = [
            (
                "session-scatters",
                tables::scatter_table(groups, study, translator()),
            ),
            (
                "session-differences",
                tables::difference_table(groups, study, translator()),
            ),
        ];
        let detailed = || {
            [
                (
                    "session-intervals",
                    tables::interval_table(groups, study, translator()),
                ),
                (
                    "session-curves",
                    tables::curve_table(groups, study, translator()),
                ),
                (
                    "session-drop-heights",
                    tables::height_table(groups, study, translator()),
                ),
            ]
        };
        let detailed = details.then(detailed).into_iter().flatten();
        for (id, table) in tables.into_iter().chain(detailed) {
            if !table.is_empty() {
                self.heading(&text(id));
                self.table(&table);
            }
        }
        if let Some(zero) = tables::ruler_zero(study, translator()) {
            self.line(&format!("\n{zero}"));
        }
        if !study.outliers.is_empty() {
            self.heading(&text("session-outliers"));
            for outlier in &study.outliers {
                let group = study
                    .groups
                    .iter()
                    .find(|g| g.drops.contains(&outlier.drop));
                let group =
                    group.map_or_else(String::new, |g| groups.group_name(&g.levels, translator()));
                let side = if outlier.off > 0.0 { "above" } else { "below" };
                let outlier = [
                    ("name", groups.name_of(outlier.drop).into()),
                    (
                        "off",
                        format!("{} %", translator().fixed(100.0 * outlier.off.abs(), 2)).into(),
                    ),
                    ("side", side.into()),
                    ("group", group.into()),
                    ("score", Value::fixed(outlier.score.abs(), 0)),
                ];
                self.line(&format!("  {}", text_with("session-outlier", &outlier)));
            }
            self.heading(&format!("  {}", text("session-outliers-count")));
            self.table(&tables::without_table(groups, study, translator()));
            self.line(&format!("\n  {}", text("session-exclude")));
        }
    }

    fn troubles(&mut self, outcome: &Outcome<'_>, details: bool) {
        let about = &outcome.groups.about;
        self.line("");
        self.list("session-without-drop", &about.without_drop, details);
        self.list("session-failed", &about.failed, details);
        self.list("session-duplicates", &about.duplicates, details);
        self.list("session-left-out", &about.left_out, details);
        let doubtful: Vec<Reason> = if details {
            about.odd.clone()
        } else {
            let doubtful = outcome.doubtful.iter();
            doubtful.map(|&index| about.odd[index].clone()).collect()
        };
        self.list("session-odd", &doubtful, details);
        for remark in &about.remarks {
            self.line(&note(remark));
        }
        if !about.assumptions.is_empty() {
            let list = [("list", about.assumptions.join(" ").into())];
            self.line(&format!("  {}", text_with("terminal-assumed", &list)));
        }
        let recordings = outcome.recordings.iter();
        let mut assumed = recordings.flat_map(|it| &it.metadata.setup.assumptions);
        if assumed.any(|assumption| assumption.code == Code::AssumedBall) {
            self.line(&note(text("session-ball-assumed")));
        }
    }

    fn list(&mut self, id: &str, reasons: &[Reason], details: bool) {
        if reasons.is_empty() {
            return;
        }
        self.line(&format!("  {}", translator().with_colon(&text(id))));
        let shown = if details { reasons.len() } else { SHOWN };
        for Reason { name, reason } in reasons.iter().take(shown) {
            self.line(&format!("    {} {reason}", translator().with_colon(name)));
        }
        if reasons.len() > shown {
            let more = [("count", (reasons.len() - shown).into())];
            self.line(&format!("    {}", text_with("session-more", &more)));
        }
    }
}
