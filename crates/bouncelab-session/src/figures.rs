//! The figures of a session.

use std::collections::{BTreeMap, BTreeSet};

use bouncelab::groups::Group;
use bouncelab_report::Chart;
use bouncelab_report::messages::Translator;

use crate::error::Result;
use crate::record::DropRecord;
use crate::results::Results;
use crate::study::Outcome;

/// Of a group so many impacts are shown.
const SHOWN: usize = 600;

/// The [figures of the groups](bouncelab_report::groups::figures()) of a session. None if there is no study.
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
    let of_groups = study.groups.iter();
    let of_groups = of_groups.map(|group| impacts(outcome, group, results));
    let impacts = of_groups.collect::<Result<_>>()?;
    Ok(bouncelab_report::groups::figures(
        &outcome.groups,
        impacts,
        translator,
    ))
}

/// Impact speed and restitution of some impacts of a group, as many of each drop.
fn impacts(outcome: &Outcome<'_>, group: &Group, results: &Results<'_>) -> Result<Vec<[f64; 2]>> {
    let of_each = SHOWN.div_ceil(group.drops.len());
    // Of very many drops some are enough.
    let every = group.drops.len().div_ceil(SHOWN);
    let drops = group.drops.iter().step_by(every);
    let drops = drops.map(|&studied| &outcome.drops[outcome.studied[studied]]);
    let wanted: BTreeSet<[usize; 2]> = drops.map(|drop| [drop.recording, drop.number]).collect();
    let of = |recording: usize| wanted.range([recording, 0]..[recording + 1, 0]);
    let mut shown = BTreeMap::new();
    results.each(
        |place| of(place).next().is_some(),
        |place, _, record| {
            for drop in of(place) {
                let known = known_impacts(&record.drops[drop[1] - 1]);
                let step = known.len().div_ceil(of_each).max(1);
                let some: Vec<[f64; 2]> = known.into_iter().step_by(step).collect();
                shown.insert(drop, some);
            }
            Ok(())
        },
    )?;
    Ok(shown.into_values().flatten().collect())
}

/// Impact speed and restitution of the impacts that count.
fn known_impacts(drop: &DropRecord) -> Vec<[f64; 2]> {
    drop.impacts
        .iter()
        .filter(|impact| impact.weight.unwrap_or(1.0) > 0.0)
        .filter_map(|impact| {
            let known = impact.restitution.as_ref()?;
            Some([known.impact_speed_m_s, known.restitution.value])
        })
        .collect()
}
