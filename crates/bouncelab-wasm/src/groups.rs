//! The study of kept drops: that of the program.

use bouncelab::groups::Group;
use bouncelab_report::Chart;
use bouncelab_report::chart::Point;
use bouncelab_report::groups::{About, GroupStudy, NotedDrop, Question, Reason, figures, page};
use bouncelab_report::messages::Translator;
use bouncelab_report::report::{Page, Provenance, repeat};

use crate::refusal::{Refusal, Result};
use crate::wire::{Comparable, Studied, StudiedDrop, StudyRequest};

/// Charts with their names.
type Charts = Vec<(&'static str, Chart)>;

/// Studies drops.
///
/// # Errors
///
/// None that a request can cause.
pub fn study(request: &StudyRequest, translator: &Translator) -> Result<Studied> {
    let (groups, mut charts) = compared(request, translator)?;
    let school = charts.iter().position(|(name, _)| *name == "intervals");
    let figure = school.map(|index| charts.remove(index).1);
    let Page { lead, sections, .. } = paged(request, &groups, &charts, translator);
    Ok(Studied {
        lead,
        figure,
        sections,
    })
}

/// The report of a study as one HTML file.
///
/// # Errors
///
/// As those of [`study`].
pub fn report(request: &StudyRequest, translator: &Translator) -> Result<String> {
    let (groups, charts) = compared(request, translator)?;
    Ok(paged(request, &groups, &charts, translator).html())
}

/// The study with its figures.
fn compared(request: &StudyRequest, translator: &Translator) -> Result<(GroupStudy, Charts)> {
    let is_comparable = |drop: &&StudiedDrop| comparable(drop).is_some();
    let studied: Vec<&StudiedDrop> = request.drops.iter().filter(is_comparable).collect();
    let by = request.by.iter().filter(|field| is_noted(&studied, field));
    let question = Question {
        by: Some(by.cloned().collect()),
        ..Question::default()
    };
    let noted = studied.iter().filter_map(|drop| noted(drop));
    let groups = GroupStudy::of(
        about(request, translator),
        noted.collect(),
        &question,
        translator,
    )
    .map_err(|unknown| Refusal::fault(unknown.to_string()))?;
    let impacts = |group: &Group| -> Vec<Point> {
        let drops = group.drops.iter().map(|&drop| studied[drop]);
        drops
            .flat_map(|drop| drop.impacts.iter().copied())
            .collect()
    };
    let of_groups = groups.study.iter().flat_map(|study| &study.groups);
    let charts = figures(&groups, of_groups.map(impacts).collect(), translator);
    Ok((groups, charts))
}

fn paged(
    request: &StudyRequest,
    groups: &GroupStudy,
    charts: &Charts,
    translator: &Translator,
) -> Page {
    let provenance = Provenance {
        made: request.made.clone(),
        ..Provenance::default()
    };
    let to_repeat = repeat(&provenance, translator);
    page(groups, charts, &provenance, to_repeat, translator)
}

/// What a drop adds, if it says anything of the curve.
fn comparable(drop: &StudiedDrop) -> Option<&Comparable> {
    let comparable = drop.comparable.as_ref();
    comparable.filter(|comparable| comparable.evidence.is_usable())
}

fn is_noted(drops: &[&StudiedDrop], field: &str) -> bool {
    drops.iter().any(|drop| drop.factors.contains_key(field))
}

fn noted(drop: &StudiedDrop) -> Option<NotedDrop<'_>> {
    let Comparable { evidence, scatter } = comparable(drop)?.clone();
    Some(NotedDrop {
        name: drop.name.as_str().into(),
        factors: &drop.factors,
        evidence,
        scatter: Some(scatter),
    })
}

fn about(request: &StudyRequest, translator: &Translator) -> About {
    let drops = &request.drops;
    let unknown = drops.iter().filter(|drop| comparable(drop).is_none());
    About {
        title: Some(request.title.clone()),
        recordings: drops.len(),
        drops: drops.len(),
        left_out: unknown
            .map(|drop| Reason {
                name: drop.name.clone(),
                reason: translator.text("session-no-curve"),
            })
            .collect(),
        ..About::default()
    }
}
