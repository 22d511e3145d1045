//! Statistics of the drops of a session.

use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::ops::Range;

use bouncelab::groups::{Covariate, Factor, Study, StudyDrop};
use bouncelab::inference::Measured;
use bouncelab_report::messages::Translator;

use crate::document::{AboutSession, Reason, SessionDocument};
use crate::error::{Error, Result};
use crate::metadata::{KnownRecording, Metadata};
use crate::name::without_name;
use crate::record::{DropRecord, PosteriorRecord, Record};
use crate::results::Results;

/// Factors in this order; all others follow in that of their names.
const FIRST: [&str; 5] = ["ball", "surface", "operator", "height", "temperature"];

/// Drops are compared by these, but not grouped: the more of them, the smaller the groups.
const NOT_GROUPED: [&str; 3] = ["operator", "height", "temperature"];

/// Why a drop is not compared that was left out by hand.
const BY_HAND: &str = "left out by hand";

/// What to ask of the drops of a session.
#[derive(Debug, Clone, Default)]
pub struct StudyOptions {
    /// The fields that make groups; if empty, ball, surface and whatever else was noted, but for
    /// operator, height and temperature.
    pub by: Vec<String>,
    /// The impact speed at which drops are compared, m/s; if left out, one that most drops know.
    pub at_speed_m_s: Option<f64>,
    /// The half width of the 95 % interval that a mean should have; if left out, half of what it has.
    pub wanted: Option<f64>,
    /// The drops to leave out: a recording, or `recording#2` for its second drop.
    pub exclude: Vec<String>,
}

/// A drop of a session.
#[derive(Debug, Clone)]
pub struct SessionDrop {
    /// The place of its recording.
    pub recording: usize,
    /// Its number there, 1 for the first.
    pub number: usize,
    /// What it is called: the recording, and `#2` where that has several drops.
    pub name: String,
    /// Whether it is left out by hand.
    pub by_hand: bool,
}

/// Everything that the drops of a session say together.
///
/// Of each drop it keeps what the statistics need; all else is read from the journal again where it
/// is wanted.
#[derive(Debug)]
pub struct Outcome<'a> {
    /// The recordings.
    pub recordings: &'a [KnownRecording],
    /// What is known of the session besides the study.
    pub about: AboutSession,
    /// Drops whose estimate can hardly be believed, by their place in `about.odd`.
    pub doubtful: Vec<usize>,
    /// The drops, in the order of their recordings and numbers.
    pub drops: Vec<SessionDrop>,
    /// What drops can be compared by.
    pub factors: Vec<Factor>,
    /// The factors that make groups, by their place.
    pub by: Vec<usize>,
    /// The drops in the study, by their place in `drops`.
    pub studied: Vec<usize>,
    /// What they add to it.
    curves: Vec<StudyDrop>,
    /// What they say together, or why they say nothing.
    pub study: std::result::Result<Study, String>,
}

impl<'a> Outcome<'a> {
    /// Reads every result once, in any order, and studies what they say together.
    ///
    /// # Errors
    /// [`Error::UnknownDrop`] and [`Error::UnknownField`] if the options name what is not there, and
    /// those of [`Results::each`].
    pub fn of(
        results: &Results<'a>,
        options: &StudyOptions,
        translator: &Translator,
    ) -> Result<Self> {
        let recordings = results.recordings;
        let mut outcome = Self {
            recordings,
            about: AboutSession {
                recordings: recordings.len(),
                assumptions: assumptions(recordings, translator),
                ..AboutSession::default()
            },
            doubtful: Vec::new(),
            drops: Vec::new(),
            factors: Vec::new(),
            by: Vec::new(),
            studied: Vec::new(),
            curves: Vec::new(),
            study: Err("there are no drops".to_owned()),
        };
        let mut excluded = Excluded::new(&options.exclude);
        let mut said = Said::default();
        let duplicates = results.duplicates();
        for (place, duplicate) in duplicates.iter().enumerate() {
            let recording = &recordings[place];
            if let Err(why) = &results.done[place].content {
                said.failed.push((place, why.clone()));
            } else if let Some(first) = duplicate {
                let first = &recordings[*first];
                let about = &mut outcome.about;
                about
                    .duplicates
                    .push(reason(recording.name(), first.name()));
                about.remarks.extend(noted_otherwise(recording, first));
            }
        }
        let counts =
            |place: usize| results.done[place].content.is_ok() && duplicates[place].is_none();
        results.each(counts, |place, _, record| {
            said.take(place, &recordings[place], record, &mut excluded, translator);
            Ok(())
        })?;
        outcome.sort(said);
        excluded.check()?;
        outcome.study(options)?;
        Ok(outcome)
    }

