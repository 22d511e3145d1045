//! What came of a session: which drops there are, and what they say together.

use std::collections::BTreeMap;

use bouncelab::estimate::Measured;
use bouncelab::groups::{Factor, Law, Study, StudyDrop};
use bouncelab_session::journal::Journal;

use super::notes::Understood;
use super::record::{DropRecord, Record};
use super::work::{Done, duplicates};
use crate::failure::Failure;

/// Factors in this order; all others follow in that of their names.
const FIRST: [&str; 5] = ["ball", "surface", "operator", "height", "temperature"];

/// Drops are compared by these, but not grouped: the more of them, the smaller the groups.
const NOT_GROUPED: [&str; 3] = ["operator", "height", "temperature"];

/// A recording and what became of it.
pub(super) enum Fate {
    /// It holds a drop or more.
    Heard,
    /// It holds no drop, for this reason.
    Silent(String),
    /// It could not be read, for this reason.
    Failed(String),
    /// It has the same content as another of this name.
    Duplicate(String),
}

/// A drop of a session, as far as it is kept in memory.
pub(super) struct Drop {
    /// The place of its recording.
    pub(super) recording: usize,
    /// Its number there, 1 for the first.
    pub(super) number: usize,
    /// What it is called: the recording, and `#2` where that has several drops.
    pub(super) name: String,
    /// Why it is not in the study.
    pub(super) left_out: Option<String>,
    /// What is odd about it.
    pub(super) remarks: Vec<String>,
    /// Impact speed and restitution of some impacts, for a figure.
    pub(super) impacts: Vec<(f64, f64)>,
    law: Law,
    scatter: Option<f64>,
    /// Whether its estimate can be believed.
    pub(super) doubtful: bool,
}

impl Drop {
    /// Restitution at a speed with the uncertainty that is its own.
    pub(super) fn at(&self, speed_m_s: f64) -> Option<Measured> {
        let point = self.law.at(speed_m_s)?;
        Some(Measured {
            value: point.value,
            sd: point.own_sd,
        })
    }

    /// The law at a speed.
    pub(super) fn law_at(&self, speed_m_s: f64) -> Option<bouncelab::groups::LawPoint> {
        self.law.at(speed_m_s)
    }
}

/// Everything that a session says.
pub(super) struct Outcome {
    pub(super) title: Option<String>,
    pub(super) fates: Vec<Fate>,
    pub(super) names: Vec<String>,
    pub(super) drops: Vec<Drop>,
    pub(super) factors: Vec<Factor>,
    /// The factors that make groups, by their place.
    pub(super) by: Vec<usize>,
    /// The drops in the study, by their place in `drops`.
    pub(super) studied: Vec<usize>,
    /// What they say together, or why they say nothing.
    pub(super) study: Result<Study, String>,
    pub(super) remarks: Vec<String>,
    pub(super) assumptions: Vec<String>,
}

/// What to ask of the drops of a session.
pub(super) struct Wish {
    pub(super) by: Vec<String>,
    pub(super) at_speed_m_s: Option<f64>,
    pub(super) wanted: Option<f64>,
    pub(super) exclude: Vec<String>,
}

impl Outcome {
    /// Reads what the journal has of these recordings, and studies it.
    pub(super) fn of(
        recordings: &[Understood],
        done: &Done,
        journal: &Journal,
        wish: &Wish,
    ) -> Result<Self, Failure> {
        let duplicates = duplicates(recordings, done);
        let mut fates = Vec::new();
        let mut drops = Vec::new();
        for (place, understood) in recordings.iter().enumerate() {
            let name = &understood.recording.name;
            let fate = match (&done.keys[place], &duplicates[place]) {
                (Err(reason), _) => Fate::Failed(reason.clone()),
                (Ok(_), Some(first)) => Fate::Duplicate(first.clone()),
                (Ok(key), None) => match journal.read::<Record>(name, key)? {
                    Some(record) => take(place, name, record, &mut drops),
                    None => Fate::Failed(format!("{name}: its result is lost; run again")),
                },
            };
            fates.push(fate);
        }
        let mut outcome = Self {
            title: None,
            fates,
            names: recordings
                .iter()
                .map(|r| r.recording.name.clone())
                .collect(),
            drops,
            factors: Vec::new(),
            by: Vec::new(),
            studied: Vec::new(),
            study: Err("there are no drops".to_owned()),
            remarks: Vec::new(),
            assumptions: assumptions(recordings),
        };
        outcome.exclude(&wish.exclude)?;
        outcome.study(recordings, wish)?;
        Ok(outcome)
    }

