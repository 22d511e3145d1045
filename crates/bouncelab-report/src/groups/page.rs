//! The study of many drops as a page.

use bouncelab::groups::Study;

use super::study::{About, GroupStudy, Reason};
use super::tables;
use crate::chart::Chart;
use crate::messages::{Translator, Value};
use crate::report::{Block, Language, Page, Provenance, Section, ended, made_by};

/// The page of many drops: the groups in sentences, tables and figures, problems of recordings, what was
/// assumed, the method, and how to repeat it. The charts are its [`figures`](super::figures()).
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
            let speed = [("speed", Value::fixed(study.at_speed_m_s, 2))];
            lead.push(Block::text(
                translator.text_with("session-compared", &speed),
            ));
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
    match (study.all.drops.len(), study.groups.len()) {
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
    let varies = if study.varies.len() > 1 {
        vec![Block::table(
            translator.text("session-varies-table"),
            tables::varies_table(groups, study, translator),
        )]
    } else {
        Vec::new()
    };
    let of_groups = group_tables(groups, study, translator);
    let section = |id: &str, blocks| Section::new(translator.text(id), blocks);
    vec![
        section("session-groups", with(of_groups, intervals)),
        section("session-against-speed", with(Vec::new(), laws)),
        section("session-what-varies", varies),
        section(
            "session-differences-heading",
            differences(groups, study, translator),
        ),
        section("session-in-order", with(Vec::new(), run)),
    ]
}

/// The groups, their intervals, and the groups with outliers with and without them.
fn group_tables(groups: &GroupStudy, study: &Study, translator: &Translator) -> Vec<Block> {
    let mut blocks = vec![
        Block::table(
            translator.text("session-groups-table"),
            tables::group_table(groups, study, None, translator),
        ),
        Block::table(
            translator.text("session-intervals-table"),
            tables::interval_table(groups, study, translator),
        ),
    ];
    let without = tables::without_table(groups, study, translator);
    if !without.is_empty() {
        blocks.push(Block::table(
            translator.text("session-without-table"),
            without,
        ));
    }
    blocks
}

/// The differences between the levels of each factor, and the trends.
fn differences(groups: &GroupStudy, study: &Study, translator: &Translator) -> Vec<Block> {
    let factors = study.differences.iter();
    let factors = factors.filter(|(_, differences)| !differences.is_empty());
    let tables_of_factors = factors.map(|(factor, differences)| {
        let name = groups.factors[*factor].name.as_str();
        let table = tables::difference_table(groups, *factor, differences, translator);
        let caption = translator.text_with("session-differences-table", &[("factor", name.into())]);
        Block::table(caption, table)
    });
    let trends = tables::trend_table(groups, study, translator);
    let trends =
        (!trends.is_empty()).then(|| Block::table(translator.text("session-trends-table"), trends));
    tables_of_factors.chain(trends).collect()
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
        "session-method-factors",
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
