//! Statistics of the drops of a session.

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

use bouncelab::Estimate;
use bouncelab::diagnostic::Code;
use bouncelab::groups::CurveEvidence;
use bouncelab_report::columns::{DropRecord, PosteriorRecord};
use bouncelab_report::groups::{About, GroupStudy, NotedDrop, Question, Reason};
use bouncelab_report::messages::Translator;

use crate::document::SessionDocument;
use crate::error::{Error, Result};
use crate::metadata::KnownRecording;
use crate::name::without_name;
use crate::record::Record;
use crate::results::Results;

/// Options of the study of a session.
#[derive(Debug, Clone, Default)]
pub struct StudyOptions {
    /// How the drops are to be compared.
    pub question: Question,
    /// The drops to exclude: a recording, or `recording#2` for its second drop.
    pub exclude: Vec<String>,
}

/// A drop of a session.
#[derive(Debug, Clone)]
pub struct SessionDrop {
    /// The index of its recording.
    pub recording: usize,
    /// Its number there, 1 for the first.
    pub number: usize,
    /// Its name: that of the recording, with `#2` if that has several drops.
    pub name: Arc<str>,
    /// Whether it was excluded by name.
    pub by_hand: bool,
}

/// The results of all drops of a session together.
///
/// For each drop it keeps what the statistics need; everything else is read from the journal again where it
/// is needed.
#[derive(Debug)]
pub struct Outcome<'a> {
    /// The recordings.
    pub recordings: &'a [KnownRecording],
    /// Drops whose estimate is doubtful, by their index in `groups.about.odd`.
    pub doubtful: Vec<usize>,
    /// The drops, in the order of their recordings and numbers.
    pub drops: Vec<SessionDrop>,
    /// The drops in the study, by their index in `drops`.
    pub studied: Vec<usize>,
    /// The comparison of the drops.
    pub groups: GroupStudy,
}

impl<'a> Outcome<'a> {
    /// Reads every result once, in any order, and compares the drops.
    ///
    /// # Errors
    /// [`Error::UnknownDrop`] and [`Error::UnknownField`] if the options name a drop or field that does not exist, and
    /// those of [`Results::each`].
    pub fn of(
        results: &Results<'a>,
        options: &StudyOptions,
        translator: &Translator,
    ) -> Result<Self> {
        let recordings = results.recordings;
        let mut about = About {
            recordings: recordings.len(),
            assumptions: assumptions(recordings, translator),
            ..About::default()
        };
        let mut excluded = Excluded::new(&options.exclude);
        let mut collected = Collected::default();
        let duplicates = results.duplicates();
        for (index, duplicate) in duplicates.iter().enumerate() {
            let recording = &recordings[index];
            if let Err(why) = &results.done[index].content {
                collected.failed.push((index, why.clone()));
            } else if let Some(first) = duplicate {
                let first = &recordings[*first];
                about
                    .duplicates
                    .push(reason(recording.name(), first.name()));
                about
                    .remarks
                    .extend(noted_otherwise(recording, first, translator));
            }
        }
        let counts =
            |index: usize| results.done[index].content.is_ok() && duplicates[index].is_none();
        results.each(counts, |index, _, record| {
            collected.take(index, &recordings[index], record, &mut excluded, translator);
            Ok(())
        })?;
        excluded.check()?;
        collected.outcome(about, recordings, &options.question, translator)
    }

    /// The drops of a recording, as a range of indices in `drops`.
    pub(crate) fn drops_of(&self, recording: usize) -> Range<usize> {
        let start = self
            .drops
            .partition_point(|drop| drop.recording < recording);
        let end = self
            .drops
            .partition_point(|drop| drop.recording <= recording);
        start..end
    }

    /// The scores of the outliers, by their index in `drops`.
    pub(crate) fn outlier_scores(&self) -> BTreeMap<usize, f64> {
        let outliers = self.groups.study.iter().flat_map(|study| &study.outliers);
        outliers
            .map(|outlier| (self.studied[outlier.drop], outlier.score))
            .collect()
    }

    /// The result for other programs.
    pub fn document(&self) -> SessionDocument<'_> {
        SessionDocument::new(&self.groups)
    }
}

/// The results of recordings, as they are read.
#[derive(Default)]
struct Collected {
    /// Recordings that failed, by their index, and why.
    failed: Vec<(usize, String)>,
    /// Recordings without a drop, by their index, and why.
    without_drop: Vec<(usize, String)>,
    drops: Vec<CollectedDrop>,
}

