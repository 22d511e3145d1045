//! What would a drop do, and how would it sound?

use std::path::PathBuf;

use bouncelab::analysis::Options;
use bouncelab::drop::{self, Start, Stop};
use bouncelab::impact::ImpactEvent;
use bouncelab::restitution::Restitution;
use bouncelab::synth::{self, BitDepth, Clicks, Hum, Lost, Noise, Reverb, Scene, Voice};
use bouncelab_audio::{SampleFormat, encode_wav};
use bouncelab_report::columns;
use bouncelab_report::document::simulation::{Document, Run};
use bouncelab_report::figure;
use bouncelab_report::mark::Mark;
use bouncelab_report::theme::Meaning;
use pyo3::prelude::*;
use pyo3::types::{PyByteArray, PyBytes};
use rand::SeedableRng;
use rand_chacha::ChaCha8Rng;
use rand_distr::{Distribution, StandardNormal};
use serde::Deserialize;

use crate::analyzer::Analyzer;
use crate::chart::Chart;
use crate::failure::{Failure, Result};
use crate::output;
use crate::physics::translator;
use crate::recording::bytes;
use crate::samples::Frames;
use crate::table::Table;
use crate::watch::interruptible;

/// How a drop begins, bounces and ends.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Request {
    height_m: f64,
    launch_speed_m_s: Option<f64>,
    restitution: Law,
    /// Standard deviation of ln e from impact to impact.
    scatter: f64,
    seed: u64,
    until_m: Option<f64>,
    bounces: Option<usize>,
}

/// A law of the impact speed as text, the restitution of each impact, or all that is unknown as a draw of its prior.
#[derive(Deserialize)]
#[serde(untagged)]
enum Law {
    OfSpeed(String),
    Each(Vec<f64>),
    Prior,
}

/// How it is recorded.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SceneRequest {
    sample_rate_hz: u32,
    seed: u64,
    voice: String,
    snr_db: Option<f64>,
    noise: String,
    hum_hz: Option<f64>,
    reverb_s: Option<f64>,
    clicks_per_s: Option<f64>,
    lost: Option<f64>,
    clip_at: Option<f64>,
    lead_in_s: f64,
    tail_s: f64,
}

impl Request {
    /// The drop, and the options that it was simulated with.
    fn run(&self, mut options: Options) -> Result<(Run, Options)> {
        let launched = self.launch_speed_m_s.map(Start::Launch);
        let start = launched.unwrap_or(Start::Height(self.height_m));
        let stop = Stop::asked(self.until_m, self.bounces);
        let mut random = ChaCha8Rng::seed_from_u64(self.seed);
        let scatter = self.scatter;
        let scattered = move |restitution: f64, random: &mut ChaCha8Rng| {
            let normal: f64 = StandardNormal.sample(random);
            restitution * (scatter * normal).exp()
        };
        let mut kept: Box<dyn FnMut(usize, f64) -> f64> = match &self.restitution {
            Law::OfSpeed(law) => {
                let law: Restitution = law.parse()?;
                Box::new(move |_, speed_m_s| scattered(law.at(speed_m_s), &mut random))
            }
            Law::Each(each) => Box::new(move |impact, _| scattered(each[impact], &mut random)),
            Law::Prior => {
                let nominal = (&options.ball, &options.environment, options.contact_time_s);
                let (ball, environment, contact_s) = nominal;
                let priors = &options.priors;
                let drawn =
                    priors.draw(ball, environment, contact_s, self.height_m, &mut random)?;
                options.ball = drawn.ball;
                options.environment = drawn.environment.clone();
                options.contact_time_s = drawn.contact_time_s;
                Box::new(move |_, speed_m_s| {
                    drawn.restitution.at(speed_m_s) * drawn.deviation(&mut random).exp()
                })
            }
        };
        let model = options.model()?;
        let history = drop::simulate_each(&model, options.contact_time_s, &mut kept, start, stop)?;
        let law = options.environment.drag.clone();
        Ok((Run::of(law, &model, history), options))
    }
}

