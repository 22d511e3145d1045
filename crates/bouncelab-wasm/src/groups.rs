//! The study of kept drops: that of the program.

use std::collections::BTreeMap;

use bouncelab::groups::Group;
use bouncelab_report::chart::Point;
use bouncelab_report::groups::{About, GroupStudy, NotedDrop, Question, Reason, figures, page};
use bouncelab_report::messages::Translator;
use bouncelab_report::report::{Page, Provenance, repeat};

use crate::refusal::{Refusal, Result};
use crate::wire::{Comparable, Studied, StudiedDrop, StudyRequest};

/// Studies drops.
///
/// # Errors
///
/// None that a request can cause.
pub fn study(request: &StudyRequest, translator: &Translator) -> Result<Studied> {
    let Page { lead, sections, .. } = paged(request, translator)?;
    Ok(Studied { lead, sections })
}

/// The report of a study as one HTML file.
///
/// # Errors
///
/// As those of [`study`].
pub fn report(request: &StudyRequest, translator: &Translator) -> Result<String> {
    Ok(paged(request, translator)?.html())
}

fn paged(request: &StudyRequest, translator: &Translator) -> Result<Page> {
    let is_comparable = |drop: &&StudiedDrop| comparable(drop).is_some();
    let studied: Vec<&StudiedDrop> = request.drops.iter().filter(is_comparable).collect();
    let by = request.by.iter().filter(|field| is_noted(&studied, field));
    let question = Question {
        by: by.cloned().collect(),
        ..Question::default()
    };
    // Without a field to group by, a study takes all fields.
    let nothing = BTreeMap::new();
    let is_one_group = question.by.is_empty();
    let noted = studied.iter().filter_map(|drop| {
        let factors = if is_one_group {
            &nothing
        } else {
            &drop.factors
        };
        noted(drop, factors)
    });
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
    let provenance = Provenance {
        made: request.made.clone(),
        ..Provenance::default()
    };
    let to_repeat = repeat(&provenance, translator);
    Ok(page(&groups, &charts, &provenance, to_repeat, translator))
}

/// What a drop adds, if it knows its restitution at a speed at least.
fn comparable(drop: &StudiedDrop) -> Option<&Comparable> {
    let comparable = drop.comparable.as_ref();
    comparable.filter(|comparable| !comparable.curve.0.is_empty())
}

fn is_noted(drops: &[&StudiedDrop], field: &str) -> bool {
    drops.iter().any(|drop| drop.factors.contains_key(field))
}

fn noted<'a>(drop: &StudiedDrop, factors: &'a BTreeMap<String, String>) -> Option<NotedDrop<'a>> {
    let Comparable { curve, scatter } = comparable(drop)?.clone();
    Some(NotedDrop {
        name: drop.name.as_str().into(),
        factors,
        height_m: None,
        temperature_k: None,
        curve,
        scatter,
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
