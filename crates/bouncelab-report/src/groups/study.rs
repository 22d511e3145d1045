//! Drops with what was noted of each, and their study.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::sync::Arc;

use bouncelab::groups::{Asked, CurveEvidence, Factor, GroupSums, MAX_RANDOM, Study, StudyDrop};
use serde::Serialize;

use crate::messages::Translator;

/// Factors in this order; all others follow in that of their names.
const FIRST: [&str; 7] = [
    "ball",
    "surface",
    "operator",
    "student",
    "place",
    "height",
    "temperature",
];

/// Drops are not grouped by these: the more of them, the smaller the groups.
const NOT_GROUPED: [&str; 5] = ["operator", "student", "place", "height", "temperature"];

/// The factors whose levels scatter about their group if they make none.
const SCATTERING: [&str; 5] = ["operator", "student", "place", "ball", "surface"];

/// A factor of more levels is no scatter of operators: each level adds an unknown.
const MAX_LEVELS: usize = 100;

/// A drop with what was noted of it, and what it adds to a study.
#[derive(Debug, Clone)]
pub struct NotedDrop<'a> {
    /// What it is called.
    pub name: Arc<str>,
    /// What it is compared by: "surface", "steel".
    pub factors: &'a BTreeMap<String, String>,
    /// What it says of the restitution curve.
    pub evidence: CurveEvidence,
    /// Scatter of ln e from impact to impact, above zero.
    pub scatter: Option<f64>,
}

/// What to ask of drops.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Question {
    /// The fields that make groups, none for a single group; if left out, ball, surface and whatever else was noted, but
    /// for operator, place, height and temperature.
    pub by: Option<Vec<String>>,
    /// The impact speed at which groups are compared, m/s; if left out, a round one that they have in common.
    pub at_speed_m_s: Option<f64>,
    /// The half width of the 95 % interval that the restitution should have; if left out, half of what it has.
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
    /// The study, or why it cannot be made.
    pub study: Result<Study, String>,
    names: Vec<Arc<str>>,
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
        let noted = drops.iter().flat_map(|drop| drop.factors);
        let asking = Asking::new(noted, drops.len(), question)?;
        let (names, drops): (Vec<_>, Vec<_>) = drops
            .into_iter()
            .map(|drop| (Arc::clone(&drop.name), asking.drop(drop)))
            .unzip();
        let study = Study::of(&drops, &asking.asked);
        Ok(Self::new(
            about,
            asking,
            study,
            names,
            drops.len(),
            translator,
        ))
    }

    fn new(
        mut about: About,
        Asking { factors, asked }: Asking,
        study: bouncelab::Result<Study>,
        names: Vec<Arc<str>>,
        studied: usize,
        translator: &Translator,
    ) -> Self {
        let study = study.map_err(|refusal| match asked.at_speed_m_s {
            _ if studied == 0 => translator.text("session-no-inference"),
            Some(speed) => translator.text_with("session-no-speed", &[("speed", speed.into())]),
            None => translator.diagnostic(&refusal.diagnostic()),
        });
        about.no_study = study.as_ref().err().cloned();
        Self {
            about,
            factors,
            by: asked.by,
            study,
            names,
        }
    }

    /// The name of a drop, by its index.
    pub fn name_of(&self, drop: usize) -> &str {
        &self.names[drop]
    }

    /// What a factor is called: in the language of the reader, if it is a usual one.
    pub fn factor_name(&self, factor: usize, translator: &Translator) -> String {
        let name = self.factors[factor].name.as_str();
        match name {
            "ball" | "surface" | "operator" | "student" | "place" => {
                translator.text(&format!("factor-{name}"))
            }
            _ => name.to_owned(),
        }
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

/// What drops can be compared by, and what is asked of them.
#[derive(Debug, Clone)]
struct Asking {
    factors: Vec<Factor>,
    asked: Asked,
}

impl Asking {
    /// By what was noted of a number of drops.
    fn new<'a>(
        noted: impl IntoIterator<Item = (&'a String, &'a String)>,
        drops: usize,
        question: &Question,
    ) -> Result<Self, UnknownField> {
        let factors = factors(noted);
        let by = by(&factors, question.by.as_deref())?;
        let asked = Asked {
            random: scattering(&factors, &by, drops),
            ball: factors.iter().position(|factor| factor.name == "ball"),
            by,
            at_speed_m_s: question.at_speed_m_s,
            wanted: question.wanted,
        };
        Ok(Self { factors, asked })
    }

    fn drop(&self, drop: NotedDrop<'_>) -> StudyDrop {
        StudyDrop {
            levels: levels(&self.factors, drop.factors),
            evidence: drop.evidence,
            scatter: drop.scatter,
        }
    }
}

