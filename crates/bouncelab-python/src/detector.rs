//! What does sound say that is still coming?

use std::sync::{Mutex, PoisonError};

use bouncelab::analysis::Plan;
use bouncelab::detection::{Detection, DropWatch};
use bouncelab_audio::check_layout;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::analyzer::Analyzer;
use crate::failure::{Failure, Result};
use crate::recording::Recording;
use crate::samples::Frames;
use crate::watch::Watch;

/// Settings, name, channels, and what was heard so far.
type State<'py> = (Analyzer, String, usize, Bound<'py, PyBytes>);

/// Takes sound in blocks, and tells of each drop when it is over.
#[pyclass(frozen, module = "bouncelab._core")]
pub(crate) struct Detector {
    analyzer: Analyzer,
    name: String,
    channels: usize,
    /// One thread at a time.
    drops: Mutex<DropWatch>,
}

impl Detector {
    fn analyze(&self, detection: Detection) -> Result<Recording> {
        let plan = Plan::of_detection(detection, &self.analyzer.setup.options);
        self.analyzer.run(&self.name, plan, &mut Watch::new(None))
    }

    fn with_drops<T>(&self, work: impl FnOnce(&mut DropWatch) -> T) -> T {
        // A panic leaves nothing behind that would not be as good as before.
        work(&mut self.drops.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

#[pymethods]
impl Detector {
    #[new]
    fn new(
        analyzer: &Analyzer,
        sample_rate_hz: u32,
        channels: usize,
        name: String,
    ) -> Result<Self> {
        check_layout(sample_rate_hz, channels, &name)?;
        let options = &analyzer.setup.options.detection;
        Ok(Self {
            analyzer: analyzer.clone(),
            name,
            channels,
            drops: DropWatch::new(sample_rate_hz, channels, options)?.into(),
        })
    }

    /// Takes the next frames; the drops that are over since, each as a recording of its own.
    fn push(&self, py: Python<'_>, samples: Bound<'_, PyAny>) -> Result<Vec<Recording>> {
        let frames = Frames::new(&samples)?;
        if frames.channels != self.channels {
            let (given, expected) = (frames.channels, self.channels);
            return Err(Failure::Input(format!(
                "a block has {given} channels; the detector was made for {expected}"
            )));
        }
        let mut over = Vec::new();
        for part in frames.blocks() {
            let block = frames.read(py, part)?;
            py.detach(|| {
                let block: Vec<&[f32]> = block.iter().map(Vec::as_slice).collect();
                over.extend(self.with_drops(|drops| drops.push(&block)));
            });
            py.check_signals()?;
        }
        py.detach(|| {
            over.into_iter()
                .map(|detection| self.analyze(detection))
                .collect()
        })
    }

    /// What all sound that came says, as if it ended here.
    fn so_far(&self, py: Python<'_>) -> Result<Recording> {
        py.detach(|| self.analyze(self.with_drops(|drops| drops.detector().so_far())))
    }

    /// How much sound came, in seconds.
    fn duration_s(&self) -> f64 {
        self.with_drops(|drops| drops.now_s())
    }

    /// A detector in the state that `state` gives.
    #[staticmethod]
    fn restore(analyzer: &Analyzer, name: String, channels: usize, state: &[u8]) -> Result<Self> {
        let drops: DropWatch = postcard::from_bytes(state).map_err(|_| {
            Failure::Input("this is no detector of this version of bouncelab".to_owned())
        })?;
        Ok(Self {
            analyzer: analyzer.clone(),
            name,
            channels,
            drops: drops.into(),
        })
    }

    /// What [`restore`](Self::restore) takes.
    fn state<'py>(&self, py: Python<'py>) -> Result<State<'py>> {
        let state = py.detach(|| self.with_drops(|drops| postcard::to_allocvec(&drops)));
        let state = state.map_err(|fault| Failure::Input(fault.to_string()))?;
        let state = PyBytes::new(py, &state);
        Ok((
            self.analyzer.clone(),
            self.name.clone(),
            self.channels,
            state,
        ))
    }
}
