//! The figures of a study of many drops.

use bouncelab::Estimate;
use bouncelab::groups::{Group, MeanAtSpeed, Study, run_limit};

use super::study::GroupStudy;
use crate::chart::{Chart, Point};
use crate::figure::{self, GroupCurve, GroupInterval, GroupPoint, RunPoint};
use crate::messages::Translator;

/// The figures with their names: the restitution of each group by impact speed, the intervals of the means, and
/// the drops in the order of work. None if there is no study. `impacts` are speed in m/s and restitution of some
/// impacts of each group.
pub fn figures(
    groups: &GroupStudy,
    impacts: Vec<Vec<Point>>,
    translator: &Translator,
) -> Vec<(&'static str, Chart)> {
    let Ok(study) = &groups.study else {
        return Vec::new();
    };
    vec![
        ("groups", laws(groups, study, impacts, translator)),
        ("intervals", intervals(groups, study, translator)),
        ("run", run(groups, study, translator)),
    ]
}

fn laws(
    groups: &GroupStudy,
    study: &Study,
    impacts: Vec<Vec<Point>>,
    translator: &Translator,
) -> Chart {
    let curve = |(group, impacts): (&Group, Vec<Point>)| GroupCurve {
        name: groups.group_name(&group.levels, translator),
        impacts,
        means: group.curve.iter().map(mean_at).collect(),
    };
    let curves: Vec<GroupCurve> = std::iter::zip(&study.groups, impacts).map(curve).collect();
    figure::groups(&curves, translator)
}

fn mean_at(MeanAtSpeed { speed_m_s, mean }: &MeanAtSpeed) -> GroupPoint {
    GroupPoint {
        speed_m_s: *speed_m_s,
        value: mean.value,
        interval95: mean.interval95,
    }
}

fn intervals(groups: &GroupStudy, study: &Study, translator: &Translator) -> Chart {
    let value = |drop: usize| groups.at(drop, study.at_speed_m_s);
    let intervals: Vec<GroupInterval> = study
        .groups
        .iter()
        .map(|group| GroupInterval {
            name: groups.group_name(&group.levels, translator),
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
    figure::intervals(&intervals, study.at_speed_m_s, translator)
}

fn run(groups: &GroupStudy, study: &Study, translator: &Translator) -> Chart {
    let mut points: Vec<(usize, RunPoint)> = Vec::new();
    let value = |drop: usize| groups.at(drop, study.at_speed_m_s);
    for (index, group) in study.groups.iter().enumerate() {
        // A mean would follow an outlier.
        let middle = median(
            group
                .drops
                .iter()
                .filter_map(|&drop| Some(value(drop)?.value)),
        );
        for &drop in &group.drops {
            let Some(estimate) = value(drop) else {
                continue;
            };
            let point = RunPoint {
                off: estimate.value - middle,
                standard_error: Some(estimate.sd),
                group: index,
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
        .map(|group| groups.group_name(&group.levels, translator))
        .collect();
    figure::run_chart(&points, &names, limit, translator)
}

fn is_outlier(study: &Study, drop: usize) -> bool {
    study.outliers.iter().any(|outlier| outlier.drop == drop)
}

fn median(values: impl Iterator<Item = f64>) -> f64 {
    Estimate::of_draws(values).map_or(f64::NAN, |summary| summary.value)
}
