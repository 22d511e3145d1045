//! The figures of a session.

use std::collections::{BTreeMap, BTreeSet};

use bouncelab::Estimate;
use bouncelab::groups::{Group, MeanAtSpeed, Study, run_limit};
use bouncelab_report::Chart;
use bouncelab_report::figure::{self, GroupCurve, GroupInterval, GroupPoint, RunPoint};
use bouncelab_report::messages::Translator;

use crate::error::Result;
use crate::record::DropRecord;
use crate::results::Results;
use crate::study::Outcome;

/// The figures of a session with their names: the restitution of each group by impact speed, the
/// intervals of the means, and the drops in the order of work. None if there is no study.
///
/// # Errors
/// Those of [`Results::each`].
pub fn figures(
    outcome: &Outcome<'_>,
    results: &Results<'_>,
    translator: &Translator,
) -> Result<Vec<(&'static str, Chart)>> {
    let Ok(study) = &outcome.study else {
        return Ok(Vec::new());
    };
    Ok(vec![
        ("groups", laws(outcome, study, results, translator)?),
        ("intervals", intervals(outcome, study, translator)),
        ("run", run(outcome, study, translator)),
    ])
}

fn laws(
    outcome: &Outcome<'_>,
    study: &Study,
    results: &Results<'_>,
    translator: &Translator,
) -> Result<Chart> {
    let group = |group: &Group| -> Result<GroupCurve> {
        let means = group
            .curve
            .iter()
            .map(|MeanAtSpeed { speed_m_s, mean }| GroupPoint {
                speed_m_s: *speed_m_s,
                value: mean.value,
                interval95: mean.interval95,
            });
        Ok(GroupCurve {
            name: outcome.group_name(&group.levels),
            impacts: impacts(outcome, group, results)?,
            means: means.collect(),
        })
    };
    let groups: Vec<GroupCurve> = study.groups.iter().map(group).collect::<Result<_>>()?;
    Ok(figure::groups(&groups, translator))
}

/// Impact speed and restitution of some impacts of a group, as many of each drop.
fn impacts(outcome: &Outcome<'_>, group: &Group, results: &Results<'_>) -> Result<Vec<[f64; 2]>> {
    /// Of a group.
    const SHOWN: usize = 600;
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

fn intervals(outcome: &Outcome<'_>, study: &Study, translator: &Translator) -> Chart {
    let value = |drop: usize| outcome.at(drop, study.at_speed_m_s);
    let groups: Vec<GroupInterval> = study
        .groups
        .iter()
        .map(|group| GroupInterval {
            name: outcome.group_name(&group.levels),
            mean: group.mean.value,
            interval95: group.mean.interval95,
            next95: group.mean.next95,
            drops: group
                .drops
                .iter()
                .filter_map(|&drop| Some((value(drop)?.value, is_outlier(study, drop))))
                .collect(),
        })
        .collect();
    figure::intervals(&groups, study.at_speed_m_s, translator)
}

fn run(outcome: &Outcome<'_>, study: &Study, translator: &Translator) -> Chart {
    let mut points: Vec<(usize, RunPoint)> = Vec::new();
    let value = |drop: usize| outcome.at(drop, study.at_speed_m_s);
    for (place, group) in study.groups.iter().enumerate() {
        // A mean would follow an outlier.
        let middle = median(
            group
                .drops
                .iter()
                .filter_map(|&drop| Some(value(drop)?.value)),
        );
        for &drop in &group.drops {
            let Some(found) = value(drop) else { continue };
            let point = RunPoint {
                off: found.value - middle,
                standard_error: Some(found.sd),
                group: place,
                outlier: is_outlier(study, drop),
            };
            points.push((drop, point));
        }
    }
    points.sort_by_key(|(drop, _)| *drop);
    let points: Vec<RunPoint> = points.into_iter().map(|(_, point)| point).collect();
    let ordinary = points.iter().filter(|point| !point.outlier);
    let limit = run_limit(&ordinary.map(|point| point.off).collect::<Vec<_>>());
    let names: Vec<String> = study
        .groups
        .iter()
        .map(|group| outcome.group_name(&group.levels))
        .collect();
    figure::run_chart(&points, &names, limit, translator)
}

fn is_outlier(study: &Study, drop: usize) -> bool {
    study.outliers.iter().any(|outlier| outlier.drop == drop)
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    Estimate::of_draws(values).map_or(f64::NAN, |summary| summary.value)
}
