//! What came of a session: which drops there are, and what they say together.

use std::cmp::Ordering;
use std::collections::BTreeMap;

use bouncelab::groups::{Covariate, Factor, Study, StudyDrop};
use bouncelab::inference::Measured;
use bouncelab_report::document::{AboutSession, Reason, SessionDocument};

use super::gather::{Drop, Gathered, reason};
use super::notes::{SetUp, Setup};
use super::results::Results;
use crate::failure::Failure;

/// Factors in this order; all others follow in that of their names.
const FIRST: [&str; 5] = ["ball", "surface", "operator", "height", "temperature"];

/// Drops are compared by these, but not grouped: the more of them, the smaller the groups.
const NOT_GROUPED: [&str; 3] = ["operator", "height", "temperature"];

/// Everything that a session says.
///
/// Of each drop it keeps what the statistics need; all else is read from the journal again where it
/// is wanted.
pub(super) struct Outcome<'a> {
    pub(super) recordings: &'a [Setup],
    pub(super) about: AboutSession,
    /// Drops whose estimate can hardly be believed, by their place in `about.odd`.
    pub(super) doubtful: Vec<usize>,
    pub(super) drops: Vec<Drop>,
    pub(super) factors: Vec<Factor>,
    /// The factors that make groups, by their place.
    pub(super) by: Vec<usize>,
    /// The drops in the study, by their place in `drops`.
    pub(super) studied: Vec<usize>,
    /// What they add to it.
    laws: Vec<StudyDrop>,
    /// What they say together, or why they say nothing.
    pub(super) study: Result<Study, String>,
}

/// What to ask of the drops of a session.
pub(super) struct Wish {
    pub(super) by: Vec<String>,
    pub(super) at_speed_m_s: Option<f64>,
    pub(super) wanted: Option<f64>,
    pub(super) exclude: Vec<String>,
}

impl<'a> Outcome<'a> {
    /// Reads what the journal has of these recordings, and studies it.
    pub(super) fn of(results: &Results<'a>, wish: &Wish) -> Result<Self, Failure> {
        let Gathered {
            about,
            doubtful,
            drops,
            studied,
            laws,
        } = Gathered::from(results, &wish.exclude)?;
        let recordings = results.recordings;
        let mut outcome = Self {
            recordings,
            about: AboutSession {
                assumptions: assumptions(recordings),
                ..about
            },
            doubtful,
            drops,
            factors: Vec::new(),
            by: Vec::new(),
            studied,
            laws,
            study: Err("there are no drops".to_owned()),
        };
        outcome.study(wish)?;
        Ok(outcome)
    }

    fn study(&mut self, wish: &Wish) -> Result<(), Failure> {
        let used: Vec<&Setup> = self
            .studied
            .iter()
            .map(|&place| &self.recordings[self.drops[place].recording])
            .collect();
        self.factors = factors(&used);
        self.by = by(&self.factors, &wish.by)?;
        for (drop, setup) in std::iter::zip(&mut self.laws, &used) {
            drop.levels = levels(&self.factors, setup);
        }
        let study = Study::of(
            &self.laws,
            &self.factors,
            &amounts(&self.factors, &used),
            &self.by,
            wish.at_speed_m_s,
            wish.wanted,
        );
        self.study = study.map_err(|refusal| match wish.at_speed_m_s {
            _ if !self.recordings.iter().any(Setup::asks) => {
                "drops are compared by the inference, which was left out (--no-inference)"
                    .to_owned()
            }
            _ if self.laws.is_empty() => {
                "no drop has an inference that could be compared".to_owned()
            }
            Some(speed) => format!(
                "no drop knows its restitution at {speed} m/s: its impacts are slower or faster"
            ),
            None => refusal.to_string(),
        });
        self.about.no_study = self.study.as_ref().err().cloned();
        self.about.left_out.extend(self.unknown_there());
        Ok(())
    }

    /// The drops that are not compared because they do not know the speed at which the others are.
    fn unknown_there(&self) -> Vec<Reason> {
        let Ok(study) = &self.study else {
            return Vec::new();
        };
        let why = format!(
            "it does not know its restitution at {:.2} m/s",
            study.at_speed_m_s
        );
        let left_out = study.left_out.iter();
        left_out
            .map(|&drop| reason(&self.name_of(drop), &why))
            .collect()
    }

