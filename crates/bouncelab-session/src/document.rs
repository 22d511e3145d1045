//! The result of a session as data for programs: the schema `bouncelab.session/2`.
//!
//! The study is that of [`bouncelab::groups`], with names where that has places.

use std::collections::BTreeMap;

use bouncelab::groups::{Difference, Factor, Group, Outlier, Study, Trend, VarianceComponent};
use serde::Serialize;

use crate::study::Outcome;

/// Name and version of the schema.
pub const SCHEMA: &str = "bouncelab.session/2";

/// What a session says.
#[derive(Debug, Clone, Serialize)]
pub struct SessionDocument<'a> {
    schema: &'static str,
    /// Version of the program that made it.
    bouncelab: &'static str,
    #[serde(flatten)]
    about: &'a AboutSession,
    study: Option<StudyDocument<'a>>,
}

/// What is known of a session besides what its drops say together.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct AboutSession {
    /// What it is called.
    pub title: Option<String>,
    /// How many recordings there are.
    pub recordings: usize,
    /// How many drops were detected.
    pub drops: usize,
    /// Recordings without a drop, with the reason.
    pub without_drop: Vec<Reason>,
    /// Recordings that could not be read, with the reason.
    pub failed: Vec<Reason>,
    /// Recordings with the same content as another, which counts, with its name as the reason.
    pub duplicates: Vec<Reason>,
    /// Drops that are not in the study, with the reason.
    pub left_out: Vec<Reason>,
    /// Drops of which there is something to know, with what it is.
    pub odd: Vec<Reason>,
    /// What to know of the session as a whole.
    pub remarks: Vec<String>,
    /// What nobody noted, and so was assumed.
    pub assumptions: Vec<String>,
    /// Why there is no study.
    pub no_study: Option<String>,
}

/// A recording or drop, and something about it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Reason {
    /// What it is called.
    pub name: String,
    /// What there is to say.
    pub reason: String,
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

/// Something that was found, with the names of what it is about.
#[derive(Debug, Clone, Serialize)]
struct Named<'a, T> {
    #[serde(flatten)]
    names: Names<'a>,
    #[serde(flatten)]
    found: &'a T,
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
    /// The document of an outcome.
    pub fn new(outcome: &'a Outcome<'_>) -> Self {
        let study = outcome.study.as_ref().ok();
        Self {
            schema: SCHEMA,
            bouncelab: env!("CARGO_PKG_VERSION"),
            about: &outcome.about,
            study: study.map(|study| StudyDocument::new(study, outcome)),
        }
    }
}

impl<'a> StudyDocument<'a> {
    fn new(study: &'a Study, outcome: &'a Outcome<'_>) -> Self {
        let factors = &outcome.factors;
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
            let of = std::iter::zip(&outcome.by, &group.levels).map(|(&factor, level)| {
                let level = level.map(|level| factors[factor].levels[level].as_str());
                (name(factor), level)
            });
            Names::Levels {
                levels: of.collect(),
            }
        };
        Self {
            at_speed_m_s: study.at_speed_m_s,
            by: names(&outcome.by),
            all: Named {
                names: Names::Levels {
                    levels: BTreeMap::new(),
                },
                found: &study.all,
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
                name: outcome.name_of(outlier.drop),
            })
            .collect(),
        }
    }
}

/// Each with its names.
fn named<'a, T>(
    found: &'a [T],
    names: impl Fn(&'a T) -> Names<'a>,
) -> impl Iterator<Item = Named<'a, T>> {
    found.iter().map(move |found| Named {
        names: names(found),
        found,
    })
}