struct CollectedDrop {
    drop: SessionDrop,
    /// Its contribution to the study, if it is part of it.
    studied: Option<Studied>,
    /// Why it is not part of it, if that is to be reported.
    left_out: Option<String>,
    /// Its diagnostics as a sentence, and whether its estimate is doubtful.
    odd: Option<(String, bool)>,
}

impl Collected {
    /// Adds the result of a recording.
    fn take(
        &mut self,
        index: usize,
        recording: &KnownRecording,
        record: Record,
        excluded: &mut Excluded<'_>,
        translator: &Translator,
    ) {
        let name = recording.name();
        if let Some(why) = record.failure {
            self.failed
                .push((index, without_name(&why, name).to_owned()));
            return;
        }
        if record.drops.is_empty() {
            let why = record.no_drop.map(|why| translator.diagnostic(&why));
            self.without_drop.push((index, why.unwrap_or_default()));
        }
        let is_alone = record.drops.len() == 1;
        for (number, of_drop) in (1..).zip(record.drops) {
            let numbered = format!("{name}#{number}");
            let drop = SessionDrop {
                recording: index,
                number,
                by_hand: excluded.has(name, &numbered),
                name: if is_alone {
                    name.into()
                } else {
                    numbered.into()
                },
            };
            let asks_inference = recording.metadata.asks_inference();
            self.drops
                .push(CollectedDrop::of(drop, of_drop, asks_inference, translator));
        }
    }

    /// Puts the results into the order of the names of their recordings, in whatever order they were read, and compares
    /// the drops.
    fn outcome<'a>(
        mut self,
        mut about: About,
        recordings: &'a [KnownRecording],
        question: &Question,
        translator: &Translator,
    ) -> Result<Outcome<'a>> {
        let named = |(index, why): (usize, String)| reason(recordings[index].name(), &why);
        self.failed.sort_by_key(|(index, _)| *index);
        about.failed = self.failed.into_iter().map(named).collect();
        self.without_drop.sort_by_key(|(index, _)| *index);
        about.without_drop = self.without_drop.into_iter().map(named).collect();
        self.drops
            .sort_by_key(|one| (one.drop.recording, one.drop.number));
        about.drops = self.drops.len();
        let (mut drops, mut doubtful) = (Vec::new(), Vec::new());
        let (mut indices, mut noted) = (Vec::new(), Vec::new());
        for one in self.drops {
            let of_drop = |why: &str| reason(&one.drop.name, why);
            if let Some((why, is_doubtful)) = &one.odd {
                if *is_doubtful {
                    doubtful.push(about.odd.len());
                }
                about.odd.push(of_drop(why));
            }
            about.left_out.extend(one.left_out.as_deref().map(of_drop));
            if let Some(studied) = one.studied {
                indices.push(drops.len());
                let factors = &recordings[one.drop.recording].metadata.factors;
                noted.push(studied.noted(Arc::clone(&one.drop.name), factors));
            }
            drops.push(one.drop);
        }
        let mut groups = GroupStudy::of(about, noted, question, translator)?;
        let asks = |recording: &KnownRecording| recording.metadata.asks_inference();
        if groups.study.is_err() && !recordings.iter().any(asks) {
            let why = translator.text("session-inference-left-out");
            groups.about.no_study = Some(why.clone());
            groups.study = Err(why);
        }
        Ok(Outcome {
            recordings,
            doubtful,
            drops,
            studied: indices,
            groups,
        })
    }
}

impl CollectedDrop {
    fn of(
        drop: SessionDrop,
        record: DropRecord,
        asks_inference: bool,
        translator: &Translator,
    ) -> Self {
        let odd = (!record.diagnostics.is_empty()).then(|| {
            let sentences = record.diagnostics.iter();
            let why = translator.in_one_line(sentences.map(|odd| translator.diagnostic(odd)));
            (why, record.height_contradicts())
        });
        let left_out = left_out(&record, drop.by_hand, translator);
        let (studied, left_out) = match (left_out, record.posterior) {
            (None, Some(posterior)) => {
                let scatter = record.quantities.get("restitution_scatter");
                (Studied::of(posterior, scatter), None)
            }
            // If no inference was requested, this is reported once and not for each drop.
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

/// The drops of a recording that are compared, each with what was noted of the recording.
pub fn compared_drops<'a>(
    record: Record,
    factors: &'a BTreeMap<String, String>,
    translator: &Translator,
) -> Vec<NotedDrop<'a>> {
    let compared = record
        .drops
        .into_iter()
        .filter(|drop| left_out(drop, false, translator).is_none());
    let noted = |drop: DropRecord| {
        let scatter = drop.quantities.get("restitution_scatter").copied();
        let studied = Studied::of(drop.posterior?, scatter.as_ref())?;
        Some(studied.noted(Arc::default(), factors))
    };
    compared.filter_map(noted).collect()
}

/// The contribution of a drop to the study.
struct Studied {
    evidence: CurveEvidence,
    scatter: Option<f64>,
}

impl Studied {
    fn of(posterior: PosteriorRecord, scatter: Option<&Estimate>) -> Option<Self> {
        Some(Self {
            evidence: posterior.evidence?,
            scatter: scatter.map(|scatter| scatter.value),
        })
    }

