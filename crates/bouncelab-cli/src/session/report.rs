//! The report of a session, as a page.

use bouncelab::groups::Study;
use bouncelab_report::Chart;
use bouncelab_report::report::{Block, Language, Page, Provenance, Section, ended, repeat};
use bouncelab_session::{AboutSession, Outcome, Reason, Results, some_of};

use super::figures;
use super::{tables, text};
use crate::failure::Failure;
use crate::language::translator;
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
        Ok(study) => of_study(outcome, study, figures::figures(outcome, results)?),
        Err(_) => Vec::new(),
    };
    sections.extend([
        troubles(about),
        assumed(about),
        method(),
        to_repeat(&provenance),
    ]);
    sections.retain(|section| !section.is_empty());
    let made = provenance.made.as_deref().unwrap_or_default();
    Ok(Page {
        title: about
            .title
            .clone()
            .unwrap_or_else(|| "A session".to_owned()),
        subtitle: format!("Report of bouncelab {}, {made}", env!("CARGO_PKG_VERSION")),
        lead: lead(outcome, about),
        sections,
        language: Language::new(translator()),
    })
}

fn lead(outcome: &Outcome<'_>, about: &AboutSession) -> Vec<Block> {
    let mut lead = vec![Block::Lead(format!("{}.", text::counts(about)))];
    match &outcome.study {
        Ok(study) => {
            lead.push(Block::text(format!(
                "Drops are compared by their restitution at an impact speed of {:.2} m/s, which most of \
                 them know, with the drag of the air taken out.",
                study.at_speed_m_s
            )));
            if !study.outliers.is_empty() {
                let names: Vec<&str> = study
                    .outliers
                    .iter()
                    .map(|outlier| outcome.name_of(outlier.drop))
                    .collect();
                lead.push(Block::Note(format!(
                    "Not like the others of their group, and counted all the same: {}.",
                    names.join(", ")
                )));
            }
        }
        Err(reason) => lead.push(Block::Note(format!(
            "Nothing can be compared: {}",
            ended(reason)
        ))),
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
            "Restitution by group: mean and its standard error, what all drops share, scatter between \
             drops and between impacts, and how many drops would halve the interval",
            tables::group_table(outcome, study, None),
        ),
        Block::table(
            "95 % intervals of the mean, of the next drop, and of the scatter between drops",
            tables::interval_table(outcome, study),
        ),
    ];
    let without = tables::without_table(outcome, study);
    if !without.is_empty() {
        groups.push(Block::table(
            "With and without the drops that are not like the others of their group",
            without,
        ));
    }
    let varies = if study.varies.len() > 1 {
        vec![Block::table(
            "Standard deviation of the restitution by what varies",
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
            let name = &outcome.factors[*factor].name;
            let table = tables::difference_table(outcome, *factor, differences);
            Block::table(format!("Differences by {name}, all else equal"), table)
        });
    let trends = tables::trend_table(outcome, study);
    let trends = (!trends.is_empty()).then(|| {
        let caption = "Change of restitution with what is noted in numbers, all else equal";
        Block::table(caption, trends)
    });
    vec![
        Section::new("Groups", with(groups, intervals)),
        Section::new("Restitution against speed", with(Vec::new(), laws)),
        Section::new("Who varies", varies),
        Section::new("Differences", differences.chain(trends).collect()),
        Section::new("In order", with(Vec::new(), run)),
    ]
}

fn troubles(about: &AboutSession) -> Section {
    let parts = [
        ("Without a drop", &about.without_drop),
        ("Not readable", &about.failed),
        ("The same sound as another, which counts", &about.duplicates),
        ("Not compared", &about.left_out),
        ("To be looked at", &about.odd),
    ];
    let blocks = parts
        .into_iter()
        .filter(|(_, reasons)| !reasons.is_empty())
        .flat_map(|(heading, reasons)| {
            [
                Block::text(format!("{heading}:")),
                Block::List(by_reason(reasons)),
            ]
        });
    Section::new("What did not work", blocks.collect())
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
        blocks.push(Block::text("Nobody noted these, so they were assumed:"));
        blocks.push(Block::List(about.assumptions.clone()));
    }
    Section::new("Conditions", blocks)
}

fn method() -> Section {
    let words = [
        "Each drop is inferred by itself: fall, drag, impacts that scatter, times with errors. Its \
         restitution at the common speed has an uncertainty of its own (timing, scatter of the \
         impacts) and one that it shares with all drops of the ball (drag law, air, mass, diameter, \
         contact). Only the first kind averages out over drops.",
        "A group is described by a random-effects model, a scatter between drops beside the error of \
         each: restricted maximum likelihood (Viechtbauer 2005), standard error of Hartung and Knapp \
         (2001) in the form of R\u{f6}ver, Knapp and Friede (2015), Student's t, Q-profile interval \
         for the scatter (Viechtbauer 2007), interval for the next drop (Higgins, Thompson and \
         Spiegelhalter 2009).",
        "Who varies, and differences with all else equal, come from a mixed model with crossed random \
         factors (Patterson and Thompson 1971), degrees of freedom after Satterthwaite (Giesbrecht and \
         Burns 1985); with a single factor from Welch (1947). Probabilities are adjusted for the number \
         of differences (Holm 1979). Outliers are named by modified z-scores above 3.5 (Iglewicz and \
         Hoaglin 1993), and left in.",
    ];
    Section::new("Method", words.map(Block::text).into())
}

fn to_repeat(provenance: &Provenance) -> Section {
    let mut section = repeat(provenance, translator());
    if provenance.files.is_empty() {
        section.blocks.push(Block::text(
            "The SHA-256 of every recording stands in the table of drops (content_sha256).",
        ));
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