    /// Restitution of a drop of the study at a speed, with the uncertainty that is its own.
    pub(super) fn at(&self, studied: usize, speed_m_s: f64) -> Option<Measured> {
        let point = self.laws[studied].law.at(speed_m_s)?;
        Some(Measured {
            value: point.value,
            sd: point.own_sd,
        })
    }

    /// The name of a drop of the study, by its place there.
    pub(super) fn name_of(&self, studied: usize) -> String {
        let drop = &self.drops[self.studied[studied]];
        drop.name(&self.recordings[drop.recording].recording.name)
    }

    /// The result for other programs.
    pub(super) fn document(&self) -> SessionDocument {
        let name = |studied| self.name_of(studied);
        let study = self.study.as_ref().ok();
        SessionDocument::new(self.about.clone(), study, &self.factors, &self.by, name)
    }

    /// What a group is called: its levels.
    pub(super) fn group_name(&self, levels: &[Option<usize>]) -> String {
        let words: Vec<&str> = std::iter::zip(&self.by, levels)
            .map(|(&factor, level)| level.map_or("?", |level| &self.factors[factor].levels[level]))
            .collect();
        if words.is_empty() {
            "all drops".to_owned()
        } else {
            words.join(", ")
        }
    }
}

/// What was assumed of all recordings alike.
fn assumptions(recordings: &[Setup]) -> Vec<String> {
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for assumption in recordings
        .iter()
        .flat_map(|r| &r.set_up.physics.assumptions)
    {
        *counts.entry(assumption).or_default() += 1;
    }
    let all = recordings.len();
    counts
        .into_iter()
        .map(|(assumption, count)| match count {
            count if count == all => assumption.to_owned(),
            count => format!("{assumption} (in {count} of {all} recordings)"),
        })
        .collect()
}

/// Everything by which drops can be compared, with its levels in order.
fn factors(used: &[&Setup]) -> Vec<Factor> {
    let mut levels: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for (field, level) in used.iter().flat_map(|setup| &setup.set_up.factors) {
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
        let place = FIRST.iter().position(|first| *first == factor.name);
        place.unwrap_or(FIRST.len())
    };
    factors.sort_by(|a, b| rank(a).cmp(&rank(b)).then_with(|| a.name.cmp(&b.name)));
    factors
}

/// The factors that are noted in numbers, in SI.
fn amounts(factors: &[Factor], used: &[&Setup]) -> Vec<Covariate> {
    type Amount = fn(&SetUp) -> Option<f64>;
    let height: Amount = |set_up| set_up.height_m;
    let temperature: Amount = |set_up| set_up.temperature_k;
    let of_factor = |(name, amount): (&str, Amount)| {
        let factor = factors.iter().position(|factor| factor.name == name)?;
        let by_level: BTreeMap<&str, f64> = used
            .iter()
            .filter_map(|setup| {
                let level = setup.set_up.factors.get(name)?;
                Some((level.as_str(), amount(&setup.set_up)?))
            })
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

fn by(factors: &[Factor], wished: &[String]) -> Result<Vec<usize>, Failure> {
    if wished.is_empty() {
        return Ok((0..factors.len())
            .filter(|&place| {
                let factor = &factors[place];
                factor.levels.len() > 1 && !NOT_GROUPED.contains(&factor.name.as_str())
            })
            .collect());
    }
    wished
        .iter()
        .map(|name| {
            let place = factors.iter().position(|factor| factor.name == *name);
            place.ok_or_else(|| {
                let known: Vec<&str> = factors.iter().map(|f| f.name.as_str()).collect();
                Failure::Usage(format!(
                    "--by {name}: nothing is noted of that; there is {}",
                    if known.is_empty() {
                        "nothing noted at all".to_owned()
                    } else {
                        known.join(", ")
                    }
                ))
            })
        })
        .collect()
}

fn levels(factors: &[Factor], setup: &Setup) -> Vec<Option<usize>> {
    factors
        .iter()
        .map(|factor| {
            let level = setup.set_up.factors.get(&factor.name)?;
            factor.levels.iter().position(|known| known == level)
        })
        .collect()
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
