//! Drops with what was noted of each, and their study.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::sync::Arc;

use bouncelab::groups::{Covariate, Factor, RestitutionCurve, Study, StudyDrop};
use bouncelab::inference::Measured;
use serde::Serialize;

use crate::messages::{Translator, Value};

/// Factors in this order; all others follow in that of their names.
const FIRST: [&str; 5] = ["ball", "surface", "operator", "height", "temperature"];

/// Drops are compared by these, but not grouped: the more of them, the smaller the groups.
const NOT_GROUPED: [&str; 3] = ["operator", "height", "temperature"];

/// A drop with what was noted of it, and what it adds to a study.
#[derive(Debug, Clone)]
pub struct NotedDrop<'a> {
    /// What it is called.
    pub name: Arc<str>,
    /// What it is compared by: "surface", "steel".
    pub factors: &'a BTreeMap<String, String>,
    /// The drop height as noted, m.
    pub height_m: Option<f64>,
    /// The temperature as noted, K.
    pub temperature_k: Option<f64>,
    /// Its restitution, at speeds that all drops share.
    pub curve: RestitutionCurve,
    /// Scatter of ln e from impact to impact, above zero.
    pub scatter: Option<Measured>,
}

/// What to ask of drops.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Question {
    /// The fields that make groups; if empty, ball, surface and whatever else was noted, but for
    /// operator, height and temperature.
    pub by: Vec<String>,
    /// The impact speed at which drops are compared, m/s; if left out, one that most drops know.
    pub at_speed_m_s: Option<f64>,
    /// The half width of the 95 % interval that a mean should have; if left out, half of what it has.
    pub wanted: Option<f64>,
}

/// Nothing is noted of a field by which drops were to be grouped.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("there are no metadata of \"{name}\"")]
pub struct UnknownField {
    /// The field.
    pub name: String,
    /// The fields of which something is noted.
    pub known: Vec<String>,
}

/// What belongs to drops besides their study.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct About {
    /// What they are called together.
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
    /// Drops with a remark, and the remark.
    pub odd: Vec<Reason>,
    /// What to know of all of them as a whole.
    pub remarks: Vec<String>,
    /// What was not noted, and therefore assumed.
    pub assumptions: Vec<String>,
    /// Why there is no study.
    pub no_study: Option<String>,
}

/// A recording or drop, and something about it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Reason {
    /// What it is called.
    pub name: String,
    /// The text.
    pub reason: String,
}

/// Drops and their study.
#[derive(Debug)]
pub struct GroupStudy {
    /// What belongs to them besides the study.
    pub about: About,
    /// What they can be compared by.
    pub factors: Vec<Factor>,
    /// The factors that make groups, by index.
    pub by: Vec<usize>,
    /// The study, or why there is none.
    pub study: Result<Study, String>,
    names: Vec<Arc<str>>,
    curves: Vec<StudyDrop>,
}

impl GroupStudy {
    /// Studies drops, in the order in which they were made.
    ///
    /// # Errors
    /// [`UnknownField`] if drops are to be grouped by what was noted of none.
    pub fn of(
        about: About,
        drops: Vec<NotedDrop<'_>>,
        question: &Question,
        translator: &Translator,
    ) -> Result<Self, UnknownField> {
        let factors = factors(&drops);
        let by = by(&factors, &question.by)?;
        let covariates = covariates(&factors, &drops);
        let with_levels = |drop: NotedDrop<'_>| {
            let added = StudyDrop {
                levels: levels(&factors, drop.factors),
                curve: drop.curve,
                scatter: drop.scatter,
            };
            (drop.name, added)
        };
        let (names, curves): (Vec<_>, Vec<_>) = drops.into_iter().map(with_levels).unzip();
        let study = Study::of(
            &curves,
            &factors,
            &covariates,
            &by,
            question.at_speed_m_s,
            question.wanted,
        );
        let study = study.map_err(|refusal| match question.at_speed_m_s {
            _ if curves.is_empty() => translator.text("session-no-inference"),
            Some(speed) => translator.text_with("session-no-speed", &[("speed", speed.into())]),
            None => translator.diagnostic(&refusal.diagnostic()),
        });
        let mut groups = Self {
            about,
            factors,
            by,
            study,
            names,
            curves,
        };
        groups.about.no_study = groups.study.as_ref().err().cloned();
        let unknown = groups.unknown_there(translator);
        groups.about.left_out.extend(unknown);
        Ok(groups)
    }

    /// The drops that are not compared because they do not know the speed at which the others are.
    fn unknown_there(&self, translator: &Translator) -> Vec<Reason> {
        let Ok(study) = &self.study else {
            return Vec::new();
        };
        let speed = [("speed", Value::fixed(study.at_speed_m_s, 2))];
        let reason = translator.text_with("session-unknown-there", &speed);
        let left_out = study.left_out.iter();
        left_out
            .map(|&drop| Reason {
                name: self.name_of(drop).to_owned(),
                reason: reason.clone(),
            })
            .collect()
    }

    /// Restitution of a drop, by its index, at a speed, with the uncertainty that is its own.
    pub fn at(&self, drop: usize, speed_m_s: f64) -> Option<Measured> {
        let point = self.curves[drop].curve.at(speed_m_s)?;
        Some(Measured {
            value: point.value,
            sd: point.own_sd,
        })
    }

    /// The name of a drop, by its index.
    pub fn name_of(&self, drop: usize) -> &str {
        &self.names[drop]
    }

    /// What a group is called: its levels.
    pub fn group_name(&self, levels: &[Option<usize>], translator: &Translator) -> String {
        let levels = std::iter::zip(&self.by, levels);
        let names: Vec<&str> = levels
            .map(|(&factor, level)| level.map_or("?", |level| &self.factors[factor].levels[level]))
            .collect();
        if names.is_empty() {
            translator.text("session-all-drops")
        } else {
            names.join(", ")
        }
    }
}

