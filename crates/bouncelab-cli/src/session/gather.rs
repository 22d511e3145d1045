//! From the results of all recordings what the study needs, and what there is to say of the rest.

use bouncelab::groups::StudyDrop;
use bouncelab_report::document::{AboutSession, Reason};

use super::notes::Setup;
use super::record::{DropRecord, EstimateRecord, Record};
use super::results::Results;
use crate::failure::Failure;

/// Why a drop is not compared that was left out by hand.
const BY_HAND: &str = "left out by hand";

/// Which drop it is.
pub(super) struct Drop {
    /// The place of its recording.
    pub(super) recording: usize,
    /// Its number there, 1 for the first.
    pub(super) number: usize,
    /// Whether its recording has others.
    has_company: bool,
    pub(super) by_hand: bool,
}

impl Drop {
    /// What it is called: the recording, and `#2` where that has several drops.
    pub(super) fn name(&self, recording: &str) -> String {
        if self.has_company {
            format!("{recording}#{}", self.number)
        } else {
            recording.to_owned()
        }
    }
}

/// What is kept of all results.
#[derive(Default)]
pub(super) struct Gathered {
    pub(super) about: AboutSession,
    /// Drops whose estimate can hardly be believed, by their place in `about.odd`.
    pub(super) doubtful: Vec<usize>,
    pub(super) drops: Vec<Drop>,
    /// The drops that can be compared, by their place in `drops`, ...
    pub(super) studied: Vec<usize>,
    /// ... and what they say, without their levels.
    pub(super) laws: Vec<StudyDrop>,
}

impl Gathered {
    /// Reads every result once.
    pub(super) fn from(results: &Results<'_>, exclude: &[String]) -> Result<Self, Failure> {
        let mut gathered = Self::default();
        let mut exclude = Excluded {
            names: exclude,
            found: vec![false; exclude.len()],
        };
        let names = |place: usize| results.recordings[place].recording.name.as_str();
        gathered.about.recordings = results.recordings.len();
        for (place, duplicate) in results.duplicates().into_iter().enumerate() {
            let name = names(place);
            let about = &mut gathered.about;
            match (&results.done.contents[place], duplicate) {
                (Err(why), _) => about.failed.push(reason(name, why)),
                (Ok(_), Some(first)) => {
                    about.duplicates.push(reason(name, names(first)));
                    about.remarks.extend(noted_otherwise(
                        &results.recordings[place],
                        &results.recordings[first],
                    ));
                }
                (Ok(_), None) => {
                    let (_, record) = results.read(place)?;
                    gathered.take(place, &results.recordings[place], record, &mut exclude);
                }
            }
        }
        gathered.about.drops = gathered.drops.len();
        exclude.check()?;
        Ok(gathered)
    }

    fn take(
        &mut self,
        recording: usize,
        setup: &Setup,
        record: Record,
        exclude: &mut Excluded<'_>,
    ) {
        let name = &setup.recording.name;
        if let Some(why) = record.failure {
            // It may begin with the path of the recording, which is named already.
            let why = match why.split_once(": ") {
                Some((path, rest)) if path.ends_with(name.as_str()) => rest,
                _ => &why,
            };
            self.about.failed.push(reason(name, why));
            return;
        }
        if record.drops.is_empty() {
            let why = record.no_drop.unwrap_or_default();
            self.about.without_drop.push(reason(name, &why));
        }
        let has_company = record.drops.len() > 1;
        let asked = setup.asks();
        for (number, of_drop) in (1..).zip(record.drops) {
            let drop = Drop {
                recording,
                number,
                has_company,
                by_hand: exclude.has(name, number),
            };
            let name = drop.name(name);
            if !of_drop.remarks.is_empty() {
                if of_drop.estimate.as_ref().is_some_and(is_doubtful) {
                    self.doubtful.push(self.about.odd.len());
                }
                let why = of_drop.remarks.join("; ");
                self.about.odd.push(reason(&name, &why));
            }
            match (left_out(&of_drop, drop.by_hand), &of_drop.estimate) {
                (None, Some(estimate)) => {
                    self.studied.push(self.drops.len());
                    self.laws.push(StudyDrop {
                        law: estimate.law(),
                        scatter: estimate.scatter.measured(),
                        levels: Vec::new(),
                    });
                }
                // What was asked of no drop need not be said of each.
                (Some(_), None) if !asked && !drop.by_hand => {}
                (why, _) => {
                    let why = why.unwrap_or_default();
                    self.about.left_out.push(reason(&name, &why));
                }
            }
            self.drops.push(drop);
        }
    }
}

/// What to say if the same sound was noted differently: only one of the notes counts.
fn noted_otherwise(other: &Setup, first: &Setup) -> Option<String> {
    let (of_other, of_first) = (&other.set_up.factors, &first.set_up.factors);
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
        first.recording.name,
        other.recording.name,
        said(of_first.get(field)),
        said(of_other.get(field)),
    ))
}

fn is_doubtful(estimate: &EstimateRecord) -> bool {
    !estimate.converged || estimate.height_contradicts
}

/// Why a drop is not compared; `None` if it is.
pub(super) fn left_out(drop: &DropRecord, by_hand: bool) -> Option<String> {
    let lawless = drop
        .estimate
        .as_ref()
        .is_none_or(|found| found.law.is_empty());
    match &drop.no_estimate {
        _ if by_hand => Some(BY_HAND.to_owned()),
        Some(why) => Some(why.clone()),
        None if lawless => Some("its impacts span too small a range of speeds".to_owned()),
        None => None,
    }
}

/// A recording or drop, and what there is to say of it.
pub(super) fn reason(name: &str, reason: &str) -> Reason {
    Reason {
        name: name.to_owned(),
        reason: reason.to_owned(),
    }
}

/// The drops to leave out, and which of them there are.
struct Excluded<'a> {
    names: &'a [String],
    found: Vec<bool>,
}

impl Excluded<'_> {
    fn has(&mut self, recording: &str, number: usize) -> bool {
        let numbered = format!("{recording}#{number}");
        let mut has = false;
        for (name, found) in self.names.iter().zip(&mut self.found) {
            if name == recording || *name == numbered {
                *found = true;
                has = true;
            }
        }
        has
    }

    fn check(&self) -> Result<(), Failure> {
        let unknown = self
            .names
            .iter()
            .zip(&self.found)
            .find(|(_, found)| !**found);
        unknown.map_or(Ok(()), |(name, _)| {
            Err(Failure::Usage(format!(
                "--exclude {name}: there is no such drop; write the recording as in the tables, \
                 with #2 for its second drop, and --exclude before each of several"
            )))
        })
    }
}