impl SceneRequest {
    fn scene(&self) -> Result<Scene> {
        let unknown = |kind, name: &str, known: &[&str]| {
            Failure::from(bouncelab::Error::unknown_name(kind, name, known))
        };
        let voice = Voice::named(&self.voice);
        let noise = match self.noise.as_str() {
            "white" => Noise::white,
            "pink" => Noise::pink,
            other => return Err(unknown("noise", other, &["white", "pink"])),
        };
        Ok(Scene {
            sample_rate_hz: self.sample_rate_hz,
            lead_in_s: self.lead_in_s,
            tail_s: self.tail_s,
            voice: voice.ok_or_else(|| unknown("voice", &self.voice, &Voice::NAMES))?,
            noise: self.snr_db.map(noise),
            hum: self.hum_hz.map(Hum::mains),
            reverb: self.reverb_s.map(Reverb::of_time),
            clicks: self.clicks_per_s.map(Clicks::often),
            lost: self.lost.map_or(Lost::None, Lost::Chance),
            clip_at: self.clip_at,
            bit_depth: BitDepth::Float,
            ..Scene::default()
        })
    }
}

/// A simulated drop.
#[pyclass(frozen, module = "bouncelab._core")]
pub(crate) struct Simulation {
    analyzer: Analyzer,
    request: String,
    run: Run,
    options: Options,
}

#[pymethods]
impl Simulation {
    #[new]
    fn new(analyzer: &Analyzer, request: String) -> Result<Self> {
        let asked: Request = serde_json::from_str(&request)?;
        let (run, options) = asked.run(analyzer.setup.options.clone())?;
        Ok(Self {
            analyzer: analyzer.clone(),
            request,
            run,
            options,
        })
    }

    fn __getnewargs__(&self) -> (Analyzer, String) {
        (self.analyzer.clone(), self.request.clone())
    }

    /// The document of the schema `bouncelab.simulation/2`.
    fn document(&self, language: &str) -> Result<String> {
        let setup = &self.analyzer.setup;
        let mut assumptions = setup.assumptions.clone();
        translator(language)?.complete_each(&mut assumptions);
        let document = Document::new(std::slice::from_ref(&self.run), &self.options, &assumptions);
        Ok(serde_json::to_string(&document)?)
    }

    /// The bounces.
    fn bounces(&self) -> Table {
        Table(columns::bounces([&self.run]))
    }

    /// The height at each time.
    fn height_m<'py>(&self, py: Python<'py>, times_s: Vec<f64>) -> Bound<'py, PyBytes> {
        let heights = times_s
            .into_iter()
            .map(|time_s| self.run.history.height_at(time_s));
        bytes(py, &heights.collect::<Vec<f64>>())
    }

    /// Height against time.
    fn figure(&self, name: &str, language: &str) -> Result<Chart> {
        let words = translator(language)?;
        let drawn = figure::Run {
            name: self.run.law.to_string(),
            meaning: Meaning::Drag,
            history: &self.run.history,
        };
        let [height, flight_times] = figure::runs(&[drawn], &words);
        match name {
            "height" => Ok(Chart(height)),
            "flight-times" => Ok(Chart(flight_times)),
            _ => Err(
                bouncelab::Error::unknown_name("figure", name, &["height", "flight-times"]).into(),
            ),
        }
    }

    /// How it sounds: samples as the bytes of 32-bit floats, which an array can own, and the true impacts.
    fn sound<'py>(&self, py: Python<'py>, scene: &str) -> Result<(Bound<'py, PyByteArray>, Table)> {
        let asked: SceneRequest = serde_json::from_str(scene)?;
        let scene = asked.scene()?;
        let events: Vec<ImpactEvent> = self.run.history.impact_events().collect();
        let (sound, samples) = py.detach(|| {
            interruptible(move || {
                synth::render(&events, &scene, asked.seed).map(|sound| {
                    let samples = sound.samples.iter().flat_map(|it| it.to_ne_bytes());
                    let samples: Vec<u8> = samples.collect();
                    (sound, samples)
                })
            })
        })??;
        let samples = PyByteArray::new(py, &samples);
        Ok((samples, Table(columns::truth(&sound))))
    }
}

/// Saves samples of one channel as WAV, of 16 bits.
#[pyfunction]
pub(crate) fn write_wav(
    py: Python<'_>,
    path: PathBuf,
    samples: Bound<'_, PyAny>,
    sample_rate_hz: u32,
    force: bool,
) -> Result<()> {
    let frames = Frames::new(&samples)?;
    let samples = frames.read(py, 0..frames.length)?;
    let channels: Vec<&[f32]> = samples.iter().map(Vec::as_slice).collect();
    let wav = encode_wav(sample_rate_hz, SampleFormat::Int16, &channels)?;
    output::write(&path, Mark::NONE, &wav, &[], force)
}