/// Everything by which drops can be compared, with its levels in order.
fn factors(drops: &[NotedDrop<'_>]) -> Vec<Factor> {
    let mut levels: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for (field, level) in drops.iter().flat_map(|drop| drop.factors) {
        levels.entry(field).or_default().push(level);
    }
    let mut factors: Vec<Factor> = levels
        .into_iter()
        .map(|(field, mut levels)| {
            levels.sort_by(|a, b| in_order(a, b));
            levels.dedup();
            Factor {
                name: field.to_owned(),
                levels: levels.into_iter().map(str::to_owned).collect(),
            }
        })
        .collect();
    let rank = |factor: &Factor| {
        let index = FIRST.iter().position(|first| *first == factor.name);
        index.unwrap_or(FIRST.len())
    };
    factors.sort_by(|a, b| rank(a).cmp(&rank(b)).then_with(|| a.name.cmp(&b.name)));
    factors
}

/// The factors that are noted in numbers, in SI.
fn covariates(factors: &[Factor], drops: &[NotedDrop<'_>]) -> Vec<Covariate> {
    type Amount = fn(&NotedDrop<'_>) -> Option<f64>;
    let height: Amount = |drop| drop.height_m;
    let temperature: Amount = |drop| drop.temperature_k;
    let of_factor = |(name, amount): (&str, Amount)| {
        let factor = factors.iter().position(|factor| factor.name == name)?;
        let by_level: BTreeMap<&str, f64> = drops
            .iter()
            .filter_map(|drop| Some((drop.factors.get(name)?.as_str(), amount(drop)?)))
            .collect();
        let levels = factors[factor].levels.iter();
        let of_levels = levels.map(|level| by_level.get(level.as_str()).copied());
        Some(Covariate {
            factor,
            of_levels: of_levels.collect::<Option<_>>()?,
        })
    };
    let noted = [("height", height), ("temperature", temperature)];
    noted.into_iter().filter_map(of_factor).collect()
}

/// By the number with which they begin, then those without one; or as text.
fn in_order(a: &str, b: &str) -> Ordering {
    let number = |text: &str| {
        let end = text
            .find(|c: char| !(c.is_ascii_digit() || c == '.' || c == '-'))
            .unwrap_or(text.len());
        text[..end].parse::<f64>().ok()
    };
    match (number(a), number(b)) {
        (Some(x), Some(y)) => x.total_cmp(&y).then_with(|| a.cmp(b)),
        (Some(_), None) => Ordering::Less,
        (None, Some(_)) => Ordering::Greater,
        (None, None) => a.cmp(b),
    }
}

/// The factors that make groups.
fn by(factors: &[Factor], wanted: &[String]) -> Result<Vec<usize>, UnknownField> {
    let makes_groups =
        |factor: &Factor| factor.levels.len() > 1 && !NOT_GROUPED.contains(&factor.name.as_str());
    if wanted.is_empty() {
        let indices = 0..factors.len();
        return Ok(indices
            .filter(|&index| makes_groups(&factors[index]))
            .collect());
    }
    let place_of = |name: &String| {
        let index = factors.iter().position(|factor| factor.name == *name);
        index.ok_or_else(|| UnknownField {
            name: name.clone(),
            known: factors.iter().map(|factor| factor.name.clone()).collect(),
        })
    };
    wanted.iter().map(place_of).collect()
}

fn levels(factors: &[Factor], noted: &BTreeMap<String, String>) -> Vec<Option<usize>> {
    let level_of = |factor: &Factor| {
        let level = noted.get(&factor.name)?;
        factor.levels.iter().position(|known| known == level)
    };
    factors.iter().map(level_of).collect()
}

#[cfg(test)]
mod tests {
    use super::in_order;

    #[test]
    fn levels_stand_in_the_order_of_their_numbers() {
        let mut levels = ["100 cm", "30.5 cm", "steel", "-5 \u{b0}C", "9 cm"];
        levels.sort_by(|a, b| in_order(a, b));
        assert_eq!(levels[..4], ["-5 \u{b0}C", "9 cm", "30.5 cm", "100 cm"]);
    }

    #[test]
    fn levels_with_and_without_numbers_have_one_order() {
        // As texts, 2.1.0 lies between 100 and 9.
        let mut levels = ["2.1.0", "9", "100", "steel"];
        for _ in 0..levels.len() {
            levels.rotate_left(1);
            let mut sorted = levels;
            sorted.sort_by(|a, b| in_order(a, b));
            assert_eq!(sorted, ["9", "100", "2.1.0", "steel"]);
        }
    }
}