/// Drops that are read in parts, perhaps on several machines: of each part only sums are kept.
#[derive(Debug, Clone)]
pub struct StudyParts {
    asking: Asking,
    /// How many drops there are, those included that have no inference.
    drops: usize,
    sums: Parts,
}

/// The sums of each group, by its levels.
pub type Parts = Vec<(Vec<Option<usize>>, GroupSums)>;

impl StudyParts {
    /// Without a drop yet, given every level that was noted of a field of any of the drops, and how many these are, those
    /// included that have no inference.
    ///
    /// # Errors
    /// As [`GroupStudy::of`].
    pub fn new<'a>(
        noted: impl IntoIterator<Item = (&'a String, &'a String)>,
        drops: usize,
        question: &Question,
    ) -> Result<Self, UnknownField> {
        Ok(Self {
            asking: Asking::new(noted, drops, question)?,
            drops,
            sums: Vec::new(),
        })
    }

    /// Adds a drop.
    pub fn add(&mut self, drop: NotedDrop<'_>) {
        let drop = self.asking.drop(drop);
        let by = &self.asking.asked.by;
        let levels = by.iter().map(|&factor| drop.levels[factor]).collect();
        let asked = self.asking.asked.clone();
        self.group(levels).add(&drop, &asked);
    }

    /// Adds the drops of another part, which was made with the same levels and question.
    pub fn merge(&mut self, parts: &Parts) {
        for (levels, sums) in parts {
            self.group(levels.clone()).merge(sums);
        }
    }

    /// The sums so far.
    pub fn parts(&self) -> &Parts {
        &self.sums
    }

    /// The study of all drops, without what needs each of them: names, outliers and heights.
    pub fn study(&self, mut about: About, translator: &Translator) -> GroupStudy {
        let study = Study::of_sums(&self.sums, &self.asking.asked);
        about.drops = self.drops;
        let studied = self.sums.iter().map(|(_, sums)| sums.drops()).sum();
        GroupStudy::new(
            about,
            self.asking.clone(),
            study,
            Vec::new(),
            studied,
            translator,
        )
    }

    fn group(&mut self, levels: Vec<Option<usize>>) -> &mut GroupSums {
        let place = match self.sums.binary_search_by(|(of, _)| of.cmp(&levels)) {
            Ok(place) => place,
            Err(place) => {
                self.sums.insert(place, (levels, GroupSums::default()));
                place
            }
        };
        &mut self.sums[place].1
    }
}

/// Everything by which drops can be compared, with its levels in order.
fn factors<'a>(noted: impl IntoIterator<Item = (&'a String, &'a String)>) -> Vec<Factor> {
    let mut levels: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for (field, level) in noted {
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

/// The factors whose levels scatter about the groups, the first of [`SCATTERING`].
fn scattering(factors: &[Factor], by: &[usize], drops: usize) -> Vec<usize> {
    let scatters = |&factor: &usize| {
        let levels = factors[factor].levels.len();
        // What every drop has of its own is no other than the scatter of drops.
        !by.contains(&factor) && (2..=MAX_LEVELS).contains(&levels) && 2 * levels <= drops
    };
    let named = SCATTERING
        .iter()
        .filter_map(|name| factors.iter().position(|factor| factor.name == *name));
    named.filter(scatters).take(MAX_RANDOM).collect()
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
fn by(factors: &[Factor], wanted: Option<&[String]>) -> Result<Vec<usize>, UnknownField> {
    let makes_groups =
        |factor: &Factor| factor.levels.len() > 1 && !NOT_GROUPED.contains(&factor.name.as_str());
    let Some(wanted) = wanted else {
        let indices = 0..factors.len();
        return Ok(indices
            .filter(|&index| makes_groups(&factors[index]))
            .collect());
    };
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
