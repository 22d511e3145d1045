//! What do many recordings say together?

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::Duration;

use bouncelab::settings::Settings;
use bouncelab_report::groups::Question;
use bouncelab_report::messages::Translator;
use bouncelab_report::report::Provenance;
use bouncelab_session::journal::{Journal, Key};
use bouncelab_session::{
    Advice, Done, KnownRecording, MetadataOptions, Outcome, Record, Results, Session as Gathered,
    Sources, Store, StudyOptions, UnmatchedNames, complete, figures, record_of, report, tables,
};
use pyo3::prelude::*;
use pyo3::pybacked::PyBackedBytes;
use serde::Deserialize;
use tempfile::TempDir;

use crate::chart::Chart;
use crate::failure::{Failure, Result};
use crate::page::Page;
use crate::physics::translator;
use crate::table::Table;
use crate::watch::{Watch, interruptible};

/// Figures with their names.
type Charts = Vec<(&'static str, Chart)>;

/// What is asked of a session.
#[derive(Clone, Deserialize)]
#[serde(deny_unknown_fields)]
struct Request {
    inputs: Vec<PathBuf>,
    pattern: Option<String>,
    notes: Option<PathBuf>,
    output: Option<PathBuf>,
    by: Option<Vec<String>>,
    compare_at_m_s: Option<f64>,
    wanted: Option<f64>,
    exclude: Vec<String>,
    allow_missing: bool,
    allow_implausible: bool,
}

/// The recordings of a session with what is known of them, its title, and which names of files are odd.
type Gathering = (Vec<KnownRecording>, Option<String>, UnmatchedNames);

impl Request {
    fn gather(&self, settings: &Settings) -> Result<Gathering> {
        let mut session = Gathered::gather(&Sources {
            inputs: self.inputs.clone(),
            pattern: self.pattern.clone(),
            notes: self.notes.clone(),
        })?;
        let (title, unmatched_names) = (
            session.title.take(),
            std::mem::take(&mut session.unmatched_names),
        );
        let english = Translator::english();
        let recordings = MetadataOptions {
            settings,
            allow_implausible: self.allow_implausible,
            allow_missing: self.allow_missing,
            translator: &english,
            advice: Advice {
                implausible: "Correct it, or say allow_implausible=True.",
                missing: "or go on without by allow_missing=True",
                ball: "or give the kind of all balls by ball=",
            },
        };
        Ok((recordings.read(session)?, title, unmatched_names))
    }
}

/// The recordings of a session in a child process, which analyses those that it is asked for.
#[pyclass(frozen, module = "bouncelab._core")]
pub(crate) struct SessionWork(Vec<KnownRecording>);

#[pymethods]
impl SessionWork {
    #[new]
    fn new(py: Python<'_>, settings: &str, request: &str) -> Result<Self> {
        let settings: Settings = serde_json::from_str(settings)?;
        let request: Request = serde_json::from_str(request)?;
        py.detach(|| Ok(Self(request.gather(&settings)?.0)))
    }

    /// The record of a recording as JSON; `null` if it is no longer what was asked for.
    fn record(&self, py: Python<'_>, name: &str, key: &str) -> Result<Vec<u8>> {
        let key: Key = serde_json::from_str(key)?;
        py.detach(|| Ok(serde_json::to_vec(&record_of(&self.0, name, &key))?))
    }
}

/// The recordings of a session, analysed. What they say together is asked while they are there.
#[pyclass(frozen, module = "bouncelab._core")]
pub(crate) struct Session(Arc<Analyzed>);

struct Analyzed {
    recordings: Vec<KnownRecording>,
    done: Vec<Done>,
    journal: Journal,
    options: StudyOptions,
    title: Option<String>,
    unmatched_names: UnmatchedNames,
    /// Where the journal is, unless somebody wants to keep it.
    _temporary: Option<TempDir>,
}

impl Analyzed {
    fn of(
        request: Request,
        settings: &Settings,
        children: &[Py<PyAny>],
        mut watch: Watch,
    ) -> Result<Self> {
        let (recordings, title, unmatched_names) = request.gather(settings)?;
        let temporary = match &request.output {
            Some(_) => None,
            None => Some(tempfile::tempdir().map_err(|why| Failure::Output(why.to_string()))?),
        };
        let own = temporary.as_ref().map(|folder| folder.path().to_owned());
        let folder = request.output.or(own).unwrap_or_default();
        let journal = Journal::open(&folder)?;
        let done = analyze_all(&recordings, &journal, children, &mut watch)?;
        journal.sync()?;
        Ok(Self {
            recordings,
            done,
            journal,
            options: StudyOptions {
                question: Question {
                    by: request.by,
                    at_speed_m_s: request.compare_at_m_s,
                    wanted: request.wanted,
                },
                exclude: request.exclude,
            },
            title,
            unmatched_names,
            _temporary: temporary,
        })
    }

    fn results(&self) -> Results<'_> {
        Results {
            recordings: &self.recordings,
            done: &self.done,
            store: Store::Journal(&self.journal),
        }
    }

    fn outcome(&self, words: &Translator) -> Result<Outcome<'_>> {
        let mut outcome = Outcome::of(&self.results(), &self.options, words)?;
        outcome.groups.about.title.clone_from(&self.title);
        let remarks = &mut outcome.groups.about.remarks;
        remarks.extend(self.unmatched_names.remark(words));
        Ok(outcome)
    }
}

