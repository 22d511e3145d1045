//! What does sound say, or a list of times?

use std::path::PathBuf;
use std::sync::Arc;

use bouncelab::Detector;
use bouncelab::analysis::Plan;
use bouncelab::settings::{Settings, Setup};
use bouncelab_audio::{Input, check_layout};
use pyo3::prelude::*;

use crate::failure::Result;
use crate::recording::Recording;
use crate::samples::Frames;
use crate::watch::{Watch, interruptible};

/// Settings, resolved.
#[pyclass(frozen, module = "bouncelab._core")]
#[derive(Clone)]
pub(crate) struct Analyzer {
    /// As they were given: what a pickle holds.
    settings: String,
    pub(crate) setup: Setup,
}

impl Analyzer {
    /// Analyses the drops of a plan, one after the other.
    pub(crate) fn run(&self, name: &str, plan: Plan, watch: &mut Watch) -> Result<Recording> {
        let count = plan.tasks().len() as f64;
        let drops = plan.tasks().iter().enumerate().map(|(done, task)| {
            watch.look("drops", done as f64, Some(count))?;
            let task = task.clone();
            interruptible(move || task.run())
        });
        let drops = drops.collect::<Result<_>>()?;
        Ok(Recording::new(name, self.clone(), plan.finish(drops)))
    }

    fn input(&self, name: &str, input: Input, mut watch: Watch) -> Result<Recording> {
        let whole_s = input.duration_s();
        let plan = input.plan(&self.setup.options, |done_s| {
            watch.look("s", done_s, whole_s)
        })?;
        self.run(name, plan, &mut watch)
    }
}

#[pymethods]
impl Analyzer {
    #[new]
    fn new(settings: String) -> Result<Self> {
        let given: Settings = serde_json::from_str(&settings)?;
        let setup = given.resolve()?;
        Ok(Self { settings, setup })
    }

    fn __getnewargs__(&self) -> (String,) {
        (self.settings.clone(),)
    }

    /// Analyses a file.
    fn file(
        &self,
        py: Python<'_>,
        path: PathBuf,
        name: &str,
        report: Option<Py<PyAny>>,
    ) -> Result<Recording> {
        py.detach(|| self.input(name, Input::open(path)?, Watch::new(report)))
    }

    /// Analyses the content of a file.
    fn content(
        &self,
        py: Python<'_>,
        content: &[u8],
        name: &str,
        report: Option<Py<PyAny>>,
    ) -> Result<Recording> {
        let input = Input::from_bytes(content, name)?;
        py.detach(|| self.input(name, input, Watch::new(report)))
    }

    /// Analyses a list of times.
    fn times(&self, py: Python<'_>, times_s: Vec<f64>, name: &str) -> Result<Recording> {
        let plan = Plan::of_times(&times_s, &self.setup.options);
        py.detach(|| self.run(name, plan, &mut Watch::new(None)))
    }

    /// Analyses an array of frames.
    fn samples(
        &self,
        py: Python<'_>,
        samples: Bound<'_, PyAny>,
        sample_rate_hz: u32,
        name: &str,
        report: Option<Py<PyAny>>,
    ) -> Result<Recording> {
        let frames = Arc::new(Frames::new(&samples)?);
        check_layout(sample_rate_hz, frames.channels, name)?;
        let options = &self.setup.options;
        let kept = Arc::clone(&frames);
        let mut detector =
            Detector::with_options(sample_rate_hz, frames.channels, &options.detection)?.rereading(
                move |channel, range| {
                    let range = range.start as usize..range.end as usize;
                    let read = Python::attach(|py| kept.read_channel(py, range, channel));
                    // If the array was resized meanwhile, its samples are gone.
                    read.unwrap_or_default()
                },
            );
        let mut watch = Watch::new(report);
        let seconds = |frames: usize| frames as f64 / f64::from(sample_rate_hz);
        let whole_s = Some(seconds(frames.length));
        for part in frames.blocks() {
            let end = part.end;
            let block = frames.read(py, part)?;
            py.detach(|| {
                detector.push(&block.iter().map(Vec::as_slice).collect::<Vec<_>>());
                watch.look("s", seconds(end), whole_s)
            })?;
        }
        py.detach(|| {
            let plan = Plan::of_detection(detector.finish(), options);
            self.run(name, plan, &mut watch)
        })
    }
}
