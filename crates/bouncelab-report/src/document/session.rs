//! What many drops say together, as data for other programs: the schema `bouncelab.session/1`.

use std::collections::BTreeMap;

use bouncelab::groups::{self, Factor, Study};
use serde::Serialize;

/// Name and version of the schema.
const SCHEMA: &str = "bouncelab.session/1";

/// What a session says.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SessionDocument {
    schema: &'static str,
    /// Version of the program that made it.
    bouncelab: &'static str,
    /// What is known of the session besides the study.
    #[serde(flatten)]
    pub about: AboutSession,
    /// What the drops say together.
    study: Option<StudyFound>,
}

/// What is known of a session besides what its drops say together.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct AboutSession {
    /// What it is called.
    pub title: Option<String>,
    /// How many recordings there are.
    pub recordings: usize,
    /// How many drops were heard.
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
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Reason {
    /// What it is called.
    pub name: String,
    /// What there is to say.
    pub reason: String,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
struct StudyFound {
    at_speed_m_s: f64,
    by: Vec<String>,
    all: Group,
    groups: Vec<Group>,
    varies: Vec<VarianceComponent>,
    differences: Vec<Difference>,
    trends: Vec<Trend>,
    outliers: Vec<Outlier>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
struct Group {
    levels: BTreeMap<String, Option<String>>,
    drops: usize,
    restitution: Mean,
    without_outliers: Option<OfDrops>,
    /// Standard uncertainty that all drops share.
    shared_sd: f64,
    next95: Option<[f64; 2]>,
    between_drops: Option<f64>,
    between_drops95: Option<[f64; 2]>,
    between_impacts: Option<f64>,
    drops_needed: Option<usize>,
    law: Vec<LawPoint>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
struct Mean {
    value: f64,
    standard_error: f64,
    interval95: Option<[f64; 2]>,
}

/// A mean and how many drops it is of.
#[derive(Clone, Debug, PartialEq, Serialize)]
struct OfDrops {
    drops: usize,
    #[serde(flatten)]
    restitution: Mean,
}

impl From<&groups::Mean> for OfDrops {
    fn from(mean: &groups::Mean) -> Self {
        Self {
            drops: mean.drops,
            restitution: Mean::from(mean),
        }
    }
}

#[derive(Clone, Debug, PartialEq, Serialize)]
struct LawPoint {
    speed_m_s: f64,
    #[serde(flatten)]
    mean: OfDrops,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
struct VarianceComponent {
    /// Empty for the drops themselves.
    factors: Vec<String>,
    levels: usize,
    sd: f64,
    sd95: Option<[f64; 2]>,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
struct Difference {
    factor: String,
    of: String,
    less: String,
    value: f64,
    standard_error: f64,
    degrees: f64,
    interval95: [f64; 2],
    p_value: f64,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
struct Trend {
    factor: String,
    levels: usize,
    /// For each metre, kelvin, or whatever the unit of the factor is in SI.
    slope: f64,
    standard_error: f64,
    degrees: f64,
    interval95: [f64; 2],
    p_value: f64,
}

#[derive(Clone, Debug, PartialEq, Serialize)]
struct Outlier {
    name: String,
    off: f64,
    score: f64,
}

impl SessionDocument {
    /// The document of a session; `name` says what a drop of the study is called, by its place.
    pub fn new(
        about: AboutSession,
        study: Option<&Study>,
        factors: &[Factor],
        by: &[usize],
        name: impl Fn(usize) -> String,
    ) -> Self {
        Self {
            schema: SCHEMA,
            bouncelab: env!("CARGO_PKG_VERSION"),
            about,
            study: study.map(|study| StudyFound::new(study, factors, by, name)),
        }
    }
}

impl StudyFound {
    fn new(
        study: &Study,
        factors: &[Factor],
        by: &[usize],
        name_of_drop: impl Fn(usize) -> String,
    ) -> Self {
        let name = |factor: &usize| factors[*factor].name.clone();
        let differences = study.differences.iter().flat_map(|(factor, differences)| {
            let level = |level: usize| factors[*factor].levels[level].clone();
            differences.iter().map(move |difference| Difference {
                factor: factors[*factor].name.clone(),
                of: level(difference.of),
                less: level(difference.less),
                value: difference.value.value,
                standard_error: difference.value.sd,
                degrees: difference.degrees,
                interval95: difference.interval95,
                p_value: difference.p_value,
            })
        });
        Self {
            at_speed_m_s: study.at_speed_m_s,
            by: by.iter().map(name).collect(),
            all: Group::new(&study.all, factors, &[]),
            groups: study
                .groups
                .iter()
                .map(|group| Group::new(group, factors, by))
                .collect(),
            varies: study
                .varies
                .iter()
                .map(|varies| VarianceComponent {
                    factors: varies.factors.iter().map(name).collect(),
                    levels: varies.levels,
                    sd: varies.component.sd,
                    sd95: varies.component.sd95,
                })
                .collect(),
            differences: differences.collect(),
            trends: study
                .trends
                .iter()
                .map(|trend| Trend {
                    factor: name(&trend.factor),
                    levels: trend.levels,
                    slope: trend.slope.value,
                    standard_error: trend.slope.sd,
                    degrees: trend.degrees,
                    interval95: trend.interval95,
                    p_value: trend.p_value,
                })
                .collect(),
            outliers: study
                .outliers
                .iter()
                .map(|outlier| Outlier {
                    name: name_of_drop(outlier.drop),
                    off: outlier.off,
                    score: outlier.score,
                })
                .collect(),
        }
    }
}

impl Group {
    fn new(group: &groups::Group, factors: &[Factor], by: &[usize]) -> Self {
        let levels = by.iter().zip(&group.levels).map(|(&factor, level)| {
            let factor = &factors[factor];
            let level = level.map(|level| factor.levels[level].clone());
            (factor.name.clone(), level)
        });
        Self {
            levels: levels.collect(),
            drops: group.mean.drops,
            restitution: Mean::from(&group.mean),
            without_outliers: group.without_outliers.as_ref().map(OfDrops::from),
            shared_sd: group.shared_sd,
            next95: group.mean.next95,
            between_drops: group.mean.between,
            between_drops95: group.mean.between95,
            between_impacts: group.between_impacts,
            drops_needed: group.drops_needed,
            law: group
                .law
                .iter()
                .map(|(speed_m_s, mean)| LawPoint {
                    speed_m_s: *speed_m_s,
                    mean: OfDrops::from(mean),
                })
                .collect(),
        }
    }
}

impl From<&groups::Mean> for Mean {
    fn from(mean: &groups::Mean) -> Self {
        Self {
            value: mean.value,
            standard_error: mean.standard_error,
            interval95: mean.interval95,
        }
    }
}
