//! The figures of a study of many drops.

use bouncelab::Estimate;
use bouncelab::groups::{FittedDrop, Group, Study, run_limit};

use super::study::GroupStudy;
use crate::chart::{Chart, Point};
use crate::figure::{self, GroupCurve, GroupInterval, RunPoint};
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
        curve: group.curve.clone(),
    };
    let curves: Vec<GroupCurve> = std::iter::zip(&study.groups, impacts).map(curve).collect();
    figure::groups(&curves, translator)
}

fn intervals(groups: &GroupStudy, study: &Study, translator: &Translator) -> Chart {
    let interval = |group: &Group| {
        let restitution = group.restitution?;
        let drops = group
            .drops
            .iter()
            .filter_map(|&drop| Some((study.restitution_of(drop)?.value, is_outlier(study, drop))));
        Some(GroupInterval {
            name: groups.group_name(&group.levels, translator),
            restitution,
            next95: group.next95,
            drops: drops.collect(),
        })
    };
    let intervals: Vec<GroupInterval> = study.groups.iter().filter_map(interval).collect();
    figure::intervals(&intervals, study.at_speed_m_s, translator)
}

fn run(groups: &GroupStudy, study: &Study, translator: &Translator) -> Chart {
    // An outlier draws the curve of its group after it.
    let middle = |group: &Group| {
        let fitted = group.drops.iter().filter_map(|&drop| study.drops[drop]);
        Estimate::of_draws(fitted.map(|fitted| fitted.off.value)).map_or(0.0, |offs| offs.value)
    };
    let middles: Vec<f64> = study.groups.iter().map(middle).collect();
    let point = |(drop, fitted): (usize, &Option<FittedDrop>)| {
        let fitted = fitted.as_ref()?;
        Some(RunPoint {
            off: fitted.off.value - middles[fitted.group],
            standard_error: Some(fitted.off.sd),
            group: fitted.group,
            outlier: is_outlier(study, drop),
        })
    };
    let points: Vec<RunPoint> = study.drops.iter().enumerate().filter_map(point).collect();
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
