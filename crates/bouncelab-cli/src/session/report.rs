//! The report of a session, as a page.

use bouncelab::groups::Study;
use bouncelab_report::Chart;
use bouncelab_report::messages::Value;
use bouncelab_report::report::{
    Block, Language, Page, Provenance, Section, ended, made_by, repeat,
};
use bouncelab_session::{AboutSession, Outcome, Reason, Results, figures, some_of};

use super::{tables, text};
use crate::failure::Failure;
use crate::language::{text as message, text_with, translator};
use crate::report::provenance;

/// With more recordings than this a list of their hashes is no use on paper.
const LISTED: usize = 60;

/// The page of a session.
pub(super) fn page(outcome: &Outcome<'_>, results: &Results<'_>) -> Result<Page, Failure> {
    let about = &outcome.about;
    let provenance = Provenance {
        files: files(results),
        ..provenance()
    };
    let mut sections = match &outcome.study {
        Ok(study) => of_study(outcome, study, figures(outcome, results, translator())?),
        Err(_) => Vec::new(),
    };
    sections.extend([
        troubles(about),
        assumed(about),
        method(),
        to_repeat(&provenance),
    ]);
    sections.retain(|section| !section.is_empty());
    Ok(Page {
        title: about
            .title
            .clone()
            .unwrap_or_else(|| message("session-untitled")),
        subtitle: made_by(&provenance, translator()),
        lead: lead(outcome, about),
        sections,
        details: Vec::new(),
        unfolded: false,
        language: Language::new(translator()),
    })
}

fn lead(outcome: &Outcome<'_>, about: &AboutSession) -> Vec<Block> {
    let mut lead = vec![Block::Lead(ended(text::counts(about)))];
    match &outcome.study {
        Ok(study) => {
            let speed = [("speed", Value::fixed(study.at_speed_m_s, 2))];
            lead.push(Block::text(text_with("session-compared", &speed)));
            if !study.outliers.is_empty() {
                let names: Vec<&str> = study
                    .outliers
                    .iter()
                    .map(|outlier| outcome.name_of(outlier.drop))
                    .collect();
                let names = [("names", names.join(", ").into())];
                lead.push(Block::Note(text_with("session-unlike", &names)));
            }
        }
        Err(reason) => {
            let reason = [("reason", ended(reason).into())];
            lead.push(Block::Note(text_with("session-incomparable", &reason)));
        }
    }
    lead
}

fn of_study(
    outcome: &Outcome<'_>,
    study: &Study,
    drawn: Vec<(&'static str, Chart)>,
) -> Vec<Section> {
    let mut drawn = drawn.into_iter();
    let mut figure = || {
        drawn
            .next()
            .map(|(name, figure)| Block::figure(name, figure))
    };
    let (laws, intervals, run) = (figure(), figure(), figure());
    let with = |mut blocks: Vec<Block>, figure: Option<Block>| {
        blocks.extend(figure);
        blocks
    };
    let mut groups = vec![
        Block::table(
            message("session-groups-table"),
            tables::group_table(outcome, study, None),
        ),
        Block::table(
            message("session-intervals-table"),
            tables::interval_table(outcome, study),
        ),
    ];
    let without = tables::without_table(outcome, study);
    if !without.is_empty() {
        groups.push(Block::table(message("session-without-table"), without));
    }
    let varies = if study.varies.len() > 1 {
        vec![Block::table(
            message("session-varies-table"),
            tables::varies_table(outcome, study),
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
            let table = tables::difference_table(outcome, *factor, differences);
            let caption = text_with("session-differences-table", &[("factor", name.into())]);
            Block::table(caption, table)
        });
    let trends = tables::trend_table(outcome, study);
    let trends = (!trends.is_empty()).then(|| {
        let caption = message("session-trends-table");
        Block::table(caption, trends)
    });
    vec![
        Section::new(message("session-groups"), with(groups, intervals)),
        Section::new(message("session-against-speed"), with(Vec::new(), laws)),
        Section::new(message("session-what-varies"), varies),
        Section::new(
            message("session-differences-heading"),
            differences.chain(trends).collect(),
        ),
        Section::new(message("session-in-order"), with(Vec::new(), run)),
    ]
}

fn troubles(about: &AboutSession) -> Section {
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
                Block::text(format!("{}:", message(id))),
                Block::List(by_reason(reasons)),
            ]
        });
    Section::new(message("session-troubles"), blocks.collect())
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

fn assumed(about: &AboutSession) -> Section {
    let mut blocks: Vec<Block> = about
        .remarks
        .iter()
        .map(|remark| Block::Note(ended(remark)))
        .collect();
    if !about.assumptions.is_empty() {
        blocks.push(Block::text(message("session-assumed")));
        blocks.push(Block::List(about.assumptions.clone()));
    }
    Section::new(message("session-conditions"), blocks)
}

fn method() -> Section {
    let ids = [
        "session-method-drop",
        "session-method-group",
        "session-method-factors",
    ];
    Section::new(
        message("session-method"),
        ids.map(|id| Block::text(message(id))).into(),
    )
}

fn to_repeat(provenance: &Provenance) -> Section {
    let mut section = repeat(provenance, translator());
    if provenance.files.is_empty() {
        section.blocks.push(Block::text(message("session-hashes")));
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
