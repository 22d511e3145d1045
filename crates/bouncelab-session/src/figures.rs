//! The figures of a session.

use std::collections::{BTreeMap, BTreeSet};

use bouncelab::groups::Group;
use bouncelab_report::Chart;
use bouncelab_report::columns::DropRecord;
use bouncelab_report::messages::Translator;

use crate::error::Result;
use crate::results::Results;
use crate::study::Outcome;

/// Maximum number of impacts of a group that are shown.
const MAX_SHOWN: usize = 600;

/// The [figures of the groups](bouncelab_report::groups::figures()) of a session; empty without a study.
///
/// # Errors
/// Those of [`Results::each`].
pub fn figures(
    outcome: &Outcome<'_>,
    results: &Results<'_>,
    translator: &Translator,
) -> Result<Vec<(&'static str, Chart)>> {
    let Ok(study) = &outcome.groups.study else {
        return Ok(Vec::new());
    };
    let groups = study.groups.iter();
    let impacts = groups
        .map(|group| impacts(outcome, group, results))
        .collect::<Result<_>>()?;
    Ok(bouncelab_report::groups::figures(
        &outcome.groups,
        impacts,
        translator,
    ))
}

/// Impact speed and restitution of some impacts of a group, about the same number from each drop.
fn impacts(outcome: &Outcome<'_>, group: &Group, results: &Results<'_>) -> Result<Vec<[f64; 2]>> {
    let of_each = MAX_SHOWN.div_ceil(group.drops.len());
    // With more drops than shown impacts, one impact of some drops.
    let every = group.drops.len().div_ceil(MAX_SHOWN);
    let some_drops = group.drops.iter().step_by(every);
    let drops = some_drops.map(|&studied| &outcome.drops[outcome.studied[studied]]);
    let wanted: BTreeSet<[usize; 2]> = drops.map(|drop| [drop.recording, drop.number]).collect();
    let of = |recording: usize| wanted.range([recording, 0]..[recording + 1, 0]);
    let mut shown = BTreeMap::new();
    results.each(
        |index| of(index).next().is_some(),
        |index, _, record| {
            for drop in of(index) {
                let impacts = counted_impacts(&record.drops[drop[1] - 1]);
                let step = impacts.len().div_ceil(of_each).max(1);
                let some: Vec<[f64; 2]> = impacts.into_iter().step_by(step).collect();
                shown.insert(drop, some);
            }
            Ok(())
        },
    )?;
    Ok(shown.into_values().flatten().collect())
}

/// Impact speed and restitution of the impacts with a weight above zero.
fn counted_impacts(drop: &DropRecord) -> Vec<[f64; 2]> {
    drop.impacts
        .iter()
        .filter(|impact| impact.weight.unwrap_or(1.0) > 0.0)
        .filter_map(|impact| {
            let measured = impact.restitution.as_ref()?;
            Some([measured.impact_speed_m_s, measured.restitution.value])
        })
        .collect()
}