    /// Leaves drops out by hand.
    fn exclude(&mut self, names: &[String]) -> Result<(), Failure> {
        for name in names {
            let mut found = false;
            for drop in &mut self.drops {
                let recording = &self.names[drop.recording];
                if *name == drop.name
                    || name == recording
                    || *name == format!("{recording}#{}", drop.number)
                {
                    drop.left_out = Some("left out by hand".to_owned());
                    found = true;
                }
            }
            if !found {
                return Err(Failure::Usage(format!(
                    "--exclude {name}: there is no such drop; write the recording as in the tables, \
                     with #2 for its second drop"
                )));
            }
        }
        Ok(())
    }

    fn study(&mut self, recordings: &[Understood], wish: &Wish) -> Result<(), Failure> {
        self.studied = (0..self.drops.len())
            .filter(|&place| self.drops[place].left_out.is_none())
            .collect();
        let used: Vec<&Understood> = self
            .studied
            .iter()
            .map(|&place| &recordings[self.drops[place].recording])
            .collect();
        self.factors = factors(&used);
        self.by = by(&self.factors, &wish.by)?;
        let drops: Vec<StudyDrop> = std::iter::zip(&self.studied, &used)
            .map(|(&place, understood)| StudyDrop {
                law: self.drops[place].law.clone(),
                scatter: self.drops[place].scatter,
                levels: levels(&self.factors, understood),
            })
            .collect();
        let study = Study::of(
            &drops,
            &self.factors,
            &self.by,
            wish.at_speed_m_s,
            wish.wanted,
        );
        self.study = study.map_err(|refusal| match wish.at_speed_m_s {
            _ if drops.is_empty() => "no drop has an inference that could be compared".to_owned(),
            Some(speed) => format!(
                "no drop knows its restitution at {speed} m/s: its impacts are slower or faster"
            ),
            None => refusal.to_string(),
        });
        Ok(())
    }

    /// The name of a drop of the study, by its place there.
    pub(super) fn name_of(&self, studied: usize) -> &str {
        &self.drops[self.studied[studied]].name
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

/// Takes the drops of a record, and says what became of the recording.
fn take(place: usize, name: &str, record: Record, drops: &mut Vec<Drop>) -> Fate {
    if let Some(reason) = record.failure {
        return Fate::Failed(reason);
    }
    let count = record.drops.len();
    for (number, drop) in (1..).zip(record.drops) {
        let name = match count {
            1 => name.to_owned(),
            _ => format!("{name}#{number}"),
        };
        drops.push(kept(place, number, name, drop));
    }
    match count {
        0 => Fate::Silent(record.no_drop.unwrap_or_default()),
        _ => Fate::Heard,
    }
}

fn kept(recording: usize, number: usize, name: String, drop: DropRecord) -> Drop {
    /// Points of one drop in a figure.
    const SHOWN: usize = 40;
    let estimate = drop.estimate.as_ref();
    let seen = drop.impacts.iter().filter_map(|impact| {
        let weight = impact.weight.unwrap_or(1.0);
        (weight > 0.0).then_some((impact.impact_speed_m_s?, impact.restitution?))
    });
    let law = estimate
        .map(super::record::EstimateRecord::law)
        .unwrap_or_default();
    let left_out = match (&drop.no_estimate, law.0.is_empty()) {
        (Some(reason), _) => Some(reason.clone()),
        (None, true) => Some("its impacts span too small a range of speeds".to_owned()),
        (None, false) => None,
    };
    Drop {
        recording,
        number,
        name,
        left_out,
        impacts: seen.take(SHOWN).collect(),
        law,
        scatter: estimate.map(|estimate| estimate.scatter.value),
        doubtful: estimate.is_some_and(|e| !e.converged || e.height_contradicts),
        remarks: drop.remarks,
    }
}

/// What was assumed of all recordings alike.
fn assumptions(recordings: &[Understood]) -> Vec<String> {
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for assumption in recordings.iter().flat_map(|r| &r.physics.assumptions) {
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
fn factors(used: &[&Understood]) -> Vec<Factor> {
    let mut levels: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for (field, level) in used.iter().flat_map(|understood| &understood.factors) {
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

/// By the number with which both begin, or as text.
fn in_order(a: &str, b: &str) -> std::cmp::Ordering {
    let number = |text: &str| {
        let end = text
            .find(|c: char| !(c.is_ascii_digit() || c == '.' || c == '-'))
            .unwrap_or(text.len());
        text[..end].parse::<f64>().ok()
    };
    match (number(a), number(b)) {
        (Some(x), Some(y)) => x.total_cmp(&y).then_with(|| a.cmp(b)),
        _ => a.cmp(b),
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

fn levels(factors: &[Factor], understood: &Understood) -> Vec<Option<usize>> {
    factors
        .iter()
        .map(|factor| {
            let level = understood.factors.get(&factor.name)?;
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
}