    /// Takes what the recordings say in the order of their names, in whatever order they were read.
    fn sort(&mut self, mut said: Said) {
        let named = |(place, why): (usize, String)| reason(self.recordings[place].name(), &why);
        said.failed.sort_by_key(|(place, _)| *place);
        self.about.failed = said.failed.into_iter().map(named).collect();
        said.without_drop.sort_by_key(|(place, _)| *place);
        self.about.without_drop = said.without_drop.into_iter().map(named).collect();
        said.drops
            .sort_by_key(|said| (said.drop.recording, said.drop.number));
        for said in said.drops {
            let of_drop = |why: &str| reason(&said.drop.name, why);
            if let Some((why, is_doubtful)) = &said.odd {
                if *is_doubtful {
                    self.doubtful.push(self.about.odd.len());
                }
                self.about.odd.push(of_drop(why));
            }
            self.about
                .left_out
                .extend(said.left_out.as_deref().map(of_drop));
            if let Some(curve) = said.studied {
                self.studied.push(self.drops.len());
                self.curves.push(curve);
            }
            self.drops.push(said.drop);
        }
        self.about.drops = self.drops.len();
    }

    fn study(&mut self, options: &StudyOptions) -> Result<()> {
        let used: Vec<&Metadata> = self
            .studied
            .iter()
            .map(|&place| &*self.recordings[self.drops[place].recording].metadata)
            .collect();
        self.factors = factors(&used);
        self.by = by(&self.factors, &options.by)?;
        for (drop, metadata) in std::iter::zip(&mut self.curves, &used) {
            drop.levels = levels(&self.factors, metadata);
        }
        let study = Study::of(
            &self.curves,
            &self.factors,
            &covariates(&self.factors, &used),
            &self.by,
            options.at_speed_m_s,
            options.wanted,
        );
        let asks = |recording: &KnownRecording| recording.metadata.asks_inference();
        self.study = study.map_err(|refusal| match options.at_speed_m_s {
            _ if !self.recordings.iter().any(asks) => {
                "drops are compared by the inference, which was left out (--no-inference)"
                    .to_owned()
            }
            _ if self.curves.is_empty() => {
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
            .map(|&drop| reason(self.name_of(drop), &why))
            .collect()
    }

    /// Restitution of a drop of the study at a speed, with the uncertainty that is its own.
    pub fn at(&self, studied: usize, speed_m_s: f64) -> Option<Measured> {
        let point = self.curves[studied].curve.at(speed_m_s)?;
        Some(Measured {
            value: point.value,
            sd: point.own_sd,
        })
    }

    /// The name of a drop of the study, by its place there.
    pub fn name_of(&self, studied: usize) -> &str {
        &self.drops[self.studied[studied]].name
    }

    /// The drops of a recording, as a range of places in `drops`.
    pub(crate) fn drops_of(&self, recording: usize) -> Range<usize> {
        let start = self
            .drops
            .partition_point(|drop| drop.recording < recording);
        let end = self
            .drops
            .partition_point(|drop| drop.recording <= recording);
        start..end
    }

    /// The scores of the outliers, by their place in `drops`.
    pub(crate) fn outlier_scores(&self) -> BTreeMap<usize, f64> {
        let outliers = self.study.iter().flat_map(|study| &study.outliers);
        outliers
            .map(|outlier| (self.studied[outlier.drop], outlier.score))
            .collect()
    }

    /// The result for other programs.
    pub fn document(&self) -> SessionDocument<'_> {
        SessionDocument::new(self)
    }

    /// What a group is called: its levels.
    pub fn group_name(&self, levels: &[Option<usize>]) -> String {
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

/// What recordings say, as it is read.
#[derive(Default)]
struct Said {
    /// Recordings that failed, by their place, and why.
    failed: Vec<(usize, String)>,
    /// Recordings without a drop, by their place, and why.
    without_drop: Vec<(usize, String)>,
    drops: Vec<SaidDrop>,
}

struct SaidDrop {
    drop: SessionDrop,
    /// What it adds to the study, if it is in it.
    studied: Option<StudyDrop>,
    /// Why it is not, if that is to be said.
    left_out: Option<String>,
    /// What is odd about it, and whether its estimate can hardly be believed.
    odd: Option<(String, bool)>,
}

impl Said {
    /// Takes what a recording says.
    fn take(
        &mut self,
        place: usize,
        recording: &KnownRecording,
        record: Record,
        excluded: &mut Excluded<'_>,
        translator: &Translator,
    ) {
        let name = recording.name();
        if let Some(why) = record.failure {
            self.failed
                .push((place, without_name(&why, name).to_owned()));
            return;
        }
        if record.drops.is_empty() {
            let why = record.no_drop.map(|why| translator.diagnostic(&why));
            self.without_drop.push((place, why.unwrap_or_default()));
        }
        let is_alone = record.drops.len() == 1;
        for (number, of_drop) in (1..).zip(record.drops) {
            let numbered = format!("{name}#{number}");
            let drop = SessionDrop {
                recording: place,
                number,
                by_hand: excluded.has(name, &numbered),
                name: if is_alone { name.to_owned() } else { numbered },
            };
            let asks_inference = recording.metadata.asks_inference();
            self.drops
                .push(SaidDrop::of(drop, of_drop, asks_inference, translator));
        }
    }
}

impl SaidDrop {
    fn of(
        drop: SessionDrop,
        record: DropRecord,
        asks_inference: bool,
        translator: &Translator,
    ) -> Self {
        let odd = (!record.diagnostics.is_empty()).then(|| {
            let odd = record.diagnostics.iter();
            let why: Vec<String> = odd.map(|odd| translator.diagnostic(odd)).collect();
            (why.join("; "), is_doubtful(&record))
        });
        let left_out = left_out(&record, drop.by_hand, translator);
        let (studied, left_out) = match (left_out, record.posterior) {
            (None, Some(posterior)) => (Some(studied(posterior)), None),
            // What was asked of no drop need not be said of each.
            (Some(_), None) if !asks_inference && !drop.by_hand => (None, None),
            (why, _) => (None, Some(why.unwrap_or_default())),
        };
        Self {
            drop,
            studied,
            left_out,
            odd,
        }
    }
}

/// What a drop adds to the study.
fn studied(posterior: PosteriorRecord) -> StudyDrop {
    let scatter = posterior.restitution_scatter;
    StudyDrop {
        curve: posterior.curve,
        scatter: scatter.known_sd().map(|sd| Measured {
            value: scatter.value,
            sd,
        }),
        levels: Vec::new(),
    }
}

/// What to say if the same sound was noted differently: only one of the notes counts.
fn noted_otherwise(other: &KnownRecording, first: &KnownRecording) -> Option<String> {
    let (of_other, of_first) = (&other.metadata.factors, &first.metadata.factors);
    let differs = |field: &&String| of_other.get(*field) != of_first.get(*field);
    let fields = of_other.keys().chain(of_first.keys());
    let field = fields.filter(differs).min()?;
    let said = |noted: Option<&String>| match noted {
        Some(text) => format!("\"{text}\""),
        None => "not noted".to_owned(),
    };
    Some(format!(
        "{} and {} are the same sound, but the {field} of the one is {} and that of the other {}; what is \
         noted of the first counts",
        first.name(),
        other.name(),
        said(of_first.get(field)),
        said(of_other.get(field)),
    ))
}

/// Whether its estimate can hardly be believed.
fn is_doubtful(drop: &DropRecord) -> bool {
    let converged = |posterior: &PosteriorRecord| posterior.converged;
    !drop.posterior.as_ref().is_none_or(converged) || drop.height_contradicts()
}

/// Why a drop is not compared; `None` if it is.
pub(crate) fn left_out(
    drop: &DropRecord,
    by_hand: bool,
    translator: &Translator,
) -> Option<String> {
    let no_posterior = drop.no_posterior.as_ref();
    match &drop.posterior {
        _ if by_hand => Some(BY_HAND.to_owned()),
        None => no_posterior.map(|why| translator.diagnostic(why)),
        Some(posterior) if posterior.curve.0.is_empty() => {
            Some("its impacts span too small a range of speeds".to_owned())
        }
        Some(_) => None,
    }
}

/// A recording or drop, and what there is to say of it.
fn reason(name: &str, reason: &str) -> Reason {
    Reason {
        name: name.to_owned(),
        reason: reason.to_owned(),
    }
}

/// The drops to leave out, and which of them there are.
struct Excluded<'a>(Vec<(&'a str, bool)>);

impl<'a> Excluded<'a> {
    fn new(names: &'a [String]) -> Self {
        Self(names.iter().map(|name| (name.as_str(), false)).collect())
    }

    /// Whether to leave out a drop of a recording, which has this name too.
    fn has(&mut self, recording: &str, numbered: &str) -> bool {
        let mut has = false;
        for (name, found) in &mut self.0 {
            if *name == recording || *name == numbered {
                *found = true;
                has = true;
            }
        }
        has
    }

    fn check(&self) -> Result<()> {
        let unknown = self.0.iter().find(|(_, found)| !found);
        unknown.map_or(Ok(()), |(name, _)| {
            let name = (*name).to_owned();
            Err(Error::UnknownDrop { name })
        })
    }
}

/// What was assumed of all recordings alike.
fn assumptions(recordings: &[KnownRecording], translator: &Translator) -> Vec<String> {
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    let assumptions = recordings
        .iter()
        .flat_map(|it| &it.metadata.setup.assumptions);
    for assumption in assumptions {
        *counts.entry(translator.diagnostic(assumption)).or_default() += 1;
    }
    let all = recordings.len();
    counts
        .into_iter()
        .map(|(assumption, count)| match count {
            count if count == all => assumption,
            count => format!("{assumption} (in {count} of {all} recordings)"),
        })
        .collect()
}

/// Everything by which drops can be compared, with its levels in order.
fn factors(used: &[&Metadata]) -> Vec<Factor> {
    let mut levels: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    for (field, level) in used.iter().flat_map(|metadata| &metadata.factors) {
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
fn covariates(factors: &[Factor], used: &[&Metadata]) -> Vec<Covariate> {
    type Amount = fn(&Metadata) -> Option<f64>;
    let height: Amount = |metadata| metadata.height_m;
    let temperature: Amount = |metadata| metadata.temperature_k;
    let of_factor = |(name, amount): (&str, Amount)| {
        let factor = factors.iter().position(|factor| factor.name == name)?;
        let by_level: BTreeMap<&str, f64> = used
            .iter()
            .filter_map(|metadata| {
                let level = metadata.factors.get(name)?;
                Some((level.as_str(), amount(metadata)?))
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

/// The factors that make groups.
fn by(factors: &[Factor], wanted: &[String]) -> Result<Vec<usize>> {
    let makes_groups =
        |factor: &Factor| factor.levels.len() > 1 && !NOT_GROUPED.contains(&factor.name.as_str());
    if wanted.is_empty() {
        let places = 0..factors.len();
        return Ok(places
            .filter(|&place| makes_groups(&factors[place]))
            .collect());
    }
    let place_of = |name: &String| {
        let place = factors.iter().position(|factor| factor.name == *name);
        place.ok_or_else(|| Error::UnknownField {
            name: name.clone(),
            known: factors.iter().map(|factor| factor.name.clone()).collect(),
        })
    };
    wanted.iter().map(place_of).collect()
}

fn levels(factors: &[Factor], metadata: &Metadata) -> Vec<Option<usize>> {
    factors
        .iter()
        .map(|factor| {
            let level = metadata.factors.get(&factor.name)?;
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