/// Why a recording has no record.
enum Trouble {
    /// Its analysis ended its process, for this reason.
    Died(String),
    /// The session cannot go on.
    Session(Failure),
}

impl<E: Into<Failure>> From<E> for Trouble {
    fn from(error: E) -> Self {
        Self::Session(error.into())
    }
}

/// Has a child process analyse a recording.
fn isolated(
    child: &Py<PyAny>,
    name: &str,
    key: &Key,
) -> std::result::Result<Option<Record>, Trouble> {
    let given = (name, serde_json::to_string(key)?);
    let record = Python::attach(|py| -> std::result::Result<PyBackedBytes, Trouble> {
        let outcome = child.bind(py).call_method1("row", (given,))?;
        if let Ok((_, reason)) = outcome.extract::<(String, String)>() {
            return Err(Trouble::Died(reason));
        }
        Ok(outcome.extract().map_err(PyErr::from)?)
    })?;
    Ok(serde_json::from_slice(&record)?)
}

/// Analyses every recording whose result is not in the journal yet, each child in a thread that ends here.
fn analyze_all(
    recordings: &[KnownRecording],
    journal: &Journal,
    children: &[Py<PyAny>],
    watch: &mut Watch,
) -> Result<Vec<Done>> {
    let (next, finished) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let stop = AtomicBool::new(false);
    let results = Mutex::new(Vec::new());
    let work = |child: &Py<PyAny>| {
        while !stop.load(Ordering::Relaxed) {
            let place = next.fetch_add(1, Ordering::Relaxed);
            let Some(recording) = recordings.get(place) else {
                break;
            };
            let analyze = |key| isolated(child, recording.name(), &key);
            let done = match complete(recording, journal, analyze) {
                Ok(done) => Ok(done),
                Err(Trouble::Died(reason)) => Ok(Done::failed(reason)),
                Err(Trouble::Session(failure)) => Err(failure),
            };
            if let Ok(mut results) = results.lock() {
                results.push((place, done));
            }
            finished.fetch_add(1, Ordering::Relaxed);
        }
    };
    thread::scope(|threads| {
        let work = &work;
        let workers = children
            .iter()
            .map(|child| threads.spawn(move || work(child)));
        let workers: Vec<_> = workers.collect();
        while workers.iter().any(|worker| !worker.is_finished()) {
            let whole = Some(recordings.len() as f64);
            let count = finished.load(Ordering::Relaxed) as f64;
            if let Err(interruption) = watch.look("recordings", count, whole) {
                stop.store(true, Ordering::Relaxed);
                // Nobody waits for what they are doing.
                Python::attach(|py| {
                    let mut ends = children.iter().map(|child| child.call_method0(py, "end"));
                    ends.try_for_each(|ended| ended.map(drop))
                })?;
                return Err(interruption);
            }
            thread::sleep(Duration::from_millis(2));
        }
        Ok(())
    })?;
    let mut results = results.into_inner().unwrap_or_default();
    results.sort_by_key(|(place, _)| *place);
    let done = results.into_iter().map(|(_, done)| done);
    done.collect()
}

#[pymethods]
impl Session {
    #[new]
    fn new(
        py: Python<'_>,
        settings: &str,
        request: &str,
        report: Option<Py<PyAny>>,
        children: Vec<Py<PyAny>>,
    ) -> Result<Self> {
        let settings: Settings = serde_json::from_str(settings)?;
        let request: Request = serde_json::from_str(request)?;
        let watch = Watch::new(report);
        let analyzed = py.detach(|| Analyzed::of(request, &settings, &children, watch))?;
        Ok(Self(Arc::new(analyzed)))
    }

    /// The tables of drops and impacts.
    fn tables(&self, py: Python<'_>) -> Result<(Table, Table)> {
        let session = Arc::clone(&self.0);
        let [drops, impacts] = py.detach(|| {
            interruptible(move || -> Result<_> {
                let outcome = session.outcome(&Translator::english())?;
                Ok(tables(&outcome, &session.results())?)
            })
        })??;
        Ok((Table(drops), Table(impacts)))
    }

    /// In a language: the document of the schema `bouncelab.session/3`, the figures with their names, and the report.
    fn reported(&self, py: Python<'_>, language: &str) -> Result<(String, Charts, Page)> {
        let (session, words) = (Arc::clone(&self.0), translator(language)?);
        let (document, charts, page) = py.detach(|| {
            interruptible(move || -> Result<_> {
                let (outcome, results) = (session.outcome(&words)?, session.results());
                let charts = figures(&outcome, &results, &words)?;
                let page = report(&outcome, &results, &charts, Provenance::default(), &words);
                Ok((serde_json::to_string(&outcome.document())?, charts, page))
            })
        })??;
        let charts = charts.into_iter().map(|(name, chart)| (name, Chart(chart)));
        Ok((document, charts.collect(), Page(page)))
    }
}
