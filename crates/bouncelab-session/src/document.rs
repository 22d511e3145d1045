//! The result of a session as data for programs: the schema `bouncelab.session/2`.
//!
//! The study is that of [`bouncelab::groups`], with names in place of indices.

use std::collections::BTreeMap;

use bouncelab::groups::{Difference, Factor, Group, Outlier, Study, Trend, VarianceComponent};
use bouncelab_report::groups::{About, GroupStudy};
use bouncelab_report::mark::Mark;
use serde::Serialize;

/// Name and version of the schema.
pub const SCHEMA: &str = "bouncelab.session/2";

/// The mark of its file: how it begins.
pub const DOCUMENT_MARK: Mark = Mark::first("{\n  \"schema\": \"bouncelab.session/2\",");

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
    all: Named<'a, Group>,
    groups: Vec<Named<'a, Group>>,
    varies: Vec<Named<'a, VarianceComponent>>,
    differences: Vec<Named<'a, Difference>>,
    trends: Vec<Named<'a, Trend>>,
    outliers: Vec<Named<'a, Outlier>>,
}

/// A result of the study, with the names of its factors, levels or drop.
#[derive(Debug, Clone, Serialize)]
struct Named<'a, T> {
    #[serde(flatten)]
    names: Names<'a>,
    #[serde(flatten)]
    result: &'a T,
}

#[derive(Debug, Clone, Serialize)]
#[serde(untagged)]
enum Names<'a> {
    Levels {
        levels: BTreeMap<&'a str, Option<&'a str>>,
    },
    /// Empty for the drops themselves.
    Factors {
        factors: Vec<&'a str>,
    },
    Pair {
        factor: &'a str,
        of: &'a str,
        less: &'a str,
    },
    Factor {
        factor: &'a str,
    },
    Drop {
        name: &'a str,
    },
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
        let names = |factors: &[usize]| factors.iter().map(|&factor| name(factor)).collect();
        let differences = study.differences.iter().flat_map(|(factor, differences)| {
            let Factor { name, levels } = &factors[*factor];
            let pair = move |difference: &Difference| Names::Pair {
                factor: name,
                of: &levels[difference.of],
                less: &levels[difference.less],
            };
            named(differences, pair)
        });
        let levels = |group: &Group| {
            let of = std::iter::zip(&groups.by, &group.levels).map(|(&factor, level)| {
                let level = level.map(|level| factors[factor].levels[level].as_str());
                (name(factor), level)
            });
            Names::Levels {
                levels: of.collect(),
            }
        };
        Self {
            at_speed_m_s: study.at_speed_m_s,
            by: names(&groups.by),
            all: Named {
                names: Names::Levels {
                    levels: BTreeMap::new(),
                },
                result: &study.all,
            },
            groups: named(&study.groups, levels).collect(),
            varies: named(&study.varies, |varies| Names::Factors {
                factors: names(&varies.factors),
            })
            .collect(),
            differences: differences.collect(),
            trends: named(&study.trends, |trend| Names::Factor {
                factor: name(trend.factor),
            })
            .collect(),
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
