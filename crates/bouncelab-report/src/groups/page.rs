//! The study of many drops as a page.

use bouncelab::groups::Study;

use super::study::{About, GroupStudy, Reason};
use super::tables;
use crate::chart::Chart;
use crate::messages::Translator;
use crate::report::{Block, Language, Page, Provenance, Section, ended, made_by};
use crate::table::Table;

/// A longer list of heights is of no use on paper: the table of drops has it.
const MAX_HEIGHTS: usize = 60;

/// The page of many drops: the groups in sentences, tables and figures, problems of recordings, what was
/// assumed, the method, and how to repeat it. The charts are its [`figures`](super::figures()), all or some of them.
pub fn page(
    groups: &GroupStudy,
    charts: &[(&'static str, Chart)],
    provenance: &Provenance,
    to_repeat: Section,
    translator: &Translator,
) -> Page {
    let about = &groups.about;
    let mut sections = match &groups.study {
        Ok(study) => of_study(groups, study, charts, translator),
        Err(_) => Vec::new(),
    };
    sections.extend([
        troubles(about, translator),
        assumed(about, translator),
        method(translator),
        to_repeat,
    ]);
    sections.retain(|section| !section.is_empty());
    let untitled = || translator.text("session-untitled");
    Page {
        title: about.title.clone().unwrap_or_else(untitled),
        subtitle: made_by(provenance, translator),
        lead: lead(groups, translator),
        sections,
        details: Vec::new(),
        unfolded: false,
        foot: String::new(),
        compact: false,
        logo: None,
        language: Language::new(translator),
    }
}

fn lead(groups: &GroupStudy, translator: &Translator) -> Vec<Block> {
    let mut lead = vec![Block::Lead(ended(tables::counts(
        &groups.about,
        translator,
    )))];
    match &groups.study {
        Ok(study) => {
            lead.extend(
                tables::sentences(groups, study, translator)
                    .into_iter()
                    .map(Block::text),
            );
            if !study.outliers.is_empty() {
                let names: Vec<&str> = study
                    .outliers
                    .iter()
                    .map(|outlier| groups.name_of(outlier.drop))
                    .collect();
                let names = [("names", names.join(", ").into())];
                lead.push(Block::Note(translator.text_with("session-unlike", &names)));
            }
            lead.extend(untold(study).map(|id| Block::Note(translator.text(id))));
        }
        Err(reason) => {
            let reason = [("reason", ended(reason).into())];
            lead.push(Block::Note(
                translator.text_with("session-incomparable", &reason),
            ));
        }
    }
    lead
}

/// What few drops, or drops of a single group, leave undetermined.
fn untold(study: &Study) -> Option<&'static str> {
    match (study.drops.iter().flatten().count(), study.groups.len()) {
        (1, _) => Some("session-one-drop"),
        (_, 1) => Some("session-one-group"),
        _ => None,
    }
}

fn of_study(
    groups: &GroupStudy,
    study: &Study,
    charts: &[(&'static str, Chart)],
    translator: &Translator,
) -> Vec<Section> {
    let figure = |wanted: &str| {
        let (name, chart) = charts.iter().find(|(name, _)| *name == wanted)?;
        Some(Block::figure(*name, chart.clone()))
    };
    let tabled = |id: &str, table: Table| {
        (!table.is_empty()).then(|| Block::table(translator.text(id), table))
    };
    let section = |id: &str, blocks: Vec<Option<Block>>| {
        Section::new(translator.text(id), blocks.into_iter().flatten().collect())
    };
    let heights = tables::height_table(groups, study, translator);
    let zero = tables::ruler_zero(study, translator).map(Block::text);
    let groups_table = tables::group_table(groups, study, None, translator);
    vec![
        section(
            "session-groups",
            vec![
                tabled("session-groups-table", groups_table),
                tabled(
                    "session-intervals-table",
                    tables::interval_table(groups, study, translator),
                ),
                tabled(
                    "session-without-table",
                    tables::without_table(groups, study, translator),
                ),
                tabled(
                    "session-scatter-table",
                    tables::scatter_table(groups, study, translator),
                ),
                figure("intervals"),
            ],
        ),
        section(
            "session-against-speed",
            vec![
                figure("groups"),
                tabled(
                    "session-curve-table",
                    tables::curve_table(groups, study, translator),
                ),
            ],
        ),
        section(
            "session-differences-heading",
            vec![tabled(
                "session-differences-table",
                tables::difference_table(groups, study, translator),
            )],
        ),
        section(
            "session-heights",
            vec![
                zero,
                tabled("session-heights-table", heights)
                    .filter(|_| study.drops.len() <= MAX_HEIGHTS),
            ],
        ),
        section("session-in-order", vec![figure("run")]),
    ]
}

fn troubles(about: &About, translator: &Translator) -> Section {
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
                Block::text(translator.with_colon(&translator.text(id))),
                Block::List(by_reason(reasons, translator)),
            ]
        });
    Section::new(translator.text("session-troubles"), blocks.collect())
}

/// One line for each reason, with the first of those that it is true of.
fn by_reason(reasons: &[Reason], translator: &Translator) -> Vec<String> {
    let mut lines: Vec<(&str, Vec<String>)> = Vec::new();
    for Reason { name, reason } in reasons {
        match lines.iter_mut().find(|(known, _)| known == reason) {
            Some((_, names)) => names.push(name.clone()),
            None => lines.push((reason, vec![name.clone()])),
        }
    }
    let line = |(reason, names): (&str, Vec<String>)| {
        format!(
            "{} {reason}",
            translator.with_colon(&some_of(&names, translator))
        )
    };
    lines.into_iter().map(line).collect()
}

fn assumed(about: &About, translator: &Translator) -> Section {
    let mut blocks: Vec<Block> = about
        .remarks
        .iter()
        .map(|remark| Block::Note(ended(remark)))
        .collect();
    if !about.assumptions.is_empty() {
        blocks.push(Block::text(translator.text("session-assumed")));
        blocks.push(Block::List(about.assumptions.clone()));
    }
    Section::new(translator.text("session-conditions"), blocks)
}

fn method(translator: &Translator) -> Section {
    let ids = [
        "session-method-drop",
        "session-method-group",
        "session-method-scatter",
    ];
    Section::new(
        translator.text("session-method"),
        ids.map(|id| Block::text(translator.text(id))).into(),
    )
}

/// The first few of many names.
pub fn some_of(names: &[String], translator: &Translator) -> String {
    const SHOWN: usize = 4;
    match names.len() {
        count if count > SHOWN + 1 => translator.text_with(
            "list-more",
            &[
                ("first", names[..SHOWN].join(", ").into()),
                ("count", (count - SHOWN).into()),
            ],
        ),
        _ => names.join(", "),
    }
}
