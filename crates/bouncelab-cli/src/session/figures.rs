//! The figures of a session.

use std::path::Path;

use bouncelab::estimate::Summary;
use bouncelab::groups::{Study, run_limit};
use bouncelab_report::Figure;
use bouncelab_report::figure::{self, GroupInterval, GroupLaw, GroupPoint, RunPoint};

use super::outcome::Outcome;
use crate::failure::Failure;

/// Impacts of one group in a figure.
const IMPACTS: usize = 600;

/// Draws them into a folder.
pub(super) fn save(outcome: &Outcome, folder: &Path) -> Result<(), Failure> {
    for (name, figure) in figures(outcome) {
        let saved = bouncelab_report::save(&figure, folder, name)?;
        eprintln!("wrote {}", saved.svg.display());
    }
    Ok(())
}

/// Name and drawing of each.
pub(super) fn figures(outcome: &Outcome) -> Vec<(&'static str, Figure)> {
    let Ok(study) = &outcome.study else {
        return Vec::new();
    };
    vec![
        ("groups", laws(outcome, study)),
        ("intervals", intervals(outcome, study)),
        ("run", run(outcome, study)),
    ]
}

fn laws(outcome: &Outcome, study: &Study) -> Figure {
    let groups: Vec<GroupLaw> = study
        .groups
        .iter()
        .map(|group| {
            let drops = group.drops.iter().map(|&drop| outcome.studied[drop]);
            let all: Vec<(f64, f64)> = drops
                .flat_map(|place| outcome.drops[place].impacts.iter().copied())
                .collect();
            let law = group.law.iter().map(|(speed_m_s, mean)| GroupPoint {
                speed_m_s: *speed_m_s,
                value: mean.value,
                interval95: mean.interval95,
            });
            GroupLaw {
                name: outcome.group_name(&group.levels),
                impacts: all
                    .iter()
                    .copied()
                    .step_by(all.len() / IMPACTS + 1)
                    .collect(),
                law: law.collect(),
            }
        })
        .collect();
    figure::groups(&groups)
}

fn intervals(outcome: &Outcome, study: &Study) -> Figure {
    let value = |drop: usize| outcome.drops[outcome.studied[drop]].at(study.at_speed_m_s);
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
    let quantity = format!("restitution at {:.2} m/s", study.at_speed_m_s);
    figure::intervals("Restitution of each group", &groups, &quantity)
}

fn run(outcome: &Outcome, study: &Study) -> Figure {
    let mut points: Vec<(usize, RunPoint)> = Vec::new();
    let value = |drop: usize| outcome.drops[outcome.studied[drop]].at(study.at_speed_m_s);
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
    figure::run_chart(&points, &names, limit)
}

fn is_outlier(study: &Study, drop: usize) -> bool {
    study.outliers.iter().any(|outlier| outlier.drop == drop)
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    Summary::of(values).map_or(f64::NAN, |summary| summary.value)
}
