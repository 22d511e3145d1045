//! The report of a session, as a page.

use bouncelab::groups::Study;
use bouncelab_report::Chart;
use bouncelab_report::messages::{Translator, Value};
use bouncelab_report::report::{
    Block, Language, Page, Provenance, Section, ended, made_by, repeat,
};

use crate::document::{AboutSession, Reason};
use crate::name::some_of;
use crate::results::Results;
use crate::study::Outcome;
use crate::summary;

/// With more recordings than this a list of their hashes is no use on paper.
const LISTED: usize = 60;

/// The page of a session: the groups in words, tables and figures ([`figures`](crate::figures()) makes them), what
/// is wrong with which recordings, what was assumed, the method, and how to repeat it. The hashes of few recordings
/// go with the provenance.
pub fn report(
    outcome: &Outcome<'_>,
    results: &Results<'_>,
    charts: &[(&'static str, Chart)],
    provenance: Provenance,
    words: &Translator,
) -> Page {
    let about = &outcome.about;
    let provenance = Provenance {
        files: files(results),
        ..provenance
    };
    let mut sections = match &outcome.study {
        Ok(study) => of_study(outcome, study, charts, words),
        Err(_) => Vec::new(),
    };
    sections.extend([
        troubles(about, words),
        assumed(about, words),
        method(words),
        to_repeat(&provenance, words),
    ]);
    sections.retain(|section| !section.is_empty());
    Page {
        title: about
            .title
            .clone()
            .unwrap_or_else(|| words.text("session-untitled")),
        subtitle: made_by(&provenance, words),
        lead: lead(outcome, about, words),
        sections,
        details: Vec::new(),
        unfolded: false,
        language: Language::new(words),
    }
}

fn lead(outcome: &Outcome<'_>, about: &AboutSession, words: &Translator) -> Vec<Block> {
    let mut lead = vec![Block::Lead(ended(summary::counts(about, words)))];
    match &outcome.study {
        Ok(study) => {
            let speed = [("speed", Value::fixed(study.at_speed_m_s, 2))];
            lead.push(Block::text(words.text_with("session-compared", &speed)));
            if !study.outliers.is_empty() {
                let names: Vec<&str> = study
                    .outliers
                    .iter()
                    .map(|outlier| outcome.name_of(outlier.drop))
                    .collect();
                let names = [("names", names.join(", ").into())];
                lead.push(Block::Note(words.text_with("session-unlike", &names)));
            }
        }
        Err(reason) => {
            let reason = [("reason", ended(reason).into())];
            lead.push(Block::Note(
                words.text_with("session-incomparable", &reason),
            ));
        }
    }
    lead
}

fn of_study(
    outcome: &Outcome<'_>,
    study: &Study,
    charts: &[(&'static str, Chart)],
    words: &Translator,
) -> Vec<Section> {
    let mut charts = charts.iter();
    let mut figure = || {
        let (name, chart) = charts.next()?;
        Some(Block::figure(*name, chart.clone()))
    };
    let (laws, intervals, run) = (figure(), figure(), figure());
    let with = |mut blocks: Vec<Block>, figure: Option<Block>| {
        blocks.extend(figure);
        blocks
    };
    let mut groups = vec![
        Block::table(
            words.text("session-groups-table"),
            summary::group_table(outcome, study, None, words),
        ),
        Block::table(
            words.text("session-intervals-table"),
            summary::interval_table(outcome, study, words),
        ),
    ];
    let without = summary::without_table(outcome, study, words);
    if !without.is_empty() {
        groups.push(Block::table(words.text("session-without-table"), without));
    }
    let varies = if study.varies.len() > 1 {
        vec![Block::table(
            words.text("session-varies-table"),
            summary::varies_table(outcome, study, words),
        )]
    } else {
        Vec::new()
    };
    let differences = study
        .differences
        .iter()
        .filter(|(_, differences)| !differences.is_empty())
        .map(|(factor, differences)| {
            let name = outcome.factors[*factor].name.as_str();
            let table = summary::difference_table(outcome, *factor, differences, words);
            let caption = words.text_with("session-differences-table", &[("factor", name.into())]);
            Block::table(caption, table)
        });
    let trends = summary::trend_table(outcome, study, words);
    let trends = (!trends.is_empty()).then(|| {
        let caption = words.text("session-trends-table");
        Block::table(caption, trends)
    });
    vec![
        Section::new(words.text("session-groups"), with(groups, intervals)),
        Section::new(words.text("session-against-speed"), with(Vec::new(), laws)),
        Section::new(words.text("session-what-varies"), varies),
        Section::new(
            words.text("session-differences-heading"),
            differences.chain(trends).collect(),
        ),
        Section::new(words.text("session-in-order"), with(Vec::new(), run)),
    ]
}

fn troubles(about: &AboutSession, words: &Translator) -> Section {
    let parts = [
        ("session-without-drop", &about.without_drop),
        ("session-failed", &about.failed),
        ("session-duplicates", &about.duplicates),
        ("session-left-out", &about.left_out),
        ("session-odd", &about.odd),
    ];
    let blocks = parts
        .into_iter()
        .filter(|(_, reasons)| !reasons.is_empty())
        .flat_map(|(id, reasons)| {
            [
                Block::text(format!("{}:", words.text(id))),
                Block::List(by_reason(reasons)),
            ]
        });
    Section::new(words.text("session-troubles"), blocks.collect())
}

/// One line for each reason, with the first of those that it is true of.
fn by_reason(reasons: &[Reason]) -> Vec<String> {
    let mut lines: Vec<(&str, Vec<String>)> = Vec::new();
    for Reason { name, reason } in reasons {
        match lines.iter_mut().find(|(known, _)| known == reason) {
            Some((_, names)) => names.push(name.clone()),
            None => lines.push((reason, vec![name.clone()])),
        }
    }
    let line = |(reason, names): (&str, Vec<String>)| format!("{}: {reason}", some_of(&names));
    lines.into_iter().map(line).collect()
}

fn assumed(about: &AboutSession, words: &Translator) -> Section {
    let mut blocks: Vec<Block> = about
        .remarks
        .iter()
        .map(|remark| Block::Note(ended(remark)))
        .collect();
    if !about.assumptions.is_empty() {
        blocks.push(Block::text(words.text("session-assumed")));
        blocks.push(Block::List(about.assumptions.clone()));
    }
    Section::new(words.text("session-conditions"), blocks)
}

fn method(words: &Translator) -> Section {
    let ids = [
        "session-method-drop",
        "session-method-group",
        "session-method-factors",
    ];
    Section::new(
        words.text("session-method"),
        ids.map(|id| Block::text(words.text(id))).into(),
    )
}

fn to_repeat(provenance: &Provenance, words: &Translator) -> Section {
    let mut section = repeat(provenance, words);
    if provenance.files.is_empty() {
        section
            .blocks
            .push(Block::text(words.text("session-hashes")));
    }
    section
}

fn files(results: &Results<'_>) -> Vec<(String, String)> {
    if results.recordings.len() > LISTED {
        return Vec::new();
    }
    std::iter::zip(results.recordings, results.done)
        .filter_map(|(recording, done)| {
            let content = done.content.as_ref().ok()?;
            Some((recording.name().to_owned(), content.to_string()))
        })
        .collect()
}