    fn noted(self, name: Arc<str>, factors: &BTreeMap<String, String>) -> NotedDrop<'_> {
        NotedDrop {
            name,
            factors,
            evidence: self.evidence,
            scatter: self.scatter,
        }
    }
}

/// A remark for two recordings of the same sound with different notes: only those of the first count.
fn noted_otherwise(
    other: &KnownRecording,
    first: &KnownRecording,
    translator: &Translator,
) -> Option<String> {
    let (of_other, of_first) = (&other.metadata.factors, &first.metadata.factors);
    let differs = |field: &&String| of_other.get(*field) != of_first.get(*field);
    let fields = of_other.keys().chain(of_first.keys());
    let field = fields.filter(differs).min()?;
    let quoted = |noted: Option<&String>| match noted {
        Some(text) => format!("\"{text}\""),
        None => translator.text("session-not-noted"),
    };
    let arguments = [
        ("first", first.name().into()),
        ("other", other.name().into()),
        ("field", field.as_str().into()),
        ("of-first", quoted(of_first.get(field)).into()),
        ("of-other", quoted(of_other.get(field)).into()),
    ];
    Some(translator.text_with("session-noted-otherwise", &arguments))
}

/// Why a drop is not compared; `None` if it is.
pub(crate) fn left_out(
    drop: &DropRecord,
    by_hand: bool,
    translator: &Translator,
) -> Option<String> {
    let no_posterior = drop.no_posterior.as_ref();
    match &drop.posterior {
        _ if by_hand => Some(translator.text("session-by-hand")),
        None => no_posterior.map(|why| translator.diagnostic(why)),
        Some(posterior)
            if !posterior
                .evidence
                .as_ref()
                .is_some_and(CurveEvidence::is_usable) =>
        {
            Some(translator.text("session-no-curve"))
        }
        Some(_) => None,
    }
}

/// A recording or drop with a remark.
fn reason(name: &str, reason: &str) -> Reason {
    Reason {
        name: name.to_owned(),
        reason: reason.to_owned(),
    }
}

/// The names of drops to exclude, and whether each exists.
struct Excluded<'a>(Vec<(&'a str, bool)>);

impl<'a> Excluded<'a> {
    fn new(names: &'a [String]) -> Self {
        Self(names.iter().map(|name| (name.as_str(), false)).collect())
    }

    /// Whether to exclude a drop, which is named by its recording or by itself.
    fn has(&mut self, recording: &str, numbered: &str) -> bool {
        let mut has = false;
        for (name, exists) in &mut self.0 {
            if *name == recording || *name == numbered {
                *exists = true;
                has = true;
            }
        }
        has
    }

    fn check(&self) -> Result<()> {
        let unknown = self.0.iter().find(|(_, exists)| !exists);
        unknown.map_or(Ok(()), |(name, _)| {
            let name = (*name).to_owned();
            Err(Error::UnknownDrop { name })
        })
    }
}

/// The assumptions for all recordings or for some of them: a sentence for each, ordered by their diagnostics.
fn assumptions(recordings: &[KnownRecording], translator: &Translator) -> Vec<String> {
    let mut counts: BTreeMap<(Code, String), usize> = BTreeMap::new();
    let assumptions = recordings
        .iter()
        .flat_map(|it| &it.metadata.setup.assumptions);
    for assumption in assumptions {
        let sentence = translator.diagnostic(assumption);
        *counts.entry((assumption.code, sentence)).or_default() += 1;
    }
    let all = recordings.len();
    counts
        .into_iter()
        .map(|((_, assumption), count)| match count {
            count if count == all => assumption,
            count => translator.text_with(
                "groups-assumed-of-some",
                &[
                    ("assumption", assumption.trim_end_matches('.').into()),
                    ("count", count.into()),
                    ("all", all.into()),
                ],
            ),
        })
        .collect()
}
