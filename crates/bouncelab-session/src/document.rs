//! The result of a session as data for programs: the schema `bouncelab.session/3`.
//!
//! The study is that of [`bouncelab::groups`], with names in place of indices.

use std::collections::BTreeMap;

use bouncelab::Estimate;
use bouncelab::groups::{Difference, Group, Outlier, Study};
use bouncelab_report::groups::{About, GroupStudy};
use bouncelab_report::mark::Mark;
use serde::Serialize;

/// Name and version of the schema.
pub const SCHEMA: &str = "bouncelab.session/3";

/// The mark of its file: how it begins.
pub const DOCUMENT_MARK: Mark = Mark::first("{\n  \"schema\": \"bouncelab.session/3\",");

/// The statistics of a session.
#[derive(Debug, Clone, Serialize)]
pub struct SessionDocument<'a> {
    schema: &'static str,
    /// Version of the program that made it.
    bouncelab: &'static str,
    #[serde(flatten)]
    about: &'a About,
    study: Option<StudyDocument<'a>>,
}

#[derive(Debug, Clone, Serialize)]
struct StudyDocument<'a> {
    at_speed_m_s: f64,
    by: Vec<&'a str>,
    groups: Vec<Named<'a, Group>>,
    differences: Vec<Named<'a, Difference>>,
    scatters: Vec<FactorScatter<'a>>,
    heights: Vec<DropHeight<'a>>,
    ruler_zero_m: Option<Estimate>,
    outliers: Vec<Named<'a, Outlier>>,
}

/// The relative scatter of the levels of a factor.
#[derive(Debug, Clone, Serialize)]
struct FactorScatter<'a> {
    factor: &'a str,
    scatter: Estimate,
}

#[derive(Debug, Clone, Serialize)]
struct DropHeight<'a> {
    name: &'a str,
    height_m: Estimate,
}

/// A result of the study, with the names of its levels, groups or drop.
#[derive(Debug, Clone, Serialize)]
struct Named<'a, T> {
    #[serde(flatten)]
    names: Names<'a>,
    #[serde(flatten)]
    result: &'a T,
}

/// The levels of a group, by their factors.
type Levels<'a> = BTreeMap<&'a str, Option<&'a str>>;

#[derive(Debug, Clone, Serialize)]
#[serde(untagged)]
enum Names<'a> {
    Levels { levels: Levels<'a> },
    Pair { of: Levels<'a>, less: Levels<'a> },
    Drop { name: &'a str },
}

impl<'a> SessionDocument<'a> {
    /// The document of drops.
    pub fn new(groups: &'a GroupStudy) -> Self {
        let study = groups.study.as_ref().ok();
        Self {
            schema: SCHEMA,
            bouncelab: env!("CARGO_PKG_VERSION"),
            about: &groups.about,
            study: study.map(|study| StudyDocument::new(study, groups)),
        }
    }
}

impl<'a> StudyDocument<'a> {
    fn new(study: &'a Study, groups: &'a GroupStudy) -> Self {
        let factors = &groups.factors;
        let name = |factor: usize| factors[factor].name.as_str();
        let levels = |group: &Group| -> Levels<'a> {
            let of = std::iter::zip(&groups.by, &group.levels).map(|(&factor, level)| {
                let level = level.map(|level| factors[factor].levels[level].as_str());
                (name(factor), level)
            });
            of.collect()
        };
        let heights = study.drops.iter().enumerate().filter_map(|(drop, fitted)| {
            let height_m = fitted.as_ref()?.height_m?;
            Some(DropHeight {
                name: groups.name_of(drop),
                height_m,
            })
        });
        Self {
            at_speed_m_s: study.at_speed_m_s,
            by: groups.by.iter().map(|&factor| name(factor)).collect(),
            groups: named(&study.groups, |group| Names::Levels {
                levels: levels(group),
            })
            .collect(),
            differences: named(&study.differences, |difference| Names::Pair {
                of: levels(&study.groups[difference.of]),
                less: levels(&study.groups[difference.less]),
            })
            .collect(),
            scatters: study
                .scatters
                .iter()
                .map(|&(factor, scatter)| FactorScatter {
                    factor: name(factor),
                    scatter,
                })
                .collect(),
            heights: heights.collect(),
            ruler_zero_m: study.ruler_zero_m,
            outliers: named(&study.outliers, |outlier| Names::Drop {
                name: groups.name_of(outlier.drop),
            })
            .collect(),
        }
    }
}

/// Results with their names.
fn named<'a, T>(
    results: &'a [T],
    names: impl Fn(&'a T) -> Names<'a>,
) -> impl Iterator<Item = Named<'a, T>> {
    results.iter().map(move |result| Named {
        names: names(result),
        result,
    })
}
